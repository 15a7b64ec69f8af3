// SPDX-License-Identifier: MIT
// Findings in the editor of a PLC's text: underlined, with a tooltip at the pointer.
(() => {
  const equip = async (view) => {
    const CM = await import("nicegui-codemirror");
    const { Decoration, EditorView, StateEffect, StateField } = CM;
    const setMarks = StateEffect.define();
    const marks = StateField.define({
      create: () => Decoration.none,
      update: (now, change) => change.effects.find((one) => one.is(setMarks))?.value ?? now.map(change.changes),
      provide: (field) => EditorView.decorations.from(field),
    });
    const tipOf = (found) => {
      const element = document.createElement("div");
      element.className = "nc-tip";
      for (const one of found) {
        const row = element.appendChild(document.createElement("div"));
        row.className = `nc-tip-finding ${one.class}`;
        row.appendChild(document.createElement("div")).textContent = one.text;
        row.appendChild(document.createElement("div")).textContent = one.remedy;
      }
      return element;
    };
    const hover = CM.hoverTooltip((_, position) => {
      const found = [];
      let pos = position, end = position;
      view.state.field(marks).between(position, position, (from, to, { spec }) => {
        found.push(spec.finding);
        pos = Math.min(pos, from);
        end = Math.max(end, to);
      });
      return found.length ? { pos, end, above: true, create: () => ({ dom: tipOf(found) }) } : null;
    });
    view.dispatch({ effects: StateEffect.appendConfig.of([marks, hover]) });
    const show = (known) => {
      const { doc } = view.state, found = [];
      for (const finding of known) {
        if (finding.line > doc.lines) continue;
        const line = doc.line(finding.line);
        const from = Math.min(line.from + finding.from, line.to), to = Math.min(line.from + finding.to, line.to);
        if (from < to) found.push(Decoration.mark({ class: finding.class, finding }).range(from, to));
      }
      view.dispatch({ effects: setMarks.of(Decoration.set(found, true)) });
    };
    const go = (line) => {
      if (line < 1 || line > view.state.doc.lines) return;
      view.dispatch({ selection: { anchor: view.state.doc.line(line).from }, scrollIntoView: true });
      view.focus();
    };
    globalThis.nctaktPlcText = { show, go };
    if (globalThis.nctaktPlcMarks) show(globalThis.nctaktPlcMarks);
  };
  const begin = () => {
    const view = getElement(EDITOR)?.editor;
    if (view) equip(view);
    else setTimeout(begin, 20); // the library is still loading
  };
  begin();
})();

// SPDX-License-Identifier: MIT
// Keys of the page, clicks in the editor, and the line of the cursor of scope and path.
(() => {
  const keys = KEYS;
  const editor = () => {
    try { return getElement(EDITOR).editor; } catch { return null; } // the page is not there yet
  };
  // Another text takes the place of one that the server knows, never of what it has not heard of.
  globalThis.nctaktEditor = {
    replace(old, text) {
      const view = editor();
      if (!view || view.state.doc.toString() !== old) return;
      if (/[\uD800-\uDFFF]/.test(old + text)) { // a pair must not be cut
        view.dispatch({ changes: { from: 0, to: old.length, insert: text } });
        return;
      }
      let start = 0, end = old.length, last = text.length;
      while (start < end && start < last && old[start] === text[start]) start += 1;
      while (end > start && last > start && old[end - 1] === text[last - 1]) { end -= 1; last -= 1; }
      view.dispatch({ changes: { from: start, to: end, insert: text.slice(start, last) } });
    },
  };
  const isInField = (target) => target.closest && target.closest(".cm-editor, input, textarea, select, .q-menu");

  document.addEventListener("keydown", (event) => {
    if (event.target.closest(".nc-plc-lines") && /^(Arrow|Page|Home|End)/.test(event.key)) return; // moves its cursor
    const inside = isInField(event.target), isCommand = event.ctrlKey || event.metaKey;
    if (isCommand && event.key.toLowerCase() === "s") {
      event.preventDefault();
      emitEvent("nctakt_key", { key: "save" });
      return;
    }
    if (isCommand || event.altKey || !(event.key in keys) || (inside && !keys[event.key])) return;
    if (document.querySelector(".q-dialog") && event.key !== "Escape") return;
    if (event.key === "Escape") {
      if (inside) document.activeElement.blur();
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    const lines = document.querySelector(".nc-plc-lines");
    const shown = lines && lines.offsetParent ? lines : null; // a file of the PLC takes the editor's place
    if (event.key === "e") { if (shown || editor()) (shown || editor()).focus(); return; }
    if (!inside && document.activeElement !== shown && document.activeElement) document.activeElement.blur();
    emitEvent("nctakt_key", { key: event.key });
  }, true);

  // Whoever asks why, or sets a stop, is not about to type: the focus stays where it is.
  document.addEventListener("mousedown", (event) => {
    if (!event.target.closest(".nc-inline, .cm-lineNumbers .cm-gutterElement")) return;
    event.preventDefault();
    event.stopPropagation();
  }, true);

  // A click on a line number sets a stop, one on what stands beside a condition asks why.
  document.addEventListener("click", (event) => {
    const number = event.target.closest(".cm-lineNumbers .cm-gutterElement");
    if (number) { emitEvent("nctakt_line", { what: "stop", line: Number(number.textContent) }); return; }
    const view = editor();
    if (event.target.closest(".nc-inline") && view) {
      const place = view.posAtDOM(event.target.closest(".cm-line"));
      emitEvent("nctakt_line", { what: "why", line: view.state.doc.lineAt(place).number });
    }
  });

  // Tab leaves the editor as it leaves any other field; Ctrl+] indents.
  document.addEventListener("keydown", (event) => {
    if (event.key === "Tab" && event.target.closest && event.target.closest(".cm-editor")) event.stopPropagation();
  }, true);

  // The editor has a name and can be reached by Tab; it is light or dark as the page is, which follows the system.
  const dress = ({ contentDOM }) => {
    contentDOM.setAttribute("aria-label", PROGRAM_NAME);
    contentDOM.tabIndex = 0;
    let wasDark = null;
    const look = () => {
      const isDark = document.body.classList.contains("body--dark");
      if (isDark !== wasDark) emitEvent("nctakt_dark", { isDark });
      wasDark = isDark;
    };
    new MutationObserver(look).observe(document.body, { attributes: true, attributeFilter: ["class"] });
    look();
  };

  // The lines in view have the colours of their tokens, which the server knows. Where somebody has
  // typed meanwhile, it is asked again, some times only: it may never hear of a text.
  const colourLines = async (view) => {
    const { Decoration, EditorView, StateEffect, StateField } = await import("nicegui-codemirror");
    const put = StateEffect.define(), known = new Map();
    const marks = StateField.define({
      create: () => Decoration.none,
      update(now, change) {
        const found = change.effects.find((effect) => effect.is(put));
        return found ? found.value : now.map(change.changes);
      },
      provide: (field) => EditorView.decorations.from(field),
    });
    let timer = 0, tries = 0;
    const ask = (after) => {
      timer ||= setTimeout(() => {
        timer = 0;
        const { state: { doc }, viewport: { from, to } } = view;
        emitEvent("nctakt_lines", { first: doc.lineAt(from).number, last: doc.lineAt(to).number });
      }, after);
    };
    const look = EditorView.updateListener.of((update) => {
      if (!update.docChanged && !update.viewportChanged) return;
      tries = 0;
      ask(60);
    });
    const markOf = (name) => {
      if (!known.has(name)) known.set(name, Decoration.mark({ class: name }));
      return known.get(name);
    };
    globalThis.nctaktEditor.colour = (first, lines) => {
      const { doc } = view.state, found = [];
      let isOther = false;
      lines.forEach(([text, tokens], index) => {
        const line = first + index <= doc.lines ? doc.line(first + index) : null;
        isOther ||= !line || line.text !== text;
        if (!line || line.text !== text) return;
        for (const [start, end, name] of tokens) found.push(markOf(name).range(line.from + start, line.from + end));
      });
      view.dispatch({ effects: put.of(Decoration.set(found)) });
      if (isOther && tries < 10) { tries += 1; ask(300); }
    };
    view.dispatch({ effects: StateEffect.appendConfig.of([marks, look]) });
    ask(0);
  };

  // The line under the pointer in the editor is marked in the scope.
  document.addEventListener("pointermove", (event) => {
    const { nctaktRun } = globalThis, view = editor();
    if (!nctaktRun || !view) return;
    const row = event.target.closest && event.target.closest(".cm-line");
    const line = row ? view.state.doc.lineAt(view.posAtDOM(row)).number : 0;
    if (line !== nctaktRun.run.line) { nctaktRun.run.line = line; nctaktRun.changed(); }
  });

  // The current block is in view, unless a person has just moved the text.
  let shown = "", quietUntil = 0;
  for (const name of ["wheel", "pointerdown", "keydown", "touchmove"]) {
    document.addEventListener(name, (event) => {
      if (event.target.closest && event.target.closest(".cm-scroller")) quietUntil = Date.now() + 4000;
    }, { capture: true, passive: true });
  }
  const reveal = (view, { run }) => {
    const now = run.isPlaying ? `${run.block}` : `${run.block} ${run.tick}`, { scrollDOM } = view;
    if (now === shown || !run.block || run.block > view.state.doc.lines || Date.now() < quietUntil) return;
    shown = now;
    const { top, height } = view.lineBlockAt(view.state.doc.line(run.block).from);
    const low = scrollDOM.scrollTop, room = scrollDOM.clientHeight;
    if (top < low || top + height > low + room) scrollDOM.scrollTop = Math.max(0, top - room / 2);
  };

  // A line with a stop has a dot in the gutter.
  const showStops = (view) => {
    const lines = new Set([...view.contentDOM.querySelectorAll(".cm-line.nc-stop")].map(
      (line) => view.state.doc.lineAt(view.posAtDOM(line)).number));
    for (const number of view.dom.querySelectorAll(".cm-lineNumbers .cm-gutterElement")) {
      number.classList.toggle("nc-stopped", lines.has(Number(number.textContent)));
    }
  };
  const watchStops = (view) => {
    const observer = new MutationObserver(() => showStops(view));
    observer.observe(view.contentDOM, { childList: true, subtree: true, attributes: true, attributeFilter: ["class"] });
    observer.observe(view.dom.querySelector(".cm-gutters"), { childList: true, subtree: true, characterData: true });
  };

  // The block at the cursor of scope or path is marked in the editor.
  const mark = document.createElement("div");
  mark.className = "nc-cursor-line";
  const follow = () => {
    const { nctaktRun } = globalThis, view = editor();
    if (!nctaktRun || !view) { setTimeout(follow, 200); return; }
    dress(view);
    watchStops(view);
    colourLines(view);
    nctaktRun.listen(() => {
      reveal(view, nctaktRun);
      const { run } = nctaktRun, block = run.cursor === null ? null : nctaktRun.blockAt(run.cursor);
      const line = block ? block[1] : 0;
      if (!line || line > view.state.doc.lines) { mark.remove(); return; }
      const place = view.lineBlockAt(view.state.doc.line(line).from);
      mark.style.top = `${place.top + view.documentPadding.top}px`;
      mark.style.height = `${place.height}px`;
      if (!mark.parentNode) view.scrollDOM.append(mark);
    });
  };
  follow();
})();

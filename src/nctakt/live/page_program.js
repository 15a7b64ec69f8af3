// SPDX-License-Identifier: MIT
// The program in the browser: lines of long programs by request, colours, marks, findings, words
// completed and explained by the server.
(() => {
  const WORDS = PROGRAM_WORDS;
  const component = () => {
    try { return getElement(EDITOR); } catch { return null; } // the page is not there yet
  };
  const editor = () => component()?.editor;

  // --- requests to the server ------------------------------------------------------------------
  // Of several requests of one kind only the newest is answered.
  const asked = new Map();
  let count = 0;
  const ask = (what, words) => new Promise((resolve) => {
    const before = asked.get(what);
    if (before) before.resolve(null);
    count += 1;
    asked.set(what, { number: count, resolve });
    emitEvent("nctakt_ask", { what, number: count, ...words });
  });
  const answer = (what, number, found) => {
    const open = asked.get(what);
    if (!open || open.number !== number) return;
    asked.delete(what);
    open.resolve(found);
  };
  const placeOf = (state, position) => {
    const line = state.doc.lineAt(position);
    return { line: line.number, column: position - line.from, text: line.text };
  };

  const equip = async (view) => {
    const CM = await import("nicegui-codemirror");
    const { Decoration, EditorState, EditorView, StateEffect, StateField } = CM;
    // Changes from the server are not sent back to it and cannot be undone.
    const put = (changes) => {
      const holder = component(), wasEmitting = holder.emitting;
      holder.emitting = false;
      try {
        view.dispatch({ changes, annotations: CM.Transaction.addToHistory.of(false) });
      } finally { holder.emitting = wasEmitting; }
    };
    const fieldOf = (effect) => StateField.define({
      create: () => Decoration.none,
      update: (now, change) => change.effects.find((one) => one.is(effect))?.value ?? now.map(change.changes),
      provide: (field) => EditorView.decorations.from(field),
    });

    // --- lines and their colours ---------------------------------------------------------------
    // A long program consists of empty lines; those in view are filled by request. If the user has
    // typed meanwhile, the request is repeated a few times only: the server may never get that text.
    const setColours = StateEffect.define(), colours = fieldOf(setColours), classes = new Map();
    const lock = new CM.Compartment(), FIRST_LINES = 60; // as many as most windows show
    let timer = 0, tries = 0, edition = -1, isLong = false, covered = [0, -1];
    const askLines = (after) => {
      timer ||= setTimeout(() => {
        timer = 0;
        const { state: { doc }, viewport: { from, to } } = view;
        const first = doc.lineAt(from).number, last = doc.lineAt(to).number;
        if (isLong && covered[0] <= first && last <= covered[1]) return;
        covered = [0, -1];
        emitEvent("nctakt_lines", { first, last: edition < 0 ? Math.max(last, FIRST_LINES) : last });
      }, after);
    };
    const look = EditorView.updateListener.of((update) => {
      if (update.docChanged) keepLater();
      if (!update.docChanged && !update.viewportChanged) return;
      tries = 0;
      askLines(isLong ? 20 : 60);
    });
    const markOf = (name) => {
      if (!classes.has(name)) classes.set(name, Decoration.mark({ class: name }));
      return classes.get(name);
    };
    const hold = (lines) => {
      isLong = lines > 0;
      view.dom.parentElement.classList.toggle("nc-long", isLong);
      put({ from: 0, to: view.state.doc.length, insert: "\n".repeat(Math.max(0, lines - 1)) });
      view.dispatch({ effects: lock.reconfigure(isLong ? [EditorState.readOnly.of(true)] : []) });
    };
    const fill = (first, lines) => {
      const { doc } = view.state, changes = [];
      lines.forEach(([text], index) => {
        const line = doc.line(first + index);
        if (line.text !== text) changes.push({ from: line.from, to: line.to, insert: CM.Text.of([text]) });
      });
      if (!changes.length) return;
      put(changes);
      showMarks();
    };
    const show = (number, length, first, lines) => {
      if (number < edition || (number === edition && length && !isLong)) return; // the text has been replaced since
      if (length && number !== edition) hold(length);
      if (!length && isLong) hold(0);
      const isNew = number !== edition;
      edition = number;
      if (length && first + lines.length - 1 <= view.state.doc.lines) fill(first, lines);
      const { doc } = view.state, found = [];
      let isOther = false;
      lines.forEach(([text, tokens], index) => {
        const line = first + index <= doc.lines ? doc.line(first + index) : null;
        isOther ||= !line || line.text !== text;
        if (!line || line.text !== text) return;
        for (const [start, end, name] of tokens) found.push(markOf(name).range(line.from + start, line.from + end));
      });
      view.dispatch({ effects: setColours.of(Decoration.set(found)) });
      covered = isOther ? [0, -1] : [first, first + lines.length - 1];
      if (isNew && length) askLines(0);
      else if (isOther && tries < 10) { tries += 1; askLines(300); }
    };
    // A new text replaces only a text that the server knows, never one that it has not yet received.
    const replace = (old, text) => {
      if ((isLong ? "" : view.state.doc.toString()) !== old) return;
      if (isLong) hold(0);
      let start = 0, end = old.length, last = text.length;
      if (!/[\uD800-\uDFFF]/.test(old + text)) { // a surrogate pair must not be split
        while (start < end && start < last && old[start] === text[start]) start += 1;
        while (end > start && last > start && old[end - 1] === text[last - 1]) { end -= 1; last -= 1; }
      }
      view.dispatch({ changes: { from: start, to: end, insert: text.slice(start, last) } });
    };

    // --- drafts ----------------------------------------------------------------------------------
    // Unsaved text outlives the page: a browser that wakes up loads the page again.
    const DRAFTS = "nctakt draft ";
    let owner = null, keeping = 0;
    const keep = () => {
      clearTimeout(keeping);
      keeping = 0;
      if (!owner || isLong) return;
      const text = view.state.doc.toString(), name = DRAFTS + owner.file;
      try {
        if (text === owner.begin) sessionStorage.removeItem(name);
        else sessionStorage.setItem(name, JSON.stringify([owner.begin, text]));
      } catch { sessionStorage.removeItem(name); } // it is too long for the browser's storage
    };
    const keepLater = () => { keeping ||= setTimeout(keep, 250); };
    addEventListener("pagehide", keep);
    const own = (file, begin) => {
      if (keeping) keep();
      owner = { file, begin };
      keep();
    };
    const drafts = () => Object.entries(sessionStorage).filter(([name]) => name.startsWith(DRAFTS))
      .map(([name, kept]) => [name.slice(DRAFTS.length), ...JSON.parse(kept)]);

    // --- marks -----------------------------------------------------------------------------------
    // Blocks, conditions with their notes, stops, findings: by lines and columns.
    class Beside extends CM.WidgetType {
      constructor(text, name) { super(); this.text = text; this.name = name; }
      eq(other) { return other.text === this.text && other.name === this.name; }
      toDOM() {
        const element = document.createElement("span");
        element.className = this.name;
        element.textContent = this.text;
        return element;
      }
      ignoreEvent() { return false; }
    }
    class Stop extends CM.GutterMarker {}
    const stop = Object.assign(new Stop(), { elementClass: "nc-stopped" });
    const setMarks = StateEffect.define(), marks = fieldOf(setMarks), setStops = StateEffect.define();
    const stops = StateField.define({
      create: () => CM.RangeSet.empty,
      update: (now, change) => change.effects.find((one) => one.is(setStops))?.value ?? now.map(change.changes),
      provide: (field) => CM.gutterLineClass.from(field),
    });
    let known = [], findings = [];
    const showMarks = () => {
      const { doc } = view.state, found = [], stopped = [];
      findings = [];
      for (const one of known) {
        if (one.line > doc.lines) continue;
        const line = doc.line(one.line), name = one.class;
        if (one.from !== undefined) {
          const from = Math.min(line.from + one.from, line.to), to = Math.min(line.from + one.to, line.to);
          if (from < to) found.push(Decoration.mark({ class: name }).range(from, to));
          findings.push({ ...one, from, to });
        } else if (one.text !== undefined) found.push(Decoration.widget({ widget: new Beside(one.text, name), side: 1 }).range(line.to));
        else found.push(Decoration.line({ class: name }).range(line.from));
        if (name === "nc-stop") stopped.push(stop.range(line.from));
      }
      findings.sort((one, other) => one.from - other.from);
      view.dispatch({ effects: [setMarks.of(Decoration.set(found, true)), setStops.of(CM.RangeSet.of(stopped, true))] });
    };

    // --- explanations of words and findings -------------------------------------------------------
    const tipOf = (parts, name = "nc-tip") => {
      const element = document.createElement("div");
      element.className = name;
      for (const part of parts) {
        const row = element.appendChild(document.createElement("div"));
        if (part.html !== undefined) row.setHTML(part.html);
        else {
          row.className = `nc-tip-finding ${part.class}`;
          row.appendChild(document.createElement("div")).textContent = part.text;
          row.appendChild(document.createElement("div")).textContent = part.remedy;
        }
      }
      return element;
    };
    const findingsAt = (position) => findings.filter(({ from, to }) => from <= position && position <= to);
    const knownAt = async (position) => {
      const own = findingsAt(position), { state } = view, place = placeOf(state, position);
      const found = await ask("explain", place);
      if (view.state.doc !== state.doc || (!own.length && !found)) return null;
      const begin = position - place.column;
      const [from, to] = found ? [begin + found.from, begin + found.to] : [own[0].from, own[0].to];
      return { parts: found ? [...own, { html: found.html }] : own, from, to, text: found?.text ?? "" };
    };
    const hover = CM.hoverTooltip(async (_, position) => {
      const found = await knownAt(position);
      return found && { pos: found.from, end: found.to, above: true, create: () => ({ dom: tipOf(found.parts) }) };
    });
    // On a key press the same is shown at the cursor, and read out, until the cursor moves.
    const setOpenTip = StateEffect.define();
    const openTip = StateField.define({
      create: () => null,
      update: (now, change) => {
        const found = change.effects.find((one) => one.is(setOpenTip));
        if (found) return found.value;
        return change.docChanged || change.selection ? null : now;
      },
      provide: (field) => CM.showTooltip.from(field),
    });
    const showTipAt = (position, parts, text) => {
      const said = [...parts.map((part) => part.text).filter(Boolean), ...parts.map((part) => part.remedy).filter(Boolean), text];
      const tooltip = { pos: position, above: true, create: () => ({ dom: tipOf(parts, "nc-tip nc-tip-here") }) };
      view.dispatch({ effects: [setOpenTip.of(tooltip), EditorView.announce.of(said.filter(Boolean).join("\n"))] });
    };
    const explain = () => {
      const position = view.state.selection.main.head;
      knownAt(position).then((found) => {
        if (view.state.selection.main.head !== position) return;
        if (found) showTipAt(found.from, found.parts, found.text);
        else showTipAt(position, [{ class: "", text: WORDS.nothing, remedy: "" }], "");
      });
    };
    const next = (step) => {
      if (!findings.length) { showTipAt(view.state.selection.main.head, [{ class: "", text: WORDS.none, remedy: "" }], ""); return; }
      const here = view.state.selection.main.head;
      const goal = step > 0 ? findings.find(({ from }) => from > here) ?? findings[0]
        : findings.findLast(({ from }) => from < here) ?? findings.at(-1);
      view.dispatch({ selection: { anchor: goal.from }, effects: EditorView.scrollIntoView(goal.from, { y: "nearest" }) });
      showTipAt(goal.from, findings.filter(({ from }) => from === goal.from), "");
    };
    const close = () => {
      if (!view.state.field(openTip)) return false;
      view.dispatch({ effects: setOpenTip.of(null) });
      return true;
    };

    // --- completion -------------------------------------------------------------------------------
    // The words of the language server in its order; in a text with gaps the first gap is selected.
    const GAP = /\$(?:\{(\d+)(?::([^{}]*)|\|([^{}|]*)\|)?\}|(\d+))/g;
    const insert = (item) => (target, completion, from, to) => {
      const { state } = target, line = state.doc.lineAt(to), begin = line.from + item.start;
      const indent = /^\s*/.exec(line.text)[0];
      let text = item.text, anchor = text.length, head = anchor, first = Infinity;
      if (item.hasGaps) {
        text = text.replaceAll("\n", `\n${indent}`);
        let plain = "", after = 0;
        for (const gap of text.matchAll(GAP)) {
          plain += text.slice(after, gap.index);
          after = gap.index + gap[0].length;
          const filler = gap[2] ?? gap[3]?.split(",")[0] ?? "", rank = Number(gap[1] ?? gap[4]) || 1000;
          if (rank < first) { first = rank; anchor = plain.length; head = anchor + filler.length; }
          plain += filler;
        }
        text = plain + text.slice(after);
        if (first === Infinity) anchor = head = text.length;
      }
      target.dispatch({
        changes: { from: begin, to, insert: text }, selection: { anchor: begin + anchor, head: begin + head },
        userEvent: "input.complete", scrollIntoView: true,
      });
    };
    const complete = async (context) => {
      const place = placeOf(context.state, context.pos), before = place.text.slice(0, place.column);
      if (context.state.readOnly || (!context.explicit && !/[\w.$#[=]$|#\S.* $/.test(before))) return null;
      const items = await ask("complete", place);
      if (!items) return null;
      const fitting = items.filter((item) => item.label.toLowerCase().startsWith(before.slice(item.start).toLowerCase()));
      if (!fitting.length) return null;
      return {
        from: context.pos - place.column + Math.max(...fitting.map((item) => item.start)),
        filter: false,
        options: fitting.map((item) => ({ label: item.label, detail: item.detail, type: item.kind, apply: insert(item) })),
      };
    };

    // A block that runs fast is shown at once: by the next frame the program has gone on.
    const follow = (position) => {
      const { scrollDOM } = view, { top, bottom } = view.lineBlockAt(position);
      if (top >= scrollDOM.scrollTop && bottom <= scrollDOM.scrollTop + scrollDOM.clientHeight) return;
      scrollDOM.scrollTop = Math.max(0, top - scrollDOM.clientHeight / 2);
      view.requestMeasure();
      view.coordsAtPos(position); // what is asked for now is measured now
    };

    view.dispatch({
      effects: StateEffect.appendConfig.of([
        colours, marks, stops, openTip, look, hover, lock.of([]),
        EditorState.languageData.of(() => [{ autocomplete: complete }]),
        EditorState.phrases.of(WORDS.phrases),
        CM.Prec.highest(CM.keymap.of([{ key: "Escape", run: close }])),
        EditorView.domEventHandlers({
          // lines that are not loaded yet cannot be copied
          copy: (event) => {
            if (!isLong || view.state.selection.ranges.every(({ from, to }) => isFilled(from, to))) return false;
            event.preventDefault();
            emitEvent("nctakt_uncopied", {});
            return true;
          },
        }),
      ]),
    });
    const isFilled = (from, to) => {
      const { doc } = view.state, first = doc.lineAt(from).number, last = doc.lineAt(to).number;
      const inView = [doc.lineAt(view.viewport.from).number, doc.lineAt(view.viewport.to).number];
      return inView[0] <= first && last <= inView[1];
    };
    // Moves the cursor to a line and scrolls it into view.
    const go = (line) => {
      if (line < 1 || line > view.state.doc.lines) return;
      view.dispatch({ selection: { anchor: view.state.doc.line(line).from } });
      globalThis.nctaktBring(line);
    };
    globalThis.nctaktEditor = {
      replace, show, answer, go, explain, next, own,
      // The lines around the block of a long program come with its marks: it may run too fast to ask.
      mark(found, block = 0, first = 0, lines = []) {
        known = found;
        const follows = isLong && block > 0 && block <= view.state.doc.lines && globalThis.nctaktFollows();
        if (follows && lines.length) show(edition, view.state.doc.lines, first, lines);
        showMarks();
        if (follows) follow(view.state.doc.line(block).from);
      },
      get isLong() { return isLong; },
    };
    showMarks();
    askLines(0);
    emitEvent("nctakt_ready", { drafts: drafts() });
  };

  const begin = () => {
    const view = editor();
    if (view) equip(view);
    else setTimeout(begin, 50);
  };
  begin();
})();

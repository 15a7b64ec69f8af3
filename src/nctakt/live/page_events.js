// SPDX-License-Identifier: MIT
// Keys of the page, clicks in the editor, and the line at the cursor of scope and path.
(() => {
  const keys = KEYS;
  const editor = () => {
    try { return getElement(EDITOR).editor; } catch { return null; } // the page is not there yet
  };
  const isInField = (target) => target.closest && target.closest(".cm-editor, input, textarea, select, .q-menu");

  const find = () => document.querySelector("[data-testid=find]")?.focus();

  document.addEventListener("keydown", (event) => {
    if (event.target.closest(".nc-plc-lines, .nc-plc-tree") && /^(Arrow|Page|Home|End)/.test(event.key)) return; // these keys move its own cursor
    const inside = isInField(event.target), isCommand = event.ctrlKey || event.metaKey;
    if (isCommand && event.key.toLowerCase() === "s") {
      event.preventDefault();
      emitEvent("nctakt_key", { key: "save" });
      return;
    }
    if (isCommand && event.key.toLowerCase() === "f" && inside && globalThis.nctaktEditor?.isLong) {
      event.preventDefault(); // the library would search only the lines that the browser has
      event.stopPropagation();
      find();
      return;
    }
    if (isCommand || event.altKey || !(event.key in keys) || (inside && !keys[event.key])) return;
    if (document.querySelector(".q-dialog") && event.key !== "Escape") return;
    if (event.key === "Escape") { // panels of the editor close first
      if (inside && !document.querySelector(".cm-tooltip-autocomplete, .cm-panel, .nc-tip-here")) document.activeElement.blur();
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    const typing = document.querySelector(".nc-plc-edit .cm-content"), lines = document.querySelector(".nc-plc-lines");
    if (typing?.offsetParent && ["e", "F1", "F4", "g"].includes(event.key)) { if (event.key === "e") typing.focus(); return; }
    const shown = lines && lines.offsetParent ? lines : null; // a file of the PLC replaces the editor
    if (event.key === "e") { if (shown || editor()) (shown || editor()).focus(); return; }
    if (event.key === "F1" || event.key === "F4" || event.key === "g") {
      if (shown) { if (event.key === "F1") emitEvent("nctakt_key", { key: "F1" }); return; }
      if (event.key === "g") find();
      else if (event.key === "F1") globalThis.nctaktEditor?.explain();
      else globalThis.nctaktEditor?.next(event.shiftKey ? -1 : 1);
      return;
    }
    if (!inside && document.activeElement !== shown && document.activeElement) document.activeElement.blur();
    if (event.key === " ") globalThis.nctaktRun?.hold();
    emitEvent("nctakt_key", { key: event.key });
  }, true);
  document.addEventListener("pointerdown", (event) => {
    if (event.target.closest("[data-testid=toggle]")) globalThis.nctaktRun?.hold();
  }, true);

  // The options of a select are in an element that can have the focus, which ARIA allows only for a group.
  const options = "[role=listbox] > .q-virtual-scroll__content:not([role])";
  new MutationObserver(() => {
    document.querySelectorAll(options).forEach((part) => part.setAttribute("role", "group"));
  }).observe(document.documentElement, { childList: true, subtree: true });

  // A click that asks why or sets a stop does not mean typing: the focus stays where it is.
  document.addEventListener("mousedown", (event) => {
    if (!event.target.closest(".nc-inline, .cm-lineNumbers .cm-gutterElement")) return;
    event.preventDefault();
    event.stopPropagation();
  }, true);

  // A click on a line number sets a stop, one on the note beside a condition asks why.
  document.addEventListener("click", (event) => {
    const number = event.target.closest(".cm-lineNumbers .cm-gutterElement");
    if (number) { emitEvent("nctakt_line", { what: "stop", line: Number(number.textContent) }); return; }
    const view = editor();
    if (event.target.closest(".nc-inline") && view) {
      const place = view.posAtDOM(event.target.closest(".cm-line"));
      emitEvent("nctakt_line", { what: "why", line: view.state.doc.lineAt(place).number });
    }
  });

  // Tab leaves the editor like any other field; Ctrl+] indents.
  document.addEventListener("keydown", (event) => {
    if (event.key === "Tab" && event.target.closest && event.target.closest(".cm-editor")) event.stopPropagation();
  }, true);

  // The editor has a name and can be reached by Tab; it is light or dark like the page, which follows the system.
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

  // The line under the pointer in the editor is marked in the scope.
  document.addEventListener("pointermove", (event) => {
    const { nctaktRun } = globalThis, view = editor();
    if (!nctaktRun || !view) return;
    const row = event.target.closest && event.target.closest(".cm-line");
    const line = row ? view.state.doc.lineAt(view.posAtDOM(row)).number : 0;
    if (line !== nctaktRun.run.line) { nctaktRun.run.line = line; nctaktRun.changed(); }
  });

  // The current block stays in view, unless the user has just scrolled or chosen a line.
  let shown = "", goal = 0, quietUntil = 0;
  const rest = () => { quietUntil = Date.now() + 4000; };
  for (const name of ["wheel", "pointerdown", "keydown", "touchmove"]) {
    document.addEventListener(name, (event) => {
      if (!event.target.closest || !event.target.closest(".cm-scroller")) return;
      rest();
      goal = 0;
    }, { capture: true, passive: true });
  }
  // Heights of distant lines are estimates: after scrolling, the position is checked again.
  const look = (view, line, looks = 6) => {
    if (goal !== line || line > view.state.doc.lines) return;
    const { scrollDOM } = view, { top, height } = view.lineBlockAt(view.state.doc.line(line).from);
    const low = scrollDOM.scrollTop, room = scrollDOM.clientHeight;
    if (top < low || top + height > low + room) scrollDOM.scrollTop = Math.max(0, top - room / 2);
    if (looks) requestAnimationFrame(() => look(view, line, looks - 1));
    else goal = 0;
  };
  const reveal = (view, { run }) => {
    if (run.isPlaying && globalThis.nctaktEditor?.isLong) return; // its lines and marks come together
    const now = run.isPlaying ? `${run.block}` : `${run.block} ${run.tick}`;
    if (now === shown || !run.block || run.block > view.state.doc.lines || Date.now() < quietUntil) return;
    shown = now;
    goal = run.block;
    look(view, goal);
  };
  globalThis.nctaktFollows = () => globalThis.nctaktRun?.run.isPlaying && Date.now() >= quietUntil;
  globalThis.nctaktBring = (line) => {
    const view = editor();
    if (!view) return;
    rest();
    goal = line;
    look(view, line);
  };

  // The block at the cursor of scope or path is marked in the editor.
  const mark = document.createElement("div");
  mark.className = "nc-cursor-line";
  const follow = () => {
    const { nctaktRun } = globalThis, view = editor();
    if (!nctaktRun || !view) { setTimeout(follow, 200); return; }
    dress(view);
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

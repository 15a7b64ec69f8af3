# SPDX-License-Identifier: MIT
"""Style sheet and keys of the live page."""

from __future__ import annotations

CSS = """
:root { --nc-line: #d9dde3; --nc-soft: #5b6470; --nc-back: #f4f6f8; --nc-card: #ffffff; }
body.body--dark { --nc-line: #363c45; --nc-soft: #9aa4b1; --nc-back: #16191d; --nc-card: #1e2227; }
body { background: var(--nc-back); }
.nicegui-content { padding: 0 !important; gap: 0 !important; }
.nc-bar { height: 46px; padding: 0 10px; gap: 6px; background: var(--nc-card);
  border-bottom: 1px solid var(--nc-line); width: 100%; flex-wrap: nowrap; align-items: center; }
.nc-body { display: grid; width: 100%; height: calc(100vh - 46px); gap: 8px; padding: 8px;
  grid-template-columns: minmax(0, 41fr) minmax(0, 37fr) minmax(262px, 22fr); }
.nc-column { display: flex; flex-direction: column; gap: 8px; min-height: 0; min-width: 0; }
.nc-card { background: var(--nc-card); border: 1px solid var(--nc-line); border-radius: 6px;
  display: flex; flex-direction: column; min-height: 0; padding: 6px 8px; width: 100%; gap: 4px; }
.nc-title { font-size: 11px; font-weight: 600; letter-spacing: .04em; color: var(--nc-soft);
  text-transform: uppercase; }
.nc-soft { color: var(--nc-soft); font-size: 12px; }
.nc-number { font-variant-numeric: tabular-nums; font-family: ui-monospace, monospace; }
.nc-position { font-size: 19px; line-height: 24px; }
.nc-row { display: flex; flex-wrap: nowrap; align-items: center; gap: 6px; width: 100%; }
.nc-scroll { overflow: auto; flex: 1 1 0; min-height: 0; width: 100%; }
.nc-finding { font-size: 12.5px; padding: 3px 4px; border-left: 3px solid var(--nc-line);
  margin-bottom: 3px; cursor: pointer; }
.nc-finding.error { border-color: #d64545; }
.nc-finding.warning { border-color: #e8a03a; }
.nc-finding.fired { border-color: #e8833a; }
.nicegui-codemirror { flex: 1 1 0; min-height: 0; width: 100%; font-size: 13px; }
.nicegui-codemirror .cm-editor { height: 100%; }
.nc-block { background: rgba(59, 130, 246, .22) !important;
  box-shadow: inset 3px 0 0 #3b82f6; }
.nc-true { background: rgba(34, 160, 107, .20) !important; }
.nc-false { background: rgba(214, 69, 69, .13) !important; }
.nc-unknown { background: rgba(138, 143, 152, .14) !important; }
.nc-ran { box-shadow: inset 3px 0 0 #22a06b; }
.nc-inline { margin-left: 18px; font-size: 11px; font-style: italic; color: var(--nc-soft); }
.nc-state { padding: 2px 9px; border-radius: 10px; font-size: 12px; font-weight: 600;
  color: #fff; background: #6b7380; white-space: nowrap; }
.nc-state.running { background: #1c8558; } .nc-state.standing { background: #2563c9; }
.nc-state.error { background: #c23838; }
.nc-bar .q-btn { min-height: 30px; padding: 2px 7px; }
.q-field--dense .q-field__control { height: 26px !important; min-height: 26px !important; }
.q-field--dense .q-field__marginal { height: 26px !important; }
.q-tab { min-height: 30px !important; padding: 0 10px; }
.q-tab__label { font-size: 12px; }
"""

#: Keys outside of fields and the editor, and what they do.
KEYS = {
    " ": "toggle",
    "Home": "home",
    ",": "back_tick",
    ".": "tick",
    "b": "block",
    "B": "back_block",
    "r": "reaction",
    "R": "back_reaction",
}

SCRIPT = """
<script>
document.addEventListener("keydown", (event) => {
  const inside = event.target.closest && event.target.closest(
    ".cm-editor, input, textarea, select, .q-menu");
  if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "s") {
    event.preventDefault();
    emitEvent("nctakt_key", {key: "save"});
  } else if (!inside && !event.ctrlKey && !event.altKey && !event.metaKey
      && KEYS.includes(event.key)) {
    event.preventDefault();
    if (document.activeElement) document.activeElement.blur();
    emitEvent("nctakt_key", {key: event.key});
  }
});
</script>
"""

// SPDX-License-Identifier: MIT
// The session's data in a browser: curves, marks, blocks, the cursor. Scope, path and editor share
// it; the server adds to it (track.py).

const MAX_POINTS = 3000, MAX_MARKS = 2000, MAX_BLOCKS = 20000, MAX_SAMPLES = 5000;

export const run = {
  names: [], units: [], booleans: [], hidden: 0, now: [], ticks: [], columns: [], marks: [], blocks: [],
  conditions: [], lanesShown: [], lanes: [], bars: { end: 0, lines: [] }, // exact up to "end", then sampled
  block: 0, tick: -1, latest: -1, // the last tick that has run: all values are from its end
  logged: {}, // a machine's log by names of signals, in ticks of this run
  isPlaying: false, future: null, cycleUs: 1000, detail: null, words: {},
  cursor: null, anchor: null, head: null, line: 0, // the user compares the stretch from anchor to head
  firstLane: 0, // the first condition shown, counted among those that match the filter
  from: 0, to: 1, follows: true, span: 0,
};
const listeners = new Set();
let isDue = false, taken = 0, told = 0, heldUntil = 0;

// Drawing waits for the answer to a key press, but at most this long, in ms.
const MAX_HELD = 150;

export const listen = (listener) => { listeners.add(listener); return () => listeners.delete(listener); };
export const changed = () => {
  if (isDue) return;
  isDue = true;
  requestAnimationFrame(draw);
};
// Tells the server which increment has been drawn: it sends no more to a page that sleeps.
const draw = () => {
  if (performance.now() < heldUntil) { requestAnimationFrame(draw); return; }
  isDue = false;
  try {
    for (const listener of listeners) listener();
  } finally {
    if (taken !== told) { told = taken; emitEvent("nctakt_taken", taken); }
  }
};

// The user pauses: data that arrives before the answer need not be drawn first.
export const hold = () => { if (run.isPlaying) heldUntil = performance.now() + MAX_HELD; };

const trim = (list, size) => { if (list.length > size) list.splice(0, list.length - size); };

// Adds data from the server: each part replaces the present data or is appended to it.
export const take = (news) => {
  for (const name of ["names", "units", "booleans", "hidden", "now", "block", "conditions", "lanesShown", "words", "cycleUs", "tick", "latest", "isPlaying", "bars", "future", "logged"]) {
    if (news[name] !== undefined) run[name] = news[name];
  }
  if (!run.isPlaying) heldUntil = 0;
  if (news.rows) {
    if (news.rows.whole) {
      run.ticks = [];
      run.columns = run.names.map(() => []);
      run.detail = null;
    }
    for (const [tick, ...values] of news.rows.added) {
      run.ticks.push(tick);
      values.forEach((value, index) => run.columns[index].push(value));
    }
    trim(run.ticks, MAX_POINTS);
    for (const column of run.columns) trim(column, MAX_POINTS);
  }
  for (const [name, size] of [["marks", MAX_MARKS], ["blocks", MAX_BLOCKS], ["lanes", MAX_SAMPLES]]) {
    const part = news[name];
    if (!part) continue;
    run[name] = part.whole ? part.added : run[name].concat(part.added);
    trim(run[name], size);
  }
  if (news.detail) run.detail = news.detail;
  if (news.texts) showTexts(news.texts);
  if (run.follows) follow();
  taken = news.number ?? taken;
  frames.count += 1;
  changed();
};

// Light or dark: the drawings look up their colours again.
new MutationObserver(changed).observe(document.body, { attributes: true, attributeFilter: ["class"] });

// How often data came, for measurements of the page.
const frames = { count: 0 };
globalThis.nctaktFrames = frames;

const showTexts = (texts) => {
  for (const [name, text] of Object.entries(texts)) {
    for (const element of document.querySelectorAll(`[data-testid="${name}"]`)) element.textContent = text;
  }
};

// --- the stretch shown by the scope ----------------------------------------------------------
export const first = () => (run.ticks.length ? run.ticks[0] : 0);
export const follow = () => {
  run.follows = true;
  const end = run.isPlaying ? Math.max(run.tick, 1) : Math.max(run.latest, run.tick, 1);
  run.to = end;
  run.from = run.span ? Math.max(0, end - run.span) : Math.min(first(), end - 1);
};
export const show = (from, to) => {
  const limit = Math.max(run.latest, run.tick, 10);
  const span = Math.min(Math.max(to - from, 10), limit);
  run.from = Math.min(Math.max(from, 0), limit - span);
  run.to = run.from + span;
  run.follows = false;
  changed();
};
export const zoom = (tick, factor) => {
  const span = (run.to - run.from) * factor;
  if (run.follows && run.isPlaying) {
    run.span = Math.max(50, span);
    follow();
    changed();
  } else show(tick - (tick - run.from) * factor, tick + (run.to - tick) * factor);
};
// The two compared ticks, or null; the later one follows the pointer, else the session.
export const compared = () => {
  if (run.anchor === null) return null;
  return [run.anchor, run.head ?? run.cursor ?? run.tick];
};
export const mark = () => {
  run.anchor = run.anchor === null ? Math.max(0, run.tick) : null;
  run.head = null;
  changed();
};
// Zooms to the selection, else to half of the shown stretch.
export const zoomIn = () => {
  if (run.anchor === null || run.head === null) { zoom((run.from + run.to) / 2, 0.6); return; }
  show(Math.min(run.anchor, run.head), Math.max(run.anchor, run.head));
};
export const pan = (share) => show(run.from + share * (run.to - run.from), run.to + share * (run.to - run.from));
export const fit = () => { run.span = 0; follow(); changed(); };

// --- looking up ------------------------------------------------------------------------------
// The finest curves for the shown stretch.
export const curves = () => {
  const { detail } = run;
  const isInside = detail && detail.names.join() === run.names.join()
    && detail.first <= run.from + 1 && detail.end >= Math.min(run.to, run.latest) - 1;
  return isInside ? detail : run;
};
// The index of the last entry at or before a tick, -1 if there is none.
export const indexAt = (list, tick, of = (entry) => entry) => {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (of(list[middle]) <= tick) low = middle + 1;
    else high = middle;
  }
  return low - 1;
};
export const blockAt = (tick) => {
  const index = indexAt(run.blocks, tick, (block) => block[0]);
  return index < 0 ? null : run.blocks[index];
};
// When the condition in a line was true: first tick, end, and whether they are exact.
export const laneBars = (line, row) => {
  const exact = run.bars.lines.find((one) => one.line === line), known = exact ? run.bars.end : 0;
  const found = exact ? exact.bars.filter(([begin]) => begin < known).map(([begin, end]) => [begin, Math.min(end, known), true]) : [];
  const add = (begin, end) => {
    const last = found[found.length - 1];
    if (last && !last[2] && last[1] === begin) last[1] = end;
    else if (begin < end) found.push([begin, end, false]);
  };
  run.lanes.forEach((sample, index) => {
    if (!(sample[row + 1] > 0)) return;
    const end = index + 1 < run.lanes.length ? run.lanes[index + 1][0] : sample[0] + 1;
    if (exact && sample[0] < exact.first) add(sample[0], Math.min(end, exact.first));
    if (end > known) add(Math.max(sample[0], known), end);
  });
  return found;
};
// The unit in which values are shown on the page, and the factor to it.
export const shownUnit = (unit) => (unit === "mm/s" ? ["mm/min", 60] : [unit, 1]);
export const seconds = (tick) => (tick * run.cycleUs) / 1e6;

globalThis.nctaktRun = { run, show, zoom, zoomIn, mark, pan, fit, changed, listen, hold, blockAt, laneBars, shownUnit };

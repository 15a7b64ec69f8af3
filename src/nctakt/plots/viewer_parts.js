// SPDX-License-Identifier: MIT
// The viewer of a run: its data and the parts of the page. page.py joins drawing/index.js and the
// files parts, time, path, pointer, in this order, into one function; they share the names declared here.
const run = JSON.parse(document.getElementById("run").textContent);
const view = document.getElementById("view");
const words = run.words;
const LEFT = 132, RIGHT = 216, LANE = 20, PANEL = 118, GAP = 14, AXIS = 26;

const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const floats = (text) => new Float32Array(bytes(text).buffer);
for (const panel of run.panels) {
  for (const line of panel.lines) Object.assign(line, { values: floats(line.values), shown: true });
}
if (run.path) {
  run.path.points = floats(run.path.points);
  run.path.positions = floats(run.path.positions);
  run.path.rapid = bytes(run.path.rapid);
}
const length = Math.max(run.end - run.begin, run.tick);
let from = run.begin - 0.01 * length, to = run.end + 0.01 * length;
let cursor = null, isHeld = false, drag = null, isDue = false;

// --- small helpers ---------------------------------------------------------------------------
const snapped = (time) => clamp(Math.round(time / run.tick) * run.tick, run.begin, run.end);
const draw = () => {
  if (isDue) return;
  isDue = true;
  requestAnimationFrame(() => { isDue = false; drawTime(); drawPath(); showValues(); });
};

// --- parts of the page -----------------------------------------------------------------------
const tools = document.getElementById("tools");
make("button", tools, { textContent: words.whole, onclick: () => wholeRun() });
const dark = window.matchMedia("(prefers-color-scheme: dark)");
const setTheme = (isDark) => { document.documentElement.dataset.theme = isDark ? "dark" : "light"; draw(); };
make("button", tools, {
  textContent: "◐", title: words.theme, ariaLabel: words.theme,
  onclick: () => setTheme(document.documentElement.dataset.theme !== "dark"),
});
dark.addEventListener("change", () => setTheme(dark.matches));
const pathPart = run.path ? make("section", view, { className: "part" }) : null;
const pathCanvas = pathPart && make("canvas", pathPart, { ariaLabel: "path", id: "path" });
const timePart = make("section", view, { className: "part", tabIndex: 0 });
const timeCanvas = make("canvas", timePart, { ariaLabel: words.time, id: "time" });
const tip = make("div", document.body, { id: "tip" });
make("p", document.body, { id: "help", textContent: words.help });
const lanesTop = 22, panelsTop = lanesTop + run.lanes.length * LANE + GAP;
const panelTop = (index) => panelsTop + index * (PANEL + GAP);
const timeHeight = panelTop(run.panels.length) + AXIS;

const legends = run.panels.map((panel, index) => {
  const legend = make("div", timePart, { className: "legend" });
  legend.style.top = `${panelTop(index)}px`;
  legend.style.maxHeight = `${PANEL}px`;
  return panel.lines.map((line) => {
    const button = make("button", legend, { ariaPressed: "true", title: line.name });
    make("i", button).style.background = line.colour;
    make("span", button, { textContent: line.name });
    button.onclick = () => { line.shown = !line.shown; button.ariaPressed = String(line.shown); draw(); };
    return make("b", button);
  });
});

// SPDX-License-Identifier: MIT
// The viewer of a run: its data, helpers, the parts of the page. page.py joins the files in the
// order parts, time, path, pointer into one function; they share what stands here.
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
const make = (tag, parent, properties = {}) => {
  const element = Object.assign(document.createElement(tag), properties);
  parent.append(element);
  return element;
};
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const snapped = (time) => clamp(Math.round(time / run.tick) * run.tick, run.begin, run.end);
const short = (value) => {
  if (Number.isInteger(value)) return String(value);
  return String(Number(value.toPrecision(6)));
};
const seconds = (time) => `${Number(time.toFixed(6))} s`;
const ticks = (low, high, count) => {
  const rough = (high - low) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= rough);
  const result = [];
  for (let n = Math.ceil(low / step); n * step <= high; n += 1) result.push(n * step);
  return { result, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
};
const cut = (pen, text, width) => {
  if (pen.measureText(text).width <= width) return text;
  let end = text.length;
  while (end > 1 && pen.measureText(`${text.slice(0, end)}…`).width > width) end -= 1;
  return `${text.slice(0, end)}…`;
};
const sized = (canvas, height) => {
  const scale = window.devicePixelRatio || 1, width = canvas.clientWidth;
  canvas.style.height = `${height}px`;
  if (canvas.width !== Math.round(width * scale) || canvas.height !== Math.round(height * scale)) {
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
  }
  const pen = canvas.getContext("2d");
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.font = "11px system-ui, sans-serif";
  return { pen, width, height };
};
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

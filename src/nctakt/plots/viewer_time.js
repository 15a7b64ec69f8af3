// SPDX-License-Identifier: MIT
// Lanes and curves over time, with one cursor through all of them.
// --- time ------------------------------------------------------------------------------------
const inner = () => timeCanvas.clientWidth - LEFT - RIGHT;
const xOf = (time) => LEFT + ((time - from) / (to - from)) * inner();
const timeOf = (x) => from + ((x - LEFT) / inner()) * (to - from);
const show = (begin, end) => {
  const margin = 0.01 * length, low = run.begin - margin, high = run.end + margin;
  const span = clamp(end - begin, Math.min(2 * run.tick, high - low), high - low);
  from = clamp(begin, low, high - span);
  to = from + span;
  draw();
};
const wholeRun = () => show(run.begin - length, run.end + length);
const zoom = (time, factor) => show(time - (time - from) * factor, time + (to - time) * factor);
const indexAt = (line, time) => {
  const index = (time - line.begin) / line.every + 1e-6;
  return clamp(line.step ? Math.floor(index) : Math.round(index), 0, line.values.length - 1);
};

const drawCurve = (pen, line, top, low, high) => {
  const { values, begin, every } = line;
  const yOf = (value) => top + PANEL - ((value - low) / (high - low)) * PANEL;
  const first = clamp(Math.floor((from - begin) / every) - 1, 0, values.length - 1);
  const last = clamp(Math.ceil((to - begin) / every) + 1, 0, values.length - 1);
  pen.beginPath();
  if (last - first > 3 * inner()) { // more points than pixels: lowest and highest value of each column
    let column = null, entry = first, lowest = first, highest = first;
    const close = (exit) => {
      const turns = lowest < highest ? [lowest, highest] : [highest, lowest];
      for (const i of [entry, ...turns, exit]) pen.lineTo(column, yOf(values[i]));
    };
    for (let i = first; i <= last; i += 1) {
      const x = Math.round(xOf(begin + i * every));
      if (x !== column) {
        if (column !== null) close(i - 1);
        column = x;
        entry = lowest = highest = i;
      } else if (values[i] < values[lowest]) lowest = i;
      else if (values[i] > values[highest]) highest = i;
    }
    close(last);
  } else {
    for (let i = first; i <= last; i += 1) {
      const x = xOf(begin + i * every), y = yOf(values[i]);
      if (line.step && i > first) pen.lineTo(x, yOf(values[i - 1]));
      pen.lineTo(x, y);
    }
    if (line.step) pen.lineTo(xOf(begin + (last + 1) * every), yOf(values[last]));
  }
  pen.strokeStyle = line.colour;
  pen.lineWidth = 1.4;
  pen.setLineDash(line.dotted ? [2, 3] : []);
  pen.stroke();
  pen.setLineDash([]);
};

const rangeOf = (panel) => {
  let low = Infinity, high = -Infinity;
  for (const line of panel.lines) {
    if (!line.shown || !line.values.length) continue;
    for (let i = indexAt(line, from); i <= indexAt(line, to); i += 1) {
      low = Math.min(low, line.values[i]);
      high = Math.max(high, line.values[i]);
    }
  }
  if (low > high) { low = 0; high = 1; }
  for (const [limit] of panel.limits) {
    if (high > 0.6 * limit) high = Math.max(high, limit);
    if (low < -0.6 * limit) low = Math.min(low, -limit);
  }
  const margin = high > low ? 0.07 * (high - low) : Math.max(1, Math.abs(high)) * 0.5;
  return [low - margin, high + margin];
};

const drawPanel = (pen, panel, top, width) => {
  const [low, high] = rangeOf(panel);
  const scale = ticks(low, high, 5);
  pen.textAlign = "right"; pen.textBaseline = "middle";
  for (const value of scale.result) {
    const y = top + PANEL - ((value - low) / (high - low)) * PANEL;
    pen.strokeStyle = colour("--grid"); pen.lineWidth = 1;
    pen.beginPath(); pen.moveTo(LEFT, y); pen.lineTo(width - RIGHT, y); pen.stroke();
    pen.fillStyle = colour("--faint");
    const text = Math.abs(value) >= 1e5 ? value.toExponential(1) : value.toFixed(scale.digits);
    pen.fillText(text, LEFT - 6, y);
  }
  pen.textAlign = "left"; pen.textBaseline = "alphabetic"; pen.fillStyle = colour("--ink");
  pen.fillText(cut(pen, panel.title, LEFT - 58), 10, top + 12);
  pen.fillStyle = colour("--faint");
  pen.fillText(panel.unit, 10, top + 27);
  pen.save();
  pen.beginPath(); pen.rect(LEFT, top, width - LEFT - RIGHT, PANEL); pen.clip();
  for (const [limit, tint] of panel.limits) {
    for (const value of [limit, -limit]) {
      const y = top + PANEL - ((value - low) / (high - low)) * PANEL;
      pen.strokeStyle = tint; pen.setLineDash([6, 5]); pen.lineWidth = 1;
      pen.beginPath(); pen.moveTo(LEFT, y); pen.lineTo(width - RIGHT, y); pen.stroke();
      pen.setLineDash([]);
    }
  }
  for (const line of panel.lines) if (line.shown && line.values.length) drawCurve(pen, line, top, low, high);
  pen.restore();
};

const drawBars = (pen, bars, tint, alpha, y, height, named) => {
  let past = -1;
  pen.globalAlpha = alpha; pen.fillStyle = tint;
  for (const [begin, end, name] of bars) {
    if (end < from) continue;
    if (begin > to) break;
    const left = Math.max(xOf(begin), LEFT), right = Math.min(xOf(end), LEFT + inner());
    const width = Math.max(right - left, 2);
    if (left + width < past + 0.6) continue; // hidden by the previous bar
    past = left + width;
    pen.fillRect(left, y + (LANE - height) / 2, width - (named && width > 4 ? 1 : 0), height);
    if (named && width > 22) {
      pen.globalAlpha = 1; pen.fillStyle = colour("--ink");
      pen.textAlign = "left"; pen.textBaseline = "middle";
      pen.fillText(cut(pen, run.texts[name], width - 8), left + 4, y + LANE / 2);
      pen.globalAlpha = alpha; pen.fillStyle = tint;
    }
  }
  pen.globalAlpha = 1;
};

const drawLanes = (pen, width) => {
  run.lanes.forEach((lane, index) => {
    const y = lanesTop + index * LANE, isNamed = ["channel", "block", "wait", "cycle", "axis", "spindle", "message"].includes(lane.kind);
    pen.textBaseline = "middle"; pen.textAlign = "right"; pen.fillStyle = colour("--ink");
    const label = lane.number ? `(${lane.number}) ${lane.label}` : lane.label;
    pen.fillText(cut(pen, label, LEFT - 16), LEFT - 8, y + LANE / 2);
    pen.textAlign = "left"; pen.fillStyle = colour("--faint");
    if (lane.text) pen.fillText(cut(pen, lane.text, RIGHT - 18), width - RIGHT + 8, y + LANE / 2);
    pen.save();
    pen.beginPath(); pen.rect(LEFT, y, width - LEFT - RIGHT, LANE); pen.clip();
    drawBars(pen, lane.background, lane.colour, 0.25, y, 15, false);
    drawBars(pen, lane.bars, lane.colour, isNamed ? 0.5 : 0.95, y, isNamed ? 14 : 9, isNamed);
    pen.restore();
  });
};

// Signals from the lane of their sender to that of their receiver.
const drawArrows = (pen, width) => {
  pen.save();
  pen.beginPath(); pen.rect(LEFT, lanesTop, width - LEFT - RIGHT, run.lanes.length * LANE); pen.clip();
  pen.strokeStyle = pen.fillStyle = colour("--arrow"); pen.lineWidth = 1.3;
  for (const [begin, end, sender, receiver, name] of run.arrows) {
    if (end < from || begin > to) continue;
    const yOf = (lane) => lanesTop + (lane + 0.5) * LANE;
    const x = xOf(begin), y = yOf(sender), toX = xOf(end), toY = yOf(receiver);
    pen.beginPath(); pen.moveTo(x, y); pen.lineTo(toX, toY); pen.stroke();
    const angle = Math.atan2(toY - y, toX - x);
    pen.beginPath(); pen.moveTo(toX, toY);
    for (const side of [0.4, -0.4]) pen.lineTo(toX - 8 * Math.cos(angle + side), toY - 8 * Math.sin(angle + side));
    pen.fill();
    pen.textAlign = "left"; pen.textBaseline = "middle";
    pen.fillText(run.texts[name], (x + toX) / 2 + 5, (y + toY) / 2);
  }
  pen.restore();
};

// Lines through all panels where reactions begin, unless they would hide the curves.
const drawMoments = (pen, bottom) => {
  const begun = run.lanes.filter((lane) => lane.number).flatMap((lane) =>
    lane.bars.filter(([begin]) => begin >= from && begin <= to).map(([begin]) => [begin, lane.colour]));
  if (begun.length > 60) return;
  pen.globalAlpha = 0.4; pen.lineWidth = 1;
  for (const [time, tint] of begun) {
    pen.strokeStyle = tint;
    pen.beginPath(); pen.moveTo(xOf(time), lanesTop); pen.lineTo(xOf(time), bottom); pen.stroke();
  }
  pen.globalAlpha = 1;
};

const drawTime = () => {
  const { pen, width, height } = sized(timeCanvas, timeHeight);
  const bottom = height - AXIS, scale = ticks(from, to, inner() / 90);
  pen.textAlign = "center"; pen.textBaseline = "top";
  for (const time of scale.result) {
    const x = xOf(time);
    pen.strokeStyle = colour("--grid"); pen.lineWidth = 1;
    pen.beginPath(); pen.moveTo(x, lanesTop); pen.lineTo(x, bottom); pen.stroke();
    pen.fillStyle = colour("--faint");
    pen.fillText(time.toFixed(scale.digits), x, bottom + 2);
  }
  pen.textAlign = "right";
  pen.fillText(words.time, width - 12, bottom + 2);
  drawMoments(pen, bottom);
  drawLanes(pen, width);
  drawArrows(pen, width);
  run.panels.forEach((panel, index) => drawPanel(pen, panel, panelTop(index), width));
  if (drag && drag.kind === "range") {
    pen.fillStyle = colour("--chosen");
    pen.fillRect(Math.min(drag.x, drag.now), lanesTop, Math.abs(drag.now - drag.x), bottom - lanesTop);
  }
  if (cursor !== null && cursor >= from && cursor <= to) {
    const x = xOf(cursor);
    pen.strokeStyle = colour("--cursor"); pen.lineWidth = 1; pen.setLineDash(isHeld ? [] : [3, 3]);
    pen.beginPath(); pen.moveTo(x, 18); pen.lineTo(x, bottom); pen.stroke(); pen.setLineDash([]);
    pen.fillStyle = colour("--ink"); pen.textAlign = "center"; pen.textBaseline = "top";
    pen.fillText(seconds(cursor), clamp(x, LEFT + 30, width - RIGHT - 30), 4);
  }
};

const showValues = () => {
  run.panels.forEach((panel, index) => panel.lines.forEach((line, place) => {
    const hasValue = cursor !== null && line.values.length;
    legends[index][place].textContent = hasValue ? short(line.values[indexAt(line, cursor)]) : "";
  }));
};

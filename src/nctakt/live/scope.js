// SPDX-License-Identifier: MIT
// The scope: conditions as lanes, curves by unit, marks of reactions and functions, one cursor.
import { clamp, colour, cut, short, sized, ticks } from "nctakt-drawing";
import { blockAt, changed, compared, curves, fit, indexAt, laneBars, listen, mark, pan, run, seconds, show, shownUnit, take, zoom } from "nctakt-store";

const LEFT = 50, RIGHT = 8, LANE = 15, ROW = 20, AXIS = 17, LABEL = 12, LABEL_ROWS = 3, MAX_PANELS = 4, MAX_LANES = 6, LEGEND = 14;
const FILTER = "nctakt filter of conditions"; // kept when this page is reloaded
const LANES_TOP = LABEL * LABEL_ROWS + 3;
const COLOURS = ["#3b82f6", "#e8833a", "#22a06b", "#c2549d", "#b08900", "#7c6ff0", "#0ea5b7", "#d64545",
  "#84a316", "#a16ae8", "#64748b", "#d97796"];
const MARKS = { fired: "#e8833a", M: "#8b7cf6", H: "#8b7cf6", output: "#8b7cf6", message: "#0ea5b7", error: "#d64545" };

export default {
  template: '<div class="nc-drawing"><canvas tabindex="0" role="img" :aria-label="name"></canvas></div>',
  props: { words: Object, name: String },
  mounted() {
    run.words = { ...run.words, ...this.words };
    this.canvas = this.$el.firstChild;
    this.stop = listen(() => this.draw());
    this.observer = new ResizeObserver(changed);
    this.observer.observe(this.$el);
    this.pointers = new Map();
    const kept = sessionStorage.getItem(FILTER);
    if (kept) this.$emit("kept", kept);
    const on = (name, handler, options) => this.canvas.addEventListener(name, handler, options);
    on("pointermove", (event) => this.move(event));
    on("pointerdown", (event) => this.press(event));
    on("pointerup", (event) => this.release(event));
    on("pointercancel", (event) => this.pointers.delete(event.pointerId));
    on("pointerleave", () => { if (!this.grip) { run.cursor = null; changed(); } });
    on("dblclick", () => this.fit());
    on("wheel", (event) => this.wheel(event), { passive: false });
  },
  beforeUnmount() { this.stop(); this.observer.disconnect(); },
  methods: {
    take(news) { take(news); },
    fit() { fit(); },
    zoomBy(factor) { zoom((run.from + run.to) / 2, factor); this.ask(); },
    mark() { mark(); },
    keepFilter(text) { sessionStorage.setItem(FILTER, text); },
    panBy(share) { pan(share); this.ask(); },
    scrollLanes(rows) {
      run.firstLane = clamp(run.firstLane + rows, 0, Math.max(0, run.lanesShown.length - MAX_LANES));
      changed();
    },
    // Scrolls to the condition under the pointer in the editor.
    followLine() {
      const row = run.line === this.line ? -1 : run.lanesShown.findIndex((index) => run.conditions[index] === run.line);
      this.line = run.line;
      if (row < 0) return;
      run.firstLane = clamp(run.firstLane, Math.max(0, row - MAX_LANES + 1), row);
    },

    // --- places ------------------------------------------------------------------------------
    inner() { return Math.max(1, this.wide - LEFT - RIGHT); },
    xOf(tick) { return LEFT + ((tick - run.from) / (run.to - run.from)) * this.inner(); },
    tickOf(x) { return run.from + ((x - LEFT) / this.inner()) * (run.to - run.from); },

    // The nearest tick with known values: travelling there shows the same values.
    tickAt(x) {
      const tick = clamp(Math.round(this.tickOf(x)), 0, Math.max(run.latest, run.tick, 0)), { ticks: known } = curves();
      const before = known[indexAt(known, tick)] ?? -Infinity, after = known[indexAt(known, tick) + 1] ?? Infinity;
      const near = tick - before <= after - tick ? before : after;
      return Number.isFinite(near) ? near : tick;
    },

    // --- pointer -----------------------------------------------------------------------------
    move(event) {
      if (this.pointers.has(event.pointerId)) this.pointers.set(event.pointerId, event.offsetX);
      if (this.pointers.size === 2) { this.pinch(); return; }
      if (this.grip) {
        const way = event.offsetX - this.grip.x;
        if (Math.abs(way) > 4) this.grip.isMoved = true;
        const shift = (way / this.inner()) * (this.grip.to - this.grip.from);
        if (this.grip.isMoved && this.grip.anchor !== null) {
          run.anchor = this.grip.anchor;
          run.head = this.tickAt(event.offsetX);
        } else if (this.grip.isMoved) show(this.grip.from - shift, this.grip.to - shift);
      }
      run.cursor = this.tickAt(event.offsetX);
      changed();
    },
    pinch() {
      const [a, b] = [...this.pointers.values()], width = Math.max(20, Math.abs(a - b));
      if (this.width) zoom(this.tickOf((a + b) / 2), this.width / width);
      this.width = width;
      if (this.grip) this.grip.isMoved = true;
    },
    press(event) {
      this.canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, event.offsetX);
      this.width = 0;
      this.grip = { x: event.offsetX, from: run.from, to: run.to, isMoved: this.pointers.size > 1,
        anchor: event.shiftKey ? this.tickAt(event.offsetX) : null };
    },
    release(event) {
      const { grip } = this;
      this.pointers.delete(event.pointerId);
      this.grip = null;
      if (!grip) return;
      if (grip.isMoved) this.ask();
      else if (grip.anchor !== null) {
        run.anchor = grip.anchor === run.anchor ? null : grip.anchor;
        run.head = null;
        changed();
      }
      else if (event.offsetX >= LEFT) {
        this.$emit("travel", clamp(this.tickAt(event.offsetX), 0, run.latest));
      }
    },
    wheel(event) {
      event.preventDefault();
      const { length } = run.lanesShown, lanes = event.offsetY - LANES_TOP;
      if (length > MAX_LANES && lanes >= 0 && lanes < MAX_LANES * LANE) {
        this.scrollLanes(Math.sign(event.deltaY));
        return;
      }
      if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
        pan((event.deltaX || event.deltaY) / this.inner());
      } else zoom(this.tickOf(event.offsetX), Math.exp(clamp(event.deltaY, -200, 200) * 0.003));
      this.ask();
    },
    // Asks for details of the shown stretch once it has not changed for a moment.
    ask() {
      clearTimeout(this.asking);
      this.asking = setTimeout(() => {
        if (!run.isPlaying && !run.follows) this.$emit("stretch", [Math.floor(run.from), Math.ceil(run.to) + 1]);
      }, 200);
    },

    // --- drawing -----------------------------------------------------------------------------
    draw() {
      if (!this.$el.clientHeight) return;
      const { pen, width, height } = sized(this.canvas, this.$el.clientHeight);
      this.wide = width;
      const shown = curves(), { lanesShown } = run, units = new Map();
      const booleans = [];
      run.names.slice(0, run.names.length - run.hidden).forEach((_, index) => {
        if (run.booleans[index]) { booleans.push(index); return; }
        const unit = run.units[index];
        const key = units.has(unit) || units.size < MAX_PANELS ? unit : [...units.keys()].pop();
        units.set(key, [...(units.get(key) || []), index]);
      });
      this.followLine();
      run.firstLane = clamp(run.firstLane, 0, Math.max(0, lanesShown.length - MAX_LANES));
      const lanesTop = LANES_TOP, rows = Math.min(lanesShown.length, MAX_LANES), top = lanesTop + rows * LANE + 4;
      const bottom = height - AXIS, middle = bottom - booleans.length * ROW;
      const each = units.size ? (middle - top) / units.size : middle - top;
      this.drawTime(pen, width, lanesTop, bottom);
      this.drawLine(pen, lanesTop, bottom);
      for (let row = 0; row < rows; row += 1) {
        const index = lanesShown[run.firstLane + row];
        this.drawCondition(pen, run.conditions[index], index, lanesTop + row * LANE, width);
      }
      if (lanesShown.length > rows) { // which part of the conditions is shown
        const share = (rows * LANE) / lanesShown.length;
        pen.fillStyle = colour("--nc-soft");
        pen.fillRect(width - RIGHT + 3, lanesTop + run.firstLane * share, 3, rows * share);
      }
      this.drawMarks(pen, width, lanesTop, bottom);
      let place = 0, tint = 0;
      for (const [unit, indices] of units) {
        const tints = indices.map(() => COLOURS[(tint++) % COLOURS.length]);
        this.drawPanel(pen, shown, unit, indices, tints, top + place * each + 3, each - 8, width);
        place += 1;
      }
      booleans.forEach((index, row) => {
        this.drawBoolean(pen, shown, index, COLOURS[(tint + row) % COLOURS.length], middle + row * ROW, width);
      });
      this.drawPlaces(pen, width, lanesTop, bottom);
    },
    drawTime(pen, width, top, bottom) {
      const scale = ticks(seconds(run.from), seconds(run.to), Math.max(4, this.inner() / 85));
      const room = width - RIGHT - pen.measureText("s").width - 4;
      pen.textAlign = "center"; pen.textBaseline = "top";
      for (const time of scale.result) {
        const x = this.xOf((time * 1e6) / run.cycleUs);
        pen.strokeStyle = colour("--nc-grid"); pen.lineWidth = 1;
        pen.beginPath(); pen.moveTo(x, top); pen.lineTo(x, bottom); pen.stroke();
        pen.fillStyle = colour("--nc-soft");
        const text = time.toFixed(scale.digits), half = pen.measureText(text).width / 2;
        if (x - half > LEFT + 2 && x + half < room) pen.fillText(text, x, bottom + 3);
      }
      pen.textAlign = "right";
      pen.fillText("s", width - RIGHT, bottom + 3);
    },
    // The ticks in which the line under the pointer in the editor is current, or its branch fires.
    drawLine(pen, top, bottom) {
      if (!run.line) return;
      pen.fillStyle = colour("--nc-chosen");
      run.blocks.forEach(([begin, line], index) => {
        if (line !== run.line) return;
        const end = index + 1 < run.blocks.length ? run.blocks[index + 1][0] : run.latest;
        const left = Math.max(LEFT, this.xOf(begin)), right = Math.min(this.xOf(end), LEFT + this.inner());
        if (right > left) pen.fillRect(left, top, Math.max(2, right - left), bottom - top);
      });
    },
    drawCondition(pen, line, row, y, width) {
      pen.textAlign = "right"; pen.textBaseline = "middle"; pen.fillStyle = colour("--nc-soft");
      pen.fillText(`${run.words.line} ${line}`, LEFT - 5, y + LANE / 2);
      pen.fillStyle = colour("--nc-grid");
      pen.fillRect(LEFT, y + LANE / 2, this.inner(), 1);
      pen.fillStyle = "#22a06b";
      let drawn = 0;
      for (const [begin, end, isExact] of laneBars(line, row)) {
        const left = Math.max(this.xOf(begin), LEFT), right = Math.max(Math.min(this.xOf(end), width - RIGHT), left + 1.5);
        if (right < LEFT || left > width - RIGHT || right <= drawn + 0.5) continue; // one column may have thousands
        drawn = right;
        pen.globalAlpha = isExact ? 1 : 0.55; // sampled: unknown in between
        pen.fillRect(left, y + 3, right - left, LANE - 6);
      }
      pen.globalAlpha = 1;
    },
    drawMarks(pen, width, top, bottom) {
      const ends = Array(LABEL_ROWS).fill(-Infinity), groups = [];
      for (const [tick, kind, label, line] of run.marks) { // marks at one place form a group
        if (tick < run.from || tick > run.to) continue;
        const x = this.xOf(tick), last = groups[groups.length - 1];
        const isChosen = Boolean(line) && line === run.line;
        if (last && x - last.x < 1.5) {
          if (last.labels.length < 3 && !last.labels.includes(label)) last.labels.push(label);
          last.isChosen ||= isChosen;
        } else groups.push({ x, kind, labels: [label], isChosen });
      }
      pen.font = "10px system-ui, sans-serif"; pen.textAlign = "left"; pen.textBaseline = "middle";
      for (const { x, kind, labels, isChosen } of groups) {
        pen.strokeStyle = MARKS[kind] || MARKS.M; pen.fillStyle = pen.strokeStyle;
        pen.globalAlpha = isChosen ? 1 : 0.65; pen.lineWidth = isChosen ? 2 : 1;
        pen.setLineDash(kind === "fired" ? [4, 3] : [1.5, 2.5]);
        const label = labels.join(" "), wide = pen.measureText(label).width + 8;
        const left = Math.min(x + 2, width - RIGHT - wide + 4);
        const row = ends.findIndex((end) => end < left);
        const begin = row < 0 ? top - 3 : row * LABEL + 1;
        pen.beginPath(); pen.moveTo(x, begin); pen.lineTo(x, bottom); pen.stroke();
        pen.setLineDash([]); pen.globalAlpha = 1;
        if (row < 0) continue; // no room for a label
        pen.fillText(label, left, row * LABEL + LABEL / 2 + 1);
        ends[row] = left + wide;
      }
      pen.font = "11px system-ui, sans-serif";
    },
    drawPanel(pen, shown, unit, indices, tints, top, height, width) {
      let low = Infinity, high = -Infinity;
      const [begin, end] = this.rowsOf(shown);
      const include = (value) => {
        if (!Number.isFinite(value)) return;
        if (value < low) low = value;
        if (value > high) high = value;
      };
      for (const index of indices) {
        for (let i = begin; i <= end; i += 1) include(shown.columns[index][i]);
        const logged = this.loggedIn(index);
        if (logged) for (let i = logged.begin; i <= logged.end; i += 1) include(logged.values[i]);
      }
      if (!(low <= high)) { low = 0; high = 1; }
      const margin = high > low ? 0.06 * (high - low) : Math.max(1, Math.abs(high)) * 0.5;
      low -= margin; high += margin;
      const isAlike = indices.every((index) => run.units[index] === unit);
      const [label, factor] = isAlike ? shownUnit(unit) : [unit, 1];
      const entries = this.legendPlaces(pen, shown, factor, indices, width, height);
      const legend = LEGEND * (entries[entries.length - 1].row + 1), inside = Math.max(4, height - legend);
      const yOf = (value) => top + legend + inside - ((value - low) / (high - low)) * inside;
      const scale = ticks(low * factor, high * factor, inside / 28);
      pen.textAlign = "right"; pen.textBaseline = "middle";
      for (const value of scale.result) {
        const y = yOf(value / factor);
        pen.strokeStyle = colour("--nc-grid"); pen.lineWidth = 1;
        pen.beginPath(); pen.moveTo(LEFT, y); pen.lineTo(width - RIGHT, y); pen.stroke();
        pen.fillStyle = colour("--nc-soft");
        const text = Math.abs(value) >= 1e5 ? value.toExponential(1) : value.toFixed(scale.digits);
        if (y > top + legend + 4 && y < top + height - 2) pen.fillText(text, LEFT - 5, y);
      }
      pen.save();
      pen.beginPath(); pen.rect(LEFT, top, this.inner(), height + 2); pen.clip();
      indices.forEach((index, place) => this.drawLogged(pen, shown, index, tints[place], unit === "", yOf, top + height));
      indices.forEach((index, place) => this.drawCurve(pen, shown, index, tints[place], begin, end, unit === "", yOf));
      pen.restore();
      this.drawLegend(pen, label, entries, tints, top);
    },
    // The rows of the shown stretch, and one more on either side.
    rowsOf(shown) {
      const begin = Math.max(0, indexAt(shown.ticks, run.from));
      return [begin, Math.min(shown.ticks.length - 1, indexAt(shown.ticks, run.to) + 1)];
    },
    // A separate row for a truth value: filled while it is true, with its name inside.
    drawBoolean(pen, shown, index, tint, top, width) {
      const [begin, end] = this.rowsOf(shown), low = top + ROW - 3, high = top + 3;
      const yOf = (value) => (value > 0 ? high : low);
      pen.save();
      pen.beginPath(); pen.rect(LEFT, top, this.inner(), ROW); pen.clip();
      pen.fillStyle = tint; pen.globalAlpha = 0.2;
      let first = -1; // adjacent rows are one shape: two would have a seam
      for (let i = begin; i <= end; i += 1) {
        const isTrue = shown.columns[index][i] > 0;
        if (isTrue && first < 0) first = i;
        if (first < 0 || (isTrue && i < end)) continue;
        const left = this.xOf(shown.ticks[first]), right = this.xOf(shown.ticks[i]);
        pen.fillRect(left, high, right - left, low - high);
        first = -1;
      }
      pen.globalAlpha = 1;
      this.drawLogged(pen, shown, index, tint, true, yOf, top + ROW);
      this.drawCurve(pen, shown, index, tint, begin, end, true, yOf);
      pen.restore();
      pen.fillStyle = colour("--nc-ink"); pen.textAlign = "left"; pen.textBaseline = "middle";
      pen.fillText(cut(pen, this.legendOf(shown, index, 1), width - RIGHT - LEFT - 8), LEFT + 4, top + ROW / 2);
    },
    // Rows within half a pixel are one line from their lowest to their highest value.
    drawCurve(pen, shown, index, tint, begin, end, isStep, yOf) {
      const values = shown.columns[index], known = shown.ticks;
      const half = (2 * this.inner()) / (run.to - run.from); // half pixels per tick
      let x = NaN, low, high, last;
      const close = () => {
        if (high > low) { pen.lineTo(x, low); pen.lineTo(x, high); pen.lineTo(x, last); }
      };
      pen.strokeStyle = tint; pen.lineWidth = 1.5;
      pen.beginPath();
      for (let i = begin; i <= end; i += 1) {
        if (!Number.isFinite(values[i])) { close(); x = NaN; continue; }
        const at = LEFT + Math.round((known[i] - run.from) * half) / 2, y = yOf(values[i]);
        if (at === x) {
          if (y < low) low = y;
          if (y > high) high = y;
          last = y;
          continue;
        }
        if (Number.isNaN(x)) pen.moveTo(at, y);
        else {
          close();
          if (isStep) pen.lineTo(at, last);
          pen.lineTo(at, y);
        }
        x = at; low = y; high = y; last = y;
      }
      close();
      pen.stroke();
    },
    // The shown part of a machine's log, null without one.
    loggedIn(index) {
      const logged = run.logged[run.names[index]];
      if (!logged) return null;
      const begin = Math.max(0, indexAt(logged.ticks, run.from));
      return { ...logged, begin, end: Math.min(logged.ticks.length - 1, indexAt(logged.ticks, run.to) + 1) };
    },
    // The log as a second, pale curve; the area between both is red, with a bar where the tolerance is exceeded.
    drawLogged(pen, shown, index, tint, isStep, yOf, bottom) {
      const logged = this.loggedIn(index);
      if (!logged) return;
      const line = new Path2D(), area = new Path2D(), back = [];
      let last = null;
      for (let i = logged.begin; i <= logged.end; i += 1) {
        const tick = logged.ticks[i], x = this.xOf(tick), y = yOf(logged.values[i]);
        if (isStep && last !== null) line.lineTo(x, last);
        line[last === null ? "moveTo" : "lineTo"](x, y);
        last = y;
        const own = this.valueAt(shown, index, tick);
        if (own === null) continue;
        area[back.length ? "lineTo" : "moveTo"](x, y);
        back.push([x, yOf(own)]);
      }
      for (const [x, y] of back.reverse()) area.lineTo(x, y);
      pen.strokeStyle = tint; pen.globalAlpha = 0.45; pen.lineWidth = 4;
      pen.stroke(line);
      pen.fillStyle = MARKS.error; pen.globalAlpha = 0.5;  // on top, since a narrow area would be hidden
      if (!isStep) pen.fill(area);
      pen.globalAlpha = 1;
      for (const [begin, end] of logged.beyond) {
        pen.fillRect(this.xOf(begin), bottom - 3, Math.max(2, this.xOf(end) - this.xOf(begin)), 3);
      }
    },
    // The value of a drawn curve between two ticks, null outside the curve.
    valueAt(shown, index, tick) {
      const at = indexAt(shown.ticks, tick), values = shown.columns[index];
      if (at < 0 || !Number.isFinite(values[at])) return null;
      if (at + 1 >= values.length) return tick > shown.ticks[at] ? null : values[at];
      const share = (tick - shown.ticks[at]) / (shown.ticks[at + 1] - shown.ticks[at]);
      return values[at] + share * (values[at + 1] - values[at]);
    },
    // The log's value at a tick as text, if the browser has all samples.
    loggedText(index, tick, factor) {
      const logged = run.logged[run.names[index]];
      if (!logged || !logged.isWhole) return "";
      // less than a step beyond its ends, the log has the value of its first or last sample
      const { ticks, values } = logged, last = ticks.length - 1, near = clamp(tick, ticks[0], ticks[last]);
      const step = last < 1 ? 1 : near > ticks[0] ? ticks[last] - ticks[last - 1] : ticks[1] - ticks[0];
      const value = Math.abs(tick - near) >= Math.max(1, step) ? null : this.valueAt({ ticks, columns: [values] }, 0, near);
      return value === null ? "" : ` ${run.words.log} ${short(value * factor)}`;
    },
    // Name and value at the cursor, else at the session's tick; in a comparison also the difference.
    legendOf(shown, index, factor) {
      const both = compared(), tick = both ? both[1] : run.cursor, isNow = tick === null || tick === run.tick;
      const at = tick === null ? -1 : indexAt(shown.ticks, tick);
      const from = both ? indexAt(shown.ticks, both[0]) : -1;
      const value = isNow ? run.now[index] : at < 0 ? null : shown.columns[index][at];
      const before = from < 0 ? null : shown.columns[index][from];
      const known = Number.isFinite(value), name = run.names[index].replace(".ACS.ACT_POS", "");
      const logged = this.loggedText(index, tick ?? run.tick, factor);
      if (run.booleans[index]) {
        const word = (truth) => (truth > 0 ? "TRUE" : "FALSE");
        const was = known && Number.isFinite(before) && before !== value ? `${word(before)} → ` : "";
        return `${name} ${known ? was + word(value) : ""}${logged}`;
      }
      const away = known && Number.isFinite(before) ? ` Δ ${short((value - before) * factor)}` : "";
      return `${name} ${known ? short(value * factor) : ""}${away}${logged}`;
    },
    // Places for the names and values of a panel: as many rows as needed, but at most half of the panel.
    legendPlaces(pen, shown, factor, indices, width, height) {
      const right = width - RIGHT, rows = Math.max(1, Math.floor(height / 2 / LEGEND));
      let x = LEFT + 4, row = 0;
      return indices.map((index) => {
        const text = this.legendOf(shown, index, factor), wide = 14 + pen.measureText(text).width;
        if (x > LEFT + 4 && x + wide > right && row + 1 < rows) { x = LEFT + 4; row += 1; }
        const place = { x, row, text: right - x < 38 ? "" : cut(pen, text, right - x - 14) };
        x += wide + 10;
        return place;
      });
    },
    drawLegend(pen, label, entries, tints, top) {
      pen.textAlign = "right"; pen.textBaseline = "middle"; pen.fillStyle = colour("--nc-soft");
      pen.fillText(label, LEFT - 5, top + 6);
      pen.textAlign = "left";
      entries.forEach(({ x, row, text }, place) => {
        if (!text) return;
        pen.fillStyle = tints[place]; pen.fillRect(x, top + row * LEGEND + 4, 9, 4);
        pen.fillStyle = colour("--nc-ink");
        pen.fillText(text, x + 12, top + row * LEGEND + 6.5);
      });
    },
    // Draws the compared stretch between two ticks, with its length.
    drawCompared(pen, width, top, bottom) {
      const both = compared();
      if (!both) return;
      const [left, right] = [Math.min(...both), Math.max(...both)].map((tick) => clamp(this.xOf(tick), LEFT, width - RIGHT));
      pen.fillStyle = colour("--nc-chosen");
      if (run.head !== null) pen.fillRect(left, top, right - left, bottom - top);
      pen.strokeStyle = "#7c6ff0"; pen.lineWidth = 1.4;
      for (const tick of both) {
        if (tick < run.from || tick > run.to) continue;
        const x = this.xOf(tick);
        pen.beginPath(); pen.moveTo(x, top); pen.lineTo(x, bottom); pen.stroke();
      }
      const ticksAway = both[1] - both[0];
      const text = `Δ ${Number(seconds(ticksAway).toFixed(6))} s · ${ticksAway} ${run.words.ticks}`;
      const wide = pen.measureText(text).width + 10;
      const at = clamp((left + right - wide) / 2, LEFT, width - RIGHT - wide);
      pen.fillStyle = colour("--nc-card"); pen.fillRect(at, bottom - 16, wide, 15);
      pen.fillStyle = colour("--nc-ink"); pen.textAlign = "left"; pen.textBaseline = "middle";
      pen.fillText(text, at + 5, bottom - 8);
    },
    // Draws the session's tick, and the cursor with its time and line.
    drawPlaces(pen, width, top, bottom) {
      if (run.tick >= run.from && run.tick <= run.to) {
        const x = this.xOf(run.tick);
        pen.strokeStyle = "#d64545"; pen.lineWidth = 1.6;
        pen.beginPath(); pen.moveTo(x, top); pen.lineTo(x, bottom); pen.stroke();
      }
      this.drawCompared(pen, width, top, bottom);
      if (run.cursor === null || run.cursor < run.from || run.cursor > run.to) return;
      const x = this.xOf(run.cursor), block = blockAt(run.cursor);
      pen.strokeStyle = colour("--nc-ink"); pen.lineWidth = 1; pen.setLineDash([3, 3]);
      pen.beginPath(); pen.moveTo(x, top); pen.lineTo(x, bottom); pen.stroke(); pen.setLineDash([]);
      const where = block ? ` · ${run.words.line} ${block[1]}` : "";
      const text = `${Number(seconds(run.cursor).toFixed(6))} s${where}`, wide = pen.measureText(text).width + 10;
      const left = clamp(x - wide / 2, LEFT, width - RIGHT - wide);
      pen.fillStyle = colour("--nc-ink"); pen.fillRect(left, bottom + 1, wide, AXIS - 2);
      pen.fillStyle = colour("--nc-card"); pen.textAlign = "left"; pen.textBaseline = "middle";
      pen.fillText(text, left + 5, bottom + AXIS / 2 + 0.5);
    },
  },
};

// SPDX-License-Identifier: MIT
// The path of the tool in space or in the plane: feed, rapid, reactions, the tool, the cursor.
import { clamp, colour, sized, ticks } from "nctakt-drawing";
import { changed, indexAt, listen, run } from "nctakt-store";

const FEED = "#3b82f6", RAPID = "#9aa1ab", FIRED = "#e8833a", TOOL = "#d64545", LIMIT = "#b3261e";
const CHANNELS = [FEED, "#c2549d", "#b08900", "#7a5c3e"]; // feed of channel 1, 2 …

// The horizontal and the vertical axis of a view, none in space.
const VIEWS = { space: null, top: [0, 1], front: [0, 2], side: [1, 2] };

export default {
  template: '<div class="nc-drawing"><canvas role="img" :aria-label="name"></canvas></div>',
  props: { axes: Array, tip: Array, direction: Array, rapid: String, name: String, limits: Array,
    channel: Number, others: Array },
  mounted() {
    this.canvas = this.$el.firstChild;
    this.camera = { zoom: 1, x: 0, y: 0, turn: -0.55, tilt: 0.9, view: this.axes.length > 2 ? "space" : "top" };
    this.stop = listen(() => this.draw());
    this.observer = new ResizeObserver(changed);
    this.observer.observe(this.$el);
    const on = (name, handler, options) => this.canvas.addEventListener(name, handler, options);
    on("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.grip = { x: event.offsetX, y: event.offsetY, start: { ...this.camera }, isMoved: false };
    });
    on("pointermove", (event) => (this.grip ? this.drag(event) : this.hover(event)));
    on("pointerup", (event) => {
      const { grip } = this;
      this.grip = null;
      if (!grip || grip.isMoved) return;
      this.hover(event);
      if (run.cursor !== null) this.$emit("travel", run.cursor);
    });
    on("pointerleave", () => { if (!this.grip) { run.cursor = null; changed(); } });
    on("dblclick", () => { Object.assign(this.camera, { zoom: 1, x: 0, y: 0 }); changed(); });
    on("wheel", (event) => this.wheel(event), { passive: false });
  },
  beforeUnmount() { this.stop(); this.observer.disconnect(); },
  methods: {
    turnView() {
      const views = this.axes.length > 2 ? Object.keys(VIEWS) : ["top"];
      this.showFrom(views[(views.indexOf(this.camera.view) + 1) % views.length]);
    },
    showFrom(view) {
      if (view !== "top" && this.axes.length < 3) return;
      Object.assign(this.camera, { view, turn: -0.55, tilt: 0.9, zoom: 1, x: 0, y: 0 });
      changed();
    },

    // With a transformation the position of the tip differs from that of the axes.
    showAxes(isWished) { this.showsAxes = isWished; changed(); },
    shown() { return this.tip.length && !this.showsAxes ? this.tip : this.axes; },
    showsTip() { return this.shown() === this.tip; },

    // --- pointer -----------------------------------------------------------------------------
    drag(event) {
      const dx = event.offsetX - this.grip.x, dy = event.offsetY - this.grip.y, { start } = this.grip;
      if (Math.hypot(dx, dy) > 4) this.grip.isMoved = true;
      if (!VIEWS[this.camera.view] && !event.shiftKey) {
        this.camera.turn = start.turn + dx * 0.008;
        this.camera.tilt = clamp(start.tilt + dy * 0.008, 0, Math.PI / 2);
      } else { this.camera.x = start.x + dx; this.camera.y = start.y + dy; }
      changed();
    },
    hover(event) {
      const place = this.placer();
      let best = 14, found = null;
      for (let i = 0; i < run.ticks.length; i += 1) {
        const [x, y] = place(this.pointAt(i)), away = Math.hypot(x - event.offsetX, y - event.offsetY);
        if (away < best) { best = away; found = run.ticks[i]; }
      }
      run.cursor = found;
      changed();
    },
    wheel(event) {
      event.preventDefault();
      const { camera } = this, factor = Math.exp(-clamp(event.deltaY, -200, 200) * 0.002);
      const dx = event.offsetX - this.$el.clientWidth / 2 - camera.x;
      const dy = event.offsetY - this.$el.clientHeight / 2 - camera.y;
      camera.zoom = clamp(camera.zoom * factor, 0.2, 500);
      camera.x += dx * (1 - factor); camera.y += dy * (1 - factor);
      changed();
    },

    // --- places ------------------------------------------------------------------------------
    // The path of a channel: columns of its axes, past and future; null without such an axis.
    trailOf(channel, names, rapid) {
      const column = (name) => run.columns[run.names.indexOf(name)];
      const tint = CHANNELS[(channel - 1) % CHANNELS.length];
      return { channel, names, tint, places: names.map(column), rapid: column(rapid) || [],
        coming: names.map((name) => this.coming(name)), comingRapid: this.coming(rapid) };
    },
    pointAt(index, { places } = this.trails[0]) {
      return places.map((values) => (values && index < values.length ? values[index] : 0));
    },
    // Between two rows the tool is on the line between them.
    pointOf(tick, trail = this.trails[0]) {
      const index = indexAt(run.ticks, tick);
      if (index < 0) return null;
      const from = this.pointAt(index, trail), next = index + 1;
      if (next >= run.ticks.length || run.ticks[index] === tick) return from;
      const share = (tick - run.ticks[index]) / (run.ticks[next] - run.ticks[index]), to = this.pointAt(next, trail);
      return from.map((value, axis) => value + share * (to[axis] - value));
    },
    // The position of the tool at the shown tick.
    pointNow({ names } = this.trails[0]) {
      const found = names.map((name) => (name === null ? 0 : run.now[run.names.indexOf(name)]));
      return found.every(Number.isFinite) ? found : null;
    },
    // The direction of the tool from its tip; null where it is 0 0 0, that is unknown.
    directionAt(index) {
      const found = this.directions.map((values) => (values ? values[index] : 0));
      return found.some((value) => value) ? found : null;
    },
    directionNow() {
      const found = this.direction.map((name) => run.now[run.names.indexOf(name)]);
      return this.showsTip() && found.every(Number.isFinite) && found.some((value) => value) ? found : null;
    },
    // A transformation begins or ends there: positions before and after it are not comparable.
    isOther(index) { return !this.directionAt(index - 1) !== !this.directionAt(index); },
    measure() {
      this.directions = this.showsTip() ? this.direction.map((name) => run.columns[run.names.indexOf(name)]) : [];
      this.trails = [this.trailOf(this.channel, this.shown(), this.rapid)];
      for (const other of this.others) this.trails.push(this.trailOf(other.channel, other.axes, other.rapid));
      this.bounds = [0, 1, 2].map((axis) => {
        let low = Infinity, high = -Infinity;
        for (const { places, coming } of this.trails) {
          for (const values of [places[axis] || [], coming[axis] || []]) {
            for (const value of values) { if (value < low) low = value; if (value > high) high = value; }
          }
        }
        return low <= high ? [low, high] : [0, 0];
      });
    },
    projected(point) {
      const away = [0, 1, 2].map((axis) => (point[axis] || 0) - (this.bounds[axis][0] + this.bounds[axis][1]) / 2);
      const [dx, dy, dz] = away, { camera } = this, plane = VIEWS[camera.view];
      if (plane) return [away[plane[0]], -away[plane[1]]];
      const a = Math.cos(camera.turn), b = Math.sin(camera.turn);
      const across = a * dx - b * dy, deep = b * dx + a * dy;
      return [across, -(deep * Math.cos(camera.tilt) + dz * Math.sin(camera.tilt))];
    },
    placer() {
      const width = this.$el.clientWidth, height = this.$el.clientHeight, { camera } = this;
      let wide = 0, high = 0;
      for (let corner = 0; corner < 8; corner += 1) {
        const [x, y] = this.projected(this.bounds.map((range, axis) => range[(corner >> axis) & 1]));
        wide = Math.max(wide, 2 * Math.abs(x));
        high = Math.max(high, 2 * Math.abs(y));
      }
      const fits = Math.min((width - 90) / (wide || 1), (height - 56) / (high || 1));
      const scale = camera.zoom * Math.min(fits, 40);
      return (point) => {
        const [x, y] = this.projected(point);
        return [width / 2 + camera.x + scale * x, height / 2 + camera.y + scale * y];
      };
    },

    // --- drawing -----------------------------------------------------------------------------
    draw() {
      if (!this.$el.clientHeight || !this.axes.length) return;
      const { pen, width, height } = sized(this.canvas, this.$el.clientHeight);
      this.measure();
      const place = this.placer();
      if (VIEWS[this.camera.view]) this.drawGrid(pen, place, width, height, VIEWS[this.camera.view]);
      else this.drawBox(pen, place);
      this.drawLimits(pen, place);
      for (const trail of [...this.trails].reverse()) { // the chosen channel on top
        this.drawFuture(pen, place, trail);
        this.drawKind(pen, place, trail, true);
        this.drawKind(pen, place, trail, false);
      }
      this.drawComing(pen, place);
      this.drawDirections(pen, place);
      this.drawFired(pen, place);
      const here = this.pointNow();
      const leaning = this.directionNow();
      const others = this.trails.slice(1).map((trail) => this.drawPlace(pen, place, trail));
      if (here) this.drawTool(pen, place(here), this.onScreen(leaning));
      run.drawn = { tick: run.tick, names: this.shown(), tool: here, direction: leaning, others }; // for tests
      const there = run.cursor === null ? null : this.pointOf(run.cursor);
      if (there) {
        const [x, y] = place(there);
        pen.strokeStyle = colour("--nc-ink"); pen.lineWidth = 1.6;
        pen.beginPath(); pen.arc(x, y, 6, 0, 7); pen.stroke();
      }
    },
    nameOf(axis) { return this.axes[axis].replace(/\.ACS\.ACT_POS$/, ""); },
    // A direction in the plane of the picture, as parts of its length.
    onScreen(vector) {
      if (!vector) return null;
      const middle = this.bounds.map(([low, high]) => (low + high) / 2);
      return this.projected(vector.map((part, axis) => middle[axis] + part));
    },
    // The tool at places of the path, as many as can be distinguished.
    drawDirections(pen, place) {
      if (!this.directions.length) return;
      pen.strokeStyle = TOOL; pen.globalAlpha = 0.55; pen.lineWidth = 1;
      pen.beginPath();
      let last = null;
      for (let i = 0; i < run.ticks.length; i += 1) {
        const leaning = this.directionAt(i);
        if (!leaning) continue;
        const [x, y] = place(this.pointAt(i));
        if (last && Math.hypot(x - last[0], y - last[1]) < 16) continue;
        last = [x, y];
        const [right, down] = this.onScreen(leaning);
        pen.moveTo(x, y); pen.lineTo(x + 18 * right, y + 18 * down);
      }
      pen.stroke(); pen.globalAlpha = 1;
    },
    // The columns of the future, from the first tick that has not run.
    coming(name) {
      const { future } = run, column = future ? future.names.indexOf(name) : -1;
      if (column < 0 || !future.ticks.length) return [];
      return future.columns[column].slice(indexAt(future.ticks, run.latest) + 1);
    },
    // The future without further input: dimmed, from the end of the branch.
    drawFuture(pen, place, trail) {
      if (!run.future || !run.future.ticks.length) return;
      const { coming, comingRapid: rapid } = trail, isMain = trail === this.trails[0];
      const leaning = isMain && this.showsTip() ? this.direction.map((name) => this.coming(name)) : [];
      const points = (index) => leaning.some((column) => column[index]);
      const pointAt = (index) => coming.map((column) => column[index] ?? 0);
      const last = run.ticks.length - 1;
      pen.globalAlpha = 0.38; pen.lineWidth = 1.7;
      for (const isRapid of [true, false]) {
        pen.strokeStyle = isRapid ? RAPID : trail.tint;
        pen.setLineDash(isRapid ? [5, 4] : []);
        pen.beginPath();
        let before = last >= 0 && run.ticks[last] === run.latest ? this.pointAt(last, trail) : null, isOpen = false;
        let pointed = before ? isMain && this.directionAt(last) !== null : points(0);
        for (let i = 0; i < rapid.length; i += 1) {
          const point = pointAt(i);
          if (before && rapid[i] > 0 === isRapid && points(i) === pointed) {
            if (!isOpen) pen.moveTo(...place(before));
            pen.lineTo(...place(point));
            isOpen = true;
          } else isOpen = false;
          before = point;
          pointed = points(i);
        }
        pen.stroke();
      }
      pen.setLineDash([]); pen.globalAlpha = 1;
    },
    // The reactions to come.
    drawComing(pen, place) {
      if (!run.future) return;
      const found = [];
      for (const [tick, , , line, channel] of run.future.marks) {
        const trail = this.trails.find((one) => one.channel === channel);
        const skipped = run.future.ticks.length - (trail ? trail.comingRapid.length : 0);
        const index = indexAt(run.future.ticks, tick) - skipped;
        if (!trail || tick <= run.latest || index < 0) continue;
        found.push([place(trail.coming.map((column) => column[index] ?? 0)), line]);
      }
      pen.globalAlpha = 0.38;
      this.drawDiamonds(pen, found);
      pen.globalAlpha = 1;
    },
    // The software limits of those axes that have some.
    drawLimits(pen, place) {
      const limits = [0, 1, 2].map((axis) => (this.limits || [])[axis] || [null, null]);
      const plane = VIEWS[this.camera.view], axes = (plane || [0, 1, 2]).filter((axis) => axis < this.axes.length);
      if (this.showsTip()) return; // the limits are in axis coordinates
      if (axes.some((axis) => limits[axis].includes(null))) return;
      const corner = (bits) => [0, 1, 2].map((axis) => (axes.includes(axis) ? limits[axis][(bits >> axis) & 1] : 0));
      pen.strokeStyle = LIMIT; pen.lineWidth = 1; pen.globalAlpha = 0.6; pen.setLineDash([8, 4]);
      for (let from = 0; from < 8; from += 1) {
        for (const axis of axes) {
          if (from & (1 << axis)) continue;
          pen.beginPath(); pen.moveTo(...place(corner(from))); pen.lineTo(...place(corner(from | (1 << axis)))); pen.stroke();
        }
      }
      pen.setLineDash([]); pen.globalAlpha = 1;
    },
    drawGrid(pen, place, width, height, [right, upward]) {
      const unit = [0, 0, 0];
      unit[right] = 1;
      const [x0, y0] = place([0, 0, 0]), [x1] = place(unit), scale = x1 - x0;
      pen.lineWidth = 1; pen.fillStyle = colour("--nc-soft"); pen.strokeStyle = colour("--nc-grid");
      const across = ticks(-x0 / scale, (width - x0) / scale, width / 80);
      for (const value of across.result) {
        const x = x0 + value * scale;
        pen.beginPath(); pen.moveTo(x, 0); pen.lineTo(x, height); pen.stroke();
        pen.textAlign = "center"; pen.textBaseline = "bottom";
        if (x > 40 && x < width - 24) pen.fillText(value.toFixed(across.digits), x, height - 2);
      }
      pen.fillStyle = colour("--nc-ink");
      pen.textAlign = "right"; pen.textBaseline = "bottom"; pen.fillText(`${this.nameOf(right)} mm`, width - 4, height - 2);
      if (upward >= this.axes.length) return; // one axis: a line with its scale
      pen.fillStyle = colour("--nc-soft");
      const up = ticks((y0 - height) / scale, y0 / scale, height / 45);
      for (const value of up.result) {
        const y = y0 - value * scale;
        pen.beginPath(); pen.moveTo(0, y); pen.lineTo(width, y); pen.stroke();
        pen.textAlign = "left"; pen.textBaseline = "bottom";
        if (y > 24 && y < height - 16) pen.fillText(value.toFixed(up.digits), 3, y);
      }
      pen.fillStyle = colour("--nc-ink");
      pen.textAlign = "left"; pen.textBaseline = "top"; pen.fillText(`${this.nameOf(upward)} mm`, 3, 3);
    },
    // The box around the path, with names and lengths of its edges.
    drawBox(pen, place) {
      const corner = (bits) => this.bounds.map((range, axis) => range[(bits >> axis) & 1]);
      pen.strokeStyle = colour("--nc-grid"); pen.lineWidth = 1;
      for (let from = 0; from < 8; from += 1) {
        for (let axis = 0; axis < 3; axis += 1) {
          if (from & (1 << axis)) continue;
          pen.beginPath(); pen.moveTo(...place(corner(from))); pen.lineTo(...place(corner(from | (1 << axis)))); pen.stroke();
        }
      }
      const [ox, oy] = place(corner(0));
      pen.fillStyle = colour("--nc-soft"); pen.textBaseline = "middle";
      this.axes.slice(0, 3).forEach((_, axis) => {
        const [low, high] = this.bounds[axis];
        if (high - low < 1e-6) return;
        const [x, y] = place(corner(1 << axis)), length = Math.hypot(x - ox, y - oy) || 1;
        if (length < 14) return;
        pen.textAlign = x > ox + 4 ? "left" : x < ox - 4 ? "right" : "center";
        const text = `${this.nameOf(axis)} ${Number(low.toFixed(1))} … ${Number(high.toFixed(1))}`;
        const half = pen.textAlign === "center" ? pen.measureText(text).width / 2 : 0;
        const wide = pen.measureText(text).width, width = this.$el.clientWidth;
        let left = pen.textAlign === "left" ? x + 6 : pen.textAlign === "right" ? x - 6 - wide : x - half;
        left = clamp(left, 2, width - wide - 2);
        pen.textAlign = "left";
        pen.fillText(text, left, clamp(y + 12 * Math.sign(y - oy || 1), 8, this.$el.clientHeight - 8));
      });
    },
    drawKind(pen, place, trail, isRapid) {
      const { rapid } = trail, isMain = trail === this.trails[0];
      pen.strokeStyle = isRapid ? RAPID : trail.tint; pen.lineWidth = 1.7;
      pen.setLineDash(isRapid ? [5, 4] : []);
      pen.beginPath();
      let isOpen = false;
      for (let i = 1; i < run.ticks.length; i += 1) {
        if (rapid[i] > 0 !== isRapid || (isMain && this.isOther(i))) { isOpen = false; continue; }
        if (!isOpen) pen.moveTo(...place(this.pointAt(i - 1, trail)));
        pen.lineTo(...place(this.pointAt(i, trail)));
        isOpen = true;
      }
      pen.stroke(); pen.setLineDash([]);
    },
    drawFired(pen, place) {
      const found = [];
      for (const [tick, kind, , line, channel] of run.marks) {
        const trail = kind === "fired" ? this.trails.find((one) => one.channel === channel) : null;
        const point = trail ? this.pointOf(tick, trail) : null;
        if (point) found.push([place(point), line]);
      }
      this.drawDiamonds(pen, found);
    },
    // Diamonds at the same place are drawn once, all of one size as one shape: much faster.
    drawDiamonds(pen, found) {
      const spots = new Set();
      pen.fillStyle = FIRED;
      for (const size of [4.5, 7]) {
        pen.beginPath();
        for (const [[x, y], line] of found) {
          const spot = `${Math.round(x)} ${Math.round(y)} ${size}`;
          if ((Boolean(line) && line === run.line) !== (size > 5) || spots.has(spot)) continue;
          spots.add(spot);
          pen.moveTo(x, y - size); pen.lineTo(x + size, y); pen.lineTo(x, y + size); pen.lineTo(x - size, y); pen.closePath();
        }
        pen.fill();
      }
    },
    // Draws the position of another channel, with its number; returns the place.
    drawPlace(pen, place, trail) {
      const point = this.pointNow(trail);
      if (!point) return null;
      const [x, y] = place(point);
      pen.fillStyle = trail.tint;
      pen.beginPath(); pen.arc(x, y, 4.5, 0, 7); pen.fill();
      pen.textAlign = "left"; pen.textBaseline = "bottom"; pen.fillText(String(trail.channel), x + 6, y - 2);
      return { channel: trail.channel, point };
    },
    drawTool(pen, [x, y], leaning) {
      pen.fillStyle = TOOL;
      if (leaning) {
        const [right, down] = leaning, across = [-down, right].map((part) => 5 * part / (Math.hypot(right, down) || 1));
        const at = (far, side) => [x + far * right + side * across[0], y + far * down + side * across[1]];
        pen.beginPath(); pen.moveTo(x, y); pen.lineTo(...at(11, 1)); pen.lineTo(...at(11, -1)); pen.fill();
        pen.globalAlpha = 0.75;
        pen.beginPath(); pen.moveTo(...at(11, 1)); pen.lineTo(...at(34, 1)); pen.lineTo(...at(34, -1)); pen.lineTo(...at(11, -1)); pen.fill();
        pen.globalAlpha = 1;
        pen.beginPath(); pen.arc(x, y, 2.5, 0, 7); pen.fill(); // seen from the end, the line has no length
        return;
      }
      if (VIEWS[this.camera.view]) { pen.beginPath(); pen.arc(x, y, 5.5, 0, 7); pen.fill(); return; }
      pen.beginPath(); pen.moveTo(x, y); pen.lineTo(x - 5, y - 11); pen.lineTo(x + 5, y - 11); pen.fill();
      pen.globalAlpha = 0.75; pen.fillRect(x - 5, y - 24, 10, 13); pen.globalAlpha = 1;
    },
  },
};

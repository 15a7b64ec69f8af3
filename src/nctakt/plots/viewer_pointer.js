// SPDX-License-Identifier: MIT
// Effects of pointer, wheel and keys; tooltips.
// --- pointer and keys ------------------------------------------------------------------------
const showTip = (event, text) => {
  tip.style.display = text ? "block" : "none";
  if (!text) return;
  tip.textContent = text;
  const box = tip.getBoundingClientRect();
  tip.style.left = `${clamp(event.clientX + 14, 4, innerWidth - box.width - 8)}px`;
  tip.style.top = `${clamp(event.clientY + 16, 4, innerHeight - box.height - 8)}px`;
};
const barText = (lane, [begin, end, name, details], isCondition) => {
  const when = end > begin ? `${words.from} ${seconds(begin)} ${words.for} ${seconds(end - begin)}` : `${words.at} ${seconds(begin)}`;
  const head = lane.text || run.texts[name];
  return [`${lane.label}${isCondition ? ` · ${words.condition}` : ""}  ${head}`, run.texts[details], when].filter(Boolean).join("\n");
};
const tipAt = (x, y) => {
  const lane = run.lanes[Math.floor((y - lanesTop) / LANE)];
  if (!lane || y < lanesTop || x < LEFT || x > LEFT + inner()) return lane && y >= lanesTop && lane.text ? lane.text : "";
  const near = ([begin, end]) => x >= xOf(begin) - 3 && x <= Math.max(xOf(end), xOf(begin) + 2) + 3;
  const bar = lane.bars.find(near);
  if (bar) return barText(lane, bar, false);
  const truth = lane.background.find(near);
  return truth ? barText(lane, truth, true) : "";
};
timeCanvas.addEventListener("pointermove", (event) => {
  const x = event.offsetX;
  if (drag) {
    drag.now = x;
    if (drag.kind === "move") show(drag.from - (x - drag.x) / drag.scale, drag.to - (x - drag.x) / drag.scale);
  } else showTip(event, tipAt(x, event.offsetY));
  if (!isHeld) cursor = snapped(timeOf(x));
  draw();
});
timeCanvas.addEventListener("pointerdown", (event) => {
  timeCanvas.setPointerCapture(event.pointerId);
  const kind = event.shiftKey || event.button === 1 ? "move" : "range";
  drag = { kind, x: event.offsetX, now: event.offsetX, from, to, scale: inner() / (to - from) };
  showTip(event, "");
});
timeCanvas.addEventListener("pointerup", (event) => {
  const done = drag;
  drag = null;
  if (!done) return;
  if (done.kind === "range" && Math.abs(done.now - done.x) > 5) {
    const [begin, end] = [done.x, done.now].map(timeOf).sort((a, b) => a - b);
    show(begin, end);
  } else if (done.kind === "range") {
    isHeld = !isHeld;
    cursor = snapped(timeOf(event.offsetX));
  }
  draw();
});
timeCanvas.addEventListener("pointerleave", (event) => {
  showTip(event, "");
  if (!isHeld && !drag) { cursor = null; draw(); }
});
timeCanvas.addEventListener("dblclick", () => { isHeld = false; wholeRun(); });
timeCanvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
    const way = ((event.deltaX || event.deltaY) / inner()) * (to - from);
    show(from + way, to + way);
  } else zoom(timeOf(event.offsetX), Math.exp(clamp(event.deltaY, -200, 200) * 0.002));
}, { passive: false });
timePart.addEventListener("keydown", (event) => {
  const step = (event.shiftKey ? 10 : 1) * run.tick, at = cursor === null ? run.begin : cursor;
  const moved = { ArrowLeft: at - step, ArrowRight: at + step }[event.key];
  if (moved !== undefined) {
    cursor = snapped(moved);
    isHeld = true;
    if (cursor < from || cursor > to) show(cursor - (to - from) / 2, cursor + (to - from) / 2);
  } else if (event.key === "+") zoom(at, 0.7);
  else if (event.key === "-") zoom(at, 1 / 0.7);
  else if (event.key === "0" || event.key === "Home") wholeRun();
  else if (event.key === "Escape") { isHeld = false; cursor = null; } else return;
  event.preventDefault();
  draw();
});
if (run.path) {
  const keys = make("div", pathPart, { className: "keys" });
  make("i", keys).style.color = "#3b82c4"; keys.append(words.feed);
  make("i", keys, { className: "rapid" }).style.color = "#9aa1ab"; keys.append(words.rapid);
  make("span", keys, { textContent: `${run.path.axes.join(" / ")} · mm` });
  if (width3 > 2) {
    const button = make("button", pathPart, { className: "switch", textContent: words.space });
    button.onclick = () => {
      camera.isSpace = !camera.isSpace;
      button.textContent = camera.isSpace ? words.plane : words.space;
      draw();
    };
  }
  let grip = null;
  pathCanvas.addEventListener("pointerdown", (event) => {
    pathCanvas.setPointerCapture(event.pointerId);
    grip = { x: event.offsetX, y: event.offsetY, ...camera, start: { ...camera } };
  });
  pathCanvas.addEventListener("pointerup", () => { grip = null; });
  pathCanvas.addEventListener("pointerleave", (event) => showTip(event, ""));
  pathCanvas.addEventListener("dblclick", () => { Object.assign(camera, { zoom: 1, x: 0, y: 0 }); draw(); });
  pathCanvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const factor = Math.exp(-clamp(event.deltaY, -200, 200) * 0.002), width = pathCanvas.clientWidth;
    const dx = event.offsetX - width / 2 - camera.x, dy = event.offsetY - PATH / 2 - camera.y;
    camera.zoom = clamp(camera.zoom * factor, 0.2, 500);
    camera.x += dx * (1 - factor); camera.y += dy * (1 - factor);
    draw();
  }, { passive: false });
  pathCanvas.addEventListener("pointermove", (event) => {
    const { offsetX, offsetY } = event, place = placer(pathCanvas.clientWidth);
    if (grip) {
      const dx = offsetX - grip.x, dy = offsetY - grip.y;
      if (camera.isSpace && !event.shiftKey) {
        camera.turn = grip.start.turn + dx * 0.008;
        camera.tilt = clamp(grip.start.tilt + dy * 0.008, 0, Math.PI / 2);
      } else { camera.x = grip.start.x + dx; camera.y = grip.start.y + dy; }
      draw();
      return;
    }
    const mark = run.path.marks.find(([, , ...point]) => {
      const [x, y] = place(point);
      return Math.hypot(x - offsetX, y - offsetY) < 10;
    });
    const lane = mark && run.lanes.find((item) => item.number === mark[0]);
    showTip(event, lane ? `(${mark[0]}) ${lane.label}  ${lane.text}\n${words.at} ${seconds(mark[1])}` : "");
    if (isHeld) return;
    let best = 15, found = null;
    const { positions, begin, every } = run.path, count = positions.length / width3;
    const stride = Math.max(1, Math.floor(count / 20000));
    for (let i = 0; i < count; i += stride) {
      const [x, y] = place(Array.from(positions.subarray(i * width3, (i + 1) * width3)));
      const distance = Math.hypot(x - offsetX, y - offsetY);
      if (distance < best) { best = distance; found = begin + i * every; }
    }
    cursor = found;
    draw();
  });
}

new ResizeObserver(draw).observe(view);
setTheme(dark.matches);

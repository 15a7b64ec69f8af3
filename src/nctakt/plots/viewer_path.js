// SPDX-License-Identifier: MIT
// The path of the tool in the plane or in space, with the place of the cursor.
// --- path ------------------------------------------------------------------------------------
const PATH = 380;
const camera = { zoom: 1, x: 0, y: 0, turn: -0.6, tilt: 0.95, isSpace: false };
const width3 = run.path ? run.path.axes.length : 0;
const bounds = run.path && [0, 1, 2].map((axis) => {
  let low = Infinity, high = -Infinity;
  for (let i = axis; axis < width3 && i < run.path.points.length; i += width3) {
    low = Math.min(low, run.path.points[i]); high = Math.max(high, run.path.points[i]);
  }
  return axis < width3 ? [low, high] : [0, 0];
});
const projected = (x, y, z) => {
  const [dx, dy, dz] = [x, y, z].map((value, axis) => value - (bounds[axis][0] + bounds[axis][1]) / 2);
  if (!camera.isSpace) return [dx, -dy];
  const a = Math.cos(camera.turn), b = Math.sin(camera.turn);
  const across = a * dx - b * dy, deep = b * dx + a * dy;
  return [across, -(deep * Math.cos(camera.tilt) + dz * Math.sin(camera.tilt))];
};
const placer = (width) => {
  let wide = 0, high = 0;
  for (let corner = 0; corner < 8; corner += 1) {
    const [x, y] = projected(...bounds.map((range, axis) => range[(corner >> axis) & 1]));
    wide = Math.max(wide, 2 * Math.abs(x));
    high = Math.max(high, 2 * Math.abs(y));
  }
  const scale = camera.zoom * Math.min((width - 120) / (wide || 1), (PATH - 90) / (high || 1));
  return (point) => {
    const [x, y] = projected(point[0], point[1], point[2] || 0);
    return [width / 2 + camera.x + scale * x, PATH / 2 + camera.y + scale * y];
  };
};
const positionAt = (time) => {
  const { positions, begin, every } = run.path, last = positions.length / width3 - 1;
  const place = clamp((time - begin) / every, 0, last), low = Math.floor(place), part = place - low;
  const high = Math.min(low + 1, last);
  return Array.from({ length: width3 }, (_, axis) =>
    (1 - part) * positions[low * width3 + axis] + part * positions[high * width3 + axis]);
};
const pointAt = (index) => Array.from(run.path.points.subarray(index * width3, (index + 1) * width3));

const drawPath = () => {
  if (!run.path) return;
  const { pen, width } = sized(pathCanvas, PATH), place = placer(width), { rapid, points } = run.path;
  const drawGrid = () => {
    const [left, top] = place([bounds[0][0], bounds[1][1], 0]), [right, low] = place([bounds[0][1], bounds[1][0], 0]);
    const perPixel = (bounds[0][1] - bounds[0][0] || 1) / (right - left || 1);
    const horizontal = ticks(bounds[0][0] - left * perPixel, bounds[0][0] + (width - left) * perPixel, width / 90);
    const per = (bounds[1][1] - bounds[1][0]) / (low - top) || perPixel;
    const vertical = ticks(bounds[1][1] - (PATH - top) * per, bounds[1][1] + top * per, 6);
    pen.strokeStyle = colour("--grid"); pen.fillStyle = colour("--faint"); pen.lineWidth = 1;
    for (const value of horizontal.result) {
      const [x] = place([value, 0, 0]);
      pen.beginPath(); pen.moveTo(x, 0); pen.lineTo(x, PATH); pen.stroke();
      pen.textAlign = "center"; pen.fillText(value.toFixed(horizontal.digits), x, PATH - 30);
    }
    for (const value of vertical.result) {
      const [, y] = place([0, value, 0]);
      pen.beginPath(); pen.moveTo(0, y); pen.lineTo(width, y); pen.stroke();
      pen.textAlign = "left"; pen.fillText(value.toFixed(vertical.digits), 10, y - 3);
    }
  };
  if (!camera.isSpace) drawGrid();
  const drawKind = (isRapid, tint, dash) => {
    pen.strokeStyle = tint; pen.setLineDash(dash); pen.lineWidth = 1.6; pen.beginPath();
    let isOpen = false;
    for (let i = 1; i * width3 < points.length; i += 1) {
      if (Boolean(rapid[i]) !== isRapid) { isOpen = false; continue; }
      if (!isOpen) pen.moveTo(...place(pointAt(i - 1)));
      pen.lineTo(...place(pointAt(i)));
      isOpen = true;
    }
    pen.stroke(); pen.setLineDash([]);
  };
  drawKind(true, "#9aa1ab", [6, 4]);
  drawKind(false, "#3b82c4", []);
  const sign = (point, tint, text) => {
    const [x, y] = place(point);
    pen.fillStyle = tint; pen.beginPath(); pen.arc(x, y, 5, 0, 7); pen.fill();
    pen.textAlign = "left"; pen.fillText(text, x + 8, y - 8);
  };
  pen.textBaseline = "alphabetic";
  sign(pointAt(0), "#15803d", words.start);
  sign(pointAt(points.length / width3 - 1), "#dc2626", words.end);
  pen.textAlign = "center"; pen.textBaseline = "middle"; pen.font = "bold 10px system-ui, sans-serif";
  const taken = new Map();
  for (const [number, , ...point] of run.path.marks) {
    const [x, y] = place(point), cell = `${Math.round(x / 16)},${Math.round(y / 16)}`;
    const there = taken.get(cell) || { x, y, numbers: [] };
    if (!there.numbers.includes(number)) there.numbers.push(number);
    taken.set(cell, there);
  }
  for (const { x, y, numbers } of taken.values()) {
    const text = numbers.join(", "), wide = Math.max(16, pen.measureText(text).width + 9);
    pen.fillStyle = "#e8833a"; pen.beginPath(); pen.roundRect(x - wide / 2, y - 8, wide, 16, 8); pen.fill();
    pen.fillStyle = "#ffffff"; pen.fillText(text, x, y + 0.5);
  }
  if (cursor !== null) {
    const [x, y] = place(positionAt(cursor));
    pen.strokeStyle = colour("--cursor"); pen.lineWidth = 2;
    pen.beginPath(); pen.arc(x, y, 7, 0, 7); pen.stroke();
  }
};

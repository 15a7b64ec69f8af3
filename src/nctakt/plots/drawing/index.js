// SPDX-License-Identifier: MIT
// Helpers for drawing on a canvas, for pictures of runs (page.py) and the live page.
export const make = (tag, parent, properties = {}) => {
  const element = Object.assign(document.createElement(tag), properties);
  parent.append(element);
  return element;
};
const colours = new Map(); // for the current drawing, since looking one up is slow
export const colour = (name) => {
  if (!colours.has(name)) colours.set(name, getComputedStyle(document.body).getPropertyValue(name).trim());
  return colours.get(name);
};
export const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
export const short = (value) => {
  if (Number.isInteger(value)) return String(value);
  return String(Number(value.toPrecision(6)));
};
export const seconds = (time) => `${Number(time.toFixed(6))} s`;
export const ticks = (low, high, count) => {
  const rough = (high - low) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= rough);
  const result = [];
  for (let n = Math.ceil(low / step); n * step <= high; n += 1) result.push(n * step);
  return { result, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
};
export const cut = (pen, text, width) => {
  if (pen.measureText(text).width <= width) return text;
  let end = text.length;
  while (end > 1 && pen.measureText(`${text.slice(0, end)}…`).width > width) end -= 1;
  return `${text.slice(0, end)}…`;
};
export const sized = (canvas, height) => {
  colours.clear();
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

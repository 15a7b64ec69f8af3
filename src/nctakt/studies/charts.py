# SPDX-License-Identifier: MIT
"""Charts of a study as SVG: histogram, scatter, heat map, strip, bars of sensitivities.

In: numbers. Out: the text of an SVG element, with axes, ticks and their numbers; no script.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

from nctakt.base.dataclass import dataclass

WIDTH, HEIGHT = 420, 260
_LEFT, _RIGHT, _TOP, _BOTTOM = 62, 14, 14, 44

#: Colours of runs that held and of all others.
HELD_COLOUR, BROKEN_COLOUR = "#2f6f9f", "#c0392b"

#: Bars of a histogram, cells of a heat map along each side.
BARS, CELLS = 24, 24

#: Maximum number of points in a scatter; if there are more, an even selection.
MAX_POINTS = 3000


@dataclass(frozen=True, slots=True)
class Axis:
    """A range of values on one side of a chart."""

    low: float
    high: float
    name: str

    def share(self, value: float) -> float:
        """Return where a value lies, 0 … 1."""
        return (value - self.low) / (self.high - self.low)

    def ticks(self) -> list[float]:
        """Return round numbers in the range, about five."""
        raw = (self.high - self.low) / 5
        unit = 10.0 ** math.floor(math.log10(raw))
        step = next(unit * factor for factor in (1, 2, 5, 10) if unit * factor >= raw * 0.999)
        first = math.ceil(self.low / step - 1e-9)
        last = math.floor(self.high / step + 1e-9)
        return [number * step for number in range(first, last + 1)]


def axis_of(values: Sequence[float], name: str) -> Axis:
    """Return the axis that shows all values; a single value lies in its middle."""
    low, high = min(values), max(values)
    if low == high:
        margin = abs(low) / 10 or 1.0
        return Axis(low - margin, high + margin, name)
    return Axis(low, high, name)


def histogram(values: Sequence[float], name: str, unit: str, limits: Sequence[float] = ()) -> str:
    """Return how often a measure has which value; ``unit``: the name of the counted items.

    ``limits``: values of expectations, as lines; the axis reaches to them.
    """
    across = axis_of([*values, *limits], name)
    counts = [0] * BARS
    for value in values:
        counts[min(int(across.share(value) * BARS), BARS - 1)] += 1
    up = Axis(0, max(counts), unit)
    bars = []
    for number, count in enumerate(counts):
        left, right = _x_at(number / BARS), _x_at((number + 1) / BARS)
        top = _y_at(up.share(count))
        low = across.low + (across.high - across.low) * number / BARS
        bars.append(
            f'<rect x="{left:.1f}" y="{top:.1f}" width="{right - left - 1:.1f}" '
            f'height="{_y_at(0) - top:.1f}" fill="{HELD_COLOUR}">'
            f"<title>{_number(low)} …: {count}</title></rect>"
        )
    for limit in limits:
        x = _x_at(across.share(limit))
        bars.append(
            f'<line x1="{x:.1f}" y1="{_TOP}" x2="{x:.1f}" y2="{_y_at(0)}" '
            f'stroke="{BROKEN_COLOUR}" stroke-dasharray="5 3">'
            f"<title>{_number(limit)}</title></line>"
        )
    return _chart(across, up, "".join(bars))


def verdict_map(
    x: Sequence[float], y: Sequence[float], held: Sequence[bool], names: tuple[str, str]
) -> str:
    """Return a map of passed and failed runs over two inputs, from one colour to the other."""
    across, up = axis_of(x, names[0]), axis_of(y, names[1])
    columns, rows = (min(CELLS, len(dict.fromkeys(own))) for own in (x, y))
    counts: dict[tuple[int, int], list[int]] = {}
    for left, bottom, is_held in zip(x, y, held, strict=True):
        column = min(int(across.share(left) * columns), columns - 1)
        row = min(int(up.share(bottom) * rows), rows - 1)
        cell = counts.setdefault((column, row), [0, 0])
        cell[0] += is_held
        cell[1] += 1
    cells = []
    for (column, row), (passed, total) in counts.items():
        left, right = _x_at(column / columns), _x_at((column + 1) / columns)
        top, bottom = _y_at((row + 1) / rows), _y_at(row / rows)
        box = (
            f'x="{left:.1f}" y="{top:.1f}" width="{right - left + 0.3:.1f}" '
            f'height="{bottom - top + 0.3:.1f}"'
        )
        failed = (total - passed) / total
        cells.append(
            f'<rect {box} fill="{HELD_COLOUR}"/>'
            f'<rect {box} fill="{BROKEN_COLOUR}" fill-opacity="{failed:.3f}">'
            f"<title>{passed} / {total}</title></rect>"
        )
    return _chart(across, up, "".join(cells))


def scatter(
    x: Sequence[float], y: Sequence[float], held: Sequence[bool], names: tuple[str, str]
) -> str:
    """Return a point for each run, coloured by its verdict."""
    across, up = axis_of(x, names[0]), axis_of(y, names[1])
    step = max(1, len(x) // MAX_POINTS)
    points = "".join(
        f'<circle cx="{_x_at(across.share(x[i])):.1f}" cy="{_y_at(up.share(y[i])):.1f}" r="2.2" '
        f'fill="{HELD_COLOUR if held[i] else BROKEN_COLOUR}" fill-opacity="0.6"/>'
        for i in range(0, len(x), step)
    )
    return _chart(across, up, points)


def heat_map(
    x: Sequence[float], y: Sequence[float], values: Sequence[float], names: tuple[str, str, str]
) -> str:
    """Return the mean of a measure over two inputs, from light to dark."""
    across, up = axis_of(x, names[0]), axis_of(y, names[1])
    columns, rows = (min(CELLS, len(dict.fromkeys(own))) for own in (x, y))
    sums: dict[tuple[int, int], list[float]] = {}
    for left, bottom, value in zip(x, y, values, strict=True):
        column = min(int(across.share(left) * columns), columns - 1)
        row = min(int(up.share(bottom) * rows), rows - 1)
        sums.setdefault((column, row), []).append(value)
    means = {cell: sum(own) / len(own) for cell, own in sums.items()}
    shade = axis_of(list(means.values()), names[2])
    cells = []
    for (column, row), mean in means.items():
        left, right = _x_at(column / columns), _x_at((column + 1) / columns)
        top, bottom = _y_at((row + 1) / rows), _y_at(row / rows)
        light = 94 - 64 * shade.share(mean)
        cells.append(
            f'<rect x="{left:.1f}" y="{top:.1f}" width="{right - left + 0.3:.1f}" '
            f'height="{bottom - top + 0.3:.1f}" fill="hsl(205 55% {light:.0f}%)">'
            f"<title>{escape(names[2])}: {_number(mean)}</title></rect>"
        )
    caption = f"{names[2]}: {_number(min(means.values()))} … {_number(max(means.values()))}"
    return _chart(across, up, "".join(cells), caption)


def strip(
    times: Sequence[float],
    held: Sequence[bool],
    name: str,
    blocks: Sequence[tuple[float, str]] = (),
) -> str:
    """Return a bar over time that is red where an injection did not hold.

    ``blocks``: the begin of each block of the program, and its line.
    """
    across = axis_of(times, name)
    width = max((_x_at(1) - _x_at(0)) / len(times), 0.6)
    marks = "".join(
        f'<rect x="{_x_at(across.share(time)) - width / 2:.2f}" y="20" width="{width:.2f}" '
        f'height="40" fill="{HELD_COLOUR if good else BROKEN_COLOUR}"/>'
        for time, good in zip(times, held, strict=True)
    )
    return _svg(110, marks + _block_marks(across, blocks) + _across(across, 66))


def _block_marks(across: Axis, blocks: Sequence[tuple[float, str]]) -> str:
    """Return a mark for each block that begins in the range, and its line where there is room."""
    parts = []
    right = 0.0
    for time, label in blocks:
        if across.low <= time <= across.high:
            x = _x_at(across.share(time))
            parts.append(f'<line x1="{x:.2f}" y1="14" x2="{x:.2f}" y2="20" stroke="#555"/>')
            width = 7.0 * len(label)
            if x - width / 2 > right:
                parts.append(f'<text x="{x:.2f}" y="11" text-anchor="middle">{label}</text>')
                right = x + width / 2 + 2
    return "".join(parts)


def bars(shares: Sequence[tuple[str, float]], name: str) -> str:
    """Return horizontal bars, the longest on top: a tornado of sensitivities, 0 … 1."""
    ordered = sorted(shares, key=lambda item: -abs(item[1]))
    parts = []
    for number, (label, share) in enumerate(ordered):
        top = 12 + 26 * number
        length = abs(share) * (WIDTH - 220)
        parts.append(
            f'<text x="130" y="{top + 14}" text-anchor="end">{escape(label)}</text>'
            f'<rect x="138" y="{top}" width="{length:.1f}" height="18" fill="{HELD_COLOUR}"/>'
            f'<text x="{144 + length:.1f}" y="{top + 14}">{share:.2f}</text>'
        )
    height = 12 + 26 * len(ordered) + 22
    parts.append(f'<text x="138" y="{height - 6}">{escape(name)}</text>')
    return _svg(height, "".join(parts))


def _x_at(share: float) -> float:
    return _LEFT + share * (WIDTH - _LEFT - _RIGHT)


def _y_at(share: float) -> float:
    return HEIGHT - _BOTTOM - share * (HEIGHT - _TOP - _BOTTOM)


def _chart(across: Axis, up: Axis, body: str, caption: str = "") -> str:
    """Return a chart with its axes around a body."""
    parts = [body, _across(across, _y_at(0))]
    for value in up.ticks():
        y = _y_at(up.share(value))
        parts.append(
            f'<line x1="{_LEFT - 4}" y1="{y:.1f}" x2="{_LEFT}" y2="{y:.1f}" stroke="#555"/>'
            f'<text x="{_LEFT - 7}" y="{y + 4:.1f}" text-anchor="end">{_number(value)}</text>'
        )
    parts.append(
        f'<line x1="{_LEFT}" y1="{_TOP}" x2="{_LEFT}" y2="{_y_at(0)}" stroke="#555"/>'
        f'<text transform="translate(13 {HEIGHT / 2 - 10}) rotate(-90)" '
        f'text-anchor="middle">{escape(up.name)}</text>'
    )
    if caption:
        parts.append(
            f'<text x="{WIDTH - _RIGHT}" y="11" text-anchor="end">{escape(caption)}</text>'
        )
    return _svg(HEIGHT, "".join(parts))


def _across(axis: Axis, y: float) -> str:
    """Return the horizontal axis at a height."""
    parts = [f'<line x1="{_LEFT}" y1="{y}" x2="{WIDTH - _RIGHT}" y2="{y}" stroke="#555"/>']
    for value in axis.ticks():
        x = _x_at(axis.share(value))
        parts.append(
            f'<line x1="{x:.1f}" y1="{y}" x2="{x:.1f}" y2="{y + 4}" stroke="#555"/>'
            f'<text x="{x:.1f}" y="{y + 17}" text-anchor="middle">{_number(value)}</text>'
        )
    middle = (_LEFT + WIDTH - _RIGHT) / 2
    parts.append(f'<text x="{middle}" y="{y + 36}" text-anchor="middle">{escape(axis.name)}</text>')
    return "".join(parts)


def _svg(height: float, body: str) -> str:
    return (
        f'<svg viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" role="img">'
        f"{body}</svg>"
    )


def _number(value: float) -> str:
    return f"{value:.6g}"

# SPDX-License-Identifier: MIT
"""A picture as a list of simple shapes, and its text as SVG.

Coordinates in pixels from the upper left corner. The same shapes are drawn by ``png``.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from html import escape
from typing import Literal

from nctakt.base.dataclass import dataclass

#: The distance of the lines of a hatched box.
_HATCH = 6.0
FONT = "DejaVu Sans, Verdana, sans-serif"


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle; ``hatched``: with slanting lines of the colour ``fill``. ``tip`` explains it."""

    x: float
    y: float
    width: float
    height: float
    fill: str
    hatched: bool = False
    tip: str = ""


@dataclass(frozen=True, slots=True)
class Stroke:
    """A polyline; ``arrows`` at its last end, or at both."""

    points: tuple[tuple[float, float], ...]
    colour: str
    width: float = 1.0
    dashed: bool = False
    arrows: Literal["none", "end", "both"] = "none"
    tip: str = ""


@dataclass(frozen=True, slots=True)
class Label:
    """A text; ``anchor`` says which part of it is at ``x``."""

    x: float
    y: float
    text: str
    size: float = 11.0
    anchor: Literal["start", "middle", "end"] = "start"
    colour: str = "#222222"
    bold: bool = False


Shape = Box | Stroke | Label


#: The width of characters in parts of the font's size, for DejaVu Sans; others are the mean.
_NARROW, _WIDE = " .,:;'|!ijl()[]·", "mwMWNOQCDGH%@—…→≤"
_NARROW_PART, _MEAN_PART, _WIDE_PART, _BOLD = 0.4, 0.66, 1.0, 1.1


def text_width(label: Label) -> float:
    """Return the width of a label in pixels, rather too much than too little."""
    parts = (
        _NARROW_PART if character in _NARROW else _WIDE_PART if character in _WIDE else _MEAN_PART
        for character in label.text
    )
    return sum(parts) * label.size * (_BOLD if label.bold else 1.0)


def label_left(label: Label) -> float:
    """Return the left end of a label in pixels."""
    part = {"start": 0.0, "middle": 0.5, "end": 1.0}[label.anchor]
    return label.x - part * text_width(label)


def fitting(label: Label, width: float) -> Label:
    """Return the label, its text cut to ``width`` pixels."""
    text = label.text
    while text and text_width(label) > width:
        text = text[:-1]
        label = replace(label, text=f"{text.rstrip()}…")
    return label


@dataclass(frozen=True, slots=True)
class Figure:
    """A picture; later shapes lie over earlier ones."""

    width: int
    height: int
    shapes: tuple[Shape, ...]


def svg(figure: Figure) -> str:
    """Return the picture as the text of an SVG file."""
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{figure.width}" '
        f'height="{figure.height}" viewBox="0 0 {figure.width} {figure.height}" '
        f'font-family="{FONT}">',
        f'<rect width="{figure.width}" height="{figure.height}" fill="#ffffff"/>',
    ]
    for shape in figure.shapes:
        if isinstance(shape, Box):
            lines.append(_box(shape))
        elif isinstance(shape, Stroke):
            lines += _stroke(shape)
        else:
            lines.append(_label(shape))
    return "\n".join([*lines, "</svg>", ""])


def _number(value: float) -> str:
    return f"{value:.2f}".rstrip("0").rstrip(".")


def _tip(text: str) -> str:
    return f"<title>{escape(text)}</title>" if text else ""


def _box(box: Box) -> str:
    fill = "#ffffff" if box.hatched else box.fill
    x, y, width, height = (_number(number) for number in (box.x, box.y, box.width, box.height))
    attributes = f'x="{x}" y="{y}" width="{width}" height="{height}"'
    rectangle = f'<rect {attributes} fill="{fill}">{_tip(box.tip)}</rect>'
    return rectangle + (_hatching(box) if box.hatched else "")


def _hatching(box: Box) -> str:
    """Slanting lines; drawn one by one, since not every viewer knows patterns."""
    bottom = box.y + box.height
    moves = []
    start = box.x - box.height + _HATCH
    while start < box.x + box.width:
        left, right = max(start, box.x), min(start + box.height, box.x + box.width)
        if right > left:
            low, high = bottom - (left - start), bottom - (right - start)
            moves.append(f"M{_number(left)},{_number(low)}L{_number(right)},{_number(high)}")
        start += _HATCH
    return f'<path d="{"".join(moves)}" stroke="{box.fill}" stroke-width="1.4" fill="none"/>'


def _stroke(stroke: Stroke) -> Iterator[str]:
    points = " ".join(f"{_number(x)},{_number(y)}" for x, y in stroke.points)
    dashes = ' stroke-dasharray="4 3"' if stroke.dashed else ""
    yield (
        f'<polyline points="{points}" fill="none" stroke="{stroke.colour}" '
        f'stroke-width="{_number(stroke.width)}"{dashes}>{_tip(stroke.tip)}</polyline>'
    )
    for head in arrow_heads(stroke):
        corners = " ".join(f"{_number(x)},{_number(y)}" for x, y in head)
        yield f'<polygon points="{corners}" fill="{stroke.colour}"/>'


def arrow_heads(stroke: Stroke) -> Iterator[list[tuple[float, float]]]:
    """Yield the triangles at the ends of a stroke with arrows, as points in pixels."""
    ends = []
    if stroke.arrows in ("end", "both"):
        ends.append((stroke.points[-2], stroke.points[-1]))
    if stroke.arrows == "both":
        ends.append((stroke.points[1], stroke.points[0]))
    for (from_x, from_y), (x, y) in ends:
        length = ((x - from_x) ** 2 + (y - from_y) ** 2) ** 0.5 or 1.0
        dx, dy = (x - from_x) / length, (y - from_y) / length
        back_x, back_y = x - 6 * dx, y - 6 * dy
        yield [
            (x, y),
            (back_x - 2.5 * dy, back_y + 2.5 * dx),
            (back_x + 2.5 * dy, back_y - 2.5 * dx),
        ]


def _label(label: Label) -> str:
    weight = ' font-weight="bold"' if label.bold else ""
    return (
        f'<text x="{_number(label.x)}" y="{_number(label.y)}" font-size="{_number(label.size)}" '
        f'text-anchor="{label.anchor}" fill="{label.colour}"{weight}>{escape(label.text)}</text>'
    )

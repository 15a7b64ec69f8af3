# SPDX-License-Identifier: MIT
"""A picture as PNG, drawn by matplotlib (extra ``plot``).

In: ``Figure``. Out: the file. No window is opened and no state of matplotlib is changed.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure as Sheet
from matplotlib.patches import Polygon, Rectangle

from nctakt.schedule.pictures.figure import Box, Figure, Label, Stroke, arrow_heads

_DPI = 144
#: matplotlib counts widths and sizes in points of a 72nd inch, pixels here are of a 96th.
_POINTS = 0.75
_ALIGN = {"start": "left", "middle": "center", "end": "right"}


def write_png(figure: Figure, path: Path) -> None:
    """Write the picture."""
    sheet = Sheet(figsize=(figure.width / 96, figure.height / 96), dpi=_DPI)
    FigureCanvasAgg(sheet)
    axes = sheet.add_axes((0, 0, 1, 1))
    axes.set_xlim(0, figure.width)
    axes.set_ylim(figure.height, 0)
    axes.axis("off")
    for layer, shape in enumerate(figure.shapes):
        if isinstance(shape, Box):
            axes.add_patch(_rectangle(shape, layer))
        elif isinstance(shape, Stroke):
            axes.plot(
                [x for x, _ in shape.points],
                [y for _, y in shape.points],
                color=shape.colour,
                linewidth=shape.width * _POINTS,
                linestyle=(0, (4, 3)) if shape.dashed else "-",
                zorder=layer,
            )
            for head in arrow_heads(shape):
                axes.add_patch(Polygon(head, color=shape.colour, zorder=layer))
        else:
            _write(axes, shape, layer)
    sheet.savefig(path, format="png", dpi=_DPI, metadata={"Software": None})


def _rectangle(box: Box, layer: int) -> Rectangle:
    return Rectangle(
        (box.x, box.y),
        box.width,
        box.height,
        linewidth=0,
        facecolor="#ffffff" if box.hatched else box.fill,
        edgecolor=box.fill,
        hatch="////" if box.hatched else None,
        zorder=layer,
    )


def _write(axes: Any, label: Label, layer: int) -> None:
    axes.text(
        label.x,
        label.y,
        label.text,
        fontsize=label.size * _POINTS,
        ha=_ALIGN[label.anchor],
        va="baseline",
        color=label.colour,
        fontweight="bold" if label.bold else "normal",
        zorder=layer,
        parse_math=False,
    )

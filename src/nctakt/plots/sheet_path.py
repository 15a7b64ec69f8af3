# SPDX-License-Identifier: MIT
"""The path of a scene on a sheet of matplotlib: in the plane and in space.

In: axes of matplotlib, ``ToolPath``. Out: feed as a line, rapid motion dashed, start and end named,
numbered marks where reactions fired.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy

from nctakt.base.diagnostics import Language, Text
from nctakt.plots.style import END, FEED, GRID, INK, LANE_COLOURS, RAPID, START
from nctakt.plots.tool_path import ToolPath

_PLANE = Text("path in the plane", "Bahn in der Ebene")
_SPACE = Text("path in space", "Bahn im Raum")
_FEED = Text("feed", "Vorschub")
_RAPID = Text("rapid", "Eilgang")
_START = Text("start", "Start")
_END = Text("end", "Ende")

#: Marks nearer than this part of the picture share one sign.
_NEAR = 0.025


def draw_plane(axes: Any, path: ToolPath, language: Language) -> None:
    """Draw the first two axes."""
    first, second = path.points[:, 0], path.points[:, 1]
    _draw_stretches(axes, path, 2, language)
    for index, text, colour, sign in ((0, _START, START, "o"), (-1, _END, END, "s")):
        point = (first[index], second[index])
        axes.plot(*point, sign, color=colour, markersize=6, zorder=4)
        axes.annotate(
            text.get(language),
            point,
            xytext=(7, 7 if index == 0 else -11),
            textcoords="offset points",
            fontsize=7,
            color=colour,
            zorder=6,
        )
    for point, numbers in _clusters(path):
        draw_numbers(axes, point, numbers)
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.08)
    axes.set_xlabel(f"{path.axes[0]} / mm", fontsize=8)
    axes.set_ylabel(f"{path.axes[1]} / mm", fontsize=8)
    axes.set_title(_PLANE.get(language), fontsize=9, color=INK)
    axes.tick_params(labelsize=7)
    axes.grid(linewidth=0.4, color=GRID)
    axes.set_axisbelow(True)
    axes.legend(fontsize=7, frameon=False, loc="best")


def draw_numbers(axes: Any, point: tuple[float, float], numbers: Sequence[int]) -> None:
    """Draw the sign with the numbers of reactions that fired at a place."""
    axes.annotate(
        ", ".join(map(str, numbers)),
        point,
        fontsize=6.5,
        ha="center",
        va="center",
        color="white",
        fontweight="bold",
        zorder=5,
        bbox={
            "boxstyle": "round,pad=0.25,rounding_size=0.8",
            "facecolor": LANE_COLOURS["reaction"],
            "edgecolor": "white",
            "linewidth": 0.8,
        },
    )


def draw_space(axes: Any, path: ToolPath, language: Language) -> None:
    """Draw three axes."""
    _draw_stretches(axes, path, 3, language)
    axes.plot(*path.points[0].tolist(), "o", color=START, markersize=5)
    axes.plot(*path.points[-1].tolist(), "s", color=END, markersize=5)
    for mark in path.marks:
        axes.plot(*mark.point, "o", color=LANE_COLOURS["reaction"], markersize=3.5)
    for name, label in zip(
        path.axes, (axes.set_xlabel, axes.set_ylabel, axes.set_zlabel), strict=True
    ):
        label(f"{name} / mm", fontsize=8)
    axes.set_title(_SPACE.get(language), fontsize=9, color=INK)
    axes.tick_params(labelsize=6)


def _draw_stretches(axes: Any, path: ToolPath, dimensions: int, language: Language) -> None:
    """Draw feed and rapid motion as one line each, with gaps between their stretches."""
    for is_rapid, text, colour, style in (
        (False, _FEED, FEED, "-"),
        (True, _RAPID, RAPID, (0, (4, 2))),
    ):
        gap = numpy.full((1, path.points.shape[1]), numpy.nan)
        pieces = [
            piece
            for kind, points in path.stretches()
            if kind is is_rapid
            for piece in (points, gap)
        ]
        if pieces:
            line = numpy.concatenate(pieces)
            axes.plot(
                *(line[:, i] for i in range(dimensions)),
                color=colour,
                linestyle=style,
                linewidth=1.2,
                label=text.get(language),
            )


def _clusters(path: ToolPath) -> list[tuple[tuple[float, float], list[int]]]:
    """Return the places of marks in the plane with the numbers that are shown there."""
    size = float(numpy.ptp(path.points[:, :2], axis=0).max()) or 1.0
    clusters: dict[tuple[int, int], tuple[tuple[float, float], list[int]]] = {}
    for mark in path.marks:
        x, y = mark.point[:2]
        cell = (round(x / size / _NEAR), round(y / size / _NEAR))
        _, numbers = clusters.setdefault(cell, ((x, y), []))
        if mark.number not in numbers:
            numbers.append(mark.number)
    return list(clusters.values())

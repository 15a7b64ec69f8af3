# SPDX-License-Identifier: MIT
"""The positions of linear axes -> the path that a picture shows, with the places of reactions.

In: the motions of the axes, which ticks were rapid, the lanes. Out: ``ToolPath``: few points where
the path is straight, stretches of feed and of rapid motion, numbered marks.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.plots.lanes import Lane
from nctakt.plots.motion import AxisMotion

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Values = NDArray[numpy.float64]
    Flags = NDArray[numpy.bool_]

#: Maximum number of points of a path: more cannot be seen.
MAX_POINTS = 20_000
#: Maximum number of marks of one reaction; the places of further ones are not shown.
MAX_MARKS = 200

#: Directions that differ by less are one straight line, in radians.
_STRAIGHT = 1e-5


@dataclass(frozen=True, slots=True)
class Mark:
    """A firing of the reaction with this number: its time and its point on the path."""

    number: int
    time_s: float
    point: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class ToolPath:
    """The path of the first two or three linear axes that move.

    ``positions``: a row for each tick from ``begin_s`` on, mm. ``points``: those that are drawn.
    ``is_rapid``: of the stretch that ends at the point. ``marks``: where reactions fired;
    ``left_out`` further firings have none.
    """

    axes: tuple[str, ...]
    begin_s: float
    positions: Values
    points: Values
    is_rapid: Flags
    marks: tuple[Mark, ...]
    left_out: int

    def stretches(self) -> list[tuple[bool, Values]]:
        """Return the points of each stretch of one kind, with whether it is rapid."""
        changes = numpy.flatnonzero(numpy.diff(self.is_rapid[1:])) + 1
        edges = [0, *changes.tolist(), len(self.points) - 1]
        return [
            (bool(self.is_rapid[end]), self.points[begin : end + 1])
            for begin, end in itertools.pairwise(edges)
            if end > begin
        ]


def tool_path(motions: Sequence[AxisMotion], rapid: Values, lanes: Sequence[Lane]) -> ToolPath:
    """Return the path of at least two axes; ``rapid`` is empty where it was not recorded."""
    shown = motions[:3]
    points = numpy.column_stack([motion.tip.values for motion in shown])
    time_s = shown[0].position.time_s
    flags = rapid > 0.5 if len(rapid) else numpy.zeros(len(points), dtype=bool)
    kept = _kept(points, flags)
    marks: list[Mark] = []
    left_out = 0
    for lane in lanes:
        if lane.number:
            left_out += max(0, len(lane.bars) - MAX_MARKS)
            for bar in lane.bars[:MAX_MARKS]:
                point = [numpy.interp(bar.begin_s, time_s, column) for column in points.T]
                marks.append(Mark(lane.number, bar.begin_s, tuple(map(float, point))))
    names = tuple(motion.name for motion in shown)
    begin_s = float(time_s[0])
    return ToolPath(names, begin_s, points, points[kept], flags[kept], tuple(marks), left_out)


def _kept(points: Values, flags: Flags) -> NDArray[numpy.int64]:
    """Return the indices of the points that the path needs: ends, corners, changes of its kind."""
    moves = numpy.any(numpy.diff(points, axis=0) != 0.0, axis=1)
    standing = numpy.concatenate(([True], moves))
    own = numpy.flatnonzero(standing)
    if len(own) < 3:
        return own
    steps = numpy.diff(points[own], axis=0)
    directions = steps / numpy.linalg.norm(steps, axis=1, keepdims=True)
    turns = numpy.abs(numpy.diff(directions, axis=0)).max(axis=1) > _STRAIGHT
    changes = flags[own[2:]] != flags[own[1:-1]]
    inner = own[1:-1][turns | changes]
    stride = -(-len(inner) // MAX_POINTS) if len(inner) else 1
    return numpy.concatenate((own[:1], inner[::stride], own[-1:]))

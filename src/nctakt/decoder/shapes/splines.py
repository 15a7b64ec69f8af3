# SPDX-License-Identifier: MIT
"""A spline of a program: its motions as vertices, its pieces as motions (MO-18).

In: the motions between ``#SPLINE ON`` and ``#SPLINE OFF``. Out: each of them with the cubics that
take its place, as soon as enough further motions are there.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.path.path_motion import PathMotion
from nctakt.decoder.shapes.held_motion import HeldMotion
from nctakt.decoder.state.geometry import cubics
from nctakt.decoder.state.geometry.arcs import RADIANS
from nctakt.decoder.state.geometry.coordinate_systems import turned_out
from nctakt.decoder.state.geometry.cubics import Cubic, Point, between, hermite
from nctakt.decoder.state.queued.commands import Segment
from nctakt.decoder.state.queued.shape_commands import AUTO, BSPLINE, USER, Vector
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.splines import (
    SPLINE_DURING_COMPENSATION,
    SPLINE_OUTSIDE_LIMITS,
    SPLINE_TOO_SHORT,
    SPLINE_WITH_CONTOURING,
    SPLINE_WITHOUT_MAIN_AXES,
)

#: A motion of the main axes up to this length counts as none, mm.
NO_WAY_MM = 1e-6

Slope = Sequence[float | None]


DEGREE = 3


#: Changes of slope are the same below this part of the slopes.
SAME_SLOPE = 1e-9


def slope_of(segment: Segment, linear: Sequence[int], *, at_end: bool) -> list[float]:
    """Return the derivative of each axis by the length at one end of a motion."""
    start, target = segment.start, segment.target
    if segment.curve is not None:
        count = len(start)
        inner = segment.curve[count:] if at_end else segment.curve[:count]
        start, target = (inner, target) if at_end else (start, inner)
    distances = [end - begin for begin, end in zip(start, target, strict=True)]
    if segment.arc is not None:
        first, second = int(segment.arc[0]), int(segment.arc[1])
        turn = segment.arc[4] * RADIANS
        end = target if at_end else start
        x, y = end[first] - segment.arc[2], end[second] - segment.arc[3]
        distances[first], distances[second] = -y * turn, x * turn
    length = math.hypot(*(distances[axis] for axis in linear))
    return [distance / length for distance in distances] if length > 0.0 else []


class Spline:
    """A spline that begins after a motion; ``span``: of the block that has switched it on."""

    def __init__(self, values: Values, path: PathMotion, kind: str, span: Span) -> None:
        self._values = values
        self._environment = values.environment
        self._path = path
        self.is_bspline = kind == BSPLINE
        self.span = span
        self.start_slope: Slope = ()
        self._linear = [
            index for index, axis in enumerate(self._environment.axes) if axis.is_linear
        ]
        self._curve: AkimaCurve | BsplineCurve | None = None
        self._motions: deque[HeldMotion] = deque()
        self._released = 0
        self._at: cubics.Point | None = None

    @property
    def last(self) -> HeldMotion | None:
        """The newest motion that is held."""
        return self._motions[-1] if self._motions else None

    def slope(self, mode: str, vector: Vector, neighbour: Segment | None, at_end: bool) -> Slope:
        """Return the slopes at an end of the curve; empty where they follow from the vertices.

        ``neighbour``: the motion that a tangential end has to fit.
        """
        if mode == AUTO or self.is_bspline:
            return ()
        if mode == USER:
            return self._normalised(vector)
        assert neighbour is not None
        slope = slope_of(neighbour, self._linear, at_end=not at_end)
        return slope if neighbour.tilt is None else turned_out(neighbour.tilt.matrix, slope)

    def _normalised(self, vector: Vector) -> Slope:
        given = dict(vector)
        length = math.hypot(*(given.get(axis, 0.0) for axis in self._linear))
        if length == 0.0:
            return ()
        return [
            value / length if value is not None and axis in self._linear else value
            for axis, value in ((a, given.get(a)) for a in range(len(self._environment.axes)))
        ]

    def add(self, motion: HeldMotion) -> Iterator[tuple[HeldMotion, list[Segment]]]:
        """Take a motion; yield those whose pieces are known by now."""
        segment = motion.segment
        if self._values.state.path.compensation.is_active:
            self._values.fail(SPLINE_DURING_COMPENSATION, motion.span)
        if segment.deviation != 0.0:
            self._values.fail(SPLINE_WITH_CONTOURING, motion.span)
        chord = math.hypot(*(segment.target[axis] - segment.start[axis] for axis in self._linear))
        if chord < NO_WAY_MM:
            self._values.fail(SPLINE_WITHOUT_MAIN_AXES, motion.span)
        if self._curve is None:
            make = BsplineCurve if self.is_bspline else AkimaCurve
            self._curve = make(segment.start)
            if isinstance(self._curve, AkimaCurve):
                self._curve.start_slope = self.start_slope
        if isinstance(self._curve, AkimaCurve):
            self._curve.add(segment.target, chord)
        else:
            self._curve.add(segment.target)
        self._motions.append(motion)
        while len(self._motions) > self._curve.AHEAD:
            yield self._next()

    def finish(self, end_slope: Slope) -> Iterator[tuple[HeldMotion, list[Segment]]]:
        """Yield the rest of the motions; raises ``DecodeError`` if the spline is too short."""
        if self._curve is None:
            return
        if isinstance(self._curve, AkimaCurve):
            self._curve.end_slope = end_slope
        if not self._curve.is_long_enough:
            self._values.fail(
                SPLINE_TOO_SHORT,
                self.span,
                count=len(self._curve.points),
                fewest=self._curve.FEWEST,
            )
        while self._motions:
            yield self._next()

    def _next(self) -> tuple[HeldMotion, list[Segment]]:
        motion = self._motions.popleft()
        curve = self._curve
        assert curve is not None
        begin, *inner, end = curve.piece(self._released)
        begin = self._at or begin
        self._released += 1
        if self._released == len(curve.points) - 1:
            end = curve.points[-1]
        self._at = end
        piece = (begin, inner[0], inner[1], end)
        return motion, self._segments(motion, piece)

    def _segments(self, motion: HeldMotion, piece: cubics.Cubic) -> list[Segment]:
        """Return a piece as motions; only the last one stops exactly."""
        self._path.check_curve([piece], motion.span, message=SPLINE_OUTSIDE_LIMITS)
        segment = motion.segment
        feed = segment.feed
        if motion.time_s > 0.0 and segment.is_feed:
            feed = cubics.length_of(piece, self._linear) / motion.time_s
        parts = list(cubics.divided(piece, self._linear))
        modifiers = segment.modifiers
        others = None if modifiers is None else replace(modifiers, end_feed=0.0)
        return [
            replace(
                segment,
                start=part[0],
                target=part[3],
                feed=feed,
                exact_stop=segment.exact_stop and part is parts[-1],
                modifiers=modifiers if part is parts[-1] else others,
                curve=(*part[1], *part[2]),
                continues_block=part is not parts[-1],
            )
            for part in parts
        ]


# B-splines: a cubic curve that control points draw, with uniform knots (MO-18).
#
# The curve begins at the first control point and ends at the last one (its knots are there four
# times); in between it passes near them. The block that ends at a control point has the curve up to
# the mean of three knots that belongs to the point (Greville). A block is known when four more
# control points are there.


class BsplineCurve:
    """A curve of control points."""

    #: How many control points after its own a block needs to be known.
    AHEAD = 4
    #: How many control points a curve has at least.
    FEWEST = 4

    def __init__(self, start: Point) -> None:
        self.points = [start]

    def add(self, point: Point) -> None:
        """Append a control point."""
        self.points.append(point)

    @property
    def is_long_enough(self) -> bool:
        """Whether the curve has as many control points as it needs."""
        return len(self.points) >= self.FEWEST

    def piece(self, number: int) -> Cubic:
        """Return the curve of the block that leaves control point ``number``."""
        begin, end = self._mean(number), self._mean(number + 1)
        span = min(int(0.5 * (begin + end)), self._spans - 1)
        steps = [(begin, begin, begin), (begin, begin, end), (begin, end, end), (end, end, end)]
        first, second, third, last = (self._blossom(span, step) for step in steps)
        return (first, second, third, last)

    @property
    def _spans(self) -> int:
        return len(self.points) - DEGREE

    def _knot(self, index: int) -> float:
        """Return a knot; the first and the last four are the same."""
        return float(min(max(index - DEGREE, 0), self._spans))

    def _mean(self, number: int) -> float:
        """Return the parameter that belongs to a control point."""
        return (self._knot(number + 1) + self._knot(number + 2) + self._knot(number + 3)) / 3.0

    def _blossom(self, span: int, at: tuple[float, float, float]) -> Point:
        """Return the point of the polar form of a span (de Boor)."""
        points = self.points[span : span + DEGREE + 1]
        for level in range(DEGREE):
            points = [
                between(
                    points[index],
                    points[index + 1],
                    self._part(span, level, index, at[level]),
                )
                for index in range(DEGREE - level)
            ]
        return points[0]

    def _part(self, span: int, level: int, index: int, at: float) -> float:
        low = self._knot(span + level + index + 1)
        high = self._knot(span + index + DEGREE + 1)
        return (at - low) / (high - low)


# Akima splines: a curve through vertices, each piece from its neighbours (MO-18).
#
# H. Akima 1970, axis by axis, over the length of the chords: the slope at a vertex is the mean of
# the slopes of the chords next to it, each weighted by the change of slope on the other side; two
# chords are extrapolated at either end. A piece is known when two more vertices are there.


class AkimaCurve:
    """A curve from vertex to vertex; ``chords``: their lengths.

    ``start_slope`` and ``end_slope``: given slopes by axis, ``None`` for an axis without; empty
    where all follow from the vertices.
    """

    #: How many vertices after its end a piece needs to be known.
    AHEAD = 2
    #: How many vertices a curve has at least.
    FEWEST = 3

    def __init__(self, start: Point) -> None:
        self.points = [start]
        self.chords: list[float] = []
        self.start_slope: Sequence[float | None] = ()
        self.end_slope: Sequence[float | None] = ()
        self._slopes: list[Point] = []

    def add(self, point: Point, chord: float) -> None:
        """Append a vertex ``chord`` mm after the last one."""
        before = self.points[-1]
        self.points.append(point)
        self.chords.append(chord)
        self._slopes.append(tuple((b - a) / chord for a, b in zip(before, point, strict=True)))

    @property
    def is_long_enough(self) -> bool:
        """Whether the curve has as many vertices as it needs."""
        given = bool(self.start_slope) and bool(self.end_slope)
        return len(self.points) >= (2 if given else self.FEWEST)

    def piece(self, number: int) -> Cubic:
        """Return the piece after vertex ``number``; missing vertices end the curve."""
        slopes = (self._slope_at(number), self._slope_at(number + 1))
        ends = (self.points[number], self.points[number + 1])
        return hermite(*ends, slopes, self.chords[number])

    def _slope_at(self, number: int) -> Point:
        """Return the slope at a vertex."""
        given: Sequence[float | None] = ()
        if number == 0:
            given = self.start_slope
        elif number == len(self._slopes):
            given = self.end_slope
        return tuple(
            self._akima(number, axis)
            if not given or given[axis] is None
            else float(given[axis] or 0)
            for axis in range(len(self.points[0]))
        )

    def _akima(self, number: int, axis: int) -> float:
        """Return the slope of an axis at a vertex, from four chords."""
        m = [self._chord_slope(index, axis) for index in range(number - 2, number + 2)]
        before, after = abs(m[1] - m[0]), abs(m[3] - m[2])
        if before + after <= SAME_SLOPE * max(map(abs, m)):
            return 0.5 * (m[0] + m[3])
        return (after * m[1] + before * m[2]) / (before + after)

    def _chord_slope(self, index: int, axis: int) -> float:
        """Return the slope of a chord; beyond the ends it is extrapolated."""
        last = len(self._slopes) - 1
        if 0 <= index <= last:
            return self._slopes[index][axis]
        near, inner = (0, 1) if index < 0 else (last, last - 1)
        if last == 0:
            return self._slopes[0][axis]
        beyond = -index if index < 0 else index - last
        edge = self._slopes[near][axis]
        return edge + beyond * (edge - self._slopes[inner][axis])

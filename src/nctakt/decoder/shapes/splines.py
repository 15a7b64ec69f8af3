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
from nctakt.decoder.shapes.akima import AkimaCurve
from nctakt.decoder.shapes.bspline import BsplineCurve
from nctakt.decoder.shapes.held_motion import HeldMotion
from nctakt.decoder.state.geometry import cubics
from nctakt.decoder.state.geometry.arcs import RADIANS
from nctakt.decoder.state.geometry.coordinate_systems import turned_out
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

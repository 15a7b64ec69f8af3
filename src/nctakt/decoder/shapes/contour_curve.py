# SPDX-License-Identifier: MIT
"""The curve that rounds a corner between two motions: two halves that meet at an interim point.

Each half begins on its motion with the motion's direction and curvature; at the interim point both
have one direction and curvature. The sources say polynomials of fourth degree. The realtime part
carries cubics, so that each half is two of them, whose second derivative changes evenly over each:
they have the same ends, directions and curvatures, and no more freedom than a polynomial of fourth
degree. Positions are mm or degrees, derivatives are by the length in mm.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from nctakt.decoder.shapes import corners
from nctakt.decoder.shapes.splines import slope_of
from nctakt.decoder.state.geometry import cubics
from nctakt.decoder.state.geometry.arcs import RADIANS
from nctakt.decoder.state.geometry.cubics import Cubic, Point
from nctakt.decoder.state.queued.commands import Segment

#: A change of direction up to this does not count, as in the realtime part; next to arcs 0.01
#: degrees.
SAME_DIRECTION = 1e-6
SAME_DIRECTION_OF_ARCS = math.radians(0.01)

#: Where a piece of a curve is compared with its motions.
_SAMPLES = (0.2, 0.4, 0.6, 0.8, 1.0)

#: The largest angle of an arc that a rounding may take, degrees.
MAX_ARC_DEG = 90.0


class End(NamedTuple):
    """Where a curve begins or ends: positions, their change and the change of that."""

    position: Point
    slope: Sequence[float]
    bend: Sequence[float]


class Joint:
    """One motion at a corner.

    ``length`` in mm, without the part used by an earlier curve (``used``); ``longest``: the most
    that a curve uses of it, a ``part`` of the whole motion.
    """

    def __init__(
        self,
        segment: Segment,
        linear: Sequence[int],
        part: float,
        *,
        is_before: bool,
        used: float = 0.0,
    ) -> None:
        self.segment = segment
        self._linear = linear
        self.is_before = is_before
        self.length = length_of(segment, linear)
        self.longest = part * (self.length + used)
        if segment.arc is not None:
            quarter = MAX_ARC_DEG / max(abs(segment.arc[4]), MAX_ARC_DEG)
            self.longest = min(self.longest, quarter * self.length)

    @property
    def corner_slope(self) -> list[float]:
        """The direction at the corner."""
        return slope_of(self.segment, self._linear, at_end=self.is_before)

    def without(self, distance: float) -> Segment:
        """Return the motion without this length in mm at the corner."""
        if distance == 0.0:
            return self.segment
        part = min(distance / self.length, 1.0)
        segment = self.segment
        cut = corners.without_end if self.is_before else corners.without_begin
        plane = (0, 1)
        if segment.arc is not None:
            plane = (int(segment.arc[0]), int(segment.arc[1]))
        side = corners.Side(segment, plane, is_before=self.is_before)
        return cut(segment, plane, part, side.far if part == 1.0 else side.point_at(part))

    def end(self, rest: Segment) -> End:
        """Return the end of the curve that joins ``rest``, the motion cut short."""
        position = rest.target if self.is_before else rest.start
        if rest.arc is None:
            return End(position, self.corner_slope, [0.0] * len(position))
        slope = slope_of(rest, self._linear, at_end=self.is_before)
        return End(position, slope, _bend(rest, position, length_of(rest, self._linear)))


def length_of(segment: Segment, linear: Sequence[int]) -> float:
    """Return the length of a line or arc over these axes, mm."""
    travels = [end - begin for begin, end in zip(segment.start, segment.target, strict=True)]
    if segment.arc is not None:
        first, second, centre_1, centre_2, angle = segment.arc
        radius = math.hypot(
            segment.start[int(first)] - centre_1, segment.start[int(second)] - centre_2
        )
        travels[int(first)], travels[int(second)] = radius * angle * RADIANS, 0.0
    return math.hypot(*(travels[axis] for axis in linear))


def _bend(arc: Segment, position: Point, length: float) -> list[float]:
    """Return the change of the direction of an arc at one of its points."""
    assert arc.arc is not None
    bend = [0.0] * len(position)
    turn = arc.arc[4] * RADIANS / length
    for axis, centre in zip(arc.arc[:2], arc.arc[2:4], strict=True):
        bend[int(axis)] = (centre - position[int(axis)]) * turn * turn
    return bend


def turn_of(before: Segment, after: Segment, linear: Sequence[int]) -> float:
    """Return the change of the direction at a corner: the length of two unit vectors' difference.

    0 where a motion moves no linear axis.
    """
    leaving = slope_of(before, linear, at_end=True)
    entering = slope_of(after, linear, at_end=False)
    if not leaving or not entering:
        return 0.0
    return math.dist([leaving[axis] for axis in linear], [entering[axis] for axis in linear])


def smallest_turn(before: Segment, after: Segment) -> float:
    """Return the change of direction up to which a corner does not count."""
    has_arc = before.arc is not None or after.arc is not None
    return SAME_DIRECTION_OF_ARCS if has_arc else SAME_DIRECTION


def distances(
    before: Joint, after: Joint, turn: float, deviation: float, requested: tuple[float, float]
) -> tuple[float, float]:
    """Return how far before the corner and after it the curve begins and ends, mm.

    ``deviation``: at the corner, both are as long as that allows; 0: they are ``requested``.
    """
    if deviation > 0.0:
        requested = (6.0 * deviation / turn,) * 2
    if requested[0] == requested[1]:
        both = min(requested[0], before.longest, after.longest)
        return (both, both)
    return (min(requested[0], before.longest), min(requested[1], after.longest))


def interim_point(
    corner: Point,
    slopes: tuple[Sequence[float], Sequence[float]],
    halves: tuple[float, float],
    given: Mapping[int, float],
) -> Point:
    """Return where both halves meet: as ``given`` by axis, else so that the curve bends evenly."""
    leaving, entering = slopes
    total = halves[0] + halves[1]
    share = halves[0] * halves[1] / (3.0 * total) if total > 0.0 else 0.0
    return tuple(
        given.get(axis, position + share * (entering[axis] - leaving[axis]))
        for axis, position in enumerate(corner)
    )


def curve(
    begin: End, end: End, halves: tuple[float, float], middle: Point, linear: Sequence[int]
) -> list[list[Cubic]]:
    """Return the cubics of both halves of the curve; ``halves``: their lengths as parameters.

    A half is at least as long as the distance to the interim point, so that a half without a
    distance from the corner has a length, too.
    """
    first = 0.5 * max(halves[0], _distance(begin.position, middle, linear))
    second = 0.5 * max(halves[1], _distance(end.position, middle, linear))
    joined: list[float] = []
    for axis, position in enumerate(middle):
        a = position - begin.position[axis] - 2.0 * first * begin.slope[axis]
        b = position - end.position[axis] + 2.0 * second * end.slope[axis]
        change = end.slope[axis] - begin.slope[axis] - a / first - b / second
        bends = first * begin.bend[axis] + second * end.bend[axis]
        joined.append((3.0 * change + bends) / (first + second))
    back = End(end.position, [-slope for slope in end.slope], end.bend)
    return [
        _half(begin, middle, first, joined),
        [(d, c, b, a) for a, b, c, d in reversed(_half(back, middle, second, joined))],
    ]


def deviation_of(
    pieces: Sequence[Cubic], motions: Sequence[Segment], linear: Sequence[int]
) -> float:
    """Return how far a curve leaves two motions, at most; 0 without an arc."""
    if all(segment.arc is None for segment in motions):
        return 0.0
    points = [cubics.point(piece, part) for piece in pieces for part in _SAMPLES]
    return max(min(_off(segment, point, linear) for segment in motions) for point in points)


def _off(segment: Segment, point: Point, linear: Sequence[int]) -> float:
    """Return the distance of a point from a line's nearest point, or from that at its angle."""
    begin, end = segment.start, segment.target
    ends = min(_distance(begin, point, linear), _distance(end, point, linear))
    if segment.arc is None:
        along = sum((end[axis] - begin[axis]) * (point[axis] - begin[axis]) for axis in linear)
        part = along / _distance(begin, end, linear) ** 2
        nearest = list(cubics.between(begin, end, part))
    else:
        first, second, centre_1, centre_2, angle = segment.arc
        from_1, from_2 = begin[int(first)] - centre_1, begin[int(second)] - centre_2
        to_1, to_2 = point[int(first)] - centre_1, point[int(second)] - centre_2
        turn = math.atan2(to_2, to_1) - math.atan2(from_2, from_1)
        part = math.copysign(1.0, angle) * turn % math.tau / (abs(angle) * RADIANS)
        nearest = list(cubics.between(begin, end, part))
        size = math.hypot(from_1, from_2) / max(math.hypot(to_1, to_2), 1e-12)
        nearest[int(first)], nearest[int(second)] = centre_1 + to_1 * size, centre_2 + to_2 * size
    if not 0.0 < part < 1.0:
        return ends
    return min(ends, _distance(tuple(nearest), point, linear))


def _distance(one: Point, other: Point, axes: Sequence[int]) -> float:
    return math.dist([one[axis] for axis in axes], [other[axis] for axis in axes])


def _half(begin: End, middle: Point, step: float, joined: Sequence[float]) -> list[Cubic]:
    """Return both cubics of a half, each over a parameter of the length ``step``."""
    inner: list[list[float]] = [[], [], [], [], []]
    for axis, (position, slope, bend) in enumerate(zip(*begin, strict=True)):
        rest = middle[axis] - position - 2.0 * step * slope
        between = rest / (step * step) - 5.0 / 6.0 * bend - joined[axis] / 6.0
        joint_slope = slope + 0.5 * step * (bend + between)
        joint = position + step * (slope + step * (bend / 3.0 + between / 6.0))
        last_slope = joint_slope + 0.5 * step * (between + joined[axis])
        third = step / 3.0
        points = (
            position + third * slope,
            joint - third * joint_slope,
            joint,
            joint + third * joint_slope,
            middle[axis] - third * last_slope,
        )
        for column, value in zip(inner, points, strict=True):
            column.append(value)
    one, two, joint_position, three, four = (tuple(column) for column in inner)
    return [(begin.position, one, two, joint_position), (joint_position, three, four, middle)]

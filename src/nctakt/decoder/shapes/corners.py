# SPDX-License-Identifier: MIT
"""Chamfers and roundings between two motions of the plane (MO-4).

Two motions meet at a corner. A chamfer begins and ends at a distance from it, measured straight, on
arcs as a chord; a rounding is an arc that touches both motions. Axes outside the plane keep their
part of the length. Lengths are mm, angles degrees.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from nctakt.decoder.state.geometry.arcs import RADIANS
from nctakt.decoder.state.queued.commands import Segment

#: Rounding error allowed in a motion, as a share of its length.
NOTHING_LEFT = 1e-9

#: Sine of an angle below which two directions are the same.
SAME_DIRECTION = 1e-9

Point = tuple[float, float]


class Side:
    """One motion at a corner, seen from the corner.

    ``part_at``: which part of the motion, counted from the corner, ends at a point of it.
    """

    def __init__(self, segment: Segment, plane: tuple[int, int], *, is_before: bool) -> None:
        first, second = plane
        begin = (segment.start[first], segment.start[second])
        end = (segment.target[first], segment.target[second])
        self.corner, self.far = (end, begin) if is_before else (begin, end)
        self._sign = 1.0 if is_before else -1.0
        self.turn = 0.0
        self.centre = self.corner
        if segment.arc is not None:
            self.centre = (segment.arc[2], segment.arc[3])
            self.turn = segment.arc[4]
        self.radius = math.dist(self.corner, self.centre)
        self.length = (
            self.radius * abs(self.turn) * RADIANS
            if self.turn
            else math.dist(self.corner, self.far)
        )

    @property
    def direction(self) -> Point:
        """The direction of the motion at the corner."""
        x, y = self.corner
        if self.turn == 0.0:
            x, y = (x - self.far[0]) * self._sign, (y - self.far[1]) * self._sign
            return (x / self.length, y / self.length)
        sign = math.copysign(1.0 / self.radius, self.turn)
        return (-(y - self.centre[1]) * sign, (x - self.centre[0]) * sign)

    def part_of_chord(self, chord: float) -> float:
        """Return which part of the motion a distance from the corner takes; above 1: too far."""
        if self.turn == 0.0:
            return chord / self.length
        if chord > 2.0 * self.radius:
            return math.inf
        return 2.0 * math.asin(0.5 * chord / self.radius) / (abs(self.turn) * RADIANS)

    def point_at(self, part: float) -> Point:
        """Return the point after a part of the motion, counted from the corner."""
        x, y = self.corner
        if self.turn == 0.0:
            return (x + (self.far[0] - x) * part, y + (self.far[1] - y) * part)
        return _turned(self.corner, self.centre, -self._sign * self.turn * part)

    def touch(self, centre: Point) -> float:
        """Return the part of the motion up to where a circle about ``centre`` touches it."""
        if self.turn == 0.0:
            x, y = self.far[0] - self.corner[0], self.far[1] - self.corner[1]
            along = (centre[0] - self.corner[0]) * x + (centre[1] - self.corner[1]) * y
            return along / (self.length * self.length)
        begin = math.atan2(self.corner[1] - self.centre[1], self.corner[0] - self.centre[0])
        angle = math.atan2(centre[1] - self.centre[1], centre[0] - self.centre[0])
        away = (angle - begin) * -self._sign * math.copysign(1.0, self.turn)
        return away % math.tau / (abs(self.turn) * RADIANS)


def _turned(point: Point, centre: Point, angle: float) -> Point:
    """Return a point turned about a centre by ``angle`` degrees."""
    cosine, sine = math.cos(angle * RADIANS), math.sin(angle * RADIANS)
    x, y = point[0] - centre[0], point[1] - centre[1]
    return (centre[0] + x * cosine - y * sine, centre[1] + x * sine + y * cosine)


def inner_angle(before: Side, after: Side) -> float:
    """Return the angle between two motions in radians: π where they go straight on."""
    x, y = before.direction
    u, v = after.direction
    return math.pi - abs(math.atan2(x * v - y * u, x * u + y * v))


def rounding_centre(before: Side, after: Side, radius: float) -> tuple[Point, float] | None:
    """Return the centre of a rounding and 1 for a turn to the left, -1 to the right.

    ``None``: no circle with this radius touches both motions.
    """
    x, y = before.direction
    u, v = after.direction
    left = math.copysign(1.0, x * v - y * u)
    offset_before = _beside(before, left * radius)
    offset_after = _beside(after, left * radius)
    if offset_before is None or offset_after is None:
        return None
    fitting = [
        (max(before.touch(point), after.touch(point)), point)
        for point in _crossings(offset_before, offset_after)
        if before.touch(point) > 0.0 and after.touch(point) > 0.0
    ]
    return (min(fitting)[1], left) if fitting else None


#: Offset curve of a motion: point and direction of a line, or centre and radius.
_Offset = tuple[Point, Point] | tuple[Point, float]


def _beside(side: Side, distance: float) -> _Offset | None:
    """Return the offset curve ``distance`` mm to the left of a motion."""
    if side.turn == 0.0:
        x, y = side.direction
        return ((side.corner[0] - y * distance, side.corner[1] + x * distance), (x, y))
    radius = side.radius - math.copysign(distance, distance * side.turn)
    return (side.centre, radius) if radius > 0.0 else None


def _crossings(one: _Offset, other: _Offset) -> list[Point]:
    """Return the points that two lines or circles have in common."""
    begin, extent = one
    other_begin, other_extent = other
    if isinstance(extent, tuple):
        if isinstance(other_extent, tuple):
            return _crossing_of_lines(begin, extent, other_begin, other_extent)
        return _crossings_of_circle(begin, extent, other_begin, other_extent)
    if isinstance(other_extent, tuple):
        return _crossings_of_circle(other_begin, other_extent, begin, extent)
    x, y = other_begin[0] - begin[0], other_begin[1] - begin[1]
    gap = math.hypot(x, y)
    if gap == 0.0:
        return []
    along = 0.5 * (gap + (extent - other_extent) * (extent + other_extent) / gap)
    foot = (begin[0] + x / gap * along, begin[1] + y / gap * along)
    return _crossings_of_circle(foot, (-y / gap, x / gap), begin, extent)


def _crossing_of_lines(
    begin: Point, direction: Point, other: Point, other_direction: Point
) -> list[Point]:
    sine = direction[0] * other_direction[1] - direction[1] * other_direction[0]
    if abs(sine) < SAME_DIRECTION:
        return []
    x, y = other[0] - begin[0], other[1] - begin[1]
    part = (x * other_direction[1] - y * other_direction[0]) / sine
    return [(begin[0] + direction[0] * part, begin[1] + direction[1] * part)]


def _crossings_of_circle(
    begin: Point, direction: Point, centre: Point, radius: float
) -> list[Point]:
    x, y = begin[0] - centre[0], begin[1] - centre[1]
    nearest = x * direction[0] + y * direction[1]
    beside2 = x * x + y * y - nearest * nearest
    rest2 = radius * radius - beside2
    if rest2 < 0.0:
        return []
    rest = math.sqrt(rest2)
    return [
        (begin[0] + direction[0] * part, begin[1] + direction[1] * part)
        for part in (-nearest - rest, -nearest + rest)
    ]


# --- motions cut short ------------------------------------------------------------------------


def without_end(segment: Segment, plane: tuple[int, int], part: float, point: Point) -> Segment:
    """Return a motion without this part of its length at its end; it then ends at ``point``."""
    if part >= 1.0:
        return replace(segment, target=segment.start, arc=None)

    def shortened(begin: float, end: float) -> float:
        return end + (begin - end) * part

    return replace(
        segment,
        target=_moved(segment.start, segment.target, plane, point, shortened),
        arc=_rest_of_arc(segment, part),
    )


def without_begin(segment: Segment, plane: tuple[int, int], part: float, point: Point) -> Segment:
    """Return a motion without this part of its length at its begin; it then begins at ``point``."""
    if part >= 1.0:
        return replace(segment, start=segment.target, arc=None)

    def shortened(begin: float, end: float) -> float:
        return begin + (end - begin) * part

    return replace(
        segment,
        start=_moved(segment.start, segment.target, plane, point, shortened),
        arc=_rest_of_arc(segment, part),
    )


def _moved(
    start: tuple[float, ...],
    target: tuple[float, ...],
    plane: tuple[int, int],
    point: Point,
    shortened: Callable[[float, float], float],
) -> tuple[float, ...]:
    ends = [shortened(begin, end) for begin, end in zip(start, target, strict=True)]
    ends[plane[0]], ends[plane[1]] = point
    return tuple(ends)


def _rest_of_arc(segment: Segment, part: float) -> tuple[float, ...] | None:
    if segment.arc is None:
        return None
    return (*segment.arc[:4], segment.arc[4] * (1.0 - part))

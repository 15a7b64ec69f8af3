# SPDX-License-Identifier: MIT
"""Arcs of the program -> centre and angle in their plane (MO-4).

A plane is spanned by two of the channel's first three axes: G17 X Y, G18 Z X, G19 Y Z; G03 turns
from the first to the second one. An arc is given by its centre, or by its radius; a negative radius
selects the longer of the two arcs. Lengths are mm, angles degrees.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.channel_configuration import CentreTolerance
from nctakt.messages.path.motion import (
    ARC_CENTRE_TOO_FAR_OFF,
    ARC_RADIUS_TOO_SMALL,
    ARC_WITHOUT_CENTRE,
    POINTS_ON_A_LINE,
)
from nctakt.nc.vocabulary.functions import PLANE_XY, PLANE_YZ, PLANE_ZX

#: G function of a plane -> its first and second axis.
PLANES = {PLANE_XY: (0, 1), PLANE_ZX: (2, 0), PLANE_YZ: (1, 2)}

#: Radians of a degree.
RADIANS = 0.017453292519943295

#: Maximum length missing in a radius whose arc just leads to the target, mm.
RADIUS_TOLERANCE_MM = 0.01

#: Ends of a circle at most this far apart coincide: sums of G91 are rounded.
SAME_POINT_MM = 1e-9

#: Three points on a larger circle than this are on a line, mm.
MAX_RADIUS_MM = 1e6

#: A centre at most this far off is exact: coordinates are rounded sums.
EXACT_CENTRE_MM = 1e-6


@dataclass(frozen=True, slots=True)
class Arc:
    """An arc over the axes ``first`` and ``second``; ``angle`` is negative for G02."""

    first: int
    second: int
    centre_first: float
    centre_second: float
    angle: float

    @property
    def axes(self) -> tuple[int, int]:
        """The axes of its plane."""
        return (self.first, self.second)

    @property
    def row(self) -> tuple[float, ...]:
        """The columns of the arc for the realtime part."""
        return (self.first, self.second, self.centre_first, self.centre_second, self.angle)

    def length(self, start: Sequence[float]) -> float:
        """Return its length in the plane, mm."""
        radius = _length(
            start[self.first] - self.centre_first, start[self.second] - self.centre_second
        )
        return radius * abs(self.angle) * RADIANS


class ArcError(Exception):
    """No arc is possible: ``message`` with its ``values``."""

    def __init__(self, message: Message, **values: float) -> None:
        super().__init__(message)
        self.message = message
        self.values = values


def arc_about(
    start: Sequence[float],
    target: Sequence[float],
    plane: tuple[int, int],
    centre: tuple[float, float],
    clockwise: bool,
    tolerance: CentreTolerance,
) -> Arc:
    """Return the arc about a centre; a full circle if start and target coincide.

    The centre is moved to the nearest point equidistant from both ends. Ends that differ only by
    the rounding of sums make a full circle. Raises ``ArcError`` if the centre would have to move
    farther than ``tolerance`` allows.
    """
    first, second = plane
    x, y = start[first] - centre[0], start[second] - centre[1]
    u, v = target[first] - centre[0], target[second] - centre[1]
    if x == 0.0 and y == 0.0:
        raise ArcError(ARC_WITHOUT_CENTRE)
    chord = _length(u - x, v - y)
    if chord <= SAME_POINT_MM:
        return Arc(first, second, *centre, -360.0 if clockwise else 360.0)
    # Move the centre along the chord until it is equidistant from both ends.
    along = ((x + u) * (u - x) + (y + v) * (v - y)) / (2.0 * chord * chord)
    shift = abs(along) * chord
    centre = (centre[0] + along * (u - x), centre[1] + along * (v - y))
    radius = _length(start[first] - centre[0], start[second] - centre[1])
    allowed = tolerance.allowed_mm(radius)
    if shift > max(allowed, EXACT_CENTRE_MM):
        raise ArcError(ARC_CENTRE_TOO_FAR_OFF, shift=shift, allowed=allowed)
    return Arc(first, second, *centre, _angle(start, target, (first, second), centre, clockwise))


def arc_of_radius(
    start: Sequence[float],
    target: Sequence[float],
    plane: tuple[int, int],
    radius: float,
    clockwise: bool,
) -> Arc:
    """Return the arc with a radius, the longer one for a negative radius; raises ``ArcError``."""
    first, second = plane
    x, y = target[first] - start[first], target[second] - start[second]
    chord = _length(x, y)
    if chord == 0.0 or radius == 0.0:
        raise ArcError(ARC_RADIUS_TOO_SMALL, radius=radius, minimum=chord / 2.0)
    height2 = radius * radius - chord * chord / 4.0
    if height2 < 0.0:
        if chord / 2.0 - abs(radius) > RADIUS_TOLERANCE_MM:
            raise ArcError(ARC_RADIUS_TOO_SMALL, radius=radius, minimum=chord / 2.0)
        height2 = 0.0
    height = arithmetic.square_root(height2) / chord
    if clockwise != (radius < 0.0):
        height = -height
    centre = (
        (start[first] + target[first]) / 2.0 - height * y,
        (start[second] + target[second]) / 2.0 + height * x,
    )
    return Arc(first, second, *centre, _angle(start, target, (first, second), centre, clockwise))


def arc_through(
    start: Sequence[float], interim: Sequence[float], target: Sequence[float]
) -> tuple[Arc, tuple[float, ...]]:
    """Return the arc over the first three axes from start by way of an interim point to a target.

    With the matrix that turns its plane into that of these axes, as ``Tilt.matrix``; the arc is in
    the turned coordinates. Raises ``ArcError`` for points that are on a line, or nearly.
    """
    one = [b - a for a, b in zip(start[:3], interim[:3], strict=True)]
    two = [c - a for a, c in zip(start[:3], target[:3], strict=True)]
    normal = cross(one, two)
    area2, one2, two2 = (dot(vector, vector) for vector in (normal, one, two))
    apart = [b - a for a, b in zip(one, two, strict=True)]
    if area2 == 0.0 or one2 * two2 * dot(apart, apart) > 4.0 * MAX_RADIUS_MM**2 * area2:
        raise ArcError(POINTS_ON_A_LINE)
    across, along = cross(normal, one), cross(two, normal)
    away = [
        (two2 * a + one2 * b) / (2.0 * area2) for a, b in zip(across, along, strict=True)
    ]  # from the start to the centre
    radius = arithmetic.square_root(dot(away, away))
    first = [-part / radius for part in away]
    third = [part / arithmetic.square_root(area2) for part in normal]
    second = cross(third, first)
    out = [b - a for a, b in zip(away, two, strict=True)]
    angle = arithmetic.arc_tangent_2(dot(out, second), dot(out, first))
    turn = tuple(axis[row] for row in range(3) for axis in (first, second, third))
    centre = [a + b for a, b in zip(start, away, strict=False)]
    inside = (dot(centre, first), dot(centre, second))
    return Arc(0, 1, *inside, angle if angle > 0.0 else angle + 360.0), turn


def dot(one: Sequence[float], other: Sequence[float]) -> float:
    """Return the scalar product of two vectors."""
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def cross(one: Sequence[float], other: Sequence[float]) -> list[float]:
    """Return the vector product of two vectors."""
    return [
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    ]


def extremes(arc: Arc, start: Sequence[float]) -> Iterator[tuple[int, float]]:
    """Yield the extreme points of the arc between its ends: axis and position."""
    x, y = start[arc.first] - arc.centre_first, start[arc.second] - arc.centre_second
    radius = _length(x, y)
    begin = arithmetic.arc_tangent_2(y, x)
    low, high = min(begin, begin + arc.angle), max(begin, begin + arc.angle)
    for turn in range(-720, 721, 90):
        if low < turn < high:
            axis, centre = (
                (arc.first, arc.centre_first)
                if turn % 180 == 0
                else (arc.second, arc.centre_second)
            )
            yield axis, centre + (radius if turn % 360 in (0, 90) else -radius)


def _length(x: float, y: float) -> float:
    return arithmetic.square_root(x * x + y * y)


def _angle(
    start: Sequence[float],
    target: Sequence[float],
    axes: tuple[int, int],
    centre: tuple[float, float],
    clockwise: bool,
) -> float:
    """Return the angle from start to target in the direction of the arc, at most a full circle."""
    first, second = axes
    x, y = start[first] - centre[0], start[second] - centre[1]
    u, v = target[first] - centre[0], target[second] - centre[1]
    if x == u and y == v:
        return -360.0 if clockwise else 360.0
    angle = arithmetic.arc_tangent_2(x * v - y * u, x * u + y * v)
    if clockwise:
        return angle if angle < 0.0 else angle - 360.0
    return angle if angle > 0.0 else angle + 360.0

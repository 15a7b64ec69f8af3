# SPDX-License-Identifier: MIT
"""Plane geometry of tool radius compensation: pieces of a contour, and beside them (MO-9).

A piece is a line or an arc in the plane of G17, G18 or G19, lengths in mm, angles in degrees. The
tool's centre goes at a signed distance to the left of it. Where two pieces meet, their shifted ones
are joined: at an inner corner where they cut each other, at an outer one by further pieces.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from nctakt.kernel import arithmetic

Point = tuple[float, float]

#: A change of direction below this is none, in degrees: ends and centres of arcs are rounded.
TANGENTIAL_DEG = 0.01

#: From here on the contour goes back along itself, in degrees.
REVERSAL_DEG = 179.99

#: Radians in a degree.
DEGREE = 0.017453292519943295

#: What a piece may lack before it is said to go backwards, in mm: rounding.
ROUNDING_MM = 1e-7


@dataclass(frozen=True, slots=True)
class Piece:
    """From ``start`` to ``end`` in a line, or about ``centre`` by ``angle``, negative clockwise."""

    start: Point
    end: Point
    centre: Point | None = None
    angle: float = 0.0

    @property
    def is_line(self) -> bool:
        """Whether it is no arc."""
        return self.centre is None

    def direction_at(self, place: Point) -> Point:
        """The direction of the way there, of length 1."""
        if self.centre is None:
            return _unit(_less(self.end, self.start))
        x, y = _unit(_less(place, self.centre))
        return (-y, x) if self.angle > 0.0 else (y, -x)


@dataclass(frozen=True, slots=True)
class Joint:
    """How two shifted pieces are joined: where the first one ends, what comes between them, where
    the second one begins."""

    end: Point
    between: tuple[Piece, ...]
    start: Point


def length(piece: Piece) -> float:
    """The way from its start to its end."""
    if piece.centre is None:
        return _length(_less(piece.end, piece.start))
    return _length(_less(piece.start, piece.centre)) * abs(piece.angle) * DEGREE


def shifted(piece: Piece, distance: float) -> Piece | None:
    """The piece at ``distance`` to its left; ``None``: an arc whose radius is not greater."""
    if piece.centre is None:
        direction = piece.direction_at(piece.start)
        return Piece(
            beside(piece.start, direction, distance), beside(piece.end, direction, distance)
        )
    inwards = distance if piece.angle > 0.0 else -distance
    if _length(_less(piece.start, piece.centre)) - inwards <= ROUNDING_MM:
        return None
    start, end = (
        beside(place, piece.direction_at(place), distance) for place in (piece.start, piece.end)
    )
    return replace(piece, start=start, end=end)


def turn_between(before: Point, behind: Point) -> float:
    """How far the way turns from one direction to another, to the left; above -180, up to 180."""
    return arithmetic.arc_tangent_2(_cross(before, behind), _dot(before, behind))


def is_outer(turn: float, distance: float) -> bool:
    """Whether the tool has to go around this corner."""
    if abs(turn) < TANGENTIAL_DEG:
        return False
    return turn * distance < 0.0 or abs(turn) > REVERSAL_DEG


def join(
    first: Piece, second: Piece, beside_them: tuple[Piece, Piece], distance: float, by_arc: bool
) -> Joint | None:
    """Join what goes at ``distance`` beside two pieces that meet, ``None`` where it does not meet.

    ``beside_them``: both of them ``shifted``. ``by_arc``: around an outer corner in an arc, else in
    lines.
    """
    corner = first.end
    before, behind = first.direction_at(first.end), second.direction_at(second.start)
    turn = turn_between(before, behind)
    if is_outer(turn, distance):
        ways = around(corner, (before, behind), distance, by_arc)
        return extended(ways, first.is_line, second.is_line)
    end, start = beside(corner, before, distance), beside(corner, behind, distance)
    if abs(turn) < TANGENTIAL_DEG:
        middle = ((end[0] + start[0]) / 2.0, (end[1] + start[1]) / 2.0)
        return Joint(middle, (), middle)
    if first.is_line and second.is_line:
        place = _bisecting(corner, before, behind, distance)
        return Joint(place, (), place)
    places = list(_common(*beside_them))
    if not places:
        return None
    place = min(places, key=lambda one: _length(_less(one, corner)))
    return Joint(place, (), place)


def around(
    corner: Point, directions: tuple[Point, Point], distance: float, by_arc: bool
) -> tuple[Piece, ...]:
    """The way around an outer corner, from beside the first direction to beside the second one.

    In lines it goes straight on to where the lines beside both directions cut each other, at sharp
    corners no farther than the distance, and then across.
    """
    before, behind = directions
    start, end = beside(corner, before, distance), beside(corner, behind, distance)
    turn = turn_between(before, behind)
    if by_arc:
        if abs(turn) > REVERSAL_DEG:
            turn = -abs(turn) if distance > 0.0 else abs(turn)
        return (Piece(start, end, corner, turn),)
    if abs(turn) <= 90.0:
        place = _bisecting(corner, before, behind, distance)
        return (Piece(start, place), Piece(place, end))
    reach = abs(distance)
    first = (start[0] + before[0] * reach, start[1] + before[1] * reach)
    second = (end[0] - behind[0] * reach, end[1] - behind[1] * reach)
    return (Piece(start, first), Piece(first, second), Piece(second, end))


def trimmed(whole: Piece, start: Point, end: Point) -> Piece | None:
    """A shifted piece between other ends; ``None``: it would go backwards."""
    if whole.centre is None:
        direction = whole.direction_at(whole.start)
        way = _dot(_less(end, start), direction)
        return None if way < -ROUNDING_MM else Piece(start, end)
    sense = 1.0 if whole.angle > 0.0 else -1.0
    radius = _length(_less(whole.start, whole.centre))
    angle = abs(whole.angle)
    for one, other in ((whole.start, start), (end, whole.end)):
        angle -= sense * turn_between(_less(one, whole.centre), _less(other, whole.centre))
    if angle * radius * DEGREE < -ROUNDING_MM or angle > abs(whole.angle) + TANGENTIAL_DEG:
        return None
    if angle * radius * DEGREE < ROUNDING_MM:
        return Piece(start, end)
    return Piece(start, end, whole.centre, sense * angle)


def beside(place: Point, direction: Point, distance: float) -> Point:
    """The place at this distance to the left of a direction."""
    return (place[0] - direction[1] * distance, place[1] + direction[0] * distance)


def extended(ways: tuple[Piece, ...], first: bool, second: bool) -> Joint:
    """Lines around a corner are part of the lines that they go on in: the way is one with them."""
    start, end = ways[0].start, ways[-1].end
    if ways[0].is_line and first:
        start, ways = ways[0].end, ways[1:]
    if ways and ways[-1].is_line and second:
        end, ways = ways[-1].start, ways[:-1]
    return Joint(start, ways, end)


def _bisecting(corner: Point, before: Point, behind: Point, distance: float) -> Point:
    """Where the lines beside two directions cut each other."""
    share = distance / (1.0 + _dot(before, behind))
    return (
        corner[0] - (before[1] + behind[1]) * share,
        corner[1] + (before[0] + behind[0]) * share,
    )


def _common(first: Piece, second: Piece) -> Iterator[Point]:
    """Where the whole line or circle of two pieces cut each other; one of them is an arc."""
    if first.centre is not None and second.centre is not None:
        yield from _of_circles(first.start, first.centre, second.start, second.centre)
    elif first.centre is not None:
        yield from _of_line(second, first.start, first.centre)
    else:
        assert second.centre is not None
        yield from _of_line(first, second.start, second.centre)


def _of_line(line: Piece, on_circle: Point, centre: Point) -> Iterator[Point]:
    direction = line.direction_at(line.start)
    off = _less(line.start, centre)
    across, along = _cross(direction, off), _dot(direction, off)
    radius = _length(_less(on_circle, centre))
    half2 = (radius - across) * (radius + across)
    if half2 < 0.0:
        return
    half = arithmetic.square_root(half2)
    for way in (-along - half, -along + half):
        yield (line.start[0] + direction[0] * way, line.start[1] + direction[1] * way)


def _of_circles(one: Point, centre: Point, other: Point, centre_2: Point) -> Iterator[Point]:
    radius, radius_2 = _length(_less(one, centre)), _length(_less(other, centre_2))
    between = _less(centre_2, centre)
    apart = _length(between)
    if apart <= ROUNDING_MM:
        return
    along = (apart + (radius - radius_2) * (radius + radius_2) / apart) / 2.0
    half2 = (radius - along) * (radius + along)
    if half2 < 0.0:
        return
    half = arithmetic.square_root(half2)
    x, y = between[0] / apart, between[1] / apart
    for side in (-half, half):
        yield (centre[0] + x * along - y * side, centre[1] + y * along + x * side)


def _less(one: Point, other: Point) -> Point:
    return (one[0] - other[0], one[1] - other[1])


def _dot(one: Point, other: Point) -> float:
    return one[0] * other[0] + one[1] * other[1]


def _cross(one: Point, other: Point) -> float:
    return one[0] * other[1] - one[1] * other[0]


def _length(one: Point) -> float:
    return arithmetic.square_root(_dot(one, one))


def _unit(one: Point) -> Point:
    length = _length(one)
    return (one[0] / length, one[1] / length)

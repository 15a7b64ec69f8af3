# SPDX-License-Identifier: MIT
"""Motions in the plane of a tilted coordinate system, and as the axes make them (MO-4, MO-8).

Arcs, the compensation of the tool's radius, chamfers and roundings are made in a plane of two axes.
Where the active coordinate system tilts that plane, their motions are turned into it
(``Segment.tilt``) and out of it again. An arc that is not in a plane of two axes then is a row of
cubics that deviate from it by at most ``TOLERANCE_MM``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.geometry import cubics
from nctakt.decoder.state.geometry.arcs import RADIANS, Arc
from nctakt.decoder.state.geometry.coordinate_systems import Matrix, axis_arc, turned_out
from nctakt.decoder.state.geometry.cubics import Cubic, Point
from nctakt.decoder.state.queued.commands import Command, EmptyBlock, Segment, Tilt

#: How far a cubic may deviate from its arc, mm.
TOLERANCE_MM = 1e-6

#: The largest angle of a cubic in degrees; beyond it the estimates of its error do not hold.
MAX_ANGLE = 45.0

#: How far a cubic over the angle a deviates from its arc at most: this times a⁶ of the radius, and
#: this times a⁴ of the distance of the axes outside the plane.
_OFF_RADIUS, _OFF_WAY = 1.9e-5, 1.2e-4


def into_plane(segment: Segment, environment: DecoderEnvironment, plane: int) -> Segment:
    """Return a motion in the active system where that tilts the plane of a G function."""
    matrix = environment.offsets.systems.tilt(plane)
    if matrix is None or segment.tilt is not None:
        return segment
    tilt = tilt_of(matrix, environment, segment.start, segment.target)
    return replace(segment, start=tilt.inside[0], target=tilt.inside[1], tilt=tilt)


def tilt_of(
    matrix: Matrix, environment: DecoderEnvironment, start: Sequence[float], target: Sequence[float]
) -> Tilt:
    """Return where a motion between positions of the axes is in a tilted plane."""
    into = environment.offsets.systems.into
    inside = (tuple(into(matrix, start)), tuple(into(matrix, target)))
    return Tilt(matrix, inside, (tuple(start), tuple(target)))


def moved_in_plane(
    positions: Sequence[float],
    point: Mapping[int, float],
    environment: DecoderEnvironment,
    plane: int,
) -> list[float]:
    """Return positions of the axes at a point of the plane of a G function, tilted or not.

    ``point``: by the axes of the plane.
    """
    systems = environment.offsets.systems
    matrix = systems.tilt(plane)
    inside = list(positions) if matrix is None else systems.into(matrix, positions)
    moved = list(inside)
    for axis, value in point.items():
        moved[axis] = value
    if moved == inside:
        return list(positions)
    return moved if matrix is None else turned_out(matrix, moved)


def _axes_at(tilt: Tilt, positions: tuple[float, ...], *ends: int) -> tuple[float, ...]:
    """Return positions of the axes; those of the programmed ``ends`` to the bit."""
    for end in ends:
        if positions == tilt.inside[end]:
            return tilt.outside[end]
    return tuple(turned_out(tilt.matrix, positions))


def out_of_plane(command: Command, environment: DecoderEnvironment) -> Iterator[Command]:
    """Yield a motion as the axes make it; any other command unchanged."""
    if not isinstance(command, Segment) or command.tilt is None:
        yield command
        return
    segment, tilt = command, command.tilt
    start, target = _axes_at(tilt, segment.start, 0, 1), _axes_at(tilt, segment.target, 1, 0)
    if segment.arc is None:
        if start != target:
            yield replace(segment, start=start, target=target, tilt=None)
        elif not segment.continues_block:  # rounding had left a distance in the plane
            yield EmptyBlock(segment.source, segment.number)
        return
    first, second, *others = segment.arc
    arc = Arc(int(first), int(second), *others)
    along = axis_arc(tilt.matrix, arc, segment.start, start)
    if along is not None:
        yield replace(segment, start=start, target=target, arc=along.row, tilt=None)
        return
    linear = [index for index, axis in enumerate(environment.axes) if axis.is_linear]
    pieces = [
        piece
        for cubic in cubics_of(segment.start, segment.target, segment.arc, tilt.matrix)
        for piece in cubics.divided(cubic, linear)
    ]
    modifiers = segment.modifiers
    without_end = None if modifiers is None else replace(modifiers, end_feed=0.0)
    for piece in pieces:
        is_last = piece is pieces[-1]
        yield replace(
            segment,
            start=start if piece is pieces[0] else piece[0],
            target=target if is_last else piece[3],
            exact_stop=segment.exact_stop and is_last,
            deviation=0.0,
            arc=None,
            modifiers=modifiers if is_last else without_end,
            continues_block=segment.continues_block or not is_last,
            curve=(*piece[1], *piece[2]),
            tilt=None,
        )


def all_out_of_plane(commands: Iterable[Command], environment: DecoderEnvironment) -> list[Command]:
    """Return motions as the axes make them, and other commands between them."""
    return [piece for command in commands for piece in out_of_plane(command, environment)]


def cubics_of(
    start: Sequence[float], target: Sequence[float], arc: Sequence[float], turn: Matrix
) -> list[Cubic]:
    """Return an arc of a turned system as cubics of the axes' positions.

    ``arc``: as ``Segment.arc``; the axes outside its plane move evenly with the angle.
    """
    first, second = int(arc[0]), int(arc[1])
    travels = [end - begin for begin, end in zip(start, target, strict=True)]
    travels[first] = travels[second] = 0.0
    radius = math.hypot(start[first] - arc[2], start[second] - arc[3])
    count = _count(arc[4] * RADIANS, radius, max(map(abs, travels)))
    step = arc[4] * RADIANS / count
    handle = 4.0 / 3.0 * math.tan(step / 4.0)
    begin = math.atan2(start[second] - arc[3], start[first] - arc[2])

    def point(number: int, ahead: float) -> Point:
        """A point of the arc, or ``ahead`` handles on from it along its tangent."""
        angle = begin + number * step
        position = list(start) if number == 0 else list(target)
        if 0 < number < count:
            position = [
                a + distance * number / count for a, distance in zip(start, travels, strict=True)
            ]
            position[first] = arc[2] + radius * math.cos(angle)
            position[second] = arc[3] + radius * math.sin(angle)
        if ahead:
            position[first] -= ahead * handle * radius * math.sin(angle)
            position[second] += ahead * handle * radius * math.cos(angle)
            for axis, distance in enumerate(travels):
                position[axis] += ahead * handle / step * distance / count
        return tuple(turned_out(turn, position))

    return [
        (point(number, 0), point(number, 1), point(number + 1, -1), point(number + 1, 0))
        for number in range(count)
    ]


def _count(angle: float, radius: float, distance: float) -> int:
    """Return how many cubics keep within the tolerance of an arc; ``angle`` in radians."""
    count = math.ceil(abs(angle) / (MAX_ANGLE * RADIANS) - 1e-9)
    while True:
        count = max(count, 1)
        step = abs(angle) / count
        off = max(_OFF_RADIUS * step**6 * radius, _OFF_WAY * step**4 * distance / count)
        if off <= TOLERANCE_MM:
            return count
        count += 1

# SPDX-License-Identifier: MIT
"""Nested coordinate systems of the program, shifted and rotated: ``#CS`` (MO-8).

A system has an origin for each axis of the channel and a rotation matrix over the first three axes.
Coordinates p with the active offsets s and the tool offset t give the axis positions origin +
matrix * (p + s) + t. The tool offset is not rotated: it acts along the axes.

In: the six components of ``#CS ON``: a shift along three axes in mm and three angles in degrees;
the third turns about the third axis, the second about the resulting second axis, the first about
the resulting first axis. Out: commands for the realtime part, positions inside and outside.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.arcs import PLANES, Arc
from nctakt.decoder.state.commands import Command, SetOrigin, SetTurn
from nctakt.kernel.base import arithmetic

#: The elements of a matrix, row by row.
Matrix = tuple[float, ...]

IDENTITY: Matrix = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)

#: The number of a channel's axes that are rotated, the first ones.
MAIN_AXES = 3

#: Maximum deviation of a plane's normal from an axis (1 - cosine).
ASKEW = 1e-12

SavedOffsets = tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class _OuterSystem:
    """The state outside of a system, restored when it is left."""

    origin: tuple[float, ...]
    matrix: Matrix
    offsets: SavedOffsets


@dataclass(frozen=True, slots=True)
class SuspendedSystems:
    """Systems that are off for a while: the innermost one, and what lies outside of each."""

    origin: tuple[float, ...]
    matrix: Matrix
    outer: tuple[_OuterSystem, ...]


class CoordinateSystems:
    """The active systems of a channel; ``axes``: the numbers of its axes in the machine."""

    def __init__(self, axes: Sequence[int]) -> None:
        self._axes = tuple(axes)
        self._origin = (0.0,) * len(axes)
        self._matrix = IDENTITY
        self._outer: list[_OuterSystem] = []
        self._has_been_active = False

    @property
    def is_active(self) -> bool:
        """Whether a system is on."""
        return bool(self._outer)

    @property
    def count(self) -> int:
        """The number of nested active systems."""
        return len(self._outer)

    def direction(self, axis: int) -> list[float]:
        """Return the direction of an axis of the innermost system, among those of the machine."""
        return list(self._matrix[axis::3])

    @property
    def shift(self) -> tuple[float, ...]:
        """Where the zero of the active system is, by axis, in mm or degrees; 0 without any."""
        return self._origin

    # --- positions ------------------------------------------------------------------------------

    def inside(self, positions: Sequence[float], tool: Sequence[float]) -> list[float]:
        """Return axis positions as coordinates of the active system, including its offsets."""
        coordinates = [
            position - origin - length
            for position, origin, length in zip(positions, self._origin, tool, strict=True)
        ]
        if self._matrix != IDENTITY:
            turned = [_dot(self._matrix[column::3], coordinates[:3]) for column in range(3)]
            coordinates[:3] = turned
        return coordinates

    def outside(self, positions: Sequence[float], tool: Sequence[float]) -> list[float]:
        """Return coordinates of the active system as axis positions, the inverse of ``inside``."""
        coordinates = list(positions)
        if self._matrix != IDENTITY:
            coordinates[:3] = _turned(self._matrix, coordinates[:3])
        return [
            position + origin + length
            for position, origin, length in zip(coordinates, self._origin, tool, strict=True)
        ]

    def arc(self, arc: Arc, inside: Sequence[float], start: Sequence[float]) -> Arc | None:
        """Return an arc of the active system as an arc of the axes; both starts are the same point.

        ``None`` if its plane is askew to the axes.
        """
        normal = sum(range(MAIN_AXES)) - arc.first - arc.second
        column = self._matrix[normal::3]
        normals = [axis for axis in range(3) if abs(column[axis]) > 1.0 - ASKEW]
        if not normals:
            return None
        radius = [0.0, 0.0, 0.0]
        radius[arc.first] = arc.centre_first - inside[arc.first]
        radius[arc.second] = arc.centre_second - inside[arc.second]
        offset = _turned(self._matrix, radius)
        first, second = next(pair for pair in PLANES.values() if normals[0] not in pair)
        angle = arc.angle if column[normals[0]] > 0.0 else -arc.angle
        centre = (start[first] + offset[first], start[second] + offset[second])
        return Arc(first, second, *centre, angle)

    def keeps_plane(self, plane: int) -> bool:
        """Return whether the plane of this G function is that of the axes, seen from the same
        side.
        """
        normal = sum(range(MAIN_AXES)) - sum(PLANES[plane])
        return self._matrix[4 * normal] > 1.0 - ASKEW

    # --- commands -------------------------------------------------------------------------------

    def begin_program(self) -> Iterator[Command]:
        """Yield the commands that deactivate all systems of the previous program."""
        self._outer.clear()
        if self._has_been_active:
            yield from self._activate((0.0,) * len(self._axes), IDENTITY, 0, 0)
        self._has_been_active = False

    def enter(
        self,
        components: Sequence[float],
        shift: Sequence[float],
        kept: SavedOffsets,
        source: int,
        number: int,
    ) -> Iterator[Command]:
        """Activate a system inside the active one; ``shift``: the active offsets."""
        six = (*components, *(0.0,) * (6 - len(components)))
        begin = list(shift)
        for axis in range(3):
            begin[axis] += six[axis]
        begin[:3] = _turned(self._matrix, begin[:3])
        origin = tuple(a + b for a, b in zip(self._origin, begin, strict=True))
        self._outer.append(_OuterSystem(self._origin, self._matrix, kept))
        self._has_been_active = True
        matrix = _product(self._matrix, rotation(six[3], six[4], six[5]))
        yield from self._activate(origin, matrix, source, number)

    def leave(self, source: int, number: int) -> Generator[Command, None, SavedOffsets]:
        """Restore the outer system; return its offsets."""
        outer = self._outer.pop()
        yield from self._activate(outer.origin, outer.matrix, source, number)
        return outer.offsets

    def suspend(self, source: int, number: int) -> Generator[Command, None, SuspendedSystems]:
        """Deactivate all systems for a while; return what ``resume`` activates again."""
        suspended = SuspendedSystems(self._origin, self._matrix, tuple(self._outer))
        if self._outer:
            self._outer.clear()
            yield from self._activate((0.0,) * len(self._axes), IDENTITY, source, number)
        return suspended

    def resume(self, suspended: SuspendedSystems, source: int, number: int) -> Iterator[Command]:
        """Activate the systems that ``suspend`` has deactivated."""
        if suspended.outer:
            self._outer[:] = suspended.outer
            yield from self._activate(suspended.origin, suspended.matrix, source, number)

    def _activate(
        self, origin: tuple[float, ...], matrix: Matrix, source: int, number: int
    ) -> Iterator[Command]:
        self._origin, self._matrix = origin, matrix
        for axis, value in zip(self._axes, origin, strict=True):
            yield SetOrigin(source, number, axis, value)
        first, second, third = self._axes[:3]
        yield SetTurn(source, number, (first, second, third), matrix if self.is_active else ())


def rotation(about_first: float, about_second: float, about_third: float) -> Matrix:
    """Return the rotation matrix of three angles in degrees."""
    a, b = arithmetic.cosine(about_first), arithmetic.sine(about_first)
    c, d = arithmetic.cosine(about_second), arithmetic.sine(about_second)
    e, f = arithmetic.cosine(about_third), arithmetic.sine(about_third)
    third = (e, -f, 0.0, f, e, 0.0, 0.0, 0.0, 1.0)
    second = (c, 0.0, d, 0.0, 1.0, 0.0, -d, 0.0, c)
    first = (1.0, 0.0, 0.0, 0.0, a, -b, 0.0, b, a)
    return _product(_product(third, second), first)


def _turned(matrix: Matrix, vector: Sequence[float]) -> list[float]:
    return [_dot(matrix[3 * row : 3 * row + 3], vector) for row in range(3)]


def _product(left: Matrix, right: Matrix) -> Matrix:
    return tuple(
        _dot(left[3 * row : 3 * row + 3], right[column::3])
        for row in range(3)
        for column in range(3)
    )


def _dot(left: Sequence[float], right: Sequence[float]) -> float:
    return left[0] * right[0] + left[1] * right[1] + left[2] * right[2]

# SPDX-License-Identifier: MIT
"""Coordinate systems of the program: ``#CS``, shifted and turned, one inside the other (MO-8).

A system has an origin for each axis of the channel and, over the first three axes, a matrix. From
its coordinates p with the offsets s that are active in it, and the offset t of the tool, the axes
are at origin + matrix * (p + s) + t. The tool does not turn with it: it acts along the axes.

In: the six components of ``#CS ON``: a shift along three axes in mm, three angles in degrees, of
which the third one turns about the third axis, the second about the second axis as it is then, the
first about the first. Out: commands for the realtime part, positions inside and outside.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.arcs import PLANES, Arc
from nctakt.decoder.state.commands import Command, SetOrigin, SetTurn
from nctakt.kernel.base import arithmetic

#: Numbers of a matrix row by row.
Matrix = tuple[float, ...]

IDENTITY: Matrix = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)

#: The axes of a channel that are turned: its first ones.
MAIN_AXES = 3

#: How far the direction of a plane may be off that of an axis for its arcs to be arcs of the axes.
ASKEW = 1e-12

SavedOffsets = tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class _OuterSystem:
    """What was active outside of a system."""

    origin: tuple[float, ...]
    matrix: Matrix
    offsets: SavedOffsets


class CoordinateSystems:
    """The systems of the programs of one channel; ``axes``: the machine's numbers of its axes."""

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
        """How many are on, one inside the other."""
        return len(self._outer)

    # --- positions ------------------------------------------------------------------------------

    def inside(self, positions: Sequence[float], tool: Sequence[float]) -> list[float]:
        """Positions of the axes as the active system has them, its offsets not taken off."""
        coordinates = [
            position - origin - length
            for position, origin, length in zip(positions, self._origin, tool, strict=True)
        ]
        if self._matrix != IDENTITY:
            turned = [_dot(self._matrix[column::3], coordinates[:3]) for column in range(3)]
            coordinates[:3] = turned
        return coordinates

    def outside(self, positions: Sequence[float], tool: Sequence[float]) -> list[float]:
        """What ``inside`` was made of."""
        coordinates = list(positions)
        if self._matrix != IDENTITY:
            coordinates[:3] = _turned(self._matrix, coordinates[:3])
        return [
            position + origin + length
            for position, origin, length in zip(coordinates, self._origin, tool, strict=True)
        ]

    def arc(self, arc: Arc, inside: Sequence[float], start: Sequence[float]) -> Arc | None:
        """An arc of the active system as one of the axes; both places are those of its start.

        ``None``: its plane lies askew to the axes.
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
        """Whether the plane of this G function is that of the axes, seen from the same side."""
        normal = sum(range(MAIN_AXES)) - sum(PLANES[plane])
        return self._matrix[4 * normal] > 1.0 - ASKEW

    # --- commands -------------------------------------------------------------------------------

    def begin_program(self) -> Iterator[Command]:
        """No system: those of the program before it are gone, whatever was taken of them."""
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
        """Another system inside the active one; ``shift``: the offsets that are active."""
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
        """Back to what was active outside; the offsets of then are the answer."""
        outer = self._outer.pop()
        yield from self._activate(outer.origin, outer.matrix, source, number)
        return outer.offsets

    def _activate(
        self, origin: tuple[float, ...], matrix: Matrix, source: int, number: int
    ) -> Iterator[Command]:
        self._origin, self._matrix = origin, matrix
        for axis, value in zip(self._axes, origin, strict=True):
            yield SetOrigin(source, number, axis, value)
        first, second, third = self._axes[:3]
        yield SetTurn(source, number, (first, second, third), matrix if self.is_active else ())


def rotation(about_first: float, about_second: float, about_third: float) -> Matrix:
    """The matrix of the angles in degrees."""
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

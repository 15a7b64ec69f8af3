# SPDX-License-Identifier: MIT
"""Nested coordinate systems of the program, shifted and rotated: ``#CS``, ``#ACS`` …

The systems of ``#BCS`` are below all of ``#ACS``, which are below all of ``#CS``; those of one kind
lie in the order of their activation, and one of ``#ECS`` is always alone. A system has an origin
for each axis of the channel and a rotation matrix over the first three axes. Coordinates p with the
active offsets s and the tool offset t give the axis positions origin + matrix * (p + s) + t (MO-8).
The tool offset is not rotated: it acts along the axes.

In: the six components of ``#CS ON``: a shift along three axes in mm and three angles in degrees;
the third turns about the third axis, the second about the resulting second axis, the first about
the resulting first axis; in fixed rotation mode (P-CHAN-00393) each about the axis as it was
before all turns. Out: commands for the realtime part, positions inside and outside.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.geometry.arcs import PLANES, SAME_POINT_MM, Arc, cross, dot
from nctakt.decoder.state.queued.commands import Command, SetOrigin, SetTurn
from nctakt.kernel.base import arithmetic

#: The elements of a matrix, row by row.
Matrix = tuple[float, ...]

IDENTITY: Matrix = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)

#: The number of a channel's axes that are rotated, the first ones.
MAIN_AXES = 3

#: Maximum deviation of a plane's normal from an axis (1 - cosine).
ASKEW = 1e-12

#: A tool whose direction is this near to the normal of a plane is perpendicular to it.
UPRIGHT = 1e-9

SavedOffsets = tuple[tuple[float, ...], ...]


#: The kinds of systems, from the bottom up: the command that activates them.
LAYERS = ("BCS", "ACS", "CS", "ECS")


@dataclass(frozen=True, slots=True)
class Placement:
    """Where a system lies in the one below: its shift in mm, its rotation matrix."""

    shift: tuple[float, float, float]
    matrix: Matrix


@dataclass(frozen=True, slots=True)
class LowerOffsets:
    """The offsets of the coordinates below a system, by axis and kind, in mm or degrees.

    ``shift``: their sum by axis without the tool's. ``axis_count``: only those of this many
    axes, counted from the first, start again in the system (P-CHAN-00397).
    """

    values: SavedOffsets
    shift: tuple[float, ...]
    axis_count: int


@dataclass(frozen=True, slots=True)
class ActiveSystem:
    """An active system: its index in ``LAYERS``, where it lies, the offsets below it."""

    layer: int
    placement: Placement
    lower: LowerOffsets


class CoordinateSystems:
    """The active systems of a channel; ``axes``: the numbers of its axes in the machine."""

    def __init__(self, axes: Sequence[int]) -> None:
        self._axes = tuple(axes)
        self._origin = (0.0,) * len(axes)
        self._matrix = IDENTITY
        self._systems: list[ActiveSystem] = []
        self._has_been_active = False
        self._newest: list[float] = []

    @property
    def is_active(self) -> bool:
        """Whether a system is on."""
        return bool(self._systems)

    @property
    def count(self) -> int:
        """The number of active systems of all kinds."""
        return len(self._systems)

    def count_of(self, layer: int) -> int:
        """Return the number of active systems of a kind, an index of ``LAYERS``."""
        return sum(system.layer == layer for system in self._systems)

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
            coordinates = turned_in(self._matrix, coordinates)
        return coordinates

    def outside(self, positions: Sequence[float], tool: Sequence[float]) -> list[float]:
        """Return coordinates of the active system as axis positions, the inverse of ``inside``."""
        coordinates = list(positions)
        if self._matrix != IDENTITY:
            coordinates = turned_out(self._matrix, coordinates)
        return [
            position + origin + length
            for position, origin, length in zip(coordinates, self._origin, tool, strict=True)
        ]

    def arc(self, arc: Arc, inside: Sequence[float], start: Sequence[float]) -> Arc:
        """Return an arc of the active system in coordinates that are not shifted by it.

        They are those of the axes, or turned by ``tilt``. ``inside``: its start in the system;
        ``start``: the same point as the axes have it.
        """
        tilt = self.tilt(next(plane for plane, axes in PLANES.items() if axes == arc.axes))
        if tilt is None:
            found = axis_arc(self._matrix, arc, inside, start)
            assert found is not None
            return found
        begin = turned_in(tilt, start)
        centre = (
            begin[arc.first] + arc.centre_first - inside[arc.first],
            begin[arc.second] + arc.centre_second - inside[arc.second],
        )
        return Arc(*arc.axes, *centre, arc.angle)

    def tilt(self, plane: int) -> Matrix | None:
        """Return the matrix of the active system if it tilts the plane of this G function."""
        return None if self.keeps_plane(plane) else self._matrix

    def into(self, tilt: Matrix, positions: Sequence[float]) -> list[float]:
        """Return positions of the axes in a tilted plane.

        A coordinate that changes only by rounding from one position to the next is kept.
        """
        turned = turned_in(tilt, positions)
        if len(self._newest) == len(turned):
            turned = [
                before if abs(position - before) < SAME_POINT_MM else position
                for position, before in zip(turned, self._newest, strict=True)
            ]
        self._newest = turned
        return turned

    def keeps_plane(self, plane: int) -> bool:
        """Return whether the plane of this G function is that of the axes, seen from the same
        side.
        """
        normal = sum(range(MAIN_AXES)) - sum(PLANES[plane])
        return self._matrix[4 * normal] > 1.0 - ASKEW

    def placement(self) -> Placement:
        """Return the innermost system as one that lies where all active ones do.

        It is the same place for a system that is activated alone, with the same offsets below.
        """
        lower = self._systems[0].lower.shift if self._systems else (0.0,) * MAIN_AXES
        first, second, third = (self._origin[axis] - lower[axis] for axis in range(MAIN_AXES))
        return Placement((first, second, third), self._matrix)

    # --- commands -------------------------------------------------------------------------------

    def begin_program(self) -> Iterator[Command]:
        """Yield the commands that deactivate all systems of the previous program."""
        self._systems.clear()
        if self._has_been_active:
            yield from self._activate(0, 0)
        self._has_been_active = False

    def enter(
        self, layer: int, placement: Placement, lower: LowerOffsets, source: int, number: int
    ) -> Generator[Command, None, bool]:
        """Activate a system above those of its kind; return whether it is the innermost one.

        ``lower``: the active offsets, which the innermost system takes. Between others a system
        takes those of the system above, which then begins at its origin.
        """
        index = sum(system.layer <= layer for system in self._systems)
        is_innermost = index == len(self._systems)
        if not is_innermost:
            above = self._systems[index]
            values = tuple((0.0,) * len(axis) for axis in above.lower.values)
            without = replace(above.lower, values=values, shift=(0.0,) * len(self._axes))
            self._systems[index], lower = replace(above, lower=without), above.lower
        self._systems.insert(index, ActiveSystem(layer, placement, lower))
        self._has_been_active = True
        yield from self._activate(source, number)
        return is_innermost

    def leave(
        self, layer: int, source: int, number: int
    ) -> Generator[Command, None, LowerOffsets | None]:
        """Deactivate the last system of a kind; return the offsets below it.

        ``None`` if it is not the innermost one: its offsets are lost, the active ones stay.
        """
        index = sum(system.layer <= layer for system in self._systems) - 1
        left = self._systems.pop(index)
        is_innermost = index == len(self._systems)
        if not is_innermost:
            self._systems[index] = replace(self._systems[index], lower=left.lower)
        yield from self._activate(source, number)
        return left.lower if is_innermost else None

    def suspend(self, source: int, number: int) -> Generator[Command, None, list[ActiveSystem]]:
        """Deactivate all systems for a while; return what ``resume`` activates again."""
        suspended = list(self._systems)
        if suspended:
            self._systems.clear()
            yield from self._activate(source, number)
        return suspended

    def resume(
        self, suspended: Sequence[ActiveSystem], source: int, number: int
    ) -> Iterator[Command]:
        """Activate the systems that ``suspend`` has deactivated."""
        if suspended:
            self._systems[:] = suspended
            yield from self._activate(source, number)

    def _activate(self, source: int, number: int) -> Iterator[Command]:
        """Compute the innermost system from all; yield the commands that activate it."""
        origin, matrix = (0.0,) * len(self._axes), IDENTITY
        for system in self._systems:
            begin = list(system.lower.shift)
            for axis in range(MAIN_AXES):
                begin[axis] += system.placement.shift[axis]
            begin[:3] = _turned(matrix, begin[:3])
            origin = tuple(a + b for a, b in zip(origin, begin, strict=True))
            matrix = _product(matrix, system.placement.matrix)
        self._origin, self._matrix = origin, matrix
        for axis, value in zip(self._axes, origin, strict=True):
            if axis >= 0:  # an axis is at the place
                yield SetOrigin(source, number, axis, value)
        first, second, third = self._axes[:3]
        yield SetTurn(source, number, (first, second, third), matrix if self.is_active else ())


def placement_of(components: Sequence[float], *, is_fixed: bool = False) -> Placement:
    """Return where a system of up to six components lies; ``is_fixed``: P-CHAN-00393."""
    first, second, third, *angles = (*components, *(0.0,) * (6 - len(components)))
    about_first, about_second, about_third = angles
    a, b = arithmetic.cosine(about_first), arithmetic.sine(about_first)
    c, d = arithmetic.cosine(about_second), arithmetic.sine(about_second)
    e, f = arithmetic.cosine(about_third), arithmetic.sine(about_third)
    turn_third = (e, -f, 0.0, f, e, 0.0, 0.0, 0.0, 1.0)
    turn_second = (c, 0.0, d, 0.0, 1.0, 0.0, -d, 0.0, c)
    turn_first = (1.0, 0.0, 0.0, 0.0, a, -b, 0.0, b, a)
    outer, inner = (turn_first, turn_third) if is_fixed else (turn_third, turn_first)
    return Placement((first, second, third), _product(_product(outer, turn_second), inner))


def axis_arc(
    matrix: Matrix, arc: Arc, inside: Sequence[float], start: Sequence[float]
) -> Arc | None:
    """Return an arc of a turned system as an arc of the axes; both starts are the same point.

    ``None`` if its plane is askew to the axes.
    """
    normal = sum(range(MAIN_AXES)) - arc.first - arc.second
    column = matrix[normal::3]
    normals = [axis for axis in range(3) if abs(column[axis]) > 1.0 - ASKEW]
    if not normals:
        return None
    radius = [0.0, 0.0, 0.0]
    radius[arc.first] = arc.centre_first - inside[arc.first]
    radius[arc.second] = arc.centre_second - inside[arc.second]
    offset = _turned(matrix, radius)
    first, second = next(pair for pair in PLANES.values() if normals[0] not in pair)
    angle = arc.angle if column[normals[0]] > 0.0 else -arc.angle
    centre = (start[first] + offset[first], start[second] + offset[second])
    return Arc(first, second, *centre, angle)


def turned_in(matrix: Matrix, positions: Sequence[float]) -> list[float]:
    """Return positions in a system that is turned by a matrix, the inverse of ``turned_out``."""
    return [*(dot(matrix[column::3], positions[:3]) for column in range(3)), *positions[3:]]


def turned_out(matrix: Matrix, positions: Sequence[float]) -> list[float]:
    """Return positions of a system that is turned by a matrix as those outside it."""
    return [*_turned(matrix, positions[:3]), *positions[3:]]


def effector_placement(
    direction: Sequence[float], plane: tuple[int, int], *, has_first_there: bool
) -> Placement:
    """Return where a system lies whose third axis is the direction of the tool.

    Its first axis, or else its second one, lies in a plane of two axes of the machine; the other
    one is on the same side of that plane as the tool (P-CHAN-00031, P-CHAN-00050).
    """
    across = [0.0, 0.0, 0.0]
    normal = sum(range(MAIN_AXES)) - sum(plane)
    across[normal] = -1.0 if direction[normal] < 0.0 else 1.0
    along = cross(across, direction) if has_first_there else cross(direction, across)
    length = arithmetic.square_root(dot(along, along))
    if length < UPRIGHT:
        named = 0 if has_first_there else 1
        along, length = [0.0, 0.0, 0.0], 1.0
        along[named if named in plane else plane[named]] = 1.0
    along = [part / length for part in along]
    if has_first_there:
        first, second = along, cross(direction, along)
    else:
        first, second = cross(along, direction), along
    matrix = tuple(axis[row] for row in range(3) for axis in (first, second, direction))
    return Placement((0.0, 0.0, 0.0), matrix)


def _turned(matrix: Matrix, vector: Sequence[float]) -> list[float]:
    return [dot(matrix[3 * row : 3 * row + 3], vector) for row in range(3)]


def _product(left: Matrix, right: Matrix) -> Matrix:
    return tuple(
        dot(left[3 * row : 3 * row + 3], right[column::3])
        for row in range(3)
        for column in range(3)
    )

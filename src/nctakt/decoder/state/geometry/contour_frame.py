# SPDX-License-Identifier: MIT
"""Conversion of programmed coordinates before any offset: scaling, rotation, mirroring.

In: ``#SCALE``, ``#ROTATION``, G68, G20 … G23, G351. Out: coordinates of the active system without
its offsets, and back. The order is scaling of the program's axes about their zero, rotation in the
plane, mirroring. Lengths are mm, angles degrees.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.kernel.base import arithmetic

Pair = tuple[float, float]
#: Components by axis.
Vector = tuple[tuple[int, float], ...]


@dataclass(slots=True)
class ContourFrame:
    """The map of one program; axes by their index in the channel.

    ``mirrored``: axes with the opposite sign. ``factors``: of ``#SCALE``, by axis, which act while
    ``is_scaled``. ``angle_deg``, ``centre``: the rotation from the first to the second of ``axes``,
    which acts while ``is_turned``.
    """

    mirrored: frozenset[int] = frozenset()
    factors: dict[int, float] = field(default_factory=dict)
    is_scaled: bool = False
    is_turned: bool = False
    angle_deg: float = 0.0
    centre: Pair = (0.0, 0.0)
    axes: tuple[int, int] = (0, 1)

    @property
    def is_active(self) -> bool:
        """Whether it changes anything at all."""
        return bool(self.mirrored) or self.is_scaled or self.is_turned

    def adopt(self, other: ContourFrame) -> None:
        """Become a copy of another map."""
        self.mirrored = other.mirrored
        self.factors = dict(other.factors)
        self.is_scaled = other.is_scaled
        self.is_turned = other.is_turned
        self.angle_deg = other.angle_deg
        self.centre = other.centre
        self.axes = other.axes

    def moved_with(self, axis: int) -> tuple[int, ...]:
        """Return the axes that a value of this axis may move."""
        return self.axes if self.is_turned and axis in self.axes else (axis,)

    def factor(self, axis: int) -> float:
        """Return the factor of an axis."""
        return self.factors.get(axis, 1.0) if self.is_scaled else 1.0

    def factor_in(self, plane: tuple[int, int]) -> float | None:
        """Return the factor of a radius in a plane; ``None`` if its axes have different ones."""
        first, second = map(self.factor, plane)
        return first if first == second else None

    def reverses(self, plane: tuple[int, int]) -> bool:
        """Return whether arcs in a plane turn the other way: one of its axes is mirrored."""
        return (plane[0] in self.mirrored) is not (plane[1] in self.mirrored)

    # --- coordinates ----------------------------------------------------------------------------

    def outside(self, programmed: Sequence[float]) -> list[float]:
        """Return the coordinates of a programmed position."""
        positions = [value * self.factor(axis) for axis, value in enumerate(programmed)]
        if self.is_turned:
            self._turn(positions, self.angle_deg)
        return self.unmirrored(positions)

    def inside(self, positions: Sequence[float]) -> list[float]:
        """Return how a position would be programmed, the inverse of ``outside``."""
        programmed = self.unmirrored(positions)
        if self.is_turned:
            self._turn(programmed, -self.angle_deg)
        return [value / self.factor(axis) for axis, value in enumerate(programmed)]

    def unmirrored(self, positions: Sequence[float]) -> list[float]:
        """Return positions with the opposite signs in mirrored axes."""
        return [-value if axis in self.mirrored else value for axis, value in enumerate(positions)]

    def direction(self, plane: tuple[int, int], programmed: Pair) -> Pair:
        """Return a programmed vector in a plane as a vector of coordinates."""
        begin, end = (self.point(plane, pair) for pair in ((0.0, 0.0), programmed))
        return (end[0] - begin[0], end[1] - begin[1])

    def vector(self, programmed: Vector, count: int) -> Vector:
        """Return a programmed vector, of ``count`` axes at most, as one of coordinates."""
        values = [0.0] * count
        for axis, value in programmed:
            values[axis] = value
        begin, end = self.outside([0.0] * count), self.outside(values)
        moved = {other for axis, _ in programmed for other in self.moved_with(axis)}
        return tuple((axis, end[axis] - begin[axis]) for axis in sorted(moved))

    def point(self, plane: tuple[int, int], programmed: Pair) -> Pair:
        """Return a programmed point of a plane as coordinates."""
        values = [0.0] * (max(*plane, *self.axes) + 1)
        values[plane[0]], values[plane[1]] = programmed
        values = self.outside(values)
        return (values[plane[0]], values[plane[1]])

    def _turn(self, values: list[float], angle_deg: float) -> None:
        first, second = self.axes
        sine, cosine = arithmetic.sine(angle_deg), arithmetic.cosine(angle_deg)
        x, y = values[first] - self.centre[0], values[second] - self.centre[1]
        values[first] = self.centre[0] + cosine * x - sine * y
        values[second] = self.centre[1] + sine * x + cosine * y

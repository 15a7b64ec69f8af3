# SPDX-License-Identifier: MIT
"""The coordinate systems: what lies between ACS, MCS and PCS for each axis (MO-8).

A position in PCS is the position in ACS less all active offsets of the axis, in mm or degrees. In a
coordinate system of the program (``#CS``) three axes belong together: ACS is its origin and the
tool's offset, and the position in PCS with the other offsets, turned by its matrix.
Without a transformation MCS and IPO are ACS. Each axis has one offset of each of the kinds that
``X[INDP OFFSET=…]`` names (RC-407), in that order.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base.bounds import check_index

# Kinds of offsets.
ZERO = 0
ADD_ZERO = 1
PSET = 2
CLAMP = 3
TOOL = 4
MEASURE = 5
MANUAL = 6

#: How many kinds there are.
KINDS = 7


class Offsets:
    """The offsets of ``count`` axes."""

    def __init__(self, count: int) -> None:
        self.count = count
        self.values = memoryview(bytearray(8 * 7 * count)).cast("d")
        self.program = memoryview(bytearray(8 * count)).cast("d")
        self.origin = memoryview(bytearray(8 * count)).cast("d")

    def set(self, axis: int, kind: int, value: float) -> None:
        """One offset of an axis gets another value."""
        self.values[axis * 7 + kind] = value
        self.program[axis] = self.sum_of(axis, 127) + self.origin[axis]

    def set_origin(self, axis: int, value: float) -> None:
        """Where the coordinate system of the program begins on this axis."""
        self.origin[axis] = value
        self.program[axis] = self.sum_of(axis, 127) + value

    def outer(self, axis: int) -> float:
        """What lies outside of the turned system: its origin, the tool."""
        return self.origin[axis] + self.values[axis * 7 + 4]

    def inner(self, axis: int) -> float:
        """What lies inside of the turned system: the offsets but the tool's."""
        return self.sum_of(axis, 111)

    def sum_of(self, axis: int, kinds: int) -> float:
        """The sum of an axis' offsets of these kinds: bit k stands for kind k."""
        total = 0.0
        for kind in range(7):
            if kinds >> kind & 1:
                total += self.values[axis * 7 + kind]
        return total

    def of(self, axis: int, kinds: int) -> float:
        """``sum_of`` for Python's side."""
        check_index(axis, self.count, "axis")
        return self.sum_of(axis, kinds)


class Turns:
    """Turned coordinate systems over three of ``count`` axes each, by the first of the three."""

    def __init__(self, count: int) -> None:
        self.active = 0
        self.second = memoryview(bytearray(8 * count)).cast("q")
        self.third = memoryview(bytearray(8 * count)).cast("q")
        self.matrix = memoryview(bytearray(8 * 9 * count)).cast("d")

    def set(self, row: memoryview[float], base: int) -> None:
        """Take the turn of the command at ``base``."""
        first = int(row[base + rows.TURN_FIRST])
        before = 1 if self.second[first] else 0
        self.second[first] = int(row[base + rows.TURN_SECOND])
        self.third[first] = int(row[base + rows.TURN_THIRD])
        self.active += (1 if self.second[first] else 0) - before
        for i in range(9):
            self.matrix[9 * first + i] = row[base + rows.TURN_MATRIX + i]

# SPDX-License-Identifier: MIT
"""The coordinate systems: offsets between ACS, MCS and PCS for each axis (MO-8).

A position in PCS is the position in ACS less all active offsets of the axis, in mm or degrees. In a
coordinate system of the program (``#CS``) three axes belong together: ACS is its origin and the
tool's offset, and the position in PCS with the other offsets, turned by its matrix.
Without a transformation MCS and IPO are ACS. Each axis has one offset of each of the kinds
in ``codes.py``.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index, check_size


class Offsets:
    """The offsets of ``count`` axes."""

    def __init__(self, count: int) -> None:
        check_size(count, "number of axes")
        self.count = count
        self.values = doubles(codes.OFFSET_KINDS * count)
        self.program = doubles(count)
        self.origin = doubles(count)

    def set(self, axis: int, kind: int, value: float) -> None:
        """Set one offset of an axis, in mm or degrees."""
        self.values[axis * codes.OFFSET_KINDS + kind] = value
        self.program[axis] = self.sum_of(axis, codes.ALL_OFFSETS) + self.origin[axis]

    def set_origin(self, axis: int, value: float) -> None:
        """Set the origin of the program's coordinate system on an axis, in mm or degrees."""
        self.origin[axis] = value
        self.program[axis] = self.sum_of(axis, codes.ALL_OFFSETS) + value

    def outer(self, axis: int) -> float:
        """Offsets outside of the turned system: its origin and the tool."""
        return self.origin[axis] + self.values[axis * codes.OFFSET_KINDS + codes.TOOL_OFFSET]

    def inner(self, axis: int) -> float:
        """Offsets inside of the turned system: all but the tool's."""
        return self.sum_of(axis, codes.OFFSETS_BUT_TOOL)

    def sum_of(self, axis: int, kinds: int) -> float:
        """Sum of an axis' offsets of these kinds: bit k means kind k."""
        total = 0.0
        for kind in range(codes.OFFSET_KINDS):
            if kinds >> kind & 1:
                total += self.values[axis * codes.OFFSET_KINDS + kind]
        return total

    def of(self, axis: int, kinds: int) -> float:
        """Sum of an axis' offsets; raise ``ValueError`` for an unknown axis."""
        check_index(axis, self.count, "axis")
        return self.sum_of(axis, kinds)


class Turns:
    """Turned coordinate systems over three of ``count`` axes each, by the first of the three."""

    def __init__(self, count: int) -> None:
        self.active = 0
        self.second = integers(count)
        self.third = integers(count)
        self.matrix = doubles(rows.MATRIX_SIZE * count)

    def set(self, queue: memoryview[float], row: int) -> None:
        """Take the turn of the command at ``row``."""
        first = int(queue[row + rows.TURN_FIRST])
        before = 1 if self.second[first] else 0
        self.second[first] = int(queue[row + rows.TURN_SECOND])
        self.third[first] = int(queue[row + rows.TURN_THIRD])
        self.active += (1 if self.second[first] else 0) - before
        for i in range(rows.MATRIX_SIZE):
            self.matrix[rows.MATRIX_SIZE * first + i] = queue[row + rows.TURN_MATRIX + i]

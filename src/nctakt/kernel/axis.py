# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""The machine's axes: command, actual and target position, and what cycles read of them.

Arrays over the axes, since the tick walks over all of them. Each axis has a row of cells in the
memory, in the order of ``nc/names.py`` (``AXIS_VARIABLES``): positions in ACS, MCS, PCS and IPO
(RC-304). PCS differs by the offsets in ``coordinates.py``. The simulated drive follows at
once: actual position = command position (MO-15).
"""

from __future__ import annotations

from nctakt.kernel.coordinates import Offsets


class Axes:
    """``count`` axes whose cells begin at ``first_cell``."""

    def __init__(self, memory: bytearray, first_cell: int, count: int) -> None:
        self.cells = memoryview(memory).cast("d")
        self.first_cell = first_cell
        self.count = count
        self.command = memoryview(bytearray(8 * count)).cast("d")
        self.actual = memoryview(bytearray(8 * count)).cast("d")
        self.target = memoryview(bytearray(8 * count)).cast("d")
        self.offsets = Offsets(count)
        self.has_moved = True

    def begin_tick(self) -> None:
        """Read actual positions; the CYCLE overrides are 100 % again (RC-305)."""
        for i in range(self.count):
            self.actual[i] = self.command[i]
            self.cells[self.first_cell + i * 20 + 15] = 100.0

    def publish(self) -> None:
        """Write what cycles, decoder and trace read."""
        if not self.has_moved:
            return
        self.has_moved = False
        for i in range(self.count):
            base = self.first_cell + i * 20
            self.cells[base] = self.command[i]
            self.cells[base + 1] = self.command[i]
            self.cells[base + 2] = self.target[i]
            self.publish_system(i, base + 3, 0.0)
            self.publish_system(i, base + 7, self.offsets.program[i])
            self.publish_system(i, base + 11, 0.0)

    def publish_system(self, i: int, base: int, offset: float) -> None:
        """Command, actual and target position and distance to go in one system."""
        self.cells[base] = self.command[i] - offset
        self.cells[base + 1] = self.command[i] - offset
        self.cells[base + 2] = self.target[i] - offset
        self.cells[base + 3] = self.target[i] - self.command[i]

    def set_offset(self, axis: int, kind: int, value: float) -> None:
        """Another offset is active: the positions in PCS differ from now on (MO-8)."""
        self.offsets.set(axis, kind, value)
        self.has_moved = True
        self.publish()

    def publish_all(self) -> None:
        """``publish`` before the first tick."""
        self.has_moved = True
        self.publish()

    def shift(self, index: int, kind: int, value: float) -> None:
        """``set_offset`` for Python's side: before the first tick."""
        self.set_offset(index, kind, value)

    def positions(self) -> list[float]:
        """The command positions: for Python's side."""
        return [self.command[i] for i in range(self.count)]

    def place(self, index: int, position: float) -> None:
        """Set one axis to a position without a motion: before the first tick."""
        self.command[index] = position
        self.actual[index] = position
        self.target[index] = position
        self.publish_all()

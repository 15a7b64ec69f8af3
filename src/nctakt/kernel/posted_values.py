# SPDX-License-Identifier: MIT
"""Values that Python posts between two runs: the next tick latches them (RC-002)."""

from __future__ import annotations

from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_range


class PostedValues:
    """The posted values, each with the cell of the memory that it is for.

    ``slots``: for each cell of the memory, where its value may be.
    """

    def __init__(self, memory: bytearray) -> None:
        self.memory = memoryview(memory).cast("q")
        self.present_cells = memoryview(memory).cast("d")
        self.count = 0
        self.capacity = 0
        self.cells = integers(1)
        self.words = integers(1)
        self.slots = memoryview(bytearray(len(memory))).cast("q")
        self.make_room(16)

    def check_cell(self, cell: int) -> None:
        """Raise ``ValueError`` unless ``cell`` is one of the memory."""
        check_range(cell, 0, len(self.memory) - 1, "cell")

    def post(self, cell: int, value: float) -> None:
        """Post a value, which the next tick latches."""
        self.check_cell(cell)
        self.put(cell, value)

    def put(self, cell: int, value: float) -> None:
        """Post a value for a cell that is one of the memory."""
        slot = self.slot_for(cell)
        self.values[slot] = value

    def post_bytes(self, cell: int, data: bytes) -> None:
        """Post a character string that fills whole cells from ``cell`` on."""
        words = memoryview(data).cast("q")
        check_range(cell, 0, len(self.memory) - len(words), "cell")
        for i, word in enumerate(words):
            slot = self.slot_for(cell + i)
            self.words[slot] = word

    def slot_of(self, cell: int) -> int:
        """Slot of a cell; -1 if nothing is posted for it."""
        slot = self.slots[cell]
        return slot if slot < self.count and self.cells[slot] == cell else -1

    def slot_for(self, cell: int) -> int:
        """Slot of a cell, a new one if it has none."""
        slot = self.slot_of(cell)
        if slot >= 0:
            return slot
        slot = self.count
        if slot == self.capacity:
            self.make_room(2 * slot)
        self.cells[slot] = cell
        self.slots[cell] = slot
        self.count = slot + 1
        return slot

    def present(self, cell: int) -> float:
        """Value of a cell of the memory; a posted value counts even before it is latched."""
        slot = self.slot_of(cell)
        return self.present_cells[cell] if slot < 0 else self.values[slot]

    def present_bytes(self, cell: int, count: int) -> bytes:
        """Bytes of ``count`` cells; those that are posted count before they are latched."""
        check_range(cell, 0, len(self.memory) - count, "cell")
        words = integers(count)
        for i in range(count):
            slot = self.slot_of(cell + i)
            words[i] = self.memory[cell + i] if slot < 0 else self.words[slot]
        return bytes(words)

    def make_room(self, count: int) -> None:
        """Make room for ``count`` cells."""
        posted = [(self.cells[i], self.words[i]) for i in range(self.count)]
        self.capacity = count
        memory = memoryview(bytearray(8 * count))
        self.cells = integers(count)
        self.words = memory.cast("q")
        self.values = memory.cast("d")
        for i, (cell, word) in enumerate(posted):
            self.cells[i] = cell
            self.words[i] = word

    def latch(self) -> None:
        """Put the posted values into the memory."""
        for i in range(self.count):
            self.memory[self.cells[i]] = self.words[i]
        self.count = 0

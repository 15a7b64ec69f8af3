# SPDX-License-Identifier: MIT
"""Character strings and structures in realtime cycles: compared, assigned, copied.

A string is a row of bytes that ends with its first zero byte; each operation goes through as many
bytes as the longer variable has, at most, and needs no additional memory. After the text the target
of an assignment has zeros only. A structure or array is copied leaf by leaf.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_cells, check_range, check_size
from nctakt.kernel.cycles import instructions
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.cycles.instructions import Counted


class CellRange(Expression):
    """A variable of ``count`` cells from ``cell`` on, offset by the value of ``index``.

    ``value`` is its first cell; an index outside its array is a fault, noted in the context.
    ``span`` are the cells of all elements that the index may choose.
    """

    def __init__(self, memory: memoryview, cell: int, span: int, index: Expression) -> None:
        check_size(span, "span")
        check_cells(cell, span, memory)
        self.cell = cell
        self.index = index

    def value(self, context: Context) -> float:
        return self.cell + self.index.value(context)


class Text:
    """A string of ``size`` bytes at ``cell_range``; a constant has its own memory."""

    def __init__(self, memory: memoryview, cell_range: CellRange, size: int) -> None:
        check_range(size, 1, len(memory), "size")
        self.characters = memoryview(memory)
        self.cell_range = cell_range
        self.size = size


def character(text: Text, first: int, number: int) -> int:
    """Return a byte of a string, whose bytes begin at ``first``; 0 after the last one."""
    if number >= text.size:
        return 0
    return text.characters[first + number]


class CompareTexts(Expression):
    """``==`` of two texts, or ``!=``: whether all characters up to the first zero are equal."""

    def __init__(self, left: Text, right: Text, is_equal: bool) -> None:
        self.left = left
        self.right = right
        self.is_equal = is_equal
        self.count = max(left.size, right.size)

    def value(self, context: Context) -> float:
        left = int(self.left.cell_range.value(context))
        right = int(self.right.cell_range.value(context))
        if context.fault:
            return 0.0
        for i in range(self.count):
            byte = character(self.left, 8 * left, i)
            if byte != character(self.right, 8 * right, i):
                return 0.0 if self.is_equal else 1.0
            if byte == 0:
                break
        return 1.0 if self.is_equal else 0.0


def assign(
    statement: Counted,
    context: Context,
    target: memoryview[int],
    to: int,
    source: memoryview[int],
    from_: int,
    size: int,
) -> None:
    """Copy a text of at most ``size`` bytes between two cells; a new one is recorded."""
    length = 0
    first, first_read = 8 * to, 8 * from_
    while length < size and source[first_read + length] != 0:
        length += 1
    is_new = False
    for i in range(size):
        byte = source[first_read + i] if i < length else 0
        if target[first + i] != byte:
            target[first + i] = byte
            is_new = True
    if is_new and context.record.records_writes:
        report(statement, context, target, to, length)


def report(
    statement: Counted, context: Context, characters: memoryview[int], cell: int, length: int
) -> None:
    """Record a new text in parts of twelve characters, six in each column of an event."""
    number = 0
    done = 0
    while number == 0 or done < length:
        half = done + rows.TEXT_HALF
        left = packed(characters, 8 * cell, done, min(half, length))
        right = packed(characters, 8 * cell, half, min(half + rows.TEXT_HALF, length))
        done = half + rows.TEXT_HALF
        parts = 2 * number + 1 if done < length else 2 * number
        name = cell + parts * rows.TEXT_PART
        context.record.event(
            rows.EVENT_WRITTEN_TEXT, statement.source, context.serial, name, left, right
        )
        number += 1


def packed(characters: memoryview[int], first: int, start: int, end: int) -> float:
    """Return the characters from ``start`` to ``end`` as a number to the base 256."""
    number = 0.0
    for i in range(start, end):
        number = 256.0 * number + characters[first + i]
    return number


class AssignText(Counted):
    """``v = text``, for a constant that fits or a string of the same length."""

    def __init__(self, target: Text, text: Text, source: int, cost: int) -> None:
        super().__init__(source, cost)
        check_range(text.size, target.size, target.size, "size of the text")
        self.target = target
        self.text = text

    def run(self, context: Context) -> int:
        if instructions.begin(self, context):
            return 1
        to = int(self.target.cell_range.value(context))
        from_ = int(self.text.cell_range.value(context))
        if context.fault:
            return instructions.stop(self, context)
        size = self.target.size
        assign(self, context, self.target.characters, to, self.text.characters, from_, size)
        return 0


class Copy(Counted):
    """``a = b`` of two structures or arrays of one type, leaf by leaf.

    ``leaves``: for each number and string in it the first cell, counted from the start, the bytes
    of a string or 0, and whether it is read in each tick; the others have their values in
    ``frozen``, as large as the variable. Both indices are evaluated once, before anything is
    copied.
    """

    def __init__(
        self,
        target: CellRange,
        value: CellRange,
        memory: memoryview,
        frozen: memoryview,
        leaves: list[tuple[int, int, bool]],
        source: int,
        cost: int,
    ) -> None:
        super().__init__(source, cost)
        self.target = target
        self.value = value
        self.characters = memoryview(memory)
        self.frozen_characters = memoryview(frozen)
        self.frozen = memoryview(frozen).cast("d")
        self.count = len(leaves)
        self.leaf_cell = integers(max(1, len(leaves)))
        self.leaf_size = integers(max(1, len(leaves)))
        self.leaf_is_live = memoryview(bytearray(max(1, len(leaves))))
        for i, (cell, size, is_live) in enumerate(leaves):
            check_cells(cell, max(1, -(-size // 8)), frozen)
            self.leaf_cell[i] = cell
            self.leaf_size[i] = size
            self.leaf_is_live[i] = is_live

    def run(self, context: Context) -> int:
        if instructions.begin(self, context):
            return 1
        to = int(self.target.value(context))
        from_ = int(self.value.value(context))
        if context.fault:
            return instructions.stop(self, context)
        for i in range(self.count):
            cell = self.leaf_cell[i]
            size = self.leaf_size[i]
            is_live = self.leaf_is_live[i]
            if size > 0:
                self.copy_text(context, to + cell, from_ + cell if is_live else -1 - cell, size)
            elif is_live:
                instructions.write(self, context, to + cell, context.cells[from_ + cell])
            else:
                instructions.write(self, context, to + cell, self.frozen[cell])
        return 0

    def copy_text(self, context: Context, to: int, from_: int, size: int) -> None:
        """Copy a string of the source, or a frozen one: its cell is ``-1 - from_`` there."""
        if from_ >= 0:
            assign(self, context, self.characters, to, self.characters, from_, size)
        else:
            assign(self, context, self.characters, to, self.frozen_characters, -1 - from_, size)

# SPDX-License-Identifier: MIT
"""What led to a change of a variable: conditions with their values, kept while a cycle runs.

Conditions, operands and calls put rows of a number and a value on a stack; a statement's rows leave
it when the statement is over, those of a call that led to its result stay until the calling
statement is over. When a watched variable changes, the rows on the stack are copied into the log
(ST-840), which keeps the newest changes of each. Without watches nothing of this runs.
"""

from __future__ import annotations

from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, words


class Notes:
    """The stack of rows, the watched variables, and the log of their changes.

    ``watched`` has for each byte of the memory the number of the watch that it belongs to, from 1
    on, or 0; ``whole`` is the number of bytes of a watch, 0 where some belong to an earlier one.
    A change in the log: watch, time in ns, source (0: not by a statement), value before, value
    after, number of rows, whether rows are missing (``kinds.NOTES_CUT``) or the value before is
    not known (``kinds.NOTES_FIRST``), which change of the watch it is, from 1 on; then the rows.
    ``logged`` counts for each watch the changes in the log, those that have left it included, and
    ``missed`` those for which it had no room. It is crowded (``is_crowded``) while little is left
    to drop; then Python takes it between two ticks.
    """

    def __init__(self, size: int) -> None:
        check_range(size, 0, kinds.MAX_MEMORY, "size")
        self.is_on = size > 0
        rows = kinds.NOTE_ROWS if size else 0
        watches = kinds.MAX_WATCHES if size else 0
        self.top = 0
        self.kept = 0
        self.loop = 0
        self.numbers = integers(rows + 1)
        values = bytearray(8 * rows + 8)
        self.values = memoryview(values).cast("q")
        self.reals = memoryview(values).cast("d")
        self.watched = memoryview(bytearray(4 * size + 4)).cast("i")
        self.count = 0
        self.interface_from = 0
        self.address = integers(watches + 1)
        self.kind = integers(watches + 1)
        self.whole = integers(watches + 1)
        self.is_new = integers(watches + 1)
        self.seen = integers(watches + 1)
        self.written_at = integers(watches + 1)
        self.written_by = integers(watches + 1)
        self.missed = integers(watches + 1)
        self.logged = integers(watches + 1)
        self.log_size = kinds.NOTE_LOG if size else 0
        self.log = integers(self.log_size + 1)
        self.log_end = 0
        self.is_crowded = False

    def begin(self) -> None:
        """Begin a cycle: nothing has led anywhere yet."""
        self.top = 0
        self.kept = 0
        self.loop = 0

    def push(self, number: int, value: int) -> None:
        """Put a row on the stack; rows that have no room are counted."""
        if self.top < kinds.NOTE_ROWS:
            self.numbers[self.top] = number
            self.values[self.top] = value
        self.top += 1

    def push_real(self, number: int, value: float) -> None:
        """Put a row with a real number on the stack."""
        if self.top < kinds.NOTE_ROWS:
            self.numbers[self.top] = number
            self.reals[self.top] = value
        self.top += 1

    def leave(self, begin: int) -> None:
        """Take the rows of a statement off, unless some of them led to a result."""
        if self.kept > begin:
            self.push(kinds.NOTE_CLOSED, begin)
        else:
            self.top = begin

    def add(self, memory: memoryview, address: int, kind: int) -> int:
        """Start to watch a variable; return its number, or 0 if the table is full."""
        if self.count >= kinds.MAX_WATCHES:
            return 0
        self.count += 1
        self.address[self.count] = address
        self.is_new[self.count] = 0
        self.kind[self.count] = kind
        self.seen[self.count] = self.bits(memory, address, kind)
        self.written_at[self.count] = -1
        self.whole[self.count] = width(kind)
        for i in range(width(kind)):
            if self.watched[address + i] == 0:
                self.watched[address + i] = self.count
            else:
                self.whole[self.count] = 0
        return self.count

    def bits(self, memory: memoryview, address: int, kind: int) -> int:
        """Return the value of a variable, of a real number its bits."""
        if kind == kinds.F32:
            return words.load(memory, address, kinds.U32)
        if kind == kinds.F64:
            return words.load(memory, address, kinds.I64)
        return words.load(memory, address, kind)

    def watch(self, memory: memoryview, address: int, kind: int) -> int:
        """Watch a variable for Python's side."""
        check_range(kind, kinds.BOOL, kinds.F64, "kind")
        check_range(address, kinds.NULL_BYTES, len(self.watched) - 9, "address")
        return self.add(memory, address, kind)

    def note(self, memory: memoryview, at: int, size: int, source: int, now: int) -> None:
        """Note that a statement has written bytes; log the variables that it has changed."""
        latest = self.watched[at]
        if latest and self.address[latest] == at and self.whole[latest] >= size:
            self.written_at[latest] = now
            self.written_by[latest] = source
            self.compare(memory, latest, source, now)
            return
        latest = 0
        for i in range(size):
            number = self.watched[at + i]
            if number not in (0, latest):
                latest = number
                self.written_at[number] = now
                self.written_by[number] = source
                self.compare(memory, number, source, now)

    def discover(self, memory: memoryview, at: int, kind: int) -> None:
        """Watch a value that has just been written; its previous value is not known."""
        number = self.add(memory, at, kind)
        if number:
            self.is_new[number] = 1

    def refresh(self, memory: memoryview, now: int) -> None:
        """Log changes in the interface that were not made by a statement."""
        for number in range(self.interface_from, self.count + 1):
            self.compare(memory, number, 0, now)

    def touch(self, memory: memoryview, at: int, now: int) -> None:
        """Log that a byte has come from outside."""
        if self.watched[at]:
            self.compare(memory, self.watched[at], 0, now)

    def compare(self, memory: memoryview, number: int, source: int, now: int) -> None:
        """Log a variable that has changed, with what led to it."""
        value = self.bits(memory, self.address[number], int(self.kind[number]))
        before = self.seen[number]
        if value == before and self.is_new[number] == 0:
            return
        count = min(self.top, kinds.NOTE_ROWS) if source else 0
        flags = kinds.NOTES_FIRST if self.is_new[number] else 0
        if source and self.top > count:
            flags |= kinds.NOTES_CUT
        self.seen[number] = value
        self.is_new[number] = 0
        if self.log_end + kinds.NOTE_HEAD + 2 * count > self.log_size and not self.is_crowded:
            self.drop_old()
        if self.log_end + kinds.NOTE_HEAD + 2 * count > self.log_size:
            self.missed[number] += 1
            return
        self.logged[number] += 1
        self.put(number)
        self.put(now)
        self.put(source)
        self.put(before)
        self.put(value)
        self.put(count)
        self.put(flags)
        self.put(self.logged[number])
        for i in range(count):
            self.put(self.numbers[i])
            self.put(self.values[i])

    def put(self, word: int) -> None:
        """Put a word at the end of the log."""
        self.log[self.log_end] = word
        self.log_end += 1

    def drop_old(self) -> None:
        """Keep the newest changes of each watch in the log, in their order."""
        at = 0
        kept = 0
        while at < self.log_end:
            end = at + kinds.NOTE_HEAD + 2 * self.log[at + kinds.NOTE_ROW_COUNT]
            number = self.log[at + kinds.NOTE_NUMBER]
            if number > self.logged[self.log[at]] - kinds.NOTES_KEPT:
                for i in range(at, end):
                    self.log[kept] = self.log[i]
                    kept += 1
            at = end
        self.log_end = kept
        self.is_crowded = 4 * kept > 3 * self.log_size

    def take_log(self) -> memoryview:
        """Return the words of the log, and empty it."""
        log = memoryview(bytes(self.log[: self.log_end])).cast("q")
        self.log_end = 0
        self.is_crowded = False
        return log


def width(kind: int) -> int:
    """Return the number of bytes that a kind has."""
    if kind in (kinds.BOOL, kinds.I8, kinds.U8):
        return 1
    if kind in (kinds.I16, kinds.U16):
        return 2
    return 4 if kind in (kinds.I32, kinds.U32, kinds.F32) else 8

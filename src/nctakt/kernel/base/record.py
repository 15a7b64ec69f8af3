# SPDX-License-Identifier: MIT
"""The record of the realtime part: rows of signals, events, probes of conditions.

Each of the three is a block of typed memory that the tick appends to and Python empties between two
calls of ``Kernel.run``. Before a tick there must be room for all that it can record
(``has_room``), else ``run`` returns: nothing is ever lost. Every signal is a cell of the memory, so
a row is a copy of the chosen cells. ``rows.py`` has the columns of events and probes.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index, check_size


class Record:
    """Rows, events and probes of the ticks since they were last taken.

    ``memory`` is the machine's; ``signals`` (``select``) are the cells that a row holds.
    ``is_reduced``: of all rows their lowest and highest values are kept, and those before them.
    """

    def __init__(
        self,
        memory: bytearray,
        *,
        row_capacity: int = 4096,
        event_capacity: int = 8192,
        probe_capacity: int = 8192,
    ) -> None:
        for capacity in (row_capacity, event_capacity, probe_capacity):
            check_size(capacity, "capacity")
        self.cells = memoryview(memory).cast("d")
        self.row_capacity = row_capacity
        self.select([])
        self.event_capacity = event_capacity
        self.events = doubles(rows.EVENT_WIDTH * event_capacity)
        self.event_count = 0
        self.probe_capacity = probe_capacity
        self.probes = doubles(rows.PROBE_WIDTH * probe_capacity)
        self.probe_count = 0
        self.tick = 0
        self.channel = 0
        self.kinds = 0
        self.awaited_kinds = 0
        self.records_writes = False
        self.records_series = False
        self.records_answers = False

    def select(self, signals: list[int], *, reduced: bool = False) -> None:
        """Set the cells of a row; rows that were not taken are dropped.

        ``reduced``: the following ticks are read by ``take_extent``, not by ``take_rows``.
        """
        for cell in signals:
            check_index(cell, len(self.cells), "cell")
        self.signal_count = len(signals)
        self.signals = integers(max(1, len(signals)))
        for i, cell in enumerate(signals):
            self.signals[i] = cell
        kept = 2 if reduced else self.row_capacity
        self.rows = doubles(max(1, kept * len(signals)))
        self.is_reduced = reduced
        self.begin_extent()

    def begin_extent(self) -> None:
        """Forget all rows; where they are reduced, begin with the present values."""
        self.row_count = 0
        if self.is_reduced:
            for i in range(self.signal_count):
                value = self.cells[self.signals[i]]
                self.rows[i] = value
                self.rows[self.signal_count + i] = value

    def has_awaited(self) -> int:
        """Return whether an event of the kinds that somebody waits for has not been taken yet."""
        return 1 if self.kinds & self.awaited_kinds else 0

    def take_row(self) -> None:
        """Copy the signals' cells as the row of this tick."""
        if self.is_reduced:
            self.reduce_row()
            return
        row = self.row_count * self.signal_count
        for i in range(self.signal_count):
            self.rows[row + i] = self.cells[self.signals[i]]
        self.row_count += 1

    def reduce_row(self) -> None:
        """Let the lowest and highest values be those of this tick, too."""
        count = self.signal_count
        for i in range(count):
            value = self.cells[self.signals[i]]
            if not self.rows[i] <= value <= self.rows[count + i]:
                self.widen(i, value)
        self.row_count += 1

    def widen(self, i: int, value: float) -> None:
        """Widen the extent kept of a signal; once it is NaN, it stays NaN."""
        count = self.signal_count
        if value != value:
            self.rows[i] = value
            self.rows[count + i] = value
        elif value < self.rows[i]:
            self.rows[i] = value
        elif value > self.rows[count + i]:
            self.rows[count + i] = value

    def event(
        self,
        kind: int,
        source: int,
        subject: int = 0,
        a: float = 0.0,
        b: float = 0.0,
        c: float = 0.0,
    ) -> None:
        """Append an event of this tick; ``has_room`` was asked before the tick."""
        row = self.event_count * rows.EVENT_WIDTH
        bit = 1
        self.kinds |= bit << kind
        self.events[row + rows.EVENT_TICK] = self.tick
        self.events[row + rows.EVENT_KIND] = kind
        self.events[row + rows.EVENT_CHANNEL] = self.channel
        self.events[row + rows.EVENT_SOURCE] = source
        self.events[row + rows.EVENT_SUBJECT] = subject
        self.events[row + rows.EVENT_A] = a
        self.events[row + rows.EVENT_B] = b
        self.events[row + rows.EVENT_C] = c
        self.event_count += 1

    def event_between_ticks(
        self, kind: int, source: int, subject: int, a: float, b: float, c: float
    ) -> None:
        """Append an event of the tick that comes; for Python, which makes room for it."""
        if self.event_count == self.event_capacity:
            taken = bytes(memoryview(self.events))
            self.event_capacity *= 2
            self.events = memoryview(bytearray(2 * len(taken) + 8 * rows.EVENT_WIDTH)).cast("d")
            for i, number in enumerate(memoryview(taken).cast("d")):
                self.events[i] = number
        self.event(kind, source, subject, a, b, c)

    def written(self, source: int, serial: int, cell: int, value: float) -> None:
        """Record the new value of a variable, where writes are recorded."""
        if self.records_writes:
            self.event(rows.EVENT_WRITTEN, source, serial, cell, value)

    def probe(self, number: int, truth: int, left: float, right: float) -> None:
        """Append a change of a condition's truth."""
        kind = rows.PROBE_TRUE if truth else rows.PROBE_FALSE
        self.append_probe(kind, number, left, right, 0)

    def series(self, number: int, kind: int, next_tick: int) -> None:
        """Append the begin of a series, where series are recorded."""
        if self.records_series:
            self.append_probe(kind, number, 0.0, 0.0, next_tick)

    def append_probe(
        self, kind: int, number: int, left: float, right: float, next_tick: int
    ) -> None:
        """Append a probe row of this tick."""
        row = self.probe_count * rows.PROBE_WIDTH
        self.probes[row + rows.PROBE_TICK] = self.tick
        self.probes[row + rows.PROBE_KIND] = kind
        self.probes[row + rows.PROBE_NUMBER] = number
        self.probes[row + rows.PROBE_LEFT] = left
        self.probes[row + rows.PROBE_RIGHT] = right
        self.probes[row + rows.PROBE_NEXT_TICK] = next_tick
        self.probe_count += 1

    def has_room(self, events: int, probes: int) -> int:
        """Return whether there is room for a tick with at most ``events`` and ``probes``."""
        if self.signal_count > 0 and self.row_count >= self.row_capacity:
            return 0
        if self.event_count + events > self.event_capacity:
            return 0
        return 1 if self.probe_count + probes <= self.probe_capacity else 0

    def reserve(self, events: int, probes: int) -> None:
        """Make the empty buffers large enough for a tick with this many events and probes."""
        if events > self.event_capacity and self.event_count == 0:
            self.event_capacity = 2 * events
            self.events = doubles(rows.EVENT_WIDTH * self.event_capacity)
        if probes > self.probe_capacity and self.probe_count == 0:
            self.probe_capacity = 2 * probes
            self.probes = doubles(rows.PROBE_WIDTH * self.probe_capacity)

    def take_rows(self) -> bytes:
        """The rows recorded since the last call, row after row of float64."""
        taken = bytes(memoryview(self.rows)[: self.row_count * self.signal_count])
        self.row_count = 0
        return taken

    def take_extent(self) -> bytes:
        """The lowest values of the signals since the last call, then the highest ones."""
        taken = bytes(memoryview(self.rows)[: 2 * self.signal_count])
        self.begin_extent()
        return taken

    def take_events(self) -> bytes:
        """The events recorded since the last call, ``rows.EVENT_WIDTH`` float64 each."""
        taken = bytes(memoryview(self.events)[: self.event_count * rows.EVENT_WIDTH])
        self.event_count = 0
        self.kinds = 0
        return taken

    def take_probes(self) -> bytes:
        """The probe rows recorded since the last call, ``rows.PROBE_WIDTH`` float64 each."""
        taken = bytes(memoryview(self.probes)[: self.probe_count * rows.PROBE_WIDTH])
        self.probe_count = 0
        return taken

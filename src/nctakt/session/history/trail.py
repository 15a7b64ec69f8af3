# SPDX-License-Identifier: MIT
"""The trail of a controller's ticks, by which a run of the same ticks is recognized.

In: the events of a run, the memory of its machine. Out: a mark after some ticks, with a digest of
the memory and of all events so far; the rows of events that a session keeps. A step to a tick whose
state is confirmed needs no further proof.
"""

from __future__ import annotations

import hashlib
import time
from collections.abc import Iterable, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader
from nctakt.session.history.columns import WRITES, ColumnTrail, Extent

#: Work between two marks, in microseconds.
MARK_US = 4_000.0

#: Ticks between two marks at most.
MAX_MARK_TICKS = 100_000

#: Length of a digest in bytes.
DIGEST_SIZE = 8


@dataclass(frozen=True, slots=True)
class Mark:
    """A run after the ticks before ``tick``.

    ``digest``: of its memory and of all events so far. ``work_us``: the time of the processor since
    the mark before, in microseconds. ``is_over``: the run has ended there.
    """

    tick: int
    digest: bytes
    work_us: float
    is_over: bool = False


class Trail:
    """A sink that digests all events.

    ``keeps``: it also keeps their rows, and the record of signals and writes, until ``take`` and
    ``take_columns``.
    """

    def __init__(self, memory: bytearray) -> None:
        self._memory = memory
        self._plc_memories: Sequence[memoryview] = ()
        self._events = hashlib.blake2b(digest_size=DIGEST_SIZE)
        self._rows: list[bytes] = []
        self._columns = ColumnTrail()
        self.keeps = False
        self._since_us = 0.0
        self.part = 64

    def follow(self, memories: Sequence[memoryview]) -> None:
        """Digest the data of PLCs that run in the tick, too."""
        self._plc_memories = memories

    def open(self, header: TraceHeader) -> None:
        """Do nothing."""

    def extent(self, first_tick: int, count: int, values: memoryview[float]) -> None:
        """Keep the lowest and highest values of the signals."""
        if self.keeps:
            self._columns.extent(first_tick, count, values)

    def events(self, events: Sequence[Event]) -> None:
        """Digest events."""
        assert isinstance(events, EventChunk)
        self._events.update(events.data)
        if self.keeps:
            has_writes = events.has_any(WRITES)
            self._rows.append(self._columns.rest(events.data) if has_writes else events.data)

    def close(self) -> None:
        """Do nothing."""

    def take(self) -> bytes:
        """Return the rows since the last call."""
        taken, self._rows = b"".join(self._rows), []
        return taken

    def take_columns(self) -> tuple[tuple[Extent, ...], bytes]:
        """Return the record of signals and writes since the last call."""
        return self._columns.take()

    def digest(self) -> bytes:
        """Return the digest of the machine's memory, of the PLC's data and of all events so far."""
        whole = self._events.copy()
        whole.update(self._memory)
        for memory in self._plc_memories:
            whole.update(memory)
        return whole.digest()

    def note(self, ticks: int, work_us: float) -> bool:
        """Note the cost of some ticks; return whether a mark is due.

        ``part``: how many ticks should follow in one go, so that marks are about the intended
        distance apart.
        """
        self._since_us += work_us
        if work_us < 0.5 * MARK_US and ticks >= self.part:
            self.part = min(2 * self.part, MAX_MARK_TICKS)
        elif work_us > 2.0 * MARK_US:
            self.part = max(self.part // 2, 1)
        return self._since_us >= MARK_US

    def mark(self, tick: int, *, is_over: bool) -> Mark:
        """Return the mark after the latest tick."""
        work_us, self._since_us = self._since_us, 0.0
        return Mark(tick, self.digest(), work_us, is_over)


def now_us() -> float:
    """Return the time that this process has had of its processor, in microseconds."""
    return time.process_time() * 1e6


# --- confirmed ticks ------------------------------------------------------------------------------


#: Maximum number of known ticks; beyond it those known so far are forgotten.
MAX_KNOWN = 4096


class Confirmed:
    """The known ticks of the branch that a session is in."""

    def __init__(self) -> None:
        self._branch = 0
        self._digests: dict[int, bytes] = {}
        self._unproved: dict[int, bytes] = {}
        self._compared = -1

    def enter(self, branch: int) -> None:
        """Begin to rerun the past of a branch; nothing is known about any other."""
        if branch != self._branch or len(self._digests) > MAX_KNOWN:
            self._digests.clear()
        self._branch = branch
        self._unproved.clear()
        self._compared = -1

    def __contains__(self, tick: int) -> bool:
        return tick in self._digests

    def between(self, after: int, last: int, count: int) -> list[int]:
        """Return the first ``count`` known ticks after a tick, up to another."""
        return sorted(tick for tick in self._digests if after < tick <= last)[:count]

    def compare(self, branch: int, found: Iterable[Mark]) -> int | None:
        """Take the marks of a run of a branch; return the first tick known to be otherwise.

        Nothing is known about any branch other than the entered one.
        """
        if branch != self._branch:
            return None
        for mark in found:
            known = self._digests.get(mark.tick)
            if known is None:
                self._unproved[mark.tick] = mark.digest
            elif known != mark.digest:
                return mark.tick
            else:
                self._compared = mark.tick
        return None

    def is_proved(self, tick: int) -> bool:
        """Return whether the latest run agrees with the known state of this tick."""
        return self._compared == tick

    def prove(self) -> None:
        """Know the ticks of the latest run from now on."""
        self._digests.update(self._unproved)
        self._unproved.clear()

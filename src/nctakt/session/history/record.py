# SPDX-License-Identifier: MIT
"""A session's record of a branch of its tape: marks and events, tick by tick.

In: marks and rows of events, as the ticks are run for the first time. Out: the marks that these
ticks must lead to when they are run again; the last event of a kind, without running anything.
Events beyond a bound are in a temporary file that has no name.
"""

from __future__ import annotations

import bisect
import os
import tempfile
from collections.abc import Iterator, Sequence
from typing import IO

import numpy as np
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.kernel import rows
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import PAST_DIFFERS
from nctakt.messages.files import TEXT_CHANGED
from nctakt.session.history.columns import WRITE_KINDS, ColumnRecord, Extent
from nctakt.session.history.trail import MARK_US, Mark
from nctakt.session.stops import EventFilter

#: Maximum bytes of events that a branch has in memory, besides its latest chunk.
MAX_BYTES = 32 << 20

#: Bytes of a chunk.
CHUNK_BYTES = 1 << 20

_ROW_BYTES = 8 * rows.EVENT_WIDTH


@dataclass(frozen=True, slots=True)
class PastMark:
    """A mark of a branch; ``work_us``: that of all ticks before it, in microseconds."""

    tick: int
    digest: bytes
    work_us: float
    is_over: bool

    @property
    def end(self) -> int:
        """How far a run must go to reach it: one more tick shows that it is over."""
        return self.tick + self.is_over


def ticks_of(marks: Sequence[PastMark]) -> tuple[int, ...]:
    """Return how far a run has to go for each of some marks."""
    return tuple(mark.end for mark in marks)


def first_difference(found: Sequence[Mark], marks: Sequence[PastMark]) -> int | None:
    """Return the first tick where ticks that were run again have not led to their mark."""
    for again, mark in zip(found, marks, strict=False):
        if (again.tick, again.digest) != (mark.tick, mark.digest):
            return min(again.tick, mark.tick)
    return None


def past_differs(tick: int) -> Failure:
    """Return the exception to raise if the past is not as it was (901901)."""
    return Failure(diagnostic(PAST_DIFFERS, tick=tick))


def check_programs(diagnostics: Sequence[Diagnostic]) -> None:
    """Raise ``Failure`` (901900) where ticks that were run again have found a changed program."""
    changed = [found for found in diagnostics if found.id == TEXT_CHANGED.id]
    if changed:
        raise Failure(changed[0])


class _Chunk:
    """Some rows of events, in memory or at a place of a file."""

    def __init__(self, first_tick: float, data: bytes) -> None:
        self.first_tick = first_tick
        self._data: bytes | None = data
        self._size = len(data)
        self._end = 0

    @property
    def bytes_in_memory(self) -> int:
        """How many bytes of it are in memory."""
        return 0 if self._data is None else self._size

    def move_to(self, file: IO[bytes]) -> None:
        """Move its rows to the end of a file."""
        if self._data is not None:
            self._end = file.seek(0, os.SEEK_END)
            file.write(self._data)
            self._data = None

    def rows(self, file: IO[bytes] | None) -> NDArray[np.float64]:
        """Return its rows."""
        data = self._data
        if data is None:
            assert file is not None
            file.seek(self._end)
            data = file.read(self._size)
        return np.frombuffer(data, np.float64).reshape(-1, rows.EVENT_WIDTH)


class BranchRecord:
    """The record of one branch, from its first tick on; ``work_us``: of all its ticks so far."""

    def __init__(self, work_us: float = 0.0) -> None:
        self.work_us = work_us
        self.marks: list[PastMark] = []
        self.columns = ColumnRecord()
        self._chunks: list[_Chunk] = []
        self._open: list[bytes] = []
        self._open_bytes = 0
        self._file: IO[bytes] | None = None

    def add(
        self,
        marks: Sequence[Mark],
        events: bytes,
        columns: tuple[Sequence[Extent], bytes] = ((), b""),
    ) -> None:
        """Add the record of ticks that were run for the first time.

        The next mark replaces the last one if it is near.
        """
        for mark in marks:
            self.work_us += mark.work_us
            before = self.marks[-2].work_us if len(self.marks) > 1 else 0.0
            if self.marks and self.marks[-1].tick >= mark.tick:
                continue
            if self.marks and self.work_us - before < MARK_US:
                self.marks.pop()
            self.marks.append(PastMark(mark.tick, mark.digest, self.work_us, mark.is_over))
        self.columns.add(*columns)
        if events:
            self._open.append(events)
            self._open_bytes += len(events)
            if self._open_bytes >= CHUNK_BYTES:
                self._close_chunk()

    def _close_chunk(self) -> None:
        data, self._open, self._open_bytes = b"".join(self._open), [], 0
        first_tick = np.frombuffer(data, np.float64, 1)[0]
        self._chunks.append(_Chunk(float(first_tick), data))
        if sum(chunk.bytes_in_memory for chunk in self._chunks) > MAX_BYTES:
            if self._file is None:
                self._file = tempfile.TemporaryFile()
            for chunk in self._chunks[: len(self._chunks) // 2]:
                chunk.move_to(self._file)

    def mark_at(self, tick: int) -> PastMark | None:
        """Return the last mark at or before a tick."""
        index = bisect.bisect_right(self.marks, tick, key=lambda mark: mark.tick)
        return self.marks[index - 1] if index else None

    def mark_after(self, tick: int) -> PastMark | None:
        """Return the first mark at or after a tick."""
        index = bisect.bisect_left(self.marks, tick, key=lambda mark: mark.tick)
        return self.marks[index] if index < len(self.marks) else None

    def mark_before_work(self, work_us: float) -> PastMark | None:
        """Return the last mark up to which the run took at most this long."""
        index = bisect.bisect_right(self.marks, work_us, key=lambda mark: mark.work_us)
        return self.marks[index - 1] if index else None

    def marks_between(self, after: int, last: int) -> list[PastMark]:
        """Return the marks after a tick, up to another one."""
        first = bisect.bisect_right(self.marks, after, key=lambda mark: mark.tick)
        end = bisect.bisect_right(self.marks, last, key=lambda mark: mark.tick)
        return self.marks[first:end]

    def _backward(self) -> Iterator[NDArray[np.float64]]:
        """Yield the rows of events, the latest ones first."""
        if self._open:
            data = b"".join(self._open)
            yield np.frombuffer(data, np.float64).reshape(-1, rows.EVENT_WIDTH)
        for chunk in reversed(self._chunks):
            yield chunk.rows(self._file)

    def last_event(self, requested: EventFilter, before: float) -> int | None:
        """Return the last tick before another that has such an event, ``None`` without."""
        if requested.kinds & WRITE_KINDS:
            return self.columns.last_write(requested, before)
        for events in self._backward():
            count = int(np.searchsorted(events[:, rows.EVENT_TICK], before))
            found = requested.rows(events[:count])
            if len(found):
                return int(events[found[-1], rows.EVENT_TICK])
        return None

    def ticks_between(self, requested: EventFilter, after: int, before: int) -> list[int]:
        """Return the ticks between two ticks that have such events."""
        found: list[NDArray[np.float64]] = []
        for events in self._backward():
            ticks = events[:, rows.EVENT_TICK]
            first, end = np.searchsorted(ticks, (after + 1, before))
            found.append(ticks[first:end][requested.rows(events[first:end])])
            if first > 0:
                break
        return sorted({int(tick) for ticks in found for tick in ticks})

    def close(self) -> None:
        """Give the file back."""
        if self._file is not None:
            self._file.close()

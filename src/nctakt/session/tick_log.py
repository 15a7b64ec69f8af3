# SPDX-License-Identifier: MIT
"""The log of a controller since the last request, as a sink of its run.

In: the events of a run. Out: the latest of them, within a bound, and the current blocks.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence

from nctakt.base.diagnostics import Span
from nctakt.kernel import rows
from nctakt.results.trace.chunks import EventChunk, latest_of_channels, of_kinds, since_tick
from nctakt.results.trace.events import Event
from nctakt.results.trace.recorded import EventList
from nctakt.results.trace.sinks import TraceHeader

#: Maximum number of events handed out per slice: the latest; the number of others is reported.
MAX_EVENTS = 1000

#: Maximum number of unread rows of events, besides the latest ones.
MAX_UNREAD = 4 * MAX_EVENTS

_BLOCKS = frozenset((rows.EVENT_BLOCK,))


class TickLog:
    """The events since the last slice: the latest of them, and the current blocks.

    Rows are looked at many at once, and only when somebody asks: a run gives few at a time.
    """

    def __init__(self) -> None:
        self._unread: list[EventChunk] = []
        self._unread_count = 0
        self._chunks: deque[Sequence[Event]] = deque()
        self._count = 0
        self._since = 0
        self._left_out = 0
        self._blocks: dict[int, Span] = {}
        self._calls: dict[int, int] = {}
        self._block_count = 0

    def open(self, header: TraceHeader) -> None:
        """Do nothing."""

    def events(self, events: Sequence[Event]) -> None:
        """Keep events, and forget the oldest of too many."""
        if not isinstance(events, EventChunk):
            self._read()
            self._keep(events)
            return
        self._unread.append(events)
        self._unread_count += len(events)
        if self._unread_count > MAX_UNREAD:
            self._read()

    def _read(self) -> None:
        """Process the events that have not been processed yet."""
        unread, self._unread, self._unread_count = self._unread, [], 0
        if not unread:
            return
        whole = unread[0].joined(unread[1:])
        for events in unread if whole is None else (whole,):
            begun = of_kinds(events, _BLOCKS)
            self._block_count += len(begun)
            for event, calls in latest_of_channels(begun, rows.EVENT_B):
                if event.span is not None:
                    self._blocks[max(event.channel, 1)] = event.span
                    self._calls[max(event.channel, 1)] = int(calls)
            self._keep(since_tick(events, self._since))

    def _keep(self, events: Sequence[Event]) -> None:
        self._chunks.append(events)
        self._count += len(events)
        while self._count - len(self._chunks[0]) >= MAX_EVENTS:
            forgotten = len(self._chunks.popleft())
            self._count -= forgotten
            self._left_out += forgotten

    def close(self) -> None:
        """Do nothing."""

    def begin(self, since: int) -> None:
        """Forget all events before a tick, which is the next one or comes later."""
        self._read()
        self._chunks.clear()
        self._count = self._left_out = 0
        self._since = since

    @property
    def blocks(self) -> Mapping[int, Span]:
        """Number of the channel -> place of its current block."""
        self._read()
        return self._blocks

    @property
    def calls(self) -> Mapping[int, int]:
        """Number of the channel -> the number of open programs there."""
        self._read()
        return self._calls

    @property
    def block_count(self) -> int:
        """How many blocks have begun."""
        self._read()
        return self._block_count

    def take(self) -> tuple[list[Event], int]:
        """Return the latest events, and how many there were before them."""
        self._read()
        surplus = max(0, self._count - MAX_EVENTS)
        left_out = self._left_out + surplus
        kept: list[Event] = []
        for chunk in self._chunks:
            kept += chunk.after(surplus) if isinstance(chunk, EventChunk) else chunk[surplus:]
            surplus = max(0, surplus - len(chunk))
        self._chunks.clear()
        self._count = self._left_out = 0
        return kept, left_out


class SignalRows(EventList):
    """Keeps the rows of a trace as bytes."""

    def __init__(self, found: bytearray) -> None:
        super().__init__()
        self._found = found

    def events(self, events: Sequence[Event]) -> None:
        """Ignore the events."""

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Keep the rows."""
        self._found += rows.tobytes()

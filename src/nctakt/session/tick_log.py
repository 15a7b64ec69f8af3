# SPDX-License-Identifier: MIT
"""What a controller has done since it was asked last, as a sink of its run.

In: the events of a run. Out: the latest of them, within a bound, and the current blocks.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from nctakt.base.diagnostics import Span
from nctakt.kernel import rows
from nctakt.trace.chunks import latest_of_channels, of_kinds, since_tick
from nctakt.trace.events import Event
from nctakt.trace.recorded import EventList
from nctakt.trace.sinks import TraceHeader

#: Events of one slice that are handed out: the latest; how many others there were is reported.
MAX_EVENTS = 1000

_BLOCKS = frozenset((rows.EVENT_BLOCK,))


class TickLog:
    """The events since the last slice: the latest of them, and the current blocks."""

    def __init__(self) -> None:
        self._chunks: deque[Sequence[Event]] = deque()
        self._count = 0
        self._since = 0
        self.left_out = 0
        self.blocks: dict[int, Span] = {}
        self.calls: dict[int, int] = {}
        self.block_count = 0

    def open(self, header: TraceHeader) -> None:
        """Do nothing."""

    def events(self, events: Sequence[Event]) -> None:
        """Keep events, and forget the oldest of too many."""
        begun = of_kinds(events, _BLOCKS)
        self.block_count += len(begun)
        for event, calls in latest_of_channels(begun, rows.EVENT_B):
            if event.span is not None:
                self.blocks[max(event.channel, 1)] = event.span
                self.calls[max(event.channel, 1)] = int(calls)
        events = since_tick(events, self._since)
        self._chunks.append(events)
        self._count += len(events)
        while self._count - len(self._chunks[0]) >= MAX_EVENTS:
            forgotten = len(self._chunks.popleft())
            self._count -= forgotten
            self.left_out += forgotten

    def close(self) -> None:
        """Do nothing."""

    def begin(self, since: int) -> None:
        """Forget all events before a tick, which is the next one or comes later."""
        self._chunks.clear()
        self._count = self.left_out = 0
        self._since = since

    def take(self) -> tuple[list[Event], int]:
        """Return the latest events, and how many there were before them."""
        kept = [event for chunk in self._chunks for event in chunk]
        left_out = self.left_out + max(0, len(kept) - MAX_EVENTS)
        self._chunks.clear()
        self._count = self.left_out = 0
        return kept[-MAX_EVENTS:], left_out


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

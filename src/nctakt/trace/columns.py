# SPDX-License-Identifier: MIT
"""A sink that hands on the first columns: two listeners of a run may record different signals.

In: a trace with all signals. Out: the first of them, for the sink behind it.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence

from nctakt.trace.events import Event
from nctakt.trace.sinks import Sink, TraceHeader


class FirstColumns:
    """Hands the first ``count`` signals and all events on to ``sink``."""

    def __init__(self, sink: Sink, count: int) -> None:
        self._sink = sink
        self._count = count

    def open(self, header: TraceHeader) -> None:
        """Open the sink with a header of its signals only."""
        signals = header.signals[: self._count]
        self._sink.open(TraceHeader(header.cycle_time_us, signals))

    def events(self, events: Sequence[Event]) -> None:
        """Hand the events on."""
        self._sink.events(events)

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Hand the first ``count`` values of each row on."""
        kept = array("d")
        for begin in range(0, len(rows), width):
            kept.frombytes(rows[begin : begin + self._count].tobytes())
        self._sink.rows(first_tick, memoryview(kept), self._count)

    def close(self) -> None:
        """Close the sink."""
        self._sink.close()

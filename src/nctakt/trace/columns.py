# SPDX-License-Identifier: MIT
"""A sink that hands on some columns: two listeners of one run may want different signals.

In: a trace with all signals. Out: the first of them, to the sink behind it.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence

from nctakt.trace.events import Event
from nctakt.trace.sinks import Sink, TraceHeader


class FirstColumns:
    """Hands the first ``count`` signals on to ``sink``, and everything else."""

    def __init__(self, sink: Sink, count: int) -> None:
        self._sink = sink
        self._count = count

    def open(self, header: TraceHeader) -> None:
        """Begin."""
        signals = header.signals[: self._count]
        self._sink.open(TraceHeader(header.cycle_time_us, signals))

    def events(self, events: Sequence[Event]) -> None:
        """What happened."""
        self._sink.events(events)

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """The rows, as far as they are wanted."""
        kept = array("d")
        for begin in range(0, len(rows), width):
            kept.frombytes(rows[begin : begin + self._count].tobytes())
        self._sink.rows(first_tick, memoryview(kept), self._count)

    def close(self) -> None:
        """End."""
        self._sink.close()

# SPDX-License-Identifier: MIT
"""A sink that hands on the first columns: two listeners of a run may record different signals.

In: a trace with all signals. Out: the first of them, for the sink after it, without events of
kinds that it does not expect.
"""

from __future__ import annotations

from array import array
from collections.abc import Collection, Sequence

from nctakt.kernel import rows
from nctakt.results.trace.chunks import without_kinds
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import RowSink, Sink, TraceHeader

#: The kinds of events that ``Controller.run(blocks=True)`` adds.
BLOCK_EVENTS = (
    rows.EVENT_BLOCK,
    rows.EVENT_WAIT,
    rows.EVENT_ACKNOWLEDGED,
    rows.EVENT_DROPPED,
)


class OtherEvents:
    """Hands all events but those of ``hides`` on to ``sink``; its header has ``count`` signals."""

    def __init__(self, sink: Sink, count: int, hides: Collection[int] = ()) -> None:
        self._sink = sink
        self._count = count
        self._hides = hides

    def open(self, header: TraceHeader) -> None:
        """Open the sink with a header of its signals only."""
        signals = header.signals[: self._count]
        self._sink.open(TraceHeader(header.cycle_time_us, signals))

    def events(self, events: Sequence[Event]) -> None:
        """Hand the events on, if any are left."""
        shown = without_kinds(events, self._hides) if self._hides else events
        if len(shown):
            self._sink.events(shown)

    def close(self) -> None:
        """Close the sink."""
        self._sink.close()


class FirstColumns(OtherEvents):
    """Hands the first ``count`` signals on as well."""

    def __init__(self, sink: RowSink, count: int, hides: Collection[int] = ()) -> None:
        super().__init__(sink, count, hides)
        self._rows = sink.rows

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Hand the first ``count`` values of each row on."""
        kept = array("d")
        for begin in range(0, len(rows), width):
            kept.frombytes(rows[begin : begin + self._count].tobytes())
        self._rows(first_tick, memoryview(kept), self._count)


def first_columns(sink: Sink, count: int, hides: Collection[int] = ()) -> Sink:
    """Return a sink that hands the first ``count`` signals and the other events to ``sink``."""
    if isinstance(sink, RowSink):
        return FirstColumns(sink, count, hides)
    return OtherEvents(sink, count, hides)

# SPDX-License-Identifier: MIT
"""The parts of a run that a comparison needs: signals, blocks, reactions.

In: a trace in memory, or a run whose trace comes to ``RecordedColumns``, which keeps it outside the
memory.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol, overload

import numpy

from nctakt.comparison.columns import Column, Numbers, NumberTable
from nctakt.kernel import rows as event_rows
from nctakt.results.run import Run
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader

_FUNCTIONS = (event_rows.EVENT_TECHNOLOGY, event_rows.EVENT_TECHNOLOGY_RT)


class Recorded(Protocol):
    """The recorded side of a comparison; events in the order of their ticks."""

    cycle_time_us: int

    def __getitem__(self, name: str, /) -> Column: ...

    @property
    def blocks(self) -> Sequence[Event]:
        """The events of blocks that begin."""

    @property
    def reactions(self) -> Sequence[Event]:
        """The events of reactions that fire."""

    @property
    def functions(self) -> Sequence[Event]:
        """The events of functions that go out."""


class RecordedTrace:
    """The trace of a run that has it in memory."""

    def __init__(self, run: Run) -> None:
        assert run.trace is not None
        self._trace = trace = run.trace
        self.cycle_time_us = trace.cycle_time_us

    def __getitem__(self, name: str, /) -> Column:
        return self._trace[name]

    @property
    def blocks(self) -> Sequence[Event]:
        """The events of blocks that begin."""
        return [event for event in self._trace.events if event.kind == "block"]

    @property
    def reactions(self) -> Sequence[Event]:
        """The events of reactions that fire."""
        return [event for event in self._trace.events if event.kind == "fired"]

    @property
    def functions(self) -> Sequence[Event]:
        """The events of functions that go out."""
        return [event for event in self._trace.events if event.kind in ("output", "M", "H")]


class RecordedColumns:
    """The trace of a run outside of the memory, as a sink."""

    def __init__(self) -> None:
        self.cycle_time_us = 0
        self._numbers: dict[str, int] = {}
        self._table = NumberTable(0)
        self.blocks = StoredEvents()
        self.reactions = StoredEvents()
        self.functions = StoredEvents()

    def open(self, header: TraceHeader) -> None:
        """Keep the header."""
        self.cycle_time_us = header.cycle_time_us
        self._numbers = {one.name: number for number, one in enumerate(header.signals)}
        self._table = NumberTable(len(header.signals))

    def events(self, events: Sequence[Event]) -> None:
        """Keep the events of blocks, reactions and functions."""
        assert isinstance(events, EventChunk)
        self.blocks.add(events.of_kinds((event_rows.EVENT_BLOCK,)))
        self.reactions.add(events.of_kinds((event_rows.EVENT_FIRED,)))
        self.functions.add(events.of_kinds(_FUNCTIONS))

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Keep the rows."""
        self._table.add(numpy.asarray(rows).reshape(-1, width))

    def close(self) -> None:
        """Do nothing: the recording stays."""

    def __getitem__(self, name: str, /) -> Column:
        return self._table.column(self._numbers[name])


class StoredEvents(Sequence[Event]):
    """Events outside of the memory, each decoded when it is looked at."""

    def __init__(self) -> None:
        self._table = NumberTable(event_rows.EVENT_WIDTH)
        self._chunk: EventChunk | None = None

    def add(self, chunk: EventChunk) -> None:
        """Add the events of a chunk."""
        if len(chunk):
            self._chunk = self._chunk or chunk
            self._table.add(numpy.frombuffer(chunk.data).reshape(-1, event_rows.EVENT_WIDTH))

    def __len__(self) -> int:
        return len(self._table)

    @property
    def ticks(self) -> Numbers:
        """The ticks of all events."""
        return self._table.column(event_rows.EVENT_TICK)[:]

    @overload
    def __getitem__(self, index: int) -> Event: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Event]: ...

    def __getitem__(self, index: int | slice) -> Event | Sequence[Event]:
        if isinstance(index, slice):
            return [self[one] for one in range(*index.indices(len(self)))]
        if not 0 <= index < len(self) or self._chunk is None:
            raise IndexError(index)
        row = [self._table.read(at, index, index + 1) for at in range(event_rows.EVENT_WIDTH)]
        return self._chunk.with_data(numpy.concatenate(row).tobytes())[0]

# SPDX-License-Identifier: MIT
"""A trace as an object: signals by name as arrays, and events.

In: the chunks of a sink, or the content of a file. Out: ``Trace``. The recorded bytes are kept as
they come; arrays and events are built when they are first read, and numpy is loaded only then.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from nctakt.base.misspelling import nearest
from nctakt.base.notebook import curve, html_columns
from nctakt.results.trace.chunks import ROW_KINDS, EventChunk
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import Signal, TraceHeader

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    Values = NDArray[numpy.float64]
    Counts = NDArray[numpy.int64]


#: Signals that a notebook shows at most.
MAX_SHOWN = 40


class Trace(Mapping[str, "Values"]):
    """The recorded signals by name, one float64 per tick, and the events.

    ``trace["X.ACS.ACT_POS"]`` is the column of a signal. Raises ``KeyError`` for a name that was
    not recorded and suggests the nearest one. The arrays are read-only. Two traces are equal if
    they have the same signals, ticks, bits and events.
    """

    def __init__(
        self,
        header: TraceHeader,
        first_tick: int,
        chunks: Sequence[bytes],
        events: Sequence[Sequence[Event]],
    ) -> None:
        self._header = header
        self.cycle_time_us = header.cycle_time_us
        self.signals: tuple[Signal, ...] = header.signals
        self.first_tick = first_tick
        self._chunks = chunks
        self._event_chunks = events
        self._rows: Values | None = None
        self._events: list[Event] | None = None
        self._columns = {signal.name: i for i, signal in enumerate(header.signals)}

    def __repr__(self) -> str:
        begin = f", from tick {self.first_tick} on" if self.first_tick else ""
        count = sum(map(len, self._event_chunks))
        return (
            f"<Trace of {_counted(len(self), 'signal')}: {_counted(self.ticks, 'tick')}{begin}, "
            f"{_counted(count, 'event')}>"
        )

    def _repr_html_(self) -> str:
        """Return a table for notebooks: each signal with its unit, range, last value, curve."""
        rows, curves = [], []
        for signal in self.signals[:MAX_SHOWN]:
            values = self[signal.name]
            if len(values):
                numbers = (values.min(), values.max(), values[-1])
                rows.append((signal.name, signal.unit, *(f"{value:.6g}" for value in numbers)))
                curves.append(_small_curve(values))
        left = len(self.signals) - MAX_SHOWN
        more = f", {left} more signals" if left > 0 else ""
        caption = f"{_counted(self.ticks, 'tick')}{more}"
        heads = ("signal", "unit", "lowest", "highest", "last", "")
        return html_columns(caption, heads, rows, curves)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Trace):
            return NotImplemented
        return self._header == other._header and self._content() == other._content()

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[type[Trace], tuple[Any, ...]]:
        first_tick, data, events = self._content()
        return Trace, (self._header, first_tick, (data,), (events,))

    def _content(self) -> tuple[int, bytes, list[Event]]:
        """Return the first tick, the values of all ticks, and the events."""
        return self.first_tick, self._data(), self.events

    def __getitem__(self, name: str) -> Values:
        column = self._columns.get(name)
        if column is None:
            near = nearest(name, self._columns)
            hint = f"; did you mean {near}?" if near else ""
            raise KeyError(f"{name} is not recorded{hint}")
        return self._table()[:, column]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def ticks(self) -> int:
        """The number of ticks that have a row."""
        width = 8 * len(self.signals)
        return sum(map(len, self._chunks)) // width if width else 0

    @property
    def tick(self) -> Counts:
        """The number of the tick of each row."""
        import numpy  # noqa: PLC0415 - a run whose arrays no one reads does not load it

        return numpy.arange(self.first_tick, self.first_tick + self.ticks, dtype=numpy.int64)

    @property
    def time_us(self) -> Counts:
        """The time at which the tick of each row begins, in microseconds."""
        return self.tick * self.cycle_time_us

    @property
    def events(self) -> list[Event]:
        """All events in the order of their occurrence."""
        if self._events is None:
            self._events = [event for chunk in self._event_chunks for event in chunk]
        return self._events

    def events_of(self, words: Collection[str]) -> list[Event]:
        """Return the events of these kinds (``fired``, ``M``); the others may stay undecoded."""
        kinds = [ROW_KINDS[word] for word in words if word in ROW_KINDS]
        if self._events is not None or len(kinds) < len(words):
            return [event for event in self.events if event.kind in words]
        return [
            event
            for chunk in self._event_chunks
            for event in (chunk.of_kinds(kinds) if isinstance(chunk, EventChunk) else chunk)
            if event.kind in words
        ]

    def at(self, tick: int, name: str) -> float:
        """Return a signal after tick ``tick``; raises ``IndexError`` for a tick without a row."""
        if not self.first_tick <= tick < self.first_tick + self.ticks:
            raise IndexError(f"tick {tick} is not recorded")
        return float(self[name][tick - self.first_tick])

    def _table(self) -> Values:
        import numpy  # noqa: PLC0415 - as above

        if self._rows is None:
            rows = numpy.frombuffer(self._data(), dtype=numpy.float64)
            self._rows = rows.reshape(-1, len(self.signals))
        return self._rows

    def _data(self) -> bytes:
        """Return the values of all ticks, put together when they are first asked for."""
        if len(self._chunks) > 1:
            self._chunks = (b"".join(self._chunks),)
        return self._chunks[0] if self._chunks else b""


def _small_curve(values: Values) -> str:
    """Return the curve of a signal: the lowest and highest value of up to 120 stretches."""
    import numpy  # noqa: PLC0415 - as above

    starts = numpy.linspace(0, len(values), min(len(values), 120), endpoint=False).astype(int)
    lows, highs = (one.reduceat(values, starts) for one in (numpy.minimum, numpy.maximum))
    if not (numpy.isfinite(lows).all() and numpy.isfinite(highs).all()):
        return ""
    return curve(lows.tolist(), highs.tolist())


class MemorySink:
    """Keeps a trace in memory; ``trace`` is valid from ``open`` on and grows with the run."""

    def __init__(self) -> None:
        self._header = TraceHeader(0, ())
        self._first_tick = 0
        self._chunks: list[bytes] = []
        self._events: list[Sequence[Event]] = []

    def open(self, header: TraceHeader) -> None:
        """Keep the header."""
        self._header = header

    def events(self, events: Sequence[Event]) -> None:
        """Keep the events; an ``EventChunk`` is not decoded."""
        if len(events):
            self._events.append(events)

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Keep the rows."""
        assert width == len(self._header.signals), width
        if not self._chunks:
            self._first_tick = first_tick
        self._chunks.append(bytes(rows))

    def close(self) -> None:
        """Do nothing: the trace stays."""

    @property
    def trace(self) -> Trace:
        """The trace recorded so far."""
        return Trace(self._header, self._first_tick, tuple(self._chunks), tuple(self._events))


class EventList:
    """Keeps the events of a trace and nothing else."""

    def __init__(self) -> None:
        self._chunks: list[Sequence[Event]] = []

    def open(self, header: TraceHeader) -> None:
        """Do nothing: events need no header."""

    def events(self, events: Sequence[Event]) -> None:
        """Keep the events; an ``EventChunk`` is not decoded."""
        self._chunks.append(events)

    def close(self) -> None:
        """Do nothing: the events stay."""

    def take(self) -> list[Event]:
        """Return the events since the last call."""
        chunks, self._chunks = self._chunks, []
        return [event for chunk in chunks for event in chunk]


def _counted(count: int, noun: str) -> str:
    """Return a number with its noun: ``1 tick``, ``2 ticks``."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"

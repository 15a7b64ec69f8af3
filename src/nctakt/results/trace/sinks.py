# SPDX-License-Identifier: MIT
"""Sinks, which receive a trace while it is recorded: their interface, and two file formats.

In: the header once, then for chunks of consecutive ticks first their events and then their rows
(float64, row after row). Out: text in a file, chunk by chunk, in constant memory; the written part
stays readable if the run is interrupted. ``reading.py`` reads both formats back.
"""

from __future__ import annotations

import abc
from array import array
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Protocol, TextIO, cast, runtime_checkable

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.files.output import OutputFile
from nctakt.kernel import rows
from nctakt.messages import diagnostic
from nctakt.messages.files import FILE_NOT_WRITABLE, UNKNOWN_TRACE_FORMAT
from nctakt.results.trace.chunks import without_kinds
from nctakt.results.trace.events import Event
from nctakt.results.trace.texts import (
    by_tick,
    column_texts,
    csv_cell,
    csv_line,
    event_object,
    join_events,
    json_text,
)

FORMAT_NAME = "nctakt-trace"
FORMAT_VERSION = 1

#: Endings of file names and the formats that they choose.
SUFFIXES = (".csv", ".jsonl")

#: The ending of Parquet files, which are written (``nctakt.results.trace.arrow``).
PARQUET = ".parquet"

#: The ending of MF4 files, which are written (``nctakt.results.trace.measurement``).
MF4 = ".mf4"


#: The kinds of events that ``Controller.run(blocks=True)`` adds.
BLOCK_EVENTS = (
    rows.EVENT_BLOCK,
    rows.EVENT_WAIT,
    rows.EVENT_ACKNOWLEDGED,
    rows.EVENT_DROPPED,
)


@dataclass(frozen=True, slots=True)
class Signal:
    """One recorded value per tick; ``integral``: its values are whole numbers.

    ``labels``: numbers and names of the items of an enumeration.
    """

    name: str
    unit: str = ""
    integral: bool = False
    labels: tuple[tuple[int, str], ...] = ()


@dataclass(frozen=True, slots=True)
class TraceHeader:
    """The header of a trace: the length of a tick and the signals in their order."""

    cycle_time_us: int
    signals: tuple[Signal, ...]


class Sink(Protocol):
    """Receives the events of a run in pieces: ``open``, then ``events``, then ``close``.

    Events come in ascending order of ticks.
    """

    def open(self, header: TraceHeader) -> None:
        """Open the sink; called once, before anything else."""

    def events(self, events: Sequence[Event]) -> None:
        """Receive the events of some consecutive ticks."""

    def close(self) -> None:
        """Close the sink; called once, after everything else."""


@runtime_checkable
class RowSink(Sink, Protocol):
    """Receives signals as well: ``events`` and ``rows`` in turn.

    All events of a tick have come when its row comes. A run without rows records no signals.
    """

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Receive rows of consecutive ticks from ``first_tick`` on, ``width`` float64 each."""


class ExtentSink(Sink, Protocol):
    """Receives the remaining values if rows are reduced."""

    def extent(self, first_tick: int, count: int, values: memoryview[float]) -> None:
        """Receive the lowest values of the signals in some ticks, then the highest ones.

        Those before the first of the ticks are among them.
        """


def check_suffix(path: Path) -> None:
    """Raise ``Failure`` (900506) for a file whose suffix is not that of a format."""
    known = (*SUFFIXES, PARQUET, MF4)
    if path.suffix.lower() not in known:
        raise Failure(diagnostic(UNKNOWN_TRACE_FORMAT, file=str(path), suffixes=" or ".join(known)))


def file_sink(file: Path | OutputFile) -> CsvSink | JsonlSink:
    """Return a sink that writes ``file`` in the format of its suffix.

    Raises ``Failure`` for another suffix (900506). A path is opened with the trace.
    """
    path = file if isinstance(file, Path) else Path(file.name)
    check_suffix(path)
    return CsvSink(file) if path.suffix.lower() == ".csv" else JsonlSink(file)


class _FileSink(abc.ABC):
    """Writes pieces of text to ``file``, a path or an open file.

    A path gets its file when the trace is closed; until then the file is next to it
    (``OutputFile``). Raises ``Failure`` (900507) when the path cannot be opened or the file cannot
    grow.
    """

    def __init__(self, file: Path | OutputFile | TextIO) -> None:
        self._target = file
        self._file: OutputFile | TextIO | None = None
        self._is_closed = False
        self._cycle_time_us = 0
        self._integral: tuple[bool, ...] = ()
        self._waiting: list[Event] = []

    def open(self, header: TraceHeader) -> None:
        """Open the file and write the header."""
        self._cycle_time_us = header.cycle_time_us
        self._integral = tuple(signal.integral for signal in header.signals)
        self._file = OutputFile(self._target) if isinstance(self._target, Path) else self._target
        self._is_closed = False
        try:
            self._write(self._header_line(header))
        except Failure:
            self.close()
            raise

    def events(self, events: Sequence[Event]) -> None:
        """Keep the events for their rows; without signals, write them."""
        self._waiting.extend(events)
        if not self._integral:
            self._write_waiting()

    def close(self) -> None:
        """Write the events after the last row and close the file; a second call does nothing."""
        if self._file is None or self._is_closed:
            return
        self._is_closed = True
        try:
            self._write_waiting()
        finally:
            self._close(self._file)

    def _write_waiting(self) -> None:
        for tick, together in by_tick(self._waiting):
            self._write(self._line_without_row(tick, together))
        self._waiting.clear()

    @abc.abstractmethod
    def _header_line(self, header: TraceHeader) -> str:
        """Return the first line of the file."""

    @abc.abstractmethod
    def _line_without_row(self, tick: int, together: Sequence[Event]) -> str:
        """Return the line with the events of a tick that has no row."""

    def _write(self, text: str) -> None:
        assert self._file is not None
        try:
            self._file.write(text)
        except Failure:
            self._waiting.clear()
            raise
        except OSError as error:
            self._waiting.clear()
            raise _unwritable(self._file, error) from error

    def _close(self, file: OutputFile | TextIO) -> None:
        try:
            file.close()
        except OSError as error:
            raise _unwritable(file, error) from error


def _unwritable(file: OutputFile | TextIO, error: OSError) -> Failure:
    reason = error.strerror or str(error)
    return Failure(diagnostic(FILE_NOT_WRITABLE, file=str(file.name), reason=reason))


class CsvSink(_FileSink):
    """One line per tick: ``tick,time_us,<signals…>,events``.

    The last column joins the tick's events with ``; ``. After an event comes its origin, cycle
    and position: ``fired 17 line 5 <17 part.nc:5:3>``, with ``-`` for a missing one. Without
    signals only ticks with events have a line.
    """

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Write a line for each row."""
        if width == 0 or not rows:
            return
        values = cast("list[float]", rows.tolist())
        columns = column_texts(values, width, self._integral)
        ticks = range(first_tick, first_tick + len(values) // width)
        cells = self._event_cells(ticks)
        times = map(str, range(ticks.start * self._cycle_time_us, *self._time_stop(ticks)))
        lines = map(",".join, zip(map(str, ticks), times, *columns, cells, strict=True))
        self._write("\n".join(lines) + "\n")

    def _time_stop(self, ticks: range) -> tuple[int, int]:
        return ticks.stop * self._cycle_time_us, self._cycle_time_us

    def _event_cells(self, ticks: range) -> list[str]:
        """Return the last column of these ticks and remove their events from the waiting ones."""
        cells = [""] * len(ticks)
        due = 0
        for tick, together in by_tick(self._waiting):
            if tick >= ticks.stop:
                break
            cells[tick - ticks.start] = csv_cell(join_events(together))
            due += len(together)
        del self._waiting[:due]
        return cells

    def _header_line(self, header: TraceHeader) -> str:
        names = [signal.name for signal in header.signals]
        return csv_line(["tick", "time_us", *names, "events"])

    def _line_without_row(self, tick: int, together: Sequence[Event]) -> str:
        empty = [""] * len(self._integral)
        return csv_line([str(tick), str(together[0].time_us), *empty, join_events(together)])


class JsonlSink(_FileSink):
    """A header object, then one object per tick with its values and events, each on a line.

    ``{"tick": 0, "time_us": 0, "values": [...], "events": [...]}``; ``values`` in the order of the
    header's signals, ``events`` only where there are some. Without signals only ticks with events
    have a line. A value that is not a finite number is ``null``.
    """

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Write an object for each row."""
        if width == 0 or not rows:
            return
        values = cast("list[float]", rows.tolist())
        columns = column_texts(values, width, self._integral, missing="null")
        period = self._cycle_time_us
        lines = [
            f'{{"tick": {tick}, "time_us": {tick * period}, "values": [{joined}]}}'
            for tick, joined in enumerate(map(", ".join, zip(*columns, strict=True)), first_tick)
        ]
        due = 0
        for tick, together in by_tick(self._waiting):
            if tick >= first_tick + len(lines):
                break
            objects = json_text([event_object(event) for event in together])
            line = lines[tick - first_tick]
            lines[tick - first_tick] = f'{line[:-1]}, "events": {objects}}}'
            due += len(together)
        del self._waiting[:due]
        self._write("\n".join(lines) + "\n")

    def _header_line(self, header: TraceHeader) -> str:
        signals = [
            {"name": signal.name, "unit": signal.unit, "integral": signal.integral}
            for signal in header.signals
        ]
        content = {
            "format": FORMAT_NAME,
            "version": FORMAT_VERSION,
            "cycle_time_us": header.cycle_time_us,
            "signals": signals,
        }
        return json_text(content) + "\n"

    def _line_without_row(self, tick: int, together: Sequence[Event]) -> str:
        objects = [event_object(event) for event in together]
        content = {"tick": tick, "time_us": together[0].time_us, "events": objects}
        return json_text(content) + "\n"


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

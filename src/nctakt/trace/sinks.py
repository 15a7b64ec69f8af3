# SPDX-License-Identifier: MIT
"""Where a trace goes while it is made: the interface of sinks, and the two file formats.

In: the header once, then for chunks of consecutive ticks first their events and then their rows
(float64, row after row). Out: text in a file, chunk by chunk, in constant memory; what has been
written stays readable when the run breaks off. ``nctakt.trace.reading`` reads both formats back.

Both formats write each number as short as it can be written without loss. Negative zero is written
as zero, so that equal values are equal text.
"""

from __future__ import annotations

import abc
import csv
import io
import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, TextIO, cast

from nctakt.diagnostics import Diagnostic
from nctakt.failure import Failure
from nctakt.messages import diagnostic
from nctakt.trace.events import Event

FORMAT_NAME = "nctakt-trace"
FORMAT_VERSION = 1

#: Endings of file names and the formats that they choose.
SUFFIXES = (".csv", ".jsonl")

#: A column is looked at in so many places to see whether its values repeat.
_SAMPLES = 64


@dataclass(frozen=True, slots=True)
class Signal:
    """One recorded value per tick; ``integral`` says that it only takes whole numbers."""

    name: str
    unit: str = ""
    integral: bool = False


@dataclass(frozen=True, slots=True)
class TraceHeader:
    """What stands in front of a trace: the length of a tick and the signals in their order."""

    cycle_time_us: int
    signals: tuple[Signal, ...]


class Sink(Protocol):
    """Takes a trace in pieces: ``open``, then ``events`` and ``rows`` in turn, then ``close``.

    The events of a tick are given before its row, both in ascending order of ticks, and no tick's
    events are divided over two calls between which its row is given.
    """

    def open(self, header: TraceHeader) -> None:
        """Begin; called once, before anything else."""

    def events(self, events: Sequence[Event]) -> None:
        """What happened in the ticks whose rows come next."""

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Rows of consecutive ticks from ``first_tick`` on: ``width`` float64 for each tick."""

    def close(self) -> None:
        """End; nothing is called after it."""


def file_sink(path: Path) -> CsvSink | JsonlSink:
    """A sink that writes the file ``path``, in the format that its suffix names.

    Raises ``Failure`` for another suffix (900506) and a file that cannot be written (900507).
    """
    if path.suffix.lower() not in SUFFIXES:
        raise Failure(diagnostic(900506, file=str(path), suffixes=" or ".join(SUFFIXES)))
    try:
        file = path.open("w", encoding="utf-8", errors="backslashreplace", newline="\n")
    except OSError as error:
        raise Failure(unwritable(path, error)) from error
    return CsvSink(file) if path.suffix.lower() == ".csv" else JsonlSink(file)


def unwritable(path: Path, error: OSError) -> Diagnostic:
    """The diagnostic of a file that cannot be written."""
    return diagnostic(900507, file=str(path), reason=error.strerror or str(error))


class _FileSink(abc.ABC):
    """Writes pieces of text to a file; raises ``Failure`` (900507) when it takes no more."""

    def __init__(self, file: TextIO) -> None:
        self._file = file
        self._cycle_time_us = 0
        self._integral: tuple[bool, ...] = ()
        self._waiting: list[Event] = []

    def events(self, events: Sequence[Event]) -> None:
        """Keep the events for their rows; without signals, write them."""
        self._waiting.extend(events)
        if not self._integral:
            self._write_waiting()

    def close(self) -> None:
        """Write events behind the last row, and close the file; again: nothing."""
        if self._file.closed:
            return
        try:
            self._write_waiting()
        finally:
            self._close_file()

    def _write_waiting(self) -> None:
        for tick, together in _by_tick(self._waiting):
            self._write(self._line_without_row(tick, together))
        self._waiting.clear()

    @abc.abstractmethod
    def _line_without_row(self, tick: int, together: Sequence[Event]) -> str:
        """The line of events in a tick that has no row."""

    def _write(self, text: str) -> None:
        try:
            self._file.write(text)
        except OSError as error:
            self._waiting.clear()
            raise Failure(unwritable(Path(self._file.name), error)) from error

    def _close_file(self) -> None:
        try:
            self._file.close()
        except OSError as error:
            raise Failure(unwritable(Path(self._file.name), error)) from error


class CsvSink(_FileSink):
    """One line per tick: ``tick,time_us,<signals…>,events``.

    The last column joins the tick's events with ``; ``. Behind an event stands where it comes
    from: ``fired 17 line 5 <17 part.nc:5:3>``, cycle and place, ``-`` for what is missing.
    Without signals only ticks with events have a line.
    """

    def open(self, header: TraceHeader) -> None:
        """Write the header line."""
        self._cycle_time_us = header.cycle_time_us
        self._integral = tuple(signal.integral for signal in header.signals)
        names = [signal.name for signal in header.signals]
        self._write(_csv_line(["tick", "time_us", *names, "events"]))

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
        """The last column of these ticks; takes their events from those that wait."""
        cells = [""] * len(ticks)
        due = 0
        for tick, together in _by_tick(self._waiting):
            if tick >= ticks.stop:
                break
            cells[tick - ticks.start] = _csv_cell(join_events(together))
            due += len(together)
        del self._waiting[:due]
        return cells

    def _line_without_row(self, tick: int, together: Sequence[Event]) -> str:
        empty = [""] * len(self._integral)
        return _csv_line([str(tick), str(together[0].time_us), *empty, join_events(together)])


class JsonlSink(_FileSink):
    """A header object, then one object per tick with its values and events, each on a line.

    ``{"tick": 0, "time_us": 0, "values": [...], "events": [...]}``; ``values`` in the order of the
    header's signals, ``events`` only where there are some. Without signals only ticks with events
    have a line. A value that is no number is ``null``.
    """

    def open(self, header: TraceHeader) -> None:
        """Write the header object."""
        self._cycle_time_us = header.cycle_time_us
        self._integral = tuple(signal.integral for signal in header.signals)
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
        self._write(_json(content) + "\n")

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
        for tick, together in _by_tick(self._waiting):
            if tick >= first_tick + len(lines):
                break
            objects = _json([event_object(event) for event in together])
            line = lines[tick - first_tick]
            lines[tick - first_tick] = f'{line[:-1]}, "events": {objects}}}'
            due += len(together)
        del self._waiting[:due]
        self._write("\n".join(lines) + "\n")

    def _line_without_row(self, tick: int, together: Sequence[Event]) -> str:
        objects = [event_object(event) for event in together]
        content = {"tick": tick, "time_us": together[0].time_us, "events": objects}
        return _json(content) + "\n"


def column_texts(
    values: list[float], width: int, integral: Sequence[bool], missing: str = "nan"
) -> list[list[str]]:
    """The texts of ``values`` (row after row, ``width`` numbers each), column by column.

    ``missing`` is written for what is no finite number. Columns, not rows, since most columns of a
    trace repeat their values, or those of another column: such a number is formatted once.
    """
    texts: list[list[str]] = []
    columns: list[tuple[bool, list[float]]] = []
    for i in range(width):
        column = (integral[i], values[i::width])
        if column in columns:
            texts.append(texts[columns.index(column)])
        else:
            texts.append(_column_text(column[1], integral[i], missing))
        columns.append(column)
    return texts


def _column_text(column: list[float], integral: bool, missing: str) -> list[str]:
    if 0.0 in column:  # equal to negative zero, which this makes a positive one
        column = [value + 0.0 for value in column]
    if integral:
        memo = {value: f"{value:.0f}" for value in dict.fromkeys(column)}
    else:
        sample = column[:: max(1, len(column) // _SAMPLES)]
        if 2 * len(dict.fromkeys(sample)) > len(sample) > 1:
            return _finite(list(map(repr, column)), column, missing)
        memo = {value: repr(value) for value in dict.fromkeys(column)}
    return _finite(list(map(memo.__getitem__, column)), column, missing)


def _finite(texts: list[str], column: list[float], missing: str) -> list[str]:
    """The texts with ``missing`` for what is not finite; a sum finds out whether there is any."""
    total = sum(column)
    if total - total == 0.0:
        return texts
    return [
        text if value - value == 0.0 else missing for text, value in zip(texts, column, strict=True)
    ]


def _by_tick(events: Sequence[Event]) -> Iterable[tuple[int, list[Event]]]:
    """Consecutive events of one tick together."""
    together: list[Event] = []
    for event in events:
        if together and together[0].tick != event.tick:
            yield together[0].tick, together
            together = []
        together.append(event)
    if together:
        yield together[0].tick, together


def join_events(events: Iterable[Event]) -> str:
    """The events of one tick as one text; ``nctakt.trace.reading.split_events`` undoes it."""
    return "; ".join(map(_event_text, events))


def _event_text(event: Event) -> str:
    text = f"{event.kind} {escape(event.text)}"
    if event.span is None and not event.cycle:
        return text
    return f"{text} <{escape(event.cycle) or '-'} {escape(str(event.span or '-'))}>"


def escape(text: str) -> str:
    r"""Mark what divides events (``;``, ``<``), ``\`` itself and line ends with a ``\``."""
    for plain, marked in (("\\", "\\\\"), (";", "\\;"), ("<", "\\<"), ("\n", "\\n"), ("\r", "\\r")):
        text = text.replace(plain, marked)
    return text


def event_object(event: Event) -> dict[str, object]:
    """An event as a JSON object; cycle and place only where there are some."""
    content: dict[str, object] = {"kind": event.kind, "text": event.text}
    if event.cycle:
        content["cycle"] = event.cycle
    if event.span is not None:
        content |= {
            "file": event.span.file,
            "line": event.span.line,
            "column": event.span.column,
            "end_column": event.span.end_column,
        }
    return content


def _json(content: object) -> str:
    return json.dumps(content, ensure_ascii=False)


def _csv_line(cells: Sequence[str]) -> str:
    buffer = io.StringIO()
    csv.writer(buffer, lineterminator="\n").writerow(cells)
    return buffer.getvalue()


def _csv_cell(text: str) -> str:
    if '"' in text or "," in text:
        doubled = text.replace('"', '""')
        return f'"{doubled}"'
    return text

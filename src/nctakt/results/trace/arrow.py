# SPDX-License-Identifier: MIT
"""Traces as Arrow tables and Parquet files (extra ``data``).

In: the chunks of a sink, or a trace in memory. Out: a row per tick: ``tick``, ``time_us``, the
signals, ``events`` as in CSV. Values of integral signals are whole numbers, empty where one is not
a number.
"""

from __future__ import annotations

import importlib
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nctakt.base.failure import Failure
from nctakt.files.output import OutputFile
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import EXTRA_MISSING
from nctakt.messages.extras import install_command
from nctakt.results.trace.events import Event
from nctakt.results.trace.recorded import Trace
from nctakt.results.trace.sinks import Signal, TraceHeader
from nctakt.results.trace.texts import by_tick, join_events

if TYPE_CHECKING:
    import pandas
    import pyarrow

#: Rows that are written together.
GROUP = 65_536


def load_pyarrow(module: str = "") -> Any:
    """Return pyarrow or one of its modules; raises ``Failure`` (901311) if it is missing."""
    try:
        return importlib.import_module(f"pyarrow.{module}" if module else "pyarrow")
    except ImportError as error:
        raise Failure(
            diagnostic(EXTRA_MISSING, package="pyarrow", install=install_command("data"))
        ) from error


def trace_table(trace: Trace) -> pyarrow.Table:
    """Return a trace as a table; raises ``Failure`` (901311) without pyarrow."""
    columns = [trace[signal.name].tolist() for signal in trace.signals]
    cells = _event_cells(trace.events, range(trace.first_tick, trace.first_tick + trace.ticks))
    return _table(trace.signals, trace.cycle_time_us, trace.first_tick, columns, cells)


def _event_cells(events: Sequence[Event], ticks: range) -> list[str]:
    """Return the events of each tick, joined; those after the last row are in it."""
    cells = [""] * len(ticks)
    for tick, together in by_tick(list(events)):
        if cells:
            index = min(tick, ticks.stop - 1) - ticks.start
            cells[index] = "; ".join(filter(None, (cells[index], join_events(together))))
    return cells


def field(name: str, kind: pyarrow.DataType, unit: str) -> pyarrow.Field:
    """Return a column with its unit in the metadata."""
    return load_pyarrow().field(name, kind, metadata={"unit": unit} if unit else None)


def pandas_frame(table: pyarrow.Table) -> pandas.DataFrame:
    """Return a table as a pandas frame with the units of its columns in ``attrs["units"]``."""
    frame = table.to_pandas()
    units = {one.name: (one.metadata or {}).get(b"unit", b"").decode() for one in table.schema}
    frame.attrs["units"] = {name: unit for name, unit in units.items() if unit}
    return frame


def _table(
    signals: Sequence[Signal],
    cycle_time_us: int,
    first_tick: int,
    columns: Sequence[Sequence[float]],
    cells: Sequence[str],
) -> pyarrow.Table:
    arrow = load_pyarrow()
    ticks = range(first_tick, first_tick + len(cells))
    arrays = [
        arrow.array(ticks, arrow.int64()),
        arrow.array([tick * cycle_time_us for tick in ticks], arrow.int64()),
    ]
    fields = [field("tick", arrow.int64(), ""), field("time_us", arrow.int64(), "us")]
    for signal, column in zip(signals, columns, strict=True):
        kind = arrow.int64() if signal.integral else arrow.float64()
        whole = [int(one) if isfinite(one) else None for one in column if signal.integral]
        arrays.append(arrow.array(whole if signal.integral else column, kind))
        fields.append(field(signal.name, kind, signal.unit))
    arrays.append(arrow.array(cells, arrow.string()))
    return arrow.table(arrays, schema=arrow.schema([*fields, field("events", arrow.string(), "")]))


class ParquetSink:
    """Writes a trace to a Parquet file, group by group; the file gets its name when it is whole.

    Raises ``Failure``: no pyarrow (901311), a file that cannot be written (900507).
    """

    def __init__(self, file: Path | OutputFile) -> None:
        load_pyarrow()
        self._target = file
        self._stream: _Stream | None = None
        self._writer: Any = None
        self._header = TraceHeader(0, ())
        self._next_tick = 0
        self._values: list[float] = []
        self._events: list[Event] = []

    def open(self, header: TraceHeader) -> None:
        """Open the file."""
        self._header = header
        target = self._target
        self._stream = _Stream(OutputFile(target) if isinstance(target, Path) else target)
        schema = _table(header.signals, 1, 0, [()] * len(header.signals), ()).schema
        schema = schema.with_metadata({"cycle_time_us": str(header.cycle_time_us)})
        parquet = load_pyarrow("parquet")
        self._writer = parquet.ParquetWriter(self._stream, schema, compression="zstd")

    def events(self, events: Sequence[Event]) -> None:
        """Keep the events for their rows."""
        self._events.extend(events)

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Take the values of ticks; write them when there are many."""
        if not self._values:
            self._next_tick = first_tick
        self._values.extend(rows.tolist())
        if width and len(self._values) >= GROUP * width:
            self._write()

    def _write(self) -> None:
        """Write the rows so far with their events."""
        width = len(self._header.signals)
        count = len(self._values) // max(width, 1)
        ticks = range(self._next_tick, self._next_tick + count)
        if not count:
            return
        columns = [self._values[number::width] for number in range(width)]
        cells = _event_cells(self._events, ticks)
        period = self._header.cycle_time_us
        table = _table(self._header.signals, period, ticks.start, columns, cells)
        self._writer.write_table(table.replace_schema_metadata(self._writer.schema.metadata))
        self._values, self._events = [], []

    def close(self) -> None:
        """Write the rows that are left, and close the file."""
        if self._stream is None or self._stream.closed:
            return
        try:
            self._write()
            self._writer.close()
        finally:
            self._stream.close()


class _Stream:
    """A file as pyarrow writes it."""

    def __init__(self, file: OutputFile) -> None:
        self._file = file
        self._length = 0
        self.closed = False

    def write(self, data: bytes) -> int:
        """Append bytes; return how many."""
        self._file.write(bytes(data))
        self._length += len(data)
        return len(data)

    def tell(self) -> int:
        """Return the number of bytes so far."""
        return self._length

    def flush(self) -> None:
        """Do nothing: each write is at once."""

    def close(self) -> None:
        """Close the file; a second call does nothing."""
        if not self.closed:
            self.closed = True
            self._file.close()

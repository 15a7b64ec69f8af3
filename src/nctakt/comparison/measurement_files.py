# SPDX-License-Identifier: MIT
"""Logs that are no tables in text: MF4 of measuring tools (ASAM MDF), Parquet, traces in JSON.

In: the file. Out: ``Log``; only requested columns are kept. In MF4 each group has its own stamps,
which count from the start of the measurement; a Parquet table has a column of stamps, by its name
or that of a mapping file, and units in the metadata of its fields or in brackets; a trace of nctakt
in JSON has a header with its signals.
"""

from __future__ import annotations

import contextlib
import gc
import importlib
import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path
from typing import Any

import numpy

from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.comparison.columns import STRETCH, Numbers, NumberTable, stretches
from nctakt.comparison.delimited import MAX_LINE
from nctakt.comparison.log import Log, LogColumn, Samples
from nctakt.comparison.plain_table import (
    NOT_SIGNALS,
    TIME_UNITS,
    find_time,
    split_unit,
    time_column,
)
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import (
    LOG_IN_OTHER_FORM,
    NO_ROW_OF_TRACE,
    NO_SIGNAL_IN_LOG,
)
from nctakt.results.trace.arrow import load_pyarrow
from nctakt.results.trace.measurement import load_asammdf
from nctakt.results.trace.sinks import FORMAT_NAME

#: Types of channels of MF4 that are numbers.
_NUMBER_TYPES = frozenset(range(6))
#: Bytes of a column of a Parquet file that are read at a time.
_BUFFER = 1 << 20


class Mf4Log(Log):
    """An MF4 file; raises ``Failure`` for one that cannot be read, and without asammdf (901311)."""

    def __init__(self, path: Path) -> None:
        super().__init__(str(path))
        self._measured = _opened(load_asammdf(), path)
        if self._measured is None:
            raise Failure(diagnostic(LOG_IN_OTHER_FORM, file=self.file))
        self.columns = [
            LogColumn(channel.name, self._unit(number, index), index, number)
            for number, group in enumerate(self._measured.groups)
            for index, channel in enumerate(group.channels)
            if channel.channel_type not in (2, 3) and channel.data_type in _NUMBER_TYPES
        ]
        if not self.columns:
            raise Failure(diagnostic(NO_SIGNAL_IN_LOG, file=self.file))

    def _unit(self, group: int, index: int) -> str:
        return str(self._measured.get_channel_unit(group=group, index=index) or "")

    def read(self, columns: Sequence[LogColumn]) -> list[Samples]:
        """Return the samples of channels."""
        found = []
        for one in columns:
            table = NumberTable(2)
            records = self._measured.groups[one.time_column].channel_group.cycles_nr
            for part in stretches(records):
                signal = self._measured.get(
                    group=one.time_column,
                    index=one.column,
                    record_offset=part.start,
                    record_count=part.stop - part.start,
                )
                stamps = numpy.round(signal.timestamps.astype(float) * 1e9) / 1e3  # whole ns
                table.add(numpy.stack([stamps, signal.samples.astype(float)]).T)
            found.append(self.settled(one.name, table.column(0), table.column(1)))
        return found


def _opened(library: Any, path: Path) -> Any:
    """Return an MF4 file, ``None`` for one that is damaged.

    The library's half-made object fails once more when it is discarded, which Python would print.
    """
    hook, sys.unraisablehook = sys.unraisablehook, lambda _: None
    try:
        with contextlib.suppress(Exception):  # it has no exception class for faults
            return library.MDF(path)
        gc.collect()  # it is part of a cycle
        return None
    finally:
        sys.unraisablehook = hook


class ParquetLog(Log):
    """A Parquet table; raises ``Failure`` as ``Mf4Log``, without pyarrow (901311)."""

    def __init__(self, path: Path, said: Mapping[str, str]) -> None:
        super().__init__(str(path))
        arrow = load_pyarrow()
        parquet = importlib.import_module("pyarrow.parquet")
        try:
            self._file = parquet.ParquetFile(path, buffer_size=_BUFFER)
        except (OSError, arrow.ArrowException) as error:
            raise Failure(diagnostic(LOG_IN_OTHER_FORM, file=self.file)) from error
        schema = self._file.schema_arrow
        cells = [_name_and_unit(one) for one in schema]
        time = find_time(cells, said)
        if time >= 0 and _is_clock(arrow, schema.field(time).type):
            self._time_us = TIME_UNITS[schema.field(time).type.unit]
        else:
            time, self._time_us = time_column(self.file, cells, said)
        self.columns = [
            LogColumn(name, unit, at, time)
            for at, (name, unit) in enumerate(cells)
            if at != time and name not in NOT_SIGNALS and _is_number(arrow, schema.field(at).type)
        ]
        if not self.columns:
            raise Failure(diagnostic(NO_SIGNAL_IN_LOG, file=self.file))

    def _batches(self, names: list[str]) -> Iterator[Any]:
        """Yield rows in parts, group by group: else the library keeps what it has read."""
        for group in range(self._file.num_row_groups):
            yield from self._file.iter_batches(STRETCH, [group], names, use_threads=False)

    def read(self, columns: Sequence[LogColumn]) -> list[Samples]:
        """Return the samples of columns, without empty cells and non-numbers."""
        names = self._file.schema_arrow.names
        time = names[columns[0].time_column]
        asked = [time, *(names[one.column] for one in columns)]
        table = NumberTable(len(asked))
        first: Any = None
        for batch in self._batches(list(set(asked))):
            cells = {name: batch.column(name).to_numpy(zero_copy_only=False) for name in asked}
            if first is None:
                known = cells[time][~_are_missing(cells[time])]
                first = known[0] if len(known) else None
            if first is not None:
                cells[time] = cells[time] - first  # before it is rounded to a float
            numbers = {name: _numbers(column) for name, column in cells.items()}
            numbers[time] *= self._time_us
            table.add(numpy.stack([numbers[name] for name in asked]).T)
        return [
            self.settled(one.name, table.column(0), table.column(at))
            for at, one in enumerate(columns, 1)
        ]


class TraceLines(Log):
    """A trace of nctakt with an object a line; raises ``Failure`` for another one (902510)."""

    def __init__(self, path: Path, access: FileAccess) -> None:
        super().__init__(str(path))
        self._path, self._access = path, access
        _, header = next(self._objects(), (0, {}))
        if header.get("format") != FORMAT_NAME:
            raise Failure(diagnostic(LOG_IN_OTHER_FORM, file=self.file))
        try:
            self.columns = [
                LogColumn(str(one["name"]), str(one["unit"]), at, 0)
                for at, one in enumerate(header["signals"])
            ]
        except (KeyError, TypeError):
            raise self._no_row(1) from None
        if not self.columns:
            raise Failure(diagnostic(NO_SIGNAL_IN_LOG, file=self.file))

    def read(self, columns: Sequence[LogColumn]) -> list[Samples]:
        """Return the samples of columns; raises ``Failure`` for a line without a row (902956)."""
        table = NumberTable(1 + len(columns))
        rows: list[list[float]] = []
        for number, row in islice(self._objects(), 1, None):
            if "values" not in row:  # it has events only
                continue
            try:
                values = [row["values"][one.column] for one in columns]
                rows.append([float(row["time_us"]), *(_number(one) for one in values)])
            except (KeyError, IndexError, TypeError, ValueError):
                raise self._no_row(number) from None
            if len(rows) == STRETCH:
                table.add(numpy.array(rows))
                rows.clear()
        if rows:
            table.add(numpy.array(rows))
        return [
            self.settled(one.name, table.column(0), table.column(at))
            for at, one in enumerate(columns, 1)
        ]

    def _objects(self) -> Iterator[tuple[int, dict[str, Any]]]:
        """Yield the objects with the numbers of their lines, from 1; raises ``Failure``."""
        with self._access.open_text(self._path, "utf-8") as file:
            number = 0
            while line := file.readline(MAX_LINE):
                number += 1
                try:
                    found = json.loads(line)
                except (ValueError, RecursionError):
                    raise self._no_row(number) from None
                if not isinstance(found, dict):
                    raise self._no_row(number)
                yield number, found

    def _no_row(self, number: int) -> Failure:
        return Failure(diagnostic(NO_ROW_OF_TRACE, Span(self.file, number, 1, 1)))


def _number(value: Any) -> float:
    """Return a value of a trace; raises ``TypeError`` and ``ValueError`` for anything else."""
    return numpy.nan if value is None else float(value)


def _are_missing(cells: Any) -> Any:
    return numpy.isnat(cells) if cells.dtype.kind in "mM" else ~numpy.isfinite(cells)


def _numbers(cells: Any) -> Numbers:
    """Return cells as floating-point numbers; empty ones are NaN."""
    numbers: Numbers = cells.astype(float)
    if cells.dtype.kind in "mM":  # dates and spans
        numbers[numpy.isnat(cells)] = numpy.nan
    return numbers


def _name_and_unit(one: Any) -> tuple[str, str]:
    """Return the name of a field without its unit, and the unit."""
    unit = (one.metadata or {}).get(b"unit", b"").decode("utf-8", errors="replace")
    return (one.name, unit) if unit else split_unit(one.name)


def _is_clock(arrow: Any, kind: Any) -> bool:
    return bool(arrow.types.is_timestamp(kind) or arrow.types.is_duration(kind))


def _is_number(arrow: Any, kind: Any) -> bool:
    types = arrow.types
    return bool(types.is_integer(kind) or types.is_floating(kind) or types.is_boolean(kind))

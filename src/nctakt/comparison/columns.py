# SPDX-License-Identifier: MIT
"""Tables of numbers that need not fit into memory: written by rows, read by stretches of a column.

Data longer than ``_IN_MEMORY`` bytes is in a temporary file without a name, which vanishes with the
process.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from typing import Protocol

import numpy
from numpy.typing import NDArray

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import NO_ROOM_FOR_SAMPLES

Numbers = NDArray[numpy.float64]

#: Rows of a block; in the file the columns of a block follow each other.
_BLOCK = 1 << 14
#: Rows that are worked on at a time.
STRETCH = 1 << 16
#: Bytes of a table that stay in memory.
_IN_MEMORY = 16 << 20


class Column(Protocol):
    """A column, by its length and its stretches: an array, or one of a ``NumberTable``."""

    def __len__(self) -> int: ...

    def __getitem__(self, rows: slice, /) -> Numbers: ...


def stretches(length: int) -> Iterator[slice]:
    """Yield the stretches of a column of a length."""
    for begin in range(0, length, STRETCH):
        yield slice(begin, min(begin + STRETCH, length))


def range_of(column: Column) -> float:
    """Return the difference between the greatest and the least value, 0 for an empty column."""
    ends = [(part.min(), part.max()) for part in (column[one] for one in stretches(len(column)))]
    if not ends:
        return 0.0
    return float(max(high for _, high in ends) - min(low for low, _ in ends))


class Part:
    """The rows of a column from ``begin`` to before ``end``."""

    def __init__(self, column: Column, begin: int, end: int) -> None:
        self._column = column
        self._begin = begin
        self._length = end - begin

    def __len__(self) -> int:
        return self._length

    def __getitem__(self, rows: slice, /) -> Numbers:
        begin, end, _ = rows.indices(self._length)
        return self._column[self._begin + begin : self._begin + end]


class NumberTable:
    """Rows of ``width`` numbers; adding some raises ``Failure`` (902730) when the disk is full."""

    def __init__(self, width: int) -> None:
        self._width = width
        self._file = tempfile.SpooledTemporaryFile(_IN_MEMORY)
        self._filling = numpy.empty((width, _BLOCK))
        self._filled = 0
        self._blocks = 0

    def __del__(self) -> None:
        self._file.close()

    def __len__(self) -> int:
        return self._blocks * _BLOCK + self._filled

    def add(self, rows: Numbers) -> None:
        """Add rows of an array, a row each."""
        while len(rows):
            part = rows[: _BLOCK - self._filled]
            self._filling[:, self._filled : self._filled + len(part)] = part.T
            self._filled += len(part)
            rows = rows[len(part) :]
            if self._filled == _BLOCK:
                self._write()

    def _write(self) -> None:
        try:
            self._file.seek(0, 2)
            self._file.write(self._filling.tobytes())
        except OSError as error:
            reason = error.strerror or str(error)
            raise Failure(diagnostic(NO_ROOM_FOR_SAMPLES, reason=reason)) from error
        self._blocks += 1
        self._filled = 0

    def read(self, column: int, begin: int, end: int) -> Numbers:
        """Return a stretch of a column."""
        parts: list[Numbers] = []
        while begin < end:
            block, first = divmod(begin, _BLOCK)
            count = min(end - begin, _BLOCK - first)
            if block == self._blocks:
                parts.append(self._filling[column, first : first + count])
            else:
                self._file.seek(8 * ((block * self._width + column) * _BLOCK + first))
                parts.append(numpy.frombuffer(self._file.read(8 * count)))
            begin += count
        return numpy.concatenate(parts) if parts else numpy.empty(0)

    def column(self, number: int) -> Column:
        """Return a column, from 0."""
        return _TableColumn(self, number)


class _TableColumn:
    """A column of a table."""

    def __init__(self, table: NumberTable, number: int) -> None:
        self._table = table
        self._number = number

    def __len__(self) -> int:
        return len(self._table)

    def __getitem__(self, rows: slice, /) -> Numbers:
        begin, end, _ = rows.indices(len(self._table))
        return self._table.read(self._number, begin, end)

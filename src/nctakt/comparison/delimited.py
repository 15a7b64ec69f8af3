# SPDX-License-Identifier: MIT
"""Tables in text: separator, decimal mark, encoding, and the samples of their columns.

Parts of a million characters are read in turn, so that a log may have any length; only requested
columns are kept, as numbers of 8 bytes outside the memory.
"""

from __future__ import annotations

import array
import importlib
import io
import math
import operator
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.comparison.columns import NumberTable
from nctakt.comparison.log import Log, LogColumn, Samples
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import (
    BYTE_NOT_OF_ENCODING,
    LOG_TEXT_CUT,
    NO_NUMBER_IN_LOG,
)

#: Stamps of this size and more are FILETIME: 100 ns since 1601 (LG-109); 10^16 are the year 1632.
_FILETIME = 10**16
#: Microseconds of a FILETIME.
_FILETIME_US = 0.1
#: Longest line of a log, in characters.
MAX_LINE = 1 << 20
#: How an export marks its end (LG-106).
END_MARK = "EOF"

#: The replacement for bytes that the encoding does not have.
_REPLACED = "\ufffd"

#: Gives the cells of a column of some lines.
_Texts = Callable[[int], Sequence[str]]


@dataclass(slots=True)
class _Origin:
    """The first FILETIME of a log, from which its others count exactly."""

    filetime: int | None = None


class Table(Log):
    """A table in text, of which header and layout are known.

    ``begin``: the number of the first line with samples, from 1; ``time_us``: microseconds of a
    unit of its stamps; ``period_us``: those between two rows of a table without stamps;
    ``decimal``: the decimal mark, "" if comma and point both may be one.
    """

    def __init__(self, path: Path, access: FileAccess, encoding: str) -> None:
        super().__init__(str(path))
        self._path = path
        self._access = access
        self.encoding = encoding
        self.separator = ";"
        self.decimal = ""
        self.begin = 1
        self.time_us = 1000.0
        self.period_us = 0.0

    def lines(self) -> Iterator[tuple[int, str]]:
        """Yield the lines with their numbers, from 1, without their ends."""
        with self._access.open_text(self._path, self.encoding) as file:
            number = 0
            while line := file.readline(MAX_LINE):
                number += 1
                if len(line) == MAX_LINE:
                    raise Failure(diagnostic(LOG_TEXT_CUT, file=self.file, line=number))
                yield number, line.rstrip("\r\n")

    def read(self, columns: Sequence[LogColumn]) -> list[Samples]:
        stamps = list(dict.fromkeys(one.time_column for one in columns))
        table = NumberTable(len(stamps) + len(columns))
        origin = _Origin()
        quick = _QuickNumbers(stamps, [one.column for one in columns])
        for first, lines in self._parts():
            found = quick.read(lines, self.separator, has_comma=self._has_comma)
            if found is None:
                texts = _cells(lines, self.separator)
                numbers = range(first, first + len(lines))
                found = [self._stamps(texts, at, numbers, origin) for at in stamps]
                found += [self._numbers(texts(one.column), numbers) for one in columns]
            else:
                found[: len(stamps)] = (one * self.time_us for one in found[: len(stamps)])
            table.add(numpy.stack(found).T)
        return [
            self.settled(
                one.name,
                table.column(stamps.index(one.time_column)),
                table.column(len(stamps) + number),
            )
            for number, one in enumerate(columns)
        ]

    def _parts(self) -> Iterator[tuple[int, list[str]]]:
        """Yield the lines with samples in parts, with the number of the first one of each."""
        number, rest = 1, ""
        with self._access.open_text(self._path, self.encoding) as file:
            while True:
                text = file.read(MAX_LINE)
                lines = (rest + text).split("\n")
                rest = lines.pop() if text or not lines[-1] else ""
                if len(rest) >= MAX_LINE:
                    raise Failure(
                        diagnostic(LOG_TEXT_CUT, file=self.file, line=number + len(lines))
                    )
                end = self._end_of(lines) if END_MARK in text else None
                begin = max(self.begin - number, 0)
                if begin < len(lines[:end]):
                    yield number + begin, lines[begin:end]
                if not text or end is not None:
                    return
                number += len(lines)

    def _end_of(self, lines: Sequence[str]) -> int | None:
        """Return the index of the line with the mark of the end, ``None`` without one."""
        firsts = (line.partition(self.separator)[0].strip() for line in lines)
        return next((at for at, first in enumerate(firsts) if first == END_MARK), None)

    def _stamps(
        self, texts: _Texts, at: int, numbers: range, origin: _Origin
    ) -> NDArray[numpy.float64]:
        """Return stamps in µs, those of FILETIME since the first of a log."""
        if at < 0:
            rows = numpy.arange(numbers.start, numbers.stop, dtype=numpy.float64)
            return (rows - self.begin) * self.period_us
        found = self._numbers(cells := texts(at), numbers) * self.time_us
        for row in numpy.flatnonzero(found >= _FILETIME * self.time_us).tolist():
            if cells[row].strip().isdigit():
                ticks = int(cells[row])
                origin.filetime = ticks if origin.filetime is None else origin.filetime
                found[row] = (ticks - origin.filetime) * _FILETIME_US
        return found

    @property
    def _has_comma(self) -> bool:
        return self.decimal == "," or (not self.decimal and self.separator != ",")

    def _numbers(self, cells: Sequence[str], numbers: range) -> NDArray[numpy.float64]:
        """Return cells as numbers; empty ones are NaN."""
        plain = "\n".join(cells).replace(",", ".").split("\n") if self._has_comma else cells
        try:
            return numpy.array(array.array("d", map(float, plain)))
        except ValueError:
            stripped = [cell.strip() for cell in cells]
            return numpy.array(list(map(self._number, stripped, plain, numbers)))

    def _number(self, text: str, plain: str, line: int) -> float:
        try:
            return float(plain) if text else math.nan
        except ValueError:
            truth = {"TRUE": 1.0, "FALSE": 0.0}.get(text.upper())
            if truth is not None:
                return truth
            if _REPLACED in text:
                raise self._not_of_encoding(line) from None
            span = Span(self.file, line, 1, 1)
            raise Failure(diagnostic(NO_NUMBER_IN_LOG, span, text=text[:40])) from None

    def _not_of_encoding(self, line: int) -> Failure:
        """Return the failure of a line with bytes that are no characters."""
        text = next(text for number, text in self.lines() if number == line)
        column = text.index(_REPLACED) + 1
        span = Span(self.file, line, column, column + 1)
        return Failure(diagnostic(BYTE_NOT_OF_ENCODING, span, encoding=self.encoding.upper()))


def _cells(lines: Sequence[str], separator: str) -> _Texts:
    """Return a getter of the cells of a column, "" if a line is too short."""
    counts = set(map(operator.methodcaller("count", separator), lines))
    if len(counts) == 1:
        width = counts.pop() + 1
        cells = separator.join(lines).split(separator)
        return lambda at: cells[at::width] if at < width else [""] * len(lines)
    rows = [line.split(separator) for line in lines]
    return lambda at: [row[at] if at < len(row) else "" for row in rows]


class _QuickNumbers:
    """Reads lines that are a table of plain numbers several times as fast, if pyarrow is installed.

    They are the numbers that ``float`` reads; the columns of ``stamps`` come first.
    """

    def __init__(self, stamps: Sequence[int], columns: Sequence[int]) -> None:
        self._asked = [*stamps, *columns]
        self._stamps = len(stamps)
        try:
            self._csv: Any = importlib.import_module("pyarrow.csv")
        except ImportError:  # an extra
            self._csv = None

    def read(
        self, lines: Sequence[str], separator: str, *, has_comma: bool
    ) -> list[NDArray[numpy.float64]] | None:
        """Return the columns of lines, ``None`` if they are not a table of plain numbers."""
        csv = self._csv
        width = lines[0].count(separator) + 1
        if (
            csv is None
            or len(separator) > 1
            or not 0 <= min(self._asked) <= max(self._asked) < width
        ):
            return None
        names = list(map(str, range(width)))
        text = "\n".join(lines)
        asked = [names[at] for at in self._asked]
        try:
            table = csv.read_csv(
                io.BytesIO((text.replace(",", ".") if has_comma else text).encode()),
                csv.ReadOptions(use_threads=False, block_size=1 << 24, column_names=names),
                csv.ParseOptions(delimiter=separator, quote_char=False, ignore_empty_lines=False),
                csv.ConvertOptions(
                    column_types=dict.fromkeys(asked, "float64"),
                    include_columns=list(dict.fromkeys(asked)),
                    null_values=[""],
                ),
            )
        except (ValueError, UnicodeError):  # pyarrow's faults are a kind of the first
            return None
        found = [table.column(name).to_numpy().astype(float, copy=False) for name in asked]
        stamps = found[: self._stamps]
        is_exact = all((numpy.abs(one) < _FILETIME).all() for one in stamps)
        return found if is_exact and table.num_rows == len(lines) else None

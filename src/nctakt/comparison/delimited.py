# SPDX-License-Identifier: MIT
"""Tables in text: separator, decimal mark, encoding, and the samples of their columns.

Lines are read one after another, so that a log may have any length; only the columns that are
asked for are kept, as numbers of 8 bytes.
"""

from __future__ import annotations

import array
import math
from collections.abc import Iterator, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.comparison.log import Log, LogColumn, Samples
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.comparison import LOG_TEXT_CUT, NO_NUMBER_IN_LOG

#: Stamps of this size and more are FILETIME: 100 ns since 1601 (LG-109); 10^16 are the year 1632.
_FILETIME = 10**16
#: Microseconds of a FILETIME.
_FILETIME_US = 0.1
#: Longest line of a log, in characters.
MAX_LINE = 1 << 20
#: How an export marks its end (LG-106).
END_MARK = "EOF"


@dataclass(slots=True)
class _Origin:
    """The first FILETIME of a log, from which its others count exactly."""

    filetime: int | None = None


@dataclass(frozen=True, slots=True)
class _Gathered:
    """Stamps and values of a column while they are read."""

    column: LogColumn
    times: array.array[float]
    values: array.array[float]


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
        times = {one.time_column: array.array("d") for one in columns}
        gathered = [_Gathered(one, array.array("d"), array.array("d")) for one in columns]
        origin = _Origin()
        for number, line in self.lines():
            if number < self.begin or not line.strip():
                continue
            cells = line.split(self.separator)
            if cells[0].strip() == END_MARK:
                break
            stamps = {
                at: self._stamp(cells, at, number - self.begin, origin, number) for at in times
            }
            for one in gathered:
                self._take(one, cells, stamps[one.column.time_column], number)
        return [self._samples(one) for one in gathered]

    def _stamp(
        self, cells: Sequence[str], at: int, row: int, origin: _Origin, line: int
    ) -> float | None:
        """Return the stamp of a row in µs since the first one of this column's kind."""
        if at < 0:
            return row * self.period_us
        text = cells[at].strip() if at < len(cells) else ""
        if not text:
            return None
        if text.lstrip("-").isdigit() and int(text) >= _FILETIME:
            ticks = int(text)
            origin.filetime = ticks if origin.filetime is None else origin.filetime
            return (ticks - origin.filetime) * _FILETIME_US
        return self._number(text, line) * self.time_us

    def _take(self, one: _Gathered, cells: Sequence[str], stamp: float | None, line: int) -> None:
        at = one.column.column
        text = cells[at].strip() if at < len(cells) else ""
        if stamp is None or not text:
            return
        value = self._number(text, line)
        if math.isfinite(value):
            one.times.append(stamp)
            one.values.append(value)

    def _number(self, text: str, line: int) -> float:
        try:
            has_comma = self.decimal == "," or (not self.decimal and self.separator != ",")
            return float(text.replace(",", ".") if has_comma else text)
        except ValueError:
            truth = {"TRUE": 1.0, "FALSE": 0.0}.get(text.upper())
            if truth is not None:
                return truth
            span = Span(self.file, line, 1, 1)
            raise Failure(diagnostic(NO_NUMBER_IN_LOG, span, text=text[:40])) from None

    def _samples(self, one: _Gathered) -> Samples:
        import numpy  # noqa: PLC0415 - opening a log does not need it

        times = numpy.frombuffer(one.times, dtype=numpy.float64).copy()
        values = numpy.frombuffer(one.values, dtype=numpy.float64)
        return self.settled(one.column.name, times, values)

# SPDX-License-Identifier: MIT
"""Tables in text with a row of names and a column of stamps: nctakt's traces and any CSV.

In: the text, and its section of a mapping file (``[log]``). Names may carry units in brackets,
``Position X [mm]``. A table of a kind without stamps has its period in a comment (LG-301).
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.comparison.delimited import Table
from nctakt.comparison.log import LogColumn
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import (
    COMMA_FOR_BOTH,
    NO_NAMES_IN_LOG,
    NO_SIGNAL_IN_LOG,
    NO_TIME_IN_LOG,
    TIME_UNIT_UNKNOWN,
)

#: Names of time columns; a unit may follow: ``time_ms``.
_TIME = re.compile(
    r"(?:t|time|zeit|timestamp|zeitstempel)(?:_(?P<unit>[num\u00b5\u03bc]?s|min))?", re.I
)
#: Microseconds of the units of stamps; the second µ is the Greek letter.
TIME_UNITS = {
    "ns": 1e-3, "us": 1.0, "µs": 1.0, "\u03bcs": 1.0, "ms": 1e3, "s": 1e6, "sec": 1e6, "min": 6e7,
    "h": 3.6e9,
}  # fmt: skip
#: Columns of nctakt's traces that are not signals.
NOT_SIGNALS = ("tick", "events")
_UNIT = re.compile(r"\s*[\[(]([^\[\]()]*)[\])]\s*$")
_PERIOD = re.compile(r"sampling period\D*(\d+)\s*ns", re.IGNORECASE)


class PlainTable(Table):
    """A table with names, open to be read; ``said``: its ``[log]`` in a mapping file."""

    def __init__(
        self, path: Path, access: FileAccess, encoding: str, said: Mapping[str, str]
    ) -> None:
        super().__init__(path, access, encoding)
        self._said = said
        self.decimal = said.get("decimal", "")
        names = self._read_names()
        cells = [split_unit(name) for name in names]
        time = self._time_column(cells)
        self.columns = [
            LogColumn(name, unit, at, time)
            for at, (name, unit) in enumerate(cells)
            if at != time and name and name not in NOT_SIGNALS
        ]
        if not self.columns:
            raise Failure(diagnostic(NO_SIGNAL_IN_LOG, file=self.file))

    def _read_names(self) -> list[str]:
        """Return the cells of the row of names; find separator and first row."""
        row, names_at = "", 0
        for number, line in self.lines():
            period = _PERIOD.search(line)
            if period is not None:
                self.period_us = int(period[1]) / 1e3
            if not line.strip() or line.startswith("#"):
                continue
            if row:
                self.begin = number
                return self._names(row, line, names_at)
            row, names_at = line, number
        if row:
            self._names(row, "", names_at)
        raise Failure(diagnostic(NO_SIGNAL_IN_LOG, file=self.file))

    def _names(self, row: str, line: str, number: int) -> list[str]:
        """Return the cells of a row of names, which has a number; ``line``: the next row."""
        self.separator = self._said.get("separator") or _separator_of(row, line)
        names = [cell.strip().strip('"') for cell in row.split(self.separator)]
        if any(map(_is_number, names)):
            raise Failure(diagnostic(NO_NAMES_IN_LOG, file=self.file, line=number))
        if self.separator == "," and len(line.rstrip(", ").split(",")) > len(names):
            raise Failure(diagnostic(COMMA_FOR_BOTH, file=self.file))
        return names

    def _time_column(self, cells: Sequence[tuple[str, str]]) -> int:
        """Return the column of the stamps, -1 for a table with a period."""
        if self.period_us and "time" not in self._said and find_time(cells, self._said) < 0:
            return -1
        at, self.time_us = time_column(self.file, cells, self._said)
        return at


def find_time(cells: Sequence[tuple[str, str]], said: Mapping[str, str]) -> int:
    """Return which of the columns, names with units, has the stamps; -1 for none."""
    named = said.get("time", "").lower()
    for at, (name, _) in enumerate(cells):
        if name.lower() == named if named else _TIME.fullmatch(name):
            return at
    return -1


def time_column(
    file: str, cells: Sequence[tuple[str, str]], said: Mapping[str, str]
) -> tuple[int, float]:
    """Return the column of the stamps and their unit in µs; raises ``Failure`` (902511, 902955).

    ``said``: the ``[log]`` of a mapping file, which overrides the name.
    """
    at = find_time(cells, said)
    if at < 0:
        raise Failure(diagnostic(NO_TIME_IN_LOG, file=file))
    name, unit = cells[at]
    match = _TIME.fullmatch(name)
    word = said.get("time_unit") or unit or (match and match["unit"]) or "s"
    if word.lower() not in TIME_UNITS:
        units = ", ".join(one for one in TIME_UNITS if one.isascii())
        raise Failure(diagnostic(TIME_UNIT_UNKNOWN, file=file, unit=word, units=units))
    return at, TIME_UNITS[word.lower()]


def split_unit(name: str) -> tuple[str, str]:
    """Return name and unit of ``Position X [mm]``."""
    found = _UNIT.search(name)
    return (name, "") if found is None else (name[: found.start()].strip(), found[1].strip())


def _separator_of(names: str, values: str) -> str:
    """Return the separator of names and values: tab, semicolon or comma.

    It is in both rows equally often; names may have commas, values decimal ones. If none is, it is
    the most frequent one in the names.
    """
    both = [one for one in "\t;," if 0 < names.count(one) == values.count(one)]
    return both[0] if both else max("\t;,", key=names.count)


def _is_number(text: str) -> bool:
    return re.fullmatch(r"[+-]?\d+([.,]\d+)?([eE][+-]?\d+)?", text) is not None

# SPDX-License-Identifier: MIT
"""Exports of TwinCAT Scope as text (LG-101 … LG-111).

An export is several tables side by side, each with its own time column on the left, which repeats
the key of each header row. Rows are found by their keys, never by line numbers. The file does not
say whether values are scaled: they are used unchanged.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.comparison.delimited import Table
from nctakt.comparison.log import LogColumn
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import COMMA_FOR_BOTH, NO_SIGNAL_IN_LOG, SCALE_IN_LOG

#: The keys of header rows, in lower case.
_KEYS = frozenset((
    "name", "file", "starttime of export", "endtime of export", "symbolcomment", "data-type",
    "sampletime[ms]", "variablesize", "symbolbased", "indexgroup", "indexoffset", "symbolname",
    "netid", "port", "offset", "scalefactor", "bitmask", "unit", "unit scalefactor", "unit offset",
    "starttime", "endtime", "startrecord", "endrecord",
))  # fmt: skip
#: How an export spells a missing unit.
_NO_UNIT = "(None)"
_SEPARATORS = "\t;,: "
#: A factor or an offset that changes nothing.
_NEUTRAL = {"scalefactor": "1", "offset": "0", "unit scalefactor": "1", "unit offset": "0"}


def is_scope_export(first_line: str) -> bool:
    """Return whether a text begins as an export does: ``Name`` and a separator."""
    return first_line[:4].lower() == "name" and first_line[4:5] in tuple(_SEPARATORS)


class ScopeExport(Table):
    """An export, open for reading; raises ``Failure`` if it cannot be understood."""

    def __init__(self, path: Path, access: FileAccess, encoding: str) -> None:
        super().__init__(path, access, encoding)
        self._rows: dict[str, list[str]] = {}
        first_row = self._read_header()
        names = self._rows.get("name", [])
        width = len(names)
        if self.separator == "," and len(first_row) > width + 1:
            raise Failure(diagnostic(COMMA_FOR_BOTH, file=self.file))
        self.columns = self._columns(names)
        if not self.columns:
            raise Failure(diagnostic(NO_SIGNAL_IN_LOG, file=self.file))
        self._report_scales()

    def _read_header(self) -> list[str]:
        """Find the header rows and the first one with samples; return its cells."""
        number = 0
        for number, line in self.lines():
            if number == 1:
                self.separator = line[4]
            cells = line.split(self.separator)
            key = cells[0].strip().lower()
            if key in _KEYS:
                self._rows[key] = [cell.strip() for cell in cells]
            elif _is_number(cells):
                self.begin = number
                return cells
        self.begin = number + 1
        return []

    def _columns(self, names: Sequence[str]) -> list[LogColumn]:
        units = self._rows.get("unit", [])
        is_known = len(units) == len(names)  # a decimal comma in a row makes it longer (LG-108)
        times = [at for at, name in enumerate(names) if name.lower() == "name"]
        found = []
        for time, following in pairwise([*times, len(names)]):
            for at in range(time + 1, following):
                if names[at]:
                    unit = units[at].partition(" ")[0] if is_known else ""
                    unit = "" if unit == _NO_UNIT else unit
                    found.append(LogColumn(names[at], unit, at, time))
        return found

    def _report_scales(self) -> None:
        """Report rows with another scale: whether the values include it is not known (LG-105)."""
        for column in self.columns:
            rows = {
                key: self._rows[key][column.column]
                for key in _NEUTRAL
                if column.column < len(self._rows.get(key, ()))
            }
            other = {key: text for key, text in rows.items() if text not in ("", _NEUTRAL[key])}
            if other:
                shown = ", ".join(f"{key} {text}" for key, text in other.items())
                self.notes.append(diagnostic(SCALE_IN_LOG, name=column.name, rows=shown))


def _is_number(cells: Sequence[str]) -> bool:
    """Return whether a row begins with a stamp and has values."""
    try:
        float(cells[0].strip().replace(",", "."))
    except ValueError:
        return False
    return len(cells) > 1

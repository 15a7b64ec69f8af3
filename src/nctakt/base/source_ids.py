# SPDX-License-Identifier: MIT
"""Places in the users' texts as single numbers, for what the realtime part records.

In: file index, line, column. Out: one integer below 2**53, which a float64 cell holds exactly, and
the way back to a ``Span``. The number is ``file << 44 | line << 20 | column``; line and column
count from 1, and 0 means that there is no place.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Span

_COLUMN_BITS = 20
_LINE_BITS = 24
_LINE_SHIFT = _COLUMN_BITS
_FILE_SHIFT = _COLUMN_BITS + _LINE_BITS

#: The last column and the last line that have numbers of their own; what lies behind shares them.
LAST_COLUMN = (1 << _COLUMN_BITS) - 1
LAST_LINE = (1 << _LINE_BITS) - 1

#: Files with a place of their own; what stands in any further file has none.
FILE_LIMIT = 1 << (53 - _FILE_SHIFT)

NO_SOURCE = 0


def pack(file_index: int, line: int, column: int) -> int:
    """The number of a place; ``NO_SOURCE`` in a file beyond ``FILE_LIMIT``.

    ``file_index`` counts from 0, ``line`` and ``column`` from 1. A user's text may be longer than
    the numbers reach: such a line or column gets the last number.
    """
    assert file_index >= 0, file_index
    assert line >= 1, line
    assert column >= 1, column
    if file_index >= FILE_LIMIT:
        return NO_SOURCE
    return (
        file_index << _FILE_SHIFT | min(line, LAST_LINE) << _LINE_SHIFT | min(column, LAST_COLUMN)
    )


def unpack(source: int) -> tuple[int, int, int]:
    """File index, line and column of a number that ``pack`` made; ``(0, 0, 0)`` for no place."""
    return source >> _FILE_SHIFT, source >> _LINE_SHIFT & LAST_LINE, source & LAST_COLUMN


class SourceFiles:
    """The texts that numbers of places refer to, in the order in which they were added."""

    def __init__(self) -> None:
        self._files: list[tuple[str, Sequence[str]]] = []
        self._by_name: dict[str, int] = {}

    def __len__(self) -> int:
        return len(self._files)

    def add(self, file: str, lines: Sequence[str]) -> int:
        """The index of the text ``lines`` named ``file``.

        A text that was added before under the same name keeps its index, so that a program which
        runs again and again does not use up the indices.
        """
        known = self._by_name.get(file)
        if known is not None and self._files[known][1] == lines:
            return known
        self._files.append((file, lines))
        self._by_name[file] = len(self._files) - 1
        return len(self._files) - 1

    def number(self, span: Span) -> int:
        """The number of the place where a span begins; ``NO_SOURCE`` in a text never added."""
        file_index = self._by_name.get(span.file)
        if file_index is None:
            return NO_SOURCE
        return pack(file_index, span.line, span.column)

    def place(self, source: int) -> Span | None:
        """The place as a span of one character; ``None`` for ``NO_SOURCE``."""
        file_index, line, column = unpack(source)
        if line == 0 or file_index >= len(self._files):
            return None
        return Span(self._files[file_index][0], line, column, column + 1)

    def line_of(self, source: int) -> str:
        """The whole text line of the place, without its end; empty when there is none."""
        file_index, line, _ = unpack(source)
        return self._line(file_index, line)

    def line_at(self, span: Span) -> str:
        """The whole text line of a span, in the text that was last added under its file name."""
        file_index = self._by_name.get(span.file)
        return "" if file_index is None else self._line(file_index, span.line)

    def _line(self, file_index: int, line: int) -> str:
        if line == 0 or file_index >= len(self._files):
            return ""
        lines = self._files[file_index][1]
        return lines[line - 1] if line <= len(lines) else ""


def begins_at(span: Span, place: Span | None) -> bool:
    """Whether a span begins at the place that an event knows."""
    if place is None:
        return False
    return (span.file, span.line, span.column) == (place.file, place.line, place.column)


_STATEMENT = re.compile(
    r"""[#$VP@] (?: "[^"]*" | \[ (?:[^\[\]]|\[[^\[\]]*\])* \] | [^;("\[\]] )* (?<!\s)
        | [^\W\d][\w.]*""",
    re.VERBOSE | re.IGNORECASE,
)


def statement_span(span: Span | None, line: str) -> Span | None:
    """The place of an event, which knows only where it begins, up to the end of what stands there.

    Of a ``#`` or ``$`` statement and of an assignment that is all of it, else its word.
    """
    if span is None:
        return None
    found = _STATEMENT.match(line, span.column - 1)
    return span if found is None else replace(span, end_column=found.end() + 1)

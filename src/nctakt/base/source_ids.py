# SPDX-License-Identifier: MIT
"""Source ids: positions in the users' texts as single numbers, for the realtime part's records.

In: file index, line, column. Out: one integer below 2**53, which a float64 cell holds exactly, and
back to a ``Span``. The number is ``file << 44 | line << 20 | column``; line and column count from
1, and 0 means no position.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Span

_COLUMN_BITS = 20
_LINE_BITS = 24
_LINE_SHIFT = _COLUMN_BITS
_FILE_SHIFT = _COLUMN_BITS + _LINE_BITS

#: The last column and the last line with separate numbers; later ones share them.
LAST_COLUMN = (1 << _COLUMN_BITS) - 1
LAST_LINE = (1 << _LINE_BITS) - 1

#: The number of files with source ids; positions in any further file have none.
FILE_LIMIT = 1 << (53 - _FILE_SHIFT)

NO_SOURCE = 0


def pack(file_index: int, line: int, column: int) -> int:
    """Return the source id of a position; ``NO_SOURCE`` in a file beyond ``FILE_LIMIT``.

    ``file_index`` counts from 0, ``line`` and ``column`` from 1. Lines and columns beyond the last
    number share it.
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
    """Return file index, line and column of a source id; ``(0, 0, 0)`` for ``NO_SOURCE``."""
    return source >> _FILE_SHIFT, source >> _LINE_SHIFT & LAST_LINE, source & LAST_COLUMN


class SourceFiles:
    """The texts that source ids refer to, in the order in which they were added."""

    def __init__(self) -> None:
        self._files: list[tuple[str, Sequence[str]]] = []
        self._by_name: dict[str, int] = {}

    def __len__(self) -> int:
        return len(self._files)

    def add(self, file: str, lines: Sequence[str]) -> int:
        """Add the text ``lines`` named ``file`` and return its index.

        A text that was added before under the same name keeps its index, so that a program which
        runs again and again does not use up the indices.
        """
        index = self._by_name.get(file)
        if index is not None and self._files[index][1] == lines:
            return index
        self._files.append((file, lines))
        self._by_name[file] = len(self._files) - 1
        return len(self._files) - 1

    def copy(self) -> SourceFiles:
        """Return the present texts, without later additions."""
        other = SourceFiles()
        other._files, other._by_name = list(self._files), dict(self._by_name)
        return other

    @contextlib.contextmanager
    def untouched(self) -> Iterator[None]:
        """Forget the texts that are added inside at the end."""
        files, by_name = list(self._files), dict(self._by_name)
        try:
            yield
        finally:
            self._files[:] = files
            self._by_name = by_name

    @property
    def names(self) -> list[str]:
        """The names of the texts, by index."""
        return [name for name, _ in self._files]

    def number(self, span: Span) -> int:
        """Return the source id of the begin of a span; ``NO_SOURCE`` in a text never added."""
        file_index = self._by_name.get(span.file)
        if file_index is None:
            return NO_SOURCE
        return pack(file_index, span.line, span.column)

    def span(self, source: int) -> Span | None:
        """Return the position as a span of one character; ``None`` for ``NO_SOURCE``."""
        file_index, line, column = unpack(source)
        if line == 0 or file_index >= len(self._files):
            return None
        return Span(self._files[file_index][0], line, column, column + 1)

    def line_of(self, source: int) -> str:
        """Return the text line of a position without its end; empty if there is none."""
        file_index, line, _ = unpack(source)
        return self._line(file_index, line)

    def line_at(self, span: Span) -> str:
        """Return the text line of a span, in the text that was last added under its file name."""
        file_index = self._by_name.get(span.file)
        return "" if file_index is None else self._line(file_index, span.line)

    def _line(self, file_index: int, line: int) -> str:
        if line == 0 or file_index >= len(self._files):
            return ""
        lines = self._files[file_index][1]
        return lines[line - 1] if line <= len(lines) else ""


def begins_at(span: Span, begin: Span | None) -> bool:
    """Return whether a span begins at the position of an event."""
    if begin is None:
        return False
    return (span.file, span.line, span.column) == (begin.file, begin.line, begin.column)


_STATEMENT = re.compile(
    r"""[#$VP@] (?: "[^"]*" | \[ (?:[^\[\]]|\[[^\[\]]*\])* \] | [^;("\[\]] )* (?<!\s)
        | [^\W\d][\w.]*""",
    re.VERBOSE | re.IGNORECASE,
)


def statement_span(span: Span | None, line: str) -> Span | None:
    """Extend the position of an event, which has no end, to its whole statement or word.

    A ``#`` or ``$`` statement and an assignment are taken as a whole, otherwise one word.
    """
    if span is None:
        return None
    match = _STATEMENT.match(line, span.column - 1)
    return span if match is None else replace(span, end_column=match.end() + 1)

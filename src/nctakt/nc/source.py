# SPDX-License-Identifier: MIT
"""The text of an NC program with its name, so that a span can be shown with its line.

In: lines without their ends. Out: the same lines by number. The sequence may be read lazily.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.base.long_text import LongText

#: Lines of a text in memory that are read as one group.
GROUP_LINES = 20_000


@dataclass(frozen=True, slots=True)
class Source:
    """An NC text: ``file`` is the name as the user gave it; ``lines`` count from 1 in every
    span.
    """

    file: str
    lines: Sequence[str]

    def groups(self, first: int = 1) -> Iterator[list[str]]:
        """Return the lines from line ``first`` on, in groups."""
        if isinstance(self.lines, LongText):
            return self.lines.groups(first - 1)
        if isinstance(self.lines, list):
            lines = self.lines
            starts = range(first - 1, len(lines), GROUP_LINES)
            return (lines[start : start + GROUP_LINES] for start in starts)
        return ([line] for line in islice(self.lines, first - 1, None))

    def line_of(self, span: Span | None) -> str:
        """Return the whole line of a span; empty without a span or outside the text."""
        if span is None or not 1 <= span.line <= len(self.lines):
            return ""
        return self.lines[span.line - 1]


class LineReader:
    """Reads a source line by line: ``group[index]`` is the next line, ``number`` its number.

    The caller advances ``index``; ``more`` fetches the next group at the end of this one.
    """

    __slots__ = ("_first", "_groups", "group", "index")

    def __init__(self, source: Source, first: int = 1) -> None:
        self._groups = source.groups(first)
        self._first = first  # number of the first line of the group
        self.group: list[str] = []
        self.index = 0

    @property
    def number(self) -> int:
        """The number of the next line."""
        return self._first + self.index

    def more(self) -> bool:
        """Fetch the next group if this one is used up; return whether there is a next line."""
        while self.index >= len(self.group):
            group = next(self._groups, None)
            if group is None:
                return False
            self._first += len(self.group)
            self.group = group
            self.index = 0
        return True

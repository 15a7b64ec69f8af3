# SPDX-License-Identifier: MIT
"""Line numbers of a text after some of its lines have been replaced.

In: which lines were replaced, by how many. Out: the new number of any other line.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span

#: Lines that are compared at once.
_BLOCK = 1 << 14


class ReplacedLine(Exception):
    """A line was replaced, so that it has no new number."""


@dataclass(frozen=True, slots=True)
class LineShift:
    """The lines from ``first`` up to but not ``end`` (from 1) became ``by`` more lines.

    While the number of lines is the same, each line keeps its number, replaced or not.
    """

    first: int
    end: int
    by: int

    @property
    def new_end(self) -> int:
        """The new number of the line ``end``."""
        return self.end + self.by

    def line(self, line: int) -> int:
        """Return the new number of a line; raises ``ReplacedLine``."""
        if not self.by or line < self.first:
            return line
        if line < self.end:
            raise ReplacedLine
        return line + self.by

    def span(self, span: Span) -> Span:
        """Return where a span is now; raises ``ReplacedLine``."""
        line = self.line(span.line)
        return span if line == span.line else replace(span, line=line)

    def diagnostic(self, found: Diagnostic) -> Diagnostic:
        """Return a diagnostic with its span and the line that it names; raises ``ReplacedLine``."""
        if not self.by:
            return found
        values = found.values
        line = values.get("line")
        if isinstance(line, int):
            values = {**values, "line": self.line(line)}
        span = None if found.span is None else self.span(found.span)
        return replace(found, span=span, values=values)


def shift_between(old: Sequence[str], new: Sequence[str]) -> LineShift | None:
    """Return which lines of ``old`` differ in ``new``, ``None`` if all are equal."""
    if isinstance(old, list) and isinstance(new, list):
        shortest = min(len(old), len(new))
        same = _equal_lines(old, new, shortest)
        if same == len(old) == len(new):
            return None
        at_the_end = _equal_lines_at_the_end(old, new, shortest - same)
    elif old == new:
        return None
    else:
        same = at_the_end = 0
    return LineShift(same + 1, len(old) - at_the_end + 1, len(new) - len(old))


def _equal_lines(old: list[str], new: list[str], limit: int) -> int:
    """Return how many lines both begin with, at most ``limit``."""
    count, step = 0, _BLOCK
    while step:
        end = min(count + step, limit)
        if end > count and old[count:end] == new[count:end]:
            count = end
        else:
            step //= 2
    return count


def _equal_lines_at_the_end(old: list[str], new: list[str], limit: int) -> int:
    """Return how many lines both end with, at most ``limit``."""
    count, step = 0, _BLOCK
    while step:
        end = min(count + step, limit)
        if end > count and (
            old[len(old) - end : len(old) - count] == new[len(new) - end : len(new) - count]
        ):
            count = end
        else:
            step //= 2
    return count

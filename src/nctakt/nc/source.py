# SPDX-License-Identifier: MIT
"""The text of an NC program with its name, so that a span can be shown with its line.

In: lines without their ends. Out: the same lines by number. The sequence may read lazily.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from nctakt.diagnostics import Span
from nctakt.long_text import LongText


@dataclass(frozen=True, slots=True)
class Source:
    """``file`` is the name as the user gave it, ``lines`` count from 1 in every span."""

    file: str
    lines: Sequence[str]

    def numbered(self, first: int = 1) -> Iterator[tuple[int, str]]:
        """The lines from one on with their numbers."""
        if first == 1:
            return enumerate(self.lines, start=1)
        if isinstance(self.lines, LongText):
            return enumerate(self.lines.from_line(first - 1), start=first)
        return ((number + 1, self.lines[number]) for number in range(first - 1, len(self.lines)))

    def line_of(self, span: Span | None) -> str:
        """The whole line that a span stands in; empty without a span or outside the text."""
        if span is None or not 1 <= span.line <= len(self.lines):
            return ""
        return self.lines[span.line - 1]

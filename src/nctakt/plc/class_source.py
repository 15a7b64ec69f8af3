# SPDX-License-Identifier: MIT
"""Places in the source of a PLC's class, for diagnostics about it.

In: a class, a member of it. Out: where it is; nothing where the source is not available, in an
interactive session for example.
"""

from __future__ import annotations

import linecache
import re
from dataclasses import replace

from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.run.conditions import CONDITION_COLUMN


def condition_mistake(kind: type, member: str, text: str, mistake: Diagnostic) -> Diagnostic:
    """Return a mistake in a condition with its place in the file of the class.

    Where the text is not there word for word, the place is that in the text.
    """
    span = mistake.span
    begin, end = (0, len(text)) if span is None else (span.column, span.end_column)
    if span is not None:
        begin, end = (max(0, column - CONDITION_COLUMN) for column in (begin, end))
    file, lines, first = _source_of(kind, member)
    for number, line in enumerate(lines[first - 1 :], first):
        column = line.find(text)
        if re.match(rf"\s*(async )?def {member}\b", line):
            break
        if column >= 0:
            span = Span(file, number, column + begin + 1, column + max(begin + 1, end) + 1)
            return replace(mistake, span=span, source_line=line.rstrip("\n"))
    span = Span(member, 1, begin + 1, max(begin + 1, end) + 1)
    return replace(mistake, span=span, source_line=text)


def _source_of(kind: type, member: str) -> tuple[str, list[str], int]:
    """Return the file of a class, its lines, and the first line of a member of the class."""
    code = getattr(getattr(kind, member), "__code__", None)
    file, first = (
        getattr(kind, "_source", ("", 1))
        if code is None
        else (code.co_filename, code.co_firstlineno)
    )
    return file, linecache.getlines(file), first


def source_position(kind: type, member: str, word: str = "") -> tuple[Span, str] | tuple[()]:
    """Return the span of a method, or of a word at it or in its class, and the source line.

    The result is empty if the source is not available.
    """
    file, lines, first = _source_of(kind, member)
    pattern = re.escape(word) if word else rf"(?<=def ){re.escape(member)}"
    for number, line in enumerate(lines[first - 1 :], first):
        match = re.search(rf"{pattern}\b", line, re.IGNORECASE)
        if match is not None:
            return Span(file, number, match.start() + 1, match.end() + 1), line.rstrip("\n")
    return ()

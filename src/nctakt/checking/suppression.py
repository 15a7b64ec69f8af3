# SPDX-License-Identifier: MIT
"""Comments that suppress findings: ``; nctakt: ignore 900243 the PLC waits for it``.

In: the lines of a program or list (there after ``#``), and its findings. Out: the findings that
are left, and new ones about comments that suppress nothing, give no reason or cannot be read.
After a block or an entry a comment is about its line, in a line of its own about the next one that
has any. Several numbers are separated by commas. Errors are not suppressed: a program with an error
does not run.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Severity, Span
from nctakt.messages import diagnostic
from nctakt.messages.catalogue import messages_of
from nctakt.messages.commands.checking import (
    INVALID_SUPPRESSION,
    SUPPRESSED_ERROR,
    SUPPRESSION_UNUSED,
    SUPPRESSION_WITHOUT_REASON,
)
from nctakt.nc.parse.lexer import without_comments
from nctakt.nc.source import Source

#: Begins the comment; a test for it must be cheap, since each line of a program is asked.
MARK = "nctakt:"

_COMMENTS = {
    begin: re.compile(
        rf"{begin}\s*(?P<all>{MARK}\s*(?P<verb>[^\W\d]*)(?P<rest>[^;]*))", re.IGNORECASE
    )
    for begin in (";", "#")
}
_NUMBERS = re.compile(r"\s+(?P<numbers>\d+(?:\s*,\s*\d+)*)(?P<reason>.*)$")
_VERB = "ignore"


@dataclass(frozen=True, slots=True)
class Suppression:
    """One number of a comment: its span, the whole line, the line that it is about, its reason."""

    number: int
    span: Span
    source_line: str
    about: int
    reason: str


@dataclass(frozen=True, slots=True)
class Suppressions:
    """The comments of a program, and the mistakes in those that cannot be read."""

    items: tuple[Suppression, ...]
    diagnostics: tuple[Diagnostic, ...]


def is_marked(line: str) -> bool:
    """Return whether a line may have such a comment."""
    return MARK in line or MARK.upper() in line


def read_suppressions(
    source: Source, *, is_list: bool = False, marked: Sequence[int] | None = None
) -> Suppressions:
    """Return the comments of a program or list that suppress findings.

    ``marked``: the numbers of the lines that may have any, if they are known.
    """
    comment = _COMMENTS["#" if is_list else ";"]
    items: list[Suppression] = []
    wrong: list[Diagnostic] = []
    lines = _marked_lines(source)
    if marked is not None:
        lines = ((number, source.lines[number - 1]) for number in marked)
    for number, line in lines:
        match = comment.search(line)
        if match is None or line.count('"', 0, match.start()) % 2:
            continue
        span = Span(
            source.file,
            number,
            match.start("all") + 1,
            match.start("all") + len(match["all"].rstrip()) + 1,
        )
        numbers = _NUMBERS.match(match["rest"])
        written = [] if numbers is None else numbers["numbers"].split(",")
        if match["verb"].lower() != _VERB or numbers is None or not all(map(_is_known, written)):
            text = match["all"].strip()[:60]
            wrong.append(diagnostic(INVALID_SUPPRESSION, span, line, text=text))
            continue
        about = _line_about(source, number, line, is_list=is_list)
        reason = numbers["reason"].strip()
        found = [Suppression(int(text), span, line, about, reason) for text in written]
        items += found
        if not reason:
            first = found[0].number
            wrong.append(diagnostic(SUPPRESSION_WITHOUT_REASON, span, line, number=first))
    return Suppressions(tuple(items), tuple(wrong))


def suppressed_by(found: Diagnostic, items: Sequence[Suppression]) -> tuple[Suppression, ...]:
    """Return the comments that are about a finding, by its line and one of its numbers."""
    if found.span is None:
        return ()
    numbers = (found.id, found.message.id, *found.also)
    return tuple(item for item in items if item.about == found.span.line and item.number in numbers)


def apply(suppressions: Suppressions, found: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return the findings of a program that are left, and those about its comments.

    The order is that of ``found``, with those about comments at the end.
    """
    if not suppressions.items and not suppressions.diagnostics:
        return list(found)
    used: dict[Suppression, None] = {}
    errors: dict[Suppression, None] = {}
    left: list[Diagnostic] = []
    for item in found:
        about = suppressed_by(item, suppressions.items)
        is_error = item.severity is Severity.ERROR
        (errors if is_error else used).update(dict.fromkeys(about))
        if is_error or not about:
            left.append(item)
    left += suppressions.diagnostics
    for comment in suppressions.items:
        if comment in errors:
            left.append(
                diagnostic(
                    SUPPRESSED_ERROR, comment.span, comment.source_line, number=comment.number
                )
            )
        elif comment not in used:
            left.append(
                diagnostic(
                    SUPPRESSION_UNUSED,
                    comment.span,
                    comment.source_line,
                    number=comment.number,
                    line=comment.about,
                )
            )
    return left


def _marked_lines(source: Source) -> Iterator[tuple[int, str]]:
    first = 1
    for group in source.groups():
        text = "\n".join(group)
        if MARK in text or MARK.upper() in text:
            for index, line in enumerate(group):
                if is_marked(line):
                    yield first + index, line
        first += len(group)


def _line_about(source: Source, number: int, line: str, *, is_list: bool) -> int:
    """Return the line that a comment is about: its own, or the next that is not empty."""
    while number < len(source.lines):
        code = line.partition("#")[0] if is_list else without_comments(line)
        if code.strip():
            break
        number += 1
        line = source.lines[number - 1]
    return number


def _is_known(number: str) -> bool:
    return bool(messages_of(int(number)))

# SPDX-License-Identifier: MIT
"""General findings of a program -> findings that name the intended form, each mistake once.

In: the diagnostics of parser and checker. Out: the same, where a general one ("not expected here")
is in a line with a known slip: the slip with the number of the general one, without the general
ones after it in that line, which follow from it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Diagnostic, Message, Span
from nctakt.messages import diagnostic
from nctakt.messages.programs.checked_blocks import (
    FUNCTION_NOT_DEFINED,
    INVALID_FUNCTION_NUMBER,
    NOT_NC_TEXT,
    UNKNOWN_WORD,
    WORD_VALUE_MISSING,
)
from nctakt.messages.programs.checked_cycles import INVALID_KEYWORD_VALUE
from nctakt.messages.programs.checked_values import NOT_A_VALUE
from nctakt.messages.programs.nc_text import (
    CYCLE_BEGIN_END_MISMATCH,
    NAME_EXPECTED,
    STRUCTURE_NOT_CLOSED,
    SYMBOL_EXPECTED,
    UNEXPECTED_TEXT,
    UNKNOWN_CONTROL_WORD,
    UNKNOWN_CYCLE_KEYWORD,
    VALUE_EXPECTED,
)
from nctakt.messages.programs.slips import (
    BODY_BEHIND_THEN,
    CURLY_BRACKETS,
    KEYWORDS_WITHOUT_EQUALS,
    WORD_OF_OTHER_CONTROL,
)
from nctakt.nc.slips.forms import FORM_SLIPS
from nctakt.nc.slips.other_controls import OTHER_CONTROLS

#: Messages that say where a line cannot be read, and not why.
_GENERAL: tuple[Message, ...] = (
    FUNCTION_NOT_DEFINED,
    INVALID_FUNCTION_NUMBER,
    NAME_EXPECTED,
    NOT_A_VALUE,
    NOT_NC_TEXT,
    SYMBOL_EXPECTED,
    UNEXPECTED_TEXT,
    UNKNOWN_CONTROL_WORD,
    UNKNOWN_CYCLE_KEYWORD,
    UNKNOWN_WORD,
    VALUE_EXPECTED,
    WORD_VALUE_MISSING,
)

#: Longest line in which slips are looked for, in characters.
_LONGEST_LINE = 1000


def name_slips(diagnostics: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return the diagnostics, sorted by position, with slips in place of general findings."""
    named: list[Diagnostic] = []
    explained: dict[tuple[str, int], None] = {}
    for item in diagnostics:
        span = item.span
        if span is None or not is_general(item):
            named.append(item)
            continue
        line = (span.file, span.line)
        if line in explained:
            continue
        slip = slip_of(item)
        if slip is not None:
            explained[line] = None
        named.append(item if slip is None else slip)
    return _without_consequences(named)


def _without_consequences(named: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return the findings without those that follow from a slip reported already."""
    kept: list[Diagnostic] = []
    unread: dict[tuple[str, int], None] = {}
    opened: dict[tuple[str, int], None] = {}
    files: dict[str, None] = {}
    for item in named:
        if item.span is None:
            continue
        line = (item.span.file, item.span.line)
        if item.message is KEYWORDS_WITHOUT_EQUALS:
            unread[line] = None
        if item.message is BODY_BEHIND_THEN:
            opened[line] = None
        if item.message is CURLY_BRACKETS and _opens_brackets(item):
            opened[line] = None
            if item.source_line.strip().startswith("{"):
                opened[item.span.file, item.span.line - 1] = None
    for item in named:
        if item.span is not None:
            file, line = item.span.file, (item.span.file, item.span.line)
            if item.message is CURLY_BRACKETS and _opens_brackets(item):
                files[file] = None
            elif item.message is CURLY_BRACKETS and file in files and item.values["found"] == "}":
                continue
            if item.message is INVALID_KEYWORD_VALUE and line in unread:
                continue
            if item.message in (STRUCTURE_NOT_CLOSED, CYCLE_BEGIN_END_MISMATCH) and line in opened:
                continue
        kept.append(item)
    return kept


def _opens_brackets(item: Diagnostic) -> bool:
    """Return whether a line opens a curly bracket that it does not close."""
    text = _before_comment(item.source_line)
    return text.count("{") > text.count("}")


def is_general(item: Diagnostic) -> bool:
    """Return whether a finding says only that something cannot be read or is not known."""
    return any(item.message is message for message in _GENERAL)


def slip_of(item: Diagnostic) -> Diagnostic | None:
    """Return the slip that a general finding has met, with the number of that finding."""
    span, line = item.span, item.source_line
    if span is None or len(line) > _LONGEST_LINE:
        return None
    text, column = _before_comment(line), span.column - 1
    for pattern, control, meaning, instead in OTHER_CONTROLS:
        match = _around(pattern, text, column)
        if match is not None:
            at = _span(span, match)
            found = diagnostic(
                WORD_OF_OTHER_CONTROL,
                at,
                line,
                found=_shown(match["wrong"]),
                control=control,
                meaning=meaning,
                instead=instead,
            )
            return replace(found, number=item.id)
    for pattern, message, replacement in FORM_SLIPS:
        match = _around(pattern, text, column)
        if match is not None:
            values = {"found": _shown(match["wrong"])}
            if "replacement" in message.parameters:
                values["replacement"] = replacement(match)
            return Diagnostic(message, _span(span, match), values, line, number=item.id)
    return None


def _before_comment(line: str) -> str:
    """Return a line without the comment after ``;``."""
    start = line.find(";")
    while start >= 0 and line.count('"', 0, start) % 2:
        start = line.find(";", start + 1)
    return line if start < 0 else line[:start]


def _around(pattern: re.Pattern[str], line: str, column: int) -> re.Match[str] | None:
    """Return the match of a slip at or around a column."""
    matches = pattern.finditer(line)
    return next((match for match in matches if match.start() <= column <= match.end()), None)


def _span(span: Span, match: re.Match[str]) -> Span:
    start, end = match.span("wrong")
    return replace(span, column=start + 1, end_column=end + 1)


def _shown(text: str) -> str:
    return " ".join(text.split())[:40]

# SPDX-License-Identifier: MIT
"""The text after an entry's name -> its value's text, apart from the comment.

In: an ``Entry``. Out: its word, character string or flags; oddities go to the collector. The
parameter's type chooses between two readings (manual of rtconf.lis, 2.4 and 2.5): after a number
or a name everything after the next blank is a comment; after a character string only ``(`` opens
one, and quotation marks protect all special characters.
"""

from __future__ import annotations

import re

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.lists.format.reader import BLANKS, Entry
from nctakt.messages import Collector
from nctakt.messages.machines.lists import (
    BLANK_MISSING,
    CLOSING_QUOTE_MISSING,
    TEXT_AFTER_QUOTE,
    UNQUOTED_SPECIAL_CHARACTERS,
)

_WORD = re.compile(r'"(?P<quoted>[^"]*)"(?=[ \t]|$)|(?P<bare>[^ \t]+)')
_FLAG_SEPARATOR = re.compile(r"[ \t]*[|,][ \t]*")
_FLAG = re.compile(r"\w+", re.A)
_DECIMAL = re.compile(r"[+-]?[0-9]+")
_HEXADECIMAL = re.compile(r"[+-]?0[xX][0-9A-Fa-f]+")
_REAL = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")

#: More digits than any type holds; longer numbers are cut, since they are out of range anyway.
_MAX_DIGITS = 40
#: Maximum length of a real number, in characters.
_LONGEST_REAL = 400


@dataclass(frozen=True, slots=True)
class Word:
    """A word of a value and its span; ``quoted``: it was in quotation marks."""

    text: str
    span: Span
    quoted: bool = False


def read_word(entry: Entry, collector: Collector) -> Word | None:
    """Return the first word of a number or name entry, ``None`` if there is none."""
    if entry.is_verbatim:
        text = entry.rest.strip()
        return Word(text, entry.span(0, len(entry.rest))) if text else None
    _check_blank(entry, collector)
    start = len(entry.rest) - len(entry.rest.lstrip(BLANKS))
    match = _WORD.match(entry.rest, start)
    if match is None:
        return None
    quoted = match["quoted"] is not None
    text = match["quoted"].strip(BLANKS) if quoted else match["bare"]
    return Word(text, entry.span(match.start(), match.end()), quoted)


def read_string(entry: Entry, collector: Collector) -> Word | None:
    """Return the character string of an entry without trailing blanks, ``None`` without one."""
    if entry.is_verbatim:
        return Word(entry.rest.rstrip(BLANKS), entry.span(0, len(entry.rest)))
    _check_blank(entry, collector)
    start = len(entry.rest) - len(entry.rest.lstrip(BLANKS))
    body = entry.rest[start:]
    if not body or body.startswith("("):
        return None
    if body.startswith('"'):
        return _read_quoted(entry, start, collector)
    comment = body.find("(")
    if comment > 0 and body[comment - 1] not in BLANKS:
        span = entry.span(start + comment, start + comment + 1)
        collector.report(BLANK_MISSING, span, entry.line, key=entry.path)
    text = (body if comment < 0 else body[:comment]).rstrip(BLANKS)
    span = entry.span(start, start + len(text))
    if any(special in text for special in (" ", "\t", "#", "/*", '"')):
        collector.report(UNQUOTED_SPECIAL_CHARACTERS, span, entry.line, key=entry.path)
    return Word(text, span)


def _read_quoted(entry: Entry, start: int, collector: Collector) -> Word:
    closing = entry.rest.find('"', start + 1)
    if closing < 0:
        collector.report(
            CLOSING_QUOTE_MISSING, entry.span(start, start + 1), entry.line, key=entry.path
        )
        closing = len(entry.rest)
    tail = entry.rest[closing + 1 :].strip(BLANKS)
    if tail and not tail.startswith("("):
        column = entry.rest.index(tail, closing + 1)
        span = entry.span(column, column + len(tail))
        collector.report(TEXT_AFTER_QUOTE, span, entry.line, key=entry.path)
    text = entry.rest[start + 1 : closing].rstrip(BLANKS)
    return Word(text, entry.span(start, closing + 1), quoted=True)


def read_flags(entry: Entry, collector: Collector) -> tuple[Word, ...]:
    """Return the words of a flag set (``PLC_INFO | MVS_SVS``, also joined by commas)."""
    first = read_word(entry, collector)
    if first is None:
        return ()
    if first.quoted:
        return (first,)
    words: list[Word] = []
    position = len(entry.rest) - len(entry.rest.lstrip(BLANKS))
    while match := _FLAG.match(entry.rest, position):
        words.append(Word(match[0], entry.span(match.start(), match.end())))
        separator = _FLAG_SEPARATOR.match(entry.rest, match.end())
        if separator is None:
            # Text after a flag without a separator belongs to it: 'MOS#' is not the flag MOS.
            glued = _WORD.match(entry.rest, match.end())
            if glued is None:
                return tuple(words)
            text = match[0] + glued[0]
            return (*words[:-1], Word(text, entry.span(match.start(), glued.end())))
        position = separator.end()
    return tuple(words) or (first,)


def _check_blank(entry: Entry, collector: Collector) -> None:
    if entry.rest and entry.rest[0] not in BLANKS:
        collector.report(BLANK_MISSING, entry.span(0, 1), entry.line, key=entry.path)


def parse_integer(text: str, *, hexadecimal: bool) -> int | None:
    """Return ``text`` as an integer, decimal with an optional sign or 0x…, else ``None``."""
    base = 10
    if not _DECIMAL.fullmatch(text):
        if not (hexadecimal and _HEXADECIMAL.fullmatch(text)):
            return None
        base = 16
    sign = -1 if text.startswith("-") else 1
    digits = text.lstrip("+-")[2 if base == 16 else 0 :].lstrip("0") or "0"
    return sign * int(digits[:_MAX_DIGITS], base)


def parse_real(text: str, *, hexadecimal: bool) -> float | None:
    """Return ``text`` as a finite real number, with decimal point and exponent, else ``None``."""
    if len(text) > _LONGEST_REAL:
        return None
    if _REAL.fullmatch(text):
        value = float(text)
        return value if abs(value) != float("inf") else None
    integer = parse_integer(text, hexadecimal=hexadecimal)
    return None if integer is None else float(integer)

# SPDX-License-Identifier: MIT
"""ASCII list -> entries.

In: the bytes of a parameter list and the dialect of its kind. Out: its entries in the order of the
text, each with its normalised path, its indices, and the text after its name, all with their
positions; oddities of the text go to the collector. Values are not interpreted here, since their
meaning depends on the parameter's type (``value_text.py``, ``values.py``).

The syntax is that of the manual of rtconf.lis, chapters 2.4 and 2.5, which all lists share: one
entry a line, a blank between name and value, ``#`` opens a comment line, ``End`` or ``Ende`` ends
the list.
"""

from __future__ import annotations

import re

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.base.text import decode_text, split_lines
from nctakt.messages import Collector
from nctakt.messages.machines.lists import (
    BLANK_MISSING_AFTER_HASH,
    HASH_NOT_AT_LINE_START,
    LIST_WITHOUT_END,
    NUL_CHARACTER_IN_LINE,
    TEXT_AFTER_END,
    TEXT_NOT_UTF8,
    UNUSUAL_END_WORD,
)

BLANKS = " \t"
_END_OF_FILE = "\x1a"
_KEY = re.compile(r'[^ \t"]+')
_STEP = re.compile(r"\[([0-9]{1,9})\]")
_WELL_FORMED = re.compile(r"[A-Za-z_]\w*(\[[0-9]{1,9}\])*(\.[A-Za-z_]\w*(\[[0-9]{1,9}\])*)*", re.A)


@dataclass(frozen=True, slots=True)
class ListDialect:
    """The differences between the kinds of list.

    ``hexadecimal``: numbers may be written as 0x… . ``references``: a number may be written as the
    ID of the parameter with it (``P-AXIS-00212.0``). ``boolean_words``: TRUE and FALSE as well as 1
    and 0. ``expects_end``: a missing End is a warning. ``comment_notes``: a ``#`` outside of the
    first column, or without a blank after it, is a note.
    """

    hexadecimal: bool = True
    references: bool = True
    boolean_words: bool = True
    expects_end: bool = False
    comment_notes: bool = False


@dataclass(frozen=True, slots=True)
class Entry:
    """A line ``name value`` of a list.

    ``path`` is the name with its indices normalised (``thread[00].name`` -> ``thread[0].name``),
    ``pattern`` the same with empty brackets. A malformed name is its own pattern. ``rest`` is the
    text after the name, from ``rest_column`` on. ``is_verbatim``: all of it is the value, without
    comments and quotation marks (XML).
    """

    path: str
    pattern: str
    indices: tuple[int, ...]
    rest: str
    rest_column: int
    key_span: Span
    line: str
    is_verbatim: bool = False

    @property
    def is_well_formed(self) -> bool:
        """Whether each bracket of the name holds an index; otherwise the name is invalid."""
        return self.pattern.count("[]") == len(self.indices)

    def span(self, start: int, end: int) -> Span:
        """Return the span of ``rest[start:end]``."""
        key = self.key_span
        column = self.rest_column + start
        return Span(key.file, key.line, column, max(column + 1, self.rest_column + end))


def read_list(
    file: str, data: bytes, dialect: ListDialect, collector: Collector
) -> tuple[Entry, ...]:
    """Return the entries of the list ``data``; ``file`` is its name in spans."""
    decoded = decode_text(data)
    if decoded.guessed:
        collector.report(TEXT_NOT_UTF8, Span(file, 1, 1, 2), encoding=decoded.encoding)
    lines = split_lines(decoded.text.split(_END_OF_FILE, 1)[0])
    entries: list[Entry] = []
    for number, line in enumerate(lines, start=1):
        content = line.strip(BLANKS)
        if not content:
            continue
        if content.startswith("#"):
            if dialect.comment_notes:
                _check_comment(Span(file, number, 1, 2), line, collector)
            continue
        entry = _read_entry(file, number, line)
        if _is_end(entry, collector):
            _check_after_end(file, lines, number, collector)
            return tuple(entries)
        if "\0" in line:
            column = line.index("\0") + 1
            collector.report(NUL_CHARACTER_IN_LINE, Span(file, number, column, column + 1), line)
            continue
        entries.append(entry)
    if dialect.expects_end:
        last = max(1, len(lines))
        collector.report(LIST_WITHOUT_END, Span(file, last, 1, 2), lines[-1] if lines else "")
    return tuple(entries)


def _check_comment(key: Span, line: str, collector: Collector) -> None:
    column = line.index("#")
    span = Span(key.file, key.line, column + 1, column + 2)
    if column > 0:
        collector.report(HASH_NOT_AT_LINE_START, span, line)
    following = line[column + 1 : column + 2]
    if following and following not in BLANKS:
        collector.report(BLANK_MISSING_AFTER_HASH, span, line)


def _read_entry(file: str, number: int, line: str) -> Entry:
    start = len(line) - len(line.lstrip(BLANKS))
    match = _KEY.match(line, start)
    # A line that begins with a quotation mark has no name; its whole first word counts as the name.
    end = match.end() if match else len(line)
    key = line[start:end]
    span = Span(file, number, start + 1, end + 1)
    rest, column = line[end:], end + 1
    if "[" not in key or not _WELL_FORMED.fullmatch(key):
        return Entry(key, key, (), rest, column, span, line)
    indices = tuple(int(text) for text in _STEP.findall(key))
    path = _STEP.sub(lambda step: f"[{int(step[1])}]", key)
    return Entry(path, _STEP.sub("[]", key), indices, rest, column, span, line)


def _is_end(entry: Entry, collector: Collector) -> bool:
    if entry.path.lower() not in {"end", "ende"}:
        return False
    if entry.path not in {"End", "Ende"}:
        collector.report(UNUSUAL_END_WORD, entry.key_span, entry.line, word=entry.path)
    return True


def _check_after_end(file: str, lines: list[str], end: int, collector: Collector) -> None:
    for number, line in enumerate(lines[end:], start=end + 1):
        content = line.strip(BLANKS)
        if content and not content.startswith("#"):
            collector.report(TEXT_AFTER_END, Span(file, number, 1, len(line) + 1), line)
            return

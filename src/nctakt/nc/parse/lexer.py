# SPDX-License-Identifier: MIT
r"""Lines -> blocks of text without comments.

In: a ``Source``. Out: one ``BlockText`` per block, from which the parser takes tokens with compiled
patterns. The lexer joins lines (``\`` at the end, comment lines between the parts), replaces
comments by blanks of the same length to keep columns true, drops ``#COMMENT BEGIN … #COMMENT END``,
and checks the length of a block. Tokens are found on demand, because the meaning of ``C:\a.nc``
depends on the text before it.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator
from typing import NamedTuple

from nctakt.base.diagnostics import Message, Span
from nctakt.messages import Collector
from nctakt.messages.programs.nc_text import (
    BINARY_FILE,
    BLOCK_LONGER_THAN_MANUAL,
    BLOCK_TOO_LONG,
    COMMENT_BEGIN_NOT_ALONE,
    COMMENT_END_NOT_ALONE,
    COMMENT_NOT_CLOSED,
)
from nctakt.nc.source import LineReader, Source

#: Maximum length of a block in characters, and the length beyond which it is not read (20301).
BLOCK_LENGTH = 4000
BLOCK_LENGTH_HARD = 4096

_COMMENT_START = re.compile(r'["(;]')
_PARENTHESIS = re.compile(r"[()]")
_CONTINUED_NUMBER = re.compile(r"\s*N\s*\d+(?![\d:])", re.IGNORECASE)
COMMENT_BEGIN = re.compile(r"#\s*COMMENT\s+BEGIN(?!\w)", re.IGNORECASE)
COMMENT_END = re.compile(r"#\s*COMMENT\s+END(?!\w)", re.IGNORECASE)
_ALONE_BEFORE = re.compile(r"\s*(?:/\d*\s*)?(?:N\s*\d+\s*)?$", re.IGNORECASE)
_NEW_STATEMENT = re.compile(
    r"\s*(?:/\d*\s*)?(?:N\s*\d+\s*:?\s*)?(?:[#$%]|Vs?\.[\w.]+(?:\[[^\]]*\])*\s*(?:[:=]|$))",
    re.IGNORECASE,
)


class BlockError(Exception):
    """Ends the reading of one block; the parser reports it and continues with the next block.

    ``start`` and ``end``: positions in the block's text; ``span`` replaces them if given.
    """

    def __init__(
        self, message: Message, start: int, end: int, span: Span | None = None, **values: object
    ) -> None:
        super().__init__(message)
        self.message = message
        self.start = start
        self.end = end
        self.span = span
        self.values = values


class Piece(NamedTuple):
    """One line of a block: its start in the block's text, its number, and the original line."""

    start: int
    number: int
    line: str


class BlockText:
    r"""The text of one block and the reading position in it.

    ``text`` has blanks for comments, a newline between the lines of a block, and no ``\``.
    """

    __slots__ = ("file", "line_number", "pieces", "pos", "text")

    def __init__(self, file: str, text: str, pieces: list[Piece]) -> None:
        self.file = file
        self.text = text
        self.pieces = pieces
        self.line_number = pieces[0].number
        self.pos = 0

    def span(self, start: int, end: int) -> Span:
        """Return the span of ``text[start:end]``, cut at the end of its first line."""
        if len(self.pieces) == 1:
            return Span(self.file, self.line_number, start + 1, max(start + 1, end) + 1)
        index = bisect_right(self.pieces, start, key=_start) - 1
        piece = self.pieces[index]
        if index + 1 < len(self.pieces):
            end = min(end, self.pieces[index + 1].start - 1)
        column = start - piece.start + 1
        return Span(self.file, piece.number, column, max(column, end - piece.start) + 1)

    def source_line(self, span: Span) -> str:
        """Return the whole line of a span of this block."""
        return self.pieces[span.line - self.line_number].line

    def text_of(self, span: Span) -> str:
        """Return the text that a span of this block covers."""
        return self.source_line(span)[span.column - 1 : span.end_column - 1]

    def match(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        """Match at the reading position and advance past the match."""
        match = pattern.match(self.text, self.pos)
        if match is not None:
            self.pos = match.end()
        return match

    def looking_at(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        """Match at the reading position without advancing."""
        return pattern.match(self.text, self.pos)

    def skip_blanks(self) -> int:
        """Skip blanks; return the index of the next character, or the text's length."""
        match = _BLANKS.match(self.text, self.pos)
        assert match is not None
        self.pos = match.end()
        return self.pos

    def at_end(self) -> bool:
        """Skip blanks; return whether the text ends."""
        return self.skip_blanks() == len(self.text)


_BLANKS = re.compile(r"\s*")


def _start(piece: Piece) -> int:
    return piece.start


def without_comments(line: str) -> str:
    """Return the line with a blank for each character of a comment, cut off at ``;``.

    ``( … )`` nest, and one that is not closed ends with the line. A text in double quotes contains
    no comments.
    """
    match = _COMMENT_START.search(line)
    if match is None:
        return line
    parts = []
    done = 0
    while match is not None:
        at = match.start()
        if line[at] == ";":
            parts.append(line[done:at])
            return "".join(parts)
        if line[at] == '"':
            closing = line.find('"', at + 1)
            if closing < 0:
                break
            end = closing + 1
            parts.append(line[done:end])
        else:
            end = _end_of_parentheses(line, at)
            parts += (line[done:at], " " * (end - at))
        done = end
        match = _COMMENT_START.search(line, done)
    parts.append(line[done:])
    return "".join(parts)


def _end_of_parentheses(line: str, start: int) -> int:
    depth = 0
    for match in _PARENTHESIS.finditer(line, start):
        depth += 1 if match[0] == "(" else -1
        if depth == 0:
            return match.end()
    return len(line)


class Lexer:
    """Yields the blocks of a source; each line is read once, on demand.

    Between two blocks the caller may consume ``lines``.
    """

    def __init__(self, source: Source, collector: Collector, first_line: int = 1) -> None:
        self._file = source.file
        self.lines = LineReader(source, first_line)
        self._waiting: tuple[int, str] | None = None
        self._collector = collector
        self._finished = False

    def blocks(self) -> Iterator[BlockText]:
        """Yield the blocks that are not empty."""
        while (line := self._next_line()) is not None:
            number, raw = line
            text = without_comments(raw)
            if not text or text.isspace():
                self._check_length(number, raw, len(raw))
                continue
            if "#" in text:
                text = self._without_comment_block(text, number, raw)
                if not text or text.isspace():
                    continue
            if text[-1] in "\\ \t" and text.rstrip().endswith("\\"):
                block = self._joined(text, number, raw)
            elif self._check_length(number, raw, len(raw)):
                block = BlockText(self._file, text, [Piece(0, number, raw)])
            else:
                continue
            if block is not None and not block.text.isspace():
                yield block

    def extend(self, block: BlockText) -> BlockText | None:
        """Return the block joined with the next line, for a value over several lines in ``#VAR``.

        ``None`` if the next line begins something new, if there is none, or if the block gets too
        long.
        """
        while (line := self._next_line()) is not None:
            number, raw = line
            text = without_comments(raw)
            if not text or text.isspace():
                continue
            length = len(block.text) + 1 + len(text)
            if _NEW_STATEMENT.match(text) or length > BLOCK_LENGTH_HARD:
                self._waiting = line
                return None
            text = text.rstrip().removesuffix("\\")
            piece = Piece(len(block.text) + 1, number, raw)
            # Skipped lines become empty pieces, so that the line numbers have no gaps.
            gap = [
                Piece(piece.start, skipped, "")
                for skipped in range(block.pieces[-1].number + 1, number)
            ]
            return BlockText(self._file, f"{block.text}\n{text}", [*block.pieces, *gap, piece])
        return None

    def _next_line(self) -> tuple[int, str] | None:
        if self._waiting is not None:
            line, self._waiting = self._waiting, None
            return line
        lines = self.lines
        if self._finished or not (lines.index < len(lines.group) or lines.more()):
            return None
        number = lines.number
        raw = lines.group[lines.index]
        lines.index += 1
        if "\0" in raw:
            column = raw.index("\0") + 1
            self._finished = True
            self._report(BINARY_FILE, number, column, column + 1, raw)
            return None
        return number, raw

    @property
    def is_between(self) -> bool:
        """Whether the next block begins with the next line of ``lines``."""
        return self._waiting is None and not self._finished

    def _joined(self, text: str, number: int, raw: str) -> BlockText | None:
        r"""Join the lines that ``\`` continues; lines without content between them are skipped."""
        pieces = [Piece(0, number, raw)]
        parts = [text.rstrip()[:-1]]
        length = len(parts[0])
        continued = True
        while continued and (line := self._next_line()) is not None:
            next_number, next_raw = line
            text = without_comments(next_raw)
            stripped = text.rstrip()
            if length > BLOCK_LENGTH_HARD:
                continued = not stripped or stripped.endswith("\\")
                continue
            pieces.append(Piece(length + 1, next_number, next_raw))
            if stripped:
                continued = stripped.endswith("\\")
                stripped = stripped.removesuffix("\\")
                own_number = _CONTINUED_NUMBER.match(stripped)
                if own_number is not None:
                    stripped = " " * own_number.end() + stripped[own_number.end() :]
            parts.append(stripped)
            length += 1 + len(stripped)
        if not self._check_length(number, raw, length):
            return None
        return BlockText(self._file, "\n".join(parts), pieces)

    def _without_comment_block(self, text: str, number: int, raw: str) -> str:
        """Return the text before ``#COMMENT BEGIN`` and skip the lines up to its end."""
        begin = COMMENT_BEGIN.search(text)
        if begin is None or text.count('"', 0, begin.start()) % 2:
            return text
        before = text[: begin.start()]
        if not _ALONE_BEFORE.match(before) or not _blank(text[begin.end() :]):
            self._report(COMMENT_BEGIN_NOT_ALONE, number, begin.start() + 1, begin.end() + 1, raw)
        while (line := self._next_line()) is not None:
            end_number, end_raw = line
            end = COMMENT_END.search(end_raw) if "#" in end_raw else None
            if end is not None:
                after = without_comments(end_raw[end.end() :])
                if not _ALONE_BEFORE.match(end_raw[: end.start()]) or not _blank(after):
                    self._report(
                        COMMENT_END_NOT_ALONE, end_number, end.start() + 1, end.end() + 1, end_raw
                    )
                break
        else:
            if not self._finished:
                self._report(COMMENT_NOT_CLOSED, number, begin.start() + 1, begin.end() + 1, raw)
        return "" if _ALONE_BEFORE.match(before) else before

    def _check_length(self, number: int, raw: str, length: int) -> bool:
        if length <= BLOCK_LENGTH:
            return True
        too_long = length > BLOCK_LENGTH_HARD
        limit = BLOCK_LENGTH_HARD if too_long else BLOCK_LENGTH
        start = min(limit, len(raw) - 1)
        self._report(
            BLOCK_TOO_LONG if too_long else BLOCK_LONGER_THAN_MANUAL,
            number,
            start + 1,
            start + 2,
            raw,
            length=length,
            limit=limit,
        )
        return not too_long

    def _report(
        self, message: Message, number: int, start: int, end: int, raw: str, **values: object
    ) -> None:
        self._collector.report(message, Span(self._file, number, start, end), raw, **values)


def _blank(text: str) -> bool:
    return not text or text.isspace()

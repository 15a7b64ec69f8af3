# SPDX-License-Identifier: MIT
"""Structured Text in the usual form: white space changes, nothing else does.

In: a piece of text. Out: its lines with an indentation by their structures, blanks around
assignments and comparisons and after commas, none at the end of a line. Blanks that align
declarations stay, and so do comments and texts.
"""

from __future__ import annotations

import re

from lsprotocol.types import TextEdit

from nctakt.editor.document import Document
from nctakt.editor.structured_text.plc_project import PlcFile
from nctakt.editor.structured_text.surroundings import masked
from nctakt.st.sources import Piece

_WORD = re.compile(r"[^\W\d]\w*")
#: Words that open a structure at their line, and those that close one.
_OPEN = frozenset(
    """IF CASE FOR WHILE REPEAT STRUCT UNION VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP VAR_STAT
    VAR_INST VAR_GLOBAL VAR_EXTERNAL VAR_CONFIG VAR_ACCESS""".split()
)
_CLOSE = frozenset(
    """END_IF END_CASE END_FOR END_WHILE END_REPEAT END_STRUCT END_UNION END_VAR""".split()
)
#: Words that are one step further to the left than the lines around them.
_BETWEEN = frozenset(("ELSE", "ELSIF", "UNTIL"))
_LABEL = re.compile(
    r"\s*(?:[-\w.#]+(?:\s*\.\.\s*[-\w.#]+)?)(?:\s*,\s*[-\w.#]+(?:\s*\.\.\s*[-\w.#]+)?)*\s*:(?!=)"
)
_INDENT = "    "
#: The replacement for each character of a comment or text.
_MASK = "\x01"
#: Structures in each other beyond which no line is moved.
_MAX_DEPTH = 60


def format_edits(document: Document, file: PlcFile, first: int, last: int) -> list[TextEdit]:
    """Return the edits that give the lines from ``first`` to ``last`` (exclusive) their form."""
    edits = []
    for piece in file.pieces:
        if not piece.text.strip():
            continue
        offset = 0
        old_lines = piece.text.split("\n")
        for number, (old, new) in enumerate(
            zip(old_lines, formatted(piece.text).split("\n"), strict=True)
        ):
            spot = _line_of(piece, offset, is_first=number == 0)
            offset += len(old) + 1
            if old == new or spot is None or not first <= spot[0] < last:
                continue
            line, column = spot
            if document.line(line)[column : column + len(old)] == old:
                edits.append(TextEdit(document.range(line, column, column + len(old)), new))
    return edits


def _line_of(piece: Piece, offset: int, *, is_first: bool) -> tuple[int, int] | None:
    """Return line and column of a line of a piece; ``None`` for one that has none."""
    line, column = piece.locate(piece.base + offset)
    if is_first and piece.title:
        line, column = piece.lines[-1], piece.columns[-1]
        for start, at, where in zip(piece.offsets, piece.lines, piece.columns, strict=True):
            if start == 0:
                line, column = at, where
    return line - 1, column - 1


def formatted(text: str) -> str:
    """Return a text in the usual form: as many lines, and the same but for white space."""
    hidden = masked(text, _MASK)
    state = _State()
    lines = []
    for line, code in zip(text.split("\n"), hidden.split("\n"), strict=True):
        lines.append(state.line(line, code))
    return "\n".join(lines)


class _State:
    """The structures that are open at a line, outside of brackets and in them."""

    def __init__(self) -> None:
        #: Of each open structure its word, and whether a label has opened a part of it.
        self._open: list[list[object]] = []
        self._brackets = 0
        self._continues = False
        self._in_hidden = False

    def line(self, line: str, code: str) -> str:
        """Return a formatted line, and move on after it."""
        stripped = line.strip()
        if not stripped:
            return ""
        begins_inside = code.startswith(_MASK) and self._in_hidden
        self._in_hidden = code.rstrip().endswith(_MASK)
        words = [word.upper() for word in _WORD.findall(code.replace(_MASK, " "))]
        keeps = begins_inside or self._brackets > 0 or self._continues
        first = words[0] if words else ""
        depth = self._depth(first, code)
        self._go_on(words, code)
        if keeps or depth > _MAX_DEPTH:
            return _spaced(line, code).rstrip()
        indent = line[: len(line) - len(line.lstrip())]
        body = _spaced(line[len(indent) :], code[len(indent) :]).rstrip()
        return f"{_INDENT * depth}{body}"

    def _depth(self, first: str, code: str) -> int:
        """Return how far a line is moved to the right."""
        depth = sum(2 if part else 1 for _, part in self._open)
        inner = self._open[-1] if self._open else None
        if first in _CLOSE and inner is not None:
            return depth - (2 if inner[1] else 1)
        if first in _BETWEEN and inner is not None:
            if inner[0] == "CASE":
                return depth - (2 if inner[1] else 1)
            return depth - 1
        if inner is not None and inner[0] == "CASE" and _LABEL.match(code.replace(_MASK, " ")):
            return depth - (1 if inner[1] else 0)
        return depth

    def _go_on(self, words: list[str], code: str) -> None:
        shown = code.replace(_MASK, " ")
        inner = self._open[-1] if self._open else None
        if inner is not None and inner[0] == "CASE" and _LABEL.match(shown):
            inner[1] = True
        for word in words:
            if word in _OPEN:
                self._open.append([word, False])
            elif word in _CLOSE and self._open:
                self._open.pop()
            elif word == "ELSE" and self._open and self._open[-1][0] == "CASE":
                self._open[-1][1] = False
        self._brackets = max(0, self._brackets + shown.count("(") - shown.count(")"))
        ends = shown.rstrip()
        self._continues = bool(ends) and ends[-1] in "+-*/,=<>&" and not ends.endswith(",")


def _spaced(line: str, code: str) -> str:
    """Return a line with blanks around signs and after commas, where it has none."""
    parts: list[str] = []
    done = 0
    for match in re.finditer(r":=|=>|<=|>=|<>|,(?=\S)", code):
        start, end = match.span()
        parts.append(line[done:start])
        if match[0] == ",":
            parts.append(", ")
        else:
            before = "" if start == 0 or code[start - 1] in " \t" else " "
            after = "" if end == len(code) or code[end] in " \t" else " "
            parts.append(f"{before}{match[0]}{after}")
        done = end
    parts.append(line[done:])
    return "".join(parts)

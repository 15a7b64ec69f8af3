# SPDX-License-Identifier: MIT
"""Surroundings of the cursor in a program: the open structures, and its part of the line.

In: the lines of a document, the cursor's line, the text before it. Out: ``Surroundings``, which
determine what the checker permits there. The line need not be readable: it is being written.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.editor.structures import open_structures
from nctakt.nc.parse.block_head import BLOCK_HEAD
from nctakt.nc.parse.lexer import without_comments

#: Lines before the cursor that are searched for the structures around it.
SEARCHED_LINES = 10_000

Part = Literal["nothing", "comment", "block", "words", "condition", "value", "target"]

_CONDITION = re.compile(
    BLOCK_HEAD + r"(?:[$#]\s*(?:IF|ELSEIF|WHILE|UNTIL|SWITCH|CASE|ENDDO)|\#\s*WAIT\s+FOR)"
    r"(?=[\s\[])",
    re.IGNORECASE,
)
_FOR = re.compile(BLOCK_HEAD + r"\$FOR\s", re.IGNORECASE)
_ASSIGNED = re.compile(
    BLOCK_HEAD + r"(?:@?P+(?:\d+|\[.*?\])(?:\[[^=]*?\])*|Vs?\.[^=\s]*?)\s*[-+*/]?=(?!=)",
    re.IGNORECASE,
)
#: The value of a word that ``=`` has begun, as in ``X=P1 +``.
_WORD_VALUE = re.compile(r"(?<![\w.\]])[A-Z]\w*\s*=(?!=)\s*[^\s\[\]]*$", re.IGNORECASE)
_FIRST_WORD = re.compile(BLOCK_HEAD + r"[$#@%]?[\w.\[\]]*$", re.IGNORECASE)
_BRACKET = re.compile(r"(?P<name>#\s*[A-Z_ ]+|[A-Z_][\w.]*)?\s*$", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Surroundings:
    """The cursor's part of its line, and the structures around it.

    ``part``: ``nothing`` in texts and comments, ``comment`` at the start of one, ``block`` at the
    start of a block, ``words`` after its first word, ``target`` where a variable to write is named,
    ``condition`` and ``value`` in expressions. ``bracket``: the name before the innermost open
    bracket, ``None`` outside brackets. ``innermost``: the opening word of the structure around the
    line, with ``opening`` as its text; empty if there is none.
    """

    part: Part
    bracket: str | None
    in_cycle: bool
    innermost: str
    opening: str
    has_else: bool

    @property
    def is_value(self) -> bool:
        """Whether only a value can be written."""
        return self.part in ("condition", "value")


def surroundings(lines: Sequence[str], line: int, before: str) -> Surroundings:
    """Return the surroundings of the end of ``before``, the written part of a line."""
    window = lines[max(0, line - SEARCHED_LINES) : line]
    stack = open_structures(window)
    inner = stack[-1] if stack else None
    has_else = inner is not None and any(
        window[number].upper().lstrip().startswith(("$ELSE ", "#ELSE "))
        or window[number].strip().upper() in ("$ELSE", "#ELSE")
        for number in inner.dividers
    )
    part = "nothing" if inner is not None and inner.begin == "#COMMENT BEGIN" else _part(before)
    return Surroundings(
        part,
        open_bracket(without_comments(before)),
        any(item.begin == "#RT CYCLE" for item in stack),
        "" if inner is None else inner.begin,
        "" if inner is None else window[inner.first],
        has_else,
    )


def _part(before: str) -> Part:
    """Return the kind of the end of a line's text."""
    code = without_comments(before)
    if len(code) < len(before):
        return "nothing" if before[len(code) :].strip("; ") else "comment"
    if code.count('"') % 2 or _is_in_brackets_of_comment(before, code):
        return "nothing"
    if _CONDITION.match(code):
        return "condition"
    loop = _FOR.match(code)
    if loop is not None:
        return "value" if "=" in code[loop.end() :] else "target"
    if _ASSIGNED.match(code) or ("#" not in code and _WORD_VALUE.search(code)):
        return "value"
    return "block" if _FIRST_WORD.match(code) else "words"


def _is_in_brackets_of_comment(before: str, code: str) -> bool:
    """Return whether ``(`` has begun a comment that is open: then it takes a ``)`` in."""
    return without_comments(f"{before})") == f"{code} "


def open_bracket(code: str) -> str | None:
    """Return the name before the innermost open bracket of a line, ``None`` without one."""
    depth = 0
    quoted = False
    for index in range(len(code) - 1, -1, -1):
        letter = code[index]
        quoted ^= letter == '"'
        if quoted:
            continue
        depth += {"]": 1, "[": -1}.get(letter, 0)
        if depth < 0:
            match = _BRACKET.search(code[:index])
            return "" if match is None or match["name"] is None else match["name"]
    return None

# SPDX-License-Identifier: MIT
"""The structures of a text, closed or not: lines that open, divide and close them.

In: lines. Out: ``Structure``, for folding, symbols, indentation and the place of a missing end.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.nc.parse.block_head import BLOCK_HEAD
from nctakt.nc.parse.lexer import without_comments

_WORD = re.compile(
    BLOCK_HEAD + r"(?P<word>\$\w+|#\s*RT\s+(?:CYCLE(?:\s+[A-Z ]+)?|WHILE|ENDWHILE)"
    r"|#\s*(?:VAR|ENDVAR|COMMENT\s+BEGIN|COMMENT\s+END|IF|ELSEIF|ELSE|ENDIF)\b|%)",
    re.IGNORECASE,
)
_JUMP_IN_LINE = re.compile(r"\$(?:GOTO|BREAK|CONTINUE)\b", re.IGNORECASE)

#: Opening word of a structure -> closing word.
ENDS = {
    "$IF": "$ENDIF",
    "$FOR": "$ENDFOR",
    "$WHILE": "$ENDWHILE",
    "$DO": "$ENDDO",
    "$REPEAT": "$UNTIL",
    "$SWITCH": "$ENDSWITCH",
    "#RT CYCLE": "#RT CYCLE END",
    "#RT WHILE": "#RT ENDWHILE",
    "#VAR": "#ENDVAR",
    "#COMMENT BEGIN": "#COMMENT END",
    "#IF": "#ENDIF",
}
_OPENS = {end: begin for begin, end in ENDS.items()}
#: Words that divide a structure.
DIVIDERS = ("$ELSEIF", "$ELSE", "$CASE", "$DEFAULT", "#ELSEIF", "#ELSE")


@dataclass(slots=True)
class Structure:
    """A structure: its opening word, its first and last line from 0, the lines that divide it.

    ``is_closed``: its end is there; else ``last`` is the last line before what ends it.
    """

    begin: str
    first: int
    last: int
    is_closed: bool = False
    dividers: list[int] = field(default_factory=list)
    inner: list[Structure] = field(default_factory=list)


def structure_word(line: str) -> str:
    """Return the structure word of a line, in one spelling; empty for any other line."""
    if "$" not in line and "#" not in line and "%" not in line:
        return ""
    code = without_comments(line)
    match = _WORD.match(code)
    if match is None:
        return ""
    word = " ".join(match["word"].upper().replace("#", "# ").split()).replace("# ", "#")
    if word.startswith("#RT CYCLE"):
        action = word.removeprefix("#RT CYCLE").strip()
        if action in ("", "DEF"):
            return "#RT CYCLE"
        return "#RT CYCLE END" if action == "END" else ""
    if word == "$IF" and _JUMP_IN_LINE.search(code):
        return ""
    return word


def structures(lines: Sequence[str], first: int = 0) -> list[Structure]:
    """Return the outermost structures of a text; a ``%`` line closes all."""
    found, stack = _read(lines, first)
    _give_up(stack, first + len(lines))
    return found


def open_structures(lines: Sequence[str]) -> list[Structure]:
    """Return the structures that are open at the end of a text, the innermost last."""
    return _read(lines, 0)[1]


def _read(lines: Sequence[str], first: int) -> tuple[list[Structure], list[Structure]]:
    """Return the outermost structures of a text, and those that nothing has closed."""
    found: list[Structure] = []
    stack: list[Structure] = []
    for number, line in enumerate(lines, first):
        word = structure_word(line)
        if not word:
            continue
        if stack and stack[-1].begin == "#COMMENT BEGIN" and word != "#COMMENT END":
            continue
        if word == "%":
            _give_up(stack, number)
        elif word in ENDS:
            item = Structure(word, number, number)
            (stack[-1].inner if stack else found).append(item)
            stack.append(item)
        elif word in DIVIDERS and stack:
            stack[-1].dividers.append(number)
        elif word in _OPENS and any(item.begin == _OPENS[word] for item in stack):
            while stack[-1].begin != _OPENS[word]:
                stack.pop().last = number - 1
            closed = stack.pop()
            closed.last, closed.is_closed = number, True
    return found, stack


def _give_up(stack: list[Structure], number: int) -> None:
    while stack:
        stack.pop().last = number - 1


def every(items: Iterable[Structure]) -> Iterator[Structure]:
    """Yield structures with those inside them, in the order of their first lines."""
    for item in items:
        yield item
        yield from every(item.inner)

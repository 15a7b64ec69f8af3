# SPDX-License-Identifier: MIT
"""Lines of a program as the printer writes them, with their comments and numbers as written.

In: lines. Out: edited lines. A line is printed separately, inside the structure that it belongs to;
if the printed line would not give the same tree again, or has a comment in its middle, only its
indentation changes.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from nctakt.editor.structures import DIVIDERS, ENDS, structure_word
from nctakt.messages import Collector
from nctakt.nc.parse.lexer import without_comments
from nctakt.nc.parse.parser import parse_program
from nctakt.nc.parse.printer import print_program
from nctakt.nc.source import Source
from nctakt.nc.tree import Program

INDENT = "  "
_NUMBER = re.compile(
    r"(?<![A-Za-z_\d.])\d+\.?\d*(?:E[-+]?\d+)?|(?<![\w.])\.\d+|\d+\.?\d*|\.\d+", re.I
)
_CLOSING = frozenset(ENDS.values())

#: Text put around a line that divides or closes a structure, for parsing.
_AROUND: dict[str, tuple[list[str], list[str]]] = {
    "$ELSEIF": (["$IF 1"], ["$ENDIF"]),
    "$ELSE": (["$IF 1"], ["$ENDIF"]),
    "#ELSEIF": (["#IF 1"], ["#ENDIF"]),
    "#ELSE": (["#IF 1"], ["#ENDIF"]),
    "$CASE": (["$SWITCH 1"], ["$ENDSWITCH"]),
    "$DEFAULT": (["$SWITCH 1"], ["$ENDSWITCH"]),
    "$UNTIL": (["$REPEAT"], []),
    "$ENDDO": (["$DO"], []),
}


def format_lines(lines: Sequence[str], first: int = 0, last: int | None = None) -> list[str]:
    """Return the lines from ``first`` to ``last`` (exclusive), formatted."""
    last = len(lines) if last is None else last
    depth = 0
    switches: list[bool] = []
    in_comment = continued = in_declarations = False
    formatted: list[str] = []
    for number, line in enumerate(lines[:last]):
        word = structure_word(line)
        if in_comment or continued:
            new = line
            in_comment = in_comment and word != "#COMMENT END"
        elif word == "#COMMENT BEGIN":
            new, in_comment = line, True
        else:
            if word == "%":
                depth, switches = 0, []
            if word in _CLOSING and switches:
                depth -= 2 if switches.pop() else 1
            outdent = 1 if word in DIVIDERS and not (switches and switches[-1]) else 0
            case = word in ("$CASE", "$DEFAULT")
            level = max(0, depth - (1 if case else outdent))
            new = line if number < first else format_line(line, level, word, in_declarations)
            if word in ENDS:
                switches.append(word == "$SWITCH")
                depth += 2 if word == "$SWITCH" else 1
            in_declarations = word == "#VAR" or (in_declarations and word != "#ENDVAR")
        continued = without_comments(line).rstrip().endswith("\\")
        if number >= first:
            formatted.append(new)
    return formatted


def format_line(line: str, level: int, word: str = "", in_declarations: bool = False) -> str:
    """Return one line at a level of indentation."""
    stripped = line.strip()
    if not stripped:
        return ""
    indent = "" if stripped[0] == "%" else INDENT * level
    code = without_comments(stripped)
    comment = stripped[len(code) :]
    is_plain = code == stripped[: len(code)]
    code = code.rstrip()
    if is_plain and code and not code.endswith("\\"):
        printed = _printed(code, word, in_declarations)
        gap = " " if comment else ""
        if comment and stripped[len(code) : len(stripped) - len(comment)]:
            gap = stripped[len(code) : len(stripped) - len(comment)]
        return f"{indent}{printed}{gap}{comment}".rstrip()
    return f"{indent}{stripped}"


def _printed(code: str, word: str, in_declarations: bool) -> str:
    """Return the code as printed, or unchanged if that would change its meaning."""
    before, after = _AROUND.get(word, ([], []))
    if word in ENDS:
        after = [ENDS[word] + (" 1" if word in ("$DO", "$REPEAT") else "")]
    elif word in _CLOSING and word not in _AROUND:
        return code.upper()
    elif in_declarations and not word:
        before, after = ["#VAR"], ["#ENDVAR"]
    tree = _tree([*before, code, *after])
    if tree is None:
        return code
    printed = print_program(tree).split("\n")
    if tree.name and not code.lstrip().startswith("%"):
        printed = printed[1:]
    if len(printed) <= len(before):
        return code
    new = _with_numbers(printed[len(before)].strip(), code)
    again = _tree([*before, new, *after])
    if (
        new.count("[") != code.count("[")
        or again is None
        or print_program(again) != print_program(tree)
    ):
        return code
    return new


def _tree(lines: list[str]) -> Program | None:
    collector = Collector()
    program = parse_program(Source("", lines), collector)
    return None if collector.diagnostics else program


def _with_numbers(printed: str, code: str) -> str:
    """Return the printed line with the numbers as written."""
    numbers = [match[0] for match in _NUMBER.finditer(code)]
    places = list(_NUMBER.finditer(printed))
    if len(numbers) != len(places):
        return code
    parts: list[str] = []
    done = 0
    for match, number in zip(places, numbers, strict=True):
        if float(match[0]) != float(number):
            return code
        parts += (printed[done : match.start()], number)
        done = match.end()
    return "".join((*parts, printed[done:]))

# SPDX-License-Identifier: MIT
"""The conditions that have a lane in the scope: those of a program's realtime cycles, filtered.

In: the lines of a program, a person's search text. Out: conditions, and which of them match.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from nctakt.base.dataclass import dataclass

_CYCLE_BEGIN = re.compile(r"\s*(?:N\d+\s*)?#RT\s*CYCLE\s*(?:DEF\b|\[|$)", re.IGNORECASE)
_CYCLE_END = re.compile(r"\s*(?:N\d+\s*)?#RT\s*CYCLE\s*END\b", re.IGNORECASE)
_CYCLE_ID = re.compile(r"\bID\s*=\s*([^\s\],]+)", re.IGNORECASE)
_CONDITION = re.compile(r"\s*(?:N\d+\s*)?\$(?:IF|ELSEIF)\b", re.IGNORECASE)
_WORD = re.compile(r'"([^"]*)"?|(\S+)')

#: Maximum number of conditions with a lane in the scope, the first ones: it shows six, and scrolls.
MAX_CONDITIONS = 100

#: Characters of a filter at most.
MAX_FILTER = 100


@dataclass(frozen=True, slots=True)
class Condition:
    """A condition: its line, the ID of its cycle as written (empty without), its text."""

    line: int
    cycle: str
    text: str


def conditions_of(lines: Sequence[str]) -> list[Condition]:
    """Return the first conditions in realtime cycles."""
    found: list[Condition] = []
    cycle: str | None = None
    for number_of_line, line in enumerate(lines, 1):
        if "#" not in line and "$" not in line:
            continue
        if _CYCLE_END.match(line):
            cycle = None
        elif _CYCLE_BEGIN.match(line):
            written = _CYCLE_ID.search(line)
            cycle = "" if written is None else written[1]
        elif cycle is not None and is_condition(line):
            found.append(Condition(number_of_line, cycle, line.strip()))
            if len(found) == MAX_CONDITIONS:
                break
    return found


def is_condition(line: str) -> bool:
    """Return whether a line begins with ``$IF`` or ``$ELSEIF``."""
    return _CONDITION.match(line) is not None


def fitting(conditions: Sequence[Condition], request: str) -> list[int]:
    """Return the indices of the conditions that fit all words of a filter; without words all.

    ``12`` is a line, ``12-20`` a range of them, ``#3`` the ID of a cycle; any other word, and any
    text in ``"``, is part of the condition's text, ignoring case.
    """
    words = [(match[1], match[2]) for match in _WORD.finditer(request[:MAX_FILTER])]
    return [
        index
        for index, one in enumerate(conditions)
        if all(_fits(one, quoted, plain) for quoted, plain in words)
    ]


def _fits(condition: Condition, quoted: str | None, plain: str | None) -> bool:
    if plain is None:
        return (quoted or "").casefold() in condition.text.casefold()
    if plain.startswith("#") and len(plain) > 1:
        return condition.cycle.casefold() == plain[1:].casefold()
    if lines := re.fullmatch(r"([0-9]+)(?:-([0-9]+))?", plain):
        return int(lines[1]) <= condition.line <= int(lines[2] or lines[1])
    return plain.casefold() in condition.text.casefold()

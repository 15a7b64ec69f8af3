# SPDX-License-Identifier: MIT
"""The tokens of lines with their colours, for the language server and the live page.

In: lines. Out: ``Coloured``, in the order of the text: the type of the colour, and when its value
is read: ``realtime`` by realtime cycles in each tick, ``decoder`` ahead of time, ``frozen`` the
same inside a cycle, where it never changes.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from nctakt.editor.display.line_tokens import Token, tokens
from nctakt.editor.names import variable_name
from nctakt.editor.structures import structure_word
from nctakt.nc.vocabulary.operators import CONSTANTS, FUNCTIONS
from nctakt.nc.vocabulary.variables.variable_table import NameTable

_TYPE_OF = {
    "comment": "comment",
    "string": "string",
    "number": "number",
    "control": "keyword",
    "frequency": "keyword",
    "command": "macro",
    "program": "class",
    "call": "function",
    "block": "label",
    "function": "function",
    "parameter": "parameter",
    "keyword": "property",
    "axisword": "property",
    "variable": "variable",
    "member": "variable",
    "operator": "operator",
}


class Coloured(NamedTuple):
    """A token: its columns, type and modifier (empty for none)."""

    start: int
    end: int
    type: str
    modifier: str


class Surroundings:
    """Which lines of a text are in a realtime cycle or in a comment of several lines."""

    def __init__(self, lines: Sequence[str]) -> None:
        self._first = [0]
        self._states = [(False, False)]
        in_cycle = in_comment = False
        for number, line in enumerate(lines):
            if "#" not in line and "%" not in line:
                continue
            word = structure_word(line)
            in_cycle = word == "#RT CYCLE" or (in_cycle and word not in ("#RT CYCLE END", "%"))
            in_comment = word == "#COMMENT BEGIN" or (in_comment and word != "#COMMENT END")
            if (in_cycle, in_comment) != self._states[-1]:
                self._first.append(number)
                self._states.append((in_cycle, in_comment))

    def of(self, number: int) -> tuple[bool, bool]:
        """Return whether a line, from 0, is in a cycle, and whether in a comment."""
        return self._states[bisect_right(self._first, number) - 1]


def synchronous_names(names: NameTable) -> frozenset[str]:
    """Return the variables of a machine that realtime cycles read and write in each tick."""
    return frozenset(name for name, _, _ in names.values() if _is_synchronous(names, name))


def coloured(
    line: str, state: tuple[bool, bool], synchronous: frozenset[str]
) -> Iterator[Coloured]:
    """Yield the tokens of a line that have a colour; ``state``: of its ``Surroundings``."""
    in_cycle, in_comment = state
    is_body = in_cycle and not ("#" in line and structure_word(line) == "#RT CYCLE")
    items = [Token("comment", 0, len(line), line)] if in_comment else tokens(line)
    for item in sorted(items, key=lambda token: token.start):
        kind, modifier = _kind_of(item, synchronous, is_body=is_body)
        if kind and item.end > item.start:
            yield Coloured(item.start, item.end, kind, modifier)


def _kind_of(item: Token, synchronous: frozenset[str], *, is_body: bool) -> tuple[str, str]:
    """Return type and modifier of a token; an empty type for one without a colour."""
    if item.kind == "name":
        word = item.text.upper()
        if word in FUNCTIONS:
            return "function", "defaultLibrary"
        return ("keyword" if word in CONSTANTS or word in ("MOD", "NOT", "XOR") else ""), ""
    kind = _TYPE_OF[item.kind]
    if item.kind == "variable":
        return kind, time_of(item.text, synchronous, is_body=is_body)
    if item.kind == "parameter":
        return kind, "frozen" if is_body else "decoder"
    return kind, "realtime" if is_body and item.kind == "function" else ""


def time_of(written: str, synchronous: frozenset[str], *, is_body: bool) -> str:
    """Return when a variable is read: ``realtime``, ``decoder``, or ``frozen`` in a cycle."""
    name = variable_name(written)
    family = name.split(".")[1].upper() if "." in name else ""
    if family in ("RTA", "RTG") or written[:3].upper() == "VS." or name in synchronous:
        return "realtime"
    return "frozen" if is_body else "decoder"


def _is_synchronous(names: NameTable, name: str) -> bool:
    found = names.resolve_text(name)
    return isinstance(found, tuple) and found[0].synchronous

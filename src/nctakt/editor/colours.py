# SPDX-License-Identifier: MIT
"""Semantic tokens: what an editor colours, with the time at which each value is read.

In: a document. Out: the encoded tokens. The modifier ``realtime`` marks what realtime cycles read
and write in each tick; ``decoder`` marks what the decoder reads ahead of time, ``frozen`` the same
inside a cycle, where it never changes.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.editor.document import Document
from nctakt.editor.legend import MODIFIERS, TYPES
from nctakt.editor.line_tokens import Token, tokens
from nctakt.editor.names import variable_name
from nctakt.editor.structures import structure_word
from nctakt.nc.vocabulary.operators import CONSTANTS, FUNCTIONS
from nctakt.nc.vocabulary.variable_table import NameTable

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


def semantic_tokens(document: Document, names: NameTable, first: int, last: int) -> list[int]:
    """Return the tokens of the lines from ``first`` to ``last`` (exclusive), as distances."""
    synchronous = {name for name, _, _ in names.values() if _is_synchronous(names, name)}
    data: list[int] = []
    line_before = start_before = 0
    in_cycle = in_comment = False
    for number, line in enumerate(document.lines[:last]):
        word = structure_word(line)
        in_cycle = word == "#RT CYCLE" or (in_cycle and word not in ("#RT CYCLE END", "%"))
        in_comment = word == "#COMMENT BEGIN" or (in_comment and word != "#COMMENT END")
        if number < first:
            continue
        is_body = in_cycle and word != "#RT CYCLE"
        items = [Token("comment", 0, len(line), line)] if in_comment else tokens(line)
        for item in sorted(items, key=lambda token: token.start):
            kind, modifiers = _kind_of(item, synchronous, is_body=is_body)
            if not kind or item.end <= item.start:
                continue
            start = document.character_of(line, item.start)
            length = document.character_of(line, item.end) - start
            ahead = start - (start_before if number == line_before else 0)
            data += (number - line_before, ahead, length, TYPES.index(kind), modifiers)
            line_before, start_before = number, start
    return data


def _kind_of(item: Token, synchronous: set[str], *, is_body: bool) -> tuple[str, int]:
    """Return type and modifiers of a token; an empty type for one without a colour."""
    if item.kind == "name":
        word = item.text.upper()
        if word in FUNCTIONS:
            return "function", _bits("defaultLibrary")
        return ("keyword" if word in CONSTANTS or word in ("MOD", "NOT", "XOR") else ""), 0
    kind = _TYPE_OF[item.kind]
    if item.kind == "variable":
        return kind, _bits(time_of(item.text, synchronous, is_body=is_body))
    if item.kind == "parameter":
        return kind, _bits("frozen" if is_body else "decoder")
    return kind, _bits("realtime") if is_body and item.kind == "function" else 0


def time_of(written: str, synchronous: set[str], *, is_body: bool) -> str:
    """Return when a variable is read: ``realtime``, ``decoder``, or ``frozen`` in a cycle."""
    name = variable_name(written)
    family = name.split(".")[1].upper() if "." in name else ""
    if family in ("RTA", "RTG") or written[:3].upper() == "VS." or name in synchronous:
        return "realtime"
    return "frozen" if is_body else "decoder"


def _is_synchronous(names: NameTable, name: str) -> bool:
    found = names.resolve_text(name)
    return isinstance(found, tuple) and found[0].synchronous


def _bits(*modifiers: str) -> int:
    return sum(1 << MODIFIERS.index(name) for name in modifiers)


def lines_with_cycles(document: Document) -> Iterator[int]:
    """Yield the lines in which a realtime cycle is defined."""
    for number, line in enumerate(document.lines):
        if "#" in line and structure_word(line) == "#RT CYCLE":
            yield number

# SPDX-License-Identifier: MIT
"""Semantic tokens: colours of an editor, with the time at which each value is read.

In: a document. Out: the tokens of ``token_colours``, encoded for the protocol.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.editor.display.legend import MODIFIERS, TYPES
from nctakt.editor.document import Document
from nctakt.editor.structures import structure_word
from nctakt.editor.token_colours import Surroundings, coloured, synchronous_names
from nctakt.nc.vocabulary.variables.variable_table import NameTable


def semantic_tokens(document: Document, names: NameTable, first: int, last: int) -> list[int]:
    """Return the tokens of the lines from ``first`` to ``last`` (exclusive), as distances."""
    synchronous = synchronous_names(names)
    surroundings = Surroundings(document.lines[:last])
    data: list[int] = []
    line_before = start_before = 0
    for number, line in enumerate(document.lines[first:last], first):
        for item in coloured(line, surroundings.of(number), synchronous):
            start = document.character_of(line, item.start)
            length = document.character_of(line, item.end) - start
            ahead = start - (start_before if number == line_before else 0)
            bits = 1 << MODIFIERS.index(item.modifier) if item.modifier else 0
            data += (number - line_before, ahead, length, TYPES.index(item.type), bits)
            line_before, start_before = number, start
    return data


def lines_with_cycles(document: Document) -> Iterator[int]:
    """Yield the lines in which a realtime cycle is defined."""
    for number, line in enumerate(document.lines):
        if "#" in line and structure_word(line) == "#RT CYCLE":
            yield number

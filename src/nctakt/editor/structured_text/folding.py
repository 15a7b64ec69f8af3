# SPDX-License-Identifier: MIT
"""Folding in Structured Text: structures and declarations, by their words."""

from __future__ import annotations

import re
from collections.abc import Iterator

from lsprotocol.types import FoldingRange, FoldingRangeKind

from nctakt.editor.document import Document
from nctakt.editor.structured_text.surroundings import hidden_parts, masked

_WORD = re.compile(
    r"\b(?:END_(?P<end>\w+)|(?P<open>IF|CASE|FOR|WHILE|REPEAT|STRUCT|UNION|VAR(?:_\w+)?"
    r"|FUNCTION_BLOCK|FUNCTION|PROGRAM|INTERFACE|METHOD|PROPERTY|ACTION|TYPE))\b",
    re.IGNORECASE,
)


def folding_ranges(document: Document) -> list[FoldingRange]:
    """Return the folding ranges, by line; structures without an end in their file have none."""
    text = document.text()
    return sorted(
        [*_structures(text), *_comments(text)], key=lambda one: (one.start_line, -one.end_line)
    )


def _structures(text: str) -> Iterator[FoldingRange]:
    code = masked(text, " ")
    opened: list[tuple[str, int]] = []
    line = position = 0
    for match in _WORD.finditer(code):
        line += code.count("\n", position, match.start())
        position = match.start()
        if match["open"] is not None:
            word = match["open"].upper()
            opened.append(("VAR" if word.startswith("VAR") else word, line))
            continue
        closed = match["end"].upper()
        known = [index for index, (word, _) in enumerate(opened) if word == closed]
        if known:
            first = opened[known[-1]][1]
            del opened[known[-1] :]
            if line > first:
                yield FoldingRange(first, line)


def _comments(text: str) -> Iterator[FoldingRange]:
    for start, end in hidden_parts(text):
        count = text.count("\n", start, end)
        if count and text.startswith(("(*", "/*"), start):
            first = text.count("\n", 0, start)
            yield FoldingRange(first, first + count, kind=FoldingRangeKind.Comment)

# SPDX-License-Identifier: MIT
"""Symbols, folds and selections of a text.

In: a document. Out: its outline, folding ranges, and selection steps for an editor.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from lsprotocol.types import (
    DocumentSymbol,
    FoldingRange,
    FoldingRangeKind,
    Position,
    Range,
    SelectionRange,
    SymbolKind,
)

from nctakt.editor.display.line_tokens import token_at
from nctakt.editor.document import Document
from nctakt.editor.list_lines import entry_groups
from nctakt.editor.names import occurrences_in, outside_comments
from nctakt.editor.structures import Structure, every, structures

_KEY = re.compile(r"^\s*(?P<key>[A-Za-z_][\w.\[\]]*)\s+(?P<value>\S+)")
_COMMENT_LINE = re.compile(r"^\s*(?:;|\(.*\)\s*$|#\s)")
_START = re.compile(r"^\s*%\s*(?P<local>L\s+)?(?P<name>[^\s;(]*)", re.IGNORECASE)
#: Maximum number of symbols of a list or program; a longer outline is of no use.
MAX_SYMBOLS = 5000

_KINDS = {
    "cycle": SymbolKind.Event,
    "label": SymbolKind.Key,
    "subprogram": SymbolKind.Function,
    "variable": SymbolKind.Variable,
}


def document_symbols(document: Document) -> list[DocumentSymbol]:
    """Return the outline: programs with their cycles, labels and variables; entries of a list."""
    if document.is_list:
        return list(_entries(document))[:MAX_SYMBOLS]
    found: list[DocumentSymbol] = []
    section: DocumentSymbol | None = None
    ends = {item.first: item.last for item in every(structures(document.lines))}
    declares = False
    count = 0
    for number, line in outside_comments(document.lines):
        start = _START.match(line) if "%" in line else None
        if start is not None:
            if section is not None:
                section.range = Range(section.range.start, Position(number - 1, 0))
            area = document.whole_lines(number, number)
            kind = SymbolKind.Function if start["local"] else SymbolKind.Module
            section = DocumentSymbol(start["name"] or "%", kind, area, area, children=[])
            found.append(section)
            continue
        if not _may_define(line):
            continue
        upper = line.upper()
        declares = "#VAR" in upper or (declares and "#ENDVAR" not in upper)
        for item in occurrences_in(line, number, declares=declares):
            kind_of = _KINDS.get(item.symbol.kind)
            if kind_of is None or not item.is_definition or count >= MAX_SYMBOLS:
                continue
            count += 1
            name = item.symbol.name
            if item.symbol.kind == "cycle":
                name = f"#RT CYCLE {name}"
            whole = document.whole_lines(number, ends.get(number, number))
            selected = document.range(number, item.start, item.end)
            symbol = DocumentSymbol(name, kind_of, whole, selected)
            if section is None:
                found.append(symbol)
            else:
                assert isinstance(section.children, list)
                section.children.append(symbol)
    if section is not None:
        section.range = Range(section.range.start, Position(len(document.lines) - 1, 0))
    return found


def _may_define(line: str) -> bool:
    stripped = line.lstrip()
    return bool(stripped) and (
        "#" in line
        or stripped[0] in "[Vv"
        or (stripped[0] in "Nn/" and (":" in line or "[" in line))
    )


def _entries(document: Document) -> Iterator[DocumentSymbol]:
    for number, line in enumerate(document.lines):
        match = _KEY.match(line)
        if match is not None:
            area = document.whole_lines(number, number)
            selected = document.range(number, *match.span("key"))
            yield DocumentSymbol(
                match["key"], SymbolKind.Property, area, selected, detail=match["value"]
            )


def folding_ranges(document: Document) -> list[FoldingRange]:
    """Return the folding ranges: structures, subprograms, groups of comment lines; in lists the
    entries of one element.
    """
    if document.is_list:
        groups = [FoldingRange(first, last) for first, last in entry_groups(document.lines)]
        return groups + list(_comment_groups(document.lines))
    folds = [
        FoldingRange(item.first, item.last)
        for item in every(structures(document.lines))
        if item.last > item.first
    ]
    starts = [number for number, line in enumerate(document.lines) if line.lstrip().startswith("%")]
    for first, following in pairwise([*starts, len(document.lines)]):
        if following - 1 > first:
            folds.append(FoldingRange(first, following - 1))
    folds += _comment_groups(document.lines)
    return sorted(folds, key=lambda fold: (fold.start_line, -fold.end_line))


def _comment_groups(lines: Sequence[str]) -> Iterator[FoldingRange]:
    first: int | None = None
    for number, line in enumerate([*lines, ""]):
        if _COMMENT_LINE.match(line):
            first = number if first is None else first
        elif first is not None:
            if number - 1 > first:
                yield FoldingRange(first, number - 1, kind=FoldingRangeKind.Comment)
            first = None


def selection_range(document: Document, position: Position) -> SelectionRange:
    """Return the word, the line, the structures and the text around a position."""
    last = len(document.lines) - 1
    places = [document.whole_lines(0, last)]
    for item in _around(structures(document.lines), position.line):
        places.append(document.whole_lines(item.first, item.last))
        bounds = [item.first, *item.dividers, item.last]
        for first, following in pairwise(bounds):
            if first < position.line < following:
                places.append(document.whole_lines(first + 1, following - 1))
    line = document.line(position.line)
    begin = len(line) - len(line.lstrip())
    places.append(document.range(position.line, begin, len(line.rstrip())))
    token = token_at(line, document.index(position))
    if token is not None:
        places.append(document.range(position.line, token.start, token.end))
    selection = SelectionRange(places[0])
    for area in places[1:]:
        if area != selection.range:
            selection = SelectionRange(area, parent=selection)
    return selection


def _around(items: Sequence[Structure], line: int) -> Iterator[Structure]:
    for item in items:
        if item.first <= line <= item.last:
            yield item
            yield from _around(item.inner, line)

# SPDX-License-Identifier: MIT
"""Semantic tokens of Structured Text: comments, literals, keywords, and kinds of names."""

from __future__ import annotations

import re
from collections.abc import Iterator

from nctakt.editor.display.legend import MODIFIERS, TYPES
from nctakt.editor.document import Document
from nctakt.editor.structured_text.occurrences import Occurrence, is_parameter
from nctakt.editor.structured_text.plc_project import PlcFile
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.st.parse.colouring import TOKEN, kind_of_word
from nctakt.st.sources import Piece
from nctakt.st.tree import GlobalList, Library
from nctakt.st.types import (
    Callable,
    EnumType,
    EnumValue,
    Kind,
    Pou,
    Property,
    Section,
    Type,
    Variable,
)


def semantic_tokens(
    names: ProjectNames, document: Document, file: PlcFile, first: int, last: int
) -> list[int]:
    """Return the tokens of the lines from ``first`` to ``last`` (exclusive), as distances."""
    data: list[int] = []
    line_before = start_before = 0
    found = sorted(_tokens(names, file), key=lambda one: one[:2])
    for line, column, length, kind, modifiers in found:
        if not first <= line < last:
            continue
        text = document.line(line)
        start = document.character_of(text, column)
        width = document.character_of(text, column + length) - start
        ahead = start - (start_before if line == line_before else 0)
        data += (line - line_before, ahead, width, TYPES.index(kind), modifiers)
        line_before, start_before = line, start
    return data


def _tokens(names: ProjectNames, file: PlcFile) -> Iterator[tuple[int, int, int, str, int]]:
    known = {one.start: one for one in names.of(file)}
    for piece in file.pieces:
        for match in TOKEN.finditer(piece.text):
            kind, modifiers = _kind_of(match, known.get(piece.base + match.start()))
            if kind:
                yield from _placed(piece, match, kind, modifiers)


def _placed(
    piece: Piece, match: re.Match[str], kind: str, modifiers: int
) -> Iterator[tuple[int, int, int, str, int]]:
    """Yield a token, in parts where it has several lines."""
    offset = match.start()
    for part in match[0].split("\n"):
        if part.strip():
            line, column = piece.locate(piece.base + offset)
            yield line - 1, column - 1, len(part), kind, modifiers
        offset += len(part) + 1


def _kind_of(match: re.Match[str], found: Occurrence | None) -> tuple[str, int]:
    """Return type and modifiers of a token; an empty type for one without a colour."""
    if match.lastgroup != "word":
        return match.lastgroup or "", 0
    if found is not None:
        return _kind_of_target(found.target)
    kind = kind_of_word(match[0])
    return kind, _bits("defaultLibrary") if kind in ("type", "function") else 0


def _kind_of_target(target: object) -> tuple[str, int]:
    match target:
        case Variable():
            modifiers = _bits("readonly") if target.is_constant else 0
            if is_parameter(target):
                return "parameter", modifiers
            is_member = target.section is Section.MEMBER
            return ("property" if is_member else "variable"), modifiers
        case Property():
            return "property", 0
        case EnumValue():
            return "enumMember", _bits("readonly")
        case Pou():
            is_function = target.kind is Kind.FUNCTION
            bits = _bits("defaultLibrary") if target.library else 0
            return ("function" if is_function else "class"), bits
        case Callable():
            return "method", 0
        case EnumType():
            return "enum", 0
        case Type():
            return "type", 0
        case GlobalList() | Library():
            return "namespace", 0
    return "", 0


def _bits(*modifiers: str) -> int:
    return sum(1 << MODIFIERS.index(name) for name in modifiers)

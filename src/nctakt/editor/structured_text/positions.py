# SPDX-License-Identifier: MIT
"""Places of a file in an editor <-> positions in the texts of a project.

In: line and character, as the editor counts them. Out: the number that the position has in
``Sources``, and back. In an XML file only the texts of objects have positions.
"""

from __future__ import annotations

from bisect import bisect_right

from lsprotocol.types import Position, Range

from nctakt.editor.document import Document
from nctakt.editor.structured_text.plc_project import PlcFile
from nctakt.st.sources import Piece, Sources


def position_at(document: Document, position: Position, file: PlcFile) -> tuple[Piece, int] | None:
    """Return the piece at a place, and the offset in its text; ``None`` outside all pieces."""
    line, column = position.line + 1, document.index(position) + 1
    for piece in file.pieces:
        offset = _offset(piece, line, column)
        if offset is not None:
            return piece, offset
    return None


def _offset(piece: Piece, line: int, column: int) -> int | None:
    """Return the offset of line and column, from 1, in a piece."""
    places = list(zip(piece.lines, piece.columns, strict=True))
    index = bisect_right(places, (line, column)) - 1
    if index < 0 or not piece.text:
        return None
    begin = piece.offsets[index]
    end = piece.offsets[index + 1] if index + 1 < len(places) else len(piece.text)
    if places[index][0] == line:
        offset = begin + column - places[index][1]
        line_end = piece.text.find("\n", begin)
        limit = len(piece.text) if line_end < 0 else line_end
        return offset if offset <= max(limit, begin) else None
    for _ in range(line - places[index][0]):  # empty lines, which have no place
        found = piece.text.find("\n", begin, max(end, begin + 1))
        if found < 0:
            return None
        begin = found + 1
    return begin if column == 1 else None  # the text after it is markup, or another text


def range_of(document: Document, sources: Sources, start: int, end: int) -> Range:
    """Return the range of a stretch of text that is within a line."""
    return document.range_of(sources.span(start, end))


def line_of(piece: Piece, offset: int) -> str:
    """Return the text of the line of a piece up to an offset."""
    return piece.text[piece.text.rfind("\n", 0, offset) + 1 : offset]

# SPDX-License-Identifier: MIT
"""Positions in the texts of a PLC project as single numbers, and back to file, line and column.

In: the pieces of text (a plain file; declaration or implementation of an object in XML). Out: each
character of the project has a number, from 1 on; 0 is no position. A position is shown by line and
column in the file, and as the programming system shows it: object, part, and line in that part.
"""

from __future__ import annotations

from bisect import bisect_right

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span, Text

#: No position.
NO_POSITION = 0


@dataclass(slots=True, eq=False)
class Piece:
    """A piece of text: where its lines begin in the file.

    ``offsets`` are those in ``text`` at which a line of the file, or a stretch of it, begins;
    ``lines`` and ``columns``, both from 1, are where. ``title`` names object and part as the
    programming system does, "" for plain text. ``base``: the position of its first character.
    """

    file: str
    text: str
    offsets: list[int]
    lines: list[int]
    columns: list[int]
    title: str = ""
    is_declaration: bool = False
    base: int = 1

    def locate(self, position: int) -> tuple[int, int]:
        """Return line and column in the file."""
        offset = position - self.base
        index = bisect_right(self.offsets, offset) - 1
        return self.lines[index], self.columns[index] + offset - self.offsets[index]


@dataclass(slots=True, eq=False)
class Sources:
    """All pieces of a project, and the lines of their files."""

    pieces: list[Piece] = field(default_factory=list)
    lines: dict[str, list[str]] = field(default_factory=dict)
    _bases: list[int] = field(default_factory=list)
    _end: int = 1

    @property
    def end(self) -> int:
        """The number after those of all pieces."""
        return self._end

    def add(self, piece: Piece) -> Piece:
        """Give a piece its numbers."""
        piece.base = self._end
        self._end += len(piece.text) + 1
        self.pieces.append(piece)
        self._bases.append(piece.base)
        return piece

    def piece_of(self, position: int) -> Piece | None:
        """Return the piece of a position; ``None`` for ``NO_POSITION``."""
        index = bisect_right(self._bases, position) - 1
        return self.pieces[index] if index >= 0 else None

    def span(self, start: int, end: int) -> Span | None:
        """Return the span of a part of the text, which ends with its first line."""
        piece = self.piece_of(start)
        if piece is None:
            return None
        line, column = piece.locate(start)
        last_line, last_column = piece.locate(max(start, end - 1))
        if last_line != line:
            return Span(piece.file, line, column, len(self.line(piece.file, line)) + 1)
        return Span(piece.file, line, column, last_column + 1)

    def text(self, start: int, end: int) -> str:
        """Return a part of the text, in one line."""
        piece = self.piece_of(start)
        if piece is None:
            return ""
        return " ".join(piece.text[start - piece.base : end - piece.base].split())

    def line_number(self, position: int) -> int:
        """Return the line of a position in its file, 0 for none."""
        piece = self.piece_of(position)
        return 0 if piece is None else piece.locate(position)[0]

    def within(self, position: int) -> Text | None:
        """Return object, part and line as the programming system shows them; of XML only."""
        piece = self.piece_of(position)
        if piece is None or not piece.title or not piece.text:
            return None
        line = piece.text.count("\n", 0, position - piece.base) + 1
        if piece.is_declaration:
            return Text(
                f"{piece.title}, declaration line {line}",
                f"{piece.title}, Deklaration Zeile {line}",
            )
        return Text(
            f"{piece.title}, implementation line {line}",
            f"{piece.title}, Implementierung Zeile {line}",
        )

    def line(self, file: str, number: int) -> str:
        """Return a line of a file; empty if there is none."""
        lines = self.lines.get(file, [])
        return lines[number - 1] if 1 <= number <= len(lines) else ""

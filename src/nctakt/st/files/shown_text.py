# SPDX-License-Identifier: MIT
"""A file of a PLC as its programmer knows it: declarations and implementations, without markup.

In: name and text of a file. Out: its lines; in XML those of the objects' texts, a heading before
each text, and where each line lies in the file. Plain text is shown unchanged.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.messages import Collector
from nctakt.st.files.objects import read_objects
from nctakt.st.files.suffixes import TEXT_SUFFIXES
from nctakt.st.parse.lexer import Definitions
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece, Sources

_PARTS = (Text("implementation", "Implementierung"), Text("declaration", "Deklaration"))


@dataclass(frozen=True, slots=True)
class ShownLine:
    """A line as shown.

    ``number``: in its text, from 1, as the programming system counts it. ``line`` and ``column``:
    where it begins in the file, from 1; of a heading 0, with its title.
    """

    text: str
    number: int
    line: int
    column: int
    heading: Text | None = None


def shown_lines(file: str, lines: Sequence[str]) -> list[ShownLine]:
    """Return the lines of a file as its programmer sees them; none for a file without texts."""
    if file[file.rfind(".") :].lower() in TEXT_SUFFIXES:
        return [ShownLine(text, number, number, 1) for number, text in enumerate(lines, 1)]
    return [line for piece in pieces_of(file, "\n".join(lines)) for line in _of_piece(piece)]


def pieces_of(file: str, text: str) -> list[Piece]:
    """Return the texts of the objects in an XML file, in the order of the file."""
    sources = Sources()
    read_objects(
        file, text.encode("utf-8", "surrogatepass"), Definitions(), Reporter(sources, Collector())
    )
    return [piece for piece in sources.pieces if piece.text]


def _of_piece(piece: Piece) -> Iterator[ShownLine]:
    part = _PARTS[piece.is_declaration]
    yield ShownLine("", 0, 0, 0, Text(f"{piece.title} · {part.en}", f"{piece.title} · {part.de}"))
    offset = 0
    for number, text in enumerate(piece.text.split("\n"), 1):
        line, column = place_in_file(piece, offset)
        yield ShownLine(text, number, line, column)
        offset += len(text) + 1


def place_in_file(piece: Piece, offset: int) -> tuple[int, int]:
    """Return line and column in the file of the beginning of a line of a piece."""
    line, column = piece.locate(piece.base + offset)
    known = max(one for one in piece.offsets if one <= offset)
    skipped = piece.text.count("\n", known, offset)  # empty lines have no place
    return (line, column) if not skipped else (line + skipped, 1)

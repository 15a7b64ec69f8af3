# SPDX-License-Identifier: MIT
"""A text that is open in an editor, and its positions.

In: the opened text, then changes. Out: lines, as the check counts them. A change touches only its
own lines, so that a program of a million lines is edited as fast as a short one.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit

from lsprotocol.types import (
    Position,
    PositionEncodingKind,
    Range,
    TextDocumentContentChangeEvent,
    TextDocumentContentChangePartial,
)

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.st.files.suffixes import SOURCE_SUFFIXES, TEXT_SUFFIXES

#: The language of lists among the languages of editors; any other document is a program.
LIST_LANGUAGE = "nctakt-list"
#: The ends of the names of lists.
LIST_SUFFIXES = (".lis", ".xml")
#: The language of Structured Text, plain or as objects in XML.
STRUCTURED_LANGUAGE = "nctakt-st"


@dataclass(slots=True)
class Document:
    """An open text; ``lines`` are without their ends, the last one may be empty.

    ``path`` is ``None`` for a text without a file. ``name`` is its name in findings. ``encoding``
    counts the characters of positions.
    """

    uri: str
    path: Path | None
    name: str
    language: str
    version: int
    lines: list[str]
    encoding: PositionEncodingKind | str = PositionEncodingKind.Utf16
    _changes: int = 0
    _copy: tuple[int, list[str]] = (-1, [])

    @property
    def location(self) -> Path | None:
        """The file, or where it would lie; ``None`` for a text without either."""
        if self.path is not None:
            return self.path
        near = Path(self.name)
        return near if near.is_absolute() else None

    @property
    def is_list(self) -> bool:
        """Whether it is a list of parameters, by its language or the end of its name."""
        suffix = Path(self.name).suffix.casefold()
        return self.language == LIST_LANGUAGE or suffix in LIST_SUFFIXES

    @property
    def is_structured(self) -> bool:
        """Whether it is Structured Text, by its language or the end of its name."""
        suffix = Path(self.name).suffix.casefold()
        return self.language == STRUCTURED_LANGUAGE or suffix in SOURCE_SUFFIXES

    @property
    def is_program(self) -> bool:
        """Whether it is an NC program."""
        return not (self.is_list or self.is_structured)

    def program_lines(self) -> list[str]:
        """Return the lines as the check counts them: an end of line begins no other line.

        They are copied once for each change, and are not affected by later changes.
        """
        changes, lines = self._copy
        if changes != self._changes:
            changes = self._changes
            lines = self.lines[:-1] if self.lines and not self.lines[-1] else self.lines[:]
            self._copy = changes, lines
        return lines

    def text(self) -> str:
        """Return the whole text."""
        return "\n".join(self.lines)

    def line(self, number: int) -> str:
        """Return a line, counted from 0; empty after the last one."""
        return self.lines[number] if 0 <= number < len(self.lines) else ""

    def change(self, event: TextDocumentContentChangeEvent) -> None:
        """Apply a change of the editor."""
        self._changes += 1
        self._apply(event)
        self._changes += 1  # a copy made meanwhile, in another thread, is not used again

    def _apply(self, event: TextDocumentContentChangeEvent) -> None:
        if not isinstance(event, TextDocumentContentChangePartial):
            self.lines = split_text(event.text)
            return
        first, last = self._inside(event.range.start), self._inside(event.range.end)
        before = self.line(first.line)[: self.index(first)]
        after = self.line(last.line)[self.index(last) :]
        new = split_text(event.text)
        new[0] = before + new[0]
        new[-1] += after
        self.lines[first.line : last.line + 1] = new

    def _inside(self, position: Position) -> Position:
        """Return the position, or the end of the text if that comes before it."""
        if position.line < len(self.lines):
            return position
        return Position(len(self.lines) - 1, len(self.lines[-1]) * 2)

    def index(self, position: Position) -> int:
        """Return the index of a position's character in its line."""
        return self.index_of(self.line(position.line), position.character)

    def index_of(self, line: str, character: int) -> int:
        """Return the index of the character that the editor counts as ``character``."""
        if line.isascii() or self.encoding == PositionEncodingKind.Utf32:
            return min(character, len(line))
        count = 0
        for index, letter in enumerate(line):
            if count >= character:
                return index
            count += self._width(letter)
        return len(line)

    def character_of(self, line: str, index: int) -> int:
        """Return how the editor counts the character at an index."""
        if line.isascii() or self.encoding == PositionEncodingKind.Utf32:
            return index
        return sum(map(self._width, line[:index])) + max(0, index - len(line))

    def _width(self, letter: str) -> int:
        if self.encoding == PositionEncodingKind.Utf8:
            return len(letter.encode("utf-8", "surrogatepass"))
        return 2 if ord(letter) > 0xFFFF else 1

    def range(self, line: int, start: int, end: int) -> Range:
        """Return the range of ``line[start:end]``; lines count from 0."""
        text = self.line(line)
        return Range(
            Position(line, self.character_of(text, start)),
            Position(line, self.character_of(text, end)),
        )

    def range_of(self, span: Span | None) -> Range:
        """Return the range of a span; of a whole file its first character."""
        if span is None or not span.line:
            return Range(Position(0, 0), Position(0, 1))
        return self.range(span.line - 1, span.column - 1, span.end_column - 1)

    def whole_lines(self, first: int, last: int) -> Range:
        """Return the range from the start of a line to the end of another."""
        text = self.line(last)
        return Range(Position(first, 0), Position(last, self.character_of(text, len(text))))


def split_text(text: str) -> list[str]:
    r"""Return the lines of a text; an end (``\r\n``, ``\n``, ``\r``) always begins another one."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def path_of(uri: str) -> Path | None:
    """Return the file of a URI, ``None`` if it names none."""
    parts = urlsplit(uri)
    if parts.scheme != "file":
        return None
    path = unquote(parts.path)
    if len(path) > 2 and path[0] == "/" and path[2] == ":":
        path = path[1:]  # /C:/programs/part.nc
    return Path(path)


def name_of(uri: str, folders: Sequence[Path], language: str = "") -> str:
    """Return a document's name in findings: its file, or where a text without one would be.

    That is the first folder of the editor, so that its project, its machine and the programs in it
    are those of the text. New Structured Text is plain text, not an object in XML.
    """
    path = path_of(uri)
    if path is not None:
        return path.as_posix()
    label = unquote(urlsplit(uri).path).rpartition("/")[2] or uri
    if language == STRUCTURED_LANGUAGE and Path(label).suffix.casefold() not in SOURCE_SUFFIXES:
        label += TEXT_SUFFIXES[0]
    return (folders[0] / label).as_posix() if folders else label


def uri_of(path: Path) -> str:
    """Return the URI of a file."""
    full = path.absolute().as_posix()
    return "file://" + quote(full if full.startswith("/") else f"/{full}")

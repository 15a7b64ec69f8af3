# SPDX-License-Identifier: MIT
"""XML -> a small tree whose texts have the place of each character in the file.

The file is not trusted: document types, entities and references to other files are refused, depth
and size have bounds. The part before a mistake is read.
"""

from __future__ import annotations

from collections.abc import Iterator
from xml.parsers import expat

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.base.text import decode_text, split_lines
from nctakt.messages.plcs.st_text import PLC_FILE_TOO_LARGE, XML_FAULT, XML_REFUSED
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece

#: Maximum size of a file in bytes, and depth of its elements.
MAX_BYTES, MAX_DEPTH = 32 << 20, 200


class _RefusedError(Exception):
    """The file is refused."""


@dataclass(slots=True, eq=False)
class Element:
    """An element; ``name`` without its namespace, ``span`` of its begin."""

    name: str
    attributes: dict[str, str]
    span: Span
    children: list[Element] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    lines: list[int] = field(default_factory=list)
    columns: list[int] = field(default_factory=list)

    @property
    def text(self) -> str:
        """All of its text."""
        return "".join(self.texts)

    def child(self, name: str) -> Element | None:
        """Return its first child of a name."""
        return next((child for child in self.children if child.name == name), None)

    def child_text(self, name: str) -> str:
        """Return the stripped text of its first child of a name, or ""."""
        child = self.child(name)
        return "" if child is None else child.text.strip()

    def descendants(self, name: str) -> Iterator[Element]:
        """Yield all elements of a name in it, in the order of the file."""
        stack = list(reversed(self.children))
        while stack:
            element = stack.pop()
            if element.name == name:
                yield element
            stack.extend(reversed(element.children))

    def piece(self, title: str, *, is_declaration: bool) -> Piece:
        """Return its text as a piece of Structured Text."""
        offsets, lines, columns = [0], [self.span.line], [self.span.column]
        total = 0
        for text, line, column in zip(self.texts, self.lines, self.columns, strict=True):
            if text != "\n":
                offsets.append(total)
                lines.append(line)
                columns.append(column + 1)
            total += len(text)
        return Piece(self.span.file, self.text, offsets, lines, columns, title, is_declaration)


def read_xml(file: str, data: bytes, reporter: Reporter) -> Element | None:
    """Return the outermost element of a file; ``None`` if it is refused or empty."""
    if len(data) > MAX_BYTES:
        reporter.report_file(PLC_FILE_TOO_LARGE, Span(file, 1, 1, 2), limit=MAX_BYTES)
        return None
    text = decode_text(data).text
    reporter.sources.lines[file] = split_lines(text)
    reader = _Reader(file)
    try:
        reader.parser.Parse(text.encode("utf-8", errors="replace"), True)
    except _RefusedError:
        reporter.report_file(XML_REFUSED, reader.span())
        return None
    except RecursionError:
        reporter.report_file(PLC_FILE_TOO_LARGE, reader.span(), limit=MAX_BYTES)
        return None
    except expat.ExpatError as error:
        span = Span(file, max(1, error.lineno), error.offset + 1, error.offset + 2)
        reporter.report_file(XML_FAULT, span, reason=expat.errors.messages[error.code])
    return reader.root


class _Reader:
    """Makes the tree of one file."""

    def __init__(self, file: str) -> None:
        self._file = file
        self.root: Element | None = None
        self._open: list[Element] = []
        parser = self.parser = expat.ParserCreate("utf-8")
        parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
        parser.buffer_text = False
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._text
        parser.StartDoctypeDeclHandler = self._refuse
        parser.EntityDeclHandler = self._refuse
        parser.ExternalEntityRefHandler = self._refuse

    def span(self) -> Span:
        """Return where the parser is."""
        column = self.parser.CurrentColumnNumber + 1
        return Span(self._file, max(1, self.parser.CurrentLineNumber), column, column + 1)

    def _refuse(self, *_: object) -> int:
        raise _RefusedError

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        if len(self._open) >= MAX_DEPTH:
            raise _RefusedError
        element = Element(name.rpartition(":")[2], attributes, self.span())
        if self._open:
            self._open[-1].children.append(element)
        elif self.root is None:
            self.root = element
        self._open.append(element)

    def _end(self, _: str) -> None:
        self._open.pop()

    def _text(self, text: str) -> None:
        if self._open:
            element = self._open[-1]
            element.texts.append(text)
            element.lines.append(self.parser.CurrentLineNumber)
            element.columns.append(self.parser.CurrentColumnNumber)

# SPDX-License-Identifier: MIT
"""XML list -> entries.

In: the bytes of a parameter list in XML, the schema of its kind. Out: its entries as those of an
ASCII list. An element is named by a parameter ID with its indices after dots, the value is its
attribute ``Value``: ``<P-RTCF-00012.0.1 Value="x" />`` is ``thread[0].function[1].name``. The
elements around them have no meaning.

The file is not trusted: entities, document types and references to other files are refused, depth
and size have bounds. The part before a mistake is read.
"""

from __future__ import annotations

import re

from nctakt.base.diagnostics import Message, Span
from nctakt.base.text import decode_text, split_lines
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.reader import Entry
from nctakt.lists.format.schema import Schema
from nctakt.messages import Collector
from nctakt.messages.machines.lists import (
    XML_LIST_TOO_DEEP,
    XML_LIST_TOO_LARGE,
    XML_LIST_WITH_ENTITIES,
    XML_LIST_WITH_MISTAKE,
)

#: Maximum size of a list in bytes; the largest of vendors have a tenth of it.
MAX_BYTES = 16 << 20
#: Maximum depth of elements; lists have about ten levels.
MAX_DEPTH = 64
#: Bytes at the begin of a file that decide whether it is a list.
BEGIN_BYTES = 8192

_BEGIN = re.compile(rb"(\xef\xbb\xbf|\xff\xfe|\xfe\xff)?[\s\0]*<[\0]?[?!A-Za-z]")
_ID = re.compile(r"(P-[A-Z]{4}-[0-9]{5})((?:\.[0-9]{1,9})*)")
_FAMILY = re.compile(r"<P-([A-Z]{4})-[0-9]{5}")
_ROOT = re.compile(r"<([A-Za-z_][\w.-]*)")
_VALUE = re.compile(r"""\bValue\s*=\s*["']""")


class _RefusedError(Exception):
    """The reading is refused; the message has the reason."""

    def __init__(self, message: Message, **values: object) -> None:
        super().__init__(message.id)
        self.message = message
        self.values = values


def is_xml(data: bytes) -> bool:
    """Return whether a file begins like XML."""
    return _BEGIN.match(data) is not None


def root_and_families(data: bytes) -> tuple[str, tuple[str, ...]]:
    """Return the name of the outermost element, and the families of the IDs (``AXIS``), each once.

    Only the begin of the file is read.
    """
    text = decode_text(data[:BEGIN_BYTES]).text
    root = _ROOT.search(text)
    return ("" if root is None else root[1]), tuple(dict.fromkeys(_FAMILY.findall(text)))


def read_xml(file: str, data: bytes, schema: Schema, collector: Collector) -> tuple[Entry, ...]:
    """Return the entries of the XML list ``data``; ``file`` is its name in spans."""
    return tuple(_parse(file, data, schema, collector).entries)


def read_xml_comments(data: bytes, schema: Schema) -> tuple[tuple[int, str], ...]:
    """Return the comments of an XML list, each with its line."""
    return tuple(_parse("", data, schema, Collector()).comments)


def _parse(file: str, data: bytes, schema: Schema, collector: Collector) -> _Reader:
    from xml.parsers import expat  # noqa: PLC0415 - few lists are XML

    if len(data) > MAX_BYTES:
        collector.report(XML_LIST_TOO_LARGE, Span(file, 1, 1, 2), limit=MAX_BYTES)
        return _Reader(file, [], schema)
    text = decode_text(data).text
    reader = _Reader(file, split_lines(text), schema)
    parser = expat.ParserCreate("utf-8")
    parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
    parser.StartElementHandler = lambda name, values: reader.start(
        name, values, parser.CurrentLineNumber, parser.CurrentColumnNumber
    )
    parser.EndElementHandler = reader.end
    parser.CommentHandler = lambda comment: reader.comments.append(
        (parser.CurrentLineNumber, comment)
    )
    parser.StartDoctypeDeclHandler = _refuse_declaration
    parser.EntityDeclHandler = _refuse_declaration
    parser.ExternalEntityRefHandler = _refuse_declaration
    try:
        parser.Parse(text.encode("utf-8", errors="replace"), True)
    except _RefusedError as refused:
        span, line = reader.span(parser.CurrentLineNumber, parser.CurrentColumnNumber)
        collector.report(refused.message, span, line, **refused.values)
    except expat.ExpatError as error:
        span, line = reader.span(error.lineno, error.offset)
        reason = expat.errors.messages[error.code]
        collector.report(XML_LIST_WITH_MISTAKE, span, line, reason=reason)
    return reader


def _refuse_declaration(*_: object) -> int:
    raise _RefusedError(XML_LIST_WITH_ENTITIES)


class _Reader:
    """Gathers the entries of one list."""

    def __init__(self, file: str, lines: list[str], schema: Schema) -> None:
        self._file = file
        self._lines = lines
        self._schema = schema
        self._depth = 0
        self.entries: list[Entry] = []
        self.comments: list[tuple[int, str]] = []

    def start(self, name: str, values: dict[str, str], line_number: int, offset: int) -> None:
        """Read the begin of an element; ``offset``: bytes before it in its line."""
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise _RefusedError(XML_LIST_TOO_DEEP, limit=MAX_DEPTH)
        match = _ID.fullmatch(name)
        if match is None:
            return
        span, line = self.span(line_number, offset)
        # After the '<'.
        start = span.column + 1
        key_span = Span(self._file, line_number, start, start + len(name))
        indices = tuple(int(text) for text in match[2].split(".")[1:])
        path, pattern = self._name(match[1], name, indices)
        attribute = _VALUE.search(line, start - 1)
        column = start + len(name) if attribute is None else attribute.end() + 1
        value = values.get("Value", "")
        self.entries.append(
            Entry(path, pattern, indices, value, column, key_span, line, is_verbatim=True)
        )

    def end(self, _: str) -> None:
        """Read the end of an element."""
        self._depth -= 1

    def span(self, line_number: int, offset: int) -> tuple[Span, str]:
        """Return a span in the text, and its line."""
        line = self._lines[line_number - 1] if line_number <= len(self._lines) else ""
        column = len(line.encode("utf-8")[:offset].decode("utf-8", errors="replace")) + 1
        return Span(self._file, max(1, line_number), column, column + 1), line

    def _name(self, id_: str, name: str, indices: tuple[int, ...]) -> tuple[str, str]:
        """Return name and pattern of the parameter, else the element's own name."""
        for parameter in self._schema.by_id(id_):
            if len(parameter.index_ranges) == len(indices):
                return with_indices(parameter.pattern, indices), parameter.pattern
        return name, name

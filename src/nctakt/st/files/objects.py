# SPDX-License-Identifier: MIT
"""A file with objects of a PLC -> their declarations in the tree (ST-102 … 106).

In: the bytes of a ``.TcPOU``, ``.TcDUT``, ``.TcGVL``, ``.TcIO``, ``.TcTTO``, or of plain text. Out:
nodes of ``tree.py``. A mistake in one part leaves the others readable.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from nctakt.base.diagnostics import Span, Text
from nctakt.base.text import decode_text, split_lines
from nctakt.messages.plcs.st_text import (
    LANGUAGE_REFUSED,
    OBJECT_MISSING,
    PLC_FILE_TOO_LARGE,
    UNEXPECTED_TOKEN,
    XML_ELEMENT_UNKNOWN,
)
from nctakt.st.files.suffixes import TEXT_SUFFIXES
from nctakt.st.files.xml_text import MAX_BYTES, Element, read_xml
from nctakt.st.parse.declarations import DeclarationParser
from nctakt.st.parse.lexer import Definitions, Lexer
from nctakt.st.parse.parser import SyntaxFaultError
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece
from nctakt.st.tree import (
    Declaration,
    GlobalListNode,
    InterfaceNode,
    MethodNode,
    PouNode,
    PropertyNode,
    TaskNode,
)
from nctakt.st.types import Statement

_LANGUAGES = {
    "NWL": Text("LD/FBD/IL networks", "KOP-/FUP-/AWL-Netzwerken"),
    "LADDER": Text("ladder diagram", "Kontaktplan"),
    "CFC": Text("CFC", "CFC"),
    "SFC": Text("SFC", "Ablaufsprache (AS)"),
    "IL": Text("IL", "Anweisungsliste (AWL)"),
}
#: Elements without meaning here.
_IGNORED = frozenset(("Folder", "LineIds", "ObjectProperties", "Declaration", "Implementation"))
_PARTS = (Text("declaration", "Deklaration"), Text("implementation", "Implementierung"))
#: Lines of exports of older systems that say where an object was: comments (ST-105).
_EXPORT_LINE = re.compile(r"^@END_DECLARATION.*$|^\(\* @.*$", re.MULTILINE)


def read_objects(
    file: str, data: bytes, definitions: Definitions, reporter: Reporter
) -> list[Declaration]:
    """Return the declarations of a file by its suffix; mistakes are reported."""
    suffix = file[file.rfind(".") :].lower()
    if suffix in TEXT_SUFFIXES:
        return _ObjectReader(file, definitions, reporter).plain(data)
    root = read_xml(file, data, reporter)
    return [] if root is None else _ObjectReader(file, definitions, reporter).xml(root)


def parse_text(name: str, text: str, reporter: Reporter) -> list[Declaration]:
    """Return the declarations of a text that is no file of a user."""
    return _ObjectReader(f"{name}.st", Definitions(), reporter).plain(text.encode())


def parse_declaration(piece: Piece, reporter: Reporter) -> PouNode | None:
    """Return a POU of a text that only declares it; ``None`` where nothing of it can be read."""
    parser = _ObjectReader(piece.file, Definitions(), reporter)._parser(piece)
    try:
        pou = parser.pou(has_body=False)
        parser.end_of_declaration()
    except SyntaxFaultError:
        return None
    return pou


class _ObjectReader:
    """Reads the objects of one file."""

    def __init__(self, file: str, definitions: Definitions, reporter: Reporter) -> None:
        self._file = file
        self._definitions = definitions
        self._reporter = reporter

    def plain(self, data: bytes) -> list[Declaration]:
        """Read a plain text."""
        if len(data) > MAX_BYTES:
            span = Span(self._file, 1, 1, 2)
            self._reporter.report_file(PLC_FILE_TOO_LARGE, span, limit=MAX_BYTES)
            return []
        lines = split_lines(decode_text(data).text)
        self._reporter.sources.lines[self._file] = lines
        text = "\n".join(lines)
        if self._file.lower().endswith(".exp"):
            text = _EXPORT_LINE.sub(lambda match: " " * len(match[0]), text)
        offsets = [0]
        for line in lines:
            offsets.append(offsets[-1] + len(line) + 1)
        columns = [1] * len(offsets)
        piece = Piece(self._file, text, offsets, list(range(1, len(offsets) + 1)), columns)
        return self._parser(piece, is_plain=True).file()

    def xml(self, root: Element) -> list[Declaration]:
        """Read the objects of an XML file."""
        readers: dict[str, Callable[[Element], list[Declaration]]] = {
            "POU": self._pou,
            "DUT": self._types,
            "GVL": self._global_list,
            "Itf": self._interface,
            "Task": self._task,
        }
        found: list[Declaration] = []
        has_object = False
        for element in root.children:
            reader = readers.get(element.name)
            if reader is None:
                self._unknown(element)
                continue
            has_object = True
            try:
                found += reader(element)
            except SyntaxFaultError:  # nothing of the declaration can be read
                continue
        if not has_object:
            self._reporter.report_file(OBJECT_MISSING, root.span, file=self._file)
        return found

    def _parser(self, piece: Piece, *, is_plain: bool = False) -> DeclarationParser:
        self._reporter.sources.add(piece)
        tokens = Lexer(piece, self._definitions, self._reporter).read()
        return DeclarationParser(tokens, self._reporter, is_plain=is_plain)

    def _declaration(self, element: Element, name: str) -> DeclarationParser:
        child = element.child("Declaration")
        piece = (element if child is None else child).piece(name, is_declaration=True)
        return self._parser(piece)

    def _unknown(self, element: Element) -> None:
        if element.name not in _IGNORED:
            self._reporter.report_file(XML_ELEMENT_UNKNOWN, element.span, name=element.name)

    def _body(self, element: Element, name: str) -> tuple[list[Statement], str]:
        """Read the implementation of an object; the second is its language."""
        implementation = element.child("Implementation")
        if implementation is None or not implementation.children:
            return [], "ST"
        content = implementation.children[0]
        if content.name != "ST":
            language = _LANGUAGES.get(content.name.upper(), Text(content.name, content.name))
            self._reporter.report_file(LANGUAGE_REFUSED, content.span, name=name, language=language)
            return [], content.name
        return self._parser(content.piece(name, is_declaration=False)).whole_body(), "ST"

    def _pou(self, element: Element) -> list[Declaration]:
        name = element.attributes.get("Name", "")
        parser = self._declaration(element, name)
        if parser.kinds[0] not in ("PROGRAM", "FUNCTION_BLOCK", "FUNCTION"):
            parser.fail(UNEXPECTED_TOKEN, found=parser.texts[0] or "–")
        pou = parser.pou(has_body=False)
        parser.end_of_declaration(f"END_{pou.kind.value}")
        pou.body, pou.language = self._body(element, name)
        self._members(element, pou)
        return [pou]

    def _members(self, element: Element, owner: PouNode | InterfaceNode) -> None:
        """Read methods, properties and actions of an object."""
        for child in element.children:
            name = f"{owner.name}.{child.attributes.get('Name', '')}"
            try:
                if child.name == "Method":
                    owner.methods.append(self._method(child, name))
                elif child.name == "Property":
                    owner.properties.append(self._property(child, name))
                elif child.name == "Action" and isinstance(owner, PouNode):
                    owner.methods.append(self._action(child, name))
                elif child.name == "Transition":
                    language = Text("transitions of SFC", "Transitionen der Ablaufsprache")
                    self._reporter.report_file(
                        LANGUAGE_REFUSED, child.span, name=name, language=language
                    )
                else:
                    self._unknown(child)
            except SyntaxFaultError:
                continue

    def _method(self, element: Element, name: str) -> MethodNode:
        parser = self._declaration(element, name)
        if parser.word() != "METHOD":
            parser.fail(UNEXPECTED_TOKEN, found=parser.texts[0] or "–")
        method = parser.method(has_body=False)
        parser.end_of_declaration("END_METHOD")
        method.body, language = self._body(element, name)
        method.is_refused = language != "ST"
        return method

    def _action(self, element: Element, name: str) -> MethodNode:
        span = element.span
        piece = Piece(self._file, "", [0], [span.line], [span.column], name)
        self._reporter.sources.add(piece)
        action = MethodNode(
            piece.base, piece.base, element.attributes.get("Name", ""), is_action=True
        )
        action.body, language = self._body(element, name)
        action.is_refused = language != "ST"
        return action

    def _property(self, element: Element, name: str) -> PropertyNode:
        parser = self._declaration(element, name)
        if parser.word() != "PROPERTY":
            parser.fail(UNEXPECTED_TOKEN, found=parser.texts[0] or "–")
        node = parser.property(is_plain=False)
        parser.end_of_declaration("END_PROPERTY")
        for child in element.children:
            if child.name in ("Get", "Set"):
                accessor = self._accessor(child, f"{name}.{child.name}", node)
                if child.name == "Get":
                    node.get = accessor
                else:
                    node.set = accessor
            else:
                self._unknown(child)
        return node

    def _accessor(self, element: Element, name: str, owner: PropertyNode) -> MethodNode:
        accessor = MethodNode(owner.start, owner.end, element.name)
        if element.child("Declaration") is not None:
            parser = self._declaration(element, name)
            accessor.access = parser.accessor_access()
            accessor.variables = parser.blocks()
            parser.end_of_declaration()
        accessor.body, language = self._body(element, name)
        accessor.is_refused = language != "ST"
        return accessor

    def _interface(self, element: Element) -> list[Declaration]:
        parser = self._declaration(element, element.attributes.get("Name", ""))
        if parser.kinds[0] != "INTERFACE":
            parser.fail(UNEXPECTED_TOKEN, found=parser.texts[0] or "–")
        interface = parser.interface(is_plain=False)
        parser.end_of_declaration("END_INTERFACE")
        self._members(element, interface)
        return [interface]

    def _types(self, element: Element) -> list[Declaration]:
        parser = self._declaration(element, element.attributes.get("Name", ""))
        if parser.kinds[0] != "TYPE":
            parser.fail(UNEXPECTED_TOKEN, found=parser.texts[0] or "–")
        types = parser.types()
        parser.end_of_declaration()
        return [*types]

    def _global_list(self, element: Element) -> list[Declaration]:
        name = element.attributes.get("Name", "")
        parser = self._declaration(element, name)
        start, attributes = parser.start, parser.attributes.get(0, {})
        blocks = parser.blocks()
        parser.end_of_declaration()
        return [GlobalListNode(start, start + 1, name, blocks, attributes)]

    def _task(self, element: Element) -> list[Declaration]:
        span = element.span
        piece = Piece(self._file, "", [0], [span.line], [span.column])
        self._reporter.sources.add(piece)
        cycle, priority = element.child_text("CycleTime"), element.child_text("Priority")
        programs = [call.child_text("Name") for call in element.descendants("PouCall")]
        return [
            TaskNode(
                piece.base,
                piece.base,
                element.attributes.get("Name", ""),
                int(cycle[:12]) if cycle.isdecimal() else 0,
                int(priority[:6]) if priority.isdecimal() else 0,
                [name for name in programs if name],
            )
        ]

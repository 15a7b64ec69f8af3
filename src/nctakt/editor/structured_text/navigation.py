# SPDX-License-Identifier: MIT
"""From a name of a PLC to its declaration, its uses and its description.

In: the names of a project, a document, a position. Out: places, explanations, an outline.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from lsprotocol.types import (
    DocumentSymbol,
    Hover,
    Location,
    MarkupContent,
    MarkupKind,
    Position,
    Range,
    SymbolKind,
)

from nctakt.base.diagnostics import Language
from nctakt.editor.document import Document, uri_of
from nctakt.editor.structured_text.descriptions import comment_of, declaration_of, facts_of
from nctakt.editor.structured_text.occurrences import Occurrence, key_of
from nctakt.editor.structured_text.plc_project import PlcFile
from nctakt.editor.structured_text.positions import range_of
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.st.tree import (
    EnumNode,
    GlobalListNode,
    Header,
    InterfaceNode,
    PouNode,
    StructNode,
    TypeDeclaration,
    VariableBlock,
    VariableNode,
)
from nctakt.st.types import Kind, Node

#: The language of code in explanations.
CODE = "iecst"
#: Maximum number of symbols of a file; a longer outline is of no use.
MAX_SYMBOLS = 5000


def hover(
    names: ProjectNames, document: Document, position: Position, language: Language
) -> Hover | None:
    """Return the declaration of the name at a position, its value, the comments about it."""
    found = names.at(document, position)
    if found is None:
        return None
    target, sources = found.target, names.project.sources
    parts = [f"```{CODE}\n{declaration_of(target)}\n```"]
    facts = facts_of(target, language)
    if facts:
        parts.append(", ".join(facts))
    comment = comment_of(sources, _start_of(names, found))
    if comment:
        parts.append(comment.replace("\n", "  \n"))
    area = range_of(document, sources, found.start, found.end)
    return Hover(MarkupContent(MarkupKind.Markdown, "\n\n".join(parts)), area)


def _start_of(names: ProjectNames, found: Occurrence) -> int:
    """Return where the target of a name is declared, 0 where that is not known."""
    start: int = getattr(found.target, "start", 0)
    if start:
        return start
    places = names.all_of(found.target, found.name)
    return next((one.start for _, one in places if one.is_definition), 0)


def definition(names: ProjectNames, document: Document, position: Position) -> list[Location]:
    """Return where the name at a position is declared, in the project or in a library's files."""
    found = names.at(document, position)
    if found is None:
        return []
    own = key_of(found.target)
    places = [
        _location(names, document, file, one)
        for file, one in names.all_of(found.target, found.name)
        if one.is_definition and key_of(one.target) == own
    ]
    return places or list(_in_library(names, document, found))


def _in_library(names: ProjectNames, document: Document, found: Occurrence) -> Iterator[Location]:
    start: int = getattr(found.target, "start", 0)
    span = names.project.sources.span(start, start + len(found.name)) if start else None
    if span is not None and Path(span.file).is_file():
        line, first, last = span.line - 1, span.column - 1, span.end_column - 1
        yield Location(uri_of(Path(span.file)), Range(Position(line, first), Position(line, last)))


def references(
    names: ProjectNames, document: Document, position: Position, *, with_definition: bool
) -> list[Location]:
    """Return where the name at a position is used in the project."""
    found = names.at(document, position)
    if found is None:
        return []
    return [
        _location(names, document, file, one)
        for file, one in names.all_of(found.target, found.name)
        if with_definition or not one.is_definition
    ]


def highlights(names: ProjectNames, document: Document, position: Position) -> list[Range]:
    """Return where this document has the name at a position."""
    found = names.at(document, position)
    file = names.project.file_named(document.name)
    if found is None or file is None:
        return []
    key = key_of(found.target)
    return [
        range_of(document, names.project.sources, one.start, one.end)
        for one in names.of(file)
        if key_of(one.target) == key
    ]


def _location(names: ProjectNames, document: Document, file: PlcFile, one: Occurrence) -> Location:
    like = document_of(names, document, file)
    return Location(like.uri, range_of(like, names.project.sources, one.start, one.end))


def document_of(names: ProjectNames, document: Document, file: PlcFile) -> Document:
    """Return a file of the project as a document: its lines are those of the last check."""
    if file.name == document.name:
        return document
    path = Path(file.name)
    lines = names.project.sources.lines.get(file.name, [])
    return Document(uri_of(path), path, file.name, document.language, 0, lines, document.encoding)


# --- outline -------------------------------------------------------------------------------------

_POU_KINDS = {
    Kind.PROGRAM: SymbolKind.Module,
    Kind.FUNCTION_BLOCK: SymbolKind.Class,
    Kind.FUNCTION: SymbolKind.Function,
}


class Outline:
    """Makes the outline of a file; its ranges end with the last part that has a place."""

    def __init__(self, names: ProjectNames, document: Document, file: PlcFile) -> None:
        self._sources = names.project.sources
        self._document = document
        self._nodes = file.nodes
        self._count = 0

    def symbols(self) -> list[DocumentSymbol]:
        """Return the objects of the file, each with its declarations."""
        return [one for node in self._nodes for one in self._object(node)]

    def _object(self, node: object) -> Iterator[DocumentSymbol]:
        if isinstance(node, PouNode):
            children = [*self._blocks(node.variables), *self._members(node)]
            yield self._symbol(node, node.name, _POU_KINDS[node.kind], children, node.body)
        elif isinstance(node, InterfaceNode):
            yield self._symbol(node, node.name, SymbolKind.Interface, self._members(node))
        elif isinstance(node, TypeDeclaration):
            yield self._type(node)
        elif isinstance(node, GlobalListNode):
            children = self._blocks(node.blocks)
            if children:
                yield self._symbol(node, node.name or "VAR_GLOBAL", SymbolKind.Namespace, children)

    def _type(self, node: TypeDeclaration) -> DocumentSymbol:
        if isinstance(node.type, EnumNode):
            items = [self._symbol(one, one.name, SymbolKind.EnumMember) for one in node.type.items]
            return self._symbol(node, node.name, SymbolKind.Enum, items)
        if isinstance(node.type, StructNode):
            members = self._variables(node.type.members, SymbolKind.Field)
            return self._symbol(node, node.name, SymbolKind.Struct, members)
        return self._symbol(node, node.name, SymbolKind.TypeParameter)

    def _members(self, node: PouNode | InterfaceNode) -> list[DocumentSymbol]:
        found = []
        for method in node.methods:
            kind = SymbolKind.Event if method.is_action else SymbolKind.Method
            inner = self._blocks(method.variables)
            found.append(self._symbol(method, method.name, kind, inner, method.body))
        for one in node.properties:
            bodies: list[Node] = [
                part
                for accessor in (one.get, one.set)
                if accessor is not None
                for part in accessor.body
            ]
            found.append(self._symbol(one, one.name, SymbolKind.Property, [], bodies))
        return found

    def _blocks(self, blocks: Sequence[VariableBlock]) -> list[DocumentSymbol]:
        found = []
        for block in blocks:
            kind = SymbolKind.Variable
            if "CONSTANT" in block.qualifiers:
                kind = SymbolKind.Constant
            found += self._variables(block.variables, kind)
        return found

    def _variables(self, nodes: Sequence[VariableNode], kind: SymbolKind) -> list[DocumentSymbol]:
        found = []
        for node in nodes:
            if self._count < MAX_SYMBOLS:
                self._count += 1
                symbol = self._symbol(node, node.name, kind)
                symbol.detail = self._sources.text(node.type.start, node.type.end) or None
                found.append(symbol)
        return found

    def _symbol(
        self,
        node: Node | Header,
        name: str,
        kind: SymbolKind,
        children: Sequence[DocumentSymbol] = (),
        body: Sequence[Node] = (),
    ) -> DocumentSymbol:
        """Return a symbol whose range takes its children and statements in."""
        selected = range_of(self._document, self._sources, node.start, node.start + len(name))
        end = selected.end
        ends = [child.range.end for child in children]
        if body:
            last = range_of(self._document, self._sources, body[-1].start, body[-1].end)
            ends.append(last.end)
        for one in ends:
            if (one.line, one.character) > (end.line, end.character):
                end = one
        start = selected.start
        for child in children:
            first = child.range.start
            if (first.line, first.character) < (start.line, start.character):
                start = first
        return DocumentSymbol(name, kind, Range(start, end), selected, children=list(children))

# SPDX-License-Identifier: MIT
"""Targets of the names of a project, as of its last check.

In: a project, places of documents. Out: occurrences of names by file, all those of one target, the
meaning of a typed expression. The trees of files not affected by a change were resolved by an
earlier check: they are resolved again when their names are requested.
"""

from __future__ import annotations

from collections.abc import Iterator

from lsprotocol.types import Position

from nctakt.editor.document import Document
from nctakt.editor.structured_text.occurrences import Occurrence, OccurrenceReader, key_of
from nctakt.editor.structured_text.plc_project import PlcFile, PlcProject
from nctakt.editor.structured_text.positions import position_at
from nctakt.messages import Collector
from nctakt.st.check.names import Declared, Scope
from nctakt.st.check.project import ProjectChecker
from nctakt.st.parse.declarations import DeclarationParser
from nctakt.st.parse.lexer import Definitions, Lexer
from nctakt.st.parse.parser import SyntaxFaultError
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece, Sources
from nctakt.st.tree import GlobalList, GlobalListNode, Target
from nctakt.st.types import Expression, InterfaceType, Method, Pou, Property


class ProjectNames:
    """The names of a project; callers hold the project's lock."""

    def __init__(self, project: PlcProject) -> None:
        self.project = project
        self.checker: ProjectChecker = project.update()
        self._occurrences: dict[str, list[Occurrence]] = {}

    # --- names ------------------------------------------------------------------------------------

    def of(self, file: PlcFile) -> list[Occurrence]:
        """Return all names of a file, by position."""
        known = self._occurrences.get(file.name)
        if known is None:
            self._resolve(file)
            known = self._occurrences[file.name] = OccurrenceReader(self.checker).of(file.nodes)
        return known

    def at(self, document: Document, position: Position) -> Occurrence | None:
        """Return the name at a place of a document."""
        file = self.project.file_named(document.name)
        spot = None if file is None else position_at(document, position, file)
        if file is None or spot is None:
            return None
        number = spot[0].base + spot[1]
        return next((one for one in self.of(file) if one.start <= number <= one.end), None)

    def all_of(self, target: Target, name: str) -> Iterator[tuple[PlcFile, Occurrence]]:
        """Yield all places of a name's target, including overrides of a method."""
        keys = {key_of(one) for one in self.family(target)}
        for file in self.project.files.values():
            if name.lower() in file.facts.words:
                for one in self.of(file):
                    if key_of(one.target) in keys and one.name.lower() == name.lower():
                        yield file, one

    def family(self, target: Target) -> list[Target]:
        """Return a method or property with those that it overrides and that override it."""
        if not isinstance(target, Method | Property):
            return [target]
        name = target.name.lower()
        groups = self._groups(name, is_method=isinstance(target, Method))
        found: list[Target] = [target]
        for one in found:
            for group in groups:
                if any(member is one for member in group):
                    found += [member for member in group if all(member is not x for x in found)]
        return found

    def _groups(self, name: str, *, is_method: bool) -> list[list[Method | Property]]:
        """Return members of a name that are one and the same for callers, by pairs of types."""
        groups = []
        for owner in self.owners():
            bases: list[Pou | InterfaceType] = []
            if isinstance(owner, Pou):
                bases = [*owner.interfaces, *([owner.base] if owner.base else [])]
            else:
                bases = list(owner.bases)
            for base in bases:
                pair = [_member(owner, name, is_method), _member(base, name, is_method)]
                found = [one for one in pair if one is not None]
                if len(found) > 1 and found[0] is not found[1]:
                    groups.append(found)
        return groups

    def owners(self) -> Iterator[Pou | InterfaceType]:
        """Yield the blocks and interfaces of the project."""
        for declared in self.checker.names.project.declared.values():
            if isinstance(declared.target, Pou | InterfaceType):
                yield declared.target

    def lists(self) -> Iterator[tuple[GlobalListNode, GlobalList]]:
        """Yield the lists of global variables with their nodes."""
        for node in self.project.declarations:
            if isinstance(node, GlobalListNode):
                title = node.attributes.get("list", node.name)
                found = self.checker.names.project.lists.get(title.lower())
                if found is not None:
                    yield node, found

    # --- typed text -------------------------------------------------------------------------------

    def scope_of(self, path: str) -> Scope:
        """Return the names that a POU, method or accessor sees; of any other path only the
        project's.
        """
        lower = path.lower()
        for unit, (_, scope) in self.checker.resolver.nodes.items():
            if unit.path.lower() == lower:
                return scope
        return Scope()

    def expression(self, text: str, scope: Scope) -> Expression | None:
        """Return a typed text as an expression of a scope, ``None`` if it is not one."""
        reporter = Reporter(Sources(), Collector())
        piece = Piece("", text, [0], [1], [1])
        reporter.sources.add(piece)
        parser = DeclarationParser(Lexer(piece, Definitions(), reporter).read(), reporter)
        try:
            node = parser.expression()
        except SyntaxFaultError:
            return None
        diagnostics = self.checker.reporter.collector.diagnostics
        count = len(diagnostics)
        self.checker.scope = scope
        self.checker.operand(node)
        del diagnostics[count:]
        return node

    def qualifier(self, node: Expression, scope: Scope) -> Target | None:
        """Return the list, type, library or POU that an expression names."""
        self.checker.scope = scope
        return self.checker.qualifier(node)

    def target_of(self, found: object) -> Target | None:
        """Return the target of an entry of a namespace."""
        if isinstance(found, Declared):
            return self.checker.resolver.target_of(found)
        return found  # type: ignore[return-value]

    def _resolve(self, file: PlcFile) -> None:
        """Have the checker note the present targets of a file's names."""
        resolver = self.checker.resolver
        own = {id(unit) for node in file.nodes for unit in _headers(node)}
        diagnostics = self.checker.reporter.collector.diagnostics
        count = len(diagnostics)
        for unit, (header, _) in list(resolver.nodes.items()):
            if id(header) in own:
                self.checker.unit_inside(header, unit)
        del diagnostics[count:]


def _headers(node: object) -> Iterator[object]:
    yield node
    yield from getattr(node, "methods", ())
    for one in getattr(node, "properties", ()):
        yield from (one.get, one.set)


def _member(owner: Pou | InterfaceType, name: str, is_method: bool) -> Method | Property | None:
    if isinstance(owner, InterfaceType):
        groups: list[InterfaceType] = [owner]
        for one in groups:
            groups += [base for base in one.bases if base not in groups]
        for one in groups:
            found = one.methods.get(name) if is_method else one.properties.get(name)
            if found is not None:
                return found
        return None
    return owner.find_method(name) if is_method else owner.find_property(name)

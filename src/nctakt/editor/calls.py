# SPDX-License-Identifier: MIT
"""Callers and calls of a program: main programs, local subprograms, programs in files.

In: a document and a position, or an item of an earlier answer. Out: items of the call hierarchy. A
program is also called by a G function or M6 that the channel list or ``#FILE NAME`` gives one.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping

from lsprotocol.types import (
    CallHierarchyIncomingCall,
    CallHierarchyItem,
    CallHierarchyOutgoingCall,
    Position,
    Range,
    SymbolKind,
)

from nctakt.base.dataclass import dataclass
from nctakt.editor.document import Document, path_of
from nctakt.editor.names import occurrences_in, outside_comments, section_of, sections, symbol_at
from nctakt.editor.navigation import called_file
from nctakt.editor.workspace import LoadedMachine, Workspace
from nctakt.nc.parse.lexer import without_comments

_START = re.compile(r"\s*(?:N\s*\d+\s*)?%\s*(?P<local>L\s+(?=\S))?(?P<name>[^;(]*)", re.IGNORECASE)
_NAMED = re.compile(r'(?P<word>[GM]\d+)\s*=\s*"(?P<file>[^"]+)"', re.IGNORECASE)
_FILE_NAME = re.compile(r"\#\s*FILE\s*NAME\b", re.IGNORECASE)
_FUNCTION = re.compile(r"(?<![\w.$#\"])(?P<letter>[GM])(?P<number>\d+)(?![\w.\"])", re.IGNORECASE)
#: The M function that a program may replace.
_TOOL_CHANGE = 6


@dataclass(frozen=True, slots=True)
class _Call:
    """A call in a line: the item that it runs, and its place."""

    target: CallHierarchyItem
    area: Range


class CallHierarchy:
    """The calls of the programs of one machine; ``programs`` returns those to search."""

    def __init__(
        self, work: Workspace, loaded: LoadedMachine, programs: Callable[[], Iterable[Document]]
    ) -> None:
        self._work = work
        self._loaded = loaded
        self._programs = programs

    def prepare(self, document: Document, position: Position) -> list[CallHierarchyItem]:
        """Return the program that is called at a position, else the one around it."""
        index = document.index(position)
        for call in self._calls(document, range(position.line, position.line + 1)):
            if call.area.start.character <= position.character <= call.area.end.character:
                return [call.target]
        found = symbol_at(document.lines, position.line, index)
        if found is not None and found.symbol.kind in ("subprogram", "file"):
            if not found.is_definition:
                return []
        return [_item(document, section_of(document.lines, position.line))]

    def outgoing(self, item: CallHierarchyItem) -> list[CallHierarchyOutgoingCall]:
        """Return the calls of a program, in the order of its text."""
        document = self._document(item.uri)
        if document is None:
            return []
        found: dict[tuple[str, int], tuple[CallHierarchyItem, list[Range]]] = {}
        within = section_of(document.lines, item.selection_range.start.line)
        for call in self._calls(document, within):
            found.setdefault(_key(call.target), (call.target, []))[1].append(call.area)
        return [CallHierarchyOutgoingCall(*entry) for entry in found.values()]

    def incoming(self, item: CallHierarchyItem) -> list[CallHierarchyIncomingCall]:
        """Return the callers of a program, those in its own file first."""
        own = self._document(item.uri)
        if own is None:
            return []
        others = [document for document in self._programs() if document.uri != own.uri]
        found: list[CallHierarchyIncomingCall] = []
        for document in (own, *others):
            for within in sections(document.lines):
                areas = [
                    call.area
                    for call in self._calls(document, within)
                    if _key(call.target) == _key(item)
                ]
                if areas:
                    found.append(CallHierarchyIncomingCall(_item(document, within), areas))
        return found

    def _document(self, uri: str) -> Document | None:
        """Return a document, open or from its file."""
        path = path_of(uri)
        known = self._work.documents.get(uri)
        return known if known is not None or path is None else self._work.document_of(path)

    def _calls(self, document: Document, within: range) -> Iterator[_Call]:
        """Yield the calls in some lines whose programs are known."""
        locals_ = _subprograms(document)
        named = self._named(document)
        for number, line in outside_comments(document.lines, within):
            code = without_comments(line)
            for found in occurrences_in(line, number):
                target: CallHierarchyItem | None = None
                if found.symbol.kind == "subprogram" and not found.is_definition:
                    target = locals_.get(found.symbol.name)
                elif found.symbol.kind == "file":
                    target = self._of_file(document, found.symbol.name)
                if target is not None:
                    yield _Call(target, document.range(number, found.start, found.end))
            if not named or "#" in code or "$" in code:
                continue
            for match in _FUNCTION.finditer(code):
                file = named.get(f"{match['letter'].upper()}{int(match['number'])}")
                target = None if file is None else self._of_file(document, file)
                if target is not None:
                    yield _Call(target, document.range(number, *match.span()))

    def _named(self, document: Document) -> Mapping[str, str]:
        """Return the files that G functions and M6 call, by the channel list or ``#FILE NAME``."""
        programs = self._loaded.machine.parameters.implicit_programs
        names = {f"G{number}": file for number, file in programs.g.items() if file}
        if programs.m6:
            names[f"M{_TOOL_CHANGE}"] = programs.m6
        for line in document.lines:
            if "#" in line and _FILE_NAME.search(line):
                for match in _NAMED.finditer(line):
                    word = match["word"].upper()
                    names[f"{word[0]}{int(word[1:])}"] = match["file"]
        return names

    def _of_file(self, document: Document, name: str) -> CallHierarchyItem | None:
        """Return the main program of a called file."""
        path = called_file(document, name, self._loaded)
        called = None if path is None else self._work.document_of(path)
        if called is None:
            return None
        return _item(called, _main(called))


def _main(document: Document) -> range:
    """Return the lines of the main program: those of the first section without ``L``."""
    for within in sections(document.lines):
        match = _START.match(document.line(within.start))
        if match is None or match["local"] is None:
            return within
    return range(len(document.lines))


def _subprograms(document: Document) -> dict[str, CallHierarchyItem]:
    """Return the local subprograms of a document by name."""
    found = {}
    for within in sections(document.lines):
        match = _START.match(document.line(within.start))
        if match is not None and match["local"] is not None:
            found[match["name"].strip()] = _item(document, within)
    return found


def _item(document: Document, within: range) -> CallHierarchyItem:
    """Return the item of a section: named as its ``%`` line says, else as its file."""
    match = _START.match(document.line(within.start))
    file = document.name.rpartition("/")[2]
    name = "" if match is None else match["name"].strip()
    is_local = match is not None and match["local"] is not None
    last = max(within.start, within.stop - 1)
    return CallHierarchyItem(
        name or file,
        SymbolKind.Function if is_local else SymbolKind.Module,
        document.uri,
        document.whole_lines(within.start, last),
        document.whole_lines(within.start, within.start),
        detail=file,
    )


def _key(item: CallHierarchyItem) -> tuple[str, int]:
    return item.uri, item.selection_range.start.line

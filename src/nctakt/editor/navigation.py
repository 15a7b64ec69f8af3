# SPDX-License-Identifier: MIT
"""From a name to its definition, its uses, and another name.

In: a document, a position, the machine. Out: places. A variable or an axis of the machine is
defined in its list, a called program in its file.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from lsprotocol.types import Location, Position, Range, TextEdit, WorkspaceEdit

from nctakt.editor.document import Document, uri_of
from nctakt.editor.list_lines import list_occurrences_in, list_symbol_at
from nctakt.editor.names import (
    OWN_FAMILIES,
    Occurrence,
    Symbol,
    occurrences,
    section_of,
    symbol_at,
)
from nctakt.editor.workspace import LoadedMachine
from nctakt.lists.machine.files import find_below
from nctakt.run.program_loader import find_program, search_folders

_IDENTIFIER = re.compile(r"[A-Za-z_]\w*")
_AXIS_NAME = re.compile(r"[ABCQU-Z]\w*")
_NUMBER = re.compile(r"[1-9]\d{0,9}")
_LIST_FILE = re.compile(r"^\s*[\w.\[\]]+\s+(?P<file>[^\s#]+\.(?:lis|xml|nc))\b", re.IGNORECASE)

#: The programs of the same machine, the current one among them.
Programs = Callable[[], Iterable[Document]]


def found_at(document: Document, position: Position, loaded: LoadedMachine) -> Occurrence | None:
    """Return the name at a position of a program or list."""
    index = document.index(position)
    if document.is_list:
        return list_symbol_at(document.lines, position.line, index)
    return symbol_at(document.lines, position.line, index, _axes(loaded))


def _axes(loaded: LoadedMachine) -> list[str]:
    return [axis.name for axis in loaded.machine.parameters.axes]


def definition(document: Document, position: Position, loaded: LoadedMachine) -> list[Location]:
    """Return where the name at a position is defined."""
    item = found_at(document, position, loaded)
    if item is None:
        return _named_list(document, position, loaded) if document.is_list else []
    if item.symbol.kind == "file":
        return _file(document, item.symbol.name, loaded)
    if is_of_machine(item.symbol):
        return list(_in_lists(item.symbol, loaded))
    defined = [other for other in _all(document, item) if other.is_definition]
    if item.symbol.kind == "parameter":
        defined = defined[:1]
    return [Location(document.uri, _range(document, other)) for other in defined]


def references(
    document: Document,
    position: Position,
    loaded: LoadedMachine,
    programs: Programs,
    *,
    with_definition: bool,
) -> list[Location]:
    """Return where the name at a position is used: of a name of the machine in all programs."""
    item = found_at(document, position, loaded)
    if item is None:
        return []
    if not is_of_machine(item.symbol):
        return [
            Location(document.uri, _range(document, other))
            for other in _all(document, item)
            if with_definition or not other.is_definition
        ]
    found = list(_in_lists(item.symbol, loaded)) if with_definition else []
    for program in programs():
        for other in occurrences(program.lines, item.symbol):
            found.append(Location(program.uri, _range(program, other)))
    return found


def highlights(document: Document, position: Position, loaded: LoadedMachine) -> list[Range]:
    """Return where this document has the name at a position."""
    item = found_at(document, position, loaded)
    if item is None:
        return []
    if document.is_list:
        return [_range(document, item)]
    return [_range(document, other) for other in _all(document, item)]


def is_of_machine(symbol: Symbol) -> bool:
    """Return whether the lists of the machine give the name: an axis, a V.E or V.CH variable."""
    return symbol.kind == "axis" or (symbol.kind == "variable" and not is_own(symbol))


def is_own(symbol: Symbol) -> bool:
    """Return whether the program itself declares a variable."""
    parts = symbol.name.split(".")
    return len(parts) > 1 and parts[1] in OWN_FAMILIES


def can_rename(symbol: Symbol) -> bool:
    """Return whether the name is one of the program or of the machine's lists."""
    if symbol.kind == "variable":
        return is_own(symbol) or re.fullmatch(r"V\.(?:E|CH)\.\w+", symbol.name) is not None
    return symbol.kind != "file"


def renamed_part(document: Document, item: Occurrence) -> tuple[int, int]:
    """Return the columns of the part of a name that changes: of a variable its last part."""
    if item.symbol.kind != "variable" or document.is_list:
        return item.start, item.end
    return _part(document, item, len(item.symbol.name.split(".")))


def rename(
    document: Document, position: Position, new: str, loaded: LoadedMachine, programs: Programs
) -> WorkspaceEdit | None:
    """Return the edits that give a name another one, ``None`` where it cannot have it.

    A name of the machine changes in its lists and in all its programs.
    """
    item = found_at(document, position, loaded)
    if item is None or not can_rename(item.symbol):
        return None
    kind, name = item.symbol
    is_numbered = kind in ("cycle", "parameter") or (kind == "label" and name[1:].isdigit())
    text = new.lstrip("NnPp") if is_numbered and kind != "cycle" else new
    form = _NUMBER if is_numbered else _AXIS_NAME if kind == "axis" else _IDENTIFIER
    if form.fullmatch(text) is None:
        return None
    changes: dict[str, list[TextEdit]] = {}
    if is_of_machine(item.symbol):
        if loaded.machine.configuration.is_demo:
            return None
        for area in _in_lists(item.symbol, loaded):
            changes.setdefault(area.uri, []).append(TextEdit(area.range, text))
        for program in programs():
            edits = [
                _renaming(program, other, item.symbol, text)
                for other in occurrences(program.lines, item.symbol)
            ]
            if edits:
                changes[program.uri] = edits
    else:
        changes[document.uri] = [
            _renaming(document, other, item.symbol, text) for other in _all(document, item)
        ]
    return WorkspaceEdit(changes=changes)


def _renaming(document: Document, item: Occurrence, symbol: Symbol, text: str) -> TextEdit:
    """Return the edit that renames one occurrence."""
    start, end = item.start, item.end
    if symbol.kind == "variable":
        start, end = _part(document, item, len(symbol.name.split(".")))
    elif symbol.kind == "parameter":
        text = f"P{text}"
    elif symbol.kind == "axis" and len(text) > 1:
        line = document.line(item.line)
        value = line[end:].lstrip()[:1]
        if line[start - 1 : start] != "." and value not in ("", "=", "[", "]", ","):
            text += "="  # a word of several letters
    return TextEdit(document.range(item.line, start, end), text)


def _part(document: Document, item: Occurrence, count: int) -> tuple[int, int]:
    """Return the columns of part ``count`` of a variable's path."""
    text = document.line(item.line)[item.start : item.end]
    plain = re.sub(r"\[[^\[\]]*\]", lambda match: "\0" * len(match[0]), text)
    start = 0
    parts = plain.split(".")
    for part in parts[: count - 1]:
        start += len(part) + 1
    return item.start + start, item.start + start + len(parts[count - 1].rstrip("\0"))


def _all(document: Document, item: Occurrence) -> Iterator[Occurrence]:
    is_label = item.symbol.kind == "label"
    within = section_of(document.lines, item.line) if is_label else None
    return occurrences(document.lines, item.symbol, within)


def _range(document: Document, item: Occurrence) -> Range:
    return document.range(item.line, item.start, item.end)


def _file(document: Document, name: str, loaded: LoadedMachine) -> list[Location]:
    path = called_file(document, name, loaded)
    start = Range(Position(0, 0), Position(0, 0))
    return [] if path is None else [Location(uri_of(path), start)]


def called_file(document: Document, name: str, loaded: LoadedMachine) -> Path | None:
    """Return the file that a call by this name runs."""
    machine = loaded.machine
    folders = search_folders(document.name, machine.parameters, machine.configuration.folder)
    return find_program(name, folders, loaded.access)


def _in_lists(symbol: Symbol, loaded: LoadedMachine) -> Iterator[Location]:
    """Yield where a list of the machine names a variable or an axis."""
    root = Symbol(symbol.kind, ".".join(symbol.name.split(".")[:3]))
    for kind, path in loaded.machine.configuration.lists:
        if kind != ("channel" if symbol.kind == "axis" else "variables"):
            continue
        for number, line in enumerate(loaded.access.read_lines(path)):
            for item in list_occurrences_in(line, number):
                if item.symbol == root:
                    area = Range(Position(number, item.start), Position(number, item.end))
                    yield Location(uri_of(path), area)


def list_file(
    document: Document, line: int, loaded: LoadedMachine
) -> tuple[Path, tuple[int, int]] | None:
    """Return the file that an entry of a list names, and the columns of its name."""
    match = _LIST_FILE.match(document.line(line))
    if match is None:
        return None
    folder = Path(document.name).parent
    path = find_below(match["file"].replace("\\", "/"), folder, loaded.access)
    return None if path is None else (path, match.span("file"))


def _named_list(document: Document, position: Position, loaded: LoadedMachine) -> list[Location]:
    found = list_file(document, position.line, loaded)
    start = Range(Position(0, 0), Position(0, 0))
    return [] if found is None else [Location(uri_of(found[0]), start)]

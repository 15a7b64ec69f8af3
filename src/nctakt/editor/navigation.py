# SPDX-License-Identifier: MIT
"""From a name to its definition, its uses, and another name.

In: a document, a position, the machine. Out: places. A variable of the machine is defined in its
list, a called program in its file.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from lsprotocol.types import Location, Position, Range, TextEdit, WorkspaceEdit

from nctakt.editor.document import Document, uri_of
from nctakt.editor.names import (
    OWN_FAMILIES,
    Occurrence,
    Symbol,
    occurrences,
    section_of,
    symbol_at,
)
from nctakt.editor.workspace import LoadedMachine
from nctakt.run.program_loader import find_program, search_folders

_LIST_NAME = re.compile(r"^\s*(?:var|v_ch)\[\d+\]\.name\s+(?P<name>\S+)", re.IGNORECASE)
_IDENTIFIER = re.compile(r"[A-Za-z_]\w*")
_NUMBER = re.compile(r"[1-9]\d{0,9}")


def found_at(document: Document, position: Position) -> Occurrence | None:
    """Return the name at a position of a program."""
    if document.is_list:
        return None
    return symbol_at(document.lines, position.line, document.index(position))


def definition(document: Document, position: Position, loaded: LoadedMachine) -> list[Location]:
    """Return where the name at a position is defined."""
    item = found_at(document, position)
    if item is None:
        return []
    if item.symbol.kind == "file":
        return _file(document, item.symbol.name, loaded)
    if item.symbol.kind == "variable" and not is_own(item.symbol):
        return list(_in_list(item.symbol, loaded))
    places = [other for other in _all(document, item) if other.is_definition]
    if item.symbol.kind == "parameter":
        places = places[:1]
    return [Location(document.uri, _range(document, other)) for other in places]


def references(document: Document, position: Position, *, with_definition: bool) -> list[Location]:
    """Return where the name at a position is used."""
    item = found_at(document, position)
    if item is None:
        return []
    return [
        Location(document.uri, _range(document, other))
        for other in _all(document, item)
        if with_definition or not other.is_definition
    ]


def is_own(symbol: Symbol) -> bool:
    """Return whether the program itself declares a variable."""
    parts = symbol.name.split(".")
    return len(parts) > 1 and parts[1] in OWN_FAMILIES


def can_rename(symbol: Symbol) -> bool:
    """Return whether the name is one of the program or of the machine's list of variables."""
    if symbol.kind in ("axis", "file"):
        return False
    return symbol.kind != "variable" or is_own(symbol) or symbol.name.startswith("V.E.")


def renamed_part(document: Document, item: Occurrence) -> tuple[int, int]:
    """Return the columns of the part of a name that changes: of a variable its last part."""
    text = document.line(item.line)[item.start : item.end]
    if item.symbol.kind != "variable":
        return item.start, item.end
    plain = re.sub(r"\[[^\[\]]*\]", lambda match: " " * len(match[0]), text).rstrip()
    return item.start + plain.rindex(".") + 1, item.start + len(plain)


def rename(
    document: Document, position: Position, new: str, loaded: LoadedMachine
) -> WorkspaceEdit | None:
    """Return the edits that give a name another one, ``None`` where it cannot have it."""
    item = found_at(document, position)
    if item is None or not can_rename(item.symbol):
        return None
    kind, name = item.symbol
    is_numbered = kind in ("cycle", "parameter") or (kind == "label" and name[1:].isdigit())
    text = new.lstrip("NnPp") if is_numbered and kind != "cycle" else new
    if (_NUMBER if is_numbered else _IDENTIFIER).fullmatch(text) is None:
        return None
    changes: dict[str, list[TextEdit]] = {document.uri: []}
    for other in _all(document, item):
        if other.symbol != item.symbol and kind != "variable":
            continue
        start, end = other.start, other.end
        if kind == "variable":
            start, end = _part(document, other, len(name.split(".")))
        written = f"P{text}" if kind == "parameter" else text
        changes[document.uri].append(TextEdit(document.range(other.line, start, end), written))
    if kind == "variable" and not is_own(item.symbol):
        for area in _in_list(item.symbol, loaded):
            changes.setdefault(area.uri, []).append(TextEdit(area.range, text))
    return WorkspaceEdit(changes=changes)


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


def _in_list(symbol: Symbol, loaded: LoadedMachine) -> Iterator[Location]:
    """Yield where a list of the machine names a variable."""
    parts = symbol.name.split(".")
    if len(parts) < 3 or parts[1] not in ("E", "CH"):
        return
    for kind, path in loaded.machine.configuration.lists:
        if kind not in ("variables", "channel"):
            continue
        for number, line in enumerate(loaded.access.read_lines(path)):
            match = _LIST_NAME.match(line)
            if match is not None and match["name"] == parts[2]:
                start, end = match.span("name")
                area = Range(Position(number, start), Position(number, end))
                yield Location(uri_of(path), area)

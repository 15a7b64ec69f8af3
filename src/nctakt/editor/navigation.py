# SPDX-License-Identifier: MIT
"""From a name to its definition, its uses, and another name.

In: a document, a position, the machine. Out: places. A variable or an axis of the machine is
defined in its list, a called program in its file.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

from lsprotocol.types import Location, Position, Range, TextEdit, WorkspaceEdit

from nctakt.base.diagnostics import NOTHING, Text
from nctakt.base.failure import Failure
from nctakt.editor.document import Document, uri_of
from nctakt.editor.list_lines import list_occurrences_in, list_symbol_at
from nctakt.editor.names import (
    OWN_FAMILIES,
    Occurrence,
    Symbol,
    called_files,
    occurrences,
    occurrences_in,
    outside_comments,
    read_comments,
    same,
    section_of,
    symbol_at,
    variable_name,
)
from nctakt.editor.workspace import LoadedMachine
from nctakt.lists.machine.files import find_below
from nctakt.messages import diagnostic
from nctakt.messages.connections.editor import (
    NAME_IS_FIXED,
    NEW_NAME_INVALID,
    NEW_NAME_TAKEN,
    RENAMED_BY_NUMBER,
)
from nctakt.nc.meaning.words import HIGHEST_CYCLE_ID
from nctakt.nc.parse.block_head import number_label
from nctakt.nc.parse.lexer import without_comments
from nctakt.run.program_loader import find_program, search_folders

_LETTERS = Text(
    "a name has letters, digits and _, a letter or _ first",
    "ein Name hat Buchstaben, Ziffern und _, zuerst einen Buchstaben oder _",
)
#: Kind of a name -> its valid forms, and their description.
_FORMS = {
    "cycle": (
        re.compile(r"0*([1-9]\d{0,9})"),
        Text(
            f"the ID of a cycle is 1 … {HIGHEST_CYCLE_ID}",
            f"die ID eines Zyklus ist 1 … {HIGHEST_CYCLE_ID}",
        ),
    ),
    "label number": (
        re.compile(r"N?\d{1,10}", re.IGNORECASE),
        Text("this label is a block number: N20", "diese Sprungmarke ist eine Satznummer: N20"),
    ),
    "label": (re.compile(r"[^\W\d]\w*"), _LETTERS),
    "subprogram": (re.compile(r"[^\W\d]\w*"), _LETTERS),
    "parameter": (
        re.compile(r"P?(\d{1,9})", re.IGNORECASE),
        Text("a parameter is P and a number", "ein Parameter ist P und eine Nummer"),
    ),
    "variable": (re.compile(r"[A-Za-z_]\w*", re.ASCII), _LETTERS),
    "axis": (
        re.compile(r"[ABCQU-Z]\w*", re.IGNORECASE | re.ASCII),
        Text(
            "an axis begins with A, B, C, Q, U, V, W, X, Y or Z",
            "eine Achse beginnt mit A, B, C, Q, U, V, W, X, Y oder Z",
        ),
    ),
}
#: Kind of a name -> its use by a computed number.
_COMPUTED = {
    "cycle": re.compile(
        r"#\s*RT\s+CYCLE\b[^\[]*\[[^\]]*?\bID\s*=\s*(?!\s*\d)[^\s\]]+", re.IGNORECASE
    ),
    "parameter": re.compile(r"(?<![\w.@])P(?:\[\s*(?!\d+\s*\])[^\]]*\]?|P\d+)", re.IGNORECASE),
}
_FILE_NAME = Text("it is the name of a file", "es ist der Name einer Datei")
_CONTROLLER_NAME = Text("the controller gives it", "die Steuerung vergibt ihn")
_DEMO_NAME = Text("it belongs to the demo machine", "er gehört der Demo-Maschine")
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
    """Return whether the name belongs to the program or to the machine's lists."""
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
    """Return the edits that rename the symbol at a place; ``None`` if there is no name.

    A name of the machine changes in its lists and in all its programs, one of a program in all
    programs that it calls and that call it. Raises ``Failure`` for a name that must not become the
    new one.
    """
    item = found_at(document, position, loaded) or _variable_in_comment(document, position)
    if item is None:
        return None
    symbol = item.symbol
    _check_fixed(symbol, loaded)
    areas = list(_in_lists(symbol, loaded)) if is_of_machine(symbol) else []
    places = list(_places(document, item, loaded, programs))
    target = _new_symbol(symbol, new, places)
    if target == symbol:
        return WorkspaceEdit(changes={})
    _check_free(target, symbol, places, document, loaded)
    changes: dict[str, list[TextEdit]] = {}
    for area in areas:
        changes.setdefault(area.uri, []).append(TextEdit(area.range, _last(target)))
    for program, found in places:
        if found:
            changes[program.uri] = [_renaming(program, other, symbol, target) for other in found]
    return WorkspaceEdit(changes=changes)


def _places(
    document: Document, item: Occurrence, loaded: LoadedMachine, programs: Programs
) -> Iterator[tuple[Document, list[Occurrence]]]:
    """Yield the programs in which a name means the same, each with its places."""
    symbol = item.symbol
    if symbol.kind in ("label", "subprogram"):
        yield document, list(_all(document, item))
        return
    if is_of_machine(symbol) or symbol.name.startswith("V.S."):
        documents = list(programs())
    else:
        documents = linked_programs(document, programs(), loaded)
    is_read = symbol.kind == "variable" and is_of_machine(symbol)
    for program in documents:
        found = list(occurrences(program.lines, symbol))
        yield program, [*found, *(_in_comments(program, symbol) if is_read else ())]


def _in_comments(program: Document, symbol: Symbol) -> Iterator[Occurrence]:
    """Yield the places of a variable in comments that nctakt reads (``; expect: V.E.N = 1``)."""
    for number, text in read_comments(program.lines):
        for one in occurrences_in(text, number):
            if same(one.symbol, symbol):
                yield one


def _variable_in_comment(document: Document, position: Position) -> Occurrence | None:
    """Return the variable of the machine at a place in a comment that nctakt reads."""
    index = document.index(position)
    for number, text in read_comments([document.line(position.line)]):
        for one in occurrences_in(text, position.line + number):
            if one.symbol.kind == "variable" and one.start <= index <= one.end:
                return one if is_of_machine(one.symbol) else None
    return None


def linked_programs(
    document: Document, programs: Iterable[Document], loaded: LoadedMachine
) -> list[Document]:
    """Return a program, those that it calls, those that call it, and so on."""
    known: dict[object, Document] = {_identity(one): one for one in (*programs, document)}
    joined: dict[object, dict[object, None]] = {}
    waiting = list(known)
    while waiting:
        caller = waiting.pop()
        for name in called_files(known[caller].lines):
            path = called_file(known[caller], name, loaded)
            if path is None:
                continue
            called = path.resolve()
            if called not in known:
                known[called] = _from_disk(path, document, loaded)
                waiting.append(called)
            joined.setdefault(caller, {})[called] = None
            joined.setdefault(called, {})[caller] = None
    first = _identity(document)
    linked: dict[object, None] = {first: None}
    waiting = [first]
    while waiting:
        for other in joined.get(waiting.pop(), ()):
            if other not in linked:
                linked[other] = None
                waiting.append(other)
    return [known[identity] for identity in linked]


def _identity(document: Document) -> object:
    return document.uri if document.path is None else document.path.resolve()


def _from_disk(path: Path, like: Document, loaded: LoadedMachine) -> Document:
    """Return a called file that is not open, its positions as the editor counts them."""
    lines = list(loaded.access.read_lines(path))
    return Document(uri_of(path), path, path.as_posix(), "nctakt", 0, lines, like.encoding)


def _check_fixed(symbol: Symbol, loaded: LoadedMachine) -> None:
    """Raise ``Failure`` for a name that neither the program nor a list of the machine gives."""
    reason = None
    if not can_rename(symbol):
        reason = _FILE_NAME if symbol.kind == "file" else _CONTROLLER_NAME
    elif is_of_machine(symbol) and loaded.machine.configuration.is_demo:
        reason = _DEMO_NAME
    if reason is not None:
        raise Failure(diagnostic(NAME_IS_FIXED, name=symbol.name, reason=reason))


def _new_symbol(
    symbol: Symbol, new: str, places: Sequence[tuple[Document, Sequence[Occurrence]]]
) -> Symbol:
    """Return the symbol named by a text; raises ``Failure`` if it cannot be of this kind."""
    kind, name = symbol
    text = new.strip()
    pattern, form = _FORMS[kind]
    if kind == "label":
        numbers = any(_is_number(program, other) for program, found in places for other in found)
        if numbers:
            pattern, form = _FORMS["label number"]
        elif text.startswith("[") and text.endswith("]"):
            text = text[1:-1].strip()
    match = pattern.fullmatch(text)
    if match is None or (kind == "cycle" and int(match[1]) > HIGHEST_CYCLE_ID):
        raise Failure(diagnostic(NEW_NAME_INVALID, new=new or NOTHING, form=form))
    if kind == "label":
        number = text.upper().removeprefix("N")
        return Symbol(kind, number_label(number) if number.isdigit() else text.upper())
    if kind == "parameter":
        return Symbol(kind, f"P{int(match[1])}")
    if kind == "cycle":
        return Symbol(kind, str(int(match[1])))
    if kind == "axis":
        return Symbol(kind, text.upper())
    if kind == "variable":
        return Symbol(kind, ".".join((*name.split(".")[:-1], text)))
    return Symbol(kind, text)


def _is_number(document: Document, item: Occurrence) -> bool:
    """Return whether a label is written as a block number there: ``N20:``, ``$GOTO N20``."""
    return document.line(item.line)[item.start : item.end].isdigit()


def _check_free(
    target: Symbol,
    symbol: Symbol,
    places: Sequence[tuple[Document, Sequence[Occurrence]]],
    document: Document,
    loaded: LoadedMachine,
) -> None:
    """Raise ``Failure`` if the new name, or a computed one, would merge two names."""
    machine = loaded.machine
    taken: dict[str, None] = {}
    if symbol.kind == "axis":
        taken = dict.fromkeys((*_axes(loaded), *machine.parameters.spindle_names))
    elif is_of_machine(symbol):
        taken = {_member(name): None for name, _, _ in machine.names.values()}
    if _last(target) in taken or target.name in taken:
        where = Text("by the machine", "von der Maschine")
        raise Failure(diagnostic(NEW_NAME_TAKEN, new=_last(target), where=where))
    for program, found in places:
        within = None
        if symbol.kind == "label" and found:
            within = section_of(program.lines, found[0].line)
        other = next(occurrences(program.lines, target, within), None)
        if other is not None:
            where = _line_name(program, other.line, document)
            raise Failure(diagnostic(NEW_NAME_TAKEN, new=_last(target), where=where))
        if symbol.kind in _COMPUTED:
            _check_computed(symbol, program, document)


def _check_computed(symbol: Symbol, program: Document, document: Document) -> None:
    """Raise ``Failure`` if a program computes which parameter or cycle it means."""
    for number, line in outside_comments(program.lines):
        match = _COMPUTED[symbol.kind].search(without_comments(line))
        if match is not None:
            written, where = " ".join(match[0].split()), _line_name(program, number, document)
            raise Failure(
                diagnostic(RENAMED_BY_NUMBER, written=written, where=where, name=symbol.name)
            )


def _line_name(program: Document, line: int, document: Document) -> Text:
    """Return a line for a message; of another program with its file."""
    file = "" if program is document else f"{Path(program.name).name}, "
    return Text(f"{file}line {line + 1}", f"{file}Zeile {line + 1}")


def _member(name: str) -> str:
    """Return the variable of a list without indices and members."""
    return ".".join(variable_name(name).split(".")[:3])


def _last(symbol: Symbol) -> str:
    """Return the part of a name that a program writes for it."""
    return symbol.name.split(".")[-1] if symbol.kind == "variable" else symbol.name


def _renaming(document: Document, item: Occurrence, symbol: Symbol, target: Symbol) -> TextEdit:
    """Return the edit that renames one occurrence."""
    start, end = item.start, item.end
    text = _last(target)
    if symbol.kind == "variable":
        start, end = _part(document, item, len(symbol.name.split(".")))
    elif symbol.kind == "label" and _is_number(document, item):
        text = target.name.removeprefix("N")
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

# SPDX-License-Identifier: MIT
"""What can be written at the cursor: words, keywords, variables, IDs, labels, files, parameters.

In: a document, a position, its machine. Out: completion items whose text replaces what is already
written of the word.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from lsprotocol.types import CompletionItem, CompletionItemKind, Position, TextEdit

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.editor.document import Document
from nctakt.editor.list_lines import parameter_of, values_of
from nctakt.editor.names import Kind, occurrences_in, section_of
from nctakt.hli import table
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.parameter import ValueType
from nctakt.lists.format.schema import Schema
from nctakt.lists.machine.list_kinds import kind_of
from nctakt.nc.check.realtime_cycles import END_ACTIONS, SCOPES
from nctakt.nc.parse.controls import CONTROL_WORDS
from nctakt.nc.parse.hash_commands import CYCLE_ACTIONS
from nctakt.nc.vocabulary.axis_commands import KEYWORDS as AXIS_KEYWORDS
from nctakt.nc.vocabulary.commands import COMMANDS, CONTROLS, VARIABLES
from nctakt.nc.vocabulary.entries import Entry, Support
from nctakt.nc.vocabulary.functions import G_FUNCTIONS, M_FUNCTIONS
from nctakt.nc.vocabulary.keywords import KEYWORDS
from nctakt.nc.vocabulary.operators import CONSTANTS, FUNCTIONS
from nctakt.nc.vocabulary.system_names import ROWS
from nctakt.run.assembly import AssembledMachine
from nctakt.run.program_loader import search_folders

#: Lines of a program that are searched for its own names; a longer one is searched around the
#: cursor.
SEARCHED_LINES = 20_000

_PATH = re.compile(r"(?<![\w.])Vs?\.[\w.\[\]]*$", re.IGNORECASE)
#: The beginning of a path of the interface: in a comment, in a PLC in Python or Structured Text.
_INTERFACE = re.compile(r"(?<![\w.])(?:HLI_Global_Variables\.)?gp[A-Z][\w\[\]^.]*$", re.IGNORECASE)
_CONTROL = re.compile(r"\$\w*$")
_COMMAND = re.compile(r"#[A-Z_ ]*$", re.IGNORECASE)
_WORD = re.compile(r"[A-Z_@]\w*$", re.IGNORECASE)
_OPEN = re.compile(r"(?P<before>#\s*[A-Z_ ]+|(?<!\w)[A-Z]\w*)\s*\[[^\[\]]*$", re.IGNORECASE)
_VALUE = re.compile(r"(?P<key>\w+)\s*=\s*(?P<value>\w*)$")
_GOTO = re.compile(r"\$GOTO\s+\[?\w*$", re.IGNORECASE)
_LOCAL = re.compile(r"(?<!\w)LL\s+\w*$", re.IGNORECASE)
_FILE = re.compile(r"(?<!\w)L\s+(?P<name>[^\s\[;]*)$", re.IGNORECASE)
_LIST_VALUE = re.compile(
    r"\s*(?P<key>[\w.\[\]]+)[ \t]+(?:[\w]+[ \t]*[|,][ \t]*)*(?P<value>[^\s|,]*)$"
)
_CYCLE = re.compile(r"#\s*RT\s+CYCLE\b", re.IGNORECASE)


@dataclass(slots=True)
class _Cursor:
    """The cursor: its document, line, text before it in the line."""

    document: Document
    line: int
    before: str
    language: Language

    def item(
        self,
        label: str,
        kind: CompletionItemKind,
        written: int,
        detail: str = "",
        text: str | None = None,
    ) -> CompletionItem:
        """Return an item in place of the last ``written`` characters."""
        end = len(self.before)
        cursor = self.document.range(self.line, end - written, end)
        edit = TextEdit(cursor, label if text is None else text)
        return CompletionItem(
            label, kind=kind, detail=detail or None, text_edit=edit, filter_text=label
        )


def complete(
    document: Document, position: Position, machine: AssembledMachine, language: Language
) -> list[CompletionItem]:
    """Return what can be written at a position."""
    before = document.line(position.line)[: document.index(position)]
    cursor = _Cursor(document, position.line, before, language)
    interface = _INTERFACE.search(before)
    if interface is not None:
        return list(_elements(cursor, interface[0]))
    if document.is_list:
        return list(_parameters(cursor))
    if ";" in before and before.count('"', 0, before.index(";")) % 2 == 0:
        return list(_comment(cursor))
    path = _PATH.search(before)
    if path is not None:
        return list(_variables(cursor, path[0], machine))
    for pattern, offer in (
        (_GOTO, _labels),
        (_LOCAL, _subprograms),
        (_CONTROL, _controls),
    ):
        if pattern.search(before):
            return list(offer(cursor))
    file = _FILE.search(before)
    if file is not None:
        return list(_files(cursor, file["name"], machine))
    open_bracket = _OPEN.search(before)
    if open_bracket is not None:
        return list(_keywords(cursor, open_bracket["before"]))
    command = _COMMAND.search(before)
    if command is not None:
        return list(_commands(cursor, command[0]))
    return list(_words(cursor, machine))


def _elements(cursor: _Cursor, path: str) -> Iterator[CompletionItem]:
    """Yield elements of the interface to the PLC behind the beginning of a path."""
    written = len(path.rpartition(".")[2])
    for element in table.continuations(path):
        label = element.name if "." in element.path else element.path
        kind = CompletionItemKind.Field
        said = element.said
        detail = element.type.name
        if said is not None:
            detail += f": {said.meaning.get(cursor.language)}"
        text = f"{label}[{element.type.low}]" if element.type.base is not None else label
        yield cursor.item(label, kind, written, detail, text)


def _comment(cursor: _Cursor) -> Iterator[CompletionItem]:
    written = len(cursor.before) - cursor.before.rindex(";") - 1
    for text in (" nctakt: ignore ", " expect: ", " given: "):
        yield cursor.item(text.strip(), CompletionItemKind.Snippet, written, text=text)


def _controls(cursor: _Cursor) -> Iterator[CompletionItem]:
    match = _CONTROL.search(cursor.before)
    assert match is not None
    for word in CONTROL_WORDS:
        entry = CONTROLS.get(word)
        meaning = "" if entry is None else entry.meaning.get(cursor.language)
        yield cursor.item(word, CompletionItemKind.Keyword, len(match[0]), meaning)


def _commands(cursor: _Cursor, written: str) -> Iterator[CompletionItem]:
    kind = CompletionItemKind.Function
    yield from _entries(cursor, COMMANDS.values(), kind, len(written))
    cycle = COMMANDS["#RT CYCLE"].meaning.get(cursor.language)
    for word in ("DEF", "END", *CYCLE_ACTIONS):
        yield cursor.item(f"#RT CYCLE {word}", kind, len(written), cycle)
    for word in ("#ENDVAR", "#RT ENDWHILE"):
        yield cursor.item(word, kind, len(written))


def _entries(
    cursor: _Cursor, entries: Iterable[Entry], kind: CompletionItemKind, written: int
) -> Iterator[CompletionItem]:
    for entry in entries:
        if entry.support is not Support.REFUSED:
            yield cursor.item(entry.name, kind, written, entry.meaning.get(cursor.language))


def _keywords(cursor: _Cursor, before: str) -> Iterator[CompletionItem]:
    """Yield keywords of a bracket, or values behind ``=``."""
    is_cycle = _CYCLE.match(before) is not None
    value = _VALUE.search(cursor.before)
    kind = CompletionItemKind.Property
    if value is not None:
        written, key = len(value["value"]), value["key"].upper()
        values: Sequence[str] = {"SCOPE": SCOPES, "END_ACTION": END_ACTIONS}.get(key, ())
        if key == "ID" and is_cycle:
            values = _own(cursor, "cycle")
        for text in values:
            yield cursor.item(text, CompletionItemKind.EnumMember, written)
        return
    match = _WORD.search(cursor.before)
    written = 0 if match is None else len(match[0])
    if is_cycle:
        words: Iterable[str] = ("ID", "SCOPE", "END_ACTION")
    elif before.startswith("#"):
        words = (name for name in KEYWORDS if name not in AXIS_KEYWORDS)
    else:
        words = AXIS_KEYWORDS
    for name in words:
        meaning = KEYWORDS[name].meaning.get(cursor.language) if name in KEYWORDS else ""
        yield cursor.item(name, kind, written, meaning)
    if not before.startswith("#"):
        yield from _functions(cursor, written)


def _functions(cursor: _Cursor, written: int) -> Iterator[CompletionItem]:
    for name, function in FUNCTIONS.items():
        detail = function.meaning.get(cursor.language)
        yield cursor.item(name, CompletionItemKind.Function, written, detail, f"{name}[")
    for name in CONSTANTS:
        yield cursor.item(name, CompletionItemKind.Constant, written)


# --- names ---------------------------------------------------------------------------------------


def _searched(cursor: _Cursor) -> range:
    count = len(cursor.document.lines)
    first = max(0, min(cursor.line - SEARCHED_LINES // 2, count - SEARCHED_LINES))
    return range(first, min(count, first + SEARCHED_LINES))


def _own(
    cursor: _Cursor, kind: Kind, within: range | None = None, *, any_use: bool = False
) -> list[str]:
    """Return the names of a kind that the program defines, in order."""
    marks = {"cycle": "#", "label": "", "subprogram": "%", "parameter": "P", "variable": "V"}
    names: dict[str, None] = {}
    lines = cursor.document.lines
    for number in within or _searched(cursor):
        line = lines[number]
        if number == cursor.line or marks[kind] not in line.upper():
            continue
        for item in occurrences_in(line, number, declares="#" not in line):
            if item.symbol.kind == kind and (item.is_definition or any_use):
                names[item.symbol.name] = None
    return list(names)


def _labels(cursor: _Cursor) -> Iterator[CompletionItem]:
    match = re.search(r"\[?\w*$", cursor.before)
    assert match is not None
    section = section_of(cursor.document.lines, cursor.line)
    for name in _own(cursor, "label", section):
        text = name if name[0] == "N" and name[1:].isdigit() else f"[{name}]"
        yield cursor.item(text, CompletionItemKind.Reference, len(match[0]))


def _subprograms(cursor: _Cursor) -> Iterator[CompletionItem]:
    match = re.search(r"\w*$", cursor.before)
    assert match is not None
    for name in _own(cursor, "subprogram"):
        yield cursor.item(name, CompletionItemKind.Module, len(match[0]))


def _files(cursor: _Cursor, written: str, machine: AssembledMachine) -> Iterator[CompletionItem]:
    name = cursor.document.name
    folders = search_folders(name, machine.parameters, machine.configuration.folder)
    seen: dict[str, None] = {}
    for folder in folders:
        if folder.is_dir():
            for path in sorted(folder.iterdir()):
                if path.is_file() and path.suffix.lower() in (".nc", ".sub", ".cyc", ".cnc"):
                    seen[path.name] = None
    for file in seen:
        if file != Path(name).name:
            yield cursor.item(file, CompletionItemKind.File, len(written))


def _variables(
    cursor: _Cursor, written: str, machine: AssembledMachine
) -> Iterator[CompletionItem]:
    """Yield the paths of variables; a part that is not written yet ends an item."""
    begin = written[: written.index(".")]
    rest = written[len(begin) + 1 :]
    names: dict[str, str] = {}
    for entry in VARIABLES.values():
        if entry.name.startswith("V.") and entry.support is not Support.REFUSED:
            names[entry.name[2:]] = entry.meaning.get(cursor.language)
    table = machine.names
    for name, _, type_ in table.values():
        names[name[2:]] = type_
    for name, _ in table.realtime():
        names[name[2:]] = ""
    for row in ROWS:
        names[f"{row.family}.{row.path}"] = ""
    for name in _own(cursor, "variable", any_use=True):
        if name.split(".")[1] in ("P", "L", "S", "CYC"):
            names[name[2:]] = ""
    folded = rest.upper()
    for name, detail in names.items():
        if name.upper().startswith(folded):
            yield cursor.item(f"{begin}.{name}", CompletionItemKind.Variable, len(written), detail)


def _words(cursor: _Cursor, machine: AssembledMachine) -> Iterator[CompletionItem]:
    match = _WORD.search(cursor.before)
    written = 0 if match is None else len(match[0])
    function, variable = CompletionItemKind.Function, CompletionItemKind.Variable
    language = cursor.language
    for number, entry in G_FUNCTIONS.items():
        if entry.support is not Support.REFUSED:
            yield cursor.item(f"G{number:02}", function, written, entry.meaning.get(language))
    for number, m_entry in M_FUNCTIONS.items():
        if m_entry.support is not Support.REFUSED:
            yield cursor.item(f"M{number:02}", function, written, m_entry.meaning.get(language))
    parameters = machine.parameters
    for letter, functions in (("M", parameters.m_functions), ("H", parameters.h_functions)):
        for number, defined in functions.items():
            if number not in M_FUNCTIONS or letter == "H":
                yield cursor.item(f"{letter}{number}", function, written, defined.synchronisation)
    for axis in parameters.axes:
        yield cursor.item(axis.name, variable, written)
    for spindle in parameters.spindles:
        yield cursor.item(spindle.name, variable, written)
    for name in _own(cursor, "parameter"):
        yield cursor.item(name, variable, written)
    for word in ("ONCE", "EDGE", "ALWAYS"):
        meaning = KEYWORDS[word].meaning.get(language)
        yield cursor.item(word, CompletionItemKind.Keyword, written, meaning)
    yield from _functions(cursor, written)


def _parameters(cursor: _Cursor) -> Iterator[CompletionItem]:
    """Yield the parameters of the kind of list, with their IDs; behind a name its values."""
    text = cursor.document.text().encode("utf-8", "surrogatepass")
    schema = kind_of(Path(cursor.document.name).name, text)
    value = _LIST_VALUE.match(cursor.before)
    if value is not None and schema is not None:
        yield from _values(cursor, value["key"], value["value"], schema)
    if re.match(r"\s*[\w.\[\]]*$", cursor.before) is None:
        return
    written = len(cursor.before.lstrip())
    for known in SCHEMAS if schema is None else (schema,):
        for parameter in known.parameters:
            meaning = parameter.text.get(cursor.language)
            detail = f"{parameter.id}: {meaning}" if parameter.id else meaning
            yield cursor.item(parameter.path, CompletionItemKind.Field, written, detail)


def _values(cursor: _Cursor, key: str, written: str, schema: Schema) -> Iterator[CompletionItem]:
    """Yield the values of a parameter where they are few, its default, files beside the list."""
    parameter = parameter_of(key, schema)
    if parameter is None:
        return
    kind = CompletionItemKind.EnumMember
    for value, detail in values_of(parameter).items():
        yield cursor.item(value, kind, len(written), detail)
    if schema.kind == "startup" and parameter.type is ValueType.STRING and cursor.document.path:
        for path in sorted(cursor.document.path.parent.glob("*")):
            if path.suffix.lower() in (".lis", ".xml") and path != cursor.document.path:
                yield cursor.item(path.name, CompletionItemKind.File, len(written))

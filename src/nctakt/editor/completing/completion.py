# SPDX-License-Identifier: MIT
"""Completion at the cursor: words, keywords, variables, IDs, labels, files, parameters.

In: a document, a position, its machine. Out: completion items whose text replaces the written part
of the word, ordered by how well they suit the context. In programs this module determines the
context; ``word_completion.py`` and ``value_completion.py`` have the answers.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from lsprotocol.types import CompletionItem, CompletionItemKind, Position

from nctakt.base.diagnostics import Language
from nctakt.editor.completing.completion_items import Cursor
from nctakt.editor.completing.program_names import names_of, programs_to_call
from nctakt.editor.completing.surroundings import Surroundings, surroundings
from nctakt.editor.completing.value_completion import values, variables, written_path
from nctakt.editor.completing.word_completion import (
    commands,
    controls,
    is_command,
    is_control,
    keywords,
    words,
)
from nctakt.editor.document import Document
from nctakt.editor.list_lines import parameter_of, values_of
from nctakt.editor.names import section_of
from nctakt.hli import table
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.parameter import ValueType
from nctakt.lists.format.schema import Schema
from nctakt.lists.machine.list_kinds import kind_of
from nctakt.run.realtime.assembly import AssembledMachine

#: The beginning of a path of the interface: in a comment, in a PLC in Python or Structured Text.
_INTERFACE = re.compile(r"(?<![\w.])(?:HLI_Global_Variables\.)?gp[A-Z][\w\[\]^.]*$", re.IGNORECASE)
_GOTO = re.compile(r"\$GOTO\s+\[?\w*$", re.IGNORECASE)
_LOCAL = re.compile(r"(?<!\w)LL\s+\w*$", re.IGNORECASE)
_FILE = re.compile(r"(?<!\w)L\s+(?P<name>[^\s\[;]*)$", re.IGNORECASE)
_LIST_VALUE = re.compile(
    r"\s*(?P<key>[\w.\[\]]+)[ \t]+(?:[\w]+[ \t]*[|,][ \t]*)*(?P<value>[^\s|,]*)$"
)
_NOTHING = Surroundings("nothing", None, in_cycle=False, innermost="", opening="", has_else=False)


def complete(
    document: Document,
    position: Position,
    machine: AssembledMachine,
    language: Language,
    *,
    has_snippets: bool = False,
) -> list[CompletionItem]:
    """Return the completions at a position, the best first.

    ``has_snippets``: the editor can fill in the gaps of texts.
    """
    before = document.line(position.line)[: document.index(position)]
    around = _NOTHING
    if not document.is_list:
        around = surroundings(document.lines, position.line, before)
    cursor = Cursor(document, machine, position.line, before, around, language, has_snippets)
    items: dict[str, CompletionItem] = {}
    for item in _offers(cursor):
        items.setdefault(item.label, item)
    for number, item in enumerate(items.values()):
        item.sort_text = f"{number:05}"
    return list(items.values())


def _offers(cursor: Cursor) -> Iterator[CompletionItem]:
    """Yield the completions, the best first."""
    interface = _INTERFACE.search(cursor.before)
    if interface is not None:
        return _elements(cursor, interface[0])
    if cursor.document.is_list:
        return _parameters(cursor)
    match cursor.around.part:
        case "nothing":
            return iter(())
        case "comment":
            return _comment(cursor)
    return _of_program(cursor)


def _of_program(cursor: Cursor) -> Iterator[CompletionItem]:
    """Yield the completions in a program, outside texts and comments."""
    before, around = cursor.before, cursor.around
    path = written_path(before)
    if path is not None:
        return variables(cursor, path)
    if not around.in_cycle:
        if _GOTO.search(before):
            return _labels(cursor)
        if _LOCAL.search(before):
            return _subprograms(cursor)
        file = _FILE.search(before)
        if file is not None:
            return _files(cursor, file["name"])
    if is_control(before):
        return controls(cursor)
    bracket = around.bracket
    if bracket is not None and not around.is_value and _takes_keywords(cursor, bracket):
        return keywords(cursor, bracket)
    if bracket is not None or around.is_value:
        return values(cursor)
    if is_command(before):
        return commands(cursor)
    return words(cursor)


def _takes_keywords(cursor: Cursor, name: str) -> bool:
    """Return whether the brackets after a name hold keywords: of a command, an axis, a spindle."""
    parameters = cursor.machine.parameters
    own = [axis.name for axis in parameters.axes] + [item.name for item in parameters.spindles]
    return name.startswith("#") or name.upper() in own


def _elements(cursor: Cursor, path: str) -> Iterator[CompletionItem]:
    """Yield elements of the interface to the PLC after the beginning of a path."""
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


def _comment(cursor: Cursor) -> Iterator[CompletionItem]:
    written = len(cursor.before) - cursor.before.rindex(";") - 1
    for text in (" nctakt: ignore ", " expect: ", " given: "):
        yield cursor.item(text.strip(), CompletionItemKind.Snippet, written, text=text)


# --- names ---------------------------------------------------------------------------------------


def _labels(cursor: Cursor) -> Iterator[CompletionItem]:
    match = re.search(r"\[?\w*$", cursor.before)
    assert match is not None
    section = section_of(cursor.document.lines, cursor.line)
    for name in names_of(cursor.document, cursor.line, "label", section):
        text = name if name[0] == "N" and name[1:].isdigit() else f"[{name}]"
        yield cursor.item(text, CompletionItemKind.Reference, len(match[0]))


def _subprograms(cursor: Cursor) -> Iterator[CompletionItem]:
    match = re.search(r"\w*$", cursor.before)
    assert match is not None
    for name in names_of(cursor.document, cursor.line, "subprogram"):
        yield cursor.item(name, CompletionItemKind.Module, len(match[0]))


def _files(cursor: Cursor, written: str) -> Iterator[CompletionItem]:
    for file in programs_to_call(cursor.document, cursor.machine):
        yield cursor.item(file, CompletionItemKind.File, len(written))


# --- lists ---------------------------------------------------------------------------------------


def _parameters(cursor: Cursor) -> Iterator[CompletionItem]:
    """Yield the parameters of the kind of list, with their IDs; after a name its values."""
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


def _values(cursor: Cursor, key: str, written: str, schema: Schema) -> Iterator[CompletionItem]:
    """Yield the values of a parameter if they are few, its default, files next to the list."""
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

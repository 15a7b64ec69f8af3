# SPDX-License-Identifier: MIT
"""Findings -> the edits that remedy them, where that takes no thought.

In: a document and its findings. Out: code actions: the right word for a slip or misspelt name,
``Vs.`` for a value of each tick, the end of an open structure, a variable added to the machine's
list, a comment that suppresses the finding. Others: ``cycle_remedies.py``, ``program_remedies.py``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from lsprotocol.types import (
    CodeAction,
    CodeActionKind,
    Position,
    Range,
    TextEdit,
    WorkspaceEdit,
)
from lsprotocol.types import Diagnostic as Shown

from nctakt.base.diagnostics import NOTHING, Diagnostic, Language, Severity, Text
from nctakt.editor.document import Document, uri_of
from nctakt.editor.edits.cycle_remedies import cycle_remedies
from nctakt.editor.edits.program_remedies import program_remedies
from nctakt.editor.list_lines import LIST_ENDS, VALUE_COLUMN
from nctakt.editor.structures import ENDS, every, structure_word, structures
from nctakt.editor.workspace import LoadedMachine
from nctakt.messages.programs.lints import ASYNCHRONOUS_CONDITION
from nctakt.messages.programs.nc_text import (
    BRACKET_NOT_CLOSED,
    CYCLE_BEGIN_END_MISMATCH,
    STRUCTURE_NOT_CLOSED,
    TEXT_NOT_CLOSED,
)
from nctakt.messages.programs.slips import (
    BODY_BEHIND_CONDITION,
    BODY_BEHIND_THEN,
    CURLY_BRACKETS,
    SURPLUS_WORD,
    UNIT_BEHIND_VALUE,
)
from nctakt.nc.parse.lexer import without_comments

_REPLACE = Text("Write {new}", "{new} schreiben")
_REMOVE = Text("Remove {old}", "{old} entfernen")
_INSERT = Text("Insert {new}", "{new} einfügen")
_SUPPRESS = Text("Ignore {number} here", "{number} hier übergehen")
_REASON = Text("reason", "Grund")
_DECLARE = Text("Add {name} to {file}", "{name} in {file} eintragen")
_EXTERNAL = re.compile(r"Vs?\.(?P<space>E|CH)\.(?P<name>[A-Za-z_]\w*)$", re.IGNORECASE)
_COUNT = re.compile(r"^\s*number_(?:used_)?variables\s+(?P<count>\d+)", re.IGNORECASE)
#: Space of a variable -> how its entries begin in the list.
_ENTRIES = {"E": "var", "CH": "vch"}
_PROGRAM_WORDS = re.compile(
    r"^\s*(?:N\d+\s*)?(?:G0?[0-3]\b|[XYZ][-+]?[\d.=]|M(?:30|0?2|17|29)\b)", re.I
)


def actions(
    document: Document,
    found: Sequence[tuple[Diagnostic, Shown]],
    loaded: LoadedMachine,
    language: Language,
) -> list[CodeAction]:
    """Return the code actions of some findings, the preferred ones first."""
    result: list[CodeAction] = []
    for item, shown in found:
        for number, (title, edit, uri) in enumerate(_remedies(document, item, loaded, language)):
            result.append(
                CodeAction(
                    title,
                    kind=CodeActionKind.QuickFix,
                    diagnostics=[shown],
                    is_preferred=number == 0,
                    edit=WorkspaceEdit(changes={uri: edit}),
                )
            )
    for item, shown in found:
        if item.severity is not Severity.ERROR and _can_suppress(document, item):
            title = _SUPPRESS.get(language).format(number=item.id)
            edit = [_suppression(document, item, language)]
            result.append(
                CodeAction(
                    title,
                    kind=CodeActionKind.QuickFix,
                    diagnostics=[shown],
                    edit=WorkspaceEdit(changes={document.uri: edit}),
                )
            )
    return result


def _remedies(
    document: Document, item: Diagnostic, loaded: LoadedMachine, language: Language
) -> Iterator[tuple[str, list[TextEdit], str]]:
    """Yield title, edits and document of each remedy of a finding."""
    span = item.span
    if span is None or not span.line or span.line > len(document.lines):
        return
    area, line = document.range_of(span), document.line(span.line - 1)
    written = line[span.column - 1 : span.end_column - 1]
    uri = document.uri
    new = _right_word(item)
    if item.message in (SURPLUS_WORD, UNIT_BEHIND_VALUE):
        title = _REMOVE.get(language).format(old=written)
        yield title, [TextEdit(area, "")], uri
    elif item.message is CURLY_BRACKETS:
        title = _REMOVE.get(language).format(old="{ }" if len(written) > 1 else written)
        yield title, [TextEdit(area, written.strip("{} "))], uri
    elif item.message is BODY_BEHIND_THEN:
        indent = line[: len(line) - len(line.lstrip())]
        lines = [f"{indent}  {new}", *([f"{indent}$ENDIF"] if "$ENDIF" in written.upper() else [])]
        yield _replacement(language, "↵"), [TextEdit(area, "\n" + "\n".join(lines))], uri
    elif item.message is BODY_BEHIND_CONDITION:
        yield _replacement(language, "↵"), [_split_line(document, span.line - 1, line)], uri
    elif new:
        yield _replacement(language, new), [TextEdit(area, new)], uri
    if item.message is ASYNCHRONOUS_CONDITION and written.upper().startswith("V."):
        text = f"Vs.{written[2:]}"
        yield _replacement(language, text), [TextEdit(area, text)], uri
    if item.message in (BRACKET_NOT_CLOSED, TEXT_NOT_CLOSED):
        mark = "]" if item.message is BRACKET_NOT_CLOSED else '"'
        end = len(without_comments(line).rstrip())
        at = document.range(span.line - 1, end, end)
        yield _INSERT.get(language).format(new=mark), [TextEdit(at, mark)], uri
    if item.message in (STRUCTURE_NOT_CLOSED, CYCLE_BEGIN_END_MISMATCH):
        edit = _missing_end(document, span.line - 1)
        if edit is not None:
            title = _INSERT.get(language).format(new=edit.new_text.strip())
            yield title, [edit], uri
    for title, edits in cycle_remedies(document, item, loaded.machine.names, language):
        yield title, edits, uri
    yield from program_remedies(document, item, loaded, language)
    yield from _declaration(written, loaded, language)


def _replacement(language: Language, new: str) -> str:
    return _REPLACE.get(language).format(new=new)


def _right_word(item: Diagnostic) -> str:
    """Return the text that belongs in place of the span, empty if it is not known."""
    for name in ("replacement", "nearest", "suggestion"):
        value = item.values.get(name)
        if isinstance(value, str) and value and value != NOTHING:
            if name == "nearest" and value[:1].isalpha() and len(value) == 1:
                return ""
            return value
    return ""


def _split_line(document: Document, number: int, line: str) -> TextEdit:
    """Return the edit that puts a condition's body, and its end, on separate lines."""
    indent = line[: len(line) - len(line.lstrip())]
    code = without_comments(line).rstrip()
    end = re.search(r"\s*\$ENDIF\s*$", code, re.IGNORECASE)
    body_end = len(code) if end is None else end.start()
    match = re.search(r"\s(?=(?:[MHGTXYZ]\d|P\d+\s*[-+*/]?=(?!=)|V\S+\s*[-+*/]?=(?!=)))", code)
    begin = body_end if match is None else match.start()
    parts = [code[:begin], f"{indent}  {code[begin:body_end].strip()}"]
    if end is not None:
        parts.append(f"{indent}$ENDIF")
    return TextEdit(document.range(number, 0, len(code)), "\n".join(parts))


def _missing_end(document: Document, opening: int) -> TextEdit | None:
    """Return the edit that closes the structure that begins in a line.

    It ends before the next line that is indented no deeper and does not divide it.
    """
    lines = document.lines
    items = [item for item in every(structures(lines)) if item.first == opening]
    if not items or structure_word(lines[opening]) not in ENDS:
        return None
    indent = _indent(lines[opening])
    last = opening
    for number in range(opening + 1, len(lines)):
        line = lines[number]
        if not line.strip():
            continue
        if line.lstrip().startswith("%") or _begins_program(lines[opening], line):
            break
        if _indent(line) <= indent and number not in items[0].dividers:
            if last > opening:
                break
            if structure_word(line) in ENDS.values():
                break
        last = number
    new = f"{lines[opening][:indent]}{ENDS[items[0].begin]}\n"
    if last + 1 >= len(lines):
        text = lines[-1]
        end = Position(len(lines) - 1, document.character_of(text, len(text)))
        return TextEdit(Range(end, end), f"\n{new.rstrip()}")
    at = Position(last + 1, 0)
    return TextEdit(Range(at, at), new)


def _begins_program(opening: str, line: str) -> bool:
    is_cycle = structure_word(opening) == "#RT CYCLE"
    return is_cycle and (
        _PROGRAM_WORDS.match(line) is not None or structure_word(line) == "#RT CYCLE"
    )


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip())


def _can_suppress(document: Document, item: Diagnostic) -> bool:
    """Return whether a comment in its line can suppress a finding: not in XML."""
    return bool(item.span and item.span.line) and not document.name.casefold().endswith(".xml")


def _suppression(document: Document, item: Diagnostic, language: Language) -> TextEdit:
    """Return the edit that writes the comment after the block of a finding."""
    assert item.span is not None
    number = item.span.line - 1
    line = document.line(number)
    mark = "#" if document.is_list else ";"
    code = line.partition("#")[0] if document.is_list else without_comments(line)
    end = len(code.rstrip())
    at = document.range(number, end, end)
    return TextEdit(at, f" {mark} nctakt: ignore {item.id} {_REASON.get(language)}")


def _declaration(
    written: str, loaded: LoadedMachine, language: Language
) -> Iterator[tuple[str, list[TextEdit], str]]:
    """Yield the edit that adds an unknown variable to the variables list of the machine."""
    match = _EXTERNAL.match(written)
    if match is None:
        return
    name, entries = f"V.{match['space'].upper()}.{match['name']}", _ENTRIES[match["space"].upper()]
    names = {known for known, _, _ in loaded.machine.names.values()}
    configuration = loaded.machine.configuration
    path = next((path for kind, path in configuration.lists if kind == "variables"), None)
    if name in names or path is None or configuration.is_demo or path.suffix.lower() == ".xml":
        return
    lines = loaded.access.read_lines(path)
    index, last = _behind(lines, entries)
    rows = [("name", match["name"]), ("type", "SGN32")]
    if entries == "var":
        rows.append(("scope", "GLOBAL"))
    rows += [("synchronisation", "TRUE"), ("access_rights", "READ_WRITE")]
    width = VALUE_COLUMN - 1
    text = [f"{f'{entries}[{index}].{key}':<{width}} {value}" for key, value in rows]
    edits = list(_counted(lines, index + 1)) if entries == "var" else []
    if last < 0:
        start = Position(0, 0)
        edits.append(TextEdit(Range(start, start), "\n".join((*text, ""))))
    else:
        end = Position(last, len(lines[last].encode("utf-16-le")) // 2)
        edits.append(TextEdit(Range(end, end), "\n".join(("", *text))))
    yield _DECLARE.get(language).format(name=name, file=path.name), edits, uri_of(path)


def _behind(lines: Sequence[str], entries: str) -> tuple[int, int]:
    """Return the next free index of a list's variables, and the line after which they belong.

    That is the last entry of its kind, else the last before the end of the list; -1 in an empty
    list.
    """
    pattern = re.compile(rf"^\s*{entries}\[(?P<index>\d+)\]")
    found = [(number, pattern.match(line)) for number, line in enumerate(lines)]
    own = [(number, int(match["index"])) for number, match in found if match is not None]
    if own:
        return max(index for _, index in own) + 1, own[-1][0]
    end = next((n for n, line in enumerate(lines) if line.strip() in LIST_ENDS), len(lines))
    return 0, max((n for n, line in enumerate(lines[:end]) if line.strip()), default=-1)


def _counted(lines: Sequence[str], count: int) -> Iterator[TextEdit]:
    """Yield the edits of the numbers of variables that are too small."""
    for number, line in enumerate(lines):
        match = _COUNT.match(line)
        if match is not None and int(match["count"]) < count:
            start, end = match.span("count")
            yield TextEdit(Range(Position(number, start), Position(number, end)), str(count))

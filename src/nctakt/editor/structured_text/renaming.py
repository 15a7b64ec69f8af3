# SPDX-License-Identifier: MIT
"""Renaming of a PLC's declarations, in all files of the project.

In: the names of a project, a position, the new name. Out: edits, which leave a project that means
the same; or a ``Failure`` with the reason. In XML files the attributes change in which the
programming system repeats the name. Programs name variables of a PLC by their paths in comments
that nctakt reads (``; expect: MAIN.bOpen``): these change, too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from lsprotocol.types import Position, Range, TextEdit, WorkspaceEdit

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Text
from nctakt.base.failure import Failure
from nctakt.editor.document import Document
from nctakt.editor.names import READ_COMMENT
from nctakt.editor.structured_text.navigation import document_of
from nctakt.editor.structured_text.occurrences import Occurrence, key_of
from nctakt.editor.structured_text.plc_project import PlcFile
from nctakt.editor.structured_text.positions import range_of
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.messages import diagnostic
from nctakt.messages.connections.editor import NAME_IS_FIXED, NEW_NAME_INVALID, NEW_NAME_TAKEN
from nctakt.st.check.project import DEFAULT_PROGRAM
from nctakt.st.files.suffixes import OBJECT_SUFFIXES
from nctakt.st.parse.lexer import KEYWORDS
from nctakt.st.tree import GlobalList, Library, TaskNode
from nctakt.st.types import EnumValue, InterfaceType, Kind, Method, Pou, StructType, Type, Variable
from nctakt.st.vocabulary.elementary import ELEMENTARY

_NAME = re.compile(r"[^\W\d]\w*")
_LETTERS = Text(
    "a name has letters, digits and _, a letter or _ first",
    "ein Name hat Buchstaben, Ziffern und _, zuerst einen Buchstaben oder _",
)
_WORD_OF_LANGUAGE = Text("it is a word of the language", "es ist ein Wort der Sprache")
_IN_LIBRARY = Text("it belongs to a library", "er gehört einer Bibliothek")
_OF_SYSTEM = Text("the system calls it by this name", "das System ruft es mit diesem Namen auf")
_LIST_IS_FILE = Text("it is the name of a file", "es ist der Name einer Datei")
#: Methods that the system calls (ST-403, ST-606).
_SYSTEM_METHODS = frozenset(("fb_init", "fb_reinit", "fb_exit"))
_PART = re.compile(r"[^\W\d]\w*")
_PATH = re.compile(r"[^\W\d]\w*(?:\[[^\]]*\])?(?:\.[^\W\d]\w*(?:\[[^\]]*\])?)+")

#: The programs of the same folders.
Programs = Callable[[], Iterable[Document]]


def rename(
    names: ProjectNames, document: Document, position: Position, new: str, programs: Programs
) -> WorkspaceEdit | None:
    """Return the edits that rename the name at a place; ``None`` if there is none.

    Raises ``Failure`` for a name that must not change, or must not become the new one.
    """
    found = names.at(document, position)
    return None if found is None else _renamed(names, document, found, new, programs)


@dataclass(frozen=True, slots=True)
class PathPart:
    """A part of a path that a comment of a program names: the path up to it, and where it is."""

    path: str
    range: Range


def part_at(program: Document, position: Position) -> PathPart | None:
    """Return the part of a PLC's path at a place in a comment of a program, if one is there."""
    line, index = program.line(position.line), program.index(position)
    comment = READ_COMMENT.search(line)
    for match in () if comment is None else _PATH.finditer(line, comment.start()):
        for part in _PART.finditer(match[0]):
            first, last = match.start() + part.start(), match.start() + part.end()
            if first <= index <= last:
                shown = program.range(position.line, first, last)
                return PathPart(match[0][: part.end()], shown)
    return None


def rename_part(
    names: ProjectNames, document: Document, part: PathPart, new: str, programs: Programs
) -> WorkspaceEdit | None:
    """Return the edits that rename the target of a path; ``None`` if the project has none.

    Raises ``Failure`` as ``rename``.
    """
    node = names.expression(part.path, names.scope_of(""))
    target = getattr(node, "target", None)
    if target is None:
        return None
    name = part.path.rpartition(".")[2]
    found = next((one for _, one in names.all_of(target, name)), None)
    return None if found is None else _renamed(names, document, found, new, programs)


def _renamed(
    names: ProjectNames, document: Document, found: Occurrence, new: str, programs: Programs
) -> WorkspaceEdit:
    """Return the edits that rename a variable or type, given one of its places."""
    new = new.strip()
    places = list(names.all_of(found.target, found.name))
    check_fixed(names, found, places)
    _check_form(new)
    if new.lower() != found.name.lower():
        _check_free(names, found, new, places)
    changes: dict[str, list[TextEdit]] = {}
    sources = names.project.sources
    for file, one in places:
        like = document_of(names, document, file)
        edit = TextEdit(range_of(like, sources, one.start, one.end), new)
        changes.setdefault(like.uri, []).append(edit)
    for file in {file.name: file for file, one in places if one.is_definition}.values():
        like = document_of(names, document, file)
        changes[like.uri] += _attributes(like, found, new)
    for like, edit in _calls_of_tasks(names, document, found, new):
        changes.setdefault(like.uri, []).append(edit)
    for program in programs():
        edits = list(_in_comments(names, program, found, new))
        if edits:
            changes.setdefault(program.uri, []).extend(edits)
    return WorkspaceEdit(changes=changes)


def check_fixed(
    names: ProjectNames, found: Occurrence, places: Iterable[tuple[PlcFile, Occurrence]]
) -> None:
    """Raise ``Failure`` for a name that is not the user's to change."""
    target, reason = found.target, None
    if isinstance(target, GlobalList):
        reason = _LIST_IS_FILE
    elif isinstance(target, Library) or not any(one.is_definition for _, one in places):
        reason = _IN_LIBRARY
    elif isinstance(target, Method) and target.name.lower() in _SYSTEM_METHODS:
        reason = _OF_SYSTEM
    elif isinstance(target, Pou) and target.kind is Kind.PROGRAM:
        has_tasks = any(isinstance(node, TaskNode) for node in names.project.declarations)
        if target.name.upper() == DEFAULT_PROGRAM and not has_tasks:
            reason = _OF_SYSTEM
    if reason is not None:
        raise Failure(diagnostic(NAME_IS_FIXED, name=found.name, reason=reason))


def _check_form(new: str) -> None:
    """Raise ``Failure`` for a text that cannot be a name."""
    form = None
    if not _NAME.fullmatch(new) or "__" in new:
        form = _LETTERS
    elif new.upper() in KEYWORDS or new.upper() in ELEMENTARY:
        form = _WORD_OF_LANGUAGE
    if form is not None:
        raise Failure(diagnostic(NEW_NAME_INVALID, new=new or NOTHING, form=form))


def _check_free(
    names: ProjectNames,
    found: Occurrence,
    new: str,
    places: list[tuple[PlcFile, Occurrence]],
) -> None:
    """Raise ``Failure`` if the new name already has a meaning, or would hide one."""
    key = new.lower()
    if key in _siblings(names, found.target):
        where = Text("in the same object", "im selben Objekt")
        raise Failure(diagnostic(NEW_NAME_TAKEN, new=new, where=where))
    is_member = isinstance(found.target, Variable) and isinstance(
        _owner_of(names, found.target), StructType
    )
    if is_member:
        return
    is_global = _is_global(names, found.target)
    units = {one.unit.lower() for _, one in places if not one.is_member}
    owner = _owner_of(names, found.target)
    for unit in _units_of(names, owner):
        units.add(unit)
    for file in names.project.files.values():
        if key not in file.facts.words:
            continue
        for one in names.of(file):
            if one.name.lower() != key or one.is_member:
                continue
            if is_global or one.unit.lower() in units:
                line = names.project.sources.line_number(one.start)
                name = Path(file.name).name
                where = Text(f"{name}, line {line}", f"{name}, Zeile {line}")
                raise Failure(diagnostic(NEW_NAME_TAKEN, new=new, where=where))


def _siblings(names: ProjectNames, target: object) -> set[str]:
    """Return the names declared in the same place as a target, in lower case."""
    owner = _owner_of(names, target)
    if isinstance(owner, StructType):
        return set(owner.members)
    if isinstance(owner, Pou | InterfaceType):
        found = {*owner.methods, *owner.properties}
        if isinstance(owner, Pou):
            found |= {*owner.members, *owner.variables, owner.name.lower()}
        return found
    if isinstance(owner, GlobalList):
        return set(owner.variables)
    if isinstance(target, EnumValue):
        return set(target.type.values)
    project = names.checker.names.project
    return {*project.declared, *(name for name in project.lists if name)}


def _owner_of(names: ProjectNames, target: object) -> object:
    """Return the structure, POU, interface or list in which a target is declared."""
    if isinstance(target, Method) or type(target).__name__ == "Property":
        owner = getattr(target, "owner", None)
        if owner is not None:
            return owner
        for one in names.owners():
            if isinstance(one, InterfaceType):
                members = (*one.methods.values(), *one.properties.values())
                if any(member is target for member in members):
                    return one
    if not isinstance(target, Variable):
        return None
    key = key_of(target)
    for declared in names.checker.names.project.declared.values():
        kind = declared.target
        if isinstance(kind, StructType) and _has(kind.members.values(), key):
            return kind
        if isinstance(kind, Pou):
            units = [kind, *kind.methods.values()]
            if any(_has(unit.variables.values(), key) for unit in units):
                return kind
    for _, group in names.lists():
        if _has(group.variables.values(), key):
            return group
    return None


def _has(variables: Iterable[Variable], key: object) -> bool:
    return any(key_of(one) == key for one in variables)


def _units_of(names: ProjectNames, owner: object) -> Iterator[str]:
    """Yield the paths of the units that see the members of a block, including derived ones."""
    if not isinstance(owner, Pou):
        return
    for unit in names.checker.resolver.nodes:
        pou = unit if isinstance(unit, Pou) else getattr(unit, "owner", None)
        if isinstance(pou, Pou) and any(one is owner for one in pou.bases()):
            yield unit.path.lower()


def _is_global(names: ProjectNames, target: object) -> bool:
    if isinstance(target, Pou | Type):
        return True
    if isinstance(target, EnumValue):
        return not target.type.is_qualified_only
    return isinstance(_owner_of(names, target), GlobalList)


# --- other places of a name ----------------------------------------------------------------------


def _attributes(document: Document, found: Occurrence, new: str) -> Iterator[TextEdit]:
    """Yield the edits of attributes of an XML file that repeat the name of an object or member."""
    if Path(document.name).suffix.lower() not in OBJECT_SUFFIXES:
        return
    if isinstance(found.target, Variable | EnumValue):
        return
    is_member = not isinstance(found.target, Pou | Type)
    elements = "Method|Property|Action" if is_member else "POU|DUT|Itf"
    name = re.escape(found.name)
    owner = r"(?:\w+\.)" if is_member else ""
    patterns = (
        re.compile(rf'<(?:{elements})\b[^>]*?\bName="(?P<name>{name})"', re.IGNORECASE),
        re.compile(rf'<LineIds\b[^>]*?\bName="{owner}(?P<name>{name})(?=["./])', re.IGNORECASE),
    )
    for number, line in enumerate(document.lines):
        if f'"{found.name.lower()}' not in line.lower() and "<lineids" not in line.lower():
            continue
        for pattern in patterns:
            for match in pattern.finditer(line):
                yield TextEdit(document.range(number, *match.span("name")), new)


def _calls_of_tasks(
    names: ProjectNames, document: Document, found: Occurrence, new: str
) -> Iterator[tuple[Document, TextEdit]]:
    """Yield the edits where tasks call a program."""
    if not (isinstance(found.target, Pou) and found.target.kind is Kind.PROGRAM):
        return
    name = re.escape(found.name)
    in_xml = re.compile(rf"<Name>(?P<name>{name})</Name>", re.IGNORECASE)
    in_text = re.compile(
        rf"\bPROGRAM\s+(?:\w+\s+WITH\s+\w+\s*:\s*)(?P<name>{name})\b", re.IGNORECASE
    )
    for file in names.project.files.values():
        if not any(isinstance(node, TaskNode) for node in file.nodes):
            continue
        like = document_of(names, document, file)
        for number, line in enumerate(like.lines):
            for match in (*in_xml.finditer(line), *in_text.finditer(line)):
                yield like, TextEdit(like.range(number, *match.span("name")), new)


def _in_comments(
    names: ProjectNames, program: Document, found: Occurrence, new: str
) -> Iterator[TextEdit]:
    """Yield the edits of paths in comments of an NC program."""
    lower, keys = found.name.lower(), {key_of(one) for one in names.family(found.target)}
    for number, line in enumerate(program.lines):
        comment = READ_COMMENT.search(line) if lower in line.lower() else None
        if comment is None:
            continue
        for match in _PATH.finditer(line, comment.start()):
            for start, end in _parts(names, match[0], lower, keys):
                first, last = match.start() + start, match.start() + end
                yield TextEdit(program.range(number, first, last), new)


def _parts(
    names: ProjectNames, path: str, name: str, keys: set[object]
) -> Iterator[tuple[int, int]]:
    """Yield the parts of a path that are a name with its meaning."""
    for part in _PART.finditer(path):
        if part[0].lower() != name:
            continue
        node = names.expression(path[: part.end()], names.scope_of(""))
        target = getattr(node, "target", None)
        if target is not None and key_of(target) in keys:
            yield part.span()

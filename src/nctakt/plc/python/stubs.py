# SPDX-License-Identifier: MIT
"""Declarations of the classes that replace blocks, read without running them.

In: the settings of a project. Out: ``ProjectLibraries``, the libraries of its PLC: those whose
sources are in its folders, with a function block for each class of ``[plc.stubs]``. A class has the
variables of its block as a text, ``declaration``, which is a literal: it is taken from Python's
syntax tree and read as Structured Text at its place in the file.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Iterator, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import NOTHING, Message, Span, Text
from nctakt.base.misspelling import nearest
from nctakt.base.text import decode_text, split_lines
from nctakt.messages.plcs.stubs import (
    STUB_CLASS_MISSING,
    STUB_NAME_TAKEN,
    STUB_NOT_PYTHON,
    STUB_UNDECLARED,
    STUB_WITHOUT_CYCLE,
)
from nctakt.project.project_file import Project, Stub
from nctakt.st.check.names import Names
from nctakt.st.files.libraries import OwnLibrary, own_libraries
from nctakt.st.files.objects import parse_declaration
from nctakt.st.files.project import ReadFile
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece
from nctakt.st.tree import PouNode
from nctakt.st.vocabulary.libraries import known

#: The library of the blocks that no library's name precedes.
STUBS = "stubs"
_PROJECT = Text("the project", "das Projekt")
#: Bases of a class that are followed, at most.
_MAX_BASES = 20


@dataclass(frozen=True, slots=True)
class ProjectLibraries:
    """The libraries of a project's PLC: folders with sources, and classes in Python."""

    folders: tuple[Path, ...] = ()
    stubs: tuple[Stub, ...] = ()

    def read(self, read: ReadFile, reporter: Reporter) -> dict[str, OwnLibrary]:
        """Return the libraries by their names in lower case; mistakes are reported."""
        found = own_libraries(self.folders, read, reporter)
        files: dict[Path, _StubFile | None] = {}
        for stub in self.stubs:
            if stub.file not in files:
                files[stub.file] = _StubFile.read(stub, read, reporter)
            file = files[stub.file]
            piece = None if file is None else file.piece_of(stub, reporter)
            errors = reporter.error_count
            node = None if piece is None else parse_declaration(piece, reporter)
            _add(found, stub, node if reporter.error_count == errors else None, reporter)
        return found


def libraries_of(project: Project | None) -> ProjectLibraries:
    """Return the libraries of the PLC of a project."""
    if project is None:
        return ProjectLibraries()
    return ProjectLibraries(project.libraries, project.stubs)


def library_of(stub: Stub) -> str:
    """Return the library that has the block of a stub, by its name here."""
    return known(stub.library) or stub.library or STUBS


@dataclass(slots=True, eq=False)
class StubbedLibrary(OwnLibrary):
    """A library with blocks replaced by classes in Python, by their names in lower case."""

    stubs: dict[str, Stub] = field(default_factory=dict)

    def report_taken(self, names: Names, reporter: Reporter) -> None:
        """Report the blocks that the project declares, and those that another library has."""
        for key, stub in self.stubs.items():
            owner: str | Text = next(_owners(key, self, names), "")
            if key in names.project.declared:
                owner = _PROJECT
            if owner and (owner is _PROJECT or not stub.library):
                _report_taken(stub, owner, reporter)


def _owners(key: str, library: StubbedLibrary, names: Names) -> Iterator[str]:
    """Yield the other libraries that declare a name."""
    for space in names.libraries.values():
        is_other = space.library.lower() != library.name.lower()
        if is_other and key in (name.lower() for name in names.declared_names(space)):
            yield space.library


def _report_taken(stub: Stub, owner: str | Text, reporter: Reporter) -> None:
    shown = owner if isinstance(owner, str) and owner != STUBS else "LIBRARY"
    example = f'"{shown}.{stub.block}" = "{stub.file.name}:{stub.class_name}"'
    _report(STUB_NAME_TAKEN, stub, reporter, name=stub.block, owner=owner, example=example)


def _report(message: Message, stub: Stub, reporter: Reporter, **values: object) -> None:
    """Report a mistake at the entry of a stub."""
    reporter.error_count += 1
    span, line = stub.location
    reporter.collector.report(message, span, line, **values)


def _add(
    found: dict[str, OwnLibrary], stub: Stub, node: PouNode | None, reporter: Reporter
) -> None:
    """Add the block of a stub to its library, in which it replaces an object of its name.

    ``node`` ``None``: its declaration has mistakes that are reported.
    """
    name, key = library_of(stub), stub.block.lower()
    before = found.get(name.lower()) or OwnLibrary(name, [], frozenset())
    others = [one for one in before.declarations if getattr(one, "name", "").lower() != key]
    stubs: dict[str, Stub] = getattr(before, "stubs", {})
    if key in stubs or (len(others) < len(before.declarations) and not stub.library):
        _report_taken(stub, before.name, reporter)
        return
    found[name.lower()] = StubbedLibrary(
        before.name,
        others if node is None else [*others, node],
        before.words | {key},
        before.is_whole,
        before.references,
        before.faulty | ({key} if node is None else set()),
        {**stubs, key: stub},
    )


@dataclass(slots=True, eq=False)
class _StubFile:
    """A file with classes, as its syntax tree shows them."""

    name: str
    lines: Sequence[str]
    classes: dict[str, ast.ClassDef]

    @classmethod
    def read(cls, stub: Stub, read: ReadFile, reporter: Reporter) -> _StubFile | None:
        """Return a file; ``None`` with a report if it cannot be read."""
        data, name = read(stub.file), stub.file.as_posix()
        if data is None:
            reporter.error_count += 1
            return None
        text = decode_text(data).text
        lines = reporter.sources.lines[name] = split_lines(text)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # about escapes in texts; running it reports them
                tree = ast.parse("\n".join(lines))
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            line = min(max(getattr(error, "lineno", None) or 1, 1), max(len(lines), 1))
            length = len(lines[line - 1]) if lines else 0
            reason = getattr(error, "msg", None) or str(error) or type(error).__name__
            reporter.report_file(
                STUB_NOT_PYTHON, Span(name, line, 1, length + 1), file=name, reason=reason
            )
            return None
        classes = {one.name: one for one in tree.body if isinstance(one, ast.ClassDef)}
        return cls(name, lines, classes)

    def piece_of(self, stub: Stub, reporter: Reporter) -> Piece | None:
        """Return the text of a class as a function block; ``None`` with a report."""
        node = self.classes.get(stub.class_name)
        if node is None:
            near = nearest(stub.class_name, self.classes) or NOTHING
            _report(
                STUB_CLASS_MISSING,
                stub,
                reporter,
                file=self.name,
                name=stub.class_name,
                block=stub.block,
                nearest=near,
            )
            return None
        span = self._span_of(node)
        has_cycle, declared = False, None
        for one, is_known in self._with_bases(node):
            has_cycle |= not is_known or _has_method(one, "cycle")
            declared = declared or _declaration_in(one)
        if declared is None:
            reporter.report_file(STUB_UNDECLARED, span, name=node.name, block=stub.block)
            return None
        if not has_cycle:
            reporter.report_file(STUB_WITHOUT_CYCLE, span, name=node.name)
        return self._piece(stub, declared)

    def _span_of(self, node: ast.ClassDef) -> Span:
        """Return the place of the name of a class."""
        line = self.lines[node.lineno - 1]
        found = re.compile(rf"\b{node.name}\b").search(line, len("class"))
        begin, end = (0, len(line)) if found is None else found.span()
        return Span(self.name, node.lineno, begin + 1, end + 1)

    def _with_bases(self, node: ast.ClassDef) -> Iterator[tuple[ast.ClassDef, bool]]:
        """Yield a class and its bases of this file; the second: it has no base elsewhere."""
        waiting, seen = [node], [node]
        while waiting:
            one = waiting.pop(0)
            names = [base.id if isinstance(base, ast.Name) else "" for base in one.bases]
            found = [self.classes[name] for name in names if name in self.classes]
            is_known = all(name in self.classes or name == "object" for name in names)
            yield one, is_known and not one.keywords
            waiting += [base for base in found if base not in seen][:_MAX_BASES]
            seen += found

    def _piece(self, stub: Stub, declared: ast.Constant) -> Piece:
        """Return the text of a literal with its places in the file."""
        head = f"FUNCTION_BLOCK {stub.block}\n"
        text, first, column = str(declared.value), declared.lineno, declared.col_offset
        own = self.lines[first - 1 : declared.end_lineno]
        column = len(own[0].encode()[:column].decode(errors="replace")) + 1
        offsets, lines, columns = [0], [first], [column]
        at = "\n".join(own).find(text, column - 1)
        before = "\n".join(own)[: max(at, 0)]
        line, column = first + before.count("\n"), len(before) - before.rfind("\n")
        begin = len(head)
        for number, part in enumerate(text.split("\n")):
            offsets.append(begin)
            lines.append(first if at < 0 else line + number)
            columns.append(columns[0] if at < 0 else 1 if number else column)
            begin += len(part) + 1
        return Piece(self.name, head + text, offsets, lines, columns)


def _has_method(node: ast.ClassDef, name: str) -> bool:
    return any(isinstance(one, ast.FunctionDef) and one.name == name for one in node.body)


def _declaration_in(node: ast.ClassDef) -> ast.Constant | None:
    """Return the text ``declaration`` of a class, if it is a literal."""
    for one in node.body:
        targets = one.targets if isinstance(one, ast.Assign) else []
        if isinstance(one, ast.AnnAssign):
            targets = [one.target]
        is_named = any(isinstance(name, ast.Name) and name.id == "declaration" for name in targets)
        value = getattr(one, "value", None) if is_named else None
        if isinstance(value, ast.Constant) and isinstance(value.value, str):
            return value
    return None

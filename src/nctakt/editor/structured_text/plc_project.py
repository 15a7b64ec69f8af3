# SPDX-License-Identifier: MIT
"""A PLC project that is checked while its files are typed.

In: the files of a project, as in the editor. Out: its findings by file, and the checker with the
targets of all names. After a change only the changed file is read; names and types are resolved
anew, which is fast; bodies are checked if they name something whose declaration has changed. The
findings are those of ``nctakt check``. The trees of unchanged files stay, so that a unit is known
by its node.
"""

from __future__ import annotations

import gc
import hashlib
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.editor.structured_text.dependencies import (
    Concerned,
    FileFacts,
    OwnedName,
    changed_names,
    facts_of,
)
from nctakt.messages import Collector
from nctakt.plc.python.stubs import ProjectLibraries
from nctakt.st.check.project import ProjectChecker, checked, checker_of
from nctakt.st.files.libraries import OwnLibrary
from nctakt.st.files.objects import read_objects
from nctakt.st.files.project import PlcSources
from nctakt.st.inspection import OUR_DEFINITION, collector_waiting
from nctakt.st.parse.lexer import Definitions
from nctakt.st.program import Program
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece, Sources
from nctakt.st.tree import Call, Declaration, Header, PouNode, TaskNode
from nctakt.st.types import Method, Pou
from nctakt.st.vocabulary.libraries import default_libraries

#: With more pieces of text than this for each valid one, everything is reread.
_MAX_PIECES = 20
_FEW_PIECES = 2000


@dataclass(slots=True, eq=False)
class PlcFile:
    """A file that was read: its objects, mistakes in its text, names visible to others.

    ``state`` changes with the file, ``digest`` with its content.
    """

    name: str
    state: object
    digest: bytes
    nodes: list[Declaration]
    findings: list[Diagnostic]
    pieces: list[Piece]
    facts: FileFacts


class Texts(Protocol):
    """The texts of a project's files, as in the editor."""

    def read_bytes(self, path: Path) -> bytes:
        """Return a file's bytes; raises ``Failure`` where it cannot be read."""

    def state_of(self, path: Path) -> object:
        """Return a key that changes with the text of a file."""


class PlcProject:
    """A project: its files, the last check of them. Callers hold ``lock`` meanwhile."""

    def __init__(self, listed: PlcSources, libraries: ProjectLibraries, texts: Texts) -> None:
        self.lock = threading.RLock()
        #: Names and types of earlier checks are left, which refer to each other.
        self.has_garbage = False
        self.listed = listed
        self._libraries = libraries
        self._texts = texts
        self._tried: dict[Path, bytes] = {}
        self._begin()

    def _begin(self) -> None:
        """Begin without anything that was read."""
        self.sources = Sources()
        self.files: dict[Path, PlcFile] = {}
        self.checker: ProjectChecker | None = None
        self.program: Program | None = None
        self._findings: dict[str, list[Diagnostic]] = {}
        self._memory = UnitMemory()
        self._is_settled = False
        self._own: dict[str, OwnLibrary] | None = None
        #: What the texts of libraries change with, by their files.
        self._library_states: dict[Path, object] = {}
        stems = frozenset(path.stem.lower() for path in self.listed.files)
        values = {OUR_DEFINITION: "", **self.listed.definitions}
        self._definitions = Definitions(values, stems, stems)

    # --- requests ---------------------------------------------------------------------------------

    def findings(self, name: str, poll: Callable[[], None] | None = None) -> list[Diagnostic]:
        """Return the findings of a file by place; ``poll`` may end the check by an exception."""
        with self.lock:
            self.update(poll)
            return list(self._findings.get(name, ()))

    def all_findings(self) -> list[Diagnostic]:
        """Return the findings of all files."""
        with self.lock:
            self.update()
            return [one for found in self._findings.values() for one in found]

    def tried(self, name: str, lines: Sequence[str]) -> list[Diagnostic]:
        """Return the findings of all files if one had other lines; the project is unchanged."""
        with self.lock:
            self._tried = {Path(name): "\n".join(lines).encode("utf-8", "surrogatepass")}
            try:
                return self.all_findings()
            finally:
                self._tried = {}
                self.update()

    def update(self, poll: Callable[[], None] | None = None) -> ProjectChecker:
        """Check all changes since the last time; return the checker with its names."""
        with self.lock, collector_waiting():
            if len(self.sources.pieces) > _FEW_PIECES + _MAX_PIECES * len(self.files):
                self._begin()
            is_changed, is_first = self._read(), self.checker is None
            if is_changed or not self._is_settled:
                self._is_settled, self.has_garbage = False, True
                self._memory.poll = poll or (lambda: None)
                self._check()
                self._is_settled = True
                if is_first:
                    # The trees stay: the garbage collector need not look through them again.
                    gc.collect()
                    gc.freeze()
            assert self.checker is not None
            return self.checker

    @property
    def declarations(self) -> list[Declaration]:
        """All objects of the project, in the order of its files."""
        return [node for file in self.files.values() for node in file.nodes]

    # --- reading ----------------------------------------------------------------------------------

    def _read(self) -> bool:
        """Read the files that have changed, and forget what depends on them."""
        if any(self._state(path) != state for path, state in self._library_states.items()):
            self._begin()
        changed: set[OwnedName] = set()
        is_changed = False
        for path in self.listed.files:
            known = self.files.get(path)
            state = self._state(path)
            if known is not None and known.state == state:
                continue
            data = self._bytes(path)
            digest = hashlib.blake2b(data).digest()
            if known is not None and known.digest == digest:
                known.state = state
                continue
            is_changed = True
            file = self._parsed(path, data, state, digest)
            if known is not None:
                changed |= changed_names(known.facts, file.facts)
                self._memory.forget(known.nodes)
            self.files[path] = file
        if self.checker is not None and changed:
            self._forget(changed)
        return is_changed

    def _state(self, path: Path) -> object:
        tried = self._tried.get(path)
        return self._texts.state_of(path) if tried is None else ("tried", tried)

    def _bytes(self, path: Path) -> bytes:
        if path in self._tried:
            return self._tried[path]
        try:
            return self._texts.read_bytes(path)
        except Failure:
            return b""

    def _parsed(self, path: Path, data: bytes, state: object, digest: bytes) -> PlcFile:
        name, before = path.as_posix(), len(self.sources.pieces)
        collector = Collector()
        nodes = read_objects(name, data, self._definitions, Reporter(self.sources, collector))
        pieces = self.sources.pieces[before:]
        facts = facts_of(nodes, pieces, self.sources)
        return PlcFile(name, state, digest, nodes, collector.diagnostics, pieces, facts)

    def _forget(self, changed: set[OwnedName]) -> None:
        """Forget the findings in bodies that use names whose declarations have changed."""
        concerned = Concerned(changed, [one.facts for one in self.files.values()])
        for file in self.files.values():
            if file.facts in concerned:
                self._memory.forget(file.nodes)
        self._memory.forget_neighbours()

    # --- checking ---------------------------------------------------------------------------------

    def _check(self) -> None:
        if self._own is None:
            reporter = Reporter(self.sources, Collector())
            self._own = self._libraries.read(self._read_library, reporter)
        collector = Collector()
        named = self.listed.libraries
        libraries = default_libraries() if named is None else named
        reporter = Reporter(self.sources, collector)
        checker = checker_of(libraries, reporter, self._own, self._memory)
        declarations = self.declarations
        for node in declarations:
            if isinstance(node, TaskNode) and node.name.lower() in self.listed.tasks:
                task = self.listed.tasks[node.name.lower()]
                node.cycle_us, node.priority = task.cycle_us, task.priority
        self._memory.begin()
        self.program = checked(self.listed.name, declarations, checker)
        self.checker = checker
        self._findings = self._by_file(collector.diagnostics)

    def _by_file(self, found: Iterable[Diagnostic]) -> dict[str, list[Diagnostic]]:
        """Return findings by file, each once, in the order of its text."""
        parsed = [one for file in self.files.values() for one in file.findings]
        by_file: dict[str, dict[object, Diagnostic]] = {}
        for one in (*parsed, *found):
            if one.span is not None:
                key = (one.id, one.span, one.text())
                by_file.setdefault(one.span.file, {})[key] = one
        return {file: sorted(items.values(), key=_order) for file, items in by_file.items()}

    def _read_library(self, path: Path) -> bytes | None:
        self._library_states[path] = self._state(path)
        return self._bytes(path) or None

    def file_named(self, name: str) -> PlcFile | None:
        """Return a file of the project by its name in findings."""
        return self.files.get(Path(name))


def _order(item: Diagnostic) -> tuple[int, int, int]:
    span = item.span
    return (0, 0, item.id) if span is None else (span.line, span.column, item.id)


def same_files(first: PlcSources, second: PlcSources) -> bool:
    """Return whether two states of a project name the same files, libraries and definitions."""
    return _facts(first) == _facts(second)


def _facts(listed: PlcSources) -> tuple[object, ...]:
    definitions: Mapping[str, str] = listed.definitions
    return (listed.name, listed.files, listed.libraries, sorted(definitions.items()))


@dataclass(slots=True, eq=False)
class _Found:
    """Result of a unit's check: findings, and its calls, by their paths."""

    findings: list[Diagnostic]
    calls: list[tuple[str, Call]]

    @property
    def names_neighbours(self) -> bool:
        """Whether a finding suggests the nearest name: another may be nearer by now."""
        return any("nearest" in one.values for one in self.findings)


class UnitMemory:
    """The findings of units; ``poll`` may end a check by an exception."""

    def __init__(self) -> None:
        self.poll: Callable[[], None] = lambda: None
        self._units: dict[Header, _Found] = {}
        self._libraries: dict[str, list[Declaration]] = {}
        self._by_path: dict[str, Pou | Method] = {}

    def begin(self) -> None:
        """Begin a check: the units are others than before."""
        self._by_path.clear()

    def forget(self, nodes: Iterable[Declaration]) -> None:
        """Forget the units of declarations."""
        for node in nodes:
            for unit in units_of(node):
                self._units.pop(unit, None)

    def forget_neighbours(self) -> None:
        """Forget units with findings that suggest a name nearest to a name."""
        for node in [node for node, found in self._units.items() if found.names_neighbours]:
            del self._units[node]

    def check(self, node: Header, unit: Pou | Method, checker: ProjectChecker) -> None:
        """Check a unit, or repeat the findings of its last check."""
        diagnostics = checker.reporter.collector.diagnostics
        known = self._units.get(node)
        if known is not None:
            diagnostics += known.findings
            self._recall(known.calls, unit, checker)
            return
        self.poll()
        begun = len(diagnostics)
        checker.unit_inside(node, unit)
        calls = [(one.path, call) for one, call in checker.callers.get(unit, {}).items()]
        self._units[node] = _Found(diagnostics[begun:], calls)

    def _recall(
        self, calls: list[tuple[str, Call]], unit: Pou | Method, checker: ProjectChecker
    ) -> None:
        """Note whom a unit calls, among the units of this check."""
        if not calls:
            return
        if not self._by_path:
            self._by_path = {one.path: one for one in checker.resolver.nodes}
        for path, call in calls:
            target = self._by_path.get(path)
            if target is not None:
                checker.callers.setdefault(unit, {}).setdefault(target, call)

    def library(self, name: str, parse: Callable[[], list[Declaration]]) -> list[Declaration]:
        """Return the declarations of a known library, parsed once."""
        if name not in self._libraries:
            self._libraries[name] = parse()
        return self._libraries[name]


def units_of(node: Declaration) -> Iterator[Header]:
    """Yield the parts of an object that have their own variables or statements."""
    if isinstance(node, PouNode):
        yield node
        yield from node.methods
        for one in node.properties:
            yield from (accessor for accessor in (one.get, one.set) if accessor is not None)

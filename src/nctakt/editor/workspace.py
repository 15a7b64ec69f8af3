# SPDX-License-Identifier: MIT
"""The open documents, their machines, and the check of each.

In: documents, the project files around them. Out: the findings of a document, those of ``nctakt
check`` for its present text in the editor.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from lsprotocol.types import PositionEncodingKind

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.editor.document import LIST_SUFFIXES, Document, split_text, uri_of

if TYPE_CHECKING:
    from nctakt.checking.check_memory import CheckMemory
    from nctakt.editor.open_buffers import OpenBuffers
    from nctakt.editor.structured_text.plc_projects import PlcProjects
    from nctakt.project.machine_choice import MachineChoice
    from nctakt.run.realtime.assembly import AssembledMachine

# The modules of the check are loaded with the first check, in parallel with the server's start.


#: Programs of the editor's folders that are searched, by the ends of their names.
MAX_FILES = 200
SUFFIXES = (".nc", ".ncp", ".cnc", ".sub", ".cyc")

#: The modules of the answers to an editor.
_ANSWERS = (
    "calls",
    "colours",
    "completion",
    "formatting",
    "hints",
    "hover",
    "navigation",
    "outline",
    "remedies",
)


@dataclass(frozen=True, slots=True)
class LoadedMachine:
    """A machine, the files that it was read from, and why it could not be read (then the demo)."""

    machine: AssembledMachine
    access: OpenBuffers
    failure: tuple[Diagnostic, ...] = ()


class Workspace:
    """All open documents by URI, and the machines of their programs."""

    def __init__(self) -> None:
        self.documents: dict[str, Document] = {}
        self.encoding: PositionEncodingKind | str = PositionEncodingKind.Utf16
        self._paths: dict[Path, Document] = {}
        self._machines: dict[Path, LoadedMachine] = {}
        self._memory: CheckMemory | None = None
        self._plc: PlcProjects | None = None

    @property
    def plc(self) -> PlcProjects:
        """The projects of documents in Structured Text."""
        if self._plc is None:
            from nctakt.editor.structured_text.plc_projects import PlcProjects  # noqa: PLC0415 - as above

            self._plc = PlcProjects(self.documents, self.lines_of)
        return self._plc

    def open(self, document: Document) -> None:
        """Add a document."""
        self.documents[document.uri] = document
        if document.path is not None:
            self._paths[_real(document.path)] = document

    def close(self, uri: str) -> None:
        """Remove a document; its file counts again."""
        document = self.documents.pop(uri, None)
        if document is not None and self._memory is not None:
            self._memory.forget(document.name)
        if document is None or document.path is None:
            return
        path = _real(document.path)
        self._paths.pop(path, None)
        for other in self.documents.values():
            if other.path is not None and _real(other.path) == path:
                self._paths[path] = other  # the same file by another name

    def at(self, path: Path) -> Document | None:
        """Return the open document of a file."""
        return self._paths.get(path) or self._paths.get(_real(path))

    def lines_of(self, path: Path) -> Sequence[str] | None:
        """Return the lines of an open file, ``None`` if it is not open."""
        document = self.at(path)
        return None if document is None else document.program_lines()

    def programs_beside(self, document: Document, folders: Sequence[Path]) -> list[Document]:
        """Return the programs of the same machine that are open or in the editor's folders."""
        folder = self.machine_of(document).machine.configuration.folder
        return [
            program
            for program in self.programs(folders)
            if self.machine_of(program).machine.configuration.folder == folder
        ]

    def programs(self, folders: Sequence[Path]) -> list[Document]:
        """Return the open programs, and those of the editor's folders, ``MAX_FILES`` at most."""
        documents = [item for item in self.documents.values() if item.is_program]
        known = {_real(item.path) for item in documents if item.path is not None}
        for folder in folders:
            paths = (path for path in sorted(folder.rglob("*")) if path.suffix.lower() in SUFFIXES)
            for path in paths:
                if len(documents) >= MAX_FILES:
                    return documents
                program = None if _real(path) in known else self._from_disk(path)
                if program is not None:
                    documents.append(program)
        return documents

    def document_of(self, path: Path) -> Document | None:
        """Return the document of a file, open or not; ``None`` if it cannot be read."""
        return self.at(path) or self._from_disk(path)

    def _from_disk(self, path: Path) -> Document | None:
        """Return a file that is not open as a document; ``None`` for one that cannot be read."""
        from nctakt.base.text import decode_text  # noqa: PLC0415 - as above
        from nctakt.files.access import FileAccess  # noqa: PLC0415

        try:
            text = decode_text(FileAccess().read_bytes(path)).text
        except Failure:
            return None
        lines, encoding = split_text(text), self.encoding
        return Document(uri_of(path), path, path.as_posix(), "nctakt", 0, lines, encoding)

    # --- machines --------------------------------------------------------------------------------

    def choice_of(self, path: Path | None) -> MachineChoice:
        """Return the machine of a program; raises ``Failure`` for an invalid project file."""
        from nctakt.editor.open_buffers import OpenBuffers  # noqa: PLC0415 - as above
        from nctakt.project.machine_choice import choose_machine  # noqa: PLC0415
        from nctakt.project.project_file import find_project  # noqa: PLC0415

        access = OpenBuffers(self.lines_of)
        return choose_machine(path, find_project(path or Path(), access), access)

    def machine_of(self, document: Document) -> LoadedMachine:
        """Return the machine of a program, reloaded if one of its lists has changed."""
        try:
            choice = self.choice_of(document.location)
        except Failure as failure:
            return LoadedMachine(*self._demo(), failure.diagnostics)
        known = self._machines.get(choice.path)
        if known is None or known.access.is_outdated():
            known = self._machines[choice.path] = self._load(choice.path)
        return known

    def _load(self, folder: Path) -> LoadedMachine:
        from nctakt.editor.open_buffers import OpenBuffers  # noqa: PLC0415 - as above
        from nctakt.lists.machine.machine import load_machine  # noqa: PLC0415
        from nctakt.run.realtime.assembly import AssembledMachine  # noqa: PLC0415

        access = OpenBuffers(self.lines_of)
        try:
            configuration = load_machine(folder, access=access)
        except Failure as failure:
            return LoadedMachine(self._demo()[0], access, failure.diagnostics)
        return LoadedMachine(AssembledMachine(configuration, access, has_history=False), access)

    def _demo(self) -> tuple[AssembledMachine, OpenBuffers]:
        from nctakt.lists.machine.files import DEMO_FOLDER  # noqa: PLC0415 - as above

        known = self._machines.get(DEMO_FOLDER)
        if known is None:
            known = self._machines[DEMO_FOLDER] = self._load(DEMO_FOLDER)
        return known.machine, known.access

    def warm_up(self) -> None:
        """Load the modules for the first answers."""
        import importlib  # noqa: PLC0415 - as above

        self._demo()
        for name in _ANSWERS:
            importlib.import_module(f"nctakt.editor.{name}")

    # --- the check -------------------------------------------------------------------------------

    def check(self, document: Document, poll: Callable[[], None] | None = None) -> list[Diagnostic]:
        """Return the findings of a document in the order of its text.

        ``poll`` is called repeatedly and may end the check by an exception.
        """
        from nctakt.checking.check import check_files  # noqa: PLC0415 - as above
        from nctakt.checking.check_memory import CheckMemory  # noqa: PLC0415
        from nctakt.run.program_loader import NcText  # noqa: PLC0415

        if document.is_structured:
            return self.plc.findings(document, poll)
        if document.is_list:
            return self._check_list(document)
        if self._memory is None:
            self._memory = CheckMemory()
        loaded = self.machine_of(document)
        named: Path | NcText
        if document.path is not None and document.path.is_file():
            named = document.path
        else:
            named = NcText(document.name, document.text())
        result = check_files([named], loaded.machine, for_all=True, poll=poll, memory=self._memory)
        return [item.diagnostic for item in result.findings if item.file == document.name]

    def _check_list(self, document: Document) -> list[Diagnostic]:
        """Return the findings of a list: with the machine that names it, else of it alone."""
        from nctakt.checking.check import check_files  # noqa: PLC0415 - as above
        from nctakt.editor.open_buffers import OpenBuffers  # noqa: PLC0415
        from nctakt.lists.machine.files import startup_list_around  # noqa: PLC0415
        from nctakt.run.realtime.assembly import AssembledMachine  # noqa: PLC0415

        path = document.path
        default = AssembledMachine(self._demo()[0].configuration, OpenBuffers(self.lines_of))
        if path is None or not path.is_file():
            return _check_unsaved(document, default)
        startup = startup_list_around(path)
        for named in (startup, path):
            if named is None:
                continue
            result = check_files([named], default, detail="effects")
            if any(_real(Path(file.file)) == _real(path) for file in result.files):
                return [
                    item.diagnostic
                    for item in result.findings
                    if item.file and _real(Path(item.file)) == _real(path)
                ]
        return []


def _check_unsaved(document: Document, machine: AssembledMachine) -> list[Diagnostic]:
    """Return the findings of a list that has no file yet, alone, from a file for the moment."""
    from nctakt.checking.check import check_files  # noqa: PLC0415 - as above

    with tempfile.TemporaryDirectory(prefix="nctakt-") as folder:
        named = Path(document.name)
        suffix = named.suffix if named.suffix.casefold() in LIST_SUFFIXES else ".lis"
        file = Path(folder, f"{named.stem}{suffix}")
        file.write_text(document.text(), "utf-8", errors="surrogatepass")
        result = check_files([file], machine, detail="effects")
        return [
            item.diagnostic
            for item in result.findings
            if item.file and _real(Path(item.file)) == _real(file)
        ]


def _real(path: Path) -> Path:
    return Path(path.absolute().as_posix()).resolve()

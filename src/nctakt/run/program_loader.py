# SPDX-License-Identifier: MIT
"""Program load: a file or text -> a checked program with all that it calls.

All mistakes are reported at once: those of the program, of the files that it calls by constant
names, of the files that these call, and so on. A subprogram whose name is computed is read when it
is called. Where files are searched: ``search_folders``.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path, PureWindowsPath

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.failure import Failure
from nctakt.base.text import split_lines
from nctakt.decoder.state.environment import DecodeError
from nctakt.files.access import FileAccess
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.files import find_below
from nctakt.messages import Collector, diagnostic
from nctakt.messages.checked_blocks import FUNCTION_NOT_DEFINED, UNKNOWN_WORD
from nctakt.messages.checked_values import UNKNOWN_AXIS_OF_VARIABLE, UNKNOWN_VARIABLE
from nctakt.messages.files import FILE_OUTSIDE
from nctakt.messages.inputs import NAMES_OF_DEMO_MACHINE, TEXT_INSTEAD_OF_FILE
from nctakt.messages.program_structure import PROGRAM_NOT_FOUND
from nctakt.nc.check.blocks import Role
from nctakt.nc.inspection import inspect
from nctakt.nc.outline import ProgramText
from nctakt.nc.source import Source
from nctakt.nc.tree import StringLiteral
from nctakt.run.assembly import AssembledMachine

#: Errors in names that the lists of a machine give.
_LIST_NAMES = (UNKNOWN_VARIABLE, UNKNOWN_AXIS_OF_VARIABLE, UNKNOWN_WORD, FUNCTION_NOT_DEFINED)

#: Characters of a text that are shown where a file name was expected.
SHOWN_TEXT = 40


class ProgramErrors(Failure):
    """The errors in a program that was read; they are among the controller's diagnostics."""


@dataclass(frozen=True, slots=True)
class NcText:
    """A program given as text; ``name`` stands for the file in diagnostics and results."""

    name: str
    text: str


def name_of(program: str | Path | NcText) -> str:
    """Return the name of a program as the user gave it."""
    return program.name if isinstance(program, NcText) else str(program)


def search_folders(caller: str, parameters: ChannelParameters, machine_folder: Path) -> list[Path]:
    """Where a subprogram that the file ``caller`` calls is searched, one folder after the other.

    The caller's own folder; then those of the channel list for subprograms, by priority, then in
    their order (P-CHAN-00401 … 00404), relative to the machine's folder or to the one above it.
    """
    folders = [Path(caller).parent]
    paths = [path for path in parameters.program_paths if path.holds_subprograms]
    for path in sorted(paths, key=lambda one: one.priority):
        folders.append(program_folder(path.folder, machine_folder))
    return list(dict.fromkeys(folders))


def program_folder(named: str, machine_folder: Path) -> Path:
    """Return a folder of programs as a channel list names it (P-CHAN-00401)."""
    plain = Path(named.replace("\\", "/"))
    near, above = machine_folder / plain, machine_folder / ".." / plain
    return above if not near.is_dir() and above.is_dir() else near


def find_program(name: str, folders: list[Path], access: FileAccess) -> Path | None:
    """Return the file of this name in the first folder that has it, as far as ``access`` allows."""
    if PureWindowsPath(name).drive or Path(name).is_absolute():
        path = Path(name.replace("\\", "/"))
        return path if access.admits(path) and path.is_file() else None
    return next((found for folder in folders if (found := find_below(name, folder, access))), None)


def missing(
    name: str, folders: list[Path], access: FileAccess, span: Span, line: str
) -> Diagnostic:
    """The diagnostic of a file that is in none of the folders, or outside of what may be read."""
    plain = name.replace("\\", "/")
    if not any(access.admits(folder / plain) for folder in folders):
        return diagnostic(FILE_OUTSIDE, span, line, file=name, folders=access.shown_folders)
    if PureWindowsPath(name).drive or Path(name).is_absolute():
        searched = name
    else:
        searched = ", ".join(f"{folder.as_posix()}/" for folder in folders)
    return diagnostic(PROGRAM_NOT_FOUND, span, line, name=name, folders=searched)


class LoadedProgram:
    """A program with the files that it calls; ``text`` is its own, ``texts`` are all.

    ``channel`` is the index of the channel that it is checked for, from 0, ``parameters`` its list.
    """

    def __init__(self, machine: AssembledMachine, channel: int) -> None:
        self._machine = machine
        self._names = machine.assembled[channel].names
        self.channel = channel
        self.parameters = machine.assembled[channel].parameters
        self._files: dict[Path, ProgramText] = {}
        self.texts: list[ProgramText] = []

    @property
    def text(self) -> ProgramText:
        """The main program's."""
        return self.texts[0]

    def add(self, source: Source, collector: Collector, role: Role) -> ProgramText:
        """Check a text."""
        self._machine.files.add(source.file, source.lines)
        text = inspect(
            source, self._names, self.parameters, collector, role=role, poll=self._machine.poll
        )
        self.texts.append(text)
        return text

    def add_called(self, text: ProgramText, collector: Collector) -> None:
        """Check the files that a text calls, and those that these call."""
        waiting = [text]
        while waiting:
            text = waiting.pop(0)
            for call in text.calls:
                assert isinstance(call.name, StringLiteral)
                known = len(self.texts)
                self._find(call.name.value, text.source.file, call.span, collector)
                waiting += self.texts[known:]

    def add_implicit(self, collector: Collector) -> None:
        """Check the programs that the channel list names, as if the main program called them."""
        for name in self.parameters.implicit_programs.names:
            known = len(self.texts)
            self._find(name, self.text.source.file, self.text.main.span, collector)
            for text in self.texts[known:]:
                self.add_called(text, collector)

    def _find(self, name: str, caller: str, span: Span, collector: Collector) -> ProgramText | None:
        """Return the text of a file that is called; what is wrong goes to ``collector``."""
        folders = search_folders(caller, self.parameters, self._folder)
        access = self._machine.file_access
        path = find_program(name, folders, access)
        if path is None:
            line = self._machine.files.line_at(span)
            collector.diagnostics.append(missing(name, folders, access, span, line))
            return None
        key = path.resolve()
        if key not in self._files:
            try:
                source = Source(str(path), access.read_lines(path))
            except Failure as failure:
                collector.diagnostics += failure.diagnostics
                return None
            self._files[key] = self.add(source, collector, "called")
        return self._files[key]

    @property
    def _folder(self) -> Path:
        return self._machine.configuration.folder

    def subprogram(self, name: str, caller: str, span: Span) -> ProgramText:
        """Return the text of a file that the file ``caller`` calls at ``span``.

        It is read and checked now if it has not been before. Raises ``DecodeError`` with the first
        of the errors in it.
        """
        collector = Collector()
        known = len(self.texts)
        found = self._find(name, caller, span, collector)
        if found is not None and len(self.texts) > known:
            self.add_called(found, collector)
        errors = [one for one in collector.diagnostics if one.severity.name == "ERROR"]
        if errors:
            raise DecodeError(errors[0])
        assert found is not None
        return found


def load(
    program: str | Path | NcText,
    machine: AssembledMachine,
    diagnostics: list[Diagnostic],
    channel: int = 0,
) -> LoadedProgram:
    """Read, parse and check a program with all that it calls; findings go to ``diagnostics``.

    ``channel``: the index of the channel that it is for, from 0. Raises ``Failure`` if it cannot be
    read, ``ProgramErrors`` with the errors in it.
    """
    collector = Collector()
    if isinstance(program, NcText):
        lines: Sequence[str] = split_lines(program.text)
    elif isinstance(program, str) and ("\n" in program or "\r" in program):
        raise Failure(diagnostic(TEXT_INSTEAD_OF_FILE, line=split_lines(program)[0][:SHOWN_TEXT]))
    else:
        lines = machine.file_access.read_lines(Path(program))
    loaded = LoadedProgram(machine, channel)
    main = loaded.add(Source(name_of(program), lines), collector, "main")
    loaded.add_called(main, collector)
    loaded.add_implicit(collector)
    diagnostics += collector.diagnostics
    errors = [found for found in collector.diagnostics if found.severity.name == "ERROR"]
    if machine.configuration.is_demo and any(one.message in _LIST_NAMES for one in errors):
        diagnostics.append(diagnostic(NAMES_OF_DEMO_MACHINE))
    if errors:
        raise ProgramErrors(*errors)
    return loaded

# SPDX-License-Identifier: MIT
"""Program load: a file or text -> a checked program with all that it calls.

All mistakes are reported at once: those of the program, of the files that it calls by constant
names, of the files that these call, and so on. A subprogram whose name is computed is read when it
is called. ``search_folders`` returns the folders in which files are searched.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path, PureWindowsPath

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.failure import Failure
from nctakt.base.long_text import TextChanged
from nctakt.base.text import split_lines
from nctakt.decoder.state.environment import DecodeError
from nctakt.files.access import FileAccess
from nctakt.lists.format import arguments
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.files import find_below
from nctakt.messages import Collector, diagnostic
from nctakt.messages.commands.inputs import NAMES_OF_DEMO_MACHINE, TEXT_INSTEAD_OF_FILE
from nctakt.messages.files import FILE_OUTSIDE, TEXT_CHANGED
from nctakt.messages.programs.checked_blocks import FUNCTION_NOT_DEFINED, UNKNOWN_WORD
from nctakt.messages.programs.checked_values import UNKNOWN_AXIS_OF_VARIABLE, UNKNOWN_VARIABLE
from nctakt.messages.programs.program_structure import PROGRAM_NOT_FOUND
from nctakt.nc.check.blocks import Role
from nctakt.nc.check.comments import misspelt_keywords
from nctakt.nc.inspection import inspect
from nctakt.nc.outline import ProgramText
from nctakt.nc.source import Source
from nctakt.nc.vocabulary.variables.variable_table import NameTable
from nctakt.run.realtime.assembly import AssembledMachine

#: Errors about names that the lists of a machine define.
_LIST_NAMES = (UNKNOWN_VARIABLE, UNKNOWN_AXIS_OF_VARIABLE, UNKNOWN_WORD, FUNCTION_NOT_DEFINED)

#: Maximum number of characters shown of a text in place of a file name.
SHOWN_TEXT = 40


class ProgramErrors(Failure):
    """The errors in a program, which are among the controller's diagnostics as well."""


@dataclass(frozen=True, slots=True)
class NcText:
    r"""A program as text; ``name`` replaces the file in diagnostics and results.

    >>> program = NcText("part.nc", "G01 X50 F6000\nG01 Y50\nM30")
    >>> Controller().run(program).virtual_time_us
    1051000
    """

    name: str
    text: str


def name_of(program: AnyProgram) -> str:
    """Return the name of a program as the user wrote it."""
    return str(program) if isinstance(program, str | Path) else program.name


def search_folders(caller: str, parameters: ChannelParameters, machine_folder: Path) -> list[Path]:
    """Return the folders in which a subprogram called by the file ``caller`` is searched.

    The caller's folder; then those of the channel list for subprograms, by priority, then in their
    order (P-CHAN-00401 … 00404), relative to the machine's folder or to its parent.
    """
    folders = [Path(caller).parent]
    paths = [path for path in parameters.program_paths if path.has_subprograms]
    for path in sorted(paths, key=lambda path: path.priority):
        folders.append(program_folder(path.folder, machine_folder))
    return list(dict.fromkeys(folders))


def program_folder(name: str, machine_folder: Path) -> Path:
    """Return a folder of programs as a channel list names it (P-CHAN-00401)."""
    plain = Path(name.replace("\\", "/"))
    near, above = machine_folder / plain, machine_folder / ".." / plain
    return above if not near.is_dir() and above.is_dir() else near


def find_program(name: str, folders: list[Path], access: FileAccess) -> Path | None:
    """Return the file of this name in the first folder that has it, as far as ``access`` allows."""
    if PureWindowsPath(name).drive or Path(name).is_absolute():
        path = Path(name.replace("\\", "/"))
        return path if access.admits(path) and path.is_file() else None
    return next((file for folder in folders if (file := find_below(name, folder, access))), None)


def missing(
    name: str, folders: list[Path], access: FileAccess, span: Span, line: str
) -> Diagnostic:
    """Return the diagnostic of a file that is missing in all folders, or must not be read."""
    plain = name.replace("\\", "/")
    if not any(access.admits(folder / plain) for folder in folders):
        return diagnostic(FILE_OUTSIDE, span, line, file=name, folders=access.shown_folders)
    if PureWindowsPath(name).drive or Path(name).is_absolute():
        searched = name
    else:
        searched = ", ".join(f"{folder.as_posix()}/" for folder in folders)
    not_found = diagnostic(PROGRAM_NOT_FOUND, span, line, name=name, folders=searched)
    from nctakt.nc.slips.naming import slip_of  # noqa: PLC0415 - only after a mistake

    return slip_of(not_found) or not_found


class LoadedProgram:
    """A program with the files that it calls; ``text`` is its own, ``texts`` are all.

    ``channel`` is the index of the channel that it is checked for, from 0, ``parameters`` its list.
    """

    def __init__(
        self,
        machine: AssembledMachine,
        channel: int,
        fetched: Mapping[str, int | None] | None = None,
    ) -> None:
        self._machine = machine
        self._names = machine.assembled[channel].names.own_table()
        self._first_fetched = dict(fetched or {})
        for axis, number in self._first_fetched.items():
            self._names.learn_axis(axis, number)
        self.channel = channel
        self.parameters = machine.assembled[channel].parameters
        self._files: dict[Path, ProgramText] = {}
        self.texts: list[ProgramText] = []

        self.diagnostics: list[Diagnostic] = []

    @property
    def text(self) -> ProgramText:
        """The text of the main program."""
        return self.texts[0]

    @property
    def names_of_fetched_axes(self) -> NameTable | None:
        """Names for a run of it with those of the axes that it fetches, ``None`` without any."""
        return self._names.own_copy() if self._names.fetched else None

    @property
    def name(self) -> str:
        """The name of the main program as the user wrote it."""
        return self.text.source.file

    def on(self, machine: AssembledMachine) -> LoadedProgram:
        """Return the program for another controller of the same machine, not checked again.

        Only the files loaded with it are included; files called by a computed name are reread.
        """
        other = LoadedProgram(machine, self.channel, self._names.fetched)
        other.texts = self.texts[: self._loaded_count]
        other._loaded_count = self._loaded_count
        other.diagnostics = self.diagnostics
        loaded = [id(text) for text in other.texts]
        other._files = {path: text for path, text in self._files.items() if id(text) in loaded}
        for text in other.texts:
            machine.files.add(text.source.file, text.source.lines)
        return other

    def late_names(self) -> dict[str, int | None]:
        """Return the fetched axes if a file other than the main program fetches one."""
        own = {name for use in self.text.exchanges for name, _ in use.names}
        fetched = self._names.fetched
        return {} if own.issuperset(fetched) or self._first_fetched else dict(fetched)

    def finish(self, diagnostics: list[Diagnostic]) -> None:
        """Note that it is loaded, with these findings."""
        self._loaded_count = len(self.texts)
        self.diagnostics = diagnostics

    def add(self, source: Source, collector: Collector, role: Role) -> ProgramText:
        """Check a text, register it and return it."""
        self._machine.files.add(source.file, source.lines)
        named = [word for other in self.texts for word in other.named_programs]
        try:
            text = inspect(
                source,
                self._names,
                self.parameters,
                collector,
                role=role,
                poll=self._machine.poll,
                named_programs=named,
            )
        except TextChanged as error:
            raise Failure(diagnostic(TEXT_CHANGED, file=str(error.path))) from error
        self.texts.append(text)
        return text

    def add_called(self, text: ProgramText, collector: Collector) -> None:
        """Check the files that a text calls, and those that they call."""
        waiting = [text]
        while waiting:
            text = waiting.pop(0)
            for call in text.calls:
                text_count = len(self.texts)
                self._find(call.name, text.source.file, call.span, collector)
                waiting += self.texts[text_count:]

    def add_implicit(self, collector: Collector) -> None:
        """Check the programs that the channel list names, as if the main program called them."""
        for name in self.parameters.implicit_programs.names:
            text_count = len(self.texts)
            self._find(name, self.text.source.file, self.text.main.span, collector)
            for text in self.texts[text_count:]:
                self.add_called(text, collector)

    def _find(self, name: str, caller: str, span: Span, collector: Collector) -> ProgramText | None:
        """Return the text of a called file; its diagnostics go to ``collector``."""
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

        It is read and checked now if it has not been read before. Raises ``DecodeError`` with its
        first error.
        """
        collector = Collector()
        text_count = len(self.texts)
        text = self._find(name, caller, span, collector)
        if text is not None and len(self.texts) > text_count:
            self.add_called(text, collector)
        errors = [message for message in collector.diagnostics if message.severity.name == "ERROR"]
        if errors:
            raise DecodeError(errors[0])
        assert text is not None
        return text


#: A program: a file, a text, or one loaded for the same machine.
AnyProgram = str | Path | NcText | LoadedProgram


def _load(
    machine: AssembledMachine,
    channel: int,
    name: str,
    lines: Sequence[str],
    collector: Collector,
    fetched: Mapping[str, int | None],
) -> LoadedProgram:
    """Check a program with all it calls; ``fetched``: axes whose names are known at once."""
    loaded = LoadedProgram(machine, channel, fetched)
    main = loaded.add(Source(name, lines), collector, "main")
    loaded.add_called(main, collector)
    if isinstance(lines, list):  # a test is no text of megabytes
        for number, line in enumerate(lines, 1):
            if ";" in line:
                collector.diagnostics += misspelt_keywords(
                    main.source.file, number, line, is_lenient=True
                )
    loaded.add_implicit(collector)
    return loaded


def load(
    program: AnyProgram,
    machine: AssembledMachine,
    diagnostics: list[Diagnostic],
    channel: int = 0,
) -> LoadedProgram:
    """Read, parse and check a program with all files that it calls.

    A loaded program is taken over unchanged, with its findings.

    All findings go to ``diagnostics``. ``channel``: the index of its channel, from 0. Raises
    ``Failure`` if the program cannot be read, ``ProgramErrors`` if it has errors.
    """
    collector = Collector()
    if isinstance(program, LoadedProgram):
        diagnostics += program.diagnostics
        return program.on(machine)
    if isinstance(program, NcText):
        arguments.text("NcText.name", program.name)
        lines: Sequence[str] = split_lines(arguments.text("NcText.text", program.text))
    elif isinstance(program, str) and ("\n" in program or "\r" in program):
        raise Failure(diagnostic(TEXT_INSTEAD_OF_FILE, line=split_lines(program)[0][:SHOWN_TEXT]))
    else:
        lines = machine.file_access.read_lines(arguments.path("program", program))
    loaded = _load(machine, channel, name_of(program), lines, collector, {})
    fetched = loaded.late_names()
    if fetched:  # a file fetches them that comes after the file that uses them
        collector = Collector()
        loaded = _load(machine, channel, name_of(program), lines, collector, fetched)
    loaded.finish(collector.diagnostics)
    diagnostics += collector.diagnostics
    errors = [message for message in collector.diagnostics if message.severity.name == "ERROR"]
    if machine.configuration.is_demo and any(message.message in _LIST_NAMES for message in errors):
        diagnostics.append(diagnostic(NAMES_OF_DEMO_MACHINE))
    if errors:
        raise ProgramErrors(*errors)
    return loaded

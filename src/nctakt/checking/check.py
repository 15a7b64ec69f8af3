# SPDX-License-Identifier: MIT
"""Files, folders and texts -> their diagnostics, in one order.

In: files, folders, texts, and the machine for programs. Out: ``CheckResult``. Nothing is executed,
and mistakes in a file do not keep others from being checked. Besides errors, suspicious code in
programs is reported (``nc/lint``).
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic, Severity, Span, Text
from nctakt.base.failure import Failure
from nctakt.base.text import BYTE_ORDER_MARKS, decode_text, split_lines
from nctakt.checking.check_memory import CheckMemory, Poll
from nctakt.checking.inputs import Finding, PlcInput, gather
from nctakt.checking.plc_interface import report_interface_uses
from nctakt.checking.program import Checked, check_program
from nctakt.checking.program_links import (
    LinkedProgram,
    ProgramUses,
    report_missing_partners,
    report_unlinked_cycles,
)
from nctakt.checking.scripts import ScriptedProgram, impossible_firings, impossible_inputs
from nctakt.checking.suppression import Suppressions, apply, read_suppressions
from nctakt.checking.targets import Target, Targets
from nctakt.files.access import BEGIN_BYTES
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.without_effect import Detail
from nctakt.lists.machine.files import LIST_SUFFIX, startup_list_around
from nctakt.lists.machine.list_kinds import check_list_alone, is_startup_list, kind_of
from nctakt.lists.machine.machine import Machine, load_machine, load_startup
from nctakt.lists.machine.schedules.scheduling_profile import STANDARD_OPTIONS, RtconfOptions
from nctakt.messages import Collector, diagnostic
from nctakt.messages.commands.checking import (
    FILE_ENCRYPTED,
    LIST_CHECKED_ALONE,
    LIST_KIND_NOT_RECOGNISED,
    NOT_A_TEXT_FILE,
)
from nctakt.messages.files import BYTE_ORDER_MARK
from nctakt.nc.check.blocks import Role
from nctakt.nc.lint.linter import GlobalCycles, never_deleted
from nctakt.nc.source import Source
from nctakt.plc.python.stubs import ProjectLibraries, libraries_of
from nctakt.project.machine_choice import MachineChoice, choose_machine
from nctakt.project.project_file import find_project
from nctakt.run.program_loader import NcText
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.st.inspection import inspect_paths

#: The kind of a program; lists have the kinds of their schemas (``channel``, ``axis``, …).
PROGRAM = "program"
#: The kind of all files of a PLC.
PLC = "plc"

_UTF16_MARKS = (b"\xff\xfe", b"\xfe\xff")
_ENCRYPTED_SUFFIX = ".ecy"


_Key = tuple[str, int, int, int, str]


@dataclass(frozen=True, slots=True)
class CheckedFile:
    """A checked file and its kind."""

    file: str
    kind: str


@dataclass(frozen=True, slots=True)
class CheckResult:
    """The checked files by name, and all diagnostics by file, line, column and number.

    ``machines``: the folders with a start-up list of a usual name, and the start-up lists of other
    names. ``uses_default``: a program was checked for the default machine, since it belongs to none
    of these. ``around``: the start-up lists of machines that are not inputs themselves, in whose
    folders programs lie. ``settings``: the machines named by settings, and by which.
    """

    files: tuple[CheckedFile, ...]
    findings: tuple[Finding, ...]
    machines: tuple[str, ...] = ()
    uses_default: bool = False
    around: tuple[str, ...] = ()
    settings: tuple[MachineChoice, ...] = ()

    def count(self, severity: Severity) -> int:
        """Return the number of diagnostics of a severity."""
        return sum(item.diagnostic.severity is severity for item in self.findings)


def check_files(
    inputs: Sequence[str | Path | NcText],
    machine: AssembledMachine,
    *,
    detail: Detail = "summary",
    root: Path | None = None,
    for_all: bool = True,
    rtconf: RtconfOptions = STANDARD_OPTIONS,
    poll: Poll | None = None,
    memory: CheckMemory | None = None,
) -> CheckResult:
    """Check files, folders with their contents, texts, and the files that programs call.

    ``detail``: the extent of reports on list entries without effect. ``root``: a further folder for
    the files that lists name. ``for_all``: all programs are for ``machine``, even those in the
    folder of another one. ``rtconf``: the reading of scheduling lists. ``poll`` is called
    repeatedly while programs are read, and may end the check by an exception. ``memory``: the state
    kept between checks of programs that change. An unreadable file is a diagnostic as well;
    ``files`` of the result is empty if no file was checked.
    """
    return _Checker(machine, detail, root, for_all, rtconf, poll, memory).check(inputs)


@dataclass(frozen=True, slots=True)
class _Waiting:
    """A program to be checked; it is read once for all its channels."""

    path: Path
    targets: tuple[Target, ...]
    role: Role


@dataclass(slots=True)
class _AcrossPrograms:
    """What the programs of a call contain that only all of them together can be checked for.

    ``called``: files that others call; ``subprogram_ends``: programs that end as subprograms do, by
    the name of their file.
    """

    global_cycles: list[GlobalCycles] = field(default_factory=list)
    uses: list[ProgramUses] = field(default_factory=list)
    linked: list[LinkedProgram] = field(default_factory=list)
    scripted: list[ScriptedProgram] = field(default_factory=list)
    called: dict[Path, None] = field(default_factory=dict)
    subprogram_ends: dict[str, Diagnostic] = field(default_factory=dict)

    def report(self, collector: Collector) -> None:
        """Report cycles that nothing ends, signals without a partner, impossible firings."""
        never_deleted(self.global_cycles, collector)
        report_missing_partners(self.uses, collector)
        report_unlinked_cycles(self.linked, collector)
        collector.diagnostics += impossible_firings(self.scripted)


class _Checker:
    """Gathers the files and diagnostics of one call."""

    def __init__(
        self,
        machine: AssembledMachine,
        detail: Detail,
        root: Path | None,
        for_all: bool,
        rtconf: RtconfOptions,
        poll: Poll | None = None,
        memory: CheckMemory | None = None,
    ) -> None:
        self._poll = poll
        self._memory = memory
        self._targets = Targets(machine, for_all)
        self._default_machine = machine.configuration
        self._access = machine.file_access
        self._detail = detail
        self._rtconf = rtconf
        self._root = root
        self._for_all = for_all
        self._files: dict[str, str] = {}
        self._found: list[Finding] = []
        self._around: dict[Path, None] = {}
        self._settings: dict[MachineChoice, None] = {}
        self._channels: dict[str, set[int]] = {}
        self._covered: dict[Path, None] = {}
        self._waiting: list[_Waiting] = []
        self._known: dict[tuple[Path, Target], None] = {}
        self._names: dict[Path, Path] = {}
        self._across = _AcrossPrograms()
        self._suppressions: dict[str, Suppressions] = {}

    def check(self, inputs: Sequence[str | Path | NcText]) -> CheckResult:
        texts = [item for item in inputs if isinstance(item, NcText)]
        paths = [Path(item) for item in inputs if not isinstance(item, NcText)]
        gathered = gather(paths, self._access, self._found)
        for startup, folder in gathered.machines:
            self._machine(startup, folder)
        unusual = []
        for path in gathered.lists:
            if path.resolve() not in self._covered and is_startup_list(path, self._access):
                self._machine(path, None)
                unusual.append(path.as_posix())
        for path in gathered.lists:
            if path.resolve() not in self._covered:
                self._list(path)
        self._names = {path.resolve(): path for path in gathered.programs}
        first_of = {path.resolve().parent: path for path in gathered.programs}
        for path in first_of.values() if not self._for_all else ():
            self._machine_of(path)
        if texts and not self._for_all:
            self._machine_of(None)
        for path in gathered.programs:
            self._queue(path, self._targets.of(path), "either")
        for text in texts:
            for target in self._targets.of(None):
                self._program(text.name, split_lines(text.text), target, "either")
        self._programs()
        for project in gathered.plc:
            self._plc(project)
        self._report_subprogram_ends(
            [path for path in paths if path.is_file()], [text.name for text in texts]
        )
        collector = Collector()
        self._across.report(collector)
        self._keep("", collector.diagnostics)
        files = tuple(CheckedFile(file, kind) for file, kind in sorted(self._files.items()))
        machines = tuple(startup.parent.as_posix() for startup, _ in gathered.machines)
        machines += tuple(unusual)
        folders = self._targets.folders
        around = tuple(path.as_posix() for path in self._around if path.parent in folders)
        found = self._unsuppressed(_ordered(self._found, self._channels))
        settings = tuple(item for item in self._settings if item.path in self._targets.assigned)
        return CheckResult(files, found, machines, self._targets.uses_default, around, settings)

    def _unsuppressed(self, found: tuple[Finding, ...]) -> tuple[Finding, ...]:
        """Return the findings that no comment of their file suppresses, in the same order."""
        for file, kind in self._files.items():
            if kind != PROGRAM and file.casefold().endswith(LIST_SUFFIX):
                with contextlib.suppress(Failure):  # an unreadable list has been reported
                    source = Source(file, self._access.read_lines(Path(file)))
                    self._suppressions[file] = read_suppressions(source, is_list=True)
        marked = {
            file: comments
            for file, comments in self._suppressions.items()
            if comments.items or comments.diagnostics
        }
        if not marked:
            return found
        self._found = [item for item in found if item.file not in marked]
        for file, comments in marked.items():
            of_file = [item for item in found if item.file == file]
            channels = {id(item.diagnostic): item.channels for item in of_file}
            left = apply(comments, [item.diagnostic for item in of_file])
            for message in left:
                self._found.append(Finding(file, message, channels.get(id(message), ())))
        return tuple(sorted(self._found, key=_key))

    def _keep(
        self, file: str, diagnostics: Sequence[Diagnostic], channels: tuple[int, ...] = ()
    ) -> None:
        for message in diagnostics:
            self._found.append(
                Finding(file if message.span is None else message.span.file, message, channels)
            )

    def _read(self, path: Path) -> bytes | None:
        """Return the bytes of a text file; ``None`` with a report for any other file."""
        try:
            data = self._access.read_bytes(path)
        except Failure as failure:
            self._keep(path.as_posix(), failure.diagnostics)
            return None
        return data if self._is_text(path, data[:BEGIN_BYTES]) else None

    def _lines(self, path: Path) -> Sequence[str] | None:
        """Return the lines of a program of any length; ``None`` as in the method before."""
        if not path.is_file():  # a pipe can be read only once
            data = self._read(path)
            if data is None:
                return None
            self._report_mark(path, data)
            return split_lines(decode_text(data).text)
        try:
            begin = self._access.read_begin(path)
            self._report_mark(path, begin)
            return self._access.read_lines(path) if self._is_text(path, begin) else None
        except Failure as failure:
            self._keep(path.as_posix(), failure.diagnostics)
            return None

    def _report_mark(self, path: Path, begin: bytes) -> None:
        if begin.startswith(BYTE_ORDER_MARKS):
            file = path.as_posix()
            self._keep(file, [diagnostic(BYTE_ORDER_MARK, Span(file, 1, 1, 2))])

    def _is_text(self, path: Path, begin: bytes) -> bool:
        """Return False and report if the file is binary, judged by its first bytes."""
        if b"\0" not in begin or begin.startswith(_UTF16_MARKS):
            return True
        number = FILE_ENCRYPTED if path.suffix.casefold() == _ENCRYPTED_SUFFIX else NOT_A_TEXT_FILE
        self._keep(path.as_posix(), [diagnostic(number, file=path.as_posix())])
        return False

    # --- lists -----------------------------------------------------------------------------------

    def _machine(self, startup: Path, folder: Path | None) -> None:
        """Check a start-up list, found in ``folder``, with all lists that it names."""
        self._covered[startup.resolve()] = None
        self._files[startup.as_posix()] = "startup"
        try:
            machine = load_startup(
                startup, folder, self._root, self._access, detail=self._detail, rtconf=self._rtconf
            )
        except Failure as error:
            self._keep(startup.as_posix(), error.diagnostics)
            return
        for kind, path in machine.lists:
            self._covered[path.resolve()] = None
            self._files[path.as_posix()] = kind
        self._keep(startup.as_posix(), machine.diagnostics)
        self._targets.add(machine)

    def _machine_of(self, program: Path | None) -> None:
        """The machine named by the project of a program, else the one around the program.

        ``None``: a text, which belongs to the project of the working directory.
        """
        try:
            project = find_project(Path() if program is None else program, self._access)
        except Failure as failure:
            self._keep("", failure.diagnostics)
            return
        if project is not None and project.machine is not None:
            self._machine_of_setting(program, choose_machine(program, project, self._access))
        elif program is not None:
            self._machine_around(program)

    def _machine_of_setting(self, program: Path | None, choice: MachineChoice) -> None:
        """Load the machine that a setting names, and report only the errors of its lists."""
        if choice not in self._settings:
            self._settings[choice] = None
            try:
                machine = load_machine(
                    choice.path, root=self._root, rtconf=self._rtconf, access=self._access
                )
            except Failure as error:
                self._keep(choice.path.as_posix(), error.diagnostics)
                return
            errors = [item for item in machine.diagnostics if item.severity is Severity.ERROR]
            self._keep(choice.path.as_posix(), errors)
            self._targets.assign(choice.path, machine)
        self._targets.use(choice.path, None if program is None else program.resolve().parent)

    def _machine_around(self, program: Path) -> None:
        """Load the machine in whose folder a program lies; report only errors of its lists."""
        startup = startup_list_around(program)
        if startup is None or startup.resolve() in self._covered or startup in self._around:
            return
        self._around[startup] = None
        try:
            machine = load_startup(startup, None, self._root, self._access, rtconf=self._rtconf)
        except Failure as error:
            self._keep(startup.as_posix(), error.diagnostics)
            return
        errors = [message for message in machine.diagnostics if message.severity is Severity.ERROR]
        self._keep(startup.as_posix(), errors)
        self._targets.add(machine)

    def _list(self, path: Path) -> None:
        """Check a single list; its kind is that of most of its entries."""
        data = self._read(path)
        if data is None:
            return
        position = Span(path.as_posix(), 1, 1, 2)
        schema = kind_of(path.name, data)
        if schema is None:
            titles = [known_schema.title for known_schema in SCHEMAS]
            unknown = diagnostic(
                LIST_KIND_NOT_RECOGNISED,
                position,
                kinds=Text(
                    ", ".join(title.en for title in titles),
                    ", ".join(title.de for title in titles),
                ),
            )
            self._keep(path.as_posix(), [unknown])
            return
        self._files[path.as_posix()] = schema.kind
        collector = Collector()
        collector.report(LIST_CHECKED_ALONE, position, kind=schema.title)
        check_list_alone(schema, path, data, collector, detail=self._detail, rtconf=self._rtconf)
        self._keep(path.as_posix(), collector.diagnostics)

    # --- PLC -------------------------------------------------------------------------------------

    def _plc(self, project: PlcInput) -> None:
        """Check a project of a PLC, or loose files of one."""
        collector = Collector()
        own = self._libraries(project.paths[0])
        programs = inspect_paths(project.paths, self._read, collector, own.read)
        machine = self._machine_of_plc(project.paths[0])
        for program in programs:
            if machine is not None:
                report_interface_uses(program, machine, collector)
        only = {path.resolve() for path in project.only}
        names = {path.resolve(): path.as_posix() for path in project.only}
        for path in project.paths:
            if not only:
                self._files[path.as_posix()] = PLC
        for program in programs:
            for file in program.files:
                name = names.get(Path(file).resolve(), file)
                if not only or name in names.values():
                    self._files[name] = PLC
        for found in collector.diagnostics:
            file = "" if found.span is None else found.span.file
            if not only or Path(file).resolve() in only:
                self._keep(file, [found])

    def _machine_of_plc(self, path: Path) -> Machine | None:
        """Return the machine of a PLC, if the check knows it: one named by the user."""
        if self._for_all:
            return self._default_machine
        with contextlib.suppress(Failure):
            project = find_project(path, self._access)
            if project is not None and project.machine is not None:
                choice = choose_machine(path, project, self._access)
                return load_machine(
                    choice.path, root=self._root, rtconf=self._rtconf, access=self._access
                )
        return None

    def _libraries(self, path: Path) -> ProjectLibraries:
        """Return the libraries of a PLC, as its project file names them."""
        try:
            project = find_project(path, self._access)
        except Failure as failure:
            for found in failure.diagnostics:
                self._keep("" if found.span is None else found.span.file, [found])
            return ProjectLibraries()
        return libraries_of(project)

    # --- programs --------------------------------------------------------------------------------

    def _report_subprogram_ends(self, files: Sequence[Path], texts: Sequence[str]) -> None:
        """Report programs named by the user that end as subprograms and that nothing calls."""
        names = [path.as_posix() for path in files if path.resolve() not in self._across.called]
        for name in (*names, *texts):
            if name in self._across.subprogram_ends:
                self._keep(name, [self._across.subprogram_ends[name]])

    def _queue(self, path: Path, targets: Sequence[Target], role: Role) -> None:
        """Queue a program for a check, once for each channel, by the name of the user's input."""
        key = path.resolve()
        new = tuple(target for target in targets if (key, target) not in self._known)
        if new:
            self._known.update(((key, target), None) for target in new)
            self._waiting.append(_Waiting(self._names.get(key, path), new, role))

    def _programs(self) -> None:
        """Check the queued programs, and those that they call."""
        while self._waiting:
            program = self._waiting.pop(0)
            lines = self._lines(program.path)
            if lines is None:
                continue
            for target in program.targets:
                self._program(program.path.as_posix(), lines, target, program.role)

    def _program(self, name: str, lines: Sequence[str], target: Target, role: Role) -> None:
        memory = None if self._memory is None else self._memory.of_file(name)
        if name not in self._suppressions:
            marked = None if memory is None else memory.suppressions.of(lines)
            self._suppressions[name] = read_suppressions(Source(name, lines), marked=marked)
        self._files[name] = PROGRAM
        self._channels.setdefault(name, set()).add(target.channel)
        collector = Collector()
        checked = check_program(
            Source(name, lines),
            target.for_program(role),
            collector,
            target.folder,
            access=self._access,
            poll=self._poll,
            memory=memory,
        )
        self._across.global_cycles.append(checked.global_cycles)
        self._across.uses.append(
            ProgramUses(
                name,
                target.folder,
                target.channel,
                target.channel_count,
                target.owners,
                {axis: one.logical_number for axis, one in target.axes.items()},
                checked.signals,
                checked.exchanges,
                role != "called" and checked.subprogram_end is None,
            )
        )
        self._across.linked.append(
            LinkedProgram(
                Path(name).resolve(),
                [path.resolve() for path in checked.called],
                checked.cycles,
                role != "called" and checked.subprogram_end is None and checked.is_complete,
                not checked.is_complete and role == "called",
            )
        )
        collector.diagnostics += self._script(name, checked, target)
        self._keep(name, collector.diagnostics, (target.channel,))
        if checked.subprogram_end is not None:
            self._across.subprogram_ends[name] = checked.subprogram_end
        for path in checked.called:
            self._across.called[path.resolve()] = None
            is_input = path.resolve() in self._names
            self._queue(path, (target,), "either" if is_input else "called")

    def _script(self, name: str, checked: Checked, target: Target) -> Iterator[Diagnostic]:
        """Keep the expectations in a program's comments; return those that no run could meet."""
        expected = checked.script.expectations
        self._across.scripted.append(
            ScriptedProgram(
                Path(name).resolve(),
                [one for one in expected if one.kind == "fired" and one.about is not None],
                checked.branch_lines,
                [path.resolve() for path in checked.called],
                checked.has_all_files,
            )
        )
        return impossible_inputs(checked.script, Path(name), target.machine, self._access)


def _ordered(findings: Sequence[Finding], channels: Mapping[str, set[int]]) -> tuple[Finding, ...]:
    """Return each finding once, in the order of file, line, column, number.

    ``channels``: file -> the channels for which it was checked; a diagnostic for all has none.
    """
    first: dict[_Key, Finding] = {}
    concerned: dict[_Key, set[int]] = {}
    for item in findings:
        first.setdefault(_key(item), item)
        concerned.setdefault(_key(item), set()).update(item.channels)
    return tuple(
        replace(first[key], channels=_named(concerned[key], channels.get(first[key].file, set())))
        for key in sorted(first)
    )


def _named(concerned: set[int], checked: set[int]) -> tuple[int, ...]:
    return () if concerned == checked else tuple(sorted(concerned))


def _key(finding: Finding) -> _Key:
    message = finding.diagnostic
    line, column = (0, 0) if message.span is None else (message.span.line, message.span.column)
    return finding.file, line, column, message.id, message.text()

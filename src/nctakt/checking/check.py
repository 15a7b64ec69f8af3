# SPDX-License-Identifier: MIT
"""What there is to check -> every diagnostic, in one order.

In: files, folders, texts, and the machine that programs shall run on. Out: ``CheckResult``. Nothing
is executed, and one file's mistakes keep no other from being checked. Beyond the errors of programs
what is likely meant otherwise is found (``nc/lint``).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Severity, Span, Text
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text, split_lines
from nctakt.checking.inputs import Found, gather
from nctakt.checking.program import check_program
from nctakt.checking.targets import Target, Targets
from nctakt.files.access import BEGIN_BYTES
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.declared.startup import STARTUP
from nctakt.lists.format.without_effect import Detail
from nctakt.lists.machine.files import startup_list_around
from nctakt.lists.machine.list_kinds import check_list_alone, kind_of
from nctakt.lists.machine.machine import load_startup
from nctakt.lists.machine.scheduling_profile import STANDARD_OPTIONS, RtconfOptions
from nctakt.messages import Collector, diagnostic
from nctakt.messages.checking import (
    FILE_ENCRYPTED,
    LIST_CHECKED_ALONE,
    LIST_KIND_NOT_RECOGNISED,
    NOT_A_TEXT_FILE,
)
from nctakt.nc.check.blocks import Role
from nctakt.nc.lint.linter import GlobalCycles, never_deleted
from nctakt.nc.source import Source
from nctakt.run.assembly import AssembledMachine
from nctakt.run.program_loader import NcText

#: The kind of a program; lists have the kinds of their schemas (``channel``, ``axis``, …).
PROGRAM = "program"

_UTF16_MARKS = (b"\xff\xfe", b"\xfe\xff")
_ENCRYPTED_SUFFIX = ".ecy"


_Key = tuple[str, int, int, int, str]


@dataclass(frozen=True, slots=True)
class CheckedFile:
    """A file that was checked, and as what."""

    file: str
    kind: str


@dataclass(frozen=True, slots=True)
class CheckResult:
    """All files that were checked, by name; all that was found, by file, line, column, number.

    ``machines``: the folders with a start-up list. ``takes_default``: some program was checked for
    the machine that was given, since it belongs to none of these. ``around``: the start-up lists
    of the machines in whose folders programs lie that were named without the machine.
    """

    files: tuple[CheckedFile, ...]
    found: tuple[Found, ...]
    machines: tuple[str, ...] = ()
    takes_default: bool = False
    around: tuple[str, ...] = ()

    def count(self, severity: Severity) -> int:
        """How many findings of one severity there are."""
        return sum(one.diagnostic.severity is severity for one in self.found)


def check_files(
    inputs: Sequence[str | Path | NcText],
    machine: AssembledMachine,
    *,
    detail: Detail = "summary",
    root: Path | None = None,
    for_all: bool = True,
    rtconf: RtconfOptions = STANDARD_OPTIONS,
) -> CheckResult:
    """Check files, folders with all that is in them, texts, and the files that programs call.

    ``detail``: how much is reported of list entries without effect. ``root``: another folder where
    the files are searched that lists name. ``for_all``: all programs are for ``machine``, even
    those in the folder of another one. ``rtconf``: how scheduling lists are read. What cannot be
    read is a diagnostic as well; no file checked at all leaves ``files`` empty.
    """
    return _Checker(machine, detail, root, for_all, rtconf).check(inputs)


@dataclass(frozen=True, slots=True)
class _Waiting:
    """A program that is still to be checked; it is read once for all its channels."""

    path: Path
    targets: tuple[Target, ...]
    role: Role


class _Checker:
    """Gathers files and diagnostics of one call."""

    def __init__(
        self,
        machine: AssembledMachine,
        detail: Detail,
        root: Path | None,
        for_all: bool,
        rtconf: RtconfOptions,
    ) -> None:
        self._targets = Targets(machine, for_all)
        self._access = machine.file_access
        self._detail = detail
        self._rtconf = rtconf
        self._root = root
        self._for_all = for_all
        self._files: dict[str, str] = {}
        self._found: list[Found] = []
        self._around: dict[Path, None] = {}
        self._channels: dict[str, set[int]] = {}
        self._covered: dict[Path, None] = {}
        self._waiting: list[_Waiting] = []
        self._known: dict[tuple[Path, Target], None] = {}
        self._names: dict[Path, Path] = {}
        self._global_cycles: list[GlobalCycles] = []

    def check(self, inputs: Sequence[str | Path | NcText]) -> CheckResult:
        texts = [one for one in inputs if isinstance(one, NcText)]
        paths = [Path(one) for one in inputs if not isinstance(one, NcText)]
        gathered = gather(paths, self._access, self._found)
        for startup, folder in gathered.machines:
            self._machine(startup, folder)
        for path in gathered.lists:
            if path.resolve() not in self._covered and self._is_startup(path):
                self._machine(path, None)
        for path in gathered.lists:
            if path.resolve() not in self._covered:
                self._list(path)
        self._names = {path.resolve(): path for path in gathered.programs}
        first_of = {path.resolve().parent: path for path in gathered.programs}
        for path in first_of.values() if not self._for_all else ():
            self._machine_around(path)
        for path in gathered.programs:
            self._want(path, self._targets.of(path), "either")
        for text in texts:
            for target in self._targets.of(None):
                self._program(text.name, split_lines(text.text), target, "either")
        self._programs()
        collector = Collector()
        never_deleted(self._global_cycles, collector)
        self._keep("", collector.diagnostics)
        files = tuple(CheckedFile(file, kind) for file, kind in sorted(self._files.items()))
        machines = tuple(startup.parent.as_posix() for startup, _ in gathered.machines)
        taken = self._targets.taken
        around = tuple(one.as_posix() for one in self._around if one.parent in taken)
        found = _ordered(self._found, self._channels)
        return CheckResult(files, found, machines, self._targets.took_default, around)

    def _keep(
        self, file: str, diagnostics: Sequence[Diagnostic], channels: tuple[int, ...] = ()
    ) -> None:
        for one in diagnostics:
            self._found.append(Found(file if one.span is None else one.span.file, one, channels))

    def _read(self, path: Path) -> bytes | None:
        """The bytes of a file of text; ``None`` where there are none, which is reported."""
        try:
            data = self._access.read_bytes(path)
        except Failure as failure:
            self._keep(path.as_posix(), failure.diagnostics)
            return None
        return data if self._is_text(path, data[:BEGIN_BYTES]) else None

    def _lines(self, path: Path) -> Sequence[str] | None:
        """Return the lines of a program, however long it is; ``None`` as above."""
        if not path.is_file():  # what a pipe gives comes only once
            data = self._read(path)
            return None if data is None else split_lines(decode_text(data).text)
        try:
            begin = self._access.read_begin(path)
            return self._access.read_lines(path) if self._is_text(path, begin) else None
        except Failure as failure:
            self._keep(path.as_posix(), failure.diagnostics)
            return None

    def _is_text(self, path: Path, begin: bytes) -> bool:
        """Return whether a file is no binary one, by its first bytes; reported if it is."""
        if b"\0" not in begin or begin.startswith(_UTF16_MARKS):
            return True
        number = FILE_ENCRYPTED if path.suffix.casefold() == _ENCRYPTED_SUFFIX else NOT_A_TEXT_FILE
        self._keep(path.as_posix(), [diagnostic(number, file=path.as_posix())])
        return False

    # --- lists -----------------------------------------------------------------------------------

    def _machine(self, startup: Path, folder: Path | None) -> None:
        """A start-up list, found in ``folder``, with all lists that it names."""
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

    def _machine_around(self, program: Path) -> None:
        """The machine in whose folder a program lies; only errors of its lists are told."""
        startup = startup_list_around(program)
        if startup is None or startup.resolve() in self._covered or startup in self._around:
            return
        self._around[startup] = None
        try:
            machine = load_startup(startup, None, self._root, self._access, rtconf=self._rtconf)
        except Failure as error:
            self._keep(startup.as_posix(), error.diagnostics)
            return
        errors = [one for one in machine.diagnostics if one.severity is Severity.ERROR]
        self._keep(startup.as_posix(), errors)
        self._targets.add(machine)

    def _is_startup(self, path: Path) -> bool:
        """Return whether a list is a start-up list, whatever its name."""
        try:
            return kind_of(path.name, self._access.read_bytes(path)) is STARTUP
        except Failure:
            return False

    def _list(self, path: Path) -> None:
        """A list by itself: its kind is that of most of its entries."""
        data = self._read(path)
        if data is None:
            return
        place = Span(path.as_posix(), 1, 1, 2)
        schema = kind_of(path.name, data)
        if schema is None:
            titles = [one.title for one in SCHEMAS]
            unknown = diagnostic(
                LIST_KIND_NOT_RECOGNISED,
                place,
                kinds=Text(
                    ", ".join(title.en for title in titles),
                    ", ".join(title.de for title in titles),
                ),
            )
            self._keep(path.as_posix(), [unknown])
            return
        self._files[path.as_posix()] = schema.kind
        collector = Collector()
        collector.report(LIST_CHECKED_ALONE, place, kind=schema.title)
        check_list_alone(schema, path, data, collector, detail=self._detail, rtconf=self._rtconf)
        self._keep(path.as_posix(), collector.diagnostics)

    # --- programs --------------------------------------------------------------------------------

    def _want(self, path: Path, targets: Sequence[Target], role: Role) -> None:
        """Check a program, once for each channel; by its own name where the user has named it."""
        key = path.resolve()
        new = tuple(one for one in targets if (key, one) not in self._known)
        if new:
            self._known.update(((key, one), None) for one in new)
            self._waiting.append(_Waiting(self._names.get(key, path), new, role))

    def _programs(self) -> None:
        """The programs that wait, and those that they call."""
        while self._waiting:
            one = self._waiting.pop(0)
            lines = self._lines(one.path)
            if lines is None:
                continue
            for target in one.targets:
                self._program(one.path.as_posix(), lines, target, one.role)

    def _program(self, name: str, lines: Sequence[str], target: Target, role: Role) -> None:
        self._files[name] = PROGRAM
        self._channels.setdefault(name, set()).add(target.channel)
        collector = Collector()
        checked = check_program(
            Source(name, lines),
            target.names,
            target.parameters,
            target.limits,
            collector,
            target.folder,
            access=self._access,
            tools=target.tools,
            role=role,
        )
        self._global_cycles.append(checked.global_cycles)
        self._keep(name, collector.diagnostics, (target.channel,))
        for path in checked.called:
            named = path.resolve() in self._names
            self._want(path, (target,), "either" if named else "called")


def _ordered(found: Sequence[Found], channels: Mapping[str, set[int]]) -> tuple[Found, ...]:
    """Return each finding once, in the order of file, line, column, number.

    ``channels``: file -> the channels for which it was checked. What all of them share names none.
    """
    first: dict[_Key, Found] = {}
    concerned: dict[_Key, set[int]] = {}
    for one in found:
        first.setdefault(_key(one), one)
        concerned.setdefault(_key(one), set()).update(one.channels)
    return tuple(
        replace(first[key], channels=_named(concerned[key], channels.get(first[key].file, set())))
        for key in sorted(first)
    )


def _named(concerned: set[int], checked: set[int]) -> tuple[int, ...]:
    return () if concerned == checked else tuple(sorted(concerned))


def _key(found: Found) -> _Key:
    one = found.diagnostic
    line, column = (0, 0) if one.span is None else (one.span.line, one.span.column)
    return found.file, line, column, one.id, one.text()

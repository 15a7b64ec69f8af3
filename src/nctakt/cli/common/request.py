# SPDX-License-Identifier: MIT
"""The options of a command that runs programs -> the request to the controller.

In: ``Options``, the options as text. Out: ``Request``, or one ``Failure`` with all mistakes.
"""

from __future__ import annotations

import errno
import os
import shlex
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar, cast

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.base.failure import Failure
from nctakt.cli.common.file_options import read_standard_input
from nctakt.files.access import FileAccess, missing_file
from nctakt.lists.machine.files import machine_folder
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import RECORDING_WITHOUT_TRACE
from nctakt.messages.files import (
    FILE_NOT_READABLE,
    FOLDER_INSTEAD_OF_PROGRAM,
    NEITHER_FOLDER_NOR_LIST,
    STDIN_NAMED_TWICE,
)
from nctakt.messages.machines.folders import INVALID_CHANNEL_NUMBER, NO_PROGRAM_NAMED
from nctakt.messages.plcs.plc import PLC_AND_HLI_OPTIONS
from nctakt.messages.programs.block_search import BOTH_STARTS_GIVEN
from nctakt.run.option_kinds import split_names
from nctakt.run.options import BY_NAME, READ_NAMES

if TYPE_CHECKING:
    from nctakt.plc import AnyPlc
    from nctakt.project.project_file import FmuSettings
    from nctakt.run.access.tape import Tape
    from nctakt.run.controller import NcText
    from nctakt.run.options import ProgramOptions, RunKeywords
    from nctakt.run.plcs.coupling import Coupled

#: Means standard input in place of a program.
STANDARD_INPUT = "-"

#: The name of that program in messages and on tapes.
STANDARD_INPUT_NAME = "<stdin>"

_P = ParamSpec("_P")
_T = TypeVar("_T")


@dataclass(frozen=True, slots=True, kw_only=True)
class Options:
    """The words of the command line with the settings of the project; ``None``: not given.

    ``machine_note`` says which setting names the machine. ``run``: the words of the options of
    ``Controller.run`` by name.
    """

    programs: tuple[str, ...]
    others: tuple[tuple[str, str], ...] = ()
    machine: str | None
    machine_note: Diagnostic | None = None
    root: str | None = None
    plcs: tuple[str, ...] = ()
    fmu: FmuSettings | None = None
    run: Mapping[str, Any]
    trace: str | None = None
    plot: str | None = None
    vcd: str | None = None
    fst: str | None = None
    perfetto: str | None = None
    signals: str | None = None
    project_signals: tuple[str, ...] | None = None
    diagnosis: str | None = None
    error_log: str | None = None
    messages: str | None = None
    language: Language
    compiled: bool | None
    hli: str | None = None
    rtconf: str | None = None
    load: str | None = None
    system: str | None = None
    quiet: bool = False
    form: str = "text"
    limit_fails: bool = False
    confined: tuple[str, ...] = ()
    record: str | None = None
    retain: str | None = None
    tape: Tape | None = None

    @property
    def plc(self) -> str | None:
        """The file of the PLC where there is one at most."""
        return next(iter(self.plcs), None)


@dataclass(frozen=True, slots=True)
class Request:
    """The request to the controller; ``signals`` ``None``: its default.

    ``programs`` are those of channel 1, ``channels`` those of the others.
    """

    programs: tuple[Path | NcText, ...]
    channels: dict[int, tuple[Path | NcText, ...]]
    options: RunKeywords
    signals: tuple[str, ...] | None
    plc: AnyPlc | None
    fmu: Coupled | None = None

    @property
    def session_options(self) -> ProgramOptions:
        """The options that a session accepts."""
        given = cast("Mapping[str, Any]", self.options)
        return cast("ProgramOptions", {name: given[name] for name in READ_NAMES})


class _Reader:
    """Reads the options one by one and gathers the mistakes."""

    def __init__(self) -> None:
        self.diagnostics: list[Diagnostic] = []

    def read(
        self, function: Callable[_P, _T], *words: _P.args, **keywords: _P.kwargs
    ) -> tuple[_T, ...]:
        """Return the result of ``function`` in a tuple, an empty one after a ``Failure``."""
        try:
            return (function(*words, **keywords),)
        except Failure as failure:
            self.diagnostics.extend(failure.diagnostics)
            return ()


def read_request(options: Options, access: FileAccess) -> Request:
    """Return the request of the options; raises one ``Failure`` with all mistakes.

    ``access`` notes the named files.
    """
    reader = _Reader()
    words = (*options.programs, *(program for _, program in options.others))
    texts = {} if options.tape is None else options.tape.texts
    if not words and not options.run["stays"]:
        reader.diagnostics.append(diagnostic(NO_PROGRAM_NAMED))
    if words.count(STANDARD_INPUT) > 1:
        reader.diagnostics.append(diagnostic(STDIN_NAMED_TWICE))
    for program in dict.fromkeys(word for word in words if word not in texts):
        reader.read(_check_program, program, access)
    numbers = [reader.read(_channel_number, number) for number, _ in options.others]
    if options.machine is not None:
        reader.read(_check_machine, machine_folder(options.machine))
        reader.read(access.check_admitted, machine_folder(options.machine))
    run = options.run
    read: dict[str, Any] = {}
    for name, word in run.items():
        for value in reader.read(BY_NAME[name].kind.from_words, word):
            read[name] = value
    plc = reader.read(_load_plcs, options.plcs, access) if options.plcs else ()
    fmu = () if options.fmu is None else reader.read(_load_fmu, options.fmu, access)
    if run["from_line"] is not None and run["from_block"] is not None:
        reader.diagnostics.append(diagnostic(BOTH_STARTS_GIVEN))
    if options.plc is not None and options.hli is not None:
        reader.diagnostics.append(diagnostic(PLC_AND_HLI_OPTIONS))
    signals = None if options.signals is None else split_names(options.signals)
    is_drawn = any((options.plot, options.vcd, options.fst, options.perfetto))
    is_traced = options.trace is not None
    for option, is_lost in (
        ("--signals", signals is not None and not is_traced and not is_drawn),
        ("--blocks", run["blocks"] and options.tape is None and not is_traced),
    ):
        if is_lost:
            reader.diagnostics.append(diagnostic(RECORDING_WITHOUT_TRACE, option=option))
    if reader.diagnostics:
        raise Failure(*reader.diagnostics)
    if signals is None and (is_traced or is_drawn):
        signals = options.project_signals
    programs: dict[int, list[Path | NcText]] = {
        1: [_program(item, options) for item in options.programs]
    }
    for (number,), (_, program) in zip(numbers, options.others, strict=True):
        programs.setdefault(number, []).append(_program(program, options))
    return Request(
        tuple(programs.pop(1)),
        {number: tuple(own) for number, own in programs.items()},
        cast("RunKeywords", read),
        signals,
        next(iter(plc), None),
        next(iter(fmu), None),
    )


def _channel_number(text: str) -> int:
    if not (text.isascii() and text.isdigit()):
        raise Failure(diagnostic(INVALID_CHANNEL_NUMBER, text=text))
    return int(text)


def _check_program(program: str, access: FileAccess) -> None:
    """Raise ``Failure`` for an unreadable program; a pipe is not read, which works only once."""
    if program == STANDARD_INPUT:
        return
    access.note(program)
    if not Path(program).exists():
        raise Failure(missing_file(Path(program)))
    if Path(program).is_dir():
        raise Failure(diagnostic(FOLDER_INSTEAD_OF_PROGRAM, folder=shlex.quote(program)))
    if not os.access(program, os.R_OK):
        reason = os.strerror(errno.EACCES)
        raise Failure(diagnostic(FILE_NOT_READABLE, file=program, reason=reason))


def _check_machine(path: Path) -> None:
    """Raise ``Failure`` unless there is a folder or start-up list of this name."""
    if not path.exists():
        raise Failure(missing_file(path))
    if not path.is_dir() and path.suffix.casefold() not in {".lis", ".xml"}:
        raise Failure(diagnostic(NEITHER_FOLDER_NOR_LIST, folder=str(path)))


def _program(program: str, options: Options) -> Path | NcText:
    texts = {} if options.tape is None else options.tape.texts
    if program != STANDARD_INPUT and program not in texts:
        return Path(program)
    from nctakt.run.controller import NcText  # noqa: PLC0415 - the mode is chosen before its import

    if program in texts:
        return NcText(program, texts[program])
    return NcText(STANDARD_INPUT_NAME, read_standard_input())


def _load_fmu(settings: FmuSettings, access: FileAccess) -> Coupled:
    """Return the FMU coupled to the PLC; raises ``Failure``."""
    from nctakt.fmu.coupled import fmu_of  # noqa: PLC0415 - the mode is chosen before its import

    assert settings.file is not None
    access.note(settings.file)
    return fmu_of(settings, access)


def _load_plcs(paths: Sequence[str], access: FileAccess) -> AnyPlc | None:
    from nctakt.plc.loading import load_plcs  # noqa: PLC0415 - the mode is chosen before its import
    from nctakt.run.plcs.realtime_plc import files_of  # noqa: PLC0415 - as above

    for path in paths:
        access.note(path)
    plc = load_plcs(paths)
    for file in files_of(plc):
        access.note(file)
    return plc

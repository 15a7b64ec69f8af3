# SPDX-License-Identifier: MIT
"""The common part of the commands that run programs: options, mode, the run itself.

In: ``Options`` and ``Request``. Out: ``Run``. A command adds ``run_options`` to its own options,
chooses the mode before anything of the realtime part is imported, and runs.
"""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar, Unpack

from nctakt.base.diagnostics import Language, Severity, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN
from nctakt.cli.common.options import ISOLATE_OPTION, MODE_OPTION, TRUST_OPTION, table_options
from nctakt.cli.common.request import Options, Request
from nctakt.cli.common.terminal import InterruptRequest, ProgressBar, print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.commands.checking import NOTES_OF_LISTS
from nctakt.messages.commands.command_line import (
    COMPILED_PART_MISSING,
    RUN_NOT_ENDED,
    RUNNING_UNCOMPILED,
)
from nctakt.messages.scheduling.scheduled_runs import OPTION_WITHOUT_SCHEDULE

if TYPE_CHECKING:
    from nctakt.lists.machine.machine import Machine
    from nctakt.results.run import ProgramMessage, Run
    from nctakt.run.controller import Controller
    from nctakt.run.options import RunKeywords
    from nctakt.schedule.open_schedule import RunSchedule

_Command = TypeVar("_Command", bound=Callable[..., Any])


#: The exit codes of commands that run programs.
RUN_CODES = (
    Text(
        "success (also at a limit, unless --limit-fails)",
        "Erfolg (auch an einer Grenze, außer mit --limit-fails)",
    ),
    Text(
        "an NC error, a program that waits forever where no limit is set, or Ctrl-C",
        "ein NC-Fehler, ein Programm, das ohne gesetzte Grenze endlos wartet, oder Strg-C",
    ),
)

#: A note of commands that run programs.
TIMES_NOTE = Text(
    "Times are numbers with us, ms, s, min, h or ticks ('300 ticks'); a plain number means "
    "seconds.",
    "Zeiten sind Zahlen mit us, ms, s, min, h oder ticks ('300 ticks'); eine Zahl allein "
    "bedeutet Sekunden.",
)


def run_options(command: str) -> Callable[[_Command], _Command]:
    """Return a decorator with the options of a command that runs programs."""

    def decorate(function: _Command) -> _Command:
        return table_options(command)(ISOLATE_OPTION(TRUST_OPTION(MODE_OPTION(function))))

    return decorate


def choose_mode(options: Options) -> None:
    """Choose compiled or plain before the realtime part is imported."""
    from nctakt.base import mode  # noqa: PLC0415 - help does not need it

    if options.compiled is False:
        mode.use_plain()
    elif not mode.is_compiled():
        if options.compiled:
            raise Failure(diagnostic(COMPILED_PART_MISSING))
        requested = os.environ.get("NCTAKT_PLAIN") == "1"
        if not options.quiet and not requested:
            print_diagnostics([diagnostic(RUNNING_UNCOMPILED)], options.language)


def start_controller(options: Options, access: FileAccess) -> Controller:
    """Return a controller of the machine; a note says which, if no word names it."""
    from nctakt.lists.machine.machine import load_machine  # noqa: PLC0415 - as below
    from nctakt.run.controller import Controller  # noqa: PLC0415 - the mode is chosen before

    if options.machine_note is not None and not options.quiet:
        print_diagnostics([options.machine_note], options.language)
    machine: Machine | str | None = options.machine
    if options.root is not None:
        machine = load_machine(options.machine, root=options.root, access=access)
    return Controller(machine, schedule_of(options, access), access)


def schedule_of(options: Options, access: FileAccess) -> RunSchedule | None:
    """Return the schedule of the options, ``None`` without one; raises ``Failure``."""
    if options.rtconf is None:
        for option, word in (("--load", options.load), ("--os", options.system)):
            if word is not None:
                raise Failure(diagnostic(OPTION_WITHOUT_SCHEDULE, option=option))
        return None
    from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions  # noqa: PLC0415
    from nctakt.schedule.open_schedule import open_schedule  # noqa: PLC0415 - as above

    profile = PROFILES[options.system or "rtx"]
    return open_schedule(options.rtconf, options.load, RtconfOptions(profile), access)


def _without_bar(
    bar: ProgressBar, on_message: Callable[[ProgramMessage], None] | None
) -> Callable[[ProgramMessage], None]:
    """Return a function that shows a message of a program in place of the progress bar."""

    def show(message: ProgramMessage) -> None:
        if on_message is not None:
            bar.hide()
            on_message(message)

    return show


def run_programs(
    options: Options,
    request: Request,
    controller: Controller,
    *,
    is_drawn: bool = False,
    **further: Unpack[RunKeywords],
) -> Run | None:
    """Return the result; ``None`` if the user's PLC failed, which has been reported.

    ``is_drawn``: it records all that pictures show; ``further``: what the command itself wants.
    """
    from nctakt.cli.common.comment_inputs import report_unused_inputs  # noqa: PLC0415 - as below
    from nctakt.plc.error import PlcError  # noqa: PLC0415 - the mode is chosen before

    report_unused_inputs(options, request)
    bar = ProgressBar()
    given = request.options

    def show_progress(tick: int, limit: int | None) -> None:
        interrupt.check()
        bar.update(tick, limit)

    try:
        with InterruptRequest() as interrupt:
            run_keywords: RunKeywords = {
                **given,
                "plc": request.plc,
                "fmu": request.fmu,
                "signals": request.signals,
                **further,
                "memory_trace": is_drawn,
                "why": further.get("why", False) or is_drawn,
                "on_message": _without_bar(bar, further.get("on_message")),
                "on_progress": show_progress,
                "blocks": given["blocks"] or is_drawn or further.get("blocks", False),
                "replay": options.tape,
            }
            return controller.run(*request.programs, channels=request.channels, **run_keywords)
    except PlcError as failure:
        bar.hide()
        print_diagnostics(failure.diagnostics, options.language)
        return None
    finally:
        bar.hide()


def print_findings(run: Run, machine: Machine, language: Language, lowest: Severity) -> None:
    """Show the diagnostics of a run; the notes about the machine's lists are one (902936)."""
    of_lists = {
        id(one)
        for one in machine.diagnostics
        if one.severity is Severity.NOTE and one.span is not None
    }
    shown = [one for one in run.diagnostics if id(one) not in of_lists]
    if left := len(run.diagnostics) - len(shown):
        folder = shlex.quote(machine.folder.as_posix())
        shown.insert(0, diagnostic(NOTES_OF_LISTS, count=left, folder=folder))
    print_diagnostics(shown, language, lowest)


def exit_code(options: Options, run: Run) -> int:
    """Return 1 after an error, Ctrl-C, or at a limit with ``--limit-fails``; else 0."""
    is_missed = options.limit_fails and run.state == "limit"
    stopped = is_missed or run.state in ("error", "interrupted")
    return EXIT_NC_ERROR if stopped or run.errors else EXIT_RAN


def with_limit_error(options: Options, run: Run) -> Run:
    """Return the run with an error (901016) if it reached a limit with ``--limit-fails``."""
    if not options.limit_fails or run.state != "limit":
        return run
    message = diagnostic(RUN_NOT_ENDED, time=str(Time(run.virtual_time_us)))
    return replace(run, diagnostics=(*run.diagnostics, message))


def shown_from(options: Options) -> Severity:
    """Return the lowest severity that a command with another main result shows."""
    return Severity.ERROR if options.quiet else Severity.WARNING

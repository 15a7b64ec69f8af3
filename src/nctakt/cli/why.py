# SPDX-License-Identifier: MIT
"""``nctakt why``: run NC programs and explain why reactions of realtime cycles fired or did not.

In: programs, machine, values of variables at times, limits; optionally a cycle, line and time. Out:
on standard output the end of the run and the report, on standard error diagnostics. Exit codes as
of ``nctakt run``; an unknown cycle, line or time is wrong usage.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Severity, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import FORMAT_OPTION
from nctakt.cli.common.request import Options, read_request
from nctakt.cli.common.running import (
    RUN_CODES,
    TIMES_NOTE,
    choose_mode,
    exit_code,
    print_findings,
    run_options,
    run_programs,
    start_controller,
    with_limit_error,
)
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.terminal import show_at_the_end
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import read_time
from nctakt.messages import diagnostic
from nctakt.messages.commands.explaining import MACHINE_VARIABLE_UNCHANGED
from nctakt.messages.commands.inputs import STIMULUS_WITHOUT_VALUE

if TYPE_CHECKING:
    from nctakt.results.explained.why import WhyReport
    from nctakt.results.run import Run
    from nctakt.run.controller import Controller
    from nctakt.run.options import RunKeywords


@described(
    "why",
    summary=Text(
        "Explain why reactions fired or did not.", "Erklären, warum Reaktionen kamen oder nicht."
    ),
    text=Text(
        "Run NC programs and explain why reactions of their realtime cycles fired or did not.",
        "NC-Programme ausführen und erklären, warum Reaktionen ihrer Echtzeit-Zyklen kamen oder "
        "nicht.",
    ),
    codes=RUN_CODES,
    notes=Text(
        "For each $IF: when its condition was evaluated, what it compared when it became true or "
        "false, when its body ran; if it never ran, why, and how near it came. "
        f"{TIMES_NOTE.en}",
        "Zu jedem $IF: wann seine Bedingung ausgewertet wurde, was sie verglich, als sie wahr oder "
        "falsch wurde, wann sein Rumpf lief; wenn er nie lief, warum, und wie nah sie daran war. "
        f"{TIMES_NOTE.de}",
    ),
    examples=(
        "nctakt why part.nc",
        "nctakt why part.nc --cycle 17 --line 4 --at 1.5ms V.E.VALUE=-1",
        "nctakt why part.nc --state 0.463",
        "nctakt why part.nc --plc cell.st --variable MAIN.bAlarm",
    ),
)
@run_options("why")
@FORMAT_OPTION
@option(
    "--cycle",
    metavar="ID",
    text=Text(
        "Only this realtime cycle (#1: the first without ID).",
        "Nur diesen Echtzeit-Zyklus (#1: der erste ohne ID).",
    ),
)
@option(
    "--line",
    type=click.IntRange(min=1),
    metavar="N",
    text=Text(
        "Only the $IF in this line, or around this line.",
        "Nur das $IF in dieser Zeile oder um sie herum.",
    ),
)
@option(
    "--variable",
    metavar="NAME",
    text=Text(
        "Only this variable or interface element of a PLC in Structured Text: which statement "
        "changed it, and the conditions that led there.",
        "Nur diese Variable oder dieses Schnittstellenelement einer SPS in Strukturiertem Text: "
        "welche Anweisung sie änderte, und die Bedingungen, die dahin führten.",
    ),
)
@option(
    "--state",
    metavar="TIME",
    text=Text(
        "Show the states at this time of the run.", "Die Zustände zu dieser Zeit des Laufs zeigen."
    ),
)
def command(
    cycle: str | None, line: int | None, variable: str | None, state: str | None, **words: Any
) -> int:
    """Explain reactions."""
    asked = _Asked(cycle, line, variable, state)
    return carry_out(words, lambda options, access: _why(options, access, asked))


@dataclass(frozen=True, slots=True)
class _Asked:
    """The selection of the report."""

    cycle: str | None
    line: int | None
    variable: str | None
    state: str | None

    def select(self, report: WhyReport) -> WhyReport:
        """Return the selected part of a report; raises ``Failure`` if it has no such part."""
        if self.variable is not None:
            report = report.select_plc(self.variable)
        return report.select(self.cycle, self.line)


def _why(options: Options, access: FileAccess, asked: _Asked) -> int:
    """Run and report; raises ``Failure`` for invalid options."""
    choose_mode(options)
    for time, assignment in options.run["at"]:
        if "=" not in assignment:
            raise Failure(diagnostic(STIMULUS_WITHOUT_VALUE, time=time))
    request = read_request(options, access)
    moment = None if asked.state is None else read_time(asked.state)
    controller = start_controller(options, access)
    length_us = controller.cycle_time_us
    tick = None if moment is None else moment.us(length_us) // length_us
    if tick is not None:  # later ticks are not needed
        ticks = request.options["ticks"]
        limited: RunKeywords = {**request.options, "ticks": min(tick + 1, ticks or tick + 1)}
        request = replace(request, options=limited)
        options = replace(options, limit_fails=False)
    run = run_programs(options, request, controller, why=True)
    if run is None:
        return EXIT_NC_ERROR
    run = with_limit_error(options, run)
    if asked.variable is not None and run.why is not None:
        _refuse_unwritten(asked.variable, run.why, controller)
    if options.form == "text":
        lowest = Severity.ERROR if options.quiet else Severity.NOTE
        print_findings(run, controller.machine, options.language, lowest)
    if run.ticks or options.form == "json":
        text = _report(options, run, asked, tick)
        show_at_the_end(lambda file: print(text, end="", file=file))
    return exit_code(options, run)


def _refuse_unwritten(name: str, report: WhyReport, controller: Controller) -> None:
    """Raise ``Failure`` for a variable of the machine that no PLC has written (902932)."""
    from nctakt.results.trace.events import number_text  # noqa: PLC0415 - the mode is chosen before

    if name[:2].upper() != "V." or any(one.path.upper() == name.upper() for one in report.plc):
        return
    value = controller.read(name)
    shown = value if isinstance(value, str) else number_text(value)
    raise Failure(diagnostic(MACHINE_VARIABLE_UNCHANGED, name=name, value=shown))


def _report(options: Options, run: Run, asked: _Asked, tick: int | None) -> str:
    from nctakt.cli.findings.json_documents import as_json, run_document  # noqa: PLC0415 - as below
    from nctakt.results.summary import headline  # noqa: PLC0415 - the mode is chosen before

    if run.why is None or not run.ticks:
        return as_json(run_document(run, options.language))
    report = asked.select(run.why)
    if options.form == "json":
        state = None if tick is None else report.render_at(tick, options.language).splitlines()
        return as_json(run_document(run, options.language, why=report, state_at_tick=state))
    if tick is not None:
        return report.render_at(tick, options.language)
    return f"{headline(run, options.language, None)}\n\n{report.render(options.language)}"

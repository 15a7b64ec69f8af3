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

from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR
from nctakt.cli.request import Options, read_request
from nctakt.cli.running import (
    FORMAT_OPTION,
    RUN_CODES,
    choose_mode,
    exit_code,
    run_options,
    run_programs,
    start_controller,
    with_limit_error,
)
from nctakt.cli.settings import carry_out
from nctakt.cli.terminal import print_diagnostics, show_at_the_end
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import read_time
from nctakt.messages import diagnostic
from nctakt.messages.inputs import STIMULUS_WITHOUT_VALUE

if TYPE_CHECKING:
    from nctakt.results.run import Run

_EPILOG = f"""\b
For each $IF: when its condition was evaluated, what it compared when it became
true or false, when its body ran; if it never ran, why, and how near it came.

{RUN_CODES}
\b
  nctakt why part.nc
  nctakt why part.nc --cycle 17 --line 4 --at 1.5ms V.E.VALUE=-1
  nctakt why part.nc --state 0.463
"""


@click.command("why", epilog=_EPILOG, short_help="Explain why reactions fired or did not.")
@run_options("report and diagnostics")
@FORMAT_OPTION
@click.option("--cycle", metavar="ID", help="Only this realtime cycle (#1: the first without ID).")
@click.option(
    "--line",
    type=click.IntRange(min=1),
    metavar="N",
    help="Only the $IF in this line, or around this line.",
)
@click.option("--state", metavar="TIME", help="Show the states at this time of the run.")
def command(cycle: str | None, line: int | None, state: str | None, **words: Any) -> int:
    """Run NC programs and explain why reactions of their realtime cycles fired or did not."""
    return carry_out(words, lambda options, access: _why(options, access, cycle, line, state))


def _why(
    options: Options, access: FileAccess, cycle: str | None, line: int | None, state: str | None
) -> int:
    """Run and report; raises ``Failure`` for invalid options."""
    choose_mode(options)
    for time, assignment in options.stimuli:
        if "=" not in assignment:
            raise Failure(diagnostic(STIMULUS_WITHOUT_VALUE, time=time))
    request = read_request(options, access)
    moment = None if state is None else read_time(state)
    controller = start_controller(options, access)
    length_us = controller.cycle_time_us
    tick = None if moment is None else moment.us(length_us) // length_us
    if tick is not None:  # later ticks are not needed
        last = min(tick + 1, options.ticks or tick + 1)
        options = replace(options, ticks=last, limit_fails=False)
    run = run_programs(options, request, controller, why=True)
    if run is None:
        return EXIT_NC_ERROR
    run = with_limit_error(options, run)
    if options.form == "text":
        lowest = Severity.ERROR if options.quiet else Severity.NOTE
        print_diagnostics(run.diagnostics, options.language, lowest)
    if run.ticks or options.form == "json":
        text = _report(options, run, cycle, line, tick)
        show_at_the_end(lambda file: print(text, end="", file=file))
    return exit_code(options, run)


def _report(
    options: Options, run: Run, cycle: str | None, line: int | None, tick: int | None
) -> str:
    from nctakt.cli.json_documents import as_json, run_document  # noqa: PLC0415 - as below
    from nctakt.results.summary import headline  # noqa: PLC0415 - the mode is chosen before

    if run.why is None or not run.ticks:
        return as_json(run_document(run, options.language))
    report = run.why.select(cycle, line)
    if options.form == "json":
        state = None if tick is None else report.render_at(tick, options.language).splitlines()
        return as_json(run_document(run, options.language, why=report, state_at_tick=state))
    if tick is not None:
        return report.render_at(tick, options.language)
    return f"{headline(run, options.language, None)}\n\n{report.render(options.language)}"

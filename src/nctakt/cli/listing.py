# SPDX-License-Identifier: MIT
"""``nctakt list``: each realtime cycle of a program as its elementary instructions.

In: programs, a machine, values of variables. Out: on standard output the listing of each definition
that the decoder meets while the programs run, with the values that were frozen into it then. Only
a run knows them: definitions stand in loops and branches, and values change. Diagnostics go to
standard error; exit code 1 when the programs do not run to their end because of an error.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN, EXIT_USAGE
from nctakt.cli.file_options import file_access
from nctakt.cli.request import Options, read_request
from nctakt.cli.running import choose_mode, run_options, run_programs, start_controller
from nctakt.cli.terminal import print_diagnostics, show_at_the_end
from nctakt.messages import diagnostic
from nctakt.messages.command_line import LISTING_INCOMPLETE, NO_CYCLE_DEFINED

if TYPE_CHECKING:
    from nctakt.decoder.cycles.builder import CycleDefinition
    from nctakt.results.run import Run
    from nctakt.run.controller import Controller

_EPILOG = """\b
A variable that is not synchronous is read when the definition is decoded: the
listing shows the value that was frozen then. Count: elementary instructions.

\b
  nctakt list part.nc
  nctakt list part.nc --set V.E.LIMIT=200 --until 5s
"""


@click.command("list", epilog=_EPILOG, short_help="List realtime cycles as their instructions.")
@run_options("listing and diagnostics")
def command(**words: Any) -> int:
    """Run NC programs and list each realtime cycle that they define ('-': standard input)."""
    options = Options(**words)
    try:
        return _list(options)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, options.language)
        return EXIT_USAGE


def _list(options: Options) -> int:
    """Run and list; raises ``Failure`` for what cannot be used."""
    choose_mode(options)
    access = file_access(options.confined)
    request = read_request(options, access)
    controller = start_controller(options, access)
    lines: list[str] = []
    run = run_programs(options, request, controller, on_cycle=_lister(options, controller, lines))
    if lines:
        show_at_the_end(lambda file: print(*lines, sep="\n", file=file))
    if run is None:
        return EXIT_NC_ERROR
    print_diagnostics(run.diagnostics, options.language, Severity.WARNING)
    print_diagnostics(_notes(run, lines), options.language)
    stopped = run.state in ("error", "interrupted")
    return EXIT_NC_ERROR if stopped or run.errors else EXIT_RAN


def _lister(
    options: Options, controller: Controller, lines: list[str]
) -> Callable[[str, CycleDefinition], None]:
    """What adds the lines of a definition to ``lines``, an empty one between two definitions."""
    from nctakt.decoder.cycles.memory_budget import memory_bytes  # noqa: PLC0415 - the mode is chosen before
    from nctakt.results.listing import Listing  # noqa: PLC0415

    listing = Listing(options.language)
    places = controller.machine.channels[0].parameters.realtime_cycles.buffers

    def add(name: str, definition: CycleDefinition) -> None:
        if lines:
            lines.append("")
        size = memory_bytes(definition.statement, places)
        lines.extend(listing.lines(name, definition, size))

    return add


def _notes(run: Run, lines: Sequence[str]) -> Iterator[Diagnostic]:
    """What the listing cannot show."""
    if not lines and run.state in ("ended", "limit"):
        yield diagnostic(NO_CYCLE_DEFINED)
    if run.state == "limit":
        yield diagnostic(LISTING_INCOMPLETE, ticks=run.ticks)

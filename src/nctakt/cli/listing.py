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

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.cli import EXIT_NC_ERROR
from nctakt.cli.request import Options, read_request
from nctakt.cli.running import (
    FORMAT_OPTION,
    RUN_CODES,
    choose_mode,
    exit_code,
    run_options,
    run_programs,
    shown_from,
    start_controller,
    with_limit_error,
)
from nctakt.cli.settings import carry_out
from nctakt.cli.terminal import print_diagnostics, show_at_the_end
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.command_line import LISTING_INCOMPLETE, NO_CYCLE_DEFINED

if TYPE_CHECKING:
    from nctakt.decoder.cycles.builder import CycleDefinition
    from nctakt.results.run import Run
    from nctakt.run.controller import Controller

_EPILOG = f"""\b
A variable that is not synchronous is read when the definition is decoded: the
listing shows the value that was frozen then. Count: elementary instructions.

{RUN_CODES}
\b
  nctakt list part.nc
  nctakt list part.nc --set V.E.LIMIT=200 --until 5s
"""


@dataclass(frozen=True, slots=True)
class Listed:
    """A definition: the name of its cycle, its memory in bytes, the lines of its listing."""

    name: str
    size_bytes: int
    lines: tuple[str, ...]


@click.command("list", epilog=_EPILOG, short_help="List realtime cycles as their instructions.")
@run_options("listing and diagnostics")
@FORMAT_OPTION
def command(**words: Any) -> int:
    """Run NC programs and list each realtime cycle that they define ('-': standard input)."""
    return carry_out(words, _list)


def _list(options: Options, access: FileAccess) -> int:
    """Run and list; raises ``Failure`` for what cannot be used."""
    choose_mode(options)
    request = read_request(options, access)
    controller = start_controller(options, access)
    listed: list[Listed] = []
    run = run_programs(options, request, controller, on_cycle=_lister(options, controller, listed))
    if options.form == "json" and run is not None:
        from nctakt.cli.json_documents import as_json, run_document  # noqa: PLC0415

        text = as_json(
            run_document(with_limit_error(options, run), options.language, listing=listed)
        )
    else:
        text = "\n".join("".join(f"{line}\n" for line in one.lines) for one in listed)
    if text:
        show_at_the_end(lambda file: print(text, end="", file=file))
    if run is None:
        return EXIT_NC_ERROR
    run = with_limit_error(options, run)
    if options.form == "text":
        print_diagnostics(run.diagnostics, options.language, shown_from(options))
        if not options.quiet:
            print_diagnostics(_notes(run, listed), options.language)
    return exit_code(options, run)


def _lister(
    options: Options, controller: Controller, listed: list[Listed]
) -> Callable[[str, CycleDefinition], None]:
    """What adds a definition to ``listed``."""
    from nctakt.decoder.cycles.memory_budget import memory_bytes  # noqa: PLC0415 - the mode is chosen before
    from nctakt.results.listing import Listing  # noqa: PLC0415

    listing = Listing(options.language)
    places = controller.machine.channels[0].parameters.realtime_cycles.buffers

    def add(name: str, definition: CycleDefinition) -> None:
        size = memory_bytes(definition.statement, places)
        listed.append(Listed(name, size, tuple(listing.lines(name, definition, size))))

    return add


def _notes(run: Run, listed: Sequence[Listed]) -> Iterator[Diagnostic]:
    """What the listing cannot show."""
    if not listed and run.state in ("ended", "limit"):
        yield diagnostic(NO_CYCLE_DEFINED)
    if run.state == "limit":
        yield diagnostic(LISTING_INCOMPLETE, ticks=run.ticks)

# SPDX-License-Identifier: MIT
"""``nctakt list``: each realtime cycle of a program as its elementary instructions.

In: programs, a machine, values of variables. Out: on standard output the listing of each definition
that the decoder meets while the programs run, with the values that were frozen into it then. Only
a run knows them: definitions stand in loops and branches, and values change. Diagnostics go to
standard error; exit code 1 when the programs do not run to their end because of an error.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN, EXIT_USAGE
from nctakt.cli.request import Options, read_request
from nctakt.cli.terminal import print_diagnostics, show_at_the_end
from nctakt.diagnostics import Language, Severity
from nctakt.failure import Failure
from nctakt.messages import diagnostic

if TYPE_CHECKING:
    from nctakt.decoder.cycles import CycleDefinition

_EPILOG = """\b
A variable that is not synchronous is read when the definition is decoded: the
listing shows the value that was frozen then. Count: elementary instructions.

\b
  nctakt list part.nc
  nctakt list part.nc --set V.E.LIMIT=200 --until 5s
"""


@click.command("list", epilog=_EPILOG, short_help="List realtime cycles as their instructions.")
@click.argument("programs", metavar="PROGRAM...", nargs=-1, required=True)
@click.option("--machine", metavar="DIR", help="Folder with the machine's lists [default: demo].")
@click.option(
    "--set",
    "assignments",
    metavar="NAME=VALUE",
    multiple=True,
    help="Give a variable a value before the first tick.",
)
@click.option(
    "--at",
    "stimuli",
    metavar="TIME NAME=VALUE",
    nargs=2,
    multiple=True,
    help="Give a variable a value at a time of the run.",
)
@click.option("--ticks", type=click.IntRange(min=1), metavar="N", help="Run at most N ticks.")
@click.option("--until", metavar="TIME", help="Run at most so long [default: 10min].")
@click.option("--plc", metavar="FILE.py", help="A class of yours that plays the PLC.")
@click.option(
    "--lang",
    "language",
    type=click.Choice(["en", "de"]),
    default="en",
    help="Language of the listing and of diagnostics.",
)
def command(**words: Any) -> int:
    """Run NC programs and list each realtime cycle that they define ('-': standard input)."""
    language: Language = words["language"]
    try:
        return _list(words, language)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def _list(words: dict[str, Any], language: Language) -> int:
    """Run and list; raises ``Failure`` for what cannot be used."""
    from nctakt.controller import Controller  # noqa: PLC0415 - a command that only shows its help
    from nctakt.decoder.memory import memory_bytes  # noqa: PLC0415 - does not load these
    from nctakt.results.listing import Listing  # noqa: PLC0415

    unused = ("trace", "signals", "diagnosis", "messages", "compiled")
    all_words: dict[str, Any] = {**words, **dict.fromkeys(unused)}
    options = Options(**all_words, after="0", quiet=False)
    request = read_request(options)
    controller = Controller(options.machine)
    places = controller.machine.channels[0].parameters.realtime_cycles.buffers
    listing = Listing(language)
    paragraphs: list[list[str]] = []

    def keep(name: str, definition: CycleDefinition) -> None:
        size = memory_bytes(definition.statement, places)
        paragraphs.append(list(listing.lines(name, definition, size)))

    run = controller.run(
        *request.programs,
        plc=request.plc,
        until_us=request.until_us,
        ticks=options.ticks,
        initial=request.initial,
        stimuli=request.stimuli,
        memory_trace=False,
        on_cycle=keep,
    )
    lines = [line for paragraph in paragraphs for line in (*paragraph, "")][:-1]
    if lines:
        show_at_the_end(lambda file: print(*lines, sep="\n", file=file))
    print_diagnostics(run.diagnostics, language, Severity.WARNING)
    if not paragraphs and run.state != "error":
        print_diagnostics([diagnostic(900591)], language)
    if run.state == "limit":
        print_diagnostics([diagnostic(900590, ticks=run.ticks)], language)
    return EXIT_NC_ERROR if run.state == "error" or run.errors else EXIT_RAN

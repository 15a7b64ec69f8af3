# SPDX-License-Identifier: MIT
"""``nctakt disassemble``: each realtime cycle of a program as its elementary instructions.

In: programs, a machine, values of variables. Out: on standard output the listing of each definition
that the decoder reaches while the programs run, with its frozen values. A run is necessary, since
definitions occur in loops and branches, and values change. Diagnostics go to standard error; exit
code 1 if an error stops the programs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.cli import EXIT_NC_ERROR
from nctakt.cli.common.help import described
from nctakt.cli.common.options import FORMAT_OPTION
from nctakt.cli.common.request import Options, read_request
from nctakt.cli.common.running import (
    RUN_CODES,
    TIMES_NOTE,
    choose_mode,
    exit_code,
    run_options,
    run_programs,
    shown_from,
    start_controller,
    with_limit_error,
)
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.terminal import print_diagnostics, show_at_the_end
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import LISTING_INCOMPLETE, NO_CYCLE_DEFINED

if TYPE_CHECKING:
    from nctakt.decoder.cycles.builder import CycleDefinition
    from nctakt.results.run import Run
    from nctakt.run.controller import Controller


@dataclass(frozen=True, slots=True)
class ListedDefinition:
    """A definition: the name of its cycle, its memory in bytes, the lines of its listing."""

    name: str
    size_bytes: int
    lines: tuple[str, ...]


@described(
    "disassemble",
    summary=Text(
        "Show the instructions of realtime cycles.",
        "Die Anweisungen von Echtzeit-Zyklen zeigen.",
    ),
    text=Text(
        "Run NC programs and show each realtime cycle that they define as its elementary "
        "instructions ('-': standard input).",
        "NC-Programme ausführen und die Elementar-Anweisungen jedes Echtzeit-Zyklus zeigen, "
        "den sie definieren ('-': Standardeingabe).",
    ),
    codes=RUN_CODES,
    notes=Text(
        "An asynchronous variable is read when the definition is decoded: the listing shows its "
        f"frozen value. Count: elementary instructions. {TIMES_NOTE.en}",
        "Eine asynchrone Variable wird gelesen, wenn die Definition dekodiert wird: Gezeigt wird "
        f"ihr eingefrorener Wert. Gezählt werden Elementar-Anweisungen. {TIMES_NOTE.de}",
    ),
    examples=(
        "nctakt disassemble part.nc",
        "nctakt disassemble part.nc --set V.E.LIMIT=200 --until 5s",
    ),
)
@run_options("disassemble")
@FORMAT_OPTION
def command(**words: Any) -> int:
    """Show realtime cycles as instructions."""
    return carry_out(words, _disassemble, runs_code=False)


def _disassemble(options: Options, access: FileAccess) -> int:
    """Run and list; raises ``Failure`` for invalid options."""
    choose_mode(options)
    request = read_request(options, access)
    controller = start_controller(options, access)
    listed: list[ListedDefinition] = []
    run = run_programs(options, request, controller, on_cycle=_lister(options, controller, listed))
    if options.form == "json" and run is not None:
        from nctakt.cli.findings.json_documents import as_json, run_document  # noqa: PLC0415

        text = as_json(
            run_document(with_limit_error(options, run), options.language, listing=listed)
        )
    else:
        text = "\n".join("".join(f"{line}\n" for line in definition.lines) for definition in listed)
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
    options: Options, controller: Controller, listed: list[ListedDefinition]
) -> Callable[[str, CycleDefinition], None]:
    """Return a function that adds a definition to ``listed``."""
    from nctakt.decoder.cycles.memory_budget import memory_bytes  # noqa: PLC0415 - mode first
    from nctakt.results.instruction_tree import Listing  # noqa: PLC0415

    listing = Listing(options.language)
    places = controller.machine.channels[0].parameters.realtime_cycles.buffers

    def add(name: str, definition: CycleDefinition) -> None:
        size = memory_bytes(definition.statement, places)
        listed.append(ListedDefinition(name, size, tuple(listing.lines(name, definition, size))))

    return add


def _notes(run: Run, listed: Sequence[ListedDefinition]) -> Iterator[Diagnostic]:
    """Yield notes about the limits of the listing."""
    if not listed and run.state in ("ended", "limit"):
        yield diagnostic(NO_CYCLE_DEFINED)
    if run.state == "limit":
        yield diagnostic(LISTING_INCOMPLETE, ticks=run.ticks)

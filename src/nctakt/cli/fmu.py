# SPDX-License-Identifier: MIT
"""``nctakt fmu``: pack a machine with its program and PLC as an FMU for other tools.

In: programs, machine, PLC, names of inputs and outputs, a file to write. Out: the FMU. It is
written once its run has been checked, and started from its own files.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.diagnostics import Severity, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import MODE_OPTION, TRUST_OPTION, table_options
from nctakt.cli.common.request import Options, read_request
from nctakt.cli.common.running import choose_mode, start_controller
from nctakt.cli.common.settings import carry_out
from nctakt.cli.common.terminal import print_diagnostics, show_at_the_end
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import CELL_NAME_NOT_POSSIBLE
from nctakt.run.option_kinds import split_names

if TYPE_CHECKING:
    from nctakt.run.options import RunKeywords

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_TEXT = Text(
    "{name}: FMI {version}.0, {inputs} inputs, {outputs} outputs, steps of {tick} or more",
    "{name}: FMI {version}.0, {inputs} Eingänge, {outputs} Ausgänge, Schritte ab {tick}",
)


@described(
    "fmu",
    summary=Text("Pack a run as an FMU.", "Einen Lauf als FMU verpacken."),
    text=Text(
        "Pack a machine with its programs and PLC as an FMU for co-simulation, which other tools "
        "simulate beside their models.",
        "Eine Maschine mit ihren Programmen und ihrer SPS als FMU für Co-Simulation verpacken, die "
        "andere Werkzeuge neben ihren Modellen simulieren.",
    ),
    codes=(
        Text("the FMU is written", "die FMU ist geschrieben"),
        Text("an NC error in the programs", "ein NC-Fehler in den Programmen"),
    ),
    notes=Text(
        "The tool that imports it needs a Python with nctakt.",
        "Das importierende Werkzeug braucht ein Python mit nctakt.",
    ),
    examples=(
        "nctakt fmu part.nc --machine mill --plc cell.py -o cell.fmu",
        "nctakt fmu part.nc -o cell.fmu --fmi 2 --inputs V.E.VALUE,HLI.OVERRIDE "
        "--outputs X.ACS.ACT_POS,V.E.COUNT",
    ),
)
@table_options("fmu")
@option("-o", "--output", "target", metavar="FILE.fmu", required=True, group="files",
        text=Text("The FMU to write.", "Die FMU, die geschrieben wird."))  # fmt: skip
@option(
    "--fmi",
    "version",
    type=click.Choice(["2", "3"]),
    default="3",
    text=Text("The version of FMI [default: 3].", "Die Version von FMI [Vorgabe: 3]."),
)
@option(
    "--inputs",
    metavar="NAME,...",
    text=Text(
        "The variables that the tool sets [default: the operator's values].",
        "Die Variablen, die das Werkzeug setzt [Vorgabe: die Werte des Bedieners].",
    ),
)
@option(
    "--outputs",
    metavar="NAME,...",
    text=Text(
        "The signals that it reads [default: those of a trace].",
        "Die Signale, die es liest [Vorgabe: die einer Aufzeichnung].",
    ),
)
@TRUST_OPTION
@MODE_OPTION
def command(target: str, version: str, **words: Any) -> int:
    """Pack."""
    inputs, outputs = (
        None if words[name] is None else split_names(words[name]) for name in ("inputs", "outputs")
    )
    del words["inputs"], words["outputs"]
    return carry_out(
        words,
        lambda options, access: _pack(options, access, target, int(version), inputs, outputs),
        fmu_use="leave_out",
    )


def _pack(
    options: Options,
    access: FileAccess,
    target: str,
    version: int,
    inputs: tuple[str, ...] | None,
    outputs: tuple[str, ...] | None,
) -> int:
    """Check the run, write the FMU and list its content; raises ``Failure``."""
    choose_mode(options)
    from nctakt.fmu.exporting import build_cell, cell_variables, gather  # noqa: PLC0415 - as above
    from nctakt.run.tape_words import words_of_run  # noqa: PLC0415

    name = Path(target).stem
    if not _NAME.fullmatch(name) or Path(target).suffix != ".fmu":
        raise Failure(diagnostic(CELL_NAME_NOT_POSSIBLE, file=target))
    request = read_request(options, access)
    controller = start_controller(options, access)
    with OutputFile(target, "--output", access) as file:
        given: RunKeywords = {
            **request.options,
            "plc": request.plc,
            "memory_trace": False,
            "signals": list(dict.fromkeys((*(outputs or ()), *(inputs or ())))) or None,
        }
        run = controller.begin({1: request.programs, **request.channels}, **given)
        run.load()
        variables = cell_variables(run.machine, inputs, outputs)
        run.close()
        lowest = Severity.ERROR if options.quiet else Severity.WARNING
        print_diagnostics(controller.diagnostics, options.language, lowest)
        if any(one.severity is Severity.ERROR for one in controller.diagnostics):
            return EXIT_NC_ERROR
        words = words_of_run(
            request.options,
            programs=list(options.programs),
            others=[list(pair) for pair in options.others],
            machine=options.machine,
        )
        cell = gather(words, options.plcs, access.read_files)
        file.write(build_cell(version, name, cell, variables, controller.cycle_time_us))
    count = sum(one.start is not None for one in variables)
    said = _TEXT.get(options.language).format(
        name=target,
        version=version,
        inputs=count,
        outputs=len(variables) - count,
        tick=f"{controller.cycle_time_us / 1e3:g} ms",
    )
    if not options.quiet:
        show_at_the_end(lambda shown: print(said, file=shown))
    return EXIT_RAN

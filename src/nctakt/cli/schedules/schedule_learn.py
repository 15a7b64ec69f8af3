# SPDX-License-Identifier: MIT
"""``nctakt schedule learn``: execution times from a recording of trace bits.

In: a scheduling list, a recording (VCD, CSV). Out: a load file (standard output or a file),
diagnostics, and the exit code as for a simulation.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.cli.common.help import described, option
from nctakt.cli.schedules.schedule_options import (
    EXIT_CODES,
    LIST_OPTIONS,
    NOTE,
    guarded,
    make_model,
    publish,
    read_list,
    with_options,
)
from nctakt.messages import Collector, diagnostic
from nctakt.messages.scheduling.learn import NOTHING_LEARNT

if TYPE_CHECKING:
    from nctakt.schedule.learn import LearntTimes
    from nctakt.schedule.model import Model

_STANDARD_RULES = {"overflow": "skip", "calls": "block", "suspension": "ticks"}


@described(
    "learn",
    summary=Text(
        "Learn execution times from a recording.",
        "Ausführungszeiten aus einer Aufzeichnung lernen.",
    ),
    text=Text(
        "Compute execution times of functions and write a load file. RECORDING is a VCD file, a "
        "CSV file with time_us and bit1 … bit7, or the table that simulate --csv writes.",
        "Ausführungszeiten von Funktionen berechnen und eine Lastdatei schreiben. RECORDING ist "
        "eine VCD-Datei, eine CSV-Datei mit time_us und bit1 … bit7 oder die Tabelle von "
        "simulate --csv.",
    ),
    codes=EXIT_CODES,
    notes=NOTE,
    examples=("nctakt schedule learn rtconf.lis recording.vcd --output load.toml",),
)
@with_options(LIST_OPTIONS[0])
@click.argument("recording", metavar="RECORDING")
@with_options(*LIST_OPTIONS[1:])
@option(
    "--as",
    "written_as",
    type=click.Choice(["uniform", "list", "longest"]),
    default="uniform",
    text=Text(
        "Write the range of the times, all in turn, or the longest one [default: uniform].",
        "Den Bereich der Zeiten schreiben, alle der Reihe nach oder die längste [Vorgabe: "
        "uniform].",
    ),
)
@option(
    "--cpu-base",
    type=click.IntRange(0, 1),
    metavar="N",
    default=1,
    text=Text("Number of the first CPU.", "Nummer der ersten CPU."),
)
@option(
    "--output",
    metavar="FILE.toml",
    text=Text("Write the load to a file.", "Die Last in eine Datei schreiben."),
    group="files",
)
def learn(**words: Any) -> int:
    """Learn execution times from a recording."""
    return guarded(_learn, words)


def _learn(words: dict[str, Any]) -> int:
    from nctakt.base.text import decode_text  # noqa: PLC0415 - not for the help
    from nctakt.files.output import OutputFile  # noqa: PLC0415
    from nctakt.schedule.learn import learn as learn_times  # noqa: PLC0415
    from nctakt.schedule.load import ASSUMED  # noqa: PLC0415
    from nctakt.schedule.reports.load_text import load_text  # noqa: PLC0415
    from nctakt.schedule.trace_reader import read_recording  # noqa: PLC0415

    read = read_list(words)
    model = make_model(read, ASSUMED, words | _STANDARD_RULES, Collector())
    path = words["recording"]
    text = decode_text(read.access.read_bytes(Path(path))).text
    learnt = learn_times(model, read_recording(path, text))
    if not learnt.calls and not learnt.external:
        raise Failure(*read.diagnostics, *learnt.diagnostics, diagnostic(NOTHING_LEARNT, file=path))
    load = load_text(model, learnt, words["written_as"], Path(path).name)
    if words["output"] is not None:
        with OutputFile(words["output"], "--output", read.access) as file:
            file.write(load)
    shown = load if words["output"] is None else ""
    return publish(words, read.diagnostics, learnt.diagnostics, shown, _document(model, learnt))


def _document(model: Model, learnt: LearntTimes) -> dict[str, object]:
    """Return the times for other programs, in µs."""
    from nctakt.schedule.model import NS_PER_US  # noqa: PLC0415

    return {
        "functions": [
            {
                "thread": model.tasks[i].key,
                "function": name,
                "times_us": [time / NS_PER_US for time in times],
            }
            for (i, name), times in learnt.calls.items()
        ],
        "external": {
            name: [time / NS_PER_US for time in times] for name, times in learnt.external.items()
        },
    }

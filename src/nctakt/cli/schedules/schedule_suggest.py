# SPDX-License-Identifier: MIT
"""``nctakt schedule suggest``: values with which each thread has the required slack.

In: a list, optionally a load, slacks, the variable entries. Out: suggestions with their bounds
(standard output), the best one as a list in a file, and the exit code: 1 without a suggestion.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.cli.common.help import described, option
from nctakt.cli.schedules.schedule_options import (
    EXIT_CODES,
    LIST_OPTIONS,
    MODEL_OPTIONS,
    NOTE,
    guarded,
    make_model,
    publish,
    read_list,
    read_model_load,
    with_options,
)
from nctakt.messages import Collector, diagnostic
from nctakt.messages.scheduling.schedule_results import INVALID_SLACK, NOTHING_SUGGESTED
from nctakt.run.option_kinds import by_name

if TYPE_CHECKING:
    from nctakt.cli.schedules.schedule_options import ListRead
    from nctakt.files.output import OutputFile
    from nctakt.lists.declared.rtconf import RtconfConfiguration
    from nctakt.schedule.analysis.suggest import Slacks, Suggestions
    from nctakt.schedule.model import Model

_NAMES = ["windows_time", "time_slice", "priorities", "cpus", "calls"]


@described(
    "suggest",
    summary=Text(
        "Suggest values with slack for each thread.",
        "Werte mit Reserve für jeden Thread vorschlagen.",
    ),
    text=Text(
        "Search values of windows_time, time_slice, priorities, CPUs and calls_per_cycle.",
        "Werte von windows_time, time_slice, Prioritäten, CPUs und calls_per_cycle suchen.",
    ),
    codes=EXIT_CODES,
    notes=NOTE,
    examples=("nctakt schedule suggest rtconf.lis --load load.toml --slack 20",),
)
@with_options(*LIST_OPTIONS, *MODEL_OPTIONS)
@option(
    "--slack",
    "slacks",
    metavar="[THREAD=]PCT",
    multiple=True,
    text=Text(
        "Slack of each thread, or of one, in percent of its period [default: 10].",
        "Reserve jedes Threads oder eines Threads in Prozent seiner Periode [Vorgabe: 10].",
    ),
)
@option(
    "--vary",
    "variables",
    type=click.Choice(_NAMES),
    multiple=True,
    text=Text(
        "The entries that may be changed [default: all].",
        "Die Einträge, die geändert werden dürfen [Vorgabe: alle].",
    ),
)
@option(
    "--cpus",
    type=click.IntRange(1, 7),
    metavar="N",
    text=Text(
        "Number of CPUs for threads [default: those of the load, or of the list].",
        "Anzahl der CPUs für Threads [Vorgabe: die der Last oder der Liste].",
    ),
)
@option(
    "--output",
    metavar="FILE",
    text=Text(
        "Write the list with the first suggestion.", "Die Liste mit dem ersten Vorschlag schreiben."
    ),
    group="files",
)
def suggest(**words: Any) -> int:
    """Suggest values with slack for each thread."""
    return guarded(_suggest, words)


def _suggest(words: dict[str, Any]) -> int:
    from nctakt.files.output import OutputFile  # noqa: PLC0415 - not for the help
    from nctakt.schedule.analysis.suggest import VARIABLES  # noqa: PLC0415
    from nctakt.schedule.analysis.suggest import suggest as search  # noqa: PLC0415
    from nctakt.schedule.reports.suggest_report import (  # noqa: PLC0415
        suggestion_document,
        suggestion_report,
    )

    read = read_list(words)
    collector = Collector()
    load = read_model_load(read, words, collector)
    model = make_model(read, load, words, collector)
    slacks = _slacks(words["slacks"], model)
    count = words["cpus"] or max(model.cpus)
    if load.cpus is not None:
        load = replace(load, cpus=max(load.cpus, count))

    def model_of(configuration: RtconfConfiguration) -> Model:
        return make_model(read, load, words, Collector(), configuration)

    variables = words["variables"] or VARIABLES
    base = words["cpu_base"]
    cpus = range(max(1, base), base + count)  # numbered as in the list, without a CPU 0
    suggestions = search(read.configuration, model_of, slacks, variables, cpus)
    if not suggestions.is_met and not suggestions.better:
        collector.report(NOTHING_SUGGESTED, None)
    elif words["output"] is not None:
        with OutputFile(words["output"], "--output", read.access) as file:
            _write(file, read, suggestions)
    text = suggestion_report(suggestions, slacks, words["language"])
    document = suggestion_document(suggestions, slacks)
    return publish(words, read.diagnostics, collector.diagnostics, text, document)


def _slacks(texts: tuple[str, ...], model: Model) -> Slacks:
    """Return the slacks of ``--slack``; raises ``Failure`` (900648, 902953)."""
    from nctakt.schedule.analysis.suggest import Slacks  # noqa: PLC0415

    names = [task.name for task in model.tasks]
    shares: list[tuple[str, float]] = []
    for text in texts:
        name, equals, number = text.rpartition("=")
        try:
            share = float(number.removesuffix("%"))
        except ValueError:
            share = -1.0
        if not 0 <= share < 100 or (equals and name not in names):
            raise Failure(diagnostic(INVALID_SLACK, text=text, names=", ".join(names)))
        shares.append((name, share))
    threads = by_name("--slack", shares)
    return Slacks(threads.pop("", 10.0), threads)


def _write(file: OutputFile, read: ListRead, suggestions: Suggestions) -> None:
    """Write the list with the first suggestion, or with its effective values without one."""
    from nctakt.schedule.reports.suggest_report import changed_entries  # noqa: PLC0415
    from nctakt.schedule.rewrite import rewrite  # noqa: PLC0415

    best = suggestions.better[0] if suggestions.better else suggestions.present
    names = {finding.entry for finding in read.diagnostics}
    names |= {name for name, _, _ in changed_entries(suggestions.present, best)}
    convention = read.options.convention
    configuration = best.configuration
    rewritten = rewrite(file.name, read.data, read.values, configuration, names, convention)
    file.write(rewritten.data)

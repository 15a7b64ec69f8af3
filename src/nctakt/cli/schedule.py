# SPDX-License-Identifier: MIT
"""``nctakt schedule``: show, simulate, analyse and run a scheduling list (rtconf.lis).

In: the list, optionally a load, options for the rules. Out: tables (standard output), diagnostics
(standard error), pictures and traces (files), and the exit code: 0 without errors, 1 if the
schedule has errors (reported overflows, missing processors) or, with ``--strict``, warnings; 2 if
the list has errors or an input is invalid.
"""

from __future__ import annotations

from typing import Any

from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.cli.common.help import described, described_group, option
from nctakt.cli.schedules.schedule_compare import compare
from nctakt.cli.schedules.schedule_learn import learn
from nctakt.cli.schedules.schedule_options import (
    EXIT_CODES,
    LIST_OPTIONS,
    MODEL_OPTIONS,
    NOTE,
    OUTPUT_OPTIONS,
    ListRead,
    guarded,
    make_model,
    open_outputs,
    publish,
    read_list,
    read_list_text,
    read_model_load,
    simulated_cycles,
    with_options,
)
from nctakt.cli.schedules.schedule_run import run
from nctakt.cli.schedules.schedule_suggest import suggest
from nctakt.messages import Collector, diagnostic
from nctakt.messages.scheduling.schedule_check import LIST_REWRITTEN


@described_group(
    "schedule",
    summary=Text(
        "Show, simulate, analyse, run rtconf.lis.", "rtconf.lis zeigen, simulieren, ausführen."
    ),
    text=Text(
        "Show, simulate, analyse, compare, improve and run scheduling lists (rtconf.lis).",
        "Listen der Echtzeitkonfiguration (rtconf.lis) zeigen, simulieren, berechnen, vergleichen, "
        "verbessern und ausführen.",
    ),
    codes=EXIT_CODES,
    notes=NOTE,
    examples=(
        "nctakt schedule show rtconf.lis",
        "nctakt schedule simulate rtconf.lis --load load.toml --plot schedule.svg",
        "nctakt schedule analyse rtconf.lis --load load.toml",
        "nctakt schedule compare rtconf.lis other.lis --load load.toml",
        "nctakt schedule learn rtconf.lis recording.vcd --output load.toml",
        "nctakt schedule run rtconf.lis --load load.toml --duration 10s",
        "nctakt schedule suggest rtconf.lis --load load.toml --slack 20",
    ),
)
def command() -> None:
    """Handle scheduling lists."""


command.add_command(compare)
command.add_command(learn)
command.add_command(run)
command.add_command(suggest)


@described(
    "show",
    summary=Text("Raw and effective values of a list.", "Rohe und wirksame Werte einer Liste."),
    text=Text(
        "Check a list; show each parameter raw and effective, with the reason. With --fix or "
        "--output the written list is shown.",
        "Eine Liste prüfen; jeden Parameter roh und wirksam zeigen, mit dem Grund. Mit --fix "
        "oder --output wird die geschriebene Liste gezeigt.",
    ),
    codes=EXIT_CODES,
    notes=NOTE,
    examples=("nctakt schedule show rtconf.lis",),
)
@with_options(
    *LIST_OPTIONS,
    option(
        "--fix",
        is_flag=True,
        text=Text(
            "Write the effective values into the list; comments stay.",
            "Die wirksamen Werte in die Liste schreiben; Kommentare bleiben.",
        ),
    ),
    option(
        "--output",
        metavar="FILE",
        text=Text(
            "Write the list with effective values to another file.",
            "Die Liste mit wirksamen Werten in eine andere Datei schreiben.",
        ),
        group="files",
    ),
)
def show(**words: Any) -> int:
    """Raw and effective values of a list."""
    return guarded(_show, words)


@described(
    "simulate",
    summary=Text(
        "Simulate the schedule in virtual time.", "Den Ablaufplan in virtueller Zeit simulieren."
    ),
    text=Text(
        "Simulate the schedule: tables of threads and of Windows, pictures, traces.",
        "Den Ablaufplan simulieren: Tabellen der Threads und von Windows, Bilder, Aufzeichnungen.",
    ),
    codes=EXIT_CODES,
    notes=NOTE,
    examples=("nctakt schedule simulate rtconf.lis --load load.toml --plot schedule.svg",),
)
@with_options(*LIST_OPTIONS, *MODEL_OPTIONS, *OUTPUT_OPTIONS)
def simulate(**words: Any) -> int:
    """Simulate the schedule in virtual time."""
    return guarded(_simulate, words)


@described(
    "analyse",
    summary=Text("Compute response times and margins.", "Antwortzeiten und Reserven berechnen."),
    text=Text(
        "Compute response times without simulation, load against supply, and margins.",
        "Antwortzeiten ohne Simulation, Last gegen Angebot und Reserven berechnen.",
    ),
    codes=EXIT_CODES,
    notes=NOTE,
    examples=("nctakt schedule analyse rtconf.lis --load load.toml",),
)
@with_options(*LIST_OPTIONS, *MODEL_OPTIONS)
def analyse(**words: Any) -> int:
    """Compute response times and margins."""
    return guarded(_analyse, words)


for _part in (show, simulate, analyse):
    command.add_command(_part)


def _show(words: dict[str, Any]) -> int:
    from nctakt.schedule.effective_table import effective_rows  # noqa: PLC0415
    from nctakt.schedule.reports.documents import effective_document  # noqa: PLC0415
    from nctakt.schedule.reports.report import effective_report  # noqa: PLC0415

    read = read_list(words)
    notes: list[Diagnostic] = []
    if words["fix"] or words["output"] is not None:
        read, note = _write_fixed(read, words)
        notes.append(note)
    language: Language = words["language"]
    rows = effective_rows(words["file"], read.data, read.configuration, read.diagnostics, language)
    text = f"{effective_report(rows, language)}\n"
    return publish(words, read.diagnostics, notes, text, effective_document(rows))


def _write_fixed(read: ListRead, words: dict[str, Any]) -> tuple[ListRead, Diagnostic]:
    """Write the list with its effective values; return it as read again, and a note."""
    from nctakt.files.output import OutputFile  # noqa: PLC0415
    from nctakt.schedule.rewrite import rewrite  # noqa: PLC0415

    rewritten = rewrite(
        words["file"],
        read.data,
        read.values,
        read.configuration,
        {finding.entry for finding in read.diagnostics},
        read.options.convention,
    )
    target = words["output"] or words["file"]
    if rewritten.is_changed or words["output"] is not None:
        option = "--output" if words["output"] is not None else "--fix"
        with OutputFile(target, option, read.access) as file:
            file.write(rewritten.data)
    note = diagnostic(
        LIST_REWRITTEN,
        file=target,
        corrected=rewritten.corrected,
        commented=rewritten.commented,
        added=rewritten.added,
    )
    return read_list_text(target, rewritten.data, read.access, read.options), note


def _simulate(words: dict[str, Any]) -> int:
    from nctakt.schedule.analysis.analyse import simulate_worst_phases  # noqa: PLC0415
    from nctakt.schedule.analysis.findings import simulation_findings  # noqa: PLC0415
    from nctakt.schedule.pictures.drawn_cycles import simulate_shown  # noqa: PLC0415
    from nctakt.schedule.reports.documents import simulation_document  # noqa: PLC0415
    from nctakt.schedule.reports.report import response_report, simulation_report  # noqa: PLC0415
    from nctakt.schedule.simulation.simulate import simulate as run_model  # noqa: PLC0415

    read = read_list(words)
    collector = Collector()
    load = read_model_load(read, words, collector)
    model = make_model(read, load, words, collector)
    cycles = simulated_cycles(model, words)
    outputs = open_outputs(read, words)
    drawn = words["drawn"]
    run = (
        run_model(model, max(cycles, drawn), record=drawn)
        if drawn
        else simulate_shown(model, cycles)
    )
    findings = [*collector.diagnostics, *simulation_findings(run)]
    phases = simulate_worst_phases(run)
    report = simulation_report(run, phases, words["language"])
    if words["histogram"]:
        report += "\n".join([*response_report(run, words["language"]), ""])
    code = publish(words, read.diagnostics, findings, report, simulation_document(run, phases))
    outputs.write(run, report)
    return code


def _analyse(words: dict[str, Any]) -> int:
    from nctakt.schedule.analysis.analyse import analyse as analyse_model  # noqa: PLC0415
    from nctakt.schedule.analysis.findings import analysis_findings, starvation_findings  # noqa: PLC0415
    from nctakt.schedule.analysis.margins import find_margins  # noqa: PLC0415
    from nctakt.schedule.analysis.self_check import check_bounds  # noqa: PLC0415
    from nctakt.schedule.reports.documents import analysis_document  # noqa: PLC0415
    from nctakt.schedule.reports.report import analysis_report  # noqa: PLC0415
    from nctakt.schedule.simulation.simulate import simulate as run_model  # noqa: PLC0415

    read = read_list(words)
    collector = Collector()
    load = read_model_load(read, words, collector)
    model = make_model(read, load, words, collector)
    analysis = analyse_model(model)
    run = run_model(model, simulated_cycles(model, words), record=0)
    check_bounds(analysis, run)
    findings = [
        *collector.diagnostics,
        *analysis_findings(analysis),
        *starvation_findings(run),
    ]
    margins = find_margins(model)
    text = analysis_report(analysis, margins, run, words["language"])
    return publish(
        words, read.diagnostics, findings, text, analysis_document(analysis, margins, run)
    )

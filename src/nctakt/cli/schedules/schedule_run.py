# SPDX-License-Identifier: MIT
"""``nctakt schedule run``: a real run of a scheduling list on this machine.

In: the list, optionally a load, options. Out: the tables of a run and of its simulation,
diagnostics, pictures and traces, and the exit code as of a simulation.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.cli.common.help import described, option
from nctakt.cli.schedules.schedule_options import (
    EXIT_CODES,
    LIST_OPTIONS,
    MODEL_OPTIONS,
    NOTE,
    OUTPUT_OPTIONS,
    ListRead,
    drawn_cycles,
    guarded,
    make_model,
    open_outputs,
    publish,
    read_list,
    read_model_load,
    simulated_cycles,
    with_options,
)
from nctakt.messages import Collector, diagnostic
from nctakt.messages.scheduling.linux_run import (
    CPU_WOULD_STARVE,
    LEFTOVERS_REMOVED,
    LOAD_MACHINE_IGNORED,
    SCHED_FIFO_NOT_PERMITTED,
    SEMAPHORE_NOT_NAMED,
    SEMAPHORE_OPTION_WITHOUT_EFFECT,
    TIMER_INSTEAD_OF_INTERRUPT,
)

if TYPE_CHECKING:
    from nctakt.schedule.load import Load
    from nctakt.schedule.model import Model
    from nctakt.schedule.real.plan import Plan

_RUN_OPTIONS = (
    option(
        "--semaphore",
        metavar="NAME",
        text=Text(
            "Semaphore of the NC interrupts instead of external_object_name.",
            "Semaphor der NC-Interrupts statt external_object_name.",
        ),
    ),
    option(
        "--stand-in",
        is_flag=True,
        text=Text(
            "Play the external threads as well, with the times of the load.",
            "Auch die externen Threads spielen, mit den Zeiten der Last.",
        ),
    ),
    option(
        "--all-users",
        is_flag=True,
        text=Text(
            "Let processes of other users wait on the semaphores as well.",
            "Auch Prozesse anderer Benutzer dürfen an den Semaphoren warten.",
        ),
    ),
    option(
        "--no-fifo",
        is_flag=True,
        text=Text(
            "Use ordinary scheduling even as root.", "Auch als root gewöhnliches Scheduling nehmen."
        ),
    ),
    option(
        "--force",
        is_flag=True,
        text=Text(
            "Run even if a processor would have no time left.",
            "Auch laufen, wenn einem Prozessor keine Zeit bliebe.",
        ),
    ),
    option(
        "--dry-run",
        is_flag=True,
        text=Text(
            "Show the plan of the run without running it.",
            "Den Plan des Laufs zeigen, ohne zu laufen.",
        ),
    ),
)


@described(
    "run",
    summary=Text(
        "Run the schedule on this machine (Linux).", "Den Ablaufplan auf diesem Rechner ausführen."
    ),
    text=Text(
        "Run the schedule: a process for each thread, with the execution times of the load. "
        "External threads are other programs, which wait on the named semaphores of the list.",
        "Den Ablaufplan ausführen (Linux): ein Prozess je Thread, mit den Ausführungszeiten "
        "der Last. Externe Threads sind andere Programme, die an den benannten Semaphoren "
        "der Liste warten.",
    ),
    codes=EXIT_CODES,
    notes=NOTE,
    examples=("nctakt schedule run rtconf.lis --load load.toml --duration 10s",),
)
@with_options(*LIST_OPTIONS, *MODEL_OPTIONS, *_RUN_OPTIONS, *OUTPUT_OPTIONS)
def run(**words: Any) -> int:
    """Run the schedule on this machine (Linux)."""
    return guarded(_run, words)


def _run(words: dict[str, Any]) -> int:
    from nctakt.schedule.analysis.findings import simulation_findings  # noqa: PLC0415
    from nctakt.schedule.real.machine import check_system  # noqa: PLC0415 - not for the help
    from nctakt.schedule.real.measure import measure  # noqa: PLC0415
    from nctakt.schedule.real.names import remove_stale  # noqa: PLC0415
    from nctakt.schedule.real.report import (  # noqa: PLC0415
        plan_document,
        plan_report,
        run_document,
        run_findings,
        run_report,
    )
    from nctakt.schedule.real.run import run_plan  # noqa: PLC0415
    from nctakt.schedule.reports.report import response_report  # noqa: PLC0415
    from nctakt.schedule.simulation.simulate import simulate  # noqa: PLC0415

    check_system()
    read = read_list(words)
    collector = Collector()
    load = _on_this_machine(read_model_load(read, words, collector), collector)
    model = make_model(read, load, words, collector)
    plan = _plan(read, model, words, collector)
    language = words["language"]
    if words["dry_run"]:
        text, document = plan_report(plan, language), plan_document(plan)
        return publish(words, read.diagnostics, collector.diagnostics, text, document)
    outputs = open_outputs(read, words)
    if names := remove_stale():
        collector.report(LEFTOVERS_REMOVED, None, names=", ".join(names))
    log = run_plan(plan, for_all_users=words["all_users"])
    measurement = measure(log, drawn_cycles(model, words))
    collector.diagnostics += run_findings(log, measurement, simulated_cycles(model, words))
    foreign = [i for i, wakeups in enumerate(log.wakeups) if wakeups is not None]
    findings = [*collector.diagnostics, *simulation_findings(measurement.run, foreign)]
    simulated = simulate(model, measurement.run.cycles, record=0)
    report = run_report(measurement, plan, simulated, language)
    if words["histogram"]:
        report += "\n".join([*response_report(measurement.run, language), ""])
    code = publish(words, read.diagnostics, findings, report, run_document(measurement, simulated))
    outputs.write(measurement.run, report)
    return code


def _on_this_machine(load: Load, collector: Collector) -> Load:
    """Return the load on the processors of this machine."""
    from nctakt.schedule.real.machine import present_cpus, usable_cpus  # noqa: PLC0415

    present, usable = present_cpus(), usable_cpus()
    for key, entry in (("cpus", load.cpus), ("offline", load.offline)):
        if entry:
            collector.report(LOAD_MACHINE_IGNORED, None, key=key, cpus=", ".join(map(str, usable)))
    offline = tuple(cpu for cpu in present if cpu not in usable)
    return replace(load, cpus=max(present), offline=offline)


def _plan(read: ListRead, model: Model, words: dict[str, Any], collector: Collector) -> Plan:
    """Return the plan of the run; raises ``Failure`` (900688, 900708)."""
    from nctakt.lists.declared.rtconf import InterruptSource  # noqa: PLC0415
    from nctakt.schedule.real.machine import fifo_refusal  # noqa: PLC0415
    from nctakt.schedule.real.names import check_name  # noqa: PLC0415
    from nctakt.schedule.real.plan import crowded_cpus, make_plan, semaphore_name  # noqa: PLC0415

    source: str | None = None
    if words["semaphore"] and model.source is not InterruptSource.SEMAPHORE:
        collector.report(SEMAPHORE_OPTION_WITHOUT_EFFECT, None)
    if model.source in (InterruptSource.HARDWARE, InterruptSource.OUTSIDE):
        collector.report(TIMER_INSTEAD_OF_INTERRUPT, None)
    elif model.source is InterruptSource.SEMAPHORE:
        source = words["semaphore"] or read.configuration.external_object_name
        if not source:
            raise Failure(*read.diagnostics, diagnostic(SEMAPHORE_NOT_NAMED))
        check_name(semaphore_name(source))
    is_fifo = not words["no_fifo"]
    if is_fifo and (reason := fifo_refusal()) is not None:
        collector.report(SCHED_FIFO_NOT_PERMITTED, None, reason=reason)
        is_fifo = False
    plan = make_plan(
        model,
        simulated_cycles(model, words),
        is_fifo=is_fifo,
        plays_external=words["stand_in"],
        source=source,
    )
    if is_fifo and not words["force"]:
        crowded = [
            diagnostic(CPU_WOULD_STARVE, cpu=cpu, demand=f"{100 * demand:.0f}")
            for cpu, demand in crowded_cpus(plan)
        ]
        if crowded:
            raise Failure(*read.diagnostics, *collector.diagnostics, *crowded)
    return plan

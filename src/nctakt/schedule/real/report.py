# SPDX-License-Identifier: MIT
"""A run for its readers: tables of text, documents for other programs, diagnostics.

In: ``RunLog``, ``Measurement``, ``Plan``, the simulation of the same model. Out: text in the user's
language, times in µs; dictionaries of plain values, as in ``schedule.reports.documents``; the
diagnostics that a simulation does not share.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.linux_run import (
    LATE_WAKEUPS,
    NOBODY_WAITS,
    POSTS_CEASED,
    POSTS_DRAINED,
    SCHEDULE_RECORDING_FULL,
    SCHEDULE_RUN_STOPPED,
)
from nctakt.schedule.analysis.findings import is_rare, us
from nctakt.schedule.model import ANY_CPU, NS_PER_US
from nctakt.schedule.real import area as layout
from nctakt.schedule.real.measure import Measurement, late_wakes, tolerated
from nctakt.schedule.real.plan import Plan, PlannedTask
from nctakt.schedule.real.run import RunLog, placement_refusals
from nctakt.schedule.reports.documents import Document, schedule_document, simulation_document
from nctakt.schedule.reports.report import (
    CLASSES,
    NONE,
    chosen_report,
    dead_time_report,
    numbers_report,
    responses,
    rounded_mean,
    table,
)
from nctakt.schedule.simulation.results import Simulation

#: Upper bounds of the histogram's steps, in µs.
_STEPS_US = (10, 20, 50, 100, 200, 500, 1000, 2000, 5000)

_FIFO = Text("SCHED_FIFO", "SCHED_FIFO")
_ORDINARY = Text("ordinary scheduling", "gewöhnliches Scheduling")


#: Periods without a post after which a semaphore counts as silent.
_SILENT_PERIODS = 4


def plan_report(plan: Plan, language: Language) -> str:
    """Return the processors, priorities and semaphores of a run."""
    heads = Text(
        "Thread|Class|CPU|Linux CPU|SCHED_FIFO|Semaphore|Run by",
        "Thread|Klasse|CPU|Linux-CPU|SCHED_FIFO|Semaphor|Ausgeführt von",
    )
    ours, foreign = (
        Text("a process of the run", "einem Prozess des Laufs"),
        Text("another program", "einem anderen Programm"),
    )
    rows = []
    for planned in plan.tasks:
        task = planned.task
        is_any = task.cpu == ANY_CPU
        rows.append(
            [
                task.name,
                CLASSES[task.kind].get(language),
                "any" if is_any else str(task.cpu),
                "any" if is_any else str(task.cpu - 1),
                _priority(plan, planned),
                planned.semaphore or NONE,
                (ours if planned.has_process else foreign).get(language),
            ]
        )
    names = heads.get(language).split("|")
    lines = [*chosen_report(plan.model, language), "", *table(names, rows, left=len(names))]
    return "\n".join(lines) + "\n"


def _priority(plan: Plan, planned: PlannedTask) -> str:
    """Return the priority of a thread; in brackets the one for an external program."""
    if not plan.is_fifo:
        return NONE
    return str(planned.priority) if planned.has_process else f"({planned.priority})"


def run_report(
    measurement: Measurement, plan: Plan, simulated: Simulation, language: Language
) -> str:
    """Return all numbers of a run as text."""
    run = measurement.run
    ran = Text(
        "Run: {cycles} NC cycles, {duration} µs, {jobs} jobs; {how}",
        "Gelaufen: {cycles} NC-Takte, {duration} µs, {jobs} Aufträge; {how}",
    )
    line = ran.get(language).format(
        cycles=run.cycles,
        duration=us(run.duration),
        jobs=run.jobs,
        how=(_FIFO if plan.is_fifo else _ORDINARY).get(language),
    )
    lines = [*chosen_report(run.model, language), line]
    if run.model.windows:
        kept = Text(
            "The time of Windows counts as kept if at most {us} µs of it are missing",
            "Die Zeit von Windows gilt als gewahrt, wenn höchstens {us} µs fehlen",
        )
        lines.append(kept.get(language).format(us=us(tolerated(run.model))))
    lines += [*dead_time_report(run.model, language), "", *numbers_report(run, language)]
    lines += ["", *_punctuality(measurement, plan, language)]
    lines += ["", *_comparison(run, simulated, language)]
    return "\n".join(lines) + "\n"


def _punctuality(measurement: Measurement, plan: Plan, language: Language) -> list[str]:
    """Return histograms of the timer's delay and of each thread's wake-up latency."""
    columns = [(Text("Timer", "Timer").get(language), measurement.timer)]
    for planned in sorted(plan.tasks, key=lambda task: task.number):
        if planned.has_process:
            columns.append((planned.task.name, measurement.wakes[planned.number]))
    head = Text("Wake-up latency, µs", "Aufwachverzögerung, µs").get(language)
    rows = [
        [name.get(language), *(us(value(times)) if times else NONE for _, times in columns)]
        for name, value in (
            (Text("least", "kleinste"), min),
            (Text("mean", "mittlere"), _mean),
            (Text("most", "größte"), max),
        )
    ]
    low = 0
    for high in (*_STEPS_US, None):
        name = f"{low} … {high}" if high is not None else f"{low} …"
        bounds = (low * NS_PER_US, None if high is None else high * NS_PER_US)
        rows.append([name, *(str(_within(times, *bounds)) for _, times in columns)])
        low = high or 0
    return table([head, *(name for name, _ in columns)], rows)


def _mean(times: tuple[int, ...]) -> int:
    return rounded_mean(sum(times), len(times))


def _within(times: tuple[int, ...], low: int, high: int | None) -> int:
    """Return the number of times from ``low`` to below ``high``; the first step has early ones."""
    return sum((time >= low or not low) and (high is None or time < high) for time in times)


def _comparison(run: Simulation, simulated: Simulation, language: Language) -> list[str]:
    """Return the numbers of each thread, simulated and measured."""
    heads = Text(
        "Thread||Due|Done|Overflows|Lost|Suspended|Load %|R min|R mean|R max",
        "Thread||Fällig|Fertig|Überläufe|Verloren|Suspendiert|Last %|R min|R mittel|R max",
    )
    rows = []
    for i, task in enumerate(run.model.tasks):
        for name, measured in (
            (Text("simulated", "simuliert"), simulated),
            (Text("run", "gelaufen"), run),
        ):
            numbers = measured.tasks[i]
            rows.append(
                [
                    task.name if measured is simulated else "",
                    name.get(language),
                    str(numbers.due),
                    str(numbers.completed),
                    str(numbers.overflows),
                    str(numbers.lost),
                    str(numbers.suspensions),
                    f"{100 * numbers.busy / measured.duration:.2f}",
                    *responses(numbers),
                ]
            )
    return table(heads.get(language).split("|"), rows, left=2)


def run_findings(log: RunLog, measurement: Measurement, requested: int) -> Iterator[Diagnostic]:
    """Yield the diagnostics of a run; ``requested``: the number of NC cycles of the command."""
    cycles = measurement.run.cycles
    yield from placement_refusals(log)
    if log.was_stopped:
        yield diagnostic(SCHEDULE_RUN_STOPPED, cycles=cycles)
    is_shorter = cycles == log.plan.cycles < requested
    if log.is_cut or is_shorter:
        yield diagnostic(SCHEDULE_RECORDING_FULL, cycles=cycles)
    if late := late_wakes(measurement):
        yield diagnostic(LATE_WAKEUPS, count=len(late), latest=us(max(late)))
    if log.plan.source is not None:
        yield from _source_findings(log, log.plan.source)
    yield from _unattended_semaphores(log)


def _source_findings(log: RunLog, name: str) -> Iterator[Diagnostic]:
    """Yield the diagnostics of the semaphore that triggers the NC interrupts."""
    if log.drained:
        yield diagnostic(POSTS_DRAINED, name=name, count=log.drained)
    interrupts = log.entries[log.entries["kind"] == layout.INTERRUPT]
    moments: list[int] = [*interrupts["value"].tolist(), log.end]
    period = log.plan.model.train.distance
    gap, begin = max((after - before, before) for before, after in pairwise(moments))
    if gap > _SILENT_PERIODS * period:
        yield diagnostic(POSTS_CEASED, name=name, gap=us(gap), time=us(begin), expected=us(period))


def _unattended_semaphores(log: RunLog) -> Iterator[Diagnostic]:
    """Yield a diagnostic for each external thread's semaphore with hardly any waiting process."""
    for task in log.plan.tasks:
        wakeups = log.wakeups[task.number]
        posts = log.posts[task.number]
        if wakeups is not None and posts and is_rare(wakeups, posts):
            yield diagnostic(NOBODY_WAITS, name=task.semaphore, taken=wakeups, count=posts)


def plan_document(plan: Plan) -> Document:
    """Return the threads of a run with their priorities, processors and semaphores."""
    return {
        "schedule": schedule_document(plan.model),
        "is_fifo": plan.is_fifo,
        "threads": [
            {
                "key": planned.task.key,
                "name": planned.task.name,
                "class": planned.task.kind.value,
                "linux_cpu": None if planned.task.cpu == ANY_CPU else planned.task.cpu - 1,
                "fifo_priority": planned.priority if plan.is_fifo else None,
                "semaphore": planned.semaphore or None,
                "has_process": planned.has_process,
            }
            for planned in plan.tasks
        ],
    }


def run_document(measurement: Measurement, simulated: Simulation) -> Document:
    """Return a run, its punctuality, and the simulation for comparison."""
    names = [task.key for task in measurement.run.model.tasks]
    return {
        **simulation_document(measurement.run, {}),
        "simulated": simulation_document(simulated, {}),
        "latencies_us": {
            "timer": [time / NS_PER_US for time in measurement.timer],
            **{
                name: [time / NS_PER_US for time in times]
                for name, times in zip(names, measurement.wakes, strict=True)
            },
        },
    }

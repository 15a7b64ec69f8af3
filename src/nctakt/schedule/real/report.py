# SPDX-License-Identifier: MIT
"""A run as tables of text: its numbers, its punctuality, and the simulation for comparison.

In: ``Measurement``, ``Plan``, the simulation of the same model. Out: text in the user's language,
times in µs.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Language, Text
from nctakt.schedule.analysis.findings import us
from nctakt.schedule.model import ANY_CPU, NS_PER_US
from nctakt.schedule.real.measure import Measurement, tolerated
from nctakt.schedule.real.plan import Plan, PlannedTask
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

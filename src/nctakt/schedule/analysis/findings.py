# SPDX-License-Identifier: MIT
"""Findings of a simulation or an analysis.

In: ``Simulation`` or ``Analysis``. Out: diagnostics, in the order of the tasks and processors.
"""

from __future__ import annotations

from collections.abc import Container, Iterator

from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.schedule_results import (
    CPU_DEMAND_TOO_HIGH,
    SUSPENSION_TOO_LATE,
    THREAD_CAN_OVERFLOW,
    THREAD_FALLS_BEHIND,
    THREAD_HARDLY_COMPLETES,
    THREAD_OVERFLOWED,
    WINDOWS_TIME_CAN_BE_VIOLATED,
    WINDOWS_TIME_VIOLATED,
    WINDOWS_WITHOUT_GUARANTEE,
)
from nctakt.schedule.analysis.analyse import Analysis
from nctakt.schedule.model import NS_PER_US, Model
from nctakt.schedule.simulation.results import Simulation, WindowsNumbers

#: A thread that finishes less often than once in this many activations hardly ever finishes.
_RARE = 10
#: This many consecutive activations waiting at the end are more than a passing delay.
_BACKLOG = 3
_LATE = "late suspension"


def us(time: int) -> str:
    """Return a time in ns as text in µs, with decimals only where it has some."""
    return f"{time / NS_PER_US:.3f}".rstrip("0").rstrip(".")


def simulation_findings(run: Simulation, foreign: Container[int] = ()) -> Iterator[Diagnostic]:
    """Yield the findings of a schedule.

    ``foreign``: tasks in processes of other programs, of which only wake-ups are known.
    """
    for task, numbers in zip(run.model.tasks, run.tasks, strict=True):
        if task.error_on_overflow and numbers.first_overflow is not None:
            first = us(numbers.first_overflow)
            yield diagnostic(
                THREAD_OVERFLOWED, thread=task.name, count=numbers.overflows, time=first
            )
    yield from starvation_findings(run, foreign)
    if run.missed_suspensions:
        yield diagnostic(SUSPENSION_TOO_LATE, count=run.missed_suspensions, cycles=run.cycles)
    for windows in run.windows[:-1]:
        if run.model.windows and windows.violated:
            yield diagnostic(
                WINDOWS_TIME_VIOLATED,
                cpu=windows.cpu,
                windows=us(run.model.windows),
                count=windows.violated,
                cycles=run.cycles,
                who=culprits(run.model, windows),
            )
    longest = [numbers.response_max or 0 for numbers in run.tasks]
    yield from _without_windows_time(run.model, longest, run.windows[-1].minimum)


def starvation_findings(run: Simulation, foreign: Container[int] = ()) -> Iterator[Diagnostic]:
    """Yield threads that hardly ever finish or fall behind, regardless of error_on_overflow."""
    for i, (task, numbers) in enumerate(zip(run.model.tasks, run.tasks, strict=True)):
        if i in foreign or not numbers.overflows:
            continue
        waiting = numbers.due - numbers.lost - numbers.completed
        if is_rare(numbers.completed, numbers.due):
            yield diagnostic(
                THREAD_HARDLY_COMPLETES,
                thread=task.name,
                completed=numbers.completed,
                due=numbers.due,
            )
        elif waiting >= _BACKLOG:
            yield diagnostic(
                THREAD_FALLS_BEHIND, thread=task.name, waiting=waiting, due=numbers.due
            )


def is_rare(count: int, due: int) -> bool:
    """Return whether something happens hardly ever when it is due."""
    return count * _RARE < due


def culprits(model: Model, windows: WindowsNumbers) -> str:
    """Return the tasks that ran in Windows' time, each with its number of cycles."""
    names = [
        f"{task.name} {count}"
        for task, count in zip(model.tasks, windows.culprits, strict=True)
        if count
    ]
    if windows.late:
        names.append(f"{_LATE} {windows.late}")
    return ", ".join(names)


def _without_windows_time(model: Model, responses: list[int], minimum: int) -> Iterator[Diagnostic]:
    """Without guaranteed time all threads should finish in each cycle."""
    if model.windows:
        return
    for task, response in zip(model.tasks, responses, strict=True):
        if response > model.cycle:
            reason = Text(
                f"{task.name} needs longer than one NC cycle",
                f"{task.name} braucht länger als einen NC-Takt",
            )
            yield diagnostic(WINDOWS_WITHOUT_GUARANTEE, what=reason)
            return
    if minimum == 0:
        reason = Text(
            "Windows gets no time in some cycles", "Windows bekommt in manchen Takten keine Zeit"
        )
        yield diagnostic(WINDOWS_WITHOUT_GUARANTEE, what=reason)


def analysis_findings(analysis: Analysis) -> Iterator[Diagnostic]:
    """Yield diagnostics of possible problems when all tasks run as long as they can."""
    model = analysis.model
    for cpu in analysis.cpus:
        if cpu.demand > cpu.suspendable_supply:
            yield diagnostic(
                CPU_DEMAND_TOO_HIGH,
                cpu=cpu.cpu,
                demand=f"{100 * cpu.demand:.2f}",
                supply=f"{100 * cpu.suspendable_supply:.2f}",
            )
        if cpu.reaches_windows:
            names = [model.tasks[i].name for i in cpu.intruders]
            who = ", ".join([*names, _LATE] if cpu.is_late else names)
            yield diagnostic(
                WINDOWS_TIME_CAN_BE_VIOLATED, cpu=cpu.cpu, windows=us(model.windows), who=who
            )
    for task, bound in zip(model.tasks, analysis.tasks, strict=True):
        if bound.can_overflow:
            response = "∞" if bound.response is None else f"{us(bound.response)} µs"
            yield diagnostic(
                THREAD_CAN_OVERFLOW, thread=task.name, response=response, cycle=us(bound.period)
            )
    responses = [bound.response or 0 for bound in analysis.tasks]
    yield from _without_windows_time(model, responses, 1)

# SPDX-License-Identifier: MIT
"""Response times in closed form, without simulation.

In: ``Model``. Out: ``Analysis``. All tasks are taken as due together at the first interrupt, with
the longest execution times. A task that is never suspended answers at the smallest t that holds its
own work and that of all more urgent ones due before t; one that can be suspended at the smallest t
whose supply, the part of the cycles that is not Windows', holds them.

Exact when NC and timer interrupts fall together, nothing overflows, and what cannot be suspended
never reaches into Windows' time; otherwise an upper bound. Overheads for switching are not part of
it, those for activation are. Tasks of equal urgency are taken as more urgent.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import lcm

from nctakt.schedule.model import ANY_CPU, Model, Task, TaskClass

#: Steps of the search for one response; a schedule that needs more counts as unbounded.
MOST_STEPS = 10_000


@dataclass(frozen=True, slots=True)
class TaskAnalysis:
    """One task; times in ns. ``response`` ``None``: no bound. ``slack`` is period - response."""

    demand: int
    period: int
    response: int | None
    can_overflow: bool

    @property
    def slack(self) -> int | None:
        """What is left of the period."""
        return None if self.response is None else self.period - self.response


@dataclass(frozen=True, slots=True)
class CpuAnalysis:
    """One processor; shares of its time as numbers from 0 on.

    ``demand``: of all tasks; ``suspendable_supply``: what is not guaranteed to Windows.
    ``reaches_windows``: what cannot be suspended may run in Windows' time; ``intruders`` are
    those tasks.
    """

    cpu: int
    demand: float
    suspendable_supply: float
    reaches_windows: bool
    intruders: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Analysis:
    """The analysis of a model; ``None`` for tasks that the operating system places.

    ``is_exact``: the responses are those of the simulation, not bounds.
    """

    model: Model
    tasks: tuple[TaskAnalysis | None, ...]
    cpus: tuple[CpuAnalysis, ...]
    is_exact: bool

    @property
    def can_overflow(self) -> bool:
        """Whether any task may be due while it is still busy."""
        return any(one is not None and one.can_overflow for one in self.tasks)


def analyse(model: Model) -> Analysis:
    """Analyse a model."""
    supply = _Supply(model)
    cpus = tuple(_analyse_cpu(model, cpu, supply) for cpu in model.cpus)
    reaching = [one.cpu for one in cpus if one.reaches_windows]
    tasks = tuple(
        None
        if task.cpu == ANY_CPU and len(model.cpus) > 1
        else _analyse_task(model, i, supply, reaches=(task.cpu or model.cpus[0]) in reaching)
        for i, task in enumerate(model.tasks)
    )
    urgencies = [(task.cpu, task.urgency) for task in model.tasks if task.calls]
    exact = (
        model.is_synchronous
        and not reaching
        and len(set(urgencies)) == len(urgencies)
        and model.overheads.switch == 0
        and all(one is not None and not one.can_overflow for one in tasks)
        and all(call.execution.is_constant for task in model.tasks for call in task.calls)
    )
    return Analysis(model, tasks, cpus, exact)


class _Supply:
    """The time that suspendable tasks can have: in each cycle up to the point of suspension."""

    def __init__(self, model: Model) -> None:
        train = model.train
        # Jitter can bring two interrupts closer together.
        self.cycle = max(1, train.distance - 2 * train.jitter)
        self.windows_cpus = model.windows_cpus
        before = model.cycle - model.windows
        if not model.windows:
            before = self.cycle
        elif model.rules.suspension == "ticks" and not model.is_synchronous:
            # The first timer interrupt can come at once behind the NC interrupt.
            before -= model.slice
        self.each = max(0, min(self.cycle, before))

    def amount(self, time: int) -> int:
        """What there is from an interrupt on up to ``time``."""
        full, rest = divmod(time, self.cycle)
        return full * self.each + min(rest, self.each)

    def moment(self, amount: int) -> int:
        """The earliest time by which there is ``amount``; the supply must not be empty."""
        if amount <= 0:
            return 0
        full = (amount - 1) // self.each
        return full * self.cycle + amount - full * self.each


def _work(model: Model, task: Task) -> int:
    return task.longest + model.overheads.activation if task.calls else 0


def _neighbours(model: Model, i: int) -> list[Task]:
    """The other tasks of the same processor that are not less urgent."""
    own = model.tasks[i]
    return [
        task
        for k, task in enumerate(model.tasks)
        if k != i and task.calls and _same_cpu(task, own) and task.urgency >= own.urgency
    ]


def _same_cpu(one: Task, other: Task) -> bool:
    return one.cpu == other.cpu or ANY_CPU in (one.cpu, other.cpu)


def _analyse_task(model: Model, i: int, supply: _Supply, *, reaches: bool) -> TaskAnalysis:
    task = model.tasks[i]
    period = task.every * supply.cycle
    demand = _work(model, task)
    if not task.calls:
        return TaskAnalysis(0, period, 0, False)
    response = _response(model, i, supply, reaches=reaches)
    return TaskAnalysis(demand, period, response, response is None or response > period)


def _response(model: Model, i: int, supply: _Supply, *, reaches: bool) -> int | None:
    task = model.tasks[i]
    above = _neighbours(model, i)
    suspended = _on_windows(task, supply) and task.kind is TaskClass.ASYNCHRONOUS
    if suspended and not supply.each:
        return None
    work = _work(model, task)
    if suspended:
        limit = _limit(model, above, supply, supply.each)
        time = _start(model, above, supply, supply.each, work - supply.each)
    else:
        limit = _limit(model, above, supply, supply.cycle)
        always = [one for one in above if one.kind is not TaskClass.ASYNCHRONOUS]
        time = _start(model, always, supply, supply.cycle, work)
    for _ in range(MOST_STEPS):
        fixed, stoppable = _demand(model, above, time, supply)
        if suspended:
            needed = supply.moment(work + fixed + stoppable)
        else:
            if _on_windows(task, supply) and stoppable:
                free = supply.amount(time) - (0 if reaches else fixed)
                stoppable = min(stoppable, max(0, free))
            needed = work + fixed + stoppable
        if needed <= time:
            return needed
        time = needed
        if limit is not None and time > limit + work:
            return None
    return None


def _on_windows(task: Task, supply: _Supply) -> bool:
    return task.cpu == ANY_CPU or task.cpu in supply.windows_cpus


def _demand(model: Model, above: Sequence[Task], time: int, supply: _Supply) -> tuple[int, int]:
    """The work due before ``time`` of tasks that are never suspended, and of the others."""
    fixed = stoppable = 0
    for task in above:
        work = -(-time // (task.every * supply.cycle)) * _work(model, task)
        if task.kind is TaskClass.ASYNCHRONOUS:
            stoppable += work
        else:
            fixed += work
    return fixed, stoppable


def _hyperperiod(model: Model, above: Sequence[Task]) -> tuple[int, int]:
    """After how many cycles the same tasks are due again, and their work up to then."""
    cycles = lcm(1, *(task.every for task in above))
    return cycles, sum(cycles // task.every * _work(model, task) for task in above)


def _limit(model: Model, above: Sequence[Task], supply: _Supply, each: int) -> int | None:
    """Where the search may end without a result; ``None``: there is always one.

    When one hyperperiod brings at least as much work as time, the next one finds the same, or more.
    """
    cycles, brought = _hyperperiod(model, above)
    return cycles * supply.cycle if brought >= cycles * each else None


def _start(model: Model, above: Sequence[Task], supply: _Supply, each: int, work: int) -> int:
    """A time before which there is no response: ``work`` at the rate that the others leave."""
    cycles, brought = _hyperperiod(model, above)
    left = cycles * each - brought
    return max(1, work * cycles * supply.cycle // left) if left > 0 else 1


def _analyse_cpu(model: Model, cpu: int, supply: _Supply) -> CpuAnalysis:
    own = [(i, task) for i, task in enumerate(model.tasks) if task.cpu in (cpu, ANY_CPU)]
    demand = sum(_work(model, task) / (task.every * supply.cycle) for _, task in own)
    guaranteed = cpu in model.windows_cpus and model.windows > 0
    share = supply.each / supply.cycle if guaranteed else 1.0
    intruders: list[int] = []
    if guaranteed:
        fixed = [(i, task) for i, task in own if task.kind is not TaskClass.ASYNCHRONOUS]
        for i, task in fixed:
            response = _response(model, i, supply, reaches=True)
            if task.calls and (response is None or response > supply.each):
                intruders.append(i)
    return CpuAnalysis(cpu, demand, share, bool(intruders), tuple(intruders))

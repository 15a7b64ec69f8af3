# SPDX-License-Identifier: MIT
"""Response times in closed form, without simulation.

In: ``Model``. Out: ``Analysis``. A response is never below that of any simulation of the model, for
any unspecified phase, jitter and execution times; it is marked if it is exact. ``response``
explains how they are found. Tasks of equal urgency count as more urgent.
"""

from __future__ import annotations

from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.schedule.analysis.response import Response, ResponseSearch
from nctakt.schedule.model import ANY_CPU, Model, TaskClass
from nctakt.schedule.simulation.results import Simulation
from nctakt.schedule.simulation.simulate import simulate

#: If responses that depend on each other still grow after this many rounds, there is no bound.
_MAX_ROUNDS = 100


@dataclass(frozen=True, slots=True)
class TaskAnalysis:
    """One task; times in ns. ``response`` ``None``: no bound.

    ``period``: the shortest time between two activations. ``slack``: the rest of it.
    ``can_overflow``: the task may still be busy when it is due again. ``is_exact``: the response is
    that of a simulation, not only a bound.
    """

    demand: int
    period: int
    response: int | None
    can_overflow: bool
    is_exact: bool

    @property
    def slack(self) -> int | None:
        """Return the part of the period that is left, in ns."""
        return None if self.response is None else self.period - self.response


@dataclass(frozen=True, slots=True)
class CpuAnalysis:
    """One processor; shares of its time as numbers from 0 on.

    ``demand``: of all tasks. ``suspendable_supply``: the time not guaranteed to Windows.
    ``intruders``: tasks that can run in Windows' time. ``is_late``: suspension itself can come too
    late for Windows' time.
    """

    cpu: int
    demand: float
    suspendable_supply: float
    intruders: tuple[int, ...]
    is_late: bool

    @property
    def reaches_windows(self) -> bool:
        """Return whether Windows can have less than its time."""
        return bool(self.intruders) or self.is_late


@dataclass(frozen=True, slots=True)
class Analysis:
    """The analysis of a model.

    ``phases``: for tasks whose bound holds for the worst phase of an NC interrupt, where the model
    leaves it open, that phase in ns.
    """

    model: Model
    tasks: tuple[TaskAnalysis, ...]
    cpus: tuple[CpuAnalysis, ...]
    phases: dict[int, int]

    @property
    def can_overflow(self) -> bool:
        """Return whether any task may be due while it is still busy."""
        return any(task.can_overflow for task in self.tasks)

    @property
    def is_exact(self) -> bool:
        """Return whether all responses are those of the simulation."""
        return all(task.is_exact for task in self.tasks)


def analyse(model: Model) -> Analysis:
    """Return the analysis of a model: bounds of all responses, in ns."""
    search = ResponseSearch(model)
    responses = _responses(search)
    tasks = tuple(
        TaskAnalysis(
            search.work[i].longest(1),
            search.period(i),
            response.time,
            response.can_overflow,
            response.is_exact,
        )
        for i, response in enumerate(responses)
    )
    cpus = tuple(_analyse_cpu(search, cpu, tasks) for cpu in model.cpus)
    return Analysis(model, tasks, cpus, _worst_phases(search))


def _responses(search: ResponseSearch) -> list[Response]:
    """Return the responses of all tasks.

    Where work left from before counts, a response depends on others, and equally urgent tasks on
    each other: all grow from 0 until none changes. A response that does not stop growing has no
    bound.
    """
    tasks = search.model.tasks
    order = sorted(range(len(tasks)), key=lambda i: -tasks[i].urgency)
    responses = [Response(0)] * len(tasks)
    times: list[int | None] = [0] * len(tasks)
    while True:
        before = list(times)
        for _ in range(_MAX_ROUNDS):
            before = list(times)
            for i in order:
                if times[i] is not None:
                    responses[i] = search.response(i, times)
                    times[i] = responses[i].time
            if times == before:
                return responses
        for i in order:
            if times[i] != before[i]:
                responses[i], times[i] = Response(None), None


def _worst_phases(search: ResponseSearch) -> dict[int, int]:
    """Return the phase that is assumed for each task whose suspension depends on it."""
    offsets = search.offsets
    phases: dict[int, int] = {}
    if offsets.earliest_phase is None or offsets.latest_phase is None:
        return phases
    tasks = search.model.tasks
    for i, task in enumerate(tasks):
        guarded = [cpu for cpu in search.cpus_of(i) if search.is_guarded(cpu)]
        if not task.calls or not guarded:
            continue
        if task.kind is TaskClass.ASYNCHRONOUS:
            phases[i] = offsets.earliest_phase
        elif any(
            tasks[k].kind is TaskClass.ASYNCHRONOUS
            for cpu in guarded
            for k in search.more_urgent(i, cpu)
        ):
            phases[i] = offsets.latest_phase
    return phases


def _analyse_cpu(search: ResponseSearch, cpu: int, tasks: tuple[TaskAnalysis, ...]) -> CpuAnalysis:
    model = search.model
    own = [i for i, task in enumerate(model.tasks) if task.cpu in (cpu, ANY_CPU)]
    distance = model.train.distance
    demand = sum(search.work[i].mean / (model.tasks[i].every * distance) for i in own)
    if not search.is_guarded(cpu):
        return CpuAnalysis(cpu, demand, 1.0, (), False)
    # Windows' time begins this long after the NC interrupt in the shortest cycle.
    begin = search.arrivals.earliest(1) - model.windows
    intruders = tuple(
        i
        for i in own
        if model.tasks[i].kind is not TaskClass.ASYNCHRONOUS
        and ((response := tasks[i].response) is None or response > max(0, begin))
    )
    has_suspendable = any(
        model.tasks[i].kind is TaskClass.ASYNCHRONOUS and model.tasks[i].calls for i in own
    )
    is_late = has_suspendable and search.offsets.latest > max(0, begin)
    share = search.supply.min_per_cycle / distance
    return CpuAnalysis(cpu, demand, share, intruders, is_late)


# --- worst phases ---------------------------------------------------------------------------------


def simulate_worst_phases(run: Simulation) -> dict[int, Simulation]:
    """Return the simulations of as many cycles, by phase in ns."""
    model = run.model
    if model.train.is_phase_known:
        return {}
    phases = sorted(set(analyse(model).phases.values()))
    return {
        phase: simulate(
            replace(model, train=replace(model.train, phase=phase)), run.cycles, record=0
        )
        for phase in phases
    }

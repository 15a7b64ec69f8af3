# SPDX-License-Identifier: MIT
"""The plan of a run: times of the NC interrupts, execution times of the calls, tasks.

In: ``Model``, the number of NC cycles. Out: ``Plan``. Interrupts and execution times are drawn in
the order of the simulation with the same seed, so both have the same numbers as long as nothing
overflows.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import ANY_CPU, Model, Task, TaskClass
from nctakt.schedule.simulation.chance import Chance
from nctakt.schedule.simulation.work import Work

#: The priority of SCHED_FIFO of the highest-priority thread; the scheduler has 90.
HIGHEST_PRIORITY = 80
#: Maximum number of NC cycles of a run.
MAX_CYCLES = 1_000_000
#: Maximum number of different execution times of a task; then they repeat from the first one.
MAX_TIMES = 200_000
#: The share of a processor from which on its other programs could come to a standstill.
_CROWDED = 0.95
#: Maximum ratio of a semaphore's posts to the expected NC interrupts.
_MAX_POSTS = 4


@dataclass(frozen=True, slots=True)
class PlannedTask:
    """A task of the run; ``number`` is its index in the model.

    ``times``: one row of execution times for each job, in ns, repeated after the last row.
    ``activations``: their maximum number. ``semaphore``: with its slash, of an external thread.
    ``has_process``: whether a process of the run plays it.
    """

    task: Task
    number: int
    priority: int
    times: npt.NDArray[np.int64]
    activations: int
    semaphore: str
    has_process: bool


@dataclass(frozen=True, slots=True)
class Plan:
    """A run: ``moments`` of the NC interrupts in ns, including the end of the last cycle.

    ``tasks``: by descending priority. ``phase``: the time of a timer interrupt in ns. ``source``:
    the semaphore that triggers the NC interrupts instead of ``moments``, with its slash.
    """

    model: Model
    cycles: int
    moments: tuple[int, ...]
    phase: int
    tasks: tuple[PlannedTask, ...]
    is_fifo: bool
    source: str | None = None


def semaphore_name(name: str) -> str:
    """Return the name of a semaphore for the system, with its slash."""
    return name if name.startswith("/") else f"/{name}"


def make_plan(
    model: Model, cycles: int, *, is_fifo: bool, plays_external: bool, source: str | None = None
) -> Plan:
    """Return the plan of ``cycles`` NC cycles, at most ``MAX_CYCLES``.

    ``source``: the list's ``external_object_name``.
    """
    assert cycles > 0
    cycles = min(cycles, MAX_CYCLES)
    chance = Chance(model.seed)
    works = [Work(task, 0, chance) for task in model.tasks]
    moments, rows = _draw(model, cycles, works, chance)
    shift = _earliest(model)
    ranks = sorted({task.urgency for task in model.tasks}, reverse=True)
    many = cycles if source is None else _MAX_POSTS * cycles + 16
    tasks = [
        PlannedTask(
            task,
            number,
            max(1, HIGHEST_PRIORITY - ranks.index(task.urgency)),
            _table(rows[number], len(task.calls)),
            -(-many // task.every),
            semaphore_name(task.name) if task.kind is TaskClass.EXTERNAL else "",
            task.kind is not TaskClass.EXTERNAL or plays_external,
        )
        for number, task in enumerate(model.tasks)
    ]
    tasks.sort(key=lambda planned: (-planned.task.urgency, planned.number))
    is_timer = model.source is InterruptSource.TIMER
    return Plan(
        model,
        cycles,
        tuple(moment + shift for moment in moments),
        model.train.phase if is_timer else 0,
        tuple(tasks),
        is_fifo,
        None if source is None else semaphore_name(source),
    )


def _table(times: list[int], calls: int) -> npt.NDArray[np.int64]:
    """Return the execution times of a task, one row for each job; without calls an empty row."""
    return np.array(times, np.int64).reshape(len(times) // calls if calls else 1, calls)


def _earliest(model: Model) -> int:
    """Return the time slices to add to all moments so that none is negative, in ns."""
    min_moment = model.train.phase - model.train.jitter
    return -(min_moment // model.slice) * model.slice if min_moment < 0 else 0


def _draw(
    model: Model, cycles: int, works: list[Work], chance: Chance
) -> tuple[list[int], list[list[int]]]:
    """Return the times of all interrupts, and the execution times of each task's jobs in a row."""
    train = model.train

    def interrupt(number: int) -> int:
        moment = train.phase + number * train.distance
        return moment + (chance.randint(-train.jitter, train.jitter) if train.jitter else 0)

    moments = [interrupt(0)]
    rows: list[list[int]] = [[] for _ in works]
    for cycle in range(cycles):
        moments.append(interrupt(cycle + 1))
        for row, work, task in zip(rows, works, model.tasks, strict=True):
            if not task.calls or cycle % task.every or len(row) >= MAX_TIMES:
                continue
            if not work.is_constant or not row:
                work.draw()
                row.extend(work.times)
    return moments, rows


def crowded_cpus(plan: Plan) -> list[tuple[int, float]]:
    """Return the processors that threads may use up almost completely, each with their share."""
    model = plan.model
    crowded: list[tuple[int, float]] = []
    for cpu in model.cpus:
        own = [
            planned
            for planned in plan.tasks
            if planned.has_process and planned.task.cpu in (cpu, ANY_CPU)
        ]
        demands = [
            (planned.task.kind, planned.task.longest / (planned.task.every * model.train.distance))
            for planned in own
        ]
        firm = sum(demand for kind, demand in demands if kind is not TaskClass.ASYNCHRONOUS)
        loose = sum(demand for kind, demand in demands if kind is TaskClass.ASYNCHRONOUS)
        if cpu in model.windows_cpus:
            loose = min(loose, max(0.0, 1 - model.windows / model.cycle - firm))
        if firm + loose >= _CROWDED:
            crowded.append((cpu, firm + loose))
    return crowded

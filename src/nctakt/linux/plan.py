# SPDX-License-Identifier: MIT
"""What a run is going to do: when NC interrupts come, how long each call works, who is who.

In: ``Model``, the number of NC cycles. Out: ``Plan``. Interrupts and execution times are drawn in
the order of the simulation with the same seed, so both work with the same numbers as long as
nothing overflows.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.chance import Chance
from nctakt.schedule.model import ANY_CPU, Model, Task, TaskClass
from nctakt.schedule.work import Work

#: The priority of SCHED_FIFO that the most urgent thread gets; the scheduler has 90.
HIGHEST_PRIORITY = 80
#: The most NC cycles of one run.
MOST_CYCLES = 1_000_000
#: So many different execution times of a task are kept, then they come again from the first.
MOST_TIMES = 200_000
#: From this share of a processor on its other programs could come to a standstill.
_CROWDED = 0.95
#: A semaphore may give so many times the NC interrupts that are expected.
_MOST_POSTS = 4


@dataclass(frozen=True, slots=True)
class PlannedTask:
    """A task of the run; ``number`` is its place in the model.

    ``times``: one row of execution times for each job, in ns, from the first row again.
    ``activations``: the most that there can be. ``semaphore``: with its slash, of an external
    thread. ``has_process``: whether it is played by a process of the run.
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
    """A run: ``moments`` of the NC interrupts in ns, the one that ends the last cycle too.

    ``tasks``: the most urgent first. ``phase``: a timer interrupt falls on it. ``source``: the
    semaphore that gives the NC interrupts, with its slash, instead of ``moments``.
    """

    model: Model
    cycles: int
    moments: tuple[int, ...]
    phase: int
    tasks: tuple[PlannedTask, ...]
    is_fifo: bool
    source: str | None = None


def semaphore_name(name: str) -> str:
    """The name of a semaphore as the system wants it."""
    return name if name.startswith("/") else f"/{name}"


def make_plan(
    model: Model, cycles: int, *, is_fifo: bool, plays_external: bool, source: str | None = None
) -> Plan:
    """The plan of ``cycles`` NC cycles, at most ``MOST_CYCLES``; ``source``: the list's
    ``external_object_name``."""
    assert cycles > 0
    cycles = min(cycles, MOST_CYCLES)
    chance = Chance(model.seed)
    works = [Work(task, 0, chance) for task in model.tasks]
    moments, rows = _draw(model, cycles, works, chance)
    shift = _earliest(model)
    ranks = sorted({task.urgency for task in model.tasks}, reverse=True)
    many = cycles if source is None else _MOST_POSTS * cycles + 16
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
    """The execution times of a task, one row for each job; without calls an empty row."""
    return np.array(times, np.int64).reshape(len(times) // calls if calls else 1, calls)


def _earliest(model: Model) -> int:
    """Return the time slices to add to all moments so that none is negative, in ns."""
    least = model.train.phase - model.train.jitter
    return -(least // model.slice) * model.slice if least < 0 else 0


def _draw(
    model: Model, cycles: int, works: list[Work], chance: Chance
) -> tuple[list[int], list[list[int]]]:
    """The moments of all interrupts, and the execution times of each task's jobs in a row."""
    train = model.train

    def interrupt(number: int) -> int:
        moment = train.phase + number * train.distance
        return moment + (chance.randint(-train.jitter, train.jitter) if train.jitter else 0)

    moments = [interrupt(0)]
    rows: list[list[int]] = [[] for _ in works]
    for cycle in range(cycles):
        moments.append(interrupt(cycle + 1))
        for row, work, task in zip(rows, works, model.tasks, strict=True):
            if not task.calls or cycle % task.every or len(row) >= MOST_TIMES:
                continue
            if not work.is_constant or not row:
                work.draw()
                row.extend(work.times)
    return moments, rows


def crowded_cpus(plan: Plan) -> list[tuple[int, float]]:
    """The processors of which threads could take so much that nothing else goes on: CPU, share."""
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

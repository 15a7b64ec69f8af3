# SPDX-License-Identifier: MIT
"""A slow, obvious scheduler: it moves on by one nanosecond and looks at everything."""

from __future__ import annotations

from dataclasses import dataclass, field

from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import Model, TaskClass


@dataclass
class Stepped:
    """What the tests compare."""

    responses: list[list[int]]
    overflows: list[int]
    lost: list[int]
    suspensions: list[int]
    busy: list[int]
    windows: list[list[int]] = field(default_factory=list)


@dataclass
class _Job:
    left: int
    due: int
    sequence: int


def step(model: Model, cycles: int) -> Stepped:
    """Run a model with constant times, no jitter, no overheads and a processor for each task."""
    tasks = model.tasks
    zeros = [0] * len(tasks)
    out = Stepped([[] for _ in tasks], [*zeros], [*zeros], [*zeros], [*zeros])
    jobs: list[_Job | None] = [None] * len(tasks)
    waiting: list[list[int]] = [[] for _ in tasks]
    suspended = [False] * len(tasks)
    is_timer = model.source is InterruptSource.TIMER
    distance = model.train.distance
    end = model.train.phase + cycles * distance
    cycle, opened, ticks, closed, sequence = -1, 0, 0, False, 0
    for now in range(model.train.phase, end + 1):
        is_nc = (now - model.train.phase) % distance == 0
        origin = model.train.phase if is_timer else 0
        is_tick = (now - origin) % model.slice == 0
        # A tick belongs to the cycle before; the timer's own NC interrupt is no tick.
        due_ticks = (model.cycle - model.windows) // model.slice
        if is_tick and cycle >= 0 and not (is_timer and is_nc):
            ticks += 1
            counted = ticks >= due_ticks
            elapsed = now - opened >= model.cycle - model.windows
            if model.windows and not closed:
                if counted if model.rules.suspension == "ticks" else elapsed:
                    closed = True
                    _suspend(model, jobs, suspended, out)
        if is_nc:
            if now == end:
                break
            cycle, opened, ticks, closed = cycle + 1, now, 0, False
            suspended = [False] * len(tasks)
            out.windows.append([0] * len(model.windows_cpus))
            for i, task in enumerate(tasks):
                if cycle % task.every or not task.calls:
                    continue
                if jobs[i] is None:
                    jobs[i] = _Job(task.longest, now, sequence)
                    sequence += 1
                    continue
                out.overflows[i] += 1
                policy = model.rules.overflow
                if task.kind is TaskClass.EXTERNAL:
                    policy = "queue"
                if policy == "queue" or (policy == "pend" and not waiting[i]):
                    waiting[i].append(now)
                else:
                    out.lost[i] += 1
            if model.windows and due_ticks <= 0:
                closed = True
                _suspend(model, jobs, suspended, out)
        for cpu in model.cpus:
            ready = [
                (-tasks[i].urgency, job.sequence, i)
                for i, job in enumerate(jobs)
                if job is not None and not suspended[i] and tasks[i].cpu == cpu
            ]
            if not ready:
                if cpu in model.windows_cpus:
                    out.windows[-1][model.windows_cpus.index(cpu)] += 1
                continue
            i = min(ready)[2]
            job = jobs[i]
            assert job is not None
            job.left -= 1
            out.busy[i] += 1
            if job.left == 0:
                out.responses[i].append(now + 1 - job.due)
                jobs[i] = None
                if waiting[i]:
                    jobs[i] = _Job(tasks[i].longest, waiting[i].pop(0), job.sequence)
    return out


def _suspend(model: Model, jobs: list[_Job | None], suspended: list[bool], out: Stepped) -> None:
    for i, task in enumerate(model.tasks):
        on_windows = task.cpu in model.windows_cpus
        if task.kind is TaskClass.ASYNCHRONOUS and on_windows and jobs[i] is not None:
            suspended[i] = True
            out.suspensions[i] += 1

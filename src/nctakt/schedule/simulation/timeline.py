# SPDX-License-Identifier: MIT
"""Times of a record between its events: timer interrupts, the time of Windows, suspensions.

In: a simulation with a record. Out: moments and times in ns.
"""

from __future__ import annotations

from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import Model
from nctakt.schedule.simulation.results import EventKind, Simulation


def tick_times(model: Model, begin: int, end: int) -> range:
    """Return the timer interrupts from ``begin`` to ``end``."""
    origin = model.train.phase if model.source is InterruptSource.TIMER else 0
    first = begin + (origin - begin) % model.slice
    return range(first, end + 1, model.slice)


def windows_times(run: Simulation, cpu: int) -> list[tuple[int, int]]:
    """Return the times in the record without a task on the processor, from and to in ns."""
    record = run.record
    free: list[tuple[int, int]] = []
    now = record.begin
    for segment in record.segments:
        if segment.cpu == cpu:
            if segment.begin > now:
                free.append((now, segment.begin))
            now = max(now, segment.end)
    if now < record.end:
        free.append((now, record.end))
    return free


def suspended_times(run: Simulation, task: int) -> list[tuple[int, int]]:
    """Return the times in the record in which a task is suspended, from and to in ns."""
    times: list[tuple[int, int]] = []
    begin: int | None = None
    for event in run.record.events:
        if event.task == task and event.kind is EventKind.SUSPEND:
            begin = event.time
        elif event.task == task and event.kind is EventKind.RESUME and begin is not None:
            times.append((begin, event.time))
            begin = None
    if begin is not None:
        times.append((begin, run.record.end))
    return [(start, end) for start, end in times if end > start]


def pending_times(run: Simulation) -> list[tuple[int, int, int]]:
    """Return for each job its task, its release and its end, in ns."""
    ends = {
        (event.task, event.time - event.value): event.time
        for event in run.record.events
        if event.kind is EventKind.END
    }
    return [
        (job.task, job.due, ends.get((job.task, job.due), run.record.end))
        for job in run.record.jobs
        if job.times  # others work in a process that is not ours
    ]

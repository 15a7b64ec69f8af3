# SPDX-License-Identifier: MIT
"""The parts of one call of the interpolation, in the order given by ``schedule``.

In: a model whose load names the parts of ``task_int``, a record. Out: the parts with their begins
and ends; the dead time (P-RTCF-00018). STANDARD puts out the results of the previous cycle, then
reads, then interpolates; COMPLETE and SWITCHED put out at the end what was read at the start.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.schedule.model import Call, Model
from nctakt.schedule.simulation.results import Job, Record, Segment
from nctakt.schedule.simulation.tracebits import Ran, calls_of_job, segments_by_job

#: For each word of ``schedule`` the order of ``PARTS``.
_ORDERS = {"STANDARD": (2, 0, 1), "COMPLETE": (0, 1, 2), "SWITCHED": (0, 1, 2)}


@dataclass(frozen=True, slots=True)
class Part:
    """A piece of a part: its place in ``model.PARTS``, when its task had the processor, in ns."""

    task: int
    part: int
    begin: int
    end: int


def has_parts(model: Model) -> bool:
    """Return whether the load names parts."""
    return any(call.execution.parts for task in model.tasks for call in task.calls)


def dead_times(model: Model) -> list[tuple[str, int]]:
    """Return for each thread with parts how long it takes from input to output, in ns.

    A call that nothing interrupts, at the begin of its cycle.
    """
    times: list[tuple[str, int]] = []
    for task in model.tasks:
        for call in task.calls:
            if call.execution.parts:
                cycle = task.every * model.train.distance
                whole = sum(call.execution.parts)
                times.append((task.name, cycle if model.schedule == "STANDARD" else whole))
                break
    return times


def parts_of(model: Model, record: Record) -> list[Part]:
    """Return all parts in a record, piece by piece."""
    segments = segments_by_job(record)
    parts: list[Part] = []
    for job in record.jobs:
        calls = model.tasks[job.task].calls
        if not job.times or not any(call.execution.parts for call in calls):
            continue
        times, meanings = _split(model, job, calls)
        own = segments[job.task, job.number]
        for ran in calls_of_job(replace(job, times=times), own, model, record.begin):
            part = meanings[ran.call]
            if part is not None:
                parts += _pieces(ran, part, own, record.end)
    return parts


def _split(
    model: Model, job: Job, calls: tuple[Call, ...]
) -> tuple[tuple[int, ...], list[int | None]]:
    """The times of a job's calls, those with parts split; which part each one is.

    Where a call took another time than the load says, its parts did in proportion.
    """
    times: list[int] = []
    meanings: list[int | None] = []
    for call, time in zip(calls, job.times, strict=True):
        parts = call.execution.parts
        if parts is None:
            times.append(time)
            meanings.append(None)
            continue
        whole, done, passed = max(1, sum(parts)), 0, 0
        for part in _ORDERS[model.schedule]:
            passed += parts[part]
            until = time * passed // whole
            times.append(until - done)
            meanings.append(part)
            done = until
    return tuple(times), meanings


def _pieces(ran: Ran, part: int, segments: list[Segment], end: int) -> Iterator[Part]:
    until = end if ran.end is None else ran.end
    for segment in segments:
        low, high = max(ran.begin, segment.begin), min(until, segment.end)
        if low < high:
            yield Part(ran.task, part, low, high)

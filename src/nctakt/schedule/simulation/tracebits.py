# SPDX-License-Identifier: MIT
"""The view of an oscilloscope: the calls of functions, and the seven trace bits (P-RTCF-00014).

In: the record of a simulation. Out: each call with its start and end; each bit with the times in
which it is high. A bit stays high while its function is preempted or suspended; of two functions
with one bit either makes it high. Times in ns.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.schedule.model import Model
from nctakt.schedule.simulation.results import Job, Record, Segment

BITS = range(1, 8)


@dataclass(frozen=True, slots=True)
class Ran:
    """A call that has begun: its index in the task's calls, its times.

    ``end`` ``None``: not by the end of the record.
    """

    task: int
    job: int
    call: int
    begin: int
    end: int | None


def calls_of(model: Model, record: Record) -> list[Ran]:
    """Return all calls, in the order of their tasks and jobs."""
    segments = segments_by_job(record)
    return [
        ran
        for job in record.jobs
        for ran in calls_of_job(job, segments[job.task, job.number], model, record.begin)
    ]


def segments_by_job(record: Record) -> dict[tuple[int, int], list[Segment]]:
    """Return the processor time of each job by task and number, in the order of time."""
    segments: dict[tuple[int, int], list[Segment]] = {
        (job.task, job.number): [] for job in record.jobs
    }
    for segment in record.segments:
        segments.setdefault((segment.task, segment.job), []).append(segment)
    return segments


def calls_of_job(job: Job, segments: list[Segment], model: Model, begin: int) -> Iterator[Ran]:
    """Yield the calls of a job, as far as they run from ``begin`` on, where the record begins."""
    if not job.done:
        yield from _distribute(job, segments, model)
        return
    before = Segment(0, begin - job.done, begin, job.task, job.number)
    for ran in _distribute(job, [before, *segments], model):
        if ran.end is None or ran.end > begin:
            yield replace(ran, begin=max(begin, ran.begin))


def _distribute(job: Job, segments: list[Segment], model: Model) -> Iterator[Ran]:
    """Distribute the processor time of a job over its calls, in their order."""
    pieces = list(_work_of(segments, model.overheads.activation))
    index = 0
    for call, time in enumerate(job.times):
        begin: int | None = None
        left = time
        while index < len(pieces):
            start, length = pieces[index]
            if begin is None:
                begin = start
            used = min(left, length)
            left -= used
            pieces[index] = (start + used, length - used)
            if left == 0:
                yield Ran(job.task, job.number, call, begin, start + used)
                break
            index += 1
        if left or begin is None:
            if begin is not None:
                yield Ran(job.task, job.number, call, begin, None)
            return
        if pieces[index][1] == 0 and index + 1 < len(pieces):
            index += 1


def _work_of(segments: list[Segment], activation: int) -> Iterator[tuple[int, int]]:
    """Yield begin and length of the pieces in which calls of the job run, without overheads."""
    overhead = activation
    for segment in segments:
        overhead += segment.overhead
        length = segment.end - segment.begin
        used = min(overhead, length)
        overhead -= used
        if length > used or length == 0:
            yield segment.begin + used, length - used


def trace_bits(model: Model, record: Record) -> dict[int, list[tuple[int, int]]]:
    """Return for each bit from 1 to 7 when it is high, in ns; calls that touch stay apart."""
    edges: dict[int, list[tuple[int, int]]] = {bit: [] for bit in BITS}
    for ran in calls_of(model, record):
        bit = model.tasks[ran.task].calls[ran.call].trace_bit
        if bit:
            edges[bit].append((ran.begin, record.end if ran.end is None else ran.end))
    return {bit: _merged(sorted(times)) for bit, times in edges.items()}


def _merged(times: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return the times with overlapping ones merged."""
    merged: list[tuple[int, int]] = []
    for begin, end in times:
        if merged and begin < merged[-1][1]:
            merged[-1] = (merged[-1][0], max(merged[-1][1], end))
        else:
            merged.append((begin, end))
    return merged

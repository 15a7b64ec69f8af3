# SPDX-License-Identifier: MIT
"""The log of a run -> the record for pictures and traces.

In: entries in the order of time. Out: ``Record`` of the first NC cycles. The execution times of a
job's calls are the measured ones: the time in which their process had a processor.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.schedule.real import area as layout
from nctakt.schedule.real.run import RunLog
from nctakt.schedule.simulation.results import Event, EventKind, Job, Record, Segment


@dataclass(slots=True)
class _Job:
    """A job of the record: the times of its calls, and whether it waits for another one."""

    due: int
    waits: bool
    times: list[int] = field(default_factory=list)
    is_done: bool = False


class RecordOfRun:
    """Gathers the cycles between the interrupts ``begins``; the last one is the end."""

    def __init__(self, log: RunLog, begins: list[int]) -> None:
        self._log = log
        self._begins = begins
        self._end = begins[-1]
        self._segments: list[Segment] = []
        self._events: list[Event] = []
        self._jobs: list[dict[int, _Job]] = [{} for _ in log.plan.tasks]
        self._current = [-1] * len(log.plan.tasks)
        self._planned = {task.number: task for task in log.plan.tasks}

    def entry(
        self, cycle: int, time: int, value: int, kind: int, i: int, call: int, cpu: int
    ) -> None:
        """Add an entry of the log; ``cycle``: the scheduler's NC cycle."""
        if kind == layout.WAKE:
            self._begins_job(i, value, time)
        elif kind == layout.SEGMENT:
            self._segment(i, time, value, call, cpu)
        elif kind == layout.END:
            self._ends_job(i, value, time)
        elif 0 <= cycle < len(self._begins) - 1:
            self._scheduled(cycle, time, value, kind, i, call)

    def _event(self, time: int, kind: EventKind, i: int, value: int) -> None:
        self._events.append(Event(min(time, self._end), kind, i, value))

    def _scheduled(self, cycle: int, time: int, value: int, kind: int, i: int, call: int) -> None:
        begin = self._begins[cycle]
        if kind == layout.INTERRUPT:
            self._event(begin, EventKind.INTERRUPT, -1, cycle)
        elif kind == layout.RELEASE:
            due = self._log.due[i]
            self._jobs[i][value] = _Job(due[value] if value < len(due) else begin, bool(call))
            if not call:
                self._event(begin, EventKind.RELEASE, i, value)
        elif kind == layout.OVERFLOW:
            self._event(begin, EventKind.OVERFLOW, i, value)
        elif kind == layout.SUSPEND:
            self._event(time, EventKind.SUSPEND, i, value)
        elif kind == layout.RESUME:
            self._event(time, EventKind.RESUME, i, value)

    def _begins_job(self, i: int, job: int, time: int) -> None:
        self._current[i] = job
        recorded = self._jobs[i].get(job)
        if recorded is not None and recorded.waits and time < self._end:
            self._event(time, EventKind.RELEASE, i, job)

    def _segment(self, i: int, begin: int, end: int, call: int, cpu: int) -> None:
        job = self._jobs[i].get(self._current[i])
        if job is None:
            return
        job.times += [0] * (call + 1 - len(job.times))
        job.times[call] += end - begin
        if begin < self._end:
            number = self._current[i]
            self._segments.append(Segment(cpu, begin, min(end, self._end), i, number))

    def _ends_job(self, i: int, number: int, time: int) -> None:
        job = self._jobs[i].get(number)
        if job is None:
            return
        job.is_done = True
        if time <= self._end:
            self._event(time, EventKind.END, i, time - job.due)

    def _times(self, i: int, number: int, job: _Job) -> tuple[int, ...]:
        """Return the calls' times in ns; those of unfinished calls exceed the time so far."""
        planned = self._planned[i]
        if not planned.has_process:
            return ()
        row = planned.times[number % len(planned.times)].tolist()
        if not job.is_done and job.times:
            job.times[-1] += 1
        return tuple([*job.times, *row[len(job.times) :]])

    def result(self) -> Record:
        """Return the whole record, in the order of time."""
        jobs = [
            Job(i, number, job.due, self._times(i, number, job))
            for i, recorded in enumerate(self._jobs)
            for number, job in recorded.items()
        ]
        return Record(
            self._begins[0],
            self._end,
            tuple(sorted(self._segments, key=lambda segment: (segment.begin, segment.cpu))),
            tuple(sorted(self._events, key=lambda event: event.time)),
            tuple(jobs),
        )

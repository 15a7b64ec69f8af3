# SPDX-License-Identifier: MIT
"""Keeps all that happens in some cycles of a simulation, for pictures and traces.

In: the calls of the simulation. Out: ``Record``. Pieces of one job that follow each other without a
gap are one segment.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.schedule.simulation.results import Event, EventKind, Job, Record, Segment


class Recorder:
    """Records these cycles, then closes."""

    def __init__(self, cycles: range) -> None:
        self.cycles = cycles
        self.is_open = False
        self._begin: int | None = None
        self._end = 0
        self._segments: list[Segment] = []
        self._events: list[Event] = []
        self._jobs: list[Job] = []
        self._numbers: dict[int, int] = {}
        self._newest: dict[int, int] = {}
        self._suspended: dict[int, int] = {}

    def open(self, jobs: Sequence[int]) -> None:
        """Begin to record; ``jobs``: how many jobs of each task have ended before."""
        self.is_open = True
        self._numbers = dict(enumerate(jobs))

    def add_carried_job(self, task: int, due: int, times: tuple[int, ...], done: int) -> None:
        """Record a job of ``task`` begun before the record; ``done``: its work before, in ns."""
        self._jobs.append(Job(task, self._take_number(task), due, times, done))

    def interrupt(self, now: int, cycle: int) -> None:
        """Record the NC interrupt that opens ``cycle``."""
        if self._begin is None:
            self._begin = now
        self.event(Event(now, EventKind.INTERRUPT, -1, cycle))
        for task, left in self._suspended.items():
            self.event(Event(now, EventKind.RESUME, task, left))
        self._suspended.clear()

    def suspend(self, now: int, task: int, left: int) -> None:
        """Record that ``task`` is suspended up to the next NC interrupt; ``left``: work in ns."""
        self._suspended[task] = left
        self.event(Event(now, EventKind.SUSPEND, task, left))

    def event(self, event: Event) -> None:
        """Record an event."""
        self._events.append(event)

    def job(self, task: int, due: int, now: int, times: tuple[int, ...]) -> None:
        """Record a job of ``task`` that is released at ``now`` and was due at ``due``."""
        number = self._take_number(task)
        self._jobs.append(Job(task, number, due, times))
        self.event(Event(now, EventKind.RELEASE, task, number))

    def _take_number(self, task: int) -> int:
        number = self._numbers.get(task, 0)
        self._numbers[task] = number + 1
        return number

    def segment(self, cpu: int, begin: int, end: int, task: int, overhead: int) -> None:
        """Record that ``task`` has a processor from one time to another."""
        job = self._numbers[task] - 1
        index = self._newest.get(cpu)
        if index is not None and not overhead:
            last = self._segments[index]
            if (last.end, last.task, last.job) == (begin, task, job):
                self._segments[index] = Segment(cpu, last.begin, end, task, job, last.overhead)
                return
        self._newest[cpu] = len(self._segments)
        self._segments.append(Segment(cpu, begin, end, task, job, overhead))

    def close(self, now: int) -> None:
        """Close the record at the end of the last recorded cycle."""
        self.is_open = False
        self._end = now

    def result(self) -> Record:
        """Return the record, in the order of time."""
        events = sorted(self._events, key=lambda event: event.time)
        segments = sorted(self._segments, key=lambda segment: (segment.begin, segment.cpu))
        begin = 0 if self._begin is None else self._begin
        return Record(begin, self._end, tuple(segments), tuple(events), tuple(self._jobs))

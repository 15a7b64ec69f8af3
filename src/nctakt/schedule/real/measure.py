# SPDX-License-Identifier: MIT
"""The log of a run -> the same numbers and the same record as those of a simulation.

In: ``RunLog``. Out: ``Measurement``. Responses count from the due time of the NC interrupt, so that
they include the timer's delay. An unfinished cycle does not count.
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.linux_run import NO_NC_CYCLE_COMPLETED
from nctakt.schedule.model import NO_OVERHEADS, Model, suspension_point
from nctakt.schedule.real import area as layout
from nctakt.schedule.real.recording import RecordOfRun
from nctakt.schedule.real.run import RunLog
from nctakt.schedule.simulation.counters import NEVER, Counters
from nctakt.schedule.simulation.results import Simulation

#: Tolerated part of Windows' time that is missing: the timer is late now and then, and stopping a
#: process takes time.
TOLERATED = 10


@dataclass(frozen=True, slots=True)
class Measurement:
    """A measured run: ``run`` in the form of a simulation.

    ``timer``: the scheduler's delays in ns. ``wakes``: for each task of the model the wake-up
    latencies of its jobs in ns.
    """

    run: Simulation
    timer: tuple[int, ...]
    wakes: tuple[tuple[int, ...], ...]


def measure(log: RunLog, drawn: int) -> Measurement:
    """Return all numbers, and a record of ``drawn`` NC cycles; raises ``Failure`` (900695)."""
    interrupts = log.entries[log.entries["kind"] == layout.INTERRUPT]
    begins: list[int] = interrupts["value"].tolist()
    if len(begins) < 2:
        raise Failure(diagnostic(NO_NC_CYCLE_COMPLETED))
    return _Measuring(log, begins, drawn).result()


class _Measuring:
    def __init__(self, log: RunLog, begins: list[int], drawn: int) -> None:
        model = log.plan.model
        self._log = log
        self._begins = begins
        self._cycles = len(begins) - 1
        self._end = begins[-1]
        self._model = replace(model, overheads=NO_OVERHEADS)
        kept = model.windows - model.windows // TOLERATED
        self._counters = Counters(replace(model, windows=kept))
        self._record = RecordOfRun(log, begins[: min(drawn, self._cycles) + 1])
        self._ended = [0] * len(model.tasks)
        self._released = [0] * len(model.tasks)
        self._post_times: list[dict[int, int]] = [{} for _ in model.tasks]
        self._wakes: list[list[int]] = [[] for _ in model.tasks]
        self._timer: list[int] = []
        self._suspended = [False] * self._cycles
        #: For each processor and cycle the time used by tasks.
        cpu_count = max(model.cpus) + 1
        self._busy = [[0] * self._cycles for _ in range(cpu_count)]
        self._late: dict[tuple[int, int], list[int]] = {}
        self._points = [suspension_point(model, begin) for begin in begins[:-1]]

    def result(self) -> Measurement:
        """Go through all entries in the order of time."""
        self._count()
        for cycle in range(self._cycles):
            self._end_cycle(cycle)
        tasks = list(self._counters.task_numbers(self._unfinished()))
        for i, wakeups in enumerate(self._log.wakeups):
            if wakeups is not None:
                tasks[i] = replace(tasks[i], completed=min(wakeups, self._released[i]))
        run = Simulation(
            self._model,
            self._cycles,
            self._begins[0],
            self._end,
            tuple(tasks),
            self._counters.windows_numbers(),
            self._counters.missed,
            self._counters.suspended_cycles,
            None,
            self._record.result(),
        )
        return Measurement(
            run, tuple(self._timer), tuple(tuple(latencies) for latencies in self._wakes)
        )

    def _count(self) -> None:
        cycle = -1
        for time, value, kind, i, call, cpu in self._log.entries.tolist():
            if kind == layout.INTERRUPT:
                cycle += 1
                self._timer.append(time - value)
            elif kind == layout.POINT:
                self._timer.append(time - value)
            elif kind == layout.SEGMENT:
                self._segment(i, cpu, time, min(value, self._end))
            elif kind == layout.END:
                self._job_ends(i, value, time)
            elif kind == layout.WAKE:
                self._job_begins(i, value, time)
            elif 0 <= cycle < self._cycles:
                self._scheduled(kind, cycle, time, value, i, call)
            self._record.entry(cycle, time, value, kind, i, call, cpu)

    def _scheduled(self, kind: int, cycle: int, time: int, value: int, i: int, call: int) -> None:
        """Count an action of the scheduler in a cycle."""
        counters = self._counters
        if kind == layout.RELEASE:
            counters.due[i] += 1
            self._released[i] += 1
            if not call:
                self._post_times[i][value] = time
        elif kind == layout.OVERFLOW:
            counters.overflow(i, self._begins[cycle])
            if not call:
                counters.due[i] += 1
                counters.lost[i] += 1
        elif kind == layout.SUSPEND:
            counters.suspensions[i] += 1
            self._suspended[cycle] = True

    def _job_begins(self, i: int, job: int, time: int) -> None:
        post_time = self._post_times[i].pop(job, None)
        if post_time is not None:
            self._wakes[i].append(max(0, time - post_time))

    def _job_ends(self, i: int, job: int, time: int) -> None:
        if time <= self._end:
            self._counters.finish(i, time - self._log.due[i][job])
            self._ended[i] += 1

    def _segment(self, i: int, cpu: int, begin: int, end: int) -> None:
        """Count the time in which a task had a processor, divided by NC cycles."""
        begin = max(begin, self._begins[0])
        if end <= begin:
            return
        self._counters.busy[i] += end - begin
        if cpu >= len(self._busy):
            return
        cycle = bisect_right(self._begins, begin) - 1
        while begin < end:
            until = min(end, self._begins[cycle + 1])
            self._busy[cpu][cycle] += until - begin
            point = self._points[cycle]
            if point is not None and until > point:
                self._late.setdefault((cycle, cpu), []).append(i)
            begin = until
            cycle += 1

    def _end_cycle(self, cycle: int) -> None:
        begin, end, point = self._begins[cycle], self._begins[cycle + 1], self._points[cycle]
        idle = array("q", [max(0, end - begin - busy[cycle]) for busy in self._busy])
        for cpu in self._model.windows_cpus:
            for i in self._late.get((cycle, cpu), ()):
                self._counters.runs_late(cpu, i)
        is_missed = point is not None and point > end
        moment = NEVER if point is None else point
        self._counters.end_cycle(idle, moment, end, is_missed, self._suspended[cycle])

    def _unfinished(self) -> list[int | None]:
        """Return for each task the due time of its unfinished job at the end, else ``None``."""
        return [
            due[ended] if released > ended and ended < len(due) else None
            for due, released, ended in zip(self._log.due, self._released, self._ended, strict=True)
        ]


def tolerated(model: Model) -> int:
    """Return the tolerated loss of Windows' time in a cycle, in ns."""
    return model.windows // TOLERATED


def late_wakes(measurement: Measurement) -> list[int]:
    """Return the scheduler's delays of more than one time slice, in ns."""
    return [late for late in measurement.timer if late > measurement.run.model.slice]

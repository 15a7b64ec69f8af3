# SPDX-License-Identifier: MIT
"""Several processors on which some tasks may run anywhere.

In: the state of the scheduler, one cycle. Out: the time without work of each processor. A task
that the operating system places stays where it runs; newly dispatched it takes the free processor
with the lowest number, else the one with the least urgent task. It can be suspended only while
only the processors of Windows are available to it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from nctakt.schedule.model import ANY_CPU, Model
from nctakt.schedule.simulation.counters import Counters

_NOWHERE = 0


class RunningState(Protocol):
    """The part of the scheduler's state that a cycle on several processors reads and advances."""

    @property
    def left(self) -> Sequence[int]:
        """The work left of each task in ns, negative where nothing is waiting."""

    @property
    def suspendable(self) -> Sequence[bool]:
        """Return for each task whether it can be suspended."""

    @property
    def counters(self) -> Counters:
        """The numbers counted so far."""

    def switch(self, i: int, cpu: int) -> int:
        """Return the time of switching to task ``i`` that is still due on ``cpu``, in ns."""

    def advance(self, i: int, cpu: int, now: int, until: int, overhead: int) -> int:
        """Let task ``i`` run from ``now`` to ``until``, ``overhead`` of it for switching, in ns."""


class Placement:
    """The processor of each task."""

    def __init__(self, model: Model) -> None:
        self._model = model
        self._cpus = model.cpus
        self._where = [_NOWHERE] * len(model.tasks)
        self._at_stop = [_NOWHERE] * len(model.tasks)

    @property
    def state(self) -> tuple[int, ...]:
        """Return the processor of each task, 0 for none."""
        return tuple(self._where)

    def cpu_at_stop(self, i: int) -> int:
        """Return the processor that task ``i`` had at the point of suspension."""
        return self._at_stop[i]

    def run(
        self, state: RunningState, order: list[int], begin: int, stop: int, end: int
    ) -> list[int]:
        """Simulate a cycle; return the idle time of each processor. ``order``: by urgency."""
        idle = [0] * (max(self._cpus) + 1)
        now = begin
        is_stopped = now >= stop
        self._at_stop = self._where[:]
        while now < end:
            self._assign(state, order, is_stopped=is_stopped)
            running = [(i, cpu) for i, cpu in enumerate(self._where) if cpu != _NOWHERE]
            until = end if is_stopped else stop
            for i, cpu in running:
                until = min(until, now + state.left[i] + state.switch(i, cpu))
            free = [True] * len(idle)
            for i, cpu in running:
                free[cpu] = False
                state.advance(i, cpu, now, until, state.switch(i, cpu))
                if until > stop and cpu in self._model.windows_cpus:
                    state.counters.runs_late(cpu, i)
            for cpu in self._cpus:
                idle[cpu] += (until - now) * free[cpu]
            now = until
            if now >= stop and not is_stopped:
                is_stopped = True
                self._at_stop = self._where[:]
        return idle

    def _assign(self, state: RunningState, order: list[int], *, is_stopped: bool) -> None:
        """Give the processors to the most urgent tasks."""
        ready = [i for i in order if state.left[i] >= 0]
        before = self._where
        runner = {before[i]: i for i in ready if before[i] != _NOWHERE}
        self._where = [_NOWHERE] * len(before)
        taken: list[int] = []
        for i in ready:
            cpus = self._allowed(state, i, is_stopped=is_stopped)
            open_cpus = [cpu for cpu in cpus if cpu not in taken]
            if not open_cpus:
                continue
            cpu = before[i] if before[i] in open_cpus else self._best(open_cpus, runner)
            taken.append(cpu)
            self._where[i] = cpu

    def _best(self, cpus: list[int], runner: dict[int, int]) -> int:
        """Return the first free processor, else that of the least urgent task."""
        free = [cpu for cpu in cpus if cpu not in runner]
        tasks = self._model.tasks
        return free[0] if free else min(cpus, key=lambda cpu: tasks[runner[cpu]].urgency)

    def _allowed(self, state: RunningState, i: int, *, is_stopped: bool) -> list[int]:
        own = self._model.tasks[i].cpu
        cpus = list(self._cpus) if own == ANY_CPU else [own]
        if is_stopped and state.suspendable[i]:
            return [cpu for cpu in cpus if cpu not in self._model.windows_cpus]
        return cpus

# SPDX-License-Identifier: MIT
# cython: boundscheck=True, cdivision=False, initializedcheck=True, wraparound=True
"""Draws the execution times of a task's jobs.

In: ``Task``, a seeded generator. Out: the work of one job after another, in ns. A list of times
belongs to a function of the task: each call takes the next one.
"""

from __future__ import annotations

from array import array

from nctakt.schedule.model import Task
from nctakt.schedule.simulation.chance import Chance

#: No constant: the work changes from job to job.
_CHANGES = -1


class Work:
    """The jobs of one task; ``extra`` ns are added to each."""

    def __init__(self, task: Task, extra: int, chance: Chance) -> None:
        executions = [call.execution for call in task.calls]
        self.is_random = any(one.spread and not one.is_constant for one in executions)
        self._extra = extra
        self._chance = chance
        self._count = len(executions)
        #: The execution times of the calls of the job drawn last.
        self._drawn = array("q", [one.values[0] for one in executions])
        self._constant = _CHANGES
        if all(execution.is_constant for execution in executions):
            self._constant = extra + sum(self._drawn)
        spans = [one.values[1] - one.values[0] + 1 if one.spread else 0 for one in executions]
        self._low = array("q", self._drawn)
        self._span = array("q", spans)
        #: 0: the call's times are in a list.
        self._bits = array("q", [span.bit_length() for span in spans])
        self._lists = [one.values for one in executions]
        functions = list(dict.fromkeys(call.function for call in task.calls))
        self._function = array("q", [functions.index(call.function) for call in task.calls])
        self._positions = array("q", [0] * len(functions))

    @property
    def is_constant(self) -> bool:
        """Return whether all jobs take the same time."""
        return self._constant != _CHANGES

    @property
    def times(self) -> tuple[int, ...]:
        """The execution times of the calls of the job drawn last, in ns."""
        return tuple(self._drawn)

    @property
    def state(self) -> tuple[int, ...]:
        """Return the position in each function's list of times."""
        return tuple(self._positions)

    def draw(self) -> int:
        """Return the work of the next job in ns; ``times`` then holds the times of its calls."""
        if self._constant != _CHANGES:
            return self._constant
        work = self._extra
        for i in range(self._count):
            if self._bits[i]:
                time = self._low[i] + self._chance.below(self._span[i], self._bits[i])
            else:
                time = self._next(i)
            self._drawn[i] = time
            work += time
        return work

    def _next(self, i: int) -> int:
        """Return the next time in the list of a call's function."""
        values = self._lists[i]
        position = self._positions[self._function[i]]
        self._positions[self._function[i]] = (position + 1) % len(values)
        return values[position % len(values)]

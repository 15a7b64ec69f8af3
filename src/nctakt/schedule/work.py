# SPDX-License-Identifier: MIT
"""Draws the execution times of a task's jobs.

In: ``Task``, a seeded generator. Out: the work of one job after another, in ns. A list of times
belongs to a function of the task: each call takes the next one.
"""

from __future__ import annotations

import random

from nctakt.schedule.model import Task


class Work:
    """The jobs of one task; ``extra`` ns are added to each."""

    def __init__(self, task: Task, extra: int, chance: random.Random) -> None:
        executions = [call.execution for call in task.calls]
        self.is_random = any(one.spread and not one.is_constant for one in executions)
        #: The work of each job, or ``None`` when it changes from job to job.
        self.constant: int | None = None
        #: The execution times of the calls of the job drawn last.
        self.times = tuple(execution.values[0] for execution in executions)
        if all(execution.is_constant for execution in executions):
            self.constant = extra + sum(self.times)
        self._calls = task.calls
        self._extra = extra
        self._chance = chance
        self._places = {call.function: 0 for call in task.calls}

    @property
    def state(self) -> tuple[int, ...]:
        """Where each function's list of times stands."""
        return tuple(self._places.values())

    def draw(self) -> int:
        """The work of the next job; ``times`` holds its calls' times from then on."""
        if self.constant is not None:
            return self.constant
        times: list[int] = []
        for call in self._calls:
            values = call.execution.values
            if call.execution.spread:
                times.append(self._chance.randint(values[0], values[1]))
                continue
            place = self._places[call.function]
            times.append(values[place % len(values)])
            self._places[call.function] = (place + 1) % len(values)
        self.times = tuple(times)
        return self._extra + sum(times)

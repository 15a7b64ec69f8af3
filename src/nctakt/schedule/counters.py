# SPDX-License-Identifier: MIT
"""The numbers of a simulation while it runs.

In: what happens to tasks and in cycles. Out: ``TaskNumbers`` and ``WindowsNumbers``. What only
adds up can be multiplied when the schedule repeats; a repetition brings no new least or greatest.
"""

from __future__ import annotations

from nctakt.schedule.model import Model
from nctakt.schedule.results import TaskNumbers, WindowsNumbers

_NONE = -1


class Counters:
    """Counts per task, and per Windows processor with their sum as the last."""

    def __init__(self, model: Model) -> None:
        count = len(model.tasks)
        self._guarantee = model.windows
        self._cpus = model.windows_cpus
        places = len(self._cpus) + 1
        self.due = [0] * count
        self.completed = [0] * count
        self.overflows = [0] * count
        self.lost = [0] * count
        self.suspensions = [0] * count
        self.busy = [0] * count
        self._response_sum = [0] * count
        self._response_min = [_NONE] * count
        self._response_max = [_NONE] * count
        self._first_overflow = [_NONE] * count
        self._total = [0] * places
        self._least = [_NONE] * places
        self._most = [_NONE] * places
        self._violated = [0] * places
        self._late = [0] * places
        self._culprits = [[0] * count for _ in range(places)]
        self._runners: list[list[int]] = [[] for _ in range(max(model.cpus) + 1)]
        # Cycles: over before their point of suspension, with something suspended.
        self._cycles = [0, 0]

    def _additive(self) -> list[list[int]]:
        return [
            self.due,
            self.completed,
            self.overflows,
            self.lost,
            self.suspensions,
            self.busy,
            self._response_sum,
            self._total,
            self._violated,
            self._late,
            self._cycles,
            *self._culprits,
        ]

    def snapshot(self) -> list[list[int]]:
        """All that adds up, as it stands."""
        return [numbers[:] for numbers in self._additive()]

    def repeat(self, before: list[list[int]], times: int) -> None:
        """What came since ``before`` comes ``times`` times more."""
        for numbers, old in zip(self._additive(), before, strict=True):
            for i, value in enumerate(old):
                numbers[i] += (numbers[i] - value) * times

    def overflow(self, i: int, now: int) -> None:
        """An activation of task ``i`` found it busy."""
        if not self.overflows[i]:
            self._first_overflow[i] = now
        self.overflows[i] += 1

    def finish(self, i: int, response: int) -> None:
        """A job of task ``i`` ended."""
        self.completed[i] += 1
        self._response_sum[i] += response
        self._response_max[i] = max(self._response_max[i], response)
        if response < self._response_min[i] or self._response_min[i] == _NONE:
            self._response_min[i] = response

    def runs_late(self, cpu: int, i: int) -> None:
        """Task ``i`` runs behind the point of suspension."""
        self._runners[cpu].append(i)

    def end_cycle(
        self, idle: list[int], point: int | None, end: int, *, is_missed: bool, suspended: bool
    ) -> None:
        """A cycle is over: ``idle`` is the time that each processor was without work."""
        self._cycles[0] += is_missed
        self._cycles[1] += suspended
        total = 0
        for place, cpu in enumerate(self._cpus):
            share = idle[cpu]
            total += share
            self._share(place, share)
            if share < self._guarantee:
                self._violated[place] += 1
                self._violated[-1] += 1
                if point is None or end - point < self._guarantee:
                    self._late[place] += 1
                    self._late[-1] += 1
                for i in dict.fromkeys(self._runners[cpu]):
                    self._culprits[place][i] += 1
                    self._culprits[-1][i] += 1
            self._runners[cpu].clear()
        self._share(-1, total)

    def _share(self, place: int, share: int) -> None:
        self._total[place] += share
        self._most[place] = max(self._most[place], share)
        if share < self._least[place] or self._least[place] == _NONE:
            self._least[place] = share

    @property
    def missed(self) -> int:
        """Cycles that were over before their point of suspension."""
        return self._cycles[0]

    @property
    def suspended_cycles(self) -> int:
        """Cycles in which something was suspended."""
        return self._cycles[1]

    def task_numbers(self, unfinished: list[int | None]) -> tuple[TaskNumbers, ...]:
        """The numbers of all tasks; ``unfinished``: since when each has a job at the end."""
        return tuple(
            TaskNumbers(
                self.due[i],
                self.completed[i],
                self.overflows[i],
                self.lost[i],
                self.suspensions[i],
                self.busy[i],
                _known(self._response_min[i], self.completed[i]),
                self._response_sum[i],
                _known(self._response_max[i], self.completed[i]),
                since,
                _known(self._first_overflow[i], self.overflows[i]),
            )
            for i, since in enumerate(unfinished)
        )

    def windows_numbers(self) -> tuple[WindowsNumbers, ...]:
        """Windows on each of its processors, then their sum."""
        return tuple(
            WindowsNumbers(
                cpu,
                self._total[place],
                self._least[place],
                self._most[place],
                self._violated[place],
                tuple(self._culprits[place]),
                self._late[place],
            )
            for place, cpu in enumerate((*self._cpus, 0))
        )


def _known(value: int, count: int) -> int | None:
    return value if count else None

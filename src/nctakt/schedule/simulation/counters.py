# SPDX-License-Identifier: MIT
# cython: boundscheck=True, cdivision=False, initializedcheck=True, wraparound=True
"""Counts the results of a simulation while it runs.

In: events of tasks and cycles. Out: ``TaskNumbers`` and ``WindowsNumbers``. Sums can be multiplied
when the schedule repeats; a repetition brings no new least or greatest.
"""

from __future__ import annotations

from array import array

from nctakt.schedule.model import Model
from nctakt.schedule.simulation.responses import ResponseCounts
from nctakt.schedule.simulation.results import Snapshot, TaskNumbers, WindowsNumbers

_NONE = -1
#: Maximum number of different responses of a task; beyond it neighbours count together.
_MAX_STEPS = 4096
#: No point of suspension in a cycle: a moment before all others.
NEVER = -(1 << 62)


class Counters:
    """Counts per task, and per Windows processor with their sum as the last."""

    def __init__(self, model: Model) -> None:
        count = len(model.tasks)
        self._guarantee = model.windows
        self._cpus = model.windows_cpus
        #: The last place of Windows is the sum of the others.
        self._sum = len(self._cpus)
        places = self._sum + 1
        self.due = _numbers(count)
        self.completed = _numbers(count)
        self.overflows = _numbers(count)
        self.lost = _numbers(count)
        self.suspensions = _numbers(count)
        self.busy = _numbers(count)
        self._response_sum = _numbers(count)
        self._response_min = _numbers(count, _NONE)
        self._response_max = _numbers(count, _NONE)
        self._first_overflow = _numbers(count, _NONE)
        self._total = _numbers(places)
        self._min = _numbers(places, _NONE)
        self._max = _numbers(places, _NONE)
        self._violated = _numbers(places)
        self._late = _numbers(places)
        self._culprits = [_numbers(count) for _ in range(places)]
        self._runners: list[list[int]] = [[] for _ in range(max(model.cpus) + 1)]
        self._has_runners = False
        #: For each task how many jobs had which response, in steps of 2 ** ``_shifts``.
        self._responses: list[dict[int, int]] = [{} for _ in range(count)]
        self._shifts = _numbers(count)
        # Cycles: over before their point of suspension, with something suspended.
        self._cycles = _numbers(2)

    def _additive(self) -> list[array[int]]:
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

    def snapshot(self) -> Snapshot:
        """Return the present values of all sums."""
        return Snapshot(
            [list(numbers) for numbers in self._additive()],
            [self._responses_of(i) for i in range(len(self._responses))],
        )

    def repeat(self, before: Snapshot, times: int) -> None:
        """Add the counts since ``before`` another ``times`` times."""
        for numbers, old in zip(self._additive(), before.numbers, strict=True):
            for i, value in enumerate(old):
                numbers[i] += (numbers[i] - value) * times
        for i, earlier in enumerate(before.responses):
            counts, shift = self._responses[i], self._shifts[i]
            known: dict[int, int] = {}
            for response, count in earlier.counts:
                known[response >> shift] = known.get(response >> shift, 0) + count
            for step in counts:
                counts[step] += (counts[step] - known.get(step, 0)) * times

    def overflow(self, i: int, now: int) -> None:
        """Count an activation that found task ``i`` busy."""
        if not self.overflows[i]:
            self._first_overflow[i] = now
        self.overflows[i] += 1

    def finish(self, i: int, response: int) -> None:
        """Count a finished job of task ``i``."""
        self.completed[i] += 1
        self._response_sum[i] += response
        self._response_max[i] = max(self._response_max[i], response)
        if response < self._response_min[i] or self._response_min[i] == _NONE:
            self._response_min[i] = response
        counts = self._responses[i]
        step = response >> self._shifts[i]
        counts[step] = counts.get(step, 0) + 1
        if len(counts) > _MAX_STEPS:
            self._coarsen(i)

    def _coarsen(self, i: int) -> None:
        """Double the steps of a task's responses until there are half as many."""
        counts = self._responses[i]
        while len(counts) > _MAX_STEPS // 2:
            wider: dict[int, int] = {}
            for step, count in counts.items():
                wider[step >> 1] = wider.get(step >> 1, 0) + count
            counts = wider
            self._shifts[i] += 1
        self._responses[i] = counts

    def _responses_of(self, i: int) -> ResponseCounts:
        shift = self._shifts[i]
        counts = tuple((step << shift, count) for step, count in self._responses[i].items())
        return ResponseCounts(1 << shift, tuple(sorted(counts)))

    def runs_late(self, cpu: int, i: int) -> None:
        """Note that task ``i`` runs after the point of suspension."""
        self._runners[cpu].append(i)
        self._has_runners = True

    def end_cycle(
        self, idle: array[int], point: int, end: int, is_missed: bool, suspended: bool
    ) -> None:
        """Count a finished cycle in which each processor was idle for ``idle`` ns.

        ``point``: the time of the suspension, or ``NEVER``.
        """
        self._cycles[0] += is_missed
        self._cycles[1] += suspended
        total = 0
        for column in range(self._sum):
            share = idle[self._cpus[column]]
            total += share
            self._share(column, share)
            if share < self._guarantee:
                self._violate(column, point == NEVER or end - point < self._guarantee)
        if self._has_runners:
            for runners in self._runners:
                runners.clear()
            self._has_runners = False
        self._share(self._sum, total)

    def _violate(self, column: int, is_late: bool) -> None:
        """Count a cycle in which Windows got less time than guaranteed."""
        for one in (column, self._sum):
            self._violated[one] += 1
            self._late[one] += is_late
            for i in dict.fromkeys(self._runners[self._cpus[column]]):
                self._culprits[one][i] += 1

    def _share(self, column: int, share: int) -> None:
        self._total[column] += share
        self._max[column] = max(self._max[column], share)
        if share < self._min[column] or self._min[column] == _NONE:
            self._min[column] = share

    @property
    def missed(self) -> int:
        """The number of cycles that ended before their point of suspension."""
        return self._cycles[0]

    @property
    def suspended_cycles(self) -> int:
        """The number of cycles in which something was suspended."""
        return self._cycles[1]

    def task_numbers(self, unfinished: list[int | None]) -> tuple[TaskNumbers, ...]:
        """Return the results of all tasks; ``unfinished``: since when each has had an open job."""
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
                self._responses_of(i),
            )
            for i, since in enumerate(unfinished)
        )

    def windows_numbers(self) -> tuple[WindowsNumbers, ...]:
        """Return the results of Windows on each of its processors, then their sum."""
        return tuple(
            WindowsNumbers(
                cpu,
                self._total[column],
                self._min[column],
                self._max[column],
                self._violated[column],
                tuple(self._culprits[column]),
                self._late[column],
            )
            for column, cpu in enumerate((*self._cpus, 0))
        )


def _known(value: int, count: int) -> int | None:
    return value if count else None


def _numbers(count: int, value: int = 0) -> array[int]:
    return array("q", [value] * count)

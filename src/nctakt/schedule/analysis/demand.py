# SPDX-License-Identifier: MIT
"""The maximum work of threads: jobs in a time, and the time of a number of jobs.

In: ``Task``, ``Train``. Out: counts of jobs, sums of execution times in ns.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from nctakt.schedule.model import Execution, Task, Train


class Arrivals:
    """Bounds of the NC interrupts after one of them; jitter can bring them closer together."""

    def __init__(self, train: Train) -> None:
        self._distance = train.distance
        self._spread = 2 * train.jitter

    def count(self, length: int) -> int:
        """Return the maximum number of NC interrupts in ``length`` ns (> 0), its start included."""
        return -(-(length + self._spread) // self._distance)

    def pending(self, response: int) -> int:
        """Return how many earlier NC interrupts can have jobs that are not finished yet.

        ``response`` is the longest response of such a job.
        """
        return max(0, -(-(response + self._spread) // self._distance) - 1)

    def earliest(self, cycles: int) -> int:
        """Return the shortest time to the NC interrupt ``cycles`` cycles later, in ns."""
        return cycles * self._distance - self._spread if cycles else 0


class JobWork:
    """The longest work of consecutive jobs of one task; ``activation`` is added to each job."""

    def __init__(self, task: Task, activation: int) -> None:
        executions: dict[str, list[Execution]] = {}
        for call in task.calls:
            executions.setdefault(call.function, []).append(call.execution)
        self._constant = activation if task.calls else 0
        self._lists: list[tuple[tuple[int, ...], int]] = []
        for calls in executions.values():
            first = calls[0]
            if first.spread or first.is_constant or any(call != first for call in calls):
                self._constant += sum(call.longest for call in calls)
            else:
                self._lists.append((first.values, len(calls)))
        self.can_be_zero = not self._constant and bool(task.calls)

    def longest(self, jobs: int) -> int:
        """Return the longest work of ``jobs`` consecutive jobs, in ns."""
        work = jobs * self._constant
        for values, calls in self._lists:
            work += longest_sum(values, jobs * calls)
        return work

    @property
    def mean(self) -> float:
        """Return the mean work of a job in ns if uniform times are always the longest."""
        return self._constant + sum(
            calls * sum(values) / len(values) for values, calls in self._lists
        )


def longest_sum(values: Sequence[int], count: int) -> int:
    """Return the greatest sum of ``count`` values that follow each other in a repeated list."""
    rounds, rest = divmod(count, len(values))
    return rounds * sum(values) + _longest_window(tuple(values), rest)


@lru_cache(maxsize=4096)
def _longest_window(values: tuple[int, ...], count: int) -> int:
    """Return the greatest sum of ``count`` neighbours, fewer than there are values."""
    around = (*values, *values)
    window = sum(around[:count])
    longest = window
    for begin in range(len(values) - 1):
        window += around[begin + count] - around[begin]
        longest = max(longest, window)
    return longest

# SPDX-License-Identifier: MIT
"""Which branches of realtime cycles no run of a study reaches, and which run reaches each first.

In: a bench and how many runs it may take. Out: ``Reached``. The points of the plan are tried spread
over its whole range, not one behind the other, until every branch has run.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.results.coverage import Coverage
from nctakt.studies.bench import Bench
from nctakt.studies.inputs import inputs_of

#: The share of a plan between two points that are tried one after the other: the golden ratio.
_SPREAD = 0.6180339887498949


@dataclass(frozen=True, slots=True)
class Reached:
    """The sum of all runs, and for each branch (file, line) the run that reached it first."""

    coverage: Coverage
    first: tuple[tuple[str, int, int], ...]

    @property
    def is_whole(self) -> bool:
        """Whether every branch ran."""
        return self.coverage.ran == self.coverage.branches


def spread(size: int) -> Iterator[int]:
    """Yield each number below a size once, neighbours far from each other."""
    step = max(1, round(size * _SPREAD))
    while math.gcd(step, size) != 1:
        step += 1
    return (index * step % size for index in range(size))


def reach(bench: Bench, budget: int) -> Reached:
    """Make runs until every branch has run, at most so many; return what they reached."""
    coverage = Coverage()
    first: list[tuple[str, int, int]] = []
    known: set[tuple[str, int]] = set()
    for _, number in zip(range(budget), spread(bench.plan.size), strict=False):
        inputs = inputs_of(bench.plan, bench.plan.point(number), bench.cycle_time_us)
        run = bench.begin(inputs, why=True).finish().outcome.run
        assert run.coverage is not None
        coverage = coverage.plus(run.coverage)
        for cycle in coverage.cycles:
            for branch in cycle.branches:
                if branch.bodies and (cycle.file, branch.line) not in known:
                    known.add((cycle.file, branch.line))
                    first.append((cycle.file, branch.line, number))
        if coverage.ran == coverage.branches:
            break
    return Reached(coverage, tuple(first))

# SPDX-License-Identifier: MIT
"""Looks for runs of a study that reach the branches of realtime cycles, and says which do.

In: a maker of runs, how many runs it may take, points that were good before. Out: ``Reached``.
Points are spread over the whole range first; then each branch that has not run is approached from
the run that came nearest, dimension by dimension, until its comparisons hold. The distances are
those that the realtime part keeps anyway (``branch_distance.py``). Runs that do not depend on each
other are requested at once, no matter who makes them.
"""

from __future__ import annotations

import itertools
from collections.abc import Generator, Iterator, Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.results.coverage import Coverage
from nctakt.results.coverage_files import from_json
from nctakt.studies.plans.coordinates import Coordinates, PlanCoordinates
from nctakt.studies.plans.dimension import Value, chance
from nctakt.studies.plans.plan import COVERAGE
from nctakt.studies.runs.study_runner import REFUSED, StudyRunner
from nctakt.studies.searching.branch_distance import NOT_THERE, BranchDistance, BranchKey, distances
from nctakt.studies.searching.search_runs import SearchRuns
from nctakt.studies.searching.unreachable import Proofs, unreachable

#: Bounds of the spread runs before the first approach: their number, their part of the budget.
_FIRST_RUNS, _FIRST_PART = 16, 8

#: The most points that are asked for at once before any branch is approached.
_AT_ONCE = 16

#: Known points that an approach may request in a row before another has its turn.
_MAX_KNOWN = 64

#: Between two steps of a dimension that are tried.
_STEP_FACTOR = 8

#: Numbers of each dimension that are tried one after another where no step helps; only of
#: dimensions with at most ``_MAX_SWEPT``, as times have.
_SWEPT, _MAX_SWEPT = 16, 1 << 12

#: The result of a run: its distance to each branch.
_Distances = dict[BranchKey, BranchDistance]

#: Asks for coordinates, and gets the distance to its branch there.
_Approach = Generator[Coordinates, BranchDistance, None]


@dataclass(frozen=True, slots=True)
class FirstRun:
    """The run that reached a branch first: file and line, the values, its number if it has any."""

    file: str
    line: int
    point: tuple[Value, ...]
    number: int | None


@dataclass(frozen=True, slots=True)
class Reached:
    """The sum of all runs, for each branch the run that reached it first, and the best points.

    ``best``: points for the next search: those that reached a branch or came nearest. ``untried``:
    how many points of the plan are left. ``failed``: how many runs were not possible, and the first
    reason. ``proofs``: the branches that no values of the plan reach.
    """

    coverage: Coverage
    first: tuple[FirstRun, ...]
    best: tuple[tuple[Value, ...], ...]
    untried: int
    failed: int = 0
    failure: tuple[Diagnostic, ...] = ()
    proofs: Proofs = field(default_factory=dict)

    @property
    def is_whole(self) -> bool:
        """Whether every branch ran."""
        return self.coverage.ran == self.coverage.branches


def reach(searched: SearchRuns, budget: int, earlier: Sequence[Sequence[Value]] = ()) -> Reached:
    """Make up to ``budget`` runs until every branch has run; return what they reached.

    ``searched``: makes them, with ``covers``; ``earlier``: points to begin with.
    """
    search = _Search(searched)
    for several in search.order(budget, earlier):
        search.make(several[: budget - search.runs])
        if search.is_over or search.runs == budget:
            break
    return search.result()


def covered(runner: StudyRunner, point: Sequence[Value]) -> Coverage:
    """Return the coverage of the run with these values; raises ``Failure`` for a wrong value."""
    coverage = runner.cover(point).outcome.run.coverage
    assert coverage is not None
    return coverage


class _Search:
    """The runs so far, and the nearest one to each branch."""

    def __init__(self, searched: SearchRuns) -> None:
        self._searched = searched
        self._runner = runner = searched.runner
        self._space = PlanCoordinates(runner.plan)
        self.coverage = Coverage()
        self._known: dict[Coordinates, _Distances] = {}
        self._nearest: dict[BranchKey, tuple[Coordinates, BranchDistance]] = {}
        self._first: list[FirstRun] = []
        self._failed = 0
        self._refused: tuple[Value, ...] | None = None
        self._good: list[Coordinates] = []
        self._reached: set[BranchKey] = set()
        self._proofs = unreachable(runner)
        self._turns: dict[BranchKey, _Turn] = {}
        self._draws = 0

    @property
    def runs(self) -> int:
        """The number of runs so far."""
        return len(self._known)

    @property
    def is_over(self) -> bool:
        """Whether every branch has run, or is proven not to."""
        return bool(self._nearest) and self._reached | self._proofs.keys() >= self._nearest.keys()

    def make(self, several: Sequence[Coordinates]) -> None:
        """Make the runs with these coordinates."""
        points = [self._space.point(coordinates) for coordinates in several]
        rows = self._searched.add(points)
        for coordinates, point, row in zip(several, points, rows, strict=True):
            self._known[coordinates] = {}
            counts = row.pop(COVERAGE, None)
            if counts is None:
                self._failed += 1
                if self._refused is None and row["verdict"] == REFUSED:
                    self._refused = point
            else:
                self._note(coordinates, point, from_json("--cover", str(counts)))

    def _note(self, coordinates: Coordinates, point: tuple[Value, ...], coverage: Coverage) -> None:
        """Note the branches that a run has reached, and how near it came to the others."""
        self.coverage = self.coverage.plus(coverage)
        lines = {
            (cycle.file, cycle.line, index): branch.line
            for cycle in coverage.cycles
            for index, branch in enumerate(cycle.branches)
        }
        found = distances(coverage)
        for key, distance in found.items():
            known = self._nearest.get(key)
            if known is None or distance.key < known[1].key:
                self._nearest[key] = coordinates, distance
            if not distance.levels and key not in self._reached:
                self._reached.add(key)
                self._good.append(coordinates)
                number = self._space.number(coordinates)
                self._first.append(FirstRun(key[0], lines[key], point, number))
        self._known[coordinates] = found

    def order(
        self, budget: int, earlier: Sequence[Sequence[Value]]
    ) -> Iterator[Sequence[Coordinates]]:
        """Yield the coordinates of the runs, each once, those together that are made at once."""
        rest = [dimension.rest_value for dimension in self._runner.plan.dimensions]
        found = (self._space.of_point(point) for point in (*earlier, rest))
        first = [*dict.fromkeys(one for one in found if one is not None)]
        for begin in range(0, len(first), _AT_ONCE):
            yield first[begin : begin + _AT_ONCE]
        spread = (one for one in self._space.spread() if one not in self._known)
        yield list(itertools.islice(spread, min(_FIRST_RUNS, budget // _FIRST_PART)))
        for coordinates in spread:
            yield from self._approaches()
            if coordinates not in self._known:
                yield [coordinates]

    def _approaches(self) -> Iterator[Sequence[Coordinates]]:
        """Approach the branches, each by a run at a time, until only known points are asked for."""
        while True:
            closed = self._reached | self._proofs.keys()
            asked: dict[Coordinates, None] = {}
            for key in [key for key in self._nearest if key not in closed]:
                turn = self._turns.setdefault(key, _Turn(self._approach(key)))
                coordinates = turn.next_unknown(key, self._known)
                if coordinates is not None:
                    asked[coordinates] = None
            if not asked:
                return
            yield list(asked)

    # --- one branch -----------------------------------------------------------------------------

    def _approach(self, key: BranchKey) -> _Approach:
        """Descend from the nearest run, then repeatedly from points next to it or elsewhere."""
        current = self._nearest[key]
        sweeps: dict[int, int] = {}
        while True:
            gained = True
            while gained:
                gained = False
                for axis in range(len(self._space.sizes)):
                    better = yield from self._along(current, axis)
                    if better is not None:
                        current, gained = better, True
            nearest = self._nearest[key]
            sweep = sweeps.setdefault(nearest[1].levels, 0)
            sweeps[nearest[1].levels] += 1
            better = yield from self._swept(nearest, sweep)
            if better is None:
                start = self._elsewhere(nearest[0])
                better = start, (yield start)
            current = better

    def _along(
        self, current: tuple[Coordinates, BranchDistance], axis: int
    ) -> Generator[Coordinates, BranchDistance, tuple[Coordinates, BranchDistance] | None]:
        """Return a better point along an axis; ``None`` if no step finds any."""
        begin, size = current[0][axis], self._space.sizes[axis]
        step = 1
        while step < size:
            for sign in (1, -1):
                moved = begin + sign * step
                if not 0 <= moved < size:
                    continue
                tried = _moved(current[0], axis, moved)
                distance = yield tried
                zero = _where_zero(begin, current[1], moved, distance)
                if zero is not None and 0 <= zero < size and zero not in (begin, moved):
                    jumped = _moved(current[0], axis, zero)
                    closer = yield jumped
                    if closer.key < min(current[1].key, distance.key):
                        return jumped, closer
                if distance.key < current[1].key:
                    return (yield from self._onward((tried, distance), axis, sign * step))
            step *= _STEP_FACTOR
        return None

    def _onward(
        self, current: tuple[Coordinates, BranchDistance], axis: int, step: int
    ) -> Generator[Coordinates, BranchDistance, tuple[Coordinates, BranchDistance]]:
        """Continue with doubled steps as long as they improve it."""
        while True:
            step *= 2
            moved = current[0][axis] + step
            if not 0 <= moved < self._space.sizes[axis]:
                return current
            tried = _moved(current[0], axis, moved)
            distance = yield tried
            if not distance.key < current[1].key:
                return current
            current = tried, distance

    def _swept(
        self, nearest: tuple[Coordinates, BranchDistance], sweep: int
    ) -> Generator[Coordinates, BranchDistance, tuple[Coordinates, BranchDistance] | None]:
        """Return a better point next to the nearest one: in turn all numbers of each dimension.

        A time at which something has to happen in the very tick of another event has no distance.
        """
        for axis, size in enumerate(self._space.sizes):
            if size > _MAX_SWEPT:
                continue
            for index in range(sweep * _SWEPT, min((sweep + 1) * _SWEPT, size)):
                tried = _moved(nearest[0], axis, index)
                distance = yield tried
                if distance.key < nearest[1].key:
                    return tried, distance
        return None

    def _elsewhere(self, nearest: Coordinates) -> Coordinates:
        """Return in turn a random point, the nearest one with one dimension changed, and a mixture.

        The mixture takes each dimension from one of the points that reached a branch or came
        nearest.
        """
        self._draws += 1
        sizes = self._space.sizes
        drawn = tuple(self._draw(axis, size) for axis, size in enumerate(sizes))
        if self._draws % 3 == 0:
            return drawn
        if self._draws % 3 == 1:
            axis = self._draw(len(sizes), len(sizes))
            return _moved(nearest, axis, drawn[axis])
        good = [*self._good, *(coordinates for coordinates, _ in self._nearest.values())]
        return tuple(
            good[self._draw(len(sizes) + axis, len(good))][axis] for axis in range(len(sizes))
        )

    def _draw(self, what: int, size: int) -> int:
        """Return a number below a size that belongs to this draw."""
        return min(int(chance(what, self._draws) * size), size - 1)

    def result(self) -> Reached:
        """Return the result of the runs."""
        reached = [one.point for one in self._first]
        left = [near for key, near in self._nearest.items() if key not in self._reached]
        best = dict.fromkeys(
            [*reached, *(self._space.point(coordinates) for coordinates, _ in left)]
        )
        return Reached(
            self.coverage,
            tuple(self._first),
            tuple(best),
            self._space.count - self.runs,
            self._failed,
            self._failure(),
            {key: proof for key, proof in self._proofs.items() if key not in self._reached},
        )

    def _failure(self) -> tuple[Diagnostic, ...]:
        """Return the reports of the first run that was not possible, restarted for that."""
        try:
            if self._refused is not None:
                covered(self._runner, self._refused)
        except Failure as failure:
            return tuple(failure.diagnostics)
        return ()


class _Turn:
    """An approach, and its latest request."""

    def __init__(self, approach: _Approach) -> None:
        self._approach = approach
        self._asked: Coordinates | None = None

    def next_unknown(
        self, key: BranchKey, known: dict[Coordinates, _Distances]
    ) -> Coordinates | None:
        """Return the next coordinates that no run has had; ``None`` after many known ones."""
        for _ in range(_MAX_KNOWN):
            if self._asked is None:
                self._asked = next(self._approach)
            else:
                distance = known[self._asked].get(key, NOT_THERE)
                self._asked = self._approach.send(distance)
            if self._asked not in known:
                return self._asked
        return None


def _moved(coordinates: Coordinates, axis: int, number: int) -> Coordinates:
    return (*coordinates[:axis], number, *coordinates[axis + 1 :])


def _where_zero(first: int, one: BranchDistance, second: int, other: BranchDistance) -> int | None:
    """Return where the difference of a comparison would be 0 if it were a straight line."""
    if one.levels != other.levels or one.difference is None or other.difference is None:
        return None
    change = other.difference - one.difference
    if not change:
        return None
    zero = first - one.difference * (second - first) / change
    return round(zero) if abs(zero) < 1e15 else None

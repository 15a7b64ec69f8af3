# SPDX-License-Identifier: MIT
"""The search for the single change that brings a run nearer to a log.

In: a comparison, and a function that reruns the program with a change. Out: proposals, the best
first. The distance of curves is one number: the root of the mean square of their deviations, each
as a share of its curve's span, after realignment. A run that has ended keeps its last values, so
that none is near just by being short.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.comparison.aligning_event import GivenTime
from nctakt.comparison.alignment import Curve
from nctakt.comparison.comparison import NOTHING_GIVEN, Comparison
from nctakt.comparison.mapping import Pair
from nctakt.comparison.recorded import Recorded, RecordedTrace
from nctakt.lists.machine.machine import Machine
from nctakt.proposals.changes import Change, changes_by_axis, changes_of
from nctakt.results.run import Run

#: The factors at which a change is tried first, and those among which its best value lies.
_FIRST = (0.7, 1.4)
_FACTORS = (0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.2, 1.4, 2.0, 3.0, 5.0, 10.0)
#: Delays of a function that are tried, in µs.
_DELAYS_US = (3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6)
#: Changes for which these values are tried, for which those around the best one are, and for how
#: many runs close in on it; rounds of that.
_COARSE, _CLOSER, _REFINED, _ROUNDS = 12, 6, 3, 14
#: The largest share of the distance that a proposal leaves, and how many are made.
_LEFT, _MAX_PROPOSALS = 0.8, 5
#: A better value by less than this share is as good as the rounder one.
_AS_GOOD = 1.02
#: Into how many parts the values around the best one are divided before the search closes in.
_PARTS = 8
#: A distance that is rounding, as a share of the curves' spans.
_EQUAL = 1e-9
_GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0

#: Runs the program with a change and its value; ``None`` if that is not possible.
Again = Callable[[Change, float], Run | None]


@dataclass(frozen=True, slots=True)
class Proposal:
    """A change with its value, and the distance that it leaves."""

    change: Change
    value: float
    distance: float


@dataclass(frozen=True, slots=True)
class Proposals:
    """The distance without a change, how many runs were made, and the changes that reduce it."""

    distance: float
    runs: int
    found: Sequence[Proposal]

    @property
    def equal(self) -> int:
        """How many of those found, the first included, come equally near."""
        if not self.found:
            return 0
        limit = _AS_GOOD * self.found[0].distance + _EQUAL
        return sum(one.distance <= limit for one in self.found)


class Search:
    """The search for one log; ``given``: known facts about its time."""

    def __init__(
        self,
        comparison: Comparison,
        pairs: Sequence[Pair],
        again: Again,
        given: GivenTime = NOTHING_GIVEN,
    ) -> None:
        self._given, self._again = given, again
        jumps = [one.jump_us for one in comparison.delays.found]
        self._is_late = any(one is None or one > 0.0 for one in jumps)
        self._jumps = [one for one in jumps if one is not None and one > 0.0]
        self._pairs = [pair for pair in pairs if not pair.signal.integral]
        raw = comparison.log.read([pair.column for pair in self._pairs])
        self._samples = [
            one.scaled(pair.factor, pair.offset) for pair, one in zip(self._pairs, raw, strict=True)
        ]
        self._spans = [one.span for one in self._samples]
        self._run = comparison.run
        self._end_us = float(self._run.cycle_time_us * (comparison.run.ticks - 1))
        self._before = self._distance(comparison.recorded)
        self._known: dict[tuple[Change, float], float] = {}

    def proposals(self, machine: Machine, override: float) -> Proposals:
        """Return changes that bring the run nearer; ``override``: that of the run, in percent."""
        if self._before <= _EQUAL:
            return Proposals(self._before, 0, [])
        moving = [
            pair.signal.name.split(".")[0]
            for pair, span in zip(self._pairs, self._spans, strict=True)
            if span > 0.0
        ]
        run = self._run
        functions = [one.name for one in run.outputs] if self._is_late else []
        groups: dict[tuple[float, ...], list[Change]] = {}
        for change in changes_of(machine, moving, functions, override, run.cycle_time_us):
            for one in (change, *self._parts(machine, change)):
                distances = tuple(self._tried(one, value) for value in self._first(one))
                if min(distances) < self._before:
                    groups.setdefault(distances, []).append(one)
        promising = [groups[distances] for distances in sorted(groups, key=min)[:_COARSE]]
        promising.sort(key=lambda group: self._nearest(group[0], self._values(group[0])).distance)
        promising = promising[:_CLOSER]
        promising.sort(key=lambda group: self._nearest(group[0], self._around(group[0])).distance)
        found = [one for group in promising[:_REFINED] for one in self._of_group(group)]
        near = [one for one in found if one.distance <= _LEFT * self._before]
        near.sort(key=lambda one: one.distance)
        all_ = Proposals(self._before, len(self._known), near)
        return Proposals(all_.distance, all_.runs, near[: max(all_.equal, _MAX_PROPOSALS)])

    def _of_group(self, group: Sequence[Change]) -> Iterator[Proposal]:
        """Yield the proposals of changes that do the same at the values tried first."""
        first = self._refined(group[0])
        yield first
        for change in group[1:]:
            if self._tried(change, first.value) == first.distance:
                yield Proposal(change, first.value, first.distance)
            else:
                yield self._refined(change)

    def _parts(self, machine: Machine, change: Change) -> list[Change]:
        """Return the change of each axis alone, if that of all has an effect."""
        has_effect = any(self._tried(change, one) != self._before for one in self._first(change))
        return list(changes_by_axis(machine, change)) if has_effect else []

    def _first(self, change: Change) -> list[float]:
        if change.kind == "function":
            return self._jumps or list(_DELAYS_US)
        return [_possible(change, factor * change.guess) for factor in _FIRST]

    def _values(self, change: Change) -> list[float]:
        """Return the values among which the best one is looked for, ascending."""
        if change.kind == "function":
            return sorted({0.0, *_DELAYS_US, *self._jumps})
        return [_possible(change, factor * change.guess) for factor in _FACTORS]

    def _around(self, change: Change) -> list[float]:
        """Return the values around the best one of ``_values``, ascending."""
        values = self._values(change)
        at = values.index(self._nearest(change, values).value)
        low, high = values[max(at - 1, 0)], values[min(at + 1, len(values) - 1)]
        return sorted({values[at], *numpy.linspace(low, high, _PARTS + 1).tolist()})

    def _nearest(self, change: Change, values: Sequence[float]) -> Proposal:
        """Return the best of some values."""
        value = min(values, key=lambda one: self._tried(change, one))
        return Proposal(change, value, self._tried(change, value))

    def _refined(self, change: Change) -> Proposal:
        """Return the best value of a change, as round as it may be."""
        values = self._around(change)
        at = values.index(self._nearest(change, values).value)
        low, high = values[max(at - 1, 0)], values[min(at + 1, len(values) - 1)]
        inner = [high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)]
        for _ in range(_ROUNDS):
            first, second = (self._tried(change, one) for one in inner)
            if first <= second:
                high, inner = inner[1], [inner[1] - _GOLDEN * (inner[1] - low), inner[0]]
            else:
                low, inner = inner[0], [inner[1], inner[0] + _GOLDEN * (high - inner[0])]
        best = _possible(
            change, min((values[at], *inner), key=lambda one: self._tried(change, one))
        )
        return self._rounded(change, best, self._tried(change, best))

    def _rounded(self, change: Change, best: float, distance: float) -> Proposal:
        for digits in (1, 2, 3):
            value = _possible(change, float(f"{best:.{digits - 1}e}"))
            reached = self._tried(change, value)
            if reached <= _AS_GOOD * distance:
                return Proposal(change, value, reached)
        return Proposal(change, best, distance)

    def _tried(self, change: Change, value: float) -> float:
        """Return the distance with a value of a change; infinite if it is not possible."""
        value = _possible(change, value)
        if (change, value) not in self._known:
            run = self._again(change, value)
            self._known[change, value] = (
                math.inf if run is None or run.errors else self._distance(RecordedTrace(run))
            )
        return self._known[change, value]

    def _distance(self, recorded: Recorded) -> float:
        """Return how far a run and the log are apart, as a share of the curves' spans."""
        period_us = float(recorded.cycle_time_us)
        curves = [Curve(period_us, recorded[one.signal.name]) for one in self._pairs]
        pairs = list(zip(self._samples, curves, strict=True))
        try:
            alignment = self._given.alignment(pairs, recorded)
        except Failure:  # a change may keep the event from happening
            return math.inf
        shares = []
        for samples, curve, span in zip(self._samples, curves, self._spans, strict=True):
            squares, count = 0.0, 0
            for stamps, values in samples.stretches():
                times = alignment.run_times(stamps)
                is_inside = (times >= 0.0) & (times <= max(curve.end_us, self._end_us))
                beside = values[is_inside] - curve.at(times[is_inside])
                squares, count = squares + float((beside**2).sum()), count + len(beside)
            if span > 0.0 and count:
                shares.append(squares / count / span**2)
        return math.sqrt(sum(shares) / len(shares)) if shares else math.inf


def _possible(change: Change, value: float) -> float:
    """Return the nearest value that a list, the operator or a tick can give."""
    if change.kind == "variable":
        value = min(max(value, 1.0), 200.0)
    return round(round(value / change.step) * change.step, 9) if change.step else value

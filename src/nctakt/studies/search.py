# SPDX-License-Identifier: MIT
"""The search of a study: a switch-over to the tick, the worst case, the smallest violation.

In: a bench and a plan. Out: the runs that answer the question, as rows. A search makes runs one
after another, since each decides about the next; the same plan makes the same runs.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.studies import (
    ANSWER_BROKEN,
    EXTRA_MISSING,
    NO_BOUNDARY,
    NOTHING_MEASURED,
)
from nctakt.studies.bench import HELD, Bench, Row
from nctakt.studies.dimension import Dimension, Value
from nctakt.studies.effects import without_effect
from nctakt.studies.plan import Goal

#: Halvings of a dimension without a step: a millionth of a millionth of its span.
MAX_HALVINGS = 40

#: The share of a search's budget that looks everywhere; the rest goes on from the best point.
WIDE_SHARE = 0.6


@dataclass(frozen=True, slots=True)
class Answer:
    """The answer to a goal: the run before and the run behind a switch-over, or the worst one.

    ``points``: the values of each; ``runs``: how many were made. ``finding``: why there is none, or
    none that counts; ``without_effect``: dimensions that changed nothing in all these runs.
    """

    goal: Goal
    rows: tuple[Row, ...]
    points: tuple[tuple[Value, ...], ...]
    runs: int
    finding: Diagnostic | None = None
    without_effect: tuple[str, ...] = ()


class _Runs:
    """Makes the runs of a search, each once."""

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self._rows: dict[tuple[Value, ...], Row] = {}

    def row(self, point: Sequence[Value]) -> Row:
        """Return the row of a point; its number is that of the run in the search."""
        key = tuple(point)
        if key not in self._rows:
            self._rows[key] = self._bench.row_of(len(self._rows), key)
        return self._rows[key]

    @property
    def count(self) -> int:
        """How many runs were made."""
        return len(self._rows)

    def without_effect(self) -> tuple[str, ...]:
        """Return the dimensions that changed nothing."""
        return tuple(without_effect(self._bench.plan, self._rows.values()))


def search(bench: Bench, goal: Goal) -> Answer:
    """Return the answer to a goal; raises ``Failure`` (901311) without the package it needs."""
    runs = _Runs(bench)
    find = _boundary if goal.word == "boundary" else _worst
    return replace(find(bench, goal, runs), without_effect=runs.without_effect())


def _boundary(bench: Bench, goal: Goal, runs: _Runs) -> Answer:
    """Halve the span of a dimension, the others at their first value, until two neighbours differ.

    On a grid they are neighbours of it, to the tick if its step is a tick.
    """
    dimensions = bench.plan.dimensions
    number = next(i for i, one in enumerate(dimensions) if goal.measure in ("", one.name))
    dimension = dimensions[number]
    point = [one.between(0.0) for one in dimensions]

    def point_at(share: int) -> tuple[Value, ...]:
        return (*point[:number], _value(dimension, share, last), *point[number + 1 :])

    def row_at(share: int) -> Row:
        return runs.row(point_at(share))

    low, high = 0, dimension.count - 1 if dimension.count else 1 << MAX_HALVINGS
    last = high
    at_low, at_high = row_at(low), row_at(high)
    holds_at_low = at_low["verdict"] == HELD
    if holds_at_low == (at_high["verdict"] == HELD):
        found = diagnostic(NO_BOUNDARY, low=at_low[dimension.name], high=at_high[dimension.name])
        ends = (point_at(low), point_at(high))
        return Answer(goal, (at_low, at_high), ends, runs.count, found)
    while high - low > 1:
        middle = (low + high) // 2
        row = row_at(middle)
        if (row["verdict"] == HELD) == holds_at_low:
            low, at_low = middle, row
        else:
            high, at_high = middle, row
    return Answer(goal, (at_low, at_high), (point_at(low), point_at(high)), runs.count)


def _value(dimension: Dimension, share: int, last: int) -> Value:
    """Return the value of a number on the grid, or at a share of the way."""
    if dimension.count:
        return dimension.value(share)
    return dimension.between(share / last)


def _worst(bench: Bench, goal: Goal, runs: _Runs) -> Answer:
    """Look for the smallest or largest value of a measure.

    Where the budget is enough for the whole grid, each point is tried. Else optuna's tree of Parzen
    estimators looks for the region, and steps of halving length from the best point for the rest.
    """
    dimensions = bench.plan.dimensions
    sign = 1.0 if goal.word == "minimize" else -1.0

    def measured(numbers: Sequence[float]) -> float:
        point = [dimension_value(one, n) for one, n in zip(dimensions, numbers, strict=True)]
        value = runs.row(point)[goal.measure]
        return sign * value if isinstance(value, float | int) else math.inf

    if 0 < math.prod(one.count for one in dimensions) <= goal.budget:
        best: Sequence[float] = min(
            itertools.product(*(range(one.count) for one in dimensions)), key=measured
        )
    else:
        best = _by_optuna(bench, goal, measured)
        best = _by_steps(dimensions, best, measured, lambda: runs.count < goal.budget)
    point = tuple(dimension_value(one, n) for one, n in zip(dimensions, best, strict=True))
    row = runs.row(point)
    found = None
    if not isinstance(row[goal.measure], float | int):
        found = diagnostic(NOTHING_MEASURED, measure=goal.measure, count=runs.count)
    elif row["verdict"] != HELD:
        found = diagnostic(ANSWER_BROKEN, broken=row["broken"])
    return Answer(goal, (row,), (point,), runs.count, found)


def _by_optuna(
    bench: Bench, goal: Goal, measured: Callable[[Sequence[float]], float]
) -> Sequence[float]:
    """Return the best point of a share of the budget; raises ``Failure`` (901311)."""
    try:
        import optuna  # noqa: PLC0415 - an extra that few plans need
    except ImportError as error:
        raise Failure(diagnostic(EXTRA_MISSING, package="optuna", extra="studies")) from error
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    dimensions = bench.plan.dimensions
    names = [str(number) for number in range(len(dimensions))]

    def objective(trial: optuna.Trial) -> float:
        return measured(
            [
                trial.suggest_int(name, 0, one.count - 1)
                if one.count
                else trial.suggest_float(name, 0.0, 1.0)
                for name, one in zip(names, dimensions, strict=True)
            ]
        )

    study = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=bench.plan.seed))
    study.optimize(objective, n_trials=max(1, round(goal.budget * WIDE_SHARE)))
    return [study.best_params[name] for name in names]


def _by_steps(
    dimensions: Sequence[Dimension],
    best: Sequence[float],
    measured: Callable[[Sequence[float]], float],
    has_budget: Callable[[], bool],
) -> Sequence[float]:
    """Return the best point that steps from a point find, each half as long as the one before."""
    lowest = measured(best)
    for halving in range(1, MAX_HALVINGS):
        steps = [max(1.0, one.count // 2**halving) if one.count else 0.5**halving
                 for one in dimensions]  # fmt: skip
        is_better = True
        while is_better and has_budget():
            is_better = False
            for index, step in itertools.product(range(len(best)), (1.0, -1.0)):
                number = best[index] + step * steps[index]
                last = dimensions[index].count - 1 if dimensions[index].count else 1.0
                other = [*best[:index], min(max(number, 0.0), last), *best[index + 1 :]]
                if has_budget() and measured(other) < lowest:
                    best, lowest, is_better = other, measured(other), True
    return best


def dimension_value(dimension: Dimension, number: float) -> Value:
    """Return the value of a number on the grid, or at a share of the way."""
    return dimension.value(int(number)) if dimension.count else dimension.between(number)


def shrink(bench: Bench, point: Sequence[Value], nominal: Sequence[Value]) -> Answer:
    """Return the smallest change from the nominal point that still breaks something.

    Each dimension goes back to its nominal value if the run stays broken then; a number that has to
    differ goes back as far as halving its change finds broken runs.
    """
    runs = _Runs(bench)
    current = list(point)
    smallest = runs.row(current)
    for index, dimension in enumerate(bench.plan.dimensions):

        def breaks(value: Value, index: int = index) -> bool:
            row = runs.row([*current[:index], value, *current[index + 1 :]])
            return row["verdict"] != HELD

        current[index] = _nearest_broken(current[index], nominal[index], dimension, breaks)
        smallest = runs.row(current)
    return Answer(Goal("boundary", "", 0), (smallest,), (tuple(current),), runs.count)


def _nearest_broken(
    value: Value, rest: Value, dimension: Dimension, breaks: Callable[[Value], bool]
) -> Value:
    """Return the value next to ``rest`` that halving the change finds broken."""
    if value == rest or breaks(rest):
        return rest
    if isinstance(value, str) or isinstance(rest, str) or dimension.values:
        return value
    held = rest
    smallest = dimension.tick_us if dimension.is_time else abs(value - held) / (1 << MAX_HALVINGS)
    step = dimension.step or smallest
    while abs(value - held) > 1.5 * step:
        middle = held + round((value - held) / 2 / step) * step
        middle = round(middle) if dimension.is_time else middle
        if breaks(middle):
            value = middle
        else:
            held = middle
    return value

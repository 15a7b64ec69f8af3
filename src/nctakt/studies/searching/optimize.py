# SPDX-License-Identifier: MIT
"""The points that a search for the best runs tries: a whole grid, or suggestions of optuna.

In: a plan, a goal, the runs of a search. Out: more of these runs. Expectations are constraints: a
run that meets them is better than one that does not, regardless of their values. The same plan
tries the same points.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import EXTRA_MISSING
from nctakt.messages.extras import install_command
from nctakt.studies.plans.dimension import Dimension, Value
from nctakt.studies.plans.plan import Goal, Plan
from nctakt.studies.runs.study_runner import PASSED, Row
from nctakt.studies.searching.search_runs import Runs

#: Halvings of a dimension without a step: a millionth of a millionth of its span.
MAX_HALVINGS = 40

#: The share of a budget spent on looking everywhere; the rest continues from the best point.
WIDE_SHARE = 0.6

#: How good a run is, smaller is better: whether it breaks something, then its objectives.
Rank = tuple[float, ...]


def objective_values(goal: Goal, row: Row) -> tuple[float, ...] | None:
    """Return the objectives of a run, smaller is better; ``None`` if one has no number."""
    values = []
    for word, name in goal.objectives:
        value = row[name]
        if not isinstance(value, float | int):
            return None
        values.append(float(value) if word == "minimize" else -float(value))
    return tuple(values)


def optimize(plan: Plan, goal: Goal, runs: Runs) -> None:
    """Try points; raises ``Failure`` (901311) without optuna where it is needed.

    If the budget is enough for the whole grid, each point is tried. Otherwise optuna looks for the
    region, and for one objective the rest goes into steps of halving length from the best point.
    """
    dimensions = plan.dimensions

    def point_of(numbers: Sequence[float]) -> list[Value]:
        return [dimension_value(one, n) for one, n in zip(dimensions, numbers, strict=True)]

    def ranked(numbers: Sequence[float]) -> Rank:
        row = runs.row(point_of(numbers))
        values = objective_values(goal, row) or (math.inf,) * len(goal.objectives)
        return (float(row["verdict"] != PASSED), *values)

    if 0 < math.prod(one.count for one in dimensions) <= goal.budget:
        grid = itertools.product(*(range(one.count) for one in dimensions))
        runs.all([point_of(numbers) for numbers in grid])
        return
    is_single = len(goal.objectives) == 1
    trials = goal.budget if not is_single else max(1, round(goal.budget * WIDE_SHARE))
    best = _by_optuna(plan, goal, ranked, trials)
    if is_single:
        _by_steps(dimensions, best, ranked, lambda: runs.count < goal.budget)


def dimension_value(dimension: Dimension, number: float) -> Value:
    """Return the value of a number on the grid, or at a share of the range."""
    return dimension.value(int(number)) if dimension.count else dimension.between(number)


def _by_optuna(
    plan: Plan, goal: Goal, ranked: Callable[[Sequence[float]], Rank], trials: int
) -> Sequence[float]:
    """Return the best of the points that optuna suggests; raises ``Failure`` (901311)."""
    try:
        import optuna  # noqa: PLC0415 - an extra that few plans need
    except ImportError as error:
        raise Failure(
            diagnostic(EXTRA_MISSING, package="optuna", install=install_command("studies"))
        ) from error
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    found: list[tuple[Rank, Sequence[float]]] = []

    def objective(trial: optuna.Trial) -> tuple[float, ...]:
        numbers = [
            trial.suggest_int(str(number), 0, one.count - 1)
            if one.count
            else trial.suggest_float(str(number), 0.0, 1.0)
            for number, one in enumerate(plan.dimensions)
        ]
        rank = ranked(numbers)
        found.append((rank, numbers))
        trial.set_constraint("expectations", rank[0])
        return rank[1:]

    sampler = optuna.samplers.TPESampler(seed=plan.seed)
    directions = ["minimize"] * len(goal.objectives)
    study = optuna.create_study(directions=directions, sampler=sampler)
    study.optimize(objective, n_trials=trials)
    return min(found, key=lambda one: one[0])[1]


def _by_steps(
    dimensions: Sequence[Dimension],
    best: Sequence[float],
    ranked: Callable[[Sequence[float]], Rank],
    has_budget: Callable[[], bool],
) -> None:
    """Try steps from the best point, each half as long as the last."""
    lowest = ranked(best)
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
                if has_budget() and ranked(other) < lowest:
                    best, lowest, is_better = other, ranked(other), True

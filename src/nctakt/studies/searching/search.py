# SPDX-License-Identifier: MIT
"""The search of a study: a switch-over, the best run that passes, the smallest violation.

In: the runs of a plan, and a goal. Out: the runs that answer the question, as rows. A search makes
runs one by one, since each decides about the next; the same plan makes the same runs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import (
    ANSWER_BROKEN,
    NO_BOUNDARY,
    NOTHING_MEASURED,
)
from nctakt.studies.plans.dimension import Dimension, Value
from nctakt.studies.plans.plan import Goal
from nctakt.studies.runs.study_runner import PASSED, Row, StudyRunner
from nctakt.studies.searching.optimize import MAX_HALVINGS, objective_values, optimize
from nctakt.studies.searching.search_runs import Runs, SearchRuns

#: A point, its row, and the values of its objectives, smaller is better.
_Measured = tuple[tuple[Value, ...], Row, tuple[float, ...]]


@dataclass(frozen=True, slots=True)
class Answer:
    """The answer to a goal.

    ``rows``: the run before and the run after a switch-over; or the best run that meets the
    expectations, then the best one that does not if it is better; or the Pareto set.

    ``points``: the values of each; ``runs``: how many were made. ``finding``: why there is no
    answer, or none that counts; ``without_effect``: dimensions that changed nothing in all these
    runs.
    """

    goal: Goal
    rows: tuple[Row, ...]
    points: tuple[tuple[Value, ...], ...]
    runs: int
    finding: Diagnostic | None = None
    without_effect: tuple[str, ...] = ()


def search(searched: SearchRuns, goal: Goal) -> Answer:
    """Return the answer to a goal; raises ``Failure`` (901311) without the package it needs."""
    runs = Runs(searched)
    if goal.word == "boundary":
        answer = _boundary(searched.runner, goal, runs)
    else:
        optimize(searched.runner.plan, goal, runs)
        answer = _best(goal, runs)
    return replace(answer, without_effect=runs.without_effect())


def _best(goal: Goal, runs: Runs) -> Answer:
    """Return the findings of a search's runs."""
    measured = [
        (point, row, values)
        for point, row in runs.tried
        if (values := objective_values(goal, row)) is not None
    ]
    if not measured:
        names = ", ".join(name for _, name in goal.objectives)
        nothing = diagnostic(NOTHING_MEASURED, measure=names, count=runs.count)
        point, row = runs.tried[0]
        return Answer(goal, (row,), (point,), runs.count, nothing)
    held = [one for one in measured if one[1]["verdict"] == PASSED]
    others = [one for one in measured if one[1]["verdict"] != PASSED]
    shown = pareto_set(held)
    if len(goal.objectives) == 1:
        shown = shown[:1]
        shown += [one for one in pareto_set(others)[:1] if not shown or one[2] < shown[0][2]]
    elif not held:
        shown = pareto_set(others)
    found = None if held else diagnostic(ANSWER_BROKEN, broken=shown[0][1]["broken"])
    rows, points = tuple(one[1] for one in shown), tuple(one[0] for one in shown)
    return Answer(goal, rows, points, runs.count, found)


def pareto_set(runs: Sequence[_Measured]) -> list[_Measured]:
    """Return the Pareto set: no other run is at least as good in all and better in one objective.

    Of runs with the same values the first one; sorted by the first objective.
    """
    kept: list[_Measured] = []
    for one in sorted(runs, key=lambda run: run[2]):
        if not any(all(a <= b for a, b in zip(other[2], one[2], strict=True)) for other in kept):
            kept.append(one)
    return kept


def _boundary(runner: StudyRunner, goal: Goal, runs: Runs) -> Answer:
    """Halve the span of a dimension, the others at their first value, until two neighbours differ.

    On a grid they are neighbours of it; times are always tried in whole ticks, so that its two
    neighbours are ticks that follow each other.
    """
    dimensions = runner.plan.dimensions
    number = next(i for i, one in enumerate(dimensions) if goal.measure in ("", one.name))
    dimension = in_ticks(dimensions[number])
    point = [one.between(0.0) for one in dimensions]

    def point_at(share: int) -> tuple[Value, ...]:
        return (*point[:number], _value(dimension, share, last), *point[number + 1 :])

    def row_at(share: int) -> Row:
        return runs.row(point_at(share))

    low, high = 0, dimension.count - 1 if dimension.count else 1 << MAX_HALVINGS
    last = high
    at_low, at_high = row_at(low), row_at(high)
    holds_at_low = at_low["verdict"] == PASSED
    if holds_at_low == (at_high["verdict"] == PASSED):
        found = diagnostic(NO_BOUNDARY, low=at_low[dimension.name], high=at_high[dimension.name])
        ends = (point_at(low), point_at(high))
        return Answer(goal, (at_low, at_high), ends, runs.count, found)
    while high - low > 1:
        middle = (low + high) // 2
        row = row_at(middle)
        if (row["verdict"] == PASSED) == holds_at_low:
            low, at_low = middle, row
        else:
            high, at_high = middle, row
    return Answer(goal, (at_low, at_high), (point_at(low), point_at(high)), runs.count)


def in_ticks(dimension: Dimension) -> Dimension:
    """Return a dimension of times with a step of a tick from the first tick between its bounds.

    A list of times is unchanged, and so are bounds without a tick between them.
    """
    tick_us = dimension.tick_us
    first, last = math.ceil(dimension.low / tick_us), math.floor(dimension.high / tick_us)
    if not dimension.is_time or dimension.values or last <= first:
        return dimension
    return replace(dimension, low=first * tick_us, high=last * tick_us, step=tick_us)


def _value(dimension: Dimension, share: int, last: int) -> Value:
    """Return the value of a number on the grid, or at a share of the range."""
    if dimension.count:
        return dimension.value(share)
    return dimension.between(share / last)


def shrink(runner: StudyRunner, point: Sequence[Value], nominal: Sequence[Value]) -> Answer:
    """Return the smallest change from the nominal point that still breaks something.

    Each dimension goes back to its nominal value if the run stays broken then; a number that has to
    differ goes back as far as halving its change finds broken runs.
    """
    runs = Runs(SearchRuns(runner))
    current = list(point)
    smallest = runs.row(current)
    for index, dimension in enumerate(runner.plan.dimensions):

        def breaks(value: Value, index: int = index) -> bool:
            row = runs.row([*current[:index], value, *current[index + 1 :]])
            return row["verdict"] != PASSED

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

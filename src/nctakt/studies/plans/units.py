# SPDX-License-Identifier: MIT
"""The units of the columns of a study: of inputs, measures, and counts.

In: a plan, the units of the machine's signals. Out: unit by name of the column, for frames, files
and axes of pictures. A column without a unit, or whose unit is not known, is not in it.
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.lists.format.times import Time
from nctakt.studies.measuring.measure_nodes import (
    Binary,
    Constant,
    Extreme,
    Node,
    Property,
    TimeBetween,
    TimeOf,
    ValueAt,
)
from nctakt.studies.plans.plan import Plan
from nctakt.studies.plans.schedule_measures import ScheduleNumber

#: The column of the time that the first expectation ``CONDITION within TIME`` took.
REACTION = "reaction_time"

SECOND = "s"

#: The unit of a signal by its name in a measure; empty for none.
SignalUnit = Callable[[str], str]


def units_of(plan: Plan, signal_unit: SignalUnit) -> dict[str, str]:
    """Return the units of the columns of a plan's rows."""
    units = {"ticks": "ticks"}
    for dimension in plan.dimensions:
        is_value = dimension.kind in ("variable", "series", "noise")
        unit = signal_unit(dimension.target) if is_value else ""
        units[dimension.name] = SECOND if dimension.is_time else unit
    for measure in plan.measures:
        units[measure.name] = _unit(measure.node, signal_unit) or ""
    if any(one.reaction for one in plan.expectations):
        units[REACTION] = SECOND
    return {name: unit for name, unit in units.items() if unit}


def _unit(node: Node, signal_unit: SignalUnit) -> str | None:
    """Return the unit of a value; ``None`` for a plain number, which goes with any unit."""
    match node:
        case Constant():
            return SECOND if isinstance(node.constant, Time) else None
        case Property():
            return {"duration": SECOND, "ticks": "ticks"}.get(node.name, "")
        case TimeOf() | TimeBetween():
            return SECOND
        case ScheduleNumber():
            return SECOND if node.is_time else ""
        case Extreme() | ValueAt():
            return signal_unit(node.name)
        case Binary(word=word, left=left, right=right):
            return _of_result(word, _unit(left, signal_unit), _unit(right, signal_unit))
    return ""


def _of_result(word: str, left: str | None, right: str | None) -> str | None:
    """Return the unit of a result; empty if it has none or an unnamed one."""
    if word in ("+", "-"):
        if left is None or right is None:
            return left or right
        return left if left == right else ""
    if word == "*" and None in (left, right):
        return left or right
    return left if word == "/" and right is None else ""

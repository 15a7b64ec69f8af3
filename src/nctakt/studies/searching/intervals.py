# SPDX-License-Identifier: MIT
"""Intervals of numbers: possible values of an expression whose variables are within bounds.

In: an expression of the tree, and an interval for each variable that has bounds. Out: an interval
that holds every value that the realtime part can compute (RC-206), perhaps more; whether a
condition can be true or false; and the bounds of variables where it is. Each bound is rounded
outward, so that no rounding of the realtime part is outside.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from nctakt.base.dataclass import dataclass
from nctakt.nc import tree

#: The name of a variable in bounds: family and parts.
VariableName = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Interval:
    """All numbers from ``low`` to ``high``."""

    low: float
    high: float

    @property
    def is_empty(self) -> bool:
        """Whether no number is in it."""
        return not self.low <= self.high

    @property
    def is_bounded(self) -> bool:
        """Whether both bounds are numbers."""
        return math.isfinite(self.low) and math.isfinite(self.high)

    def hull(self, *others: Interval) -> Interval:
        """Return the least interval with this and the others in it."""
        parts = (self, *others)
        return Interval(min(one.low for one in parts), max(one.high for one in parts))

    def cut(self, other: Interval) -> Interval:
        """Return the intersection."""
        return Interval(max(self.low, other.low), min(self.high, other.high))


ANY = Interval(-math.inf, math.inf)
_TRUTH = Interval(0.0, 1.0)

Bounds = Mapping[VariableName, Interval]

_CONSTANTS = {"TRUE": 1.0, "FALSE": 0.0, "PI": math.pi}
_MIRRORED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}
_NEGATED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
#: Functions that keep the order of their arguments.
_RISING: dict[str, Callable[[float], float]] = {
    "INT": math.trunc, "ROUND": round, "CEIL": math.ceil, "FLOOR": math.floor,
}  # fmt: skip
#: A value counts as true from this magnitude on (RC-202).
_TRUE_FROM = 0.5


def name_of(variable: tree.Variable) -> VariableName | None:
    """Return the name of a variable without indices; ``None`` for others."""
    if any(part.indices for part in variable.parts):
        return None
    return variable.family.upper(), *(part.name.upper() for part in variable.parts)


def interval_of(expression: tree.Expression, bounds: Bounds) -> Interval:
    """Return an interval that holds each value of an expression."""
    match expression:
        case tree.Number():
            return Interval(expression.value, expression.value)
        case tree.Constant():
            value = _CONSTANTS[expression.name]
            return Interval(value, value)
        case tree.Variable():
            name = name_of(expression)
            return ANY if name is None else bounds.get(name, ANY)
        case tree.Unary(operator="-"):
            operand = interval_of(expression.operand, bounds)
            return Interval(-operand.high, -operand.low)
        case tree.Unary(operator="NOT"):
            return _TRUTH
        case tree.Binary():
            left, right = (
                interval_of(expression.left, bounds),
                interval_of(expression.right, bounds),
            )
            return _combined(expression.operator, left, right)
        case tree.Call() if len(expression.arguments) == 1:
            return _called(expression.function, interval_of(expression.arguments[0], bounds))
    return ANY


def _combined(operator: str, left: Interval, right: Interval) -> Interval:
    if operator in _MIRRORED or operator in ("&&", "||", "XOR"):
        return _TRUTH
    if not (left.is_bounded and right.is_bounded):
        return ANY
    match operator:
        case "+":
            return _outward(left.low + right.low, left.high + right.high)
        case "-":
            return _outward(left.low - right.high, left.high - right.low)
        case "*":
            ends = [a * b for a in (left.low, left.high) for b in (right.low, right.high)]
            return _outward(min(ends), max(ends))
        case "/" if right.low > 0.0 or right.high < 0.0:
            ends = [a / b for a in (left.low, left.high) for b in (right.low, right.high)]
            return _outward(min(ends), max(ends))
    return ANY


def _called(function: str, argument: Interval) -> Interval:
    match function:
        case "SIN" | "COS":
            return Interval(-1.0, 1.0)
        case "NOT":
            return _TRUTH
        case "ABS":
            ends = abs(argument.low), abs(argument.high)
            lowest = 0.0 if argument.low <= 0.0 <= argument.high else min(ends)
            return Interval(lowest, max(ends))
        case "SQR" if argument.is_bounded:
            ends = argument.low * argument.low, argument.high * argument.high
            lowest = 0.0 if argument.low <= 0.0 <= argument.high else min(ends)
            return _outward(lowest, max(ends))
    if function in _RISING and argument.is_bounded:
        convert = _RISING[function]
        return Interval(float(convert(argument.low)), float(convert(argument.high)))
    return ANY


def _outward(low: float, high: float) -> Interval:
    """Return the interval with each bound rounded outward; any number where it is not finite."""
    if not (math.isfinite(low) and math.isfinite(high)):
        return ANY
    return Interval(math.nextafter(low, -math.inf), math.nextafter(high, math.inf))


def can_be(condition: tree.Expression, truth: bool, bounds: Bounds) -> bool:
    """Return whether a condition can be true, or false; ``True`` where that is not known."""
    if isinstance(condition, tree.Binary):
        if condition.operator in ("&&", "||"):
            sides = can_be(condition.left, truth, bounds), can_be(condition.right, truth, bounds)
            return all(sides) if (condition.operator == "&&") is truth else any(sides)
        if condition.operator in _MIRRORED:
            operator = condition.operator if truth else _NEGATED[condition.operator]
            left = interval_of(condition.left, bounds)
            return _can_compare(left, operator, interval_of(condition.right, bounds))
    negated = _operand_of_not(condition)
    if negated is not None:
        return can_be(negated, not truth, bounds)
    value = interval_of(condition, bounds)
    if truth:
        return value.high >= _TRUE_FROM or value.low <= -_TRUE_FROM
    return value.low < _TRUE_FROM and value.high > -_TRUE_FROM


def _operand_of_not(condition: tree.Expression) -> tree.Expression | None:
    match condition:
        case tree.Unary(operator="NOT"):
            return condition.operand
        case tree.Call(function="NOT", arguments=(operand,)):
            return operand
    return None


def _can_compare(left: Interval, operator: str, right: Interval) -> bool:
    match operator:
        case "<":
            return left.low < right.high
        case "<=":
            return left.low <= right.high
        case ">":
            return left.high > right.low
        case ">=":
            return left.high >= right.low
        case "==":
            return not left.cut(right).is_empty
    return not left.low == left.high == right.low == right.high


def narrowed(
    condition: tree.Expression, truth: bool, bounds: dict[VariableName, Interval]
) -> dict[VariableName, Interval]:
    """Return the bounds of the variables where a condition is true, or false."""
    negated = _operand_of_not(condition)
    if negated is not None:
        return narrowed(negated, not truth, bounds)
    if not isinstance(condition, tree.Binary):
        return bounds
    if condition.operator in ("&&", "||"):
        if (condition.operator == "&&") is truth:
            return narrowed(condition.right, truth, narrowed(condition.left, truth, bounds))
        return bounds
    if condition.operator not in _MIRRORED:
        return bounds
    operator = condition.operator if truth else _NEGATED[condition.operator]
    for variable, side, other in (
        (condition.left, operator, condition.right),
        (condition.right, _MIRRORED[operator], condition.left),
    ):
        name = name_of(variable) if isinstance(variable, tree.Variable) else None
        if name in bounds:
            limit = interval_of(other, bounds)
            bounds = {**bounds, name: bounds[name].cut(_allowed(side, limit))}
    return bounds


def _allowed(operator: str, limit: Interval) -> Interval:
    """Return the numbers that compare so with some number of the limit; ``<`` includes it."""
    match operator:
        case "<" | "<=":
            return Interval(-math.inf, limit.high)
        case ">" | ">=":
            return Interval(limit.low, math.inf)
        case "==":
            return limit
    return ANY

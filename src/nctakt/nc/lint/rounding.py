# SPDX-License-Identifier: MIT
"""Constants that lose their fraction in a variable of whole numbers (RC-307).

In: an assignment of a program or realtime cycle. Out: a warning (901050) where its constant value
is rounded: ``V.RTG.OVERRIDE.VEL.CYCLE = 0.5`` stops the path, ``V.E.COUNT += 0.4`` adds nothing.
"""

from __future__ import annotations

from math import isfinite

from nctakt.base.diagnostics import NOTHING, Text
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages.lints import CONSTANT_ROUNDED
from nctakt.nc.check.findings import Findings
from nctakt.nc.lint.uses import is_override
from nctakt.nc.tree import Assignment, Binary, Expression, Number, Unary, Variable
from nctakt.nc.vocabulary.resolution import path_text, resolve
from nctakt.nc.vocabulary.variable_table import Location, NameTable

_PERCENT = Text(
    "An override is in percent: 50 is one half.", "Ein Override ist in Prozent: 50 ist die Hälfte."
)


def check_rounding(statement: Assignment, names: NameTable, findings: Findings) -> None:
    """Report a constant with a fraction that a variable of whole numbers gets."""
    target = statement.target
    if statement.operator not in ("=", "+=", "-=") or not isinstance(target, Variable):
        return
    value = constant(statement.value)
    if value is None or value == round(value):
        return
    location = resolve(target, names)
    if not isinstance(location, Location) or not location.is_numeric:
        return
    if not SCALARS[location.type].is_integer:
        return
    findings.report(
        CONSTANT_ROUNDED,
        statement.value.span,
        name=path_text(target),
        type=location.type,
        value=value,
        rounded=round(value),
        percent=_PERCENT if is_override(target) else NOTHING,
    )


def constant(expression: Expression) -> float | None:
    """Return the value of numbers and their sums, products and quotients; else ``None``."""
    if isinstance(expression, Number):
        return expression.value if isfinite(expression.value) else None
    if isinstance(expression, Unary):
        operand = constant(expression.operand)
        return None if operand is None else -operand
    if not isinstance(expression, Binary) or expression.operator not in ("+", "-", "*", "/"):
        return None
    left, right = constant(expression.left), constant(expression.right)
    if left is None or right is None or (expression.operator == "/" and right == 0.0):
        return None
    value = {
        "+": lambda: left + right,
        "-": lambda: left - right,
        "*": lambda: left * right,
        "/": lambda: left / right,
    }[expression.operator]()
    return value if isfinite(value) else None

# SPDX-License-Identifier: MIT
"""Constants that are valid but cannot be meant: of variables (RC-307), and of overrides.

In: an assignment of a program or realtime cycle. Out: a warning (901050) where its constant value
is rounded: ``V.RTG.OVERRIDE.VEL.CYCLE = 0.5`` stops the path, ``V.E.COUNT += 0.4`` adds nothing;
one (901051) where a BOOLEAN gets another number than 0 and 1; the error of a run (50892 in a cycle,
20847 in a program) where the value is out of the range of the type. Of ``#OVERRIDE [FEED_FACT=50]``
and of those of axes and spindles: the error of a run (21419), a warning (901158) where the value is
so small that a share was meant instead of per cent.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite

from nctakt.base.diagnostics import NOTHING, Text
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages.path.feed import INVALID_PROGRAM_OVERRIDE
from nctakt.messages.programs.decoder import VALUE_OUTSIDE_TYPE_RANGE
from nctakt.messages.programs.lints import (
    CONSTANT_NOT_BOOLEAN,
    CONSTANT_ROUNDED,
    OVERRIDE_IS_PERCENT,
)
from nctakt.messages.programs.realtime import CYCLE_VALUE_OUT_OF_RANGE
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import SPINDLE_FACTOR
from nctakt.nc.lint.uses import is_override
from nctakt.nc.meaning.path import OVERRIDE_FACTORS, OVERRIDE_MAX_PCT, OVERRIDE_MIN_PCT
from nctakt.nc.tree import Assignment, Binary, Expression, Keyword, Node, Number, Unary, Variable
from nctakt.nc.vocabulary.variables.resolution import path_text, resolve
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable

_PERCENT = Text(
    "An override is in percent: 50 is one half.", "Ein Override ist in Prozent: 50 ist die Hälfte."
)


#: Overrides up to this value are taken for shares: 1 for all, 0.5 for one half.
_LARGEST_SHARE = 1.0


def check_constant(
    statement: Assignment, names: NameTable, findings: Findings, *, in_cycle: bool
) -> None:
    """Report a constant with a fraction, or out of the range, for a variable of whole numbers."""
    target = statement.target
    if statement.operator not in ("=", "+=", "-=") or not isinstance(target, Variable):
        return
    location = resolve(target, names)
    if not isinstance(location, Location) or not location.is_numeric:
        return
    is_added = statement.operator != "="
    check_value(
        target, location.type, statement.value, findings, is_added=is_added, in_cycle=in_cycle
    )


def check_value(
    target: Variable,
    type_: str,
    expression: Expression,
    findings: Findings,
    *,
    is_added: bool = False,
    in_cycle: bool = False,
) -> None:
    """Report a constant value of a variable of this type as above; ``is_added``: a change of it."""
    value = constant(expression)
    scalar = SCALARS[type_]
    if value is None or not scalar.is_integer:
        return
    name, span = path_text(target), expression.span
    if type_ == "BOOLEAN":
        if value not in (0, 1):
            findings.report(
                CONSTANT_NOT_BOOLEAN, span, name=name, value=value, stored=int(abs(value) >= 0.5)
            )
        return
    rounded = round(value)
    if not is_added and not scalar.low <= rounded <= scalar.high:
        low, high = int(scalar.low), int(scalar.high)
        if in_cycle:
            findings.report(
                CYCLE_VALUE_OUT_OF_RANGE, span, variable=name, value=rounded, low=low, high=high
            )
        else:
            findings.report(
                VALUE_OUTSIDE_TYPE_RANGE, span, name=name, value=rounded, low=low, high=high
            )
    elif rounded != value:
        findings.report(
            CONSTANT_ROUNDED,
            span,
            name=name,
            type=type_,
            value=value,
            rounded=rounded,
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


def check_overrides(items: Iterable[Node], findings: Findings) -> None:
    """Report constants of FEED_FACT, RAPID_FACT and SPEED_FACT that cannot be meant."""
    for item in items:
        if not isinstance(item, Keyword) or item.name not in (*OVERRIDE_FACTORS, SPINDLE_FACTOR):
            continue
        value = None if item.value is None else constant(item.value)
        if item.value is None or value is None:
            continue
        if not OVERRIDE_MIN_PCT <= value <= OVERRIDE_MAX_PCT:
            findings.report(
                INVALID_PROGRAM_OVERRIDE,
                item.value.span,
                word=item.name,
                value=value,
                low=OVERRIDE_MIN_PCT,
                high=OVERRIDE_MAX_PCT,
            )
        elif value <= _LARGEST_SHARE:
            findings.report(
                OVERRIDE_IS_PERCENT,
                item.value.span,
                word=item.name,
                value=value,
                meant=100.0 * value,
            )

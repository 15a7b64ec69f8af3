# SPDX-License-Identifier: MIT
"""Comparisons of a condition that have only one possible result.

In: a condition of a program or of a realtime cycle. Out: a warning where the type of a variable
(900239) or the travel range of an axis (901052) decides the comparison with a constant.
"""

from __future__ import annotations

from nctakt.lists.declared.variables import SCALARS
from nctakt.messages.programs.lints import COMPARISON_OUTSIDE_TYPE_RANGE
from nctakt.nc.check.findings import Findings
from nctakt.nc.lint.constants import constant
from nctakt.nc.lint.reach import ALWAYS_TRUE, NEVER_TRUE, check_comparison
from nctakt.nc.lint.uses import always, comparisons_in
from nctakt.nc.meaning.cost import is_live
from nctakt.nc.tree import Binary, Expression, Number, Variable
from nctakt.nc.vocabulary.variables.resolution import resolve
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable

_MIRRORED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}


def check_condition(
    condition: Expression, names: NameTable, findings: Findings, *, is_inch: bool
) -> None:
    """Report each comparison of a condition with a constant that decides it."""
    for comparison in comparisons_in(condition):
        check_bounds(comparison, names, findings, is_inch=is_inch)


def check_bounds(
    comparison: Binary,
    names: NameTable,
    findings: Findings,
    *,
    is_inch: bool,
    in_cycle: bool = False,
) -> None:
    """Report a comparison decided by the type of its variable or the travel range of an axis.

    ``in_cycle``: types of live variables only, since frozen values have separate findings.
    """
    left, right, operator = comparison.left, comparison.right, comparison.operator
    if constant(left) is not None:
        left, right, operator = right, left, _MIRRORED.get(operator, operator)
    value = constant(right)
    if not isinstance(left, Variable) or value is None:
        return
    if isinstance(right, Number) and (is_live(left, names) or not in_cycle):
        _check_type(comparison, left, operator, value, names, findings)
    check_comparison(comparison, left, operator, value, names, findings, is_inch=is_inch)


def _check_type(
    comparison: Binary,
    variable: Variable,
    operator: str,
    value: float,
    names: NameTable,
    findings: Findings,
) -> None:
    """Report a whole number that a value of the type never, or always, compares true with."""
    location = resolve(variable, names)
    if not isinstance(location, Location):
        return
    scalar = SCALARS[location.type]
    if not scalar.is_integer:
        return
    truth = always(operator, value, scalar.low, scalar.high)
    if truth is None:
        return
    findings.report(
        COMPARISON_OUTSIDE_TYPE_RANGE,
        comparison.span,
        name=location.name,
        type=location.type,
        result=ALWAYS_TRUE if truth else NEVER_TRUE,
        low=int(scalar.low),
        high=int(scalar.high),
    )

# SPDX-License-Identifier: MIT
"""Variables that a realtime cycle reads and writes.

In: nodes of a cycle's body. Out: operands that decide a value, comparisons and their constant
results, targets of assignments.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite

from nctakt.base.diagnostics import number_text
from nctakt.nc.meaning.cost import is_live
from nctakt.nc.tree import (
    Assignment,
    Binary,
    Call,
    Constant,
    Expression,
    If,
    Number,
    Parameter,
    Statement,
    Unary,
    Variable,
)
from nctakt.nc.vocabulary.variables.resolution import indices_of, name_of
from nctakt.nc.vocabulary.variables.variable_table import NameTable

COMPARISONS = ("==", "!=", "<", "<=", ">", ">=")


def integer_value(expression: Expression | None) -> int | None:
    """Return a constant as a whole number; ``None`` for anything else."""
    if not isinstance(expression, Number) or not isfinite(expression.value):
        return None
    return int(expression.value)


def element_name(variable: Variable) -> str:
    """Return the variable with its constant indices; computed ones are ``[]``."""
    parts = []
    for part in variable.parts:
        indices = (
            f"[{number_text(index.value)}]" if isinstance(index, Number) else "[]"
            for index in part.indices
        )
        parts.append(part.name + "".join(indices))
    return name_of(variable.family, ".".join(parts))


def operand_key(target: Variable | Parameter) -> str:
    """Return a key for a variable or parameter; it contains ``[]`` if an index is computed."""
    if isinstance(target, Variable):
        return element_name(target)
    number = integer_value(target.index)
    return "P[]" if number is None else f"P[{number}]"


def targets(statements: Sequence[Statement]) -> Iterator[Variable | Parameter]:
    """Yield the targets of all assignments in these statements and inside them."""
    for statement in statements:
        if isinstance(statement, Assignment):
            yield statement.target
        elif isinstance(statement, If):
            yield from targets(statement.body)
            for branch in statement.elseifs:
                yield from targets(branch.body)
            yield from targets(statement.else_body or ())


def operands_of(expression: Expression, names: NameTable) -> Iterator[Expression]:
    """Yield the operands that decide the value: all but constants, with indices of live
    variables.
    """
    match expression:
        case Number() | Constant():
            return
        case Unary():
            yield from operands_of(expression.operand, names)
        case Binary():
            yield from operands_of(expression.left, names)
            yield from operands_of(expression.right, names)
        case Call():
            for argument in expression.arguments:
                yield from operands_of(argument, names)
        case Variable() if is_live(expression, names):
            for index in indices_of(expression):
                yield from operands_of(index, names)
            yield expression
        case _:
            yield expression


def comparisons_in(expression: Expression) -> Iterator[Binary]:
    match expression:
        case Unary():
            yield from comparisons_in(expression.operand)
        case Binary():
            if expression.operator in COMPARISONS:
                yield expression
            yield from comparisons_in(expression.left)
            yield from comparisons_in(expression.right)
        case Call():
            for argument in expression.arguments:
                yield from comparisons_in(argument)


def always(operator: str, value: float, low: float, high: float) -> bool | None:
    """Return whether all or none of the whole numbers from ``low`` to ``high`` compare true;
    ``None`` if some do.
    """
    if operator in ("==", "!="):
        possible = low <= value <= high and value == int(value)
        return None if possible else operator == "!="
    fulfilled = {
        "<": (low < value, high < value),
        "<=": (low <= value, high <= value),
        ">": (low > value, high > value),
        ">=": (low >= value, high >= value),
    }[operator]
    return fulfilled[0] if fulfilled[0] == fulfilled[1] else None


def is_override(variable: Variable) -> bool:
    names = [part.name for part in variable.parts]
    return variable.family in ("RTG", "RTA") and names[:3] == ["OVERRIDE", "VEL", "CYCLE"]


def is_position(expression: Expression, *kinds: str) -> bool:
    return (
        isinstance(expression, Variable)
        and expression.family == "RTA"
        and len(expression.parts) == 3
        and expression.parts[1].name in kinds
    )

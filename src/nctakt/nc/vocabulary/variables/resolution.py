# SPDX-License-Identifier: MIT
"""Variables of the tree -> their entries in the table of names.

Checker and decoder call ``NameTable.resolve`` through this module only.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest

from nctakt.nc.tree import (
    PARAMETER_ARRAYS,
    ArrayLiteral,
    Binary,
    Call,
    Expression,
    Number,
    Parameter,
    Part,
    StringLiteral,
    Unary,
    Variable,
)
from nctakt.nc.vocabulary.operators import FUNCTIONS
from nctakt.nc.vocabulary.variables.variable_table import Aggregate, Location, NameTable, NotFound


def resolve(variable: Variable, names: NameTable) -> Location | NotFound:
    """Return the location of a variable, or why there is none; index values do not matter."""
    parts = [(part.name, len(part.indices)) for part in variable.parts]
    return names.resolve(variable.family, parts)


def resolve_aggregate(variable: Variable, names: NameTable) -> Aggregate | NotFound:
    """Return the structure or whole array that a variable names, or why there is none."""
    parts = [(part.name, len(part.indices)) for part in variable.parts]
    return names.resolve_aggregate(variable.family, parts)


#: Families of variables that programs create themselves.
PROGRAM_FAMILIES = ("P", "S", "L", "CYC")


def name_of(family: str, path: str) -> str:
    """Return the name of a variable of a family as programs write it: ``V.P.A``, ``P10``."""
    return f"P{path}" if family == PARAMETER_ARRAYS else f"V.{family}.{path}"


def as_array(expression: Expression) -> Expression:
    """Return the array that ``P10`` without an index may name; any other expression unchanged."""
    match expression:
        case Parameter(index=Number(value=number), call=False):
            part = Part(expression.span, f"{number:g}", ())
            return Variable(expression.span, PARAMETER_ARRAYS, (part,), False)
    return expression


def is_program_variable(expression: Expression) -> bool:
    """Return whether the program itself creates the variable, so that its type is known only at
    run time.
    """
    return isinstance(expression, Variable) and (
        expression.family in PROGRAM_FAMILIES or expression.family == PARAMETER_ARRAYS
    )


def bare_name(variable: Variable) -> str:
    """Return the name of a program variable without family and indices."""
    return ".".join(part.name for part in variable.parts)


def may_be_text(expression: Expression) -> bool:
    """Return whether only the run shows if the value is a text or a number."""
    match expression:
        case Parameter():
            return expression.call
        case Binary(operator="+"):
            return may_be_text(expression.left) and may_be_text(expression.right)
    return is_program_variable(expression)


def is_text(expression: Expression, names: NameTable) -> bool:
    """Return whether the value of an expression is a text, or was meant as one."""
    match expression:
        case StringLiteral():
            return True
        case Call():
            function = FUNCTIONS.get(expression.function)
            return function is not None and function.is_text
        case Variable():
            location = resolve(expression, names)
            return isinstance(location, Location) and not location.is_numeric
        case Binary(operator="+"):
            return is_text(expression.left, names) or is_text(expression.right, names)
    return False


def indices_of(variable: Variable) -> list[Expression]:
    """Return all indices of a variable in the order of ``Location.dimensions``."""
    return [index for part in variable.parts for index in part.indices]


def path_text(variable: Variable) -> str:
    """Return the variable as messages show it, without index values: ``V.E.LIST[].MEMBER``."""
    parts = [part.name + "[]" * len(part.indices) for part in variable.parts]
    return name_of(variable.family, ".".join(parts)) if parts else f"V.{variable.family}"


def variables_in(expression: Expression) -> Iterator[Variable]:
    """Yield all variables in an expression; those in an index precede the indexed variable."""
    match expression:
        case Variable():
            for index in indices_of(expression):
                yield from variables_in(index)
            yield expression
        case Parameter():
            yield from variables_in(expression.index)
        case Unary():
            yield from variables_in(expression.operand)
        case Binary():
            yield from variables_in(expression.left)
            yield from variables_in(expression.right)
        case Call():
            yield from _variables_in_call(expression)
        case ArrayLiteral():
            for item in expression.items:
                yield from variables_in(item)


def _variables_in_call(call: Call) -> Iterator[Variable]:
    """Yield the variables that a function reads, without the one that it takes by name."""
    function = FUNCTIONS.get(call.function)
    kinds = "" if function is None else function.arguments
    for kind, argument in zip_longest(kinds[: len(call.arguments)], call.arguments):
        if kind == "A" and isinstance(argument, Variable):
            for index in indices_of(argument):
                yield from variables_in(index)
        else:
            yield from variables_in(argument)

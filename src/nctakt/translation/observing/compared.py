# SPDX-License-Identifier: MIT
"""Comparisons of which a run can say how near they came to being true, or false.

In: an expression of the tree. Out: whether its two sides are numbers, and nothing that they call
can evaluate the same comparison in between.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from nctakt.st.tree import AssignmentExpression, Binary, Call, Member, Name, Operator
from nctakt.st.types import Elementary, EnumType, Expression, Family, Node, Property, ReferenceType
from nctakt.translation.body import is_standard

_RELATIONS = (
    Operator.EQUAL,
    Operator.UNEQUAL,
    Operator.LESS,
    Operator.LESS_EQUAL,
    Operator.GREATER,
    Operator.GREATER_EQUAL,
)


def is_compared(expression: Expression) -> bool:
    """Return whether the sides of a comparison are noted."""
    if not isinstance(expression, Binary) or expression.operator not in _RELATIONS:
        return False
    sides = (expression.left, expression.right)
    return all(map(_is_number, sides)) and not any(map(_calls, sides))


def _is_number(expression: Expression) -> bool:
    """Return whether an expression is a number, a duration, a date or an item."""
    found = expression.type
    found = found.target if isinstance(found, ReferenceType) else found
    if isinstance(found, EnumType):
        return True
    return isinstance(found, Elementary) and found.family is not Family.BOOL


def _calls(expression: Expression) -> bool:
    """Return whether an expression calls code of the project, or assigns."""
    return any(
        isinstance(node, AssignmentExpression)
        or (isinstance(node, Call) and not is_standard(node))
        or (isinstance(node, Name | Member) and isinstance(node.target, Property))
        for node in _nodes(expression)
    )


def _nodes(item: object) -> Iterator[Node]:
    """Yield an expression and all in it."""
    if isinstance(item, list | tuple):
        for one in item:
            yield from _nodes(one)
    elif isinstance(item, Expression):
        yield item
        for one in fields(item):
            if one.name not in ("type", "operand_type", "target"):
                yield from _nodes(getattr(item, one.name))

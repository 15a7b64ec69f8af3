# SPDX-License-Identifier: MIT
"""Fuses nodes with simple operands into one node (``kernel/cycles/fused.py``).

In: operator and operands. Out: the fused node, or ``None``. Fusing changes neither results, to the
last bit, nor instruction counts, which depend on the tree (``nc/meaning/cost.py``).
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.kernel.cycles import expressions, fused
from nctakt.kernel.cycles.expressions import Expression, Load

#: Variables with their factors, added up from left to right.
Terms = tuple[tuple[Load, float], ...]


@dataclass(frozen=True, slots=True)
class Operand:
    """A built node.

    ``constant``: its value if known; ``load``: the variable that it only loads; ``terms``: its
    terms if it is a sum of multiples of variables.
    """

    node: Expression
    constant: float | None = None
    load: Load | None = None
    terms: Terms = ()


def constant(value: float) -> Operand:
    """Return the operand of a known number."""
    return Operand(expressions.Constant(value), value)


def load(cell: int, count: int) -> Operand:
    """Return the operand of a variable in a memory of ``count`` cells."""
    node = Load(cell, count)
    return Operand(node, load=node, terms=((node, 1.0),))


@dataclass(frozen=True, slots=True)
class _Operation:
    """The fused nodes of an operator, by its operands."""

    cell_constant: type[fused.CellConstant]
    cell_cell: type[fused.CellCell]
    expression_constant: type[fused.ExpressionConstant]
    expression_cell: type[fused.ExpressionCell]


_OPERATIONS = {
    "+": _Operation(
        fused.AddCellConstant,
        fused.AddCellCell,
        fused.AddExpressionConstant,
        fused.AddExpressionCell,
    ),
    "-": _Operation(
        fused.SubtractCellConstant,
        fused.SubtractCellCell,
        fused.SubtractExpressionConstant,
        fused.SubtractExpressionCell,
    ),
    "*": _Operation(
        fused.MultiplyCellConstant,
        fused.MultiplyCellCell,
        fused.MultiplyExpressionConstant,
        fused.MultiplyExpressionCell,
    ),
}

_SUMS = {2: fused.SumOfTwo, 3: fused.SumOfThree, 4: fused.SumOfFour}


def fuse(operator: str, left: Operand, right: Operand) -> Operand | None:
    """Return ``left operator right``, not both constant, as one node; ``None`` if none fits."""
    if operator == "/" and right.constant:
        return Operand(fused.DivideExpressionConstant(left.node, right.constant))
    if operator not in _OPERATIONS:
        return None
    if operator == "*":
        return _multiple(left, right) or _pair(operator, left, right)
    terms = _sum(operator, left, right)
    if len(terms) < 2 or (left.load is not None and right.load is not None):
        return _pair(operator, left, right, terms)
    return Operand(_SUMS[len(terms)](1.0, terms), terms=terms)


def _sum(operator: str, left: Operand, right: Operand) -> Terms:
    """Return the terms of a sum or difference, at most four; empty if it is not one.

    Only the last term may be negated: ``a - [b + c]`` is not a sum of terms to the last bit.
    """
    if operator == "+" and len(left.terms) == 1:
        left, right = right, left
    if not 1 <= len(left.terms) <= 3 or len(right.terms) != 1:
        return ()
    ((variable, factor),) = right.terms
    return (*left.terms, (variable, factor if operator == "+" else -factor))


def _multiple(left: Operand, right: Operand) -> Operand | None:
    """Return a number times a variable or times a sum."""
    if left.constant is not None:
        left, right = right, left
    if right.constant is None or not left.terms:
        return None
    if left.load is not None:
        node = fused.MultiplyCellConstant(left.load, right.constant)
        return Operand(node, terms=((left.load, right.constant),))
    if len(left.terms) == 1:
        return None
    return Operand(_SUMS[len(left.terms)](right.constant, left.terms))


def _pair(operator: str, left: Operand, right: Operand, terms: Terms = ()) -> Operand | None:
    """Return the node of two operands of which at least one is a variable or a number."""
    operation = _OPERATIONS[operator]
    if operator != "-" and right.load is None and right.constant is None:
        left, right = right, left
    if operator != "-" and left.constant is not None and right.load is not None:
        left, right = right, left
    if left.load is not None and right.constant is not None:
        return Operand(operation.cell_constant(left.load, right.constant))
    if left.load is not None and right.load is not None:
        return Operand(operation.cell_cell(left.load, right.load), terms=terms)
    if right.constant is not None:
        return Operand(operation.expression_constant(left.node, right.constant))
    if right.load is not None and left.constant is None:
        return Operand(operation.expression_cell(left.node, right.load))
    return None

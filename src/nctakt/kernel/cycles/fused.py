# SPDX-License-Identifier: MIT
"""Fused nodes of expressions: each does the work of several in one call.

RC-501: they count as the nodes that they replace. Results are the same to the bit: the operations
are done in the order of the text, and the factors added to make shapes alike are exact, 1 or -1
(``a - b`` is ``1 * a + -1 * b``). Only variables and numbers are fused, so no fault can arise
within; results that are not finite are caught at the assignment (RC-207).
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Expression, Load


class CellConstant(Expression):
    """Base: a variable and a number."""

    def __init__(self, load: Load, number: float) -> None:
        self.cell = load.cell
        self.number = number


class CellCell(Expression):
    """Base: two variables."""

    def __init__(self, load: Load, other: Load) -> None:
        self.cell = load.cell
        self.other = other.cell


class ExpressionConstant(Expression):
    """Base: an expression and a number."""

    def __init__(self, operand: Expression, number: float) -> None:
        self.operand = operand
        self.number = number


class ExpressionCell(Expression):
    """Base: an expression and a variable."""

    def __init__(self, operand: Expression, load: Load) -> None:
        self.operand = operand
        self.cell = load.cell


class AddCellConstant(CellConstant):
    """Variable ``+`` number."""

    def value(self, context: Context) -> float:
        return context.cells[self.cell] + self.number


class AddCellCell(CellCell):
    """Variable ``+`` variable."""

    def value(self, context: Context) -> float:
        return context.cells[self.cell] + context.cells[self.other]


class AddExpressionConstant(ExpressionConstant):
    """Expression ``+`` number."""

    def value(self, context: Context) -> float:
        return self.operand.value(context) + self.number


class AddExpressionCell(ExpressionCell):
    """Expression ``+`` variable."""

    def value(self, context: Context) -> float:
        return self.operand.value(context) + context.cells[self.cell]


class SubtractCellConstant(CellConstant):
    """Variable ``-`` number."""

    def value(self, context: Context) -> float:
        return context.cells[self.cell] - self.number


class SubtractCellCell(CellCell):
    """Variable ``-`` variable."""

    def value(self, context: Context) -> float:
        return context.cells[self.cell] - context.cells[self.other]


class SubtractExpressionConstant(ExpressionConstant):
    """Expression ``-`` number."""

    def value(self, context: Context) -> float:
        return self.operand.value(context) - self.number


class SubtractExpressionCell(ExpressionCell):
    """Expression ``-`` variable."""

    def value(self, context: Context) -> float:
        return self.operand.value(context) - context.cells[self.cell]


class MultiplyCellConstant(CellConstant):
    """Variable ``*`` number."""

    def value(self, context: Context) -> float:
        return context.cells[self.cell] * self.number


class MultiplyCellCell(CellCell):
    """Variable ``*`` variable."""

    def value(self, context: Context) -> float:
        return context.cells[self.cell] * context.cells[self.other]


class MultiplyExpressionConstant(ExpressionConstant):
    """Expression ``*`` number."""

    def value(self, context: Context) -> float:
        return self.operand.value(context) * self.number


class MultiplyExpressionCell(ExpressionCell):
    """Expression ``*`` variable."""

    def value(self, context: Context) -> float:
        return self.operand.value(context) * context.cells[self.cell]


class DivideExpressionConstant(ExpressionConstant):
    """Expression ``/`` number that is not zero."""

    def value(self, context: Context) -> float:
        return self.operand.value(context) / self.number


class SumOfTwo(Expression):
    """``scale * (factor_a * a + factor_b * b)`` of variables."""

    def __init__(self, scale: float, terms: Sequence[tuple[Load, float]]) -> None:
        self.scale = scale
        (first, self.factor_a), (second, self.factor_b) = terms
        self.a, self.b = first.cell, second.cell

    def value(self, context: Context) -> float:
        total = self.factor_a * context.cells[self.a] + self.factor_b * context.cells[self.b]
        return self.scale * total


class SumOfThree(Expression):
    """``scale * (factor_a * a + factor_b * b + factor_c * c)`` of variables."""

    def __init__(self, scale: float, terms: Sequence[tuple[Load, float]]) -> None:
        self.scale = scale
        (first, self.factor_a), (second, self.factor_b), (third, self.factor_c) = terms
        self.a, self.b, self.c = first.cell, second.cell, third.cell

    def value(self, context: Context) -> float:
        total = self.factor_a * context.cells[self.a] + self.factor_b * context.cells[self.b]
        return self.scale * (total + self.factor_c * context.cells[self.c])


class SumOfFour(Expression):
    """``scale * (factor_a * a + factor_b * b + factor_c * c + factor_d * d)`` of variables."""

    def __init__(self, scale: float, terms: Sequence[tuple[Load, float]]) -> None:
        self.scale = scale
        (first, self.factor_a), (second, self.factor_b), *others = terms
        (third, self.factor_c), (fourth, self.factor_d) = others
        self.a, self.b, self.c, self.d = first.cell, second.cell, third.cell, fourth.cell

    def value(self, context: Context) -> float:
        total = self.factor_a * context.cells[self.a] + self.factor_b * context.cells[self.b]
        total += self.factor_c * context.cells[self.c]
        return self.scale * (total + self.factor_d * context.cells[self.d])

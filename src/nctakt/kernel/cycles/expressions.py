# SPDX-License-Identifier: MIT
"""Expressions of realtime cycles: trees of small objects, each of which computes its value.

RC-206, RC-207. ``value(context)`` returns a float64. An operation that is not defined for its
operands notes fault 50879 with its operation number in the context and returns 0; the statement
above sees the fault and stores nothing. Operators are here, functions in ``functions.py``;
``fused.py`` has nodes that combine several of these.
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.bounds import MAX_SIZE, check_index, check_range
from nctakt.kernel.cycles.context import Context


class Expression:
    """Base of an expression, and null object: zero."""

    def value(self, context: Context) -> float:
        """Evaluate the node."""
        return 0.0

    def measure(self, context: Context) -> float:
        """Evaluate the node for Python's side: tests, and listings of constants."""
        return self.value(context)


class Constant(Expression):
    """Number that was known when the cycle was decoded (RC-302)."""

    def __init__(self, number: float) -> None:
        self.number = number

    def value(self, context: Context) -> float:
        return self.number


class Load(Expression):
    """A variable: one cell of a memory of ``count`` cells.

    The number of a cell enters a tree only here: fused nodes and assignments take a ``Load``.
    ``room``: the number of cells from this one on.
    """

    def __init__(self, cell: int, count: int) -> None:
        check_index(cell, count, "cell")
        self.cell = cell
        self.room = count - cell

    def value(self, context: Context) -> float:
        return context.cells[self.cell]


class Index(Expression):
    """The part of an array access that is not fixed: ``next + stride * index`` (RC-307).

    An index outside 0 … count-1 notes ``message``, NaN notes 50879; ``further`` is the next
    dimension's part, ``None`` after the last one. ``span``: the highest value.
    """

    def __init__(
        self,
        index: Expression,
        stride: int,
        count: int,
        further: Index | None,
        source: int,
        message: int,
    ) -> None:
        check_range(stride, 1, MAX_SIZE, "stride")
        check_range(count, 1, MAX_SIZE, "count")
        self.span = (count - 1) * stride + highest_of(further)
        self.index = index
        self.stride = stride
        self.count = count
        self.further = further or Expression()
        self.source = source
        self.message = message

    def value(self, context: Context) -> float:
        number = arithmetic.round_half_even(self.index.value(context))
        if number - number != 0.0:
            context.fail(50879, self.source, 0.0, number)
            return 0.0
        if not 0.0 <= number < self.count:
            context.fail(self.message, self.source, number, self.count)
            return 0.0
        return self.stride * number + self.further.value(context)


def highest_of(index: Index | None) -> int:
    """Return the highest value of an index, 0 for none."""
    return 0 if index is None else index.span


class LoadElement(Expression):
    """An array element whose index is computed in the tick."""

    def __init__(self, first: Load, index: Index) -> None:
        check_index(index.span, first.room, "index")
        self.first_cell = first.cell
        self.index = index

    def value(self, context: Context) -> float:
        index = int(self.index.value(context))
        if context.fault:
            return 0.0
        return context.cells[self.first_cell + index]


class Binary(Expression):
    """Base of all nodes with two operands; the left one is computed first, as its fault counts."""

    def __init__(self, left: Expression, right: Expression) -> None:
        self.left = left
        self.right = right


class Unary(Expression):
    """Base of all nodes with one operand."""

    def __init__(self, operand: Expression) -> None:
        self.operand = operand


class Add(Binary):
    """``+``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return left + self.right.value(context)


class Subtract(Binary):
    """``-``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return left - self.right.value(context)


class Multiply(Binary):
    """``*``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return left * self.right.value(context)


class Divide(Binary):
    """``/``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        result = arithmetic.divide(left, self.right.value(context))
        if result != result:
            context.fail(50879, 0, 1.0, 0.0)
            return 0.0
        return result


class Modulo(Binary):
    """``MOD``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        result = arithmetic.modulo(left, self.right.value(context))
        if result != result:
            context.fail(50879, 0, 2.0, 0.0)
            return 0.0
        return result


class Power(Binary):
    """``**``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        result = arithmetic.power(left, self.right.value(context))
        if result != result:
            context.fail(50879, 0, 3.0, 0.0)
            return 0.0
        return result


class BitAnd(Binary):
    """``&``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        result = arithmetic.bit_and(left, self.right.value(context))
        if result != result:
            context.fail(50879, 0, 4.0, 0.0)
            return 0.0
        return result


class BitOr(Binary):
    """``|``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        result = arithmetic.bit_or(left, self.right.value(context))
        if result != result:
            context.fail(50879, 0, 5.0, 0.0)
            return 0.0
        return result


class BitXor(Binary):
    """``^``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        result = arithmetic.bit_xor(left, self.right.value(context))
        if result != result:
            context.fail(50879, 0, 6.0, 0.0)
            return 0.0
        return result


class Less(Binary):
    """``<``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return 1.0 if left < self.right.value(context) else 0.0


class LessEqual(Binary):
    """``<=``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return 1.0 if left <= self.right.value(context) else 0.0


class Greater(Binary):
    """``>``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return 1.0 if left > self.right.value(context) else 0.0


class GreaterEqual(Binary):
    """``>=``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return 1.0 if left >= self.right.value(context) else 0.0


class Equal(Binary):
    """``==``, exact (RC-304)."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return 1.0 if left == self.right.value(context) else 0.0


class NotEqual(Binary):
    """``!=``, exact (RC-304)."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        return 1.0 if left != self.right.value(context) else 0.0


class And(Binary):
    """``&&``; both sides are evaluated (RC-501)."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        right = self.right.value(context)
        return 1.0 if arithmetic.is_true(left) and arithmetic.is_true(right) else 0.0


class Or(Binary):
    """``||``; both sides are evaluated (RC-501)."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        right = self.right.value(context)
        return 1.0 if arithmetic.is_true(left) or arithmetic.is_true(right) else 0.0


class ExclusiveOr(Binary):
    """``XOR``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        right = self.right.value(context)
        return 1.0 if arithmetic.is_true(left) != arithmetic.is_true(right) else 0.0


class Negate(Unary):
    """Unary ``-``."""

    def value(self, context: Context) -> float:
        return 0.0 - self.operand.value(context)


class Not(Unary):
    """``NOT``."""

    def value(self, context: Context) -> float:
        return 0.0 if arithmetic.is_true(self.operand.value(context)) else 1.0


#: Names of the operations that can fail, by the number in detail ``a`` of fault 50879.
OPERATIONS = {
    1: "/",
    2: "MOD",
    3: "**",
    4: "&",
    5: "|",
    6: "^",
    7: "SQRT",
    8: "EXP",
    9: "DEXP",
    10: "LN",
    11: "LOG",
    12: "SIN",
    13: "COS",
    14: "TAN",
    15: "COT",
    16: "ASIN",
    17: "ACOS",
    18: "INV",
    19: "ATAN2",
}

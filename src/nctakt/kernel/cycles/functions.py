# SPDX-License-Identifier: MIT
"""Functions in expressions of realtime cycles: ``SQRT``, ``SIN``, ``INT`` and the others (RC-206).

One node for each function, evaluated like those of ``expressions.py``. Angles are in degrees. An
argument for which the function is not defined notes fault 50879 with the number of the function
(``expressions.OPERATIONS``) in the context and returns 0 (RC-207).
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Binary, Unary


class Truncate(Unary):
    """``INT``."""

    def value(self, context: Context) -> float:
        return arithmetic.truncate(self.operand.value(context))


class Fraction(Unary):
    """``FRACT``."""

    def value(self, context: Context) -> float:
        return arithmetic.fraction(self.operand.value(context))


class Round(Unary):
    """``ROUND``."""

    def value(self, context: Context) -> float:
        return arithmetic.round_half_even(self.operand.value(context))


class Floor(Unary):
    """``FLOOR``."""

    def value(self, context: Context) -> float:
        return arithmetic.floor(self.operand.value(context))


class Ceiling(Unary):
    """``CEIL``."""

    def value(self, context: Context) -> float:
        return arithmetic.ceiling(self.operand.value(context))


class ArcTangent(Unary):
    """``ATAN``."""

    def value(self, context: Context) -> float:
        return arithmetic.arc_tangent(self.operand.value(context))


class ArcCotangent(Unary):
    """``ACOT``."""

    def value(self, context: Context) -> float:
        return arithmetic.arc_cotangent(self.operand.value(context))


class Absolute(Unary):
    """``ABS``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        return operand if operand >= 0.0 else 0.0 - operand


class Square(Unary):
    """``SQR``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        return operand * operand


class SquareRoot(Unary):
    """``SQRT``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.square_root(operand)
        if result != result:
            context.fail(50879, 0, 7.0, operand)
            return 0.0
        return result


class Exponential(Unary):
    """``EXP``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.exponential(operand)
        if result != result:
            context.fail(50879, 0, 8.0, operand)
            return 0.0
        return result


class DecimalExponential(Unary):
    """``DEXP``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.decimal_exponential(operand)
        if result != result:
            context.fail(50879, 0, 9.0, operand)
            return 0.0
        return result


class NaturalLogarithm(Unary):
    """``LN``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.natural_logarithm(operand)
        if result != result:
            context.fail(50879, 0, 10.0, operand)
            return 0.0
        return result


class DecimalLogarithm(Unary):
    """``LOG``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.decimal_logarithm(operand)
        if result != result:
            context.fail(50879, 0, 11.0, operand)
            return 0.0
        return result


class Sine(Unary):
    """``SIN``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.sine(operand)
        if result != result:
            context.fail(50879, 0, 12.0, operand)
            return 0.0
        return result


class Cosine(Unary):
    """``COS``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.cosine(operand)
        if result != result:
            context.fail(50879, 0, 13.0, operand)
            return 0.0
        return result


class Tangent(Unary):
    """``TAN``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.tangent(operand)
        if result != result:
            context.fail(50879, 0, 14.0, operand)
            return 0.0
        return result


class Cotangent(Unary):
    """``COT``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.cotangent(operand)
        if result != result:
            context.fail(50879, 0, 15.0, operand)
            return 0.0
        return result


class ArcSine(Unary):
    """``ASIN``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.arc_sine(operand)
        if result != result:
            context.fail(50879, 0, 16.0, operand)
            return 0.0
        return result


class ArcCosine(Unary):
    """``ACOS``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.arc_cosine(operand)
        if result != result:
            context.fail(50879, 0, 17.0, operand)
            return 0.0
        return result


class Invert(Unary):
    """``INV``."""

    def value(self, context: Context) -> float:
        operand = self.operand.value(context)
        result = arithmetic.bit_invert(operand)
        if result != result:
            context.fail(50879, 0, 18.0, operand)
            return 0.0
        return result


class ArcTangent2(Binary):
    """``ATAN2[y, x]``."""

    def value(self, context: Context) -> float:
        left = self.left.value(context)
        result = arithmetic.arc_tangent_2(left, self.right.value(context))
        if result != result:
            context.fail(50879, 0, 19.0, 0.0)
            return 0.0
        return result

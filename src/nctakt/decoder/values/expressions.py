# SPDX-License-Identifier: MIT
"""Expressions of the tree -> expressions of the realtime part (RC-206).

Decoder and cycles share this meaning of operators and functions: in a cycle a variable becomes a
load; in the decoder it becomes its current value, and the result is evaluated at once. Nodes with
simple operands are fused (``fusing.py``).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import NoReturn

from nctakt.decoder.values.fusing import Operand, constant, fuse
from nctakt.kernel.cycles import conditions, expressions, functions
from nctakt.kernel.cycles.conditions import Condition
from nctakt.kernel.cycles.context import Context, empty_context
from nctakt.kernel.cycles.expressions import Expression
from nctakt.nc import tree

_BINARY: dict[str, type[expressions.Binary]] = {
    "+": expressions.Add,
    "-": expressions.Subtract,
    "*": expressions.Multiply,
    "/": expressions.Divide,
    "MOD": expressions.Modulo,
    "**": expressions.Power,
    "<": expressions.Less,
    "<=": expressions.LessEqual,
    ">": expressions.Greater,
    ">=": expressions.GreaterEqual,
    "==": expressions.Equal,
    "!=": expressions.NotEqual,
    "&": expressions.BitAnd,
    "|": expressions.BitOr,
    "^": expressions.BitXor,
    "&&": expressions.And,
    "||": expressions.Or,
    "XOR": expressions.ExclusiveOr,
}

_UNARY: dict[str, type[expressions.Unary]] = {
    "-": expressions.Negate,
    "NOT": expressions.Not,
    "INV": functions.Invert,
    "ABS": functions.Absolute,
    "SQR": functions.Square,
    "SQRT": functions.SquareRoot,
    "EXP": functions.Exponential,
    "DEXP": functions.DecimalExponential,
    "LN": functions.NaturalLogarithm,
    "LOG": functions.DecimalLogarithm,
    "SIN": functions.Sine,
    "COS": functions.Cosine,
    "TAN": functions.Tangent,
    "COT": functions.Cotangent,
    "ASIN": functions.ArcSine,
    "ACOS": functions.ArcCosine,
    "ATAN": functions.ArcTangent,
    "ACOT": functions.ArcCotangent,
    "INT": functions.Truncate,
    "FRACT": functions.Fraction,
    "ROUND": functions.Round,
    "CEIL": functions.Ceiling,
    "FLOOR": functions.Floor,
}

#: Comparisons of two expressions, and of a variable with a number.
_COMPARISONS: dict[
    str, tuple[type[conditions.Comparison], type[conditions.CellComparison], str]
] = {
    "<": (conditions.IsLess, conditions.IsLessCellConstant, ">"),
    "<=": (conditions.IsLessEqual, conditions.IsLessEqualCellConstant, ">="),
    ">": (conditions.IsGreater, conditions.IsGreaterCellConstant, "<"),
    ">=": (conditions.IsGreaterEqual, conditions.IsGreaterEqualCellConstant, "<="),
    "==": (conditions.IsEqual, conditions.IsEqualCellConstant, "=="),
    "!=": (conditions.IsNotEqual, conditions.IsNotEqualCellConstant, "!="),
}

#: Combinations of conditions.
COMBINATIONS: dict[str, type[conditions.Combination]] = {
    "&&": conditions.Both,
    "||": conditions.Either,
}

_CONSTANTS = {"TRUE": 1.0, "FALSE": 0.0, "PI": 3.141592653589793}


def _unexpected(text: tree.StringLiteral) -> NoReturn:
    raise AssertionError(text)


class ExpressionBuilder:
    """Builds expressions; ``leaf`` converts variables and parameters, ``number`` numbers.

    ``compare_texts`` returns the result of ``==`` and ``!=`` between texts, ``None`` for numbers;
    ``query`` that of a function of names or texts, ``None`` for other functions. ``macro`` reports
    an undefined macro.
    """

    def __init__(
        self,
        leaf: Callable[[tree.Variable | tree.Parameter], Operand],
        compare_texts: Callable[[tree.Binary], Operand | None] = lambda _: None,
        query: Callable[[tree.Call], Operand | None] = lambda _: None,
        number: Callable[[tree.Number], Operand] = lambda node: constant(node.value),
        macro: Callable[[tree.StringLiteral], NoReturn] = _unexpected,
    ) -> None:
        self._leaf = leaf
        self._compare_texts = compare_texts
        self._query = query
        self._number = number
        self._macro = macro

    @cached_property
    def _context(self) -> Context:
        """The context of folded constants, created on first use."""
        return empty_context()

    def build(self, expression: tree.Expression) -> Operand:
        """Return the operand of a checked expression."""
        match expression:
            case tree.Number():
                return self._number(expression)
            case tree.Constant():
                return constant(_CONSTANTS[expression.name])
            case tree.Variable() | tree.Parameter():
                return self._leaf(expression)
            case tree.StringLiteral():
                return self._macro(expression)
            case tree.Unary():
                return self._unary(expression.operator, expression.operand)
            case tree.Binary():
                if expression.operator in ("==", "!="):
                    compared = self._compare_texts(expression)
                    if compared is not None:
                        return compared
                left = self.build(expression.left)
                return self.combine(expression.operator, left, self.build(expression.right))
            case tree.Call():
                return self._call(expression)
        raise AssertionError(expression)

    def condition(self, expression: tree.Expression) -> Condition:
        """Return the condition of an ``$IF``; ``&&`` and ``||`` combine conditions."""
        if isinstance(expression, tree.Binary) and expression.operator in COMBINATIONS:
            left, right = self._part(expression.left), self._part(expression.right)
            return COMBINATIONS[expression.operator](left, right)
        if not isinstance(expression, tree.Binary) or expression.operator not in _COMPARISONS:
            built = self.build(expression)
            return conditions.IsTrue(built.node)
        operator = expression.operator
        if operator in ("==", "!="):
            compared = self._compare_texts(expression)
            if compared is not None:
                return conditions.IsTextTrue(compared.node)
        left_operand, right_operand = self.build(expression.left), self.build(expression.right)
        general, fused, mirrored = _COMPARISONS[operator]
        if left_operand.load is not None and right_operand.constant is not None:
            return fused(left_operand.load, right_operand.constant)
        if left_operand.constant is not None and right_operand.load is not None:
            return _COMPARISONS[mirrored][1](right_operand.load, left_operand.constant)
        return general(left_operand.node, right_operand.node)

    def _part(self, expression: tree.Expression) -> Condition:
        """Return the condition of an operand of ``&&`` or ``||``."""
        if isinstance(expression, tree.Binary) and (
            expression.operator in COMBINATIONS or expression.operator in _COMPARISONS
        ):
            return self.condition(expression)
        return conditions.IsTruePart(self.build(expression).node)

    def combine(self, operator: str, left: Operand, right: Operand) -> Operand:
        """Return ``left operator right``."""
        if left.constant is not None and right.constant is not None:
            return self._folded(_BINARY[operator](left.node, right.node))
        return fuse(operator, left, right) or Operand(_BINARY[operator](left.node, right.node))

    def _unary(self, operator: str, operand: tree.Expression) -> Operand:
        built = self.build(operand)
        node = _UNARY[operator](built.node)
        if built.constant is not None:
            return self._folded(node)
        return Operand(node)

    def _call(self, call: tree.Call) -> Operand:
        asked = self._query(call)
        if asked is not None:
            return asked
        if call.function == "ATAN2":
            left, right = (self.build(argument) for argument in call.arguments)
            node = functions.ArcTangent2(left.node, right.node)
            if left.constant is not None and right.constant is not None:
                return self._folded(node)
            return Operand(node)
        return self._unary(call.function, call.arguments[0])

    def _folded(self, node: Expression) -> Operand:
        """Return the value of a node with constant operands; the node itself for a fault at run
        time.
        """
        self._context.fault = 0
        value = node.measure(self._context)
        if self._context.fault or value - value != 0.0:
            return Operand(node)
        return constant(value)

# SPDX-License-Identifier: MIT
"""Fused nodes give the bits of the operations that they represent (RC-206, RC-501)."""

from __future__ import annotations

import itertools
import math
import struct
from collections.abc import Callable
from typing import Any

import pytest

from nctakt.decoder.values.expressions import ExpressionBuilder
from nctakt.decoder.values.fusing import Operand, constant, load
from nctakt.kernel.cycles.context import context_of

#: Values whose sums round, cancel, overflow, or are zeros of either sign.
NUMBERS = (0.0, -0.0, 0.1, -0.1, 3e-324, 1e308, -7.25, 1 / 3)

SHAPES: dict[str, tuple[Callable[..., Any], str]] = {
    "a - b": (lambda a, b, c, d: a - b, "SubtractCellCell"),
    "a + b": (lambda a, b, c, d: a + b, "AddCellCell"),
    "a - b - c": (lambda a, b, c, d: a - b - c, "SumOfThree"),
    "a + [b - c]": (lambda a, b, c, d: a + (b - c), "SumOfThree"),
    "a - [b + c]": (lambda a, b, c, d: a - (b + c), "Subtract"),
    "a - b + c - d": (lambda a, b, c, d: a - b + c - d, "SumOfFour"),
    "a + b + c + d + a": (lambda a, b, c, d: a + b + c + d + a, "AddExpressionCell"),
    "0.25 * a - b": (lambda a, b, c, d: 0.25 * a - b, "SumOfTwo"),
    "a - b * 0.1": (lambda a, b, c, d: a - b * 0.1, "SumOfTwo"),
    "0.1 * [a - b]": (lambda a, b, c, d: 0.1 * (a - b), "SumOfTwo"),
    "[a - b - c] * 3": (lambda a, b, c, d: (a - b - c) * 3.0, "SumOfThree"),
    "3 * [0.1 * [a - b]]": (lambda a, b, c, d: 3.0 * (0.1 * (a - b)), "MultiplyExpressionConstant"),
    "0.1 * [3 * a]": (lambda a, b, c, d: 0.1 * (3.0 * a), "MultiplyExpressionConstant"),
    "c + 0.1 * [a - b]": (lambda a, b, c, d: c + 0.1 * (a - b), "AddExpressionCell"),
    "2 * a + 3 * b - 4 * c": (lambda a, b, c, d: 2.0 * a + 3.0 * b - 4.0 * c, "SumOfThree"),
    "a - 2 - b": (lambda a, b, c, d: a - 2.0 - b, "SubtractExpressionCell"),
    "5 - a": (lambda a, b, c, d: 5.0 - a, "Subtract"),
    "a * b * c": (lambda a, b, c, d: a * b * c, "MultiplyExpressionCell"),
}


class Side:
    """An operand that is built instead of computed."""

    builder = ExpressionBuilder(lambda _: constant(0.0))

    def __init__(self, built: Operand) -> None:
        self.built = built

    def combined(self, operator: str, other: Side | float, turned: bool) -> Side:
        """The node of both operands."""
        right = other.built if isinstance(other, Side) else constant(other)
        left, right = (right, self.built) if turned else (self.built, right)
        return Side(self.builder.combine(operator, left, right))

    def __add__(self, other: Side | float) -> Side:
        return self.combined("+", other, False)

    def __sub__(self, other: Side | float) -> Side:
        return self.combined("-", other, False)

    def __rsub__(self, other: float) -> Side:
        return self.combined("-", other, True)

    def __mul__(self, other: Side | float) -> Side:
        return self.combined("*", other, False)

    def __rmul__(self, other: float) -> Side:
        return self.combined("*", other, True)


def bits(value: float) -> bytes:
    """A number, with the sign of a zero; all that are none are alike."""
    return b"no number" if math.isnan(value) else struct.pack("=d", value)


@pytest.mark.parametrize("text", SHAPES)
def test_a_fused_node_gives_the_same_bits(text: str) -> None:
    """Signs of zeros included, and infinite where the operations are."""
    shape, name = SHAPES[text]
    node = shape(*[Side(load(cell, 4)) for cell in range(4)]).built.node
    assert type(node).__name__ == name
    memory = bytearray(8 * 10)
    context = context_of(memory)
    for values in itertools.product(NUMBERS, repeat=4):
        struct.pack_into("=4d", memory, 0, *values)
        assert bits(node.measure(context)) == bits(shape(*values)), values

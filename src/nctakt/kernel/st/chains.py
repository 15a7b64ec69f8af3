# SPDX-License-Identifier: MIT
"""Chains of real numbers: sums and products of which one side is a constant or a variable.

``a + 0.25 * (u - c - a)`` begins with ``u``; its links subtract ``c``, subtract ``a``, multiply by
0.25 and add ``a``. A chain runs in a loop without a call, and looks for what is not a number once,
at its end, since no link makes a number of that again (ST-305).
"""

from __future__ import annotations

from nctakt.kernel.st import kinds, real_leaves, reals
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.reals import (
    AddReal,
    LoadRealFixed,
    LoadRealFrame,
    LoadRealInstance,
    MultiplyReal,
    Real,
    RealConstant,
    RoundToSingle,
    SubtractReal,
)

_Leaf = RealConstant | LoadRealFixed | LoadRealFrame | LoadRealInstance
_TREES = {
    kinds.LINK_ADD: AddReal,
    kinds.LINK_SUBTRACT: SubtractReal,
    kinds.LINK_MULTIPLY: MultiplyReal,
}


class RealChain(Real):
    """A number, and what is done with it: each part is an operation and its operand."""

    def __init__(self, start: Real, parts: tuple[tuple[int, _Leaf], ...]) -> None:
        self.start = start
        self.parts = parts
        words = bytearray(8 * kinds.LINK_WIDTH * len(parts))
        self.links = memoryview(words).cast("q")
        self.constants = memoryview(words).cast("d")
        for number, (operation, operand) in enumerate(parts):
            at = kinds.LINK_WIDTH * number
            self.links[at + kinds.LINK_SOURCE] = operand.leaf - kinds.CONSTANT
            self.links[at + kinds.LINK_OPERATION] = 2 * operation
            if isinstance(operand, RealConstant):
                constant_at = at + kinds.LINK_CONSTANT
                self.links[at + kinds.LINK_OFFSET] = 8 * constant_at
                self.constants[constant_at] = operand.constant
            else:
                self.links[at + kinds.LINK_OFFSET] = operand.offset
                self.links[at + kinds.LINK_OPERATION] += operand.kind == kinds.F32

    def number(self, context: PlcContext) -> float:
        number = real_leaves.number_of(self.start, context)
        number = real_leaves.followed(self.links, self.constants, number, context)
        return number if number == number else reals.valid(context, number)


def joined(operation: int, left: Real, right: Real) -> Real:
    """Return a sum, a difference or a product: as a chain where one side is a leaf.

    The side on the right is a chain's begin only if it calls nothing: the left one comes first.
    """
    if isinstance(right, _Leaf):
        return _linked(left, operation, right)
    if isinstance(left, _Leaf) and isinstance(right, RealChain):
        if isinstance(right.start, _Leaf):
            is_difference = operation == kinds.LINK_SUBTRACT
            return _linked(right, kinds.LINK_SUBTRACT_FROM if is_difference else operation, left)
    return _TREES[operation](left, right)


def rounded(node: Real) -> Real:
    """Return a result rounded to REAL (ST-304)."""
    if isinstance(node, RealChain):
        return _linked(node, kinds.LINK_ROUND, RealConstant(0.0))
    return RoundToSingle(node)


def _linked(node: Real, operation: int, operand: _Leaf) -> Real:
    if isinstance(node, RealChain):
        return RealChain(node.start, (*node.parts, (operation, operand)))
    return RealChain(node, ((operation, operand),))

# SPDX-License-Identifier: MIT
"""Chains of real numbers: sums and products of which one side is a constant or a variable.

``a + 0.25 * (u - c - a)`` begins with ``u``; its links subtract ``c``, subtract ``a``, multiply by
0.25 and add ``a``. A chain runs in a loop without a call, and checks for NaN once, at its end,
since no link turns NaN into a number again (ST-305). A single operation is a chain only where an
assignment follows its links itself; elsewhere its own node costs less.
"""

from __future__ import annotations

import struct

from nctakt.kernel.base.arrays import integers
from nctakt.kernel.st import kinds, real_leaves
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.reals import (
    AddReal,
    BinaryReal,
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
_Parts = tuple[tuple[int, _Leaf], ...]
_TREES = {
    kinds.LINK_ADD: AddReal,
    kinds.LINK_SUBTRACT: SubtractReal,
    kinds.LINK_MULTIPLY: MultiplyReal,
}
_OPERATIONS: dict[type[Real], int] = {node: operation for operation, node in _TREES.items()}


class RealChain(Real):
    """A number, and operations on it: each part is an operation and its operand."""

    def __init__(self, start: Real, parts: _Parts) -> None:
        self.start = start
        self.parts = parts
        self.links = links_of(parts)

    def number(self, context: PlcContext) -> float:
        number = real_leaves.number_of(self.start, context)
        return real_leaves.followed(self.links, number, context)


def links_of(parts: _Parts) -> memoryview:
    """Return the words of a chain's links."""
    links = integers(kinds.LINK_WIDTH * len(parts))
    for number, (operation, operand) in enumerate(parts):
        at = kinds.LINK_WIDTH * number
        links[at + kinds.LINK_SOURCE] = operand.leaf - kinds.CONSTANT
        links[at + kinds.LINK_OPERATION] = 2 * operation
        if isinstance(operand, RealConstant):
            constant_at = at + kinds.LINK_CONSTANT
            links[at + kinds.LINK_OFFSET] = 8 * constant_at
            (links[constant_at],) = struct.unpack("<q", struct.pack("<d", operand.constant))
        else:
            links[at + kinds.LINK_OFFSET] = operand.offset
            links[at + kinds.LINK_OPERATION] += operand.kind == kinds.F32
    return links


def opened(node: Real) -> tuple[Real, _Parts]:
    """Return the operand that a chain begins with and its links; no links without an operation."""
    if isinstance(node, RealChain):
        return node.start, node.parts
    if isinstance(node, RoundToSingle):
        start, parts = opened(node.operand)
        return start, (*parts, (kinds.LINK_ROUND, RealConstant(0.0)))
    operation = _OPERATIONS.get(type(node))
    if operation is None or not isinstance(node, BinaryReal) or not isinstance(node.right, _Leaf):
        return node, ()
    return node.left, ((operation, node.right),)


def joined(operation: int, left: Real, right: Real) -> Real:
    """Return a sum, a difference or a product: from the second operation on as a chain.

    The right side starts a chain only if it calls nothing: the left side is evaluated first.
    """
    if isinstance(right, _Leaf):
        start, parts = opened(left)
        if parts:
            return RealChain(start, (*parts, (operation, right)))
    elif isinstance(left, _Leaf):
        start, parts = opened(right)
        if parts and isinstance(start, _Leaf):
            is_difference = operation == kinds.LINK_SUBTRACT
            link = kinds.LINK_SUBTRACT_FROM if is_difference else operation
            return RealChain(start, (*parts, (link, left)))
    return _TREES[operation](left, right)


def rounded(node: Real) -> Real:
    """Return a result rounded to REAL (ST-304)."""
    rounding = RoundToSingle(node)
    start, parts = opened(rounding)
    return RealChain(start, parts) if len(parts) > 1 else rounding

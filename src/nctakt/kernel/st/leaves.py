# SPDX-License-Identifier: MIT
"""Whole numbers as their parents evaluate them.

Constants and variables are most of a tree. Compiled modules have C functions of the same names
(``leaves.pxd``) that read them in place, without a call.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, cast

from nctakt.kernel.st import kinds, words

if TYPE_CHECKING:
    from nctakt.kernel.st.context import PlcContext


class WholeNode(Protocol):
    """A node that has a whole number, truth or address."""

    def value(self, context: PlcContext) -> int:
        """Evaluate the node."""


class ElementNode(Protocol):
    """An element of an array."""

    address: WholeNode
    index: WholeNode
    lowest: int
    count: int
    stride: int
    offset: int


def value_of(node: WholeNode, context: PlcContext) -> int:
    """Return the whole number or truth that a node has."""
    return node.value(context)


def place_of(node: WholeNode, context: PlcContext) -> int:
    """Return the address that a node has."""
    return node.value(context)


def is_near(node: WholeNode) -> bool:
    """Return whether a node is evaluated without a call: a constant or a variable."""
    return getattr(node, "leaf", kinds.COMPUTED) > kinds.COMPUTED


def near_value(node: WholeNode, context: PlcContext) -> int:
    """Return the number or truth of a node that is evaluated without a call."""
    return node.value(context)


def is_near_place(node: WholeNode) -> bool:
    """Return whether an address is evaluated without a call."""
    leaf = getattr(node, "leaf", kinds.COMPUTED)
    return leaf == kinds.CONSTANT or leaf < kinds.COMPUTED


def near_place(node: WholeNode, context: PlcContext) -> int:
    """Return the address of a node that is evaluated without a call."""
    return node.value(context)


def near_element(node: WholeNode, context: PlcContext) -> int:
    """Return the address of an element whose parts need no call; 0 if it is outside."""
    element = cast("ElementNode", node)
    number = words.subtract(element.index.value(context), element.lowest)
    if number < 0 or number >= element.count:
        return 0
    return element.address.value(context) + element.offset + number * element.stride


def target_of(node: WholeNode, context: PlcContext) -> int:
    """Return the address that a statement writes; else note a fault."""
    return context.checked_target(node.value(context), 1)

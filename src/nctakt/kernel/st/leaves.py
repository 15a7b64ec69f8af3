# SPDX-License-Identifier: MIT
"""Whole numbers as their parents evaluate them.

Constants and variables are most of a tree. Compiled modules have C functions of the same names
(``leaves.pxd``) that read them in place, without a call.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from nctakt.kernel.st.context import PlcContext


class WholeNode(Protocol):
    """A node that has a whole number, truth or address."""

    def value(self, context: PlcContext) -> int:
        """Evaluate the node."""


def value_of(node: WholeNode, context: PlcContext) -> int:
    """Return the whole number or truth that a node has."""
    return node.value(context)


def place_of(node: WholeNode, context: PlcContext) -> int:
    """Return the address that a node has."""
    return node.value(context)


def is_near(node: WholeNode) -> bool:
    """Return whether a node is evaluated without a call: plain Python does not care."""
    return True


def near_value(node: WholeNode, context: PlcContext) -> int:
    """Return the number or truth of a node that is evaluated without a call."""
    return node.value(context)


def is_near_place(node: WholeNode) -> bool:
    """Return whether an address is evaluated without a call: plain Python does not care."""
    return True


def near_place(node: WholeNode, context: PlcContext) -> int:
    """Return the address of a node that is evaluated without a call."""
    return node.value(context)


def target_of(node: WholeNode, context: PlcContext) -> int:
    """Return the address that a statement writes; else note a fault."""
    return context.checked_target(node.value(context), 1)

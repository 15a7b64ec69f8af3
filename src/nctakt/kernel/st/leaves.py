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
    """Return the whole number, truth or address that a node has."""
    return node.value(context)

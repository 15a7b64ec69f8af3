# SPDX-License-Identifier: MIT
"""Real numbers as their parents evaluate them.

Constants and variables are most of a tree. Compiled modules have C functions of the same names
(``real_leaves.pxd``) that read them in place, without a call.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from nctakt.kernel.st.context import PlcContext


class RealNode(Protocol):
    """A node that has a real number."""

    def number(self, context: PlcContext) -> float:
        """Evaluate the node."""


def number_of(node: RealNode, context: PlcContext) -> float:
    """Return the real number that a node has."""
    return node.number(context)

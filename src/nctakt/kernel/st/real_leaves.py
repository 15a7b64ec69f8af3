# SPDX-License-Identifier: MIT
"""Real numbers as their parents evaluate them.

Constants and variables are most of a tree. Compiled modules have C functions of the same names
(``real_leaves.pxd``) that read them in place, without a call.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Protocol

from nctakt.kernel.st import kinds, words

if TYPE_CHECKING:
    from nctakt.kernel.st.context import PlcContext


class RealNode(Protocol):
    """A node that has a real number."""

    def number(self, context: PlcContext) -> float:
        """Evaluate the node."""


def number_of(node: RealNode, context: PlcContext) -> float:
    """Return the real number that a node has."""
    return node.number(context)


def valid(context: PlcContext, result: float) -> float:
    """Return a result; NaN is an invalid operation (ST-305)."""
    if result != result and context.stops_at_invalid:
        context.fail(kinds.INVALID, 0, 0)
    return result


def followed(links: memoryview, number: float, context: PlcContext) -> float:
    """Return the result of a chain's links for a number (``chains.py``)."""
    if not links:
        return number
    begins = (0, 0, context.frame, context.instance)
    for at in range(0, len(links), kinds.LINK_WIDTH):
        source, operation = links[at + kinds.LINK_SOURCE], links[at + kinds.LINK_OPERATION] // 2
        if operation == kinds.LINK_ROUND:
            number = words.single(number)
            continue
        (operand,) = struct.unpack("<d", struct.pack("<q", links[at + kinds.LINK_CONSTANT]))
        if source:
            address = begins[source] + links[at + kinds.LINK_OFFSET]
            kind = kinds.F32 if links[at + kinds.LINK_OPERATION] % 2 else kinds.F64
            operand = words.load_real(context.memory, address, kind)
        if operation == kinds.LINK_ADD:
            number += operand
        elif operation == kinds.LINK_SUBTRACT:
            number -= operand
        elif operation == kinds.LINK_SUBTRACT_FROM:
            number = operand - number
        else:
            number *= operand
    return valid(context, number)

# SPDX-License-Identifier: MIT
"""Channel lists (P-CHAN): in front of which blocks single block stops."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

#: Values of P-CHAN-00015: blocks that move, those that do something, all lines.
ONLY_MOTIONS, EFFECTIVE_BLOCKS, ALL_LINES = -1, 0, 1

SINGLE_BLOCK = (
    Parameter(
        "P-CHAN-00015",
        "einzelschrittmodus",
        ValueType.SGN16,
        EFFECTIVE_BLOCKS,
        Text(
            "Blocks at which single block stops: -1 motions, 0 also control blocks, 1 all lines",
            "Sätze, an denen der Einzelsatz anhält: -1 Bewegungen, 0 auch Steuersätze, 1 alle",
        ),
        low=ONLY_MOTIONS,
        high=ALL_LINES,
    ),
)

# SPDX-License-Identifier: MIT
"""Which of the controller's data V.G and V.A programs may read here.

In: a variable of the tree. Out: what it is, ``None`` for what is refused by name. All of them are
numbers, read when the block is decoded, and never written.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from nctakt.nc.resolution import is_own
from nctakt.nc.syntax import Expression, Variable

SYSTEM_FAMILIES = ("G", "A")

#: Timers of the main program: IDs 0 … 127.
TIMERS = 128

_LIMITS = {"+SWE_MDS": "high", "-SWE_MDS": "low"}


class SystemVariable(NamedTuple):
    """``subject`` is the axis; ``number`` that of a timer."""

    kind: Literal["timer", "tool", "low", "high"]
    subject: str = ""
    number: Expression | None = None


def system_variable(variable: Variable, axes: Sequence[str]) -> SystemVariable | None:
    """What a variable of these families is; ``axes``: those of the channel."""
    names = [part.name for part in variable.parts]
    indices = [index for part in variable.parts for index in part.indices]
    if variable.family == "G" and names == ["TIMER"] and len(indices) == 1:
        return SystemVariable("timer", "", indices[0])
    if indices:
        return None
    if variable.family == "G" and len(names) == 2 and names[0] == "WZ_AKT" and names[1] in "RL":
        return SystemVariable("tool", names[1])
    if variable.family == "A" and len(names) == 2 and names[0] in _LIMITS and names[1] in axes:
        return SystemVariable("high" if names[0][0] == "+" else "low", names[1])
    return None


def is_decoder_data(variable: Variable) -> bool:
    """Whether only the decoder knows the variable: a realtime cycle gets it as a constant."""
    return is_own(variable) or variable.family in SYSTEM_FAMILIES

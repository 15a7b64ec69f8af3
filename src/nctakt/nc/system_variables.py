# SPDX-License-Identifier: MIT
"""Which of the controller's data V.G and V.A programs may use here.

In: a variable of the tree. Out: what it is, ``None`` for what is refused by name. All of them are
numbers, read when the block is decoded; of the active tool, radius and length can be written.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from nctakt.nc.resolution import is_own
from nctakt.nc.syntax import Expression, Part, Variable

SYSTEM_FAMILIES = ("G", "A")

#: Timers of the main program: IDs 0 … 127.
TIMERS = 128

_LIMITS = {"+SWE_MDS": "high", "-SWE_MDS": "low"}

#: What programs read of a tool beside its elements: radius, length, valid, cutting edge, spindle.
_TOOL_VALUES = ("R", "L", "OK", "SRK_ID", "SPDL_AX_NR")


class SystemVariable(NamedTuple):
    """``subject`` is the axis of a limit, the name of a tool's value.

    ``number`` is that of a timer or, beside the active one, a tool; ``element`` that of a parameter
    or axis of a tool, ``axis`` the axis that is named instead. ``is_writable``: programs may give
    it a value.
    """

    kind: Literal["timer", "tool", "low", "high"]
    subject: str = ""
    number: Expression | None = None
    element: Expression | None = None
    axis: str = ""
    is_writable: bool = False

    @property
    def indices(self) -> list[Expression]:
        """What has to be evaluated for it."""
        return [one for one in (self.number, self.element) if one is not None]


def system_variable(variable: Variable, axes: Sequence[str]) -> SystemVariable | None:
    """What a variable of these families is; ``axes``: those of the channel."""
    names = [part.name for part in variable.parts]
    indices = [index for part in variable.parts for index in part.indices]
    if variable.family == "G" and names == ["TIMER"] and len(indices) == 1:
        return SystemVariable("timer", "", indices[0])
    if variable.family == "G" and variable.parts:
        return _of_tools(variable.parts, axes)
    if indices:
        return None
    if variable.family == "A" and len(names) == 2 and names[0] in _LIMITS and names[1] in axes:
        return SystemVariable("high" if names[0][0] == "+" else "low", names[1])
    return None


def _of_tools(parts: Sequence[Part], axes: Sequence[str]) -> SystemVariable | None:
    """``WZ_AKT.R``, ``WZ[5].V.X``, ``WZR``, ``T_AKT``, ``D_AKT``."""
    first, rest = parts[0], parts[1:]
    if not rest and not first.indices:
        if first.name in ("T_AKT", "D_AKT"):
            return SystemVariable("tool", first.name)
        return SystemVariable("tool", "R", is_writable=True) if first.name == "WZR" else None
    if first.name == "WZ_AKT" and not first.indices:
        number = None
    elif first.name == "WZ" and len(first.indices) == 1:
        (number,) = first.indices
    else:
        return None
    names = [part.name for part in rest]
    indices = [index for part in rest for index in part.indices]
    if len(names) == 1 and names[0] in _TOOL_VALUES and not indices:
        is_writable = number is None and names[0] in ("R", "L")
        return SystemVariable("tool", names[0], number, is_writable=is_writable)
    if len(names) == 1 and names[0] in ("V", "P") and len(indices) == 1:
        return SystemVariable("tool", names[0], number, indices[0])
    if len(names) == 2 and names[0] == "V" and names[1] in axes and not indices:
        return SystemVariable("tool", "V", number, axis=names[1])
    return None


def is_decoder_data(variable: Variable) -> bool:
    """Whether only the decoder knows the variable: a realtime cycle gets it as a constant."""
    return is_own(variable) or variable.family in SYSTEM_FAMILIES

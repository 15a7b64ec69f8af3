# SPDX-License-Identifier: MIT
"""V.G and V.A variables of the tree -> the controller's data that they name.

In: a variable of the tree. Out: its meaning, ``None`` for a variable that is refused by name. All
values are numbers, read when the block is decoded; ``system_names.py`` lists those that are not of
tools.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal, NamedTuple

from nctakt.lists.machine.transformations.universal_kinematic import BASE, ENTRIES, PARAMETER
from nctakt.nc.tree import Expression, Part, Variable
from nctakt.nc.vocabulary.variables.resolution import is_program_variable
from nctakt.nc.vocabulary.variables.spindle_variables import (
    SPINDLE_BY_PATH,
    SPINDLE_FAMILIES,
    SPINDLE_ROWS,
)
from nctakt.nc.vocabulary.variables.system_names import BY_PATH, ROWS

SYSTEM_FAMILIES = ("G", "A", "TOOL", "TLM", *SPINDLE_FAMILIES)

#: Timers of the main program: IDs 0 … 127.
TIMERS = 128

#: The ID of a tool.
_IDENTITY = ("BASIC", "SISTER", "VARIANT", "SISTER_VALID", "VARIANT_VALID")
#: The limits of its spindle that a tool brings.
_SPINDLE_LIMITS = ("S_MIN_SPEED", "S_MAX_SPEED", "S_MAX_ACC")
#: Single values of a tool: radius, length, validity, cutting edge, spindle, kinematic.
_TOOL_VALUES = (
    *("R", "L", "OK", "SRK_ID", "SPDL_AX_NR", "KIN_ID", "TYPE", "ME"),
    *_SPINDLE_LIMITS,
    *_IDENTITY,
)
_WRITABLE_TOOL_VALUES = ("R", "L", "OK", "SRK_ID", "SPDL_AX_NR", "KIN_ID")
#: Factors of the acquisition of tool life.
_LIFE_FACTORS = ("TIME_FACT", "DIST_FACT")


class SystemVariable(NamedTuple):
    """A variable of the controller; ``subject``: the value of a tool, or a path of
    ``system_names.py``.

    ``number``: of a timer or kinematic, or of a tool or zero offset other than the active one;
    ``element``: of a parameter, axis or spindle, ``axis``: the axis or spindle if it is named
    instead. ``is_writable``: programs may assign to it. ``waits``: reading it empties the channel
    first. ``further``: the indices of a number of a kinematic.
    """

    kind: Literal["timer", "tool", "tool life", "axis", "channel", "spindle", "kinematic"]
    subject: str = ""
    number: Expression | None = None
    element: Expression | None = None
    axis: str = ""
    is_writable: bool = False
    waits: bool = False
    further: tuple[Expression, ...] = ()

    @property
    def indices(self) -> list[Expression]:
        """The index expressions to evaluate."""
        named = [index for index in (self.number, self.element) if index is not None]
        return [*named, *self.further]


def system_variable(variable: Variable, axes: Sequence[str]) -> SystemVariable | None:
    """Return the meaning of a V.G or V.A variable; ``axes``: those of the channel."""
    names = [part.name for part in variable.parts]
    indices = [index for part in variable.parts for index in part.indices]
    if variable.family == "G" and names == ["TIMER"] and len(indices) == 1:
        return SystemVariable("timer", "", indices[0])
    if not variable.parts:
        return None
    if variable.family in ("TOOL", "TLM"):
        return None if indices or len(names) != 1 else _of_tool_data(variable.family, names[0])
    if variable.family in SPINDLE_FAMILIES:
        return _of_spindles(variable)
    return _of_row(variable, axes) or _of_kinematic(variable) or _of_tools(variable, axes)


def _of_tool_data(family: str, name: str) -> SystemVariable | None:
    """Return the meaning of ``V.TOOL.BASIC``, ``V.TLM.TIME_FACT``."""
    if family == "TOOL":
        return SystemVariable("tool", name) if name in _IDENTITY else None
    return SystemVariable("tool life", name, is_writable=True) if name in _LIFE_FACTORS else None


def _of_spindles(variable: Variable) -> SystemVariable | None:
    """Return the meaning of ``V.SPDL.LOG_AX_NR.S``, ``V.SPDL_PROG.SPEED[0]``."""
    first, rest = variable.parts[0], variable.parts[1:]
    row = SPINDLE_BY_PATH.get((variable.family, first.name))
    indices = [index for part in variable.parts for index in part.indices]
    if row is None or len(rest) + len(indices) != int(row.has_spindle):
        return None
    name = rest[0].name if rest else ""
    return SystemVariable("spindle", row.path, element=indices[0] if indices else None, axis=name)


def _of_row(variable: Variable, axes: Sequence[str]) -> SystemVariable | None:
    """Return the meaning of ``V.A.ABS.X``, ``V.A.ABS[0]``, ``V.G.NP[1].V.X``, ``V.G.MASS_MM``."""
    parts = list(variable.parts)
    axis, element, number = "", None, None
    if len(parts) > 1 and parts[-1].name in axes and not parts[-1].indices:
        axis = parts.pop().name
    elif len(parts[-1].indices) == 1:
        element = parts[-1].indices[0]
        parts[-1] = _without(parts[-1])
    if variable.family == "G" and parts[0].name == "NP" and len(parts[0].indices) == 1:
        number = parts[0].indices[0]
        parts[0] = _without(parts[0])
    if any(part.indices for part in parts):
        return None
    path = ".".join(part.name for part in parts)
    row = BY_PATH.get(
        (variable.family, "NP[1].V" if number is not None and path == "NP.V" else path)
    )
    has_element = axis or element is not None
    if (
        row is None
        or (row.has_axis or row.elements > 0) != bool(has_element)
        or (row.elements and axis)
    ):
        return None
    if (number is not None) != (row.path == "NP[1].V"):
        return None
    kind: Literal["axis", "channel"] = "axis" if row.has_axis else "channel"
    return SystemVariable(kind, row.path, number, element, axis, row.is_writable, row.waits)


def _without(part: Part) -> Part:
    """Return a part of a name without its indices."""
    return Part(part.span, part.name)


def _of_kinematic(variable: Variable) -> SystemVariable | None:
    """Return the meaning of ``KIN[9].PARAM[0]``, ``KIN[91].AXIS[3].POINT[2]``."""
    first, rest = variable.parts[0], variable.parts[1:]
    if variable.family != "G" or first.name != "KIN" or len(first.indices) != 1:
        return None
    path = ".".join(part.name.lower() + "[]" * len(part.indices) for part in rest)
    if path not in (PARAMETER, BASE) and path not in ENTRIES:
        return None
    indices = tuple(index for part in rest for index in part.indices)
    return SystemVariable("kinematic", path, first.indices[0], further=indices, is_writable=True)


def _of_tools(variable: Variable, axes: Sequence[str]) -> SystemVariable | None:
    """Return the meaning of ``WZ_AKT.R``, ``WZ[5].V.X``, ``WZR``, ``T_AKT``, ``D_AKT``.

    Type, unit and ID of a tool are read only.
    """
    if variable.family != "G":
        return None
    first, rest = variable.parts[0], variable.parts[1:]
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
        is_writable = names[0] in _WRITABLE_TOOL_VALUES
        return SystemVariable("tool", names[0], number, is_writable=is_writable)
    if len(names) == 1 and names[0] in ("KIN_PARAM", "V", "P") and len(indices) == 1:
        return SystemVariable("tool", names[0], number, indices[0], is_writable=True)
    if len(names) == 2 and names[0] == "V" and names[1] in axes and not indices:
        return SystemVariable("tool", "V", number, axis=names[1], is_writable=True)
    return None


def known_paths(axes: Sequence[str], spindles: Sequence[str]) -> Iterator[str]:
    """Yield the names of the controller's variables, ``[]`` for each index, as messages do."""
    for row in ROWS:
        if row.has_axis:
            yield from (f"V.{row.family}.{row.path}.{axis}" for axis in axes)
        else:
            yield f"V.{row.family}.{row.path}" + ("[]" if row.elements else "")
    for tool in ("V.G.WZ_AKT", "V.G.WZ[]"):
        yield from (f"{tool}.{name}" for name in _TOOL_VALUES)
        yield from (f"{tool}.V.{axis}" for axis in axes)
    yield from ("V.G.TIMER[]", "V.G.T_AKT", "V.G.D_AKT", "V.G.WZR")
    for spindle_row in SPINDLE_ROWS:
        name = f"V.{spindle_row.family}.{spindle_row.path}"
        yield from (f"{name}.{spindle}" for spindle in spindles if spindle_row.has_spindle)
        if not spindle_row.has_spindle:
            yield name
    yield from (f"V.TOOL.{name}" for name in _IDENTITY)
    yield from (f"V.TLM.{name}" for name in _LIFE_FACTORS)


def is_whole_offset(variable: Variable) -> bool:
    """Return whether the variable is a zero offset of all axes: ``V.G.NP[1].ALL``, ``NP_AKT.ALL``.

    They are copied as a whole only, one to the other.
    """
    if variable.family != "G" or [part.name for part in variable.parts[1:]] != ["ALL"]:
        return False
    first, last = variable.parts
    count = {"NP": 1, "NP_AKT": 0}.get(first.name)
    return len(first.indices) == count and not last.indices


def is_decoder_data(variable: Variable) -> bool:
    """Return whether only the decoder knows the variable, so that a realtime cycle takes it as a
    constant.
    """
    return is_program_variable(variable) or variable.family in SYSTEM_FAMILIES

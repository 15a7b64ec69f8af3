# SPDX-License-Identifier: MIT
"""Which axis of the machine an AXIS_REF of a PLC means (ST-742).

In: a program, the axes of a machine, a table by paths of variables. Out: where each AXIS_REF keeps
its axis, and the logical number that it gets: by the table, else by the name of the variable. One
of the CNC's library may be left: code can give it ``log_ax_nr``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.machine import Machine
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc_code import AXIS_REFERENCE_UNBOUND
from nctakt.st.program import Program
from nctakt.st.types import ArrayType, BlockType, Kind, Section, StructType, Type, Variable

_AXIS_REF = "axis_ref"
#: Elements of an array that are looked through at most.
_MAX_ELEMENTS = 256


@dataclass(frozen=True, slots=True)
class BoundAxis:
    """An AXIS_REF: its path, the paths of variables that it has from the start, and their values.

    The first one is the logical number of its axis.
    """

    path: str
    values: tuple[tuple[str, int], ...]


def bound_axes(
    program: Program, machine: Machine, names: Mapping[str, str]
) -> tuple[list[BoundAxis], list[Diagnostic]]:
    """Return the axes of a program's references, and those that name none of the machine."""
    numbers: dict[str, int] = {}
    for axis in machine.axes:
        numbers.setdefault(axis.name.lower(), axis.logical_number)
    for channel in machine.channels:
        for named in channel.axes:
            numbers.setdefault(named.name.lower(), named.logical_number)
    op_modes = {axis.logical_number: _op_modes(axis) for axis in machine.axes}
    given = {path.lower(): name for path, name in names.items()}
    found: list[BoundAxis] = []
    missing: list[Diagnostic] = []
    for path, variable in _references(program):
        name = given.get(path.lower(), variable.name)
        number = numbers.get(name.lower())
        is_block = isinstance(variable.type, BlockType)
        if number is not None and is_block:
            modes = op_modes.get(number, 0)
            values = (f"{path}.NcToPlc.AxisId", number), (f"{path}.NcToPlc.OpModeDWord", modes)
            found.append(BoundAxis(path, values))
        elif number is not None:
            found.append(BoundAxis(path, ((f"{path}.log_ax_nr", number),)))
        elif is_block or path.lower() in given:
            known = ", ".join(axis.name for axis in machine.axes)
            span = program.sources.span(variable.start, variable.start + len(variable.name))
            missing.append(diagnostic(AXIS_REFERENCE_UNBOUND, span, path=path, known=known))
    return found, missing


def _op_modes(axis: AxisConfiguration) -> int:
    """Return the published bits of OpModeDWord (NCTOPLC_AXIS_REF_OPMODE) that lists decide."""
    has_low, has_high = axis.software_limit_low > -math.inf, axis.software_limit_high < math.inf
    return axis.is_modulo << 7 | has_low << 18 | has_high << 19


def _references(program: Program) -> Iterator[tuple[str, Variable]]:
    """Yield the AXIS_REF variables of programs and lists with their paths."""
    for pou in program.pous.values():
        if pou.kind is Kind.PROGRAM:
            for variable in pou.members.values():
                yield from _inside(f"{pou.name}.{variable.name}", variable, variable.type)
    for group in program.lists:
        for variable in group.variables.values():
            prefix = f"{group.name}." if group.name else ""
            yield from _inside(f"{prefix}{variable.name}", variable, variable.type)


def _inside(path: str, variable: Variable, found: Type) -> Iterator[tuple[str, Variable]]:
    if variable.section is Section.IN_OUT:
        return
    if found.name.lower() == _AXIS_REF:
        yield path, variable
    elif isinstance(found, BlockType):
        for member in found.pou.members.values():
            yield from _inside(f"{path}.{member.name}", member, member.type)
    elif isinstance(found, StructType):
        for member in found.members.values():
            yield from _inside(f"{path}.{member.name}", member, member.type)
    elif isinstance(found, ArrayType) and len(found.bounds) == 1:
        low, high = found.bounds[0]
        if isinstance(found.element, BlockType | StructType):
            for index in range(low, min(high, low + _MAX_ELEMENTS) + 1):
                yield from _inside(f"{path}[{index}]", variable, found.element)

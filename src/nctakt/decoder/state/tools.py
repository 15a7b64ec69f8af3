# SPDX-License-Identifier: MIT
"""The tool of a program: D selects its data, T names it (MO-8).

In: the tool list of the channel, the words T and D, the plane. Out: TOOL offsets as commands, the
radius for compensation, the values of V.G.WZ…, V.G.T_AKT and V.G.D_AKT. A length acts along the
axis perpendicular to the plane, in addition to the offset of the list for that axis. The offsets
move nothing by themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NoReturn, Protocol

from nctakt.base.diagnostics import Message, Span
from nctakt.decoder.state.arcs import PLANES
from nctakt.decoder.state.commands import Command
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.modal_state import ModalState
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.tools import (
    MAX_KINEMATIC_PARAMETERS,
    MAX_PARAMETERS,
    NO_TOOL,
    Tool,
)
from nctakt.messages.checked_values import INDEX_OUT_OF_RANGE
from nctakt.messages.tools import (
    INVALID_TOOL_NUMBER,
    TOOL_LENGTH_WITHOUT_AXIS,
    TOOL_NOT_IN_LIST,
    TOOL_NOT_VALID,
    TOOL_RADIUS_LOST,
    UNKNOWN_TOOL,
)
from nctakt.messages.transformations import (
    KINEMATIC_OF_TOOL_DIFFERS,
    PARAMETER_DURING_TRANSFORMATION,
)
from nctakt.nc.tree import Expression, Variable, Word
from nctakt.nc.vocabulary.system_variables import SystemVariable

#: Sum of the indices of the first three axes; minus those of a plane: the axis normal to it.
_MAIN_AXES = 0 + 1 + 2

#: The axes whose offsets of the tool a transformation ignores (P-TOOL-00006).
_LINEAR_AXES = 3

#: The largest number behind T or D; the code of a T function has no room for more.
MAX_TOOL_NUMBER = 999_999_999


class Fail(Protocol):
    """Raises ``DecodeError``."""

    def __call__(self, message: Message, span: Span, **values: object) -> NoReturn: ...


class ActiveTool:
    """The tool of one program."""

    def __init__(self, environment: DecoderEnvironment, state: ModalState, fail: Fail) -> None:
        self._environment = environment
        self._state = state
        self._fail = fail

    def name(self, word: Word, value: float) -> int:
        """Process T, and return its number for the PLC; the tool list has it, if there is one."""
        number = self._number(word, value)
        if number and self._environment.tools and number not in self._environment.tools:
            self._fail(TOOL_NOT_IN_LIST, word.span, tool=number)
        self._state.tool.number = number
        return number

    def select(self, word: Word, value: float) -> None:
        """Select the data of a valid tool of the list, or none with the number 0."""
        number = self._number(word, value)
        tool = NO_TOOL if number == 0 else self._environment.tools.get(number)
        if tool is None:
            self._fail(UNKNOWN_TOOL, word.span, tool=number)
        if tool is not NO_TOOL and not tool.valid:
            self._fail(TOOL_NOT_VALID, word.span, tool=number)
        self._change_radius(tool.radius, f"{word.name}{number}", word.span)
        self._select_kinematic(tool, word.span)
        self._state.tool.record = number
        self._state.tool.tool = tool

    def _select_kinematic(self, tool: Tool, span: Span) -> None:
        """Select the kinematic of a tool that names one (P-TOOL-00011)."""
        transformation = self._environment.offsets.transformation
        identity = transformation.kinematics.id_of_tool(tool)
        active = transformation.kinematic
        if identity and active is not None and active.id != identity:
            self._fail(KINEMATIC_OF_TOOL_DIFFERS, span, tool=identity, active=active.id)
        if identity:
            transformation.selected[0] = identity

    def _number(self, word: Word, value: float) -> int:
        number = int(arithmetic.round_half_even(value))
        if number != value or not 0 <= number <= MAX_TOOL_NUMBER:
            self._fail(INVALID_TOOL_NUMBER, word.span, word=word.name, value=value)
        return number

    def _change_radius(self, radius: float, command: str, span: Span) -> None:
        """Set the radius for the next motion between G41 or G42 and G40."""
        compensation = self._state.path.compensation
        if not compensation.side:
            return
        if radius == 0.0:
            self._fail(TOOL_RADIUS_LOST, span, command=command, word=compensation.word)
        compensation.radius = radius

    def offsets(self, span: Span, number: int) -> Iterator[Command]:
        """Yield the offsets of the tool in the current plane; a transformation has its length."""
        tool, plane = self._state.tool.tool, self._state.path.plane
        offsets = dict(tool.axis_offsets)
        transformation = self._environment.offsets.transformation
        if transformation.is_transformation:
            source = self._environment.source_id(span)
            self._state.positions = yield from transformation.change_tool(
                tool, self._state.positions, source, number
            )
            offsets = {axis: value for axis, value in offsets.items() if axis >= _LINEAR_AXES}
        elif tool.length:
            normal = _MAIN_AXES - sum(PLANES[plane])
            if normal >= len(self._environment.axes):
                self._fail(TOOL_LENGTH_WITHOUT_AXIS, span, length=tool.length, plane=plane)
            offsets[normal] = offsets.get(normal, 0.0) + tool.length
        source = self._environment.source_id(span)
        yield from self._environment.offsets.set_tool(offsets, source, number)

    # --- V.G -------------------------------------------------------------------------------------

    def read(
        self,
        variable: Variable,
        system_variable: SystemVariable,
        index: Callable[[Expression], float],
    ) -> float:
        """Return V.G.T_AKT, V.G.D_AKT, V.G.WZ_AKT… or V.G.WZ[5]…, lengths in the program's unit.

        ``index`` evaluates the number of a tool or element.
        """
        state = self._state.tool
        if system_variable.subject in ("T_AKT", "D_AKT"):
            return float(state.number if system_variable.subject == "T_AKT" else state.record)
        tool = state.tool
        if system_variable.number is not None:
            number = int(index(system_variable.number))
            listed = NO_TOOL if number == 0 else self._environment.tools.get(number)
            if listed is None:
                self._fail(UNKNOWN_TOOL, system_variable.number.span, tool=number)
            tool = listed
        unit = self._state.length_unit_mm
        match system_variable.subject:
            case "R":
                return tool.radius / unit
            case "L":
                return tool.length / unit
            case "V":
                return self._axis_offset(variable, system_variable, tool, index)
            case "P":
                parameter = self._element(variable, system_variable, MAX_PARAMETERS, index)
                return tool.parameters.get(parameter, 0.0)
            case "KIN_PARAM":
                count = MAX_KINEMATIC_PARAMETERS
                parameter = self._element(variable, system_variable, count, index)
                return float(tool.kinematic_parameters.get(parameter, 0))
            case "KIN_ID":
                return float(tool.kinematic_id)
            case "OK":
                return float(tool.valid)
            case "SRK_ID":
                return float(tool.cutter_position)
            case _:
                return float(tool.spindle_number)

    def _axis_offset(
        self,
        variable: Variable,
        system_variable: SystemVariable,
        tool: Tool,
        index: Callable[[Expression], float],
    ) -> float:
        if system_variable.element is None:
            axis = self._environment.axis_numbers[system_variable.axis]
        else:
            axis = self._element(variable, system_variable, len(self._environment.axes), index)
        offset = tool.axis_offsets.get(axis, 0.0)
        is_linear = self._environment.axes[axis].is_linear
        return offset / self._state.length_unit_mm if is_linear else offset

    def _element(
        self,
        variable: Variable,
        system_variable: SystemVariable,
        count: int,
        index: Callable[[Expression], float],
    ) -> int:
        assert system_variable.element is not None
        element = int(index(system_variable.element))
        if not 0 <= element < count:
            name = f"V.{variable.family}." + ".".join(part.name for part in variable.parts)
            self._fail(
                INDEX_OUT_OF_RANGE,
                system_variable.element.span,
                variable=name,
                index=element,
                count=count,
            )
        return element

    def write_kinematic_parameter(
        self,
        variable: Variable,
        system_variable: SystemVariable,
        value: float,
        index: Callable[[Expression], float],
    ) -> None:
        """Set what the active tool adds to a parameter of the kinematic, until the next D."""
        if self._environment.offsets.transformation.is_transformation:
            self._fail(PARAMETER_DURING_TRANSFORMATION, variable.span)
        state = self._state.tool
        parameter = self._element(variable, system_variable, MAX_KINEMATIC_PARAMETERS, index)
        parameters = {**state.tool.kinematic_parameters, parameter: value}
        state.tool = replace(state.tool, kinematic_parameters=parameters)

    def write(
        self, system_variable: SystemVariable, value: float, span: Span, number: int
    ) -> Iterator[Command]:
        """Set radius or length of the active tool until the next D."""
        state = self._state.tool
        length = value * self._state.length_unit_mm
        if system_variable.subject == "R":
            self._change_radius(length, "V.G.WZ_AKT.R", span)
            state.tool = replace(state.tool, radius=length)
        else:
            state.tool = replace(state.tool, length=length)
            yield from self.offsets(span, number)

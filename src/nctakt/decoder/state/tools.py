# SPDX-License-Identifier: MIT
"""The tool of a program: D selects its data, T names it (MO-8).

In: the tool list of the channel, the words T and D, the plane. Out: TOOL offsets as commands, the
radius for compensation, the values of V.G.WZ…, V.G.T_AKT and V.G.D_AKT. A length acts along the
axis perpendicular to the plane, in addition to the offset of the list for that axis. The offsets
alone move nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import replace
from typing import NoReturn, Protocol

from nctakt.base.diagnostics import Message, Span
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.geometry.arcs import PLANES
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.queued.spindle_commands import SpindleLimits
from nctakt.decoder.state.queued.tool_life import SetToolLife, ToolLifeFactors
from nctakt.decoder.state.tool_manager import (
    ANSWER_LIMIT_S,
    DATA,
    PREPARATION,
    Identity,
    ToolManager,
)
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.tools import (
    MAX_KINEMATIC_PARAMETERS,
    MAX_PARAMETERS,
    NO_TOOL,
    Tool,
)
from nctakt.messages.path.tools import (
    INVALID_TOOL_LIFE_FACTOR,
    INVALID_TOOL_NUMBER,
    INVALID_TOOL_VALUE,
    TOOL_LENGTH_WITHOUT_AXIS,
    TOOL_NOT_ASKED_FOR,
    TOOL_NOT_IN_LIST,
    TOOL_NOT_VALID,
    TOOL_RADIUS_LOST,
    UNKNOWN_TO_TOOL_MANAGEMENT,
    UNKNOWN_TOOL,
)
from nctakt.messages.path.transformations import (
    KINEMATIC_NOT_POSSIBLE,
    KINEMATIC_OF_TOOL_DIFFERS,
    PARAMETER_DURING_TRANSFORMATION,
)
from nctakt.messages.programs.checked_values import INDEX_OUT_OF_RANGE
from nctakt.nc.tree import Expression, Variable, Word
from nctakt.nc.vocabulary.variables.system_variables import SystemVariable

#: Sum of the indices of the first three axes; minus those of a plane: the axis normal to it.
_MAIN_AXES = 0 + 1 + 2

#: The third main axis, Z.
_THIRD_AXIS = 2

#: The axes whose offsets of the tool a transformation ignores (P-TOOL-00006).
_LINEAR_AXES = 3

#: Degrees per second are 1000 of the tool list's units.
_SPEED_UNITS = 1000.0

#: The largest number after T or D; the code of a T function has no room for more.
MAX_TOOL_NUMBER = 999_999_999


#: The names in variables of basic, sister and variant number of a tool.
_PARTS = ("BASIC", "SISTER", "VARIANT")


class Fail(Protocol):
    """Raises ``DecodeError``."""

    def __call__(self, message: Message, span: Span, **values: object) -> NoReturn: ...


class ActiveTool:
    """The tool of one program."""

    def __init__(self, environment: DecoderEnvironment, state: ModalState, fail: Fail) -> None:
        self._environment = environment
        self._state = state
        self._fail = fail
        self._limiting_tool: Tool | None = None
        self._is_external = environment.parameters.tool_selection.is_external
        self.manager = ToolManager(environment, state)

    def name(self, word: Word, value: float) -> int:
        """Process T, and return its number for the PLC; the tool list has it, if there is one."""
        number = self._number(word.name, word.span, value)
        self.prepare((number, 0, 0), word.span)
        return number

    def prepare(self, identity: Identity, span: Span) -> None:
        """Process ``#TOOL PREP`` or T for the tool with this ID.

        An external tool management may have more tools than the list.
        """
        is_listed = self._environment.tools and not self._is_external
        if any(identity) and is_listed and self._with(identity) is None:
            self._fail(TOOL_NOT_IN_LIST, span, tool=_shown(identity))
        self._state.tool.number = identity[0]

    def announce(
        self, identity: Identity, command: str, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Let the tool manager of the PLC get a tool ready, if T asks for that (P-CHAN-00087)."""
        informs = self._environment.parameters.tool_selection.informs_of_t
        if informs and any(identity) and self.manager.is_there:
            wrong, _ = yield from self.manager.ask(PREPARATION, identity, span, number)
            self._check_answer(wrong, identity, command, span)

    def _managed(
        self, identity: Identity, command: str, span: Span, number: int
    ) -> Generator[Command, Answer, Tool | None]:
        """Return the tool that the PLC answers, or that of the list; ``None``: there is none.

        The manager gets D0, too: the tool that is put away may have worn.
        """
        if not self.manager.is_there:
            return self._with(identity) if any(identity) else NO_TOOL
        wrong, tool = yield from self.manager.ask(DATA, identity, span, number)
        self._check_answer(wrong, identity, command, span)
        return tool if any(identity) else NO_TOOL

    def _check_answer(
        self, wrong: Message | None, identity: Identity, command: str, span: Span
    ) -> None:
        if wrong is not None:
            shown, limit = _shown(identity), ANSWER_LIMIT_S
            self._fail(wrong, span, command=command, tool=shown, seconds=limit)

    def select(self, word: Word, value: float, number: int) -> Generator[Command, Answer, Identity]:
        """Select the data of a valid tool, or none with the number 0; return its ID."""
        basic = self._number(word.name, word.span, value)
        yield from self.select_identity((basic, 0, 0), f"{word.name}{basic}", word.span, number)
        return (basic, 0, 0)

    def select_identity(
        self, identity: Identity, command: str, span: Span, block: int
    ) -> Generator[Command, Answer]:
        """Select the data of the valid tool with this ID, or none with 0; ``block``: N number."""
        tool = yield from self._managed(identity, command, span, block)
        number = identity[0]
        if tool is None:
            message = UNKNOWN_TO_TOOL_MANAGEMENT if self._is_external else UNKNOWN_TOOL
            self._fail(message, span, tool=_shown(identity))
        if tool is not NO_TOOL and not tool.valid:
            self._fail(TOOL_NOT_VALID, span, tool=_shown(identity))
        if tool is not NO_TOOL:
            for message, values in self._environment.parameters.tool_selection.mistakes(tool):
                self._fail(message, span, tool=_shown(identity), **values)
        self._take(tool, number, command, span)

    def refresh(self, span: Span, number: int) -> Generator[Command, Answer]:
        """Take the data of the active tool again, of the list or the PLC (``#TOOL REFRESH``)."""
        active = self._state.tool.tool
        tool = self._listed(active.number)
        if self.manager.is_there and active is not NO_TOOL:
            tool = yield from self._managed(active.identity, "#TOOL REFRESH", span, number)
        if tool is not None:
            self._take(tool, self._state.tool.record, "#TOOL REFRESH", span)

    def _listed(self, index: int) -> Tool | None:
        """Return the tool of the list with this index, as programs have changed it."""
        changed = self._environment.controller_data.tools
        return changed.get(index) or self._environment.tools.get(index)

    def _with(self, identity: Identity) -> Tool | None:
        """Return the tool of the list with this ID."""
        tools = self._environment.tools
        tool = tools.get(identity[0])
        if tool is None or tool.identity != identity:
            every = (one for one in tools.values() if one.identity == identity)
            tool = next(every, None)
        return None if tool is None else self._listed(tool.number)

    def _take(self, tool: Tool, number: int, command: str, span: Span) -> None:
        """Activate this tool."""
        self._change_radius(tool.radius, command, span)
        self._select_kinematic(tool, span)
        suspended = self._environment.offsets.suspended
        if suspended is not None and not suspended.is_without_tools:
            suspended.has_tool = True
        self._state.tool.record = number
        self._state.tool.tool = tool

    def _select_kinematic(self, tool: Tool, span: Span) -> None:
        """Select the kinematic of a tool that names one (P-TOOL-00011)."""
        transformation = self._environment.offsets.transformation
        identity = transformation.kinematics.id_of_tool(tool)
        suspended = self._environment.offsets.suspended
        active = transformation.steps[0] if suspended is None else suspended.steps[0]
        if identity and active is not None and active.id != identity:
            self._fail(KINEMATIC_OF_TOOL_DIFFERS, span, tool=identity, active=active.id)
        if active is not None:
            kinematics = transformation.kinematics
            reason = kinematics.refusal(kinematics.with_tool(active, tool))
            if reason is not None:
                self._fail(KINEMATIC_NOT_POSSIBLE, span, id=active.id, reason=reason)
        if identity:
            transformation.selected[0] = identity

    def _number(self, word: str, span: Span, value: float) -> int:
        number = int(arithmetic.round_half_even(value))
        if number != value or not 0 <= number <= MAX_TOOL_NUMBER:
            self._fail(INVALID_TOOL_NUMBER, span, word=word, value=value)
        return number

    def identity(self, numbers: Sequence[float], command: str, span: Span) -> Identity:
        """Return the ID of basic, sister and variant number; missing ones are 0."""
        parts = [self._number(command, span, number) for number in numbers]
        basic, sister, variant = [*parts, 0, 0][:3]
        return (basic, sister, variant)

    def _change_radius(self, radius: float, command: str, span: Span) -> None:
        """Set the radius for the next motion between G41 or G42 and G40."""
        compensation = self._state.path.compensation
        if not compensation.side:
            return
        if radius == 0.0:
            self._fail(TOOL_RADIUS_LOST, span, command=command, word=compensation.word)
        compensation.radius = radius

    def offsets(self, span: Span, number: int) -> Iterator[Command]:
        """Yield the offsets of the tool in the current plane; a transformation has its length.

        A new tool brings the limits of its spindle.
        """
        yield from self._spindle_limits(span, number)
        if not self._environment.offsets.has_tool_offsets:
            return
        tool, plane = self._state.tool.tool, self._state.path.plane
        offsets = dict(tool.axis_offsets)
        transformation = self._environment.offsets.transformation
        source = self._environment.source_id(span)
        if transformation.is_transformation:
            self._state.positions = yield from transformation.change_tool(
                tool, self._state.positions, source, number
            )
            offsets = {axis: value for axis, value in offsets.items() if axis >= _LINEAR_AXES}
        elif tool.length:
            normal, sign = self._length_axis(plane)
            if normal >= len(self._environment.axes):
                self._fail(TOOL_LENGTH_WITHOUT_AXIS, span, length=tool.length, plane=plane)
            offsets[normal] = offsets.get(normal, 0.0) + sign * tool.length
        if transformation.plane is not None:
            self._state.positions = yield from transformation.change_tool_of_plane(
                offsets, self._state.positions, source, number
            )
            mapped = transformation.plane.mapped
            offsets = {axis: value for axis, value in offsets.items() if axis not in mapped}
        yield from self._environment.offsets.set_tool(offsets, source, number)

    def _spindle_limits(self, span: Span, number: int) -> Iterator[Command]:
        """Yield the limits that a tool has for its spindle; one without any changes nothing."""
        tool = self._state.tool.tool
        is_known = tool is self._limiting_tool
        if is_known or not tool.spindle_number or not (any(tool.speeds) or tool.acceleration):
            return
        self._limiting_tool = tool
        low, high = (speed / _SPEED_UNITS for speed in tool.speeds)
        for index, spindle in enumerate(self._environment.parameters.spindles):
            if spindle.logical_number == tool.spindle_number and not spindle.plc_controlled:
                source = self._environment.source_id(span)
                gears = self._environment.spindle_gears.get(index)
                if gears is not None:
                    gears.tool_range = (low, high)
                yield SpindleLimits(source, number, index, low, high, tool.acceleration)

    def _length_axis(self, plane: int) -> tuple[int, int]:
        """Return the index of the axis along which the length acts, and the sign."""
        if self._state.tool.length_axis is not None:
            return self._state.tool.length_axis
        keeps_axis = self._environment.parameters.tool_selection.keeps_length_axis
        return (_THIRD_AXIS if keeps_axis else _MAIN_AXES - sum(PLANES[plane])), 1

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
            tool = self._numbered(system_variable.number, index)
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
            case "TYPE":
                return float(tool.type)
            case "ME":
                return float(tool.is_inch)
            case "BASIC" | "SISTER" | "VARIANT":
                return float(tool.identity[_PARTS.index(system_variable.subject)])
            case "SISTER_VALID":
                return float(tool.sister_is_valid)
            case "VARIANT_VALID":
                return float(tool.variant_is_valid)
            case "OK":
                return float(tool.valid)
            case "SRK_ID":
                return float(tool.cutter_position)
            case "S_MIN_SPEED" | "S_MAX_SPEED":
                return tool.speeds[system_variable.subject == "S_MAX_SPEED"]
            case "S_MAX_ACC":
                return tool.acceleration
            case _:
                return float(tool.spindle_number)

    def _numbered(self, number: Expression, index: Callable[[Expression], float]) -> Tool:
        """Return the tool of V.G.WZ[5]; raises ``DecodeError``."""
        value = int(index(number))
        listed = NO_TOOL if value == 0 else self._with((value, 0, 0))
        if value and self.manager.is_there:
            listed = self.manager.known.get((value, 0, 0))
            if listed is None:
                self._fail(TOOL_NOT_ASKED_FOR, number.span, tool=value)
        if listed is None:
            self._fail(UNKNOWN_TOOL, number.span, tool=value)
        return listed

    def _axis_offset(
        self,
        variable: Variable,
        system_variable: SystemVariable,
        tool: Tool,
        index: Callable[[Expression], float],
    ) -> float:
        axis = self._axis(variable, system_variable, index)
        offset = tool.axis_offsets.get(axis, 0.0)
        is_linear = self._environment.axes[axis].is_linear
        return offset / self._state.length_unit_mm if is_linear else offset

    def _axis(
        self,
        variable: Variable,
        system_variable: SystemVariable,
        index: Callable[[Expression], float],
    ) -> int:
        """Return the index of the axis in the channel."""
        if system_variable.element is None:
            return self._environment.axis_numbers[system_variable.axis]
        return self._element(variable, system_variable, len(self._environment.axes), index)

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
        """Set the active tool's addition to a parameter of the kinematic, until the next D."""
        if self._environment.offsets.transformation.is_transformation:
            self._fail(PARAMETER_DURING_TRANSFORMATION, variable.span)
        state = self._state.tool
        parameter = self._element(variable, system_variable, MAX_KINEMATIC_PARAMETERS, index)
        parameters = {**state.tool.kinematic_parameters, parameter: value}
        state.tool = replace(state.tool, kinematic_parameters=parameters)

    def write_life(self, factor: str, value: float, span: Span, number: int) -> Iterator[Command]:
        """Set V.TLM.TIME_FACT or V.TLM.DIST_FACT, at least 0."""
        if value < 0.0:
            self._fail(INVALID_TOOL_LIFE_FACTOR, span, variable=f"V.TLM.{factor}", value=value)
        factors = self._environment.controller_data.tool_life_factors
        factors[factor] = value
        source = self._environment.source_id(span)
        yield ToolLifeFactors(source, number, factors["TIME_FACT"], factors["DIST_FACT"])

    def change_life(
        self, identity: Identity, span: Span, number: int, *, by_d: bool
    ) -> Iterator[Command]:
        """Begin the tool life of another tool, if it begins with D (``by_d``) or T."""
        rules = self._environment.parameters.tool_selection.life
        if rules.by_d == by_d:
            yield self.life(
                codes.LIFE_SENT if rules.is_sent else codes.LIFE_BEGUN, identity, span, number
            )

    def life(self, action: int, identity: Identity, span: Span, number: int) -> SetToolLife:
        """Return the command for the tool life with a tool."""
        text = self._environment.text_id(_shown(identity))
        return SetToolLife(self._environment.source_id(span), number, action, text, identity[0])

    def write(
        self,
        variable: Variable,
        system_variable: SystemVariable,
        value: float,
        index: Callable[[Expression], float],
        number: int,
    ) -> Iterator[Command]:
        """Change the active tool until the next D, or a tool of the list until the next start-up.

        Radius, length, free values, offsets of axes, validity, numbers, additions to kinematics.
        """
        state = self._state.tool
        changes_list = system_variable.number is not None
        tool = state.tool
        if system_variable.number is not None:
            tool = self._numbered(system_variable.number, index)
        length = value * self._state.length_unit_mm
        match system_variable.subject:
            case "R":
                tool = replace(tool, radius=length)
            case "L":
                tool = replace(tool, length=length)
            case "P":
                parameter = self._element(variable, system_variable, MAX_PARAMETERS, index)
                tool = replace(tool, parameters={**tool.parameters, parameter: value})
            case "KIN_PARAM":
                count = MAX_KINEMATIC_PARAMETERS
                parameter = self._element(variable, system_variable, count, index)
                added = {**tool.kinematic_parameters, parameter: value}
                tool = replace(tool, kinematic_parameters=added)
            case "OK":
                tool = replace(tool, valid=arithmetic.is_true(value))
            case "SRK_ID":
                tool = replace(tool, cutter_position=self._whole(variable, value))
            case "SPDL_AX_NR":
                tool = replace(tool, spindle_number=self._whole(variable, value))
            case "KIN_ID":
                tool = replace(tool, kinematic_id=self._whole(variable, value))
            case _:
                axis = self._axis(variable, system_variable, index)
                offset = length if self._environment.axes[axis].is_linear else value
                tool = replace(tool, axis_offsets={**tool.axis_offsets, axis: offset})
        if changes_list:
            if tool.number:
                self._environment.controller_data.tools[tool.number] = tool
            return
        if system_variable.subject == "R":
            self._change_radius(length, "V.G.WZ_AKT.R", variable.span)
        state.tool = tool
        if system_variable.subject in ("L", "V"):
            yield from self.offsets(variable.span, number)

    def _whole(self, variable: Variable, value: float) -> int:
        """Return a value of a tool that is a whole number of at least 0."""
        if value < 0.0 or value != int(value):
            self._fail(INVALID_TOOL_VALUE, variable.span, value=value)
        return int(value)


def _shown(identity: Identity) -> str:
    """Return an ID as written: ``5``, ``5, 2, 1``."""
    return ", ".join(map(str, identity)) if any(identity[1:]) else str(identity[0])

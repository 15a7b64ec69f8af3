# SPDX-License-Identifier: MIT
"""``#KIN ID``, ``#TRAFO``, ``#RTCP``, ``#TLC`` of the main program -> commands (MO-8).

In: the tree of a checked command. A kinematic is selected by its ID, activated and deactivated;
neither moves an axis. ``#TLC`` shifts the linear axes along the tool by a difference of its length.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence

from nctakt.base.diagnostics import NOTHING, Span
from nctakt.decoder.state.commands import Answer, Command, PositionRequest
from nctakt.decoder.values.variables import Values
from nctakt.lists.machine.kinematics import Kinematic
from nctakt.messages.transformations import (
    FIXED_TYPE_SIGNS,
    KIN_ID_DURING_TRANSFORMATION,
    KINEMATIC_NOT_POSSIBLE,
    NO_KINEMATIC_SELECTED,
    PTP_DURING_COMPENSATION,
    PTP_WITHOUT_TRANSFORMATION,
    SECOND_STEP_NOT_SIMULATED,
    TLC_AND_RTCP,
    TLC_DURING_COMPENSATION,
    TRANSFORMATION_DURING_COMPENSATION,
    UNKNOWN_KINEMATIC,
)
from nctakt.nc import tree
from nctakt.nc.check.transformations import TransformationCommand, transformation_command


class TransformationCommands:
    """The commands of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._transformations = values.environment.parameters.transformations
        self._active = values.environment.offsets.transformation
        self._reported: set[int] = set()

    def command(self, statement: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one command."""
        command = transformation_command(statement)
        assert command is not None
        span = statement.span
        match command.name:
            case "KIN ID":
                yield from self._select(command, span, number)
            case "TRAFO":
                yield from self._select_and_switch(command, span, number)
            case "TRAFO ON" | "RTCP ON":
                yield from self._switch_on(command, span, number)
            case "TRAFO OFF" | "RTCP OFF":
                if self._active.is_transformation:
                    yield from self._switch(0, command, span, number)
            case "TLC ON":
                yield from self._correct_length(command, span, number)
            case "TLC OFF":
                if self._active.is_length_correction:
                    yield from self._switch(0, command, span, number)
            case "PTP ON":
                yield from self._move_straight(command, span, number)
            case _:
                yield from self._active.move_straight(
                    False, self._environment.source_id(span), number
                )

    # --- selection ------------------------------------------------------------------------------

    def _select(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Select kinematics; without values the default ones."""
        if self._active.is_transformation:
            self._values.fail(KIN_ID_DURING_TRANSFORMATION, span)
        if not command.values:
            self._active.selected = list(self._transformations.default_ids)
            return
        for step in range(2):
            value = command.values[step] if step < len(command.values) else "NONE"
            self._active.selected[step] = yield from self._identity(value, step, number)

    def _identity(
        self, value: tree.Expression | str, step: int, number: int
    ) -> Generator[Command, Answer, int]:
        """Return the ID that a value of a step selects; ON and OFF keep that of the step."""
        if value == "NONE":
            return 0
        if value == "DEFAULT":
            return self._transformations.default_ids[step]
        if isinstance(value, str):
            return self._active.selected[step]
        result = yield from self._values.evaluate(value, number)
        if result != int(result):
            known = _known(self._transformations.steps[step])
            self._values.fail(UNKNOWN_KINEMATIC, value.span, id=result, known=known)
        return int(result)

    def _select_and_switch(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Execute ``#TRAFO [a, b]``."""
        selected = []
        for step in range(2):
            value = command.values[step] if step < len(command.values) else "NONE"
            selected.append((yield from self._identity(value, step, number)))
        first = command.values[0]
        activates = first not in ("OFF", "NONE")
        if activates and self._active.is_transformation and selected != self._active.selected:
            self._values.fail(KIN_ID_DURING_TRANSFORMATION, span)
        self._active.selected = selected
        second = command.values[1] if len(command.values) > 1 else "NONE"
        if second not in ("OFF", "NONE") and selected[1]:
            self._values.fail(SECOND_STEP_NOT_SIMULATED, span)
        if activates:
            yield from self._switch_on(command, span, number)
        elif self._active.is_transformation:
            yield from self._switch(0, command, span, number)

    def _kinematic(self, command: TransformationCommand, span: Span) -> Kinematic:
        """Return the selected kinematic of the first step."""
        known = _known(self._transformations.steps[0])
        identity = self._active.selected[0]
        if identity == 0:
            self._values.fail(NO_KINEMATIC_SELECTED, span, command=command.shown, known=known)
        kinematic = self._active.kinematics.find(0, identity)
        if kinematic is None:
            self._values.fail(UNKNOWN_KINEMATIC, span, id=identity, known=known)
        reason = self._active.kinematics.refusal(kinematic)
        if reason is not None:
            self._values.fail(KINEMATIC_NOT_POSSIBLE, span, id=identity, reason=reason)
        if kinematic.universal is None and kinematic.type not in self._reported:
            self._reported.add(kinematic.type)
            self._values.warn(FIXED_TYPE_SIGNS, span, id=identity, type=kinematic.type)
        return kinematic

    # --- switching ------------------------------------------------------------------------------

    def _switch_on(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Activate the selected kinematic."""
        if self._active.selected[1]:
            self._values.fail(SECOND_STEP_NOT_SIMULATED, span)
        kinematic = self._kinematic(command, span)
        if self._active.is_length_correction:
            self._values.fail(TLC_AND_RTCP, span, command=command.shown)
        if not self._active.is_transformation:
            tool = self._values.state.tool.tool
            yield from self._switch(self._active.map_of(kinematic, tool), command, span, number)
            self._active.kinematic = kinematic

    def _switch(
        self, map_number: int, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Activate a map, 0 for none, with the axes where they are."""
        if self._values.state.path.compensation.is_active:
            message = TRANSFORMATION_DURING_COMPENSATION
            self._values.fail(message, span, command=command.shown)
        source = self._environment.source_id(span)
        self._values.check_flush_allowed(command.shown, span)
        answer = yield PositionRequest(source, number)
        assert isinstance(answer, tuple)
        state = self._values.state
        state.positions = yield from self._active.switch(map_number, list(answer), source, number)
        yield from self._values.tool.offsets(span, number)

    def _correct_length(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Execute ``#TLC ON [dL]``."""
        if self._active.is_transformation:
            self._values.fail(TLC_AND_RTCP, span, command=command.shown)
        if self._values.state.path.compensation.is_active:
            self._values.fail(TLC_DURING_COMPENSATION, span)
        kinematic = self._kinematic(command, span)
        difference = 0.0
        for value in command.values:
            assert isinstance(value, tree.Expression)
            difference = yield from self._values.evaluate(value, number)
        difference *= self._values.state.length_unit_mm
        yield from self._switch(
            self._active.map_of_length(kinematic, difference), command, span, number
        )

    def _move_straight(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Execute ``#PTP ON``."""
        if self._values.state.path.compensation.is_active:
            self._values.fail(PTP_DURING_COMPENSATION, span)
        if not self._active.is_transformation:
            self._values.fail(PTP_WITHOUT_TRANSFORMATION, span)
        yield from self._active.move_straight(True, self._environment.source_id(span), number)


def _known(kinematics: Mapping[int, Kinematic]) -> str:
    """Return the IDs of kinematics as a list for a message."""
    identities: Sequence[int] = sorted(kinematics)
    return ", ".join(map(str, identities)) or NOTHING

# SPDX-License-Identifier: MIT
"""``#KIN ID``, ``#TRAFO``, ``#RTCP``, ``#TLC`` of the main program -> commands (MO-8).

In: the tree of a checked command. A kinematic is selected by its ID, activated and deactivated;
neither moves an axis. ``#TLC`` shifts the linear axes along the tool by a difference of its length.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence

from nctakt.base.diagnostics import NOTHING, Span
from nctakt.decoder.blocks.axes.coupled_axes import check_uncoupled
from nctakt.decoder.kinematics.rotating_planes import RotatingPlane
from nctakt.decoder.state.geometry.transformation import NO_STEPS, Steps
from nctakt.decoder.state.queued.commands import Answer, Command, PositionRequest
from nctakt.decoder.values.variables import Values
from nctakt.lists.declared.tools import NO_TOOL
from nctakt.lists.machine.transformations.kinematics import Kinematic
from nctakt.messages.path.transformations import (
    FIXED_TYPE_SIGNS,
    KIN_ID_DURING_TRANSFORMATION,
    KINEMATIC_NOT_POSSIBLE,
    NO_KINEMATIC_SELECTED,
    PTP_DURING_COMPENSATION,
    PTP_WITHOUT_TRANSFORMATION,
    TLC_AND_RTCP,
    TLC_DURING_COMPENSATION,
    TRANSFORMATION_DURING_COMPENSATION,
    TRANSFORMATION_DURING_PTP,
    UNKNOWN_KINEMATIC,
)
from nctakt.nc import tree
from nctakt.nc.meaning.coordinates import TransformationCommand, transformation_command


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
                yield from self._switch_on(command, (True, True), span, number)
            case "TRAFO OFF" | "RTCP OFF":
                if self._active.is_transformation:
                    yield from self.switch(0, command.shown, span, number)
            case "TLC ON":
                yield from self._correct_length(command, span, number)
            case "TLC OFF":
                if self._active.is_length_correction:
                    yield from self.switch(0, command.shown, span, number)
            case "ORI MODE":
                (mode,) = command.values
                assert isinstance(mode, str)
                self._values.state.orientation = mode
            case "PTP ON":
                yield from self._move_straight(command, span, number)
            case _:
                yield from self._move_transformed(command, span, number)

    def begin_program(self, span: Span) -> Generator[Command, Answer]:
        """Activate the default kinematics where the list says so (P-CHAN-00151)."""
        if self._transformations.is_on_at_start and any(self._active.selected):
            steps = self.selected_steps((True, True), "P-CHAN-00151", span)
            yield from self.switch_steps(steps, "P-CHAN-00151", span, 0)

    def end_program(self, span: Span) -> Generator[Command, Answer]:
        """Deactivate the kinematics where the list says so (P-CHAN-00152)."""
        is_compensated = self._values.state.path.compensation.is_active
        if self._transformations.is_off_at_end and self._active.is_transformation:
            if not is_compensated:
                yield from self.switch(0, "P-CHAN-00152", span, 0)

    # --- selection ------------------------------------------------------------------------------

    def _select(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Select kinematics; without values the default ones."""
        if self._active.is_transformation or self._environment.offsets.is_kinematic_suspended:
            self._values.fail(KIN_ID_DURING_TRANSFORMATION, span)
        if not command.values:
            self._active.selected = list(self._transformations.default_ids)
            return
        for step, value in enumerate(_of_both_steps(command)):
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
        """Execute ``#TRAFO [a, b]``: each step is activated or deactivated by its value."""
        values = _of_both_steps(command)
        selected = []
        for step, value in enumerate(values):
            selected.append((yield from self._identity(value, step, number)))
        if self._active.is_transformation and any(
            new not in (0, old) for new, old in zip(selected, self._active.selected, strict=True)
        ):
            self._values.fail(KIN_ID_DURING_TRANSFORMATION, span)
        self._active.selected = selected
        are_on = [value not in ("OFF", "NONE") for value in values]
        if any(are_on):
            yield from self._switch_on(command, are_on, span, number)
        elif self._active.is_transformation:
            yield from self.switch(0, command.shown, span, number)

    def _kinematic(self, step: int, shown: str, span: Span) -> Kinematic:
        """Return the selected kinematic of a step."""
        identity = self._active.selected[step]
        known = _known(self._transformations.steps[step])
        if identity == 0:
            self._values.fail(NO_KINEMATIC_SELECTED, span, command=shown, known=known)
        kinematic = self._active.kinematics.find(step, identity)
        if kinematic is None:
            self._values.fail(UNKNOWN_KINEMATIC, span, id=identity, known=known)
        kinematics = self._active.kinematics
        tool = self._values.state.tool.tool if step == 0 else NO_TOOL
        reason = kinematics.refusal(kinematics.with_tool(kinematic, tool))
        if reason is not None:
            self._values.fail(KINEMATIC_NOT_POSSIBLE, span, id=identity, reason=reason)
        if kinematic.universal is None and kinematic.type not in self._reported:
            self._reported.add(kinematic.type)
            self._values.warn(FIXED_TYPE_SIGNS, span, id=identity, type=kinematic.type)
        return kinematic

    def selected_map(self, shown: str, span: Span) -> int:
        """Return the number of the map of the selected kinematics; ``shown``: the command."""
        steps = self.selected_steps((True, True), shown, span)
        return self._active.map_of(steps, self._values.state.tool.tool)

    def selected_steps(self, are_on: Sequence[bool], shown: str, span: Span) -> Steps:
        """Return the selected kinematics of these steps, at least one."""
        used = [step for step in range(2) if are_on[step] and self._active.selected[step]]
        kinematics = {step: self._kinematic(step, shown, span) for step in used or [0]}
        return kinematics.get(0), kinematics.get(1)

    # --- switching ------------------------------------------------------------------------------

    def _switch_on(
        self,
        command: TransformationCommand,
        are_on: Sequence[bool],
        span: Span,
        number: int,
    ) -> Generator[Command, Answer]:
        """Activate the selected kinematics of these steps, and deactivate those of the others."""
        if self._active.is_straight:
            self._values.fail(TRANSFORMATION_DURING_PTP, span, command=command.shown)
        steps = self.selected_steps(are_on, command.shown, span)
        if self._active.is_length_correction:
            self._values.fail(TLC_AND_RTCP, span, command=command.shown)
        if [_id(one) for one in steps] != [_id(one) for one in self._active.steps]:
            yield from self.switch_steps(steps, command.shown, span, number)

    def switch_steps(
        self, steps: Steps, shown: str, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Activate kinematics with the present tool."""
        tool = self._values.state.tool.tool
        yield from self.switch(self._active.map_of(steps, tool), shown, span, number, steps)

    def switch(
        self,
        map_number: int,
        shown: str,
        span: Span,
        number: int,
        steps: Steps = NO_STEPS,
        plane: RotatingPlane | None = None,
    ) -> Generator[Command, Answer]:
        """Activate a map of ``steps`` or ``plane``, 0 for none, with the axes where they are.

        ``shown``: the command.
        """
        check_uncoupled(self._values, shown, span)
        self.check_uncompensated(shown, span)
        source = self._environment.source_id(span)
        positions = yield from self.stop(shown, span, number)
        state = self._values.state
        state.positions = yield from self._active.switch(
            map_number, steps, positions, source, number, plane
        )
        yield from self._values.tool.offsets(span, number)

    def check_uncompensated(self, shown: str, span: Span) -> None:
        """Raise ``DecodeError`` while the tool's radius is compensated."""
        if self._values.state.path.compensation.is_active:
            self._values.fail(TRANSFORMATION_DURING_COMPENSATION, span, command=shown)

    def stop(self, shown: str, span: Span, number: int) -> Generator[Command, Answer, list[float]]:
        """Let the path stop; return where it is, as it is programmed."""
        self._values.check_flush_allowed(shown, span)
        answer = yield PositionRequest(self._environment.source_id(span), number)
        assert isinstance(answer, tuple)
        return list(answer)

    def _correct_length(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Execute ``#TLC ON [dL]``."""
        if self._active.is_transformation:
            self._values.fail(TLC_AND_RTCP, span, command=command.shown)
        if self._values.state.path.compensation.is_active:
            self._values.fail(TLC_DURING_COMPENSATION, span)
        kinematic = self._kinematic(0, command.shown, span)
        difference = 0.0
        for value in command.values:
            assert isinstance(value, tree.Expression)
            difference = yield from self._values.evaluate(value, number)
        difference *= self._values.state.length_unit_mm
        map_number = self._active.map_of_length(kinematic, difference)
        yield from self.switch(map_number, command.shown, span, number)

    def _move_straight(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Execute ``#PTP ON``."""
        if self._values.state.path.compensation.is_active:
            self._values.fail(PTP_DURING_COMPENSATION, span)
        if not self._active.is_transformation:
            self._values.fail(PTP_WITHOUT_TRANSFORMATION, span)
        if not self._active.is_straight:
            self._values.state.positions = yield from self.stop(command.shown, span, number)
            yield from self._active.move_straight(True, self._environment.source_id(span), number)

    def _move_transformed(
        self, command: TransformationCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Execute ``#PTP OFF``."""
        if self._active.is_straight:
            self._values.state.positions = yield from self.stop(command.shown, span, number)
            yield from self._active.move_straight(False, self._environment.source_id(span), number)


def _of_both_steps(command: TransformationCommand) -> list[tree.Expression | str]:
    """Return the values of both steps; one that is left out is NONE."""
    return [*command.values, "NONE"][:2]


def _id(kinematic: Kinematic | None) -> int:
    """Return the ID of a kinematic, 0 for none."""
    return 0 if kinematic is None else kinematic.id


def _known(kinematics: Mapping[int, Kinematic]) -> str:
    """Return the IDs of kinematics as a list for a message."""
    identities: Sequence[int] = sorted(kinematics)
    return ", ".join(map(str, identities)) or NOTHING

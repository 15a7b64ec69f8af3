# SPDX-License-Identifier: MIT
"""``#MCS``, ``#WCS TO MCS``, ``#MCS TO WCS`` of the main program (MO-8).

Between ``#MCS ON`` and ``#MCS OFF`` programmed positions are those of the machine's axes: the
transformation, all coordinate systems, mirroring, rotation, scaling and all offsets are off, and
come back with OFF; the tool is the one that is active then. The conversions move nothing: they read
V.A.WCS and write V.A.MCS, or the other way round, with the offsets that are active.
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.frames.cs_commands import CsCommands
from nctakt.decoder.blocks.frames.frame_commands import FrameCommands
from nctakt.decoder.blocks.frames.transformation_commands import TransformationCommands
from nctakt.decoder.kinematics.selection import REASONS
from nctakt.decoder.state.geometry.contour_frame import ContourFrame
from nctakt.decoder.state.geometry.transformation import NO_STEPS
from nctakt.decoder.state.queued.commands import Answer, Command, PositionRequest
from nctakt.decoder.values.variables import Values
from nctakt.kernel.kinematics import map_rows
from nctakt.messages.path.transformations import (
    CONVERSION_DURING_TRANSFORMATION,
    MCS_DURING_PTP,
    POSITION_NOT_REACHED,
)
from nctakt.nc import tree
from nctakt.nc.meaning.coordinates import MachineCommand, machine_command


class MachineCoordinates:
    """These commands of one program."""

    def __init__(
        self, values: Values, systems: CsCommands, transformations: TransformationCommands
    ) -> None:
        self._values = values
        self._environment = values.environment
        self._offsets = values.environment.offsets
        self._systems = systems
        self._transformations = transformations
        self._frame = ContourFrame()
        self._contour = FrameCommands(values)

    def command(self, statement: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one command."""
        command = machine_command(statement)
        assert command is not None
        span = statement.span
        if command.name == "MCS ON":
            yield from self._enter(command, span, number)
        elif command.name == "MCS OFF":
            yield from self._leave(command, span, number)
        else:
            yield from self._convert(command, span, number)

    # --- machine coordinates --------------------------------------------------------------------

    def _enter(
        self, command: MachineCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Switch off everything between programmed positions and those of the axes."""
        self._check(command, span)
        if self._offsets.suspended is not None:
            return
        active = self._offsets.transformation
        steps, map_number = active.steps, active.number
        if map_number:
            yield from self._transformations.switch(0, command.shown, span, number)
        source = self._environment.source_id(span)
        yield from self._offsets.suspend(
            steps, map_number, command.is_without_tools, source, number
        )
        self._frame.adopt(self._values.state.frame)
        self._values.state.frame.adopt(ContourFrame())

    def _leave(
        self, command: MachineCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Switch everything on again that was active before, with the present tool."""
        self._check(command, span)
        suspended = self._offsets.suspended
        if suspended is None:
            return
        self._values.state.frame.adopt(self._frame)
        self._contour.leave_plane(self._values.state.path.plane, span)
        yield from self._offsets.resume(suspended, self._environment.source_id(span), number)
        if suspended.steps != NO_STEPS:
            yield from self._transformations.switch_steps(
                suspended.steps, command.shown, span, number
            )
        elif suspended.map_number:
            yield from self._transformations.switch(
                suspended.map_number, command.shown, span, number
            )
        yield from self._values.tool.offsets(span, number)

    def _check(self, command: MachineCommand, span: Span) -> None:
        if self._offsets.transformation.is_straight:
            self._values.fail(MCS_DURING_PTP, span, command=command.shown)
        self._transformations.check_uncompensated(command.shown, span)

    # --- conversion -----------------------------------------------------------------------------

    def _convert(
        self, command: MachineCommand, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Convert between V.A.WCS and V.A.MCS."""
        if self._offsets.transformation.is_active or self._offsets.systems.is_active:
            self._values.fail(CONVERSION_DURING_TRANSFORMATION, span, command=command.shown)
        system = None
        if command.system is not None:
            value = yield from self._values.evaluate(command.system, number)
            system = self._systems.stored(value, span)
        map_number = 0
        if command.has_kinematic:
            map_number = self._transformations.selected_map(command.shown, span)
        state = self._values.state
        if map_number:
            self._values.check_flush_allowed(command.shown, span)
            answer = yield PositionRequest(self._environment.source_id(span), number)
            assert isinstance(answer, tuple)
            state.positions = list(answer)
        to_machine = command.name == "WCS TO MCS"
        source, target = (state.wcs, state.mcs) if to_machine else (state.mcs, state.wcs)
        given = [source.get(axis, 0.0) for axis in range(len(state.positions))]
        result, answer_code = self._offsets.converted(
            given, state.positions, system, map_number, to_machine
        )
        if answer_code != map_rows.REACHED:
            reason = REASONS[answer_code]
            self._values.fail(POSITION_NOT_REACHED, span, reason=reason)
        target.update(enumerate(result))

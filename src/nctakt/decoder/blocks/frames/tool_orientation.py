# SPDX-License-Identifier: MIT
"""``#TOOL ORI CS`` and ``#ECS``: the tool and the axes of the coordinate system (MO-8).

With ``#TOOL ORI CS`` the rotary axes turn the tool along an axis of the coordinate system. The axis
is that of P-CHAN-00188, in the active ``#CS`` or else in the machine; P-CHAN-00189 chooses between
the two positions of the rotary axes that give the direction. They go there in rapid motion: with a
transformation about the tip, without one with the linear axes at rest. ``#ECS`` is the inverse: a
system with the third axis along the present tool direction.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.blocks.block_decoder import BlockDecoder
from nctakt.decoder.blocks.frames.transformation_commands import TransformationCommands
from nctakt.decoder.kinematics.selection import REASONS
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.kernel.kinematics import map_rows
from nctakt.messages.path.transformations import NO_TOOL_ORIENTATION, POSITION_NOT_REACHED
from nctakt.nc.vocabulary.functions import RAPID

_SHOWN = "#TOOL ORI CS"
#: P-CHAN-00189: which of two positions of the rotary axes.
_BY_ITSELF, _SHORTEST, _WITHIN_LIMITS, _FIRST, _SECOND = range(5)

_TWO = 2


class ToolOrientation:
    """These commands in one program."""

    def __init__(
        self, values: Values, transformations: TransformationCommands, blocks: BlockDecoder
    ) -> None:
        self._values = values
        self._environment = values.environment
        self._transformations = transformations
        self._active = values.environment.offsets.transformation
        self._blocks = blocks
        self._last = 0
        self._parameters = values.environment.parameters.transformations

    def command(self, span: Span, number: int) -> Generator[Command, Answer]:
        """Execute the command."""
        self._transformations.check_uncompensated(_SHOWN, span)
        state = self._values.state
        steps = self._active.steps
        if not self._active.is_transformation:
            steps = self._transformations.selected_steps((True, True), _SHOWN, span)
        kinematic = steps[0] or steps[1]
        assert kinematic is not None
        rotary = self._active.kinematics.chain(kinematic).rotary
        if len(rotary) != _TWO:
            self._values.fail(NO_TOOL_ORIENTATION, span, id=kinematic.id)
        self._last = rotary[-1].axis
        map_number = self._active.map_of(steps, state.tool.tool)
        yield from self._blocks.moved.request(list(self._environment.axis_numbers), span, number)
        target = self._target(map_number, span)
        content = BlockContent()
        content.axes = self._blocks.orientation.words_to(target, content.path.offset_kinds, span)
        motion = state.motion
        state.motion = RAPID
        yield from self._blocks.motion(content, span, number)
        state.motion = motion

    def effector(self, span: Span, number: int) -> Generator[Command, Answer, list[float]]:
        """Return the direction of the tool for ``#ECS ON``.

        Without a transformation it is that of the selected kinematic's rotary axes that turn the
        tool; the linear axes are not turned.
        """
        steps = self._active.steps
        if not self._active.is_transformation:
            steps = self._transformations.selected_steps((True, True), "#ECS ON", span)
        yield from self._blocks.moved.request(list(self._environment.axis_numbers), span, number)
        axes = self._active.to_axes(self._values.state.positions)
        if self._active.is_transformation:
            return self._active.tool_direction(self._active.number, axes)
        kinematic = steps[0] or steps[1]
        assert kinematic is not None
        return self._active.tool_direction(self._active.map_of_length(kinematic, 0.0), axes)

    def _target(self, map_number: int, span: Span) -> list[float]:
        """Return the positions to go to."""
        axis = self._parameters.tool_axis or MAIN_AXES
        vector = self._environment.offsets.systems.direction(axis - 1)
        present = self._values.state.positions
        programmed = list(present)
        if not self._active.is_transformation:
            programmed, _ = self._active.mapped(map_number, present, present, False)
        aimed, answer = self._active.aim(map_number, vector, programmed)
        if answer != map_rows.REACHED:
            self._values.fail(POSITION_NOT_REACHED, span, reason=REASONS[answer])
        other = self._active.other_aim(map_number, aimed)
        nearer, further = (self._of_axes(map_number, one, present) for one in (aimed, other))
        return self._chosen(nearer, further)

    def _of_axes(
        self, map_number: int, programmed: list[float], present: Sequence[float]
    ) -> list[float]:
        """Return positions as the active transformation has them."""
        if self._active.is_transformation:
            return programmed
        axes, _ = self._active.mapped(map_number, programmed, present, True)
        return [*present[:MAIN_AXES], *axes[MAIN_AXES:]]

    def _chosen(self, nearer: list[float], further: list[float]) -> list[float]:
        """Return one of two solutions, by P-CHAN-00189."""
        solution = self._parameters.solution
        if solution == _WITHIN_LIMITS:
            return further if self._is_within(further) and not self._is_within(nearer) else nearer
        if solution in (_BY_ITSELF, _SHORTEST):
            return nearer
        first, second = sorted((nearer, further), key=self._inclination, reverse=True)
        return first if solution == _FIRST else second

    def _is_within(self, positions: Sequence[float]) -> bool:
        """Whether the rotary axes stay within their software limits."""
        limits = self._values.state.software_limits
        for index, axis in enumerate(self._environment.axes):
            low, high = limits.of(axis, index)
            if not axis.is_linear and not axis.is_modulo and not low <= positions[index] <= high:
                return False
        return True

    def _inclination(self, positions: Sequence[float]) -> float:
        """Return the angle of the rotary axis nearest to the tool, within -180° … 180°."""
        return arithmetic.within(positions[self._last], -180.0, 360.0)

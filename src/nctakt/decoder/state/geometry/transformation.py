# SPDX-License-Identifier: MIT
"""The active transformation of a channel in the decoder: positions of the axes <-> programmed ones.

While a transformation is active the decoder's positions are those of the tool's tip in the machine
(MCS) and of the rotary axes; offsets and coordinate systems act on them. Switching moves no axis:
the positions are recomputed from those of the axes, by the maps that the ticks use, to the bit.
Under ``#PTP`` the positions stay the same, and motions are those of the axes.

Out: ``SetTransformation`` commands, positions, and the first axis that leaves its software limits
during a block.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence

from nctakt.decoder.kinematics import rotating_planes
from nctakt.decoder.kinematics.chain import ORIGIN, Chain, Joint, map_values
from nctakt.decoder.kinematics.rotating_planes import RotatingPlane
from nctakt.decoder.kinematics.selection import ChannelAxes, ChannelKinematics
from nctakt.decoder.kinematics.transformed_travel import TransformedTravel
from nctakt.decoder.state.queued.commands import Command, SetTransformation
from nctakt.kernel.axes.transformations import Transformations
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.kinematics import map_rows
from nctakt.lists.declared.tools import NO_TOOL, Tool
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.transformations.kinematics import Kinematic

#: The kinematics of both steps; ``None``: the step does nothing.
Steps = tuple[Kinematic | None, Kinematic | None]
NO_STEPS: Steps = (None, None)


class ActiveTransformation:
    """The transformation of one channel, one of its ``kinematics``.

    ``number``: the active map, 0 for none; ``axis_check``: against the limits of
    the axes. ``plane``: the one of ``#FACE`` or ``#CYL`` that is active.
    ``steps``: the active kinematics that the map is made of, ``NO_STEPS`` under ``#TLC``.
    ``is_straight``: the axes go straight (``#PTP``). ``selected``: the IDs of both steps, 0: none.
    """

    def __init__(self, kinematics: ChannelKinematics, transformations: Transformations) -> None:
        self.kinematics = kinematics
        self._transformations = transformations
        self._maps = transformations.maps
        self._has_axis = transformations.has_axis
        self._places: frozenset[int] = frozenset()
        self.number = 0
        self.steps: Steps = NO_STEPS
        self.is_straight = False
        self.plane: RotatingPlane | None = None
        self.selected = list(kinematics.transformations.default_ids)
        self.exchange(kinematics.axes)

    def exchange(self, axes: ChannelAxes) -> None:
        """Take the axes of the channel; no map is active."""
        self.kinematics.axes = axes
        self._axes = axes.members
        count = max(1, len(self._axes))
        self._given = doubles(count)
        self._near = doubles(count)
        self._present = doubles(count)
        self._result = doubles(count)
        self._standing: tuple[list[float], list[float]] = ([], [])
        self.axis_check = TransformedTravel(len(self._axes), self._transformations)
        for slot, (low, high) in enumerate(axes.limits):
            self.axis_check.limit(slot, low, high)

    @property
    def is_active(self) -> bool:
        """Whether programmed positions are not those of the axes."""
        return self.number > 0

    @property
    def is_transformation(self) -> bool:
        """Whether a kinematic is active (``#TRAFO``)."""
        return self.steps != NO_STEPS

    @property
    def is_length_correction(self) -> bool:
        """Whether the tool's length is corrected (``#TLC``)."""
        return self.number > 0 and self.plane is None and self.steps == NO_STEPS

    def is_linear(self, index: int, axis: AxisConfiguration) -> bool:
        """Return whether an axis is programmed in mm: a linear one, or that of a plane."""
        return axis.is_linear or (self.plane is not None and index == self.plane.rotary)

    def has_axis(self, axis: int) -> bool:
        """Return whether an axis of the channel belongs to the active transformation."""
        return axis in self._places

    def with_moved(self, names: list[str]) -> list[str]:
        """Return names of axes with those that the active transformation moves with them."""
        every = self.kinematics.axes.names
        return names + [every[i] for i in sorted(self._places) if every[i] not in names]

    # --- positions ------------------------------------------------------------------------------

    def of_axes(self, positions: Sequence[float]) -> list[float]:
        """Return positions of the axes as programmed ones."""
        if self.number == 0:
            return list(positions)
        self._give(positions)
        for i, position in enumerate(positions):
            self._near[i] = position
        self._maps.forward(self.number, self._given, self._near, self._result)
        self._standing = (list(self._result), list(positions))
        return list(self._result)

    def to_axes(self, positions: Sequence[float]) -> list[float]:
        """Return programmed positions as those of the axes, the inverse of ``of_axes``.

        Those that ``of_axes`` returned last lead back to the same numbers.
        """
        if self.number == 0:
            return list(positions)
        if self._standing[0] == list(positions):
            return list(self._standing[1])
        self._give(positions)
        self._maps.inverse(self.number, self._given, self._near, self._result)
        for i in range(len(positions)):
            self._near[i] = self._result[i]
        return list(self._result)

    def mapped(
        self, number: int, positions: Sequence[float], near: Sequence[float], to_axes: bool
    ) -> tuple[list[float], int]:
        """Return positions by a map that need not be active, and ``REACHED`` or why not.

        Of two solutions that nearer to the axes' positions ``near``.
        """
        if number == 0:
            return list(positions), map_rows.REACHED
        self._give(positions)
        for i, position in enumerate(near):
            self._present[i] = position
        answer = map_rows.REACHED
        if to_axes:
            answer = self._maps.inverse(number, self._given, self._present, self._result)
        else:
            self._maps.forward(number, self._given, self._present, self._result)
        return list(self._result), answer

    def _give(self, positions: Sequence[float]) -> None:
        for i, position in enumerate(positions):
            self._given[i] = position

    def aim(
        self, number: int, vector: Sequence[float], near: Sequence[float]
    ) -> tuple[list[float], int]:
        """Return programmed positions with the tool along a vector, else those of ``near``.

        By a map that need not be active; of two solutions the nearer one. And ``REACHED`` or why
        there is none.
        """
        self._give(vector)
        for i, position in enumerate(near):
            self._present[i] = position
            self._result[i] = position
        answer = self._maps.aim(number, self._given, self._present, self._result)
        return list(self._result), answer

    def other_aim(self, number: int, positions: Sequence[float]) -> list[float]:
        """Return the other solution of the last ``aim``, in ``positions``."""
        for i, position in enumerate(positions):
            self._result[i] = position
        self._maps.other_aim(number, self._result)
        return list(self._result)

    # --- maps -----------------------------------------------------------------------------------

    def map_of(self, steps: Steps, tool: Tool) -> int:
        """Return the number of the map of kinematics with a tool; 0 without any.

        The tool's length counts in the first of them.
        """
        number = 0
        for step, kinematic in reversed(list(enumerate(steps))):
            if kinematic is not None:
                has_tool = step == 0 or steps[0] is None
                values = self.kinematics.map_values(step, kinematic, tool if has_tool else NO_TOOL)
                values[map_rows.SECOND_STEP] = number
                number = self._maps.add(values)
        return number

    def map_of_plane(self, plane: RotatingPlane, tool: Mapping[int, float]) -> int:
        """Return the number of the map of a plane with the offsets of a tool."""
        return self._maps.add(rotating_planes.map_values(plane, self._axes, tool))

    def map_of_length(self, kinematic: Kinematic, difference: float) -> int:
        """Return the number of the map that shifts the linear axes along the tool, by mm.

        The tool is turned by the rotary axes after the linear ones, about its clamp.
        """
        chain = self.kinematics.chain(kinematic)
        last = max(k for k, joint in enumerate(chain.joints) if not joint.is_rotary)
        joints = tuple(
            Joint(joint.axis, joint.is_rotary, joint.direction)
            for k, joint in enumerate(chain.joints)
            if k > last or not joint.is_rotary
        )
        shift = Chain(joints, ORIGIN, chain.tool_direction)
        return self._maps.add(map_values(shift, self._axes, difference))

    def tool_direction(self, number: int, axes: Sequence[float]) -> list[float]:
        """Return the vector from the tip to the clamp, of length 1, for positions of the axes."""
        self._give(axes)
        self._maps.direction(number, self._given, self._result)
        return list(self._result[:3])

    # --- commands -------------------------------------------------------------------------------

    def begin_program(self) -> Iterator[Command]:
        """Yield the command that deactivates the transformation left by an earlier program."""
        self._activate(0, NO_STEPS)
        self.selected = list(self.kinematics.transformations.default_ids)
        if self._maps.used > 1:
            yield SetTransformation(0, 0, 0, 0)

    def switch(
        self,
        number: int,
        steps: Steps,
        positions: Sequence[float],
        source: int,
        block: int,
        plane: RotatingPlane | None = None,
    ) -> Generator[Command, None, list[float]]:
        """Activate a map of ``steps`` or of a plane, 0 for none.

        Return ``positions`` as programmed from here on.
        """
        axes = self.to_axes(positions)
        self._activate(number, steps)
        self.plane = plane
        self.axis_check.start_at(axes)
        yield SetTransformation(source, block, number, number)
        return self.of_axes(axes)

    def change_tool(
        self, tool: Tool, positions: Sequence[float], source: int, block: int
    ) -> Generator[Command, None, list[float]]:
        """Use another tool for the kinematic; return as ``switch``."""
        is_straight = self.is_straight
        number = self.map_of(self.steps, tool)
        if number == self.number:
            return list(positions)
        result = yield from self.switch(number, self.steps, positions, source, block)
        yield from self.move_straight(is_straight, source, block)
        return result

    def change_tool_of_plane(
        self, tool: Mapping[int, float], positions: Sequence[float], source: int, block: int
    ) -> Generator[Command, None, list[float]]:
        """Use the offsets of another tool for the plane; return as ``switch``."""
        assert self.plane is not None
        number = self.map_of_plane(self.plane, tool)
        if number == self.number:
            return list(positions)
        return (yield from self.switch(number, NO_STEPS, positions, source, block, self.plane))

    def move_straight(self, is_straight: bool, source: int, block: int) -> Iterator[Command]:
        """Let the axes go straight to the ends of blocks, or the tool again (``#PTP``)."""
        if self.is_straight != is_straight:
            self.is_straight = is_straight
            of_segments = 0 if is_straight else self.number
            yield SetTransformation(source, block, self.number, of_segments)

    def _activate(self, number: int, steps: Steps) -> None:
        """Note the active map."""
        self.number = number
        self.steps = steps
        self.is_straight = False
        self.plane = None
        self._standing = ([], [])
        self.axis_check.number = number
        places = range(len(self._axes))
        self._places = frozenset(i for i in places if number and self._has_axis(number, i))

# SPDX-License-Identifier: MIT
"""The active transformation of a channel in the decoder: positions of the axes <-> programmed ones.

While a transformation is active the decoder's positions are those of the tool's tip in the machine
(MCS) and of the rotary axes; offsets and coordinate systems act on them. Switching moves no axis:
the positions are computed anew from those of the axes, by the maps that the ticks use, to the bit.
Under ``#PTP`` the positions stay what they are, and motions are those of the axes.

Out: ``SetTransformation`` commands, positions, and the first axis that leaves its software limits
on the way of a block.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence

from nctakt.decoder.kinematics.chain import ORIGIN, Chain, Joint, map_values
from nctakt.decoder.kinematics.selection import ChannelKinematics
from nctakt.decoder.kinematics.transformed_way import TransformedWay
from nctakt.decoder.state.commands import Command, SetTransformation
from nctakt.kernel.axes.transformations import Transformations
from nctakt.lists.declared.tools import Tool
from nctakt.lists.machine.kinematics import Kinematic


class ActiveTransformation:
    """The transformation of one channel, one of its ``kinematics``.

    ``number``: the active map, 0 for none; ``axis_check``: against the limits of
    the axes.
    ``kinematic``: what the map is made of, ``None`` under ``#TLC`` and without a transformation.
    ``is_straight``: the axes go straight (``#PTP``). ``selected``: the IDs of both steps, 0: none.
    """

    def __init__(self, kinematics: ChannelKinematics, transformations: Transformations) -> None:
        axes = kinematics.axes.members
        self.kinematics = kinematics
        self._axes = axes
        self._maps = transformations.maps
        self._has_axis = transformations.has_axis
        room = 8 * max(1, len(axes))
        self._given = memoryview(bytearray(room)).cast("d")
        self._near = memoryview(bytearray(room)).cast("d")
        self._result = memoryview(bytearray(room)).cast("d")
        self._places: frozenset[int] = frozenset()
        self.number = 0
        self.kinematic: Kinematic | None = None
        self.is_straight = False
        self.selected = list(kinematics.transformations.default_ids)
        self.axis_check = TransformedWay(len(axes), transformations)

    @property
    def is_active(self) -> bool:
        """Whether programmed positions are not those of the axes."""
        return self.number > 0

    @property
    def is_transformation(self) -> bool:
        """Whether a kinematic is active (``#TRAFO``)."""
        return self.kinematic is not None

    @property
    def is_length_correction(self) -> bool:
        """Whether the tool's length is corrected (``#TLC``)."""
        return self.number > 0 and self.kinematic is None

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
        return list(self._result)

    def to_axes(self, positions: Sequence[float]) -> list[float]:
        """Return programmed positions as those of the axes, the inverse of ``of_axes``."""
        if self.number == 0:
            return list(positions)
        self._give(positions)
        self._maps.inverse(self.number, self._given, self._near, self._result)
        for i in range(len(positions)):
            self._near[i] = self._result[i]
        return list(self._result)

    def _give(self, positions: Sequence[float]) -> None:
        for i, position in enumerate(positions):
            self._given[i] = position

    # --- maps -----------------------------------------------------------------------------------

    def map_of(self, kinematic: Kinematic, tool: Tool) -> int:
        """Return the number of the map of a kinematic with a tool."""
        return self._maps.add(self.kinematics.map_values(0, kinematic, tool, 0.0))

    def map_of_length(self, kinematic: Kinematic, difference: float) -> int:
        """Return the number of the map that shifts the linear axes along the tool, by mm.

        The tool is turned by the rotary axes behind the linear ones, about its clamp.
        """
        chain = self.kinematics.chain(kinematic, {})
        last = max(k for k, joint in enumerate(chain.joints) if not joint.is_rotary)
        joints = tuple(
            Joint(joint.axis, joint.is_rotary, joint.direction)
            for k, joint in enumerate(chain.joints)
            if k > last or not joint.is_rotary
        )
        shift = Chain(joints, ORIGIN, chain.tool_direction)
        return self._maps.add(map_values(shift, self._axes, difference))

    # --- commands -------------------------------------------------------------------------------

    def begin_program(self) -> Iterator[Command]:
        """Yield the command that deactivates what an earlier program has left."""
        self._activate(0)
        self.selected = list(self.kinematics.transformations.default_ids)
        if self._maps.used > 1:
            yield SetTransformation(0, 0, 0, 0)

    def switch(
        self, number: int, positions: Sequence[float], source: int, block: int
    ) -> Generator[Command, None, list[float]]:
        """Activate a map, 0 for none; return ``positions`` as they are programmed from here on."""
        axes = self.to_axes(positions)
        self._activate(number)
        yield SetTransformation(source, block, number, number)
        return self.of_axes(axes)

    def change_tool(
        self, tool: Tool, positions: Sequence[float], source: int, block: int
    ) -> Generator[Command, None, list[float]]:
        """Let another tool be the one of the kinematic; return as ``switch``."""
        kinematic, is_straight = self.kinematic, self.is_straight
        assert kinematic is not None
        number = self.map_of(kinematic, tool)
        if number == self.number:
            return list(positions)
        result = yield from self.switch(number, positions, source, block)
        self.kinematic = kinematic
        yield from self.move_straight(is_straight, source, block)
        return result

    def move_straight(self, is_straight: bool, source: int, block: int) -> Iterator[Command]:
        """Let the axes go straight to the ends of blocks, or the tool again (``#PTP``)."""
        if self.is_straight != is_straight:
            self.is_straight = is_straight
            of_segments = 0 if is_straight else self.number
            yield SetTransformation(source, block, self.number, of_segments)

    def _activate(self, number: int) -> None:
        """Note the active map."""
        self.number = number
        self.kinematic = None
        self.is_straight = False
        self.axis_check.number = number
        places = range(len(self._axes))
        self._places = frozenset(i for i in places if number and self._has_axis(number, i))

# SPDX-License-Identifier: MIT
"""Single-axis commands of a checked cycle -> statements that run in the tick (RC-405 … RC-410).

Units are those of the cycle's definition: positions and feeds of linear axes in mm or inch, feeds
per minute, in the unit of P-CHAN-00108 under G71. Rotary axes: degrees, degrees per minute.
"""

from __future__ import annotations

from nctakt.decoder.axis_limits import feed_unit
from nctakt.decoder.values.expressions import ExpressionBuilder
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.cycles import actions
from nctakt.kernel.cycles.expressions import Constant, Expression
from nctakt.kernel.cycles.instructions import Statement
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.nc import tree
from nctakt.nc.meaning.cost import word_steps
from nctakt.nc.vocabulary.single_axes.axis_commands import (
    DIRECTIONS,
    OFFSETS,
    AxisCommand,
    AxisTraits,
    read_axis_command,
)


class ActionBuilder:
    """Builds the single-axis commands of one cycle; ``axes``: those that it names."""

    def __init__(self, values: Values, expressions: ExpressionBuilder) -> None:
        self._environment = values.environment
        self._state = values.state
        self._expressions = expressions
        self._feeds: dict[str, actions.FeedMemory] = {}
        self.axes: dict[str, None] = {}

    def build(self, bracket: tree.BracketCommand) -> Statement:
        """Return the statement of one command."""
        command, wrong = read_axis_command(bracket)
        assert not wrong, wrong
        self.axes[command.axis] = None
        source = self._environment.source_id(bracket.span)
        cost = word_steps(bracket, self._environment.names)
        nature = self._environment.names.axis(command.axis)
        assert nature is not None
        if command.stops:
            return actions.StopAxis(nature.number, source, cost)
        speed = self._speed(command)
        direction, has_direction = self._direction(command, nature)
        moving = (nature.number, speed, direction, has_direction, command.buffered, source, cost)
        if command.position is None:
            return actions.RunAxis(*moving)
        position = self._expressions.build(command.position).node
        offsets = 0
        if command.offset:
            offsets = (
                codes.ALL_OFFSETS if command.offset == "ALL" else 1 << OFFSETS.index(command.offset)
            )
        unit = self._state.length_unit_mm if nature.is_linear else 1.0
        target = actions.AxisTarget(position, unit, bool(command.absolute), offsets)
        return actions.MoveAxis(*moving, target)

    def _speed(self, command: AxisCommand) -> actions.Speed:
        """Return the speed: FEED of this command, of an earlier one with G01, or the rapid
        speed.
        """
        axis = self._axis(command.axis)
        memory = self._feeds.setdefault(command.axis, actions.FeedMemory())
        if command.feed is not None and not command.has_idle_feed:
            expression = self._expressions.build(command.feed).node
            listed_mm_min = self._environment.parameters.program_start.feed_unit_mm_min
            unit = feed_unit(axis, self._state, listed_mm_min)
            return actions.Feed(axis.max_speed, memory, expression, unit)
        if command.rapid is False:
            return actions.EarlierFeed(axis.max_speed, memory)
        return actions.Speed(axis.rapid_speed, memory)

    def _direction(self, command: AxisCommand, traits: AxisTraits) -> tuple[Expression, bool]:
        """DIR and whether it counts: for a motion to a position, only on a modulo axis."""
        direction = command.direction
        if direction is None or (command.position is not None and not traits.is_modulo):
            return Constant(0.0), False
        if isinstance(direction, tree.Name):
            return Constant(DIRECTIONS[direction.name]), True
        return self._expressions.build(direction).node, True

    def _axis(self, name: str) -> AxisConfiguration:
        return self._environment.axes[self._environment.axis_numbers[name]]

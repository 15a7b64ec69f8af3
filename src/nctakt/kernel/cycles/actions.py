# SPDX-License-Identifier: MIT
"""Statements of realtime cycles that move a single axis (RC-405 … RC-408).

A statement computes feed, position and direction, looks for room for an action (P-CHAN-00480), and
gives the command to ``single_axes.py``, which accepts it or names the message that refuses it: a
fault of the cycle. Positions go down in mm or degrees of ACS, speeds in mm/s or degrees/s. The
numbers of 50967 are those of ``nc/vocabulary/single_axes/axis_commands.py`` (``REFUSALS``).
"""

from __future__ import annotations

import math

from nctakt.kernel import codes
from nctakt.kernel.cycles import instructions
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.cycles.instructions import Counted


class FeedMemory:
    """The FEED that one axis got last in one cycle, in mm/s or degrees/s; 0 before the first."""

    def __init__(self) -> None:
        self.speed_v = 0.0


class Speed:
    """The speed of a command; the base is the rapid speed of the axis."""

    def __init__(self, highest_v: float, memory: FeedMemory) -> None:
        self.highest_v = highest_v
        self.memory = memory

    def value(self, context: Context) -> float:
        """Speed with the sign of FEED, at most that of the axis; a fault is in the context."""
        return self.highest_v


class Feed(Speed):
    """FEED of the command itself; ``unit_v`` is what 1 means."""

    def __init__(
        self, highest_v: float, memory: FeedMemory, expression: Expression, unit_v: float
    ) -> None:
        super().__init__(highest_v, memory)
        self.expression = expression
        self.unit_v = unit_v

    def value(self, context: Context) -> float:
        speed_v = self.expression.value(context) * self.unit_v
        if speed_v == 0.0:
            context.fail(50967, 0, 0.0, codes.FEED_ZERO)
        elif speed_v - speed_v != 0.0:
            context.fail(50879, 0, 0.0, speed_v)
        speed_v = max(-self.highest_v, min(speed_v, self.highest_v))
        self.memory.speed_v = speed_v
        return speed_v


class EarlierFeed(Speed):
    """G01 without FEED: that of an earlier command for the axis."""

    def value(self, context: Context) -> float:
        if self.memory.speed_v == 0.0:
            context.fail(50967, 0, 0.0, codes.FEED_UNKNOWN)
        return math.fabs(self.memory.speed_v)


class AxisStatement(Counted):
    """Base of the commands for one axis, ``axis`` being its number in the machine."""

    def __init__(self, axis: int, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.axis = axis


def refuse(statement: AxisStatement, context: Context, message: int, value: float) -> int:
    """Stop the cycle with ``message``; ``value``: the requested value. Return 1."""
    context.fail(message, statement.source, statement.axis, value)
    return 1


def complete(statement: AxisStatement, context: Context, value: float) -> int:
    """Complete a fault by its source; return 0 without one. ``value`` has to be finite."""
    if context.fault:
        if context.fault == 50967:
            context.fault_a = statement.axis
        return instructions.stop(statement, context)
    if value - value != 0.0:
        context.fail(50879, statement.source, 0.0, value)
        return 1
    return 0


def has_room_for_action(statement: AxisStatement, context: Context, is_buffered: int) -> int:
    """Return whether the cycle may open one more action (RC-408, P-CHAN-00480)."""
    open_count = context.single_axes.open_count(context.owner)
    if not is_buffered:
        open_count -= context.single_axes.open_on(statement.axis, context.owner)
    open_count += context.spindles.open_count(context.serial)
    return 1 if open_count < context.max_open_actions else 0


def sign(value: float) -> int:
    """Sign of a number: 1, 0 or -1."""
    if value > 0.0:
        return 1
    return -1 if value < 0.0 else 0


def direction_of(statement: AxisStatement, context: Context, value: float) -> int:
    """The direction that a value of DIR means; any but 1, 0 and -1 is a fault (RC-405)."""
    if value != sign(value) and context.fault == 0:
        context.fail(50967, statement.source, statement.axis, codes.DIRECTION_UNKNOWN)
    return sign(value)


class StopAxis(AxisStatement):
    """``X[INDP STOP]``."""

    def run(self, context: Context) -> int:
        if instructions.begin(self, context):
            return 1
        message = context.single_axes.stop(self.axis, context.owner)
        if message:
            return refuse(self, context, message, 0.0)
        return 0


class MovingStatement(AxisStatement):
    """Base of the commands that move; ``has_direction``: DIR is given."""

    def __init__(
        self,
        axis: int,
        speed: Speed,
        direction: Expression,
        has_direction: bool,
        is_buffered: bool,
        source: int,
        cost: int,
    ) -> None:
        super().__init__(axis, source, cost)
        self.speed = speed
        self.direction = direction
        self.has_direction = has_direction
        self.is_buffered = is_buffered

    def restart(self) -> None:
        """Forget the FEED of earlier commands (START)."""
        self.speed.memory.speed_v = 0.0


class AxisTarget:
    """``G90|G91 POS=p``: where a command moves its axis to, or how far.

    ``unit_d``: mm or degrees that a position of 1 means. ``offsets``: which active offsets of the
    axis are added to a target of G90, as bits (``coordinates.Offsets.sum_of``).
    """

    def __init__(
        self, position: Expression, unit_d: float, is_absolute: bool, offsets: int
    ) -> None:
        self.position = position
        self.unit_d = unit_d
        self.is_absolute = is_absolute
        self.offsets = offsets


class MoveAxis(MovingStatement):
    """``X[INDP G90|G91 … POS=p]``."""

    def __init__(
        self,
        axis: int,
        speed: Speed,
        direction: Expression,
        has_direction: bool,
        is_buffered: bool,
        source: int,
        cost: int,
        target: AxisTarget,
    ) -> None:
        super().__init__(axis, speed, direction, has_direction, is_buffered, source, cost)
        self.target = target

    def run(self, context: Context) -> int:
        if instructions.begin(self, context):
            return 1
        speed_v = self.speed.value(context)
        position_d = self.target.position.value(context) * self.target.unit_d
        direction = codes.SHORTEST
        if self.has_direction:
            direction = direction_of(self, context, self.direction.value(context))
        if complete(self, context, position_d + speed_v):
            return 1
        if speed_v < 0.0:
            return refuse(self, context, 50967, codes.FEED_NEGATIVE)
        if not has_room_for_action(self, context, self.is_buffered):
            context.fail(51028, self.source, context.max_open_actions, 0.0)
            return 1
        return self.command(context, position_d, speed_v, direction)

    def command(self, context: Context, position_d: float, speed_v: float, direction: int) -> int:
        """Give the command; return 1 if it is refused, which is a fault."""
        context.single_axes.order(self.source, context.serial)
        if self.target.is_absolute:
            position_d += context.single_axes.axes.offsets.sum_of(self.axis, self.target.offsets)
            message = context.single_axes.move_to(
                self.axis, position_d, speed_v, self.is_buffered, direction, context.owner
            )
        else:
            message = context.single_axes.move_by(
                self.axis, position_d, speed_v, self.is_buffered, context.owner
            )
        if message:
            return refuse(self, context, message, position_d)
        return 0


class RunAxis(MovingStatement):
    """Endless motion ``X[INDP FEED=f …]``, in the direction of DIR or of FEED's sign."""

    def run(self, context: Context) -> int:
        if instructions.begin(self, context):
            return 1
        speed_v = self.speed.value(context)
        direction = sign(speed_v)
        if self.has_direction:
            direction = direction_of(self, context, self.direction.value(context))
        if complete(self, context, speed_v):
            return 1
        if not has_room_for_action(self, context, self.is_buffered):
            context.fail(51028, self.source, context.max_open_actions, 0.0)
            return 1
        speed_v = math.fabs(speed_v)
        context.single_axes.order(self.source, context.serial)
        message = context.single_axes.run_endless(
            self.axis, speed_v, direction, self.is_buffered, context.owner
        )
        if message:
            return refuse(self, context, message, speed_v)
        return 0

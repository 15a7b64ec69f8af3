# SPDX-License-Identifier: MIT
"""A spindle's job in a realtime cycle: complete, in this tick, without waiting (RC-404, RC-408)."""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.cycles import instructions
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.cycles.instructions import Counted


class CommandSpindle(Counted):
    """M3, M4, M5 or M19 of one spindle; revolutions per minute, degrees.

    60331: the spindle takes no job in this tick. 51028: the cycle has no room for another action.
    20991, 20007: the speed is below 0, or 0 on the way to a position.
    """

    def __init__(
        self,
        spindle: int,
        function: int,
        speed: Expression,
        position: Expression,
        direction: int,
        ticks: int,
        source: int,
        cost: int,
    ) -> None:
        super().__init__(source, cost)
        self.spindle = spindle
        self.function = function
        self.speed = speed
        self.position = position
        self.direction = direction
        self.ticks = ticks

    def run(self, context: Context) -> int:
        speed = instructions.evaluate(self, self.speed, context)
        if context.fault:
            return 1
        position = self.position.value(context)
        if context.fault == 0 and position - position != 0.0:
            context.fail(50879, self.source, 0.0, position)
        if speed < 0.0:
            context.fail(20991, self.source, speed, 0.0)
        if self.function == codes.SPINDLE_POSITION and speed == 0.0:
            context.fail(20007, self.source, 0.0, 0.0)
        if context.fault:
            return instructions.stop(self, context)
        return self.command_spindle(context, 6.0 * speed, position)

    def command_spindle(self, context: Context, speed_v: float, position: float) -> int:
        """Give the job to the spindle, or report the message that refuses it."""
        if not context.spindles.is_ready(self.spindle, context.tick):
            number = context.spindles.first_number + self.spindle
            context.fail(60331, self.source, number, 0.0)
            return 1
        if not context.spindles.has_job(self.spindle, context.serial):
            open_count = context.spindles.open_count(context.serial)
            open_count += context.single_axes.open_count(context.owner)
            if open_count >= context.max_open_actions:
                context.fail(51028, self.source, context.max_open_actions, 0.0)
                return 1
        context.spindles.command(
            self.spindle,
            self.function,
            speed_v,
            position,
            self.direction,
            context.serial,
            context.tick,
        )
        context.spindles.record_job(self.spindle, self.source, context.serial)
        context.spindles.hand_over(self.spindle, context.tick + self.ticks)
        return 0

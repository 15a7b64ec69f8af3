# SPDX-License-Identifier: MIT
"""The main spindle of a channel as an axis of its path (``#CAX``, ``S[PUTAX]``).

The axis begins at the angle of the spindle, and the spindle turns with it; it takes no job until
the channel has given the axis away again (``tick/axis_exchange.py``).
"""

from __future__ import annotations

from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.bounds import check_index


class CAxis:
    """An axis and a spindle that are one drive; ``axis`` is -1 if no spindle can be an axis.

    ``channel``: that of the spindle. ``is_active``: the spindle is an axis now. ``last``: the
    command that the spindle has followed.
    """

    def __init__(self, axes: Axes, spindles: Spindles) -> None:
        self.axes = axes
        self.spindles = spindles
        self.axis = -1
        self.spindle = 0
        self.last = 0.0
        self.channel = 0
        self.is_active = False

    def configure(self, axis: int, spindles: Spindles, spindle: int, channel: int) -> None:
        """Allow a spindle of a channel, counted from 1, to become an axis."""
        check_index(axis, self.axes.count, "axis")
        check_index(spindle, spindles.count, "spindle")
        self.spindles = spindles
        self.axis = axis
        self.spindle = spindle
        self.channel = channel

    def can_take(self, axis: int) -> int:
        """Return whether the path can have an axis: the spindle is at rest."""
        if axis != self.axis or self.spindles.has_no_axis[self.spindle]:
            return 1
        return self.spindles.is_resting(self.spindle)

    def take(self, axis: int) -> None:
        """Turn the spindle into an axis, if it is this axis; it begins at the angle of the axis."""
        if axis == self.axis:
            if self.spindles.has_no_axis[self.spindle]:
                self.spindles.turn_to(self.spindle, self.axes.command[axis])
            self.last = self.spindles.position[self.spindle]
            self.axes.set_position(axis, self.last)
            self.is_active = True
            self.spindles.follow(self.spindle, self.last, 0.0)

    def give(self, axis: int) -> int:
        """Turn the axis back into a spindle, if it is this axis and a path has had it.

        Return the channel whose spindle has it from here on, 0 for none.
        """
        if axis != self.axis or not self.is_active:
            return 0
        self.is_active = False
        if self.spindles.has_no_axis[self.spindle]:
            self.spindles.follow(self.spindle, self.last, 0.0)
            return 0
        self.spindles.uncouple(self.spindle)
        return self.channel

    def follow(self) -> None:
        """Turn the spindle with its axis."""
        command = self.axes.command[self.axis]
        covered = self.axes.distance(self.axis, self.last, command)
        self.last = command
        self.spindles.follow(self.spindle, command, covered / self.spindles.cycle_t)

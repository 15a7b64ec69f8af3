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
    """The axis and the spindle that are one; ``axis`` is -1 where no spindle can be an axis.

    ``is_active``: the spindle is an axis now. ``last``: the command that the spindle has followed.
    """

    def __init__(self, axes: Axes, spindles: Spindles) -> None:
        self.axes = axes
        self.spindles = spindles
        self.axis = -1
        self.spindle = 0
        self.last = 0.0
        self.is_active = False

    def configure(self, axis: int, spindles: Spindles, spindle: int) -> None:
        """Let a spindle be able to become an axis."""
        check_index(axis, self.axes.count, "axis")
        check_index(spindle, spindles.count, "spindle")
        self.spindles = spindles
        self.axis = axis
        self.spindle = spindle

    def can_take(self, axis: int) -> int:
        """Return whether the path can have an axis: the spindle is at rest."""
        if axis != self.axis or self.spindles.has_no_axis[self.spindle]:
            return 1
        return self.spindles.is_resting(self.spindle)

    def take(self, axis: int) -> None:
        """Let the spindle be an axis, if it is this one."""
        if axis == self.axis:
            self.last = self.spindles.position[self.spindle]
            self.axes.set_position(axis, self.last)
            self.is_active = True
            self.spindles.follow(self.spindle, self.last, 0.0)

    def give(self, axis: int) -> None:
        """Let the spindle be one again, if its axis is this one."""
        if axis == self.axis:
            self.is_active = False
            if self.spindles.has_no_axis[self.spindle]:
                self.spindles.follow(self.spindle, self.last, 0.0)
            else:
                self.spindles.uncouple(self.spindle)

    def follow(self) -> None:
        """Turn the spindle with its axis."""
        command = self.axes.command[self.axis]
        covered = self.axes.distance(self.axis, self.last, command)
        self.last = command
        self.spindles.follow(self.spindle, command, covered / self.spindles.cycle_t)

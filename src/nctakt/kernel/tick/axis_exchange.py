# SPDX-License-Identifier: MIT
"""A channel's side of the axis exchange: the axes that it has, and those that it waits for.

Axes change their channel between two ticks, while the path of the channel is at rest and its queue
is empty. An axis belongs to one channel or to none; ``SingleAxes.in_channel`` has its number. A
channel takes an axis that no other one has and that is at rest.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.kernel import codes, rows
from nctakt.kernel.axes.c_axis import CAxis
from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_index
from nctakt.kernel.path.path import Path
from nctakt.kernel.path.segment_limits import SegmentLimits
from nctakt.kernel.tick.channel_signals import ChannelSignals
from nctakt.kernel.tick.command_execution import CommandExecutor


class AxisExchange:
    """The axes of one channel.

    ``is_waiting``: its decoder waits for the axes that are ``awaited``; ``since``: the first tick
    of that; ``source``: the command. ``signals``: knows the channel's number. ``c_axis``: the
    spindle that can be one of them; ``c_axes``: all of them on the machine, the channel's own
    first.
    """

    def __init__(self, path: Path, limits: SegmentLimits, executor: CommandExecutor) -> None:
        self.path = path
        self.limits = limits
        self.single_axes = executor.context.single_axes
        self.signals = executor.signals
        self.spindles = executor.spindle_exchange
        self.c_axis = CAxis(self.path.axes, executor.context.spindles)
        self.c_axes = [self.c_axis]
        self.awaited = integers(self.path.axes.count + 1)
        self.is_waiting = False
        self.source = 0
        self.since = 0

    def set_signals(self, signals: ChannelSignals) -> None:
        """Set the signals of the channel, and let it have its axes."""
        self.signals = signals
        for i in range(self.path.count):
            self.single_axes.assign_to_channel(self.path.members[i], signals.number)

    def share(self, c_axes: Sequence[CAxis]) -> None:
        """Know the spindles of other channels that can be axes."""
        self.c_axes.extend(c_axes)

    # --- Python's side, between two ticks -------------------------------------------------------

    def await_axes(self, source: int, tick: int, axes: Sequence[int]) -> None:
        """Let the decoder wait from ``tick`` on until it can have these axes."""
        for axis in axes:
            check_index(axis, self.path.axes.count, "axis")
        for axis in range(self.path.axes.count):
            self.awaited[axis] = 1 if axis in axes else 0
        self.is_waiting = True
        self.source = source
        self.since = tick
        for axis in axes:
            holder = self.holder(axis)
            if holder not in (0, self.signals.number):
                self.signals.board.has_waited = True
                self.record_exchange(tick, axis, codes.AXIS_AWAITED, holder)

    def exchange(self, tick: int, source: int, members: list[int]) -> None:
        """Let the channel have these axes instead, as ``Path.set_axes``; it waits no more."""
        self.give_up()
        self.source = source
        before = [axis for axis in self.path.own_axes() if axis != self.path.axes.count]
        self.path.set_axes(members)
        self.path.arc.set_count(len(members))
        self.path.forget()
        self.limits.set_count(len(members))
        after = [axis for axis in members if axis != self.path.axes.count]
        for axis in before:
            if axis not in after:
                keepers = [one.give(axis) for one in self.c_axes]
                self.single_axes.assign_to_channel(axis, max(keepers))
                self.record_exchange(tick, axis, codes.AXIS_GIVEN, 0)
        for axis in after:
            if axis not in before:
                self.single_axes.assign_to_channel(axis, self.signals.number)
                spindle = next((one for one in self.c_axes if one.axis == axis), None)
                if spindle is not None:
                    spindle.take(axis)
                self.record_exchange(tick, axis, codes.AXIS_TAKEN, 0)
        self.single_axes.note_exchange()

    def holder(self, axis: int) -> int:
        """Return the number of the channel that has an axis, 0 if none has."""
        check_index(axis, self.path.axes.count, "axis")
        return int(self.single_axes.in_channel[axis])

    def missing(self) -> list[int]:
        """Return the axes that the decoder waits for and that another channel has."""
        count = self.path.axes.count if self.is_waiting else 0
        own = (0, self.signals.number)
        missing = [
            axis for axis in range(count) if self.awaited[axis] and self.holder(axis) not in own
        ]
        of_spindle = self.spindles.awaited()[0]
        return missing if of_spindle < 0 else [of_spindle, *missing]

    def awaited_since(self) -> tuple[int, int]:
        """Return source and first tick of the command that waits for an axis; (0, 0): none.

        That of a spindle comes before the decoder, which is ahead of it.
        """
        axis, source, since = self.spindles.awaited()
        if axis < 0 and not self.is_waiting:
            return (0, 0)
        return (source, since) if axis >= 0 else (int(self.source), int(self.since))

    def record_exchange(self, tick: int, axis: int, what: int, holder: int) -> None:
        """Record an event of the exchange in the coming tick."""
        self.signals.record_event(
            tick, rows.EVENT_AXIS_EXCHANGED, self.source, axis, what, holder, 0.0
        )

    def give_up(self) -> None:
        """Let the decoder wait no more."""
        self.is_waiting = False

    # --- in the tick ----------------------------------------------------------------------------

    def can_exchange(self) -> int:
        """Return whether the decoder waits for axes, and can have all of them now."""
        if not self.is_waiting or self.is_stuck():
            return 0
        for axis in range(self.path.axes.count):
            if self.awaited[axis] and not self.single_axes.is_free(axis):
                return 0
            if self.awaited[axis] and not self.c_axis.can_take(axis):
                return 0
        return 1

    def is_stuck(self) -> int:
        """Return whether the decoder waits for an axis that another channel has."""
        if not self.is_waiting:
            return 0
        for axis in range(self.path.axes.count):
            if self.awaited[axis] and self.single_axes.in_channel[axis]:
                if self.single_axes.in_channel[axis] != self.signals.number:
                    return 1
        return 0

    def reset(self) -> None:
        """Wait no more (RC-007)."""
        self.is_waiting = False

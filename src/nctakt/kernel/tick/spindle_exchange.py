# SPDX-License-Identifier: MIT
"""The axes of a channel's spindles, given away and taken again (``S[PUTAX]``, ``S[CALLAX]``).

A spindle has its axis as the path has its axes: ``SingleAxes.in_channel`` has the number of the
channel that has it, by its path or by a spindle. Any channel can take an axis that a spindle has
given up, and the spindle waits until it is free again.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base.record import Record
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.tick.channel_signals import ChannelSignals
from nctakt.kernel.tick.command_queue import CommandQueue


class SpindleExchange:
    """Gives and takes the axes of spindles; ``blocked_since``: the tick since when the command at
    the head of the queue waits for one, -1: none does. ``signals``: they have the channel's number.
    """

    def __init__(
        self, context: Context, queue: CommandQueue, signals: ChannelSignals, record: Record
    ) -> None:
        self.context = context
        self.queue = queue
        self.signals = signals
        self.record = record
        self.blocked_since = -1

    def begin(self, signals: ChannelSignals) -> None:
        """Assign the spindles their axes; a shared axis goes to the first channel."""
        self.signals = signals
        spindles, single_axes = self.context.spindles, self.context.single_axes
        for spindle in range(spindles.count):
            axis = spindles.axis[spindle]
            holder = signals.number if axis < 0 else single_axes.in_channel[axis]
            if not 0 < holder <= signals.number:
                single_axes.assign_to_channel(axis, signals.number)

    def awaited(self) -> tuple[int, int, int]:
        """Return the awaited axis, source and first tick; axis -1: none."""
        if not self.is_stuck():
            return (-1, 0, 0)
        row = self.queue.head_row()
        spindle = int(self.queue.rows[row + rows.GIVING_SPINDLE])
        source = int(self.queue.rows[row + rows.SOURCE])
        return (self.context.spindles.axis[spindle], source, self.blocked_since)

    # --- in the tick ----------------------------------------------------------------------------

    def execute(self, tick: int, row: int) -> int:
        """Carry out a command at ``row``; 0: it waits; else the number of an error, or 1."""
        spindle = int(self.queue.rows[row + rows.GIVING_SPINDLE])
        if self.queue.rows[row + rows.GIVES_AXIS] == 0.0:
            return self.take(tick, row, spindle)
        if not self.context.spindles.give_axis(spindle):
            return 60137
        axis = self.context.spindles.axis[spindle]
        if axis >= 0 and self.context.single_axes.in_channel[axis] == self.signals.number:
            position = self.context.spindles.position[spindle]
            self.context.single_axes.axes.put_at(axis, position)
            self.context.single_axes.in_channel[axis] = 0
            self.context.single_axes.has_exchanged = True
            self.record_exchange(row, spindle, axis, codes.AXIS_GIVEN)
        return 1

    def take(self, tick: int, row: int, spindle: int) -> int:
        """Let a spindle have its axis again; 0 while another channel has it."""
        axis = self.context.spindles.axis[spindle]
        if self.has_other(axis):
            if self.blocked_since < 0:
                self.blocked_since = tick
                self.signals.board.has_waited = True
                self.record_exchange(row, spindle, axis, codes.AXIS_AWAITED)
            return 0
        self.blocked_since = -1
        if axis >= 0 and self.context.single_axes.in_channel[axis] == 0:
            self.context.single_axes.in_channel[axis] = self.signals.number
            self.context.single_axes.has_exchanged = True
            self.context.spindles.turn_to(spindle, self.context.single_axes.axes.command[axis])
            self.record_exchange(row, spindle, axis, codes.AXIS_TAKEN)
        self.context.spindles.take_axis(spindle)
        return 1

    def has_other(self, axis: int) -> int:
        """Return whether another channel has an axis."""
        if axis < 0:
            return 0
        holder = self.context.single_axes.in_channel[axis]
        return 0 if holder in (0, self.signals.number) else 1

    def is_stuck(self) -> int:
        """Return whether the command at the head of the queue waits for an axis."""
        if self.blocked_since < 0 or self.queue.head == self.queue.tail:
            return 0
        row = self.queue.head_row()
        if self.queue.rows[row + rows.KIND] != rows.SPINDLE_AXIS:
            return 0
        spindle = int(self.queue.rows[row + rows.GIVING_SPINDLE])
        return self.has_other(self.context.spindles.axis[spindle])

    def record_exchange(self, row: int, spindle: int, axis: int, what: int) -> None:
        """Record an event of the exchange, with the number of the spindle, from 1."""
        source = int(self.queue.rows[row + rows.SOURCE])
        holder = self.context.single_axes.in_channel[axis] if what == codes.AXIS_AWAITED else 0
        number = self.context.spindles.first_number + spindle + 1
        self.record.event(rows.EVENT_AXIS_EXCHANGED, source, axis, what, holder, number)

    def reset(self) -> None:
        """Wait no more (RC-007)."""
        self.blocked_since = -1

# SPDX-License-Identifier: MIT
"""What the commands of a channel's queue do when they are taken (RC-003, RC-004).

``Commands.take_commands`` is the first phase of a channel's tick; ``channel.py`` has the others.
The channel's cells stand from ``first_cell`` on in the order of ``nc/vocabulary/variable_table.py``
(``CHANNEL_VARIABLES``).
"""

from __future__ import annotations

from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.record import Record
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.cycles import CycleManager
from nctakt.kernel.path import geometry
from nctakt.kernel.path.backward import Retrace
from nctakt.kernel.path.edge_probe import EdgeProbe
from nctakt.kernel.path.fixed_stops import FixedStops
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.override import Overrides
from nctakt.kernel.path.path import Path
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.kernel.tick.command_queue import CommandRing


class Commands(CommandRing):
    """The queue of a channel with all that its commands act on, and the channel's error state."""

    def __init__(
        self,
        memory: bytearray,
        first_cell: int,
        record: Record,
        hli: Hli,
        manager: CycleManager,
        path: Path,
        timers: Timers,
        ahead: LookAhead,
        single_axes: SingleAxes,
    ) -> None:
        super().__init__(path, ahead)
        self.cells = memoryview(memory).cast("d")
        self.characters = memoryview(memory)
        self.first_cell = first_cell
        self.record = record
        self.hli = hli
        self.panel = hli.panel
        self.manager = manager
        self.stops = FixedStops(path, record)
        self.is_at_stop = False
        self.edge = EdgeProbe(path, hli, record, memory, first_cell + 3)
        self.context = Context(memory, record, hli, timers, single_axes)
        self.overrides = Overrides(self.context, path.width)
        self.retrace = Retrace(path, hli.panel, record, ahead, self.overrides)
        self.program_timers = timers
        self.waiting = 0
        self.taken_source = 0
        self.program_ended = False
        self.error_pending = False
        self.error_detail = 0.0
        self.error_message = 0
        self.is_looping = False
        self.is_skipping = False
        self.is_between = False
        self.is_stopped = False
        self.is_fatal = False
        self.is_resetting = False

    def set_spindles(self, spindles: Spindles, action_places: int) -> None:
        """The channel's spindles; so many actions of a realtime cycle are open (P-CHAN-00480)."""
        self.context.spindles = spindles
        self.context.action_places = action_places
        self.manager.spindles = spindles

    def take_commands(self, tick: int) -> None:
        """Take commands in order until one takes time or has to wait (RC-003, RC-004)."""
        self.manager.leave_blocks(self.path.block_serial())
        if self.is_stopped or self.is_resetting or self.goes_back():
            return
        while self.head < self.tail and self.waiting == 0 and not self.is_stopped:
            if self.panel.is_paused:
                return
            if self.path.is_active and self.begun < self.head:
                return
            base = self.head % self.capacity * self.width
            if self.queue[base] == 71.0 and self.goes_round():
                self.repeat_body()
                continue
            if self.is_between and not self.goes_round() and self.is_at_stand():
                self.is_skipping = True
            if self.is_skipping and self.queue[base] != 71.0:
                self.timed_count -= self.counts_of(base)
            elif not self.enter_block(base) or not self.take(tick, base):
                return
            else:
                self.is_between = self.queue[base] == 72.0
            self.head += 1

    def is_at_stand(self) -> int:
        """Whether the path stands between two blocks, and has begun none that is still queued."""
        stands = self.path.speed_v == 0.0 and not self.path.is_active and not self.path.goes_on()
        return 1 if stands and self.begun < self.head else 0

    def goes_back(self) -> int:
        """Whether the path is away from its front or about to leave it: nothing is taken."""
        if self.path.is_away:
            return 1
        if not self.panel.backward_motion or self.path.history_size == 0:
            return 0
        return 1 if self.path.speed_v == 0.0 else 0

    def enter_block(self, base: int) -> int:
        """Whether the command at ``base`` may be taken: single block stops in front of a block."""
        source = int(self.queue[base + 1])
        self.taken_source = source
        line = source >> 20  # file and line (``base/source_ids.py``)
        is_begun = self.head <= self.begun or self.path.speed_v > 0.0
        if self.path.goes_on():
            return 1
        if self.panel.lets_go(line, self.queue[base] <= 2.0, is_begun):
            return 1
        self.record.paused(source)
        return 0

    def take(self, tick: int, base: int) -> int:
        """Take the command at ``base``: 0 when it stays at the head of the queue."""
        kind = int(self.queue[base])
        if kind <= 2:
            return self.take_block(base)
        if kind <= 4:
            return self.take_cycle(tick, base, kind)
        if kind == 5:
            return self.take_technology(tick, base)
        if kind == 6:
            if self.hli.program.is_waiting(int(self.queue[base + 3])):
                return 0
            self.timed_count -= 1
            return 1
        if kind == 7:
            self.take_write(base)
            return 1
        if kind == 8:
            self.record.message(int(self.queue[base + 1]), int(self.queue[base + 3]))
            return 1
        if kind == 11:
            return self.take_program_end(tick, base)
        if 50 <= kind <= 52:
            self.take_offset(base, kind)
            return 1
        if kind == 60:
            self.take_frozen(base)
            return 1
        if 20 <= kind <= 22:
            self.take_user_error(base, kind)
            return 1
        if kind == 23:
            return self.take_spindle(tick, base)
        if kind == 24:
            return self.take_spindle_wait(base)
        if 30 <= kind <= 32:
            self.take_mark(tick, base, kind)
            return 1
        if kind == 77:
            self.path.forget()
            return 1
        if 75 <= kind <= 76:
            return self.take_measuring(tick, base, kind)
        if 73 <= kind <= 74:
            self.take_fixed_stop(base, kind)
            return 1
        if kind == 70:
            self.take_loop(base)
            return 1
        if kind == 72:
            self.cells[self.first_cell + 5] += 1.0
            return 1
        if kind == 53:
            self.timed_count -= 1
            if self.panel.stop_for_program(self.queue[base + 3] != 0.0):
                self.record.paused(int(self.queue[base + 1]))
            return 1
        if kind == 12:
            self.timed_count -= 1
            self.report(int(self.queue[base + 1]), int(self.queue[base + 3]), 0.0)
            return 1
        self.waiting = kind
        return 0

    def take_block(self, base: int) -> int:
        """A segment or dwell: current from now on, unless the path has passed its start already.

        BLOCK cycles that stood before it run with it, or once where it is over by now (RC-105).
        """
        self.timed_count -= self.counts_of(base)
        if self.head <= self.begun:
            is_current = self.head == self.begun and self.path.is_active
            self.manager.enter_block(self.path.serial if is_current else -1)
            if self.head == self.begun:
                self.begun = -1
            return 1
        if self.queue[base] == 1.0:
            message = self.path.refusal(base, self.queue)
            if message:
                self.report(int(self.queue[base + 1]), message, self.path.refused_axis)
                return 1
        self.path.begin(base, self.queue, 0.0)
        if self.path.goes_on():
            self.path.leave_rest(self.rest_of_block(self.head))
        self.manager.enter_block(self.path.serial)
        return 1

    def counts_of(self, base: int) -> int:
        """How much a segment or dwell counts among the commands that take time."""
        kind = self.queue[base]
        if kind > 2.0:
            return 0
        return 0 if kind == 1.0 and self.queue[base + 9] == 2.0 else 1

    def rest_of_block(self, position: int) -> float:
        """What ``Path.leave_rest`` wants of a segment whose block goes on; 0: it is not known."""
        last = position
        while self.queue[last % self.capacity * self.width + 8] < 0.0:
            last += 1
            if last >= self.tail:
                return 0.0
        rest = 0.0
        while last > position:
            base = last % self.capacity * self.width
            if self.queue[base + 10] > 0.0:
                rest += geometry.whole_way(self.queue, base, self.path.count)
            else:
                limit_v = self.queue[base + 5]
                rest = self.ahead.entry_speed(self.queue, base, rest, limit_v)
            last -= 1
        return rest

    def take_cycle(self, tick: int, base: int, kind: int) -> int:
        """A definition or a management command; DELETE and HOLD may have to wait (RC-004)."""
        source = int(self.queue[base + 1])
        if kind == 3:
            message = self.manager.define(
                int(self.queue[base + 3]), int(self.queue[base + 4]), tick
            )
        else:
            action = int(self.queue[base + 3])
            identity = int(self.queue[base + 4])
            if (action in (2, 5)) and self.manager.is_fresh(identity, tick):
                return 0
            message = self.manager.control(action, identity, tick, source)
        if message != 0:
            detail = self.queue[base + 4]
            if kind == 3:
                detail = self.manager.wanted(int(self.queue[base + 3]), message)
            self.report(source, message, detail)
        return 1

    def take_technology(self, tick: int, base: int) -> int:
        """An M or H function of the main program; waits while no slot is free."""
        function = int(self.queue[base + 3])
        if self.hli.program.issue(function, tick, int(self.queue[base + 4])) <= 0:
            return 0
        value = int(self.queue[base + 6])
        self.hli.program.give_value(value)
        has_value = self.queue[base + 5] != 0.0
        self.record.technology(int(self.queue[base + 1]), function, has_value, value)
        return 1

    def take_spindle(self, tick: int, base: int) -> int:
        """A spindle's job of the main program; waits until the spindle can take it."""
        spindle = int(self.queue[base + 3])
        if not self.context.spindles.is_ready(spindle, tick):
            return 0
        self.context.spindles.command(
            spindle,
            int(self.queue[base + 4]),
            self.queue[base + 5],
            self.queue[base + 6],
            int(self.queue[base + 7]),
            0,
            tick,
        )
        self.context.spindles.tell(spindle, int(self.queue[base + 1]), 0)
        ticks = int(self.queue[base + 8])
        self.context.spindles.hand_over(spindle, tick + ticks)
        return 1

    def take_spindle_wait(self, base: int) -> int:
        """Speed or position of a spindle is waited for; a held job would never have them."""
        spindle = int(self.queue[base + 3])
        if self.context.spindles.is_busy(spindle):
            if not self.context.spindles.is_held[spindle]:
                return 0
            number = self.context.spindles.first_number + spindle
            self.report(int(self.queue[base + 1]), 900811, number)
        self.timed_count -= 1
        return 1

    def take_write(self, base: int) -> None:
        """A synchronous variable written by the decoder (RC-308)."""
        cell = int(self.queue[base + 3])
        if self.queue[base + 6] != 0.0:
            self.take_characters(base, 8 * cell)
            return
        self.cells[cell] = self.queue[base + 4]
        if self.queue[base + 5] != 0.0:
            self.record.written(int(self.queue[base + 1]), 0, cell, self.cells[cell])

    def take_characters(self, base: int, place: int) -> None:
        """Part of a string: from the byte (4) on so many characters (5), then so many zeros (7)."""
        first = int(self.queue[base + 4])
        count = int(self.queue[base + 5])
        zeros = int(self.queue[base + 7])
        first += place
        for i in range(count):
            self.characters[first + i] = int(self.queue[base + 8 + i])
        for i in range(count, count + zeros):
            self.characters[first + i] = 0

    def take_offset(self, base: int, kind: int) -> None:
        """An offset, the origin or the turn of a system: the cycles of this tick see it (MO-8)."""
        if kind == 52:
            self.path.axes.turn(self.queue, base + 3)
            return
        axis = int(self.queue[base + 3])
        if kind == 51:
            self.path.axes.set_origin(axis, self.queue[base + 4])
        else:
            self.path.axes.set_offset(axis, int(self.queue[base + 4]), self.queue[base + 5])

    def take_loop(self, base: int) -> None:
        """The begin of a realtime loop: without its condition it is passed over."""
        self.cells[self.first_cell + 5] = 0.0
        self.is_skipping = self.cells[self.first_cell + 4] == 0.0
        self.is_looping = not self.is_skipping
        self.panel.show_loop(self.is_looping)
        self.record.loop(int(self.queue[base + 1]), 1 if self.is_skipping else 0)
        self.prolong_loop()

    def prolong_loop(self) -> None:
        """While the loop's condition holds there is always another pass ahead of the path."""
        if self.goes_round():
            while self.needs_pass():
                self.repeat_body()

    def take_fixed_stop(self, base: int, kind: int) -> None:
        """An axis is monitored from now on or no longer; the block that needs a stop is over."""
        source = int(self.queue[base + 1])
        if kind == 73:
            member = int(self.queue[base + 3])
            if self.queue[base + 4] != 0.0:
                self.stops.arm(member, source, self.queue, base + 5)
            else:
                self.stops.disarm(member)
            return
        self.timed_count -= 1
        member = self.stops.missing()
        if member >= 0:
            self.report(source, 50885, self.path.members[member])

    def take_measuring(self, tick: int, base: int, kind: int) -> int:
        """The next block is measured in; it is over, and its function was acknowledged."""
        source = int(self.queue[base + 1])
        if kind == 75:
            function = int(self.queue[base + 3])
            ticks = int(self.queue[base + 4])
            self.edge.arm(source, function, ticks, self.queue[base + 5])
            self.edge.has_value = self.queue[base + 6] != 0.0
            self.edge.value = int(self.queue[base + 7])
            return 1
        found = self.edge.finish(tick)
        if found == 0:
            return 0
        self.timed_count -= 1
        if found < 0:
            self.report(source, 50891, 0.0)
        return 1

    def goes_round(self) -> int:
        """Whether the condition of the loop that the path is in holds."""
        return 1 if self.is_looping and self.cells[self.first_cell + 4] != 0.0 else 0

    def leave_loop(self, source: int) -> None:
        """The path has come to the loop's end, and the condition does not hold."""
        if self.is_looping:
            self.record.loop(source, 2)
        self.give_up_loop()

    def give_up_loop(self) -> None:
        """There is no loop any more."""
        self.is_looping = False
        self.is_skipping = False
        self.is_between = False
        self.panel.show_loop(False)
        self.body.give_up()

    def take_frozen(self, base: int) -> None:
        """What the definition before it has frozen: told where it is taken (RC-302)."""
        source = int(self.queue[base + 1])
        name = int(self.queue[base + 4])
        self.record.frozen(source, int(self.queue[base + 3]), name, self.queue[base + 5])

    def take_mark(self, tick: int, base: int, kind: int) -> None:
        """Where a block is carried out, why the decoder waits, a timer of the program."""
        source = int(self.queue[base + 1])
        subject = int(self.queue[base + 3])
        if kind == 30:
            self.record.block(source, int(self.queue[base + 2]), subject)
        elif kind == 31:
            self.record.wait(source, subject, int(self.queue[base + 4]))
        else:
            self.program_timers.command(int(self.queue[base + 4]), subject, tick)

    def take_program_end(self, tick: int, base: int) -> int:
        """M30; not in the tick in which a cycle that it deletes was started (RC-004, RC-106)."""
        if self.manager.has_fresh(tick):
            return 0
        self.timed_count -= 1
        self.path.forget()
        self.stops.clear()
        self.edge.clear()
        self.manager.end_program()
        self.record.program_end(int(self.queue[base + 1]), int(self.queue[base + 3]))
        self.program_ended = True
        self.waiting = 11
        return 1

    def take_user_error(self, base: int, kind: int) -> None:
        """``#ERROR`` of the main program: told, then its values, then it may stop the channel."""
        source = int(self.queue[base + 1])
        if kind == 20:
            self.record.user_error(source, 0, self.queue[base + 3], self.queue[base + 4])
        elif kind == 22:
            self.timed_count -= 1
            self.stop_for_user(int(self.queue[base + 3]))
        elif self.queue[base + 5] != 0.0:
            self.record.user_text(source, 0, int(self.queue[base + 3]), int(self.queue[base + 4]))
        else:
            self.record.user_value(source, 0, int(self.queue[base + 3]), self.queue[base + 4])

    def stop_for_user(self, reaction: int) -> None:
        """An ``#ERROR`` with RC from 1 on: error state until a reset, with RC 7 for good."""
        self.enter_error(900464)
        if reaction == 7:
            self.error_message = 900465
            self.is_fatal = True

    def enter_error(self, message: int) -> None:
        """The channel is in error state: nothing is taken, the path brakes."""
        self.error_message = message
        self.error_pending = True
        self.is_stopped = True

    def report(self, source: int, message: int, detail: float) -> None:
        """An error of the realtime part: channel in error state, the path brakes (RC-505)."""
        self.record.error(source, 0, message, detail)
        self.error_detail = detail
        self.enter_error(message)

# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""One channel: the queue of commands, and the phases of its tick (RC-002 … RC-007).

``ring.py`` is the queue. While the decoder has more to give, the kernel returns when the commands
that take time fall below ``low_water``, so that a tick never finds the queue empty too early, and
the path always knows as many blocks as it looks ahead. The channel's cells stand from
``first_cell`` on in the order of ``nc/names.py`` (``CHANNEL_VARIABLES``).
"""

from __future__ import annotations

from nctakt.kernel import arithmetic
from nctakt.kernel.cycles import CycleManager
from nctakt.kernel.hli import Hli
from nctakt.kernel.lookahead import LookAhead
from nctakt.kernel.memory import Context
from nctakt.kernel.path import Path
from nctakt.kernel.record import Record
from nctakt.kernel.ring import CommandRing
from nctakt.kernel.single_axes import SingleAxes
from nctakt.kernel.spindles import Spindles
from nctakt.kernel.timers import Timers

#: Commands that take time below which the kernel asks for more.
LOW_WATER = 8


class Channel(CommandRing):
    """One channel with its path, its cycles and its image of the PLC."""

    def __init__(
        self,
        memory: bytearray,
        first_cell: int,
        record: Record,
        hli: Hli,
        manager: CycleManager,
        path: Path,
        timers: Timers,
        max_override_pct: float,
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
        self.max_override_pct = max_override_pct
        self.context = Context(memory, record, hli, timers, single_axes)
        self.low_water = max(LOW_WATER, ahead.blocks)
        self.program_timers = timers
        self.decoder_open = False
        self.wants_slot = False
        self.waiting = 0
        self.answer = 0.0
        self.answer_ready = False
        self.program_ended = False
        self.error_pending = False
        self.error_detail = 0.0
        self.is_stopped = False
        self.is_fatal = False
        self.is_resetting = False
        self.is_reset_due = False
        self.error_message = 0

    def set_spindles(self, spindles: Spindles, action_places: int) -> None:
        """The channel's spindles; so many actions of a realtime cycle are open (P-CHAN-00480)."""
        self.context.spindles = spindles
        self.context.action_places = action_places
        self.manager.spindles = spindles

    # --- Python's side, between two runs --------------------------------------------------------

    def take_answer(self) -> float:
        """The value that the decoder has waited for; it goes on."""
        assert self.answer_ready
        self.answer_ready = False
        return self.answer

    def can_free_slots(self) -> bool:
        """Whether realtime cycles may still end by themselves: for the decoder that needs a slot.

        Their blocks are on their way, or what comes before the next definition is not taken yet.
        """
        return not self.is_idle()

    def due(self) -> int:
        """What the channel needs Python for, as ``needs_python``."""
        return self.needs_python()

    def event_bound(self) -> int:
        """The most events that one tick can record: a few for each command, cycle and slot."""
        commands = self.tail - self.head
        single = self.context.single_axes.event_bound(commands) + self.context.spindles.count
        return 8 + single + 3 * commands + self.manager.events_bound + self.manager.capacity

    # --- the tick -------------------------------------------------------------------------------

    def needs_python(self) -> int:
        """Why the kernel must return before the next tick: 0 not at all, 1 … 7 (``kernel.py``)."""
        if self.panel.reset_taken:
            return 7
        if self.panel.start_taken:
            return 6
        if self.error_pending:
            return 4
        if self.program_ended:
            return 3
        if self.answer_ready:
            return 2
        if self.decoder_open and self.wants_slot:
            return 1 if self.manager.dead_count > 0 or self.is_idle() else 0
        if self.decoder_open and self.timed_count < self.low_water:
            return 1
        return 0

    def is_idle(self) -> int:
        """Whether nothing is queued or current, and no cycle waits for its block's end."""
        if self.head < self.tail or self.path.is_active:
            return 0
        return 1 if self.manager.in_block_count == 0 else 0

    def begin_tick(self, tick: int) -> None:
        """Latch the PLC's answers and a reset; the CYCLE override is 100 % again (RC-305)."""
        self.context.begin(tick)
        self.hli.latch()
        self.context.spindles.latch()
        if self.panel.reset_pressed:
            self.begin_reset()
        elif self.panel.start_pressed:
            self.panel.take_start(not self.is_stopped and not self.is_resetting)
        if self.is_reset_due:
            self.is_reset_due = False
            self.hli.clear()
            self.manager.reset()
            for i in range(self.path.count):
                self.context.single_axes.reset(self.path.members[i])
        self.cells[self.first_cell] = 100.0

    def take_commands(self, tick: int) -> None:
        """Take commands in order until one takes time or has to wait (RC-003, RC-004)."""
        self.manager.leave_blocks(self.path.serial if self.path.is_active else 0)
        if self.is_stopped or self.is_resetting or self.panel.is_paused:
            return
        while self.head < self.tail and self.waiting == 0 and not self.is_stopped:
            if self.path.is_active and self.begun < self.head:
                return
            base = self.head % self.capacity * self.width
            if not self.enter_block(base) or not self.take(tick, base):
                return
            self.head += 1

    def enter_block(self, base: int) -> int:
        """Whether the command at ``base`` may be taken: single block stops in front of a block."""
        source = int(self.queue[base + 1])
        line = source >> 20  # file and line (``sources.py``)
        is_begun = self.head <= self.begun or self.path.speed_v > 0.0
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
        if kind == 50:
            self.take_offset(base)
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
            if self.context.spindles.is_busy(int(self.queue[base + 3])):
                return 0
            self.timed_count -= 1
            return 1
        if 30 <= kind <= 32:
            self.take_mark(tick, base, kind)
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
        self.timed_count -= 1
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
        self.manager.enter_block(self.path.serial)
        return 1

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
        self.record.technology(int(self.queue[base + 1]), function)
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

    def take_offset(self, base: int) -> None:
        """An offset of an axis: the cycles of this tick see it (MO-8)."""
        kind = int(self.queue[base + 4])
        self.path.axes.set_offset(int(self.queue[base + 3]), kind, self.queue[base + 5])

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

    def run_cycles(self) -> None:
        """All active realtime cycles, once; none during a reset (RC-007)."""
        if self.is_resetting:
            return
        if self.manager.run_cycles(self.context):
            self.enter_error(self.context.fault)
        if self.context.user_reaction > 0:
            self.stop_for_user(self.context.user_reaction)

    def interpolate(self) -> None:
        """One increment of the path with this tick's override (RC-305, MO-5)."""
        pct = self.panel.override_pct * self.cells[self.first_cell] / 100.0
        pct = min(pct, self.max_override_pct)
        stops = self.is_stopped or self.is_resetting or self.panel.feed_hold
        self.publish_block()
        self.path.publish_overrides(self.panel.override_pct)
        if self.path.is_single != self.panel.single_block:
            self.path.set_single(self.panel.single_block)
        if self.path.step(pct / 100.0, stops):
            self.go_on(pct / 100.0, stops)
        self.cells[self.first_cell + 1] = arithmetic.round_half_even(pct)

    def publish_block(self) -> None:
        """The N number of the block that is current in this tick, its last one included."""
        number = self.path.block_number() if self.path.is_active else 0.0
        self.cells[self.first_cell + 7] = number

    def go_on(self, factor: float, stops: int) -> None:
        """The path passes block ends: what stands between is taken in the next tick (RC-003)."""
        position = max(self.head, self.begun + 1)
        if self.path.is_single and self.path.speed_v == 0.0:
            return
        while position < self.tail:
            base = position % self.capacity * self.width
            kind = int(self.queue[base])
            if kind == 1:
                if self.path.refusal(base, self.queue):
                    return
                self.begun = position
                self.path.begin(base, self.queue, self.path.left_t)
                if self.path.left_t > 0.0:
                    self.publish_block()
                if not self.path.step_carried(factor, stops):
                    return
            elif not self.passes(kind):
                return
            position += 1

    def end_tick(self) -> None:
        """Answer what waits for the path to stand; end a reset; publish (RC-005, RC-007)."""
        state = 3 if self.is_resetting else 2 if self.is_stopped else 0
        if self.path.stands():
            if not self.is_stopped and (self.waiting in (9, 10) or self.axes_stand()):
                self.answer_waiting()
            if self.is_resetting:
                self.end_reset()
        if self.context.single_axes.fault_count > 0:
            self.report_axes()
        self.context.spindles.step(self.context.tick, self.hli.acknowledges_itself)
        self.hli.run_default_plc(self.context.tick)
        self.panel.publish(state, self.error_message)
        self.cells[self.first_cell + 6] = self.path.speed_v
        self.cells[self.first_cell + 8] = self.manager.running_count
        self.cells[self.first_cell + 9] = self.path.rest_d()

    def report_axes(self) -> None:
        """An independent motion of one of the channel's axes has failed: error state."""
        message = self.context.single_axes.take_faults(self.path.members, self.path.count)
        if message:
            self.enter_error(message)

    def axes_stand(self) -> int:
        """Whether the axes of a waiting position request stand; one that never will is an error."""
        if self.waiting != 13:
            return 0
        base = self.head % self.capacity * self.width
        message = self.context.single_axes.asked(self.queue, base)
        if message > 1:
            self.report(int(self.queue[base + 1]), message, self.context.single_axes.asked_axis)
        return 1 if message == 0 else 0

    def answer_waiting(self) -> None:
        """Flush and synchronous read at the head: answered with the values of now."""
        base = self.head % self.capacity * self.width
        self.answer = 0.0
        if self.waiting == 10:
            cell = int(self.queue[base + 3])
            self.answer = self.cells[cell]
        if self.queue[base + 5] != 0.0:
            self.answer_ready = True
        self.waiting = 0
        self.head += 1
        self.timed_count -= 1

    def end_reset(self) -> None:
        """Everything stands: give up what was decoded ahead; the path braked on it until now."""
        if not self.context.single_axes.all_free(self.path.members, self.path.count):
            return
        self.is_resetting = False
        self.path.abandon()
        self.head = self.tail
        self.timed_count = 0
        self.begun = -1
        self.latest = -1

    def request_reset(self) -> None:
        """Python asks for a reset, which begins with the next tick."""
        self.begin_reset()

    def begin_reset(self) -> None:
        """Latch a reset: until the path stands, at least one tick (RC-007)."""
        self.is_resetting = True
        self.is_reset_due = True
        self.is_stopped = self.is_fatal
        self.error_pending = False
        self.error_message = 0
        self.waiting = 0
        self.answer_ready = False
        self.panel.is_paused = False

    def clear_error(self) -> None:
        """Python has read the error; the channel stays stopped until a reset."""
        self.error_pending = False

    def accept_end(self) -> None:
        """Python has seen the program's end; the queue is ready for another program."""
        assert self.program_ended
        self.program_ended = False
        self.waiting = 0

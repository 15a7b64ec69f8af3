# SPDX-License-Identifier: MIT
"""One channel: the phases of its tick (RC-002 … RC-007).

``command_queue.py`` is the queue, ``command_execution.py`` executes its commands. While the decoder
has more to give, the kernel returns when the commands that take time fall below ``low_water``, so
that a tick never finds the queue empty too early, and the path always knows as many blocks as it
looks ahead. Where a schedule gives the decoder its time (``is_paced``), the queue may run empty,
and events say so.
"""

from __future__ import annotations

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.path.backward import BackwardMotion
from nctakt.kernel.path.override import Overrides
from nctakt.kernel.tick.axis_exchange import AxisExchange
from nctakt.kernel.tick.command_bounds import check_command
from nctakt.kernel.tick.command_execution import CommandExecutor
from nctakt.kernel.tick.signals import SignalBoard
from nctakt.kernel.tick.wait_reasons import WaitReasons

#: Commands that take time below which the kernel asks for more.
LOW_WATER = 8


class DecoderFeed:
    """What the decoder owes its channel, and what the channel owes the decoder.

    While the decoder is open, it is asked for commands below ``low_water``, or for a cycle once a
    slot is free (``wants_slot``). ``answer``: the value that it waits for. ``starved_since``: the
    tick in which the path had no more commands, -1: it has some.
    """

    def __init__(self, low_water: int) -> None:
        self.low_water = low_water
        self.decoder_open = False
        self.wants_slot = False
        self.is_paced = False
        self.starved_since = -1
        self.answer = 0.0
        self.answer_ready = False

    def take_answer(self) -> float:
        """Take the value that the decoder waits for; raise ``ValueError`` without one."""
        if not self.answer_ready:
            raise ValueError("the realtime part has no answer")
        self.answer_ready = False
        return self.answer


class Channel:
    """One channel: its path, its cycles, its image of the PLC.

    It has a ``queue`` of commands and an ``executor`` that takes them.
    """

    def __init__(
        self,
        executor: CommandExecutor,
        max_override_pct: float,
    ) -> None:
        self.executor = executor
        look_ahead = self.executor.queue.look_ahead
        self.queue = self.executor.queue
        self.path = self.executor.path
        self.cells = self.executor.cells
        self.first_cell = self.executor.first_cell
        self.record = self.executor.record
        self.hli = self.executor.hli
        self.panel = self.executor.panel
        self.manager = self.executor.manager
        self.context = self.executor.context
        self.signals = self.executor.signals
        self.threads = self.executor.threads
        self.fixed_stops = self.executor.fixed_stops
        self.is_at_fixed_stop = False
        self.measuring = self.executor.measuring
        self.exchange = AxisExchange(self.path, look_ahead.limits, self.executor)
        self.c_axis = self.exchange.c_axis
        self.overrides = Overrides(self.context)
        self.backward = BackwardMotion(
            self.path, self.panel, self.record, look_ahead, self.overrides
        )
        self.waits = WaitReasons(self.executor, self.overrides, self.exchange)
        self.overrides.max_pct = max_override_pct
        self.total_pct = 100.0
        self.feed = DecoderFeed(max(LOW_WATER, look_ahead.blocks))
        self.is_reset_due = False
        self.silence_ticks = 0
        self.exchange.set_signals(self.signals)

    # --- Python's side, between two runs --------------------------------------------------------

    def put(self, command: list[float]) -> None:
        """Queue a command of the decoder; raise ``ValueError`` for a number outside its table."""
        check_command(self.executor, command)
        self.queue.put(command)

    def take_answer(self) -> float:
        """Take the value that the decoder waits for; raise ``ValueError`` without one."""
        return self.feed.take_answer()

    def can_free_slots(self) -> bool:
        """Return whether realtime cycles may still end unaided and free a slot.

        Their blocks are on their way, or commands before the next definition are still queued.
        """
        return not self.is_idle()

    def due(self) -> int:
        """Return ``needs_python`` to Python."""
        return self.needs_python()

    def event_bound(self) -> int:
        """Highest number of events of a tick: a few for each command, cycle and slot."""
        commands = self.queue.tail - self.queue.head
        single = self.context.single_axes.event_bound(commands) + self.context.spindles.count
        cycles = self.manager.events_bound + self.manager.capacity
        return 12 + self.path.count + self.hli.waiting_count() + single + 3 * commands + cycles

    # --- the tick -------------------------------------------------------------------------------

    def needs_python(self) -> int:
        """Return why the kernel must return before the next tick, else ``codes.DONE``."""
        if self.panel.reset_taken:
            return codes.RESET
        if self.panel.start_taken:
            return codes.START
        if self.executor.error_pending:
            return codes.ERROR
        if self.executor.program_ended:
            return codes.PROGRAM_END
        if self.feed.answer_ready:
            return codes.ANSWER
        if self.signals.is_decoder_waiting and self.can_accept():
            return codes.ANSWER
        if self.exchange.is_waiting and self.exchange.can_exchange():
            return codes.ANSWER
        if self.feed.is_paced:
            return codes.DONE
        if self.feed.decoder_open and self.feed.wants_slot:
            has_slot = self.manager.ended_count > 0 or self.is_idle()
            return codes.REFILL if has_slot else codes.DONE
        if self.feed.decoder_open and self.queue.timed_count < self.feed.low_water:
            return codes.REFILL
        return codes.DONE

    def can_accept(self) -> int:
        """Return whether the decoder needs to wait for its signal no more.

        A signal that would overtake another is an error if no ``#WAIT SYN`` before it can accept
        that.
        """
        state = self.signals.decoder_state()
        if state == codes.SIGNAL_OVERTAKES:
            return self.is_idle()
        return 1 if state == codes.SIGNAL_THERE else 0

    def activity(self) -> int:
        """Return whether the channel's program runs, and whether it can do anything by itself."""
        if not self.panel.is_running or self.executor.is_stopped or self.executor.is_resetting:
            return codes.AT_REST
        if self.path.is_active or self.panel.backward_motion or self.executor.waiting != 0:
            return codes.AT_WORK
        if self.queue.head < self.queue.tail:
            is_stuck = self.signals.is_stuck() or self.executor.spindle_exchange.is_stuck()
            return codes.STUCK if is_stuck else codes.AT_WORK
        is_stuck = self.signals.is_decoder_waiting or self.exchange.is_stuck()
        return codes.STUCK if is_stuck else codes.AT_WORK

    def is_idle(self) -> int:
        """Return whether nothing is queued or current, and no cycle waits for its block's end."""
        if self.queue.head < self.queue.tail or self.path.is_active:
            return 0
        return 1 if self.manager.in_block_count == 0 else 0

    def watch_queue(self, tick: int) -> None:
        """Record from when to when the path starves because the decoder is late."""
        is_empty = (
            self.queue.head == self.queue.tail
            and self.feed.decoder_open
            and not self.feed.wants_slot
        )
        can_go = not (self.path.is_active or self.executor.is_stopped or self.executor.is_resetting)
        can_go = can_go and not self.panel.is_paused
        if is_empty and can_go:
            if self.feed.starved_since < 0:
                self.feed.starved_since = tick
                self.record.event(rows.EVENT_STARVED, self.executor.taken_source)
        elif self.feed.starved_since >= 0:
            self.record.event(
                rows.EVENT_FED, self.executor.taken_source, tick - self.feed.starved_since
            )
            self.feed.starved_since = -1

    def begin_tick(self, tick: int) -> None:
        """Latch the PLC's answers and a reset; the CYCLE override is 100 % again (RC-305)."""
        self.context.begin(tick)
        if self.signals.awaits_tick:
            self.signals.awaits_tick = False
            self.feed.answer = 0.0
            self.feed.answer_ready = True
        if self.record.records_answers:
            self.hli.record_answers(self.record, codes.ACKNOWLEDGED, rows.EVENT_ACKNOWLEDGED)
        self.hli.latch()
        self.context.spindles.latch()
        if self.panel.is_watched:
            self.watch_plc()
        if self.panel.reset_pressed:
            self.begin_reset()
        elif self.panel.start_pressed and not self.executor.is_resetting:
            self.panel.take_start(not self.executor.is_stopped)
        if self.is_reset_due:
            self.is_reset_due = False
            if self.record.records_answers:
                self.hli.record_answers(self.record, codes.WAITING, rows.EVENT_DROPPED)
            self.hli.clear()
            self.manager.reset()
            for i in range(self.path.count):
                if not self.path.is_place_free(i):
                    self.context.single_axes.reset(self.path.members[i])
        self.cells[self.first_cell + cells.CHANNEL_OVERRIDE_VEL_CYCLE] = 100.0

    def watch_plc(self) -> None:
        """Enter the error state if the PLC has not shown in time that it lives."""
        if self.executor.is_stopped or self.executor.is_resetting or self.hli.has_default_plc():
            self.panel.silent_ticks = 0
        elif self.panel.silent_ticks > self.silence_ticks:
            self.executor.report(0, codes.PLC_SILENT, 0.0)

    def run_cycles(self) -> None:
        """Run all active realtime cycles once; none during a reset (RC-007)."""
        if self.executor.is_resetting:
            return
        if self.manager.run_cycles(self.context):
            self.executor.enter_error(self.context.fault)
        if self.context.user_reaction > 0:
            self.executor.stop_for_user(self.context.user_reaction)

    def interpolate(self) -> None:
        """Advance the path by a tick with the present override (RC-305, MO-5)."""
        factor = self.override()
        is_cutting = self.threads.is_cutting
        was_retracing = self.path.is_retracing
        is_stopping = (
            self.executor.is_stopped
            or self.executor.is_resetting
            or (self.panel.feed_hold and not is_cutting)
            or self.is_at_fixed_stop
            or (self.path.axes.locked_count > 0 and self.path.locked_axis() >= 0)
        )
        if self.executor.is_looping and not self.path.is_retracing:
            self.executor.prolong_loop()
        if self.measuring.watch(self.context.tick):
            is_stopping = True
        self.publish_block()
        self.path.publish_overrides(self.panel.override_pct, self.panel.feed_hold)
        is_single = self.panel.single_block and not is_cutting
        if is_single and not was_retracing:
            is_single = self.executor.single_block.stops_ahead() > 0
        if self.path.is_single != is_single:
            self.path.set_single(is_single)
        if is_cutting:
            has_time_left = self.threads.step(factor, is_stopping)
        elif self.path.is_retracing or self.panel.backward_motion:
            has_time_left = self.step_back(factor, is_stopping)
            is_stopping = is_stopping or (self.panel.backward_motion and self.path.history_size > 0)
        else:
            has_time_left = self.path.step(factor, is_stopping)
        if has_time_left:
            self.pass_block_ends(is_stopping)
        is_away = was_retracing or self.path.is_retracing
        if self.threads.state != codes.WITHOUT_THREAD or is_away:
            self.threads.settle()
        if self.threads.fault:
            number = self.threads.spindle_number()
            fault = self.threads.take_fault()
            if not self.executor.is_stopped:
                self.executor.report(self.threads.source, fault, number)
        total_pct = arithmetic.round_half_even(self.total_pct)
        self.cells[self.first_cell + cells.CHANNEL_OVERRIDE_VEL_TOTAL] = total_pct
        if self.fixed_stops.count > 0 and not self.path.is_retracing:
            self.watch_stops()
        if (factor == 0.0 and not is_stopping) or self.waits.has_warned_of_spindle:
            self.watch_spindle(factor)

    def watch_spindle(self, factor: float) -> None:
        """Warn once for each standstill in which the path waits for a spindle (G95, 900819)."""
        if factor != 0.0:
            self.waits.has_warned_of_spindle = False
        elif not self.waits.has_warned_of_spindle and self.waits.resting_spindle() > 0:
            self.waits.has_warned_of_spindle = True
            source = int(self.path.history_rows[self.path.row + rows.SOURCE])
            self.record.event(rows.EVENT_ERROR, source, 0, 900819)

    def watch_stops(self) -> None:
        """Brake at the fixed stop, and drop the rest of the block (MO-12)."""
        if self.fixed_stops.watch() and self.path.is_active:
            self.is_at_fixed_stop = True
        if self.is_at_fixed_stop and self.path.speed_v == 0.0:
            self.is_at_fixed_stop = False
            self.path.abandon()

    def override(self) -> float:
        """Return the factor of the current segment's prepared speed in this tick (RC-305).

        ``total_pct``: operator's, programmed and CYCLE part.
        """
        cycle_pct = self.cells[self.first_cell + cells.CHANNEL_OVERRIDE_VEL_CYCLE]
        if self.overrides.have_changed(self.panel.override_pct, cycle_pct):
            self.path.common_factor = self.overrides.parts(0) / 100.0
            self.path.unoverridden_factor = self.overrides.parts(1) / 100.0
        if self.path.is_active and not self.path.is_dwell:
            factor = self.overrides.factor(self.path.history_rows, self.path.row)
        else:
            factor = self.overrides.none()
        self.total_pct = self.overrides.total_pct
        return factor

    def step_back(self, factor: float, is_stopping: int) -> int:
        """Advance a tick of backward motion, or forward over the history (MO-7)."""
        if self.path.history_size == 0:
            if self.panel.turns_back:
                self.record.event(rows.EVENT_ERROR, 0, 0, 50453)
            return self.path.step(factor, is_stopping)
        if not self.path.is_retracing:
            is_held = self.executor.is_stopped or self.executor.is_resetting
            if is_held or not self.backward.can_take_over():
                self.warn_of_wait()
                return self.path.step(factor, 1)
            self.backward.leave()
            self.publish_block()
        has_time_left = self.backward.step(factor, is_stopping)
        if self.backward.entered >= 0.0:
            self.cells[self.first_cell + cells.CHANNEL_BLOCK] = self.backward.entered
        if self.backward.fault != 0:
            self.executor.report(
                self.backward.fault_source, self.backward.fault, self.path.refused_axis
            )
            self.backward.fault = 0
        return has_time_left

    def warn_of_wait(self) -> None:
        """Warn once that a program waits because nothing is left to walk back (50449)."""
        if self.panel.turns_back or self.executor.is_resetting:
            self.waits.has_warned_of_wait = False
        waits = self.queue.head < self.queue.tail and not self.path.is_active
        is_held = self.executor.is_stopped or self.executor.is_resetting
        if waits and not self.waits.has_warned_of_wait and not is_held:
            self.waits.has_warned_of_wait = True
            row = self.queue.head % self.queue.capacity * self.queue.width
            source = int(self.queue.rows[row + rows.SOURCE])
            self.record.event(rows.EVENT_ERROR, source, 0, 50449)

    def publish_block(self) -> None:
        """Publish N number and kind of this tick's block, its last tick included."""
        number = self.path.block_number() if self.path.is_active else 0.0
        self.cells[self.first_cell + cells.CHANNEL_BLOCK] = number
        is_rapid = 1.0 if self.path.is_active and self.path.is_rapid() else 0.0
        self.cells[self.first_cell + cells.CHANNEL_PATH_RAPID] = is_rapid

    def pass_block_ends(self, is_stopping: int) -> None:
        """Pass block ends in the tick; commands between are taken in the next one (RC-003).

        A block that it cannot take is an error; with speed left, it brakes on this block with the
        axes that are free, since it must not stop in a step (MO-1, MO-6).
        """
        position = max(self.queue.head, self.queue.started + 1)
        if self.path.is_single and self.path.speed_v == 0.0:
            return
        while position < self.queue.tail:
            row = position % self.queue.capacity * self.queue.width
            kind = int(self.queue.rows[row + rows.KIND])
            if kind == rows.SEGMENT:
                if self.threads.is_at_rest_before(self.queue.rows[row + rows.THREAD]):
                    return
                message = self.path.refusal(row, self.queue.rows)
                if message:
                    if self.path.speed_v == 0.0:
                        return
                    source = int(self.queue.rows[row + rows.SOURCE])
                    self.executor.report(source, message, self.path.refused_axis)
                    is_stopping = 1
                self.queue.started = position
                self.path.begin(row, self.queue.rows, self.path.left_t)
                if self.threads.state != codes.WITHOUT_THREAD:
                    self.threads.chain()
                if self.path.continues_block():
                    self.path.set_remaining(self.queue.remaining_of_block(position))
                if self.path.left_t > 0.0:
                    self.publish_block()
                if not self.path.step_carried(self.override(), is_stopping):
                    return
            elif not rows.is_transparent(kind):
                return
            position += 1

    def end_tick(self) -> None:
        """Answer waits for the path to come to rest; end a reset; publish (RC-005, RC-007)."""
        state = codes.CHANNEL_READY
        if self.executor.is_resetting:
            state = codes.CHANNEL_RESET
        elif self.executor.is_stopped:
            state = codes.CHANNEL_ERROR
        if self.path.is_at_rest():
            if not self.executor.is_stopped and not self.path.is_retracing:
                if self.executor.waiting == rows.LOOP_END:
                    row = self.queue.head % self.queue.capacity * self.queue.width
                    self.executor.leave_loop(int(self.queue.rows[row + rows.SOURCE]))
                waits = self.executor.waiting in (rows.FLUSH, rows.READ, rows.LOOP_END)
                if waits or self.are_axes_at_rest():
                    self.answer_waiting()
            if self.executor.is_resetting:
                self.end_reset()
        if self.context.single_axes.faults.open_count > 0:
            self.report_axes()
        if self.c_axis.is_active:
            self.c_axis.follow()
        self.context.spindles.step(self.context.tick, self.hli.has_default_plc())
        self.hli.run_default_plc(self.context.tick)
        self.executor.tool_lives.end_tick()
        self.panel.publish(state, self.executor.error_message)
        if self.path.history_size > 0:
            self.panel.show_history(self.backward.state(), self.path.used - self.path.oldest)
        self.cells[self.first_cell + cells.CHANNEL_PATH_SPEED] = self.path.speed_v
        self.cells[self.first_cell + cells.CHANNEL_CYCLES_ACTIVE] = self.manager.running_count
        self.cells[self.first_cell + cells.CHANNEL_PATH_DIST_TO_GO] = self.path.distance_to_go()
        self.path.publish_direction(self.cells, self.first_cell + cells.CHANNEL_TOOL_DIRECTION_X)

    def report_axes(self) -> None:
        """Enter the error state if an independent motion of the channel's axes has failed."""
        message = self.context.single_axes.take_faults(self.path.members, self.path.count)
        if message:
            self.executor.enter_error(message)

    def are_axes_at_rest(self) -> int:
        """Return whether the requested axes are at rest; a motion that never ends is an error."""
        if self.executor.waiting != rows.POSITIONS:
            return 0
        row = self.queue.head % self.queue.capacity * self.queue.width
        state = self.context.single_axes.request_state(self.queue.rows, row)
        if state > codes.AXIS_MOVES:
            source = int(self.queue.rows[row + rows.SOURCE])
            self.executor.report(source, 50766, self.context.single_axes.requested_axis)
            self.executor.axis_state = state
        return 1 if state == codes.AXIS_STOPPED else 0

    def answer_waiting(self) -> None:
        """Answer the flush or synchronous read at the head with the present values."""
        row = self.queue.head % self.queue.capacity * self.queue.width
        self.feed.answer = 0.0
        if self.executor.waiting == rows.READ:
            cell = int(self.queue.rows[row + rows.READ_CELL])
            self.feed.answer = self.cells[cell]
        if self.queue.rows[row + rows.IS_ANSWERED] != 0.0:
            self.feed.answer_ready = True
        self.executor.waiting = 0
        self.queue.head += 1
        self.queue.timed_count -= 1

    def end_reset(self) -> None:
        """End a reset once everything is at rest: drop the commands decoded ahead."""
        if not self.context.single_axes.all_free(self.path.members, self.path.count):
            return
        self.executor.is_resetting = False
        for i in range(self.path.count):
            if not self.path.is_place_free(i):
                self.context.single_axes.reopen(self.path.members[i])
        self.path.abandon()
        self.threads.clear()
        self.executor.give_up_loop()
        self.is_at_fixed_stop = False
        self.fixed_stops.clear()
        self.measuring.clear()
        self.queue.head = self.queue.tail
        self.queue.timed_count = 0
        self.queue.started = -1
        self.queue.last_segment = -1

    def set_signals(self, board: SignalBoard, number: int) -> None:
        """Set the signals that all channels share; the channel's number, from 1."""
        self.executor.set_signals(board, number)
        self.signals = self.executor.signals
        self.exchange.set_signals(self.signals)

    def request_reset(self) -> None:
        """Request a reset, which begins with the next tick."""
        self.begin_reset()

    def begin_reset(self) -> None:
        """Latch a reset: until the path is at rest, at least one tick (RC-007)."""
        self.executor.is_resetting = True
        self.is_reset_due = True
        self.executor.is_stopped = self.executor.is_fatal
        self.executor.error_pending = False
        self.executor.error_message = 0
        self.executor.waiting = 0
        self.feed.answer_ready = False
        self.signals.reset()
        self.exchange.reset()
        self.executor.spindle_exchange.reset()
        self.executor.program_ended = False
        self.panel.is_paused = False

    def clear_error(self) -> None:
        """Note that Python has read the error; the channel stays stopped until a reset."""
        self.executor.error_pending = False

    def accept_end(self) -> None:
        """Accept another program after M30; raise ``ValueError`` if none has ended."""
        if not self.executor.program_ended:
            raise ValueError("no program has ended")
        self.executor.program_ended = False
        self.executor.waiting = 0

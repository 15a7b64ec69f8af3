# SPDX-License-Identifier: MIT
"""Execution of the commands of a channel's queue, first in a tick (RC-003)."""

from __future__ import annotations

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.bounds import check_cells
from nctakt.kernel.base.record import Record
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.cycles import CycleManager
from nctakt.kernel.path.probing.fixed_stops import FixedStops
from nctakt.kernel.path.probing.measuring import Measuring
from nctakt.kernel.path.threads import Threads
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.kernel.tick.block_scope import BlockScope
from nctakt.kernel.tick.channel_signals import ChannelSignals
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.kernel.tick.early_outputs import EarlyOutputs
from nctakt.kernel.tick.signals import SignalBoard
from nctakt.kernel.tick.single_block import SingleBlock
from nctakt.kernel.tick.spindle_exchange import SpindleExchange
from nctakt.kernel.tick.tool_lives import ToolLifeReporter


class CommandExecutor:
    """Executes the commands of one channel's queue on its objects; holds the error state."""

    def __init__(
        self,
        memory: bytearray,
        first_cell: int,
        record: Record,
        hli: Hli,
        manager: CycleManager,
        timers: Timers,
        single_axes: SingleAxes,
        queue: CommandQueue,
    ) -> None:
        self.queue = queue
        self.path = queue.path
        check_cells(first_cell, cells.CHANNEL_TIMER, memory)
        self.cells = memoryview(memory).cast("d")
        self.characters = memoryview(memory)
        self.first_cell = first_cell
        self.record = record
        self.hli = hli
        self.panel = hli.panel
        self.single_block = SingleBlock(queue, self.panel)
        self.early_outputs = EarlyOutputs(queue, hli, record)
        self.tool_lives = ToolLifeReporter(queue, self.panel, record)
        self.manager = manager
        self.block_scope = BlockScope(manager, record)
        self.fixed_stops = FixedStops(queue.path, record)
        edge_cell = first_cell + cells.CHANNEL_MEAS_DELTA
        stops = self.fixed_stops
        self.measuring = Measuring(queue.path, hli, record, memory, edge_cell, stops)
        self.context = Context(memory, record, hli, timers, single_axes, manager.spindles)
        self.threads = Threads(queue.path, self.context)
        self.program_timers = timers
        self.signals = ChannelSignals(SignalBoard(), 1, queue, record)
        self.spindle_exchange = SpindleExchange(self.context, queue, self.signals, record)
        self.modal = 0
        self.waiting = 0
        self.taken_source = 0
        self.program_ended = False
        self.error_pending = False
        self.error_detail = 0.0
        self.axis_state = codes.AXIS_MOVES
        self.error_message = 0
        self.is_looping = False
        self.is_skipping = False
        self.is_between = False
        self.is_stopped = False
        self.is_fatal = False
        self.is_resetting = False

    def set_spindles(self, spindles: Spindles, max_open_actions: int) -> None:
        """Set the channel's spindles, and a cycle's number of open actions (P-CHAN-00480)."""
        self.context.spindles = spindles
        self.context.max_open_actions = max_open_actions
        self.manager.spindles = spindles
        self.threads.spindles = spindles
        rapid_cell = self.first_cell + cells.CHANNEL_PATH_RAPID
        spindles.cutting.axes, spindles.cutting.rapid_cell = self.path.axes, rapid_cell
        self.queue.look_ahead.limits.spindles = spindles

    def set_signals(self, board: SignalBoard, number: int) -> None:
        """Set the signals that all channels share; the channel's number, from 1."""
        self.signals = ChannelSignals(board, number, self.queue, self.record)
        self.spindle_exchange.begin(self.signals)

    def run_commands(self, tick: int) -> None:
        """Execute the commands of this tick; BLOCK cycles leave their block with them (RC-105)."""
        if self.manager.in_block_count > 0:
            self.block_scope.leave(self.queue)
        self.run_due_commands(tick)
        if self.block_scope.lingers:
            self.block_scope.leave(self.queue)
        if self.queue.has_early and not (self.is_stopped or self.is_resetting):
            if not (self.panel.is_paused or self.is_reversing()):
                self.early_outputs.put_out(tick)

    def run_due_commands(self, tick: int) -> None:
        """Execute commands in order until one takes time or has to wait (RC-003, RC-004)."""
        if self.is_stopped or self.is_resetting or self.is_reversing():
            return
        while self.queue.head < self.queue.tail and self.waiting == 0 and not self.is_stopped:
            if self.panel.is_paused:
                return
            if self.path.is_active and self.queue.started < self.queue.head:
                return
            if self.block_scope.lingers:
                self.block_scope.leave(self.queue)
            row = self.queue.head % self.queue.capacity * self.queue.width
            kind = int(self.queue.rows[row + rows.KIND])
            if kind == rows.LOOP_END and self.loop_repeats():
                self.queue.repeat_body()
                continue
            if self.is_between and not self.loop_repeats() and self.is_at_rest():
                self.is_skipping = True
            if self.is_skipping and kind != rows.LOOP_END:
                self.queue.timed_count -= self.queue.time_units(row)
            elif not self.enter_block(row):
                return
            elif not self.execute(tick, row, kind):
                self.block_scope.wait(self.queue)
                return
            else:
                self.is_between = kind == rows.LOOP_PASS
                if self.manager.armed_count > 0:
                    self.block_scope.pass_over(kind, self.taken_source)
            self.queue.head += 1

    def is_at_rest(self) -> int:
        """Return whether the path is at rest between two blocks with none started ahead."""
        moves = self.path.speed_v != 0.0 or self.path.is_active or self.path.continues_block()
        return 0 if moves or self.queue.started >= self.queue.head else 1

    def is_reversing(self) -> int:
        """Return whether the path walks over its history or is about to: no command is executed."""
        if self.path.is_retracing:
            return 1
        if not self.panel.backward_motion or self.path.history_size == 0:
            return 0
        return 1 if self.path.speed_v == 0.0 else 0

    def enter_block(self, row: int) -> int:
        """Return whether the command may be executed: single block stops before a block."""
        self.taken_source = int(self.queue.rows[row + rows.SOURCE])
        if self.single_block.permits():
            return 1
        self.record.event(rows.EVENT_PAUSED, self.taken_source)
        return 0

    def execute(self, tick: int, row: int, kind: int) -> int:
        """Execute the command at ``row``; return 0 if it stays at the head of the queue."""
        if kind in (rows.SEGMENT, rows.DWELL):
            return self.execute_block(row)
        if kind == rows.DEFINE_CYCLE:
            return self.execute_definition(tick, row)
        if kind == rows.CONTROL_CYCLE:
            return self.execute_control(tick, row)
        if kind == rows.TECHNOLOGY:
            return self.early_outputs.issue_at_its_place(tick, row)
        if kind == rows.AWAIT_ACKNOWLEDGE:
            if self.hli.program.is_waiting(int(self.queue.rows[row + rows.AWAITED_FUNCTION])):
                return 0
            self.queue.timed_count -= 1
            return 1
        if kind == rows.PROGRAM_END:
            return self.execute_program_end(tick, row)
        if kind == rows.SPINDLE:
            return self.execute_spindle(tick, row)
        if kind == rows.AWAIT_SPINDLE:
            return self.execute_spindle_wait(row)
        if kind == rows.MEASURE_END:
            return self.execute_measure_end(tick, row)
        if kind in (rows.SIGNAL, rows.AWAIT_SIGNAL, rows.REMOVE_SIGNAL):
            return self.execute_signal(tick, row, kind)
        if kind == rows.SPINDLE_AXIS:
            return self.execute_spindle_axis(tick, row)
        return self.execute_at_once(tick, row, kind)

    def execute_at_once(self, tick: int, row: int, kind: int) -> int:
        """Execute a command that never waits; return 0 for one that the decoder waits for."""
        if kind == rows.WRITE_VARIABLE:
            self.execute_write(row)
        elif kind == rows.WRITE_TEXT:
            self.execute_characters(row)
        elif rows.SET_OFFSET <= kind <= rows.SET_TURN or kind in (rows.COUPLE, rows.FEED_FORWARD):
            self.path.axes.execute(self.queue.rows, row, kind)
        elif kind == rows.SET_TRANSFORMATION:
            self.path.transform(self.queue.rows, row)
        elif kind in (rows.USER_ERROR, rows.USER_VALUE, rows.USER_TEXT, rows.USER_STOP):
            self.execute_user_error(row, kind)
        elif kind in (rows.CUTTING_SPEED, rows.SPINDLE_LIMITS):
            self.context.spindles.execute(self.queue.rows, row, kind)
        elif kind == rows.TIMER:
            timer = int(self.queue.rows[row + rows.TIMER_NUMBER])
            self.program_timers.command(int(self.queue.rows[row + rows.TIMER_ACTION]), timer, tick)
        elif kind == rows.CLEAR_HISTORY:
            self.path.forget()
        elif kind in (rows.MEASURE, rows.TOUCH, rows.TOUCH_END):
            self.execute_part(row, kind)
        elif rows.HOME <= kind <= rows.SOFTWARE_LIMITS or self.moves_alone(kind):
            self.execute_part(row, kind)
        elif kind == rows.FIXED_STOP:
            self.fixed_stops.execute(self.queue.rows, row)
        elif kind == rows.FIXED_STOP_END:
            self.execute_fixed_stop_end(row)
        elif kind == rows.LOOP_BEGIN:
            self.execute_loop(row)
        elif kind == rows.LOOP_PASS:
            self.cells[self.first_cell + cells.CHANNEL_LOOP_COUNT] += 1.0
        elif kind == rows.PROGRAM_STOP:
            self.queue.timed_count -= 1
            if self.panel.stop_for_program(self.queue.rows[row + rows.STOP_IS_OPTIONAL] != 0.0):
                self.record.event(rows.EVENT_PAUSED, int(self.queue.rows[row + rows.SOURCE]))
        elif kind == rows.GIVE_UP:
            self.queue.timed_count -= 1
            self.report(self.taken_source, int(self.queue.rows[row + rows.GIVE_UP_MESSAGE]), 0.0)
        elif kind == rows.SINGLE_STEP:
            self.single_block.execute(row)
        elif kind == rows.TOOL_LIFE:
            self.tool_lives.execute(row)
        elif kind == rows.MODAL_MARK:
            self.modal = int(self.queue.rows[row + rows.MODAL_NUMBER])
        elif kind in (rows.MESSAGE, rows.FREEZE, rows.BLOCK_MARK, rows.WAIT_MARK):
            self.record_event(row, kind)
        elif kind != rows.EMPTY_BLOCK:
            self.waiting = kind
            if kind == rows.POSITIONS:
                self.context.single_axes.finish_requested(self.queue.rows, row)
            return 0
        return 1

    def moves_alone(self, kind: int) -> int:
        """Return whether a command begins or ends an independent motion of an axis."""
        return 1 if rows.MOVE_ALONE <= kind <= rows.END_OSCILLATION else 0

    def record_event(self, row: int, kind: int) -> None:
        """Record a command that is nothing but an event."""
        source = int(self.queue.rows[row + rows.SOURCE])
        if kind == rows.MESSAGE:
            number = int(self.queue.rows[row + rows.MESSAGE_TEXT])
            self.record.event(rows.EVENT_MESSAGE, source, number)
        elif kind == rows.FREEZE:
            serial = int(self.queue.rows[row + rows.FROZEN_CYCLE])
            name = self.queue.rows[row + rows.FROZEN_NAME]
            value = self.queue.rows[row + rows.FROZEN_VALUE]
            self.record.event(rows.EVENT_FROZEN, source, serial, name, value)
        elif kind == rows.BLOCK_MARK:
            number = int(self.queue.rows[row + rows.BLOCK_NUMBER])
            decoded_tick = self.queue.rows[row + rows.MARK_TICK]
            calls = self.queue.rows[row + rows.MARK_CALLS]
            depth = self.queue.rows[row + rows.MARK_DEPTH]
            self.record.event(rows.EVENT_BLOCK, source, number, decoded_tick, calls, depth)
        else:
            reason = int(self.queue.rows[row + rows.WAIT_REASON])
            cell = self.queue.rows[row + rows.WAIT_CELL]
            self.record.event(rows.EVENT_WAIT, source, reason, cell)

    def execute_block(self, row: int) -> int:
        """Make a segment or dwell current, unless the path has passed its start already.

        BLOCK cycles programmed before it run with it, or once if it is already over (RC-105).
        """
        has_thread = self.queue.has_thread(row)
        if has_thread and self.queue.head > self.queue.started:
            if self.panel.feed_hold or not self.threads.may_begin(self.queue.rows, row):
                return 0
        self.queue.timed_count -= self.queue.time_units(row)
        if self.queue.head <= self.queue.started:
            is_current = self.queue.head == self.queue.started and self.path.is_active
            serial = self.path.serial if is_current else codes.BLOCK_IS_OVER
            self.block_scope.move(self.queue, row, serial)
            if self.queue.head == self.queue.started:
                self.queue.started = -1
            return 1
        if self.queue.rows[row + rows.KIND] == rows.SEGMENT:
            message = self.path.refusal(row, self.queue.rows)
            if message:
                self.report(
                    int(self.queue.rows[row + rows.SOURCE]), message, self.path.refused_axis
                )
                return 1
        self.path.begin(row, self.queue.rows, 0.0)
        if self.path.continues_block():
            self.path.set_remaining(self.queue.remaining_of_block(self.queue.head))
        if has_thread:
            self.threads.begin()
        self.block_scope.move(self.queue, row, self.path.serial)
        return 1

    def execute_definition(self, tick: int, row: int) -> int:
        """Define a realtime cycle."""
        slot = int(self.queue.rows[row + rows.CYCLE_SLOT])
        message = self.manager.define(slot, int(self.queue.rows[row + rows.CYCLE_STARTS]), tick)
        if message != 0:
            source = int(self.queue.rows[row + rows.SOURCE])
            self.report(source, message, self.manager.refused_value(slot, message))
        return 1

    def execute_control(self, tick: int, row: int) -> int:
        """Carry out a management command; DELETE and HOLD may have to wait (RC-004)."""
        source = int(self.queue.rows[row + rows.SOURCE])
        action = int(self.queue.rows[row + rows.CONTROL_ACTION])
        identity = int(self.queue.rows[row + rows.CONTROL_IDENTITY])
        if action in (codes.CONTROL_HOLD, codes.CONTROL_DELETE) and self.manager.started_this_tick(
            identity, tick
        ):
            return 0
        message = self.manager.control(action, identity, tick, source)
        if message != 0:
            self.report(source, message, identity)
        return 1

    def execute_spindle_axis(self, tick: int, row: int) -> int:
        """Let a spindle give its axis, or take it again; while it turns that is 60137."""
        result = self.spindle_exchange.execute(tick, row)
        if result > 1:
            spindle = int(self.queue.rows[row + rows.GIVING_SPINDLE])
            number = self.context.spindles.first_number + spindle
            self.report(int(self.queue.rows[row + rows.SOURCE]), result, number)
        return 1 if result else 0

    def execute_spindle(self, tick: int, row: int) -> int:
        """Give a spindle its job; wait until the spindle can take it."""
        spindle = int(self.queue.rows[row + rows.JOB_SPINDLE])
        if not self.context.spindles.is_ready(spindle, tick):
            return 0
        self.context.spindles.command(
            spindle,
            int(self.queue.rows[row + rows.JOB_FUNCTION]),
            self.queue.rows[row + rows.JOB_SPEED],
            self.queue.rows[row + rows.JOB_POSITION],
            int(self.queue.rows[row + rows.JOB_DIRECTION]),
            0,
            tick,
            int(self.queue.rows[row + rows.JOB_IGNORES_OVERRIDE]),
        )
        self.context.spindles.record_job(spindle, int(self.queue.rows[row + rows.SOURCE]), 0)
        ticks = int(self.queue.rows[row + rows.JOB_TICKS])
        self.context.spindles.hand_over(spindle, tick + ticks)
        return 1

    def execute_spindle_wait(self, row: int) -> int:
        """Wait for speed or position of a spindle; a held job would never reach it."""
        spindle = int(self.queue.rows[row + rows.JOB_SPINDLE])
        if self.context.spindles.is_busy(spindle):
            if not self.context.spindles.is_held[spindle]:
                return 0
            number = self.context.spindles.first_number + spindle
            self.report(int(self.queue.rows[row + rows.SOURCE]), 900811, number)
        self.queue.timed_count -= 1
        return 1

    def execute_write(self, row: int) -> None:
        """Write a synchronous variable (RC-308)."""
        cell = int(self.queue.rows[row + rows.VARIABLE_CELL])
        self.cells[cell] = self.queue.rows[row + rows.VARIABLE_VALUE]
        if self.queue.rows[row + rows.VARIABLE_IS_REPORTED] != 0.0:
            self.record.written(int(self.queue.rows[row + rows.SOURCE]), 0, cell, self.cells[cell])

    def execute_characters(self, row: int) -> None:
        """Write a part of a string, and zeros after it."""
        cell = int(self.queue.rows[row + rows.TEXT_CELL])
        first = int(self.queue.rows[row + rows.TEXT_FIRST])
        first += 8 * cell
        count = int(self.queue.rows[row + rows.TEXT_COUNT])
        zeros = int(self.queue.rows[row + rows.TEXT_ZEROS])
        for i in range(count):
            self.characters[first + i] = int(self.queue.rows[row + rows.TEXT_CHARACTERS + i])
        for i in range(count, count + zeros):
            self.characters[first + i] = 0

    def execute_loop(self, row: int) -> None:
        """Begin a realtime loop; without its condition it is skipped."""
        self.cells[self.first_cell + cells.CHANNEL_LOOP_COUNT] = 0.0
        self.is_looping = self.cells[self.first_cell + cells.CHANNEL_LOOP_ENABLED] != 0.0
        self.is_skipping = not self.is_looping
        self.panel.show_loop(self.is_looping)
        source = int(self.queue.rows[row + rows.SOURCE])
        how = rows.LOOP_SKIPPED if self.is_skipping else rows.LOOP_BEGUN
        self.record.event(rows.EVENT_LOOP, source, how)
        self.prolong_loop()

    def prolong_loop(self) -> None:
        """Keep another pass ahead of the path while the loop's condition holds."""
        if self.loop_repeats():
            while self.queue.needs_pass():
                self.queue.repeat_body()

    def execute_fixed_stop_end(self, row: int) -> None:
        """End the block that moves to a fixed stop."""
        self.queue.timed_count -= 1
        member = self.fixed_stops.missing()
        if member >= 0:
            source = int(self.queue.rows[row + rows.SOURCE])
            self.report(source, 50886, self.path.members[member])

    def execute_part(self, row: int, kind: int) -> None:
        """Hand a command to the probes or the axes, and report the message that refuses it."""
        source = int(self.queue.rows[row + rows.SOURCE])
        message = 0
        if kind == rows.MEASURE:
            self.measuring.edge_probe.arm(source, self.queue.rows, row)
        elif kind == rows.TOUCH:
            message = self.measuring.touch_probe.arm(source, self.queue.rows, row)
        elif kind == rows.TOUCH_END:
            message = self.measuring.touch_probe.finish()
        else:
            message = self.context.single_axes.execute(self.queue.rows, row, kind)
            if kind == rows.REFER or self.moves_alone(kind):
                self.path.forget()
        if message:
            self.context.fault_a = self.queue.rows[row + rows.HOMED_AXIS]
            self.context.fault_b = self.queue.rows[row + rows.HOMING_DISTANCE]
            self.report(source, message, self.queue.rows[row + rows.HOMED_AXIS])

    def execute_measure_end(self, tick: int, row: int) -> int:
        """Finish measuring in a block; return 0 while its function waits for the PLC."""
        outcome = self.measuring.edge_probe.finish(tick)
        if outcome == 0:
            return 0
        self.queue.timed_count -= 1
        if outcome < 0:
            self.report(int(self.queue.rows[row + rows.SOURCE]), 50891, 0.0)
        return 1

    def loop_repeats(self) -> int:
        """Return whether the condition of the current loop holds."""
        is_enabled = self.cells[self.first_cell + cells.CHANNEL_LOOP_ENABLED] != 0.0
        return 1 if self.is_looping and is_enabled else 0

    def leave_loop(self, source: int) -> None:
        """Leave the loop at its end, since the condition does not hold."""
        if self.is_looping:
            self.record.event(rows.EVENT_LOOP, source, rows.LOOP_LEFT)
        self.give_up_loop()

    def give_up_loop(self) -> None:
        """Forget the loop."""
        self.is_looping = False
        self.is_skipping = False
        self.is_between = False
        self.panel.show_loop(False)
        self.queue.loop_body.give_up()

    def execute_program_end(self, tick: int, row: int) -> int:
        """End the program (M30), not in the tick of a cycle's start (RC-004, RC-106)."""
        if self.manager.has_started_this_tick(tick):
            return 0
        self.queue.timed_count -= 1
        self.path.forget()
        self.fixed_stops.clear()
        self.measuring.clear()
        self.context.single_axes.finish_swings(self.path.members, self.path.count)
        self.manager.end_program()
        program = int(self.queue.rows[row + rows.PROGRAM_NUMBER])
        source = int(self.queue.rows[row + rows.SOURCE])
        self.record.event(rows.EVENT_PROGRAM_END, source, program)
        self.program_ended = True
        self.waiting = rows.PROGRAM_END
        return 1

    def execute_signal(self, tick: int, row: int, kind: int) -> int:
        """Send, await or remove signals; return 0 while one is waited for."""
        outcome = self.signals.execute(tick, row, kind)
        if outcome == 0:
            return 0
        self.queue.timed_count -= self.queue.time_units(row)
        if outcome > 1:
            source = int(self.queue.rows[row + rows.SOURCE])
            self.report(source, outcome, self.signals.board.blocking)
        return 1

    def execute_user_error(self, row: int, kind: int) -> None:
        """Record ``#ERROR`` of the main program and its values; RC may stop the channel."""
        source = int(self.queue.rows[row + rows.SOURCE])
        if kind == rows.USER_ERROR:
            identity = self.queue.rows[row + rows.ERROR_IDENTITY]
            reaction = self.queue.rows[row + rows.ERROR_REACTION]
            self.record.event(rows.EVENT_USER_ERROR, source, 0, identity, reaction)
        elif kind == rows.USER_STOP:
            self.queue.timed_count -= 1
            self.stop_for_user(int(self.queue.rows[row + rows.STOP_REACTION]))
        elif kind == rows.USER_TEXT:
            keyword = self.queue.rows[row + rows.USER_TEXT_KEYWORD]
            text = self.queue.rows[row + rows.USER_TEXT_NUMBER]
            self.record.event(rows.EVENT_USER_TEXT, source, 0, keyword, text)
        else:
            keyword = self.queue.rows[row + rows.VALUE_KEYWORD]
            value = self.queue.rows[row + rows.VALUE_NUMBER]
            self.record.event(rows.EVENT_USER_VALUE, source, 0, keyword, value)

    def stop_for_user(self, reaction: int) -> None:
        """Enter the error state by ``#ERROR`` with RC from 1 on, with RC 7 for good."""
        self.enter_error(900464)
        if reaction == codes.FATAL_REACTION:
            self.error_message = 900465
            self.is_fatal = True

    def enter_error(self, message: int) -> None:
        """Enter the error state: no command is executed, the path brakes."""
        self.error_message = message
        self.error_pending = True
        self.is_stopped = True

    def report(self, source: int, message: int, detail: float) -> None:
        """Record an error and enter the error state; the path brakes (RC-505)."""
        self.record.event(rows.EVENT_ERROR, source, 0, message, detail)
        self.error_detail = detail
        self.axis_state = codes.AXIS_MOVES
        self.enter_error(message)

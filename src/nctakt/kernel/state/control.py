# SPDX-License-Identifier: MIT
"""The state of channels, cycles, record and kernel: as ``axes.py``.

The rows of a record are not among its arrays: what has been taken from it is not read again.
"""

from __future__ import annotations

from collections.abc import Callable
from types import MappingProxyType
from typing import Any

from nctakt.kernel.base.record import Record
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.cycles.actions import FeedMemory
from nctakt.kernel.cycles.branches import IfAlways, IfEdge, IfOnce, Reaction
from nctakt.kernel.cycles.conditions import Condition
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.cycles import CycleManager, RealtimeCycle
from nctakt.kernel.cycles.instructions import Counted
from nctakt.kernel.kernel import Kernel
from nctakt.kernel.plc.axis_requests import AxisRequests
from nctakt.kernel.plc.panel import Panel
from nctakt.kernel.plc.technology_slots import Hli, Section
from nctakt.kernel.tick.axis_exchange import AxisExchange
from nctakt.kernel.tick.block_scope import BlockScope
from nctakt.kernel.tick.channel import Channel
from nctakt.kernel.tick.channel_signals import ChannelSignals
from nctakt.kernel.tick.command_execution import CommandExecutor
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.kernel.tick.loop_body import LoopBody
from nctakt.kernel.tick.signals import SignalBoard
from nctakt.kernel.tick.tool_lives import ToolLives

Arrays = tuple[Any, ...]


def copy_record(source: Record, target: Record) -> None:
    target.signals = source.signals
    target.rows = source.rows
    target.events = source.events
    target.probes = source.probes
    target.signal_count = source.signal_count
    target.row_count = source.row_count
    target.event_capacity = source.event_capacity
    target.event_count = source.event_count
    target.probe_capacity = source.probe_capacity
    target.probe_count = source.probe_count
    target.tick = source.tick
    target.channel = source.channel
    target.records_writes = source.records_writes
    target.records_series = source.records_series
    target.records_answers = source.records_answers


def arrays_of_record(part: Record) -> Arrays:
    return (
        part.cells,
        part.signals,
    )


def arrays_of_timers(part: Timers) -> Arrays:
    return (
        part.cells,
        part.is_running,
        part.started_tick,
        part.elapsed_ticks,
    )


def copy_feed_memory(source: FeedMemory, target: FeedMemory) -> None:
    target.speed_v = source.speed_v


def copy_reaction(source: Reaction, target: Reaction) -> None:
    target.count = source.count
    target.first_tick = source.first_tick
    target.next_tick = source.next_tick
    target.last_run = source.last_run


def copy_if_once(source: IfOnce, target: IfOnce) -> None:
    target.is_done = source.is_done


def copy_if_edge(source: IfEdge, target: IfEdge) -> None:
    target.was_true = source.was_true


def copy_if_always(source: IfAlways, target: IfAlways) -> None:
    target.is_latched = source.is_latched


def copy_condition(source: Condition, target: Condition) -> None:
    target.probe = source.probe
    target.truth = source.truth
    target.next_tick = source.next_tick
    target.was_ever_true = source.was_ever_true
    target.nearest = source.nearest
    target.nearest_left = source.nearest_left
    target.nearest_right = source.nearest_right
    target.nearest_tick = source.nearest_tick


def copy_context(source: Context, target: Context) -> None:
    target.max_open_actions = source.max_open_actions
    target.tick = source.tick
    target.serial = source.serial
    target.run = source.run
    target.owner = source.owner
    target.fault = source.fault
    target.user_reaction = source.user_reaction
    target.fault_source = source.fault_source
    target.fault_a = source.fault_a
    target.fault_b = source.fault_b
    target.steps = source.steps
    target.check_at = source.check_at
    target.max_steps = source.max_steps
    target.cont_steps = source.cont_steps
    target.budget_steps = source.budget_steps


def arrays_of_context(part: Context) -> Arrays:
    return (part.cells,)


def copy_realtime_cycle(source: RealtimeCycle, target: RealtimeCycle) -> None:
    target.slot = source.slot
    target.next_tick = source.next_tick
    target.runs = source.runs
    target.serial = source.serial
    target.probe = source.probe
    target.events = source.events
    target.probes = source.probes


def copy_cycle_manager(source: CycleManager, target: CycleManager) -> None:
    target.capacity = source.capacity
    target.memory_limit = source.memory_limit
    target.memory_used = source.memory_used
    target.loaded = list(source.loaded)
    target.loaded_count = source.loaded_count
    target.root = source.root
    target.latest_start = source.latest_start
    target.running_count = source.running_count
    target.armed_count = source.armed_count
    target.in_block_count = source.in_block_count
    target.ended_count = source.ended_count
    target.events_bound = source.events_bound
    target.probes_bound = source.probes_bound


def arrays_of_cycle_manager(part: CycleManager) -> Arrays:
    return (
        part.state,
        part.identity,
        part.scope,
        part.source,
        part.serial,
        part.reusable,
        part.restarts,
        part.started_tick,
        part.block,
        part.size,
        part.moves_on,
        part.order,
    )


def copy_counted(source: Counted, target: Counted) -> None:
    target.source = source.source


def copy_kernel(source: Kernel, target: Kernel) -> None:
    target.ends_deadlock = source.ends_deadlock
    target.is_stopped = source.is_stopped
    target.tick = source.tick
    target.input_count = source.input_count
    target.input_capacity = source.input_capacity
    target.input_cells = source.input_cells
    target.input_words = source.input_words


def arrays_of_kernel(part: Kernel) -> Arrays:
    return (
        part.words,
        part.input_cells,
        part.input_words,
    )


def copy_axis_requests(source: AxisRequests, target: AxisRequests) -> None:
    target.capacity = source.capacity
    target.posted = source.posted
    target.latched = source.latched


def arrays_of_axis_requests(part: AxisRequests) -> Arrays:
    return (
        part.kind,
        part.axis,
        part.value,
        part.speed_v,
        part.mode,
        part.direction,
        part.answer,
    )


def copy_panel(source: Panel, target: Panel) -> None:
    target.override_pct = source.override_pct
    target.feed_hold = source.feed_hold
    target.single_block = source.single_block
    target.plc_present = source.plc_present
    target.start_pressed = source.start_pressed
    target.reset_pressed = source.reset_pressed
    target.is_armed = source.is_armed
    target.is_running = source.is_running
    target.is_paused = source.is_paused
    target.is_released = source.is_released
    target.is_step_locked = source.is_step_locked
    target.step_resolution = source.step_resolution
    target.backward_motion = source.backward_motion
    target.turns_back = source.turns_back
    target.probe = source.probe
    target.optional_stop = source.optional_stop
    target.block_line = source.block_line
    target.block_moves = source.block_moves
    target.start_taken = source.start_taken
    target.reset_taken = source.reset_taken


def arrays_of_panel(part: Panel) -> Arrays:
    return (part.cells,)


def copy_section(source: Section, target: Section) -> None:
    target.last_slot = source.last_slot
    target.issued_in_tick = source.issued_in_tick
    target.taken_count = source.taken_count
    target.issued = source.issued
    target.version = source.version


def arrays_of_section(part: Section) -> Arrays:
    return (
        part.state,
        part.function,
        part.sequence,
        part.tick,
        part.serial,
        part.value,
        part.done,
    )


def copy_hli(source: Hli, target: Hli) -> None:
    target.acknowledges_itself = source.acknowledges_itself


def copy_block_scope(source: BlockScope, target: BlockScope) -> None:
    target.serial = source.serial
    target.position = source.position
    target.source = source.source
    target.has_moved = source.has_moved
    target.lingers = source.lingers
    target.passed_source = source.passed_source


def copy_channel(source: Channel, target: Channel) -> None:
    target.is_at_fixed_stop = source.is_at_fixed_stop
    target.total_pct = source.total_pct
    target.decoder_open = source.decoder_open
    target.wants_slot = source.wants_slot
    target.answer = source.answer
    target.answer_ready = source.answer_ready
    target.is_reset_due = source.is_reset_due
    target.is_paced = source.is_paced
    target.starved_since = source.starved_since
    target.has_warned_of_wait = source.has_warned_of_wait
    target.has_warned_of_spindle = source.has_warned_of_spindle


def arrays_of_channel(part: Channel) -> Arrays:
    return (part.cells,)


def copy_tool_lives(source: ToolLives, target: ToolLives) -> None:
    target.sent = source.sent


def copy_command_executor(source: CommandExecutor, target: CommandExecutor) -> None:
    target.modal = source.modal
    target.waiting = source.waiting
    target.taken_source = source.taken_source
    target.program_ended = source.program_ended
    target.error_pending = source.error_pending
    target.error_detail = source.error_detail
    target.axis_state = source.axis_state
    target.error_message = source.error_message
    target.is_looping = source.is_looping
    target.is_skipping = source.is_skipping
    target.is_between = source.is_between
    target.is_stopped = source.is_stopped
    target.is_fatal = source.is_fatal
    target.is_resetting = source.is_resetting


def arrays_of_command_executor(part: CommandExecutor) -> Arrays:
    return (
        part.cells,
        part.characters,
    )


def copy_command_queue(source: CommandQueue, target: CommandQueue) -> None:
    target.capacity = source.capacity
    target.rows = source.rows
    target.head = source.head
    target.tail = source.tail
    target.timed_count = source.timed_count
    target.started = source.started
    target.last_segment = source.last_segment
    target.transformation = source.transformation


def arrays_of_command_queue(part: CommandQueue) -> Arrays:
    return (
        part.rows,
        part.end_row,
    )


def copy_loop_body(source: LoopBody, target: LoopBody) -> None:
    target.rows = source.rows
    target.count = source.count
    target.is_open = source.is_open
    target.is_complete = source.is_complete
    target.ends_at_standstill = source.ends_at_standstill


def arrays_of_loop_body(part: LoopBody) -> Arrays:
    return (part.rows,)


def copy_signal_board(source: SignalBoard, target: SignalBoard) -> None:
    target.count = source.count
    target.received_mask = source.received_mask
    target.taken_sender = source.taken_sender
    target.taken_tick = source.taken_tick
    target.blocking = source.blocking
    target.has_waited = source.has_waited


def arrays_of_signal_board(part: SignalBoard) -> Arrays:
    return (
        part.number,
        part.sender,
        part.receiver,
        part.remaining,
        part.level,
        part.tick,
        part.mask,
        part.values,
        part.received,
    )


def copy_axis_exchange(source: AxisExchange, target: AxisExchange) -> None:
    target.is_waiting = source.is_waiting
    target.source = source.source
    target.since = source.since


def arrays_of_axis_exchange(part: AxisExchange) -> Arrays:
    return (part.awaited,)


def copy_channel_signals(source: ChannelSignals, target: ChannelSignals) -> None:
    target.is_decoder_waiting = source.is_decoder_waiting
    target.awaited_number = source.awaited_number
    target.awaited_senders = source.awaited_senders
    target.may_overtake = source.may_overtake
    target.awaited_source = source.awaited_source
    target.waiting_since = source.waiting_since
    target.blocked_since = source.blocked_since
    target.awaits_tick = source.awaits_tick


#: Class -> what copies its state.
COPIERS: MappingProxyType[type, Callable[..., None]] = MappingProxyType(
    {
        Record: copy_record,
        FeedMemory: copy_feed_memory,
        Reaction: copy_reaction,
        IfOnce: copy_if_once,
        IfEdge: copy_if_edge,
        IfAlways: copy_if_always,
        Condition: copy_condition,
        Context: copy_context,
        RealtimeCycle: copy_realtime_cycle,
        CycleManager: copy_cycle_manager,
        Counted: copy_counted,
        Kernel: copy_kernel,
        AxisRequests: copy_axis_requests,
        Panel: copy_panel,
        Section: copy_section,
        Hli: copy_hli,
        BlockScope: copy_block_scope,
        ToolLives: copy_tool_lives,
        Channel: copy_channel,
        CommandExecutor: copy_command_executor,
        CommandQueue: copy_command_queue,
        LoopBody: copy_loop_body,
        SignalBoard: copy_signal_board,
        AxisExchange: copy_axis_exchange,
        ChannelSignals: copy_channel_signals,
    }
)

#: Class -> what returns its arrays.
ARRAYS: MappingProxyType[type, Callable[..., Arrays]] = MappingProxyType(
    {
        AxisExchange: arrays_of_axis_exchange,
        Record: arrays_of_record,
        Timers: arrays_of_timers,
        Context: arrays_of_context,
        CycleManager: arrays_of_cycle_manager,
        Kernel: arrays_of_kernel,
        AxisRequests: arrays_of_axis_requests,
        Panel: arrays_of_panel,
        Section: arrays_of_section,
        Channel: arrays_of_channel,
        CommandExecutor: arrays_of_command_executor,
        CommandQueue: arrays_of_command_queue,
        LoopBody: arrays_of_loop_body,
        SignalBoard: arrays_of_signal_board,
    }
)

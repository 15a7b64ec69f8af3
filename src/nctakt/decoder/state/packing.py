# SPDX-License-Identifier: MIT
"""A command of the decoder -> a row of the queue, its columns in the order of ``kernel/rows.py``.

Segments are not packed but prepared in the queue (``CommandQueue.put_segment``).
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.decoder.state.axis_commands import FeedForward, Home, Refer, SetSoftwareLimits
from nctakt.decoder.state.commands import (
    AwaitAcknowledge,
    AwaitSignal,
    BlockMark,
    ClearHistory,
    Command,
    CycleControl,
    Dwell,
    EmptyBlock,
    FixedStop,
    FixedStopEnd,
    Flush,
    Freeze,
    GiveUp,
    LoadCycle,
    LoopBegin,
    LoopEnd,
    LoopPass,
    Measure,
    MeasureEnd,
    PositionRequest,
    ProgramEnd,
    ProgramStop,
    ProgramTimer,
    ReadRealtime,
    RemoveSignals,
    Segment,
    SendSignal,
    SetOffset,
    SetOrigin,
    SetTransformation,
    SetTurn,
    TechnologyOutput,
    UserErrorReport,
    UserErrorStop,
    UserErrorValue,
    UserMessage,
    WaitMark,
    WriteText,
    WriteVariable,
)
from nctakt.decoder.state.couplings import Couple
from nctakt.decoder.state.in_force import ModalMark
from nctakt.decoder.state.limit_commands import SetLimits
from nctakt.decoder.state.probe_commands import Touch, TouchEnd
from nctakt.decoder.state.spindle_commands import (
    AwaitSpindle,
    CuttingSpeed,
    SpindleJob,
    SpindleLimits,
)
from nctakt.decoder.state.start_block import SingleStep, StartReached
from nctakt.decoder.state.tool_life import ToolLife, ToolLifeFactors
from nctakt.kernel import codes, rows


def pack(command: Command, reference: int = 0) -> list[float]:
    """Return the row of a command.

    ``reference`` is the slot of a cycle or the number of a text or program.
    """
    head = (command.source, command.number)
    row: list[float]
    match command:
        case Dwell():
            return [rows.DWELL, *head, command.ticks]
        case LoadCycle():
            return [rows.DEFINE_CYCLE, *head, reference, not command.definition_only]
        case CycleControl():
            return [rows.CONTROL_CYCLE, *head, command.action, command.identity]
        case TechnologyOutput():
            row = [rows.TECHNOLOGY, *head, command.function, command.ticks]
            return [*row, command.value is not None, command.value or 0]
        case AwaitAcknowledge():
            return [rows.AWAIT_ACKNOWLEDGE, *head, command.function]
        case SpindleJob():
            row = [rows.SPINDLE, *head, command.spindle, command.function, command.speed_v]
            row += [command.position, command.direction, command.ticks]
            return [*row, command.ignores_override]
        case AwaitSpindle():
            return [rows.AWAIT_SPINDLE, *head, command.spindle]
        case WriteVariable():
            return [rows.WRITE_VARIABLE, *head, command.cell, command.value, command.is_reported]
        case WriteText():
            row = [rows.WRITE_TEXT, *head, command.cell, command.first, len(command.data)]
            return [*row, command.zeros, *command.data]
        case UserMessage():
            return [rows.MESSAGE, *head, reference]
        case SetOffset():
            return [rows.SET_OFFSET, *head, command.axis, command.kind, command.value]
        case SetOrigin():
            return [rows.SET_ORIGIN, *head, command.axis, command.value]
        case SetTurn():
            first, second, third = command.axes
            if not command.matrix:
                return [rows.SET_TURN, *head, first]
            return [rows.SET_TURN, *head, first, second + 1, third + 1, *command.matrix]
        case SetTransformation():
            return [rows.SET_TRANSFORMATION, *head, command.map_number, command.of_segments]
        case Freeze():
            return [rows.FREEZE, *head, command.serial, reference, command.value]
        case UserErrorReport():
            return [rows.USER_ERROR, *head, command.identity, command.reaction]
        case UserErrorValue():
            kind = rows.USER_TEXT if command.is_text else rows.USER_VALUE
            return [kind, *head, command.code, command.content]
        case UserErrorStop():
            return [rows.USER_STOP, *head, command.reaction]
        case Flush():
            return [rows.FLUSH, *head, command.waits]
        case ReadRealtime():
            return [rows.READ, *head, True, command.cell]
        case PositionRequest():
            return [rows.POSITIONS, *head, True, len(command.axes), *command.axes]
        case BlockMark():
            return [rows.BLOCK_MARK, *head, reference, command.calls, command.depth]
        case ModalMark():
            return [rows.MODAL_MARK, *head, command.modal]
        case WaitMark():
            return [rows.WAIT_MARK, *head, command.reason, command.cell]
        case ProgramTimer():
            return [rows.TIMER, *head, command.timer, command.action]
        case FixedStop():
            row = [rows.FIXED_STOP, *head, command.axis, command.is_on, command.limit]
            return [*row, command.ticks, command.begin, command.end, command.needed]
        case Measure():
            row = [rows.MEASURE, *head, command.function, command.ticks, command.residual]
            return [*row, command.value is not None, command.value or 0]
        case Touch():
            row = [rows.TOUCH, *head, command.part, command.ticks, command.level]
            return [*row, command.continues, command.needed, command.may_be_pressed]
        case TouchEnd():
            return [rows.TOUCH_END, *head]
        case Home():
            return [rows.HOME, *head, command.axis, command.distance, command.speed]
        case Refer():
            return [rows.REFER, *head, command.axis, command.position]
        case SetSoftwareLimits():
            return [rows.SOFTWARE_LIMITS, *head, command.axis, command.low, command.high]
        case Couple():
            row = [rows.COUPLE, *head, command.slave, command.master]
            return [*row, command.factor, command.allowed_d]
        case FeedForward():
            return [rows.FEED_FORWARD, *head, command.axis, command.share]
        case SingleStep():
            resolution = -1 if command.resolution is None else command.resolution
            return [rows.SINGLE_STEP, *head, command.is_disabled, resolution]
        case ToolLife():
            row = [rows.TOOL_LIFE, *head, command.action, command.tool, command.basic]
            return [*row, command.time, command.distance]
        case ToolLifeFactors():
            row = [rows.TOOL_LIFE, *head, codes.LIFE_FACTORS, 0, 0]
            return [*row, command.time, command.distance]
        case ClearHistory():
            return [rows.CLEAR_HISTORY, *head]
        case CuttingSpeed():
            row = [rows.CUTTING_SPEED, *head, command.spindle, command.surface_v]
            return [*row, command.axis, command.centre, command.limit_v]
        case SpindleLimits():
            row = [rows.SPINDLE_LIMITS, *head, command.spindle, command.low_v]
            return [*row, command.high_v, command.acceleration, command.jerk, command.step]
        case EmptyBlock():
            return [rows.EMPTY_BLOCK, *head]
        case MeasureEnd():
            return [rows.MEASURE_END, *head]
        case FixedStopEnd():
            return [rows.FIXED_STOP_END, *head]
        case LoopBegin():
            return [rows.LOOP_BEGIN, *head]
        case LoopPass():
            return [rows.LOOP_PASS, *head]
        case LoopEnd():
            return [rows.LOOP_END, *head, True]
        case ProgramEnd():
            return [rows.PROGRAM_END, *head, reference]
        case ProgramStop():
            return [rows.PROGRAM_STOP, *head, command.is_optional]
        case SendSignal():
            row = [rows.SIGNAL, *head, command.signal, command.receivers, command.count]
            return [*row, command.mask, *command.values]
        case AwaitSignal():
            row = [rows.AWAIT_SIGNAL, *head, command.signal, command.senders]
            return [*row, command.overtakes]
        case RemoveSignals():
            row = [rows.REMOVE_SIGNAL, *head, command.low, command.high, command.receivers]
            return [*row, command.is_range]
        case GiveUp():
            return [rows.GIVE_UP, *head, command.message]
    raise AssertionError(command)


def takes_time(command: Command) -> bool:
    """Return whether ticks pass while the command is executed."""
    if isinstance(command, SetLimits | StartReached):
        return False
    return isinstance(command, Segment) or pack(command)[rows.KIND] in rows.TIMED_KINDS


def write_text(
    source: int, number: int, cell: int, data: bytes, axis_count: int
) -> Iterator[WriteText]:
    """The commands that give the string at ``cell`` all its bytes, zeros at its end included."""
    text = data.rstrip(b"\0")
    room = rows.text_width(axis_count)
    for first in range(0, max(1, len(text)), room):
        part = text[first : first + room]
        is_last = first + room >= len(text)
        yield WriteText(source, number, cell, first, part, len(data) - len(text) if is_last else 0)

# SPDX-License-Identifier: MIT
"""A command of the decoder -> a row of the queue, its columns in the order of ``kernel/rows.py``.

Segments are not packed but prepared in the queue (``CommandQueue.put_segment``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from operator import attrgetter

from nctakt.decoder.state.queued.commands import (
    BlockMark,
    Command,
    Flush,
    Freeze,
    LoadCycle,
    LoopEnd,
    Measure,
    PositionRequest,
    ProgramEnd,
    ReadRealtime,
    Segment,
    SendSignal,
    SetTurn,
    TechnologyOutput,
    UserErrorValue,
    UserMessage,
    WriteText,
)
from nctakt.decoder.state.queued.limit_commands import SetLimits
from nctakt.decoder.state.queued.start_block import SingleStep, StartReached
from nctakt.decoder.state.queued.tool_life import ToolLifeFactors
from nctakt.kernel import codes, rows

#: What reads source, block number and arguments of a command whose arguments are its fields.
_READERS: dict[type[Command], Callable[[Command], tuple[float, ...]]] = {}


def pack(command: Command, reference: int = 0) -> list[float]:
    """Return the row of a command.

    ``reference`` is the slot of a cycle or the number of a text or program.
    """
    read = _READERS.get(type(command))
    if read is None:
        if not command.packed_as:
            return _packed_specially(command, (command.source, command.number), reference)
        read = _READERS[type(command)] = attrgetter(*command.__match_args__)
    return [command.packed_as, *read(command)]


def _packed_specially(command: Command, head: tuple[int, int], reference: int) -> list[float]:
    """Return the row of a command whose arguments are not just its fields."""
    match command:
        case LoadCycle():
            return [rows.DEFINE_CYCLE, *head, reference, not command.definition_only]
        case TechnologyOutput():
            row = [rows.TECHNOLOGY, *head, command.function, command.ticks]
            row += [command.value is not None, command.value or 0]
            return [*row, command.lead, command.lead_kind]
        case WriteText():
            row = [rows.WRITE_TEXT, *head, command.cell, command.first, len(command.data)]
            return [*row, command.zeros, *command.data]
        case UserMessage():
            return [rows.MESSAGE, *head, reference]
        case SetTurn():
            first, second, third = command.axes
            if not command.matrix:
                return [rows.SET_TURN, *head, first]
            return [rows.SET_TURN, *head, first, second + 1, third + 1, *command.matrix]
        case Freeze():
            return [rows.FREEZE, *head, command.serial, reference, command.value]
        case UserErrorValue():
            kind = rows.USER_TEXT if command.is_text else rows.USER_VALUE
            return [kind, *head, command.code, command.content]
        case Flush():
            return [rows.FLUSH, *head, command.waits]
        case ReadRealtime():
            return [rows.READ, *head, True, command.cell]
        case PositionRequest():
            return [rows.POSITIONS, *head, True, len(command.axes), *command.axes]
        case BlockMark():
            return [rows.BLOCK_MARK, *head, reference, command.calls, command.depth]
        case Measure():
            measured = [rows.MEASURE, *head, command.function, command.ticks, command.residual]
            return [*measured, command.value is not None, command.value or 0]
        case SingleStep():
            resolution = -1 if command.resolution is None else command.resolution
            return [rows.SINGLE_STEP, *head, command.is_disabled, resolution]
        case ToolLifeFactors():
            row = [rows.TOOL_LIFE, *head, codes.LIFE_FACTORS, 0, 0]
            return [*row, command.time, command.distance]
        case LoopEnd():
            return [rows.LOOP_END, *head, True]
        case ProgramEnd():
            return [rows.PROGRAM_END, *head, reference]
        case SendSignal():
            row = [rows.SIGNAL, *head, command.signal, command.receivers, command.count]
            return [*row, command.mask, *command.values]
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

# SPDX-License-Identifier: MIT
"""Range checks for the commands that the decoder hands to a channel.

The tick takes cells, axes, spindles, slots and timers from a row unchecked.
"""

from __future__ import annotations

from typing import Any

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.base import bounds
from nctakt.kernel.tick.command_execution import CommandExecutor

#: Kinds that come by methods of the queue: ``put_segment``, ``begin_loop``, ``end_loop``.
_BY_METHOD = (rows.SEGMENT, rows.LOOP_BEGIN, rows.LOOP_END)

#: Columns of each kind that have bounds, with their contents.
_BOUNDED = {
    kind: [
        (rows.ARGUMENTS + number, column)
        for number, column in enumerate(record.columns)
        if column != rows.HOLDS_NUMBER
    ]
    for kind, record in rows.COMMANDS.items()
}


def check_command(executor: CommandExecutor, command: list[Any]) -> None:
    """Raise ``ValueError`` unless each number that becomes an index in a tick lies in its table."""
    kind = command[0] if command else None
    if kind not in rows.COMMANDS or kind in _BY_METHOD:
        raise ValueError(f"{kind} is not a kind of command")
    min_length = rows.COMMANDS[kind].min_length
    bounds.check_range(len(command), min_length, executor.queue.width, "length of a command")
    for number, column in _BOUNDED[kind]:
        if number < len(command):
            check_column(executor, column, command[number])
    if kind == rows.WRITE_TEXT:
        check_text(command, 8 * len(executor.cells))
    elif kind == rows.POSITIONS:
        check_axes(command, executor.path.axes.count)
    elif kind == rows.COUPLE and command[rows.COUPLED_TO] != -1:
        couplings = executor.path.axes.couplings
        couplings.check(command[rows.COUPLED_AXIS], command[rows.COUPLED_TO])


def check_column(executor: CommandExecutor, column: int, number: Any) -> None:
    """Raise ``ValueError`` unless ``number`` fits the column."""
    axes = executor.path.axes.count
    if column == rows.HOLDS_AXIS:
        bounds.check_index(number, axes, "axis")
    elif column == rows.HOLDS_SPINDLE:
        bounds.check_index(number, executor.context.spindles.count, "spindle")
    elif column == rows.HOLDS_CELL:
        bounds.check_index(number, len(executor.cells), "cell")
    elif column == rows.HOLDS_SLOT:
        bounds.check_index(number, executor.manager.capacity, "slot")
    elif column == rows.HOLDS_TIMER:
        bounds.check_index(number, cells.TIMERS, "timer")
    elif column == rows.HOLDS_MEMBER:
        bounds.check_index(number, executor.path.count, "axis of the channel")
    elif column == rows.HOLDS_OFFSET:
        bounds.check_index(number, codes.OFFSET_KINDS, "kind of offset")
    elif column == rows.HOLDS_MAP:
        bounds.check_index(number, executor.path.axes.transformations.maps.used, "map")
    elif column == rows.HOLDS_AXIS_FROM_1:
        bounds.check_range(number, 0, axes, "axis")
    elif number != -1:  # AXIS_OR_NONE
        bounds.check_index(number, axes, "axis")


def check_axes(command: list[Any], axes: int) -> None:
    """Raise ``ValueError`` unless a position request names axes of the machine."""
    count = len(command) - rows.POSITIONS_AXES
    bounds.check_range(command[rows.POSITIONS_COUNT], 0, count, "number of axes")
    for number in command[rows.POSITIONS_AXES :]:
        bounds.check_index(number, axes, "axis")


def check_text(command: list[Any], size: int) -> None:
    """Raise ``ValueError`` unless characters and zeros lie in the memory of ``size`` bytes."""
    bounds.check_range(command[rows.TEXT_FIRST], 0, size, "byte of a text")
    bounds.check_range(
        command[rows.TEXT_COUNT], 0, len(command) - rows.TEXT_CHARACTERS, "characters"
    )
    bounds.check_range(command[rows.TEXT_ZEROS], 0, size, "zeros")
    length = command[rows.TEXT_FIRST] + command[rows.TEXT_COUNT] + command[rows.TEXT_ZEROS]
    bounds.check_range(command[rows.TEXT_CELL], 0, (size - length) // 8, "cell")
    for character in command[rows.TEXT_CHARACTERS :]:
        bounds.check_index(character, 256, "character")

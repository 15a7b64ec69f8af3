# SPDX-License-Identifier: MIT
"""Range checks for the commands that the decoder hands to a channel.

The tick takes cells, axes, spindles, slots and timers out of a row without a check of its own.
"""

from __future__ import annotations

from typing import Any

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.base import bounds
from nctakt.kernel.tick.command_execution import CommandExecutor

#: How many columns a command of each kind has at least; a segment is prepared by the queue.
_MIN_LENGTH = {
    rows.DWELL: rows.DWELL_TICKS + 1,
    rows.DEFINE_CYCLE: rows.CYCLE_STARTS + 1,
    rows.CONTROL_CYCLE: rows.CONTROL_IDENTITY + 1,
    rows.TECHNOLOGY: rows.TECHNOLOGY_LEAD_KIND + 1,
    rows.AWAIT_ACKNOWLEDGE: rows.AWAITED_FUNCTION + 1,
    rows.WRITE_VARIABLE: rows.VARIABLE_IS_REPORTED + 1,
    rows.WRITE_TEXT: rows.TEXT_CHARACTERS,
    rows.MESSAGE: rows.MESSAGE_TEXT + 1,
    rows.FLUSH: rows.IS_ANSWERED + 1,
    rows.READ: rows.READ_CELL + 1,
    rows.POSITIONS: rows.POSITIONS_AXES,
    rows.PROGRAM_END: rows.PROGRAM_NUMBER + 1,
    rows.GIVE_UP: rows.GIVE_UP_MESSAGE + 1,
    rows.USER_ERROR: rows.ERROR_REACTION + 1,
    rows.USER_VALUE: rows.VALUE_NUMBER + 1,
    rows.USER_TEXT: rows.USER_TEXT_NUMBER + 1,
    rows.USER_STOP: rows.STOP_REACTION + 1,
    rows.SPINDLE: rows.JOB_IGNORES_OVERRIDE + 1,
    rows.AWAIT_SPINDLE: rows.JOB_SPINDLE + 1,
    rows.SPINDLE_AXIS: rows.GIVES_AXIS + 1,
    rows.BLOCK_MARK: rows.MARK_DEPTH + 1,
    rows.MODAL_MARK: rows.MODAL_NUMBER + 1,
    rows.WAIT_MARK: rows.WAIT_CELL + 1,
    rows.TIMER: rows.TIMER_ACTION + 1,
    rows.SET_OFFSET: rows.OFFSET_VALUE + 1,
    rows.SET_ORIGIN: rows.ORIGIN_VALUE + 1,
    rows.SET_TURN: rows.TURN_FIRST + 1,
    rows.SET_TRANSFORMATION: rows.TRANSFORMATION_OF_SEGMENTS + 1,
    rows.PROGRAM_STOP: rows.STOP_IS_OPTIONAL + 1,
    rows.FREEZE: rows.FROZEN_VALUE + 1,
    rows.LOOP_PASS: rows.ARGUMENTS,
    rows.FIXED_STOP: rows.FIXED_STOP_IS_NEEDED + 1,
    rows.FIXED_STOP_END: rows.ARGUMENTS,
    rows.MEASURE: rows.MEASURE_VALUE + 1,
    rows.MEASURE_END: rows.ARGUMENTS,
    rows.TOUCH: rows.TOUCH_MAY_BE_PRESSED + 1,
    rows.TOUCH_END: rows.ARGUMENTS,
    rows.HOME: rows.HOMING_SPEED + 1,
    rows.REFER: rows.HOMING_DISTANCE + 1,
    rows.SOFTWARE_LIMITS: rows.LIMIT_HIGH + 1,
    rows.MOVE_ALONE: rows.ALONE_IS_RELATIVE + 1,
    rows.OSCILLATE: rows.SWING_COUNT + 1,
    rows.END_OSCILLATION: rows.ENDED_SPEED + 1,
    rows.SINGLE_STEP: rows.STEP_RESOLUTION + 1,
    rows.COUPLE: rows.COUPLED_WITHIN + 1,
    rows.FEED_FORWARD: rows.FED_SHARE + 1,
    rows.TOOL_LIFE: rows.LIFE_DISTANCE + 1,
    rows.CLEAR_HISTORY: rows.ARGUMENTS,
    rows.EMPTY_BLOCK: rows.ARGUMENTS,
    rows.CUTTING_SPEED: rows.CUTTING_LIMIT + 1,
    rows.SPINDLE_LIMITS: rows.LIMITED_BY_GEAR + 1,
    rows.SIGNAL: rows.SIGNAL_FIRST_VALUE + codes.SIGNAL_VALUES,
    rows.AWAIT_SIGNAL: rows.AWAITED_OVERTAKES + 1,
    rows.REMOVE_SIGNAL: rows.REMOVED_IS_RANGE + 1,
}

#: The kinds whose first argument is the number of an axis in the machine.
_OF_AN_AXIS = (
    rows.HOME,
    rows.REFER,
    rows.SOFTWARE_LIMITS,
    rows.FEED_FORWARD,
    rows.MOVE_ALONE,
    rows.OSCILLATE,
    rows.END_OSCILLATION,
)


def check_command(executor: CommandExecutor, command: list[Any]) -> None:
    """Raise ``ValueError`` unless what becomes an index in a tick lies in its table."""
    kind = command[0] if command else None
    if kind not in _MIN_LENGTH:
        raise ValueError(f"{kind} is not a kind of command")
    bounds.check_range(len(command), _MIN_LENGTH[kind], executor.queue.width, "length of a command")
    axes = executor.path.axes.count
    cell_count = len(executor.cells)
    if kind == rows.WRITE_VARIABLE:
        bounds.check_index(command[rows.VARIABLE_CELL], cell_count, "cell")
    elif kind == rows.WRITE_TEXT:
        check_text(command, 8 * cell_count)
    elif kind == rows.READ:
        bounds.check_index(command[rows.READ_CELL], cell_count, "cell")
    elif kind == rows.DEFINE_CYCLE:
        bounds.check_index(command[rows.CYCLE_SLOT], executor.manager.capacity, "slot")
    elif kind == rows.TIMER:
        bounds.check_index(command[rows.TIMER_NUMBER], cells.TIMERS, "timer")
    elif kind in (rows.SPINDLE, rows.AWAIT_SPINDLE):
        bounds.check_index(command[rows.JOB_SPINDLE], executor.context.spindles.count, "spindle")
    elif kind == rows.SPINDLE_AXIS:
        bounds.check_index(command[rows.GIVING_SPINDLE], executor.context.spindles.count, "spindle")
    elif kind == rows.CUTTING_SPEED:
        spindles = executor.context.spindles.count
        bounds.check_index(command[rows.CUTTING_SPINDLE], spindles, "spindle")
        bounds.check_index(command[rows.CUTTING_AXIS], axes, "axis")
    elif kind == rows.SPINDLE_LIMITS:
        spindles = executor.context.spindles.count
        bounds.check_index(command[rows.LIMITED_SPINDLE], spindles, "spindle")
    elif kind == rows.FIXED_STOP:
        bounds.check_index(
            command[rows.FIXED_STOP_AXIS], executor.path.count, "axis of the channel"
        )
    elif kind == rows.SET_OFFSET:
        bounds.check_index(command[rows.OFFSET_AXIS], axes, "axis")
        bounds.check_index(command[rows.OFFSET_KIND], codes.OFFSET_KINDS, "kind of offset")
    elif kind in _OF_AN_AXIS:
        bounds.check_index(command[rows.HOMED_AXIS], axes, "axis")
    elif kind == rows.COUPLE:
        slave, master = command[rows.COUPLED_AXIS], command[rows.COUPLED_TO]
        bounds.check_index(slave, axes, "axis")
        if master != -1:
            bounds.check_index(master, axes, "axis")
            executor.path.axes.couplings.check(slave, master)
    elif kind == rows.SET_ORIGIN:
        bounds.check_index(command[rows.ORIGIN_AXIS], axes, "axis")
    elif kind == rows.SET_TURN:
        bounds.check_index(command[rows.TURN_FIRST], axes, "axis")
        for number in command[rows.TURN_SECOND : rows.TURN_MATRIX]:
            bounds.check_range(number, 0, axes, "axis")
    elif kind == rows.SET_TRANSFORMATION:
        maps = executor.path.axes.transformations.maps.used
        for number in command[rows.TRANSFORMATION_NUMBER : rows.ARGUMENTS + 2]:
            bounds.check_index(number, maps, "map")
    elif kind == rows.POSITIONS:
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

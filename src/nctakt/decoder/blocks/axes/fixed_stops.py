# SPDX-License-Identifier: MIT
"""``X[FIXED_STOP ON …]``: motion of an axis to a fixed stop (MO-12)."""

from __future__ import annotations

from collections.abc import Collection, Generator

from nctakt.decoder.state.queued.commands import Answer, Command, FixedStop
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.path.fixed_stops import (
    AXIS_AT_FIXED_STOP,
    FIXED_STOP_ACTIVE,
    FIXED_STOP_WITHOUT_HISTORY,
    FIXED_STOP_WITHOUT_MOTION,
    INVALID_FIXED_STOP_RANGE,
)
from nctakt.nc import tree

#: The first keyword of the command.
WORD = "FIXED_STOP"
#: Default of POS_LAG_LIMIT, mm or degrees (P-AXIS-00712).
DEFAULT_LIMIT = 2.0


def is_fixed_stop(command: tree.BracketCommand) -> bool:
    """Return whether a command for an axis is ``X[FIXED_STOP …]``."""
    first = command.items[0] if command.items else None
    return isinstance(first, tree.Keyword) and first.name == WORD


def fixed_stop(
    values: Values, command: tree.BracketCommand, axis: int, number: int
) -> Generator[Command, Answer, FixedStop]:
    """Return the command of the axis with this index; START and END are percentages of the path."""
    numbers: dict[str, float] = {}
    for item in command.items:
        if isinstance(item, tree.Keyword) and item.value is not None:
            numbers[item.name] = yield from values.evaluate(item.value, number)
    begin, end = numbers.get("START", 0.0), numbers.get("END", 100.0)
    if not 0.0 <= begin < end <= 100.0:
        values.fail(INVALID_FIXED_STOP_RANGE, command.span, start=begin, end=end)
    limit = numbers.get("POS_LAG_LIMIT", DEFAULT_LIMIT)
    if "POS_LAG_LIMIT" in numbers and values.environment.axes[axis].is_linear:
        limit *= values.state.length_unit_mm
    return FixedStop(
        values.environment.source_id(command.span),
        number,
        axis,
        not any(isinstance(item, tree.Keyword) and item.name == "OFF" for item in command.items),
        limit,
        max(1, int(arithmetic.round_half_even(numbers.get("CYCLES", 1.0)))),
        begin / 100.0,
        end / 100.0,
        arithmetic.is_true(numbers.get("ERR_NOT_DETECTED", 1.0)),
    )


def begin_or_end(
    values: Values, word: tree.BracketCommand, stop: FixedStop, moved: Collection[str]
) -> None:
    """Note that monitoring of an axis begins or ends; ``moved``: the axes of the block.

    Raises ``DecodeError`` where monitoring cannot begin: without a motion of the axis (21966),
    without a history of the path (50881), while it is active (21969).
    """
    axis, monitored = word.name, values.state.monitored
    if not stop.is_on:
        monitored.discard(axis)
        return
    if axis not in moved:
        values.fail(FIXED_STOP_WITHOUT_MOTION, word.span, axis=axis)
    if values.environment.history_size == 0:
        values.fail(FIXED_STOP_WITHOUT_HISTORY, word.span, axis=axis)
    if axis in monitored:
        values.fail(FIXED_STOP_ACTIVE, word.span, axis=axis)
    values.check_flush_allowed(f"{axis}[{WORD}]", word.span)
    monitored.add(axis)


def check_free(
    values: Values,
    words: Collection[tree.AxisWord],
    stops: Collection[tuple[tree.BracketCommand, FixedStop]],
) -> None:
    """Check that the block moves no axis at a fixed stop; raises ``DecodeError`` 21967."""
    commanded = {command.name for command, _ in stops}
    for word in words:
        if word.name in values.state.monitored and word.name not in commanded:
            values.fail(AXIS_AT_FIXED_STOP, word.span, axis=word.name)

# SPDX-License-Identifier: MIT
"""``X[OSC ON …]`` and ``X[OSC OFF …]``: axes that oscillate independently of the path.

The rules SA-11 … SA-17 are in docs/conformance/single-axes.md. From OSC ON on the position of the
axis is uncertain until a command requests it, which ends the oscillation at its second position.
"""

from __future__ import annotations

import math
from collections.abc import Generator

from nctakt.decoder.axis_limits import acceleration_alone, feed_unit
from nctakt.decoder.blocks.axes.moved_axes import MovedAxes
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.state.queued.axis_commands import EndOscillation, Oscillate
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.messages.axes.axis_motions import INDP_TARGET_OUTSIDE_LIMITS
from nctakt.messages.axes.independent_axes import (
    AXIS_VALUE_INVALID,
    INDEPENDENT_IN_TRANSFORMATION,
    OSCILLATION_COUNT,
    OSCILLATION_LIMITED,
    OSCILLATION_OUTSIDE_MODULO_RANGE,
    OSCILLATION_WITHOUT_SPEED,
    OSCILLATION_WITHOUT_STROKE,
)
from nctakt.nc import tree
from nctakt.nc.vocabulary.single_axes.axis_brackets import OSC
from nctakt.nc.vocabulary.single_axes.oscillation import (
    MAX_COUNT,
    OscillationCommand,
    is_count,
    is_valid,
    read_oscillation,
)


class Oscillations:
    """The oscillating axes of one program."""

    def __init__(self, values: Values, moved: MovedAxes) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._moved = moved

    def read(
        self, bracket: tree.BracketCommand, number: int, content: BlockContent
    ) -> Generator[Command, Answer]:
        """Evaluate a command and note it in the block's content; raises ``DecodeError``."""
        command, _ = read_oscillation(bracket)
        name = command.axis
        self._values.check_flush_allowed(f"{name}[{OSC} …]", command.span)
        values = {}
        for word, expression in command.values.items():
            values[word] = yield from self._values.evaluate(expression, number)
            self._check(command, word, values[word], expression)
        traits = self._environment.names.axis(name)
        assert traits is not None
        head = (self._environment.source_id(command.span), number, traits.number)
        index = self._environment.axis_numbers[name]
        axis = self._environment.axes[index]
        if not command.is_on:
            how, speed = self._end(command, values, axis)
            content.independent += ((bracket, EndOscillation(*head, how, speed)),)
            return
        if self._environment.offsets.transformation.is_active:
            self._values.fail(INDEPENDENT_IN_TRANSFORMATION, command.span, axis=name, form=OSC)
        yield from self._moved.request([name], command.span, number)
        first, second = self._positions(command, values, axis, index)
        stroke = self._stroke(command, first, second, axis)
        pauses = [self._ticks(values.get(word, 0.0)) for word in ("1ST_DELT", "2ND_DELT")]
        paused_s = sum(pauses) * self._environment.cycle_time_us / 1e6
        speed = self._speed(command, values, axis, abs(stroke), paused_s)
        count = int(values.get("NBR_OSC", -1))
        first_ticks, second_ticks = pauses
        oscillate = Oscillate(*head, first, second, stroke, speed, first_ticks, second_ticks, count)
        content.independent += ((bracket, oscillate),)
        self._state.positions = list(self._state.positions)
        self._state.positions[index] = second

    def _check(
        self, command: OscillationCommand, word: str, value: float, expression: tree.Expression
    ) -> None:
        """Raise ``DecodeError`` for a value that a keyword cannot have."""
        axis, span = command.axis, expression.span
        if word == "NBR_OSC" and not is_count(value):
            self._values.fail(OSCILLATION_COUNT, span, axis=axis, value=value, highest=MAX_COUNT)
        if word == "FEED" and value <= 0.0:
            self._values.fail(OSCILLATION_WITHOUT_SPEED, span, axis=axis)
        if not is_valid(word, value):
            named = {"axis": axis, "form": OSC, "word": word, "value": value}
            self._values.fail(AXIS_VALUE_INVALID, span, **named)

    def _end(
        self, command: OscillationCommand, values: dict[str, float], axis: AxisConfiguration
    ) -> tuple[int, float]:
        """Return how an oscillation ends, and the speed towards its second position."""
        if "INSTANT" in command.flags:
            return codes.HALTS, 0.0
        if "FEED" in values:
            return codes.RETURNS, min(self._feed(values["FEED"], axis), axis.max_speed)
        return codes.FINISHES, 0.0

    def _positions(
        self,
        command: OscillationCommand,
        values: dict[str, float],
        axis: AxisConfiguration,
        index: int,
    ) -> tuple[float, float]:
        """Return both reversal positions, mm or degrees, within the limits of the axis."""
        unit = self._state.length_unit_mm if axis.is_linear else 1.0
        if "ZERO_POS" in values:
            zero, excursion = values["ZERO_POS"] * unit, values["EXCUR"] * unit
            first, second = zero - excursion, zero + excursion
        else:
            first, second = values["1ST_POS"] * unit, values["2ND_POS"] * unit
        if "INCL_OFFSETS" in command.flags:
            offset = self._environment.offsets.total(index)
            first, second = first + offset, second + offset
        named = {"axis": command.axis}
        if first == second:
            self._values.fail(OSCILLATION_WITHOUT_STROKE, command.span, position=first, **named)
        low, high = self._state.software_limits.of(axis, index)
        message = INDP_TARGET_OUTSIDE_LIMITS
        if axis.is_modulo:
            low, high = axis.dynamics.modulo_low, axis.dynamics.modulo_high
            message = OSCILLATION_OUTSIDE_MODULO_RANGE
        for position in (first, second):
            if low <= position < high or (position == high and not axis.is_modulo):
                continue
            word = "position" if axis.is_modulo else "target"
            self._values.fail(
                message, command.span, **named, **{word: position}, low=low, high=high
            )
        return first, second

    def _stroke(
        self, command: OscillationCommand, first: float, second: float, axis: AxisConfiguration
    ) -> float:
        """Return the distance from the first position to the second; SHORT: the shorter one."""
        stroke, full = second - first, axis.modulo_range
        if axis.is_modulo and "SHORT" in command.flags:
            stroke -= full * arithmetic.ceiling(stroke / full - 0.5)
        return stroke

    def _ticks(self, seconds: float) -> int:
        """Return for how many ticks an axis waits, as for a dwell (RC-005)."""
        return int(arithmetic.ceiling(seconds * 1e6 / self._environment.cycle_time_us - 1e-6))

    def _feed(self, feed: float, axis: AxisConfiguration) -> float:
        """Return a FEED as mm/s or degrees/s."""
        listed_mm_min = self._environment.parameters.program_start.feed_unit_mm_min
        return feed * feed_unit(axis, self._state, listed_mm_min)

    def _speed(
        self,
        command: OscillationCommand,
        values: dict[str, float],
        axis: AxisConfiguration,
        stroke: float,
        paused_s: float,
    ) -> float:
        """Return the speed between the positions: for FREQ and TIME such that two strokes of
        ``stroke``, ramps included, and both waits take one period.
        """
        if "FEED" in values:
            return min(self._feed(values["FEED"], axis), axis.max_speed)
        period_s = values["TIME"] if "TIME" in values else 1.0 / values["FREQ"]
        start = self._environment.parameters.program_start
        acceleration = acceleration_alone(axis, start.slope_profile != 0)
        travel_s = (period_s - paused_s) / 2.0
        gained = acceleration * max(travel_s, 0.0)
        under = gained * gained - 4.0 * acceleration * stroke
        speed = (gained - math.sqrt(under)) / 2.0 if under >= 0.0 else math.inf
        if speed <= axis.max_speed:
            return speed
        top = min(axis.max_speed, math.sqrt(acceleration * stroke))
        reached_s = 2.0 * (stroke / top + top / acceleration) + paused_s
        reached, period = round(reached_s, 6), round(period_s, 6)
        self._values.warn(
            OSCILLATION_LIMITED, command.span, axis=command.axis, reached=reached, period=period
        )
        return axis.max_speed

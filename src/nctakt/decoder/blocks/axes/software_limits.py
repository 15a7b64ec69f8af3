# SPDX-License-Identifier: MIT
"""G98, G99: software limits of the program, in place of those of the lists.

They act on the path, when its blocks are decoded, and on independent motions
(``SetSoftwareLimits``), until the end of the program.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from math import inf

from nctakt.base.diagnostics import Span, Text
from nctakt.decoder.blocks.block_content import AxisValues
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.queued.axis_commands import SetSoftwareLimits
from nctakt.decoder.state.queued.commands import Command
from nctakt.decoder.values.variables import Values
from nctakt.messages.axes.homing import (
    NEGATIVE_LIMIT_IGNORED,
    NEGATIVE_LIMIT_TOO_HIGH,
    POSITIVE_LIMIT_IGNORED,
    POSITIVE_LIMIT_TOO_LOW,
)
from nctakt.messages.path.motion import SIMPLIFIED
from nctakt.nc.vocabulary.functions import NEGATIVE_LIMIT

#: The base of a relative limit.
_ADDED_TO_LIMIT = Text(
    "a limit under G91 is added to the limit in force",
    "ein Endschalter unter G91 kommt zum wirksamen Endschalter hinzu",
)


class SoftwareLimits:
    """The software limits of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._limits = values.state.software_limits
        self._has_noted_relative = False

    def set(self, function: int, words: AxisValues, source: int, number: int) -> Iterator[Command]:
        """Yield the limits of G98 (negative) or G99 (positive); raises ``DecodeError``."""
        is_negative = function == NEGATIVE_LIMIT
        for word, programmed in words:
            index = self._environment.axis_numbers[word.name]
            axis = self._environment.axes[index]
            low, high = self._limits.of(axis, index)
            value = programmed
            if axis.is_linear:
                value *= self._values.state.length_unit_mm
            if not self._values.state.absolute:
                value += low if is_negative else high
                self._note_relative(function, word.span)
            listed = axis.software_limit_low if is_negative else axis.software_limit_high
            is_beyond = value < listed if is_negative else value > listed
            if is_beyond and self._environment.parameters.keeps_listed_limits:
                message = NEGATIVE_LIMIT_IGNORED if is_negative else POSITIVE_LIMIT_IGNORED
                self._values.warn(message, word.span, axis=word.name, value=value, listed=listed)
                continue
            other = high if is_negative else low
            if value >= other if is_negative else value <= other:
                message = NEGATIVE_LIMIT_TOO_HIGH if is_negative else POSITIVE_LIMIT_TOO_LOW
                self._values.fail(message, word.span, axis=word.name, value=value, other=other)
            limits = (value, high) if is_negative else (low, value)
            self._limits.programmed[index] = limits
            slot = self._environment.places.present[index]
            assert slot is not None
            yield from _limit(self._environment, slot.index, *limits, source, number)

    def _note_relative(self, function: int, span: Span) -> None:
        if not self._has_noted_relative:
            self._has_noted_relative = True
            self._values.warn(SIMPLIFIED, span, command=f"G{function}", meaning=_ADDED_TO_LIMIT)


def listed_limits_again(
    environment: DecoderEnvironment, axes: Collection[int], source: int, number: int
) -> Iterator[Command]:
    """Yield the limits of the lists for those of these axes that a program has limited.

    ``axes``: their numbers in the machine.
    """
    limited = environment.controller_data.limited_axes
    for axis in sorted(limited.intersection(axes)):
        listed = environment.places.machine_axes[axis]
        low, high = listed.software_limit_low, listed.software_limit_high
        yield from _limit(environment, axis, low, high, source, number)
        limited.discard(axis)


def limits_of_program_again(
    environment: DecoderEnvironment, state: ModalState, source: int, number: int
) -> Iterator[Command]:
    """Yield the limits of the program for the axes that the channel has after an exchange."""
    for index, (low, high) in state.software_limits.programmed.items():
        slot = environment.places.present[index]
        assert slot is not None
        yield from _limit(environment, slot.index, low, high, source, number)


def _limit(
    environment: DecoderEnvironment, axis: int, low: float, high: float, source: int, number: int
) -> Iterator[Command]:
    """Set the limits of an axis for blocks under a transformation, and yield its command."""
    environment.controller_data.limited_axes.add(axis)
    if environment.places.machine_axes[axis].is_modulo:
        low, high = -inf, inf
    for index, slot in enumerate(environment.places.present):
        if slot is not None and slot.index == axis:
            environment.offsets.transformation.axis_check.limit(index, low, high)
    yield SetSoftwareLimits(source, number, axis, low, high)

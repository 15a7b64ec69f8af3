# SPDX-License-Identifier: MIT
"""M40 … M45, G112 and speeds that choose a gear step -> commands for the spindle.

A change lets the spindle turn to the position of the active step, waits for the M function, and
takes the limits of the new step. G112 only takes the limits, for a spindle at rest.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.technology_output import process_ticks
from nctakt.decoder.state.queued.commands import AwaitAcknowledge, Command, TechnologyOutput
from nctakt.decoder.state.queued.spindle_commands import AwaitSpindle, SpindleJob, SpindleLimits
from nctakt.decoder.state.spindle_gears import SpindleGears
from nctakt.decoder.values.variables import Values
from nctakt.hli.function_codes import code_of
from nctakt.messages.axes.couplings import NOT_WHILE_COUPLED
from nctakt.messages.axes.spindles import (
    GEAR_CHANGE_WHILE_TURNING,
    GEAR_FUNCTION_SYNCHRONISATION,
    GEAR_OF_PLC_SPINDLE,
    GEAR_STEP_OUT_OF_FORMAT,
    NO_GEAR_FOR_SPEED,
    UNKNOWN_SPINDLE_GEAR,
)
from nctakt.nc.tree import BlockWord, Number, Word
from nctakt.nc.vocabulary.functions import GEAR_FUNCTIONS, SPINDLE_POSITION

#: The highest number of a gear step that fits into its data format (20030).
_HIGHEST_STAGE = 65_535


class GearChanges:
    """The gear changes of one program; ``is_enabled``: P-CHAN-00052."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._listed = values.environment.parameters.gears
        self.is_enabled = self._listed.is_enabled

    def stage_of(self, word: BlockWord) -> int:
        """Return the gear step of M40 … M45; 0 for other words."""
        if not isinstance(word, Word) or word.name != "M" or not isinstance(word.value, Number):
            return 0
        function = word.value.value
        return int(function) - GEAR_FUNCTIONS[0] + 1 if function in GEAR_FUNCTIONS else 0

    def chosen(self, index: int, speed: float, span: Span) -> int:
        """Return the gear step for a speed in 1/min; 0 where the speed does not choose.

        The active step stays if it covers the speed; otherwise the first step that does is taken.
        """
        spindle = self._values.environment.parameters.spindles[index]
        listed = self._listed.ranges.get(spindle.logical_number)
        is_automatic = self.is_enabled and listed is not None and listed.is_automatic
        if not is_automatic or listed is None or speed == 0.0:
            return 0
        gears = self._gears(index, span)
        low, high = listed.ranges.get(gears.active, (1.0, 0.0))
        if low <= speed <= high:
            return gears.active
        for stage, (low, high) in listed.ranges.items():
            if low <= speed <= high:
                return stage
        ranges = ", ".join(f"{low:g} … {high:g}" for low, high in listed.ranges.values()) or "–"
        self._values.fail(NO_GEAR_FOR_SPEED, span, spindle=spindle.name, speed=speed, ranges=ranges)

    def change(
        self, index: int, stage: int, span: Span, number: int
    ) -> Generator[Command, None, bool]:
        """Change the gear step; return whether another one was active."""
        gears = self._gears(index, span)
        if stage == gears.active:
            return False
        self._check(index, stage, span)
        if self._values.state.couplings.spindles(index):
            command = f"M{GEAR_FUNCTIONS[0] + stage - 1}"
            self._values.fail(NOT_WHILE_COUPLED, span, command=command, other="#AX LINK")
        environment = self._values.environment
        source = environment.source_id(span)
        gear = gears.gear
        shown = GEAR_FUNCTIONS[0] + stage - 1
        function = environment.parameters.m_functions.get(shown)
        if function is None or function.synchronisation != "MVS_SVS":
            self._values.fail(GEAR_FUNCTION_SYNCHRONISATION, span, function=shown)
        position = gear.change_position
        yield SpindleJob(source, number, index, SPINDLE_POSITION, gear.rapid_v, position, 0, 0)
        yield AwaitSpindle(source, number, index)
        code = code_of("M", function.number)
        ticks = process_ticks(function, environment.cycle_time_us)
        yield TechnologyOutput(source, number, code, ticks)
        yield AwaitAcknowledge(source, number, code)
        yield from self._take(index, stage, span, number)
        return True

    def load(
        self, index: int, stage: float, span: Span, number: int, *, turns: bool
    ) -> Iterator[Command]:
        """Take the limits of a gear step (G112); ``turns``: an endless job is active."""
        if stage != int(stage) or not 1 <= stage <= _HIGHEST_STAGE:
            self._values.fail(GEAR_STEP_OUT_OF_FORMAT, span, stage=stage)
        self._check(index, int(stage), span)
        if turns:
            name = self._values.environment.parameters.spindles[index].name
            self._values.fail(GEAR_CHANGE_WHILE_TURNING, span, spindle=name)
        yield AwaitSpindle(self._values.environment.source_id(span), number, index)
        yield from self._take(index, int(stage), span, number)

    def _gears(self, index: int, span: Span) -> SpindleGears:
        """Return the gear steps of a spindle that the CNC turns."""
        gears = self._values.environment.spindle_gears.get(index)
        if gears is None:
            name = self._values.environment.parameters.spindles[index].name
            self._values.fail(GEAR_OF_PLC_SPINDLE, span, spindle=name)
        return gears

    def _check(self, index: int, stage: int, span: Span) -> None:
        gears = self._gears(index, span)
        if stage not in gears.steps:
            name = self._values.environment.parameters.spindles[index].name
            known = ", ".join(map(str, sorted(filter(None, gears.steps))))
            self._values.fail(UNKNOWN_SPINDLE_GEAR, span, spindle=name, stage=stage, known=known)

    def _take(self, index: int, stage: int, span: Span, number: int) -> Iterator[Command]:
        gears = self._gears(index, span)
        gears.active = stage
        gear, source = gears.gear, self._values.environment.source_id(span)
        yield SpindleLimits(
            source, number, index, 0.0, gear.speed_v, gear.acceleration, gear.jerk, stage
        )

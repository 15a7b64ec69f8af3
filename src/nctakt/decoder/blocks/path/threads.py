# SPDX-License-Identifier: MIT
"""The coupling of path and spindle in a block: G33, G63, G331 and G332.

In: the modal words (I, J, K, F, S), start and target of a block. Out: its feed and the
``FeedModifiers`` that tell the realtime part how many degrees of which spindle belong to a mm of
the path. The pitch is that of the main axis with the longest distance; below 45° that is Z.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence

from nctakt.base.diagnostics import Span
from nctakt.base.whole_numbers import is_whole
from nctakt.decoder.blocks.axes.spindles import DEGREES_PER_S, SpindleWords, find, warn_of_speed
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.queued.feed_modifiers import FeedModifiers
from nctakt.decoder.values.variables import Values
from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic
from nctakt.messages.path.threads import (
    INVALID_TURN_VALUE,
    NEGATIVE_THREAD_PITCH,
    SPINDLE_WORD_IN_TAPPING,
    TAP_SPEED_ZERO,
    TAP_SPINDLE_TURNING,
    TAP_WITH_FEED_FUNCTION,
    TAPPING_DECIDED,
    THREAD_DURING_COMPENSATION,
    THREAD_ENTRY_DECIDED,
    THREAD_PITCH_MISSING,
    THREAD_WITH_PLC_SPINDLE,
    TURN_VALUE_NOT_SIMULATED,
)
from nctakt.messages.programs.decoder import NO_FEED_ACTIVE
from nctakt.nc import tree
from nctakt.nc.vocabulary.functions import (
    FEED_PER_MINUTE,
    SPINDLE_STOP,
    TAP_RETRACTION,
    TAPPING_BY_FEED,
    TAPPING_FUNCTIONS,
    THREAD_CUTTING,
)
from nctakt.nc.vocabulary.spindle_commands import SpindleCommand

#: The highest number of cycles of a filter in ``#TURN``.
MAX_FILTER_CYCLES = 20

#: Forms of ``#TURN`` that are not possible here.
_NOT_SIMULATED = (("TIME_IN_REV_CPL", 1), ("THREAD_CUT_IGNORE_OV", 0))

#: The words of the pitch, one for each of the first three axes.
PITCH_WORDS = ("I", "J", "K")
_LONGITUDINAL = 2


class ThreadMotion:
    """Decodes the threads of one program."""

    def __init__(self, values: Values, spindles: SpindleWords) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._spindles = spindles

    def speed(self, command: SpindleCommand, number: int) -> Generator[Command, Answer]:
        """Process S of tapping: its sign is the direction. No job goes to the spindle."""
        function = f"G{self._state.motion}"
        if self._spindles.cutting.sets_limit:
            self._values.fail(TAP_WITH_FEED_FUNCTION, command.span, function="G196")
        if command.functions:
            word = f"M{command.functions[0]}"
            self._values.fail(SPINDLE_WORD_IN_TAPPING, command.span, word=word, function=function)
        if command.speed is None:
            return
        index, _ = find(self._values, command.name, command.span)
        thread = self._state.thread
        thread.spindle = index
        thread.speed = yield from self._values.evaluate(command.speed, number)
        warn_of_speed(self._values, index, abs(thread.speed), command.speed.span)

    def pitches(self, words: Mapping[str, tuple[Span, float]]) -> None:
        """Process I, J and K of a block, in mm; they are modal."""
        thread = self._state.thread
        for name, (span, value) in words.items():
            if value < 0.0 and self._state.motion == THREAD_CUTTING:
                self._values.fail(NEGATIVE_THREAD_PITCH, span, value=value)
            thread.pitches[name] = value * self._state.length_unit_mm

    def settings(self, items: Sequence[tree.Keyword], number: int) -> Generator[Command, Answer]:
        """Execute ``#TURN``; a spindle has its command speed and position, so filters do nothing.

        Raises ``DecodeError`` for a value that is not simulated.
        """
        for item in items:
            assert item.value is not None
            value = yield from self._values.evaluate(item.value, number)
            highest = MAX_FILTER_CYCLES if item.name.endswith("N_CYCLES") else 1
            if not is_whole(value, 0, highest):
                self._values.fail(
                    INVALID_TURN_VALUE,
                    item.value.span,
                    word=item.name,
                    value=value,
                    highest=highest,
                )
            if (item.name, value) in _NOT_SIMULATED:
                written = f"{item.name}={int(value)}"
                self._values.fail(TURN_VALUE_NOT_SIMULATED, item.span, word=written)
            if item.name == "ROT_FEED_CPL":
                self._state.feed.follows_spindle = value == 1
            elif item.name == "THREAD_CHAIN":
                self._state.thread.chains = value == 1

    def of(
        self, start: Sequence[float], target: Sequence[float], modifiers: FeedModifiers, span: Span
    ) -> tuple[float, FeedModifiers]:
        """Return feed in mm/s and modifiers of a block; ``modifiers``: its overrides."""
        motion = self._state.motion
        if self._state.path.compensation.is_active:
            self._values.fail(THREAD_DURING_COMPENSATION, span, function=f"G{motion}")
        if motion == THREAD_CUTTING:
            return self._cut(start, target, span)
        return self._tap(start, target, modifiers, span)

    def _cut(
        self, start: Sequence[float], target: Sequence[float], span: Span
    ) -> tuple[float, FeedModifiers]:
        thread = self._state.thread
        if not thread.has_noted_cutting:
            thread.has_noted_cutting = True
            self._values.warn(THREAD_ENTRY_DECIDED, span)
        index = self._spindle(span)
        modal = self._spindles.modal.get(index)
        spindle_v = 0.0 if modal is None else DEGREES_PER_S * modal.turning_speed
        spindle_v = min(spindle_v, self._environment.spindle_gears[index].gear.speed_v)
        if spindle_v == 0.0:
            spindle_v = self._environment.spindle_gears[index].gear.speed_v
        pitch = abs(self._pitch(start, target, span))
        modifiers = FeedModifiers(
            1.0, True, index, spindle_v, rows.CUTTING, 360.0 / pitch, thread.offset
        )
        return pitch * spindle_v / 360.0, modifiers

    def _tap(
        self, start: Sequence[float], target: Sequence[float], modifiers: FeedModifiers, span: Span
    ) -> tuple[float, FeedModifiers]:
        thread = self._state.thread
        motion = self._state.motion
        if not thread.has_noted_tapping:
            thread.has_noted_tapping = True
            self._values.warn(TAPPING_DECIDED, span)
        index = self._spindle(span)
        modal = self._spindles.modal.get(index)
        if modal is not None and modal.function != SPINDLE_STOP:
            name = self._environment.parameters.spindles[index].name
            self._values.fail(TAP_SPINDLE_TURNING, span, spindle=name)
        speed = thread.speed
        if speed == 0.0 and modal is not None:
            speed = modal.speed
        if speed == 0.0:
            self._values.fail(TAP_SPEED_ZERO, span, function=f"G{motion}")
        size = abs(speed)
        if motion == TAPPING_BY_FEED:
            mode = self._state.feed.feed_mode
            if mode != FEED_PER_MINUTE:
                self._values.fail(TAP_WITH_FEED_FUNCTION, span, function=f"G{mode}")
            if self._spindles.cutting.is_active:
                self._values.fail(TAP_WITH_FEED_FUNCTION, span, function="G96")
            feed = self._state.feed_mm_s
            if feed == 0.0:
                self._values.fail(NO_FEED_ACTIVE, span)
            turn = DEGREES_PER_S * speed / feed
        else:
            pitch = self._pitch(start, target, span)
            feed = abs(pitch) * size / 60.0
            turn = 360.0 / pitch if motion != TAP_RETRACTION else -360.0 / pitch
            turn = turn if speed > 0.0 else -turn
        spindle_v = DEGREES_PER_S * size
        return feed, FeedModifiers(
            modifiers.override, modifiers.is_exempt, index, spindle_v, rows.TAPPING, turn
        )

    def _spindle(self, span: Span) -> int:
        """Return the index of the spindle of the thread: the main one, or that of S in tapping."""
        thread = self._state.thread
        name = ""
        if self._state.motion in TAPPING_FUNCTIONS and thread.spindle >= 0:
            name = self._environment.parameters.spindles[thread.spindle].name
        index, spindle = find(self._values, name, span)
        if spindle.plc_controlled:
            self._values.fail(
                THREAD_WITH_PLC_SPINDLE,
                span,
                function=f"G{self._state.motion}",
                spindle=spindle.name,
            )
        return index

    def _pitch(self, start: Sequence[float], target: Sequence[float], span: Span) -> float:
        """Return the pitch along the path in mm, with its sign, for a block that moves."""
        offsets = self._environment.offsets
        begin, end = offsets.inside(start), offsets.inside(target)
        distances = [abs(end[axis] - begin[axis]) for axis in range(min(MAIN_AXES, len(end)))]
        axis = len(distances) - 1
        for other, distance in enumerate(distances[:_LONGITUDINAL]):
            if distance >= distances[axis] and distance > 0.0:
                axis = other
        word = PITCH_WORDS[axis]
        pitch = self._state.thread.pitches.get(word, 0.0)
        if pitch == 0.0:
            function = f"G{self._state.motion}"
            self._values.fail(THREAD_PITCH_MISSING, span, function=function, word=word)
        length2 = 0.0
        for index, member in enumerate(self._environment.axes):
            if member.is_linear:
                length2 += (target[index] - start[index]) * (target[index] - start[index])
        return pitch * arithmetic.square_root(length2) / distances[axis]

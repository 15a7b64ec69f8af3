# SPDX-License-Identifier: MIT
"""Measuring with a touch probe: G100, G310, G101, G102, ``#MEAS``.

In: the words of a block, checked commands. Out: the motion of the block between ``Touch`` and
``TouchEnd``, then the measured values in the modal state; measuring offsets as commands. The signal
is HLI.PROBE or that of a simulated probe (P-AXIS-00112), whose place along the motion is computed
here.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from dataclasses import replace
from math import inf

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.modal_state import Measured, MeasuringState
from nctakt.decoder.state.queued.commands import Answer, Command, FixedStop, Segment
from nctakt.decoder.state.queued.probe_commands import MeasurementRequest, Touch, TouchEnd
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.measuring import (
    AFTER_CYCLES,
    ALL_AT_TARGET,
    AT_OBJECT,
    AT_POSITION,
    AT_REST_PCT,
    FIRST_TYPE,
    LAST_TYPE,
    ONE_AT_TARGET,
    AxisMeasuring,
)
from nctakt.messages.path.measuring import (
    CONTINUATION_WITHOUT_TYPE_3,
    MEASURING_DURING_SEARCH,
    NO_FIXED_STOP_DETECTION,
    NO_MEASURED_VALUE,
    NO_MEASURING_WAY,
    NOT_A_MEASURING_AXIS,
    SIMULATED_OFFSET_WITHOUT_MODE,
    TYPE_WITHOUT_G100,
    TYPE_WITHOUT_G310,
    UNKNOWN_MEASURING_TYPE,
    WRONG_MEASURING_AXES,
)
from nctakt.nc import tree
from nctakt.nc.meaning.path import keywords
from nctakt.nc.meaning.words import MEASURING_MODE
from nctakt.nc.vocabulary.functions import MEASURING_OFFSET_ON

#: Types of G100 other than the usual one: one axis, with G106, main axes, fixed stop.
ONE_AXIS, CONTINUING, MAIN_AXES, FIXED_STOP = 2, 3, 4, 7
#: Those of G310; 6 is the one of SERCOS drives.
INTERRUPTING = (5, 6)
_MAIN_AXES = 3
_POSITION_UNITS = 10_000


@dataclass(frozen=True, slots=True)
class _AxisMotion:
    """The motion of one axis in a measuring block, in mm or degrees."""

    measuring: AxisMeasuring
    start: float
    target: float

    def part_at(self, position: float) -> float:
        """Return the share of the motion at which the axis reaches or passes ``position``.

        Infinite: the axis does not come there.
        """
        length = self.target - self.start
        if length == 0.0:
            return inf
        part = (position - self.start) / length
        return max(part, 0.0) if part <= 1.0 else inf


class Measuring:
    """Measuring of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._state: MeasuringState = values.state.measuring

    # --- #MEAS ----------------------------------------------------------------------------------

    def command(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#MEAS``, ``#MEAS MODE``, ``#MEAS DEFAULT``."""
        words = [word.name for word in command.words]
        state = self._state
        if words == MEASURING_MODE:
            state.type = 0
            for value in command.arguments:
                assert isinstance(value, tree.Bracket)
                (item,) = value.items
                assert isinstance(item, tree.Expression)
                state.type = yield from self._type(item, number)
        elif len(words) > 1:
            if words[1] == "DEFAULT":
                state.type, state.needs_signal, state.lead, state.level = 0, None, 0.0, 1
        else:
            state.needs_signal = True
            for keyword in keywords(command):
                yield from self._setting(keyword, number)

    def _setting(self, keyword: tree.Keyword, number: int) -> Generator[Command, Answer]:
        """Execute one keyword of ``#MEAS``; the others choose among probes (900xxx)."""
        state, value = self._state, keyword.value
        if keyword.name == "EDGE":
            assert isinstance(value, tree.Name)
            state.level = 0 if value.name == "NEG" else 1
        elif keyword.name == "TYPE":
            assert value is not None
            state.type = yield from self._type(value, number)
        elif keyword.name == "ERR_NO_SIGNAL":
            assert value is not None
            state.needs_signal = arithmetic.is_true(
                (yield from self._values.evaluate(value, number))
            )
        elif keyword.name == "SIMU_OFFSET":
            assert value is not None
            modes = [axis.measuring.simulation for axis in self._environment.axes]
            if ALL_AT_TARGET not in modes:
                self._values.fail(SIMULATED_OFFSET_WITHOUT_MODE, keyword.span)
            lead = yield from self._values.evaluate(value, number)
            state.lead = lead * self._values.state.length_unit_mm

    def _type(self, value: tree.Expression, number: int) -> Generator[Command, Answer, int]:
        """Return a measuring type; raises ``DecodeError`` 20437."""
        type_ = yield from self._values.evaluate(value, number)
        if type_ != int(type_) or not FIRST_TYPE <= type_ <= LAST_TYPE:
            self._values.fail(UNKNOWN_MEASURING_TYPE, value.span, type=type_)
        return int(type_)

    @property
    def type(self) -> int:
        """The active measuring type."""
        return self._state.type or self._environment.parameters.measuring.type

    # --- G100 -----------------------------------------------------------------------------------

    def check(
        self, words: Sequence[tree.AxisWord], span: Span, *, continues: bool, interrupts: bool
    ) -> None:
        """Raise ``DecodeError`` if the active type cannot measure with the axes of a block.

        ``continues``: G106, ``interrupts``: G310.
        """
        type_, names = self.type, [word.name for word in words]
        function = "G310" if interrupts else "G100"
        self._values.check_flush_allowed(function, span)
        if self._values.state.is_searching:
            self._values.fail(MEASURING_DURING_SEARCH, span, word=function)
        if interrupts and type_ not in INTERRUPTING:
            self._values.fail(TYPE_WITHOUT_G310, span, type=type_)
        if not interrupts and type_ in INTERRUPTING:
            self._values.fail(TYPE_WITHOUT_G100, span, type=type_)
        if continues and type_ != CONTINUING:
            self._values.fail(CONTINUATION_WITHOUT_TYPE_3, span, type=type_)
        for word in words:
            index = self._environment.axis_numbers[word.name]
            is_wrong = type_ == ONE_AXIS and len(names) > 1
            if is_wrong or (type_ == MAIN_AXES and index >= _MAIN_AXES):
                listed = ", ".join(names)
                self._values.fail(
                    WRONG_MEASURING_AXES, word.span, type=type_, count=len(names), axes=listed
                )
            if not self._environment.axes[index].measuring.takes_part:
                self._values.fail(NOT_A_MEASURING_AXIS, word.span, axis=word.name)
            if type_ == FIXED_STOP:
                self._check_stop(word)

    def _check_stop(self, word: tree.AxisWord) -> None:
        """Raise ``DecodeError`` for an axis that does not notice a fixed stop (type 7)."""
        measuring = self._of(word)
        missing = None
        if not measuring.finds_stops:
            missing = "meas_signal_fixed_stop", 0
        elif measuring.stop_lag == 0.0:
            missing = "fixed_stop_pos_lag_limit", 0
        if missing is not None:
            key, value = missing
            axis, span = word.name, word.span
            self._values.fail(NO_FIXED_STOP_DETECTION, span, axis=axis, key=key, value=value)

    def speed(self, words: Sequence[tree.AxisWord]) -> float | None:
        """Return the speed of the motion in mm/s; ``None``: the programmed feed."""
        if self.type != ONE_AXIS:
            return None
        return self._of(words[0]).speed

    def _of(self, word: tree.AxisWord) -> AxisMeasuring:
        return self._environment.axes[self._environment.axis_numbers[word.name]].measuring

    def motion(
        self,
        motion: Generator[Command, Answer],
        words: Sequence[tree.AxisWord],
        continues: bool,
        span: Span,
        number: int,
    ) -> Generator[Command, Answer]:
        """Yield the motion of the block so that it measures; keep the measured values."""
        source = self._environment.source_id(span)
        answer: Answer = None
        segment: Segment | None = None
        while True:
            try:
                command = motion.send(answer)
            except StopIteration:
                break
            if isinstance(command, Segment):
                segment = command
                command = self._extended(command, words)
                yield from self._monitor(words, source, number, is_on=True)
                yield self._touch(command, words, continues, source, number)
            answer = yield command
        if segment is None:
            if self._environment.parameters.measuring.needs_travel:
                self._values.fail(NO_MEASURING_WAY, span)
            self._forget(words)
            return
        yield TouchEnd(source, number)
        yield from self._monitor(words, source, number, is_on=False)
        answer = yield MeasurementRequest(source, number)
        assert isinstance(answer, tuple)
        self._keep(answer, segment, words)

    def _monitor(
        self, words: Sequence[tree.AxisWord], source: int, number: int, *, is_on: bool
    ) -> Iterator[Command]:
        """Let the axes of type 7 look for a fixed stop, or no longer."""
        if self.type != FIXED_STOP:
            return
        for word in words:
            measuring = self._of(word)
            ticks = -(-measuring.stop_us // self._environment.cycle_time_us)
            ticks = max(ticks or measuring.stop_ticks, 1)
            index = self._environment.axis_numbers[word.name]
            yield FixedStop(
                source, number, index, is_on, measuring.stop_lag, ticks, 0.0, 1.0, False
            )

    def _forget(self, words: Sequence[tree.AxisWord]) -> None:
        """Note that the probe has not touched; the values of an earlier touch stay."""
        for word in words:
            index = self._environment.axis_numbers[word.name]
            before = self._state.measured.get(index, Measured())
            self._state.measured[index] = replace(before, has_touched=False)

    def _extended(self, segment: Segment, words: Sequence[tree.AxisWord]) -> Segment:
        """Return the motion with the overrun beyond the target that type 2 has (P-AXIS-00114)."""
        overtravel = self._of(words[0]).overtravel if self.type == ONE_AXIS else 0.0
        if overtravel == 0.0 or self._state.needs_signal is not None:
            return segment
        index = self._environment.axis_numbers[words[0].name]
        target = list(segment.target)
        target[index] += overtravel if target[index] > segment.start[index] else -overtravel
        return replace(segment, target=tuple(target))

    def _touch(
        self,
        segment: Segment,
        words: Sequence[tree.AxisWord],
        continues: bool,
        source: int,
        number: int,
    ) -> Touch:
        """Return the command that arms the probe for a motion."""
        parameters = self._environment.parameters.measuring
        needed = self._state.needs_signal
        if needed is None and self.type == FIXED_STOP:
            needed = parameters.needs_fixed_stop
        elif needed is None:
            needed = self.type == ONE_AXIS or parameters.needs_signal
        needed = needed and self.type not in INTERRUPTING
        motions = []
        for word in words:
            index = self._environment.axis_numbers[word.name]
            motions.append(_AxisMotion(self._of(word), segment.start[index], segment.target[index]))
        part = min((self._part(moved, motions, segment) for moved in motions), default=inf)
        simulated = (moved.measuring for moved in motions)
        cycles = [one.first for one in simulated if one.simulation == AFTER_CYCLES]
        if self.type == FIXED_STOP:
            level = codes.FIXED_STOP_SIGNAL
            return Touch(source, number, -1.0, -1, level, False, needed, may_be_pressed=False)
        return Touch(
            source,
            number,
            part if part <= 1.0 else -1.0,
            min(cycles, default=-1),
            self._state.level,
            continues,
            needed,
            parameters.may_be_pressed,
        )

    def _part(self, moved: _AxisMotion, motions: Sequence[_AxisMotion], segment: Segment) -> float:
        """Return the share of the block's length at which the simulated probe of an axis touches.

        Infinite: it does not.
        """
        mode, first = moved.measuring.simulation, moved.measuring.first
        part = inf
        if mode == AT_POSITION:
            part = moved.part_at(first / _POSITION_UNITS)
        elif mode == AT_REST_PCT:
            part = min(max(1.0 - first / 100.0, 0.0), 1.0)
        elif mode == AT_OBJECT:
            part = _part_of_object(motions)
        elif mode == ALL_AT_TARGET:
            part = max(1.0 - self._state.lead / _length(segment), 0.0)
        elif mode == ONE_AT_TARGET:
            part = 0.0 if moved.start == moved.target else 1.0
        return part

    def _keep(
        self, answer: Sequence[float], segment: Segment, words: Sequence[tree.AxisWord]
    ) -> None:
        """Keep the answer of the realtime part: positions of the axes, and measured values."""
        count = len(segment.target)
        has_touched, positions = bool(answer[0]), list(answer[1 : 1 + count])
        of_axes = answer[1 + count : 1 + 2 * count]
        programmed = list(answer[1 + 2 * count :])
        offsets = self._environment.offsets
        self._values.state.positions = positions
        if not has_touched:
            self._forget(words)
            return
        values, goal = offsets.inside(programmed), offsets.inside(segment.target)
        radius = self._probe_radius(offsets.inside(segment.start), goal)
        for index in self._measured_axes(words):
            self._state.measured[index] = Measured(
                True,
                values[index],
                of_axes[index],
                values[index] - offsets.total(index) + radius[index],
                values[index] - goal[index],
            )

    def _measured_axes(self, words: Sequence[tree.AxisWord]) -> list[int]:
        """Return the programmed axes; all measuring axes where P-CHAN-00327 says so.

        That needs a coordinate system, a map of the contour or a transformation.
        """
        state, offsets = self._values.state, self._environment.offsets
        has_system = offsets.systems.is_active or state.frame.is_active
        if self._environment.parameters.measuring.of_all_axes and (
            has_system or offsets.transformation.is_active
        ):
            axes = enumerate(self._environment.axes)
            return [index for index, axis in axes if axis.measuring.takes_part]
        return [self._environment.axis_numbers[word.name] for word in words]

    def _probe_radius(self, start: Sequence[float], goal: Sequence[float]) -> list[float]:
        """Return the distance from the centre of the probe to the workpiece, in each axis, mm.

        The probe's radius is that of the tool; it touches in the direction of the motion.
        """
        steps = [end - begin for begin, end in zip(start, goal, strict=True)]
        length = arithmetic.square_root(sum(step * step for step in steps[:_MAIN_AXES]))
        radius = self._values.state.tool.tool.radius
        if length == 0.0 or not self._environment.parameters.measuring.adds_radius:
            return [0.0] * len(steps)
        main = [radius * step / length for step in steps[:_MAIN_AXES]]
        return main + [0.0] * (len(steps) - len(main))

    # --- G101, G102 -----------------------------------------------------------------------------

    def include(
        self,
        function: int,
        words: Sequence[tuple[tree.AxisWord, float]],
        source: int,
        number: int,
    ) -> Iterator[Command]:
        """Yield the measuring offsets of G101, the deviation times the factor; G102: none."""
        for word, factor in words:
            index = self._environment.axis_numbers[word.name]
            offset = 0.0
            if function == MEASURING_OFFSET_ON:
                measured = self._state.measured.get(index, Measured())
                if not measured.has_touched:
                    self._values.fail(NO_MEASURED_VALUE, word.span, axis=word.name)
                offset = measured.deviation * factor
            yield from self._environment.offsets.set_measured(index, offset, source, number)


def _part_of_object(motions: Sequence[_AxisMotion]) -> float:
    """Return the share of the path at which all axes are within the object of P-AXIS-00145, 00146.

    Axes without this mode do not count; infinite: it is not touched.
    """
    enter, leave = 0.0, 1.0
    for moved in motions:
        if moved.measuring.simulation != AT_OBJECT:
            continue
        low = moved.measuring.first / _POSITION_UNITS
        high = moved.measuring.second / _POSITION_UNITS
        length = moved.target - moved.start
        if length == 0.0:
            if not low <= moved.start <= high:
                return inf
            continue
        ends = sorted(((low - moved.start) / length, (high - moved.start) / length))
        enter, leave = max(enter, ends[0]), min(leave, ends[1])
    return enter if enter <= leave else inf


def _length(segment: Segment) -> float:
    """Return the length of a line, mm or degrees."""
    steps = (end - begin for begin, end in zip(segment.start, segment.target, strict=True))
    return arithmetic.square_root(sum(step * step for step in steps))

# SPDX-License-Identifier: MIT
"""The words of a block -> commands: G, F, axis words, M and H functions.

Order within a block: modal G functions and F, functions before the motion, the motion, functions
after it, the end of the program.
"""

from __future__ import annotations

from collections.abc import Container, Generator, Iterator, Mapping, Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.cutting_speed import CuttingSpeeds
from nctakt.decoder.blocks.feed import FeedRate
from nctakt.decoder.blocks.fixed_stops import (
    begin_or_end,
    check_free,
    fixed_stop,
    is_fixed_stop,
)
from nctakt.decoder.blocks.in_force_marks import InForceMarks
from nctakt.decoder.blocks.path_motion import CENTRE_WORDS, PathMotion, PathWords
from nctakt.decoder.blocks.spindles import SpindleWords, is_revolutions, names_of
from nctakt.decoder.blocks.technology_output import (
    BlockFunction,
    TechnologyOutputs,
    block_function,
    tool_function,
)
from nctakt.decoder.blocks.threads import ThreadMotion
from nctakt.decoder.blocks.weights import Weights, weigh
from nctakt.decoder.state.arcs import PLANES, SAME_POINT_MM
from nctakt.decoder.state.commands import (
    Answer,
    Command,
    Dwell,
    FixedStop,
    FixedStopEnd,
    Flush,
    Measure,
    MeasureEnd,
    PositionRequest,
    ProgramStop,
    Segment,
    TechnologyOutput,
)
from nctakt.decoder.state.coordinate_systems import MAIN_AXES
from nctakt.decoder.state.offsets import ZERO_GROUPS
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.offsets import MAX_GROUPS
from nctakt.messages.backward import EDGE_BANDING_NOT_SIMULATED
from nctakt.messages.decoder import INVALID_DWELL_TIME
from nctakt.messages.offsets import UNKNOWN_ZERO_OFFSET
from nctakt.nc import tree
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import (
    ABSOLUTE,
    ARC_RADIUS,
    ARCS,
    AXIS_WEIGHTS,
    COMPENSATIONS,
    CONTOURING_ONCE,
    DWELL,
    EDGE_BANDING,
    EXACT_STOP_ONCE,
    INCH,
    NO_OVERRIDE,
    NUMBERED_ZERO_OFFSET,
    OPTIONAL_STOPS,
    PROGRAM_ENDS,
    PROGRAM_STOPS,
    REFERENCE_OFFSET,
    TAPPING_FUNCTIONS,
    THREADS,
    WEIGHTS,
    group_of,
)
from nctakt.nc.vocabulary.spindle_commands import split

#: G functions for one block only.
ONE_BLOCK = frozenset((EXACT_STOP_ONCE, CONTOURING_ONCE, NO_OVERRIDE))


@dataclass(slots=True)
class _BlockContent:
    """A block's words by effect; ``has_offset_word``: there is a D."""

    axes: list[tuple[tree.AxisWord, float]] = field(default_factory=list)
    path: PathWords = field(default_factory=PathWords)
    functions: list[BlockFunction] = field(default_factory=list)
    dwell_s: float | None = None
    zero_group: int | None = None
    is_reference: bool = False
    updates_tool_offsets: bool = False
    has_offset_word: bool = False
    stops: tuple[tuple[tree.BracketCommand, FixedStop], ...] = ()
    program_stops: tuple[ProgramStop, ...] = ()
    ends_program: bool = False
    weights: Weights = field(default_factory=dict)


class BlockDecoder:
    """Decodes the blocks of one program; ``has_motion``: the last one commanded a motion."""

    def __init__(self, values: Values, uncertain_axes: UncertainAxes) -> None:
        self._uncertain_axes = uncertain_axes
        self._values = values
        self._environment = values.environment
        self._state = values.state
        marks = values.environment.marks_blocks
        self._in_force = InForceMarks(values.environment, values.state) if marks else None
        self._is_linear = [axis.is_linear for axis in self._environment.axes]
        self._spindles = SpindleWords(values, CuttingSpeeds(values))
        threads = ThreadMotion(values, self._spindles)
        self.path = PathMotion(values, FeedRate(values, self._spindles), threads)
        self.technology = TechnologyOutputs()
        self.has_motion = False
        self._spindle_names = names_of(self._environment.parameters.spindles)

    def presets(self, command: tree.OffsetCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#PSET`` or ``#PRESET``."""
        offsets = self._environment.offsets
        source = self._environment.source_id(command.span)
        for axis in range(len(self._state.positions)) if not command.words else ():
            yield from offsets.release(axis, source, number)
        for word in command.words:
            assert isinstance(word, tree.AxisWord)
            assert word.value is not None
            axis = self._environment.axis_numbers[word.name]
            if command.name == "PRESET":
                yield from offsets.release(axis, source, number)
                continue
            programmed = yield from self._values.evaluate(word.value, number)
            value = self._in_axis_unit(axis, programmed)
            yield from self.request([word.name], command.span, number)
            position = offsets.inside(self._state.positions)[axis]
            yield from offsets.preset(axis, position, value, source, number)

    def block(
        self, block: tree.Block, number: int, kinds: int = codes.ALL_OFFSETS
    ) -> Generator[Command, Answer, bool]:
        """Yield the commands of a block; return true if it ends the program.

        ``kinds``: the offsets that apply to its absolute positions.
        """
        self.has_motion = False
        content = yield from self._sort(block, number)
        if self._in_force is not None:
            yield from self._in_force.of_block(block.span, number)
        if self._state.monitored:
            check_free(self._values, [word for word, _ in content.axes], content.stops)
        content.path.offset_kinds = kinds
        yield from self._offsets(content, self._environment.source_id(block.span), number)
        if content.updates_tool_offsets:
            yield from self._values.tool.offsets(block.span, number)
        yield from weigh(self._values, content.weights, number)
        if content.functions:
            yield from self.technology.before_motion(content.functions)
        measured = (
            self.technology.take_measuring(content.functions) if self._state.measures else None
        )
        if measured is not None:
            yield from self._measure(content, measured, block.span, number)
        elif content.stops:
            yield from self._move_to_fixed_stop(content, block.span, number)
        else:
            yield from self._motion(content, block.span, number)
        if content.dwell_s is not None:
            yield from self.dwell(content.dwell_s, block.span, number)
        if content.functions:
            yield from self.technology.after_motion(content.functions)
        yield from content.program_stops
        return content.ends_program

    def _sort(self, block: tree.Block, number: int) -> Generator[Command, Answer, _BlockContent]:
        """Evaluate the words; G and F take effect at once, regardless of their order."""
        content = _BlockContent()
        numbers: dict[int, Span] = {}
        for word in block.words:
            if isinstance(word, tree.Word) and word.name == "G":
                if isinstance(word.value, tree.Number):
                    numbers[round(word.value.value)] = word.span
            elif isinstance(word, tree.Word) and word.name == "D":
                content.has_offset_word = True
        if numbers:
            self._functions(numbers, content)
        rest: Sequence[tree.BlockWord] = block.words
        if DWELL in numbers:
            rest = [word for word in rest if not is_revolutions(word)]
            content.dwell_s = yield from self._spindles.dwell_s(block, number)
        commands, words = split(rest, self._spindle_names)
        for word in words:
            if isinstance(word, tree.AxisWord):
                if word.value is not None:
                    value = self._values.constant_value(word.value)
                    if value is None:
                        value = yield from self._values.evaluate(word.value, number)
                    content.axes.append((word, value))
                continue
            if isinstance(word, tree.BracketCommand):
                axis = self._environment.axis_numbers[word.name]
                if is_fixed_stop(word):
                    stop = yield from fixed_stop(self._values, word, axis, number)
                    content.stops += ((word, stop),)
                    continue
                yield from self.path.feed_rate.override(word.items, number, axis)
                continue
            assert isinstance(word, tree.Word), word
            if word.name == "G":
                if word.additional is not None:
                    additional = yield from self._values.evaluate(word.additional, number)
                    self._additional(word, additional, content)
                continue
            assert word.value is not None, word
            value = self._values.constant_value(word.value)
            if value is None:
                value = yield from self._values.evaluate(word.value, number)
            extra = None
            if word.additional is not None:
                extra = yield from self._values.evaluate(word.additional, number)
            if word.name in ("T", "D"):
                yield from self._tool(word, value, number, content)
            else:
                self._word(word, value, extra, number, content)
        for function in COMPENSATIONS:
            if function in numbers:
                self.path.compensate(function, numbers[function])
        if self._state.motion in THREADS and content.path.centre:
            self.path.threads.pitches(content.path.centre)
            content.path.centre = {}
        if commands or self._spindles.is_concerned(numbers):
            yield from self._spindles.speed_functions(numbers, number)
        for command in commands:
            if self._state.motion in TAPPING_FUNCTIONS:
                yield from self.path.threads.speed(command, number)
                continue
            content.functions += yield from self._spindles.functions(command, number)
        if DWELL in numbers and content.axes:
            content.dwell_s = content.axes.pop()[1]
        for function in AXIS_WEIGHTS.intersection(numbers):
            content.weights[function], content.axes = (numbers[function], content.axes), []
        return content

    def _tool(
        self, word: tree.Word, value: float, number: int, content: _BlockContent
    ) -> Generator[Command, Answer]:
        """Process T or D; T may go to the PLC, and select offsets where the block has no D."""
        selection = self._environment.parameters.tool_selection
        if word.name == "T":
            tool = self._values.tool.name(word, value)
            if selection.output is not None:
                content.functions.append(
                    tool_function(self._values, word.span, tool, selection.output, number)
                )
            if not selection.by_t or content.has_offset_word:
                return
        if selection.flushes:
            self._values.check_flush_allowed(word.name, word.span)
            yield Flush(self._environment.source_id(word.span), number, True)
        self._values.tool.select(word, value)
        content.updates_tool_offsets = True

    def _functions(self, numbers: Mapping[int, Span], content: _BlockContent) -> None:
        """Execute the G functions of a block; modal ones take effect at once."""
        content.updates_tool_offsets = any(function in PLANES for function in numbers)
        for function, span in numbers.items():
            self._state.note(function)
            if self._in_force is not None:
                self._in_force.note(function)
            self._modal(function, span)
            content.zero_group = ZERO_GROUPS.get(function, content.zero_group)
        content.is_reference = REFERENCE_OFFSET in numbers
        content.path.once = ONE_BLOCK.intersection(numbers)

    def _additional(self, word: tree.Word, value: float, content: _BlockContent) -> None:
        """Process the offset of G159, the radius of G163 or the time of G04."""
        assert isinstance(word.value, tree.Number)
        function = word.value.value
        if function == ARC_RADIUS:
            self._state.path.radius = value * self._state.length_unit_mm
        elif function == DWELL:
            content.dwell_s = value
        elif function == NUMBERED_ZERO_OFFSET:
            self._zero_group(word, value, content)
        elif function in WEIGHTS:
            content.weights[int(function)] = (word.span, value)

    def _zero_group(self, word: tree.Word, value: float, content: _BlockContent) -> None:
        """Select the zero offset with this number; raises ``DecodeError`` if there is none."""
        group = arithmetic.round_half_even(value)
        if not 0 <= group < MAX_GROUPS:
            self._values.fail(UNKNOWN_ZERO_OFFSET, word.span, group=value, highest=MAX_GROUPS - 1)
        content.zero_group = int(group)

    def _offsets(self, content: _BlockContent, source: int, number: int) -> Iterator[Command]:
        """Yield the zero offsets, and those of G92, whose axis words are no motion (MO-8)."""
        offsets = self._environment.offsets
        if content.zero_group is not None:
            yield from offsets.select_group(content.zero_group, source, number)
        if content.is_reference:
            for word, value in content.axes:
                axis = self._environment.axis_numbers[word.name]
                shift = self._in_axis_unit(axis, value)
                relative = not self._state.absolute
                yield from offsets.add_zero(axis, shift, relative, source, number)
            content.axes.clear()

    def _in_axis_unit(self, axis: int, value: float) -> float:
        """Return a programmed value in mm or degrees."""
        return value * self._state.length_unit_mm if self._is_linear[axis] else value

    def _modal(self, function: int, span: Span) -> None:
        state = self._state
        match group_of(function):
            case Group.UNIT:
                state.inch = function == INCH
            case Group.DIMENSION:
                state.absolute = function == ABSOLUTE
            case Group.EDGE_BANDING:
                self._edge_banding(function, span)
            case group:
                if state.path.compensation.is_active:
                    if group is Group.PLANE:
                        self.path.keep_plane(function, span)
                    elif group is Group.APPROACH:
                        self.path.keep_selection(function, span)
                self.path.modal(function)

    def _edge_banding(self, function: int, span: Span) -> None:
        """Let the next block with a function of the type MNE_SNS look for an edge (G108)."""
        if function == EDGE_BANDING and self._environment.parameters.edge_across_blocks:
            self._values.fail(EDGE_BANDING_NOT_SIMULATED, span)
        self._state.measures = function == EDGE_BANDING

    def _word(
        self,
        word: tree.Word,
        value: float,
        extra: float | None,
        block: int,
        content: _BlockContent,
    ) -> None:
        if self.path.word(word, value):
            return
        if word.name == "E":
            content.path.end_feed = (word.span, value)
            return
        if word.name in CENTRE_WORDS:
            content.path.centre[word.name] = (word.span, value)
            return
        number = int(arithmetic.round_half_even(value))
        content.ends_program |= word.name == "M" and number in PROGRAM_ENDS
        if word.name == "M" and number in PROGRAM_STOPS:
            source = self._environment.source_id(word.span)
            content.program_stops += (ProgramStop(source, block, number in OPTIONAL_STOPS),)
        parameters = self._environment.parameters
        table = parameters.m_functions if word.name == "M" else parameters.h_functions
        if number in table:
            function = block_function(self._values, word, table[number], extra, block)
            content.functions.append(function)

    def _motion(
        self, content: _BlockContent, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Yield the path to the programmed position; a centre without a target is a full circle."""
        if not content.axes and not (content.path.centre and self._state.motion in ARCS):
            return
        self.has_motion = True
        if not self._uncertain_axes.is_empty:
            yield from self.request(self._programmed(content), span, number)
        start = self._state.positions
        target = self._target(content, span)
        segment = self.path.segment(start, target, content.path, span, number)
        self._state.positions = target
        if segment is None:
            yield from self._uncertain_axes.pass_over(self._environment.source_id(span), number)
            return
        if segment.is_feed and self.technology.awaits_feed:
            yield from self.technology.before_feed()
        yield segment

    def _measure(
        self, content: _BlockContent, measured: BlockFunction, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Yield a motion that looks for the edge of the strip (G108, V.RTG.MEAS_DELTA)."""
        self._state.measures = False
        source = self._environment.source_id(span)
        output = measured.output
        assert isinstance(output, TechnologyOutput)
        residual = self._environment.parameters.residual_path_mm
        function, ticks, value = output.function, output.ticks, output.value
        yield Measure(source, number, function, ticks, residual, value)
        yield from self._motion(content, span, number)
        yield MeasureEnd(source, number)

    def _move_to_fixed_stop(
        self, content: _BlockContent, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Yield a motion to or from a fixed stop; its end is known to the axes only (MO-12)."""
        moved = self._programmed(content)
        for word, stop in content.stops:
            begin_or_end(self._values, word, stop, moved)
            yield stop
        yield from self._motion(content, span, number)
        if any(stop.is_on for _, stop in content.stops):
            source = self._environment.source_id(span)
            yield FixedStopEnd(source, number)
            answer = yield PositionRequest(source, number)
            assert isinstance(answer, tuple)
            self._state.positions = list(answer)

    def _programmed(self, content: _BlockContent) -> list[str]:
        """Return the names of the axes of the block; an arc moves both axes of its plane."""
        names = [word.name for word, _ in content.axes]
        if self._state.motion in ARCS:
            plane = PLANES[self._state.path.plane]
            for name, axis in self._environment.axis_numbers.items():
                if axis in plane and name not in names:
                    names.append(name)
        if self._environment.offsets.systems.is_active:
            main = list(self._environment.axis_numbers)[:MAIN_AXES]
            names += [name for name in main if name not in names]
        return self._environment.offsets.transformation.with_moved(names)

    def request(self, axes: Sequence[str], span: Span, number: int) -> Generator[Command, Answer]:
        """Request the positions of those of these axes that cycles may have moved (RC-409)."""
        uncertain = self._uncertain_axes.uncertain(axes)
        if not uncertain:
            return
        self._values.check_flush_allowed(", ".join(uncertain), span)
        source = self._environment.source_id(span)
        indices = [self._environment.axis_numbers[name] for name in uncertain]
        if self._environment.offsets.transformation.is_active:
            indices = list(range(len(self._state.positions)))
        numbers = (self._environment.names.axis(name) for name in uncertain)
        answer = yield PositionRequest(
            source, number, tuple(axis.number for axis in numbers if axis is not None)
        )
        assert isinstance(answer, tuple)
        for index in indices:
            self._state.positions[index] = answer[index]
        self._uncertain_axes.confirm(uncertain)

    def axes_moved_by(self, command: Command) -> list[str]:
        """Return the names of the axes that a command moves with the path."""
        if not isinstance(command, Segment):
            return []
        plane = () if command.arc is None else command.arc[:2]
        numbers = self._environment.axis_numbers
        start, target = command.start, command.target
        names = [n for n, axis in numbers.items() if start[axis] != target[axis] or axis in plane]
        return self._environment.offsets.transformation.with_moved(names)

    def _target(self, content: _BlockContent, span: Span) -> list[float]:
        """Return the axis positions at the end of the block."""
        offsets, kinds = self._environment.offsets, content.path.offset_kinds
        target = offsets.inside(self._state.positions, kinds)
        spans = {}
        for word, value in content.axes:
            index = self._environment.axis_numbers[word.name]
            begin = offsets.total(index, kinds) if self._state.absolute else target[index]
            target[index] = begin + self.path.radius_of(index, self._in_axis_unit(index, value))
            spans[index] = word.span
        if offsets.systems.is_active:
            target = self._outside(target, spans, kinds)
            if any(index < MAIN_AXES for index in spans):
                spans = {index: span for index in range(MAIN_AXES)} | spans
        if not offsets.transformation.is_active:
            for index, word_span in spans.items():
                self.path.check_limit(index, target[index], word_span)
        return target

    def _outside(self, target: list[float], programmed: Container[int], kinds: int) -> list[float]:
        """Return a target in the program's coordinate system as axis positions.

        Axes that only rounding would move keep their positions.
        """
        start = self._state.positions
        positions = self._environment.offsets.outside(target, kinds)
        turns = any(axis in programmed for axis in range(MAIN_AXES))
        for index, before in enumerate(start):
            moves = turns if index < MAIN_AXES else index in programmed
            if not moves or abs(positions[index] - before) < SAME_POINT_MM:
                positions[index] = before
        return positions

    def dwell(self, seconds: float, span: Span, number: int) -> Generator[Command, Answer]:
        """Yield a dwell of ``ceil(d / T)`` ticks (RC-005)."""
        if seconds < 0.0:
            self._values.fail(INVALID_DWELL_TIME, span, seconds=seconds)
        count = int(arithmetic.ceiling(seconds * 1e6 / self._environment.cycle_time_us - 1e-6))
        if count > 0:
            yield Dwell(self._environment.source_id(span), number, count)
        else:
            yield from self._uncertain_axes.pass_over(self._environment.source_id(span), number)

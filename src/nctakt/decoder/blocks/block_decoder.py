# SPDX-License-Identifier: MIT
"""The words of a block -> commands: G, F, axis words, M and H functions.

Order within a block: modal G functions and F, functions before the motion, the motion, functions
after it, the end of the program.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.axes.axis_functions import AxisFunctions
from nctakt.decoder.blocks.axes.cutting_speed import CuttingSpeeds
from nctakt.decoder.blocks.axes.fixed_stops import (
    begin_or_end,
    check_free,
    fixed_stop,
    is_fixed_stop,
)
from nctakt.decoder.blocks.axes.gear_changes import GearChanges
from nctakt.decoder.blocks.axes.independent_axes import IndependentAxes
from nctakt.decoder.blocks.axes.moved_axes import MovedAxes
from nctakt.decoder.blocks.axes.oscillations import Oscillations
from nctakt.decoder.blocks.axes.spindles import SpindleWords, is_revolutions
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.blocks.edge_banding import seek_edge
from nctakt.decoder.blocks.frames.frame_commands import FrameCommands
from nctakt.decoder.blocks.frames.orientation import Orientation
from nctakt.decoder.blocks.in_force_marks import InForceMarks
from nctakt.decoder.blocks.measuring import Measuring
from nctakt.decoder.blocks.modal_functions import ModalFunctions
from nctakt.decoder.blocks.path.contour_lines import ContourLines, FirstLine
from nctakt.decoder.blocks.path.corners import changes_contour
from nctakt.decoder.blocks.path.feed import FeedRate
from nctakt.decoder.blocks.path.feed_ramps import FeedRamps
from nctakt.decoder.blocks.path.path_motion import CENTRE_WORDS, PathMotion
from nctakt.decoder.blocks.path.threads import ThreadMotion
from nctakt.decoder.blocks.path.weights import DynamicWeighting, weigh
from nctakt.decoder.blocks.targets import Targets
from nctakt.decoder.blocks.technology_output import (
    TechnologyOutputs,
    block_function,
)
from nctakt.decoder.blocks.tool_words import ToolWords
from nctakt.decoder.state.geometry.arcs import PLANES
from nctakt.decoder.state.geometry.offsets import ZERO_GROUPS
from nctakt.decoder.state.queued.commands import (
    Answer,
    Command,
    Dwell,
    FixedStopEnd,
    PositionRequest,
    ProgramStop,
)
from nctakt.decoder.state.queued.shape_commands import ReleaseMotions
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.offsets import MAX_GROUPS
from nctakt.messages.programs.checked_blocks import EXCLUSIVE_WORDS
from nctakt.messages.programs.decoder import INVALID_DWELL_TIME
from nctakt.messages.programs.offsets import UNKNOWN_ZERO_OFFSET
from nctakt.nc import tree
from nctakt.nc.vocabulary.functions import (
    ANY_ARCS,
    ARC_RADIUS,
    AXIS_VALUES,
    AXIS_WEIGHTS,
    COMPENSATIONS,
    CONTOURING_ONCE,
    DWELL,
    EXACT_STOP_ONCE,
    FEED_PER_MINUTE,
    FEED_RAMPS,
    INSERTIONS,
    INTERRUPTIBLE,
    LINE,
    MAP_FUNCTIONS,
    MEASURING,
    MEASURING_CONTINUES,
    NO_OVERRIDE,
    NUMBERED_ZERO_OFFSET,
    OPTIONAL_STOPS,
    PROGRAM_ENDS,
    PROGRAM_STOPS,
    RAPID,
    REFERENCE_OFFSET,
    ROTATION_ON,
    TANGENTIAL_APPROACH,
    TAPPING_FUNCTIONS,
    THREADS,
    WEIGHTS,
)
from nctakt.nc.vocabulary.single_axes.axis_brackets import OSC, form_of
from nctakt.nc.vocabulary.spindle_commands import SpindleCommand, split

#: G functions for one block only.
ONE_BLOCK = frozenset((EXACT_STOP_ONCE, CONTOURING_ONCE, NO_OVERRIDE, *INSERTIONS))

#: G functions that take the axis words of their block.
_TAKING_AXES = AXIS_WEIGHTS | AXIS_VALUES


class BlockDecoder:
    """Decodes the blocks of one program.

    ``has_motion``: the last one commanded a motion; ``in_force``: the marks of the functions in
    force, ``None`` without marks.
    """

    def __init__(self, values: Values, uncertain_axes: UncertainAxes) -> None:
        self._uncertain_axes = uncertain_axes
        self._values = values
        self._environment = values.environment
        self._state = values.state
        marks = values.environment.marks_blocks
        self.in_force = InForceMarks(values.environment, values.state) if marks else None
        self.spindles = SpindleWords(values, CuttingSpeeds(values), GearChanges(values))
        feed_rate = FeedRate(values, self.spindles)
        self.path = PathMotion(values, feed_rate, ThreadMotion(values, self.spindles))
        self.ramps = FeedRamps(values, feed_rate)
        self.weighting = DynamicWeighting(values, feed_rate)
        self.frame = FrameCommands(values)
        self._modal = ModalFunctions(values, self.frame, self.ramps, self.path.splines)
        self.targets = Targets(values, self.path)
        self._lines = ContourLines(values, self.targets, self.path)
        self.technology = TechnologyOutputs()
        self._measuring = Measuring(values)
        self._axis_functions = AxisFunctions(values, self._measuring, uncertain_axes)
        self.moved = MovedAxes(values, uncertain_axes)
        self._independent = IndependentAxes(values, self.moved, uncertain_axes)
        self._oscillations = Oscillations(values, self.moved)
        self.tools = ToolWords(values, self.moved)
        self.orientation = Orientation(values, self.moved)
        self.has_motion = False
        self._spindle_names = self._environment.parameters.spindle_names

    def offsets(self, command: tree.OffsetCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#PSET``, ``#PRESET`` or ``#SCALE``."""
        if command.name.startswith("SCALE"):
            yield from self.frame.scale(command, number)
            return
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
            value = self.targets.in_axis_unit(axis, programmed)
            yield from self.moved.request([word.name], command.span, number)
            position = offsets.inside(self._state.positions)[axis]
            yield from offsets.preset(axis, position, value, source, number)

    def block(
        self, block: tree.Block, number: int, kinds: int = codes.ALL_OFFSETS
    ) -> Generator[Command, Answer, bool]:
        """Yield the commands of a block; return true if it ends the program.

        ``kinds``: the offsets that apply to its absolute positions.
        """
        self.has_motion = False
        if self._state.shapes.holds_motions and changes_contour(block):
            yield ReleaseMotions(self._environment.source_id(block.span), number, block.span)
        content = yield from self._sort(block, number)
        path = content.path
        corner = self.path.corners.take(path.once, path.centre, block.span, number)
        if self.path.splines.has_words:
            yield from self.path.splines.commands(content.axes, block.span, number)
        if self.in_force is not None:
            yield from self.in_force.of_block(block.span, number)
        if self._state.monitored:
            check_free(self._values, [word for word, _ in content.axes], content.stops)
        content.path.offset_kinds = kinds
        yield from self._offsets(content, self._environment.source_id(block.span), number)
        if content.updates_tool_offsets:
            yield from self.tools.offsets(content, block.span, number)
        yield from weigh(self._values, content.weights, number)
        if content.axis_values:
            yield from self._axis_functions.execute(content.axis_values, block.span, number)
        if self.orientation.has_vector:
            yield from self.orientation.resolve(content, block.span, number)
        if self._lines.is_concerned:
            first = self._lines.complete(content, corner, block.span, number)
            if first is not None:
                yield from self._first_line(first)
            if self._lines.first is not None:
                corner = None
        if content.functions:
            yield from self.technology.before_motion(content.functions)
        if content.independent:
            yield from self._independent.begin(content, self.moved.programmed(content))
        yield from self._moves(content, block.span, number)
        if corner is not None:
            yield corner
        if content.dwell_s is not None:
            yield from self.dwell(content.dwell_s, block.span, number)
        if content.awaited:
            yield from self.moved.request(content.awaited, block.span, number)
        if content.functions:
            yield from self.technology.after_motion(content.functions)
        yield from content.program_stops
        return content.ends_program

    def _moves(self, content: BlockContent, span: Span, number: int) -> Generator[Command, Answer]:
        """Yield the motion of a block, with its measuring or stop commands."""
        measured = (
            self.technology.take_measuring(content.functions) if self._state.measures else None
        )
        if measured is not None and content.measures:
            self._values.fail(EXCLUSIVE_WORDS, content.measures, word="G100", other="G108")
        if measured is not None:
            motion = self.motion(content, span, number)
            yield from seek_edge(self._values, motion, measured, span, number)
        elif content.measures is not None:
            yield from self._measure(content, content.measures, span, number)
        elif content.stops:
            yield from self._move_to_fixed_stop(content, span, number)
        elif self._lines.first is None:
            yield from self.motion(content, span, number)

    def _first_line(self, first: FirstLine) -> Generator[Command, Answer]:
        """Yield the first of two lines, with the motion and feed of its block."""
        before = (self._state.motion, self._state.feed_mm_s)
        self._state.motion, self._state.feed_mm_s = first.motion, first.feed_mm_s
        yield from self.motion(first.content, first.span, first.number)
        if first.corner is not None:
            yield first.corner
        self._state.motion, self._state.feed_mm_s = before

    def _sort(self, block: tree.Block, number: int) -> Generator[Command, Answer, BlockContent]:
        """Evaluate the words; G and F take effect at once, regardless of their order."""
        content = BlockContent()
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
            content.dwell_s = yield from self.spindles.dwell_s(block, number)
        commands, words = split(rest, self._spindle_names)
        if self.spindles.gears.is_enabled:
            words = yield from self.spindles.change_gear(words, commands, number)
        for word in words:
            if isinstance(word, tree.AxisWord):
                if word.value is not None:
                    value = self._values.constant_value(word.value)
                    if value is None:
                        value = yield from self._values.evaluate(word.value, number)
                    if word.name not in self._environment.axis_numbers:
                        self.orientation.check(word, numbers)
                    content.axes.append((word, value))
            elif isinstance(word, tree.BracketCommand):
                yield from self._axis_command(word, number, content)
            else:
                assert isinstance(word, tree.Word), word
                yield from self._evaluate(word, numbers, number, content)
        yield from self._apply_functions(numbers, commands, number, content)
        return content

    def _axis_command(
        self, word: tree.BracketCommand, number: int, content: BlockContent
    ) -> Generator[Command, Answer]:
        """Execute the fixed stop, the override or the motion of an axis, ``X[…]``."""
        form = form_of(word)
        if form:
            reader = self._oscillations if form == OSC else self._independent
            yield from reader.read(word, number, content)
            return
        axis = self._environment.axis_numbers[word.name]
        if is_fixed_stop(word):
            stop = yield from fixed_stop(self._values, word, axis, number)
            content.stops += ((word, stop),)
        else:
            yield from self.path.feed_rate.override(word.items, number, axis)

    def _evaluate(
        self, word: tree.Word, numbers: Mapping[int, Span], number: int, content: BlockContent
    ) -> Generator[Command, Answer]:
        """Evaluate the value of a word and its additional one, and process the word."""
        if word.name == "G":
            if word.additional is not None:
                additional = yield from self._values.evaluate(word.additional, number)
                self._additional(word, additional, content)
            return
        if word.value is None:
            self.path.splines.word(word.name)
            return
        value = self._values.constant_value(word.value)
        if value is None:
            value = yield from self._values.evaluate(word.value, number)
        extra = None
        if word.additional is not None:
            extra = yield from self._values.evaluate(word.additional, number)
        if word.name == "R" and ROTATION_ON in numbers:
            content.angle_deg = value
        elif word.name in ("T", "D"):
            yield from self.tools.word(word, value, number, content)
        else:
            self._word(word, value, extra, number, content)

    def _apply_functions(
        self,
        numbers: Mapping[int, Span],
        commands: Sequence[SpindleCommand],
        number: int,
        content: BlockContent,
    ) -> Generator[Command, Answer]:
        """Apply G functions and spindle commands that need the values of the other words."""
        if not MAP_FUNCTIONS.isdisjoint(numbers):
            self.frame.words(numbers, content)
        for function in COMPENSATIONS:
            if function in numbers:
                self.path.compensate(function, numbers[function])
        if self._state.motion in THREADS and content.path.centre:
            self.path.threads.pitches(content.path.centre)
            content.path.centre = {}
        if commands or self.spindles.is_concerned(numbers):
            yield from self.spindles.speed_functions(numbers, number)
        for command in commands:
            if command.exchanges:
                yield from self.spindles.exchange(command, number)
                continue
            if self._state.motion in TAPPING_FUNCTIONS:
                yield from self.path.threads.speed(command, number)
                continue
            content.functions += yield from self.spindles.functions(command, number)
        if DWELL in numbers and content.axes:
            content.dwell_s = content.axes.pop()[1]
        if not _TAKING_AXES.isdisjoint(numbers):
            for function in AXIS_WEIGHTS.intersection(numbers):
                content.weights[function], content.axes = (numbers[function], content.axes), []
            for function in AXIS_VALUES.intersection(numbers):
                content.axis_values[function], content.axes = content.axes, []
        content.interrupts = INTERRUPTIBLE in numbers
        content.measures = numbers.get(INTERRUPTIBLE, numbers.get(MEASURING))
        content.continues = MEASURING_CONTINUES in numbers

    def _functions(self, numbers: Mapping[int, Span], content: BlockContent) -> None:
        """Execute the G functions of a block; modal ones take effect at once."""
        content.updates_tool_offsets = any(function in PLANES for function in numbers)
        if TANGENTIAL_APPROACH in numbers:
            self.path.go_tangentially(numbers[TANGENTIAL_APPROACH])
        for function, span in numbers.items():
            self._state.note(function)
            if self.in_force is not None:
                self.in_force.note(function)
            self._modal.execute(function, span)
            content.zero_group = ZERO_GROUPS.get(function, content.zero_group)
        content.is_reference = REFERENCE_OFFSET in numbers
        content.path.once = ONE_BLOCK.intersection(numbers)
        for function in FEED_RAMPS:
            if function in numbers:
                content.path.ramp = (function, self._state.feed_mm_s)

    def _additional(self, word: tree.Word, value: float, content: BlockContent) -> None:
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

    def _zero_group(self, word: tree.Word, value: float, content: BlockContent) -> None:
        """Select the zero offset with this number; raises ``DecodeError`` if there is none."""
        group = arithmetic.round_half_even(value)
        if not 0 <= group < MAX_GROUPS:
            self._values.fail(UNKNOWN_ZERO_OFFSET, word.span, group=value, highest=MAX_GROUPS - 1)
        content.zero_group = int(group)

    def _offsets(self, content: BlockContent, source: int, number: int) -> Iterator[Command]:
        """Yield the zero offsets, and those of G92, whose axis words are no motion (MO-8)."""
        offsets = self._environment.offsets
        if content.zero_group is not None:
            yield from offsets.select_group(content.zero_group, source, number)
        if content.is_reference:
            for word, value in content.axes:
                axis = self._environment.axis_numbers[word.name]
                shift = self.targets.in_axis_unit(axis, value)
                relative = not self._state.absolute
                yield from offsets.add_zero(axis, shift, relative, source, number)
            content.axes.clear()

    def _word(
        self,
        word: tree.Word,
        value: float,
        extra: float | None,
        block: int,
        content: BlockContent,
    ) -> None:
        if word.name in CENTRE_WORDS:
            content.path.centre[word.name] = (word.span, value)
            return
        if self.path.word(word, value) or self._lines.word(word.name, word.span, value):
            return
        if word.name == "E":
            content.path.end_feed = (word.span, value)
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

    def motion(self, content: BlockContent, span: Span, number: int) -> Generator[Command, Answer]:
        """Yield the path to the programmed position; a centre without a target is a full circle."""
        is_arc = bool(content.path.centre) and self._state.motion in ANY_ARCS
        if not content.axes and not is_arc:
            if content.kept:
                yield from self._keep(content, span, number)
            return
        self.has_motion = True
        if not self._uncertain_axes.is_empty:
            names = self.moved.programmed(content)
            if self._uncertain_axes.of_program(names) and self.moved.is_along_axes():
                names = self._independent.without_resting(names, self.targets.of(content, span))
            yield from self.moved.request(names, span, number)
        start = self._state.positions
        target = self.targets.of(content, span)
        segment = self.path.segment(start, target, content.path, span, number)
        self._state.positions = target
        if segment is None:
            yield from self._uncertain_axes.pass_over(self._environment.source_id(span), number)
            return
        if segment.is_feed and self.technology.awaits_feed:
            yield from self.technology.before_feed()
        if self._state.limits.weights_blocks:
            yield from self.weighting.of(segment, span, number)
        if content.path.ramp is None and not self._state.feed.slows_at_ends:
            yield segment
        else:
            yield from self.ramps.divide(segment, content.path.ramp)

    def change_tool(self, span: Span, number: int) -> Generator[Command, Answer]:
        """Activate the offsets of a tool that a command has selected."""
        content = BlockContent(selects_tool=True)
        yield from self.tools.offsets(content, span, number)
        yield from self.motion(content, span, number)

    def _keep(self, content: BlockContent, span: Span, number: int) -> Generator[Command, Answer]:
        """Yield the motion by new offsets of the tool alone: a line, whatever is modal."""
        self.has_motion = True
        modal = self._state.motion
        if modal != RAPID:
            self._state.motion = LINE
        target = self.targets.of(content, span)
        segment = self.path.segment(self._state.positions, target, content.path, span, number)
        self._state.motion, self._state.positions = modal, target
        if segment is not None:
            yield segment

    def _measure(
        self, content: BlockContent, word: Span, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Yield a motion that measures with a touch probe: a line to the target.

        G310 may be at rapid traverse.
        """
        words = [axis_word for axis_word, _ in content.axes]
        self._measuring.check(
            words, word, continues=content.continues, interrupts=content.interrupts
        )
        feed = self._state.feed
        before = (self._state.motion, self._state.feed_mm_s, feed.feed_mode)
        if not (content.interrupts and self._state.motion == RAPID):
            self._state.motion = LINE
        speed = self._measuring.speed(words)
        if speed is not None:
            self._state.feed_mm_s, feed.feed_mode = speed, FEED_PER_MINUTE
        motion = self.motion(content, span, number)
        yield from self._measuring.motion(motion, words, content.continues, span, number)
        self._state.motion, self._state.feed_mm_s, feed.feed_mode = before

    def _move_to_fixed_stop(
        self, content: BlockContent, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Yield a motion to or from a fixed stop; its end is known to the axes only (MO-12)."""
        moved = self.moved.programmed(content)
        for word, stop in content.stops:
            begin_or_end(self._values, word, stop, moved)
            yield stop
        yield from self.motion(content, span, number)
        if any(stop.is_on for _, stop in content.stops):
            source = self._environment.source_id(span)
            yield FixedStopEnd(source, number)
            answer = yield PositionRequest(source, number)
            assert isinstance(answer, tuple)
            self._state.positions = list(answer)

    def dwell(self, seconds: float, span: Span, number: int) -> Generator[Command, Answer]:
        """Yield a dwell of ``ceil(d / T)`` ticks (RC-005)."""
        if seconds < 0.0:
            self._values.fail(INVALID_DWELL_TIME, span, seconds=seconds)
        count = int(arithmetic.ceiling(seconds * 1e6 / self._environment.cycle_time_us - 1e-6))
        if count > 0:
            yield Dwell(self._environment.source_id(span), number, count)
        else:
            yield from self._uncertain_axes.pass_over(self._environment.source_id(span), number)

# SPDX-License-Identifier: MIT
"""``#`` commands of the main program that have no separate module.

In: checked nodes. Out: commands, or changes of the decoder's state.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.block_decoder import BlockDecoder
from nctakt.decoder.blocks.frames.cs_commands import CsCommands
from nctakt.decoder.blocks.frames.machine_coordinates import MachineCoordinates
from nctakt.decoder.blocks.frames.rotating_planes import RotatingPlanes
from nctakt.decoder.blocks.frames.tool_orientation import ToolOrientation
from nctakt.decoder.blocks.frames.transformation_commands import TransformationCommands
from nctakt.decoder.blocks.measuring import Measuring
from nctakt.decoder.blocks.path.feed_forward import follow_feed_forward
from nctakt.decoder.blocks.technology_output import tool_function
from nctakt.decoder.cycles.builder import TIMER_ACTIONS
from nctakt.decoder.flow.couplings import Couplings
from nctakt.decoder.state.queued.commands import (
    Answer,
    ClearHistory,
    Command,
    Flush,
    PositionRequest,
    ProgramTimer,
    UserMessage,
)
from nctakt.decoder.state.queued.shape_commands import ReleaseMotions
from nctakt.decoder.state.queued.start_block import SingleStep
from nctakt.decoder.state.queued.tool_life import UNCHANGED, SetToolLife
from nctakt.decoder.values.texts import FormatError, format_text
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.messages.axes.axis_exchange import UNKNOWN_AXIS_NUMBER
from nctakt.messages.machines.memory import NUMBER_INSTEAD_OF_TEXT
from nctakt.messages.path.contour_lines import CONTOUR_LINE_INCOMPLETE
from nctakt.messages.path.fixed_stops import POSITION_AT_FIXED_STOP
from nctakt.messages.path.motion import FILTER_NOT_SIMULATED
from nctakt.messages.path.tools import NEGATIVE_TOOL_LIFE
from nctakt.messages.path.transformations import NOT_IN_MACHINE_COORDINATES
from nctakt.messages.programs.decoder import MSG_FORMAT_MISMATCH, UNKNOWN_TIMER
from nctakt.messages.programs.single_steps import NEGATIVE_RESOLUTION
from nctakt.nc import tree
from nctakt.nc.meaning.coordinates import CONVERSIONS
from nctakt.nc.meaning.path import keywords
from nctakt.nc.meaning.words import SINGLE_STEP_OFF, is_for_simulation, numbers_of, signed_axis
from nctakt.nc.vocabulary.entries import Support
from nctakt.nc.vocabulary.file_names import MESSAGES, named_files
from nctakt.nc.vocabulary.support_level import hash_command
from nctakt.nc.vocabulary.variables.system_variables import TIMERS

#: Commands of coordinates and transformations that ``#MCS ON`` excludes, by their first words.
_NOT_IN_MCS = ("ACS", "BCS", "CS", "CYL", "ECS", "FACE", "RTCP", "TLC", "TRAFO")
#: Those that #FACE and #CYL exclude, unless they switch something off.
_NOT_IN_PLANE = ("ACS", "BCS", "CS", "ECS", "KIN", "MCS", "PTP", "RTCP", "TLC", "TRAFO")


class HashCommands:
    """Decodes these commands for one program."""

    def __init__(self, values: Values, blocks: BlockDecoder) -> None:
        self._values = values
        self._splines = blocks.path.splines
        self._environment = values.environment
        self._spindles = blocks.spindles
        self._systems = CsCommands(values)
        self._measuring = Measuring(values)
        self._couplings = Couplings(values, blocks.spindles.cutting)
        self._tools = ToolCommands(values, blocks)
        self._transformations = TransformationCommands(values)
        self._tool = ToolOrientation(values, self._transformations, blocks)
        self._machine = MachineCoordinates(values, self._systems, self._transformations)
        self._planes = RotatingPlanes(values, self._transformations)
        self._is_part_simulated = False
        self._decoders = self._table()

    def _table(self) -> dict[str, Callable[[tree.HashCommand, int], Iterable[Command]]]:
        """Return the functions that decode commands, by their rows in ``commands.tsv``."""
        return {
            "#ACS": self._systems.command,
            "#AKIMA TRANS": self._splines.settings,
            "#AX LINK": self._couplings.command,
            "#BACKWARD STORAGE CLEAR": self._clear_history,
            "#BCS": self._systems.command,
            "#CHANNEL INIT": self._take_positions,
            "#CS": self._systems.command,
            "#CS ADD": self._systems.command,
            "#CS MODE": self._systems.command,
            "#CS SELECT": self._systems.command,
            "#CYL": self._planes.command,
            "#CYL OFF": self._planes.command,
            "#DELETE": self._delete,
            "#DISABLE AX LINK": self._couplings.command,
            "#ECS": self._effector,
            "#ENABLE AX LINK": self._couplings.command,
            "#FACE": self._planes.command,
            "#FACE OFF": self._planes.command,
            "#FILE NAME": self._file,
            "#FILENAME": self._file,
            "#FILTER": self._refuse_filters,
            "#KIN ID": self._transformations.command,
            "#MAIN SPINDLE": self._spindles.choose_main,
            "#MCS": self._machine.command,
            "#MCS TO WCS": self._machine.command,
            "#MEAS": self._measuring.command,
            "#OPTIONAL EXECUTION": self._optional_part,
            "#ORI MODE": self._transformations.command,
            "#PTP": self._transformations.command,
            "#RTCP": self._transformations.command,
            "#SET ASPLINE MODE": self._splines.settings,
            "#SET AX LINK": self._couplings.command,
            "#SET DEC LR SOLL": self._take_positions,
            "#SET SPLINETYPE": self._splines.settings,
            "#SINGLE STEP": self._single_step,
            "#SPLINE TYPE": self._splines.settings,
            "#TLAX": self._tools.length_axis,
            "#TLC": self._transformations.command,
            "#TOOL DATA": self._tools.command,
            "#TOOL LIFE DEF": self._tools.command,
            "#TOOL LIFE READ": self._tools.command,
            "#TOOL LIFE REMOVE": self._tools.command,
            "#TOOL ORI CS": self._orient_tool,
            "#TOOL PREP": self._tools.command,
            "#TOOL REFRESH": self._tools.command,
            "#TRAFO": self._transformations.command,
            "#WCS TO MCS": self._machine.command,
        }

    def begin_program(self, span: Span) -> Generator[Command, Answer]:
        """Begin a program with the offsets and the transformation of the lists."""
        yield from self._environment.offsets.begin_program()
        if self._environment.controller_data.feed_forward:
            yield from follow_feed_forward(self._values, 0, 0)
        yield from self._transformations.begin_program(span)
        yield from self._couplings.begin_program(span)

    def end_program(self, span: Span) -> Generator[Command, Answer]:
        """End a program with the transformation that the lists want then.

        Raise ``DecodeError`` where a line of ``#ANG`` has no end.
        """
        open_line = self._values.state.shapes.open_line
        if open_line is not None:
            self._values.fail(CONTOUR_LINE_INCOMPLETE, open_line)
        yield from self._couplings.end_program(span)
        yield from self._transformations.end_program(span)

    def command(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute a command; one that is not simulated has passed the check if it does nothing."""
        words = tuple(word.name for word in command.words)
        self._check_coordinates(words, command.span)
        state = self._values.state
        if state.path.compensation.is_left and state.shapes.holds_motions:
            source = self._environment.source_id(command.span)
            yield ReleaseMotions(source, number, command.span)
        entry = hash_command(words)
        assert entry is not None
        decode = self._decoders.get(entry.name)
        if decode is not None:
            yield from decode(command, number)
        else:
            assert entry.support is not Support.SIMULATED, entry.name

    def _delete(self, command: tree.HashCommand, _number: int) -> Iterable[Command]:
        for argument in command.arguments:
            assert isinstance(argument, tree.Variable)
            self._values.program_values.delete(argument)
        return ()

    def _effector(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        if command.words[-1].name == "ON":
            direction = yield from self._tool.effector(command.span, number)
            yield from self._systems.enter_effector(direction, command.span, number)
        else:
            yield from self._systems.command(command, number)

    def _orient_tool(self, command: tree.HashCommand, number: int) -> Iterable[Command]:
        return self._tool.command(command.span, number)

    def _clear_history(self, command: tree.HashCommand, number: int) -> Iterable[Command]:
        yield ClearHistory(self._environment.source_id(command.span), number)

    def _take_positions(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Continue from where the axes are."""
        source = self._environment.source_id(command.span)
        yield from self._check_numbers(command, number)
        self._check_free(command)
        name = "#" + " ".join(word.name for word in command.words)
        self._values.check_flush_allowed(name, command.span)
        answer = yield PositionRequest(source, number)
        assert isinstance(answer, tuple)
        self._values.state.positions = list(answer)

    def _single_step(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Let single block have no effect, or again, or stop at other block numbers."""
        source = self._environment.source_id(command.span)
        (item,) = keywords(command)
        if item.value is None:
            yield SingleStep(source, number, item.name == SINGLE_STEP_OFF)
            return
        value = yield from self._values.evaluate(item.value, number)
        resolution = arithmetic.round_half_even(value)
        if resolution < 0.0:
            self._values.fail(NEGATIVE_RESOLUTION, item.value.span, value=value)
        yield SingleStep(source, number, resolution=int(resolution))

    def _optional_part(self, command: tree.HashCommand, number: int) -> Iterable[Command]:
        """Prevent backward motion into a part that it would leave out."""
        switch = command.words[2].name
        if switch == "ON":
            self._is_part_simulated = is_for_simulation(command)
        if switch == "CLEAR" or not self._is_part_simulated:
            yield ClearHistory(self._environment.source_id(command.span), number)
        if switch == "OFF":
            self._is_part_simulated = False

    def _refuse_filters(self, command: tree.HashCommand, _number: int) -> Iterable[Command]:
        """Raise ``DecodeError`` where an axis has a filter that ``#FILTER`` would switch on."""
        if command.words[-1].name == "OFF":
            return ()
        for index, axis in enumerate(self._environment.axes):
            if axis.filter_type != 0:
                name = self._environment.places.name(index)
                self._values.fail(
                    FILTER_NOT_SIMULATED, command.span, axis=name, type=axis.filter_type
                )
        return ()

    def _check_coordinates(self, words: tuple[str, ...], span: Span) -> None:
        """Check that no other coordinates are asked for between ``#MCS ON`` and ``#MCS OFF``."""
        is_other = words[0] in _NOT_IN_MCS or " ".join(words) in (*CONVERSIONS, "TOOL ORI CS")
        if is_other and self._environment.offsets.suspended is not None:
            self._values.fail(NOT_IN_MACHINE_COORDINATES, span, command="#" + " ".join(words))
        if (words[0] in _NOT_IN_PLANE and words[-1] != "OFF") or " ".join(words) in CONVERSIONS:
            self._planes.check_other("#" + " ".join(words), span)

    def _check_numbers(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Check that axes of ``#CHANNEL INIT [CMDPOS AXNR=1]`` are those of the channel."""
        known = [axis.logical_number for axis in self._environment.axes]
        for item in keywords(command):
            if item.name == "AXNR" and item.value is not None:
                value = yield from self._values.evaluate(item.value, number)
                if value not in known:
                    numbers = ", ".join(str(one) for one in known)
                    self._values.fail(
                        UNKNOWN_AXIS_NUMBER, item.value.span, value=value, numbers=numbers
                    )

    def _check_free(self, command: tree.HashCommand) -> None:
        """Check that ``[ACTPOS]`` does not ask for an axis at a fixed stop (21964)."""
        items = [
            item for one in command.arguments if isinstance(one, tree.Bracket) for item in one.items
        ]
        asks_actual = any(
            isinstance(item, tree.Keyword) and item.name == "ACTPOS" for item in items
        )
        monitored = self._values.state.monitored
        if asks_actual and monitored:
            self._values.fail(POSITION_AT_FIXED_STOP, command.span, axis=min(monitored))

    def _file(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        (bracket,) = command.arguments
        assert isinstance(bracket, tree.Bracket)
        state = self._values.state
        for key, file, _ in named_files(bracket.items):
            assert file is not None
            if isinstance(file, tree.Name):
                name = file.text
            else:
                text = yield from self._values.evaluate_any(file, number)
                assert isinstance(text, str)
                name = text
            if key == MESSAGES:
                state.message_file = name
            else:
                state.named_programs[key] = name

    def timer(self, timer: tree.Timer, number: int) -> Generator[Command, Answer]:
        """Execute ``#TIMER`` at once, or with SYN in the order of the blocks."""
        identity = 0.0
        for keyword in timer.keywords:
            assert isinstance(keyword, tree.Keyword)
            assert keyword.value is not None
            identity = yield from self._values.evaluate(keyword.value, number)
            if not 0 <= identity == int(identity) < TIMERS:
                maximum = TIMERS - 1
                self._values.fail(UNKNOWN_TIMER, keyword.value.span, id=identity, maximum=maximum)
        index = int(identity)
        timers = self._environment.controller_data.timers
        if not timer.options:
            timers.command(timer.action, index)
            return
        source = self._environment.source_id(timer.span)
        yield ProgramTimer(source, number, index, TIMER_ACTIONS[timer.action])
        if timer.action == "READ":
            self._values.check_flush_allowed("#TIMER READ SYN", timer.span)
            yield Flush(source, number, True)
            timers.take_over(index)

    def message(self, statement: tree.UserMessage, number: int) -> Generator[Command, Answer]:
        """Yield ``#MSG`` with its text formatted."""
        layout = yield from self._values.evaluate_any(statement.format, number)
        if not isinstance(layout, str):
            self._values.fail(NUMBER_INSTEAD_OF_TEXT, statement.format.span, value=layout)
        values: list[float | str] = []
        for argument in statement.arguments:
            values.append((yield from self._values.evaluate_any(argument, number)))
        try:
            text = format_text(layout, values)
        except FormatError as error:
            self._values.fail(MSG_FORMAT_MISMATCH, statement.format.span, found=str(error))
        options = [option.name for option in statement.options]
        yield UserMessage(
            self._environment.source_id(statement.span),
            number,
            text,
            "EXCLUSIVE" in options,
            "CONTINUE" in options,
            self._values.state.message_file if "SAVE" in options else "",
        )


class ToolCommands:
    """Decodes these commands for one program."""

    def __init__(self, values: Values, blocks: BlockDecoder) -> None:
        self._blocks = blocks
        self._values = values
        self._environment = values.environment

    def length_axis(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#TLAX [Z-]`` or ``#TLAX DEFAULT``; it moves nothing by itself."""
        signed, axis = signed_axis(command), None
        if signed is not None:
            axis = self._environment.axis_numbers[signed[0]], signed[1]
        self._values.state.tool.length_axis = axis
        yield from self._values.tool.offsets(command.span, number)

    def command(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one of these commands."""
        name = command.words[1].name
        tool, span = self._values.tool, command.span
        if name == "LIFE":
            yield from self._life(command, number)
            return
        if name == "REFRESH":
            yield from tool.refresh(span, number)
            yield from self._blocks.change_tool(span, number)
            return
        numbers = []
        for expression in numbers_of(command) or ():
            numbers.append((yield from self._values.evaluate(expression, number)))
        identity = tool.identity(numbers, f"#TOOL {name}", span)
        selection = self._environment.parameters.tool_selection
        if name == "PREP":
            tool.prepare(identity, span)
            yield from self._blocks.tools.flush_before_t(span, number)
            yield from tool.announce(identity, "#TOOL PREP", span, number)
            if selection.output is not None:
                function = tool_function(self._values, span, identity[0], selection.output, number)
                yield function.output
                yield function.wait
            yield from tool.change_life(identity, span, number, by_d=False)
            if not selection.by_t:
                return
        if selection.flushes:
            self._values.check_flush_allowed(f"#TOOL {name}", span)
            yield Flush(self._environment.source_id(span), number, True)
        yield from tool.select_identity(identity, f"#TOOL {name}", span, number)
        yield from tool.change_life(identity, span, number, by_d=True)
        yield from self._blocks.change_tool(span, number)

    def _life(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#TOOL LIFE READ``, ``#TOOL LIFE REMOVE`` or ``#TOOL LIFE DEF``."""
        name, span = command.words[2].name, command.span
        source = self._environment.source_id(span)
        if name == "REMOVE":
            yield SetToolLife(source, number, codes.LIFE_REMOVED)
            return
        if name == "READ":
            numbers = []
            for expression in numbers_of(command) or ():
                numbers.append((yield from self._values.evaluate(expression, number)))
            identity = self._values.tool.identity(numbers, "#TOOL LIFE READ", span)
            yield self._values.tool.life(codes.LIFE_READ, identity, span, number)
            return
        given = {"TIME": UNCHANGED, "DIST": UNCHANGED}
        for item in keywords(command):
            assert item.value is not None
            value = yield from self._values.evaluate(item.value, number)
            if value < 0.0:
                self._values.fail(NEGATIVE_TOOL_LIFE, item.value.span, word=item.name, value=value)
            given[item.name] = value
        time_s, distance_mm = given["TIME"], given["DIST"]
        yield SetToolLife(source, number, codes.LIFE_DEFINED, 0, 0, time_s, distance_mm)

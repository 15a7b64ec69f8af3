# SPDX-License-Identifier: MIT
"""Decodes a checked program: blocks, flow control, ``#`` commands -> commands (RC-109).

A generator that waits by yielding: a command that ``waits`` receives its answer from ``yield``.
Mistakes that depend on values raise ``DecodeError``.
"""

from __future__ import annotations

import itertools
import operator
from collections.abc import Callable, Generator, Iterable
from functools import partial
from math import nan

from nctakt.base.diagnostics import Span
from nctakt.decoder import tilted_motions
from nctakt.decoder.blocks.block_decoder import BlockDecoder
from nctakt.decoder.blocks.path.path_motion import PathMotion
from nctakt.decoder.blocks.path.path_settings import PathSettings
from nctakt.decoder.blocks.user_errors import user_error
from nctakt.decoder.compensation import Compensation
from nctakt.decoder.cycles.builder import SCOPES, CycleDefinition, CyclePlace, built_cycle
from nctakt.decoder.cycles.keywords import keyword_of, word_of
from nctakt.decoder.fast.handover import PlainBlocks
from nctakt.decoder.flow.axis_exchange import AxisExchange
from nctakt.decoder.flow.block_search import BlockSearch
from nctakt.decoder.flow.calls import Calls, ModalCalls, has_return
from nctakt.decoder.flow.computed_blocks import is_literal, with_computed_numbers
from nctakt.decoder.flow.flow import Decoding, Flow, Jump, Return, Signal
from nctakt.decoder.flow.hash_commands import HashCommands
from nctakt.decoder.flow.macros import Macros
from nctakt.decoder.flow.realtime_loops import RealtimeLoops
from nctakt.decoder.flow.signals import Signals
from nctakt.decoder.shapes.contouring import Contouring
from nctakt.decoder.shapes.shaping import Shaping
from nctakt.decoder.state.call_stack import MAX_CALL_DEPTH, MAX_NESTING, CallFrame
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.geometry.offsets import remaining_offset_kinds
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.queued.commands import (
    CONTROL_ACTIONS,
    PAUSE,
    Answer,
    BlockMark,
    Command,
    CycleControl,
    EmptyBlock,
    Flush,
    Freeze,
    LoadCycle,
    PositionRequest,
    ProgramEnd,
    is_block,
)
from nctakt.decoder.state.queued.start_block import StartBlock
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.channel_configuration import ALL_LINES
from nctakt.messages.programs.checked_cycles import INVALID_CYCLE_ID, INVALID_GLOBAL_CYCLE_ID
from nctakt.messages.programs.decoder import (
    JUMP_TARGET_NOT_NC_TEXT,
    PROGRAMS_NESTED_TOO_DEEP,
    RETURN_LABEL_NOT_UNIQUE,
    STRUCTURES_AND_CALLS_TOO_DEEP,
    TOO_MANY_BLOCKS_WITHOUT_TIME,
)
from nctakt.nc import tree
from nctakt.nc.meaning.axes import is_c_axis, is_exchange
from nctakt.nc.meaning.path import PATH_COMMANDS, command_name
from nctakt.nc.meaning.words import HIGHEST_CYCLE_ID
from nctakt.nc.outline import ProgramText, SectionReader, leads_to


class MotionStages:
    """The stages after the decoder that change the motions of a program.

    Shapes of several blocks, then the compensation of the tool's radius, then the curves of
    contoured corners. Each holds motions until it knows the next one; held commands count as
    executed. ``pass_time`` is called once for each command that takes time.
    """

    def __init__(
        self, values: Values, path: PathMotion, pass_time: Callable[[Command], None]
    ) -> None:
        self._environment = values.environment
        self._pass_time = pass_time
        self._shaping = Shaping(values, path, pass_time)
        self.compensation = Compensation(values, path, self._after_shaping)
        self._contouring = Contouring(values, path, self._after_compensation, self.compensation)

    @property
    def needs_next(self) -> bool:
        """Whether the next motion shapes the held one."""
        return self._shaping.needs_next or self._contouring.needs_next

    @property
    def is_idle(self) -> bool:
        """Whether no stage holds a motion, so that commands pass at once."""
        stages = (self._shaping, self.compensation, self._contouring)
        return all(stage.is_idle for stage in stages)

    def run(self, commands: Generator[Command, Answer]) -> Generator[Command, Answer]:
        """Yield the commands of a program with its motions changed; raises ``DecodeError``."""
        shaped = self._shaping.shape(commands)
        return self._contouring.contour(self.compensation.compensate(shaped))

    def loop_body(self, body: list[Command]) -> list[Command]:
        """Return the commands of a realtime loop's body with its motions changed."""
        shaped = self._shaping.shape_body(body)
        whole = tilted_motions.all_out_of_plane(shaped, self._environment)
        return self._contouring.plain_body(whole)

    def pass_time(self, command: Command) -> None:
        """Note that the consumer has taken a command that takes time."""
        if not self._contouring.is_releasing:
            self._after_compensation(command)

    def _after_compensation(self, command: Command) -> None:
        if not self.compensation.is_releasing:
            self._after_shaping(command)

    def _after_shaping(self, command: Command) -> None:
        if not self._shaping.is_releasing:
            self._pass_time(command)


#: Maximum number of consecutive blocks that take no time (a loop that never moves).
MAX_BLOCKS_WITHOUT_TIME = 100_000

#: Blocks between two calls of the environment's ``poll``.
BLOCKS_PER_POLL = 1000

#: The words of the commands that wait for functions of the type MVS_SLP, and end a modal call.
EXPLICIT = ["EXPL", "SYN"]
NO_MODAL = ["DISABLE", "MODAL", "CYCLE"]

_SCOPE_NAMES = {codes.BLOCK_SCOPE: "BLOCK", codes.PROG_SCOPE: "PROG", codes.GLOBAL_SCOPE: "GLOBAL"}


class ProgramDecoder:
    """Decodes one main program.

    ``start``: the block where it begins by block search. ``next_cycle`` returns the serial number
    and the first probe of a cycle definition, ``keep_cycle`` stores the built cycle.
    ``takes_runs``: the consumer of the commands handles ``PlainRun``.
    """

    def __init__(
        self,
        environment: DecoderEnvironment,
        state: ModalState,
        next_cycle: Callable[[], tuple[int, int]],
        keep_cycle: Callable[[CycleDefinition], None],
        *,
        takes_runs: bool,
        start: StartBlock | None = None,
    ) -> None:
        self._environment = environment
        self._state = state
        self._values = Values(environment, state)
        self._uncertain_axes = UncertainAxes(environment.living_cycles, environment.moving_axes())
        self._block_decoder = BlockDecoder(self._values, self._uncertain_axes)
        path = self._block_decoder.path
        self._path_settings = PathSettings(self._values, self._block_decoder)
        self._stages = MotionStages(self._values, path, self._pass_time)
        self._calls = Calls(self._values)
        self._macros = Macros(environment, self._values.fail, state.named_programs)
        self._hash_commands = HashCommands(self._values, self._block_decoder)
        self._loops = RealtimeLoops(
            self._values, self._block_decoder, self._statements, self._stages.loop_body
        )
        self._signals = Signals(self._values, self._block_decoder.moved.request)
        self._flow = Flow(self._values, self._statements, self._count_pass)
        self._call_stack = state.call_stack
        self._modal = ModalCalls(state.call_stack)
        self._next_cycle = next_cycle
        self._keep_cycle = keep_cycle
        self._plain = PlainBlocks(
            self._values,
            self._uncertain_axes,
            self._block_decoder.technology,
            self._block_decoder.in_force,
            self._stages,
            self._stages.compensation,
            MAX_BLOCKS_WITHOUT_TIME,
        )
        self._exchange = AxisExchange(self._values, self._plain.adapt)
        self._stops_at_lines = environment.parameters.single_block == ALL_LINES
        self._takes_runs = takes_runs and not self._stops_at_lines
        self._search = BlockSearch(
            self._values,
            path,
            start,
            self._stages.pass_time,
            self._block_decoder.spindles.gears,
            self._uncertain_axes,
            lambda: self._loops.is_decoding,
        )
        self._blocks = 0
        self._started_blocks = 0
        self._passes: dict[Span, int] = {}
        self._nested = 0
        self._current: tree.Statement | None = None
        #: Called with statements of the main program; where it returns true, the commands pause
        #: before the statement.
        self.pauses_before: Callable[[tree.Statement], bool] | None = None

    def decode(self, program: ProgramText, members: list[int]) -> Generator[Command, Answer]:
        """Return the commands of a run of the main program; the last one is its end.

        The channel list may name programs that run before and after it. ``members``: the axes that
        an earlier program has left to the channel.
        """
        self._search.begin(program.source.file)
        commands = self._exchange.run(self._run(program), members, lambda: self._current)
        commands = self._stages.run(commands)
        if self._search.is_active:
            commands = self._search.filter(commands, program.main.span)
        return commands

    def resume(self, program: ProgramText, statement: tree.Statement) -> Generator[Command, Answer]:
        """Return the commands from a statement on before which they have paused."""
        self._nested = 0
        commands = self._exchange.resume(self._rest(program, statement), lambda: self._current)
        return self._stages.run(commands)

    def _rest(self, program: ProgramText, statement: tree.Statement) -> Generator[Command, Answer]:
        yield from self._run_frame(self._call_stack.top, statement)
        yield from self._end(program)

    def _run(self, program: ProgramText) -> Generator[Command, Answer]:
        yield from self._values.tool.manager.await_announcement()
        yield from self._hash_commands.begin_program(program.main.span)
        implicit = self._environment.parameters.implicit_programs
        self._calls.note_text(program)
        frame = CallFrame(program, program.main)
        self._enter(frame)
        signal: Signal = ""
        if implicit.program_start:
            start = self._calls.implicit_frame(implicit.program_start, program.main.span)
            signal = yield from self._call(start, program.main.span)
        if not signal:
            yield from self._run_frame(frame)
        yield from self._end(program)

    def _end(self, program: ProgramText) -> Generator[Command, Answer]:
        implicit = self._environment.parameters.implicit_programs
        if implicit.program_end:
            end = self._calls.implicit_frame(implicit.program_end, program.main.span)
            yield from self._call(end, program.main.span)
        yield from self._hash_commands.end_program(program.main.span)
        yield ProgramEnd(0, 0)

    @property
    def started_blocks(self) -> int:
        """The number of blocks and passes of loops started since the program began."""
        return self._started_blocks

    def pass_time(self, command: Command) -> None:
        """Note that the consumer has taken a command that takes time."""
        self._stages.pass_time(command)

    def _pass_time(self, command: Command) -> None:
        self._blocks = 0
        self._passes.clear()
        if not self._uncertain_axes.is_empty:
            self._uncertain_axes.pass_time(
                self._block_decoder.moved.axes_moved_by(command), is_block=is_block(command)
            )

    # --- programs -------------------------------------------------------------------------------

    def _enter(self, frame: CallFrame) -> None:
        self._call_stack.enter(frame)
        self._state.shapes.waits_for_next |= frame.text.joins_motions

    def _run_frame(self, frame: CallFrame, first: tree.Statement | None = None) -> Decoding:
        """Run a program from start to end, or from a statement on; a jump restarts it."""
        label: str | None = None
        while True:
            statements = frame.text.statements(frame.section, label)
            if first is not None:
                begin, first = first, None
                statements = itertools.dropwhile(partial(operator.is_not, begin), statements)
            signal = yield from self._statements(statements, label)
            if not isinstance(signal, Jump):
                return signal
            label = signal.label
            self._count_pass(signal.span)
            labels = frame.section.labels
            if label not in labels.lines or label in labels.doubled:
                self._values.fail(
                    RETURN_LABEL_NOT_UNIQUE, signal.span, label=label, name=frame.section.name
                )

    def _call(self, frame: CallFrame, span: Span) -> Decoding:
        """Run a subprogram; return the signal to its caller."""
        if len(self._call_stack.frames) >= MAX_CALL_DEPTH:
            self._values.fail(PROGRAMS_NESTED_TOO_DEEP, span, limit=MAX_CALL_DEPTH)
        self._enter(frame)
        signal = yield from self._run_frame(frame)
        self._call_stack.leave()
        if not isinstance(signal, Return):
            return signal
        calls = len(self._call_stack.frames) if signal.calls is None else signal.calls
        if calls > 1:
            return Return(calls - 1, signal.label, signal.span)
        return "" if signal.label is None else Jump(signal.label, signal.span)

    # --- statements -----------------------------------------------------------------------------

    def _statements(
        self,
        statements: Iterable[tree.Statement],
        label: str | None = None,
        *,
        is_part: bool = False,
    ) -> Decoding:
        """Run statements, from the one with or around ``label`` on if given.

        ``is_part``: they belong to one block of the program.
        """
        self._nested += 1
        reader = None
        if self._takes_runs and isinstance(statements, SectionReader):
            reader = statements
        for statement in statements:
            if self._call_stack.modal_count:
                signal = yield from self._repeated(statement.span.line)
                if signal:
                    self._nested -= 1
                    return signal
            if label is None:
                if self.pauses_before is not None and reader is None and self._may_pause:
                    if self.pauses_before(statement):
                        yield PAUSE
                signal = yield from self._statement(statement)
            elif not leads_to(statement, label):
                continue
            elif statement.head.label == label:
                label = None
                signal = yield from self._statement(statement)
            else:
                self._count(statement.span)
                inside, label = label, None
                signal = yield from self._flow.enter(statement, inside)
            if signal:
                self._nested -= 1
                return signal
            if self._call_stack.modal_count:
                self._modal.after_statement(statement)
            elif reader is not None and label is None and not self._search.is_active:
                self._blocks = yield from self._plain.decode(reader, self._blocks)
        self._nested -= 1
        if self._call_stack.modal_count and not is_part:
            return (yield from self._repeated())
        return ""

    @property
    def _may_pause(self) -> bool:
        """Whether decoding continues depending only on the place in the main program."""
        return (
            self._nested == 1
            and len(self._call_stack.frames) == 1
            and not self._call_stack.modal_count
            and not self._search.is_active
            and self._stages.is_idle
        )

    def _repeated(self, line: int | None = None) -> Decoding:
        """Run the modal call that is due before the block in this line, or at the end."""
        due = self._modal.take_due(line)
        if due is None:
            return ""
        frame, modal = due
        return (yield from self._call(frame, modal.span))

    def _count_pass(self, span: Span) -> None:
        """Count a pass of the loop, or a jump, at this span; outer loops come first."""
        self._passes[span] = self._passes.get(span, 0) + 1
        self._count(span)

    def _count(self, span: Span) -> None:
        """Count a block or pass; report too many without time, and too deep nesting."""
        self._started_blocks += 1
        self._blocks += 1
        if self._started_blocks % BLOCKS_PER_POLL == 0:
            self._environment.poll()
        if self._blocks > MAX_BLOCKS_WITHOUT_TIME:
            loops = (loop for loop, rounds in self._passes.items() if rounds > 1)
            self._values.fail(
                TOO_MANY_BLOCKS_WITHOUT_TIME, next(loops, span), count=MAX_BLOCKS_WITHOUT_TIME
            )
        if self._nested > MAX_NESTING:
            self._values.fail(STRUCTURES_AND_CALLS_TOO_DEEP, span, limit=MAX_NESTING)

    def _statement(self, statement: tree.Statement) -> Decoding:
        self._current = statement
        self._count(statement.span)
        if statement.head.skip in self._environment.skip_levels:
            return ""
        if self._macros.are_defined:
            statement = self._macros.expand_expressions(statement)
        number = 0
        if statement.head.number is not None:
            value = self._values.constant_value(statement.head.number)
            if value is None:
                value = yield from self._values.evaluate(statement.head.number, 0)
            number = self._state.block_number = int(arithmetic.round_half_even(value))
        if self._state.is_searching:
            yield from self._search.reach(statement, number)
        if self._environment.marks_blocks:
            yield self._mark(statement, number)
        if self._stops_at_lines:
            yield EmptyBlock(self._environment.source_id(statement.span), number)
        match statement:
            case tree.Block():
                return (yield from self._block(statement, number))
            case tree.OffsetCommand() if statement.name == "SUPPRESS OFFSETS":
                block = tree.Block(statement.span, statement.head, statement.words)
                return (yield from self._block(block, number, remaining_offset_kinds(statement)))
            case tree.OffsetCommand():
                yield from self._block_decoder.offsets(statement, number)
            case tree.Assignment():
                yield from self._values.assign(statement, number)
            case tree.VariableBlock():
                yield from self._values.evaluate_any(statement.variable, number)
            case tree.Break():
                return "break"
            case tree.Continue():
                return "continue"
            case tree.Goto():
                return Jump(statement.label, statement.span)
            case tree.SubprogramCall():
                if statement.words:
                    words = tree.Block(statement.span, tree.NO_HEAD, statement.words)
                    signal = yield from self._block(words, number)
                    if signal:
                        return signal
                frame = yield from self._calls.call(statement, number)
                self._modal.begin(statement, frame)
                return (yield from self._call(frame, statement.span))
            case tree.If() | tree.For() | tree.While() | tree.Do() | tree.Repeat() | tree.Switch():
                return (yield from self._flow.structure(statement, number))
            case tree.Unreadable():
                self._values.fail(JUMP_TARGET_NOT_NC_TEXT, statement.span)
            case _:
                yield from self._command(statement, number)
        return ""

    def _mark(self, statement: tree.Statement, number: int) -> BlockMark:
        """Return the mark of a block, with the calls that are open."""
        calls = self._call_stack
        calls.top.current = statement.span
        source = self._environment.source_id(statement.span)
        path_number = calls.path_number_of(self._environment.path_id)
        return BlockMark(source, number, path_number, len(calls.frames))

    def _block(self, block: tree.Block, number: int, kinds: int = codes.ALL_OFFSETS) -> Decoding:
        """Run the words of a block, then its call, then its end of program.

        ``kinds``: the offsets that apply to the block's positions.
        """
        if not is_literal(block):
            meant = self._macros.expand_block(block)
            if meant is not None:
                return (yield from self._statements(meant, is_part=True))
            block = yield from with_computed_numbers(self._values, block, number)
        returning = called = None
        if has_return(block):
            block, returning = yield from self._calls.return_of(block, number)
        if self._calls.has_implicit_programs:
            block, called = yield from self._calls.implicit_call(block, number)
        ends = yield from self._block_decoder.block(block, number, kinds)
        if called is not None:
            signal = yield from self._call(called, block.span)
            if signal:
                return signal
        if ends:
            return "end"
        if returning is not None:
            return returning
        if self._call_stack.modal_count and called is None:
            self._modal.after_block(block.span.line, self._block_decoder.has_motion)
        return ""

    # --- commands -------------------------------------------------------------------------------

    def _command(self, statement: tree.Statement, number: int) -> Generator[Command, Answer]:
        source = self._environment.source_id(statement.span)
        match statement:
            case tree.RealtimeCycle():
                yield from self._define(statement, source, number)
            case tree.CycleControl():
                yield from self._control(statement, source, number)
            case tree.RealtimeLoop():
                yield from self._loops.loop(statement, number)
            case tree.Flush():
                self._values.check_flush_allowed("#FLUSH", statement.span)
                if statement.mode != "CONTINUE":
                    yield Flush(source, number, statement.mode == "WAIT")
            case tree.Time():
                seconds = yield from self._values.evaluate(statement.seconds, number)
                yield from self._block_decoder.dwell(seconds, statement.span, number)
            case tree.UserError():
                yield from user_error(self._values, statement, number)
            case tree.UserMessage():
                yield from self._hash_commands.message(statement, number)
            case tree.HashCommand() if [word.name for word in statement.words] == EXPLICIT:
                yield from self._block_decoder.technology.explicit_synchronisation()
            case tree.HashCommand() if statement.words[0].name == "FGROUP":
                yield from self._block_decoder.path.feed_rate.groups.select(statement, number)
            case tree.HashCommand() if command_name(statement) in PATH_COMMANDS:
                yield from self._path_settings.command(statement, number)
            case tree.VariableDeclarations():
                for declaration in statement.declarations:
                    yield from self._values.declare(declaration, number)
            case tree.MacroDefinition():
                self._macros.define(statement)
            case tree.Timer():
                yield from self._hash_commands.timer(statement, number)
            case tree.HashCommand() if [word.name for word in statement.words] == NO_MODAL:
                self._modal.end()
            case tree.HashCommand() if statement.words[0].name == "BLOCKSEARCH":
                self._search.lock(statement)
            case tree.HashCommand() if statement.words[0].name in ("SIGNAL", "WAIT"):
                yield from self._signals.command(statement, number)
            case tree.HashCommand() if is_exchange(statement) or is_c_axis(statement):
                yield from self._exchange.command(statement, number)
            case tree.HashCommand():
                yield from self._hash_commands.command(statement, number)
            case tree.ProgramStart():
                pass  # a comment
            case _:
                raise AssertionError(statement)

    def _define(
        self, statement: tree.RealtimeCycle, source: int, number: int
    ) -> Generator[Command, Answer]:
        identity = yield from self._identity(statement, number)
        scope_word = keyword_of(statement.keywords, "SCOPE")
        scope = codes.PROG_SCOPE if scope_word is None else SCOPES[word_of(scope_word)]
        if identity is not None and identity < 1:
            self._values.fail(
                INVALID_GLOBAL_CYCLE_ID if scope == codes.GLOBAL_SCOPE else INVALID_CYCLE_ID,
                statement.span,
                id=identity,
            )
        serial, first_probe = self._next_cycle()
        origin = CyclePlace(serial, first_probe, identity or 0, _SCOPE_NAMES[scope])
        built = built_cycle(self._values, statement, origin)
        self._keep_cycle(built)
        starts = not statement.definition_only
        self._uncertain_axes.define_cycle(
            built.identity, built.axes, is_block=scope == codes.BLOCK_SCOPE, starts=starts
        )
        end_action = keyword_of(statement.keywords, "END_ACTION")
        moves_on = end_action is not None and word_of(end_action) == "MOVE_CONT"
        yield LoadCycle(source, number, built.cycle, built.identity, scope, not starts, moves_on)
        for frozen in built.frozen:
            source_id = self._environment.source_id(frozen.span)
            if isinstance(frozen.value, str):
                name = f'{frozen.name} "{frozen.value}"'
                yield Freeze(source_id, number, serial, name, nan)
            else:
                yield Freeze(source_id, number, serial, frozen.name, frozen.value)

    def _control(
        self, statement: tree.CycleControl, source: int, number: int
    ) -> Generator[Command, Answer]:
        identity = yield from self._identity(statement, number)
        assert identity is not None
        if identity < 1:
            self._values.fail(INVALID_CYCLE_ID, statement.span, id=identity)
        yield CycleControl(source, number, CONTROL_ACTIONS[statement.action], identity)
        if statement.action == "START":
            self._uncertain_axes.start_cycle(identity)
        if statement.action == "DELETE":
            self._values.check_flush_allowed("#RT CYCLE DELETE", statement.span)
            answer = yield PositionRequest(source, number)
            assert isinstance(answer, tuple)
            self._state.positions = list(answer)
            self._uncertain_axes.delete_cycle(identity, self._environment.moving_axes())

    def _identity(
        self, statement: tree.RealtimeCycle | tree.CycleControl, number: int
    ) -> Generator[Command, Answer, int | None]:
        keyword = keyword_of(statement.keywords, "ID")
        if keyword is None or keyword.value is None:
            return None
        value = yield from self._values.evaluate(keyword.value, number)
        if arithmetic.floor(value) != value or value > HIGHEST_CYCLE_ID:
            self._values.fail(INVALID_CYCLE_ID, keyword.value.span, id=value)
        return int(value)

# SPDX-License-Identifier: MIT
"""Block search: a program begins at one of its blocks, in the state that it would have there.

In: the commands of the program from its start on, with the shapes of its motions. Up to the start
block motions, dwells, functions, messages and signals are left out; offsets, variables, realtime
cycles and limits come into force. There spindles get their gear step and their last job, and the
axes move at rapid traverse, in a straight line, to where the block begins; a cycle with scope BLOCK
that waits for it comes after that. ``#BLOCKSEARCH LOCKED`` forbids a start in a part of a program.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.axes.gear_changes import GearChanges
from nctakt.decoder.blocks.path.path_motion import PathMotion, PathWords
from nctakt.decoder.state.queued.axis_commands import (
    EndOscillation,
    FeedForward,
    MoveAlone,
    Oscillate,
    SetSoftwareLimits,
)
from nctakt.decoder.state.queued.commands import (
    Answer,
    AwaitAcknowledge,
    Command,
    CycleControl,
    DecoderWait,
    Flush,
    Freeze,
    LoadCycle,
    PositionRequest,
    ProgramEnd,
    ProgramTimer,
    ReadRealtime,
    Segment,
    SetOffset,
    SetOrigin,
    SetTransformation,
    SetTurn,
    UserErrorReport,
    UserErrorStop,
    UserErrorText,
    UserErrorValue,
    WriteText,
    WriteVariable,
)
from nctakt.decoder.state.queued.in_force import ModalMark
from nctakt.decoder.state.queued.limit_commands import SetLimits
from nctakt.decoder.state.queued.packing import takes_time
from nctakt.decoder.state.queued.spindle_commands import CuttingSpeed, SpindleJob, SpindleLimits
from nctakt.decoder.state.queued.start_block import SingleStep, StartBlock, StartReached
from nctakt.decoder.state.queued.tool_life import SetToolLife, ToolLifeFactors
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.messages.programs.block_search import (
    START_BLOCK_LOCKED,
    START_BLOCK_NOT_REACHED,
    START_IN_LOOP,
    START_OF_SEARCH,
)
from nctakt.nc import tree
from nctakt.nc.vocabulary.functions import RAPID

#: Commands that come into force during the search.
_PASSING = (
    CuttingSpeed,
    CycleControl,
    DecoderWait,
    FeedForward,
    Flush,
    Freeze,
    LoadCycle,
    ModalMark,
    ProgramTimer,
    ReadRealtime,
    SetLimits,
    SetOffset,
    SetOrigin,
    SetSoftwareLimits,
    SetTransformation,
    SetTurn,
    SingleStep,
    SpindleLimits,
    SetToolLife,
    ToolLifeFactors,
    UserErrorReport,
    UserErrorStop,
    UserErrorText,
    UserErrorValue,
    WriteText,
    WriteVariable,
)


class _BlockCycles:
    """Cycles with scope BLOCK that are started and wait for the block after them (RC-105).

    ``waiting``: the commands from the first of them on that define and control cycles. They are
    kept in their order until the next block: if that is left out, so are its cycles.
    """

    def __init__(self) -> None:
        self.waiting: list[Command] = []
        self._reusable: set[int] = set()
        self._keeps_last = False

    def keeps(self, command: Command) -> bool:
        """Return whether a command waits here for the next block."""
        match command:
            case LoadCycle():
                is_block = command.scope == codes.BLOCK_SCOPE
                self._reusable.discard(command.identity)
                if is_block and command.definition_only:
                    self._reusable.add(command.identity)
                starts_block = is_block and not command.definition_only
                self._keeps_last = kept = starts_block or bool(self.waiting)
            case Freeze():
                kept = self._keeps_last
            case CycleControl():
                is_start = command.action == codes.CONTROL_START
                kept = bool(self.waiting) or (is_start and command.identity in self._reusable)
            case _:
                return False
        if kept:
            self.waiting.append(command)
        return kept

    def pass_block(self) -> Iterator[Command]:
        """Yield the commands that outlive a skipped block, and drop the rest."""
        if not self.waiting:
            return
        waiting, self.waiting = self.waiting, []
        dropped: set[int] = set()
        ended: set[int] = set()
        for command in waiting:
            match command:
                case LoadCycle() if command.scope == codes.BLOCK_SCOPE:
                    if command.definition_only:
                        yield command
                    else:
                        dropped.add(command.cycle.serial)
                        ended.add(command.identity)
                case LoadCycle():
                    ended.discard(command.identity)
                    yield command
                case Freeze():
                    if command.serial not in dropped:
                        yield command
                case CycleControl() if command.identity in ended:
                    pass
                case CycleControl() if (
                    command.identity in self._reusable and command.action != codes.CONTROL_DELETE
                ):
                    pass
                case _:
                    yield command


class BlockSearch:
    """The search in one program; ``start``: ``None`` without one.

    ``pass_time`` is called with each skipped command that takes time, ``in_loop`` returns whether a
    realtime loop is decoded. ``is_active``: commands of the program are skipped.
    """

    def __init__(
        self,
        values: Values,
        path: PathMotion,
        start: StartBlock | None,
        pass_time: Callable[[Command], None],
        gears: GearChanges,
        uncertain_axes: UncertainAxes,
        in_loop: Callable[[], bool],
    ) -> None:
        self._values = values
        self._path = path
        self._start = start
        self._pass_time = pass_time
        self._file = ""
        self._passes = 0
        self._is_locked = False
        self._gears = gears
        self._uncertain_axes = uncertain_axes
        self._in_loop = in_loop
        self._jobs: dict[int, SpindleJob] = {}
        self._oscillations: dict[int, Oscillate] = {}
        self._steps: dict[int, int] = {}
        self._shifted: dict[int, int] = {}
        self._awaits_shift = False
        self._at: tuple[float, ...] | None = None
        self._block_cycles = _BlockCycles()
        self.is_active = False

    def lock(self, command: tree.HashCommand) -> None:
        """Execute ``#BLOCKSEARCH LOCKED`` or ``#BLOCKSEARCH RELEASED``."""
        self._is_locked = command.words[1].name == "LOCKED"

    def begin(self, file: str) -> None:
        """Begin to search in a main program, if there is a start block."""
        self._file = file
        self._values.state.is_searching = self.is_active = self._start is not None
        gears = self._values.environment.spindle_gears
        self._steps = {index: one.active for index, one in gears.items()}

    def reach(self, statement: tree.Statement, number: int) -> Generator[Command, Answer]:
        """Begin the program here if this is the start block; raises ``DecodeError`` 21399."""
        start = self._start
        if start is None or not start.is_at(statement.span, self._file, number):
            return
        self._passes += 1
        if self._passes < start.passes:
            return
        if self._is_locked:
            self._values.fail(START_BLOCK_LOCKED, statement.span)
        if self._in_loop():
            self._values.fail(START_IN_LOOP, statement.span)
        state, environment = self._values.state, self._values.environment
        state.is_searching = False
        self._values.warn(START_OF_SEARCH, statement.span, block=start.shown)
        steps = {index: gears.active for index, gears in environment.spindle_gears.items()}
        source = environment.source_id(statement.span)
        names = environment.axis_numbers
        self._uncertain_axes.confirm(self._uncertain_axes.of_program(names))
        uncertain = self._uncertain_axes.uncertain(names)
        yield StartReached(source, number, statement.span, tuple(state.positions), uncertain, steps)

    def filter(
        self, commands: Generator[Command, Answer], span: Span
    ) -> Generator[Command, Answer]:
        """Yield the commands of a program; up to the start block only those that come into force.

        Raises ``DecodeError`` where the program ends before; ``span``: that of the program.
        """
        answer: Answer = None
        try:
            while True:
                try:
                    command = commands.send(answer)
                except StopIteration:
                    return
                if self.is_active:
                    answer = yield from self._take(command, span)
                else:
                    answer = yield command
        finally:
            commands.close()

    def _take(self, command: Command, span: Span) -> Generator[Command, Answer, Answer]:
        """Process a command before the start block; return its answer."""
        if isinstance(command, StartReached):
            self.is_active = False
            yield from self._begin_at(command)
            return None
        if isinstance(command, ProgramEnd):
            assert self._start is not None
            self._values.fail(START_BLOCK_NOT_REACHED, span, block=self._start.shown)
        if isinstance(command, PositionRequest):
            for axis in command.axes:
                self._oscillations.pop(axis, None)
            return tuple(self._values.state.positions)
        if self._block_cycles.keeps(command):
            return None
        is_gear = isinstance(command, SpindleLimits) and command.step != 0
        if not isinstance(command, _PASSING) or is_gear:
            yield from self._leave_out(command)
            return None
        if isinstance(command, SetTransformation):
            self._at = None
        if isinstance(command, Flush | ReadRealtime):
            yield from self._block_cycles.pass_block()
        return (yield command)

    def _leave_out(self, command: Command) -> Iterator[Command]:
        if isinstance(command, SpindleJob):
            self._jobs[command.spindle] = command
        elif isinstance(command, SpindleLimits) and self._awaits_shift:
            self._shifted[command.spindle] = command.step
        elif isinstance(command, Segment):
            self._at = command.target
        elif isinstance(command, MoveAlone):
            self._at = None
        elif isinstance(command, Oscillate):
            self._oscillations[command.axis] = command
            self._at = None
        elif isinstance(command, EndOscillation):
            self._oscillations.pop(command.axis, None)
        self._awaits_shift = isinstance(command, AwaitAcknowledge)
        if takes_time(command):
            self._pass_time(command)
            yield from self._block_cycles.pass_block()

    def _begin_at(self, reached: StartReached) -> Generator[Command, Answer]:
        """Yield commands that prepare the start block: gears, spindles, approach, cycles."""
        environment, span, number = self._values.environment, reached.span, reached.number
        yield from self._shift(reached.steps, span, number)
        yield from self._jobs.values()
        known = [name for name in environment.axis_numbers if name not in reached.uncertain]
        axes = map(environment.names.axis, known)
        numbers = tuple(axis.number for axis in axes if axis is not None)
        answer = yield PositionRequest(reached.source, number, numbers)
        assert isinstance(answer, tuple)
        target = list(self._at or reached.positions)
        if environment.offsets.transformation.is_straight:
            target = list(reached.positions)
        for name in reached.uncertain:
            slot = environment.axis_numbers[name]
            target[slot] = answer[slot]
        yield from self._approach(answer, target, span, number)
        yield from self._oscillations.values()
        yield from self._block_cycles.waiting

    def _approach(
        self, begin: Sequence[float], end: Sequence[float], span: Span, number: int
    ) -> Generator[Command, None]:
        """Yield the straight motion to the start of the block, at rapid traverse."""
        state, path = self._values.state, self._path
        kept = state.motion, getattr(path, "span", span)
        state.motion = RAPID
        segment = path.segment(list(begin), list(end), PathWords(), span, number)
        state.motion, path.span = kept
        if segment is not None:
            yield replace(segment, exact_stop=True, deviation=0.0)

    def _shift(self, steps: dict[int, int], span: Span, number: int) -> Generator[Command, None]:
        """Change to the gear steps that the spindles would have: the PLC has to shift, too."""
        for index, before in self._steps.items():
            gears = self._values.environment.spindle_gears[index]
            ahead, gears.active = gears.active, before
            if index in self._shifted:
                yield from self._gears.change(index, self._shifted[index], span, number)
            if steps[index] != gears.active:
                yield from self._gears.load(index, steps[index], span, number, turns=False)
            gears.active = ahead

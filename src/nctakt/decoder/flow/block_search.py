# SPDX-License-Identifier: MIT
"""Block search: a program begins at one of its blocks, with the state that it would have there.

In: the commands of the program from its start on. Up to the start block motions, dwells, functions,
messages and signals are left out; offsets, variables, realtime cycles and limits come into force.
There spindles get their gear step and their last job, and the axes move at rapid traverse, in a
straight line, to where the block begins. ``#BLOCKSEARCH LOCKED`` forbids a start in a part of a
program.
"""

from __future__ import annotations

from collections.abc import Callable, Generator

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.gear_changes import GearChanges
from nctakt.decoder.blocks.path_motion import PathMotion, PathWords
from nctakt.decoder.state.axis_commands import SetSoftwareLimits
from nctakt.decoder.state.commands import (
    Answer,
    AwaitAcknowledge,
    Command,
    CycleControl,
    DecoderWait,
    Dwell,
    Flush,
    Freeze,
    LoadCycle,
    PositionRequest,
    ProgramEnd,
    ReadRealtime,
    Segment,
    SetOffset,
    SetOrigin,
    SetTransformation,
    SetTurn,
    UserErrorReport,
    UserErrorStop,
    UserErrorValue,
    WriteText,
    WriteVariable,
)
from nctakt.decoder.state.limit_commands import SetLimits
from nctakt.decoder.state.spindle_commands import CuttingSpeed, SpindleJob, SpindleLimits
from nctakt.decoder.state.start_block import SingleStep, StartBlock
from nctakt.decoder.state.tool_life import ToolLifeFactors
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.messages.block_search import (
    START_BLOCK_LOCKED,
    START_BLOCK_NOT_REACHED,
    START_OF_SEARCH,
)
from nctakt.nc import tree
from nctakt.nc.vocabulary.functions import RAPID

#: Commands that come into force during the search.
_PASSING = (
    CuttingSpeed,
    CycleControl,
    DecoderWait,
    Flush,
    Freeze,
    ReadRealtime,
    SetLimits,
    SetOffset,
    SetOrigin,
    SetSoftwareLimits,
    SetTransformation,
    SetTurn,
    SingleStep,
    SpindleLimits,
    ToolLifeFactors,
    UserErrorReport,
    UserErrorStop,
    UserErrorValue,
    WriteText,
    WriteVariable,
)


class BlockSearch:
    """The search in one program; ``start``: ``None`` without one.

    ``pass_time`` is called with each motion and dwell that is left out.
    """

    def __init__(
        self,
        values: Values,
        path: PathMotion,
        start: StartBlock | None,
        pass_time: Callable[[Command], None],
        gears: GearChanges,
    ) -> None:
        self._values = values
        self._path = path
        self._start = start
        self._pass_time = pass_time
        self._file = ""
        self._is_locked = False
        self._gears = gears
        self._jobs: dict[int, SpindleJob] = {}
        self._steps: dict[int, int] = {}
        self._shifted: dict[int, int] = {}
        self._awaits_shift = False

    @property
    def is_active(self) -> bool:
        """Whether the start block has not been reached."""
        return self._values.state.is_searching

    def lock(self, command: tree.HashCommand) -> None:
        """Execute ``#BLOCKSEARCH LOCKED`` or ``#BLOCKSEARCH RELEASED``."""
        self._is_locked = command.words[1].name == "LOCKED"

    def begin(self, file: str) -> None:
        """Begin to search in a main program, if there is a start block."""
        self._file = file
        self._values.state.is_searching = self._start is not None
        gears = self._values.environment.spindle_gears
        self._steps = {index: one.active for index, one in gears.items()}

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
                if not self.is_active:
                    answer = yield command
                elif isinstance(command, ProgramEnd):
                    assert self._start is not None
                    self._values.fail(START_BLOCK_NOT_REACHED, span, block=self._start.shown)
                elif isinstance(command, PositionRequest):
                    answer = tuple(self._values.state.positions)
                elif _comes_into_force(command):
                    answer = yield command
                else:
                    self._leave_out(command)
                    answer = None
        finally:
            commands.close()

    def _leave_out(self, command: Command) -> None:
        if isinstance(command, SpindleJob):
            self._jobs[command.spindle] = command
        elif isinstance(command, SpindleLimits) and self._awaits_shift:
            self._shifted[command.spindle] = command.step
        elif isinstance(command, Segment | Dwell):
            self._pass_time(command)
        self._awaits_shift = isinstance(command, AwaitAcknowledge)

    def reach(self, statement: tree.Statement, number: int) -> Generator[Command, Answer]:
        """Begin the program here if this is the start block; raises ``DecodeError`` 21399."""
        start = self._start
        if start is None or not start.is_at(statement.span, self._file, number):
            return
        if self._is_locked:
            self._values.fail(START_BLOCK_LOCKED, statement.span)
        self._values.state.is_searching = False
        self._values.warn(START_OF_SEARCH, statement.span, block=start.shown)
        yield from self._shift(statement.span, number)
        yield from self._jobs.values()
        source = self._values.environment.source_id(statement.span)
        environment = self._values.environment
        axes = (environment.names.axis(name) for name in environment.axis_numbers)
        numbers = tuple(axis.number for axis in axes if axis is not None)
        answer = yield PositionRequest(source, number, numbers)
        assert isinstance(answer, tuple)
        state = self._values.state
        motion, state.motion = state.motion, RAPID
        segment = self._path.segment(
            list(answer), state.positions, PathWords(), statement.span, number
        )
        state.motion = motion
        if segment is not None:
            yield segment

    def _shift(self, span: Span, number: int) -> Generator[Command, None]:
        """Change to the gear steps that the spindles would have: the PLC has to shift, too."""
        for index, before in self._steps.items():
            gears = self._values.environment.spindle_gears[index]
            step, gears.active = gears.active, before
            if index in self._shifted:
                yield from self._gears.change(index, self._shifted[index], span, number)
            if step != gears.active:
                yield from self._gears.load(index, step, span, number, turns=False)


def _comes_into_force(command: Command) -> bool:
    """Return whether a command counts during the search: not one that changes a gear step."""
    if isinstance(command, LoadCycle):
        return command.scope != codes.BLOCK_SCOPE
    is_gear = isinstance(command, SpindleLimits) and command.step != 0
    return isinstance(command, _PASSING) and not is_gear

# SPDX-License-Identifier: MIT
"""Block search: a program begins at one of its blocks, with the state that it would have there.

In: the commands of the program from its start on. Up to the start block motions, dwells, functions,
messages and signals are left out; offsets, variables, realtime cycles and limits come into force.
There the spindles get their last job, and the axes move at rapid traverse, straight, to where the
block begins. ``#BLOCKSEARCH LOCKED`` forbids a start in a part of a program.
"""

from __future__ import annotations

from collections.abc import Callable, Generator

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.path_motion import PathMotion, PathWords
from nctakt.decoder.state.axis_commands import SetSoftwareLimits
from nctakt.decoder.state.commands import (
    Answer,
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
    ) -> None:
        self._values = values
        self._path = path
        self._start = start
        self._pass_time = pass_time
        self._file = ""
        self._is_locked = False
        self._jobs: dict[int, SpindleJob] = {}

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
                elif isinstance(command, _PASSING) or _is_lasting(command):
                    answer = yield command
                else:
                    self._leave_out(command)
                    answer = None
        finally:
            commands.close()

    def _leave_out(self, command: Command) -> None:
        if isinstance(command, SpindleJob):
            self._jobs[command.spindle] = command
        elif isinstance(command, Segment | Dwell):
            self._pass_time(command)

    def reach(self, statement: tree.Statement, number: int) -> Generator[Command, Answer]:
        """Begin the program here if this is the start block; raises ``DecodeError`` 21399."""
        start = self._start
        if start is None or not start.is_at(statement.span, self._file, number):
            return
        if self._is_locked:
            self._values.fail(START_BLOCK_LOCKED, statement.span)
        self._values.state.is_searching = False
        self._values.warn(START_OF_SEARCH, statement.span, block=start.shown)
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


def _is_lasting(command: Command) -> bool:
    """Return whether a command defines a cycle that outlives the next block."""
    return isinstance(command, LoadCycle) and command.scope != codes.BLOCK_SCOPE

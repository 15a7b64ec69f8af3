# SPDX-License-Identifier: MIT
"""Realtime loops: a body that is decoded once and repeated by the realtime part.

In: the commands of the statements of the body. Out: the same commands between the two ends of the
loop, after a check of all of them: a pass ends where it began and fits into the history of the
path.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable

from nctakt.decoder.blocks.block_decoder import BlockDecoder
from nctakt.decoder.flow.flow import Decoding
from nctakt.decoder.state.queued.commands import (
    Answer,
    AwaitSignal,
    BlockMark,
    Command,
    EmptyBlock,
    LoopBegin,
    LoopEnd,
    LoopPass,
    Segment,
    SendSignal,
    WriteVariable,
)
from nctakt.decoder.state.queued.in_force import ModalMark
from nctakt.decoder.state.queued.shape_commands import ShapeCommand
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.backward import (
    NOT_ALLOWED_IN_RT_WHILE,
    RT_WHILE_DURING_COMPENSATION,
    RT_WHILE_PATH_NOT_CLOSED,
    RT_WHILE_TOO_LONG,
    RT_WHILE_WITHOUT_HISTORY,
    RT_WHILE_WITHOUT_MOTION,
)
from nctakt.messages.path.splines import SPLINE_AT_LOOP
from nctakt.nc import tree

#: The commands that a body can have.
_OF_BODY = (
    Segment,
    ShapeCommand,
    WriteVariable,
    BlockMark,
    ModalMark,
    EmptyBlock,
    SendSignal,
    AwaitSignal,
)

#: Maximum distance between start and end of a pass due to rounding, mm or degrees.
CLOSE_ENOUGH = 1e-9


class RealtimeLoops:
    """Decodes loops; ``run`` decodes statements, ``shape`` shapes the motions of a body.

    ``is_decoding``: a body is decoded at this moment.
    """

    def __init__(
        self,
        values: Values,
        block_decoder: BlockDecoder,
        run: Callable[[Iterable[tree.Statement], str | None], Decoding],
        shape: Callable[[list[Command]], list[Command]],
    ) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._block_decoder = block_decoder
        self._run = run
        self._shape = shape
        self.is_decoding = False

    def loop(self, loop: tree.RealtimeLoop, number: int) -> Generator[Command, Answer]:
        """Yield the commands of a loop; decoding continues when the realtime part has left it."""
        size = self._environment.history_size
        if self._state.path.compensation.is_active:
            self._values.fail(RT_WHILE_DURING_COMPENSATION, loop.span)
        spline = self._state.shapes.spline
        if spline.is_on:
            self._values.fail(SPLINE_AT_LOOP, loop.span, command="#RT WHILE")
        if size == 0:
            self._values.fail(RT_WHILE_WITHOUT_HISTORY, loop.span)
        source = self._environment.source_id(loop.span)
        yield from self._block_decoder.moved.request(
            tuple(self._environment.axis_numbers), loop.span, number
        )
        yield from self._block_decoder.technology.before_feed()
        begin = tuple(self._state.positions)
        self.is_decoding = True
        body = self._body(loop)
        self.is_decoding = False
        if spline.is_on:
            self._values.fail(SPLINE_AT_LOOP, loop.span, command="#RT ENDWHILE")
        motions = sum(isinstance(command, Segment) for command in body)
        if motions == 0:
            self._values.fail(RT_WHILE_WITHOUT_MOTION, loop.span)
        if motions > size:
            self._values.fail(RT_WHILE_TOO_LONG, loop.span, count=motions, size=size)
        for axis, before, after in zip(
            self._environment.axis_numbers, begin, self._state.positions, strict=True
        ):
            if abs(after - before) > CLOSE_ENOUGH:
                off = abs(after - before)
                self._values.fail(RT_WHILE_PATH_NOT_CLOSED, loop.span, off=f"{off:.6g}", axis=axis)
        yield LoopBegin(source, number)
        yield from body
        yield LoopPass(source, number)
        yield LoopEnd(source, number)

    def _body(self, loop: tree.RealtimeLoop) -> list[Command]:
        """Return all commands of the body; raises ``DecodeError`` for one that would have to
        wait.
        """
        commands: list[Command] = []
        decoded = self._run(loop.body, None)
        while True:
            try:
                command = next(decoded)
            except StopIteration:
                return self._shape(commands)
            if not isinstance(command, _OF_BODY):
                self._values.fail(NOT_ALLOWED_IN_RT_WHILE, loop.span, command="#RT WHILE")
            commands.append(command)

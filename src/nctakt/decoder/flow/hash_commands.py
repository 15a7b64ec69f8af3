# SPDX-License-Identifier: MIT
"""``#`` commands of the main program without a module of their own.

In: checked nodes. Out: commands, or changes of the decoder's state.
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.decoder.blocks.cs_commands import CsCommands
from nctakt.decoder.blocks.transformation_commands import TransformationCommands
from nctakt.decoder.cycles.builder import TIMER_ACTIONS
from nctakt.decoder.state.commands import (
    Answer,
    ClearHistory,
    Command,
    Flush,
    PositionRequest,
    ProgramTimer,
)
from nctakt.decoder.values.variables import Values
from nctakt.messages.decoder import UNKNOWN_TIMER
from nctakt.messages.fixed_stops import POSITION_AT_FIXED_STOP
from nctakt.nc import tree
from nctakt.nc.check.transformations import COMMANDS
from nctakt.nc.vocabulary.system_variables import TIMERS


class HashCommands:
    """Decodes these commands for one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._systems = CsCommands(values)
        self._transformations = TransformationCommands(values)

    def command(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#DELETE``, ``#CS``, ``#TRAFO``, ``#FILENAME``, ``#CHANNEL INIT``, ``#BACKWARD
        STORAGE CLEAR``.

        Other commands have no effect.
        """
        words = tuple(word.name for word in command.words)
        if words == ("DELETE",):
            for argument in command.arguments:
                assert isinstance(argument, tree.Variable)
                self._values.program_values.delete(argument)
        elif words[0] == "CS":
            yield from self._systems.command(command, number)
        elif " ".join(words) in COMMANDS:
            yield from self._transformations.command(command, number)
        elif words in (("FILENAME",), ("FILE", "NAME")):
            yield from self._file(command, number)
        elif words == ("BACKWARD", "STORAGE", "CLEAR"):
            yield ClearHistory(self._environment.source_id(command.span), number)
        elif words == ("CHANNEL", "INIT"):
            source = self._environment.source_id(command.span)
            self._check_free(command)
            self._values.check_flush_allowed("#CHANNEL INIT", command.span)
            answer = yield PositionRequest(source, number)
            assert isinstance(answer, tuple)
            self._values.state.positions = list(answer)

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
        for item in bracket.items:
            assert isinstance(item, tree.Keyword)
            assert item.value is not None
            if isinstance(item.value, tree.Name):
                self._values.state.message_file = item.value.text
            else:
                text = yield from self._values.evaluate_any(item.value, number)
                assert isinstance(text, str)
                self._values.state.message_file = text

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

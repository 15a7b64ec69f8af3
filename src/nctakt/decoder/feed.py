# SPDX-License-Identifier: MIT
"""Decoder -> queue: keeps the channel's queue filled from a program's commands.

The queue is filled when the kernel says that it runs low or that an answer is ready, never because
Python happens to be there: so decode moments do not depend on how a run is cut into pieces.
"""

from __future__ import annotations

from collections.abc import Callable, Generator

from nctakt.decoder import commands
from nctakt.decoder.commands import Answer, Command
from nctakt.decoder.surroundings import DecodeError
from nctakt.diagnostics import Diagnostic
from nctakt.kernel.axis import Axes
from nctakt.kernel.channel import LOW_WATER, TIMED_KINDS, Channel

#: Commands that take time, up to which the queue is filled.
HIGH_WATER = 64


class Feed:
    """One program on its way into one channel.

    ``keep_text`` numbers the texts of messages, ``took_time`` tells the decoder that a command
    takes time, ``report`` takes what stops the program.
    """

    def __init__(
        self,
        channel: Channel,
        axes: Axes,
        members: list[int],
        program: int,
        decoded: Generator[Command, Answer],
        keep_text: Callable[[str], int],
        took_time: Callable[[], None],
        report: Callable[[Diagnostic], None],
        place: Callable[[Diagnostic], int],
    ) -> None:
        assert LOW_WATER < HIGH_WATER
        self._channel = channel
        self._axes = axes
        self._members = members
        self._program = program
        self._decoded = decoded
        self._keep_text = keep_text
        self._took_time = took_time
        self._report = report
        self._place = place
        self._waiting: Command | None = None
        self._pending: commands.LoadCycle | None = None
        self._is_done = False
        channel.decoder_open = True

    def refill(self) -> None:
        """Decode until enough commands that take time wait, or the decoder itself has to wait."""
        channel = self._channel
        channel.manager.free_dead()
        if self._pending is not None and not self._load(self._pending):
            return
        while channel.decoder_open and channel.timed_count < HIGH_WATER:
            self._next(None)

    def answer(self) -> None:
        """The realtime part has answered: the decoder goes on."""
        value = self._channel.take_answer()
        answer: Answer = value
        if isinstance(self._waiting, commands.PositionRequest):
            positions = self._axes.positions()
            answer = tuple(positions[i] for i in self._members)
        self._waiting = None
        self._channel.decoder_open = True
        self._next(answer)
        self.refill()

    def stop(self) -> None:
        """The program is given up: nothing more is decoded."""
        self._decoded.close()
        self._channel.decoder_open = False
        self._is_done = True

    def _next(self, answer: Answer) -> None:
        try:
            command = next(self._decoded) if answer is None else self._decoded.send(answer)
        except StopIteration:
            self._channel.decoder_open = False
            self._is_done = True
            return
        except DecodeError as error:
            self._report(error.diagnostic)
            self._put(commands.GiveUp(self._place(error.diagnostic), 0, error.diagnostic.id), 0)
            self._channel.decoder_open = False
            self._is_done = True
            return
        self._take(command)

    def _take(self, command: Command) -> None:
        if isinstance(command, commands.LoadCycle):
            self._load(command)
            return
        place = 0
        if isinstance(command, commands.UserMessage):
            place = self._keep_text(command.text)
        if isinstance(command, commands.ProgramEnd):
            place = self._program
        self._put(command, place)
        if commands.waits(command):
            self._waiting = command
            self._channel.decoder_open = False

    def _load(self, command: commands.LoadCycle) -> bool:
        """Fill a slot; where none is free the decoder waits until cycles have ended."""
        slot = self._channel.manager.load(
            command.cycle, command.identity, command.scope, command.source
        )
        if slot < 0 and self._channel.timed_count:
            self._pending = command
            self._channel.low_water = 1
            return False
        self._pending = None
        self._channel.low_water = LOW_WATER
        if slot < 0:
            self._put(commands.GiveUp(command.source, command.number, 50877), 0)
            self.stop()
        else:
            self._put(command, slot)
        return True

    def _put(self, command: Command, place: int) -> None:
        row = commands.pack(command, place)
        self._channel.put(row)
        if row[0] in TIMED_KINDS:
            self._took_time()

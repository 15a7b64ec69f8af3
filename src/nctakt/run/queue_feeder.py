# SPDX-License-Identifier: MIT
"""Decoder -> queue: keeps the channel's queue filled from a program's commands.

The queue is filled when the kernel says that it runs low or that an answer is ready, never because
Python happens to be there: so decode moments do not depend on how a run is cut into pieces.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import partial

from nctakt.base.diagnostics import Diagnostic
from nctakt.decoder.fast.handover import PlainRun
from nctakt.decoder.program import ProgramDecoder
from nctakt.decoder.state import commands
from nctakt.decoder.state.commands import Answer, Command
from nctakt.decoder.state.environment import DecodeError
from nctakt.decoder.state.modal_state import state_at_program_start
from nctakt.decoder.state.program_variables import Scopes
from nctakt.kernel import rows
from nctakt.messages.realtime import TOO_MANY_CYCLES
from nctakt.run.assembly import AssembledMachine
from nctakt.run.decode_budget import DecodeBudget
from nctakt.run.program_loader import LoadedProgram

#: Commands that take time, up to which the queue is filled above the look-ahead.
HIGH_WATER = 64


class QueueFeeder:
    """One program on its way into its channel; ``report`` takes what stops it.

    Blocks of ``skip_levels`` are left out; ``marks_blocks``: events tell of each block when it was
    decoded and when it is carried out, and why the channel is emptied.
    """

    def __init__(
        self,
        machine: AssembledMachine,
        program: LoadedProgram,
        report: Callable[[Diagnostic], None],
        skip_levels: frozenset[int] = frozenset(),
        marks_blocks: bool = False,
        budget: DecodeBudget | None = None,
    ) -> None:
        self._machine = machine
        self._index = program.channel
        self._channel = machine.channels[program.channel]
        self._report = report
        self._number = machine.registry.add_program(program.text.source.file)
        self._environment = machine.environment(
            program.subprogram, report, skip_levels, program.channel, marks_blocks
        )
        self._environment.offsets.adopt(machine.axes.offsets)
        start = program.parameters.program_start
        state = state_at_program_start(start, machine.positions(program.channel))
        state.call_stack.scopes = Scopes(machine.controller_data[program.channel].kept)
        registry = machine.registry
        self._decoder = ProgramDecoder(
            self._environment,
            state,
            registry.next_cycle,
            partial(registry.keep, channel=machine.number_in_names(program.channel)),
            takes_runs=budget is None,
        )
        self._decoded: Generator[Command, Answer] = self._decoder.decode(program.text)
        self.given_up: Diagnostic | None = None
        self._waiting: Command | None = None
        self._pending: commands.LoadCycle | None = None
        self._held: Command | None = None
        self._answer: tuple[Answer, ...] = ()
        self._budget = budget
        if budget is not None:
            budget.forgive()
        self._high_water = self._channel.ahead.blocks + HIGH_WATER
        self._channel.taken_source = 0
        self._channel.decoder_open = True
        self._channel.wants_slot = False

    def refill(self) -> None:
        """Decode until enough commands that take time wait, or the decoder itself has to wait."""
        self._free_slots()
        if self._pending is not None and not self._load(self._pending):
            return
        if self._held is not None and not self._take_held():
            return
        while self.wants_to_decode and (self._budget is None or self._budget.can_begin):
            self._next()
            if self._pending is not None or self._held is not None:
                return

    @property
    def wants_to_decode(self) -> bool:
        """Whether the decoder does not wait, and the queue is not full."""
        channel = self._channel
        return bool(channel.decoder_open and channel.timed_count < self._high_water)

    def _take_held(self) -> bool:
        """Put what was decoded ahead of its time into the queue, if it is paid by now."""
        assert self._held is not None
        assert self._budget is not None
        if not self._budget.is_paid:
            return False
        command, self._held = self._held, None
        self._take(command)
        return self._pending is None

    def answer(self) -> None:
        """The realtime part has answered: the decoder goes on."""
        self._answer = (self._channel.take_answer(),)
        self._channel.decoder_open = True
        if self._budget is None:
            self.refill()

    def _take_answer(self) -> Answer:
        """What the decoder gets where it goes on: nothing but behind a command that waits."""
        if not self._answer:
            return None
        (answer,), self._answer = self._answer, ()
        if isinstance(self._waiting, commands.PositionRequest):
            answer = tuple(self._machine.positions(self._index))
        self._waiting = None
        return answer

    def _free_slots(self) -> None:
        """Make the slots of ended cycles free for those that are decoded next."""
        self._machine.registry.forget(self._channel.manager.free_dead())

    def stop(self) -> None:
        """The program is given up: nothing more is decoded."""
        self._decoded.close()
        self._channel.decoder_open = False

    def _next(self) -> None:
        answer = self._take_answer()
        begun = self._decoder.started_blocks
        try:
            command = next(self._decoded) if answer is None else self._decoded.send(answer)
        except StopIteration:
            self._channel.decoder_open = False
            return
        except DecodeError as error:
            self._give_up(error.diagnostic)
            return
        if self._budget is not None:
            self._budget.spend(self._decoder.started_blocks - begun)
            if not self._budget.is_paid:
                self._held = command
                return
        self._take(command)

    def _give_up(self, found: Diagnostic) -> None:
        """A mistake that only values show: the channel stops behind what was prepared."""
        self.given_up = found
        self._report(found)
        source = 0 if found.span is None else self._environment.source_id(found.span)
        self._put(commands.GiveUp(source, 0, found.id), 0)
        self._channel.decoder_open = False

    def _take(self, command: Command) -> None:
        if isinstance(command, PlainRun):
            command.blocks.fill(self._channel, self._high_water)
            return
        if isinstance(command, commands.LoadCycle):
            self._load(command)
            return
        if self._environment.marks_blocks:
            mark = commands.wait_mark(command)
            if mark is not None:
                self._put(mark, 0)
        place = 0
        if isinstance(command, commands.BlockMark):
            place = self._machine.kernel.tick
        if isinstance(command, commands.UserMessage):
            place = self._machine.registry.add_message(command)
        if isinstance(command, commands.Freeze):
            place = self._machine.registry.add_variable(command.name)
        if isinstance(command, commands.ProgramEnd):
            place = self._number
        self._put(command, place)
        if commands.waits(command):
            self._waiting = command
            self._channel.decoder_open = False

    def _load(self, command: commands.LoadCycle) -> bool:
        """Fill a slot; where none is free the decoder waits until cycles have ended."""
        slot = self._channel.manager.load(
            command.cycle, command.identity, command.scope, command.source, command.moves_on
        )
        if slot < 0 and self._channel.can_free_slots():
            self._pending = command
            self._channel.wants_slot = True
            return False
        self._pending = None
        self._channel.wants_slot = False
        if slot < 0:
            self._put(commands.GiveUp(command.source, command.number, TOO_MANY_CYCLES.id), 0)
            self.stop()
        else:
            self._put(command, slot)
        return True

    def _put(self, command: Command, place: int) -> None:
        if isinstance(command, commands.Segment):
            self._channel.put_segment(
                command.source,
                command.number,
                command.start,
                command.target,
                command.motion,
                command.feed,
                command.exact_stop,
                command.deviation,
                command.limits_jerk,
                command.arc,
                None if command.modifiers is None else command.modifiers.row,
            )
            if command.goes_on:
                self._channel.block_goes_on()
            self._decoder.pass_time(command)
            return
        row = commands.pack(command, place)
        if isinstance(command, commands.LoopBegin):
            self._channel.begin_loop(row)
        elif isinstance(command, commands.LoopEnd):
            self._channel.end_loop(row)
        else:
            self._channel.put(row)
        if row[rows.KIND] in rows.TIMED_KINDS:
            self._decoder.pass_time(command)

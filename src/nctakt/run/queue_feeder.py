# SPDX-License-Identifier: MIT
"""Decoder -> queue: fills a channel's command queue from a program.

The queue is filled when the kernel reports that it runs low or that an answer is ready, and at no
other moment: so the moments of decoding do not depend on how a run is divided into steps.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import partial

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.long_text import TextChanged
from nctakt.decoder.axis_limits import apply_limits
from nctakt.decoder.fast.handover import PlainRun
from nctakt.decoder.program import ProgramDecoder
from nctakt.decoder.state.axis_places import ExchangeAxes
from nctakt.decoder.state.environment import DecodeError
from nctakt.decoder.state.modal_state import state_at_program_start
from nctakt.decoder.state.program_variables import Scopes
from nctakt.decoder.state.queued import commands
from nctakt.decoder.state.queued.commands import PAUSE, Answer, Command
from nctakt.decoder.state.queued.limit_commands import SetLimits
from nctakt.decoder.state.queued.packing import pack, takes_time
from nctakt.decoder.state.queued.probe_commands import MeasurementRequest
from nctakt.decoder.state.queued.start_block import StartBlock
from nctakt.kernel.tick.channel import LOW_WATER
from nctakt.messages import diagnostic
from nctakt.messages.files import TEXT_CHANGED
from nctakt.messages.programs.realtime import TOO_MANY_CYCLES
from nctakt.nc import tree
from nctakt.run.decode_budget import DecodeBudget
from nctakt.run.program_loader import LoadedProgram
from nctakt.run.realtime.assembly import AssembledMachine

#: Number of commands with a duration in the queue beyond those of the look-ahead.
HIGH_WATER = 64


class QueueFeeder:
    """Feeds one program into its channel; ``report`` receives errors that stop it.

    Blocks of ``skip_levels`` are left out; ``marks_blocks``: there are events when each block is
    decoded and executed, and for why the channel is flushed. ``start``: the block where the program
    begins by block search. ``fatal_error``: the decoder's error that has stopped the program.
    ``state``: the modal state of the decoder. ``condition``: the ``#WAIT FOR`` that it evaluates
    tick by tick, 0: none; ``awaits_tools``: instead of one, the answer of the tool manager.
    """

    def __init__(
        self,
        machine: AssembledMachine,
        program: LoadedProgram,
        report: Callable[[Diagnostic], None],
        skip_levels: frozenset[int] = frozenset(),
        marks_blocks: bool = False,
        budget: DecodeBudget | None = None,
        start: StartBlock | None = None,
    ) -> None:
        self._machine = machine
        self._program = program
        self._index = program.channel
        self._channel = machine.channels[program.channel]
        self._report = report
        self._number = machine.registry.add_program(program.text.source.file)
        machine.begin_program(program.channel)
        self.environment = machine.environment(
            program.subprogram,
            report,
            skip_levels,
            program.channel,
            marks_blocks,
            program.names_of_fetched_axes,
        )
        self.environment.offsets.adopt(machine.axes.offsets)
        initial = program.parameters.program_start
        state = state_at_program_start(initial, machine.positions(program.channel))
        state.call_stack.scopes = Scopes(machine.controller_data[program.channel].kept)
        registry = machine.registry
        self._decoder = ProgramDecoder(
            self.environment,
            state,
            registry.next_cycle,
            partial(registry.keep, channel=machine.number_in_names(program.channel)),
            takes_runs=budget is None,
            start=start,
        )
        listed = machine.realtime.listed_limits[program.channel]
        apply_limits(self._channel.queue.look_ahead.limits, listed)
        members = machine.members_of(program.channel)
        self._decoded: Generator[Command, Answer] = self._decoder.decode(program.text, members)
        self.state = state
        self.fatal_error: Diagnostic | None = None
        self._waiting: Command | None = None
        self.condition = 0
        self.awaits_tools = False
        self._unloaded: commands.LoadCycle | None = None
        self._unpaid: Command | None = None
        self._since = 0
        self._answer: tuple[Answer, ...] = ()
        self._budget = budget
        self._is_paused = False
        if budget is not None:
            budget.forgive()
        blocks = self._channel.queue.look_ahead.blocks
        self.high_water = max(blocks + HIGH_WATER, self._channel.feed.low_water + LOW_WATER)
        self._channel.executor.taken_source = 0
        self._channel.feed.decoder_open = True
        self._channel.feed.wants_slot = False

    def refill(self) -> None:
        """Decode until the queue is full enough, the granted time is used or the decoder waits."""
        self._free_slots()
        if self._unloaded is not None and not self._load(self._unloaded):
            return
        if self._unpaid is not None and not self._queue_paid_command():
            return
        while self.can_decode and (self._budget is None or self._budget.can_begin):
            try:
                self._next()
            except TextChanged as error:
                self._give_up(diagnostic(TEXT_CHANGED, file=str(error.path)))
            if self._unloaded is not None or self._unpaid is not None:
                return

    def pause(self, pauses_before: Callable[[tree.Statement], bool]) -> bool:
        """Decode as ``refill``, up to a pause before a statement; return whether there was one.

        ``pauses_before``: called with the statements of the main program before which decoding can
        pause.
        """
        self._decoder.pauses_before = pauses_before
        while self.can_decode and not self._is_paused and self._unloaded is None:
            self._next()
        self._decoder.pauses_before = None
        is_paused, self._is_paused = self._is_paused, False
        return is_paused

    def drop(self) -> None:
        """Leave decoding where it is."""
        self._decoded.close()

    def resume(self, statement: tree.Statement) -> None:
        """Fill the queue on from a pause before a statement, in which this feeder is again."""
        self._decoded = self._decoder.resume(self._program.text, statement)
        self.refill()

    @property
    def can_decode(self) -> bool:
        """Whether the decoder does not wait and the queue is below its mark."""
        channel = self._channel
        return bool(channel.feed.decoder_open and channel.queue.timed_count < self.high_water)

    def _queue_paid_command(self) -> bool:
        """Queue the held command once its decode time has been granted; return whether it was."""
        assert self._unpaid is not None
        assert self._budget is not None
        if not self._budget.is_paid:
            return False
        command, self._unpaid = self._unpaid, None
        self._take(command)
        return self._unloaded is None

    def answer(self) -> None:
        """Take the answer of the realtime part, with which the decoder continues."""
        waiting = self._waiting
        if isinstance(waiting, commands.DecoderSignal):
            self._answer = (self._channel.signals.accept(self._machine.kernel.tick),)
        elif isinstance(waiting, ExchangeAxes):
            self._answer = (self._machine.exchange(self._index, waiting),)
        else:
            self._answer = (self._channel.take_answer(),)
        if isinstance(waiting, commands.DecoderWait) and self._machine.kernel.tick > self._since:
            self._decoder.pass_time(waiting)
        self._channel.feed.decoder_open = True
        if self._budget is None:
            self.refill()

    def _take_answer(self) -> Answer:
        """Return the answer to the command that waited; ``None`` if there was none."""
        if not self._answer:
            return None
        (answer,), self._answer = self._answer, ()
        if isinstance(self._waiting, commands.PositionRequest):
            positions = self._machine.present_positions(self._index)
            of_axes = self.environment.offsets.transformation.of_axes
            answer = tuple(of_axes(positions))
            if isinstance(self._waiting, MeasurementRequest):
                probe = self._channel.executor.measuring.touch_probe
                values = list(probe.values)[: len(positions)]
                answer = (float(probe.has_touched), *answer, *values, *of_axes(values))
        self._waiting = None
        return answer

    def _free_slots(self) -> None:
        """Free the slots of ended cycles."""
        self._machine.registry.forget(self._channel.manager.free_ended())

    def stop(self) -> None:
        """Stop decoding the program."""
        self._decoded.close()
        self._channel.signals.give_up()
        self._channel.exchange.give_up()
        self._channel.feed.decoder_open = False

    def _next(self) -> None:
        answer = self._take_answer()
        first_block = self._decoder.started_blocks
        try:
            command = next(self._decoded) if answer is None else self._decoded.send(answer)
        except StopIteration:
            self._channel.feed.decoder_open = False
            return
        except DecodeError as error:
            self._give_up(error.diagnostic)
            return
        if self.condition and not isinstance(command, commands.NextTick | commands.ReadRealtime):
            self.condition = 0
        if self._budget is not None:
            self._budget.spend(self._decoder.started_blocks - first_block)
            if not self._budget.is_paid:
                self._unpaid = command
                return
        self._take(command)

    def _give_up(self, error: Diagnostic) -> None:
        """Report an error of decoding; the channel stops after the commands that are queued."""
        self.fatal_error = error
        self._report(error)
        source = 0 if error.span is None else self.environment.source_id(error.span)
        self._put(commands.GiveUp(source, 0, error.id), 0)
        self._channel.feed.decoder_open = False

    def _take(self, command: Command) -> None:
        if command is PAUSE:
            self._is_paused = True
            return
        if isinstance(command, PlainRun):
            tick = self._machine.kernel.tick
            command.blocks.fill(self._channel.queue, self.high_water, tick)
            return
        if isinstance(command, commands.LoadCycle):
            self._load(command)
            return
        if isinstance(command, commands.DecoderWait):
            self._await(command)
            return
        if self.environment.marks_blocks:
            mark = commands.wait_mark(command)
            if mark is not None:
                self._put(mark, 0)
        subject = 0
        if isinstance(command, commands.BlockMark):
            subject = self._machine.kernel.tick
        if isinstance(command, commands.UserMessage):
            subject = self._machine.registry.add_message(command)
        if isinstance(command, commands.Freeze):
            subject = self._machine.registry.add_variable(command.name)
        if isinstance(command, commands.ProgramEnd):
            subject = self._number
        self._put(command, subject)
        if commands.waits(command):
            self._waiting = command
            self._channel.feed.decoder_open = False

    def _await(self, command: commands.DecoderWait) -> None:
        """Let the decoder wait for a signal, axes, or the next tick; the queue continues."""
        self._since = self._machine.kernel.tick
        if isinstance(command, commands.DecoderSignal):
            self._channel.signals.await_signal(
                command.source, self._since, command.signal, command.senders, command.overtakes
            )
        elif isinstance(command, ExchangeAxes):
            self._channel.exchange.await_axes(command.source, self._since, command.awaited)
        else:
            self._channel.signals.await_tick(command.source)
            self.condition = command.source
            self.awaits_tools = isinstance(command, commands.AwaitTools)
        self._waiting = command
        self._channel.feed.decoder_open = False

    def _load(self, command: commands.LoadCycle) -> bool:
        """Load a cycle into a slot; return False if the decoder has to wait for a free one."""
        slot = self._channel.manager.load(
            command.cycle, command.identity, command.scope, command.source, command.moves_on
        )
        if slot < 0 and self._channel.can_free_slots():
            self._unloaded = command
            self._channel.feed.wants_slot = True
            return False
        self._unloaded = None
        self._channel.feed.wants_slot = False
        if slot < 0:
            self._put(commands.GiveUp(command.source, command.number, TOO_MANY_CYCLES.id), 0)
            self.stop()
        else:
            self._put(command, slot)
        return True

    def _put(self, command: Command, subject: int) -> None:
        """Queue a command; ``subject``: its tick, slot or number in the registry."""
        if isinstance(command, commands.Segment):
            self._channel.queue.put_segment(
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
                command.curve,
            )
            if command.continues_block:
                self._channel.queue.continue_block()
            self._decoder.pass_time(command)
            return
        if isinstance(command, SetLimits):
            apply_limits(self._channel.queue.look_ahead.limits, command)
            return
        row = pack(command, subject)
        if isinstance(command, commands.LoopBegin):
            self._channel.queue.begin_loop(row)
        elif isinstance(command, commands.LoopEnd):
            self._channel.queue.end_loop(row)
        else:
            self._channel.put(row)
        if takes_time(command):
            self._decoder.pass_time(command)

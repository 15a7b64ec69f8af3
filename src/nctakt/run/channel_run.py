# SPDX-License-Identifier: MIT
"""The programs of one channel, run in turn.

In: checked programs, the kernel's requests. Out: commands in the channel's queue
(``run/queue_feeder.py``) and the state in which the programs ended. The kernel runs all channels in
lockstep; each is served on its own, in the tick in which it asks, so that channels do not depend on
each other's programs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.decoder.state.queued.start_block import StartBlock
from nctakt.kernel import codes
from nctakt.messages import diagnostic
from nctakt.messages.plcs.hli_table import NUMBER_NOT_TAKEN
from nctakt.messages.programs.user_errors import STOPPED_BY_FATAL_USER_ERROR
from nctakt.results.run import RunState
from nctakt.results.trace.events import Event
from nctakt.run.decode_budget import DecodeBudget
from nctakt.run.program_loader import LoadedProgram
from nctakt.run.queue_feeder import QueueFeeder
from nctakt.run.realtime.assembly import AssembledMachine

#: The kinds of block search that the interface can order (``HLI.SEARCH_TYPE``).
NO_SEARCH, SEARCH_TO_BLOCK = 0, 4


class ChannelRun:
    """The programs of a channel; ``index`` counts from 0, ``report`` takes fatal errors.

    Blocks of ``skip_levels`` are left out; ``marks_blocks``: each block has events. ``start``:
    the block where the next program begins by block search. ``result``:
    the state in which the queued programs ended, ``None`` until then. ``budget``: the time that a
    schedule grants the decoder, if there is a schedule.
    """

    def __init__(
        self, machine: AssembledMachine, index: int, report: Callable[[Diagnostic], None]
    ) -> None:
        self._machine = machine
        self._index = index
        self._report = report
        self._programs: list[LoadedProgram] = []
        self._waits_for_start = False
        self._selected: LoadedProgram | None = None
        self._outcome: RunState | None = None
        self._stopped_at = -1
        self.channel = machine.channels[index]
        self.feeder: QueueFeeder | None = None
        self.skip_levels: frozenset[int] = frozenset()
        self.marks_blocks = False
        self.start: StartBlock | None = None
        self.budget: DecodeBudget | None = None
        self.result: RunState | None = "ended"

    @property
    def is_running(self) -> bool:
        """Whether a program runs."""
        return self.feeder is not None

    @property
    def is_stopped(self) -> bool:
        """Whether the channel is in error state."""
        return bool(self.channel.executor.is_stopped)

    @property
    def is_braking(self) -> bool:
        """Whether an error or a reset has ended the programs and still has effects.

        The path brakes or the reset lasts. After an error there is at least one tick, in which the
        remaining realtime cycles can react to it (RC-402, RC-505).
        """
        if self.is_stopped and not self._waits_for_start:
            return self._stopped_at == self._machine.kernel.tick or not self._is_at_rest()
        return self._outcome == "reset" and not self._is_at_rest()

    def _is_at_rest(self) -> bool:
        return (
            self._machine.has_path_stopped(self._index) and not self.channel.executor.is_resetting
        )

    # --- programs in sequence -------------------------------------------------------------------

    def queue(self, programs: Sequence[LoadedProgram], *, waits_for_start: bool) -> None:
        """Run these programs in turn, each after START on the HLI if it waits for it."""
        self._programs = list(programs)
        self._waits_for_start = waits_for_start
        self._selected = None
        self._outcome = None
        self.result = None

    def proceed(self) -> None:
        """Begin the next program if it is due, or set the result if none is left."""
        if self.result is not None or self.is_braking:
            return
        if self.is_stopped and not self._waits_for_start:
            self.result = "error"
        elif self._outcome == "reset" and self._waits_for_start:
            assert self._selected is not None
            self.select(self._selected)
        elif self._outcome == "reset":
            self.result = "reset"
        elif self._outcome == "ended" or self._selected is None:
            self._begin_next()

    def _begin_next(self) -> None:
        if not self._programs:
            self.result = "ended"
            return
        program = self._programs.pop(0)
        if self._waits_for_start:
            self.select(program)
        else:
            self.begin(program)

    def select(self, program: LoadedProgram) -> None:
        """Make a program wait for START."""
        self._outcome = None
        self._selected = program
        self.channel.panel.arm(True)

    def begin(self, program: LoadedProgram) -> None:
        """Start a checked program; raises ``Failure`` after a fatal error."""
        if self.channel.executor.is_fatal:
            raise Failure(diagnostic(STOPPED_BY_FATAL_USER_ERROR))
        self._outcome = None
        self._stopped_at = -1
        self._selected = program
        self.feeder = QueueFeeder(
            self._machine,
            program,
            self._report,
            self.skip_levels,
            self.marks_blocks,
            self.budget,
            self.start or self._searched_block(),
        )
        self.start = None
        self.channel.panel.begin_program()

    def _searched_block(self) -> StartBlock | None:
        """Return the block to which the interface orders block search; ``None`` without an order.

        An invalid value that another process has put into the memory is reported and ignored.
        """
        kind, number, passes = (
            int(self._machine.read(f"{self._machine.assembled[self._index].prefix}HLI.{name}"))
            for name in ("SEARCH_TYPE", "SEARCH_BLOCK", "SEARCH_PASS")
        )
        if kind == SEARCH_TO_BLOCK:
            return StartBlock(number=number, passes=max(passes, 1))
        if kind != NO_SEARCH:
            known = f"{NO_SEARCH}, {SEARCH_TO_BLOCK}"
            name = "HLI.SEARCH_TYPE"
            self._report(diagnostic(NUMBER_NOT_TAKEN, path=name, value=kind, known=known))
        return None

    def close(self) -> None:
        """End the sequence of programs: none waits for START any more."""
        self.result = self.result or "limit"
        self.channel.panel.arm(False)

    # --- under a schedule -----------------------------------------------------------------------

    @property
    def can_decode(self) -> bool:
        """Whether the decoder of the channel has work."""
        return self.feeder is not None and self.feeder.can_decode

    def decode(self) -> None:
        """Decode as long as the granted time lasts."""
        if self.feeder is not None and self.channel.feed.decoder_open:
            self.feeder.refill()

    # --- requests of the kernel -----------------------------------------------------------------

    def serve(self) -> None:
        """Do what is due before the next tick: feed the queue, end or begin a program."""
        reason = self.channel.due()
        if reason == codes.ERROR:
            if self._stopped_at < 0:
                self._stopped_at = self._machine.kernel.tick
            self.channel.clear_error()
            self.channel.panel.end_program()
            self._stop()
        elif reason == codes.PROGRAM_END:
            self.channel.accept_end()
            self.channel.panel.end_program()
            self.feeder = None
            self._outcome = "ended"
        elif reason == codes.START:
            assert self._selected is not None
            self.begin(self._selected)
        elif reason == codes.RESET:
            self._give_up()
            self.channel.panel.accept_reset()
            self._outcome = "reset"
        elif reason == codes.ANSWER:
            assert self.feeder is not None
            self.feeder.answer()
        elif reason == codes.REFILL:
            assert self.feeder is not None
            self.feeder.refill()

    def request_reset(self) -> None:
        """Give the program up and reset the channel (RC-007)."""
        self._give_up()
        self._outcome = "reset"
        self.channel.request_reset()

    def _give_up(self) -> None:
        """Stop decoding the program and drop cycles that it has loaded but not defined."""
        self._stop()
        self.channel.panel.end_program()
        self.channel.manager.drop_undefined()

    def _stop(self) -> None:
        if self.feeder is not None:
            self.feeder.stop()
            self.feeder = None


def worst_state(channels: Sequence[ChannelRun], otherwise: RunState) -> RunState:
    """Return the state of a run of several channels: an error comes before a reset."""
    if any(channel.is_stopped for channel in channels):
        return "error"
    return "reset" if any(channel.result == "reset" for channel in channels) else otherwise


def is_reported(channels: Sequence[ChannelRun], event: Event) -> bool:
    """Return whether an error event is the decoder's, which has been reported when it gave up."""
    feeder = channels[max(event.channel - 1, 0)].feeder
    error = None if feeder is None else feeder.fatal_error
    return error is not None and not event.cycle and event.text == str(error.id)

# SPDX-License-Identifier: MIT
"""A run under a schedule on a real clock, repeated: a tape has the decisions of the clock.

In: the inputs of a tape: how many commands the decoders had given by a tick, which threads were
still busy when they were due, which ticks were lost. Out: the shares of the threads in each tick,
the same as in the recorded run.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.diagnostics import Diagnostic
from nctakt.run.access.inputs import DECODED, LOST, OVERFLOWED, SCHEDULE, Input
from nctakt.run.channel_run import ChannelRun
from nctakt.run.decode_budget import StepBudget
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.schedule.simulation.ticks import Share

#: The share of a tick that takes place.
_RUNS = Share((), False, (), 1)
_IS_LOST = Share((), True, (), 1)


def is_recorded(inputs: Sequence[Input]) -> bool:
    """Return whether the inputs of a tape are those of a schedule on a real clock."""
    return any(one.source == SCHEDULE for one in inputs)


class RecordedSchedule:
    """The shares of a recorded run; its machine follows the schedule already."""

    def __init__(self, machine: AssembledMachine, schedule: RunSchedule) -> None:
        self.schedule = schedule
        self._machine = machine
        self._budgets = [StepBudget() for _ in machine.channels]
        self._due: list[tuple[str, tuple[int, ...]]] = []
        self._tick = -1
        self._share = _RUNS
        machine.inputs.on_schedule = self._take

    def _take(self, kind: str, values: tuple[int, ...]) -> None:
        self._due.append((kind, values))

    def budget(self, channel: int) -> StepBudget:
        """Return the decoder's budget of a channel; channels count from 0."""
        return self._budgets[channel]

    def prepare(self, runs: Sequence[ChannelRun], *, has_plc: bool) -> Share:
        """Repeat the threads' actions before the next tick."""
        if self._tick == self._machine.kernel.tick:
            return self._share
        self._tick = self._machine.kernel.tick
        self._share = _RUNS
        due, self._due = self._due, []
        for kind, values in due:
            if kind == DECODED:
                channel, steps = values
                decode(runs[channel], self._budgets[channel], steps)
            elif kind == OVERFLOWED:
                self._machine.kernel.note_overflow(values[0])
            elif kind == LOST:
                self._share = _IS_LOST
        settle(runs, self._budgets, has_plc=has_plc)
        return self._share

    def end_tick(self) -> None:
        """Do nothing: no clock measures the tick."""

    def findings(self) -> list[Diagnostic]:
        """Return nothing: the recorded run has reported the problems."""
        return []


def decode(run: ChannelRun, budget: StepBudget, steps: int) -> int:
    """Let a decoder give at most ``steps`` commands; return how many it gave.

    The end of its program counts as one.
    """
    if not run.can_decode:
        return 0
    budget.grant(steps)
    run.decode()
    ended = 0 if run.channel.feed.decoder_open else min(1, budget.steps)
    given = steps - budget.steps + ended
    budget.grant(0)
    return given


def settle(runs: Sequence[ChannelRun], budgets: Sequence[StepBudget], *, has_plc: bool) -> None:
    """Do the work that does not depend on a clock: load cycles that waited for a slot."""
    for run, budget in zip(runs, budgets, strict=True):
        budget.grant(0)
        run.decode()
        run.channel.hli.acknowledges_itself = not has_plc

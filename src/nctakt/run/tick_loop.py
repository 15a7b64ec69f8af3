# SPDX-License-Identifier: MIT
"""The loop between decoder, kernel and PLC: ticks run until one of the others is due.

In: an assembled machine with its channels, the planned inputs, a scripted PLC, a schedule. Out: the
ticks, with their records passed to the listeners. Where the loop is interrupted never changes the
ticks.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Protocol

from nctakt.base.diagnostics import Diagnostic
from nctakt.kernel import codes
from nctakt.run.access.inputs import NEVER, PLC
from nctakt.run.channel_run import ChannelRun, is_reported
from nctakt.run.plcs.coupling import Coupled
from nctakt.run.plcs.plc_player import PlcPlayer, PlcWithBlocks
from nctakt.run.plcs.plc_view import AnyPlc, PlcView
from nctakt.run.plcs.realtime_plc import NamedGroup, RealtimePlc, parts_of, side_of
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.recording import Recording

if TYPE_CHECKING:
    from nctakt.run.decode_budget import DecodeBudget
    from nctakt.schedule.open_schedule import RunSchedule
    from nctakt.schedule.simulation.ticks import Share

#: Ticks of the compiled part without a pause, in which Python acts on Ctrl-C.
TICKS_AT_ONCE = 100_000


class TickShares(Protocol):
    """The time that a schedule gives decoder, interpolation and PLC, tick by tick."""

    schedule: RunSchedule

    def budget(self, channel: int) -> DecodeBudget:
        """Return the decode time of a channel; channels count from 0."""

    def prepare(self, runs: Sequence[ChannelRun], *, has_plc: bool) -> Share:
        """Let the decoders work before the next tick; return the shares of the threads in it."""

    def end_tick(self) -> None:
        """Note that a tick is done, with the PLC's call after it."""

    def findings(self) -> list[Diagnostic]:
        """Return the findings about the schedule so far, each once."""


class TickLoop:
    """The ticks of one machine.

    ``plc``: a scripted PLC; ``has_plc``: something acknowledges technology functions, be it that
    script or a tape of one. ``scheduled_run``: the limited times of decoder, interpolation and PLC
    under a schedule. ``ends_deadlock``: ``advance`` returns with ``is_deadlocked`` when all
    programs wait for each other's signals, and nothing outside can free them.
    """

    def __init__(
        self,
        machine: AssembledMachine,
        report: Callable[[Diagnostic], None],
        scheduled_run: TickShares | None,
    ) -> None:
        self.machine = machine
        self.channels = [
            ChannelRun(machine, index, report) for index in range(len(machine.channels))
        ]
        self.recording = Recording(machine, report, functools.partial(is_reported, self.channels))
        self.scheduled_run: TickShares | None = None
        if scheduled_run is not None:
            self.follow(scheduled_run)
        self.plc: AnyPlc | None = None
        self._player: PlcPlayer | None = None
        self._realtime_plcs: list[RealtimePlc] = []
        self._report = report
        self.has_plc = False
        self.ends_deadlock = False
        self.is_deadlocked = False
        self._kernel = machine.kernel
        self._coupled: Coupled | None = None

    @property
    def tick(self) -> int:
        """The number of ticks since start-up."""
        return self._kernel.tick

    def follow(self, shares: TickShares) -> None:
        """Let a schedule give decoder, interpolation and PLC their time, before any program."""
        self.scheduled_run = shares
        for index, channel in enumerate(self.channels):
            channel.budget = shares.budget(index)

    def attach(self, plc: AnyPlc | None) -> None:
        """Restart only this PLC in the tick, if it runs there; then ``connect``.

        Its variables are known from now on.
        """
        for channel in self.channels:
            channel.channel.hli.is_divided = False
        self.machine.access.presences.clear()
        realtime, _ = parts_of(plc)
        named = [one.attach(self.machine) for one in realtime]
        self._kernel.attach_plc(side_of(realtime))
        group = NamedGroup(named, [one.name for one in realtime])
        self.machine.access.named = group if named else None

    def connect(self, plc: AnyPlc | None, *, has_plc: bool) -> None:
        """Let this PLC run after each tick.

        Functions acknowledge themselves unless Python calls it, or ``has_plc``: something else
        acknowledges them.
        """
        self.plc = plc
        self._realtime_plcs, called = parts_of(plc)
        blocks = self._blocks_in_python()
        played = PlcWithBlocks(called, blocks) if blocks else called
        self._player = PlcPlayer(played, self.machine) if played is not None else None
        if played is None:
            self._kernel.calls.stop()
        self.has_plc = has_plc or called is not None
        for channel in self.channels:
            channel.channel.hli.acknowledges_itself = not self.has_plc

    def _blocks_in_python(self) -> list[Callable[[PlcView], None]]:
        """Return what Python does after each tick for blocks of PLCs in the tick."""
        found = []
        for number, one in enumerate(self._realtime_plcs):
            write = functools.partial(self._write_variable, number)
            call = None if one.is_replayed else one.blocks_in_python(write)
            found += [] if call is None else [call]
        return found

    def _write_variable(self, number: int, path: str, value: float | bool | str) -> None:
        """Set a variable of a PLC in the tick, as a PLC in Python does."""
        access = self.machine.access
        if isinstance(access.named, NamedGroup):
            access.write(access.named.path(number, path), value, PLC)

    @property
    def runs_python(self) -> bool:
        """Whether Python does something after ticks that a tape has as inputs of the PLC."""
        return self._player is not None

    def couple(self, coupled: Coupled | None) -> None:
        """Couple only this simulation to the ticks from the next one on."""
        before, self._coupled = self._coupled, None
        if before is not None:
            before.close()
        if coupled is not None:
            self._coupled = coupled
            coupled.begin(self.machine)

    def _step_coupled(self, due: int) -> int:
        """Step the coupled simulation if it is due; return how far ticks may run."""
        coupled = self._coupled
        if coupled is None:
            return due
        if coupled.next_tick <= self._kernel.tick < due:
            coupled.step()
        return min(due, coupled.next_tick)

    def advance(self, end: int) -> bool:
        """Run up to tick ``end``, or until the decoder, an input, the PLC or a pause is due.

        Returns whether a stop of the kernel has ended it.
        """
        kernel = self._kernel
        due_input = self.machine.inputs.apply_due()
        due = self._step_coupled(min(end, due_input, kernel.tick + TICKS_AT_ONCE))
        share = None
        if self.scheduled_run is not None:
            due = min(due, kernel.tick + 1)
            share = self.scheduled_run.prepare(self.channels, has_plc=self.has_plc)
        kernel.reserve()
        kernel.ends_deadlock = (
            self.ends_deadlock
            and not self.has_plc
            and not self._realtime_plcs
            and self._coupled is None
            and due_input >= NEVER
            and not kernel.image.is_attached
        )
        ticks = due - kernel.tick
        if share is not None:
            reason = kernel.lose_tick() if share.is_lost else kernel.run(ticks)
        else:
            reason = kernel.run(ticks) if self._player is None else self._play(ticks)
        self.settle(reason)
        if share is not None:
            self._end_scheduled(share, is_done=kernel.tick == due and reason != codes.FULL)
        elif self._player is not None:
            self._player.finish()
        return bool(kernel.is_stopped)

    def run_alone(self, ticks: int) -> int | None:
        """Run ticks that wait for nothing but the decoder; return why the kernel has ended them.

        ``None``, and no tick, if an input, a PLC or a schedule may be due in them. ``settle`` must
        follow, unless all of them are done and nothing was recorded (``is_settled``).
        """
        if self._player is not None or self.scheduled_run is not None or self.ends_deadlock:
            return None
        if self._coupled is not None:
            return None
        if not self.machine.inputs.are_silent:
            return None
        kernel = self._kernel
        kernel.reserve()
        kernel.ends_deadlock = False
        return kernel.run(ticks if ticks < TICKS_AT_ONCE else TICKS_AT_ONCE)

    def settle(self, reason: int) -> None:
        """Pass on the kernel's records, and do what it has returned for."""
        for plc in self._realtime_plcs:
            plc.record_messages()
        self.recording.drain()
        for plc in self._realtime_plcs:
            for message in plc.news():
                self._report(message)
        self.is_deadlocked = reason == codes.DEADLOCK
        if reason and reason != codes.FULL:
            for channel in self.channels:
                channel.serve()

    def _play(self, ticks: int) -> int:
        """Run ticks with the calls of a PLC; return why the kernel has ended them."""
        assert self._player is not None
        try:
            return self._player.run(self._player.bound(ticks))
        except BaseException:
            self.recording.drain()
            raise

    def _end_scheduled(self, share: Share, *, is_done: bool) -> None:
        """Let the PLC have its calls after a tick of a schedule, if the tick is done."""
        assert self.scheduled_run is not None
        if self._player is not None and is_done:
            for _ in range(share.plc_calls):
                self._player.cycle()
        self.scheduled_run.end_tick()

    def reset(self, channels: Sequence[ChannelRun]) -> None:
        """Reset channels (RC-007); run until they are at rest, at least one tick."""
        for channel in channels:
            channel.request_reset()
        while any(channel.channel.executor.is_resetting for channel in channels):
            self.advance(self.tick + 1)

    def make_ready(self, channels: Sequence[ChannelRun]) -> None:
        """Reset those of the channels that an earlier run has left stopped or running."""
        busy = [channel for channel in channels if channel.is_stopped or channel.is_running]
        if busy:
            self.reset(busy)

    @property
    def state(self) -> str:
        """``error`` if a channel has one, else ``running`` during a program, else ``ready``."""
        state = "ready"
        for channel in self.channels:
            if channel.channel.executor.is_stopped:
                return "error"
            if channel.feeder is not None:
                state = "running"
        return state

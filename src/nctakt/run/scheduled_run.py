# SPDX-License-Identifier: MIT
"""A schedule gives decoder, interpolation and PLC their time (``nctakt run --rtconf``).

In: a machine, a schedule. Out: before each tick, blocks decoded as far as their time goes; whether
the tick takes place; how often the PLC runs behind it. Without a schedule none of this is there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import Machine
from nctakt.lists.machine.scheduling_checks import check_contexts, check_time_limits
from nctakt.messages import Collector, diagnostic
from nctakt.messages.linux_run import CYCLES_MAY_TAKE_WINDOWS_TIME
from nctakt.messages.machine import RTCONF_MISSING
from nctakt.messages.schedule_check import CHANNEL_CONTEXT_WITHOUT_THREAD
from nctakt.messages.schedule_results import THREAD_OVERFLOWED
from nctakt.messages.scheduled_runs import TICK_MISMATCH
from nctakt.run.assembly import AssembledMachine
from nctakt.run.channel_run import ChannelRun
from nctakt.run.decode_budget import DecodeBudget
from nctakt.schedule.findings import simulation_findings
from nctakt.schedule.model import NS_PER_US
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.schedule.thread_roles import find_duties
from nctakt.schedule.ticks import Duties, Share, TickSchedule

#: What is said of the machine's own scheduling list, which does not count here: that there is none,
#: contexts without a thread, realtime cycles in the time of Windows.
_OF_OWN_LIST = (RTCONF_MISSING, CHANNEL_CONTEXT_WITHOUT_THREAD, CYCLES_MAY_TAKE_WINDOWS_TIME)


def scheduled(machine: Machine, schedule: RunSchedule) -> tuple[Machine, Duties]:
    """The machine with the ticks of a schedule, and who works for it; raises ``Failure``."""
    collector = Collector()
    known = [one for one in machine.diagnostics if one.message not in _OF_OWN_LIST]
    collector.diagnostics += known
    collector.diagnostics += [one for one in schedule.diagnostics if one not in known]
    parameters = [channel.parameters for channel in machine.channels]
    check_contexts(schedule.configuration, parameters, collector)
    check_time_limits(schedule.configuration, parameters, collector)
    duties = find_duties(
        schedule.configuration, schedule.model, parameters, schedule.load.plc, collector
    )
    if duties is None:
        raise Failure(*collector.diagnostics)
    tick_us = duties.every * schedule.configuration.cycle_time_us
    if machine.rtconf is not None and tick_us != machine.cycle_time_us:
        collector.report(
            TICK_MISMATCH, None, file=schedule.file, cycle=tick_us, other=machine.cycle_time_us
        )
    changed = replace(
        machine,
        cycle_time_us=tick_us,
        rtconf=schedule.configuration,
        diagnostics=tuple(collector.diagnostics),
    )
    return changed, duties


class ScheduledRun:
    """The schedule of a machine at work."""

    def __init__(self, machine: AssembledMachine, schedule: RunSchedule, duties: Duties) -> None:
        self._machine = machine
        self.schedule = schedule
        self._duties = duties
        self._ticks = TickSchedule(schedule.model, duties)
        self._share: Share | None = None
        self._tick = -1
        self._overflows: dict[int, list[int]] = {}
        self._told: set[str] = set()
        self._budgets = [DecodeBudget(schedule.load.block) for _ in machine.channels]
        machine.registry.name_threads([task.name for task in schedule.model.tasks])
        for channel in machine.channels:
            channel.is_paced = True
        if _sends_late(machine.configuration):
            machine.axes.send_late()
        if machine.kernel.tick or schedule.model.cycle % NS_PER_US:
            raise ValueError("a schedule begins with the first tick, of whole microseconds")

    def budget(self, channel: int) -> DecodeBudget:
        """The time of a channel's decoder; channels count from 0."""
        return self._budgets[channel]

    def prepare(self, runs: Sequence[ChannelRun], *, has_plc: bool) -> Share:
        """What comes before the next tick: decoders work; ``has_plc``: a script plays the PLC."""
        share = self._share
        if share is None or self._tick != self._machine.kernel.tick:
            share = self._share = self._ticks.next_share()
            self._tick = self._machine.kernel.tick
            self._begin_tick(share, runs, has_plc=has_plc)
        for one in runs:
            one.decode()
        return share

    def _begin_tick(self, share: Share, runs: Sequence[ChannelRun], *, has_plc: bool) -> None:
        for (_, channels), time_ns in zip(self._duties.decoders, share.decoding, strict=True):
            busy = [index for index in channels if runs[index].wants_to_decode]
            for index in channels:
                self._budgets[index].grant(time_ns // len(busy) if index in busy else 0)
        for thread in share.overflows:
            self._machine.kernel.note_overflow(thread)
            self._overflows.setdefault(thread, []).append(self._tick)
        for one in runs:
            one.channel.hli.acknowledges_itself = not has_plc and share.plc_calls > 0

    def findings(self) -> list[Diagnostic]:
        """What went wrong in the schedule in the ticks that were, each finding once."""
        schedule = self._ticks.simulation(self._machine.kernel.tick)
        found = [
            *self._overflow_errors(),
            *(one for one in simulation_findings(schedule) if one.message is not THREAD_OVERFLOWED),
        ]
        new = [one for one in found if one.text("en") not in self._told]
        self._told.update(one.text("en") for one in new)
        return new

    def _overflow_errors(self) -> Iterator[Diagnostic]:
        """P-RTCF-00011 for each thread that wants it."""
        tick_us = self._machine.configuration.cycle_time_us
        for thread, ticks in sorted(self._overflows.items()):
            task = self.schedule.model.tasks[thread]
            if task.error_on_overflow:
                first = ticks[0] * tick_us
                yield diagnostic(THREAD_OVERFLOWED, thread=task.name, count=len(ticks), time=first)


def _sends_late(machine: Machine) -> bool:
    """P-RTCF-00018: STANDARD puts out first what the tick before has computed.

    COMPLETE does so too unless all axes allow the other order (P-AXIS-00276).
    """
    assert machine.rtconf is not None
    order = machine.rtconf.schedule
    allowed = all(axis.optimised_schedule for axis in machine.axes)
    return order == "STANDARD" or (order == "COMPLETE" and not allowed)

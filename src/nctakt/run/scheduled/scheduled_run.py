# SPDX-License-Identifier: MIT
"""A run under a schedule: decoder, interpolation and PLC get limited time (``run --rtconf``).

In: a machine, a schedule. Out: before each tick, the blocks decoded in the granted time; whether
the tick takes place; how often the PLC runs after it. A channel's threads are those with its
contexts (P-RTCF-00017 with P-CHAN-00410 and 00411), else all with the function.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.lists.declared.rtconf import REALTIME_FUNCTION, RtconfConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.machine import Machine
from nctakt.lists.machine.schedules.scheduling_checks import check_contexts, check_time_limits
from nctakt.messages import Collector, diagnostic
from nctakt.messages.machines.machine import RTCONF_MISSING
from nctakt.messages.scheduling.linux_run import CYCLES_MAY_TAKE_WINDOWS_TIME
from nctakt.messages.scheduling.schedule_check import CHANNEL_CONTEXT_WITHOUT_THREAD
from nctakt.messages.scheduling.schedule_results import THREAD_OVERFLOWED
from nctakt.messages.scheduling.scheduled_runs import (
    NO_COMMON_TICK,
    REQUIRED_FUNCTION_NOT_CALLED,
    TICK_MISMATCH,
    UNKNOWN_PLC_THREAD,
)
from nctakt.run.channel_run import ChannelRun
from nctakt.run.decode_budget import DecodeBudget
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.schedule.analysis.findings import simulation_findings
from nctakt.schedule.model import NS_PER_US, Model, TaskClass
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.schedule.simulation.results import Simulation
from nctakt.schedule.simulation.ticks import DECODER_FUNCTION, Share, ThreadRoles, TickSchedule

#: Findings about the machine's own scheduling list, which has no effect under a schedule: no list,
#: contexts without a thread, realtime cycles in the time of Windows.
_OF_OWN_LIST = (RTCONF_MISSING, CHANNEL_CONTEXT_WITHOUT_THREAD, CYCLES_MAY_TAKE_WINDOWS_TIME)


def scheduled(machine: Machine, schedule: RunSchedule) -> tuple[Machine, ThreadRoles]:
    """Return the machine with the ticks of a schedule, and the roles of the threads.

    Raises ``Failure`` if a thread for the interpolation or a decoder is missing.
    """
    collector = Collector()
    kept = [finding for finding in machine.diagnostics if finding.message not in _OF_OWN_LIST]
    collector.diagnostics += kept
    collector.diagnostics += [finding for finding in schedule.diagnostics if finding not in kept]
    parameters = [channel.parameters for channel in machine.channels]
    check_contexts(schedule.configuration, parameters, collector)
    check_time_limits(schedule.configuration, parameters, collector)
    roles = find_thread_roles(
        schedule.configuration, schedule.model, parameters, schedule.load.plc, collector
    )
    if roles is None:
        raise Failure(*collector.diagnostics)
    tick_us = roles.every * schedule.configuration.cycle_time_us
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
    return changed, roles


class ScheduledRun:
    """The schedule of a machine while programs run."""

    def __init__(
        self, machine: AssembledMachine, schedule: RunSchedule, roles: ThreadRoles
    ) -> None:
        self._machine = machine
        self.schedule = schedule
        self._roles = roles
        self._ticks = TickSchedule(schedule.model, roles)
        self._share: Share | None = None
        self._tick = -1
        self._overflows: dict[int, list[int]] = {}
        self._reported: set[str] = set()
        self._budgets = [DecodeBudget(schedule.load.block) for _ in machine.channels]
        follow_schedule(machine, schedule)

    def budget(self, channel: int) -> DecodeBudget:
        """Return the decode time of a channel; channels count from 0."""
        return self._budgets[channel]

    def prepare(self, runs: Sequence[ChannelRun], *, has_plc: bool) -> Share:
        """Let the decoders work before the next tick; return the shares of the threads in it.

        ``has_plc``: a script plays the PLC.
        """
        share = self._share
        if share is None or self._tick != self._machine.kernel.tick:
            share = self._share = self._ticks.next_share()
            self._tick = self._machine.kernel.tick
            self._begin_tick(share, runs, has_plc=has_plc)
        for run in runs:
            run.decode()
        return share

    def _begin_tick(self, share: Share, runs: Sequence[ChannelRun], *, has_plc: bool) -> None:
        for (_, channels), time_ns in zip(self._roles.decoders, share.decoding, strict=True):
            busy = [index for index in channels if runs[index].can_decode]
            for index in channels:
                self._budgets[index].grant(time_ns // len(busy) if index in busy else 0)
        for thread in share.overflows:
            self._machine.kernel.note_overflow(thread)
            self._overflows.setdefault(thread, []).append(self._tick)
        for run in runs:
            run.channel.hli.acknowledges_itself = not has_plc and share.plc_calls > 0

    def end_tick(self) -> None:
        """Do nothing: no clock measures the tick."""

    def findings(self) -> list[Diagnostic]:
        """Return the findings about the schedule so far, each once."""
        findings = [*self._overflow_errors(), *self._simulated_findings()]
        new = [finding for finding in findings if finding.text("en") not in self._reported]
        self._reported.update(finding.text("en") for finding in new)
        return new

    def simulation(self) -> Simulation:
        """Return the results of the schedule in the ticks so far."""
        return self._ticks.simulation(self._machine.kernel.tick)

    def _simulated_findings(self) -> Iterator[Diagnostic]:
        """Yield the findings about the ticks so far, without overflows."""
        for finding in simulation_findings(self.simulation()):
            if finding.message is not THREAD_OVERFLOWED:
                yield finding

    def _overflow_errors(self) -> Iterator[Diagnostic]:
        """Yield the errors of overflown threads with P-RTCF-00011."""
        tick_us = self._machine.configuration.cycle_time_us
        for thread, ticks in sorted(self._overflows.items()):
            task = self.schedule.model.tasks[thread]
            if task.error_on_overflow:
                first = ticks[0] * tick_us
                yield diagnostic(THREAD_OVERFLOWED, thread=task.name, count=len(ticks), time=first)


def follow_schedule(machine: AssembledMachine, schedule: RunSchedule) -> None:
    """Make a machine's ticks follow a schedule from the first one on."""
    machine.registry.name_threads([task.name for task in schedule.model.tasks])
    for channel in machine.channels:
        channel.feed.is_paced = True
    if _sends_late(machine.configuration):
        machine.axes.send_late()
    if machine.kernel.tick or schedule.model.cycle % NS_PER_US:
        raise ValueError("a schedule begins with the first tick, of whole microseconds")


def _sends_late(machine: Machine) -> bool:
    """Return whether a tick first outputs the positions of the previous one (P-RTCF-00018).

    STANDARD does so always, COMPLETE unless all axes allow the other order (P-AXIS-00276).
    """
    assert machine.rtconf is not None
    order = machine.rtconf.schedule
    allowed = all(axis.optimised_schedule for axis in machine.axes)
    return order == "STANDARD" or (order == "COMPLETE" and not allowed)


# --- the threads of a controller ------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Lists:
    configuration: RtconfConfiguration
    model: Model

    def with_function(self, function: str, context: int) -> tuple[int, ...]:
        """Return the threads that call a function: those of the context, else all."""
        threads = self.configuration.threads
        callers = [
            i
            for i, task in enumerate(self.model.tasks[: len(threads)])
            if any(call.function == function for call in task.calls)
        ]
        own = tuple(i for i in callers if threads[i].context == context)
        return own or tuple(callers)

    def interpolators(self, context: int) -> tuple[int, ...]:
        """Return the threads of the interpolation: with ``task_int``, else the most urgent."""
        callers = self.with_function(REALTIME_FUNCTION, context)
        tasks = enumerate(self.model.tasks)
        return callers or tuple(
            i for i, task in tasks if task.kind is TaskClass.REALTIME and task.calls
        )


def find_thread_roles(
    configuration: RtconfConfiguration,
    model: Model,
    channels: Sequence[ChannelParameters],
    plc: str | None,
    collector: Collector,
) -> ThreadRoles | None:
    """Return the roles; ``None`` after errors. ``plc``: its semaphore, if the load names it."""
    lists = _Lists(configuration, model)
    found = Collector()
    interpolators: dict[int, None] = {}
    decoders: dict[tuple[int, ...], list[int]] = {}
    for index, channel in enumerate(channels):
        interpolators |= dict.fromkeys(lists.interpolators(channel.context_geo))
        threads = lists.with_function(DECODER_FUNCTION, channel.context_sda)
        decoders.setdefault(threads, []).append(index)
    if not interpolators:
        found.report(REQUIRED_FUNCTION_NOT_CALLED, None, function=REALTIME_FUNCTION)
    if () in decoders:
        found.report(REQUIRED_FUNCTION_NOT_CALLED, None, function=DECODER_FUNCTION)
    periods = {model.tasks[i].every for i in interpolators}
    if len(periods) > 1:
        names = ", ".join(model.tasks[i].name for i in interpolators)
        found.report(NO_COMMON_TICK, None, threads=names)
    plc_thread = _plc(model, plc, found)
    collector.diagnostics += found.diagnostics
    if found.has_errors:
        return None
    groups = tuple((threads, tuple(own)) for threads, own in decoders.items())
    return ThreadRoles(periods.pop(), tuple(interpolators), groups, plc_thread)


def _plc(model: Model, name: str | None, collector: Collector) -> int | None:
    """Return the external thread that is the PLC: the one that the load names, else the first."""
    external = [i for i, task in enumerate(model.tasks) if task.kind is TaskClass.EXTERNAL]
    if name is None:
        return external[0] if external else None
    for i in external:
        if model.tasks[i].name == name:
            return i
    names = ", ".join(model.tasks[i].name for i in external)
    collector.report(UNKNOWN_PLC_THREAD, None, name=name, names=names or "–")
    return None

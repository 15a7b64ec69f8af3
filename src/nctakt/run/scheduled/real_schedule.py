# SPDX-License-Identifier: MIT
"""A run whose decoder, interpolation and PLC have their time on a real clock (``serve --rtconf``).

In: a machine, a schedule, a PLC's script. Out: ticks at the NC interrupts of this thread, as many
commands of the decoders as their threads had time for, calls of the PLC in its own thread. Each
decision of the clock is an input: from tick t on, n further commands were there. So a tape of such
a run replays to the same bytes (``recorded_schedule.py``).
"""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.linux_run import SCHED_FIFO_NOT_PERMITTED
from nctakt.messages.scheduling.real_schedule import (
    ALWAYS_A_TIMER,
    STEPS_BESIDE_TICKS,
    THREAD_NOT_PLACED,
    THREADS_SHARED,
    THREADS_WITHOUT_WORK,
)
from nctakt.messages.scheduling.schedule_results import THREAD_OVERFLOWED
from nctakt.run.access.inputs import DECODED, LOST, OVERFLOWED
from nctakt.run.channel_run import ChannelRun
from nctakt.run.decode_budget import StepBudget
from nctakt.run.plcs.plc_view import AnyPlc, PlcView
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.scheduled.recorded_schedule import decode, settle
from nctakt.run.scheduled.scheduled_run import follow_schedule
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.schedule.real.machine import fifo_refusal
from nctakt.schedule.real.measure import Measurement
from nctakt.schedule.real.plan import Plan, make_plan
from nctakt.schedule.real.report import run_report
from nctakt.schedule.real.schedule_threads import ScheduleThreads, Step
from nctakt.schedule.simulation.simulate import simulate
from nctakt.schedule.simulation.ticks import Share, ThreadRoles

if TYPE_CHECKING:
    from nctakt.schedule.model import Task

#: How long a thread may compute in Python while the interpolation is due, in seconds.
_SWITCH_S = 0.00005

#: NC cycles of the simulation that the table compares with.
_MAX_SIMULATED = 1_000_000


class RealSchedule:
    """The threads of one controller; the thread that calls ``prepare`` is the interpolation's.

    ``plc``: its script, called in the thread of the list that is the PLC.
    """

    def __init__(
        self,
        machine: AssembledMachine,
        schedule: RunSchedule,
        roles: ThreadRoles,
        plc: AnyPlc | None,
        report: Callable[[Diagnostic], None],
    ) -> None:
        follow_schedule(machine, schedule)
        self.schedule = schedule
        self._machine = machine
        self._roles = roles
        self._plc = plc
        self._report = report
        self._plan = _plan(schedule, report)
        self._budgets = [StepBudget() for _ in machine.channels]
        self._runs: Sequence[ChannelRun] = ()
        self._given: list[tuple[int, int]] = []
        self._failure: BaseException | None = None
        self._tick = -1
        self._share = Share((), False, (), 0)
        self._overflows: dict[int, list[int]] = {}
        self._reported = 0
        self._switch_s = 0.0
        steps = dict(self._steps())
        for found in self._limits(steps):
            report(found)
        self._threads = ScheduleThreads(self._plan, roles.interpolators[0], steps)

    def _steps(self) -> Iterator[tuple[int, Step]]:
        """Yield the action of each thread's step."""
        for threads, channels in self._roles.decoders:
            yield threads[0], self._decoder_step(channels)
        if self._plc is not None and self._roles.plc is not None:
            yield self._roles.plc, self._call_plc

    def _limits(self, steps: dict[int, Step]) -> Iterator[Diagnostic]:
        """Yield the settings of the list that cannot be kept here."""
        tasks = self.schedule.model.tasks
        played = {*steps, self._roles.interpolators[0]}
        decoders = (i for threads, _ in self._roles.decoders for i in threads)
        busy = (*self._roles.interpolators, *decoders)
        shared = [tasks[i].name for i in busy if i not in played]
        idle = [
            task.name
            for i, task in enumerate(tasks)
            if i not in played and task.name not in shared and not _is_external(task)
        ]
        yield diagnostic(STEPS_BESIDE_TICKS)
        if shared:
            yield diagnostic(THREADS_SHARED, threads=", ".join(shared))
        if idle:
            yield diagnostic(THREADS_WITHOUT_WORK, threads=", ".join(idle))

    # --- jobs -----------------------------------------------------------------------------------

    def _decoder_step(self, channels: Sequence[int]) -> Step:
        """Return the step of a decoder: one command of its next channel that has work."""

        def step() -> bool:
            try:
                for channel in channels:
                    given = decode(self._runs[channel], self._budgets[channel], 1)
                    if given:
                        self._note(channel, given)
                        return True
            except BaseException as error:  # noqa: BLE001 - the interpolation's thread raises it
                self._failure = self._failure or error
            return False

        return step

    def _note(self, channel: int, given: int) -> None:
        """Note commands, in the order in which the decoders gave them."""
        if self._given and self._given[-1][0] == channel:
            self._given[-1] = channel, self._given[-1][1] + given
        else:
            self._given.append((channel, given))

    def _call_plc(self) -> bool:
        """Call the PLC once."""
        if self._plc is not None and self._failure is None:
            try:
                self._plc.cycle(PlcView(self._machine))
            except BaseException as error:  # noqa: BLE001 - as above
                self._failure = error
        return False

    # --- ticks ----------------------------------------------------------------------------------

    def budget(self, channel: int) -> StepBudget:
        """Return the decoder's budget of a channel; channels count from 0."""
        return self._budgets[channel]

    def restart(self) -> None:
        """Restart after a pause: ticks due during it are not lost."""
        self._threads.restart()

    def prepare(self, runs: Sequence[ChannelRun], *, has_plc: bool) -> Share:
        """Wait for the NC interrupt of the next tick; the threads work meanwhile."""
        if self._tick == self._machine.kernel.tick:
            return self._share
        self._tick = self._machine.kernel.tick
        if self._tick == 0:
            self._prepare_process()
            self._machine.inputs.schedule(DECODED, 0, 0)  # a tape of a real clock
        self._runs = runs
        is_lost, busy = self._threads.wait(self._roles.every)
        if self._failure is not None:
            raise self._failure
        for channel, given in self._given:
            self._machine.inputs.schedule(DECODED, channel, given)
        self._given.clear()
        for thread in busy:
            self._machine.inputs.schedule(OVERFLOWED, thread)
            self._machine.kernel.note_overflow(thread)
            self._overflows.setdefault(thread, []).append(self._tick)
        if is_lost:
            self._machine.inputs.schedule(LOST)
        settle(runs, self._budgets, has_plc=has_plc)
        plc_calls = 1 if self._roles.plc is None else 0
        self._share = Share((), is_lost, tuple(busy), plc_calls)
        self._report_refusals()
        return self._share

    def _prepare_process(self) -> None:
        """Make other threads release the interpreter soon, and disable garbage collection."""
        self._switch_s = sys.getswitchinterval()
        sys.setswitchinterval(_SWITCH_S)
        gc.freeze()

    def _report_refusals(self) -> None:
        for number, error in self._threads.refusals[self._reported :]:
            task = self.schedule.model.tasks[number]
            reason = os.strerror(error)
            self._report(diagnostic(THREAD_NOT_PLACED, thread=task.name, reason=reason))
        self._reported = len(self._threads.refusals)

    def end_tick(self) -> None:
        """Note that the tick is done."""
        self._threads.finish()

    def close(self) -> None:
        """End the threads; undo their changes to the process."""
        self._threads.close()
        if self._switch_s:
            sys.setswitchinterval(self._switch_s)
            gc.unfreeze()

    # --- results --------------------------------------------------------------------------------

    def findings(self) -> list[Diagnostic]:
        """Return the errors of overflown threads with P-RTCF-00011."""
        tick_us = self._machine.configuration.cycle_time_us
        found = []
        for thread, ticks in sorted(self._overflows.items()):
            task = self.schedule.model.tasks[thread]
            if task.error_on_overflow:
                time, count = ticks[0] * tick_us, len(ticks)
                found.append(
                    diagnostic(THREAD_OVERFLOWED, thread=task.name, count=count, time=time)
                )
        return found

    def measurement(self) -> Measurement:
        """Return the numbers of the threads up to here."""
        return self._threads.measurement()

    def table(self, language: Language) -> str:
        """Return the table of ``nctakt schedule run``; empty before the first NC cycle.

        The wake-up latency of the interpolation is that of the tick: until it computes.
        """
        measurement = self.measurement()
        cycles = min(measurement.run.cycles, _MAX_SIMULATED)
        if not cycles:
            return ""
        return run_report(
            measurement, self._plan, simulate(self.schedule.model, cycles, record=0), language
        )


def _plan(schedule: RunSchedule, report: Callable[[Diagnostic], None]) -> Plan:
    """Return priorities, processors and semaphores of the list."""
    if schedule.model.source is not InterruptSource.TIMER:
        report(diagnostic(ALWAYS_A_TIMER))
    reason = fifo_refusal()
    if reason is not None:
        report(diagnostic(SCHED_FIFO_NOT_PERMITTED, reason=reason))
    return make_plan(schedule.model, 1, is_fifo=reason is None, plays_external=False)


def _is_external(task: Task) -> bool:
    return task.kind.name == "EXTERNAL"

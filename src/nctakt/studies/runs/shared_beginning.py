# SPDX-License-Identifier: MIT
"""Injections that share the beginning of their runs, which is run once.

In: a runner whose plan injects a value at each tick. Out: the same rows as ``StudyRunner.row``
makes. The unchanged run advances by some ticks at a time. Where it waits, the ticks up to the next
injections and after them are tried, and the realtime part is restored (``trial.py``). If a trial is
not possible, a copy of the process (``fork``) continues until the injection is decided and hands
its row over; a process that does so has one thread. If a copy takes longer than the beginning, or
must not be made, the run is made from its start: the choice is measured, and changes no row.
"""

from __future__ import annotations

import os
import pickle
import signal
import time
from collections.abc import Sequence

from nctakt.base import interrupts
from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.run.access.machine_names import names_of_machine
from nctakt.run.access.stimuli import Stimulus, as_inputs
from nctakt.studies.measuring.window import Injection
from nctakt.studies.plans.dimension import Value
from nctakt.studies.plans.inputs import RunInputs, inputs_of
from nctakt.studies.plans.plan import Plan
from nctakt.studies.runs.begun_run import BegunRun, FinishedRun
from nctakt.studies.runs.study_runner import Row, StudyRunner, crashed_row
from nctakt.studies.runs.trial import Trials

#: An unchanged run waits fewer than this many ticks before an injection that starts from it.
MAX_LEAD = 32

#: From which length of the unchanged run on copying may be cheaper than running from the start.
MIN_COPIED_TICKS = 10_000


def is_shared(plan: Plan) -> bool:
    """Return whether the runs of a plan share their beginning."""
    is_single = len(plan.dimensions) == 1 and not plan.is_schedule
    return is_single and plan.dimensions[0].is_each_tick


def is_copied(plan: Plan, cycle_time_us: int) -> bool:
    """Return whether copies of a process may make the runs of a plan faster."""
    is_long = is_shared(plan) and plan.dimensions[0].high / cycle_time_us >= MIN_COPIED_TICKS
    return is_long and hasattr(os, "fork")


def maker_of(runner: StudyRunner, *, may_copy: bool) -> StudyRunner | SharedBeginning:
    """Return the maker of a runner's rows; ``may_copy``: this process may copy itself."""
    return SharedBeginning(runner, may_copy=may_copy) if is_shared(runner.plan) else runner


class SharedBeginning:
    """Makes the rows of a runner; each number should be higher than the last.

    ``may_copy``: this process has one thread and may copy itself.
    """

    def __init__(self, runner: StudyRunner, *, may_copy: bool) -> None:
        self._runner = runner
        self._may_copy = may_copy and is_copied(runner.plan, runner.cycle_time_us)
        self._begun: BegunRun | None = None
        self._trials: Trials | None = None
        stimuli = (Stimulus(*one) for one in runner.plan.stimuli)
        self._planned = as_inputs(stimuli, 0, runner.cycle_time_us)
        self._beginning_s = 0.0
        self._copy_s = 0.0

    def row(self, number: int) -> Row:
        """Return the row of a run; if its process dies, a row that says so."""
        plan, runner = self._runner.plan, self._runner
        point = plan.point(number)
        injected_us = plan.injection_us(point)
        assert injected_us is not None
        injection = runner.injection(injected_us)
        if injection is None and not self._may_copy:
            return runner.row(number)
        tick = -(-injected_us // runner.cycle_time_us)
        try:
            finished = None if injection is None else self._tried(injection, point)
            if finished is not None:
                return runner.row_head(number, point) | runner.judge(finished)
            if not self._may_copy:
                return runner.row(number)
            begun = self._advanced(tick)
        except Failure:
            self._begun = None
            return runner.row(number)
        if begun.controller.tick == tick and self._copying_pays():
            return self._copied(begun, number, point)
        return runner.row(number)

    def _advanced(self, tick: int) -> BegunRun:
        """Return the unchanged run at a tick, and note how long it takes to get there.

        If it ends earlier, it waits at its end.
        """
        begin_s = time.perf_counter()
        if self._begun is None or self._begun.controller.tick > tick:
            plan = self._runner.plan
            inputs = RunInputs(dict(plan.assignments), list(plan.stimuli))
            self._begun = self._runner.begin(inputs)
            self._trials = None
            self._beginning_s = 0.0
        self._begun.run.advance(tick)
        self._beginning_s += time.perf_counter() - begin_s
        return self._begun

    # --- trials ---------------------------------------------------------------------------------

    def _tried(self, injection: Injection, point: Sequence[Value]) -> FinishedRun | None:
        """Return the run that a trial has made; ``None`` if there can be no trial.

        It is made off the unchanged run where that waits, or else at the injection's tick.
        """
        begun = self._begun
        if begun is not None and 0 <= injection.tick - begun.controller.tick < MAX_LEAD:
            finished = self._tried_off(begun, injection, point)
            if finished is not None or begun.controller.tick == injection.tick:
                return finished
        return self._tried_off(self._advanced(injection.tick), injection, point)

    def _tried_off(
        self, begun: BegunRun, injection: Injection, point: Sequence[Value]
    ) -> FinishedRun | None:
        """Return the run that a trial off the unchanged run has made, as ``_tried``."""
        runner, controller = self._runner, begun.controller
        tick = controller.tick
        is_due = any(tick <= one.tick < injection.end for one in self._planned)
        if is_due or tick > injection.tick or injection.end > begun.run.end:
            return None
        if runner.plan.plcs or controller.state != "running" or begun.lent is None:
            return None
        if any(one.severity is Severity.ERROR for one in controller.diagnostics):
            return None
        if self._trials is None:
            names = names_of_machine(runner.machine)
            known = names.signals()
            cells = {name: known[name].cell for name in runner.signals}
            self._trials = Trials(begun.lent.part, names, cells)
        inputs = inputs_of(runner.plan, point, runner.cycle_time_us)
        own = [Stimulus(*one) for one in inputs.stimuli[len(runner.plan.stimuli) :]]
        try:
            tried = self._trials.make(
                injection, as_inputs(own, 0, runner.cycle_time_us), begun.before
            )
        except Failure:
            return None
        if tried is None:
            return None
        digest = begun.digest.with_more(tried.events, tried.rows)
        return FinishedRun(tried.outcome, inputs, digest)

    # --- copies of the process ------------------------------------------------------------------

    def _copying_pays(self) -> bool:
        """Return whether a copy of this process takes less time than the beginning of a run."""
        if self._copy_s == 0.0:
            begin_s = time.perf_counter()
            process = os.fork()
            if process == 0:
                os._exit(0)
            os.waitpid(process, 0)
            self._copy_s = time.perf_counter() - begin_s
        return self._copy_s < self._beginning_s

    def _copied(self, begun: BegunRun, number: int, point: Sequence[Value]) -> Row:
        """Let a copy of this process make the run, and return its row."""
        reader, writer = os.pipe()
        process = os.fork()
        if process == 0:
            try:
                interrupts.ignore()
                interrupts.end_with_parent()
                os.close(reader)
                row = self._finished(begun, number, point)
                with os.fdopen(writer, "wb") as file:
                    pickle.dump(row, file)
            finally:
                os._exit(0)
        os.close(writer)
        try:
            with os.fdopen(reader, "rb") as file:
                data = file.read()
        except KeyboardInterrupt:
            os.kill(process, signal.SIGKILL)
            raise
        finally:
            os.waitpid(process, 0)
        if not data:
            return crashed_row(self._runner.plan, number)
        copied: Row = pickle.loads(data)
        return copied

    def _finished(self, begun: BegunRun, number: int, point: Sequence[Value]) -> Row:
        """Apply the injection, continue until it is decided, and return the row."""
        runner = self._runner
        inputs = inputs_of(runner.plan, point, runner.cycle_time_us)
        own = [Stimulus(*one) for one in inputs.stimuli[len(runner.plan.stimuli) :]]
        begun.add(as_inputs(own, 0, runner.cycle_time_us))
        injected_us = runner.plan.injection_us(point)
        finished = begun.finish(injected_us, runner.injection(injected_us))
        return runner.row_head(number, point) | runner.judge(finished)

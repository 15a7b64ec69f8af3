# SPDX-License-Identifier: MIT
"""Injections that share the beginning of their runs: run once, copied at each tick by ``fork``.

In: a bench whose plan injects a value at each tick. Out: the same rows as ``Bench.row`` makes. The
unchanged run goes forward from injection to injection; at each, a copy of the process takes the
injection, goes on until it is decided, and hands its row over. A process that does so has one
thread. Where there is no ``fork``, and where a copy takes longer than the beginning, each run
is made from its start: that is measured, and changes no row.
"""

from __future__ import annotations

import os
import pickle
import time
from collections.abc import Sequence

from nctakt.run.stimuli import Stimulus, as_inputs
from nctakt.studies.bench import BegunRun, Bench, Row, crashed_row
from nctakt.studies.dimension import Value
from nctakt.studies.inputs import RunInputs, inputs_of
from nctakt.studies.plan import Plan

#: From which length of the unchanged run on copying may be cheaper than running from the start.
MIN_SHARED_TICKS = 10_000


def is_shared(plan: Plan, cycle_time_us: int) -> bool:
    """Return whether the runs of a plan should share their beginning."""
    if not hasattr(os, "fork") or len(plan.dimensions) != 1:
        return False
    dimension = plan.dimensions[0]
    return dimension.is_each_tick and dimension.high / cycle_time_us >= MIN_SHARED_TICKS


class SharedBeginning:
    """Makes the rows of a bench; each number should be higher than the one before."""

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self._begun: BegunRun | None = None
        self._beginning_s = 0.0
        self._copy_s = 0.0

    def row(self, number: int) -> Row:
        """Return the row of a run; of one whose process ends by itself, a row that says so."""
        plan = self._bench.plan
        point = plan.point(number)
        injected_us = plan.injection_us(point)
        assert injected_us is not None
        tick = -(-injected_us // self._bench.cycle_time_us)
        begun = self._advanced(tick)
        is_over = begun.controller.tick != tick  # the unchanged run has ended before
        if is_over or not self._copying_pays():
            return self._bench.row(number)
        return self._copied(begun, number, point)

    def _advanced(self, tick: int) -> BegunRun:
        """Return the unchanged run at a tick, and note how long it takes to get there."""
        begin_s = time.perf_counter()
        if self._begun is None or self._begun.controller.tick > tick:
            plan = self._bench.plan
            inputs = RunInputs(dict(plan.assignments), list(plan.stimuli))
            self._begun = self._bench.begin(inputs)
            self._beginning_s = 0.0
        self._begun.run.advance(tick)
        self._beginning_s += time.perf_counter() - begin_s
        return self._begun

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
                os.close(reader)
                row = self._finished(begun, number, point)
                with os.fdopen(writer, "wb") as file:
                    pickle.dump(row, file)
            finally:
                os._exit(0)
        os.close(writer)
        with os.fdopen(reader, "rb") as file:
            data = file.read()
        os.waitpid(process, 0)
        if not data:
            return crashed_row(self._bench.plan, number)
        copied: Row = pickle.loads(data)
        return copied

    def _finished(self, begun: BegunRun, number: int, point: Sequence[Value]) -> Row:
        """Take the injection, go on until it is decided, and return the row."""
        bench = self._bench
        inputs = inputs_of(bench.plan, point, bench.cycle_time_us)
        own = [Stimulus(*one) for one in inputs.stimuli[len(bench.plan.stimuli) :]]
        begun.add(as_inputs(own, 0, bench.cycle_time_us))
        injected_us = bench.plan.injection_us(point)
        finished = begun.finish(injected_us, bench.decided_after(injected_us))
        return bench.row_head(number, point) | bench.judge(finished)

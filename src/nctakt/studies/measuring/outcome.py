# SPDX-License-Identifier: MIT
"""One run of a study, as seen by measures: events, signals tick by tick, state, duration."""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from functools import cached_property

from nctakt.results.run import Run
from nctakt.schedule.analysis.analyse import Analysis, analyse
from nctakt.schedule.simulation.results import Simulation
from nctakt.testing.queries import NcRun
from nctakt.testing.verdict import signal_of


class NotMeasuredError(Exception):
    """A measure has no value in this run: its event did not happen."""


class Outcome:
    """A run, as measures and expectations look at it.

    Times are microseconds of the run. ``injected_us``: that of the stimulus of an each-tick study.
    ``simulation``: the schedule of the run, or the one simulated without a run.
    """

    def __init__(
        self,
        run: Run,
        injected_us: int | None = None,
        simulation: Simulation | None = None,
    ) -> None:
        self.simulation = simulation
        self.run = run
        self.queries = NcRun(run)
        self.injected_us = injected_us
        self._columns: dict[str, array[float]] = {}
        #: The times of events that were looked for, by event.
        self.times_us: dict[object, list[int]] = {}

    @cached_property
    def analysis(self) -> Analysis:
        """The analysis of its schedule."""
        assert self.simulation is not None
        return analyse(self.simulation.model)

    @property
    def cycle_time_us(self) -> int:
        """The length of a tick in microseconds."""
        return self.run.cycle_time_us

    def values(self, name: str) -> Sequence[float]:
        """Return the values of a signal at the begin of each tick, and at the end of the run."""
        return self.course(name)[0]

    def course(self, name: str) -> tuple[array[float], int]:
        """Return the available values of a signal, and the tick of the first one."""
        signal = signal_of(self.queries, name)
        if signal not in self._columns:
            assert self.run.trace is not None
            values = array("d", [self.run.before[signal]])
            values.frombytes(self.run.trace[signal].tobytes())
            self._columns[signal] = values
        return self._columns[signal], 0

    def value_at(self, name: str, time_us: int) -> float:
        """Return a signal at a time, as a realtime cycle reads it then."""
        values = self.values(name)
        tick = -(-time_us // self.run.cycle_time_us)
        return values[max(0, min(tick, len(values) - 1))]

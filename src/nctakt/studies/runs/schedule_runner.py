# SPDX-License-Identifier: MIT
"""The runner of a study of a schedule: a list and its load -> the row of each simulation.

In: a plan without a program. Out: rows as ``StudyRunner`` makes them, of simulations in virtual
time.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence

from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import Time
from nctakt.schedule.analysis.findings import simulation_findings
from nctakt.schedule.open_schedule import cycles_within
from nctakt.schedule.simulation.simulate import simulate
from nctakt.studies.plans.changed_schedule import ScheduleChanges, ScheduleFiles
from nctakt.studies.plans.dimension import Dimension, Value
from nctakt.studies.plans.inputs import RunInputs, inputs_of
from nctakt.studies.plans.plan import Plan
from nctakt.studies.plans.schedule_measures import ScheduleOutcome, problems_of_numbers
from nctakt.studies.plans.units import units_of
from nctakt.studies.runs.begun_run import FinishedRun
from nctakt.studies.runs.study_runner import FAILED, PASSED, Row, StudyRunner

#: How long a schedule is simulated unless the plan says it.
DURATION = Time(1_000_000)

#: The state of a simulation.
SIMULATED = "simulated"


class ScheduleRunner(StudyRunner):
    """List and load of a plan; raises ``Failure`` for files that cannot be read."""

    def __init__(self, plan: Plan, access: FileAccess | None = None) -> None:
        assert plan.rtconf is not None
        self.plan = plan
        self.access = access or FileAccess()
        self._files = ScheduleFiles(plan.rtconf, plan.load, plan.system)
        self._base = self._files.schedule(ScheduleChanges(), self.access)
        self.cycle_time_us = self._base.configuration.cycle_time_us
        self.units = units_of(plan, lambda _name: "")

    def check(self) -> None:
        """Raise ``Failure`` for names that list and load do not have."""
        found: list[Diagnostic] = []
        plan, base = self.plan, self._base.model
        for measure in plan.measures:
            found += self._failures("measure", measure.name, measure.check)
        found += problems_of_numbers(plan, base)
        for number, dimension in enumerate(plan.dimensions):
            for value in dimension.probes():
                found += self._failures("vary", number, self._check_value, dimension, value)
        if found:
            raise Failure(*{one.text(): one for one in found}.values())

    def _check_value(self, dimension: Dimension, value: Value) -> None:
        """Raise ``Failure`` for a value that list or load refuse, with the others unchanged."""
        inputs = RunInputs()
        inputs.add(dimension, value, self.cycle_time_us)
        self._files.schedule(inputs.schedule, self.access)

    def _failures(
        self, table: str, entry: str | int, function: Callable[..., None], *words: object
    ) -> list[Diagnostic]:
        """Return the exception of a function, at the place of an entry of the plan."""
        try:
            function(*words)
        except Failure as failure:
            return self.plan.placed(failure, table, entry)
        return []

    def make(self, point: Sequence[Value]) -> FinishedRun:
        """Simulate the schedule with these values; raises ``Failure``."""
        inputs = inputs_of(self.plan, point, self.cycle_time_us)
        model = self._files.schedule(inputs.schedule, self.access).model
        run = simulate(model, cycles_within(model, self.plan.until or DURATION), record=0)
        numbers = repr((model, run.tasks, run.windows, run.missed_suspensions, run.end))
        digest = hashlib.blake2b(numbers.encode(), digest_size=8).hexdigest()
        return FinishedRun(ScheduleOutcome(run), inputs, digest)

    def judge(self, finished: FinishedRun) -> Row:
        """Return measures, verdict and digest; an overflow that is an error breaks a run.

        Unless an expectation is about overflows.
        """
        plan, outcome = self.plan, finished.outcome
        assert isinstance(outcome, ScheduleOutcome)
        broken = [one.broken(outcome) for one in plan.expectations if not one.is_met(outcome)]
        if not any("overflows" in one.text for one in plan.expectations):
            errors = simulation_findings(outcome.simulation)
            broken += dict.fromkeys(
                f"error {one.id}" for one in errors if one.severity is Severity.ERROR
            )
        measured: Row = {measure.name: measure.value(outcome) for measure in plan.measures}
        return measured | {
            "state": SIMULATED,
            "ticks": outcome.simulation.cycles,
            "verdict": FAILED if broken else PASSED,
            "broken": "; ".join(broken),
            "seed": plan.seed,
            "digest": finished.digest,
        }

    def texts(self, point: Sequence[Value]) -> tuple[str, str | None]:
        """Return the texts of list and load of a run; raises ``Failure``."""
        inputs = inputs_of(self.plan, point, self.cycle_time_us)
        return self._files.texts(inputs.schedule, self.access)


def runner_of(plan: Plan, access: FileAccess | None = None) -> StudyRunner:
    """Return the runner of a plan: of a schedule, or of a program."""
    return ScheduleRunner(plan, access) if plan.is_schedule else StudyRunner(plan, access)

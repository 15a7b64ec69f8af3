# SPDX-License-Identifier: MIT
"""The values of a point -> the inputs of its run.

In: a plan and a point. Out: ``RunInputs``: values before the first tick, values at times, faults of
the PLC, parameters of lists, variables of the program; and the words of ``nctakt run`` for them.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass, field
from nctakt.lists.format.times import Time
from nctakt.plc.inputs import read_inputs
from nctakt.project.run_settings import DEFAULT_PLC
from nctakt.run.access.stimuli import assignment_text
from nctakt.run.options import BY_NAME, command_words
from nctakt.studies.plans.changed_schedule import FAMILY, ScheduleChanges
from nctakt.studies.plans.dimension import Dimension, Value, chance
from nctakt.studies.plans.faults import PlcFaults
from nctakt.studies.plans.plan import Plan

Amount = float | str

#: The most values at times that a command names.
MAX_STIMULI = 20


@dataclass(slots=True)
class RunInputs:
    """The inputs of one run; ``parameters``: ID and axis or channel -> value."""

    assignments: dict[str, Amount] = field(default_factory=dict)
    stimuli: list[tuple[Time, str, Amount]] = field(default_factory=list)
    faults: PlcFaults = field(default_factory=PlcFaults)
    parameters: dict[tuple[str, str], Amount] = field(default_factory=dict)
    program_variables: dict[str, Amount] = field(default_factory=dict)
    schedule: ScheduleChanges = field(default_factory=ScheduleChanges)

    @property
    def needs_tape(self) -> bool:
        """Whether no option of ``nctakt run`` says some of these inputs."""
        changes = self.schedule
        changed = self.parameters or self.program_variables or changes.parameters or changes.entries
        return bool(self.faults or changed)

    def add(self, dimension: Dimension, value: Value, cycle_time_us: int) -> None:
        """Add the inputs for a value of a dimension."""
        match dimension.kind:
            case "variable" if dimension.at is None and not dimension.is_ramp:
                self.assignments[dimension.target] = value
            case "variable" if dimension.is_ramp:
                self.stimuli += _ramp(dimension, value, cycle_time_us)
            case "variable":
                assert dimension.at is not None
                begin_us = dimension.at.us(cycle_time_us)
                self.stimuli += _pulse(dimension, begin_us, value, cycle_time_us)
            case "time_of":
                self.stimuli += _pulse(dimension, int(value), dimension.amount, cycle_time_us)
            case "noise":
                self.stimuli += _noise(dimension, int(value), cycle_time_us)
            case "series":
                self.stimuli += (
                    (one.time, one.name, one.value) for one in read_inputs(Path(str(value)))
                )
            case "acknowledge":
                self.faults.answers[dimension.target.upper()] = value
            case "plc_dies":
                self.faults.dies_us = int(value)
            case "plc_returns":
                self.faults.returns_us = int(value)
            case "program_variable":
                self.program_variables[dimension.target] = value
            case "parameter" if dimension.target.startswith(FAMILY):
                self.schedule.parameters[dimension.target, dimension.of] = value
            case "parameter":
                self.parameters[dimension.target, dimension.of] = value
            case "load_entry":
                self.schedule.entries[dimension.target] = value
            case "rtconf":
                self.schedule.rtconf = Path(str(value))
            case "load":
                self.schedule.load = Path(str(value))


def inputs_of(plan: Plan, point: Sequence[Value], cycle_time_us: int) -> RunInputs:
    """Return the inputs of a point."""
    inputs = RunInputs(dict(plan.assignments), list(plan.stimuli))
    for dimension, value in zip(plan.dimensions, point, strict=True):
        inputs.add(dimension, value, cycle_time_us)
    return inputs


def _pulse(
    dimension: Dimension, begin_us: int, amount: Amount, cycle_time_us: int
) -> Iterator[tuple[Time, str, Amount]]:
    """Yield a value at a time, and the value at rest when its duration is over."""
    yield Time(begin_us), dimension.target, amount
    if dimension.duration is not None:
        end_us = begin_us + dimension.duration.us(cycle_time_us)
        yield Time(end_us), dimension.target, dimension.rest


def _ramp(
    dimension: Dimension, goal: Value, cycle_time_us: int
) -> Iterator[tuple[Time, str, Amount]]:
    """Yield the values of a ramp from ``rest`` to the goal, one for each tick."""
    begin_us, ticks = _span(dimension, cycle_time_us)
    rest = float(dimension.rest)
    for tick in range(ticks + 1):
        value = rest + (float(goal) - rest) * tick / max(ticks, 1)
        yield Time(begin_us + tick * cycle_time_us), dimension.target, value


def _noise(
    dimension: Dimension, seed: int, cycle_time_us: int
) -> Iterator[tuple[Time, str, Amount]]:
    """Yield the values of a noise, one for each tick, evenly spread around ``rest``."""
    begin_us, ticks = _span(dimension, cycle_time_us)
    for tick in range(ticks + 1):
        share = 2.0 * chance(seed, tick) - 1.0
        value = float(dimension.rest) + float(dimension.amount) * share
        yield Time(begin_us + tick * cycle_time_us), dimension.target, value


def _span(dimension: Dimension, cycle_time_us: int) -> tuple[int, int]:
    """Return the begin of a course of values in microseconds, and its length in ticks."""
    begin_us = 0 if dimension.at is None else dimension.at.us(cycle_time_us)
    assert dimension.duration is not None
    return begin_us, dimension.duration.ticks(cycle_time_us)


def command_of(plan: Plan, inputs: RunInputs) -> str | None:
    """Return the command that makes this run; ``None`` if there is no option for its inputs.

    The same if the command would be unreadable: with more than ``MAX_STIMULI`` values at times.
    """
    if plan.is_schedule or plan.text is not None or inputs.needs_tape:
        return None
    if len(inputs.stimuli) > MAX_STIMULI:
        return None
    words = ["nctakt", "run", str(plan.program)]
    if plan.machine is not None:
        words += ["--machine", str(plan.machine)]
    for plc in plan.plcs or ((DEFAULT_PLC,) if plan.names_default_plc else ()):
        words += ["--plc", str(plc)]
    for name, value in inputs.assignments.items():
        words += ["--set", assignment_text(name, value)]
    for time, name, value in inputs.stimuli:
        words += ["--at", str(time).replace(" ", ""), assignment_text(name, value)]
    for option, path in (
        ("--rtconf", inputs.schedule.rtconf or plan.rtconf),
        ("--load", inputs.schedule.load or plan.load),
    ):
        if path is not None:
            words += [option, str(path)]
    if plan.rtconf is not None:
        words += ["--os", plan.system]
    if plan.until is not None:
        words += ["--until", str(plan.until).replace(" ", "")]
    if plan.after.count:
        words += ["--after", str(plan.after).replace(" ", "")]
    for name, chosen in plan.further:
        row = BY_NAME[name]
        words += command_words(row, row.kind.to_words(chosen))
    return shlex.join(words)

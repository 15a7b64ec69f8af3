# SPDX-License-Identifier: MIT
"""The runner of a worker: machine and program, loaded once, on which the runs of a plan are made.

In: a plan. Out: the row of each run: inputs, measures, verdict, digest. A run depends on its inputs
alone, so that rows are the same no matter which process makes them, and in which order.
"""

from __future__ import annotations

import re
from collections import OrderedDict
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import FAULTS_OF_STRUCTURED_PLC, UNKNOWN_PROGRAM_VARIABLE
from nctakt.nc.parse.lexer import without_comments
from nctakt.plc.loading import plc_file
from nctakt.results.coverage import Coverage
from nctakt.results.coverage_files import as_json
from nctakt.run.access.tape import TapeWriter
from nctakt.run.beginning import Beginning, Beginnings, may_share
from nctakt.run.controller import Controller, NcText
from nctakt.run.options import RunKeywords, merged
from nctakt.run.plcs.plc_view import AnyPlc
from nctakt.run.plcs.realtime_plc import files_of as structured_files
from nctakt.run.plcs.realtime_plc import is_structured, plc_object
from nctakt.run.program_loader import AnyProgram, LoadedProgram
from nctakt.run.realtime.realtime_parts import MACHINES, RealtimeParts
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.studies.measuring.measure_nodes import reaction_time
from nctakt.studies.measuring.measures import Expectation
from nctakt.studies.measuring.outcome import Outcome
from nctakt.studies.measuring.python_measure import PythonMeasure
from nctakt.studies.measuring.window import Injection
from nctakt.studies.plans.changed_lists import changed_machine
from nctakt.studies.plans.changed_schedule import ScheduleChanges, ScheduleFiles
from nctakt.studies.plans.dimension import Value
from nctakt.studies.plans.faults import FaultyPlc
from nctakt.studies.plans.inputs import RunInputs, inputs_of
from nctakt.studies.plans.plan import COVERAGE, Plan
from nctakt.studies.plans.schedule_measures import problems_of_numbers
from nctakt.studies.plans.units import REACTION, units_of
from nctakt.studies.runs.begun_run import BegunRun, Digest, FinishedRun

#: Parameters of the lists that a run changes, with their values.
Parameters = tuple[tuple[tuple[str, str], float | str], ...]

#: A row of the results: name -> number, text or ``None``.
Row = dict[str, float | int | str | None]

#: Verdicts of a run: all expectations met, some not met, not possible, process died.
PASSED, FAILED, REFUSED, CRASHED = "passed", "failed", "refused", "crashed"
#: Verdicts in files of earlier versions, whose ``failed`` was a run that is not possible.
EARLIER_VERDICTS = {"held": PASSED, "broken": FAILED}


#: The state of a run that was left as soon as its expectations were decided.
DECIDED = "decided"


class StudyRunner:
    """Machine and program of a plan; ``access`` notes the files that are read.

    Raises ``Failure`` for a machine or a program that cannot be read, and for each name of the plan
    that they do not have.
    """

    def __init__(self, plan: Plan, access: FileAccess | None = None) -> None:
        self.plan = plan
        self.access = access = access or FileAccess()
        self.machine = load_machine(plan.machine, access=access)
        self._schedule_files = (
            None if plan.rtconf is None else ScheduleFiles(plan.rtconf, plan.load, plan.system)
        )
        self._schedules: OrderedDict[object, RunSchedule] = OrderedDict()
        text = plan.text
        self._text = "\n".join(access.read_lines(plan.program)) if text is None else text
        self._plc_files = [plc_file(one) for one in plan.plcs]
        if self._has_structured:
            for file in structured_files(self._plc(RunInputs())):
                access.note(Path(file))
        self._machines: OrderedDict[Parameters, Machine] = OrderedDict()
        #: The program as checked for a machine.
        self._loaded: dict[Parameters, LoadedProgram] = {}
        self._speaks_of_errors = plan.speaks_of_errors
        self._may_share = may_share(merged(plan.options, {}))
        self._parts = RealtimeParts()
        self._beginnings: Beginnings[Controller] = Beginnings()
        self._asks_all = any(isinstance(one.node, PythonMeasure) for one in plan.measures)
        reactions = (expected.reaction for expected in plan.expectations)
        self._reactions = tuple(one for one in reactions if one is not None)
        controller = self._controller(RunInputs())
        self.cycle_time_us = controller.cycle_time_us
        self._window_us = plan.window_us(self.cycle_time_us)
        self.signals = self._signals(controller)
        self.units = units_of(plan, lambda name: _unit(controller, name))

    def _signals(self, controller: Controller) -> tuple[str, ...]:
        """Return the signals that measures read; an axis means its command position."""
        axes = {axis.name for axis in controller.channel_axes}
        signals: list[str] = []
        found: list[Diagnostic] = []
        for table, entry, name in self._readers():
            signals.append(_signal_name(name, axes))
            try:
                controller.signal(signals[-1])
            except Failure as failure:
                found += self.plan.placed(failure, table, entry)
        if found:
            raise Failure(*{one.text(): one for one in found}.values())
        return tuple(dict.fromkeys(signals))

    def _readers(self) -> Iterator[tuple[str, str, str]]:
        """Yield the signals read, with table and entry of the plan that read them."""
        for measure in self.plan.measures:
            for name in measure.node.signals():
                yield "measure", measure.name, name
        for expectation in self.plan.expectations:
            for name in expectation.signals:
                yield "expect", expectation.text, name

    def line(self, number: int) -> str:
        """Return a line of the program, from 1."""
        lines = self._text.split("\n")
        return lines[number - 1] if number <= len(lines) else ""

    def check(self) -> None:
        """Raise ``Failure`` for names and values that machine or program do not have."""
        found: list[Diagnostic] = []
        for measure in self.plan.measures:
            try:
                measure.check()
            except Failure as failure:
                found += self.plan.placed(failure, "measure", measure.name)
        schedule = self._schedule_of(ScheduleChanges())
        if schedule is not None:
            found += problems_of_numbers(self.plan, schedule.model)
        for number, dimension in enumerate(self.plan.dimensions):
            for value in dimension.probes():
                inputs = RunInputs()
                inputs.add(dimension, value, self.cycle_time_us)
                found += self._wrong_inputs(inputs, "vary", number)
        for name, value in self.plan.assignments:
            found += self._wrong_inputs(RunInputs({name: value}), "set", name)
        found += self._wrong_inputs(RunInputs({}, list(self.plan.stimuli)), "", "at")
        try:
            self._plc(RunInputs())
        except Failure as failure:
            found += failure.diagnostics
        if found:
            raise Failure(*{one.text(): one for one in found}.values())

    def _wrong_inputs(self, inputs: RunInputs, table: str, entry: str | int) -> list[Diagnostic]:
        """Return the mistakes in the inputs of an entry of the plan."""
        try:
            controller = self._controller(inputs)
            self.program_of(inputs, controller)
            for name, value in inputs.assignments.items():
                controller.write(name, value)
            for _, name, value in inputs.stimuli:
                controller.write(name, value)
        except Failure as failure:
            return self.plan.placed(failure, table, entry)
        return []

    # --- one run ---------------------------------------------------------------------------------

    def row(self, index: int) -> Row:
        """Return the row of a run by its number."""
        point = self.plan.point(index)
        return self.row_of(index, point)

    def row_of(self, index: int, point: Sequence[Value], *, covers: bool = False) -> Row:
        """Return the row of a run with these values.

        ``covers``: of the whole run, with the counts of its branches (``COVERAGE``).
        """
        row = self.row_head(index, point)
        try:
            finished = self.cover(point) if covers else self.make(point)
        except Failure as failure:
            row |= {measure.name: None for measure in self.plan.measures}
            heads = (_without_folder(one).headline().splitlines() for one in failure.diagnostics)
            texts = "; ".join(dict.fromkeys(head[0] for head in heads))
            return row | {"verdict": REFUSED, "broken": texts, "seed": self.plan.seed, "digest": ""}
        if covers:
            row[COVERAGE] = as_json(finished.outcome.run.coverage or Coverage())
        return row | self.judge(finished)

    def row_head(self, index: int, point: Sequence[Value]) -> Row:
        """Return the begin of a row: the number of the run and its inputs."""
        row: Row = {"run": index}
        for dimension, value in zip(self.plan.dimensions, point, strict=True):
            row[dimension.name] = dimension.shown(value)
        return row

    def judge(self, finished: FinishedRun) -> Row:
        """Return measures, verdict and digest of a run."""
        plan, outcome = self.plan, finished.outcome
        row: Row = {measure.name: measure.value(outcome) for measure in plan.measures}
        broken = self.broken(outcome, plan.expectations)
        if self._reactions:
            row[REACTION] = reaction_time(self._reactions[0], outcome)
        return row | {
            "state": DECIDED if outcome.run.state == "interrupted" else outcome.run.state,
            "ticks": outcome.run.ticks,
            "verdict": FAILED if broken else PASSED,
            "broken": "; ".join(broken),
            "seed": plan.seed,
            "digest": finished.digest,
        }

    def broken(self, outcome: Outcome, expectations: Sequence[Expectation]) -> list[str]:
        """Return the broken expectations of a run with actual values, and unexpected errors."""
        broken = [one.broken(outcome) for one in expectations if not one.is_met(outcome)]
        if not self._speaks_of_errors:
            broken += dict.fromkeys(f"error {found.id}" for found in outcome.run.errors)
        return broken

    def make(self, point: Sequence[Value]) -> FinishedRun:
        """Make the run with these values, up to where it is decided; raises ``Failure``."""
        injected_us = self.plan.injection_us(point)
        begun = self.begin(inputs_of(self.plan, point, self.cycle_time_us))
        return begun.finish(injected_us, self.injection(injected_us))

    def cover(self, point: Sequence[Value]) -> FinishedRun:
        """Make the run with these values to its end, with its coverage; raises ``Failure``."""
        injected_us = self.plan.injection_us(point)
        return self.begin(inputs_of(self.plan, point, self.cycle_time_us), why=True).finish(
            injected_us
        )

    def injection(self, injected_us: int | None) -> Injection | None:
        """Return the injection at a time; ``None`` if its run is decided only at its end."""
        window_us = self._window_us
        if injected_us is None or window_us is None:
            return None
        return Injection(
            injected_us,
            -(-injected_us // self.cycle_time_us),
            -(-(injected_us + window_us) // self.cycle_time_us) + 1,
            self.cycle_time_us,
            self._reactions,
        )

    def begin(
        self,
        inputs: RunInputs,
        *,
        blocks: bool = False,
        why: bool = False,
        draws: bool = False,
        tape: TapeWriter | None = None,
    ) -> BegunRun:
        """Begin a run with these inputs.

        ``blocks``: with the events of its blocks; ``why``: with the histories of its conditions;
        ``draws``: with the signals of a picture; ``tape``: records it.
        """
        if not (blocks or why or tape):
            again = self._begun_again(inputs)
            if again is not None:
                return again
        machine = self._machine_with(inputs.parameters)
        schedule = self._schedule_of(inputs.schedule)
        lent = None if schedule is not None else self._parts.lend(machine)
        part = None if lent is None else lent.part
        controller = Controller(machine, schedule, self.access, part)
        program = self.program_of(inputs, controller)
        digest = Digest()
        drawn = controller.motion_signals if draws else ()
        further: RunKeywords = {
            "set": inputs.assignments,
            "at": inputs.stimuli,
            "plc": self._plc(inputs),
            "signals": (*dict.fromkeys((*self.signals, *drawn)),),
            "sinks": (digest,) if tape is None else (digest, tape),
            "blocks": blocks,
            "why": why,
            "record": None if tape is None else tape.note,
        }
        statistics = why or schedule is not None or self._asks_all
        options = merged(self.plan.options, further)
        run = controller.begin({1: (program,)}, statistics=statistics, **options)
        return BegunRun(controller, run, inputs, digest, lent)

    def _begun_again(self, inputs: RunInputs) -> BegunRun | None:
        """Begin a run where others with these lists and this text have begun, if that is possible.

        Apart from them it depends on values, times and sinks.
        """
        if self._has_structured or self._schedule_files is not None:
            return None
        if inputs.program_variables or self._asks_all or not self._may_share:
            return None
        lists = tuple(inputs.parameters.items())
        beginning = self._beginnings.of(lists, lambda: self._beginning(inputs))
        if beginning is None:
            return None
        digest = Digest()
        run = beginning.begin(
            {
                "set": inputs.assignments,
                "at": inputs.stimuli,
                "plc": self._plc(inputs),
                "sinks": (digest,),
            }
        )
        if run is None:
            return None
        return BegunRun(beginning.controller, run, inputs, digest, beginning)

    def _beginning(self, inputs: RunInputs) -> Beginning[Controller]:
        """Return the beginning of the runs with the same lists."""
        machine = self._machine_with(inputs.parameters)
        lent = self._parts.lend(machine)
        program = self.program_of(inputs, Controller(machine, None, self.access, lent.part))
        assert isinstance(program, LoadedProgram)
        return Beginning(
            lambda part: Controller(machine, None, self.access, part),
            lent,
            program,
            merged(self.plan.options, {"signals": self.signals}),
            keeps_results=False,
        )

    def _controller(self, inputs: RunInputs) -> Controller:
        """Return a controller with machine, schedule and the PLC's variables of a run."""
        machine = self._machine_with(inputs.parameters)
        controller = Controller(machine, self._schedule_of(inputs.schedule), self.access)
        if self._has_structured:
            names = [name for _, _, name in self._readers()]
            controller.attach(self._plc(inputs), names)
        return controller

    def _schedule_of(self, changes: ScheduleChanges) -> RunSchedule | None:
        """Return the schedule with these changes, read once; ``None`` without one."""
        if self._schedule_files is None:
            return None
        schedule = self._schedules.get(changes.key) or self._schedule_files.schedule(
            changes, self.access
        )
        self._schedules[changes.key] = schedule
        self._schedules.move_to_end(changes.key)
        if len(self._schedules) > MACHINES:
            self._schedules.popitem(last=False)
        return schedule

    def _machine_with(self, parameters: Mapping[tuple[str, str], float | str]) -> Machine:
        """Return the machine with these parameters; those used last are kept."""
        if not parameters:
            return self.machine
        key = tuple(parameters.items())
        machine = self._machines.get(key) or changed_machine(self.machine, parameters)
        self._machines[key] = machine
        self._machines.move_to_end(key)
        if len(self._machines) > MACHINES:
            self._loaded.pop(self._machines.popitem(last=False)[0], None)
        return machine

    def program_of(self, inputs: RunInputs, controller: Controller) -> AnyProgram:
        """Return the program of a run: the unchanged one is checked once for each machine.

        With program variables, their first assignments have these values.
        """
        values = inputs.program_variables
        key = tuple(inputs.parameters.items())
        if not values and key in self._loaded:
            return self._loaded[key]
        source = NcText(str(self.plan.program), self.text_with(values))
        if values:
            return source
        self._loaded[key] = controller.load(source)
        return self._loaded[key]

    def text_with(self, values: Mapping[str, float | str]) -> str:
        """Return the text of the program in which the first assignments have these values.

        Raises ``Failure`` (901313) for a variable that gets no plain number.
        """
        lines = self._text.split("\n")
        for name, value in values.items():
            found = _assignment_of(name, lines)
            if found is None:
                raise Failure(diagnostic(UNKNOWN_PROGRAM_VARIABLE, name=name))
            number, begin, end = found
            shown = value if isinstance(value, str) else f"{Decimal(repr(value)):f}"
            lines[number] = f"{lines[number][:begin]}{shown}{lines[number][end:]}"
        return "\n".join(lines)

    def _plc(self, inputs: RunInputs) -> AnyPlc | None:
        """Return the PLCs of a run as one; raises ``Failure`` for faults of Structured Text."""
        plc = plc_object([one.plc() for one in self._plc_files])
        if not inputs.faults:
            return plc
        for file in filter(is_structured, self.plan.plcs):
            raise Failure(diagnostic(FAULTS_OF_STRUCTURED_PLC, file=str(file)))
        return FaultyPlc(plc, inputs.faults)

    @property
    def _has_structured(self) -> bool:
        """Whether a PLC in Structured Text runs, which restarts with each run."""
        return any(map(is_structured, self.plan.plcs))


def _signal_name(name: str, axes: Collection[str]) -> str:
    """Return the signal of a name in a measure: an axis means its command position."""
    return f"{name}.ACS.ACT_POS" if name in axes else name


def _unit(controller: Controller, name: str) -> str:
    """Return the unit of a signal; empty for anything else, such as a variable of the program."""
    axes = {axis.name for axis in controller.channel_axes}
    try:
        return controller.unit(_signal_name(name, axes))
    except Failure:
        return ""


def _assignment_of(name: str, lines: Sequence[str]) -> tuple[int, int, int] | None:
    """Return where a variable first gets a plain number: index of the line, begin, end."""
    pattern = rf"(?<![\w.]){re.escape(name)}[ \t]*=[ \t]*([+-]?(?:\d+\.?\d*|\.\d+))"
    assignment = re.compile(rf"{pattern}(?![\w.]|[ \t]*[-+*/])", re.IGNORECASE)
    for index, line in enumerate(lines):
        match = assignment.search(without_comments(line))
        if match is not None:
            return index, match.start(1), match.end(1)
    return None


def _without_folder(found: Diagnostic) -> Diagnostic:
    """Return a diagnostic with the name of its file: elsewhere it lies in another folder."""
    if found.span is None:
        return found
    return replace(found, span=replace(found.span, file=Path(found.span.file).name))


def columns_of(plan: Plan) -> list[str]:
    """Return the names of the columns of a row, in their order."""
    return [
        "run",
        *(dimension.name for dimension in plan.dimensions),
        *(measure.name for measure in plan.measures),
        *([REACTION] if any(one.reaction for one in plan.expectations) else []),
        "state", "ticks", "verdict", "broken", "seed", "digest",
    ]  # fmt: skip


def crashed_row(plan: Plan, index: int, point: Sequence[Value] | None = None) -> Row:
    """Return the row of a run whose process died; ``point``: its values if searched."""
    row: Row = dict.fromkeys(columns_of(plan))
    point = plan.point(index) if point is None else point
    values: dict[str, Any] = {
        dimension.name: dimension.shown(value)
        for dimension, value in zip(plan.dimensions, point, strict=True)
    }
    return row | values | {"run": index, "verdict": CRASHED, "broken": "", "seed": plan.seed}

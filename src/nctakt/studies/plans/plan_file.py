# SPDX-License-Identifier: MIT
"""A plan's file (TOML) -> ``Plan``, checked entry by entry.

Names of machine and program are checked by ``StudyRunner.check``; here are the words of the plan
itself. Each mistake has its line; all are reported at once.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.files.access import FileAccess, is_file_or_folder
from nctakt.files.toml_text import TomlError, read_toml
from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.format.times import Time, read_time
from nctakt.lists.machine.files import machine_folder
from nctakt.lists.machine.machine import load_machine
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES
from nctakt.messages import Collector, diagnostic
from nctakt.messages.commands.project import PLAN_NOT_TRUSTED
from nctakt.messages.commands.studies import EMPTY_STUDY, INVALID_PLAN, NAME_TAKEN
from nctakt.project.run_settings import DEFAULT_PLC, Named, RunSettings, run_settings
from nctakt.project.trust import list_of_trusted, why_distrusted
from nctakt.run.access.stimuli import parse_assignment
from nctakt.run.option_kinds import UnfitDataError
from nctakt.run.options import RUN_OPTIONS, accepted_by
from nctakt.run.program_loader import NcText
from nctakt.studies.measuring.measure_nodes import Constant, Node
from nctakt.studies.measuring.measure_text import Reader
from nctakt.studies.measuring.measures import Expectation, Measure, read_expectation, read_measure
from nctakt.studies.measuring.python_measure import PythonMeasure
from nctakt.studies.plans.changed_schedule import FAMILY
from nctakt.studies.plans.plan import (
    DESIGNS,
    MAX_DESIGN,
    METHODS,
    RESERVED,
    Entry,
    Goal,
    GoalWord,
    Place,
    Plan,
)
from nctakt.studies.plans.plan_dimensions import DimensionReader
from nctakt.studies.plans.plan_reader import (
    FILE,
    LIST,
    NAME,
    NUMBER_OR_TEXT,
    TABLE,
    TEXT,
    THE_PLAN,
    PlanReader,
    is_name,
    is_value,
    one_of,
)
from nctakt.studies.plans.schedule_measures import ScheduledProgramReader, ScheduleReader

#: The run options of a plan other than those with a special meaning here.
_FURTHER = tuple(
    option
    for option in accepted_by("plan")
    if option in RUN_OPTIONS and option.name not in ("plc", "until", "after", "set", "at")
)

_TOP = (
    "program", "machine", "plc", "rtconf", "load", "os", "method", "count", "seed", "until",
    "after", "set", "at", "vary", "measure", "expect", "find",
    *(option.name for option in _FURTHER),
)  # fmt: skip
_GOALS: tuple[GoalWord, ...] = ("minimize", "maximize", "boundary", "pareto")
_STIMULUS = Text('["20 ms", "V.E.DOOR = 1"]', '["20 ms", "V.E.DOOR = 1"]')
_DESIGN = Text(
    f"at most {MAX_DESIGN} with this method (random takes any)",
    f"bei diesem Verfahren höchstens {MAX_DESIGN} (random nimmt jede Zahl)",
)
_TWO_OBJECTIVES = Text("two different measures or more", "zwei verschiedene Messgrößen oder mehr")
_WITH_PROGRAM = Text("left out without a program", "ohne Programm weggelassen")


def read_plan(path: Path, default_machine: Path | None = None) -> Plan:
    """Return the plan of a file; paths in it are relative to its folder.

    ``default_machine``: that of a plan that names none, before the project's.

    Raises one ``Failure`` with all mistakes: not TOML (901300), unknown entries (901301), values
    (901302), missing entries (901303), measures (901306), expectations (901307), names that are
    taken (901390), times (900510), assignments (900511, 900512), code that may be somebody else's
    (902970); for a file that cannot be read as ``FileAccess.read_bytes``.
    """
    text = decode_text(FileAccess().read_bytes(path)).text
    try:
        tables = read_toml(path.as_posix(), text)
    except TomlError as error:
        found = diagnostic(INVALID_PLAN, error.span, error.line, reason=str(error))
        raise Failure(found) from error
    lines = text.splitlines()
    plan = read_tables(tables, path.parent, path.as_posix(), lines, default_machine)
    return replace(plan, source=text)


def read_tables(
    tables: dict[str, Any],
    folder: Path,
    file: str = "",
    lines: Sequence[str] = (),
    default_machine: Path | None = None,
) -> Plan:
    """Return the plan of tables; ``file`` and ``lines``: where they are, for messages."""
    reader = _Reader(folder, file, lines)
    reader.default_machine = default_machine
    plan = reader.plan(tables)
    if reader.diagnostics:
        raise Failure(*sorted(reader.diagnostics, key=_line_of))
    return plan


def _line_of(found: Diagnostic) -> int:
    return 0 if found.span is None else found.span.line


_DRAWN = Text(
    "left out with this method (random, latin or sobol draw values)",
    "bei diesem Verfahren weggelassen (random, latin oder sobol ziehen Werte)",
)


def _as_many(count: int, name: str) -> Text:
    return Text(
        f"a list of {count} values, as for {name}", f"eine Liste von {count} Werten wie bei {name}"
    )


class _Reader(PlanReader):
    """Reads the tables of one plan."""

    default_machine: Path | None = None
    _program = Path()
    _settings: RunSettings | None = None
    _rtconf: Path | None = None
    _tick: int | None = None
    _words: type[Reader] = Reader

    def plan(self, tables: dict[str, Any]) -> Plan:
        self.check_keys(tables, _TOP, "", 0)
        source = tables.get("program")
        text = source.text if isinstance(source, NcText) else None
        program = Path(source.name) if isinstance(source, NcText) else self._path(tables, "program")
        machine, plcs = self._path(tables, "machine"), self._plcs(tables)
        rtconf, load = self._path(tables, "rtconf"), self._path(tables, "load")
        self._check_entries(tables)
        self._program, self._rtconf = program or Path(), rtconf
        is_schedule = "program" not in tables and "rtconf" in tables
        values, until = self._values(tables.get("set", {})), self.length(tables, "until")
        if program is not None:
            machine_word = machine or self.default_machine
            self._take_settings(Named(machine=machine_word, plcs=plcs, values=values, until=until))
        settings = self._settings
        if rtconf is not None:
            self._words = ScheduleReader if is_schedule else ScheduledProgramReader
        measures, known = self._measures(tables.get("measure", {}))
        method = self.choice(tables, "method", METHODS)
        count = self.whole(tables, "count", 0)
        if method in DESIGNS and count > MAX_DESIGN:
            self.wrong("count", count, _DESIGN)
        dimensions = DimensionReader(self, self._tick_us, self._slice_us).dimensions(
            tables.get("vary", [])
        )
        plan = Plan(
            rtconf or Path() if is_schedule else self._program,
            machine if settings is None else settings.machine,
            () if settings is None else settings.plcs,
            dimensions,
            measures,
            self._expectations(tables.get("expect", []), known),
            method,
            count,
            self.whole(tables, "seed", 0, 0),
            until if settings is None or settings.until is None else read_time(settings.until),
            self.time(tables, "after") or Time(0),
            tuple({**({} if settings is None else settings.values), **values}.items()),
            self._stimuli(tables.get("at", [])),
            self._goals(
                tables.get("find", []), known, [dimension.name for dimension in dimensions]
            ),
            text,
            rtconf,
            load,
            self.choice(tables, "os", list(PROFILES)),
            is_schedule,
            plcs == (Path(DEFAULT_PLC),),
            tuple(self._further(tables)),
        )
        plan = replace(plan, places=self._places(plan))
        self._check_trusted(plcs, plan.measures)
        self._check_names(plan)
        self._check_kinds(plan)
        self._check_distributions(plan)
        if not self.diagnostics:
            self._check_size(plan)
        return plan

    def _check_entries(self, tables: dict[str, Any]) -> None:
        """Note entries missing next to others, and entries that belong to a program only."""
        if "program" not in tables and "rtconf" not in tables:
            self.missing("program", THE_PLAN)
        if ("load" in tables or "os" in tables) and "rtconf" not in tables:
            self.missing("rtconf", THE_PLAN)
        if "program" not in tables:
            further = (option.name for option in _FURTHER)
            for key in ("machine", "plc", "after", "set", "at", *further):
                if key in tables:
                    self.wrong(key, tables[key], _WITH_PROGRAM)

    def _check_distributions(self, plan: Plan) -> None:
        """Note distributions of methods that take all values of a grid or of lists."""
        if plan.method in ("grid", "list"):
            for number, dimension in enumerate(plan.dimensions):
                if dimension.distribution is not None:
                    self.wrong("distribution", plan.method, _DRAWN, "vary", number)

    def _check_size(self, plan: Plan) -> None:
        """Note a plan without runs (901304), and lists with unequal numbers of values."""
        dimensions = list(enumerate(plan.dimensions))
        if plan.goals:
            empty = [(number, one.name) for number, one in dimensions if one.is_empty]
        elif plan.method in ("grid", "list"):
            empty = [(number, one.name) for number, one in dimensions if one.count == 0]
        else:
            empty = [] if plan.count else [(0, "count")]
        for number, name in empty[:1]:
            self.report(diagnostic(EMPTY_STUDY, name=name), self.location("", "vary", number))
        if empty or plan.method != "list":
            return
        for number, one in dimensions:
            count = plan.dimensions[0].count
            if one.count != count:
                expected = _as_many(count, plan.dimensions[0].name)
                self.wrong("values", one.count, expected, "vary", number)

    def _check_trusted(self, plcs: Sequence[Path], measures: Sequence[Measure]) -> None:
        """Note code that the plan's file names, and that may be somebody else's (902970)."""
        if not self._file:
            return  # the tables belong to a program
        code = [(path, "plc", "") for path in plcs if path != Path(DEFAULT_PLC)]
        for measure in measures:
            if isinstance(measure.node, PythonMeasure):
                code.append((measure.node.file, measure.name, "measure"))
        for path, key, table in code:
            reason = why_distrusted((Path(self._file), path), self.folder)
            if reason is not None:
                found = diagnostic(
                    PLAN_NOT_TRUSTED,
                    key=key,
                    reason=reason,
                    folder=str(self.folder.absolute()),
                    list=str(list_of_trusted()),
                )
                self.report(found, self.location(key, table, 0))

    def _places(self, plan: Plan) -> dict[Entry, Place]:
        """Return the places of entries whose names machine and program must know."""
        keys: list[tuple[str, str, str | int]] = [
            (dimension.kind, "vary", number) for number, dimension in enumerate(plan.dimensions)
        ]
        keys += [(name, "set", name) for name, _ in plan.assignments]
        keys += [("at", "", "at")]
        places: dict[Entry, Place] = {
            (table, entry): self.location(key, table, entry if isinstance(entry, int) else 0)
            for key, table, entry in keys
        }
        for measure in plan.measures:
            own = self.location_of_text(measure.text, measure.name, "measure")
            places["measure", measure.name] = own
        for one in plan.expectations:
            places["expect", one.text] = self.location_of_text(one.text, "expect", "")
        if self._settings is not None and self._settings.project is not None:
            of_project = self._settings.project.places
            places |= {("set", name): of_project[name] for name in self._settings.values}
        return places

    # --- entries ---------------------------------------------------------------------------------

    def _path(self, table: dict[str, Any], key: str) -> Path | None:
        value = table.get(key)
        if value is None or key != "machine" or not isinstance(value, str) or not value:
            return None if key not in table else self.existing(value, key)
        path = machine_folder(value, self.folder)
        if not is_file_or_folder(path):
            self.wrong(key, value, FILE)
        return path

    def _plcs(self, tables: dict[str, Any]) -> tuple[Path, ...]:
        """Return the files of the PLCs, or the word for the built-in one."""
        value = tables.get("plc")
        if value == DEFAULT_PLC and not is_file_or_folder(self.folder / DEFAULT_PLC):
            return (Path(DEFAULT_PLC),)
        given = value if isinstance(value, list | tuple) else [] if value is None else [value]
        return tuple(path for one in given if (path := self.existing(one, "plc")) is not None)

    def _further(self, tables: dict[str, Any]) -> Iterator[tuple[str, Any]]:
        """Yield the further run options that the plan has, each with its value."""
        for option in _FURTHER:
            if option.name not in tables:
                continue
            try:
                value = option.kind.from_data(tables[option.name])
                option.kind.check(option.name, value)
            except UnfitDataError as error:
                self.wrong(option.name, tables[option.name], error.expected)
            except Failure as failure:
                for found in failure.diagnostics:
                    self.report(found, self.location(option.name, "", 0))
            else:
                yield option.name, value

    def _take_settings(self, named: Named) -> None:
        """Take entries missing from the plan from the project of its program."""
        try:
            self._settings = run_settings([self._program], FileAccess(), named)
        except Failure as failure:
            self.diagnostics += failure.diagnostics

    def _values(self, table: Any) -> dict[str, float | str]:
        if not isinstance(table, dict):
            self.wrong("set", table, TABLE)
            return {}
        values = {
            name: int(value) if value is True or value is False else value
            for name, value in table.items()
        }
        for name, value in values.items():
            if not is_value(value):
                self.wrong(str(name), value, NUMBER_OR_TEXT, "set")
        return values

    def _stimuli(self, entries: Any) -> tuple[tuple[Time, str, float | str], ...]:
        """Return the values at times of all runs: ``at = [["20 ms", "V.E.DOOR = 1"]]``."""
        if not isinstance(entries, list | tuple):
            self.wrong("at", entries, LIST)
            return ()
        stimuli = []
        for entry in entries:
            is_pair = isinstance(entry, list | tuple) and len(entry) == 2
            if not is_pair or not isinstance(entry[1], str):
                self.wrong("at", entry, _STIMULUS)
                continue
            time = self.tried("at", "", 0, read_time, entry[0])
            assignment = self.tried("at", "", 0, parse_assignment, entry[1])
            if time is not None and assignment is not None:
                stimuli.append((time, *assignment))
        return tuple(stimuli)

    def _measures(self, table: Any) -> tuple[tuple[Measure, ...], dict[str, Node]]:
        """Return the measures, and the meaning of their names in further texts."""
        if not isinstance(table, dict):
            self.wrong("measure", table, TABLE)
            return (), {}
        measures: list[Measure] = []
        known: dict[str, Node] = {}
        for name, text in table.items():
            if not isinstance(text, str) or not is_name(name):
                wrong = (text, TEXT) if is_name(name) else (name, NAME)
                self.wrong(name, *wrong, "measure")
                continue
            words = (name, text, dict(known), self.folder, self._words)
            measure = self.read(text, name, "measure", read_measure, *words)
            if measure is not None:
                measures.append(measure)
            known[name] = Constant(0) if measure is None else measure.node  # reported once
        return tuple(measures), known

    def _expectations(self, entries: Any, known: dict[str, Node]) -> tuple[Expectation, ...]:
        entries = [entries] if isinstance(entries, str) else entries
        is_list = isinstance(entries, list | tuple)
        if not is_list or not all(isinstance(one, str) for one in entries):
            self.wrong("expect", entries, LIST)
            return ()
        found = [
            self.read(one, "expect", "", read_expectation, one, known, self._words)
            for one in entries
        ]
        return tuple(one for one in found if one is not None)

    def _goals(
        self, entries: Any, known: dict[str, Node], dimensions: Sequence[str]
    ) -> tuple[Goal, ...]:
        goals: list[Goal] = []
        for number, entry in enumerate(self.tables(entries, "find")):
            self.check_keys(entry, (*_GOALS, "budget"), "find", number)
            budget = self.whole(entry, "budget", 100, 1, "find", number)
            words = [word for word in _GOALS if word in entry]
            if not words:
                self.missing(" / ".join(_GOALS), f"find {number + 1}", number, "find")
            for word in words:
                if word == "pareto":
                    goals += self._pareto(entry[word], list(known), budget, number)
                    continue
                name, names = entry[word], dimensions if word == "boundary" else list(known)
                if not isinstance(name, str) or name not in names:
                    self.wrong(word, name, one_of(names), "find", number)
                elif not dimensions:
                    self.missing("vary", THE_PLAN)
                else:
                    goals.append(Goal(word, name, budget))
        return tuple(goals)

    def _pareto(self, entry: Any, names: Sequence[str], budget: int, number: int) -> list[Goal]:
        """Return the goal with several objectives, such as ``["minimize a", "maximize b"]``."""
        texts = entry if isinstance(entry, list) else [entry]
        several = []
        for text in texts:
            word, _, name = text.partition(" ") if isinstance(text, str) else ("", "", "")
            if word not in ("minimize", "maximize") or name.strip() not in names:
                forms = [f"{verb} {one}" for one in names for verb in ("minimize", "maximize")]
                self.wrong("pareto", text, one_of(forms), "find", number)
                return []
            several.append((word, name.strip()))
        if len(several) < 2 or len({name for _, name in several}) < len(several):
            self.wrong("pareto", entry, _TWO_OBJECTIVES, "find", number)
            return []
        return [Goal("pareto", ", ".join(map(str, texts)), budget, tuple(several))]

    def _check_kinds(self, plan: Plan) -> None:
        """Note dimensions of a schedule without one, and those of a program without one."""
        for number, dimension in enumerate(plan.dimensions):
            of_schedule = dimension.kind in ("load_entry", "rtconf", "load")
            of_schedule |= dimension.kind == "parameter" and dimension.target.startswith(FAMILY)
            if of_schedule and plan.rtconf is None:
                self.missing("rtconf", THE_PLAN)
            elif plan.is_schedule and not of_schedule:
                self.wrong(dimension.kind, dimension.target, _WITH_PROGRAM, "vary", number)

    def _check_names(self, plan: Plan) -> None:
        """Note each name of a dimension or a measure that another column has already (901390)."""
        taken = set(RESERVED)
        for number, dimension in enumerate(plan.dimensions):
            self._check_name(dimension.name, taken, "name", "vary", number)
        for measure in plan.measures:
            self._check_name(measure.name, taken, measure.name, "measure", 0)

    def _check_name(self, name: str, taken: set[str], key: str, table: str, number: int) -> None:
        if name in taken:
            self.report(diagnostic(NAME_TAKEN, name=name), self.location(key, table, number))
        taken.add(name)

    # --- lengths ---------------------------------------------------------------------------------

    def _tick_us(self) -> int:
        """Return the length of a tick of the machine, for times in ticks; 1 ms without one."""
        if self._tick is None:
            with contextlib.suppress(Failure):
                if self._rtconf is not None:
                    self._tick = self._configuration().cycle_time_us
                elif self._settings is not None:
                    self._tick = load_machine(self._settings.machine).cycle_time_us
        return self._tick or 1000

    def _slice_us(self) -> int:
        """Return the distance of the timer interrupts; raises ``Failure`` without a list."""
        if self._rtconf is None:
            self.missing("rtconf", THE_PLAN)
            return 1
        with contextlib.suppress(Failure):
            return self._configuration().time_slice_us
        return 1

    def _configuration(self) -> RtconfConfiguration:
        assert self._rtconf is not None
        data = FileAccess().read_bytes(self._rtconf)
        return load_rtconf(str(self._rtconf), data, Collector())

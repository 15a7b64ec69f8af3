# SPDX-License-Identifier: MIT
"""A plan's file (TOML) -> ``Plan``, checked entry by entry.

Names of machine and program are checked by ``Bench.check``; here are the words of the plan itself.
Each mistake has its line; all are reported at once.
"""

from __future__ import annotations

import contextlib
import re
import tomllib
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from nctakt.base.diagnostics import NOTHING, Diagnostic, Message, Span, Text, whole_file
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text, nearest
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import Time, read_time
from nctakt.lists.machine.files import machine_folder
from nctakt.lists.machine.machine import load_machine
from nctakt.messages import diagnostic
from nctakt.messages.studies import (
    EMPTY_STUDY,
    INVALID_PLAN,
    INVALID_PLAN_VALUE,
    PLAN_ENTRY_MISSING,
    UNKNOWN_PLAN_ENTRY,
)
from nctakt.project.machine_choice import machine_of
from nctakt.run.program_loader import NcText
from nctakt.run.stimuli import parse_assignment
from nctakt.studies.dimension import END_OF_RUN, TIME_KINDS, Dimension, Kind, Value
from nctakt.studies.measure_nodes import Node
from nctakt.studies.measures import Expectation, Measure, read_expectation, read_measure
from nctakt.studies.plan import METHODS, Goal, Plan

_TOP = (
    "program", "machine", "plc", "method", "count", "seed", "until", "after", "set", "at", "vary",
    "measure", "expect", "find",
)  # fmt: skip
_COMMON = ("name", "values", "from", "to", "step", "nominal")
_WORDS: dict[Kind, tuple[str, ...]] = {
    "variable": ("at", "for", "rest", "over"),
    "time_of": ("for", "rest", "each_tick"),
    "noise": ("at", "for", "rest", "amount"),
    "series": (),
    "acknowledge": (),
    "plc_dies": (),
    "plc_returns": (),
    "parameter": ("of",),
    "program_variable": (),
}
_FIND = ("minimize", "maximize", "boundary", "budget")
_POSITION = re.compile(r" ?\(at line (\d+), column (\d+)\)")
_HEADER = re.compile(r"\s*\[+\s*([\w.]+)\s*\]+")
_NUMBER = Text("a number", "eine Zahl")
_COUNT = Text("a whole number above 0", "eine ganze Zahl über 0")
_TEXT = Text("a text", "ein Text")
_TABLE = Text("a table", "eine Tabelle")
_LIST = Text("a list", "eine Liste")
_FILE = Text("an existing file or folder", "eine vorhandene Datei oder ein vorhandener Ordner")

_T = TypeVar("_T")


def read_plan(path: Path) -> Plan:
    """Return the plan of a file; paths in it are relative to its folder.

    Raises one ``Failure`` with all mistakes: not TOML (901300), unknown entries (901301), values
    (901302), missing entries (901303), measures (901306), expectations (901307), times (900510),
    assignments (900511, 900512); for a file that cannot be read as ``FileAccess.read_bytes``.
    """
    text = decode_text(FileAccess().read_bytes(path)).text
    try:
        tables = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise Failure(_invalid(path, text, str(error))) from error
    return read_tables(tables, path.parent, path.as_posix(), text.splitlines())


def read_tables(
    tables: dict[str, Any], folder: Path, file: str = "", lines: Sequence[str] = ()
) -> Plan:
    """Return the plan of tables; ``file`` and ``lines``: where they stand, for messages."""
    reader = _Reader(folder, file, lines)
    plan = reader.plan(tables)
    if plan is None or reader.diagnostics:
        raise Failure(*sorted(reader.diagnostics, key=_line_of))
    return plan


def _line_of(found: Diagnostic) -> int:
    return 0 if found.span is None else found.span.line


def _invalid(path: Path, text: str, reason: str) -> Diagnostic:
    found, lines = _POSITION.search(reason), text.splitlines()
    span, line = whole_file(path.as_posix()), ""
    if found is not None and int(found[1]) <= len(lines):
        number, column = int(found[1]), int(found[2])
        span, line = Span(path.as_posix(), number, column, column + 1), lines[number - 1]
    return diagnostic(INVALID_PLAN, span, line, reason=_POSITION.sub("", reason))


class _Reader:
    """Reads the tables of one plan; ``diagnostics``: its mistakes."""

    def __init__(self, folder: Path, file: str, lines: Sequence[str]) -> None:
        self._folder = folder
        self._file = file
        self._lines = lines
        self._program = Path()
        self._machine: Path | None = None
        self._tick_us: int | None = None
        self.diagnostics: list[Diagnostic] = []

    def plan(self, tables: dict[str, Any]) -> Plan | None:
        self._check_keys(tables, _TOP, "", 0)
        source = tables.get("program")
        text = source.text if isinstance(source, NcText) else None
        program = Path(source.name) if isinstance(source, NcText) else self._path(tables, "program")
        if "program" not in tables:
            self._missing("program", "the plan", 0)
        machine = self._path(tables, "machine")
        plc = self._path(tables, "plc")
        self._program, self._machine = program or Path(), machine
        measures = self._measures(tables.get("measure", {}))
        known = {measure.name: measure.node for measure in measures}
        method = tables.get("method", "grid")
        if method not in METHODS:
            self._wrong("method", method, Text(f"one of {', '.join(METHODS)}", ", ".join(METHODS)))
        count = self._whole(tables, "count", 0)
        dimensions = self._dimensions(tables.get("vary", []))
        plan = Plan(
            program or Path(),
            machine,
            plc,
            dimensions,
            measures,
            self._expectations(tables.get("expect", []), known),
            method,
            count,
            self._whole(tables, "seed", 0),
            self._time(tables, "until"),
            self._time(tables, "after") or Time(0),
            self._assignments(tables.get("set", {})),
            self._stimuli(tables.get("at", [])),
            self._goals(
                tables.get("find", []), known, [dimension.name for dimension in dimensions]
            ),
            text,
        )
        if not self.diagnostics and plan.size == 0 and not plan.goals:
            empty = [one.name for one in plan.dimensions if one.count == 0]
            name = empty[0] if empty and method in ("grid", "list") else "count"
            self._report(diagnostic(EMPTY_STUDY, name=name), self._location("vary", "", 0))
        return plan

    # --- diagnostics -----------------------------------------------------------------------------

    def _location(self, key: str, table: str, number: int) -> tuple[Span | None, str]:
        """Return the place of an entry of the ``number``-th table of a name."""
        if not self._file:
            return None, ""
        header, count = "", -1
        entry = re.compile(rf'\s*"?{re.escape(key)}"?\s*=')
        fallback: tuple[Span | None, str] = (whole_file(self._file), "")
        for line_number, line in enumerate(self._lines, 1):
            match = _HEADER.match(line)
            if match is not None and "=" not in line:
                header = match[1]
                count += header == table
                if header == table and count == number:
                    fallback = Span(self._file, line_number, 1, len(line) + 1), line
                continue
            if header == table and (not table or count == number) and entry.match(line):
                begin = len(line) - len(line.lstrip()) + 1
                return Span(self._file, line_number, begin, begin + len(key)), line
        return fallback

    def _report(self, found: Diagnostic, location: tuple[Span | None, str]) -> None:
        span, line = location
        self.diagnostics.append(replace(found, span=span, source_line=line) if span else found)

    def _wrong(
        self, key: str, value: object, expected: Text, table: str = "", number: int = 0
    ) -> None:
        message: Message = INVALID_PLAN_VALUE
        found = diagnostic(message, key=key, value=repr(value), expected=expected)
        self._report(found, self._location(key, table, number))

    def _missing(self, key: str, shown: str, number: int, table: str = "") -> None:
        found = diagnostic(PLAN_ENTRY_MISSING, key=key, table=shown)
        self._report(found, self._location(key, table, number))

    def _check_keys(
        self, table: dict[str, Any], names: Sequence[str], header: str, number: int
    ) -> None:
        for key in table:
            if key not in names:
                near = nearest(key, names) or NOTHING
                found = diagnostic(
                    UNKNOWN_PLAN_ENTRY, key=key, nearest=near, names=", ".join(names)
                )
                self._report(found, self._location(key, header, number))

    def _tried(
        self, key: str, table: str, number: int, function: Callable[..., _T], *words: object
    ) -> _T | None:
        """Return the result of a function; ``None`` after a ``Failure``, which is reported."""
        try:
            return function(*words)
        except Failure as failure:
            for found in failure.diagnostics:
                self._report(found, self._location(key, table, number))
            return None

    # --- entries ---------------------------------------------------------------------------------

    def _path(self, table: dict[str, Any], key: str) -> Path | None:
        value = table.get(key)
        if value is None:
            return None
        if not isinstance(value, str) or not value:
            self._wrong(key, value, _TEXT)
            return None
        own = self._folder / value
        path = machine_folder(value, self._folder) if key == "machine" else own
        if not path.exists():
            self._wrong(key, value, _FILE)
        return path

    def _whole(self, table: dict[str, Any], key: str, default: int) -> int:
        value = table.get(key, default)
        if isinstance(value, bool) or not isinstance(value, int) or value < 0:
            self._wrong(key, value, _COUNT)
            return default
        return value

    def _time(
        self, table: dict[str, Any], key: str, header: str = "", number: int = 0
    ) -> Time | None:
        if key not in table:
            return None
        return self._tried(key, header, number, read_time, table[key])

    def _assignments(self, table: Any) -> tuple[tuple[str, float | str], ...]:
        if not isinstance(table, dict):
            self._wrong("set", table, _TABLE)
            return ()
        return tuple(table.items())

    def _stimuli(self, entries: Any) -> tuple[tuple[Time, str, float | str], ...]:
        """Return the values at times of all runs: ``at = [["20 ms", "V.E.DOOR = 1"]]``."""
        if not isinstance(entries, list):
            self._wrong("at", entries, _LIST)
            return ()
        stimuli = []
        for entry in entries:
            if not isinstance(entry, list) or len(entry) != 2 or not isinstance(entry[1], str):
                self._wrong(
                    "at", entry, Text('["20 ms", "V.E.DOOR = 1"]', '["20 ms", "V.E.DOOR = 1"]')
                )
                continue
            time = self._tried("at", "", 0, read_time, entry[0])
            assignment = self._tried("at", "", 0, parse_assignment, entry[1])
            if time is not None and assignment is not None:
                stimuli.append((time, *assignment))
        return tuple(stimuli)

    def _measures(self, table: Any) -> tuple[Measure, ...]:
        if not isinstance(table, dict):
            self._wrong("measure", table, _TABLE)
            return ()
        measures: list[Measure] = []
        known: dict[str, Node] = {}
        for name, text in table.items():
            if not isinstance(text, str):
                self._wrong(name, text, _TEXT, "measure")
                continue
            location = (name, "measure", 0)
            measure = self._tried(*location, read_measure, name, text, dict(known), self._folder)
            if measure is not None:
                measures.append(measure)
                known[name] = measure.node
        return tuple(measures)

    def _expectations(self, entries: Any, known: dict[str, Node]) -> tuple[Expectation, ...]:
        entries = [entries] if isinstance(entries, str) else entries
        if not isinstance(entries, list) or not all(isinstance(one, str) for one in entries):
            self._wrong("expect", entries, _LIST)
            return ()
        found = [self._tried("expect", "", 0, read_expectation, one, known) for one in entries]
        return tuple(one for one in found if one is not None)

    def _goals(
        self, entries: Any, known: dict[str, Node], dimensions: Sequence[str]
    ) -> tuple[Goal, ...]:
        entries = [entries] if isinstance(entries, dict) else entries
        goals: list[Goal] = []
        if not isinstance(entries, list) or not all(isinstance(one, dict) for one in entries):
            self._wrong("find", entries, _LIST)
            return ()
        for number, entry in enumerate(entries):
            self._check_keys(entry, _FIND, "find", number)
            budget = self._whole(entry, "budget", 100)
            for word in ("minimize", "maximize", "boundary"):
                name = entry.get(word)
                if name is None:
                    continue
                names_here = dimensions if word == "boundary" else known
                if name not in names_here:
                    words = ", ".join(names_here)
                    names = Text(f"one of {words}", f"eins von {words}")
                    self._wrong(word, name, names, "find", number)
                goals.append(Goal(word, name, budget))
        return tuple(goals)

    # --- dimensions ------------------------------------------------------------------------------

    def _dimensions(self, entries: Any) -> tuple[Dimension, ...]:
        if not isinstance(entries, list) or not all(isinstance(one, dict) for one in entries):
            self._wrong("vary", entries, _LIST)
            return ()
        found = [self._dimension(entry, number) for number, entry in enumerate(entries)]
        return tuple(dimension for dimension in found if dimension is not None)

    def _dimension(self, entry: dict[str, Any], number: int) -> Dimension | None:
        kinds = [kind for kind in _WORDS if kind in entry]
        if len(kinds) != 1:
            every = (*_COMMON, *_WORDS, *(word for own in _WORDS.values() for word in own))
            self._check_keys(entry, tuple(dict.fromkeys(every)), "vary", number)
            self._missing(" / ".join(_WORDS), f"vary {number + 1}", number, "vary")
            return None
        kind = kinds[0]
        self._check_keys(entry, (kind, *_COMMON, *_WORDS[kind]), "vary", number)
        target, amount = str(entry[kind]), entry.get("amount", 0.0)
        if kind == "time_of":
            assignment = self._tried(kind, "vary", number, parse_assignment, target)
            if assignment is None:
                return None
            target, amount = assignment
        is_time = kind in TIME_KINDS
        duration = self._time(entry, "over" if "over" in entry else "for", "vary", number)
        if kind == "noise" and duration is None:
            self._missing("for", f"vary {number + 1}", number, "vary")
        low, high, step = (
            self._bound(entry, key, is_time, number) for key in ("from", "to", "step")
        )
        if entry.get("each_tick"):
            step = self._cycle_time_us()
            high = high if "to" in entry else END_OF_RUN
        return Dimension(
            str(entry.get("name", target)),
            kind,
            target,
            str(entry.get("of", "")),
            self._values(entry, kind, number),
            low,
            high,
            step,
            amount,
            entry.get("rest", 0.0),
            self._time(entry, "at", "vary", number),
            duration,
            "over" in entry,
            bool(entry.get("each_tick", False)),
            self._nominal(entry, is_time, number),
        )

    def _nominal(self, entry: dict[str, Any], is_time: bool, number: int) -> Value | None:
        """Return the value of the unchanged run; ``None`` if the entry does not say it."""
        value = entry.get("nominal")
        if value is not None and is_time:
            return self._microseconds(value, "nominal", number)
        return value if isinstance(value, int | float | str) else None

    def _bound(self, entry: dict[str, Any], key: str, is_time: bool, number: int) -> float:
        value = entry.get(key, 0)
        if is_time:
            return self._microseconds(value, key, number)
        if isinstance(value, bool) or not isinstance(value, int | float):
            self._wrong(key, value, _NUMBER, "vary", number)
            return 0.0
        return float(value)

    def _microseconds(self, value: Any, key: str, number: int) -> int:
        """Return a time in microseconds; ticks are those of the standard cycle time."""
        time = self._tried(key, "vary", number, read_time, value)
        if time is None:
            return 0
        return time.us(self._cycle_time_us()) if time.is_in_ticks else time.us(1)

    def _cycle_time_us(self) -> int:
        """Return the length of a tick of the machine, for times in ticks; 1 ms without one."""
        if self._tick_us is None:
            with contextlib.suppress(Failure):
                folder = self._machine or machine_of(self._program, FileAccess()).path
                self._tick_us = load_machine(folder).cycle_time_us
        return self._tick_us or 1000

    def _values(self, entry: dict[str, Any], kind: Kind, number: int) -> tuple[Value, ...]:
        values = entry.get("values", [])
        if not isinstance(values, list):
            self._wrong("values", values, _LIST, "vary", number)
            return ()
        if kind in TIME_KINDS:
            return tuple(self._microseconds(value, "values", number) for value in values)
        if kind == "series":
            return tuple(str(self._folder / str(value)) for value in values)
        if kind == "acknowledge":
            for value in values:
                if value not in ("never", "twice"):
                    self._tried("values", "vary", number, read_time, value)
        return tuple(values)

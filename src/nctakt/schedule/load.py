# SPDX-License-Identifier: MIT
"""The load: values that a simulation needs and rtconf.lis does not have.

In: the text of a load file (TOML). Out: ``Load``; its mistakes go to the collector.
Times in the file are numbers of microseconds, as in rtconf.lis, with or without decimals, or texts
with a unit (``"1.5 ms"``, ``"1 h"``)::

    seed = 1
    [functions]                       # execution time of one call
    task_int = 400                    # always the same; also "400 us", "0.4 ms"
    task_rnd = [600, 650, 700]        # one call after another, from the first again
    task_com = { uniform = [200, 300] }
    # of task_int also its parts, in the order of schedule:
    # task_int = { input = 50, interpolation = 300, output = 50 }
    "thread[1].function[1]" = 250     # this one only
    [external.external_sps]           # a semaphore_name
    time = 200
    priority = 110                    # [default: right after the realtime thread]
    cpu = 1
    [machine]
    cpus = 2                          # [default: as many as the list uses]
    offline = [2]
    windows_cpus = [1]                # [default: all that the list uses]
    [interrupt]                       # sources hardware and semaphore
    period = 2000                     # [default: cycle_time]
    phase = 0
    drift = 0.5                       # each period is this much longer
    jitter = 10                       # earlier or later
    [overheads]
    switch = 2                        # each time that a thread gets a processor
    activation = 1                    # each job
    [controller]                      # nctakt run --rtconf
    block = 100                       # what the decoder needs for one block of a program
    plc = "external_sps"              # [default: the first external thread]
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Text
from nctakt.files.toml_text import TomlError, read_toml
from nctakt.lists.format.times import nanoseconds
from nctakt.messages import Collector
from nctakt.messages.scheduling.load import (
    INVALID_LOAD_FILE,
    INVALID_LOAD_VALUE,
    UNKNOWN_LOAD_ENTRY,
)
from nctakt.schedule.model import NO_OVERHEADS, NS_PER_US, PARTS, Execution, Overheads

#: The longest time that a load can name, in µs: that of UNS32, as for the list.
LONGEST_US = 2**32 - 2
#: The most processors: those that ``thread[i].cpu`` can name.
MAX_CPUS = 8

_TIME = Text(
    'a time in µs, 0 or more, or a text such as "1.5 ms"',
    'eine Zeit in µs ab 0 oder ein Text wie "1.5 ms"',
)
_TIMES = Text(
    'a time in µs, a text such as "1.5 ms", a list of times, { uniform = [least, greatest] } or '
    "the parts of task_int",
    'eine Zeit in µs, ein Text wie "1.5 ms", eine Liste, { uniform = [kleinste, größte] } oder '
    "die Teile von task_int",
)
_SIGNED = Text(
    'a time in µs or a text such as "-1.5 ms"', 'eine Zeit in µs oder ein Text wie "-1.5 ms"'
)
_NUMBER = Text("an integer", "eine ganze Zahl")
_CPU = Text(f"a number from 1 to {MAX_CPUS}", f"eine Zahl von 1 bis {MAX_CPUS}")
_CPUS = Text(
    f"a list of different numbers from 1 to {MAX_CPUS}",
    f"eine Liste verschiedener Zahlen von 1 bis {MAX_CPUS}",
)
_NAME = Text("a name", "ein Name")
_TABLE = Text("a table", "eine Tabelle")

_ENTRIES: dict[str, tuple[str, ...]] = {
    "": ("seed", "functions", "external", "machine", "interrupt", "overheads", "controller"),
    "controller": ("block", "plc"),
    "machine": ("cpus", "offline", "windows_cpus"),
    "interrupt": ("period", "phase", "drift", "jitter"),
    "overheads": ("switch", "activation"),
    "external": ("time", "priority", "cpu"),
}


#: Decode time of a block unless the load names one, in µs: a value for first trials.
ASSUMED_BLOCK = 100 * NS_PER_US


@dataclass(frozen=True, slots=True)
class ExternalLoad:
    """An external thread; ``execution`` ``None``: not given. ``priority`` as in the list."""

    execution: Execution | None = None
    priority: int | None = None
    cpu: int = 1


@dataclass(frozen=True, slots=True)
class Load:
    """A load; ``None``: not given. Times in ns.

    ``functions``: by name of function, or by its place in the list. ``interrupt``: period, phase,
    drift and jitter as far as they are given. ``block``: the decoder's time for one block of a
    program. ``plc``: the external thread that is the PLC of a controller. ``is_assumed``: it was
    not given.
    """

    functions: Mapping[str, Execution] = field(default_factory=dict)
    external: Mapping[str, ExternalLoad] = field(default_factory=dict)
    cpus: int | None = None
    offline: tuple[int, ...] = ()
    windows_cpus: tuple[int, ...] | None = None
    interrupt: Mapping[str, int] = field(default_factory=dict)
    overheads: Overheads = NO_OVERHEADS
    seed: int = 0
    block: int = ASSUMED_BLOCK
    plc: str | None = None
    is_assumed: bool = False


def _us(time: int) -> Execution:
    return Execution((time * NS_PER_US,))


#: Times of calls without a load, in µs: values for trying, of no real machine.
ASSUMED = Load(
    {
        "task_int": _us(300),
        "task_rnd": _us(600),
        "task_mmi_driver": _us(200),
        "task_com": _us(200),
    },
    is_assumed=True,
)
ASSUMED_EXTERNAL = _us(150)
ASSUMED_FUNCTION = _us(100)


def read_load(file: str, text: str, collector: Collector) -> Load:
    """Read a load file; with errors in the collector the result is incomplete."""
    try:
        tables = read_toml(file, text)
    except TomlError as error:
        collector.report(INVALID_LOAD_FILE, error.span, error.line, reason=str(error))
        return Load()
    return load_of_tables(tables, collector)


def load_of_tables(tables: dict[str, Any], collector: Collector) -> Load:
    """Return the load of the tables of a load file; with errors it is not complete."""
    return _Reader(collector).load(tables)


class _Reader:
    """Reads entry for entry and reports mistakes."""

    def __init__(self, collector: Collector) -> None:
        self._collector = collector

    def load(self, tables: dict[str, Any]) -> Load:
        self._check_names("", tables, _ENTRIES[""])
        machine = self._table(tables, "machine")
        interrupt = self._table(tables, "interrupt")
        overheads = self._table(tables, "overheads")
        controller = self._table(tables, "controller")
        functions = self._subtable(tables, "functions")
        external = self._subtable(tables, "external")
        times = {name: self._execution(f"functions.{name}", functions[name]) for name in functions}
        return Load(
            {name: time for name, time in times.items() if time is not None},
            {name: self._external(name, external[name]) for name in external},
            self._cpu("machine.cpus", machine.get("cpus")),
            self._cpus("machine.offline", machine.get("offline")) or (),
            self._cpus("machine.windows_cpus", machine.get("windows_cpus")),
            self._interrupt(interrupt),
            Overheads(
                self._time("overheads.switch", overheads.get("switch", 0)) or 0,
                self._time("overheads.activation", overheads.get("activation", 0)) or 0,
            ),
            self._integer("seed", tables.get("seed")) or 0,
            self._block(controller.get("block")),
            self._name("controller.plc", controller.get("plc")),
        )

    def _report(self, key: str, value: object, expected: Text) -> None:
        self._collector.report(
            INVALID_LOAD_VALUE,
            None,
            key=key,
            value=_toml(value),
            expected=expected,
        )

    def _check_names(self, table: str, entries: dict[str, Any], names: tuple[str, ...]) -> None:
        for name in entries:
            if name not in names:
                key = f"{table}.{name}" if table else name
                self._collector.report(UNKNOWN_LOAD_ENTRY, None, key=key, names=", ".join(names))

    def _subtable(self, tables: dict[str, Any], name: str) -> dict[str, Any]:
        table = tables.get(name, {})
        if isinstance(table, dict):
            return table
        self._report(name, table, _TABLE)
        return {}

    def _table(self, tables: dict[str, Any], name: str) -> dict[str, Any]:
        table = self._subtable(tables, name)
        self._check_names(name, table, _ENTRIES[name])
        return table

    def _external(self, name: str, entry: Any) -> ExternalLoad:
        key = f"external.{name}"
        if not isinstance(entry, dict):
            self._report(key, entry, _TABLE)
            return ExternalLoad()
        self._check_names(key, entry, _ENTRIES["external"])
        time = self._execution(f"{key}.time", entry["time"]) if "time" in entry else None
        if time is not None and time.parts:
            self._report(f"{key}.time", entry["time"], _TIME)
        return ExternalLoad(
            time,
            self._integer(f"{key}.priority", entry.get("priority")),
            self._cpu(f"{key}.cpu", entry.get("cpu")) or 1,
        )

    def _interrupt(self, entries: dict[str, Any]) -> dict[str, int]:
        times: dict[str, int] = {}
        for name in _ENTRIES["interrupt"]:
            if name in entries:
                signed = name == "drift"
                time = self._time(f"interrupt.{name}", entries[name], signed=signed)
                if time is not None and (name != "period" or time > 0):
                    times[name] = time
                elif time is not None:
                    self._report("interrupt.period", entries[name], _TIME)
        return times

    def _execution(self, key: str, entry: Any) -> Execution | None:
        if isinstance(entry, dict):
            if sorted(entry) == sorted(PARTS):
                return self._parts(key, entry)
            bounds = entry.get("uniform")
            if list(entry) == ["uniform"] and isinstance(bounds, list) and len(bounds) == 2:
                low, high = (self._time(key, bound) for bound in bounds)
                if low is None or high is None:
                    return None
                if low <= high:
                    return Execution((low, high), spread=True)
            self._report(key, entry, _TIMES)
            return None
        if isinstance(entry, list) and entry:
            times = [self._time(key, item) for item in entry]
            values = tuple(time for time in times if time is not None)
            return Execution(values) if len(values) == len(times) else None
        if isinstance(entry, list):
            self._report(key, entry, _TIMES)
            return None
        time = self._time(key, entry)
        return None if time is None else Execution((time,))

    def _parts(self, key: str, entry: dict[str, Any]) -> Execution | None:
        """A time that consists of three."""
        times = [self._time(f"{key}.{part}", entry[part]) for part in PARTS]
        values = tuple(time for time in times if time is not None)
        if len(values) != 3:
            return None
        return Execution((sum(values),), parts=values)

    def _time(self, key: str, entry: Any, *, signed: bool = False) -> int | None:
        """A time in ns."""
        time_ns = _nanoseconds(entry)
        low = -LONGEST_US * NS_PER_US if signed else 0
        if time_ns is not None and low <= time_ns <= LONGEST_US * NS_PER_US:
            return time_ns
        self._report(key, entry, _SIGNED if signed else _TIME)
        return None

    def _integer(self, key: str, entry: Any) -> int | None:
        if isinstance(entry, int) and not isinstance(entry, bool):
            return int(entry)
        if entry is None:
            return None
        self._report(key, entry, _NUMBER)
        return None

    def _block(self, entry: Any) -> int:
        time = None if entry is None else self._time("controller.block", entry)
        return ASSUMED_BLOCK if time is None else time

    def _name(self, key: str, entry: Any) -> str | None:
        if entry is None or isinstance(entry, str):
            return entry
        self._report(key, entry, _NAME)
        return None

    def _cpu(self, key: str, entry: Any) -> int | None:
        if entry is None:
            return None
        if _is_cpu(entry):
            return int(entry)
        self._report(key, entry, _CPU)
        return None

    def _cpus(self, key: str, entry: Any) -> tuple[int, ...] | None:
        if entry is None:
            return None
        is_list = isinstance(entry, list) and all(_is_cpu(item) for item in entry)
        if is_list and len(set(entry)) == len(entry):
            return tuple(sorted(entry))
        self._report(key, entry, _CPUS)
        return None


def _nanoseconds(entry: Any) -> int | None:
    """A number of microseconds or a text with a unit in ns; ``None`` if it is neither."""
    if isinstance(entry, str):
        size = nanoseconds(entry.removeprefix("-"))
        return -size if size is not None and entry.startswith("-") else size
    if isinstance(entry, bool) or not isinstance(entry, int | float):
        return None
    return round(float(entry) * NS_PER_US) if abs(entry) <= LONGEST_US else None


def _toml(entry: object) -> object:
    """Return an entry as a load file writes it; text without its quotation marks."""
    if isinstance(entry, bool):
        return str(entry).lower()
    if isinstance(entry, dict):
        inner = ", ".join(f"{name} = {_toml(one)}" for name, one in entry.items())
        return f"{{ {inner} }}" if inner else "{}"
    if isinstance(entry, list):
        return f"[{', '.join(str(_toml(one)) for one in entry)}]"
    return entry


def _is_cpu(entry: Any) -> bool:
    return isinstance(entry, int) and not isinstance(entry, bool) and 1 <= entry <= MAX_CPUS

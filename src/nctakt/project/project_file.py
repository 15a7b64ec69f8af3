# SPDX-License-Identifier: MIT
"""The project file: settings that count for all programs in its folder and below.

In: a program or a folder. Out: ``Project``, from the nearest ``nctakt.toml``, or ``pyproject.toml``
with a table ``tool.nctakt``, in that folder or above. Paths in it are relative to its folder::

    machine = "lists"                 # a machine's folder, or a built-in machine
    plc = "cell_plc.py"               # the PLC of the runs
    until = "60 s"                    # the limit of the runs
    set = {"V.E.VALUE" = 5}           # values before the first tick
    language = "de"
    signals = ["X.ACS.ACT_POS"]       # what --trace records and --plot draws
    paths = ["programs", "lists"]     # what `nctakt check` checks if nothing is named

    [plc]                             # instead of plc = "…"
    file = "Cell.plcproj"
    libraries = ["libraries"]         # folders with sources of libraries, or stubs for them
    axes = {"MAIN.axLoader" = "A"}    # the axis that a variable of the type AXIS_REF means
    instruction_time = 20             # ns of an elementary instruction of Structured Text

    [plc.stubs]                       # classes that stand in for blocks of libraries
    FB_EcCoESdoRead = "stubs.py:SdoRead"

    [fmu]                             # a simulation model beside the PLC, or fmu = "plant.fmu"
    file = "plant.fmu"
    every = "2 ms"                    # its communication step
    inputs = {"position" = "X.ACS.ACT_POS"}
    outputs = {"force" = "V.E.VALUE"}
    start = {"mass" = 12.5}
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import Any, cast

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import NOTHING, Diagnostic, Language, Span, Text, whole_file
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.files.access import FileAccess, is_file_or_folder
from nctakt.files.toml_text import TomlError, read_toml
from nctakt.lists.format.times import Time, read_time
from nctakt.lists.machine.files import machine_folder
from nctakt.messages import Collector
from nctakt.messages.commands.project import (
    INVALID_PROJECT_FILE,
    INVALID_PROJECT_VALUE,
    PROJECT_PATH_MISSING,
    UNKNOWN_PROJECT_ENTRY,
)
from nctakt.run.options import accepted_by, refused

#: The names of a project file; the first counts if a folder has both.
OWN_NAME = "nctakt.toml"
PYTHON_NAME = "pyproject.toml"

_PLC_KEYS = ("file", "libraries", "axes", "instruction_time", "stubs")
_FMU_KEYS = ("file", "every", "inputs", "outputs", "start", "isolate", "limit")
_KEYS = (*(option.name for option in accepted_by("project")), "paths")
_TABLE = re.compile(r"\s*\[\s*(.*?)\s*\]\s*(#.*)?")
_TEXT = Text("a text", "ein Text")
_TEXTS = Text("a list of texts", "eine Liste von Texten")
_LANGUAGE = Text("a language", "eine Sprache")
_AXES = Text("a table of names of axes", "eine Tabelle mit Namen von Achsen")
_STUB = Text("a file and a class", "eine Datei und eine Klasse")
_STUB_NAME, _STUB_CLASS = re.compile(r"(?:(\w+)\.)?([A-Za-z_]\w*)"), re.compile(r"(.+):(\w+)")
_STUB_EXAMPLE = 'FB_EcCoESdoRead = "stubs.py:SdoRead"'
_MAX_NS = 1_000_000
_NANOSECONDS = Text("whole nanoseconds, 0 … 1000000", "ganze Nanosekunden, 0 … 1000000")
_TRUTH = Text("true or false", "true oder false")
_ON_TABLE = Text("a table", "eine Tabelle")
_VALUE = Text("a number or a text", "eine Zahl oder ein Text")
_TIME = Text("a time above 0", "eine Zeit über 0")

#: A place in a project file, and the text of its line.
Place = tuple[Span, str]


@dataclass(frozen=True, slots=True)
class FmuSettings:
    """A project's settings for an FMU; ``file`` ``None``: it is named elsewhere.

    ``inputs``, ``outputs``: the FMU's variables -> names of the machine; ``start``: their values
    before the first step; ``isolate``: it runs in a separate process; ``limit``: how long a call of
    it may last; ``places``: where each start value is.
    """

    file: Path | None = None
    every: Time = Time(1, is_in_ticks=True)
    inputs: Mapping[str, str] = field(default_factory=dict)
    outputs: Mapping[str, str] = field(default_factory=dict)
    start: Mapping[str, float | str] = field(default_factory=dict)
    isolate: bool = False
    limit: Time = Time(10_000_000)
    places: Mapping[str, Place] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Stub:
    """A class in a Python file that replaces a function block of a library.

    ``library`` "": the block has no other owner; ``location``: of the entry.
    """

    library: str
    block: str
    file: Path
    class_name: str
    location: Place


@dataclass(frozen=True, slots=True)
class Project:
    """The settings of a project file; ``None`` and empty: not set.

    Paths are relative to the working directory where they lie below it, else absolute. ``values``
    are those of variables before the first tick; ``places``: where each is, and ``plc`` and
    ``fmu``. ``libraries``: folders with sources of the PLC's libraries; ``axes``: the axes of its
    variables of the type AXIS_REF, by their paths. ``instruction_ns``: how long an elementary
    instruction of Structured Text takes, 0: no time.
    """

    file: Path
    machine: Path | None = None
    plcs: tuple[Path, ...] = ()
    language: Language | None = None
    signals: tuple[str, ...] | None = None
    paths: tuple[Path, ...] = ()
    until: Time | None = None
    values: Mapping[str, float | str] = field(default_factory=dict)
    places: Mapping[str, Place] = field(default_factory=dict, compare=False, repr=False)
    libraries: tuple[Path, ...] = ()
    axes: Mapping[str, str] = field(default_factory=dict)
    instruction_ns: int = 0
    fmu: FmuSettings | None = None
    stubs: tuple[Stub, ...] = ()

    @property
    def plc(self) -> Path | None:
        """The file of the first PLC."""
        return next(iter(self.plcs), None)

    def placed(self, found: Diagnostic) -> Diagnostic:
        """Return a diagnostic about one of its values at the place of that value.

        Others are returned unchanged: they are about values from elsewhere.
        """
        name = str(found.values.get("name"))
        value = self.values.get(name)
        if found.span is not None or value is None or found.values.get("value", value) != value:
            return found
        span, line = self.places[name]
        return replace(found, span=span, source_line=line)


def project_around(names: Sequence[str], access: FileAccess) -> Project | None:
    """Return the project of the first file or folder, of the working directory without one.

    ``-`` means standard input. Raises ``Failure`` as ``find_project``.
    """
    return find_project(Path(next((name for name in names if name != "-"), "")), access)


def find_project(begin: Path, access: FileAccess) -> Project | None:
    """Return the project of a program or folder; ``None`` if no folder above has a project file.

    Only files that ``access`` admits are looked for. Raises ``Failure`` for a file that cannot be
    read (900503), that is not TOML (901060) or has wrong entries (901061 … 901063).
    """
    begin = begin.resolve()
    for folder in (begin, *begin.parents):
        for name in (OWN_NAME, PYTHON_NAME):
            file = folder / name
            if access.admits(file) and _is_file(file):
                project = _read(from_here(file), access)
                if project is not None:
                    return project
    return None


def from_here(path: Path) -> Path:
    """Return the path as seen from the working directory if it lies below, else unchanged."""
    working = Path.cwd()
    return path.relative_to(working) if path.is_relative_to(working) else path


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a folder without permission to read
        return False


def _read(file: Path, access: FileAccess) -> Project | None:
    """Return the project of a file; ``None`` for a pyproject.toml without nctakt's table."""
    data = access.read_bytes(file)
    is_own = file.name == OWN_NAME
    if not is_own and b"nctakt" not in data:  # most have nothing for us, and need no reader
        return None
    collector = Collector()
    reader = _Reader(file, data, collector)
    entries = reader.entries(is_own=is_own)
    project = None if entries is None else reader.project(entries)
    if collector.diagnostics:
        raise Failure(*sorted(collector.diagnostics, key=_line_of))
    return project


def _line_of(found: Diagnostic) -> int:
    return 0 if found.span is None else found.span.line


class _Reader:
    """Reads one file entry for entry and reports mistakes with their places."""

    def __init__(self, file: Path, data: bytes, collector: Collector) -> None:
        self._file = file
        self._name = file.as_posix()
        self._folder = file.resolve().parent
        self._text = data.decode("utf-8-sig", errors="replace")
        self._is_text = "\0" not in self._text and "\ufffd" not in self._text
        self._lines = self._text.splitlines()
        self._header = ""
        self._collector = collector

    def entries(self, *, is_own: bool) -> dict[str, Any] | None:
        """Return the settings; ``None`` if there are none, or for a text that is not TOML."""
        if not self._is_text:
            span, line = self._first_without_meaning()
            reason = "the text is not UTF-8"
            self._collector.report(INVALID_PROJECT_FILE, span, line, reason=reason)
            return None
        try:
            tables = read_toml(self._name, self._text)
        except TomlError as error:
            reason = str(error)
            self._collector.report(INVALID_PROJECT_FILE, error.span, error.line, reason=reason)
            return None
        if is_own:
            return tables
        self._header = "tool.nctakt"
        tool = tables.get("tool")
        entries = tool.get("nctakt") if isinstance(tool, dict) else None
        if entries is None or isinstance(entries, dict):
            return entries
        self._wrong("tool.nctakt", entries, _ON_TABLE, "[tool.nctakt]")
        return None

    def _first_without_meaning(self) -> Place:
        """Return the place of the first character that is not UTF-8."""
        for number, line in enumerate(self._lines, 1):
            if found := re.search("[\0\ufffd]", line):
                return Span(self._name, number, found.start() + 1, found.end() + 1), line
        return whole_file(self._name), ""

    def project(self, entries: dict[str, Any]) -> Project:
        for key in entries:
            if key not in _KEYS:
                self._refuse(key)
        plcs, libraries = self._plcs(entries.get("plc"))
        axes = self._axes(entries.get("plc"))
        return Project(
            self._file,
            self._path("machine", entries.get("machine"), 'machine = "lists"'),
            plcs,
            self._language(entries.get("language")),
            self._signals(entries.get("signals")),
            self._paths(entries.get("paths")),
            self._time("until", entries.get("until"), 'until = "60 s"'),
            values := self._values(entries.get("set")),
            {key: self._location(key) for key in ("plc", "fmu")}
            | {name: self._location_of_value(name) for name in values},
            libraries,
            axes,
            self._instruction_ns(entries.get("plc")),
            self._fmu(entries.get("fmu")),
            tuple(self._stubs(entries.get("plc"))),
        )

    def _stubs(self, value: Any) -> Iterator[Stub]:
        """Yield the classes that replace blocks of the PLC."""
        entries = value if isinstance(value, dict) else {}
        example = f"stubs = {{{_STUB_EXAMPLE}}}"
        for name, text in self._table_of("stubs", entries, example, str, "plc").items():
            location = self._location_of_value(name, "stubs", "plc")
            block, named = _STUB_NAME.fullmatch(name), _STUB_CLASS.fullmatch(text)
            if block is None or named is None:
                self._wrong(f"plc.stubs.{name}", text, _STUB, _STUB_EXAMPLE, location)
                continue
            file = self._folder / named[1]
            if not _is_file(file):
                self._collector.report(PROJECT_PATH_MISSING, *location, key=name, path=named[1])
                continue
            file = from_here(Path(os.path.normpath(file)))
            yield Stub(block[1] or "", block[2], file, named[2], location)

    def _axes(self, value: Any) -> Mapping[str, str]:
        """Return the axes of the PLC's variables by their paths."""
        table = value.get("axes", {}) if isinstance(value, dict) else {}
        if isinstance(table, dict) and all(isinstance(one, str) for one in table.values()):
            return MappingProxyType(table)
        example = 'axes = {"MAIN.axLoader" = "A"}'
        self._wrong("axes", table, _AXES, example, self._location_in("plc", "axes"))
        return {}

    def _instruction_ns(self, value: Any) -> int:
        """Return how long an instruction of the PLC takes, in ns."""
        found = value.get("instruction_time", 0) if isinstance(value, dict) else 0
        if isinstance(found, int) and not isinstance(found, bool) and 0 <= found <= _MAX_NS:
            return found
        location = self._location_in("plc", "instruction_time")
        self._wrong("instruction_time", found, _NANOSECONDS, "instruction_time = 20", location)
        return 0

    def _refuse(self, key: str) -> None:
        """Report an unknown entry, or a run option that belongs elsewhere."""
        span, line = self._location(key)
        found = refused(key, "project")
        if found is not None:
            self._collector.diagnostics.append(replace(found, span=span, source_line=line))
            return
        near = nearest(key, _KEYS) or NOTHING
        names = ", ".join(_KEYS)
        self._collector.report(
            UNKNOWN_PROJECT_ENTRY, span, line, key=key, nearest=near, names=names
        )

    def _plcs(self, value: Any) -> tuple[tuple[Path, ...], tuple[Path, ...]]:
        """Return the files of the PLCs, and the folders with sources of their libraries."""
        if not isinstance(value, dict):
            return self._files("plc", value, 'plc = "cell_plc.py"'), ()
        self._check_keys("plc", value, _PLC_KEYS)
        location = self._location_in("plc", "libraries")
        texts = self._texts(
            "libraries", value.get("libraries"), 'libraries = ["libraries"]', location
        )
        folders = [self._folder / text for text in texts or ()]
        for text, folder in zip(texts or (), folders, strict=True):
            if not folder.is_dir():
                self._collector.report(PROJECT_PATH_MISSING, *location, key="libraries", path=text)
        files = self._files("file", value.get("file"), 'file = "Cell.plcproj"', "plc")
        return files, tuple(from_here(Path(os.path.normpath(one))) for one in folders)

    def _location_in(self, table: str, key: str) -> Place:
        """Return the place of an entry of a table, else that of the table."""
        header, self._header = self._header, f"{self._header}.{table}".removeprefix(".")
        found = self._location(key)
        self._header = header
        return found if found[1] else self._location(table)

    def _check_keys(self, table: str, value: Mapping[str, Any], known: Sequence[str]) -> None:
        """Report the unknown entries of a table."""
        for key in value:
            if key not in known:
                self._collector.report(
                    UNKNOWN_PROJECT_ENTRY,
                    *self._location_in(table, key),
                    key=f"{table}.{key}",
                    nearest=nearest(key, known) or NOTHING,
                    names=", ".join(known),
                )

    def _fmu(self, value: Any) -> FmuSettings | None:
        """Return the settings of the FMU coupled to the PLC."""
        if not isinstance(value, dict):
            file = self._path("fmu", value, 'fmu = "plant.fmu"')
            return None if file is None else FmuSettings(file)
        self._check_keys("fmu", value, _FMU_KEYS)
        every = self._time("every", value.get("every"), 'every = "10 ms"', "fmu")
        limit = self._time("limit", value.get("limit"), 'limit = "10 s"', "fmu")
        isolate = value.get("isolate", False)
        if not isinstance(isolate, bool):
            entry_location = self._location_in("fmu", "isolate")
            self._wrong("fmu.isolate", isolate, _TRUTH, "isolate = true", entry_location)
        start = self._table_of("start", value, 'start = {"mass" = 12.5}', (str, int, float))
        return FmuSettings(
            self._path("file", value.get("file"), 'file = "plant.fmu"', "fmu"),
            Time(1, is_in_ticks=True) if every is None else every,
            self._table_of("inputs", value, 'inputs = {"position" = "X.ACS.ACT_POS"}', str),
            self._table_of("outputs", value, 'outputs = {"force" = "V.E.VALUE"}', str),
            start,
            isolate is True,
            FmuSettings().limit if limit is None else limit,
            {name: self._location_of_value(name, "start", "fmu") for name in start},
        )

    def _table_of(
        self, key: str, entries: Mapping[str, Any], example: str, kinds: Any, owner: str = "fmu"
    ) -> Mapping[str, Any]:
        """Return a table within that of ``owner``; names with dots may be tables in tables."""
        table = entries.get(key, {})
        found = dict(_flat(table)) if isinstance(table, dict) else None
        if found is None or not all(
            isinstance(one, kinds) and _is_finite(one) for one in found.values()
        ):
            location = self._location_in(owner, key)
            self._wrong(f"{owner}.{key}", table, _ON_TABLE, example, location)
            return {}
        return MappingProxyType(found)

    def _path(self, key: str, value: Any, example: str, table: str = "") -> Path | None:
        """Return the path of an entry, ``None`` without one; ``table``: where the entry is."""
        if value is None:
            return None
        location = self._location_in(table, key) if table else self._location(key)
        if not isinstance(value, str) or not value or "\0" in value:
            self._wrong(key, value, _TEXT, example, location)
            return None
        path = machine_folder(value, self._folder) if key == "machine" else self._folder / value
        if not is_file_or_folder(path):
            self._collector.report(PROJECT_PATH_MISSING, *location, key=key, path=value)
        return from_here(Path(os.path.normpath(path)))

    def _files(self, key: str, value: Any, example: str, table: str = "") -> tuple[Path, ...]:
        """Return the paths of an entry that names one file or a list of them."""
        values = value if isinstance(value, list) else [value]
        found = (self._path(key, one, example, table) for one in values)
        return tuple(path for path in found if path is not None)

    def _paths(self, value: Any) -> tuple[Path, ...]:
        texts = self._texts("paths", value, 'paths = ["programs"]') or ()
        found = (self._path("paths", text, 'paths = ["programs"]') for text in texts)
        return tuple(path for path in found if path is not None)

    def _signals(self, value: Any) -> tuple[str, ...] | None:
        return self._texts("signals", value, 'signals = ["X.ACS.ACT_POS"]')

    def _texts(
        self, key: str, value: Any, example: str, location: Place | None = None
    ) -> tuple[str, ...] | None:
        if value is None:
            return None
        if not isinstance(value, list) or not all(
            isinstance(one, str) and "\0" not in one for one in value
        ):
            self._wrong(key, value, _TEXTS, example, location)
            return None
        return tuple(value)

    def _language(self, value: Any) -> Language | None:
        if value is not None and value not in ("en", "de"):
            self._wrong("language", value, _LANGUAGE, 'language = "en", language = "de"')
            return None
        return cast("Language | None", value)

    def _time(self, key: str, value: Any, example: str, table: str = "") -> Time | None:
        """Return a time above 0, ``None`` without one; ``table``: where the entry is."""
        location = self._location_in(table, key) if table else self._location(key)
        if value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            self._wrong(key, value, _TIME, example, location)
            return None
        try:
            time = read_time(value)
        except Failure as failure:
            span, line = location
            self._collector.diagnostics += [
                replace(found, span=span, source_line=line) for found in failure.diagnostics
            ]
            return None
        if time.count == 0:
            self._wrong(key, value, _TIME, example, location)
        return time

    def _values(self, table: Any) -> Mapping[str, float | str]:
        """Return the values of ``set``; ``V.E.VALUE = 5`` without quotes is a table in tables."""
        example = 'set = {"V.E.VALUE" = 5}'
        if table is not None and not isinstance(table, dict):
            self._wrong("set", table, _ON_TABLE, example)
            return {}
        values: dict[str, float | str] = {}
        for name, value in _flat(table or {}):
            if not isinstance(value, str | int | float) or not _is_finite(value):
                self._wrong(name, value, _VALUE, example, self._location_of_value(name))
            else:
                values[name] = int(value) if isinstance(value, bool) else value
        return MappingProxyType(values)

    def _location_of_value(self, name: str, key: str = "set", within: str = "") -> Place:
        """Return the place of a value in the table ``key``, else that of the table.

        ``within``: the table that has the table.
        """
        outer = f"{self._header}.{within}".strip(".") if within else self._header
        entry = re.compile(rf"""\s*["']?(?P<key>{re.escape(name)})["']?\s*=""")
        inline = re.compile(rf"""\s*{key}\b.*?["'.{{\s,](?P<key>{re.escape(name)})["']?\s*=""")
        for pattern, table in ((entry, f"{outer}.{key}".removeprefix(".")), (inline, outer)):
            for number, line in self._own_lines(table):
                found = pattern.match(line)
                if found is not None:
                    begin, end = found.span("key")
                    return Span(self._name, number, begin + 1, end + 1), line
        return self._location_in(within, key) if within else self._location(key)

    def _wrong(
        self, key: str, value: Any, expected: Text, example: str, location: Place | None = None
    ) -> None:
        self._collector.report(
            INVALID_PROJECT_VALUE,
            *(location or self._location(key)),
            key=key,
            value=value,
            expected=expected,
            example=example,
        )

    def _location(self, key: str) -> Place:
        """Return the span of an entry's name, or of its table's, and its line.

        Else it is the whole file.
        """
        pattern = re.compile(rf"""\s*\[?\s*["']?(?P<key>{re.escape(key)})["']?\s*[].=]""")
        for number, line in self._own_lines(self._header):
            found = pattern.match(line)
            if found is not None:
                begin, end = found.span("key")
                return Span(self._name, number, begin + 1, end + 1), line
        for number, line in self._own_lines(f"{self._header}.{key}".removeprefix(".")):
            return Span(self._name, number, 1, len(line.rstrip()) + 1), line
        return whole_file(self._name), ""

    def _own_lines(self, header: str) -> Iterator[tuple[int, str]]:
        """Yield the lines of a table with their numbers, its header among them."""
        table = ""
        for number, line in enumerate(self._lines, 1):
            found = _TABLE.fullmatch(line)
            if found is not None:
                table = "".join(found[1].split())
            if table == header:
                yield number, line


def _flat(table: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the names and values of a table in tables, the names joined by dots."""
    for name, value in table.items():
        if isinstance(value, dict):
            yield from _flat(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def _is_finite(value: str | float) -> bool:
    return isinstance(value, str) or math.isfinite(value)

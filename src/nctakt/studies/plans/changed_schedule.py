# SPDX-License-Identifier: MIT
"""A scheduling list and its load with other values of some entries.

In: the files of a plan and the changes of a run. Out: the schedule of the changed texts. No file is
written; ``files_of`` returns the texts, for who wants to have them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.base.text import decode_text
from nctakt.files.access import FileAccess
from nctakt.files.toml_text import TomlError, read_toml
from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.declared.schemas import RTCONF
from nctakt.lists.format.parameter import Parameter
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions
from nctakt.messages import Collector, diagnostic
from nctakt.messages.scheduling.load import LOAD_INTERRUPT_WITHOUT_EFFECT, LOAD_OF_UNUSED_FUNCTION
from nctakt.schedule.load import ASSUMED, load_of_tables
from nctakt.schedule.model import NS_PER_US
from nctakt.schedule.open_schedule import RunSchedule, schedule_of
from nctakt.studies.plans.changed_lists import entry_text, refuse, unknown_parameter, with_entry

#: The letters with which the IDs of parameters of a scheduling list begin.
FAMILY = "P-RTCF-"

#: Findings about an entry of a load that changes nothing.
_WITHOUT_EFFECT = (LOAD_OF_UNUSED_FUNCTION, LOAD_INTERRUPT_WITHOUT_EFFECT)

_INDEX = re.compile(r"\[[^]]*\]")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


@dataclass(slots=True)
class ScheduleChanges:
    """Changes for a run: other files, parameters by ID and thread, entries of the load."""

    rtconf: Path | None = None
    load: Path | None = None
    parameters: dict[tuple[str, str], float | str] = field(default_factory=dict)
    entries: dict[str, float | str] = field(default_factory=dict)

    @property
    def key(self) -> tuple[object, ...]:
        """The changes as a key of a dictionary."""
        return (
            self.rtconf, self.load, tuple(self.parameters.items()), tuple(self.entries.items()),
        )  # fmt: skip


@dataclass(frozen=True, slots=True)
class ScheduleFiles:
    """The scheduling list of a plan, its load and its operating system."""

    rtconf: Path
    load: Path | None
    system: str

    def schedule(self, changes: ScheduleChanges, access: FileAccess) -> RunSchedule:
        """Return the schedule with these changes.

        Raises ``Failure``: an unknown parameter or thread (901312), and the reports of list and
        load.
        """
        name, text, tables = self._changed(changes, access)
        schedule = self._schedule(name, text, tables)
        if changes.entries:
            assert tables is not None
            unchanged = self._schedule(name, text, self._load_tables(changes, access))
            before = [one.text() for one in unchanged.diagnostics]
            useless = [one for one in schedule.diagnostics if one.message in _WITHOUT_EFFECT]
            found = [one for one in useless if one.text() not in before]
            if found:
                raise Failure(*found)
        return schedule

    def _schedule(self, name: str, text: str, tables: dict[str, Any] | None) -> RunSchedule:
        options = RtconfOptions(PROFILES[self.system])
        collector = Collector()
        configuration = load_rtconf(name, text.encode("utf-8"), collector, options)
        load = ASSUMED if tables is None else load_of_tables(tables, collector)
        return schedule_of(name, configuration, load, options, collector)

    def texts(self, changes: ScheduleChanges, access: FileAccess) -> tuple[str, str | None]:
        """Return the texts of the list and of the load with these changes; raises ``Failure``."""
        _, text, tables = self._changed(changes, access)
        return text, None if tables is None else toml_text(tables)

    def _load_tables(self, changes: ScheduleChanges, access: FileAccess) -> dict[str, Any] | None:
        """Return the tables of the load before their changes; those of assumed times if needed."""
        load = changes.load or self.load
        if load is None:
            return _assumed_tables() if changes.entries else None
        return _tables(load, access)

    def _changed(
        self, changes: ScheduleChanges, access: FileAccess
    ) -> tuple[str, str, dict[str, Any] | None]:
        """Return the name and the text of the list, and the tables of the load."""
        path = changes.rtconf or self.rtconf
        text = decode_text(access.read_bytes(path)).text
        if changes.parameters:
            configuration = load_rtconf(path.as_posix(), text.encode("utf-8"), Collector())
            for (id_, owner), value in changes.parameters.items():
                text = with_entry(text, _entry_name(configuration, id_, owner), entry_text(value))
        tables = self._load_tables(changes, access)
        for key, value in changes.entries.items():
            assert tables is not None
            _set_entry(tables, key, value)
        return path.as_posix(), text, tables


def _tables(path: Path, access: FileAccess) -> dict[str, Any]:
    """Return the tables of a load file; one that is not TOML raises ``Failure``."""
    from nctakt.messages.scheduling.load import INVALID_LOAD_FILE  # noqa: PLC0415 - few loads are invalid

    try:
        return read_toml(path.as_posix(), decode_text(access.read_bytes(path)).text)
    except TomlError as error:
        found = diagnostic(INVALID_LOAD_FILE, error.span, error.line, reason=str(error))
        raise Failure(found) from error


def _assumed_tables() -> dict[str, Any]:
    times = {name: one.values[0] // NS_PER_US for name, one in ASSUMED.functions.items()}
    return {"functions": times}


def _set_entry(tables: dict[str, Any], key: str, value: float | str) -> None:
    """Set an entry of a load by its path: ``functions.task_rnd``, ``external.plc.time``."""
    table, _, rest = key.partition(".")
    if not rest:
        tables[table] = value
        return
    inner = tables.setdefault(table, {})
    if table == "external" and isinstance(inner, dict):
        name, _, rest = rest.rpartition(".")
        inner = inner.setdefault(name, {})
    if isinstance(inner, dict):
        inner[rest] = value


def _entry_name(configuration: RtconfConfiguration, id_: str, owner: str) -> str:
    """Return the name of a parameter in the list: that of the thread ``owner``, if it has one."""
    parameter = next((one for one in RTCONF.parameters if one.id == id_), None)
    if parameter is None:
        near = nearest(id_, [one.id for one in RTCONF.parameters])
        refuse(id_, owner, unknown_parameter(near))
    count = len(_INDEX.findall(parameter.path))
    if count == 0:
        return parameter.path
    owners = _owners(configuration, parameter, count)
    path = owners.get(owner, owner if owner in owners.values() else None)
    if path is None:
        known = ", ".join(owners)
        refuse(id_, owner, Text(f"known: {known}", f"bekannt: {known}"))
    return f"{path}.{parameter.path.rpartition('.')[2]}"


def _owners(
    configuration: RtconfConfiguration, parameter: Parameter, count: int
) -> Mapping[str, str]:
    """Return the names of the threads, or of their functions -> their places in the list."""
    if parameter.path.startswith("external_thread"):
        return {
            one.semaphore_name: f"external_thread[{one.index}]"
            for one in configuration.external_threads
        }
    if count == 1:
        return {one.name: f"thread[{one.index}]" for one in configuration.threads}
    owners = {}
    for thread in configuration.threads:
        for function in thread.functions:
            path = f"thread[{thread.index}].function[{function.index}]"
            owners[f"{thread.name}.{function.name}"] = path
            if len(thread.functions) == 1:
                owners[thread.name] = path
    return owners


def toml_text(tables: Mapping[str, Any]) -> str:
    """Return tables of numbers, texts, lists and further tables as TOML."""
    lines = [f"{_key(key)} = {_value(value)}" for key, value in tables.items()
             if not isinstance(value, dict)]  # fmt: skip
    for key, table in tables.items():
        if isinstance(table, dict):
            lines.append(f"{_key(key)} = {_value(table)}")
    return "\n".join(lines) + "\n"


def _key(key: str) -> str:
    return key if _BARE_KEY.fullmatch(key) else json.dumps(key, ensure_ascii=False)


def _value(value: Any) -> str:
    if isinstance(value, dict):
        return f"{{{', '.join(f'{_key(key)} = {_value(one)}' for key, one in value.items())}}}"
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    return json.dumps(value, ensure_ascii=False)

# SPDX-License-Identifier: MIT
"""A TwinCAT project (``.tsproj``) -> the lists of its CNC (LG-401 … LG-405).

Each list is the text of a ``Data`` element below ``CNC``. The start-up list names them as
``tc_virtual_9/axis.lis``: 9 is the ``Offset`` of the element. In the folder that comes out each
has its own name, and the start-up list names it so.
"""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import NoReturn
from xml.parsers import expat

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.machines.folders import PROJECT_WITHOUT_LISTS

#: The start-up list of the folder.
STARTUP = "hochlauf.lis"

_SUFFIX = ".tsproj"
#: Cycle times of tasks are in 100 ns (LG-401).
_PER_US = 10
_WHOLE = re.compile(r"[1-9][0-9]{0,8}")
_VIRTUAL = re.compile(r"(?:\.?[\\/])?tc_virtual_(\d+)[\\/]+([^\s\\/(]+)", re.IGNORECASE)
_STARTUP_DATA = "startup"
_IN_FILES = frozenset(("CNC", "Axis", "Channel"))


def project_in(source: Path) -> Path | None:
    """Return the project that a path names: a file, or the only one in a folder without lists."""
    if source.suffix.casefold() == _SUFFIX:
        return source
    if not source.is_dir() or any((source / name).exists() for name in (STARTUP, "startup.lis")):
        return None
    found = [*source.glob(f"*{_SUFFIX}"), *source.glob(f"*/*{_SUFFIX}")]
    return found[0] if len(found) == 1 else None


@dataclass(frozen=True, slots=True)
class ProjectLists:
    """The lists of a project's CNC by name; ``cycle_us``: how often its GEO task runs, if known."""

    files: dict[str, bytes]
    cycle_us: float | None


def lists_of_project(file: Path, access: FileAccess) -> ProjectLists:
    """Return the lists of a project's CNC; raises ``Failure`` (902680)."""
    reader = _Reader(file)
    reader.read(access.read_bytes(file))
    startup = reader.startup
    if startup is None:
        reason = Text("it has no CNC with a start-up list", "er hat keine CNC mit Hochlaufliste")
        _refuse(file, reason)
    named = {offset: name for offset, name in _VIRTUAL.findall(startup) if offset in reader.data}
    counts = Counter(name.casefold() for name in (*named.values(), STARTUP))
    names = {
        offset: name if counts[name.casefold()] == 1 else f"{offset}_{name}"
        for offset, name in named.items()
    }
    text = _VIRTUAL.sub(lambda found: f"./{names.get(found[1], found[2])}", startup)
    lists = {STARTUP: text.encode("utf-8")}
    lists |= {name: reader.data[offset].encode("utf-8") for offset, name in names.items()}
    return ProjectLists(lists, reader.cycle_us)


class _Reader:
    """Gathers the texts of the lists; ``data``: by their offset."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self._elements: list[str] = []
        self._offset: str | None = None
        self._is_startup = False
        self._text: list[str] = []
        self.startup: str | None = None
        self.cycle_us: float | None = None
        self.data: dict[str, str] = {}

    def read(self, content: bytes) -> None:
        """Read a project; raises ``Failure``."""
        parser = expat.ParserCreate()
        parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
        parser.StartDoctypeDeclHandler = self._declaration
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._text.append
        try:
            parser.Parse(content, True)
        except expat.ExpatError as error:
            words = f"line {error.lineno}: {expat.errors.messages[error.code]}"
            _refuse(self._file, Text(words, words))

    def _declaration(self, *_: object) -> NoReturn:
        _refuse(self._file, Text("it declares a document type", "er deklariert einen Dokumenttyp"))

    def _start(self, name: str, values: dict[str, str]) -> None:
        self._elements.append(name)
        self._text.clear()
        is_inside = "CNC" in self._elements
        if is_inside and name in _IN_FILES and "File" in values:
            own = values["File"]
            reason = Text(
                f"its {name} is kept in another file, {own}: save it in the project itself",
                f"{name} liegt in einer eigenen Datei, {own}: im Projekt selbst speichern",
            )
            _refuse(self._file, reason)
        if is_inside and name == "GeoTask" and _WHOLE.fullmatch(values.get("CycleTime", "")):
            self.cycle_us = int(values["CycleTime"]) / _PER_US
        if is_inside and name == "Data":
            self._offset = values.get("Offset")
            self._is_startup = values.get("Name", "").casefold() == _STARTUP_DATA

    def _end(self, name: str) -> None:
        if name == "Data" and "CNC" in self._elements:
            text = "".join(self._text).lstrip("\r\n")
            if self._is_startup:
                self.startup = text
            elif self._offset is not None:
                self.data[self._offset] = text
        self._elements.pop()
        self._text.clear()


def _refuse(file: Path, reason: Text) -> NoReturn:
    raise Failure(diagnostic(PROJECT_WITHOUT_LISTS, file=str(file), reason=reason))

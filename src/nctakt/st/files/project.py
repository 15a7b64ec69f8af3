# SPDX-License-Identifier: MIT
"""A project's files -> the objects in them (ST-101, ST-103, ST-106).

In: a ``.plcproj``, a ``.tsproj``, a folder, or single files. Out: ``PlcSources``: the files with
objects, in order, the libraries they refer to, and the definitions for conditions. Files are read
by the function that the caller gives, so that all reading is bounded in one place.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from urllib.parse import unquote

from nctakt.base.dataclass import dataclass, field
from nctakt.messages.plcs.st_text import PROJECT_FILE_MISSING
from nctakt.st.files.suffixes import OBJECT_SUFFIXES, PROJECT_SUFFIX, SYSTEM_SUFFIX
from nctakt.st.files.xml_text import MAX_BYTES, Element, read_xml
from nctakt.st.reporting import Reporter

#: Folders above an object in which its project is looked for.
MAX_LEVELS = 8

#: Returns the bytes of a file; ``None`` after a report.
ReadFile = Callable[[Path], bytes | None]


@dataclass(slots=True, eq=False)
class SystemTask:
    """A task of the system's project, which wins over that of the PLC's."""

    cycle_us: int
    priority: int


@dataclass(slots=True, eq=False)
class PlcSources:
    """The content of a project; ``libraries`` is ``None`` if it does not list them."""

    name: str
    files: list[Path] = field(default_factory=list)
    libraries: list[str] | None = None
    definitions: dict[str, str] = field(default_factory=dict)
    tasks: dict[str, SystemTask] = field(default_factory=dict)


def loose_files(paths: Sequence[Path]) -> PlcSources:
    """Return files without a project as one project, in the order of their paths."""
    return PlcSources(paths[0].stem if paths else "", sorted(paths))


def read_project(path: Path, read: ReadFile, reporter: Reporter) -> list[PlcSources]:
    """Return the project of a ``.plcproj``, or those that a ``.tsproj`` names."""
    data = read(path)
    root = None if data is None else read_xml(path.as_posix(), data, reporter)
    if root is None:
        return []
    if path.suffix.lower() == SYSTEM_SUFFIX:
        return _system(path, root, read, reporter)
    return [_project(path, root, reporter)]


def _project(path: Path, root: Element, reporter: Reporter) -> PlcSources:
    found = PlcSources(path.stem, libraries=[])
    for element in root.descendants("Name"):
        found.name = element.text.strip() or found.name
        break
    for element in root.descendants("Compile"):
        if element.child_text("ExcludeFromBuild").lower() == "true":
            continue
        name = unquote(element.attributes.get("Include", "")).replace("\\", "/")
        file = path.parent / name
        if file.suffix.lower() not in OBJECT_SUFFIXES:
            continue
        if not _is_inside(name) or not file.is_file():
            file = _in_any_case(path.parent, name) or file
        if file.is_file():
            found.files.append(file)
        else:
            reporter.report_file(PROJECT_FILE_MISSING, element.span, path=name)
    for kind in ("PlaceholderReference", "LibraryReference"):
        for element in root.descendants(kind):
            include = element.attributes.get("Include", "")
            assert found.libraries is not None
            found.libraries.append(include.partition(",")[0].lstrip("#").strip())
    for element in root.descendants("CompilerDefines"):
        for part in element.text.replace(";", ",").split(","):
            name, _, value = part.partition(":=")
            if name.strip():
                found.definitions[name.strip().lower()] = value.strip().strip("'")
    return found


def project_around(path: Path) -> Path | None:
    """Return the project in a folder above an object that lists it; ``None`` without one."""
    needle = path.name.lower().encode()
    for folder in list(path.resolve().parents)[:MAX_LEVELS]:
        for file in sorted(folder.glob(f"*{PROJECT_SUFFIX}")):
            try:
                listed = file.stat().st_size <= MAX_BYTES and needle in file.read_bytes().lower()
            except OSError:
                continue
            if listed:
                return file
    return None


def _is_inside(name: str) -> bool:
    return not Path(name).is_absolute()


def _in_any_case(folder: Path, name: str) -> Path | None:
    """Return a file whose name is in a different case on the disk."""
    current = folder
    for part in Path(name).parts:
        if part == "..":
            current = current.parent
            continue
        exact = current / part
        if exact.exists():
            current = exact
            continue
        if not current.is_dir():
            return None
        match = [one for one in sorted(current.iterdir()) if one.name.lower() == part.lower()]
        if not match:
            return None
        current = match[0]
    return current


def _system(path: Path, root: Element, read: ReadFile, reporter: Reporter) -> list[PlcSources]:
    """Return the PLC projects of a system, with its tasks."""
    tasks: dict[str, SystemTask] = {}
    for element in root.descendants("Task"):
        name, cycle = element.child_text("Name"), element.attributes.get("CycleTime", "")
        priority = element.attributes.get("Priority", "")
        if name and cycle.isdecimal():
            number = int(priority[:6]) if priority.isdecimal() else 0
            tasks[name.lower()] = SystemTask(int(cycle[:12]) // 10, number)
    found: list[PlcSources] = []
    for element in root.descendants("Project"):
        name = element.attributes.get("PrjFilePath", "").replace("\\", "/")
        if not name.lower().endswith(PROJECT_SUFFIX):
            continue
        file = _in_any_case(path.parent, name)
        if file is None:
            reporter.report_file(PROJECT_FILE_MISSING, element.span, path=name)
            continue
        for project in read_project(file, read, reporter):
            project.tasks = tasks
            found.append(project)
    return found

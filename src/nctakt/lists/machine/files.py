# SPDX-License-Identifier: MIT
"""Paths in lists -> files.

In: a path as a list has it, and the folders where the lists of the machine are searched: the folder
of the start-up list, its parents up to the folder that the user named (the one above at least), the
working directory, the root folder. Out: the file. Both slashes and any letter case count, as on
Windows. Where no folder has the path as a whole, its first parts are left out one after the other:
``./listen/x.lis`` is ``x.lis`` where the files lie beside the start-up list. What was found with
such tolerance is one note for the machine.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path, PureWindowsPath

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.declared.startup import ListReference
from nctakt.messages import Collector
<<<<<<< HEAD
from nctakt.messages.files import FILE_OUTSIDE
from nctakt.messages.machine import LIST_FILE_MISSING, PATH_TAKEN_AS
=======
from nctakt.messages.machine import LIST_FILE_MISSING, LIST_NOT_READABLE, PATHS_TAKEN_AS
>>>>>>> 05a2c8b (Find lists anywhere in a tree and below a root folder, with one note for tolerated paths)

#: How the start-up list of a machine's folder is called.
STARTUP_NAMES = ("hochlauf.lis", "startup.lis")
#: How else start-up lists are called in the field.
_STARTUP_NAME = re.compile(r"(hochlauf|start[_-]?up)[\w-]*\.(lis|xml)", re.IGNORECASE)
#: The first part of paths in XML lists: the controller's root folder.
_CONTROLLER_ROOT = "cnckernelrootdir"


<<<<<<< HEAD
def find_list(
    reference: ListReference, folder: Path, access: FileAccess, collector: Collector
) -> Path | None:
    """The file that ``reference`` in a list of ``folder`` means; reported if there is none."""
    found = find_file(reference.path, folder, access)
    place, line = reference.span, reference.line
    if found is None:
        if access.admits(folder / reference.path):
            collector.report(LIST_FILE_MISSING, place, line, path=reference.path)
        else:
            collector.report(
                FILE_OUTSIDE, place, line, file=reference.path, folders=access.shown_folders
            )
        return None
    plain = "/".join(part for part in reference.path.split("/") if part not in {"", "."})
    if not found.as_posix().endswith(plain):
        collector.report(PATH_TAKEN_AS, place, line, path=reference.path, found=found.as_posix())
    return found
=======
class ListSearch:
    """Finds the files that the lists of one machine name.
>>>>>>> 05a2c8b (Find lists anywhere in a tree and below a root folder, with one note for tolerated paths)

    ``startup_file``: its start-up list. ``named``: the folder that the user named, ``root``: the
    controller's root folder, if the user named one.
    """

<<<<<<< HEAD
def find_file(path: str, folder: Path, access: FileAccess) -> Path | None:
    """Search ``path`` in ``folder``, then in its parent, as far as ``access`` allows."""
    if Path(path).is_absolute():
        return _admitted_file(Path(path), access)
    # '.' and '..' have no parent that their spelling shows.
    above = folder.parent if folder.name not in {"", ".."} else folder / ".."
    found = find_below(path, folder, access)
    return find_below(path, above, access) if found is None else found
=======
    def __init__(
        self, startup_file: Path, named: Path | None = None, root: Path | None = None
    ) -> None:
        folders = [*_upward(startup_file.parent, named), Path()]
        if root is not None:
            folders.append(root)
        self.folders: tuple[Path, ...] = tuple(dict.fromkeys(folders))
        self._names: dict[Path, dict[str, str]] = {}
        self._tolerated: list[tuple[ListReference, Path]] = []

    def find_list(self, reference: ListReference, collector: Collector) -> Path | None:
        """Return the file that a reference means; reported if there is none."""
        file = self.find(reference.path)
        if file is None:
            folders = ", ".join(f"{folder.as_posix()}/" for folder in self.folders)
            collector.report(
                LIST_FILE_MISSING,
                reference.span,
                reference.line,
                path=reference.path,
                folders=folders,
            )
            return None
        if not file.as_posix().endswith("/".join(_parts(reference.path, "/"))):
            self._tolerated.append((reference, file))
        return file

    def find(self, path: str) -> Path | None:
        """Return the file that ``path`` means, ``None`` if there is none."""
        absolute = Path(path)
        if absolute.is_absolute() and absolute.is_file():
            return absolute
        parts = _parts(path, r"[\\/]")
        for first in range(len(parts)):
            for folder in self.folders:
                file = self._descend(folder, parts[first:])
                if file is not None and file.is_file():
                    return file
        return None

    def report_tolerance(self, collector: Collector) -> None:
        """Report the paths that do not name their files as they are: one note."""
        if self._tolerated:
            reference, file = self._tolerated[0]
            collector.report(
                PATHS_TAKEN_AS,
                reference.span,
                reference.line,
                count=len(self._tolerated),
                path=reference.path,
                file=file.as_posix(),
            )

    def _descend(self, folder: Path, parts: list[str]) -> Path | None:
        for part in parts:
            name = part if part == ".." else self._entry(folder, part)
            if name is None:
                return None
            folder = folder / name
        return folder

    def _entry(self, folder: Path, name: str) -> str | None:
        """Return the entry of a folder called ``name``, else one that differs in case only."""
        if folder not in self._names:
            entries = _entries(folder)
            self._names[folder] = {
                **{entry.casefold(): entry for entry in reversed(entries)},
                **{entry: entry for entry in entries},
            }
        names = self._names[folder]
        return names.get(name) or names.get(name.casefold())


def _upward(folder: Path, named: Path | None) -> Iterator[Path]:
    """The folder, its parents up to ``named`` if it lies there, and at least the one above."""
    yield folder
    while named is not None and folder != named and folder.is_relative_to(named):
        folder = folder.parent
        yield folder
    # '.' and '..' have no parent that their spelling shows.
    yield folder.parent if folder.name not in {"", ".."} else folder / ".."


def _parts(path: str, separator: str) -> list[str]:
    """The parts of a path without its drive and the controller's root folder."""
    drive = PureWindowsPath(path).drive
    parts = re.split(separator, path.removeprefix(drive))
    parts = [part for part in parts if part not in {"", "."}]
    return parts[1:] if parts and parts[0].casefold() == _CONTROLLER_ROOT else parts
>>>>>>> 05a2c8b (Find lists anywhere in a tree and below a root folder, with one note for tolerated paths)


def find_below(path: str, folder: Path, access: FileAccess) -> Path | None:
    """Search ``path`` in ``folder`` alone, as far as ``access`` allows."""
    if Path(path).is_absolute():
<<<<<<< HEAD
        return _admitted_file(Path(path), access)
    plain = path.replace("\\", "/")
    found = _descend(folder, plain.split("/")) if access.admits(folder / plain) else None
    return None if found is None else _admitted_file(found, access)


def _admitted_file(path: Path, access: FileAccess) -> Path | None:
    return path if access.admits(path) and path.is_file() else None


def _descend(root: Path, parts: list[str]) -> Path | None:
    current = root
    for part in parts:
=======
        return Path(path) if Path(path).is_file() else None
    current = folder
    for part in re.split(r"[\\/]", path):
>>>>>>> 05a2c8b (Find lists anywhere in a tree and below a root folder, with one note for tolerated paths)
        if part in {"", "."}:
            continue
        name = part if part == ".." else find_entry(current, part)
        if name is None:
            return None
        current = current / name
    return current if current.is_file() else None


def find_entry(folder: Path, name: str) -> str | None:
    """Return the entry of ``folder`` called ``name``, else the first that differs in case only.

    ``None``: there is none, or the folder cannot be read.
    """
    names = _entries(folder)
    if name in names:
        return name
    folded = name.casefold()
    return next((entry for entry in names if entry.casefold() == folded), None)


def _entries(folder: Path) -> list[str]:
    """The names in a folder in order; none if it cannot be read."""
    try:
        return sorted(entry.name for entry in folder.iterdir())
    except OSError:
        return []


def is_startup_name(name: str) -> bool:
    """Return whether a start-up list may be called so."""
    return _STARTUP_NAME.fullmatch(name) is not None


def startup_lists(folder: Path) -> list[Path]:
    """Return the start-up lists that lie in ``folder``, those with the usual names first."""
    names = [name for name in _entries(folder) if is_startup_name(name)]
    names.sort(key=lambda name: name.casefold() not in STARTUP_NAMES)
    return [folder / name for name in names if (folder / name).is_file()]


def startup_lists_below(folder: Path) -> list[Path]:
    """Return the start-up lists in the folders of ``folder``; links are not followed."""
    found: list[Path] = []
    for name in _entries(folder):
        inner = folder / name
        if not name.startswith(".") and inner.is_dir() and not inner.is_symlink():
            found += startup_lists(inner) + startup_lists_below(inner)
    return found


def startup_list_around(file: Path) -> Path | None:
    """Return the start-up list of the machine in whose folder ``file`` lies: the nearest above."""
    for folder in file.resolve().parents:
        lists = startup_lists(folder)
        if lists:
            working = Path.cwd()
            found = lists[0]
            return found.relative_to(working) if found.is_relative_to(working) else found
    return None


<<<<<<< HEAD
def read_file(path: Path, access: FileAccess, collector: Collector) -> bytes | None:
    """The bytes of ``path``; reported if it cannot be read."""
=======
def read_file(path: Path, collector: Collector) -> bytes | None:
    """Return the bytes of ``path``; reported if it cannot be read."""
>>>>>>> 05a2c8b (Find lists anywhere in a tree and below a root folder, with one note for tolerated paths)
    try:
        return access.read_bytes(path)
    except Failure as failure:
        collector.diagnostics += failure.diagnostics
        return None

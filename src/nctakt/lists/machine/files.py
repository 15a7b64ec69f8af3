# SPDX-License-Identifier: MIT
"""Paths in lists -> files.

In: a path as written in a list, and the folders where the lists of the machine are searched: the
folder of the start-up list, its parents up to the folder that the user named (the one above at
least), the working directory, the root folder. Out: the file. Both slashes and any letter case
count, as on Windows. If no folder has the path as a whole, its first parts are dropped one by one:
``./listen/x.lis`` is ``x.lis`` if the files are next to the start-up list. Files found with such
tolerance are listed in one note for the machine. ``..`` after a folder takes that away: all
messages name a file by its shortest path.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path, PureWindowsPath

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.declared.startup import ListReference
from nctakt.messages import Collector
from nctakt.messages.files import FILE_OUTSIDE
from nctakt.messages.machines.machine import LIST_FILE_MISSING, PATHS_TAKEN_AS

#: The built-in machines by name, the default one first.
BUILT_IN_MACHINES = ("demo", "demo5")
_MACHINES = Path(__file__).parent.parent.parent / "machines"
#: The folder of the first of them.
DEMO_FOLDER = _MACHINES / BUILT_IN_MACHINES[0]
#: How the name of a list in ASCII ends.
LIST_SUFFIX = ".lis"
#: Usual names of the start-up list of a machine.
STARTUP_NAMES = ("hochlauf.lis", "startup.lis", "hochlauf.xml", "startup.xml")
#: Further names of start-up lists in the field.
_STARTUP_NAME = re.compile(r"(hochlauf|start[_-]?up)[\w-]*\.(lis|xml)", re.IGNORECASE)
#: Paths that a message about a missing list names at most.
_MAX_TRIED = 8
#: The first part of paths in XML lists: the controller's root folder.
_CONTROLLER_ROOT = "cnckernelrootdir"


class ListSearch:
    """Finds the files that the lists of one machine name.

    ``startup_file``: its start-up list. ``access`` says which files may be read. ``named``: the
    folder that the user named, ``root``: the controller's root folder, if the user named one.
    """

    def __init__(
        self,
        startup_file: Path,
        access: FileAccess,
        user_folder: Path | None = None,
        root: Path | None = None,
    ) -> None:
        self._access = access
        folders = [*_upward(startup_file.parent, user_folder), Path()]
        if root is not None:
            folders.append(root)
        self.folders: tuple[Path, ...] = tuple(dict.fromkeys(folders))
        self._names: dict[Path, dict[str, str]] = {}
        self._tolerated: list[tuple[ListReference, Path]] = []

    def find_list(self, reference: ListReference, collector: Collector) -> Path | None:
        """Return the file of a reference; a missing one is reported."""
        file = self.find(reference.path)
        if file is None and not self._may_be_read(reference.path):
            collector.report(
                FILE_OUTSIDE,
                reference.span,
                reference.line,
                file=reference.path,
                folders=self._access.shown_folders,
            )
            return None
        if file is None:
            collector.report(
                LIST_FILE_MISSING,
                reference.span,
                reference.line,
                path=reference.path,
                paths=self._tried(reference.path),
            )
            return None
        if not self._is_as_written(reference.path, file):
            self._tolerated.append((reference, file))
        return file

    def _tried(self, path: str) -> str:
        """Return the paths that a missing file would have, each once, as text for a message."""
        parts = _parts(path, r"[\\/]")
        paths = [
            _joined(folder, parts[first:]) for first in range(len(parts)) for folder in self.folders
        ]
        shown = list(dict.fromkeys(one.as_posix() for one in paths))
        more = ["…"] if len(shown) > _MAX_TRIED else []
        return ", ".join(shown[:_MAX_TRIED] + more)

    def _is_as_written(self, path: str, file: Path) -> bool:
        """Return whether a path in a list has the slashes and the letter case of its file."""
        parts = _parts(path, "/")
        return file.as_posix().endswith("/".join(parts)) or any(
            _joined(folder, parts) == file for folder in self.folders
        )

    def find(self, path: str) -> Path | None:
        """Return the file of ``path``, ``None`` if there is none that may be read."""
        absolute = Path(path)
        if absolute.is_absolute() and _is_admitted_file(absolute, self._access):
            return absolute
        parts = _parts(path, r"[\\/]")
        for first in range(len(parts)):
            for folder in self.folders:
                if not self._access.admits(folder.joinpath(*parts[first:])):
                    continue
                file = self._descend(folder, parts[first:])
                if file is not None and _is_admitted_file(file, self._access):
                    return file
        return None

    def _may_be_read(self, path: str) -> bool:
        """Return whether a file with this path may be read, even if it does not exist."""
        if Path(path).is_absolute():
            return self._access.admits(path)
        parts = _parts(path, r"[\\/]")
        return any(self._access.admits(folder.joinpath(*parts)) for folder in self.folders)

    def report_tolerance(self, collector: Collector) -> None:
        """Report the paths that differ from the names of their files, in one note."""
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
            folder = _joined(folder, [name])
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


def _upward(folder: Path, user_folder: Path | None) -> Iterator[Path]:
    """Yield the folder and its parents up to ``user_folder`` around it, at least the next one."""
    yield folder
    while user_folder is not None and folder != user_folder and folder.is_relative_to(user_folder):
        folder = folder.parent
        yield folder
    # '.' and '..' have no parent that their spelling shows.
    yield folder.parent if folder.name not in {"", ".."} else folder / ".."


def _parts(path: str, separator: str) -> list[str]:
    """Return the parts of a path without its drive and the controller's root folder."""
    drive = PureWindowsPath(path).drive
    parts = re.split(separator, path.removeprefix(drive))
    parts = [part for part in parts if part not in {"", "."}]
    return parts[1:] if parts and parts[0].casefold() == _CONTROLLER_ROOT else parts


def _joined(folder: Path, parts: Sequence[str]) -> Path:
    """Return a path below a folder; ``..`` takes its last folder away unless that is a link."""
    for part in parts:
        is_above = part == ".." and folder.name not in {"", ".."} and not folder.is_symlink()
        folder = folder.parent if is_above else folder / part
    return folder


def find_below(path: str, folder: Path, access: FileAccess) -> Path | None:
    """Search ``path`` in ``folder`` alone, as far as ``access`` allows."""
    plain = path.replace("\\", "/")
    if not access.admits(folder / plain):
        return None
    if Path(path).is_absolute():
        return Path(path) if Path(path).is_file() else None
    current = folder
    for part in plain.split("/"):
        if part in {"", "."}:
            continue
        name = part if part == ".." else find_entry(current, part)
        if name is None:
            return None
        current = _joined(current, [name])
    return current if _is_admitted_file(current, access) else None


def _is_admitted_file(path: Path, access: FileAccess) -> bool:
    return access.admits(path) and path.is_file()


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
    """Return the names in a folder in order; none if it cannot be read."""
    try:
        return sorted(entry.name for entry in folder.iterdir())
    except OSError:
        return []


def machine_folder(name: str | Path, base: Path = Path()) -> Path:
    """Return the folder or start-up list that ``name`` means, seen from the folder ``base``.

    The name of a built-in machine means that machine, unless a file there has the same name.
    """
    folder = base / name
    return _MACHINES / name if str(name) in BUILT_IN_MACHINES and not folder.exists() else folder


def is_startup_name(name: str) -> bool:
    """Return whether a start-up list may have this name."""
    return _STARTUP_NAME.fullmatch(name) is not None


def startup_lists(folder: Path) -> list[Path]:
    """Return the start-up lists that lie in ``folder``, those with the usual names first."""
    names = [name for name in _entries(folder) if is_startup_name(name)]
    names.sort(key=lambda name: name.casefold() not in STARTUP_NAMES)
    return [folder / name for name in names if (folder / name).is_file()]


def startup_lists_below(folder: Path) -> list[Path]:
    """Return the start-up lists in the folders of ``folder``; links are not followed."""
    result: list[Path] = []
    for name in _entries(folder):
        inner = folder / name
        if not name.startswith(".") and inner.is_dir() and not inner.is_symlink():
            result += startup_lists(inner) + startup_lists_below(inner)
    return result


def startup_list_around(file: Path) -> Path | None:
    """Return the start-up list of the machine in whose folder ``file`` lies: the nearest above."""
    for folder in file.resolve().parents:
        lists = startup_lists(folder)
        if lists:
            working = Path.cwd()
            nearest_list = lists[0]
            return (
                nearest_list.relative_to(working)
                if nearest_list.is_relative_to(working)
                else nearest_list
            )
    return None


def read_file(path: Path, access: FileAccess, collector: Collector) -> bytes | None:
    """Return the bytes of ``path``; an unreadable file is reported."""
    try:
        return access.read_bytes(path)
    except Failure as failure:
        collector.diagnostics += failure.diagnostics
        return None

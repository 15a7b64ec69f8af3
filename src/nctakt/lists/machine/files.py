# SPDX-License-Identifier: MIT
"""Paths in lists -> files.

In: a path as a list has it, the folder of that list. Out: the file. A path is searched in the
list's own folder, then in the folder above (vendors' sets keep all lists in ``listen`` and name
them ``./listen/x.lis``). Back-slashes and letter case count as on Windows, with a note.
"""

from __future__ import annotations

from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.declared.startup import ListReference
from nctakt.messages import Collector
from nctakt.messages.files import FILE_OUTSIDE
from nctakt.messages.machine import LIST_FILE_MISSING, PATH_TAKEN_AS

#: How the start-up list of a machine's folder is called.
STARTUP_NAMES = ("hochlauf.lis", "startup.lis")


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


def find_file(path: str, folder: Path, access: FileAccess) -> Path | None:
    """Search ``path`` in ``folder``, then in its parent, as far as ``access`` allows."""
    if Path(path).is_absolute():
        return _admitted_file(Path(path), access)
    # '.' and '..' have no parent that their spelling shows.
    above = folder.parent if folder.name not in {"", ".."} else folder / ".."
    found = find_below(path, folder, access)
    return find_below(path, above, access) if found is None else found


def find_below(path: str, folder: Path, access: FileAccess) -> Path | None:
    """Search ``path`` in ``folder`` alone, as far as ``access`` allows."""
    if Path(path).is_absolute():
        return _admitted_file(Path(path), access)
    plain = path.replace("\\", "/")
    found = _descend(folder, plain.split("/")) if access.admits(folder / plain) else None
    return None if found is None else _admitted_file(found, access)


def _admitted_file(path: Path, access: FileAccess) -> Path | None:
    return path if access.admits(path) and path.is_file() else None


def _descend(root: Path, parts: list[str]) -> Path | None:
    current = root
    for part in parts:
        if part in {"", "."}:
            continue
        if part == "..":
            current = current / part
            continue
        name = find_entry(current, part)
        if name is None:
            return None
        current = current / name
    return current


def find_entry(folder: Path, name: str) -> str | None:
    """The entry of ``folder`` called ``name``, else the first that differs in case only.

    ``None``: there is none, or the folder cannot be read.
    """
    try:
        names = sorted(entry.name for entry in folder.iterdir())
    except OSError:
        return None
    if name in names:
        return name
    wanted = name.casefold()
    return next((found for found in names if found.casefold() == wanted), None)


def startup_list(folder: Path) -> Path | None:
    """The start-up list that lies in ``folder``, if there is one."""
    for wanted in STARTUP_NAMES:
        name = find_entry(folder, wanted)
        if name is not None and (folder / name).is_file():
            return folder / name
    return None


def startup_list_around(file: Path) -> Path | None:
    """The start-up list of the machine in whose folder ``file`` lies: the nearest one above it."""
    for folder in file.resolve().parents:
        found = startup_list(folder)
        if found is not None:
            here = Path.cwd()
            return found.relative_to(here) if found.is_relative_to(here) else found
    return None


def read_file(path: Path, access: FileAccess, collector: Collector) -> bytes | None:
    """The bytes of ``path``; reported if it cannot be read."""
    try:
        return access.read_bytes(path)
    except Failure as failure:
        collector.diagnostics += failure.diagnostics
        return None

# SPDX-License-Identifier: MIT
"""Paths in lists -> files.

In: a path as a list has it, the folder of that list. Out: the file. A path is searched in the
list's own folder, then in the folder above (vendors' sets keep all lists in ``listen`` and name
them ``./listen/x.lis``). Back-slashes and letter case count as on Windows, with a note.
"""

from __future__ import annotations

from pathlib import Path

from nctakt.lists.declared.startup import ListReference
from nctakt.messages import Collector
from nctakt.messages.machine import LIST_FILE_MISSING, LIST_NOT_READABLE, PATH_TAKEN_AS

#: How the start-up list of a machine's folder is called.
STARTUP_NAMES = ("hochlauf.lis", "startup.lis")


def find_list(reference: ListReference, folder: Path, collector: Collector) -> Path | None:
    """The file that ``reference`` in a list of ``folder`` means; reported if there is none."""
    found = find_file(reference.path, folder)
    place, line = reference.span, reference.line
    if found is None:
        collector.report(LIST_FILE_MISSING, place, line, path=reference.path)
        return None
    plain = "/".join(part for part in reference.path.split("/") if part not in {"", "."})
    if not found.as_posix().endswith(plain):
        collector.report(PATH_TAKEN_AS, place, line, path=reference.path, found=found.as_posix())
    return found


def find_file(path: str, folder: Path) -> Path | None:
    """Search ``path`` in ``folder``, then in its parent."""
    parts = path.replace("\\", "/").split("/")
    if Path(path).is_absolute():
        absolute = Path(path)
        return absolute if absolute.is_file() else None
    # '.' and '..' have no parent that their spelling shows.
    above = folder.parent if folder.name not in {"", ".."} else folder / ".."
    for root in (folder, above):
        found = _descend(root, parts)
        if found is not None and found.is_file():
            return found
    return None


def find_below(path: str, folder: Path) -> Path | None:
    """Search ``path`` in ``folder`` alone."""
    if Path(path).is_absolute():
        return Path(path) if Path(path).is_file() else None
    found = _descend(folder, path.replace("\\", "/").split("/"))
    return found if found is not None and found.is_file() else None


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


def read_file(path: Path, collector: Collector) -> bytes | None:
    """The bytes of ``path``; reported if it cannot be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        collector.report(
            LIST_NOT_READABLE, None, path=path.as_posix(), reason=error.strerror or str(error)
        )
        return None

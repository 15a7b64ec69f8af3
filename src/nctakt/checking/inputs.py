# SPDX-License-Identifier: MIT
"""Files and folders as a user names them -> the inputs of a check.

In: paths. Out: start-up lists of machines, lists, programs, projects and objects of PLCs, each file
once; a missing file is reported. A file is a list if its name ends with ``.lis`` or ``.xml``, part
of a PLC by the suffixes of ``st/files``, else a program. A start-up list represents its machine, a
project its files. A folder is searched with all its folders except hidden ones; each folder with a
start-up list is a machine.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess, missing_file
from nctakt.lists.format.xml_reader import is_xml
from nctakt.lists.machine.files import LIST_SUFFIX, is_startup_name
from nctakt.lists.machine.list_kinds import kind_of
from nctakt.messages import diagnostic
from nctakt.messages.commands.checking import NOTHING_TO_CHECK
from nctakt.messages.files import FILE_MISSING, FILE_NOT_READABLE
from nctakt.st.files.project import project_around
from nctakt.st.files.suffixes import (
    FOLDER_SUFFIXES,
    OBJECT_SUFFIXES,
    PLC_SUFFIXES,
    PROJECT_SUFFIXES,
    TEXT_SUFFIXES,
)

#: Suffixes of programs in folders.
PROGRAM_SUFFIXES = (".nc", ".ncp", ".cnc", ".sub", ".cyc", ".ecy")
XML_SUFFIX = ".xml"
LIST_SUFFIXES = (LIST_SUFFIX, XML_SUFFIX)


@dataclass(frozen=True, slots=True)
class Finding:
    """A diagnostic and its file, even if it has no position there.

    ``channels``: the channels that it concerns, if it does not concern all that run the program.
    """

    file: str
    diagnostic: Diagnostic
    channels: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class PlcInput:
    """A project of a PLC, or files of one without a project.

    ``only``: the files that the user has named of it; empty: all.
    """

    paths: tuple[Path, ...]
    only: tuple[Path, ...] = ()


@dataclass(frozen=True, slots=True)
class Inputs:
    """The inputs of a check.

    ``machines``: start-up lists, each with the folder in which it was found, ``None`` for an input
    of the user.
    """

    machines: tuple[tuple[Path, Path | None], ...]
    lists: tuple[Path, ...]
    programs: tuple[Path, ...]
    plc: tuple[PlcInput, ...] = ()


def gather(paths: Sequence[Path], access: FileAccess, diagnostics: list[Finding]) -> Inputs:
    """Return the files of the paths; mistakes in the paths are added to ``diagnostics``."""
    machines: dict[Path, tuple[Path, Path | None]] = {}
    lists: dict[Path, Path] = {}
    programs: dict[Path, Path] = {}
    plc: list[Path] = []
    for path in paths:
        if not path.exists():
            diagnostics.append(Finding(path.as_posix(), missing_file(path)))
        elif path.is_file() and is_startup_name(path.name):
            machines.setdefault(path.resolve(), (path, None))
        elif path.is_file() and path.suffix.casefold() in PLC_SUFFIXES:
            plc.append(path)
        elif not path.is_dir():
            group = lists if path.suffix.casefold() in LIST_SUFFIXES else programs
            group.setdefault(path.resolve(), path)
        else:
            plc += _search(path, machines, lists, programs, access, diagnostics)
    return Inputs(
        tuple(machines.values()),
        tuple(lists.values()),
        tuple(programs.values()),
        tuple(_plc_inputs(plc)),
    )


def _plc_inputs(paths: Sequence[Path]) -> Iterator[PlcInput]:
    """Yield projects, then the files that belong to a project around them, then all others."""
    projects = {
        path.resolve(): path for path in paths if path.suffix.casefold() in PROJECT_SUFFIXES
    }
    parts: dict[Path, list[Path]] = {}
    loose: list[Path] = []
    for path in paths:
        if path.resolve() in projects:
            continue
        around = None if path.suffix.casefold() in TEXT_SUFFIXES else project_around(path)
        if around is None:
            loose.append(path)
        elif around.resolve() not in projects:
            parts.setdefault(around, []).append(path)
    yield from (PlcInput((path,)) for path in projects.values())
    yield from (PlcInput((path,), tuple(only)) for path, only in parts.items())
    if loose:
        yield PlcInput(tuple(dict.fromkeys(loose)))


def _search(
    folder: Path,
    machines: dict[Path, tuple[Path, Path | None]],
    lists: dict[Path, Path],
    programs: dict[Path, Path],
    access: FileAccess,
    diagnostics: list[Finding],
) -> list[Path]:
    """Sort the files of a folder; return those of PLCs."""
    empty = True
    plc: list[Path] = []
    for path in _files(folder, diagnostics):
        suffix = path.suffix.casefold()
        if suffix in FOLDER_SUFFIXES and path.is_file():
            empty = False
            plc.append(path)
            continue
        if suffix not in (*LIST_SUFFIXES, *PROGRAM_SUFFIXES):
            continue
        if suffix == XML_SUFFIX and not _is_list(path, access):
            continue
        empty = False
        if not path.exists():
            diagnostics.append(Finding(path.as_posix(), diagnostic(FILE_MISSING, file=str(path))))
        elif is_startup_name(path.name):
            machines.setdefault(path.resolve(), (path, folder))
        elif path.is_file():
            group = lists if suffix in LIST_SUFFIXES else programs
            group.setdefault(path.resolve(), path)
    if empty:
        suffixes = ", ".join(PROGRAM_SUFFIXES)
        message = diagnostic(NOTHING_TO_CHECK, folder=str(folder), suffixes=suffixes)
        diagnostics.append(Finding(folder.as_posix(), message))
    if any(path.suffix.casefold() in PROJECT_SUFFIXES for path in plc):
        # Files that no project lists have been left out of it.
        plc = [path for path in plc if path.suffix.casefold() not in OBJECT_SUFFIXES]
    return plc


def _is_list(path: Path, access: FileAccess) -> bool:
    """Return whether an XML file is a list of parameters."""
    try:
        begin = access.read_begin(path)
    except Failure:
        return False
    return is_xml(begin) and kind_of(path.name, begin) is not None


def _files(folder: Path, diagnostics: list[Finding]) -> Iterator[Path]:
    """Yield all files in a folder and its folders by name; links are not followed."""

    def unreadable(error: OSError) -> None:
        name = str(error.filename)
        reason = error.strerror or str(error)
        diagnostics.append(Finding(name, diagnostic(FILE_NOT_READABLE, file=name, reason=reason)))

    for root, folders, names in os.walk(folder, onerror=unreadable):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        for name in sorted(names):
            if not name.startswith("."):
                yield Path(root) / name

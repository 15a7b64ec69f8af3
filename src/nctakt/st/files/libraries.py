# SPDX-License-Identifier: MIT
"""Sources of libraries that a user gives: folders -> the declarations in them (ST-107).

In: the folders of ``[plc] libraries``. Out: ``OwnLibrary`` objects: each project below a folder is
a library of that name; files without a project form a library named after their folder.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.st.files.objects import read_objects
from nctakt.st.files.project import PlcSources, ReadFile, read_project
from nctakt.st.files.suffixes import FOLDER_SUFFIXES, PROJECT_SUFFIX
from nctakt.st.parse.lexer import Definitions
from nctakt.st.reporting import Reporter
from nctakt.st.tree import Declaration

#: Files of all libraries together, at most.
MAX_FILES = 20_000


@dataclass(slots=True, eq=False)
class OwnLibrary:
    """A library whose sources the user has: its declarations, and the words of its texts.

    ``is_whole``: it is a project, which replaces a library of this name known to nctakt; files of
    no project are added to it. ``references``: the libraries that a project names. ``faulty``:
    names of what it lacks because of mistakes that are reported.
    """

    name: str
    declarations: list[Declaration]
    words: frozenset[str]
    is_whole: bool = False
    references: tuple[str, ...] = ()
    faulty: frozenset[str] = frozenset()

    @property
    def declared_names(self) -> tuple[str, ...]:
        """The names of its objects."""
        return tuple(name for one in self.declarations if (name := getattr(one, "name", "")))

    def report_taken(self, names: Any, reporter: Reporter) -> None:
        """Report what it has that only it may have, and others declare, too."""


def own_libraries(
    folders: Sequence[Path], read: ReadFile, reporter: Reporter
) -> dict[str, OwnLibrary]:
    """Return the libraries below folders, by their names in lower case."""
    found: dict[str, OwnLibrary] = {}
    for folder in folders:
        for sources in _projects(folder, read, reporter):
            library = _read(sources, read, reporter)
            found.setdefault(sources.name.lower(), library)
    return found


def _projects(folder: Path, read: ReadFile, reporter: Reporter) -> Iterator[PlcSources]:
    """Yield the projects below a folder, then the files of no project, folder by folder."""
    known: set[Path] = set()
    for file in sorted(folder.rglob(f"*{PROJECT_SUFFIX}"))[:MAX_FILES]:
        for project in read_project(file, read, reporter):
            known.update(path.resolve() for path in project.files)
            known.add(file.parent.resolve())
            yield project
    loose: dict[Path, list[Path]] = {}
    for path in sorted(folder.rglob("*"))[:MAX_FILES]:
        is_source = path.suffix.lower() in FOLDER_SUFFIXES and path.suffix != PROJECT_SUFFIX
        if (
            is_source
            and path.is_file()
            and known.isdisjoint((path.resolve(), *path.resolve().parents))
        ):
            first = path.relative_to(folder).parts[0]
            loose.setdefault(folder / first if folder / first != path else folder, []).append(path)
    for base, files in loose.items():
        yield PlcSources(base.resolve().name, files)


def _read(sources: PlcSources, read: ReadFile, reporter: Reporter) -> OwnLibrary:
    declarations: list[Declaration] = []
    words: set[str] = set()
    definitions = Definitions(dict(sources.definitions), frozenset(), frozenset())
    for path in sources.files:
        data = read(path)
        if data is not None:
            words.update(re.findall(r"\w+", data.decode("utf-8", "replace").lower()))
            declarations += read_objects(path.as_posix(), data, definitions, reporter)
    is_whole, references = sources.libraries is not None, tuple(sources.libraries or ())
    return OwnLibrary(sources.name, declarations, frozenset(words), is_whole, references)

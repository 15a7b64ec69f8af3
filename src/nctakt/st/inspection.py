# SPDX-License-Identifier: MIT
"""The files of a PLC -> a checked program, with all mistakes."""

from __future__ import annotations

import contextlib
import gc
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from nctakt.messages import Collector
from nctakt.st.check.project import check_project
from nctakt.st.files.libraries import OwnLibrary
from nctakt.st.files.objects import read_objects
from nctakt.st.files.project import PlcSources, ReadFile, loose_files, read_project
from nctakt.st.files.suffixes import PROJECT_SUFFIX, SYSTEM_SUFFIX
from nctakt.st.parse.lexer import Definitions
from nctakt.st.program import Program
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources
from nctakt.st.tree import Declaration, TaskNode
from nctakt.st.vocabulary.libraries import default_libraries

#: Reads the libraries whose sources the user has, by their names in lower case.
ReadLibraries = Callable[[ReadFile, Reporter], Mapping[str, OwnLibrary]]

#: Definitions for conditions in programs (ST-205).
OUR_DEFINITION = "nctakt"


def inspect_paths(
    paths: Sequence[Path],
    read: ReadFile,
    collector: Collector,
    own: ReadLibraries = lambda read, reporter: {},
) -> list[Program]:
    """Check projects, and single files as one project, with the user's own libraries."""
    programs: list[Program] = []
    loose = [path for path in paths if path.suffix.lower() not in (PROJECT_SUFFIX, SYSTEM_SUFFIX)]
    for path in paths:
        if path not in loose:
            reporter = Reporter(Sources(), collector)
            for project in read_project(path, read, reporter):
                programs.append(inspect_sources(project, read, reporter, own))
    if loose:
        reporter = Reporter(Sources(), collector)
        programs.append(inspect_sources(loose_files(loose), read, reporter, own))
    return programs


def inspect_sources(
    project: PlcSources, read: ReadFile, reporter: Reporter, own: ReadLibraries
) -> Program:
    """Read and check all files of a project, with the user's own libraries."""
    texts = [(path.as_posix(), read(path)) for path in project.files]
    return inspect_texts(
        project.name,
        {file: data for file, data in texts if data is not None},
        reporter,
        libraries=project.libraries,
        project=project,
        own=own(read, reporter),
    )


def inspect_texts(
    name: str,
    texts: Mapping[str, bytes],
    reporter: Reporter,
    *,
    libraries: Sequence[str] | None = None,
    project: PlcSources | None = None,
    own: Mapping[str, OwnLibrary] | None = None,
) -> Program:
    """Check texts by their names; ``libraries`` ``None``: all known ones."""
    with collector_waiting():
        return _inspect(name, texts, reporter, libraries, project, own)


@contextlib.contextmanager
def collector_waiting() -> Iterator[None]:
    """Let the garbage collector wait: it would look through the growing trees again and again."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


def _inspect(
    name: str,
    texts: Mapping[str, bytes],
    reporter: Reporter,
    libraries: Sequence[str] | None,
    project: PlcSources | None,
    own: Mapping[str, OwnLibrary] | None,
) -> Program:
    values = {OUR_DEFINITION: "", **(project.definitions if project is not None else {})}
    stems = frozenset(Path(file).stem.lower() for file in texts)
    definitions = Definitions(values, stems, stems)
    declarations: list[Declaration] = []
    for file, data in texts.items():
        declarations += read_objects(file, data, definitions, reporter)
    if project is not None:
        for node in declarations:
            if isinstance(node, TaskNode) and node.name.lower() in project.tasks:
                task = project.tasks[node.name.lower()]
                node.cycle_us, node.priority = task.cycle_us, task.priority
    found = default_libraries() if libraries is None else list(libraries)
    program = check_project(name, declarations, found, reporter, own)
    program.files = list(texts)
    return program

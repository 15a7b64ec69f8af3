# SPDX-License-Identifier: MIT
"""Completes the words of a command: what they leave out comes from environment and project file.

In: the words as click gives them. Out: ``Options`` with machine, PLC and language, and the exit
code of the command that is carried out with them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_USAGE
from nctakt.cli.file_options import file_access
from nctakt.cli.request import STANDARD_INPUT, Options
from nctakt.cli.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.project import PROGRAMS_OF_DIFFERENT_MACHINES
from nctakt.project.machine_choice import MachineChoice, choose_machine, machine_of
from nctakt.project.project_file import Project, find_project

#: The word after --plc for the built-in PLC, where the project file names another one.
DEFAULT_PLC = "default"


def carry_out(words: dict[str, Any], action: Callable[[Options, FileAccess], int]) -> int:
    """Carry out a command that runs programs; its exit code. A ``Failure`` is shown."""
    paths = [*words["programs"], *(program for _, program in words["others"])]
    return maybe_watched(words, paths, lambda access: _carry_out(words, action, access))


def maybe_watched(
    words: dict[str, Any], paths: Sequence[str], carry_out: Callable[[FileAccess], int]
) -> int:
    """Carry out a command, with ``--watch`` again and again; its exit code."""

    def open_access() -> FileAccess:
        return file_access(words["confined"])

    if not words.pop("watch", False):
        return carry_out(open_access())
    from nctakt.cli.watching import watch  # noqa: PLC0415 - seldom needed

    language: Language = words["language"] or "en"
    try:
        return watch(carry_out, open_access, paths, language)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def _carry_out(
    words: dict[str, Any], action: Callable[[Options, FileAccess], int], access: FileAccess
) -> int:
    language: Language = words["language"] or "en"
    try:
        options = _completed(words, access)
        language = options.language
        return action(options, access)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def project_around(names: Sequence[str], access: FileAccess) -> Project | None:
    """Return the project of the first file or folder, of the working directory without one."""
    first = next((name for name in names if name != STANDARD_INPUT), "")
    return find_project(Path(first), access)


def _completed(words: dict[str, Any], access: FileAccess) -> Options:
    """Return the words with the settings; raises ``Failure`` where these are wrong."""
    programs = [*words["programs"], *(program for _, program in words["others"])]
    project = project_around(programs, access)
    plc = words["plc"]
    if plc == DEFAULT_PLC and not Path(plc).exists():
        plc = None
    elif plc is None and words.get("hli") is None and project is not None and project.plc:
        plc = str(project.plc)
    language = words["language"] or (project and project.language) or "en"
    given = {**words, "plc": plc, "language": language}
    if project is not None:
        given["project_signals"] = project.signals
    if words["machine"] is None:
        choice = _machine_of_all(programs, project, access)
        if not choice.is_demo:
            given["machine"] = str(choice.path)
            given["machine_note"] = choice.note()
    return Options(**given)


def _machine_of_all(
    programs: Sequence[str], project: Project | None, access: FileAccess
) -> MachineChoice:
    """Return the machine of all programs; raises ``Failure`` (901065) if they have several."""
    if not programs or STANDARD_INPUT in programs[:1]:
        return choose_machine(None, project, access)
    first = programs[0]
    machine = choose_machine(Path(first), project, access)
    seen = {Path(first).parent}
    for name in programs[1:]:
        folder = Path(name).parent
        if name == STANDARD_INPUT or folder in seen:
            continue
        seen.add(folder)
        other = machine_of(Path(name), access)
        if other.path != machine.path:
            raise Failure(
                diagnostic(
                    PROGRAMS_OF_DIFFERENT_MACHINES,
                    first=first,
                    machine=machine.shown,
                    second=name,
                    other=other.shown,
                )
            )
    return machine

# SPDX-License-Identifier: MIT
"""Which machine a program runs on, and is checked for, if none is named.

In: a program, its project. Out: ``MachineChoice``: the machine of the environment, else that of the
project file, else the one in whose folder the program lies, else the built-in one; and the note
that says which.
"""

from __future__ import annotations

import os
import shlex
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import (
    DEMO_FOLDER,
    LIST_SUFFIX,
    machine_folder,
    startup_list_around,
    startup_lists,
)
from nctakt.messages import diagnostic
from nctakt.messages.commands.project import (
    MACHINE_BESIDE_PROGRAM,
    MACHINE_OF_SETTING,
    RUN_ON_DEMO_MACHINE,
    RUN_ON_MACHINE_OF_FILE,
)
from nctakt.project.project_file import Project, find_project

#: The environment variable for the machine.
MACHINE_VARIABLE = "NCTAKT_MACHINE"

#: Maximum number of lists next to a program read to find a start-up list of an unusual name.
_MAX_LISTS = 50
#: Folders that are searched for a machine near a program, at most.
_MAX_FOLDERS = 50


@dataclass(frozen=True, slots=True)
class MachineChoice:
    """A machine's folder or start-up list, and the setting that names it.

    ``setting``: the environment variable or the project file; empty for the machine around the
    program and for the built-in one. ``overlooked``: a list next to a program on the built-in
    machine that has the entries of a start-up list, but no usual name; ``nearby``: a start-up list
    in a folder next to such a program.
    """

    path: Path
    setting: str = ""
    overlooked: Path | None = None
    nearby: Path | None = None

    @property
    def is_demo(self) -> bool:
        """Whether it is the built-in machine, with no setting that says so."""
        return self.path == DEMO_FOLDER and not self.setting

    @property
    def shown(self) -> str:
        """The machine as a message names it."""
        is_built_in = self.path.parent == DEMO_FOLDER.parent
        return self.path.name if is_built_in else self.path.as_posix()

    def note(self) -> Diagnostic | None:
        """Return the note that names the machine (901064, 900816).

        That of the demo machine names the list that it may be about (902944, 902967); ``None`` if
        there is none.
        """
        if self.setting:
            return diagnostic(MACHINE_OF_SETTING, machine=self.shown, source=self.setting)
        if self.overlooked is not None:
            return diagnostic(RUN_ON_DEMO_MACHINE, file=self.overlooked.as_posix())
        if self.nearby is not None:
            folder = shlex.quote(self.nearby.parent.as_posix())
            return diagnostic(MACHINE_BESIDE_PROGRAM, file=self.nearby.as_posix(), folder=folder)
        return None if self.is_demo else diagnostic(RUN_ON_MACHINE_OF_FILE, file=self.shown)


def machine_of_environment() -> MachineChoice | None:
    """Return the machine that ``NCTAKT_MACHINE`` names, seen from the working directory."""
    word = os.environ.get(MACHINE_VARIABLE)
    return MachineChoice(machine_folder(word, Path()), MACHINE_VARIABLE) if word else None


def choose_machine(
    program: Path | None, project: Project | None, access: FileAccess
) -> MachineChoice:
    """Return the machine of a program (``None``: a text without a folder).

    The machine around a program counts only where ``access`` admits it.
    """
    from_environment = machine_of_environment()
    if from_environment is not None:
        return from_environment
    if project is not None and project.machine is not None:
        return MachineChoice(project.machine, project.file.as_posix())
    if program is None:
        return MachineChoice(DEMO_FOLDER)
    startup = startup_list_around(program)
    if startup is None or not access.admits(startup):
        overlooked = _overlooked_list(program.parent, access)
        nearby = None if overlooked is not None else _list_nearby(program.parent, access)
        return MachineChoice(DEMO_FOLDER, overlooked=overlooked, nearby=nearby)
    return MachineChoice(startup)


def _overlooked_list(folder: Path, access: FileAccess) -> Path | None:
    """Return the first list in a folder that is a start-up list by its entries alone."""
    try:
        paths = sorted(path for path in folder.iterdir() if path.suffix.lower() == LIST_SUFFIX)
    except OSError:
        return None
    if not paths:
        return None
    from nctakt.lists.machine.list_kinds import is_startup_list  # noqa: PLC0415 - seldom needed

    found = (path for path in paths[:_MAX_LISTS] if is_startup_list(path, access))
    return next(found, None)


def _list_nearby(folder: Path, access: FileAccess) -> Path | None:
    """Return the first start-up list in the folders of a folder, or in its siblings.

    The latter count within the working directory: ``nc/part.nc`` next to ``lists/hochlauf.lis``.
    """
    above = folder.resolve().parent
    is_within = above.is_relative_to(Path.cwd())
    for searched in (folder, *((folder.parent,) if is_within else ())):
        try:
            inner = sorted(one for one in searched.iterdir() if not one.name.startswith("."))
            folders = [one for one in inner if one.is_dir() and not one.is_symlink()]
        except OSError:
            continue
        for one in folders[:_MAX_FOLDERS]:
            found = next((path for path in startup_lists(one) if access.admits(path)), None)
            if found is not None:
                return found
    return None


def machine_of(program: Path, access: FileAccess) -> MachineChoice:
    """Return the machine of a program or a test by its own project; raises ``Failure``."""
    return choose_machine(program, find_project(program, access), access)

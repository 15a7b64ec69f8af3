# SPDX-License-Identifier: MIT
"""Which machine a program runs on, and is checked for, if none is named.

In: a program, its project. Out: ``MachineChoice``: the machine of the environment, else that of the
project file, else the one in whose folder the program lies, else the built-in one; and the note
that says which.
"""

from __future__ import annotations

import os
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import DEMO_FOLDER, machine_folder, startup_list_around
from nctakt.messages import diagnostic
from nctakt.messages.commands.project import MACHINE_OF_SETTING, RUN_ON_MACHINE_OF_FILE
from nctakt.project.project_file import Project, find_project

#: The environment variable for the machine.
MACHINE_VARIABLE = "NCTAKT_MACHINE"


@dataclass(frozen=True, slots=True)
class MachineChoice:
    """A machine's folder or start-up list, and the setting that names it.

    ``setting``: the environment variable or the project file; empty for the machine around the
    program and for the built-in one.
    """

    path: Path
    setting: str = ""

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
        """Return the note that names the machine (901064, 900816); ``None`` if it is the demo."""
        if self.setting:
            return diagnostic(MACHINE_OF_SETTING, machine=self.shown, source=self.setting)
        return None if self.is_demo else diagnostic(RUN_ON_MACHINE_OF_FILE, file=self.shown)


def machine_of_environment() -> MachineChoice | None:
    """Return the machine that ``NCTAKT_MACHINE`` names, seen from the working directory."""
    word = os.environ.get(MACHINE_VARIABLE)
    return MachineChoice(machine_folder(word, Path()), MACHINE_VARIABLE) if word else None


def choose_machine(
    program: Path | None, project: Project | None, access: FileAccess
) -> MachineChoice:
    """Return the machine of a program (``None``: a text that lies nowhere).

    The machine around a program counts only where ``access`` admits it.
    """
    from_environment = machine_of_environment()
    if from_environment is not None:
        return from_environment
    if project is not None and project.machine is not None:
        return MachineChoice(project.machine, project.file.as_posix())
    startup = None if program is None else startup_list_around(program)
    if startup is None or not access.admits(startup):
        return MachineChoice(DEMO_FOLDER)
    return MachineChoice(startup)


def machine_of(program: Path, access: FileAccess) -> MachineChoice:
    """Return the machine of a program or a test by its own project; raises ``Failure``."""
    return choose_machine(program, find_project(program, access), access)

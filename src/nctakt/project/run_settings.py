# SPDX-License-Identifier: MIT
"""The settings of a run: missing ones come from environment and project file.

In: programs, and the settings of a command, a test, a plan or a launch configuration. Out:
``RunSettings``. Every kind of run takes them from here, so that a program has one result, however
it is started.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import TimeLike
from nctakt.lists.machine.files import machine_folder
from nctakt.messages import diagnostic
from nctakt.messages.commands.project import (
    PROGRAMS_OF_DIFFERENT_MACHINES,
    PROJECT_FMU_NOT_POSSIBLE,
    PROJECT_NOT_TRUSTED,
)
from nctakt.messages.plcs.fmu import NOTHING_TO_ISOLATE
from nctakt.project.machine_choice import MachineChoice, choose_machine, machine_of
from nctakt.project.project_file import FmuSettings, Place, Project, find_project
from nctakt.project.trust import list_of_trusted, why_distrusted

#: Uses of a project's FMU in a run.
FmuUse = Literal["run", "leave_out", "refuse"]

#: The word for the built-in PLC, if the project file names another.
DEFAULT_PLC = "default"


@dataclass(frozen=True, slots=True, kw_only=True)
class Named:
    """Settings in the words of a run themselves; ``None`` and empty: not set.

    ``plcs``: files, ``DEFAULT_PLC`` for the built-in PLC; ``has_plc``: it has one that is no file;
    ``fmu``: a file; ``fmu_use``: whether it runs that of the project, leaves it out, or has to
    refuse it; ``isolates``: whether it gives an FMU a separate process. ``values``: the variables
    that it sets before the first tick. ``is_limited``: it has a limit of another form than
    ``until``. ``base``: the folder from which machine and PLC are seen.
    """

    machine: str | Path | None = None
    plcs: tuple[str | Path, ...] = ()
    has_plc: bool = False
    fmu: str | Path | None = None
    fmu_use: FmuUse = "refuse"
    isolates: bool = False
    values: Collection[str] = ()
    until: TimeLike | None = None
    is_limited: bool = False
    base: Path = Path()


@dataclass(frozen=True, slots=True, kw_only=True)
class RunSettings:
    """The settings that a run uses.

    ``machine`` ``None``: the demo machine, because none is named; ``machine_note`` says which
    setting names it. ``plcs`` in the order of a tick; empty: the built-in one, or one that is no
    file. ``values``: those of variables before the first tick, besides those that the run sets
    itself.
    """

    machine: Path | None
    machine_note: Diagnostic | None
    plcs: tuple[Path, ...]
    fmu: FmuSettings | None
    values: Mapping[str, float | str]
    until: TimeLike | None
    language: Language | None
    signals: tuple[str, ...] | None
    project: Project | None

    @property
    def plc(self) -> Path | None:
        """The file of the PLC where there is one at most."""
        return next(iter(self.plcs), None)

    def placed(self, failure: Failure) -> Failure:
        """Return a failure of the run; mistakes in a project's value have their place there."""
        project = self.project
        if project is None:
            return failure
        return Failure(
            *(
                project.placed(found) if found.values.get("name") in self.values else found
                for found in failure.diagnostics
            )
        )


def run_settings(
    programs: Sequence[Path], access: FileAccess, named: Named | None = None
) -> RunSettings:
    """Return the settings of a run of programs, by the project of the first one.

    Without programs it is the project of the working directory. Raises ``Failure`` for an invalid
    project file (901060 …), one that names code and is not trusted (902025), a file that ``access``
    does not admit, and programs of several machines (901065).
    """
    named = named or Named()
    project = find_project(programs[0] if programs else Path(), access)
    machine, note = None, None
    if named.machine is not None:
        machine = machine_folder(named.machine, named.base)
    else:
        choice = _machine_of_all(programs, project, access)
        machine, note = None if choice.is_demo else choice.path, choice.note()
    is_limited = named.is_limited or named.until is not None
    of_project = {} if project is None else project.values
    return RunSettings(
        machine=machine,
        machine_note=note,
        plcs=_plcs(named, project, access),
        fmu=_isolated(named, _fmu(named, project, access)),
        values={name: value for name, value in of_project.items() if name not in named.values},
        until=named.until if is_limited or project is None else project.until,
        language=None if project is None else project.language,
        signals=None if project is None else project.signals,
        project=project,
    )


def _plcs(named: Named, project: Project | None, access: FileAccess) -> tuple[Path, ...]:
    """Return the files of the PLCs; none: the built-in one."""
    found: tuple[Path, ...] = ()
    if named.plcs:
        files = [(one, named.base / one) for one in named.plcs]
        found = tuple(file for one, file in files if str(one) != DEFAULT_PLC or file.exists())
    elif not named.has_plc and project is not None:
        found = project.plcs
        for file in found:
            access.check_admitted(file)
            check_trusted(project, "plc", file, project.places["plc"])
        for stub in project.stubs:
            access.check_admitted(stub.file)
    return found


def _fmu(named: Named, project: Project | None, access: FileAccess) -> FmuSettings | None:
    """Return the FMU coupled to the PLC with its connections; ``None`` without one."""
    found = None if project is None else project.fmu
    if named.fmu is not None:
        return replace(found or FmuSettings(), file=named.base / named.fmu)
    if project is None or found is None or found.file is None or named.fmu_use == "leave_out":
        return None
    if named.fmu_use == "refuse":
        raise Failure(diagnostic(PROJECT_FMU_NOT_POSSIBLE, *project.places["fmu"]))
    access.check_admitted(found.file)
    check_trusted(project, "fmu", found.file, project.places["fmu"])
    return found


def _isolated(named: Named, fmu: FmuSettings | None) -> FmuSettings | None:
    """Return the FMU in a separate process, if that is requested; raises ``Failure`` (902734)."""
    if not named.isolates:
        return fmu
    if fmu is None:
        raise Failure(diagnostic(NOTHING_TO_ISOLATE))
    return replace(fmu, isolate=True)


def check_trusted(project: Project, key: str, code: Path, location: Place) -> None:
    """Raise ``Failure`` (902025) for an entry that names code and may be somebody else's."""
    folder = project.file.absolute().parent
    reason = why_distrusted((project.file, code), folder)
    if reason is not None:
        found = diagnostic(
            PROJECT_NOT_TRUSTED,
            *location,
            key=key,
            reason=reason,
            folder=str(folder),
            list=str(list_of_trusted()),
        )
        raise Failure(found)


def _machine_of_all(
    programs: Sequence[Path], project: Project | None, access: FileAccess
) -> MachineChoice:
    """Return the machine of all programs; raises ``Failure`` (901065) if they have several."""
    if not programs:
        return choose_machine(None, project, access)
    first = programs[0]
    machine = choose_machine(first, project, access)
    seen = {first.parent}
    for program in programs[1:]:
        if program.parent in seen:
            continue
        seen.add(program.parent)
        other = machine_of(program, access)
        if other.path != machine.path:
            raise Failure(
                diagnostic(
                    PROGRAMS_OF_DIFFERENT_MACHINES,
                    first=str(first),
                    machine=machine.shown,
                    second=str(program),
                    other=other.shown,
                )
            )
    return machine

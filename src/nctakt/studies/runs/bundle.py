# SPDX-License-Identifier: MIT
"""A plan with the files that it needs, for a machine that does not have them.

In: a plan, and further files and wheels that a user sends along. Out: ``Bundle``, which can be
sent; ``write`` puts its files into a folder, ``plan`` returns the plan with the paths there.
Built-in machines are part of nctakt and stay where they are.
"""

from __future__ import annotations

import hashlib
import io
import pickle
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.base.version import __version__
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import EXTRA_MISSING, UPLOAD_TOO_LARGE
from nctakt.messages.extras import install_command
from nctakt.messages.files import FILE_NOT_READABLE
from nctakt.studies.measuring.python_measure import PythonMeasure
from nctakt.studies.plans.plan import Plan
from nctakt.studies.plans.user_modules import MAX_BYTES, UserModules, files_below
from nctakt.studies.runs.plan_files import files_of

#: Folders of a wheel whose content is installed next to its packages.
_LIBRARIES = ("purelib", "platlib")


@dataclass(frozen=True, slots=True)
class Bundle:
    """``files``: absolute path -> content; ``built_in``: the name of a built-in machine, if any.

    ``shown``: absolute path -> its name in messages.
    ``packed``: the plan, which may name functions of the modules. ``modules``: the first parts of
    their names; ``folders``: where they are found; ``wheels``: name -> content. ``version``: of the
    nctakt that has made it.
    """

    packed: bytes
    files: tuple[tuple[str, bytes], ...]
    built_in: str
    modules: tuple[str, ...]
    folders: tuple[str, ...]
    wheels: tuple[tuple[str, bytes], ...]
    shown: tuple[tuple[str, str], ...]
    version: str = __version__

    @property
    def key(self) -> str:
        """Digits that change with the plan and the files."""
        return hashlib.sha256(pickle.dumps(self)).hexdigest()[:16]

    def write(self, folder: Path) -> list[str]:
        """Write the files below a folder; return the folders in which modules are found there."""
        for name, content in self.files:
            path = _below(folder, Path(name))
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        found = [str(_below(folder, Path(name))) for name in self.folders]
        for name, content in self.wheels:
            found += _install(content, folder / "wheels" / name)
        return found

    def shown_names(self, folder: Path) -> dict[str, str]:
        """Return the names in messages of the files below a folder, by their names there."""
        return {_below(folder, Path(name)).as_posix(): shown for name, shown in self.shown}

    def plan(self, folder: Path) -> Plan:
        """Return the plan with the paths of its files below a folder."""
        plan: Plan = pickle.loads(self.packed)
        return _with_paths(plan, lambda path: _below(folder, path), self.built_in)


def _with_paths(plan: Plan, changed: Callable[[Path], Path], built_in: str = "") -> Plan:
    """Return a plan with its paths changed; ``built_in``: the name of a built-in machine."""

    def of(path: Path | None) -> Path | None:
        return None if path is None else changed(path)

    return replace(
        plan,
        program=changed(plan.program) if plan.text is None else plan.program,
        machine=DEMO_FOLDER.parent / built_in if built_in else of(plan.machine),
        plcs=tuple(map(changed, plan.plcs)),
        rtconf=of(plan.rtconf),
        load=of(plan.load),
        dimensions=tuple(
            replace(one, values=tuple(str(changed(Path(str(value)))) for value in one.values))
            if one.has_files
            else one
            for one in plan.dimensions
        ),
        measures=tuple(
            replace(one, node=replace(one.node, file=changed(one.node.file)))
            if isinstance(one.node, PythonMeasure)
            else one
            for one in plan.measures
        ),
    )


def _below(folder: Path, path: Path) -> Path:
    return folder / path.relative_to(path.anchor)


def _install(content: bytes, folder: Path) -> list[str]:
    """Put the files of a wheel into a folder; return the folders in which its modules are found."""
    with zipfile.ZipFile(io.BytesIO(content)) as wheel:
        wheel.extractall(folder)
    libraries = (entry / name for entry in folder.glob("*.data") for name in _LIBRARIES)
    return [str(folder), *(str(entry) for entry in libraries if entry.is_dir())]


def bundle(plan: Plan, uploads: Sequence[Path] = ()) -> Bundle:
    """Return a plan with its files: program and files it calls, lists, PLC, series, measures.

    The modules of the user that they import go along. ``uploads``: further files, folders, modules
    and wheels. Raises ``Failure``: a plan that cannot be used, an upload that cannot be read
    (900500 …) or is too large (901484).
    """
    try:
        import cloudpickle  # noqa: PLC0415 - comes with the extra
    except ImportError as error:
        raise Failure(
            diagnostic(EXTRA_MISSING, package="distributed", install=install_command("cluster"))
        ) from error
    needed = files_of(plan)
    modules = needed.modules
    files = [*needed.files, *modules.files]
    names, folders, wheels = list(modules.names), list(modules.folders), []
    for path in (path.resolve() for path in uploads):
        if path.suffix == ".whl":
            wheels.append((path.name, _wheel(path)))
            names += _modules_in(wheels[-1][1])
            continue
        further = UserModules()
        further.add_file(path)
        files += [*(files_below(path) if path.is_dir() else [path]), *further.files]
        names += further.names
        folders += further.folders
    machine = None if plan.is_schedule else (plan.machine or DEMO_FOLDER).resolve()
    own = DEMO_FOLDER.parent.resolve()
    built_in = machine.name if machine is not None and machine.is_relative_to(own) else ""
    access = FileAccess()
    contents = {
        str(path): access.read_bytes(path) for path in files if not path.is_relative_to(own)
    }
    if sum(map(len, contents.values())) > MAX_BYTES:
        largest = max(contents, key=lambda name: len(contents[name]))
        raise Failure(diagnostic(UPLOAD_TOO_LARGE, file=largest, limit=MAX_BYTES >> 20))
    return Bundle(
        cloudpickle.dumps(_with_paths(replace(plan, machine=machine), Path.resolve)),
        tuple(sorted(contents.items())),
        built_in,
        tuple(dict.fromkeys(names)),
        tuple(dict.fromkeys(map(str, folders))),
        tuple(wheels),
        tuple(zip(map(str, needed.files), needed.shown, strict=True)),
    )


def _wheel(path: Path) -> bytes:
    """Return the content of a wheel; raises ``Failure`` if it is not one."""
    content = FileAccess().read_bytes(path)
    if not zipfile.is_zipfile(io.BytesIO(content)):
        reason = "not a wheel"
        raise Failure(diagnostic(FILE_NOT_READABLE, file=path.as_posix(), reason=reason))
    return content


def _modules_in(wheel: bytes) -> list[str]:
    """Return the first parts of the names of the modules in a wheel."""
    with zipfile.ZipFile(io.BytesIO(wheel)) as archive:
        entries = [Path(name).parts for name in archive.namelist()]
    firsts = (entry[2] if entry[0].endswith(".data") and len(entry) > 2 else entry[0]
              for entry in entries)  # fmt: skip
    return [name.partition(".")[0] for name in firsts if not name.endswith((".dist-info", ".data"))]

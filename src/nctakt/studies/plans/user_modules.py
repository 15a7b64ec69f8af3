# SPDX-License-Identifier: MIT
"""The modules of a user that a PLC or a measure imports, for machines that do not have them.

In: Python files. Out: the files of the modules that they import, directly or indirectly, and the
folders in which Python finds them. Imports are read from the texts, also those inside of functions;
nothing is run. Modules of Python itself and packages installed next to nctakt are not the user's,
and a machine that makes runs must have them installed, too.
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import sys
import sysconfig
from collections.abc import Iterable, Iterator
from pathlib import Path

from nctakt.base.dataclass import dataclass, field
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import UPLOAD_TOO_LARGE
from nctakt.project.imports import imported_names

#: The most bytes of files that go along with the runs of a study.
MAX_BYTES = 64 << 20

#: Folders in which packages are installed.
_INSTALLED = ("site-packages", "dist-packages")

_OUR_FOLDER = Path(__file__).parents[2]


@dataclass(slots=True)
class UserModules:
    """``names``: of modules; ``files``: theirs; ``folders``: those in which Python finds them."""

    names: dict[str, None] = field(default_factory=dict)
    files: dict[Path, None] = field(default_factory=dict)
    folders: dict[Path, None] = field(default_factory=dict)

    def trace(self, files: Iterable[Path]) -> None:
        """Add the modules that Python files import, and those that these import."""
        waiting = [path.resolve() for path in files]
        known = dict.fromkeys(waiting)
        while waiting:
            path = waiting.pop()
            for name in imported_names(path):
                for new in self._add(name, path.parent):
                    if new not in known:
                        known[new] = None
                        waiting.append(new)

    def add(self, name: str) -> None:
        """Add a module that this process has, by its name, and those that it imports."""
        self.trace(self._add(name, Path()))

    def add_file(self, path: Path) -> None:
        """Add a module by its file, or by the folder of a package; any other path adds nothing."""
        if path.suffix == ".py" or (path / "__init__.py").exists():
            self.trace(self._add(path.stem, path.parent))

    def _add(self, name: str, folder: Path) -> list[Path]:
        """Add a module by its name; return its Python files."""
        spec = _spec(name, folder)
        if spec is None:
            return []
        roots = [Path(entry) for entry in spec.submodule_search_locations or ()]
        own = roots or ([Path(spec.origin)] if spec.origin and spec.has_location else [])
        own = [path.resolve() for path in own]
        if not own or not all(map(is_users, own)):
            return []
        self.names[name] = None
        found = []
        for entry in own:
            self.folders[entry.parent] = None
            found += list(files_below(entry)) if entry.is_dir() else [entry]
        self.files |= dict.fromkeys(found)
        return [path for path in found if path.suffix == ".py"]


def is_users(path: Path) -> bool:
    """Return whether a file is a user's: neither Python's, nor installed, nor nctakt's."""
    if any(part in _INSTALLED for part in path.parts) or path.is_relative_to(_OUR_FOLDER):
        return False
    own = (sysconfig.get_path("stdlib"), sysconfig.get_path("platstdlib"))
    return not any(path.is_relative_to(Path(entry).resolve()) for entry in own)


def files_below(folder: Path) -> Iterator[Path]:
    """Yield the files below a folder, without hidden and compiled ones.

    Raises ``Failure`` (901317) if they are too large to go along with runs.
    """
    size = 0
    for path in sorted(folder.rglob("*")):
        below = path.relative_to(folder).parts
        if not path.is_file() or any(part.startswith((".", "__pycache__")) for part in below):
            continue
        size += path.stat().st_size
        if size > MAX_BYTES:
            raise Failure(
                diagnostic(UPLOAD_TOO_LARGE, file=folder.as_posix(), limit=MAX_BYTES >> 20)
            )
        yield path


def _spec(name: str, folder: Path) -> importlib.machinery.ModuleSpec | None:
    """Return where Python finds a module for a file in a folder; ``None``: nowhere."""
    if name in sys.stdlib_module_names or name == "nctakt":
        return None
    try:
        beside = importlib.machinery.PathFinder.find_spec(name, [str(folder)])
        return beside or importlib.util.find_spec(name)
    except (ImportError, ValueError):  # a missing module is reported when it is imported
        return None

# SPDX-License-Identifier: MIT
"""Compiled or plain: which form of the realtime part is imported.

Modules with types in a ``.pxd`` next to them, all of ``nctakt.kernel`` and some of other packages,
are Python files that are compiled at installation where there is a C compiler. ``use_plain``,
called before the first of them is imported, makes Python import the files themselves: slower, for
debuggers and coverage, with the same results. The environment variable ``NCTAKT_PLAIN=1`` does the
same.
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

_PACKAGE = "nctakt."


class _PlainFinder:
    """Finds the Python file of a module next to its compiled form."""

    @staticmethod
    def find_spec(
        name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        """Return the file's spec for a module of this package, nothing for any other."""
        if not name.startswith(_PACKAGE) or path is None:
            return None
        file = Path(next(iter(path))) / f"{name.rpartition('.')[2]}.py"
        if not file.exists():
            return None  # a package
        return importlib.util.spec_from_file_location(name, file)


def use_plain() -> None:
    """Import the realtime part as plain Python from now on; it must not be imported yet."""
    loaded = [
        name
        for name, module in sys.modules.items()
        if name.startswith(_PACKAGE)
        and str(module.__file__).endswith((".so", ".pyd"))
        and Path(str(module.__file__)).with_name(f"{name.rpartition('.')[2]}.py").exists()
    ]
    assert not loaded, loaded
    if not any(finder is _PlainFinder for finder in sys.meta_path):
        sys.meta_path.insert(0, _PlainFinder)


def is_compiled() -> bool:
    """Return whether the realtime part runs compiled."""
    if any(finder is _PlainFinder for finder in sys.meta_path):
        return False
    spec = importlib.util.find_spec(f"{_PACKAGE}kernel.kernel")
    assert spec is not None
    return isinstance(spec.loader, importlib.machinery.ExtensionFileLoader)


if os.environ.get("NCTAKT_PLAIN") == "1":
    use_plain()

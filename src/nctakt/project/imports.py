# SPDX-License-Identifier: MIT
"""Imports of a user's Python file, read from its text: nothing is run.

In: Python files. Out: the names that they import, also inside of functions, and the files next to
them that Python would use for these names.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from importlib.machinery import BYTECODE_SUFFIXES, SOURCE_SUFFIXES
from pathlib import Path

#: The folder next to a module in which Python keeps compiled files.
_TRANSLATED = "__pycache__"
#: Suffixes of files that Python loads: sources, compiled ones, libraries.
_ENDINGS = (*SOURCE_SUFFIXES, *BYTECODE_SUFFIXES, ".so", ".pyd")


def imported_names(path: Path) -> Iterator[str]:
    """Yield the first part of each name that a Python file imports."""
    try:
        tree = ast.parse(path.read_bytes())
    except (OSError, SyntaxError, ValueError, RecursionError):  # reported by who imports it
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name.partition(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            yield node.module.partition(".")[0]
        elif isinstance(node, ast.Call) and node.args:
            word = getattr(node.func, "attr", getattr(node.func, "id", ""))
            name = getattr(node.args[0], "value", None)
            if word in ("import_module", "__import__") and isinstance(name, str):
                yield name.partition(".")[0]


def with_imports(files: Iterable[Path]) -> Iterator[Path]:
    """Yield files; after a Python file all files next to it that Python may use for its imports.

    A name of a standard module counts, too: the folder of a user's file is searched first.
    """
    known: dict[Path, None] = {}
    waiting = list(files)
    while waiting:
        path = waiting.pop(0)
        if path in known:
            continue
        known[path] = None
        yield path
        if path.suffix == ".py" and path.is_file():
            folder = Path(path).resolve().parent
            for name in dict.fromkeys((path.stem, *imported_names(path))):
                waiting += _modules(name, folder)


def _modules(name: str, folder: Path) -> Iterator[Path]:
    """Yield the files of a module of a folder: its own, its package's, compiled ones."""
    searched = [(folder, f"{name}.*"), (folder / _TRANSLATED, f"{name}.*"), (folder / name, "**/*")]
    for below, pattern in searched:
        yield from (path for path in sorted(below.glob(pattern)) if path.suffix in _ENDINGS)

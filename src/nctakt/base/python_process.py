# SPDX-License-Identifier: MIT
"""How nctakt starts Python: with modules of nctakt and of libraries, not of the folder it is in.

Python looks for modules in the working directory first, for ``-m`` and ``-c``: a ``json.py`` next
to a program that somebody only opens would run. Only this module names the interpreter;
``tests/test_tidy.py`` enforces that.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

#: The environment variable equivalent to Python's option ``-P``.
_SAFE_PATH = "PYTHONSAFEPATH"

#: The environment variable that says which warnings a Python process prints.
_WARNINGS = "PYTHONWARNINGS"

_SEARCH_PATH = "PYTHONPATH"

#: How variables of the environment begin that Python, its libraries and nctakt read at their start.
_READ_AT_START = ("PYTHON", "NCTAKT_", "LC_", "LANG", "LD_")


def python_command(module: str, *words: str) -> list[str]:
    """Return the command that starts a module of nctakt."""
    return [sys.executable, "-P", "-m", module, *words]


def python_environment() -> dict[str, str]:
    """Return the environment of such a command: it finds this nctakt, wherever it starts.

    Entries of ``PYTHONPATH`` name the same folders as in this process, also from another working
    directory; an empty entry, which means the working directory, is left out.
    """
    entries = os.environ.get(_SEARCH_PATH, "").split(os.pathsep)
    named = [str(Path(entry).absolute()) for entry in entries if entry]
    search = os.pathsep.join([str(Path(__file__).parents[2]), *named])
    return {**os.environ, _SEARCH_PATH: search}


def at_start() -> tuple[object, ...]:
    """Return what decides how such a command starts: the interpreter, and files read then."""
    read = {name: value for name, value in os.environ.items() if name.startswith(_READ_AT_START)}
    return sys.executable, read


def start_resource_tracker() -> None:
    """Start Python's resource tracker, which removes the shared memory of a killed process.

    It is a separate Python process, which prints no warning.
    """
    if sys.platform == "win32":
        return
    from multiprocessing import resource_tracker  # noqa: PLC0415 - most runs share no memory

    changed = {_SAFE_PATH: "1", _WARNINGS: "ignore::UserWarning"}
    before = {name: os.environ.get(name) for name in changed}
    os.environ.update(changed)
    try:
        resource_tracker.ensure_running()
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value

# SPDX-License-Identifier: MIT
"""Output of ``nctakt`` without a subcommand: the path of five commands, and the full version.

In: the working directory. Out: the path with the lists and programs that lie there, so that a
person can copy it. Only the folder and those right below it are looked at; of the programs there,
the path shows the first one with a realtime cycle, because its last commands are about cycles.
"""

from __future__ import annotations

import contextlib
import platform
import re
import shlex
import sys
from collections.abc import Iterator
from importlib import metadata
from itertools import islice
from pathlib import Path

from nctakt.base.diagnostics import Language, Text
from nctakt.base.mode import is_compiled
from nctakt.base.version import __version__
from nctakt.checking.inputs import PROGRAM_SUFFIXES
from nctakt.lists.machine.files import startup_lists
from nctakt.project.project_file import OWN_NAME

_PATH = Text("The path from your folder to an answer", "Der Weg vom eigenen Ordner zur Antwort")
_STEPS = (
    ("nctakt check {folder}", Text("find mistakes", "Fehler finden")),
    ("nctakt run {program}{machine}", Text("run it", "ausführen")),
    ("nctakt live {program}{machine} --open", Text("see it in the browser", "im Browser ansehen")),
    ("nctakt why {program}{machine}", Text("why reactions came", "warum Reaktionen kamen")),
    (
        "nctakt init --ci github",
        Text("project, first test, CI", "Projekt, erster Test, CI"),
    ),
)

#: How many programs are searched for a realtime cycle, and how far.
_SEARCHED, _SEARCHED_BYTES = 50, 10_000

#: A requirement of an extra, as the metadata of the package has it.
_REQUIREMENT = re.compile(r"([\w.-]+)[^;]*(?:;.*extra == ['\"](\w+)['\"])?")
#: Extras of extras, and for those who work on nctakt itself.
_INTERNAL = ("all", "docs", "test")


def path_lines(language: Language, folder: Path) -> Iterator[str]:
    """Yield the path of five commands with the files of a folder."""
    program = _program(folder)
    machine = next((path.parent for path in _startup_lists(folder)), folder)
    shown = machine.relative_to(folder).as_posix()
    is_chosen = (folder / OWN_NAME).exists() or (folder / program).is_relative_to(machine)
    option = "" if is_chosen else f" --machine {shlex.quote(shown)}"
    names = {"folder": shlex.quote(shown), "program": shlex.quote(program), "machine": option}
    steps = [(command.format(**names), text) for command, text in _STEPS]
    width = max(len(command) for command, _ in steps)
    yield f"{_PATH.get(language)}:"
    for command, text in steps:
        yield f"  {command.ljust(width)}  {text.get(language)}"


def _folders(folder: Path) -> Iterator[Path]:
    """Yield a folder and those right below it, without hidden ones."""
    yield folder
    with contextlib.suppress(OSError):  # a folder without permission to read
        for path in sorted(folder.iterdir()):
            if not path.name.startswith(".") and path.is_dir() and not path.is_symlink():
                yield path


def _program(folder: Path) -> str:
    """Return the program that the path shows."""
    programs = list(islice(_programs(folder), _SEARCHED))
    for program in programs:
        with contextlib.suppress(OSError), (folder / program).open("rb") as file:
            if b"#RT CYCLE" in file.read(_SEARCHED_BYTES):
                return program
    return programs[0] if programs else "part.nc"


def _programs(folder: Path) -> Iterator[str]:
    for inner in _folders(folder):
        for path in sorted(inner.glob("*.*")):
            if path.suffix.casefold() in PROGRAM_SUFFIXES and path.is_file():
                yield path.relative_to(folder).as_posix()


def _startup_lists(folder: Path) -> Iterator[Path]:
    for inner in _folders(folder):
        yield from startup_lists(inner)


def version_lines() -> Iterator[str]:
    """Yield data for a fault report: version, platform, compiled and installed parts."""
    yield f"nctakt {__version__}"
    yield f"Python {platform.python_version()} ({sys.implementation.name}), {platform.platform()}"
    yield f"realtime part: {'compiled' if is_compiled() else 'plain Python'}"
    extras: dict[str, list[str]] = {}
    for requirement in metadata.requires("nctakt") or ():
        found = _REQUIREMENT.match(requirement)
        if found is not None and found[2] not in _INTERNAL:
            extras.setdefault(found[2] or "", []).append(f"{found[1]} {_version(found[1])}")
    for extra in sorted(extras):
        yield f"{f'extra {extra}' if extra else 'libraries'}: {', '.join(extras[extra])}"


def _version(name: str) -> str:
    """Return the version of a library, ``–`` if it is not installed."""
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return "–"

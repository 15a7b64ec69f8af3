# SPDX-License-Identifier: MIT
"""``--watch``: a command carried out again whenever a file that it reads has changed.

In: the command as a function of a ``FileAccess``, its files and folders. Out: the exit code of the
last run, after Ctrl-C or SIGTERM. The library watchfiles (extra ``watch``) reports changes; changes
while the command ran are found by the state of the files when they were read.
"""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.base.interrupts import terminations
from nctakt.checking.inputs import LIST_SUFFIXES, PROGRAM_SUFFIXES
from nctakt.cli.common.request import STANDARD_INPUT
from nctakt.cli.common.terminal import complain
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import (
    WATCH_LIBRARY_MISSING,
    WATCH_OF_STDIN,
    WATCHING_FILES,
)
from nctakt.st.files.suffixes import PLC_SUFFIXES

if TYPE_CHECKING:
    from types import ModuleType

#: Ends of the names of files that may concern a command though it has not read them yet.
_SUFFIXES = (*PROGRAM_SUFFIXES, *LIST_SUFFIXES, *PLC_SUFFIXES, ".py", ".toml")

#: Files with their time of change and size.
_State = dict[Path, tuple[int, int]]

#: Wall-clock time between two looks at the files that were read.
_LOOK_MS = 500


def watch(
    carry_out: Callable[[FileAccess], int],
    open_access: Callable[[], FileAccess],
    named: Sequence[str],
    language: Language,
) -> int:
    """Carry out a command, and again at each change; its last exit code after Ctrl-C or SIGTERM.

    During a run Ctrl-C ends the run alone, SIGTERM the watching, too. ``named``: the files and
    folders of the command line. Raises ``Failure``: the library is not installed (901067), standard
    input is named (901068).
    """
    library = _library()
    if STANDARD_INPUT in named:
        raise Failure(diagnostic(WATCH_OF_STDIN))
    access = open_access()
    while True:
        folders = _folders(named, access)
        before = _state(folders)
        access = open_access()
        modules = set(sys.modules)
        asked = terminations()
        code = carry_out(access)
        if terminations() != asked:
            return code
        _forget_users_modules(modules)
        sys.stdout.flush()
        new = [folder for folder in _folders(named, access) if folder not in folders]
        folders += new
        before |= _state(new)
        waiting = diagnostic(WATCHING_FILES, count=len(access.read_files)).headline(language)
        try:  # from the moment on at which the user reads that it waits
            complain(waiting)
            _wait(library, folders, access, before)
        except KeyboardInterrupt:
            return code


def _library() -> ModuleType:
    try:
        import watchfiles  # noqa: PLC0415 - only with --watch
    except ImportError as error:
        raise Failure(diagnostic(WATCH_LIBRARY_MISSING)) from error
    return watchfiles


def _forget_users_modules(before: set[str]) -> None:
    """Forget modules that the user's PLC has imported from next to it: they may change, too."""
    own = Path(__file__).parents[2]
    for name in sorted(set(sys.modules) - before):
        file = getattr(sys.modules[name], "__file__", None)
        if file is None or "site-packages" in file or _is_standard(name):
            continue
        if not Path(file).is_relative_to(own):
            del sys.modules[name]


def _is_standard(name: str) -> bool:
    return name.partition(".")[0] in sys.stdlib_module_names


def _folders(names: Sequence[str], access: FileAccess) -> list[Path]:
    """Return the folders of all files that the command has read or was given."""
    folders: dict[Path, None] = {}
    for path in (*map(Path, names), *access.read_files):
        for folder in _with_inner(path) if path.is_dir() else (path.parent,):
            if folder.is_dir():
                folders[folder.resolve()] = None
    return list(folders) or [Path.cwd()]


def _with_inner(folder: Path) -> Iterator[Path]:
    """Yield a folder and all that are in it but for hidden ones."""
    yield folder
    for inner in folder.iterdir():
        if inner.is_dir() and not inner.is_symlink() and not inner.name.startswith("."):
            yield from _with_inner(inner)


def _state(folders: Sequence[Path]) -> _State:
    """Return the files in folders that may concern a command, with time and size."""
    states: _State = {}
    for folder in folders:
        with contextlib.suppress(OSError):  # it has just been deleted
            for path in sorted(folder.iterdir()):
                if path.suffix.casefold() in _SUFFIXES or path.is_dir():
                    state = path.stat()
                    states[path] = (0, 0) if path.is_dir() else (state.st_mtime_ns, state.st_size)
    return states


def _wait(library: ModuleType, folders: Sequence[Path], access: FileAccess, before: _State) -> None:
    """Return when a file has changed that concerns the command; ``KeyboardInterrupt`` by Ctrl-C."""
    for _ in library.watch(
        *folders,
        watch_filter=None,
        debounce=200,
        rust_timeout=_LOOK_MS,
        yield_on_timeout=True,
        recursive=False,
    ):
        if access.has_changed() or _state(folders) != before:
            return

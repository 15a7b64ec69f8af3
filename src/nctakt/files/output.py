# SPDX-License-Identifier: MIT
"""A file of results, which gets its name when it is complete.

In: a path, the option that names it, text or bytes. Out: the file. It is written under a name that
no file has, as ``trace.partial.csv`` for ``trace.csv``, else ``trace.partial-2.csv`` …, and renamed
at the end: an earlier file stays until then, and a truncated file (a full disk, Ctrl-C, the process
killed) can be read under a name that says so. A device or a pipe is written directly.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import stat
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import IO, Self

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.files import (
    FILE_NOT_WRITABLE,
    FOLDER_INSTEAD_OF_FILE,
    OUTPUT_CUT_OFF,
    OUTPUT_IN_USE,
)

try:
    import fcntl
except ImportError:  # Windows, where two processes cannot open the file to write it anyway
    fcntl = None  # type: ignore[assignment]


#: Names that are tried for a file while it is written.
_MAX_PARTIAL = 1000


class OutputFile:
    """A file to write; raises ``Failure`` (900507) at once if it cannot be written.

    ``option`` is named in the message if the file is an input (900913) or another output (900914)
    of the same ``access``. An earlier file is only replaced if ``write`` is called.
    """

    def __init__(
        self, path: str | Path, option: str = "output", access: FileAccess | None = None
    ) -> None:
        self.name = str(path)
        self._option = option
        self._access = FileAccess() if access is None else access
        self._target = Path(os.path.realpath(path))
        self._partial: Path | None = None
        self._has_begun = False
        self._has_failed = False
        try:
            self._file = self._opened()
        except OSError as error:
            raise self._unwritable(error) from error

    def _opened(self) -> IO[bytes]:
        option, access = self._option, self._access
        state = _state_of(Path(self.name))
        access.claim(state, self.name, option)
        if state is not None and stat.S_ISDIR(state.st_mode):
            raise Failure(diagnostic(FOLDER_INSTEAD_OF_FILE, file=self.name))
        if state is not None and not stat.S_ISREG(state.st_mode):
            self._target = Path(self.name)  # the link of a pipe does not lead to a path
            return self._target.open("wb", buffering=0)
        if state is not None and not os.access(self._target, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        access.claim_place(self._target, option)
        return self._new_file(state)

    def _new_file(self, state: os.stat_result | None) -> IO[bytes]:
        """Return the file under a name that no file has; ``state``: of the one to be replaced."""
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND | getattr(os, "O_BINARY", 0)
        for number in range(1, _MAX_PARTIAL + 1):
            partial = _partial_path(self._target, number)
            if self._access.is_claimed(partial):
                continue
            try:
                file = os.fdopen(os.open(partial, flags, 0o666), "wb", buffering=0)
                break
            except FileExistsError:
                continue
        else:
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST))
        try:
            self._lock(file, partial)
            self._access.claim(os.fstat(file.fileno()), partial, self._option)
            if state is not None:
                partial.chmod(stat.S_IMODE(state.st_mode))
        except BaseException:
            file.close()
            partial.unlink()
            raise
        self._partial = partial
        return file

    def _lock(self, file: IO[bytes], partial: Path) -> None:
        """Keep other processes from writing the same file; raises ``Failure`` (900919).

        If two come at once, each locks its own file before it looks for that of the other.
        """
        if fcntl is None:
            return
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if any(other != partial and _is_locked(other) for other in _partial_files(self._target)):
            raise Failure(diagnostic(OUTPUT_IN_USE, file=self.name))

    def write(self, data: str | bytes) -> None:
        """Append to the data written by this command; the first call begins a new file.

        Raises ``Failure`` (900507, 900918) if the system refuses it.
        """
        self._has_begun = True
        try:
            rest = memoryview(data if isinstance(data, bytes) else _encoded(data))
            while rest:  # the system may take a part only
                rest = rest[self._file.write(rest) :]
        except OSError as error:
            self._has_failed = True
            raise self._unwritable(error) from error

    def fill(self, write: Callable[[Path], object]) -> None:
        """Let ``write`` create the file at a path; raises ``Failure`` as the method ``write``."""
        self._has_begun = True
        try:
            write(self._partial or self._target)
        except OSError as error:
            self._has_failed = True
            raise self._unwritable(error) from error

    def close(self) -> None:
        """Give the file its name, or without a ``write`` leave an earlier file; may be repeated.

        Raises ``Failure`` if the file cannot be renamed (900507) or has been read since (900913);
        it then keeps its partial name.
        """
        if self._file.closed:
            return
        try:
            with contextlib.closing(self._file):
                if fcntl is None:  # a file that is open cannot be renamed
                    self._file.close()
                if self._partial is not None and not self._has_begun:
                    self._partial.unlink()
                elif self._partial is not None and not self._has_failed:
                    self._access.check_unread(_state_of(self._target), self.name, self._option)
                    self._partial.replace(self._target)
        except OSError as error:
            if not self._has_failed:  # else it has been reported
                raise self._unwritable(error) from error

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, _type: object, error: BaseException | None, _traceback: TracebackType | None
    ) -> None:
        """Close the file; after an exception the file keeps its partial name."""
        if error is None:
            self.close()
        else:
            self._give_up(error)

    def _give_up(self, error: BaseException) -> None:
        """Leave the file under its partial name, and report it with the error."""
        if self._file.closed:
            return
        self._file.close()
        if self._partial is None:
            return
        state = _state_of(self._partial)
        if not self._has_begun or (not self._has_failed and state and not state.st_size):
            with contextlib.suppress(OSError):
                self._partial.unlink()
            return
        found = diagnostic(OUTPUT_CUT_OFF, file=self._partial.as_posix())
        if not isinstance(error, Failure):
            error.add_note(found.render())
        elif found not in error.diagnostics:
            raise Failure(*error.diagnostics, found) from error

    def _unwritable(self, error: OSError) -> Failure:
        diagnostics = [
            diagnostic(FILE_NOT_WRITABLE, file=self.name, reason=error.strerror or str(error))
        ]
        if self._has_begun and self._partial is not None:
            diagnostics.append(diagnostic(OUTPUT_CUT_OFF, file=self._partial.as_posix()))
        return Failure(*diagnostics)


def write_file(
    path: str | Path,
    data: str | bytes,
    option: str = "output",
    access: FileAccess | None = None,
) -> None:
    """Write a whole file; raises ``Failure`` as ``OutputFile``."""
    with OutputFile(path, option, access) as file:
        file.write(data)


def check_outputs(outputs: Mapping[str, str | Path], access: FileAccess) -> None:
    """Raise ``Failure`` at once for files that could not be written when their data are ready.

    ``outputs``: option -> file; ``access``: of what the command reads. Files are not changed.
    """
    with contextlib.ExitStack() as files:
        for option, name in outputs.items():
            path = Path(name)
            if not (path.is_fifo() or path.is_char_device() or path.is_socket()):
                files.enter_context(OutputFile(name, option, access))


def _partial_path(path: Path, number: int) -> Path:
    """Return a name of a file while it is written: ``out.partial.csv``, ``out.partial-2.csv`` …"""
    mark = "partial" if number == 1 else f"partial-{number}"
    return path.with_name(f"{path.stem}.{mark}{path.suffix}")


def _partial_files(path: Path) -> Iterator[Path]:
    """Yield the files that are there under such names."""
    form = re.compile(rf"{re.escape(path.stem)}\.partial(-\d+)?{re.escape(path.suffix)}")
    try:
        files = list(path.parent.iterdir())
    except OSError:  # a folder without permission to read
        return
    yield from (file for file in files if form.fullmatch(file.name))


def _is_locked(path: Path) -> bool:
    """Return whether a process has locked a file, as the one that writes it does."""
    assert fcntl is not None
    try:
        number = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:  # no plain file, or one that has just got its name
        return False
    try:
        fcntl.flock(number, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    except OSError:
        return False
    finally:
        os.close(number)
    return False


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", errors="backslashreplace")


def _state_of(path: Path) -> os.stat_result | None:
    try:
        return path.stat()
    except FileNotFoundError:
        return None

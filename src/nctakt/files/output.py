# SPDX-License-Identifier: MIT
"""A file of results, which gets its name when it is complete.

In: a path, the option that names it, text or bytes. Out: the file. It is written under another
name, as ``trace.partial.csv`` for ``trace.csv``, and renamed at the end: an earlier file stays
until then, and a file that is cut off (a full disk, the process killed) can be read under a name
that says so. A device or a pipe is written directly.
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from collections.abc import Callable, Mapping
from pathlib import Path
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
        partial = partial_path(self._target)
        before = _state_of(partial)
        access.claim(before, partial, option, self.name)
        flags = os.O_WRONLY | os.O_CREAT | os.O_APPEND
        flags |= getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
        file = os.fdopen(os.open(partial, flags, 0o666), "wb", buffering=0)
        try:
            self._lock(file, partial)
            if before is None:
                access.claim(os.fstat(file.fileno()), partial, option)
            file.truncate(0)
            if state is not None:
                partial.chmod(stat.S_IMODE(state.st_mode))
        except BaseException:
            file.close()
            raise
        self._partial = partial
        return file

    def _lock(self, file: IO[bytes], partial: Path) -> None:
        """Keep other processes from writing the same file; raises ``Failure`` (900919)."""
        if fcntl is None:
            return
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            is_ours = os.path.samestat(os.fstat(file.fileno()), partial.stat())
        except (BlockingIOError, FileNotFoundError):
            is_ours = False
        if not is_ours:  # another process writes it, or has just given it its name
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

    def __exit__(self, *_: object) -> None:
        self.close()

    def _unwritable(self, error: OSError) -> Failure:
        diagnostics = [
            diagnostic(FILE_NOT_WRITABLE, file=self.name, reason=error.strerror or str(error))
        ]
        if self._has_begun and self._partial is not None:
            diagnostics.append(diagnostic(OUTPUT_CUT_OFF, file=self._partial.as_posix()))
        return Failure(*diagnostics)


def write_file(path: str | Path, data: str | bytes) -> None:
    """Write a whole file; raises ``Failure`` as ``OutputFile``."""
    with OutputFile(path) as file:
        file.write(data)


def check_outputs(outputs: Mapping[str, str | Path], access: FileAccess) -> None:
    """Raise ``Failure`` at once for files that could not be written when their data are ready.

    ``outputs``: option -> file; ``access``: of what the command reads. Files stay as they are.
    """
    with contextlib.ExitStack() as files:
        for option, name in outputs.items():
            path = Path(name)
            if not (path.is_fifo() or path.is_char_device() or path.is_socket()):
                files.enter_context(OutputFile(name, option, access))


def partial_path(path: Path) -> Path:
    """Return the name of a file while it is written: ``out.partial.csv``."""
    return path.with_name(f"{path.stem}.partial{path.suffix}")


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", errors="backslashreplace")


def _state_of(path: Path) -> os.stat_result | None:
    try:
        return path.stat()
    except FileNotFoundError:
        return None

# SPDX-License-Identifier: MIT
"""Access to the files that a command reads and writes.

In: paths as users, lists and programs name them. Out: their bytes or lines, or a ``Failure``: the
size of a file that is read at once is bounded, files outside the allowed folders are refused, and
no file is both read and written by one command. Files are compared by device and inode, not by
name.
"""

from __future__ import annotations

import io
import os
import stat
from collections.abc import Sequence
from pathlib import Path
from typing import BinaryIO, TextIO

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.long_text import LinesTooLong, LongText, is_long
from nctakt.base.misspelling import nearest
from nctakt.base.text import decode_text, split_lines
from nctakt.messages import diagnostic
from nctakt.messages.files import (
    FILE_MISSING,
    FILE_NOT_READABLE,
    FILE_OUTSIDE,
    FILE_TOO_LONG,
    FOLDER_INSTEAD_OF_FILE,
    MISSPELT_FILE,
    NOT_A_REGULAR_FILE,
    OUTPUT_IS_READ,
    OUTPUTS_ARE_ONE_FILE,
)

#: Maximum size of a file that is read at once, in bytes: a list, or a program from a pipe.
MAX_BYTES = 64 << 20

#: Bytes at the begin of a file that decide whether it is a text.
BEGIN_BYTES = 8192

#: The lists of the built-in machine, which may always be read.
_BUILT_IN = os.path.realpath(Path(__file__).parent.parent / "machines")

#: The name shown for standard input.
STDIN_NAME = Path("<stdin>")

#: Device and inode of a file.
Identity = tuple[int, int]


class FileAccess:
    """The files of one command; only files in ``folders`` are read, all files if it is empty."""

    def __init__(self, folders: Sequence[str | Path] = ()) -> None:
        self.folders = tuple(os.path.realpath(folder) for folder in folders)
        self._read: dict[Identity, tuple[Path, os.stat_result]] = {}
        self._written: dict[Identity, str] = {}
        self._places: dict[tuple[Identity, str], str] = {}
        self._replaced: dict[str, bytes] = {}

    @property
    def read_files(self) -> list[Path]:
        """The files that were read so far, without standard input."""
        return [path for path, _ in self._read.values() if path != STDIN_NAME]

    @property
    def replaces_files(self) -> bool:
        """Whether a file has another content here than on disk."""
        return bool(self._replaced)

    def has_changed(self) -> bool:
        """Return whether a file has changed since it was read."""
        return any(
            _is_other(path, state) for path, state in self._read.values() if path != STDIN_NAME
        )

    # --- reading ---------------------------------------------------------------------------------

    def admits(self, path: str | Path) -> bool:
        """Return whether the file lies in one of the folders, links resolved."""
        if not self.folders:
            return True
        real = Path(os.path.realpath(path))
        return any(real.is_relative_to(folder) for folder in (*self.folders, _BUILT_IN))

    @property
    def shown_folders(self) -> str:
        """The folders as text for a message."""
        return ", ".join(Path(folder).as_posix() for folder in self.folders)

    def check_admitted(self, path: str | Path) -> None:
        """Raise ``Failure`` (900917) for a path outside of the folders, even without a file."""
        if not self.admits(path):
            file = Path(path).as_posix()
            raise Failure(diagnostic(FILE_OUTSIDE, file=file, folders=self.shown_folders))

    def replace(self, path: Path, data: bytes) -> None:
        """Let ``read_bytes`` return this content for a file, which need not be there."""
        self._replaced[os.path.realpath(path)] = data

    def note(self, path: str | Path) -> None:
        """Note that a file is read; raises ``Failure`` (900913, 900917)."""
        self.check_admitted(path)
        try:
            self.note_state(Path(path).stat(), path)
        except OSError:
            return  # reported by its reader

    def note_all(self, other: FileAccess) -> None:
        """Note the files that ``other`` has read; raises ``Failure`` (900913)."""
        for path, state in other._read.values():
            self.note_state(state, path)

    def note_state(self, state: os.stat_result, path: str | Path) -> None:
        """Note a file by its state; raises ``Failure`` (900913) if it is written as well."""
        if not _can_be_lost(state):
            return
        identity = (state.st_dev, state.st_ino)
        self._read.setdefault(identity, (Path(path), state))
        if identity in self._written:
            raise Failure(
                diagnostic(OUTPUT_IS_READ, option=self._written[identity], file=str(path))
            )

    def read_bytes(self, path: Path, *, is_replaced: bool = False) -> bytes:
        """Return the content of a file of at most ``MAX_BYTES``.

        ``is_replaced``: the command may write it again. Raises ``Failure``: not there (900500), a
        folder (900501), unreadable (900503), read and written (900913), too long (900915), outside
        of the folders (900917).
        """
        if self._replaced:
            self.check_admitted(path)
            data = self._replaced.get(os.path.realpath(path))
            if data is not None:
                return data
        file = self._opened(path, is_replaced=is_replaced)
        try:
            with file:
                return read_stream(file, str(path))
        except OSError as error:
            raise _unreadable(path, error) from error

    def read_lines(self, path: Path) -> Sequence[str]:
        """Return the lines of a file; those of a long plain file are read when they are needed.

        Raises ``Failure`` as ``read_bytes``; a plain file may have any length, its lines may not.
        """
        file = self._opened(path)
        try:
            with file:
                if is_long(file):
                    return LongText(path)
                return split_lines(decode_text(read_stream(file, str(path))).text)
        except LinesTooLong as error:
            raise _too_long(path) from error
        except OSError as error:
            raise _unreadable(path, error) from error

    def open_text(self, path: Path, encoding: str) -> TextIO:
        """Return a text of any length, open to be read line by line; raises as ``read_bytes``.

        Bytes that the encoding has not become a mark of that.
        """
        return io.TextIOWrapper(self._opened(path), encoding=encoding, errors="replace")

    def read_begin(self, path: Path) -> bytes:
        """Return the first ``BEGIN_BYTES`` of a file; raises ``Failure`` as ``read_bytes``."""
        file = self._opened(path)
        try:
            with file:
                return file.read(BEGIN_BYTES)
        except OSError as error:
            raise _unreadable(path, error) from error

    def _opened(self, path: Path, *, is_replaced: bool = False) -> BinaryIO:
        """Open a file and note that it is read."""
        if "\0" in str(path):  # no file has such a name
            raise Failure(diagnostic(FILE_MISSING, file=str(path).replace("\0", "\\0")))
        self.check_admitted(path)
        try:
            if self.folders and path.exists() and not (path.is_file() or path.is_dir()):
                raise Failure(diagnostic(NOT_A_REGULAR_FILE, file=str(path)))  # it may never end
            file = path.open("rb")
        except FileNotFoundError as error:
            raise Failure(diagnostic(FILE_MISSING, file=str(path))) from error
        except IsADirectoryError as error:
            raise Failure(diagnostic(FOLDER_INSTEAD_OF_FILE, file=str(path))) from error
        except OSError as error:
            raise _unreadable(path, error) from error
        if not is_replaced:
            try:
                self.note_state(os.fstat(file.fileno()), path)
            except Failure:
                file.close()
                raise
        return file

    # --- writing ---------------------------------------------------------------------------------

    def claim(self, state: os.stat_result | None, path: str | Path, option: str) -> None:
        """Let ``option`` write a file whose state is ``state``, ``None`` for a new file.

        Raises ``Failure`` if it is read (900913) or written (900914) by this command.
        """
        self.check_unread(state, path, option)
        if state is None or not _can_be_lost(state):
            return
        identity = (state.st_dev, state.st_ino)
        other = self._written.get(identity)
        if other is not None:
            found = diagnostic(OUTPUTS_ARE_ONE_FILE, option=option, other=other, file=str(path))
            raise Failure(found)
        self._written[identity] = option

    def claim_place(self, path: Path, option: str) -> None:
        """Let ``option`` give a file this name later; raises ``Failure`` (900914), ``OSError``."""
        other = self._places.setdefault(_place_of(path), option)
        if other != option:
            found = diagnostic(OUTPUTS_ARE_ONE_FILE, option=option, other=other, file=str(path))
            raise Failure(found)

    def is_claimed(self, path: Path) -> bool:
        """Return whether an output will get this name; raises ``OSError``."""
        return _place_of(path) in self._places

    def check_unread(self, state: os.stat_result | None, path: str | Path, option: str) -> None:
        """Raise ``Failure`` (900913) if a file has been read meanwhile."""
        if state is not None and (state.st_dev, state.st_ino) in self._read:
            raise Failure(diagnostic(OUTPUT_IS_READ, option=option, file=str(path)))


def is_file_or_folder(path: Path) -> bool:
    """Return whether there is a regular file or a folder: what a file may name.

    Reading a pipe or a device may never end, and no system takes each name.
    """
    try:
        return path.is_file() or path.is_dir()
    except (OSError, ValueError):
        return False


def _place_of(path: Path) -> tuple[Identity, str]:
    """Return folder and name of a file that may not be there yet."""
    folder = path.parent.stat()
    return (folder.st_dev, folder.st_ino), path.name


def _is_other(path: Path, before: os.stat_result) -> bool:
    try:
        now = path.stat()
    except OSError:
        return True
    return (now.st_mtime_ns, now.st_size, now.st_ino) != (
        before.st_mtime_ns,
        before.st_size,
        before.st_ino,
    )


def read_stream(file: BinaryIO, name: str) -> bytes:
    """Return the content of an open file; raises ``Failure`` (900915) beyond ``MAX_BYTES``."""
    data = file.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise _too_long(name)
    return data


def _can_be_lost(state: os.stat_result) -> bool:
    """Return whether it is a regular file, not a device such as /dev/null."""
    return not stat.S_ISCHR(state.st_mode)


def _too_long(name: str | Path) -> Failure:
    return Failure(diagnostic(FILE_TOO_LONG, file=str(name), limit=MAX_BYTES))


def missing_file(path: Path) -> Diagnostic:
    """Return the mistake in a path that leads nowhere, with the similar name probably meant.

    Only a path that the user has written belongs here.
    """
    try:
        names = sorted(one.name for one in path.parent.iterdir())
    except OSError:
        names = []
    near = nearest(path.name, names)
    if near:
        shown = (path.parent / near).as_posix()
        return diagnostic(MISSPELT_FILE, file=path.as_posix(), nearest=shown)
    return diagnostic(FILE_MISSING, file=str(path))


def _unreadable(path: Path, error: OSError) -> Failure:
    reason = error.strerror or str(error)
    return Failure(diagnostic(FILE_NOT_READABLE, file=str(path), reason=reason))

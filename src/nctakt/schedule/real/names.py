# SPDX-License-Identifier: MIT
"""The named semaphores of a run, and those that a killed run has left behind.

In: names. Out: semaphores that exist while the run lasts. Before a run creates one, it writes its
name into a locked file. The scheduler removes semaphores and file at the end. If all processes were
killed, the file is still there without a lock: the next run removes the semaphores in it.
"""

from __future__ import annotations

import fcntl
import os
from contextlib import suppress
from pathlib import Path

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.linux_run import (
    INVALID_LINUX_SEMAPHORE_NAME,
    SEMAPHORE_EXISTS,
    SEMAPHORE_NOT_CREATED,
)
from nctakt.schedule.real.area import NAME_SIZE

#: The system's folder of named semaphores, empty after a restart.
FOLDER = Path("/dev/shm")
_PREFIX = "nctakt-schedule."
#: The system's prefix of a semaphore's name in ``FOLDER``.
_SYSTEM_PREFIX = "sem."
_FOR_ONE_USER, _FOR_ALL_USERS = 0o600, 0o666


def check_name(name: str) -> None:
    """Raise ``Failure`` (900684) if a name, with its slash, is not valid for a semaphore."""
    if "/" in name[1:] or len(os.fsencode(name)) > NAME_SIZE - len(_SYSTEM_PREFIX):
        raise Failure(diagnostic(INVALID_LINUX_SEMAPHORE_NAME, name=name))


class SemaphoreNames:
    """The semaphores of one run; raises ``Failure`` (900684, 900685, 900686).

    ``for_all_users``: processes of other users may wait on them, too.
    """

    def __init__(self, names: list[str], *, for_all_users: bool = False) -> None:
        for name in names:
            check_name(name)
        self._names = names
        self._mode = _FOR_ALL_USERS if for_all_users else _FOR_ONE_USER
        self._created: list[str] = []
        self.record = FOLDER / f"{_PREFIX}{os.getpid()}"
        self._handle = -1
        if not names:
            return
        try:
            self._handle = _open(self.record, os.O_CREAT | os.O_EXCL | os.O_WRONLY)
            fcntl.flock(self._handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise Failure(_refusal(str(self.record), error)) from error
        try:
            for name in names:
                self._make(name)
        except Failure:
            self.remove()
            raise

    def _make(self, name: str) -> None:
        from nctakt.schedule.real import processes  # noqa: PLC0415 - it may be missing

        # First the record, then the semaphore: each existing semaphore is in the record.
        os.write(self._handle, f"{name}\n".encode())
        try:
            processes.create(name)
        except FileExistsError as error:
            raise Failure(diagnostic(SEMAPHORE_EXISTS, name=name)) from error
        except OSError as error:
            raise Failure(_refusal(name, error)) from error
        self._created.append(name)
        try:
            _file_of(name).chmod(self._mode)
        except OSError as error:
            raise Failure(_refusal(name, error)) from error

    def remove(self) -> None:
        """Remove all semaphores and the record."""
        _remove_semaphores(self._created)
        self._created.clear()
        if self._names:
            self.record.unlink(missing_ok=True)
        self.release()

    def release(self) -> None:
        """Release the record's lock; the scheduler has removed everything."""
        if self._handle >= 0:
            os.close(self._handle)
            self._handle = -1


def _open(path: Path, flags: int) -> int:
    return os.open(path, flags | os.O_NOFOLLOW | os.O_CLOEXEC, 0o600)


def _refusal(name: str, error: OSError) -> Diagnostic:
    return diagnostic(SEMAPHORE_NOT_CREATED, name=name, reason=error.strerror or str(error))


def _remove_semaphores(names: list[str]) -> None:
    from nctakt.schedule.real import processes  # noqa: PLC0415 - it may be missing

    for name in names:
        with suppress(FileNotFoundError):
            processes.remove(name)


def remove_stale() -> list[str]:
    """Remove the semaphores of killed runs of this user; return their names."""
    names: list[str] = []
    for record in sorted(FOLDER.glob(f"{_PREFIX}*")):
        try:
            handle = _open(record, os.O_RDWR)
        except OSError:  # of another user, or just removed
            continue
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if os.fstat(handle).st_uid == os.geteuid():
                names += _clear(record, handle)
        except BlockingIOError:  # its run is alive
            pass
        finally:
            os.close(handle)
    return names


def _clear(record: Path, handle: int) -> list[str]:
    names = os.read(handle, 1 << 16).decode("utf-8", "replace").split("\n")[:-1]
    existing = [name for name in names if _file_of(name).exists()]
    _remove_semaphores(existing)
    record.unlink(missing_ok=True)
    return existing


def _file_of(name: str) -> Path:
    return FOLDER / f"{_SYSTEM_PREFIX}{name[1:]}"

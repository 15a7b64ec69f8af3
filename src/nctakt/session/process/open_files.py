# SPDX-License-Identifier: MIT
"""Files that a PLC in Python holds open while its controller is copied.

In: the descriptors of this process. Out: files that are only read are opened again by the copy, at
the same place; all others would be shared by both, and are refused by name.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Collection, Iterator
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import PLC_HOLDS_OPEN

_DESCRIPTORS = Path("/proc/self/fd")

#: Standard input, output and error.
_STANDARD = 3

#: Files that are named in the diagnostic at most.
_MAX_NAMED = 3


def check_open_files(own: Collection[int]) -> list[int]:
    """Return the descriptors that a copy must reopen; ``own`` are not the PLC's.

    Raises ``Failure`` (902060) if the PLC holds something open that two processes must not share.
    """
    import fcntl  # noqa: PLC0415 - not on Windows, where nothing is copied

    again: list[int] = []
    held: list[str] = []
    for descriptor, name, mode in _opened(own):
        flags = fcntl.fcntl(descriptor, fcntl.F_GETFL)
        if stat.S_ISREG(mode) and flags & os.O_ACCMODE == os.O_RDONLY:
            again.append(descriptor)
        elif not (stat.S_ISDIR(mode) or stat.S_ISCHR(mode)):
            held.append(name)
    if held:
        shown = ", ".join(held[:_MAX_NAMED]) + (", …" if len(held) > _MAX_NAMED else "")
        raise Failure(diagnostic(PLC_HOLDS_OPEN, names=shown))
    return again


def open_again(descriptors: Collection[int]) -> None:
    """Give this process its own positions in files shared with the process it is a copy of."""
    for descriptor in descriptors:
        position = os.lseek(descriptor, 0, os.SEEK_CUR)
        opened = os.open(_DESCRIPTORS / str(descriptor), os.O_RDONLY | os.O_CLOEXEC)
        os.lseek(opened, position, os.SEEK_SET)
        os.dup2(opened, descriptor, inheritable=False)
        os.close(opened)


def _opened(own: Collection[int]) -> Iterator[tuple[int, str, int]]:
    """Yield the descriptors of the PLC, each with its name and its mode."""
    for path in sorted(_DESCRIPTORS.iterdir(), key=lambda one: int(one.name)):
        descriptor = int(path.name)
        if descriptor < _STANDARD or descriptor in own:
            continue
        try:
            name, mode = str(path.readlink()), os.fstat(descriptor).st_mode
        except OSError:  # it belonged to this list
            continue
        yield descriptor, name, mode

# SPDX-License-Identifier: MIT
"""Named shared memory that another process has made.

In: its name. Out: its bytes. On Linux it is a file in ``/dev/shm``; elsewhere Python's class finds
it. Only its maker removes it, never an attached process.
"""

from __future__ import annotations

import mmap
import sys
from pathlib import Path

from nctakt.base.python_process import start_resource_tracker
from nctakt.hli.layout import MAGIC

#: The folder of shared memory on Linux.
FOLDER = Path("/dev/shm")


class SharedFile:
    """The bytes of shared memory; raises ``OSError`` or ``ValueError`` if there is none."""

    def __init__(self, name: str) -> None:
        if not name or "/" in name or "\0" in name:
            raise ValueError(name)
        if FOLDER.is_dir():
            with (FOLDER / name).open("r+b") as file:
                self._map = mmap.mmap(file.fileno(), 0)
            self.memory = memoryview(self._map)
            self._close = self._map.close
        else:
            from multiprocessing import resource_tracker  # noqa: PLC0415 - not on Linux
            from multiprocessing.shared_memory import SharedMemory  # noqa: PLC0415 - as above

            start_resource_tracker()
            shared = SharedMemory(name)
            if sys.platform != "win32":
                # the maker removes it; without this the end of this process would
                resource_tracker.unregister(f"/{name}", "shared_memory")
            self.memory = memoryview(shared.buf or b"")
            self._close = shared.close

    def close(self) -> None:
        """Let go of the bytes; views of them are released before."""
        self.memory.release()
        self._close()


def image_names() -> list[str]:
    """Return the names of all images of an HLI that can be found; none outside Linux."""
    found = []
    for path in sorted(FOLDER.glob("*")) if FOLDER.is_dir() else ():
        try:
            with path.open("rb") as file:
                if file.read(len(MAGIC)) == MAGIC:
                    found.append(path.name)
        except OSError:
            continue  # another user's
    return found

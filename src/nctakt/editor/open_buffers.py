# SPDX-License-Identifier: MIT
"""The files of a check, with the texts that are open in the editor in place of those on disk."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from nctakt.files.access import BEGIN_BYTES, FileAccess

#: The lines of a file that is open in the editor, ``None`` for any other file.
Buffers = Callable[[Path], Sequence[str] | None]

#: The state of a file: for an open one its number of lines and content, else time and size.
_Stamp = tuple[object, ...]


class OpenBuffers(FileAccess):
    """Reads open texts from the editor, all other files from disk."""

    def __init__(self, buffers: Buffers, folders: Sequence[str | Path] = ()) -> None:
        super().__init__(folders)
        self._buffers = buffers
        self._noted: dict[Path, _Stamp] = {}

    def read_bytes(self, path: Path, *, is_replaced: bool = False) -> bytes:
        self._noted[path] = self.state_of(path)
        lines = self._buffers(path)
        if lines is None:
            return super().read_bytes(path, is_replaced=is_replaced)
        self.check_admitted(path)
        return "\n".join(lines).encode("utf-8", "surrogatepass")

    def read_lines(self, path: Path) -> Sequence[str]:
        lines = self._buffers(path)
        if lines is None:
            return super().read_lines(path)
        self.check_admitted(path)
        return lines

    def read_begin(self, path: Path) -> bytes:
        lines = self._buffers(path)
        if lines is None:
            return super().read_begin(path)
        text = "\n".join(lines[:BEGIN_BYTES])
        return text[:BEGIN_BYTES].encode("utf-8", "surrogatepass")[:BEGIN_BYTES]

    def is_outdated(self) -> bool:
        """Return whether a file that was read as a whole has changed since."""
        noted = list(self._noted.items())  # a check in another thread may note another one
        return any(self.state_of(path) != stamp for path, stamp in noted)

    def state_of(self, path: Path) -> _Stamp:
        """Return a key that changes with the text of a file, open or not."""
        lines = self._buffers(path)
        if lines is not None:
            return (len(lines), hash(tuple(lines)))
        try:
            state = path.stat()
        except OSError:
            return ()
        return (state.st_mtime_ns, state.st_size, state.st_ino)

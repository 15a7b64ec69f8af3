# SPDX-License-Identifier: MIT
"""Data from an editor, read ahead by a separate thread.

In: bytes of standard input or of a port. Out: lines and bodies, as pygls reads them. A thread that
waits for an editor cannot be ended; a thread that waits here can.
"""

from __future__ import annotations

import threading
from collections.abc import Callable

#: The longest line of a header, and the longest message, in bytes; a program of a million lines
#: has some thirty million.
MAX_LINE, MAX_MESSAGE = 1024, 256 * 1024 * 1024

#: Bytes read at once, and maximum waiting beyond those requested.
_CHUNK, _MAX_WAITING = 65536, 1 << 20

#: Replacement for a message that is too long: not valid in the protocol, and reported as such.
_NOTHING = b"null"


class Incoming:
    """Bytes of an editor from ``read``, which returns some, and none at the end; ``first``: before.

    ``end`` wakes the waiting reader with the end of data.
    """

    def __init__(self, read: Callable[[int], bytes], first: bytes = b"") -> None:
        self._read = read
        self._data = bytearray(first)
        self._needed = 0
        self._changed = threading.Condition()
        self._is_ended = False
        threading.Thread(target=self._read_on, name="nctakt lsp reader", daemon=True).start()

    def _read_on(self) -> None:
        try:
            while data := self._read(_CHUNK):
                with self._changed:
                    self._data += data
                    self._changed.notify_all()
                    self._changed.wait_for(self._has_room)
                    if self._is_ended:
                        return
        except (OSError, ValueError):
            pass  # the editor has gone
        self.end()

    def _has_room(self) -> bool:
        return self._is_ended or len(self._data) < self._needed + _MAX_WAITING

    def end(self) -> None:
        """End: nothing comes any more."""
        with self._changed:
            self._is_ended = True
            self._changed.notify_all()

    def readline(self) -> bytes:
        """Return the next line, or the start of an overlong one; nothing at the end."""
        with self._changed:
            self._changed.wait_for(
                lambda: b"\n" in self._data or len(self._data) >= MAX_LINE or self._is_ended
            )
            length = self._data.find(b"\n", 0, MAX_LINE) + 1
            return self._taken(length or MAX_LINE)

    def read(self, size: int) -> bytes:
        """Return this many bytes, less at the end; ``null`` where they are too many."""
        if size <= MAX_MESSAGE:
            return self._awaited(size)
        while size > 0 and (passed := self._awaited(min(size, _CHUNK))):
            size -= len(passed)
        return _NOTHING

    def _awaited(self, size: int) -> bytes:
        with self._changed:
            self._needed = size
            self._changed.notify_all()
            self._changed.wait_for(lambda: len(self._data) >= size or self._is_ended)
            self._needed = 0
            return self._taken(size)

    def _taken(self, size: int) -> bytes:
        taken = bytes(memoryview(self._data)[:size])
        del self._data[: len(taken)]
        self._changed.notify_all()
        return taken

# SPDX-License-Identifier: MIT
"""The one listener of all servers: reports of the session -> calls in the loop of the servers.

In: frames and notices, in the session's thread. Out: the same in the loop, in their order. The
session never waits: when the loop falls behind, the oldest frames are left out, and counted.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable

from nctakt.session.listening import Frame, Listener, Notice

#: Frames that wait for the loop at most; at 1,000 a second these are four seconds.
MAX_FRAMES = 4096

#: Frames a second: as many as there are slices.
_EACH_SLICE_HZ = 1e6


class Feed(Listener):
    """Hands frames and notices on into a loop; ``missed``: frames that were left out."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        take_frame: Callable[[Frame], None],
        take_notice: Callable[[Notice], None],
    ) -> None:
        super().__init__((), _EACH_SLICE_HZ, wants_events=False)
        self._loop = loop
        self._take_frame = take_frame
        self._take_notice = take_notice
        self._waiting: deque[Frame | Notice] = deque()
        self._is_called = False
        self.missed = 0

    def is_due(self) -> bool:
        """Return that each slice is of interest."""
        return True

    def give(self, frame: Frame) -> None:
        """Hand a frame on."""
        with self._changed:
            if len(self._waiting) >= MAX_FRAMES:
                self.missed += 1
                self._waiting.popleft()
            self._hand_on(frame)

    def notify(self, notice: Notice) -> None:
        """Hand a notice on."""
        with self._changed:
            self._hand_on(notice)

    def _hand_on(self, what: Frame | Notice) -> None:
        self._waiting.append(what)
        if not self._is_called:
            self._is_called = True
            try:
                self._loop.call_soon_threadsafe(self._deliver)
            except RuntimeError:
                self._waiting.clear()  # the loop has ended

    def _deliver(self) -> None:
        with self._changed:
            waiting, self._waiting = self._waiting, deque()
            self._is_called = False
        for what in waiting:
            if isinstance(what, Frame):
                self._take_frame(what)
            else:
                self._take_notice(what)

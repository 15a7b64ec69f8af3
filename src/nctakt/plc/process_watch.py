# SPDX-License-Identifier: MIT
"""Whether another process still lives.

In: the process ID. Out: ``is_gone``. Where the system has no means to watch a process of that
number, it counts as living.
"""

from __future__ import annotations

import os
import select


class ProcessWatch:
    """Watches a process; 0, or a number that no process has, is never gone."""

    def __init__(self, process: int) -> None:
        self._poll: select.poll | None = None
        self._handle = -1
        if process <= 0 or not hasattr(os, "pidfd_open"):
            return
        try:
            self._handle = os.pidfd_open(process)
        except (OSError, OverflowError):
            return
        self._poll = select.poll()
        self._poll.register(self._handle, select.POLLIN)

    @property
    def is_gone(self) -> bool:
        """Return whether the process has ended since the watch began."""
        return self._poll is not None and bool(self._poll.poll(0))

    def close(self) -> None:
        """End the watch; twice is no harm."""
        if self._handle >= 0:
            os.close(self._handle)
            self._handle = -1
            self._poll = None

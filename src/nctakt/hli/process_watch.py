# SPDX-License-Identifier: MIT
"""A watch that notices the end of another process.

In: the process ID. Out: ``is_gone``. If the system cannot watch the process, it counts as living.
"""

from __future__ import annotations

import os
import select


class ProcessWatch:
    """Watches a process; the ID 0, and one without a process, is never gone."""

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
        """End the watch; may be repeated."""
        if self._handle >= 0:
            os.close(self._handle)
            self._handle = -1
            self._poll = None


def is_living(process: int) -> bool:
    """Return whether there is a process with this ID; False if the system cannot tell."""
    if not hasattr(os, "pidfd_open"):
        return False
    try:
        os.close(os.pidfd_open(process))
    except PermissionError:
        return True
    except (OSError, OverflowError):
        return False
    return True

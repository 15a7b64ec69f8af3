# SPDX-License-Identifier: MIT
"""Whether a call of an FMU lasts too long: a thread looks, so that a call costs next to nothing.

In: the times at which calls begin and end. Out: a call of ``on_late``, once.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

#: So often within the limit is looked.
_LOOKS = 4


class CallWatch:
    """Watches calls; ``limit_s``: how long one may last; ``on_late`` runs in another thread."""

    def __init__(self, limit_s: float, on_late: Callable[[], None]) -> None:
        self._limit_s = limit_s
        self._on_late = on_late
        self._since = 0.0
        self._stopped = threading.Event()
        threading.Thread(target=self._watch, daemon=True).start()

    def begin(self) -> None:
        """Note that a call begins."""
        self._since = time.monotonic()

    def end(self) -> None:
        """Note that it has ended."""
        self._since = 0.0

    def stop(self) -> None:
        """End the thread."""
        self._stopped.set()

    def _watch(self) -> None:
        while not self._stopped.wait(self._limit_s / _LOOKS):
            since = self._since
            if since and time.monotonic() - since > self._limit_s:
                self._on_late()
                return

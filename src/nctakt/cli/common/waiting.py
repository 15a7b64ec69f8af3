# SPDX-License-Identifier: MIT
"""Waiting on the wall clock for another process."""

from __future__ import annotations

import time
from collections.abc import Callable

#: Checks without a pause: a partner on another core answers within some microseconds.
_EAGER_LOOKS = 50

#: The pause between two later checks, in seconds.
_PAUSE_S = 0.0001


def waiter(seconds: float) -> Callable[[Callable[[], bool]], bool]:
    """Return a function that waits for a condition and returns whether it came true in time."""

    def wait(condition: Callable[[], bool]) -> bool:
        for _ in range(_EAGER_LOOKS):
            if condition():
                return True
            time.sleep(0)
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                return False
            time.sleep(_PAUSE_S)
        return True

    return wait

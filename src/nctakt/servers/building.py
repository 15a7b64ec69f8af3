# SPDX-License-Identifier: MIT
"""Objects that live as long as the servers are built while the garbage collector waits.

It would look through half a million nodes and types again and again, a quarter of a second each
time: three quarters of a start with OPC UA, and later the longest wait of a client.
"""

from __future__ import annotations

import contextlib
import gc
from collections.abc import Callable, Iterator


@contextlib.contextmanager
def building() -> Iterator[Callable[[], None]]:
    """Let the garbage collector wait until the function that it gives is called.

    From then on it scans only later objects; at the end everything is as before.
    """
    was_enabled = gc.isenabled()
    gc.disable()

    def built() -> None:
        gc.freeze()
        gc.enable()

    try:
        yield built
    finally:
        gc.unfreeze()
        if was_enabled:
            gc.enable()
        else:
            gc.disable()

# SPDX-License-Identifier: MIT
"""The progress of a run or a study in a notebook; it changes no result.

In: how much is done, of how much. Out: a bar below the cell, once that has lasted some seconds.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

#: Wall-clock time after which the bar appears, and between two updates.
PATIENCE_S, UPDATE_S = 2.0, 0.5


class NotebookProgress:
    """Shows in a notebook how far something is, once it has lasted ``PATIENCE_S``."""

    def __init__(self, name: str, clock: Callable[[], float] = time.monotonic) -> None:
        self._name = name
        self._clock = clock
        self._next_s = clock() + PATIENCE_S
        self._handle: Any = None

    def show(self, done: int, total: int | None) -> None:
        """Show how much is done, of how much."""
        now_s = self._clock()
        if now_s >= self._next_s:
            self._next_s = now_s + UPDATE_S
            self._display(_bar(self._name, done, total))

    def close(self) -> None:
        """Remove the display."""
        if self._handle is not None:
            self._display("")

    def _display(self, page: str) -> None:
        display = sys.modules["IPython"].display
        shown = display.HTML(page)
        if self._handle is None:
            self._handle = display.display(shown, display_id=True)
        else:
            self._handle.update(shown)


def notebook_progress(name: str) -> NotebookProgress | None:
    """Return a progress display; ``None`` outside a notebook."""
    ipython = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    return NotebookProgress(name) if hasattr(shell, "kernel") else None


def _bar(name: str, done: int, total: int | None) -> str:
    from html import escape  # noqa: PLC0415 - only in a notebook

    of = f" / {total:,}" if total is not None else ""
    limit = "" if total is None else f' max="{total}" value="{min(done, total)}"'
    return f"{escape(name)}: <progress{limit}></progress> {done:,}{of}"

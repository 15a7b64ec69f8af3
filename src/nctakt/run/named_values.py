# SPDX-License-Identifier: MIT
"""Variables by names that are not the machine's own: those of a PLC that runs in the tick."""

from __future__ import annotations

from typing import Protocol


class NamedValues(Protocol):
    """Variables of a PLC by their paths: ``MAIN.fbGate.bOpen``."""

    def knows(self, name: str) -> bool:
        """Return whether a name is one of its variables."""

    def read(self, name: str) -> float | bool | str:
        """Return the value of a variable."""

    def check(self, name: str, value: float | bool | str) -> object:
        """Raise ``Failure`` for a value that the variable cannot hold."""

    def write(self, name: str, value: float | bool | str) -> None:
        """Set a variable from its next cycle on."""

    def signal(self, name: str) -> tuple[int, str, bool] | None:
        """Return where a variable is shown in each tick; ``None`` for what is no number."""

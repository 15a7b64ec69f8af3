# SPDX-License-Identifier: MIT
"""Values by names that are not the machine's own: of a PLC that runs in the tick, and of the
interface by the controller's paths.
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from typing import NamedTuple, Protocol


class SignalCell(NamedTuple):
    """Where a signal is: its cell, its unit, whether it is a whole number.

    ``labels``: numbers and names of the items of an enumeration.
    """

    cell: int
    unit: str = ""
    is_whole: bool = False
    labels: tuple[tuple[int, str], ...] = ()


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

    def signal(self, name: str) -> SignalCell | None:
        """Return where a variable is shown in each tick; ``None`` for what is no number."""


class InterfaceValues(Protocol):
    """Elements of the interface by the controller's paths, and ranges of its bytes."""

    def read(self, name: str) -> float | bool | str:
        """Return what is there."""

    def check(self, name: str, value: float | bool | str) -> None:
        """Raise ``Failure`` for a name or value that ``write`` would not take now."""

    def draft(self) -> AbstractContextManager[None]:
        """Let each write that is checked be known to the checks after it, up to the end."""

    def write(self, name: str, value: float | bool | str, source: str) -> None:
        """Write, with effect from the next tick on."""

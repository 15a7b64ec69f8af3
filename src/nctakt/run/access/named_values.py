# SPDX-License-Identifier: MIT
"""Values by names that do not belong to the machine: of a PLC that runs in the tick, and of the
interface by the controller's paths.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import AbstractContextManager
from typing import NamedTuple, Protocol

from nctakt.base.diagnostics import Diagnostic, Text

#: Programs and lists of a PLC that are named, at most.
_MAX_SCOPES = 5
#: Remedy for a variable of a PLC when there is no PLC.
NO_SCOPES = Text("", "")


class SignalCell(NamedTuple):
    """Where a signal is: its cell, its unit, whether it is a whole number.

    ``labels``: numbers and names of the items of an enumeration. ``is_boolean``: true or false.
    """

    cell: int
    unit: str = ""
    is_whole: bool = False
    labels: tuple[tuple[int, str], ...] = ()
    is_boolean: bool = False


class NamedValues(Protocol):
    """Variables of a PLC by their paths: ``MAIN.fbGate.bOpen``."""

    def knows(self, name: str) -> bool:
        """Return whether a name is one of its variables."""

    def names(self, *, are_numbers: bool) -> Iterator[str]:
        """Yield the paths of its values, without elements of arrays; if so, only of numbers."""

    def read(self, name: str) -> float | bool | str:
        """Return the value of a variable."""

    def check(self, name: str, value: float | bool | str) -> object:
        """Raise ``Failure`` for a value that the variable cannot hold."""

    def write(self, name: str, value: float | bool | str) -> None:
        """Set a variable from its next cycle on."""

    def mistake(self, name: str) -> Diagnostic | None:
        """Return the mistake in the path of a missing part, or of a non-signal; else ``None``."""

    def signal(self, name: str) -> SignalCell | None:
        """Return where a variable is shown in each tick; ``None`` if it is not a number."""


class InterfaceValues(Protocol):
    """Elements of the interface by the controller's paths, and ranges of its bytes."""

    def read(self, name: str) -> float | bool | str:
        """Return the value."""

    def check(self, name: str, value: float | bool | str) -> None:
        """Raise ``Failure`` for a name or value that ``write`` would not take now."""

    def draft(self) -> AbstractContextManager[None]:
        """Make each checked write known to the later checks, up to the end."""

    def write(self, name: str, value: float | bool | str, source: str) -> None:
        """Write, with effect from the next tick on."""


def scopes_text(named: NamedValues | None) -> Text:
    """Return where the variables of PLCs are, as the end of a remedy; empty without any."""
    scopes = "" if named is None else _scopes(named.names(are_numbers=False))
    if not scopes:
        return NO_SCOPES
    return Text(f", those of the PLC in {scopes}", f", die der SPS in {scopes}")


def _scopes(paths: Iterable[str]) -> str:
    """Return the first names that paths begin with: ``MAIN, GVL``."""
    found = list(dict.fromkeys(path.partition(".")[0] for path in paths if "." in path))
    return ", ".join((*found[:_MAX_SCOPES], *(["…"] if len(found) > _MAX_SCOPES else ())))

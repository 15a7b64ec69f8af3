# SPDX-License-Identifier: MIT
"""A PLC that runs in the realtime part: what a run knows of it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Diagnostic
from nctakt.run.named_values import NamedValues
from nctakt.run.plc_view import PlcView, WatchedPlc

if TYPE_CHECKING:
    from nctakt.run.assembly import AssembledMachine


class RealtimePlc(WatchedPlc):
    """A PLC whose tasks run in the tick; it acknowledges only what it has announced itself."""

    def cycle(self, hli: PlcView) -> None:
        """Do nothing: its tasks run in the tick."""

    def attach(self, machine: AssembledMachine) -> NamedValues:
        """Begin anew on a machine, before its next tick; return its variables."""
        raise NotImplementedError

    def news(self) -> Sequence[Diagnostic]:
        """Return what has stopped it since the last call."""
        raise NotImplementedError

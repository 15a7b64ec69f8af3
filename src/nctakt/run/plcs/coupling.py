# SPDX-License-Identifier: MIT
"""A simulation with its own step, coupled to the ticks of a run in addition to its PLC."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from nctakt.run.realtime.assembly import AssembledMachine


class Coupled(Protocol):
    """A simulation that reads the machine each n ticks and gives it values from outside.

    Its writes count from the next tick on (RC-002).
    """

    def begin(self, machine: AssembledMachine) -> None:
        """Get ready for a run from the machine's next tick on; raises ``Failure``."""

    @property
    def next_tick(self) -> int:
        """The tick before which it is due."""

    def step(self) -> None:
        """Continue up to the machine's next tick; raises ``Failure``."""

    def close(self) -> None:
        """Release everything it holds for the run."""

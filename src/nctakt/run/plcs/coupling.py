# SPDX-License-Identifier: MIT
"""What is coupled to the ticks of a run beside its PLC: a simulation with a step of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from nctakt.run.realtime.assembly import AssembledMachine


class Coupled(Protocol):
    """A simulation that reads the machine each n ticks and gives it values from outside.

    What it writes counts from the next tick on (RC-002).
    """

    def begin(self, machine: AssembledMachine) -> None:
        """Get ready for a run from the machine's next tick on; raises ``Failure``."""

    @property
    def next_tick(self) -> int:
        """The tick before which it is due."""

    def step(self) -> None:
        """Go on up to the machine's next tick; raises ``Failure``."""

    def close(self) -> None:
        """Give up what it holds for the run."""

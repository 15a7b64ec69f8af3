# SPDX-License-Identifier: MIT
"""The past of a session, run once more to be explained: why reactions fired, or did not.

In: the setup of a session and the inputs of its branch. Out: a result with the histories of its
conditions. The session itself keeps none, since they cost time in each tick.
"""

from __future__ import annotations

from dataclasses import replace
from typing import cast

from nctakt.base.dataclass import dataclass
from nctakt.results.run import Run
from nctakt.run.inputs import Input
from nctakt.session.setup import Setup
from nctakt.session.workshop import Workshop


@dataclass(frozen=True, slots=True)
class Past:
    """What it takes to run a session up to a tick again, in a process of its own."""

    setup: Setup
    inputs: tuple[Input, ...]
    tick: int

    def explained(self) -> Run:
        """Return the result with ``why``; raises ``Failure`` where the setup has mistakes."""
        workshop = Workshop()
        try:
            engine, _ = workshop.open(replace(self.setup, why=True))
            try:
                engine.plan(self.inputs)
                engine.run(self.tick)
                return cast("Run", engine.ask("result"))
            finally:
                engine.close()
        finally:
            workshop.close()

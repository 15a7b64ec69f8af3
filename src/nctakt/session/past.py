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
from nctakt.session.timeline import Poll, run_in_parts
from nctakt.session.workshop import Workshop


@dataclass(frozen=True, slots=True)
class Past:
    """What it takes to run a session up to a tick again, in a process of its own."""

    setup: Setup
    inputs: tuple[Input, ...]
    tick: int

    def explained(self, poll: Poll) -> Run:
        """Return the result with ``why``; raises ``Failure`` where the setup has mistakes.

        ``poll`` is called meanwhile, and may end it by an exception.
        """
        workshop = Workshop()
        try:
            engine, _ = workshop.open(replace(self.setup, why=True))
            try:
                engine.plan(self.inputs)
                run_in_parts(engine, self.tick, poll)
                return cast("Run", engine.ask("result"))
            finally:
                engine.close()
        finally:
            workshop.close()

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
from nctakt.run.access.inputs import Input
from nctakt.session.history.record import (
    PastMark,
    check_programs,
    first_difference,
    past_differs,
    ticks_of,
)
from nctakt.session.history.timeline import PART_TICKS, Poll
from nctakt.session.process.workshop import ProcessPool, RemoteEngine
from nctakt.session.setup import Setup


@dataclass(frozen=True, slots=True)
class Past:
    """What it takes to run a session up to a tick again, in a process of its own.

    ``marks``: those that this must lead to.
    """

    setup: Setup
    inputs: tuple[Input, ...]
    tick: int
    marks: tuple[PastMark, ...]

    def explained(self, poll: Poll) -> Run:
        """Return the result with ``why``; raises ``Failure`` where the setup has mistakes.

        Raises it as well where the past is not as it was (901901). ``poll`` is called meanwhile,
        and may end it by an exception.
        """
        workshop = ProcessPool()
        try:
            engine, _ = workshop.open(
                replace(self.setup, options={**self.setup.options, "why": True})
            )
            try:
                engine.plan(self.inputs)
                self._rerun(engine, poll)
                return cast("Run", engine.ask("result"))
            finally:
                engine.close()
        finally:
            workshop.close()

    def _rerun(self, engine: RemoteEngine, poll: Poll) -> None:
        while engine.tick < self.tick:
            end = min(self.tick, engine.tick + PART_TICKS)
            marks = [mark for mark in self.marks if engine.tick < mark.tick <= end]
            done = engine.run(end, marks=ticks_of(marks))
            check_programs(done.diagnostics)
            differs = first_difference(done.marks, marks)
            if differs is not None and not self.setup.plcs:
                raise past_differs(differs)
            if done.run_state is not None:
                return
            poll()

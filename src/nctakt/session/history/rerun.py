# SPDX-License-Identifier: MIT
"""Ticks of a branch that are rerun in parallel with the session, by a controller of their own.

In: a branch. Out: controllers at its ticks, with its inputs. The session is asked only for these
and for the marks of the ticks, which takes milliseconds.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from nctakt.session.history.branch import Branch
from nctakt.session.history.record import PastMark, first_difference, past_differs
from nctakt.session.history.timeline import Timeline, next_part
from nctakt.session.history.trail import Mark
from nctakt.session.process.process_pool import RemoteEngine


class PastRerun:
    """Reruns ticks of a branch; one thread asks it, any one.

    ``ask`` calls a method in the thread of the session; raises ``Failure`` once that is closed.
    """

    def __init__(self, ask: Callable[..., Any], timeline: Timeline, branch: Branch) -> None:
        self._ask = ask
        self._timeline = timeline
        self._branch = branch

    @property
    def branch(self) -> int:
        """The number of the branch."""
        return self._branch.number

    @property
    def latest(self) -> int:
        """The tick that the branch has reached."""
        return self._branch.latest

    def _controller(self, end: int, work_us: float) -> tuple[RemoteEngine, float]:
        """Return a controller before a stretch, for this rerun alone, and its work."""
        return self._ask(self._apart, end, work_us)  # type: ignore[no-any-return]

    def _apart(self, end: int, work_us: float) -> tuple[RemoteEngine, float]:
        engine, stretch_us = self._timeline.before(self._branch, end, work_us)
        engine.is_apart = True
        return engine, stretch_us

    def _plan_on(self, engine: RemoteEngine) -> int:
        """Give a controller the present inputs of the branch; return up to where."""
        return self._ask(self._timeline.plan_on, engine, self._branch)  # type: ignore[no-any-return]

    def _next_part(self, tick: int, end: int) -> tuple[int, Sequence[PastMark]]:
        """Return how far a controller reruns in one go, and the marks on the way."""
        return self._ask(next_part, self._branch, tick, end)  # type: ignore[no-any-return]

    def _compare(self, found: Sequence[Mark], marks: Sequence[PastMark]) -> None:
        """Raise ``Failure`` (901901) if the ticks are not as they were."""
        differs = first_difference(found, marks)
        if differs is not None and not self._timeline.setup.plcs:
            raise past_differs(differs)

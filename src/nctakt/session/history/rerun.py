# SPDX-License-Identifier: MIT
"""Ticks of a branch that are rerun in parallel with the session, by a controller of their own.

In: a branch. Out: controllers at its ticks, with its inputs; where the time of its ticks went, as
tables of ``nctakt time``; the run of its ticks with their signals. The session is asked only for
controllers and for the marks of the ticks, which takes milliseconds.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from typing import Any

from nctakt.base.diagnostics import Language
from nctakt.results.run import RecordedRun
from nctakt.session.history.branch import Branch
from nctakt.session.history.record import PastMark, first_difference, past_differs, ticks_of
from nctakt.session.history.timeline import Timeline, next_part
from nctakt.session.history.trail import Mark
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.process.worker import can_fork
from nctakt.timing.table import TitledTables


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


class PastAccount(PastRerun):
    """The account of a branch, as far as it has come."""

    _engine: RemoteEngine | None = None

    @property
    def tick(self) -> int:
        """How many ticks are accounted for."""
        return 0 if self._engine is None else self._engine.tick

    def advance(self, count: int) -> bool:
        """Account for up to ``count`` further ticks; return whether there were any.

        Raises ``Failure`` if the past cannot be rerun (901901).
        """
        tick = self.tick
        if self.latest <= tick:
            return False
        if self._engine is None:
            self._engine = self._controller(1, 0.0)[0]
        engine = self._engine
        end = min(self._plan_on(engine), tick + count)
        part, marks = self._next_part(tick, end)
        self._compare(engine.account(part, ticks_of(marks))[1], marks)
        return engine.tick > tick

    def tables(self, language: Language) -> TitledTables:
        """Return where the time of these ticks went."""
        return [] if self._engine is None else self._engine.time_tables(language)

    def close(self) -> None:
        """Give the controller back."""
        if self._engine is not None:
            self._engine.close()


class PastRecording(PastRerun):
    """A rerun of a branch that records signals."""

    def run(
        self, end: int, signals: Sequence[str] | None, on_progress: Callable[[int, int], None]
    ) -> RecordedRun:
        """Return the run of the ticks up to, but without, ``end``.

        ``signals``: those of its trace, by default those of a run. ``on_progress`` is called
        meanwhile with how many of how many ticks have been rerun, and may end it by an exception.
        Raises ``Failure`` for an unknown signal, and if the past cannot be rerun (901901).
        """
        engine = self._controller(1, 0.0)[0]
        with contextlib.closing(engine):
            self._plan_on(engine)
            engine.record(signals)
            while engine.tick < end:
                part, marks = self._next_part(engine.tick, end)
                self._compare(engine.record_to(part, ticks_of(marks))[1], marks)
                on_progress(engine.tick, end)
            self._confirm(engine)
            return engine.recorded()

    def _confirm(self, engine: RemoteEngine) -> None:
        """Compare the end with the next mark, in a copy that runs on to it.

        Raises ``Failure`` (901901) if it differs there.
        """
        following = self._ask(self._branch.mark_after, engine.tick)
        if following is None:
            return
        marks = [following]
        if following.tick == engine.tick:  # the run is over
            self._compare(engine.record_to(following.end, ticks_of(marks))[1], marks)
        elif can_fork():
            with contextlib.closing(engine.copy()) as copy:
                found = copy.run(following.end, events=False, marks=ticks_of(marks)).marks
                self._compare(found, marks)

# SPDX-License-Identifier: MIT
"""Reruns the past of a session to explain it, in a separate process.

In: everything needed to run a branch up to a tick. Out: the result, with the histories of its
conditions. A rerun leaves copies of itself on the way, so that the next place is explained from the
nearest one on.
"""

from __future__ import annotations

import contextlib
import threading
from dataclasses import replace
from typing import cast

from nctakt.base.failure import Failure
from nctakt.results.run import Run
from nctakt.session.history.parked import Parked, ParkedControllers
from nctakt.session.history.past import Past
from nctakt.session.history.record import check_programs, first_difference, past_differs, ticks_of
from nctakt.session.history.timeline import PART_TICKS, Poll
from nctakt.session.process.process_pool import ProcessPool, RemoteEngine
from nctakt.session.process.worker import can_fork

#: Maximum number of copies left on the way.
MAX_KEPT = 24


class PastRuns:
    """Reruns pasts of one session; several threads may ask at once."""

    def __init__(self) -> None:
        self._kept = ParkedControllers(MAX_KEPT)
        self._lock = threading.Lock()
        self._opening = threading.Lock()
        self._is_closed = False

    def explained(self, past: Past, poll: Poll) -> Run:
        """Return the result with ``why``; raises ``Failure`` where the setup has mistakes.

        Also raises it if the past is not as it was (901901). ``poll`` is called meanwhile, and may
        end it by an exception.
        """
        with contextlib.ExitStack() as ends:
            engine = self._nearest(past)
            if engine is None:
                with self._opening:  # requests meanwhile get a copy of the first one
                    engine = self._nearest(past) or self._opened(past, ends)
            ends.enter_context(contextlib.closing(engine))
            return self._run(engine, past, poll)

    def _opened(self, past: Past, ends: contextlib.ExitStack) -> RemoteEngine:
        """Return a new controller, of which a copy is kept; ``ends``: those waiting for its end."""
        pool = ends.enter_context(contextlib.closing(ProcessPool()))
        setup = replace(past.setup, options={**past.setup.options, "why": True})
        engine = pool.open(setup)[0]
        self._keep(engine, past)
        return engine

    def _nearest(self, past: Past) -> RemoteEngine | None:
        """Return a copy of the last controller that is kept before the end of a past."""
        with self._lock:
            kept = self._kept.nearest(past.branch, past.tick)
            if kept is None:
                return None
            return self._copy(kept.engine)

    def _copy(self, engine: RemoteEngine) -> RemoteEngine | None:
        """Return a copy; ``None`` if none can be made, for instance because of a PLC."""
        try:
            copy = engine.copy()
        except Failure:
            return None
        copy.is_apart = True
        return copy

    def _run(self, engine: RemoteEngine, past: Past, poll: Poll) -> Run:
        engine.plan(past.inputs_from(engine.tick))
        while engine.tick < past.tick:
            end = min(past.tick, engine.tick + PART_TICKS)
            marks = [mark for mark in past.marks if engine.tick < mark.tick <= end]
            done = engine.run(end, marks=ticks_of(marks))
            check_programs(done.diagnostics)
            differs = first_difference(done.marks, marks)
            if differs is not None and not past.setup.plcs:
                raise past_differs(differs)
            if done.run_state is not None:
                break
            if engine.tick < past.tick:
                self._keep(engine, past)
            poll()
        return cast("Run", engine.ask("result"))

    def _keep(self, engine: RemoteEngine, past: Past) -> None:
        """Keep a copy of a controller, if one can be made."""
        copy = self._copy(engine) if can_fork() else None
        if copy is None:
            return
        with self._lock:
            if self._is_closed:
                copy.close()
                return
            # Where the work is not measured, ticks say how far apart controllers are.
            owner = past.branch.owner(engine.tick)
            self._kept.add(Parked(owner, engine.tick, float(engine.tick), copy))
            self._kept.thin_out(float(past.tick))

    def close(self) -> None:
        """Close all controllers that are kept."""
        with self._lock:
            self._is_closed = True
            self._kept.close()

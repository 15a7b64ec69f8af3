# SPDX-License-Identifier: MIT
"""A search over the events of a branch, in parallel with the session.

In: a text, a tick from which it goes back or forward. Out: the matches, stretch by stretch.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.results.trace.event_words import SoughtEvents
from nctakt.results.trace.events import Event
from nctakt.session.engine import FoundEvents
from nctakt.session.history.record import ticks_of
from nctakt.session.history.rerun import PastRerun
from nctakt.session.history.timeline import SEARCHED_GROWTH, SEARCHED_US
from nctakt.session.process.process_pool import RemoteEngine

#: Result of a search between two stretches: it continues.
Step = FoundEvents | None


class EventSearch(PastRerun):
    """Events of a branch that are sought."""

    def before(self, end: int, sought: SoughtEvents) -> Iterator[Step]:
        """Search the ticks before ``end``, from the latest stretch to the earliest.

        ``None``: it continues. Raises ``Failure`` if the past cannot be rerun (901901).
        """
        stretch_us = SEARCHED_US / SEARCHED_GROWTH
        while end > 0:
            work_us = SEARCHED_GROWTH * stretch_us
            engine, stretch_us = self._controller(end, work_us)
            first, count = engine.tick, 0
            events: tuple[Event, ...] = ()
            try:
                while engine.tick < end:
                    yield None
                    tick = engine.tick
                    found = self._part(engine, end, sought, first)
                    events = (*events, *found.events)[-sought.count :]
                    count += len(found.events) + found.left_out
                    if engine.tick == tick:
                        break  # the run is over
            finally:
                engine.close()
            yield FoundEvents(first, end, events, count - len(events))
            end = first

    def since(self, first: int, sought: SoughtEvents) -> Iterator[Step]:
        """Search the ticks from ``first`` on, up to the latest of the branch and on with it.

        What has no ticks is found where there is nothing new. Otherwise as ``before``.
        """
        engine: RemoteEngine | None = None
        end = 0  # its inputs are those of the ticks before
        try:
            while True:
                if self.latest <= first:
                    yield FoundEvents(first, first, (), 0)
                    continue
                if engine is None:
                    engine = self._controller(first + 1, 0.0)[0]
                if engine.tick >= end:
                    end = self._plan_on(engine)
                tick = engine.tick
                found = self._part(engine, end, sought, first)
                first = max(first, engine.tick)
                yield None if engine.tick < first and engine.tick > tick else found
        finally:
            if engine is not None:
                engine.close()

    def _part(
        self, engine: RemoteEngine, end: int, sought: SoughtEvents, since: int
    ) -> FoundEvents:
        """Search some ticks more; raises ``Failure`` (901901) if they are not as they were."""
        part, marks = self._next_part(engine.tick, end)
        found = engine.find_events(part, sought, ticks_of(marks), since)
        self._compare(found.marks, marks)
        return found

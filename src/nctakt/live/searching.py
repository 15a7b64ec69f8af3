# SPDX-License-Identifier: MIT
"""Searches over all events of the branch that is shown, one for each browser.

In: a text, requests for the previous or the next match. Out: the matches of some ticks in a row, up
to a number of them, and where the next one is. A separate thread reruns the past for them, some
ticks for each browser in turn; the session meanwhile continues.
"""

from __future__ import annotations

import bisect
import threading
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from typing import Protocol

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.results.trace.event_words import SoughtEvents
from nctakt.results.trace.events import Event
from nctakt.session.engine import FoundEvents
from nctakt.session.session import Session

#: Matches of a search that are kept.
MAX_KEPT = 1000

#: How long the thread waits for new events once everything is searched, in seconds.
_REST_S = 0.2


class Search:
    """What a browser looks for in a branch of a session.

    ``events``: all matches in the ticks from ``begin`` up to, but without, ``end``, in their order.
    ``newer``: how many have followed these since it began; ``is_newest``: further ones do.
    ``error``: why it has ended.
    """

    def __init__(self, session: Session, text: str, language: Language) -> None:
        self.text = text
        self.session = session
        self._language: Language = language
        self._source = session.event_search()
        self.branch = self._source.branch
        self.error: Failure | RuntimeError | None = None
        self.newer = 0
        self._requests: deque[Callable[[], None]] = deque()
        self._asked: tuple[Iterator[int | None], Future[int | None]] | None = None
        self._is_turn_back = self._is_ended = False
        self._anchor(None)

    def _anchor(self, before: int | None) -> None:
        """Restart the search, back from a tick, by default from the latest."""
        self.is_newest = before is None
        self.begin = self.end = self._source.latest if before is None else before
        self.events: tuple[Event, ...] = ()
        self._back = self._source.before(self.end, self._sought(MAX_KEPT))
        self._on = self._source.since(self.end, self._sought(MAX_KEPT))

    def _sought(self, count: int, *, is_latest: bool = True) -> SoughtEvents:
        return SoughtEvents(self.text, self._language, count, is_latest)

    @property
    def _has_older(self) -> bool:
        return self.begin > 0 and not self.is_full

    @property
    def _lags(self) -> bool:
        return self.is_newest and self.end < self._source.latest

    @property
    def is_full(self) -> bool:
        """Whether older matches are not looked for: enough are kept."""
        return len(self.events) >= MAX_KEPT

    @property
    def is_done(self) -> bool:
        """Whether the past is searched as far as it shall be."""
        return self._asked is None and not self._requests and not self._has_older

    # --- from any thread ------------------------------------------------------------------------

    def hop(self, tick: int, *, is_back: bool) -> Future[int | None]:
        """Let the tick of the nearest match before or after a tick be looked for.

        ``None``: there is none, or somebody has asked for another one meanwhile.
        """
        answer: Future[int | None] = Future()
        answer.set_running_or_notify_cancel()  # who no longer waits cannot cancel it
        self._requests.append(lambda: self._begin_hop(tick, answer, is_back=is_back))
        return answer

    def turn(self, *, is_older: bool) -> None:
        """Let the matches that are kept be older ones, or the newest."""
        before = self.begin if is_older else None
        self._requests.append(lambda: self._anchor(before))

    def end_it(self) -> None:
        """Search no more."""
        self._is_ended = True

    # --- in the thread of the searches ----------------------------------------------------------

    def advance(self) -> bool:
        """Search some ticks; return whether there were any."""
        try:
            return self._advance()
        except (Failure, RuntimeError) as error:
            self.error = error
            self.close()
            return False

    def _advance(self) -> bool:
        while self._requests:
            self._requests.popleft()()
        if self._asked is not None:
            steps, answer = self._asked
            found = next(steps, -1)
            if found is not None:
                self._asked = None
                answer.set_result(None if found < 0 else found)
            return True
        has_older, lags = self._has_older, self._lags
        self._is_turn_back = has_older and not (lags and self._is_turn_back)
        if self._is_turn_back:
            self._add(next(self._back))
        elif lags:
            self._add(next(self._on), is_newer=True)
        return has_older or lags

    def _add(self, found: FoundEvents | None, *, is_newer: bool = False) -> None:
        """Keep the latest matches; of too many, all are known after the tick of the first one."""
        if found is None:
            return
        if is_newer:
            self.end = found.end
            self.newer += len(found.events)
            events = (*self.events, *found.events)
        else:
            self.begin = found.first
            events = (*found.events, *self.events)
        self.events = events[-MAX_KEPT:]
        if found.left_out or len(events) > MAX_KEPT:
            self.begin = self.events[0].tick + 1

    def _begin_hop(self, tick: int, answer: Future[int | None], *, is_back: bool) -> None:
        if self._asked is not None:
            self._asked[1].set_result(None)
        self._asked = (self._before(tick) if is_back else self._after(tick)), answer

    def _before(self, tick: int) -> Iterator[int | None]:
        """Look for the last match before a tick; ``None``: the search continues."""
        end = tick
        if self.begin <= tick <= self.end:
            index = bisect.bisect_left(self.events, tick, key=lambda one: one.tick)
            if index:
                yield self.events[index - 1].tick
                return
            end = self.begin
        for found in self._source.before(end, self._sought(1)):
            if found is not None and found.events:
                tick = found.events[-1].tick
                self._anchor(tick + 1)
                yield tick
                return
            yield None

    def _after(self, tick: int) -> Iterator[int | None]:
        """Look for the first match after a tick; ``None``: the search continues."""
        first = tick + 1
        if self.begin <= first <= self.end:
            index = bisect.bisect_right(self.events, tick, key=lambda one: one.tick)
            if index < len(self.events):
                yield self.events[index].tick
                return
            first = self.end
        for found in self._source.since(first, self._sought(1, is_latest=False)):
            if found is not None and found.events:
                tick = found.events[0].tick
                if not self.is_newest or tick < self.end:
                    self._anchor(tick + 1)
                yield tick
                return
            if found is not None and found.first == found.end:
                return
            yield None

    @property
    def is_ended(self) -> bool:
        """Whether it searches no more."""
        return self._is_ended or self.error is not None

    def close(self) -> None:
        """Give its controllers back; who waits for a match gets none."""
        for steps in (self._back, self._on, *(self._asked or ())[:1]):
            steps.close()
        while self._requests:
            self._requests.popleft()()
        if self._asked is not None:
            self._asked[1].set_result(None)
            self._asked = None


class PastWork(Protocol):
    """What reruns the past of a session, some ticks in turn with others; it may end by itself."""

    @property
    def is_ended(self) -> bool:
        """Whether it reruns no more."""

    def advance(self) -> bool:
        """Rerun some ticks; return whether there were any."""

    def close(self) -> None:
        """Give its controllers back."""


class Searches:
    """What reruns the past for browsers, and its thread, which begins with the first one."""

    def __init__(self) -> None:
        self._searches: list[PastWork] = []
        self._changed = threading.Condition()
        self._thread: threading.Thread | None = None
        self._is_closed = False

    def begin(self, search: PastWork) -> None:
        """Let a search, or an account, begin."""
        with self._changed:
            self._searches.append(search)
            if self._thread is None:
                self._thread = threading.Thread(
                    target=self._work, name="nctakt search", daemon=True
                )
                self._thread.start()
        self.go_on()

    def go_on(self) -> None:
        """Let the thread look at once what there is to do."""
        with self._changed:
            self._changed.notify_all()

    def _work(self) -> None:
        while not self._is_closed:
            has_advanced = False
            for search in list(self._searches):
                if search.is_ended:
                    self._searches.remove(search)
                    search.close()
                elif search.advance():
                    has_advanced = True
            if not has_advanced:
                with self._changed:
                    if self._is_closed:
                        break
                    self._changed.wait(_REST_S if self._searches else None)
        for search in self._searches:
            search.close()

    def close(self) -> None:
        """End the thread."""
        with self._changed:
            self._is_closed = True
            self._changed.notify_all()
        if self._thread is not None:
            self._thread.join()

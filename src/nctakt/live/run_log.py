# SPDX-License-Identifier: MIT
"""The past as listed on the page: events, messages and findings of the branch shown.

In: frames of a session, which may travel and begin branches. Out: the results of the ticks before
the one shown, each once. Missing parts are not guessed: the session reruns them.
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.base.diagnostics import Diagnostic
from nctakt.live.view import LogRow
from nctakt.results.run import ProgramMessage
from nctakt.results.trace.events import Event
from nctakt.session.engine import StepResult
from nctakt.session.listening import Frame

#: Rows of the lists of messages and events, and as many as are wanted after a travel.
MAX_LOG, ENOUGH = 200, 80

#: Findings of a run that are kept.
MAX_DIAGNOSTICS = 500

#: Ticks of the past that are run again for the lists.
_AGAIN_TICKS = 200_000


class RunLog:
    """The events, messages and findings of the ticks from ``begin`` up to ``end``.

    ``left_out``: events of these ticks that are not listed, the oldest. ``lacks_some``: something
    that belongs there may be missing until ``complete`` has been called.
    """

    def __init__(self, cycle_time_us: int) -> None:
        self._cycle_time_us = cycle_time_us
        self._branch = 1
        self._found: tuple[tuple[int, int, Diagnostic], ...] = ()
        self.events: tuple[Event, ...] = ()
        self.messages: tuple[ProgramMessage | LogRow, ...] = ()
        self.begin = self.end = self.left_out = 0
        self.lacks_some = False

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """The findings, each once."""
        return list({str(found): found for _, _, found in self._found}.values())

    def say(self, row: LogRow) -> None:
        """List a row among the messages; it belongs to no tick."""
        self.messages = (*self.messages, row)[-MAX_LOG:]

    def note(self, frame: Frame, fork: Callable[[int, int], int]) -> None:
        """Take a frame; ``fork``: the tick before which two branches are the same."""
        left, self._branch = self._branch, frame.branch
        first = frame.first_tick
        self._forget_from(first if left == frame.branch else min(first, fork(left, frame.branch)))
        if frame.first_tick > self.end:  # the ticks between have not been reported
            self.events, self.left_out = (), 0
            self.begin, self.lacks_some = frame.first_tick, True
        self._add(frame)

    def complete(self, happened: Callable[[int, int], StepResult]) -> None:
        """Replace the known results of the latest ticks by what ``happened``.

        ``happened`` reruns a range of ticks; its exceptions pass through.
        """
        end = self.end
        done = happened(max(0, end - _AGAIN_TICKS), end)
        self._forget_from(done.first_tick)
        self.events, self.left_out, self.begin = (), 0, done.first_tick
        self._add(done)
        self.lacks_some = False

    def _forget_from(self, tick: int) -> None:
        """Forget the results of a tick and later ones."""
        if tick >= self.end:
            return
        before_us = tick * self._cycle_time_us
        self.messages = tuple(
            one for one in self.messages if isinstance(one, LogRow) or one.time_us < before_us
        )
        count = len(self.events)
        self.events = tuple(one for one in self.events if one.tick < tick)
        self.begin, self.end = min(self.begin, tick), tick
        # only the frame of a finding is known: it may belong to a tick before this one
        is_unsure = any(first < tick < end for first, end, _ in self._found)
        self._found = tuple(one for one in self._found if one[1] <= tick)
        is_short = len(self.events) < min(ENOUGH, count) and bool(self.left_out or self.begin)
        self.lacks_some = self.lacks_some or is_unsure or is_short

    def _add(self, done: Frame | StepResult) -> None:
        """List the results of further ticks."""
        events = (*self.events, *done.events)
        self.left_out += done.left_out + max(0, len(events) - MAX_LOG)
        self.events = events[-MAX_LOG:]
        self.messages = (*self.messages, *done.messages)[-MAX_LOG:]
        found = [(done.first_tick, done.tick, one) for one in done.diagnostics]
        self._found = (*self._found, *found)[-MAX_DIAGNOSTICS:]
        self.end = done.tick

# SPDX-License-Identifier: MIT
"""Reports of a session: frames, which may be skipped, and notices, which may not.

In: the moments of a session. Out: for each listener the latest frame, at its own rate, and all
notices in order. No listener can hold the session up.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.results.run import ProgramMessage, RunState
from nctakt.results.trace.events import Event

#: Maximum number of notices waiting for a listener; a listener that leaves more unread is dropped.
MAX_NOTICES = 1000

#: Events that wait in a listener's frame at most; how many were left out is reported.
MAX_FRAME_EVENTS = 2000

NoticeKind = Literal["stopped", "ended", "branch", "travelled", "refused", "closed"]


@dataclass(frozen=True, slots=True)
class Frame:
    """A session at a tick; all of it belongs together.

    ``values``: those of the listener's signals. ``blocks``: number of the channel -> place of its
    current block. ``events``, ``messages`` and ``diagnostics`` are those of the ticks from
    ``first_tick`` on, which follow the listener's frame before, or the place to which the session
    has travelled since; ``left_out`` events are missing. ``travels``: how often it has travelled.
    ``missed``: how many frames the listener has not taken.
    """

    first_tick: int
    tick: int
    branch: int
    travels: int
    state: str
    run_state: RunState | None
    speed: float | None
    values: Mapping[str, float | bool | str]
    blocks: Mapping[int, Span]
    events: Sequence[Event]
    left_out: int
    messages: Sequence[ProgramMessage]
    diagnostics: Sequence[Diagnostic]
    missed: int


@dataclass(frozen=True, slots=True)
class Notice:
    """A message that a listener must get: at which tick, and what; ``text`` has the details.

    ``text_de``: the same in German, where that differs.
    """

    kind: NoticeKind
    tick: int
    text: str = ""
    text_de: str = ""


class Listener:
    """A listener to some signals, at most ``rate_hz`` times a second.

    ``is_dropped``: it has left too many notices unread, and gets no more.
    """

    def __init__(
        self, signals: Sequence[str], rate_hz: float, *, wants_events: bool = True
    ) -> None:
        self.signals = tuple(signals)
        self.wants_events = wants_events
        self.rate_hz = rate_hz
        self._due = 0.0
        self._changed = threading.Condition()
        self._frame: Frame | None = None
        self._notices: deque[Notice] = deque()
        self._missed = 0
        self._is_woken = False
        self.is_dropped = False

    def is_due(self) -> bool:
        """Return whether it is time for its next frame."""
        return time.monotonic() >= self._due

    def give(self, frame: Frame) -> None:
        """Give it a frame; a frame that it has not taken is merged into it."""
        now_s = time.monotonic()
        # absolute times, so that slices of 10 ms do not make 20 frames a second 17
        distance_s = 1.0 / self.rate_hz
        self._due = max(self._due, now_s - distance_s) + distance_s
        with self._changed:
            if self._frame is not None:
                self._missed += 1
                frame = _folded(self._frame, frame)
            self._frame = frame
            self._changed.notify_all()

    def notify(self, notice: Notice) -> None:
        """Give it a notice."""
        with self._changed:
            if len(self._notices) >= MAX_NOTICES:
                self.is_dropped = True
            else:
                self._notices.append(notice)
            self._changed.notify_all()

    def wake(self) -> None:
        """Wake the thread that waits for a frame, or does so next."""
        with self._changed:
            self._is_woken = True
            self._changed.notify_all()

    def take(self, timeout_s: float = 0.0) -> Frame | None:
        """Return the latest frame, waiting for one up to a time in seconds; else ``None``."""
        with self._changed:
            if timeout_s > 0.0:
                self._changed.wait_for(lambda: self._frame is not None or self._is_woken, timeout_s)
            self._is_woken = False
            frame, self._frame = self._frame, None
            if frame is None:
                return None
            missed, self._missed = self._missed, 0
        return replace(frame, missed=missed)

    def notices(self, timeout_s: float = 0.0) -> list[Notice]:
        """Return the notices since the last call, waiting for one up to a time in seconds."""
        with self._changed:
            if not self._notices and timeout_s > 0.0:
                self._changed.wait_for(lambda: bool(self._notices), timeout_s)
            notices = list(self._notices)
            self._notices.clear()
        return notices


def _folded(older: Frame, newer: Frame) -> Frame:
    """Return the newer frame with the events of both, as far as there is room.

    Events before a jump are not the past of the place the session has gone to.
    """
    if newer.travels != older.travels:
        return newer
    events = [*older.events, *newer.events]
    surplus = max(0, len(events) - MAX_FRAME_EVENTS)
    return replace(
        newer,
        first_tick=older.first_tick,
        events=tuple(events[surplus:]),
        left_out=older.left_out + newer.left_out + surplus,
        messages=(*older.messages, *newer.messages)[-MAX_FRAME_EVENTS:],
        diagnostics=(*older.diagnostics, *newer.diagnostics)[-MAX_FRAME_EVENTS:],
    )

# SPDX-License-Identifier: MIT
"""Those who listen to a session: each gets frames at its own rate, and all notices.

In: the results of a session's slices. Out: frames and notices to the listeners.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nctakt.messages import diagnostic
from nctakt.messages.connections.session import PLC_DIFFERS
from nctakt.session.core import SessionCore
from nctakt.session.engine import StepResult
from nctakt.session.listening import MAX_FRAME_EVENTS, Frame, Listener, Notice, NoticeKind

#: Maximum number of slices whose events wait for a listener's next frame.
MAX_PENDING = 64


class Subscribers:
    """The listeners of a session."""

    def __init__(self, core: SessionCore) -> None:
        self._core = core
        self._listeners: list[Listener] = []
        self._pending: dict[int, list[StepResult]] = {}
        self._has_differed = False
        self._travels = 0

    def add(self, listener: Listener, speed: float | None, signals: Sequence[str]) -> None:
        """Add a listener to these signals; raises ``Failure`` for an unknown signal."""
        self._core.read(signals)
        listener.signals = tuple(signals)
        if listener not in self._listeners:
            self._listeners.append(listener)
            self._pending[id(listener)] = [self._core.latest]
        self._give([listener], speed)

    @property
    def wants_events(self) -> bool:
        """Whether anybody listens to events."""
        return any(one.wants_events for one in self._listeners)

    def remove(self, listener: Listener) -> None:
        """Remove a listener; nothing happens if it is already gone."""
        if listener in self._listeners:
            self._listeners.remove(listener)
            del self._pending[id(listener)]

    def travel(self, done: StepResult) -> None:
        """Report that the session has moved; ``done``: the results of the ticks before.

        They were reported when first run, and waiting reports may not belong to this past.
        """
        self._travels += 1
        for pending in self._pending.values():
            pending.clear()
        self.notify("travelled", str(self._core.branch.number))
        arrived = replace(
            done, first_tick=done.tick, events=(), left_out=0, messages=(), diagnostics=()
        )
        self.publish(arrived, None, at_once=True)

    def publish(self, done: StepResult, speed: float | None, *, at_once: bool) -> None:
        """Distribute the results of a slice: to all at once, or to those whose time has come."""
        if done.differs is not None and not self._has_differed:
            self._has_differed = True
            found = diagnostic(PLC_DIFFERS, tick=done.differs)
            self.notify("refused", str(found), found.render("de"))
        for listener in self._listeners:
            self._pending[id(listener)].append(done)
        due = [
            one
            for one in self._listeners
            if at_once or one.is_due() or len(self._pending[id(one)]) >= MAX_PENDING
        ]
        if due:
            self._give(due, speed)
        if done.hits:
            self.notify("stopped", ", ".join(map(str, done.hits)))
        if done.run_state is not None:
            self.notify("ended", done.run_state)

    def flush(self) -> None:
        """Hand out everything waiting for the listeners' next frames: the session has stopped."""
        self._give([one for one in self._listeners if self._pending[id(one)]], None)

    def _give(self, listeners: Sequence[Listener], speed: float | None) -> None:
        """Give these listeners their frames; the signals of all are read at once."""
        names = list(dict.fromkeys(name for one in listeners for name in one.signals))
        values = dict(zip(names, self._core.read(names) if names else (), strict=True))
        latest = self._core.latest
        for listener in listeners:
            parts, self._pending[id(listener)] = self._pending[id(listener)], []
            heard = parts if listener.wants_events else ()
            events = [event for part in heard for event in part.events]
            surplus = max(0, len(events) - MAX_FRAME_EVENTS)
            listener.give(
                Frame(
                    parts[0].first_tick if parts else latest.tick,
                    latest.tick,
                    self._core.branch.number,
                    self._travels,
                    latest.state,
                    latest.run_state,
                    speed,
                    {name: values[name] for name in listener.signals},
                    latest.blocks,
                    tuple(events[surplus:]),
                    surplus + sum(part.left_out for part in heard),
                    tuple(message for part in parts for message in part.messages),
                    tuple(found for part in parts for found in part.diagnostics),
                    0,
                )
            )

    def notify(self, kind: NoticeKind, text: str = "", text_de: str = "") -> None:
        """Give all listeners a notice; who has left too many unread listens no more."""
        notice = Notice(kind, self._core.tick, text, text_de)
        for listener in list(self._listeners):
            listener.notify(notice)
            if listener.is_dropped:
                self.remove(listener)

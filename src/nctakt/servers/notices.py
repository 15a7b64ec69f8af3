# SPDX-License-Identifier: MIT
"""Notices for clients, which may not be left out; a client that does not read them is disconnected.

In: notices, messages and diagnostics of the session. Out: each of them to each listener at
once, and to each subscriber in a queue with a limit.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import error_text
from nctakt.results.run import ProgramMessage
from nctakt.servers.log import ServerLog
from nctakt.session.listening import NoticeKind

#: Notices that wait for a subscriber at most.
MAX_WAITING = 1000


@dataclass(frozen=True, slots=True)
class ServerNotice:
    """A notice for clients.

    ``kind``: one of the session's, ``message`` of a program, ``diagnostic``, or ``closing``: the
    servers end. ``tick``: after which it happened. ``text_de``: its German where that differs.
    """

    kind: NoticeKind | Literal["message", "diagnostic", "closing"]
    tick: int
    text: str
    message: ProgramMessage | None = None
    diagnostic: Diagnostic | None = None
    text_de: str = ""


class Subscription:
    """The notices for one client; ``is_dropped``: it has left too many of them unread."""

    def __init__(self, drop: Callable[[], None], limit: int = MAX_WAITING) -> None:
        self._drop = drop
        self._queue: asyncio.Queue[ServerNotice] = asyncio.Queue(limit)
        self.is_dropped = False

    def put(self, notice: ServerNotice) -> None:
        """Put a notice into the queue; a full one disconnects the client."""
        if self.is_dropped:
            return
        try:
            self._queue.put_nowait(notice)
        except asyncio.QueueFull:
            self.is_dropped = True
            self._drop()

    async def next(self) -> ServerNotice:
        """Return the next notice, once there is one."""
        return await self._queue.get()


class Notices:
    """Those who hear notices: subscribers, each with a queue, and listeners, which never wait."""

    def __init__(self, log: ServerLog) -> None:
        self._log = log
        self._subscriptions: list[Subscription] = []
        self._listeners: list[Callable[[ServerNotice], None]] = []

    def listen(self, listener: Callable[[ServerNotice], None]) -> Callable[[], None]:
        """Call a function with each notice, in the loop; return one that ends it."""
        self._listeners.append(listener)
        return lambda: self._listeners.remove(listener)

    def subscribe(self, drop: Callable[[], None], limit: int = MAX_WAITING) -> Subscription:
        """Let a client have all notices from now on; ``drop`` disconnects it."""
        subscription = Subscription(drop, limit)
        self._subscriptions.append(subscription)
        return subscription

    def unsubscribe(self, subscription: Subscription) -> None:
        """Let a client have no more notices."""
        if subscription in self._subscriptions:
            self._subscriptions.remove(subscription)

    def notify(self, notice: ServerNotice) -> None:
        """Give all a notice."""
        for listener in tuple(self._listeners):
            try:
                listener(notice)
            except Exception as error:  # noqa: BLE001 - one endpoint's mistake must not hit the others
                self._log.error("notice", reason=error_text(error))
        for subscription in tuple(self._subscriptions):
            subscription.put(notice)
            if subscription.is_dropped:
                self.unsubscribe(subscription)

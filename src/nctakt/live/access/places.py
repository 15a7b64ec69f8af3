# SPDX-License-Identifier: MIT
"""The places of browsers: a connected browser has one, one that only fetched the page has none.

In: pages that are fetched, and their browsers as they connect and leave. Out: whether there is room
for another. Pages without a browser are bounded, too: a new one displaces the oldest of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Text
from nctakt.live.access.guard import TOO_MANY, Refused

if TYPE_CHECKING:
    from nicegui import Client

#: Browsers that may look at the page at a time, and pages that may wait for theirs to connect.
MAX_BROWSERS, MAX_WAITING = 20, 20

_NOT_CONNECTED = Text("its browser did not connect", "sein Browser verband sich nicht")


class Places:
    """Who looks at the page; ``clients``: all pages that were fetched, by their IDs."""

    def __init__(self, clients: Mapping[str, Client], refused: Refused) -> None:
        self._clients = clients
        self._refused = refused
        self._taken: set[str] = set()

    def make_room(self) -> bool:
        """Return whether another page may be fetched."""
        if len(self._taken) >= MAX_BROWSERS:
            return False
        waiting = [one for one in self._clients.values() if one.id not in self._taken]
        if len(waiting) >= MAX_WAITING:
            oldest = min(waiting, key=lambda one: one.created)
            self._refused(oldest.ip, _NOT_CONNECTED)
            oldest.delete()
        return True

    def let_wait(self, client: Client) -> None:
        """Let a page wait for its browser, which takes a place once it connects."""
        client.on_connect(partial(self._take, client))
        client.on_delete(partial(self._leave, client.id))

    async def _take(self, client: Client) -> None:
        if client.id in self._taken:
            return  # it comes again
        if len(self._taken) < MAX_BROWSERS:
            self._taken.add(client.id)
            return
        self._refused(client.ip, TOO_MANY)
        client.run_javascript("location.reload()")  # it gets the reason
        client.delete()

    def _leave(self, name: str) -> None:
        """Return a place. A separate method: the library inspects each handler's signature."""
        self._taken.discard(name)

# SPDX-License-Identifier: MIT
"""A client of the ADS server: its handles and notifications, which no other client can use.

A client is source NetId and port of one connection: a router sends many through the same
connection. Its handles and notifications end with the connection.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import count
from typing import Protocol

from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.data import Item
from nctakt.servers.ads.frames import shown_net_id
from nctakt.servers.ads.limits import MAX_CONNECTION_HANDLES, MAX_HANDLES
from nctakt.servers.ads.types import Symbol

#: Maximum number of sum commands of a client whose parts are remembered.
_MAX_PLANS = 64

#: Values in all of them together, unless it is a single one.
_MAX_PLANNED = 200_000


class HasHandles(Protocol):
    """A connection; ``handle_count``: the handles of all its clients."""

    @property
    def handle_count(self) -> int: ...


class Client:
    """One client; ``name``: NetId and port, as on the tape and in the log.

    ``send``: sends bytes to it. ``connection``: the one it uses. ``plans``: sum commands -> the
    items they read. ``begins``: handles of notifications whose first value is still to be sent.
    """

    _numbers = count(1)

    def __init__(
        self,
        net_id: bytes,
        port: int,
        send: Callable[[bytes], None],
        connection: HasHandles | None = None,
    ) -> None:
        self.connection = connection
        self.net_id = net_id
        self.port = port
        self.name = f"{shown_net_id(net_id)}:{port}"
        self.send = send
        self.handles: dict[int, Symbol] = {}
        self.notifications: set[int] = set()
        self.plans: dict[bytes, Item] = {}
        self.begins: list[int] = []

    @classmethod
    def next_number(cls) -> int:
        """Return a number that no client has had: a handle that was released means nothing."""
        return next(cls._numbers) & 0xFFFFFFFF

    def open_handle(self, symbol: Symbol) -> int:
        """Return a handle of a symbol; raises ``AdsError`` for too many."""
        if len(self.handles) >= MAX_HANDLES:
            raise AdsError(Error.NO_HANDLES, f"{MAX_HANDLES} handles are open")
        if self.connection and self.connection.handle_count >= MAX_CONNECTION_HANDLES:
            raise AdsError(Error.NO_HANDLES, f"{MAX_CONNECTION_HANDLES} handles are open")
        handle = self.next_number()
        self.handles[handle] = symbol
        return handle

    def symbol(self, handle: int) -> Symbol:
        """Return the symbol of a handle; raises ``AdsError`` (0x710)."""
        try:
            return self.handles[handle]
        except KeyError:
            raise AdsError(Error.SYMBOL, "an unknown handle") from None

    def release(self, handle: int) -> None:
        """Release a handle; raises ``AdsError`` (0x710)."""
        self.symbol(handle)
        del self.handles[handle]
        self.plans.clear()

    def keep_plan(self, parts: bytes, item: Item) -> None:
        """Remember the items that a sum command reads."""
        planned = len(item.leaves) + sum(len(plan.leaves) for plan in self.plans.values())
        if len(self.plans) >= _MAX_PLANS or planned > _MAX_PLANNED:
            self.plans.clear()
        self.plans[parts] = item

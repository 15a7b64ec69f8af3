# SPDX-License-Identifier: MIT
"""The latest values of a session, in the loop of the servers: all clients read them here.

In: frames of the session. Out: values by name, all of the same tick, without asking the session. A
name read for the first time is subscribed; then its value comes with each frame.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Iterable, Mapping, Sequence

from nctakt.base.failure import error_text
from nctakt.servers.log import ServerLog
from nctakt.session.listening import Frame

#: The type of values.
Scalar = float | bool | str

#: Values that are borrowed at most: each frame brings all of them.
MAX_BORROWED = 5000

#: Makes the session report these values from now on.
Subscriber = Callable[[Sequence[str]], Awaitable[None]]


class Store:
    """Values by name; ``tick``: the next one, ``frame``: the latest one."""

    def __init__(self, subscribe: Subscriber, log: ServerLog) -> None:
        self._subscribe = subscribe
        self._log = log
        self._names: dict[str, None] = {}
        self._borrowed: dict[str, None] = {}
        self._held: dict[str, int] = {}
        self._lock = asyncio.Lock()
        self._listeners: list[Callable[[Frame], None]] = []
        self.values: Mapping[str, Scalar] = {}
        self.tick = 0
        self.frame: Frame | None = None

    def receive(self, frame: Frame) -> None:
        """Take a frame, and notify the listeners."""
        self.frame = frame
        self.tick = frame.tick
        self.values = frame.values
        for listener in tuple(self._listeners):
            try:
                listener(frame)
            except Exception as error:  # noqa: BLE001 - one endpoint's mistake must not hit the others
                self._log.error("frame", reason=error_text(error))

    def listen(self, listener: Callable[[Frame], None]) -> Callable[[], None]:
        """Call a function with each frame, in the loop; return one that ends it."""
        self._listeners.append(listener)
        return lambda: self._listeners.remove(listener)

    def has(self, names: Iterable[str]) -> bool:
        """Return whether the values of all names are here."""
        values = self.values
        return all(name in values for name in names)

    async def subscribe(self, names: Iterable[str], *, is_borrowing: bool = False) -> None:
        """Subscribe the values of these names; raises ``Failure`` for unknown ones.

        The names are those of the session (``Catalogue.find(...).name``). Borrowed values are
        dropped unless ``keep_borrowed`` names them.
        """
        asked_for = dict.fromkeys(names)
        own = {**self._names, **self._borrowed} if is_borrowing else self._names
        if self.has(asked_for) and all(name in own for name in asked_for):
            return
        async with self._lock:  # a value that goes just now is here, but must come again
            await self._subscribe_missing(asked_for)
            own = self._borrowed if is_borrowing else self._names
            own.update((name, None) for name in asked_for if name not in self._names)

    async def _subscribe_missing(self, names: Iterable[str]) -> None:
        """Subscribe those of these names that do not come yet; raises ``Failure``."""
        known = {**self._names, **dict.fromkeys(self._held), **self._borrowed}
        missing = [name for name in names if name not in known]
        if missing:
            await self._subscribe([*known, *missing])

    async def hold(self, names: Iterable[str]) -> None:
        """Hold these values until they are released as often; raises as ``subscribe``."""
        asked_for = list(names)
        async with self._lock:
            await self._subscribe_missing(dict.fromkeys(asked_for))
            for name in asked_for:
                self._held[name] = self._held.get(name, 0) + 1

    async def release(self, names: Iterable[str]) -> None:
        """Unsubscribe values that no one else holds, has subscribed or borrowed."""
        async with self._lock:
            for name in names:
                count = self._held.pop(name, 0) - 1
                if count > 0:
                    self._held[name] = count
            await self._subscribe(
                list({**self._names, **dict.fromkeys(self._held), **self._borrowed})
            )

    async def keep_borrowed(self, used: Callable[[], Iterable[str]]) -> None:
        """Let only those of the borrowed values come from now on that are used."""
        async with self._lock:
            kept = self._borrowed
            while True:  # until no released value is in use again
                asked_for = {name: None for name in used() if name in self._borrowed}
                if asked_for == kept:
                    break
                kept = asked_for
                await self._subscribe(list({**self._names, **dict.fromkeys(self._held), **kept}))
            self._borrowed = kept

    def can_borrow(self, names: Iterable[str]) -> bool:
        """Return whether there is room for these names among the borrowed ones."""
        new = sum(name not in self._borrowed for name in names)
        return len(self._borrowed) + new <= MAX_BORROWED

    async def read(self, *names: str) -> list[Scalar]:
        """Return values, all of the same tick; raises ``Failure`` for an unknown name."""
        await self.subscribe(names)
        return [self.values[name] for name in names]

# SPDX-License-Identifier: MIT
"""The WebSockets of browsers: whose may stay, and how much they may send.

In: WebSockets that the guard has let through. Out: the same to the library, which reads them. A
WebSocket without a fetched page ends soon, a page has only few, and one that sends more than a
browser does is read more slowly: the system holds its bytes back.
"""

from __future__ import annotations

import asyncio
import time
from collections import Counter
from collections.abc import Callable, MutableMapping
from typing import Any
from urllib.parse import parse_qs

from nctakt.base.diagnostics import Text
from nctakt.live.access.guard import Application, Receive, Refused, Scope, Send

#: Paths where the library accepts WebSockets, and requests in place of one; the page sends none.
_FOLDER = "/_nicegui_ws/"

#: Maximum number of WebSockets of one page, including a lost one and its successor, and of those
#: without a page.
MAX_OF_PAGE, MAX_STRANGERS = 4, 20

#: How long a WebSocket may belong to no browser that looks on, in seconds.
GREETING_S = 5.0

#: Messages per second read at once, and how many more after a pause; bytes that count as one.
RATE, BURST, MESSAGE_BYTES = 100.0, 400.0, 100_000

_NO_SOCKET = Text("it uses no WebSocket", "es benutzt keinen WebSocket")
_NO_BROWSER = Text("its WebSocket is no browser's", "sein WebSocket gehört zu keinem Browser")
_SOCKETS = Text("too many WebSockets", "zu viele WebSockets")


class Sockets:
    """Lets WebSockets of browsers pass, and everything that is not a WebSocket.

    ``is_connected``: whether the page of an ID has a browser; ``None`` if there is no such page.
    """

    def __init__(
        self,
        application: Application,
        is_connected: Callable[[str], bool | None],
        refused: Refused,
    ) -> None:
        self._application = application
        self._looks_on = is_connected
        self._refused = refused
        self._open: Counter[str] = Counter()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if not str(scope.get("path", "")).startswith(_FOLDER):
            await self._application(scope, receive, send)
        elif scope["type"] == "websocket":
            await self._pass(scope, receive, send)
        elif scope["type"] == "http":
            self._report(scope, _NO_SOCKET)
            await send({"type": "http.response.start", "status": 403, "headers": []})
            await send({"type": "http.response.body", "body": b"403: only WebSockets\n"})

    async def _pass(self, scope: Scope, receive: Receive, send: Send) -> None:
        words = parse_qs(scope.get("query_string", b"").decode("latin-1"))
        page = words.get("client_id", [""])[0]
        name = "" if self._looks_on(page) is None else page
        if self._open[name] >= (MAX_OF_PAGE if name else MAX_STRANGERS):
            self._report(scope, _SOCKETS)
            await send({"type": "websocket.close", "code": 1008})
            return
        self._open[name] += 1
        try:
            reading = Reading(receive, lambda: self._looks_on(page) is True)
            await self._application(scope, reading, send)
            if reading.is_over:
                self._report(scope, _NO_BROWSER)
        finally:
            self._open[name] -= 1
            self._open += Counter()  # forgets those without one

    def _report(self, scope: Scope, reason: Text) -> None:
        self._refused(str((scope.get("client") or ("",))[0]), reason)


class Reading:
    """The messages of a WebSocket, at the permitted rate, while it belongs to a browser.

    ``is_over``: it has ended because it did not belong to a browser.
    """

    def __init__(self, receive: Receive, is_browser: Callable[[], bool]) -> None:
        self._receive = receive
        self._is_browser = is_browser
        self._ends_s = time.monotonic() + GREETING_S
        self._left = BURST
        self._since_s = time.monotonic()
        self.is_over = False

    async def __call__(self) -> MutableMapping[str, Any]:
        """Return the next message; the last one if it does not belong to a browser."""
        while True:
            now_s = time.monotonic()
            if now_s >= self._ends_s:
                if not self._is_browser():
                    self.is_over = True
                    return {"type": "websocket.disconnect", "code": 1008}
                self._ends_s = now_s + GREETING_S
            try:
                async with asyncio.timeout(self._ends_s - now_s):
                    message = await self._receive()
            except TimeoutError:
                continue
            await self._slow_down(message)
            return message

    async def _slow_down(self, message: MutableMapping[str, Any]) -> None:
        """Wait until the message is due."""
        now_s = time.monotonic()
        self._left = min(BURST, self._left + (now_s - self._since_s) * RATE)
        self._since_s = now_s
        size = len(message.get("bytes") or b"") + len(message.get("text") or "")
        self._left -= 1.0 + size / MESSAGE_BYTES
        if self._left < 0.0:
            await asyncio.sleep(-self._left / RATE)

# SPDX-License-Identifier: MIT
"""The connections of browsers: how many there may be, and how long they may take.

In: bytes of browsers. Out: the same to the library's protocol, which answers them. A connection
beyond the limit, and one whose request or answer never ends, is closed and counted; what other
protocols of the process need stays free.
"""

from __future__ import annotations

import asyncio
from typing import Any

from uvicorn.protocols.http.h11_impl import H11Protocol

from nctakt.base.diagnostics import Text
from nctakt.live.access.guard import Refused

#: Connections at a time, WebSockets among them: 20 browsers have about seven each while they load.
MAX_CONNECTIONS = 200

#: How long a request may take until it is whole, and its answer until it is taken, in seconds.
REQUEST_S, ANSWER_S = 5.0, 60.0

_TOO_MANY = Text("too many connections", "zu viele Verbindungen")
_NO_REQUEST = Text("its request did not come to an end", "seine Anfrage fand kein Ende")
_NO_READER = Text("it did not take its answer", "es nahm seine Antwort nicht ab")


def protocol(refused: Refused) -> type[asyncio.Protocol]:
    """Return the protocol of connections; ``refused`` gets those that are closed."""

    class Connection(H11Protocol):
        """A connection, until it becomes a WebSocket."""

        _timer: asyncio.TimerHandle | None = None
        _is_asking = True
        _answered: Any = None

        def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
            """Begin; a connection beyond the limit ends at once."""
            super().connection_made(transport)
            if len(self.connections) > MAX_CONNECTIONS:
                self._end(_TOO_MANY)
            else:
                self._let_end_in(REQUEST_S, _NO_REQUEST)

        def connection_lost(self, exc: Exception | None) -> None:
            """Forget the time."""
            self._stop_timer()
            super().connection_lost(exc)

        def data_received(self, data: bytes) -> None:
            """Take bytes; from the first one of a request on its time runs."""
            if not self._is_asking and self.cycle is self._answered:
                self._is_asking = True
                self._let_end_in(REQUEST_S, _NO_REQUEST)
            super().data_received(data)
            if self.transport.get_protocol() is not self:
                self._stop_timer()  # a WebSocket, whose library has limits of its own
            elif self._is_asking and self.cycle is not self._answered and not self.cycle.more_body:
                self._is_asking = False
                self._let_end_in(ANSWER_S, _NO_READER)

        def on_response_complete(self) -> None:
            """Wait for the next request, as long as the library does."""
            self._answered = self.cycle
            super().on_response_complete()

        def _let_end_in(self, seconds: float, reason: Text) -> None:
            self._stop_timer()
            self._timer = self.loop.call_later(seconds, self._end, reason)

        def _stop_timer(self) -> None:
            if self._timer is not None:
                self._timer.cancel()

        def _end(self, reason: Text) -> None:
            """Close the connection, unless it has taken its answer and waits for its next word."""
            is_waiting = not self._is_asking and self.cycle is self._answered
            if not is_waiting or self.transport.get_write_buffer_size():
                refused(self.client[0] if self.client else "", reason)
                self.transport.abort()

    return Connection

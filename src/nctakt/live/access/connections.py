# SPDX-License-Identifier: MIT
"""The connections of browsers: how many there may be, and how long they may take.

In: bytes of browsers. Out: the same to the library's protocol, which answers them. A connection
beyond the limit, and one whose request or answer never ends, is closed and counted; resources for
other protocols of the process stay free.
"""

from __future__ import annotations

import asyncio
import functools
import time
from typing import Any

from uvicorn.protocols.http.h11_impl import H11Protocol

from nctakt.base.diagnostics import Text
from nctakt.live.access.guard import Refused

#: Connections at a time, WebSockets among them: 20 browsers have about seven each while they load.
MAX_CONNECTIONS = 200

#: How long a request may take until it is whole, and its answer until it is taken, in seconds.
REQUEST_S, ANSWER_S = 5.0, 60.0

#: Frames a second of a WebSocket, and how many more after a rest; a browser sends few of them.
FRAME_RATE, FRAME_BURST = 1000.0, 5000.0

#: Bytes that the library gets at once: its work grows with the square of how many there are.
_PIECE = 16_384

_TOO_MANY = Text("too many connections", "zu viele Verbindungen")
_NO_REQUEST = Text("its request did not come to an end", "seine Anfrage fand kein Ende")
_FRAMES = Text("its WebSocket sent too many frames", "sein WebSocket sandte zu viele Frames")
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
            library: Any = self.ws_protocol_class
            self.ws_protocol_class = socket_protocol(library, refused)
            if len(self.connections) > MAX_CONNECTIONS:
                self._end(_TOO_MANY)
            else:
                self._let_end_in(REQUEST_S, _NO_REQUEST)

        def connection_lost(self, exc: Exception | None) -> None:
            """Forget the time."""
            self._stop_timer()
            super().connection_lost(exc)

        def data_received(self, data: bytes) -> None:
            """Take bytes; the time of a request runs from its first byte."""
            if not self._is_asking and self.cycle is self._answered:
                self._is_asking = True
                self._let_end_in(REQUEST_S, _NO_REQUEST)
            super().data_received(data)
            if self.transport.get_protocol() is not self:
                self._stop_timer()  # a WebSocket, whose library has its own limits
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


class FrameCount:
    """Counts the frames of a WebSocket, of which the library reads any number as fast as it can.

    Fragments of an endless message, and pings, reach no code that could hold them back.
    """

    def __init__(self) -> None:
        self._head = bytearray()
        self._rest = 0
        self._left = FRAME_BURST
        self._since_s = time.monotonic()

    def take(self, data: bytes, now_s: float) -> bool:
        """Take bytes that follow; return whether the frames in them are as many as may be."""
        self._left = min(FRAME_BURST, self._left + (now_s - self._since_s) * FRAME_RATE)
        self._since_s = now_s
        offset = 0
        while offset < len(data):
            if self._rest:
                skipped = min(self._rest, len(data) - offset)
                self._rest -= skipped
                offset += skipped
                continue
            self._head.append(data[offset])
            offset += 1
            self._end_head()
        return self._left >= 0.0

    def _end_head(self) -> None:
        """Begin the content of a frame if its head is whole."""
        head = self._head
        if len(head) < 2:
            return
        length = head[1] & 0x7F
        wide = {126: 2, 127: 8}.get(length, 0)
        if len(head) < 2 + wide + (4 if head[1] & 0x80 else 0):
            return
        self._rest = int.from_bytes(head[2 : 2 + wide], "big") if wide else length
        self._left -= 1.0
        head.clear()


@functools.cache
def socket_protocol(library: Any, refused: Refused) -> Any:
    """Return the library's protocol of WebSockets with a limit of their frames."""

    class Socket(library):  # type: ignore[misc]
        """A WebSocket; its request comes first, whole."""

        _frames: FrameCount | None = None

        def data_received(self, data: bytes) -> None:
            """Hand bytes on in small pieces; end where they have too many frames."""
            if self._frames is None:
                self._frames = FrameCount()
                super().data_received(data)
                return
            for offset in range(0, len(data), _PIECE):
                if self.transport.is_closing():
                    return
                piece = data[offset : offset + _PIECE]
                if not self._frames.take(piece, time.monotonic()):
                    refused(self.client[0] if self.client else "", _FRAMES)
                    self.transport.abort()
                    return
                super().data_received(piece)

    return Socket

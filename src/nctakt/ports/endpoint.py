# SPDX-License-Identifier: MIT
"""A port at which clients come in: bounded in number and time until they have shown the token.

In: connections. Out: for each a ``Visitor``, in a separate thread, which becomes a guest by the
token. The cost of visitors is bounded: a few at a time, for some seconds, with few bytes. So a
visitor without the token keeps no one else out.
"""

from __future__ import annotations

import contextlib
import errno
import socket
import threading
import time
from collections.abc import Callable
from typing import BinaryIO

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.ports import (
    PORT_IS_FULL,
    PORT_NOT_USABLE,
    TOKEN_NEEDED,
    TOKEN_NOT_WRITTEN,
    WRONG_TOKEN,
)
from nctakt.ports.token import TokenFile, is_same, new_token

#: Visitors at a time. A further one displaces the oldest, unless that has just come.
MAX_VISITORS = 32

#: How long a visitor may stay at most, and how long it is not sent away, in seconds.
VISIT_S, GRACE_S = 10.0, 0.5

#: Maximum total data from a visitor, in bytes.
VISIT_BYTES = 1 << 20

#: How many guests may be without a token, of those that there may be.
GUESTS_WITHOUT_TOKEN = 0.5

#: How often the endpoint looks for visitors whose time is over, in seconds.
_LOOK_S = 0.5

#: How long the threads of connections may take to end, in seconds.
_CLOSING_S = 15.0

#: Errors of ``accept`` while the system has no more descriptors, or the client has gone.
_PASSING = (errno.EMFILE, errno.ENFILE, errno.ENOBUFS, errno.ENOMEM, errno.ECONNABORTED)


class Endpoint:
    """A port; ``kind`` names it in the file of its token, ``port`` 0 is a free one.

    Raises ``Failure`` (901920) if the system refuses it. ``warning``: why there is no file, as a
    diagnostic.
    """

    def __init__(self, kind: str, host: str, port: int, *, max_guests: int) -> None:
        try:
            self._socket = socket.create_server((host, port), family=_family(host))
        except (OSError, OverflowError, UnicodeError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            found = diagnostic(PORT_NOT_USABLE, host=host, port=port, reason=reason)
            raise Failure(found) from error
        self._socket.settimeout(_LOOK_S)
        self.port = int(self._socket.getsockname()[1])
        self.host = f"[{host}]" if ":" in host else host
        self.token = new_token()
        self.warning: Diagnostic | None = None
        self._file: TokenFile | None = None
        try:
            self._file = TokenFile(kind, self.port, self.token)
        except OSError as error:
            self.warning = diagnostic(TOKEN_NOT_WRITTEN, reason=error.strerror or str(error))
        self._max_guests = max_guests
        self._lock = threading.Lock()
        self._visitors: list[Visitor] = []
        self._guests: list[Visitor] = []
        self._threads: set[threading.Thread] = set()
        self._is_closed = False

    def lines(self) -> list[str]:
        """Return the output of the command: the address, the token, its file."""
        file = "" if self._file is None else f" ({self._file.path})"
        return [f"{self.host}:{self.port}", f"token {self.token}{file}"]

    # --- connections ----------------------------------------------------------------------------

    def serve(self, receive: Callable[[Visitor], None]) -> None:
        """Let ``receive`` serve each connection, in a separate thread, until ``close``."""
        while not self._is_closed:
            try:
                connection, _ = self._socket.accept()
            except TimeoutError:
                self._end_visits()
                continue
            except OSError as error:
                if error.errno not in _PASSING or self._is_closed:
                    return
                self._end_visits()
                time.sleep(_LOOK_S)
                continue
            connection.settimeout(None)
            self._end_visits()
            visitor = self._take(connection)
            if visitor is not None:
                thread = threading.Thread(
                    target=self._receive, args=(visitor, receive), name="nctakt port", daemon=True
                )
                with self._lock:
                    self._threads.add(thread)
                thread.start()

    def _take(self, connection: socket.socket) -> Visitor | None:
        """Return a connection as a visitor, ``None`` if there is no place for it."""
        with self._lock:
            oldest = self._visitors[0] if len(self._visitors) >= MAX_VISITORS else None
            if oldest is not None:
                if time.monotonic() - oldest.since_s < GRACE_S:
                    connection.close()
                    return None
                self._visitors.remove(oldest)
                oldest.hang_up()
            visitor = Visitor(self, connection)
            self._visitors.append(visitor)
            return visitor

    def _end_visits(self) -> None:
        """Send away visitors whose time is over."""
        now_s = time.monotonic()
        with self._lock:
            for visitor in self._visitors:
                if now_s - visitor.since_s > VISIT_S:
                    visitor.hang_up()

    def _receive(self, visitor: Visitor, receive: Callable[[Visitor], None]) -> None:
        try:
            with contextlib.suppress(OSError):  # the client has gone before the last bytes
                receive(visitor)
        finally:
            visitor.close()
            with self._lock:
                for group in (self._visitors, self._guests):
                    if visitor in group:
                        group.remove(visitor)
                self._threads.discard(threading.current_thread())

    def admit(self, visitor: Visitor, token: str | None, request: str, *, is_open: bool) -> None:
        """Make a visitor a guest, as ``Visitor.enter`` says."""
        if token is None and not is_open:
            raise Failure(diagnostic(TOKEN_NEEDED, request=request))
        if token is not None and not is_same(token, self.token):
            raise Failure(diagnostic(WRONG_TOKEN))
        with self._lock:
            if visitor in self._guests:
                return
            without = sum(not guest.has_token for guest in self._guests)
            is_full = token is None and without >= self._max_guests * GUESTS_WITHOUT_TOKEN
            if is_full or len(self._guests) >= self._max_guests:
                raise Failure(diagnostic(PORT_IS_FULL, limit=self._max_guests))
            if visitor in self._visitors:
                self._visitors.remove(visitor)
                self._guests.append(visitor)
        visitor.has_token = token is not None
        visitor.reading.left = None

    def close(self) -> None:
        """Accept no further clients, hang up, and wait until their threads have ended."""
        self._is_closed = True
        self._socket.close()
        with self._lock:
            for visitor in (*self._visitors, *self._guests):
                visitor.hang_up()
            threads = list(self._threads)
        end_s = time.monotonic() + _CLOSING_S
        for thread in threads:
            thread.join(max(0.0, end_s - time.monotonic()))
        if self._file is not None:
            self._file.remove()


class Visitor:
    """A connection: its input and output streams. ``enter`` makes it a guest."""

    def __init__(self, endpoint: Endpoint, connection: socket.socket) -> None:
        self._endpoint = endpoint
        self._connection = connection
        self.since_s = time.monotonic()
        self.has_token = False
        self.reading = Metered(connection.makefile("rb"))
        self.writing = connection.makefile("wb")

    def enter(self, token: str | None, request: str, *, is_open: bool = False) -> None:
        """Become a guest by the token; ``is_open``: without one, too.

        Raises ``Failure``: no token for this request (901921), another one (901922), too many
        guests (901923).
        """
        self._endpoint.admit(self, token, request, is_open=is_open)

    def hang_up(self) -> None:
        """End its streams, in whatever thread they are read and written."""
        with contextlib.suppress(OSError):
            self._connection.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        """Close its streams."""
        self.hang_up()
        for stream in (self.reading, self.writing, self._connection):
            with contextlib.suppress(OSError):
                stream.close()


class Metered:
    """A stream that ends after ``left`` bytes; ``None``: after any number."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self.left: int | None = VISIT_BYTES

    def readline(self, limit: int = -1) -> bytes:
        """Return a line, of at most ``limit`` bytes; nothing at the end."""
        if self.left is not None:
            limit = self.left if limit < 0 else min(limit, self.left)
        return self._counted(self._stream.readline(limit))

    def read(self, size: int) -> bytes:
        """Return this many bytes; less at the end."""
        if self.left is not None and size > self.left:
            return b""
        return self._counted(self._stream.read(size))

    def read1(self, size: int) -> bytes:
        """Return some bytes, as soon as there are any; nothing at the end."""
        size = size if self.left is None else min(size, self.left)
        return self._counted(self._stream.read1(size))  # type: ignore[attr-defined]

    def _counted(self, data: bytes) -> bytes:
        if self.left is not None:
            self.left -= len(data)
        return data

    def close(self) -> None:
        """Close it."""
        self._stream.close()


def _family(host: str) -> socket.AddressFamily:
    return socket.AF_INET6 if ":" in host else socket.AF_INET

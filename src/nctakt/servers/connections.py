# SPDX-License-Identifier: MIT
"""Common parts of connections of all protocols: timeouts, lost peers, descriptors.

In: incomplete messages, sockets, the maximum number of connections. Out: an end for those that take
too long; enough descriptors, so that no protocol takes those of another.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.servers import TOO_FEW_DESCRIPTORS

#: How long the first bytes of a message may take, and the others, in seconds.
HEADER_S, MESSAGE_S = 5.0, 60.0

#: Why a connection ends if its message takes longer.
NO_END = "a message did not come to its end"

#: Descriptors for all that is not a connection of a client: files, pipes, the controllers.
RESERVE = 160

#: A peer is asked after this silence in s, then at this distance, this often, until it is gone.
_ASKED_AFTER_S, _DISTANCE_S, _QUESTIONS = 30, 10, 3


class Deadline:
    """Calls ``end`` with a reason when a message does not come to its end in time.

    ``header_bytes``: the length of its first part. The first message is due at once.
    """

    def __init__(
        self, loop: asyncio.AbstractEventLoop, header_bytes: int, end: Callable[[str], None]
    ) -> None:
        self._loop = loop
        self._header_bytes = header_bytes
        self._end = end
        self._seconds = HEADER_S
        self._timer: asyncio.TimerHandle | None = loop.call_later(HEADER_S, end, NO_END)

    def look(self, pending: int, *, is_new: bool) -> None:
        """Take the number of bytes that are no message yet; ``is_new``: a message came before."""
        seconds = 0.0
        if pending:
            seconds = HEADER_S if pending < self._header_bytes else MESSAGE_S
        elif not is_new:
            return  # nothing has come yet
        if is_new or seconds != self._seconds:
            self.stop()
            self._seconds = seconds
            if seconds:
                self._timer = self._loop.call_later(seconds, self._end, NO_END)

    def stop(self) -> None:
        """Expect nothing more."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None


def watch(transport: asyncio.BaseTransport) -> None:
    """Let the system find out within a minute that the other side of a connection is gone."""
    connection = transport.get_extra_info("socket")
    if connection is None:
        return
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    for name, value in (
        ("TCP_KEEPIDLE", _ASKED_AFTER_S),
        ("TCP_KEEPINTVL", _DISTANCE_S),
        ("TCP_KEEPCNT", _QUESTIONS),
        ("TCP_USER_TIMEOUT", 1000 * (_ASKED_AFTER_S + _DISTANCE_S * _QUESTIONS)),
    ):
        if hasattr(socket, name):
            connection.setsockopt(socket.IPPROTO_TCP, getattr(socket, name), value)


def provide_descriptors(connections: int) -> None:
    """Let this process have descriptors for this many connections, and for all else.

    Raises ``Failure`` (902041) where the system does not permit it.
    """
    try:
        import resource  # noqa: PLC0415 - not on Windows, which has no such limit
    except ImportError:
        return
    needed = connections + RESERVE
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if soft == resource.RLIM_INFINITY or soft >= needed:
        return
    if hard != resource.RLIM_INFINITY and hard < needed:
        raise Failure(diagnostic(TOO_FEW_DESCRIPTORS, limit=hard, needed=needed))
    resource.setrlimit(resource.RLIMIT_NOFILE, (needed, hard))

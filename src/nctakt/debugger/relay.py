# SPDX-License-Identifier: MIT
"""The relay from an editor's debugger to the one inside ``nctakt live``.

In: a port of this computer, the requests of the editor. Out: the same at that port, and what comes
from there to the editor. So an editor that starts its own debugger can attach, too.
"""

from __future__ import annotations

import contextlib
import socket
import threading
from collections.abc import Callable
from typing import Any

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import NO_LIVE_PAGE
from nctakt.ports.framing import Message, MessageReader, MessageWriter
from nctakt.ports.token import known_token

#: How long the other debugger may take to answer at first, in seconds.
ANSWER_S = 10.0

#: The only address of such a port, and the name of its token's file.
HOST, KIND = "127.0.0.1", "dap"


class Relayed(Exception):
    """A request that the other debugger answers."""


class Relay:
    """A connection to another debugger; raises ``Failure`` (901238) if there is none.

    ``initialized``: the arguments of the editor's ``initialize``. ``end`` is called when the other
    one has gone.
    """

    def __init__(
        self, port: int, initialized: Any, writer: MessageWriter, end: Callable[[], None]
    ) -> None:
        self._open = contextlib.ExitStack()
        try:
            self._socket = socket.create_connection((HOST, port), timeout=ANSWER_S)
            self._open.enter_context(self._socket)
            reading = self._open.enter_context(self._socket.makefile("rb"))
            writing = self._open.enter_context(self._socket.makefile("wb"))
            self._reader = MessageReader(reading, is_strict=True)
            self._other = MessageWriter(writing)
            request = {"type": "request", "command": "initialize", "arguments": initialized or {}}
            self._other.write({**request, "seq": 0})
            if self._reader.read() is None:
                raise ConnectionResetError("EOF")
        except (OSError, OverflowError, Failure) as error:
            self._open.close()
            reason = getattr(error, "strerror", None) or str(error)
            raise Failure(diagnostic(NO_LIVE_PAGE, port=port, reason=reason)) from error
        self._socket.settimeout(None)
        self._token = known_token(KIND, port)
        self._writer = writer
        self._end = end
        self._thread = threading.Thread(
            target=self._forward_answers, name="nctakt dap relay", daemon=True
        )
        self._thread.start()

    def send(self, message: Message) -> None:
        """Send a request of the editor; with the token of the port where this user has it."""
        arguments = message.get("arguments")
        if self._token is not None and message.get("command") == "attach":
            known = arguments if isinstance(arguments, dict) else {}
            message = {**message, "arguments": {**known, "token": self._token}}
        self._other.write(message)

    def _forward_answers(self) -> None:
        """Forward the other debugger's messages to the editor, until it goes."""
        with contextlib.suppress(OSError, ValueError, Failure):
            while (message := self._reader.read()) is not None:
                message.pop("seq", None)
                self._writer.write(message)
        self._end()

    def close(self) -> None:
        """Leave the other debugger."""
        with contextlib.suppress(OSError):
            self._socket.shutdown(socket.SHUT_RDWR)
        self._thread.join()
        with contextlib.suppress(OSError):
            self._open.close()

# SPDX-License-Identifier: MIT
"""The debugger on standard input and output, and on a port of this computer.

In: streams of bytes. Out: one adapter for each client until it goes. The port is one of this
computer alone: whoever reaches it can run programs, and with them a PLC in Python.
"""

from __future__ import annotations

import contextlib
import os
import socket
import sys
import threading
from collections.abc import Callable, Sequence
from typing import BinaryIO

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.debugger.adapter import Adapter
from nctakt.debugger.transport import MessageReader, MessageWriter
from nctakt.messages import diagnostic
from nctakt.messages.live import ADDRESS_NOT_USABLE
from nctakt.session.session import Session

#: The only address of the port.
HOST = "127.0.0.1"

#: Clients at a time; a further one is turned away.
MAX_CLIENTS = 8


def serve_streams(
    reading: BinaryIO,
    writing: BinaryIO,
    *,
    folders: Sequence[str] = (),
    language: Language = "en",
    session: Callable[[], Session] | None = None,
    is_strict: bool = False,
) -> None:
    """Serve one client until it goes; ``session`` returns that of another one, to attach to."""
    adapter = Adapter(MessageWriter(writing), folders=folders, language=language, shared=session)
    reader = MessageReader(reading, is_strict=is_strict)
    thread = threading.Thread(
        target=_read_all, args=(reader, adapter), name="nctakt dap reader", daemon=True
    )
    thread.start()
    adapter.serve()


def _read_all(reader: MessageReader, adapter: Adapter) -> None:
    """Give all messages of a client to its adapter."""
    try:
        while True:
            try:
                message = reader.read()
            except Failure as failure:
                adapter.refuse(failure)
                continue
            if message is None:
                break
            adapter.receive(message)
    except (OSError, ValueError):
        pass  # the client has gone
    finally:
        adapter.end()


def serve_pipe(*, folders: Sequence[str], language: Language) -> None:
    """Serve the client at standard input and output; what else is printed goes to standard error.

    The process and those that it starts, a PLC's among them, cannot write into the protocol.
    """
    own = os.dup(sys.stdout.fileno())
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    # Not sys.stdin: the process cannot end while a thread waits in that one's buffer.
    reading = os.fdopen(os.dup(sys.stdin.fileno()), "rb")
    with contextlib.suppress(OSError), os.fdopen(own, "wb") as writing:
        serve_streams(reading, writing, folders=folders, language=language)


class PortServer:
    """Serves clients at a port of this computer; ``port``: the one that it has.

    Raises ``Failure`` (901161) if the port is taken. ``session`` returns the session to attach to.
    """

    def __init__(
        self,
        port: int,
        *,
        folders: Sequence[str] = (),
        language: Language = "en",
        session: Callable[[], Session] | None = None,
    ) -> None:
        try:
            self._socket = socket.create_server((HOST, port))
        except (OSError, OverflowError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            found = diagnostic(ADDRESS_NOT_USABLE, host=HOST, port=port, reason=reason)
            raise Failure(found) from error
        self.port = int(self._socket.getsockname()[1])
        self._folders = folders
        self._language: Language = language
        self._session = session
        self._free = threading.Semaphore(MAX_CLIENTS)

    def serve(self) -> None:
        """Take clients until ``close``."""
        while True:
            try:
                client, _ = self._socket.accept()
            except OSError:
                return  # closed
            if not self._free.acquire(blocking=False):
                client.close()
                continue
            threading.Thread(
                target=self._serve_and_free, args=(client,), name="nctakt dap", daemon=True
            ).start()

    def _serve_and_free(self, client: socket.socket) -> None:
        try:
            self._serve_client(client)
        finally:
            self._free.release()

    def _serve_client(self, client: socket.socket) -> None:
        with (
            contextlib.suppress(OSError),  # the client has gone before the last bytes
            client,
            client.makefile("rb") as reading,
            client.makefile("wb") as writing,
        ):
            serve_streams(
                reading,
                writing,
                folders=self._folders,
                language=self._language,
                session=self._session,
                is_strict=True,
            )
            with contextlib.suppress(OSError):
                client.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        """Take no further clients."""
        with contextlib.suppress(OSError):  # not on each system
            self._socket.shutdown(socket.SHUT_RDWR)
        self._socket.close()

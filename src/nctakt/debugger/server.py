# SPDX-License-Identifier: MIT
"""The debugger on standard input and output, and on a port of this computer.

In: streams of bytes. Out: one adapter for each client until it goes. The port is one of this
computer alone, and a client there needs the token: with programs it runs a PLC in Python.
"""

from __future__ import annotations

import contextlib
import os
import sys
import threading
from collections.abc import Callable, Sequence
from typing import BinaryIO

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.debugger.adapter import Adapter, Enter
from nctakt.debugger.relay import HOST, KIND
from nctakt.ports.endpoint import Endpoint, Visitor
from nctakt.ports.framing import MessageReader, MessageWriter, Readable
from nctakt.session.session import Session

#: Clients with a program at a time.
MAX_CLIENTS = 8


def serve_streams(
    reading: Readable,
    writing: BinaryIO,
    *,
    folders: Sequence[str] = (),
    language: Language = "en",
    session: Callable[[], Session] | None = None,
    enter: Enter | None = None,
) -> None:
    """Serve one client until it goes; ``session`` returns somebody else's, to attach to.

    ``enter``: admits a client of a port to a program.
    """
    adapter = Adapter(
        MessageWriter(writing), folders=folders, language=language, shared=session, enter=enter
    )
    reader = MessageReader(reading, is_strict=enter is not None)
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
    """Serve the client at standard input and output; other output goes to standard error.

    The process and those that it starts, a PLC's among them, cannot write into the protocol.
    """
    own = os.dup(sys.stdout.fileno())
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    # Not sys.stdin: the process cannot end while a thread waits in that one's buffer.
    reading = os.fdopen(os.dup(sys.stdin.fileno()), "rb")
    with contextlib.suppress(OSError), os.fdopen(own, "wb") as writing:
        serve_streams(reading, writing, folders=folders, language=language)


class PortServer:
    """Serves clients at a port of this computer, by its ``endpoint``.

    Raises ``Failure`` (901920) if the system refuses the port. ``session`` returns the session to
    attach to.
    """

    def __init__(
        self,
        port: int,
        *,
        folders: Sequence[str] = (),
        language: Language = "en",
        session: Callable[[], Session] | None = None,
    ) -> None:
        self.endpoint = Endpoint(KIND, HOST, port, max_guests=MAX_CLIENTS)
        self._folders = folders
        self._language: Language = language
        self._session = session

    def serve(self) -> None:
        """Take clients until ``close``."""
        self.endpoint.serve(self._serve_visitor)

    def _serve_visitor(self, visitor: Visitor) -> None:
        serve_streams(
            visitor.reading,
            visitor.writing,
            folders=self._folders,
            language=self._language,
            session=self._session,
            enter=visitor.enter,
        )

    def close(self) -> None:
        """Take no further clients, and leave those that there are."""
        self.endpoint.close()

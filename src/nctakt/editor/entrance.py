# SPDX-License-Identifier: MIT
"""How an editor connects to the language server: by standard streams, or a port.

In: a server. Out: its end, with the editor or by a signal. At a port the first message has to be
``initialize`` with the token in its ``initializationOptions``; any other start, such as from a page
in a browser, is refused and disconnected.
"""

from __future__ import annotations

import json
import os
import queue
import sys
import threading
from collections.abc import Callable

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.editor.incoming import Incoming
from nctakt.editor.server import Server
from nctakt.messages import diagnostic
from nctakt.messages.connections.ports import TOKEN_NEEDED
from nctakt.ports.endpoint import Endpoint, Visitor
from nctakt.ports.framing import Message, MessageReader

#: The name of a token's file.
KIND = "lsp"

#: The code of an error of JSON-RPC: a request that is not valid.
_INVALID_REQUEST = -32600


def serve_streams(server: Server) -> None:
    """Serve the editor at standard input and output."""
    number = sys.stdin.fileno()
    server.serve(Incoming(lambda size: os.read(number, size)), sys.stdout.buffer)


def serve_port(
    server: Server,
    host: str,
    port: int,
    announce: Callable[[str], None],
    warn: Callable[[Diagnostic], None],
) -> None:
    """Serve the first editor that comes with the token, until it disconnects.

    ``announce`` receives address and token. Raises ``Failure`` (901920) if the port is refused.
    """
    endpoint = Endpoint(KIND, host, port, max_guests=1)
    entered: queue.SimpleQueue[tuple[Visitor, Message]] = queue.SimpleQueue()
    is_over = threading.Event()

    def receive(visitor: Visitor) -> None:
        message = _first_message(visitor, server)
        if message is not None:
            entered.put((visitor, message))
            is_over.wait()

    try:
        for line in endpoint.lines():
            announce(line)
        if endpoint.warning is not None:
            warn(endpoint.warning)
        threading.Thread(
            target=endpoint.serve, args=(receive,), name="nctakt lsp", daemon=True
        ).start()
        visitor, message = entered.get()
        server.serve(Incoming(visitor.reading.read1, _framed(message)), visitor.writing)
    except KeyboardInterrupt:
        pass  # the way to end it
    finally:
        is_over.set()
        endpoint.close()


def _first_message(visitor: Visitor, server: Server) -> Message | None:
    """Return the request that brings the token, ``None`` if the visitor is refused."""
    try:
        message = MessageReader(visitor.reading, is_strict=True).read()
    except Failure:
        return None  # not the protocol: there is no client to notify
    if message is None:
        return None
    parameters = message.get("params")
    options = parameters.get("initializationOptions") if isinstance(parameters, dict) else None
    token = options.get("token") if isinstance(options, dict) else None
    method = message.get("method")
    try:
        if method != "initialize":
            raise Failure(diagnostic(TOKEN_NEEDED, request=str(method)[:40]))
        visitor.enter(token if isinstance(token, str) else None, "initialize")
    except Failure as failure:
        text = failure.diagnostics[0].headline(server.language)
        error = {"code": _INVALID_REQUEST, "message": text}
        number = message["id"] if isinstance(message.get("id"), int | str) else None
        answer = {"jsonrpc": "2.0", "id": number, "error": error}
        visitor.writing.write(_framed(answer))
        visitor.writing.flush()
        return None
    return message


def _framed(message: Message) -> bytes:
    body = json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n%b" % (len(body), body)

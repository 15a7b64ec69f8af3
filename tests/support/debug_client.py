# SPDX-License-Identifier: MIT
"""A small client of the debugger: requests with their answers, events by name."""

from __future__ import annotations

import contextlib
import json
import socket
import threading
from collections.abc import Callable
from types import TracebackType
from typing import Any, BinaryIO

from nctakt.debugger.server import serve_streams
from nctakt.ports.framing import MessageReader

#: How long a test waits for a message, in seconds.
PATIENCE_S = 60.0


class Refused(Exception):
    """A request that was answered with an error; ``error``: its body."""

    def __init__(self, answer: dict[str, Any]) -> None:
        super().__init__(answer["message"])
        self.error = answer.get("body", {}).get("error", {})


class DebugClient:
    """A client at the ends of two pipes, with a server in its own thread, or at a port."""

    def __init__(self, port: int | None = None, **options: Any) -> None:
        if port is None:
            own, other = socket.socketpair()
        else:
            own = socket.create_connection(("127.0.0.1", port))
        own.settimeout(PATIENCE_S)
        self._socket = own
        self.writing: BinaryIO = own.makefile("wb", buffering=0)
        self._reading = own.makefile("rb")

        def serve() -> None:
            with other, other.makefile("rb") as reading, other.makefile("wb") as writing:
                serve_streams(reading, writing, **options)

        self.thread = threading.Thread(target=serve if port is None else int, daemon=True)
        self.thread.start()
        self._reader = MessageReader(self._reading, is_strict=False)
        self._count = 0
        self.events: list[dict[str, Any]] = []
        self.passed: list[dict[str, Any]] = []

    def send(self, command: str, **arguments: Any) -> int:
        """Send a request, and return its number."""
        self._count += 1
        body = {"seq": self._count, "type": "request", "command": command, "arguments": arguments}
        self.send_bytes(json.dumps(body).encode())
        return self._count

    def send_bytes(self, body: bytes) -> None:
        self.writing.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))

    def _next(self) -> dict[str, Any]:
        message = self._reader.read()
        assert message is not None, "the debugger has gone"
        return message

    def answer(self, number: int) -> dict[str, Any]:
        """Return the answer to a request; events before it are kept."""
        while True:
            message = self._next()
            if message["type"] == "event":
                self.events.append(message)
            elif message["request_seq"] == number:
                return message
            else:
                self.passed.append(message)

    def ask(self, command: str, **arguments: Any) -> Any:
        """Return the body of the answer to a request; raises ``Refused``."""
        answer = self.answer(self.send(command, **arguments))
        if not answer["success"]:
            raise Refused(answer)
        return answer.get("body")

    def event(self, name: str, wanted: Callable[[dict[str, Any]], bool] | None = None) -> Any:
        """Return the body of the next event of a name that is as wanted."""
        while True:
            for index, message in enumerate(self.events):
                if message["event"] == name and (wanted is None or wanted(message["body"])):
                    del self.events[: index + 1]
                    return message["body"]
            message = self._next()
            if message["type"] == "event":
                self.events.append(message)
            else:
                self.passed.append(message)

    # --- shorter ways ---------------------------------------------------------------------------

    def begin(self, program: str, **options: Any) -> dict[str, Any]:
        """Launch a program, up to where breakpoints are set; return what the debugger can do."""
        abilities = self.ask("initialize", adapterID="nctakt", **options.pop("client", {}))
        self.ask("launch", program=program, **options)
        self.event("initialized")
        return dict(abilities)

    def stopped(self) -> dict[str, Any]:
        """Return the next stop with the line of the innermost frame."""
        body = self.event("stopped")
        frames = self.ask("stackTrace", threadId=body["threadId"])["stackFrames"]
        return {**body, "line": frames[0]["line"] if frames else 0, "frames": frames}

    def go(self, command: str = "continue", **arguments: Any) -> dict[str, Any]:
        """Go on or back, and return where it has stopped."""
        self.ask(command, **{"threadId": 1, **arguments})
        return self.stopped()

    def console(self, text: str, context: str = "repl") -> str:
        """Return the answer of the console to a line."""
        return str(self.ask("evaluate", expression=text, context=context)["result"])

    def scope(self, name: str, frame: int | None = None) -> dict[str, Any]:
        """Return the variables of a scope of the innermost frame by name."""
        if frame is None:
            frame = self.ask("stackTrace", threadId=1)["stackFrames"][0]["id"]
        scopes = {one["name"]: one for one in self.ask("scopes", frameId=frame)["scopes"]}
        return self.unfolded(scopes[name]["variablesReference"])

    def unfolded(self, reference: int) -> dict[str, Any]:
        """Return the variables of a reference by name."""
        found = self.ask("variables", variablesReference=reference)["variables"]
        return {one["name"]: one for one in found}

    def close(self) -> None:
        with contextlib.suppress(OSError):
            self._socket.shutdown(socket.SHUT_WR)
        self.thread.join(PATIENCE_S)
        for one in (self.writing, self._reading, self._socket):
            one.close()

    def __enter__(self) -> DebugClient:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

# SPDX-License-Identifier: MIT
"""Messages of editors and debuggers on a stream of bytes, within bounds.

In: bytes of a client: lines of a header, an empty line, JSON. Out: messages as dictionaries, and
vice versa. A message of more than ``MAX_MESSAGE`` bytes, a header without a length, and JSON that
is no object are reported by number; where the next message begins is found again on a pipe. On a
socket such bytes end the connection: a page in a browser can send them, and must not be understood.
"""

from __future__ import annotations

import json
import threading
from math import isfinite
from typing import Any, BinaryIO, Protocol

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import MESSAGE_TOO_LONG, NOT_A_HEADER, NOT_A_MESSAGE

#: The longest message, and the longest line of a header, in bytes.
MAX_MESSAGE = 8 * 1024 * 1024
MAX_HEADER_LINE = 1024

#: Lines of a header at most.
MAX_HEADER_LINES = 8

#: Bytes that are read at once of a message that is passed over.
_PASSED_OVER = 65536

Message = dict[str, Any]


class Readable(Protocol):
    """The source of messages."""

    def readline(self, limit: int, /) -> bytes:
        """Return a line, of at most ``limit`` bytes."""

    def read(self, size: int, /) -> bytes:
        """Return this many bytes; less at the end."""


class MessageReader:
    """Reads messages; ``is_strict``: the first bytes that are no header end the stream."""

    def __init__(self, stream: Readable, *, is_strict: bool) -> None:
        self._stream = stream
        self._is_strict = is_strict
        self._is_ended = False

    def read(self) -> Message | None:
        """Return the next message, ``None`` at the end of the stream.

        Raises ``Failure`` for other bytes (901220, 901221, 901222); the next call continues after
        them.
        """
        length = None if self._is_ended else self._length()
        if length is None:
            return None
        if length > MAX_MESSAGE:
            self._pass_over(length)
            raise Failure(diagnostic(MESSAGE_TOO_LONG, count=length, limit=MAX_MESSAGE))
        body = self._stream.read(length)
        if len(body) < length:
            return None
        try:
            message = json.loads(body, parse_float=_number, parse_constant=_number)
        except (ValueError, RecursionError) as error:
            raise Failure(diagnostic(NOT_A_MESSAGE, reason=str(error))) from error
        if not isinstance(message, dict):
            raise Failure(diagnostic(NOT_A_MESSAGE, reason=type(message).__name__))
        return message

    def _length(self) -> int | None:
        """Return the length of the next message; ``None`` at the end of the stream."""
        length: int | None = None
        for _ in range(MAX_HEADER_LINES):
            line = self._stream.readline(MAX_HEADER_LINE)
            if not line:
                return None
            name, _, value = line.partition(b":")
            value = value.strip()
            if line in (b"\r\n", b"\n") and length is not None:
                return length
            if name.lower() == b"content-length" and value.isdigit() and len(value) < 16:
                length = int(value)
            elif name.lower() != b"content-type" or (length is None and self._is_strict):
                self._refuse(line)
        self._refuse(b"")
        return None

    def _refuse(self, line: bytes) -> None:
        """Raise ``Failure``; on a pipe the next line may be a header again."""
        self._is_ended = self._is_strict
        shown = line[:40].decode("ascii", "replace").strip()
        raise Failure(diagnostic(NOT_A_HEADER, text=shown))

    def _pass_over(self, length: int) -> None:
        self._is_ended = self._is_strict
        while length > 0 and not self._is_ended:
            skipped = len(self._stream.read(min(length, _PASSED_OVER)))
            if not skipped:
                return
            length -= skipped


def _number(text: str) -> float:
    """Return a number of JSON; raises ``ValueError`` if no message can hold it."""
    number = float(text)
    if not isfinite(number):
        raise ValueError(text)
    return number


class MessageWriter:
    """Writes messages with running numbers, from any thread, each as a whole."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self._lock = threading.Lock()
        self._count = 0
        self.is_broken = False

    def write(self, message: Message) -> None:
        """Write a message; once the client is gone, nothing happens."""
        with self._lock:
            self._count += 1
            body = json.dumps({"seq": self._count, **message}, allow_nan=False).encode()
            try:
                self._stream.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
                self._stream.flush()
            except (OSError, ValueError):
                self.is_broken = True

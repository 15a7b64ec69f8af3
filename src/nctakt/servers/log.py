# SPDX-License-Identifier: MIT
"""What the servers tell of their clients: one JSON object a line.

In: what happened, of which door and client, and why. Out: lines with a time. A refusal that comes
again and again is told once in ``REPEAT_S`` seconds, with the number of those between.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from datetime import UTC, datetime

#: Seconds between two lines about the same refusal of the same client.
REPEAT_S = 10.0

#: Lines about clients of a host that come, and that go, in this time.
MAX_VISITS = 20

#: Kinds of lines that are counted at most.
_MAX_REMEMBERED = 10_000


class ServerLog:
    """Writes lines; ``write`` ``None``: nobody reads them."""

    def __init__(
        self,
        write: Callable[[str], object] | None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._write = write
        self._clock = clock
        self._counts: dict[tuple[str, str, str], tuple[float, int]] = {}

    def note(self, event: str, **words: object) -> None:
        """Tell what happened."""
        self._line("info", event, words)

    def error(self, event: str, **words: object) -> None:
        """Tell what went wrong in a server."""
        self._line("error", event, words)

    def visit(self, event: str, door: str, host: str, **words: object) -> None:
        """Tell that a client of a host has come or gone; not each one of a storm of them."""
        repeated = self._unwritten((event, door, host), MAX_VISITS)
        if repeated is not None:
            self._line("info", event, {"door": door, "host": host, **words, **repeated})

    def refuse(self, door: str, client: str, reason: str, **words: object) -> None:
        """Tell that something of a client was refused."""
        repeated = self._unwritten((door, client, reason), 1)
        if repeated is not None:
            shown = {"door": door, "client": client, "reason": reason, **words, **repeated}
            self._line("warning", "refused", shown)

    def _unwritten(self, key: tuple[str, str, str], limit: int) -> dict[str, object] | None:
        """Return how many lines like this were not written, ``None`` if this one is not either."""
        now = self._clock()
        begin, count = self._counts.get(key, (-REPEAT_S, 0))
        if now - begin < REPEAT_S:
            self._counts[key] = begin, count + 1
            return {} if count < limit else None
        if len(self._counts) >= _MAX_REMEMBERED:
            self._counts.clear()
        self._counts[key] = now, 1
        return {"repeated": count - limit} if count > limit else {}

    def _line(self, level: str, event: str, words: dict[str, object]) -> None:
        if self._write is None:
            return
        moment = datetime.now(UTC).isoformat(timespec="milliseconds")
        line = {"time": moment, "level": level, "event": event, **words}
        text = json.dumps(line, ensure_ascii=False, default=str)
        try:
            self._write(escaped(text) + "\n")
        except (OSError, ValueError):
            self._write = None  # a full disk ends the log, not the servers


def escaped(document: str) -> str:
    """Return a JSON document in which surrogates, which have no UTF-8, are escapes of JSON."""
    return document.encode("utf-8", "backslashreplace").decode("utf-8")

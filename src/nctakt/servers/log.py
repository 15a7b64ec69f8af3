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

#: Refusals that are remembered at most.
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
        self._refused: dict[tuple[str, str, str], tuple[float, int]] = {}

    def note(self, event: str, **words: object) -> None:
        """Tell what happened."""
        self._line("info", event, words)

    def error(self, event: str, **words: object) -> None:
        """Tell what went wrong in a server."""
        self._line("error", event, words)

    def refuse(self, door: str, client: str, reason: str, **words: object) -> None:
        """Tell that something of a client was refused."""
        key = door, client, reason
        now = self._clock()
        last, count = self._refused.get(key, (-REPEAT_S, 0))
        if now - last < REPEAT_S:
            self._refused[key] = last, count + 1
            return
        if len(self._refused) >= _MAX_REMEMBERED:
            self._refused.clear()
        self._refused[key] = now, 0
        repeated = {"repeated": count} if count else {}
        words_of_line = {"door": door, "client": client, "reason": reason, **words, **repeated}
        self._line("warning", "refused", words_of_line)

    def _line(self, level: str, event: str, words: dict[str, object]) -> None:
        if self._write is None:
            return
        moment = datetime.now(UTC).isoformat(timespec="milliseconds")
        line = {"time": moment, "level": level, "event": event, **words}
        try:
            self._write(json.dumps(line, ensure_ascii=False, default=str) + "\n")
        except (OSError, ValueError):
            self._write = None  # a full disk ends the log, not the servers

# SPDX-License-Identifier: MIT
"""The servers' log about their clients: one JSON object per line.

In: events, with endpoint, client and reason. Out: lines with a time. A repeated event of a client
is logged once in ``REPEAT_S`` seconds, regardless of its port, then with the number of repetitions;
an endpoint has ``MAX_LINES`` lines in that time, whatever its clients call themselves.
"""

from __future__ import annotations

import json
import re
import time
from collections import Counter
from collections.abc import Callable, Mapping
from datetime import UTC, datetime

from nctakt.base.dataclass import dataclass

#: Seconds between two lines about the same refusal of the same client.
REPEAT_S = 10.0

#: Lines about clients of a host that come, and that go, in this time.
MAX_VISITS = 20

#: Lines about the clients of an endpoint in this time.
MAX_LINES = 100

#: A client with its port: ``1.2.3.4.1.1:33000``, ``[::1]:4711``.
_WITH_PORT = re.compile(r"([^:]+|\[.*\]):\d+")

#: The key of equal lines: event, endpoint, client without its port, reason.
_Key = tuple[str, str, str, str]


@dataclass(slots=True)
class _Repeats:
    """Equal lines since ``begin_s``; of ``count`` as many as ``limit`` were written."""

    begin_s: float
    limit: int
    level: str
    words: Mapping[str, object]
    count: int = 1

    @property
    def left_out(self) -> int:
        return max(0, self.count - self.limit)


@dataclass(slots=True)
class _Budget:
    """The lines of an endpoint since ``begin_s``: those written, and those beyond the limit."""

    begin_s: float
    written: int = 0
    left_out: int = 0


class ServerLog:
    """Writes lines; ``write``: ``None`` if they are not wanted.

    ``refused``: how often something was refused, by endpoints.
    """

    def __init__(
        self,
        write: Callable[[str], object] | None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._write = write
        self._clock = clock
        self.refused: Counter[str] = Counter()
        self._repeats: dict[_Key, _Repeats] = {}
        self._budgets: dict[str, _Budget] = {}

    def note(self, event: str, **words: object) -> None:
        """Log an event."""
        self._line("info", event, words)

    def error(self, event: str, *, endpoint: str = "", reason: str = "", **words: object) -> None:
        """Log an error of a server."""
        shown = (
            {"endpoint": endpoint, **words, "reason": reason}
            if endpoint
            else {**words, "reason": reason}
        )
        self._bounded("error", (event, endpoint, "", reason), 1, shown)

    def visit(self, event: str, endpoint: str, host: str, **words: object) -> None:
        """Log that a client of a host has come or gone; not every one of many."""
        shown = {"endpoint": endpoint, "host": host, **words}
        self._bounded("info", (event, endpoint, host, ""), MAX_VISITS, shown)

    def refuse(self, endpoint: str, client: str, reason: str, **words: object) -> None:
        """Log a refusal of a client."""
        self.refused[endpoint] += 1
        found = _WITH_PORT.fullmatch(client)
        party = client if found is None else found[1]
        shown = {"endpoint": endpoint, "client": client, "reason": reason, **words}
        self._bounded("warning", ("refused", endpoint, party, reason), 1, shown)

    def report_counts(self) -> None:
        """Log the numbers of repeated events."""
        self._end_repeats(None)
        self._end_budgets(None)

    def _bounded(self, level: str, key: _Key, limit: int, words: Mapping[str, object]) -> None:
        """Write a line unless there are too many like it, or too many of the endpoint."""
        now = self._clock()
        repeats = self._repeats.get(key)
        if repeats is not None and now - repeats.begin_s < REPEAT_S:
            repeats.count += 1
            if repeats.count <= limit and self._has_room(key[1], now):
                self._line(level, key[0], words)
            return
        left_out = 0 if repeats is None else self._repeats.pop(key).left_out
        self._end_repeats(now)
        self._end_budgets(now)
        if not self._has_room(key[1], now):
            self._budgets[key[1]].left_out += left_out
            return
        self._repeats[key] = _Repeats(now, limit, level, words)
        self._line(level, key[0], {**words, **({"repeated": left_out} if left_out else {})})

    def _end_repeats(self, now: float | None) -> None:
        """Log the counts whose time is over, without ``now`` all; the oldest come first."""
        for key, repeats in tuple(self._repeats.items()):
            if now is not None and now - repeats.begin_s < REPEAT_S:
                return
            del self._repeats[key]
            if repeats.left_out:
                words = {**repeats.words, "repeated": repeats.left_out}
                self._line(repeats.level, key[0], words)

    def _has_room(self, endpoint: str, now: float) -> bool:
        """Return whether an endpoint may have a further line, and count it."""
        budget = self._budgets.setdefault(endpoint, _Budget(now))
        if budget.written >= MAX_LINES:
            budget.left_out += 1
            return False
        budget.written += 1
        return True

    def _end_budgets(self, now: float | None) -> None:
        """Log how many lines endpoints had too many, like ``_end_repeats``."""
        for endpoint, budget in tuple(self._budgets.items()):
            if now is not None and now - budget.begin_s < REPEAT_S:
                continue
            del self._budgets[endpoint]
            if budget.left_out:
                self._line("warning", "left out", {"endpoint": endpoint, "lines": budget.left_out})

    def _line(self, level: str, event: str, words: Mapping[str, object]) -> None:
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

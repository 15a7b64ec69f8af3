# SPDX-License-Identifier: MIT
"""The predicted path: a copy of the session's controller runs ahead without further inputs.

In: a session, and the input up to which it is known. Out: for browsers the ticks, positions and
reactions to come, computed in a separate thread, and why they end there.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Sequence
from functools import partial
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.live.texts import Texts
from nctakt.live.track import marks_of
from nctakt.live.view import rounded
from nctakt.session.ahead import Future
from nctakt.session.session import Session

#: How long the inputs must be unchanged before the future is recomputed, in seconds.
_REST_S = 0.3

#: How long browsers draw the known part while the rest is computed, in seconds.
_DISTANCE_S = 0.3

#: The languages in which browsers may show why it ends.
LANGUAGES: tuple[Language, ...] = ("en", "de")

#: Ticks of a branch after which its future is looked for again: it reaches farther than that.
_AGAIN_TICKS = 250_000


@dataclass(frozen=True, slots=True)
class FutureOf:
    """The state that a future depends on.

    The session's serial number, branch and number of inputs, what is shown, and how far it has run.
    """

    serial: int
    branch: int
    inputs: int
    signals: tuple[str, ...]
    file: str
    stretch: int

    @classmethod
    def of(cls, session: Session, serial: int, signals: Sequence[str], file: str) -> FutureOf:
        """Return the state that the future of a session depends on now."""
        branch = session.branch
        stretch = session.branches[branch] // _AGAIN_TICKS
        return cls(serial, branch, session.input_count, tuple(signals), file, stretch)


class Ahead:
    """The future of a session, for all browsers."""

    def __init__(self) -> None:
        self._known: tuple[FutureOf, dict[str, Any]] | None = None
        self._request: tuple[FutureOf, Session] | None = None
        self._done: tuple[FutureOf, Session] | None = None
        self._changed = threading.Condition()
        self._is_closed = False
        self._thread = threading.Thread(target=self._work, name="nctakt ahead", daemon=True)
        self._thread.start()

    def request(self, subject: FutureOf, session: Session) -> None:
        """Computes the future of a session."""
        with self._changed:
            if self._request is None or self._request[0] != subject:
                self._request = subject, session
                self._changed.notify_all()

    def shown(self, subject: FutureOf) -> dict[str, Any] | None:
        """Return the future for browsers; ``None`` while it is not known."""
        known = self._known
        return known[1] if known is not None and known[0] == subject else None

    def _work(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._is_closed or self._request != self._done)
                request, done = self._request, self._done
                if request is None or self._is_closed:
                    return
                is_new = done is None or request[0].serial != done[0].serial
                is_replaced = partial(self._is_replaced, request)
                if not is_new and self._changed.wait_for(is_replaced, _REST_S):
                    continue
                self._done = request
            try:
                self._look(*request)
            except (Failure, RuntimeError):
                continue  # the session is closed, or its past has changed: nothing is shown

    def _is_replaced(self, request: tuple[FutureOf, Session]) -> bool:
        return self._request is not request or self._is_closed

    def _look(self, subject: FutureOf, session: Session) -> None:
        futures = session.future(*subject.signals)
        future, due_s = None, 0.0
        for future in futures:
            if self._is_closed or self._request is None or self._request[0] != subject:
                close = getattr(futures, "close", None)  # the copy ends with it
                if close is not None:
                    close()
                return
            if time.monotonic() >= due_s:
                self._known = subject, drawn(future, subject.signals, subject.file)
                due_s = time.monotonic() + _DISTANCE_S
        if future is not None:
            self._known = subject, drawn(future, subject.signals, subject.file)

    def close(self) -> None:
        """End the thread."""
        with self._changed:
            self._is_closed = True
            self._changed.notify_all()


def drawn(future: Future, signals: Sequence[str], file: str) -> dict[str, Any]:
    """Return a future as browsers draw it."""
    return {
        "names": list(signals),
        "ticks": list(future.ticks),
        "columns": [[rounded(value) for value in column] for column in future.columns],
        "marks": [mark for mark in marks_of(future.events, file) if mark[1] == "fired"],
        "reason": future.reason,
        "causes": {language: _causes(future, language) for language in LANGUAGES},
    }


def _causes(future: Future, language: Language) -> str:
    """Return the waits of the programs, or the errors of the run, with their lines."""
    texts = []
    for one in future.causes:
        awaited = one.values.get("awaited")
        text = awaited.get(language) if isinstance(awaited, Text) else f"{one.id}"
        line = one.span.line if one.span is not None else 0
        texts.append(f"{text} ({Texts(language)['line']} {line})" if line else text)
    return ", ".join(dict.fromkeys(texts))

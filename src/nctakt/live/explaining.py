# SPDX-License-Identifier: MIT
"""Why reactions fired or did not, for the place at which a session stands.

In: a session that stands. Out: the report of its past, made in a thread of its own once the session
has stood for a moment; the ticks in which conditions were true.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import partial

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.live.texts import Texts
from nctakt.results.why import WhyReport
from nctakt.session.session import Session

#: How long a session stands before its past is explained, in seconds.
_REST_S = 0.6

#: Ticks of a past that is explained without being asked for.
_MAX_TICKS = 1_000_000

#: The state that is explained: the session's serial number, its branch and its tick.
Moment = tuple[int, int, int]


class Explainer:
    """Explains the past of a session; ``notify`` is called when it has."""

    def __init__(self, notify: Callable[[], None]) -> None:
        self._notify = notify
        self._report: tuple[Moment, WhyReport] | None = None
        self._wish: tuple[Moment, Session] | None = None
        self._changed = threading.Condition()
        self._is_closed = False
        self._thread = threading.Thread(target=self._work, name="nctakt why", daemon=True)
        self._thread.start()

    def wish(self, moment: Moment, session: Session) -> None:
        """Explain this place once the session has stood there for a moment."""
        if not 0 < moment[2] <= _MAX_TICKS:
            return
        with self._changed:
            if self._wish is None or self._wish[0] != moment:
                self._wish = (moment, session)
                self._changed.notify_all()

    def forget_wish(self) -> None:
        """Explain nothing: the session has gone on."""
        with self._changed:
            self._wish = None
            self._changed.notify_all()

    def report(self, moment: Moment, session: Session) -> WhyReport:
        """Return the report of this place, at once if it is there; raises ``Failure``."""
        known = self._report
        if known is not None and known[0] == moment:
            return known[1]
        report = session.why()
        if report.first_tick + report.ticks == moment[2]:  # it has not gone on meanwhile
            self._report = (moment, report)
            self._notify()
        return report

    def bars(self, moment: Moment, file: str) -> list[dict[str, object]]:
        """Return when conditions were true: their line, first ticks and ends; empty if unknown."""
        known = self._report
        return bars_of(known[1], file) if known is not None and known[0] == moment else []

    def _work(self) -> None:
        while not self._is_closed:
            with self._changed:
                self._changed.wait_for(lambda: self._wish is not None or self._is_closed)
                wish = self._wish
                is_replaced = partial(self._is_replaced, wish)
                if wish is None or self._changed.wait_for(is_replaced, _REST_S):
                    continue
                self._wish = None
            try:
                self.report(*wish)
            except (Failure, RuntimeError):
                time.sleep(_REST_S)  # whoever clicks gets the reason

    def _is_replaced(self, wish: tuple[Moment, Session] | None) -> bool:
        return self._wish is not wish or self._is_closed

    def close(self) -> None:
        """End the thread."""
        with self._changed:
            self._is_closed = True
            self._changed.notify_all()


def bars_of(report: WhyReport, file: str) -> list[dict[str, object]]:
    """Return the stretches in which conditions of a file were true, by their lines."""
    found: dict[int, list[list[int]]] = {}
    for cycle in report.cycles:
        for branch in cycle.branches:
            if branch.span.file != file:
                continue
            bars = found.setdefault(branch.span.line, [])
            ends = [series.last_tick + 1 for series in branch.evaluated.series]
            changes = branch.condition.changes
            for index, change in enumerate(changes):
                if change.truth:
                    is_last = index + 1 == len(changes)
                    end = max([change.tick + 1, *ends]) if is_last else changes[index + 1].tick
                    bars.append([change.tick, end])
    return [{"line": line, "bars": sorted(bars)} for line, bars in sorted(found.items())]


def why_text(report: WhyReport, line: int, tick: int, language: Language) -> str:
    """Return in words why the condition in a line had its state in the last tick, and its history.

    Raises ``Failure`` for a line without a condition, and before the first tick.
    """
    chosen = report.select(line=line)
    rule = "─" * 40
    heading = Texts(language)["history"]
    return f"{chosen.render_at(tick - 1, language)}\n{rule}\n{heading}\n{chosen.render(language)}"

# SPDX-License-Identifier: MIT
"""Why reactions fired or did not, for the place at which a session is.

In: a session at rest. Out: the report of its past, made in a thread of its own once the session
has rested for a moment; the ticks in which conditions were true.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.live.texts import Texts
from nctakt.results.explained.why import WhyReport
from nctakt.session.session import Session

#: How long a session rests before its past is explained, in seconds.
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
        self._farthest: tuple[Moment, WhyReport] | None = None
        self._lanes: tuple[WhyReport | None, str, list[dict[str, Any]]] = (None, "", [])
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
            self._keep(moment, report)
            self._notify()
        return report

    def knows(self, moment: Moment) -> bool:
        """Return whether the report of this place is there."""
        return self._report is not None and self._report[0] == moment

    def _keep(self, moment: Moment, report: WhyReport) -> None:
        """Keep a report; that of the farthest tick of a branch also for its lanes."""
        self._report = (moment, report)
        farthest = self._farthest
        if farthest is None or farthest[0][:2] != moment[:2] or farthest[0][2] < moment[2]:
            self._farthest = (moment, report)

    def cut(self, serial: int, branch: int, tick: int) -> None:
        """Another branch is shown, whose ticks before ``tick`` are those of the one before."""
        farthest = self._farthest
        if farthest is not None:
            (known, _, end), report = farthest
            self._farthest = None
            if known == serial and tick > 0:
                self._farthest = ((serial, branch, min(end, tick)), report)

    def bars(self, moment: Moment, file: str) -> dict[str, Any]:
        """Return when conditions of the branch were true, exactly, and up to which tick.

        ``lines``: for each its line, from when on it is known, first ticks and ends.
        """
        farthest = self._farthest
        if farthest is None or farthest[0][:2] != moment[:2]:
            return {"end": 0, "lines": []}
        known, _, lines = self._lanes
        if known is not farthest[1] or self._lanes[1] != file:
            lines = bars_of(farthest[1], file)
            self._lanes = farthest[1], file, lines
        return {"end": farthest[0][2], "lines": lines}

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


def bars_of(report: WhyReport, file: str) -> list[dict[str, Any]]:
    """Return the stretches in which conditions of a file were true, by their lines.

    ``first``: the tick from which on they are known.
    """
    found: dict[int, list[list[int]]] = {}
    firsts: dict[int, int] = {}
    begin = report.first_tick
    if report.left_out and report.cycles:
        begin = min((cycle.life[0].tick for cycle in report.cycles if cycle.life), default=begin)
    for cycle in report.cycles:
        for branch in cycle.branches:
            if branch.span.file != file:
                continue
            line, condition = branch.span.line, branch.condition
            bars = found.setdefault(line, [])
            changes = condition.changes
            first = changes[0].tick if condition.changes_left_out else begin
            firsts[line] = max(first, firsts.get(line, first))
            ends = [series.last_tick + 1 for series in branch.evaluated.series]
            for index, change in enumerate(changes):
                if change.truth:
                    is_last = index + 1 == len(changes)
                    end = max([change.tick + 1, *ends]) if is_last else changes[index + 1].tick
                    bars.append([change.tick, end])
    return [
        {"line": line, "first": firsts[line], "bars": sorted(bars)}
        for line, bars in sorted(found.items())
    ]


def why_text(report: WhyReport, line: int, language: Language) -> str:
    """Return why the condition in a line had its state in the last tick, and its history.

    It begins with the answer. Raises ``Failure`` for a line without a condition.
    """
    chosen, tick = report.select(line=line), report.last_tick
    rule = "─" * 40
    parts = [chosen.render_answer(tick, language), chosen.render_at(tick, language)]
    parts = [f"{part}{rule}\n" for part in parts if part]
    return "".join(parts) + f"{Texts(language)['history']}\n{chosen.render(language)}"

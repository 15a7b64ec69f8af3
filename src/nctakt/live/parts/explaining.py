# SPDX-License-Identifier: MIT
"""Why reactions fired or did not, for the place at which a session is.

In: a session at rest. Out: the report of its past, made in a separate thread once the session has
rested for a moment; the ticks in which conditions were true.
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

#: Ticks of a past that is explained without being asked for: five hours of 1 ms fit.
_MAX_TICKS = 20_000_000

#: The state that is explained: the session's serial number, its branch and its tick.
Moment = tuple[int, int, int]


class _GoneOnError(Exception):
    """The session has left the place that is being explained, or more is asked for."""


class Explainer:
    """Explains the past of a session; ``notify`` is called when it has."""

    def __init__(self, notify: Callable[[], None]) -> None:
        self._notify = notify
        self._report: tuple[Moment, WhyReport] | None = None
        self._widest: tuple[Moment, Session, WhyReport] | None = None
        self._lanes: tuple[WhyReport | None, str, list[dict[str, Any]]] = (None, "", [])
        self._request: tuple[Moment, Session] | None = None
        self._current: Moment | None = None
        self._questions = 0
        self._changed = threading.Condition()
        self._is_closed = False
        self._thread = threading.Thread(target=self._work, name="nctakt why", daemon=True)
        self._thread.start()

    def request(self, moment: Moment, session: Session) -> None:
        """Explain this place once the session has been there for a moment."""
        if not 0 < moment[2] <= _MAX_TICKS:
            return
        with self._changed:
            if moment == self._current:
                return
            self._current = None
            if self._request is None or self._request[0] != moment:
                self._request = (moment, session)
                self._changed.notify_all()

    def forget_request(self) -> None:
        """Explain nothing: the session has gone on."""
        with self._changed:
            self._request = self._current = None
            self._changed.notify_all()

    def report(self, moment: Moment, session: Session) -> WhyReport:
        """Return the report of this place to a caller who waits for it; raises ``Failure``.

        Explanations made without a request give way, and continue afterwards.
        """
        with self._changed:
            self._questions += 1
        try:
            return self._report_of(moment, session, lambda: None)
        finally:
            with self._changed:
                self._questions -= 1
                self._current = None

    def _report_of(
        self, moment: Moment, session: Session, meanwhile: Callable[[], None]
    ) -> WhyReport:
        """Return the report of this place, at once if it is there; raises ``Failure``.

        ``meanwhile`` may end it by an exception.
        """
        known = self._report
        if known is not None and known[0] == moment:
            return known[1]
        report = self._explained(moment, session, meanwhile)
        self._report = (moment, report)
        self._notify()
        return report

    def knows(self, moment: Moment) -> bool:
        """Return whether the report of this place is there."""
        return self._report is not None and self._report[0] == moment

    def _explained(
        self, moment: Moment, session: Session, meanwhile: Callable[[], None]
    ) -> WhyReport:
        """Explain a place; the lanes of its branch only get longer by it, never shorter."""
        report = session.why(moment[2], moment[1], meanwhile=meanwhile)
        if _exact_end(self._widest, moment) <= moment[2]:
            self._widest = moment, session, report
        return report

    def bars(self, moment: Moment, file: str) -> dict[str, Any]:
        """Return when conditions of the branch were true, exactly, and up to which tick.

        ``lines``: for each its line, from when on it is known, first ticks and ends.
        """
        widest = self._widest
        end = _exact_end(widest, moment)
        if widest is None or not end:
            return {"end": 0, "lines": []}
        known, of_file, lines = self._lanes
        if known is not widest[2] or of_file != file:
            lines = bars_of(widest[2], file)
            self._lanes = widest[2], file, lines
        return {"end": end, "lines": lines}

    def _work(self) -> None:
        while not self._is_closed:
            with self._changed:
                self._changed.wait_for(lambda: self._request is not None or self._is_closed)
                request = self._request
                is_replaced = partial(self._is_replaced, request)
                if request is None or self._changed.wait_for(is_replaced, _REST_S):
                    continue
                self._request, self._current = None, request[0]
            meanwhile = partial(self._check_rest, request[0])
            try:
                self._report_of(*request, meanwhile)
                self._extend_lanes(*request, meanwhile)
            except _GoneOnError:
                continue
            except (Failure, RuntimeError):
                time.sleep(_REST_S)  # a click shows the reason

    def _check_rest(self, moment: Moment) -> None:
        """Raise ``_GoneOnError`` if the session has continued meanwhile, or a request has come."""
        if self._current != moment or self._questions or self._is_closed:
            raise _GoneOnError

    def _extend_lanes(
        self, moment: Moment, session: Session, meanwhile: Callable[[], None]
    ) -> None:
        """Make the lanes exact up to the end of the branch, as far as its curves go."""
        serial, branch, _ = moment
        end = session.branches[branch]
        if _exact_end(self._widest, moment) < end <= _MAX_TICKS and self._request is None:
            self._explained((serial, branch, end), session, meanwhile)
            self._notify()

    def _is_replaced(self, request: tuple[Moment, Session] | None) -> bool:
        return self._request is not request or self._is_closed

    def close(self) -> None:
        """End the thread."""
        with self._changed:
            self._is_closed = True
            self._changed.notify_all()


def _exact_end(widest: tuple[Moment, Session, WhyReport] | None, moment: Moment) -> int:
    """Return up to which tick of a place's branch a report knows it: at most to where they part."""
    if widest is None or widest[0][0] != moment[0]:
        return 0
    (_, branch, end), session, _ = widest
    return min(end, session.fork(branch, moment[1]))


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


def why_plc_text(report: WhyReport, file: str, line: int, language: Language) -> str:
    """Return the writes of a PLC statement in a line, and why; or that there were none."""
    chosen = report.select_plc_line(file, line)
    if not chosen.plc:
        return Texts(language)["plc_wrote_nothing"]
    tick = report.last_tick
    parts = [chosen.render_at(tick, language), f"{'─' * 40}\n", chosen.render(language)]
    return "\n".join(part.strip("\n") for part in parts if part)


def why_text(report: WhyReport, line: int, language: Language) -> str:
    """Return why the condition in a line had its state in the last tick, and its history.

    It begins with the answer. Raises ``Failure`` for a line without a condition.
    """
    chosen, tick = report.select(line=line), report.last_tick
    rule = "─" * 40
    parts = [chosen.render_answer(tick, language), chosen.render_at(tick, language)]
    parts = [f"{part}{rule}\n" for part in parts if part]
    return "".join(parts) + f"{Texts(language)['history']}\n{chosen.render(language)}"

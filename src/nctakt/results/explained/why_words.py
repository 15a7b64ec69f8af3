# SPDX-License-Identifier: MIT
"""The words of ``nctakt why``: reasons, ticks, values as text in English and German.

In: parts of histories. Out: short texts without a full stop, which ``why_text.py`` combines.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.diagnostics import Language, Span, Text
from nctakt.lists.format.times import Time
from nctakt.results.compared_numbers import comparison_text, distance_text
from nctakt.results.histories import (
    WITHOUT_VALUES,
    BranchHistory,
    Change,
    ConditionHistory,
    CycleHistory,
    Nearest,
    Reason,
    Series,
    Times,
)

#: Number of items shown at each end of a long list.
ENDS_SHOWN = 4

_TICK = Text("tick {tick} ({time})", "Takt {tick} ({time})")
_TICKS = Text("ticks {ticks}", "Takte {ticks}")
_TO = Text("{first} to {last}", "{first} bis {last}")
_MORE = Text("… {count} more …", "… {count} weitere …")
_TRUE_FROM_HALF = Text("{value} (true from 0.5 on)", "{value} (wahr ab 0.5)")
_LINE = Text("line {line}", "Zeile {line}")
_ERROR = Text("error {number}", "Fehler {number}")
_NEAREST = Text(
    "nearest at {tick}: {values}, {distance} away",
    "am nächsten in {tick}: {values}, Abstand {distance}",
)
_NEVER_TRUE = Text("never true", "nie wahr")
_AT_COMMAND = Text("{text}, {line}", "{text}, {line}")

_ENDED_BY = {
    "scope": Text("its block ended", "sein Satz war zu Ende"),
    "program": Text("the program ended", "das Programm endete"),
    "delete": Text("deleted", "gelöscht"),
    "reset": Text("reset", "Reset"),
    "error": Text("an error in the cycle", "Fehler im Zyklus"),
}

_CYCLE_REASONS = {
    "undefined": Text("not defined up to here", "bis hierher nicht definiert"),
    "undefined yet": Text("not defined until {tick}", "nicht definiert bis {tick}"),
    "unstarted": Text(
        "defined at {tick} with DEF, not started", "in {tick} mit DEF definiert, nicht gestartet"
    ),
    "waiting": Text(
        "started at {tick}, waiting for its block", "in {tick} gestartet, wartet auf seinen Satz"
    ),
    "held": Text("on hold since {tick}", "angehalten seit {tick}"),
    "ended": Text("ended at {tick}", "beendet in {tick}"),
    "stopped": Text(
        "stopped in this tick by the fault of another cycle",
        "in diesem Takt durch den Fehler eines anderen Zyklus gestoppt",
    ),
    "reset": Text("the channel was being reset", "der Kanal wurde zurückgesetzt"),
    "forgotten": Text("too long ago to be known", "zu lange her, nicht mehr bekannt"),
}

_BRANCH_REASONS = {
    "cycle": Text("the cycle did not run: {reason}", "der Zyklus lief nicht: {reason}"),
    "outer": Text("not reached: {line} did not run", "nicht erreicht: {line} lief nicht"),
    "earlier": Text("not reached: {line} ran", "nicht erreicht: {line} lief"),
    "no rise": Text(
        "EDGE: true already since {tick}, no change from false to true",
        "EDGE: schon seit {tick} wahr, kein Wechsel von falsch nach wahr",
    ),
    "no rise before": Text(
        "EDGE: true already before the run, no change from false to true",
        "EDGE: schon vor dem Lauf wahr, kein Wechsel von falsch nach wahr",
    ),
    "done": Text("ONCE: done since {tick}", "ONCE: erledigt seit {tick}"),
    "done before": Text("ONCE: done before the run", "ONCE: vor dem Lauf erledigt"),
    "fault": Text("an error ended the cycle at {tick}", "ein Fehler beendete den Zyklus in {tick}"),
    "false since": Text("false since {seen}", "falsch seit {seen}"),
    "false": Text("false since before the run", "schon vor dem Lauf falsch"),
    "forgotten": Text("too long ago to be known", "zu lange her, nicht mehr bekannt"),
}


class Words:
    """Texts in one language; ``cycle_time_us`` is the length of a tick."""

    def __init__(self, language: Language, cycle_time_us: int) -> None:
        self.language = language
        self._cycle_time_us = cycle_time_us

    def get(self, text: Text, /, **values: object) -> str:
        """Return a text in the language with its values."""
        return text.get(self.language).format(**values)

    # --- ticks and times ------------------------------------------------------------------------

    def time(self, tick: int) -> str:
        """Return the time at which a tick begins: ``0.463 s``."""
        return str(Time(tick * self._cycle_time_us))

    def tick(self, tick: int) -> str:
        """Return a tick with its time."""
        return self.get(_TICK, tick=tick, time=self.time(tick))

    def times(self, times: Times) -> str:
        """Return the ticks of all series; if there are many, the first and last ones."""
        if times.ticks == 1 and times.series:
            return self.tick(times.series[0].first_tick)
        shown = [self._series(series) for series in times.series]
        return self.get(_TICKS, ticks=", ".join(self.ends(shown, times.left_out)))

    def ends(self, texts: list[str], left_out: int = 0) -> list[str]:
        """Return a long list without its middle, or without its begin if ``left_out`` are lost."""
        if left_out:
            hidden = left_out + max(0, len(texts) - 2 * ENDS_SHOWN)
            return [self.get(_MORE, count=hidden), *texts[-2 * ENDS_SHOWN :]]
        if len(texts) <= 2 * ENDS_SHOWN + 1:
            return texts
        hidden = len(texts) - 2 * ENDS_SHOWN
        more = self.get(_MORE, count=hidden)
        return [*texts[:ENDS_SHOWN], more, *texts[-ENDS_SHOWN:]]

    def _series(self, series: Series) -> str:
        if series.first_tick == series.last_tick:
            return str(series.first_tick)
        return self.get(_TO, first=series.first_tick, last=series.last_tick)

    # --- places and values ----------------------------------------------------------------------

    def line(self, span: Span, file: str = "") -> str:
        """Return the line number: ``line 4``; ``lib/x.nc:4`` if it is not in ``file``."""
        if file and span.file != file:
            return f"{span.file}:{span.line}"
        return self.get(_LINE, line=span.line)

    def values(self, condition: ConditionHistory, left: float, right: float) -> str:
        """Return the compared values: ``200.25 > 200``; empty where none are recorded."""
        if condition.operator in WITHOUT_VALUES:
            return ""
        shown = comparison_text(condition.operator, left, right)
        return shown if condition.operator else self.get(_TRUE_FROM_HALF, value=shown)

    def seen(self, condition: ConditionHistory, change: Change) -> str:
        """Return the tick of a change of truth and the compared values."""
        values = self.values(condition, change.left, change.right)
        return self.tick(change.tick) + (f": {values}" if values else "")

    def nearest(self, condition: ConditionHistory, nearest: Nearest) -> str:
        """Return how near to true a condition came that was never true."""
        values = self.values(condition, nearest.left, nearest.right)
        never = self.get(_NEVER_TRUE)
        if not values:
            return never
        distance = distance_text(nearest.distance)
        tick = self.tick(nearest.tick)
        near = self.get(_NEAREST, tick=tick, values=values, distance=distance)
        return f"{never}, {near}"

    # --- reasons --------------------------------------------------------------------------------

    def ended(self, reason: str, span: Span | None, number: int, file: str) -> str:
        """Return how a cycle of ``file`` ended, with the responsible line."""
        text = self.get(_ENDED_BY[reason])
        if number:
            text = f"{text}: {self.get(_ERROR, number=number)}"
        if span is not None and reason in ("delete", "error"):
            text = self.get(_AT_COMMAND, text=text, line=self.line(span, file))
        return text

    def cycle_reason(self, reason: Reason, file: str) -> str:
        """Return why a cycle of ``file`` did not run."""
        kind = "undefined yet" if reason.kind == "undefined" and reason.tick else reason.kind
        tick = "" if reason.tick is None else self.tick(reason.tick)
        text = self.get(_CYCLE_REASONS[kind], tick=tick)
        if reason.kind == "ended":
            return f"{text}: {self.ended(reason.ended_by, reason.span, reason.number, file)}"
        if reason.kind in ("held", "stopped") and reason.span is not None:
            text = self.get(_AT_COMMAND, text=text, line=self.line(reason.span, file))
        return text

    def branch_reason(
        self, cycle: CycleHistory, branch: BranchHistory, reasons: Sequence[Reason]
    ) -> str:
        """Return why a branch did not run; ``reasons`` continue with the responsible branches."""
        texts: list[str] = []
        for reason in reasons:
            texts.append(self._one(cycle, branch, reason))
            if reason.branch is not None:
                branch = cycle.branches[reason.branch]
        return ": ".join(texts)

    def _one(self, cycle: CycleHistory, branch: BranchHistory, reason: Reason) -> str:
        tick = "" if reason.tick is None else self.tick(reason.tick)
        match reason.kind:
            case "cycle":
                assert reason.cycle is not None
                text = self.cycle_reason(reason.cycle, cycle.span.file)
                return self.get(_BRANCH_REASONS["cycle"], reason=text)
            case "outer" | "earlier":
                assert reason.branch is not None
                line = self.line(cycle.branches[reason.branch].span)
                return self.get(_BRANCH_REASONS[reason.kind], line=line)
            case "false":
                return self._false(branch.condition, reason)
            case "no rise" | "done":
                kind = reason.kind if tick else f"{reason.kind} before"
                return self.get(_BRANCH_REASONS[kind], tick=tick)
            case "fault":
                return self._fault(reason, tick, cycle.span.file)
        return self.get(_BRANCH_REASONS[reason.kind])

    def _false(self, condition: ConditionHistory, reason: Reason) -> str:
        if reason.change is not None:
            seen = self.seen(condition, reason.change)
            return self.get(_BRANCH_REASONS["false since"], seen=seen)
        if reason.nearest is not None:
            return self.nearest(condition, reason.nearest)
        return self.get(_BRANCH_REASONS["false"])

    def _fault(self, reason: Reason, tick: str, file: str) -> str:
        text = self.get(_BRANCH_REASONS["fault"], tick=tick)
        if reason.number:
            text = f"{text}: {self.get(_ERROR, number=reason.number)}"
        if reason.span is not None:
            text = self.get(_AT_COMMAND, text=text, line=self.line(reason.span, file))
        return text

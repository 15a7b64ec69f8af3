# SPDX-License-Identifier: MIT
"""Why a reaction fired or did not: the report of a run (``Run.why``).

In: the histories of the realtime cycles. Out: ``WhyReport``; ``select`` narrows it to a cycle or a
line, ``render`` describes the whole run, ``render_at`` one tick. The data for the text are in
``cycles`` (``histories.py``) and ``reasons.py``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Span, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.base.notebook import html_columns, strip
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.commands.explaining import (
    CYCLE_NOT_IN_RUN,
    LINE_NOT_IN_CYCLE,
    PLC_VARIABLE_UNCHANGED,
    PROGRAMS_WITHOUT_CYCLES,
    RUN_WITHOUT_CYCLES,
    TICK_NOT_IN_RUN,
)
from nctakt.results.explained.plc_histories import PlcHistories, PlcHistory
from nctakt.results.explained.plc_text import render_plc, render_plc_at
from nctakt.results.explained.why_text import render_answer, render_report, render_state
from nctakt.results.explained.why_words import Words
from nctakt.results.histories import CycleHistory, Series, Times

#: Maximum number of names in the message about an unknown cycle.
_MAX_NAMES = 10


@dataclass(frozen=True, slots=True)
class WhyReport:
    """The histories of a run's realtime cycles, from tick ``first_tick`` on for ``ticks`` ticks.

    The ``left_out`` oldest cycles were dropped to bound the memory.
    """

    cycle_time_us: int
    first_tick: int
    ticks: int
    cycles: tuple[CycleHistory, ...]
    left_out: int = 0
    #: Changes made by a PLC in Structured Text.
    plc: Sequence[PlcHistory] = ()

    def with_plc(self, changes: Sequence[PlcHistory]) -> WhyReport:
        """Return the report with the changes of a PLC."""
        before = self.plc
        return replace(self, plc=PlcHistories(lambda: (*before, *changes)))

    def select_plc(self, path: str) -> WhyReport:
        """Return only the history of a variable of the PLC; raises ``Failure`` (902660)."""
        sought = path.upper()
        found = tuple(one for one in self.plc if one.path.upper() == sought)
        if not found:
            near = nearest(path, [one.path for one in self.plc])
            meant = (
                Text(f"Did you mean {near}? ", f"War {near} gemeint? ") if near else Text("", "")
            )
            raise Failure(diagnostic(PLC_VARIABLE_UNCHANGED, path=path, meant=meant))
        return replace(self, cycles=(), left_out=0, plc=found)

    def select_plc_line(self, file: str, line: int) -> WhyReport:
        """Return only the writes of a statement of the PLC in a line; there may be none."""

        def is_it(span: Span | None) -> bool:
            return span is not None and (span.file, span.line) == (file, line)

        found = tuple(
            one
            for one in self.plc
            if is_it(one.writer) or any(is_it(change.span) for change in one.changes)
        )
        return replace(self, cycles=(), left_out=0, plc=found)

    def select(self, cycle: str | None = None, line: int | None = None) -> WhyReport:
        """Return only the cycles with this ID (``17``, ``#1``), only the branches with this line.

        The line may be that of a branch or of a statement in its body. Raises ``Failure`` for an
        unknown cycle (900574) or line (900575).
        """
        if cycle is None and line is None:
            return self
        cycles = self.cycles
        if cycle is not None:
            cycles = tuple(history for history in cycles if history.name == cycle)
            if not cycles:
                raise Failure(self._unknown_cycle(cycle))
        if line is not None:
            chosen = [_with_line(history, line) for history in cycles]
            cycles = tuple(history for history in chosen if history is not None)
            if not cycles:
                raise Failure(self._unknown_line(line, cycle))
        return replace(self, cycles=cycles, plc=self._named_in(cycles))

    def _named_in(self, cycles: Sequence[CycleHistory]) -> tuple[PlcHistory, ...]:
        """Return the PLC's changes of values that conditions compare."""
        texts = [cycle.branches[index].text.upper() for cycle in cycles for index in cycle.shown]
        return tuple(
            one
            for one in self.plc
            if any(re.search(rf"{re.escape(one.path.upper())}(?![\w.])", text) for text in texts)
        )

    def _repr_html_(self) -> str:
        """Return a table for notebooks: each branch, how often it was true and ran, and when."""
        rows, strips = [], []
        for cycle in self.cycles:
            for branch in (cycle.branches[index] for index in cycle.shown):
                evaluated, ran = branch.evaluated.ticks, branch.bodies
                asked = f"{branch.condition.true_ticks} / {evaluated}" if evaluated else "–"
                counts = (asked, str(branch.became_true), str(ran.ticks))
                line = str(branch.span.line)
                rows.append((cycle.name or "–", line, branch.text, *counts, *self._ends(ran)))
                strips.append(strip([self._share(one) for one in ran.series]))
        heads = ("cycle", "line", "branch", "true / evaluated", "began", "ran", "first", "last", "")
        left = f", {self.left_out} older cycles left out" if self.left_out else ""
        return html_columns(f"{self.ticks} ticks{left}", heads, rows, strips)

    def _ends(self, times: Times) -> tuple[str, str]:
        """Return when something happened first and last, as far as that is known."""
        if not times.series:
            return "–", "–"
        first, last = times.series[0].first_tick, times.series[-1].last_tick
        begin, end = (str(Time(tick * self.cycle_time_us)) for tick in (first, last))
        return "–" if times.left_out else begin, end

    def _share(self, series: Series) -> tuple[float, float]:
        """Return begin and end of a series as shares of the run."""
        begin, end = series.first_tick - self.first_tick, series.last_tick + 1 - self.first_tick
        return begin / max(1, self.ticks), end / max(1, self.ticks)

    def render(self, language: Language = "en") -> str:
        """Return the histories as text with a final line end."""
        words = Words(language, self.cycle_time_us)
        shown = self._shown_plc()
        plc = render_plc(shown, words)
        if shown and not self.cycles:
            return plc.lstrip("\n")
        return render_report(self.cycles, self.left_out, self.last_tick, words) + plc

    def _shown_plc(self) -> Sequence[PlcHistory]:
        """Return the requested history: of a variable, else of the PLC's commands."""
        if not self.cycles and len(self.plc) == 1:
            return self.plc
        return tuple(one for one in self.plc if one.is_interface)

    @property
    def last_tick(self) -> int:
        """The last tick of the run."""
        return self.first_tick + self.ticks - 1

    def render_answer(self, tick: int, language: Language = "en") -> str:
        """Return in short whether the selected branches ran in a tick, why, and how often."""
        return render_answer(self.cycles, tick, Words(language, self.cycle_time_us))

    def render_at(self, tick: int, language: Language = "en") -> str:
        """Return the states in a tick of the run as text; raises ``Failure`` (900576) outside."""
        first, last = self.first_tick, self.last_tick
        if not first <= tick <= last:
            raise Failure(diagnostic(TICK_NOT_IN_RUN, tick=tick, first=first, last=last))
        words = Words(language, self.cycle_time_us)
        shown = self._shown_plc()
        plc = render_plc_at(shown, tick, words)
        if shown and not self.cycles:
            return f"{words.tick(tick)}\n{plc}"
        return render_state(self.cycles, self.left_out, tick, words) + plc

    def _unknown_cycle(self, name: str) -> Diagnostic:
        names = list(dict.fromkeys(cycle.name for cycle in self.cycles if cycle.name))
        if not names:
            return diagnostic(RUN_WITHOUT_CYCLES, cycle=name)
        names_text = ", ".join(names[:_MAX_NAMES])
        if len(names) > _MAX_NAMES:
            names_text = f"{names_text}, …"
        return diagnostic(CYCLE_NOT_IN_RUN, cycle=name, known=names_text)

    def _unknown_line(self, line: int, cycle: str | None) -> Diagnostic:
        lines = sorted(
            {
                number
                for history in self.cycles
                if cycle in (None, history.name)
                for number in _lines(history)
            }
        )
        if not lines:
            return diagnostic(PROGRAMS_WITHOUT_CYCLES, line=line)
        near = min(lines, key=lambda number: abs(number - line))
        return diagnostic(LINE_NOT_IN_CYCLE, line=line, nearest=near)


def _lines(cycle: CycleHistory) -> list[int]:
    return [*cycle.lines, *(line for branch in cycle.branches for line in branch.lines)]


def _with_line(cycle: CycleHistory, line: int) -> CycleHistory | None:
    """Return the cycle with the branches that ``line`` belongs to; all for its first line."""
    if line == cycle.span.line:
        return cycle
    shown = tuple(i for i, branch in enumerate(cycle.branches) if line in branch.lines)
    return replace(cycle, shown=shown) if shown or line in cycle.lines else None

# SPDX-License-Identifier: MIT
"""Why a reaction fired or did not: the report of a run (``Run.why``).

In: the histories of the realtime cycles. Out: ``WhyReport``; ``select`` narrows it to a cycle or
a line, ``render`` tells the whole run, ``render_at`` one tick. Those who want data read ``cycles``
(``histories.py``) and ask ``reasons.py``.
"""

from __future__ import annotations

from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.explaining import (
    CYCLE_NOT_IN_RUN,
    LINE_NOT_IN_CYCLE,
    PROGRAMS_WITHOUT_CYCLES,
    RUN_WITHOUT_CYCLES,
    TICK_NOT_IN_RUN,
)
from nctakt.results.histories import CycleHistory
from nctakt.results.why_text import render_report, render_state
from nctakt.results.why_words import Words

#: Names that are told when an unknown cycle was asked for.
_NAMES_TOLD = 10


@dataclass(frozen=True, slots=True)
class WhyReport:
    """What the realtime cycles of a run did, from tick ``first_tick`` on for ``ticks`` ticks.

    ``left_out`` older cycles were dropped, so that memory is bounded.
    """

    cycle_time_us: int
    first_tick: int
    ticks: int
    cycles: tuple[CycleHistory, ...]
    left_out: int = 0

    def select(self, cycle: str | None = None, line: int | None = None) -> WhyReport:
        """Only the cycles with this ID (``17``, ``#1``), only the branches with this line.

        The line may be that of a branch or of a statement in its body. Raises ``Failure`` for what
        there is not (900574, 900575).
        """
        cycles = self.cycles
        if cycle is not None:
            cycles = tuple(one for one in cycles if one.name == cycle)
            if not cycles:
                raise Failure(self._unknown_cycle(cycle))
        if line is not None:
            chosen = [_with_line(one, line) for one in cycles]
            cycles = tuple(one for one in chosen if one is not None)
            if not cycles:
                raise Failure(self._unknown_line(line, cycle))
        return replace(self, cycles=cycles)

    def render(self, language: Language = "en") -> str:
        """The histories as text, which ends with a line end."""
        words = Words(language, self.cycle_time_us)
        last_tick = self.first_tick + self.ticks - 1
        return render_report(self.cycles, self.left_out, last_tick, words)

    def render_at(self, tick: int, language: Language = "en") -> str:
        """The states in one tick of the run as text; raises ``Failure`` (900576) for another."""
        last_tick = self.first_tick + self.ticks - 1
        if not self.first_tick <= tick <= last_tick:
            raise Failure(
                diagnostic(TICK_NOT_IN_RUN, tick=tick, first=self.first_tick, last=last_tick)
            )
        words = Words(language, self.cycle_time_us)
        return render_state(self.cycles, self.left_out, tick, words)

    def _unknown_cycle(self, name: str) -> Diagnostic:
        names = list(dict.fromkeys(one.name for one in self.cycles if one.name))
        if not names:
            return diagnostic(RUN_WITHOUT_CYCLES, cycle=name)
        told = ", ".join(names[:_NAMES_TOLD])
        if len(names) > _NAMES_TOLD:
            told = f"{told}, …"
        return diagnostic(CYCLE_NOT_IN_RUN, cycle=name, known=told)

    def _unknown_line(self, line: int, cycle: str | None) -> Diagnostic:
        known = sorted(
            {known for one in self.cycles if cycle in (None, one.name) for known in _lines(one)}
        )
        if not known:
            return diagnostic(PROGRAMS_WITHOUT_CYCLES, line=line)
        near = min(known, key=lambda one: abs(one - line))
        return diagnostic(LINE_NOT_IN_CYCLE, line=line, nearest=near)


def _lines(cycle: CycleHistory) -> list[int]:
    return [*cycle.lines, *(line for branch in cycle.branches for line in branch.lines)]


def _with_line(cycle: CycleHistory, line: int) -> CycleHistory | None:
    """The cycle with only the branches that ``line`` belongs to; that of its definition is all."""
    if line == cycle.span.line:
        return cycle
    shown = tuple(i for i, branch in enumerate(cycle.branches) if line in branch.lines)
    return replace(cycle, shown=shown) if shown or line in cycle.lines else None

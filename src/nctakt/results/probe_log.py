# SPDX-License-Identifier: MIT
"""The log of realtime cycles and their conditions in a run: record bytes -> histories.

In: probe and event rows (``kernel/rows.py``) as they come, the definitions of the cycles, at the
end the counters of their nodes. Out: ``CycleHistory`` for each cycle. Memory is bounded by the
constants here and in ``branch_log.py``: the newest entries are kept, and the histories count the
dropped ones.
"""

from __future__ import annotations

import struct
from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Protocol

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.base.source_ids import begins_at
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.kernel import codes, rows
from nctakt.messages.programs.realtime import BLOCK_CYCLE_NEVER_RAN
from nctakt.nc.check.cycles.branches import (
    branch_outlines,
    lines_without_branch,
)
from nctakt.nc.outline import ProgramText
from nctakt.nc.parse.printer import format_expression
from nctakt.nc.tree import Expression, RealtimeCycle
from nctakt.results.branch_log import BranchLog, ConditionLog, SeriesLog, first_tick_of_series
from nctakt.results.coverage import Coverage, CycleCounts, add_up, cycle_counts
from nctakt.results.histories import (
    BranchHistory,
    ConditionHistory,
    CycleHistory,
    EndedBy,
    LifeEvent,
    LifeKind,
)

#: Maximum number of steps kept of a cycle's life.
LIFE_KEPT = 1000

#: Maximum number of cycles kept; ended ones are dropped for new ones, the oldest first.
CYCLES_KEPT = 256

_EVENT = struct.Struct(f"={rows.EVENT_WIDTH}d")
_PROBE = struct.Struct(f"={rows.PROBE_WIDTH}d")

_LIFE: dict[int, LifeKind] = {
    rows.EVENT_CREATED: "created",
    rows.EVENT_STARTED: "started",
    rows.EVENT_HELD: "held",
    rows.EVENT_CONTINUED: "continued",
}
_ENDED_BY: dict[int, EndedBy] = {
    rows.ENDED_BY_SCOPE: "scope",
    rows.ENDED_BY_DELETE: "delete",
    rows.ENDED_BY_RESET: "reset",
    rows.ENDED_BY_ERROR: "error",
}


class CycleNames(Protocol):
    """The names for the numbers in rows, while a cycle lives."""

    def cycle(self, serial: int) -> str:
        """Return the programmed ID of the cycle, or ``#1`` without one."""

    def definition(self, serial: int) -> CycleDefinition:
        """Return the definition of a cycle that has not been dropped."""

    def span(self, source: int) -> Span | None:
        """Return the position with this source id, ``None`` without one."""

    def line_at(self, span: Span) -> str:
        """Return the source line of a span."""


@dataclass(slots=True)
class _CycleLog:
    name: str
    definition: CycleDefinition
    runs: SeriesLog
    branches: dict[Span, BranchLog]
    life: deque[LifeEvent] = field(default_factory=lambda: deque(maxlen=LIFE_KEPT))
    life_left_out: int = 0
    missed_its_block: bool = False

    def fired(self, span: Span | None) -> None:
        """Count that the branch at this place became true."""
        for own, branch in self.branches.items():
            if begins_at(own, span):
                branch.became_true += 1

    def live(self, event: LifeEvent) -> None:
        self.life_left_out += len(self.life) == LIFE_KEPT
        self.life.append(event)


class ProbeLog:
    """Gathers the histories of a run.

    ``living`` are the cycles that live at its first tick, with the state of their slots.
    """

    def __init__(
        self,
        names: CycleNames,
        first_tick: int,
        living: Iterable[tuple[CycleDefinition, int]],
    ) -> None:
        self._names = names
        self._cycles: dict[int, _CycleLog] = {}
        self._evaluated: dict[int, SeriesLog] = {}
        self._bodies: dict[int, SeriesLog] = {}
        self._conditions: dict[int, ConditionLog] = {}
        self._stops: deque[tuple[int, LifeEvent]] = deque(maxlen=LIFE_KEPT)
        self._seen: dict[Span, None] = {}
        self._dropped: tuple[CycleCounts, ...] = ()
        self.left_out = 0
        for definition, state in living:
            cycle = self._add(definition, first_tick)
            cycle.live(LifeEvent(first_tick, "created" if state == codes.DEFINED else "living"))
            if state == codes.HELD:
                cycle.live(LifeEvent(first_tick, "held"))

    # --- during the run -------------------------------------------------------------------------

    def add(self, probes: bytes, events: bytes) -> None:
        """Add the rows of some ticks."""
        for row in _EVENT.iter_unpack(events):
            self._event(*row)
        for row in _PROBE.iter_unpack(probes):
            self._probe(*row)
        while len(self._cycles) > CYCLES_KEPT and self._drop():
            pass

    def _probe(
        self,
        tick: float,
        kind: float,
        number: float,
        left: float,
        right: float,
        next_tick: float,
    ) -> None:
        """Add a change of truth, or the begin of a series of evaluations or body runs."""
        probe = int(number)
        condition = self._conditions.get(probe)
        if kind in (rows.PROBE_FALSE, rows.PROBE_TRUE):
            if condition is not None:
                condition.change(int(tick), kind == rows.PROBE_TRUE, left, right)
            return
        evaluated = kind == rows.PROBE_EVALUATED
        series = (self._evaluated if evaluated else self._bodies).get(probe)
        if series is not None:
            series.begin(int(tick), int(next_tick))
        if evaluated and condition is not None:
            condition.truths.begin(int(tick), int(next_tick))

    def _event(
        self,
        tick: float,
        kind_number: float,
        _channel: float,
        source: float,
        subject: float,
        a: float,
        _b: float,
        _c: float,
    ) -> None:
        kind, serial = int(kind_number), int(subject)
        if kind == rows.EVENT_CREATED:
            self._add(self._names.definition(serial), None)
        cycle = self._cycles.get(serial)
        if cycle is None:
            return
        span = self._names.span(int(source))
        if kind == rows.EVENT_FIRED:
            cycle.fired(span)
        elif kind in _LIFE:
            cycle.live(LifeEvent(int(tick), _LIFE[kind], span))
        elif kind == rows.EVENT_ENDED:
            self._ended(cycle, int(tick), int(a), span)
        elif kind == rows.EVENT_ERROR and serial:
            self._stops.append((serial, LifeEvent(int(tick), "ended", span, "error", int(a))))
        elif kind == rows.EVENT_NOTICE and a == BLOCK_CYCLE_NEVER_RAN.id:
            cycle.missed_its_block = True

    def _ended(self, cycle: _CycleLog, tick: int, reason: int, span: Span | None) -> None:
        ended_by = _ENDED_BY[reason]
        number = 0
        if ended_by == "scope" and (cycle.definition.scope == "PROG" or cycle.missed_its_block):
            ended_by = "program"
        if ended_by == "error" and self._stops:
            span, number = self._stops[-1][1].span, self._stops[-1][1].number
        cycle.live(LifeEvent(tick, "ended", span, ended_by, number))

    def _add(self, definition: CycleDefinition, living_from: int | None) -> _CycleLog:
        cycle = definition.cycle
        runs = SeriesLog(first_tick_of_series(cycle.next_tick, living_from))
        branches = {built.span: BranchLog(built, living_from) for built in definition.reactions}
        name = self._names.cycle(definition.serial)
        log = _CycleLog(name, definition, runs, branches)
        self._cycles[definition.serial] = log
        self._evaluated[cycle.probe] = runs
        for branch in branches.values():
            self._evaluated[branch.probe] = branch.evaluated
            self._bodies[branch.probe] = branch.bodies
            self._conditions |= branch.conditions
        self._seen[definition.span] = None
        return log

    def _drop(self) -> bool:
        """Drop the oldest ended cycle but keep its counts; return whether there was one."""
        ended = (s for s, log in self._cycles.items() if log.life and log.life[-1].kind == "ended")
        serial = next(ended, None)
        if serial is None:
            return False
        dropped = self._counts(self._history(serial, self._cycles[serial]))
        self._dropped = add_up([*self._dropped, dropped])
        cycle = self._cycles.pop(serial)
        del self._evaluated[cycle.definition.cycle.probe]
        for branch in cycle.branches.values():
            del self._evaluated[branch.probe]
            del self._bodies[branch.probe]
            for probe in branch.conditions:
                del self._conditions[probe]
        self.left_out += 1
        return True

    # --- at its end -----------------------------------------------------------------------------

    def histories(self, programs: Sequence[ProgramText]) -> tuple[CycleHistory, ...]:
        """Return all cycles in the order of their creation, then the unreached definitions."""
        histories = [self._history(serial, cycle) for serial, cycle in self._cycles.items()]
        for program in programs:
            for statement in program.cycles:
                if statement.span not in self._seen:
                    self._seen[statement.span] = None
                    histories.append(self._unreached(statement))
        return tuple(histories)

    def _history(self, serial: int, cycle: _CycleLog) -> CycleHistory:
        definition = cycle.definition
        fault = next((stop for who, stop in self._stops if who == serial), None)
        branches = tuple(
            cycle.branches[outline.span].history(
                outline, self._text(outline.span), definition.frozen, fault
            )
            for outline in branch_outlines(definition.statement)
        )
        return CycleHistory(
            cycle.name,
            definition.scope,
            definition.span,
            definition.statement.end_span.line,
            tuple(lines_without_branch(definition.statement)),
            self._text(definition.span),
            branches,
            tuple(range(len(branches))),
            tuple(cycle.life),
            cycle.life_left_out,
            cycle.runs.finish(definition.cycle.next_tick),
            tuple(stop for who, stop in self._stops if who != serial),
        )

    def _unreached(self, statement: RealtimeCycle) -> CycleHistory:
        branches = tuple(
            BranchHistory(
                outline.span,
                outline.lines,
                self._text(outline.span),
                outline.word,
                outline.frequency,
                outline.outer,
                outline.earlier,
                _unseen(outline.condition),
                commands=outline.commands,
            )
            for outline in branch_outlines(statement)
        )
        return CycleHistory(
            "",
            "",
            statement.span,
            statement.end_span.line,
            tuple(lines_without_branch(statement)),
            self._text(statement.span),
            branches,
            tuple(range(len(branches))),
        )

    def coverage(self, histories: Sequence[CycleHistory]) -> Coverage:
        """Return the coverage of the histories and of the dropped cycles together."""
        return Coverage(
            add_up([*self._dropped, *(self._counts(history) for history in histories)]), 1
        )

    def _counts(self, history: CycleHistory) -> CycleCounts:
        span = history.span
        lines = range(span.line, history.end_line + 1)
        source = tuple(self._names.line_at(replace(span, line=line)).rstrip() for line in lines)
        return cycle_counts(history, source)

    def _text(self, span: Span) -> str:
        return self._names.line_at(span).strip()


def _unseen(condition: Expression | None) -> ConditionHistory:
    """Return the history of a condition that was never evaluated: its text."""
    return ConditionHistory("" if condition is None else format_expression(condition))

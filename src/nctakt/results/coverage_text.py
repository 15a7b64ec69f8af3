# SPDX-License-Identifier: MIT
"""Branch coverage as text: a table of the branches, or the source lines with their counts.

In: ``Coverage``, language. Out: lines; a line that never ran is marked with ``!``, a plain
condition that was never false with ``~``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nctakt.base.diagnostics import Language, Text
from nctakt.results.compared_numbers import comparison_text, distance_text
from nctakt.results.coverage import (
    PLC_SCOPES,
    WITHOUT_CONDITION,
    BranchCounts,
    BranchState,
    ConditionCounts,
    Coverage,
    CycleCounts,
    NearestMiss,
)
from nctakt.results.histories import WITHOUT_VALUES
from nctakt.results.trace.events import number_text

_CYCLE = Text("realtime cycle {name}", "Echtzeit-Zyklus {name}")
_NO_NAME = Text("realtime cycle", "Echtzeit-Zyklus")
_RAN = Text("{count} of {all} branches ran", "{count} von {all} Zweigen ausgeführt")
_ONCE = Text("run once", "einmal gelaufen")
_TIMES = Text("run {runs} times", "{runs}-mal gelaufen")
_DEFINED = Text("defined {instances} times", "{instances}-mal definiert")
_NEVER = Text("never defined", "nie definiert")
_UNCALLED = Text("never called", "nie aufgerufen")
_IDLE = Text("defined, never run", "definiert, nie gelaufen")
_COLUMNS = (
    Text("line", "Zeile"),
    Text("evaluated", "ausgewertet"),
    Text("true", "wahr"),
    Text("false", "falsch"),
    Text("ran", "lief"),
)
_TOTAL = Text(
    "total: {count} of {all} branches ran, {percent} %; runs: {runs}",
    "insgesamt: {count} von {all} Zweigen ausgeführt, {percent} %; Läufe: {runs}",
)
_NO_CYCLES = Text("no realtime cycles", "keine Echtzeit-Zyklen")
_PART = Text("part {text}", "Teil {text}")
_NEAREST = Text("nearest {values}, {distance} away", "am nächsten {values}, Abstand {distance}")
_STATES: dict[BranchState, Text] = {
    "never true": Text("never true", "nie wahr"),
    "never false": Text("never false", "nie falsch"),
    "no rise": Text("true all the time, no change to true", "immer wahr, kein Wechsel nach wahr"),
    "fault": Text("an error ended it", "durch einen Fehler abgebrochen"),
    "not reached": Text("never reached", "nie erreicht"),
    "cycle": Text("the cycle never ran", "der Zyklus ist nie gelaufen"),
}
_LEGEND = Text(
    "! never ran   ~ never false   counts are in ticks",
    "! nie ausgeführt   ~ nie falsch   Zahlen in Takten",
)
_OF_PLC = Text(", of the PLC in evaluations", ", der SPS in Auswertungen")

_MARKS: dict[BranchState, str] = {"ran": " ", "never false": "~"}
#: Widths of the columns line, evaluated, true, false, body.
_WIDTHS = (6, 12, 9, 9, 9)


class CoverageText:
    """Writes a coverage in one language."""

    def __init__(self, coverage: Coverage, language: Language) -> None:
        self._coverage = coverage
        self._language = language

    def table(self) -> str:
        """Return each branch with its counts, and the reason if it did not run."""
        return self._joined(self._table)

    def source(self) -> str:
        """Return the lines of each definition with the counts of their branches."""
        has_plc = any(cycle.scope in PLC_SCOPES for cycle in self._coverage.cycles)
        legend = self._get(_LEGEND) + (self._get(_OF_PLC) if has_plc else "")
        return self._joined(self._source, legend)

    def _joined(self, lines_of: Callable[[CycleCounts], Iterator[str]], legend: str = "") -> str:
        if not self._coverage.cycles:
            return self._get(_NO_CYCLES) + "\n"
        lines: list[str] = []
        for cycle in self._coverage.cycles:
            lines += [self._headline(cycle), *lines_of(cycle), ""]
        lines += [legend] if legend else []
        return "\n".join([*lines, self._total()]) + "\n"

    def _get(self, text: Text, /, **values: object) -> str:
        return text.get(self._language).format(**values)

    # --- heads and sums -------------------------------------------------------------------------

    def _headline(self, cycle: CycleCounts) -> str:
        name = self._get(_CYCLE, name=cycle.name) if cycle.name else self._get(_NO_NAME)
        is_plc = cycle.scope in PLC_SCOPES
        title = f"{cycle.scope} {cycle.name}" if is_plc else f"{name} {cycle.scope}".rstrip()
        facts = [f"{cycle.file}:{cycle.line}  {title}"]
        if not cycle.instances and not cycle.runs:
            facts.append(self._get(_NEVER))
        elif not cycle.runs:
            facts.append(self._get(_UNCALLED if is_plc else _IDLE))
        else:
            if cycle.instances > 1:
                facts.append(self._get(_DEFINED, instances=cycle.instances))
            times = _ONCE if cycle.runs == 1 else _TIMES
            facts.append(self._get(times, runs=cycle.runs))
        if cycle.branches:
            facts.append(self._get(_RAN, count=cycle.ran, all=len(cycle.branches)))
        return ", ".join(facts)

    def _total(self) -> str:
        coverage = self._coverage
        percent = number_text(round(coverage.percent, 1))
        return self._get(
            _TOTAL, count=coverage.ran, all=coverage.branches, percent=percent, runs=coverage.runs
        )

    def _columns(self) -> str:
        heads = zip(_COLUMNS, _WIDTHS, strict=True)
        return "  " + "".join(f"{self._get(head):>{width}}" for head, width in heads)

    # --- table ----------------------------------------------------------------------------------

    def _table(self, cycle: CycleCounts) -> Iterator[str]:
        if not cycle.branches:
            return
        yield self._columns()
        for branch in cycle.branches:
            state = cycle.state(branch)
            row = _row(_MARKS.get(state, "!"), branch.line, _counts(branch))
            yield f"{row}  {'  ' * _depth(cycle, branch)}{branch.text}"
            indent = " " * (2 + sum(_WIDTHS) + 2 + 2 * _depth(cycle, branch) + 2)
            if state != "ran":
                is_uncalled = state == "cycle" and cycle.scope in PLC_SCOPES
                text = self._get(_UNCALLED) if is_uncalled else ""
                yield indent + (text or self._state(state, branch.condition))
            for part in branch.parts:
                yield indent + self._part(part)

    def _state(self, state: BranchState, condition: ConditionCounts) -> str:
        text = self._get(_STATES[state])
        if state == "never false":
            nearest = self._nearest(condition, condition.nearest_to_false)
        else:
            is_known = state in ("never true", "not reached")
            nearest = self._nearest(condition, condition.nearest) if is_known else ""
        return f"{text}, {nearest}" if nearest else text

    def _part(self, part: ConditionCounts) -> str:
        counts = f"{self._get(_COLUMNS[2])} {part.true}, {self._get(_COLUMNS[3])} {part.false}"
        nearest = self._nearest(part, part.nearest)
        text = f"{self._get(_PART, text=part.text)}: {counts}"
        return f"{text}, {nearest}" if nearest else text

    def _nearest(self, condition: ConditionCounts, miss: NearestMiss | None) -> str:
        """Return how near to a change a condition came; empty for a combination of conditions."""
        if miss is None or condition.operator in WITHOUT_VALUES:
            return ""
        values = comparison_text(condition.operator, miss.left, miss.right)
        return self._get(_NEAREST, values=values, distance=distance_text(miss.distance))

    # --- source ---------------------------------------------------------------------------------

    def _source(self, cycle: CycleCounts) -> Iterator[str]:
        counts = self._line_counts(cycle)
        yield self._columns()
        for line, text in enumerate(cycle.source, start=cycle.line):
            yield f"{counts.get(line) or _row(' ', line, _NO_COUNTS)}  {text}".rstrip()

    def _line_counts(self, cycle: CycleCounts) -> dict[int, str]:
        """Return the head of each line that can run; several branches in a line share it."""
        heads: dict[int, str] = {}
        ran = "!" if not cycle.runs else " "
        for line in cycle.outside:
            heads[line] = _row(ran, line, ("", "", "", str(cycle.runs)))
        for branch in cycle.branches:
            mark = _MARKS.get(cycle.state(branch), "!")
            body_mark = " " if branch.bodies else "!"
            for line in branch.lines:
                heads[line] = _row(body_mark, line, ("", "", "", str(branch.bodies)))
            heads[branch.line] = _row(mark, branch.line, _counts(branch))
        return heads


_NO_COUNTS = ("", "", "", "")


def _counts(branch: BranchCounts) -> tuple[str, str, str, str]:
    """Return the cells evaluated, true, false, body; without a condition only the last one."""
    if branch.word in WITHOUT_CONDITION:
        return ("", "", "", str(branch.bodies))
    condition = branch.condition
    counts = (branch.evaluated, condition.true, condition.false, branch.bodies)
    evaluated, true, false, bodies = map(str, counts)
    return evaluated, true, false, bodies


def _row(mark: str, line: int, counts: tuple[str, str, str, str]) -> str:
    cells = zip((str(line), *counts), _WIDTHS, strict=True)
    return f"{mark} " + "".join(f"{cell:>{width}}" for cell, width in cells)


def _depth(cycle: CycleCounts, branch: BranchCounts) -> int:
    depth = 0
    while branch.outer is not None:
        branch = cycle.branches[branch.outer]
        depth += 1
    return depth

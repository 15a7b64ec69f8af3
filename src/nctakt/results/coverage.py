# SPDX-License-Identifier: MIT
"""Branch coverage of realtime cycles and Structured Text, of one run or of many together.

In: the histories of a run (``histories.py``), from the same probes as ``nctakt why``. Out:
``Coverage``. All counts are ticks: a realtime cycle runs once in a tick. A definition that was
executed repeatedly is one entry, identified by its file and line; if its text has changed since
earlier runs, their counts for its file are dropped (``Coverage.outdated_by``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Literal, get_args

from nctakt.base.dataclass import dataclass
from nctakt.nc.check.cycles.branches import BranchWord
from nctakt.results.histories import BranchHistory, ConditionHistory, CycleHistory, Nearest

#: The state of a branch: ``ran`` its body ran; ``never false`` its body ran in each evaluation of a
#: plain ``$IF`` or ``$ELSEIF``; ``never true`` its condition was always false; ``no rise`` its EDGE
#: was true from before the run on; ``fault`` an error broke off each evaluation; ``not reached``
#: its condition was never evaluated, or its ``$ELSE`` was never entered; ``cycle`` its cycle never
#: ran.
BranchState = Literal[
    "ran", "never false", "never true", "no rise", "fault", "not reached", "cycle"
]
BRANCH_STATES: tuple[BranchState, ...] = get_args(BranchState)

#: The word of a branch, in realtime cycles and in Structured Text.
CoverageWord = Literal[BranchWord, "IF", "ELSIF", "ELSE", "CASE", "FOR", "WHILE", "REPEAT"]
COVERAGE_WORDS: tuple[str, ...] = get_args(CoverageWord)
#: Words of branches without a condition.
WITHOUT_CONDITION = ("$ELSE", "ELSE", "CASE", "FOR")
#: Kinds of units of Structured Text, as ``CycleCounts.scope``.
PLC_SCOPES = ("PROGRAM", "FUNCTION_BLOCK", "FUNCTION", "METHOD", "ACTION", "PROPERTY")
_RAN = ("ran", "never false")


@dataclass(frozen=True, slots=True)
class NearestMiss:
    """The compared values at which a condition came nearest to being true, or false."""

    left: float
    right: float
    distance: float


@dataclass(frozen=True, slots=True)
class ConditionCounts:
    """Ticks in which a condition, or an operand of its ``&&`` or ``||``, was true and false.

    ``operator`` is that of its comparison, empty for a single value. ``nearest`` to true is
    ``None`` once it was true, ``nearest_to_false`` once it was false; both if it was never
    evaluated.
    """

    text: str
    operator: str
    true: int
    false: int
    nearest: NearestMiss | None = None
    nearest_to_false: NearestMiss | None = None

    def plus(self, other: ConditionCounts) -> ConditionCounts:
        """Return the sum of two runs."""
        true, false = self.true + other.true, self.false + other.false
        evaluated = self if self.true or self.false else other
        return replace(
            evaluated,
            true=true,
            false=false,
            nearest=None if true else _nearer(self.nearest, other.nearest),
            nearest_to_false=(
                None if false else _nearer(self.nearest_to_false, other.nearest_to_false)
            ),
        )


@dataclass(frozen=True, slots=True)
class BranchCounts:
    """One branch: the ticks in which its condition was evaluated and its body ran.

    ``outer`` is the index of the branch around it; ``lines`` are those of the branch itself and of
    the statements in its body outside inner branches. ``parts`` are the operands of ``&&`` and
    ``||``. An evaluation aborted by an error is neither true nor false.
    """

    line: int
    column: int
    text: str
    word: CoverageWord
    frequency: str
    outer: int | None
    lines: tuple[int, ...]
    evaluated: int
    bodies: int
    condition: ConditionCounts
    parts: tuple[ConditionCounts, ...] = ()

    def plus(self, other: BranchCounts) -> BranchCounts:
        """Return the sum of two runs."""
        return replace(
            self,
            evaluated=self.evaluated + other.evaluated,
            bodies=self.bodies + other.bodies,
            condition=self.condition.plus(other.condition),
            parts=_sums(self.parts, other.parts),
        )


@dataclass(frozen=True, slots=True)
class CycleCounts:
    """One definition: the number of its ``instances`` and of their run-throughs, ``runs``.

    Of Structured Text one function, method or body of a block: ``runs`` counts its calls, ``scope``
    is its keyword (``PLC_SCOPES``), and all counts are evaluations.

    ``name`` and ``scope`` are those of its first instance, empty without one. ``source`` are its
    lines, which begin at ``line``; ``outside`` those outside all branches.
    """

    file: str
    line: int
    name: str
    scope: str
    source: tuple[str, ...]
    outside: tuple[int, ...]
    instances: int
    runs: int
    branches: tuple[BranchCounts, ...]

    def plus(self, other: CycleCounts) -> CycleCounts:
        """Return the sum of two instances or runs."""
        executed = self if self.instances else other
        return replace(
            self,
            name=executed.name,
            scope=executed.scope,
            instances=self.instances + other.instances,
            runs=self.runs + other.runs,
            branches=tuple(
                branch.plus(other_branch)
                for branch, other_branch in zip(self.branches, other.branches, strict=True)
            ),
        )

    def state(self, branch: BranchCounts) -> BranchState:
        """Return the state of one of its branches."""
        if branch.bodies:
            is_plain = not branch.frequency and branch.word not in WITHOUT_CONDITION
            return "never false" if is_plain and not branch.condition.false else "ran"
        if not self.runs:
            return "cycle"
        if branch.condition.true:
            return "no rise"
        if branch.condition.false:
            return "never true"
        return "fault" if branch.evaluated else "not reached"

    @property
    def ran(self) -> int:
        """The number of its branches that ran."""
        return sum(branch.bodies > 0 for branch in self.branches)


@dataclass(frozen=True, slots=True)
class Coverage:
    """The branches of the realtime cycles of one run or of many, by file and line."""

    cycles: tuple[CycleCounts, ...] = ()
    runs: int = 0

    @property
    def branches(self) -> int:
        """The number of branches."""
        return sum(len(cycle.branches) for cycle in self.cycles)

    @property
    def ran(self) -> int:
        """The number of branches that ran."""
        return sum(cycle.ran for cycle in self.cycles)

    @property
    def percent(self) -> float:
        """The percentage of branches that ran; 100 without branches."""
        return 100.0 * self.ran / self.branches if self.branches else 100.0

    def count(self, state: BranchState) -> int:
        """Return the number of branches in this state."""
        return sum(
            cycle.state(branch) == state for cycle in self.cycles for branch in cycle.branches
        )

    def outdated_by(self, other: Coverage) -> tuple[str, ...]:
        """Return the files whose realtime cycles have changed or moved in ``other``.

        A run may know only some cycles of a file: GLOBAL cycles begun by an earlier run.
        """
        outdated = []
        theirs = other.by_file()
        for file, own in self.by_file().items():
            others = theirs.get(file, {})
            differ = any(own[line] != others[line] for line in own.keys() & others.keys())
            moved = own.keys() - others.keys() and others.keys() - own.keys()
            if differ or moved:
                outdated.append(file)
        return tuple(outdated)

    def by_file(self) -> dict[str, dict[int, tuple[str, ...]]]:
        """Return the text of each definition and the lines of its branches, by file and line."""
        texts: dict[str, dict[int, tuple[str, ...]]] = {}
        for cycle in self.cycles:
            shape = tuple(f"{branch.line} {branch.word}" for branch in cycle.branches)
            texts.setdefault(cycle.file, {})[cycle.line] = (*cycle.source, *shape)
        return texts

    def plus(self, other: Coverage) -> Coverage:
        """Return the sum of both; for a file that has changed only ``other`` counts."""
        outdated = self.outdated_by(other)
        current = [cycle for cycle in self.cycles if cycle.file not in outdated]
        return Coverage(add_up([*current, *other.cycles]), self.runs + other.runs)

    def renamed(self, name_of: Callable[[str], str | None]) -> Coverage:
        """Return the coverage with other names of files, without files that have no new name."""
        cycles_by_name = [(name_of(cycle.file), cycle) for cycle in self.cycles]
        cycles = [replace(cycle, file=name) for name, cycle in cycles_by_name if name is not None]
        return Coverage(add_up(cycles), self.runs)


def cycle_counts(history: CycleHistory, source: tuple[str, ...]) -> CycleCounts:
    """Return the counts of one instance of a definition, or of a definition without one."""
    return CycleCounts(
        history.span.file,
        history.span.line,
        history.name,
        history.scope,
        source,
        history.lines,
        1 if history.life else 0,
        history.runs.ticks,
        tuple(_branch(branch) for branch in history.branches),
    )


def _branch(history: BranchHistory) -> BranchCounts:
    return BranchCounts(
        history.span.line,
        history.span.column,
        history.text,
        history.word,
        history.frequency,
        history.outer,
        history.lines,
        history.evaluated.ticks,
        history.bodies.ticks,
        _condition(history.condition),
        tuple(_condition(part) for part in history.parts),
    )


def _condition(history: ConditionHistory) -> ConditionCounts:
    return ConditionCounts(
        history.text,
        history.operator,
        history.true_ticks,
        history.false_ticks,
        None if history.true_ticks else _miss(history.nearest),
        None if history.false_ticks else _miss(history.nearest_to_false),
    )


def _miss(nearest: Nearest | None) -> NearestMiss | None:
    if nearest is None:
        return None
    return NearestMiss(nearest.left, nearest.right, nearest.distance)


def _nearer(one: NearestMiss | None, other: NearestMiss | None) -> NearestMiss | None:
    """Return the one with the smaller distance, the first if they are equal."""
    misses = [miss for miss in (one, other) if miss is not None]
    return min(misses, key=lambda miss: miss.distance, default=None)


def _sums(
    first: Sequence[ConditionCounts], second: Sequence[ConditionCounts]
) -> tuple[ConditionCounts, ...]:
    """Return the sums part by part; a definition without an instance has no parts."""
    if len(first) != len(second):
        return tuple(first if len(first) > len(second) else second)
    return tuple(part.plus(other_part) for part, other_part in zip(first, second, strict=True))


def add_up(cycles: Iterable[CycleCounts]) -> tuple[CycleCounts, ...]:
    """Return the counts added up by definition, in the order of file and line."""
    totals: dict[tuple[str, int, str], CycleCounts] = {}
    for cycle in cycles:
        # Several methods may begin in one line, a cycle may have another name in each run.
        key = (cycle.file, cycle.line, cycle.name if cycle.scope in PLC_SCOPES else "")
        totals[key] = totals[key].plus(cycle) if key in totals else cycle
    return tuple(totals[key] for key in sorted(totals))

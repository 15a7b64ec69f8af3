# SPDX-License-Identifier: MIT
"""Which branches of which realtime cycles ran, and how often: of a run, or of many runs together.

In: the histories of a run (``histories.py``), from the same probes as ``nctakt why``. Out:
``Coverage``. All counts are ticks: a realtime cycle runs once in a tick. A definition that was
executed again and again is one entry, found by its file and line; where its text is another one
than that of earlier runs, what they know of its file is of no use and is dropped
(``Coverage.outdated_by``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Literal, get_args

from nctakt.base.dataclass import dataclass
from nctakt.nc.check.branches import BranchWord
from nctakt.results.histories import BranchHistory, ConditionHistory, CycleHistory

#: What became of a branch: ``ran`` its body did; ``never false`` it did, in each evaluation of a
#: plain ``$IF`` or ``$ELSEIF``; ``never true`` its condition was evaluated and always false; ``no
#: rise`` an EDGE that was true all the time, from before the run on; ``fault`` an error broke off
#: each evaluation; ``not reached`` its condition was never evaluated, or nothing led into its
#: ``$ELSE``; ``cycle`` its cycle never ran.
BranchState = Literal[
    "ran", "never false", "never true", "no rise", "fault", "not reached", "cycle"
]
BRANCH_STATES: tuple[BranchState, ...] = get_args(BranchState)

_RAN = ("ran", "never false")


@dataclass(frozen=True, slots=True)
class NearestMiss:
    """What a condition compared when it came nearest to being true."""

    left: float
    right: float
    distance: float


@dataclass(frozen=True, slots=True)
class ConditionCounts:
    """A condition, or a part of one that ``&&`` or ``||`` combines: ticks in which it was … .

    ``operator`` is that of its comparison, empty for a value alone. ``nearest`` is ``None`` once it
    was true, or where it was never evaluated.
    """

    text: str
    operator: str
    true: int
    false: int
    nearest: NearestMiss | None = None

    def plus(self, other: ConditionCounts) -> ConditionCounts:
        """The sum of two runs."""
        true = self.true + other.true
        misses = [one.nearest for one in (self, other) if one.nearest is not None]
        nearest = None if true or not misses else min(misses, key=lambda one: one.distance)
        known = self if self.true or self.false else other
        return replace(known, true=true, false=self.false + other.false, nearest=nearest)


@dataclass(frozen=True, slots=True)
class BranchCounts:
    """One branch: in how many ticks its condition was evaluated and its body ran.

    ``outer`` is the position of the branch around it; ``lines`` are its own and those of the
    statements in its body that stand in no further branch. ``parts`` are what ``&&`` and ``||``
    combine. An evaluation that an error broke off is neither true nor false.
    """

    line: int
    column: int
    text: str
    word: BranchWord
    frequency: str
    outer: int | None
    lines: tuple[int, ...]
    evaluated: int
    bodies: int
    condition: ConditionCounts
    parts: tuple[ConditionCounts, ...] = ()

    def plus(self, other: BranchCounts) -> BranchCounts:
        """The sum of two runs."""
        return replace(
            self,
            evaluated=self.evaluated + other.evaluated,
            bodies=self.bodies + other.bodies,
            condition=self.condition.plus(other.condition),
            parts=_sums(self.parts, other.parts),
        )


@dataclass(frozen=True, slots=True)
class CycleCounts:
    """One definition: ``instances`` is how often it was executed, ``runs`` its run-throughs.

    ``name`` and ``scope`` are those of its first instance, empty where there was none. ``source``
    are its lines, the first one in ``line``; ``outside`` those that stand in no branch.
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
        """The sum of two instances or runs."""
        named = self if self.instances else other
        return replace(
            self,
            name=named.name,
            scope=named.scope,
            instances=self.instances + other.instances,
            runs=self.runs + other.runs,
            branches=tuple(
                one.plus(another)
                for one, another in zip(self.branches, other.branches, strict=True)
            ),
        )

    def state(self, branch: BranchCounts) -> BranchState:
        """What became of one of its branches."""
        if branch.bodies:
            is_plain = not branch.frequency and branch.word != "$ELSE"
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
        """How many of its branches ran."""
        return sum(branch.bodies > 0 for branch in self.branches)


@dataclass(frozen=True, slots=True)
class Coverage:
    """The branches of the realtime cycles of one run or of many, by file and line."""

    cycles: tuple[CycleCounts, ...] = ()
    runs: int = 0

    @property
    def branches(self) -> int:
        """How many branches there are."""
        return sum(len(one.branches) for one in self.cycles)

    @property
    def ran(self) -> int:
        """How many of them ran."""
        return sum(one.ran for one in self.cycles)

    @property
    def percent(self) -> float:
        """The share of branches that ran; 100 where there are none."""
        return 100.0 * self.ran / self.branches if self.branches else 100.0

    def count(self, state: BranchState) -> int:
        """How many branches are in this state."""
        return sum(one.state(branch) == state for one in self.cycles for branch in one.branches)

    def outdated_by(self, other: Coverage) -> tuple[str, ...]:
        """The files whose realtime cycles have another text in ``other``, or stand elsewhere.

        A run may know only some cycles of a file: GLOBAL ones that an earlier run has begun.
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
        """The text of each definition and where its branches stand, by file and line."""
        found: dict[str, dict[int, tuple[str, ...]]] = {}
        for one in self.cycles:
            shape = tuple(f"{branch.line} {branch.word}" for branch in one.branches)
            found.setdefault(one.file, {})[one.line] = (*one.source, *shape)
        return found

    def plus(self, other: Coverage) -> Coverage:
        """Both together; of a file whose text has changed only ``other`` counts."""
        outdated = self.outdated_by(other)
        kept = [one for one in self.cycles if one.file not in outdated]
        return Coverage(added([*kept, *other.cycles]), self.runs + other.runs)

    def renamed(self, name_of: Callable[[str], str | None]) -> Coverage:
        """With other names of files; what has no name is left out."""
        named = [(name_of(one.file), one) for one in self.cycles]
        cycles = [replace(one, file=name) for name, one in named if name is not None]
        return Coverage(added(cycles), self.runs)


def counts_of(history: CycleHistory, source: tuple[str, ...]) -> CycleCounts:
    """The counts of one instance of a definition, or of one that was not reached."""
    return CycleCounts(
        history.span.file,
        history.span.line,
        history.name,
        history.scope,
        source,
        history.lines,
        1 if history.life else 0,
        history.runs.ticks,
        tuple(_branch(one) for one in history.branches),
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
    nearest = history.nearest
    miss = None
    if nearest is not None and not history.true_ticks:
        miss = NearestMiss(nearest.left, nearest.right, nearest.distance)
    return ConditionCounts(
        history.text, history.operator, history.true_ticks, history.false_ticks, miss
    )


def _sums(
    first: Sequence[ConditionCounts], second: Sequence[ConditionCounts]
) -> tuple[ConditionCounts, ...]:
    """Part by part; a definition that was not reached knows none."""
    if len(first) != len(second):
        return tuple(first if len(first) > len(second) else second)
    return tuple(one.plus(another) for one, another in zip(first, second, strict=True))


def added(cycles: Iterable[CycleCounts]) -> tuple[CycleCounts, ...]:
    """One entry for each definition, in the order of their places."""
    found: dict[tuple[str, int], CycleCounts] = {}
    for one in cycles:
        place = (one.file, one.line)
        found[place] = found[place].plus(one) if place in found else one
    return tuple(found[place] for place in sorted(found))

# SPDX-License-Identifier: MIT
"""How far a run was from a branch of a realtime cycle that did not run.

In: the coverage of a run, which knows where each condition came nearest to changing. Out: a
distance for each branch, comparable between runs: first by how many branches around it are left,
then by the conditions of the first of them.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.results.coverage import (
    WITHOUT_CONDITION,
    BranchCounts,
    ConditionCounts,
    Coverage,
    CycleCounts,
    NearestMiss,
)
from nctakt.results.histories import WITHOUT_VALUES

#: A branch: its file, the line of its definition, its index there.
BranchKey = tuple[str, int, int]

#: Words of branches that follow others of their ``$IF`` or IF.
_FOLLOWING = ("$ELSEIF", "$ELSE", "ELSIF", "ELSE")

#: The distance of a condition whose values say nothing; with values it is less.
_UNKNOWN = 1.0

#: A comparison that misses by nothing still misses: ``X < 5`` at 5.
_MIN_REST = 1e-9


@dataclass(frozen=True, slots=True)
class BranchDistance:
    """The distance to a branch; ``difference``: that of the two sides of its comparison.

    ``levels``: the branches that did not run, those around it included; 0 if it ran.
    ``difference`` is ``None`` where no single comparison of numbers decides.
    """

    levels: int
    rest: float = 0.0
    difference: float | None = None

    @property
    def key(self) -> tuple[int, float]:
        """The key by which runs compare: less is better."""
        return self.levels, self.rest


#: The distance of a run that does not even have the cycle of a branch.
NOT_THERE = BranchDistance(1 << 30)


def distances(coverage: Coverage) -> dict[BranchKey, BranchDistance]:
    """Return the distance of a run to each branch of its cycles."""
    return {
        (cycle.file, cycle.line, index): _distance(cycle, index)
        for cycle in coverage.cycles
        for index in range(len(cycle.branches))
    }


def _distance(cycle: CycleCounts, index: int) -> BranchDistance:
    """Return the distance of a branch: that of the outermost one around it that did not run."""
    chain = [index]
    while (outer := cycle.branches[chain[-1]].outer) is not None:
        chain.append(outer)
    left = [number for number in reversed(chain) if not cycle.branches[number].bodies]
    if not left:
        return BranchDistance(0)
    if not cycle.runs:
        return BranchDistance(len(left) + 1, _UNKNOWN)
    return _rest(len(left), cycle, left[0])


def _rest(levels: int, cycle: CycleCounts, index: int) -> BranchDistance:
    """Return the distance of a branch by its condition, or by those before it in its ``$IF``."""
    branch = cycle.branches[index]
    if branch.condition.false or _has_label(branch):
        misses = [_miss(branch, to=True)]
    else:
        earlier = _earlier(cycle.branches, index)
        misses = [_miss(one, to=False) for one in earlier if not one.condition.false]
        misses += [(_UNKNOWN, None)] * (branch.word not in WITHOUT_CONDITION)
    rest = sum(rest for rest, _ in misses) or _UNKNOWN
    difference = next((difference for _, difference in misses if difference is not None), None)
    return BranchDistance(levels, rest, difference)


def _has_label(branch: BranchCounts) -> bool:
    """Return whether values are known that lead to a branch without a condition, as in CASE."""
    return branch.word in WITHOUT_CONDITION and branch.condition.nearest is not None


def _earlier(branches: tuple[BranchCounts, ...], index: int) -> list[BranchCounts]:
    """Return the branches before one in the same ``$IF`` or IF."""
    earlier: list[BranchCounts] = []
    word = branches[index].word
    for branch in reversed(branches[:index]):
        if word not in _FOLLOWING:
            break
        if branch.outer == branches[index].outer:
            earlier.append(branch)
            word = branch.word
    return earlier


def _miss(branch: BranchCounts, *, to: bool) -> tuple[float, float | None]:
    """Return the distance until a condition changes, and the difference of its sides if it has any.

    The rest is below 1 for a comparison, and for ``&&`` and ``||`` the sum of their operands'; the
    difference is then that of the first operand that has not changed.
    """
    nearest = _nearest(branch.condition, to=to)
    if nearest is None:
        return _of_parts(branch, to=to)
    if branch.condition.operator in WITHOUT_VALUES:
        parts = [_nearest(part, to=to) for part in branch.parts]
        first = next((part for part in parts if part is not None), None)
        difference = None if first is None else first.left - first.right
        return max(_MIN_REST, nearest.distance), difference
    share = nearest.distance / (nearest.distance + 1.0)
    return max(_MIN_REST, share), nearest.left - nearest.right


def _of_parts(branch: BranchCounts, *, to: bool) -> tuple[float, float | None]:
    """Return the same of a condition of Structured Text, of which the operands alone are known."""
    known = [_nearest(part, to=to) for part in branch.parts]
    misses = [one for one in known if one is not None]
    if not misses:
        return _UNKNOWN, None
    shares = (one.distance / (one.distance + 1.0) for one in misses)
    rest = max(_MIN_REST, sum(shares) / len(misses))
    return rest, misses[0].left - misses[0].right


def _nearest(condition: ConditionCounts, *, to: bool) -> NearestMiss | None:
    """Return where a condition that has never been so came nearest to it, where its values say."""
    nearest = condition.nearest if to else condition.nearest_to_false
    is_known = nearest is not None and nearest.distance == nearest.distance
    return nearest if is_known and condition.operator != "text" else None

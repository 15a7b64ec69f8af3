# SPDX-License-Identifier: MIT
"""Branch coverage of a PLC in Structured Text, in the form of that of realtime cycles.

In: the numbered branches of a program and their counts. Out: ``Coverage``: each function, method
and body with its branches; conditions with the operands of AND and OR.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.results.coverage import (
    BranchCounts,
    ConditionCounts,
    Coverage,
    CycleCounts,
    NearestMiss,
)
from nctakt.st.program import Program
from nctakt.st.sources import Sources
from nctakt.st.tree import Binary
from nctakt.st.types import Expression
from nctakt.translation.observing.branches import BranchNumbers, NumberedBranch, NumberedUnit
from nctakt.translation.observing.compared import is_compared


@dataclass(frozen=True, slots=True)
class Counts:
    """Counts of a run: how often, and for comparisons how near they came.

    ``left``, ``right`` and ``distances``: both sides and how far they were apart, below 0 where
    that is not known.
    """

    of: Sequence[int]
    left: Sequence[float]
    right: Sequence[float]
    distances: Sequence[float]

    def miss(self, number: int) -> NearestMiss | None:
        """Return how near a comparison came to the result it never had."""
        if self.of[number] or self.distances[number] < 0.0:
            return None
        return NearestMiss(self.left[number], self.right[number], self.distances[number])


def coverage_of(program: Program, numbers: BranchNumbers, counts: Counts) -> Coverage:
    """Return the coverage of a program by its counts; it belongs to a run that is counted once."""
    return Coverage(tuple(_unit(program.sources, unit, counts) for unit in numbers.units))


def _unit(sources: Sources, unit: NumberedUnit, counts: Counts) -> CycleCounts:
    piece = sources.piece_of(unit.called.start)
    file = "" if piece is None else piece.file
    first = sources.line_number(unit.called.start)
    last = max(first, sources.line_number(unit.end - 1))
    source = tuple(sources.line(file, line) for line in range(first, last + 1))
    return CycleCounts(
        file,
        first,
        unit.called.path,
        unit.title,
        source,
        _lines(sources, unit.starts),
        1,
        counts.of[unit.number],
        tuple(_branch(sources, branch, counts) for branch in unit.branches),
    )


def _branch(sources: Sources, branch: NumberedBranch, counts: Counts) -> BranchCounts:
    piece = sources.piece_of(branch.start)
    file, line, column = ("", 0, 0) if piece is None else (piece.file, *piece.locate(branch.start))
    text = "ELSE" if branch.kind == "ELSE" else sources.line(file, line).strip()
    if branch.condition is None:
        evaluated = bodies = counts.of[branch.number]
        operator = "=" if branch.is_label else ""
        condition = ConditionCounts(text, operator, bodies, 0, counts.miss(branch.number))
    else:
        condition = _condition(sources, branch.condition, branch.number, counts)
        evaluated = condition.true + condition.false
        bodies = evaluated if branch.kind == "REPEAT" else condition.true
    return BranchCounts(
        line,
        column,
        text,
        branch.kind,
        "",
        branch.outer,
        (line, *_lines(sources, branch.starts)),
        evaluated,
        bodies,
        condition,
        tuple(_condition(sources, part, number, counts) for part, number in branch.parts),
    )


def _condition(
    sources: Sources, expression: Expression, number: int, counts: Counts
) -> ConditionCounts:
    text = sources.text(expression.start, expression.end)
    is_known = isinstance(expression, Binary) and is_compared(expression)
    operator = expression.operator.value if isinstance(expression, Binary) and is_known else ""
    return ConditionCounts(
        text,
        operator,
        counts.of[number],
        counts.of[number + 1],
        counts.miss(number),
        counts.miss(number + 1),
    )


def _lines(sources: Sources, starts: Sequence[int]) -> tuple[int, ...]:
    return tuple(dict.fromkeys(sources.line_number(start) for start in starts))

# SPDX-License-Identifier: MIT
"""What is gathered of one branch of a realtime cycle, its condition and its body: rows -> history.

In: a branch's node in the realtime part, then its probe rows as they come. Out: ``BranchHistory``.
The newest rows are kept, up to the bounds below.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from nctakt.decoder.cycles import BuiltReaction, Frozen
from nctakt.kernel import conditions
from nctakt.nc.branches import BranchPlace, accesses_in, combined
from nctakt.nc.printer import format_expression
from nctakt.nc.syntax import Expression
from nctakt.results.histories import (
    BranchHistory,
    Change,
    ConditionHistory,
    Nearest,
    Series,
    Times,
)

#: Changes of truth that are kept for each condition.
CHANGES_KEPT = 1000

#: Series of consecutive ticks that are kept for each condition, body and cycle.
SERIES_KEPT = 1000


_OPERATORS: dict[type[conditions.Condition], str] = {
    conditions.IsLess: "<",
    conditions.IsLessCellConstant: "<",
    conditions.IsLessEqual: "<=",
    conditions.IsLessEqualCellConstant: "<=",
    conditions.IsGreater: ">",
    conditions.IsGreaterCellConstant: ">",
    conditions.IsGreaterEqual: ">=",
    conditions.IsGreaterEqualCellConstant: ">=",
    conditions.IsEqual: "==",
    conditions.IsEqualCellConstant: "==",
    conditions.IsNotEqual: "!=",
    conditions.IsNotEqualCellConstant: "!=",
    conditions.Both: "&&",
    conditions.Either: "||",
}


class SeriesLog:
    """Begins of series, each with the tick behind the one before -> closed series."""

    def __init__(self, first_tick: int | None) -> None:
        self._first_tick = first_tick
        self._kept: deque[Series] = deque(maxlen=SERIES_KEPT)
        self._ticks = 0
        self._left_out = 0

    def begin(self, tick: int, next_tick: int) -> None:
        """A series begins; the one before ended before ``next_tick``."""
        self._close(next_tick)
        self._first_tick = tick

    def _close(self, next_tick: int) -> None:
        """The series that is open ended before ``next_tick``; it may have no tick in this run."""
        if self._first_tick is not None and next_tick > self._first_tick:
            self._left_out += len(self._kept) == SERIES_KEPT
            self._kept.append(Series(self._first_tick, next_tick - 1))
            self._ticks += next_tick - self._first_tick
        self._first_tick = None

    def finish(self, next_tick: int) -> Times:
        """All series, the last of which ended before ``next_tick``."""
        self._close(next_tick)
        return Times(tuple(self._kept), self._ticks, self._left_out)


def continued(next_tick: int, living_from: int | None) -> int | None:
    """The first tick of a series that an earlier run has begun and that may go on."""
    return living_from if next_tick == living_from else None


class ConditionLog:
    """One condition: its node in the realtime part and its changes of truth."""

    def __init__(self, node: conditions.Condition, is_living: bool) -> None:
        self.node = node
        has_truth = is_living and node.truth != conditions.UNKNOWN
        self._was_true = node.truth == 1 if has_truth else None
        self._changes: deque[Change] = deque(maxlen=CHANGES_KEPT)
        self._left_out = 0

    def change(self, tick: int, truth: bool, left: float, right: float) -> None:
        """The condition has another truth."""
        self._left_out += len(self._changes) == CHANGES_KEPT
        self._changes.append(Change(tick, truth, left, right))

    def history(self, expression: Expression | None) -> ConditionHistory:
        """What was gathered."""
        node = self.node
        nearest = None
        if node.nearest_tick >= 0 and not node.was_ever_true:
            nearest = Nearest(
                node.nearest_tick, node.nearest_left, node.nearest_right, node.nearest
            )
        return ConditionHistory(
            "" if expression is None else format_expression(expression),
            _OPERATORS.get(type(node), ""),
            tuple(self._changes),
            self._left_out,
            self._was_true,
            nearest,
        )


def _leaves(node: conditions.Condition) -> list[conditions.Condition]:
    """What ``&&`` and ``||`` combine, in the order of the text."""
    if isinstance(node, conditions.Combination):
        return [*_leaves(node.first), *_leaves(node.second)]
    return [node]


class BranchLog:
    """One branch: its node in the realtime part and what came from it.

    ``living_from`` is the run's first tick for a branch that lives since before it, else ``None``.
    """

    def __init__(self, built: BuiltReaction, living_from: int | None) -> None:
        node = built.node.condition
        is_living = living_from is not None
        self._reaction = built.node
        self._condition = ConditionLog(node, is_living)
        self._parts: list[ConditionLog] = []
        if isinstance(node, conditions.Combination):
            self._parts = [ConditionLog(leaf, is_living) for leaf in _leaves(node)]
        self.probe = node.probe
        self.conditions = {one.node.probe: one for one in (self._condition, *self._parts)}
        self.evaluated = SeriesLog(continued(node.next_tick, living_from))
        self.bodies = SeriesLog(continued(built.node.next_tick, living_from))

    def history(self, place: BranchPlace, text: str, frozen: Sequence[Frozen]) -> BranchHistory:
        """What was gathered; ``text`` is the source line, ``frozen`` what the whole cycle froze."""
        node = self._condition.node
        expressions = [] if place.condition is None else combined(place.condition)
        places = [access.span for one in expressions for access in accesses_in(one)]
        return BranchHistory(
            place.span,
            place.lines,
            text,
            place.word,
            place.frequency,
            place.outer,
            place.earlier,
            self._condition.history(place.condition),
            tuple(
                part.history(expression)
                for part, expression in zip(self._parts, expressions, strict=False)
            ),
            self.evaluated.finish(node.next_tick),
            self.bodies.finish(self._reaction.next_tick),
            tuple(one for one in frozen if one.span in places),
        )

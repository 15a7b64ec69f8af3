# SPDX-License-Identifier: MIT
"""The log of one branch of a realtime cycle, its condition and its body: rows -> history.

In: a branch's node in the realtime part, then its probe rows as they come. Out: ``BranchHistory``.
The newest rows are kept, up to the bounds below.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from nctakt.base.source_ids import begins_at
from nctakt.decoder.cycles.builder import CycleBranch, FrozenValue
from nctakt.kernel import codes
from nctakt.kernel.cycles import conditions
from nctakt.nc.check.cycles.branches import BranchOutline, accesses_in, combined
from nctakt.nc.parse.printer import format_expression
from nctakt.nc.tree import Expression
from nctakt.results.compared import OPERATORS
from nctakt.results.histories import (
    BranchHistory,
    Change,
    ConditionHistory,
    LifeEvent,
    Nearest,
    Series,
    Times,
)

#: Maximum number of changes of truth kept for each condition.
CHANGES_KEPT = 1000

#: Maximum number of series of consecutive ticks kept for each condition, body and cycle.
SERIES_KEPT = 1000


#: Initial value of a distance in the realtime part.
_NEVER = 1.7976931348623157e308


class SeriesLog:
    """Begins of series, each with the tick after the previous series -> closed series."""

    def __init__(self, first_tick: int | None) -> None:
        self._first_tick = first_tick
        self._kept: deque[Series] = deque(maxlen=SERIES_KEPT)
        self._ticks = 0
        self._left_out = 0

    def begin(self, tick: int, next_tick: int) -> None:
        """Begin a series; the previous one ended before ``next_tick``."""
        self._close(next_tick)
        self._first_tick = tick

    def _close(self, next_tick: int) -> None:
        """Close the open series, which ended before ``next_tick``, perhaps before this run."""
        if self._first_tick is not None and next_tick > self._first_tick:
            self._left_out += len(self._kept) == SERIES_KEPT
            self._kept.append(Series(self._first_tick, next_tick - 1))
            self._ticks += next_tick - self._first_tick
        self._first_tick = None

    def finish(self, next_tick: int) -> Times:
        """Return all series; the last one ended before ``next_tick``."""
        self._close(next_tick)
        return Times(tuple(self._kept), self._ticks, self._left_out)


class TruthCount:
    """Begins of series and changes of truth -> the numbers of ticks with false and with true."""

    def __init__(self, first_tick: int | None, truth: bool | None) -> None:
        self._since = first_tick
        self._truth = truth
        self._ticks = [0, 0]

    def begin(self, tick: int, next_tick: int) -> None:
        """Begin a series of evaluations; the previous one ended before ``next_tick``."""
        self._close(next_tick)
        self._since = tick

    def change(self, tick: int, truth: bool) -> None:
        """Note that the evaluation in ``tick`` was the first with this truth."""
        self._close(tick)
        self._since, self._truth = tick, truth

    def _close(self, next_tick: int) -> None:
        if self._since is not None and self._truth is not None and next_tick > self._since:
            self._ticks[self._truth] += next_tick - self._since
        self._since = None

    def finish(self, next_tick: int) -> tuple[int, int]:
        """Return the ticks with false and with true; the last series ended before ``next_tick``."""
        self._close(next_tick)
        return self._ticks[0], self._ticks[1]


def first_tick_of_series(next_tick: int, living_from: int | None) -> int | None:
    """Return the first tick of a series that an earlier run began, ``None`` if it has ended."""
    return living_from if next_tick == living_from else None


class ConditionLog:
    """One condition: its node in the realtime part and its changes of truth.

    ``living_from`` is the run's first tick for a condition older than the run, else ``None``.
    """

    def __init__(self, node: conditions.Condition, living_from: int | None) -> None:
        self.node = node
        has_truth = living_from is not None and node.truth != codes.UNKNOWN
        self._was_true = node.truth == codes.TRUE if has_truth else None
        self.truths = TruthCount(first_tick_of_series(node.next_tick, living_from), self._was_true)
        self._changes: deque[Change] = deque(maxlen=CHANGES_KEPT)
        self._left_out = 0

    def change(self, tick: int, truth: bool, left: float, right: float) -> None:
        """Note a change of truth and the compared values."""
        self._left_out += len(self._changes) == CHANGES_KEPT
        self._changes.append(Change(tick, truth, left, right))
        self.truths.change(tick, truth)

    def history(self, expression: Expression | None, fault_tick: int | None) -> ConditionHistory:
        """Return the history; an error broke off the evaluation in ``fault_tick``."""
        node = self.node
        broken_off = fault_tick is not None and node.next_tick == fault_tick + 1
        false_ticks, true_ticks = self.truths.finish(node.next_tick - broken_off)
        nearest = None
        if node.nearest_tick >= 0:
            distance = node.nearest
            if isinstance(node, conditions.Combination):
                distance = _left(node, to=not node.was_ever_true)
            nearest = Nearest(node.nearest_tick, node.nearest_left, node.nearest_right, distance)
        return ConditionHistory(
            "" if expression is None else format_expression(expression),
            OPERATORS.get(type(node), ""),
            tuple(self._changes),
            self._left_out,
            self._was_true,
            None if node.was_ever_true else nearest,
            true_ticks,
            false_ticks,
            None if node.was_ever_false else nearest,
        )


def _left(node: conditions.Condition, *, to: bool) -> float:
    """Return how much is left until a condition has been so; 0 if it was.

    If operands must hold together, it is smaller the nearer one of them came while the other held:
    ``V.E.GO == 1 && X > 200`` is nearer the later ``V.E.GO`` is 1 before X is at 200.
    """
    if node.was_ever_true if to else node.was_ever_false:
        return 0.0
    if not isinstance(node, conditions.Combination):
        return max(node.nearest / (node.nearest + 1.0), 1e-9) if node.nearest_tick >= 0 else 1.0
    first, second = _left(node.first, to=to), _left(node.second, to=to)
    if isinstance(node, conditions.Both) is not to:
        return min(first, second)
    return sum(
        beside if beside < _NEVER else 1.0 + left
        for beside, left in ((node.beside_first, first), (node.beside_second, second))
    ) + min(node.nearest, 2.0)


def _leaves(node: conditions.Condition) -> list[conditions.Condition]:
    """Return the operands of ``&&`` and ``||``, in the order of the text."""
    if isinstance(node, conditions.Combination):
        return [*_leaves(node.first), *_leaves(node.second)]
    return [node]


class BranchLog:
    """One branch: its node in the realtime part and the rows recorded for it.

    ``living_from`` is the run's first tick for a branch older than the run, else ``None``.
    """

    def __init__(self, branch: CycleBranch, living_from: int | None) -> None:
        node = branch.node.condition
        self._reaction = branch.node
        self._condition = ConditionLog(node, living_from)
        self._parts: list[ConditionLog] = []
        self.became_true = 0
        if isinstance(node, conditions.Combination):
            self._parts = [ConditionLog(leaf, living_from) for leaf in _leaves(node)]
        self.probe = node.probe
        self.conditions = {
            condition.node.probe: condition for condition in (self._condition, *self._parts)
        }
        self.evaluated = SeriesLog(first_tick_of_series(node.next_tick, living_from))
        self.bodies = SeriesLog(first_tick_of_series(branch.node.next_tick, living_from))

    def history(
        self,
        outline: BranchOutline,
        text: str,
        frozen: Sequence[FrozenValue],
        fault: LifeEvent | None,
    ) -> BranchHistory:
        """Return the history of the branch.

        ``text`` is the source line, ``frozen`` the asynchronous values of the whole cycle
        (RC-302), ``fault`` the error that ended the cycle.
        """
        fault_tick = None
        if fault is not None and begins_at(outline.span, fault.span):
            fault_tick = fault.tick
        node = self._condition.node
        expressions = [] if outline.condition is None else combined(outline.condition)
        spans = [access.span for item in expressions for access in accesses_in(item)]
        return BranchHistory(
            outline.span,
            outline.lines,
            text,
            outline.word,
            outline.frequency,
            outline.outer,
            outline.earlier,
            self._condition.history(outline.condition, fault_tick),
            tuple(
                part.history(expression, fault_tick)
                for part, expression in zip(self._parts, expressions, strict=False)
            ),
            self.evaluated.finish(node.next_tick),
            self.bodies.finish(self._reaction.next_tick),
            tuple(item for item in frozen if item.span in spans),
            outline.commands,
            self.became_true,
        )

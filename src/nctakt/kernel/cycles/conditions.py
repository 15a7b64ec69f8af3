# SPDX-License-Identifier: MIT
"""Conditions of ``$IF`` in realtime cycles, each with its probe (RC-202).

A condition keeps its last truth and records a probe row (``record.py``) when its truth changes,
and, on request, when a series of evaluations in consecutive ticks begins. As long as it has only
been false, or only true, it keeps the smallest distance between its two sides, and when that was. A
condition that is not a comparison compares its value with 0.5. ``&&`` and ``||`` combine conditions
that have probes, too; their distance is how far they are from changing: the sum over the operands
if all have to change, each as a share of 1, or the least one if one is enough. They also keep how
near one operand came while the other had the required truth. Evaluations ended by a fault are not
recorded.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Expression, Load


class Condition:
    """Base, and null object: always true, nothing recorded.

    ``probe`` is its number in the probe rows; ``truth`` the last one, ``codes.UNKNOWN`` from its
    cycle's START on. ``next_tick`` is the tick after its last evaluation, -1 before the first;
    ``seen_left`` and ``seen_right`` are the values compared then. ``distance``: left side less
    right side in that evaluation.
    """

    def __init__(self) -> None:
        self.probe = 0
        self.truth = codes.UNKNOWN
        self.next_tick = -1
        self.seen_left = 0.0
        self.seen_right = 0.0
        self.was_ever_true = False
        self.was_ever_false = False
        self.distance = 0.0
        self.nearest = 1.7976931348623157e308
        self.nearest_left = 0.0
        self.nearest_right = 0.0
        self.nearest_tick = -1

    def decide(self, context: Context) -> int:
        """Evaluate the condition: 1 true, 0 false. A fault is noted in the context."""
        return 1

    def sides(self, context: Context) -> tuple[float, float]:
        """Return what an evaluation would compare now, for Python's side; it changes nothing."""
        return 0.0, 0.0

    def forget(self) -> None:
        """Forget the last truth: the next evaluation counts as the first (START, RC-111)."""
        self.truth = codes.UNKNOWN


def note(condition: Condition, context: Context, truth: int, left: float, right: float) -> None:
    """Record a change of truth; until it has been both, keep the nearest sides.

    Most evaluations give the same as in the tick before; they end here, inlined in the caller.
    """
    if context.tick != condition.next_tick or truth != condition.truth:
        record_change(condition, context, truth, left, right)
    condition.next_tick = context.tick + 1
    condition.seen_left = left
    condition.seen_right = right
    distance = left - right
    condition.distance = distance
    if distance < condition.nearest and distance > -condition.nearest:
        approach(condition, context, left, right)


def note_combination(condition: Combination, context: Context, truth: int, distance: float) -> None:
    """Record a change of truth of ``&&`` or ``||``, which has no sides, and its distance."""
    if context.tick != condition.next_tick or truth != condition.truth:
        record_change(condition, context, truth, truth, 0.5)
    condition.next_tick = context.tick + 1
    condition.seen_left = truth
    condition.seen_right = 0.5
    condition.distance = distance
    if distance < condition.nearest:
        approach(condition, context, distance, 0.0)


def share(condition: Condition) -> float:
    """Return the distance of a condition from changing as a share of 1, never 0."""
    distance = condition.distance
    if distance < 0.0:
        distance = 0.0 - distance
    return max(distance / (distance + 1.0), 1e-9)


def record_change(
    condition: Condition, context: Context, truth: int, left: float, right: float
) -> None:
    """Record the begin of a series of evaluations, or a change of truth."""
    if context.tick != condition.next_tick:
        context.record.series(condition.probe, rows.PROBE_EVALUATED, condition.next_tick)
    if truth == condition.truth or context.fault:
        return
    condition.truth = truth
    if truth == codes.TRUE:
        condition.was_ever_true = True
    else:
        condition.was_ever_false = True
    if condition.was_ever_true and condition.was_ever_false:
        condition.nearest = -1.0
    context.record.probe(condition.probe, truth, left, right)


def approach(condition: Condition, context: Context, left: float, right: float) -> None:
    """Keep sides that are nearer to each other than ever before."""
    if context.fault:
        return
    distance = left - right
    if distance < 0.0:
        distance = 0.0 - distance
    condition.nearest = distance
    condition.nearest_left = left
    condition.nearest_right = right
    condition.nearest_tick = context.tick


class Comparison(Condition):
    """Base of the comparisons of two expressions."""

    def __init__(self, left: Expression, right: Expression) -> None:
        super().__init__()
        self.left = left
        self.right = right

    def sides(self, context: Context) -> tuple[float, float]:
        return self.left.measure(context), self.right.measure(context)


class CellComparison(Condition):
    """Base of the comparisons of a variable with a number (fused)."""

    def __init__(self, load: Load, number: float) -> None:
        super().__init__()
        self.load = load
        self.cell = load.cell
        self.number = number

    def sides(self, context: Context) -> tuple[float, float]:
        return self.load.measure(context), self.number


class IsTrue(Condition):
    """Any other expression: true from a magnitude of 0.5 on; not finite is 50879 (RC-207)."""

    def __init__(self, operand: Expression) -> None:
        super().__init__()
        self.operand = operand

    def sides(self, context: Context) -> tuple[float, float]:
        return self.operand.measure(context), 0.5

    def decide(self, context: Context) -> int:
        value = self.operand.value(context)
        if value - value != 0.0:
            context.fail(50879, 0, 0.0, value)
            return 0
        truth = 1 if arithmetic.is_true(value) else 0
        note(self, context, truth, value, 0.5)
        return truth


class IsTruePart(IsTrue):
    """An operand of ``&&`` or ``||``, which may be infinite as in an expression."""

    def decide(self, context: Context) -> int:
        value = self.operand.value(context)
        truth = 1 if arithmetic.is_true(value) else 0
        note(self, context, truth, value, 0.5)
        return truth


class IsTextTrue(IsTrue):
    """A comparison of texts: its two sides are not recorded."""


class Combination(Condition):
    """Base of a combination of two conditions, both of which are evaluated (RC-501).

    ``beside_first``: the least distance of the second operand while only the first was as ``&&``
    (true) or ``||`` (false) requires of both; ``beside_second`` the reverse.
    """

    def __init__(self, first: Condition, second: Condition) -> None:
        super().__init__()
        self.first = first
        self.second = second
        self.beside_first = 1.7976931348623157e308
        self.beside_second = 1.7976931348623157e308

    def forget(self) -> None:
        self.truth = codes.UNKNOWN
        self.first.forget()
        self.second.forget()


def far(combination: Combination, first_holds: bool, second_holds: bool) -> float:
    """Return how far a combination is from changing.

    An operand *holds* if it is as ``&&`` (true) or ``||`` (false) requires of both: if both hold,
    one is enough to change the combination, else each one that does not hold has to change.
    """
    if first_holds and second_holds:
        return min(share(combination.first), share(combination.second))
    first = 0.0
    if not first_holds:
        first = share(combination.first)
        if second_holds and first < combination.beside_second:
            combination.beside_second = first
    second = 0.0
    if not second_holds:
        second = share(combination.second)
        if first_holds and second < combination.beside_first:
            combination.beside_first = second
    return first + second


class Both(Combination):
    """``first && second``."""

    def decide(self, context: Context) -> int:
        first = self.first.decide(context)
        second = self.second.decide(context)
        truth = 1 if first == codes.TRUE and second == codes.TRUE else 0
        note_combination(self, context, truth, far(self, first == codes.TRUE, second == codes.TRUE))
        return truth


class Either(Combination):
    """``first || second``."""

    def decide(self, context: Context) -> int:
        first = self.first.decide(context)
        second = self.second.decide(context)
        truth = 1 if codes.TRUE in (first, second) else 0
        note_combination(self, context, truth, far(self, first != codes.TRUE, second != codes.TRUE))
        return truth


class IsLess(Comparison):
    """``left < right``."""

    def decide(self, context: Context) -> int:
        left = self.left.value(context)
        right = self.right.value(context)
        truth = 1 if left < right else 0
        note(self, context, truth, left, right)
        return truth


class IsLessCellConstant(CellComparison):
    """Variable ``<`` number."""

    def decide(self, context: Context) -> int:
        left = context.cells[self.cell]
        truth = 1 if left < self.number else 0
        note(self, context, truth, left, self.number)
        return truth


class IsLessEqual(Comparison):
    """``left <= right``."""

    def decide(self, context: Context) -> int:
        left = self.left.value(context)
        right = self.right.value(context)
        truth = 1 if left <= right else 0
        note(self, context, truth, left, right)
        return truth


class IsLessEqualCellConstant(CellComparison):
    """Variable ``<=`` number."""

    def decide(self, context: Context) -> int:
        left = context.cells[self.cell]
        truth = 1 if left <= self.number else 0
        note(self, context, truth, left, self.number)
        return truth


class IsGreater(Comparison):
    """``left > right``."""

    def decide(self, context: Context) -> int:
        left = self.left.value(context)
        right = self.right.value(context)
        truth = 1 if left > right else 0
        note(self, context, truth, left, right)
        return truth


class IsGreaterCellConstant(CellComparison):
    """Variable ``>`` number."""

    def decide(self, context: Context) -> int:
        left = context.cells[self.cell]
        truth = 1 if left > self.number else 0
        note(self, context, truth, left, self.number)
        return truth


class IsGreaterEqual(Comparison):
    """``left >= right``."""

    def decide(self, context: Context) -> int:
        left = self.left.value(context)
        right = self.right.value(context)
        truth = 1 if left >= right else 0
        note(self, context, truth, left, right)
        return truth


class IsGreaterEqualCellConstant(CellComparison):
    """Variable ``>=`` number."""

    def decide(self, context: Context) -> int:
        left = context.cells[self.cell]
        truth = 1 if left >= self.number else 0
        note(self, context, truth, left, self.number)
        return truth


class IsEqual(Comparison):
    """``left == right``."""

    def decide(self, context: Context) -> int:
        left = self.left.value(context)
        right = self.right.value(context)
        truth = 1 if left == right else 0
        note(self, context, truth, left, right)
        return truth


class IsEqualCellConstant(CellComparison):
    """Variable ``==`` number."""

    def decide(self, context: Context) -> int:
        left = context.cells[self.cell]
        truth = 1 if left == self.number else 0
        note(self, context, truth, left, self.number)
        return truth


class IsNotEqual(Comparison):
    """``left != right``."""

    def decide(self, context: Context) -> int:
        left = self.left.value(context)
        right = self.right.value(context)
        truth = 1 if left != right else 0
        note(self, context, truth, left, right)
        return truth


class IsNotEqualCellConstant(CellComparison):
    """Variable ``!=`` number."""

    def decide(self, context: Context) -> int:
        left = context.cells[self.cell]
        truth = 1 if left != self.number else 0
        note(self, context, truth, left, self.number)
        return truth

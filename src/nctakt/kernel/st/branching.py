# SPDX-License-Identifier: MIT
"""``IF``, ``CASE`` and loops (ST-511 … ST-513)."""

from __future__ import annotations

from itertools import pairwise

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, leaves, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.steps import Sourced, Step
from nctakt.kernel.st.wholes import Whole


class Alternative(Sourced):
    """A branch of ``IF``; without others it is the whole statement."""

    def __init__(self, condition: Whole, body: Step, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.condition = condition
        self.body = body

    def attempt(self, context: PlcContext) -> int:
        """Run the body if the condition holds; return how it ends, or that it is not taken."""
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        truth = leaves.value_of(self.condition, context)
        if context.fault:
            return context.stop_at(self.source)
        return self.body.run(context) if truth else kinds.NOT_TAKEN

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        truth = leaves.value_of(self.condition, context)
        if context.fault:
            return context.stop_at(self.source)
        return self.body.run(context) if truth else kinds.GOES_ON


class EitherOr(Alternative):
    """``IF … ELSE``: both sides."""

    def __init__(
        self, condition: Whole, body: Step, otherwise: Step, source: int, cost: int
    ) -> None:
        super().__init__(condition, body, source, cost)
        self.otherwise = otherwise

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        truth = leaves.value_of(self.condition, context)
        if context.fault:
            return context.stop_at(self.source)
        return self.body.run(context) if truth else self.otherwise.run(context)


class AlternativePair(Alternative):
    """Two branches or groups of branches, of which at most one is taken."""

    def __init__(self, first: Alternative, second: Alternative) -> None:
        super().__init__(Whole(), Step(), 0, 0)
        self.first = first
        self.second = second

    def attempt(self, context: PlcContext) -> int:
        end = self.first.attempt(context)
        return end if end != kinds.NOT_TAKEN else self.second.attempt(context)

    def run(self, context: PlcContext) -> int:
        end = self.attempt(context)
        return kinds.GOES_ON if end == kinds.NOT_TAKEN else end


class Alternatives(Step):
    """``IF`` with ``ELSIF``."""

    def __init__(self, branches: Alternative, otherwise: Step) -> None:
        self.branches = branches
        self.otherwise = otherwise

    def run(self, context: PlcContext) -> int:
        end = self.branches.attempt(context)
        return self.otherwise.run(context) if end == kinds.NOT_TAKEN else end


def alternatives(branches: list[Alternative]) -> Alternative:
    """Tie branches, no deeper than their number's logarithm."""
    if len(branches) < 2:
        return branches[0]
    middle = len(branches) // 2
    return AlternativePair(alternatives(branches[:middle]), alternatives(branches[middle:]))


class Choices:
    """The labels of ``CASE`` as a tree; the null object: no label fits."""

    def choose(self, context: PlcContext, selector: int) -> int:
        """Run the body of the label that fits; return how it ends, or that none fits."""
        return kinds.NOT_TAKEN


class Choice(Choices):
    """A range of labels with its body, between those that are less and those that are greater."""

    def __init__(
        self, lowest: int, highest: int, body: Step, less: Choices, greater: Choices
    ) -> None:
        check_range(lowest, -(1 << 63), highest, "label")
        check_range(highest, lowest, (1 << 63) - 1, "label")
        self.lowest = lowest
        self.highest = highest
        self.body = body
        self.less = less
        self.greater = greater

    def choose(self, context: PlcContext, selector: int) -> int:
        if selector < self.lowest:
            return self.less.choose(context, selector)
        if selector > self.highest:
            return self.greater.choose(context, selector)
        return self.body.run(context)


def choices(ranges: list[tuple[int, int, Step]]) -> Choices:
    """Tie ranges of labels that do not overlap; raise ``ValueError`` where they do."""
    ordered = sorted(ranges, key=lambda one: one[0])
    for (_, highest, _), (lowest, _, _) in pairwise(ordered):
        check_range(lowest, highest + 1, 1 << 63, "label")
    return _tied(ordered)


def _tied(ordered: list[tuple[int, int, Step]]) -> Choices:
    if not ordered:
        return Choices()
    middle = len(ordered) // 2
    lowest, highest, body = ordered[middle]
    return Choice(lowest, highest, body, _tied(ordered[:middle]), _tied(ordered[middle + 1 :]))


class Case(Sourced):
    """``CASE``: the label that fits, without a fall-through (ST-511)."""

    def __init__(
        self, selector: Whole, labels: Choices, otherwise: Step, source: int, cost: int
    ) -> None:
        super().__init__(source, cost)
        self.selector = selector
        self.labels = labels
        self.otherwise = otherwise

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        selector = leaves.value_of(self.selector, context)
        if context.fault:
            return context.stop_at(self.source)
        end = self.labels.choose(context, selector)
        return self.otherwise.run(context) if end == kinds.NOT_TAKEN else end


class For(Sourced):
    """``FOR``: start, end and step are evaluated once (ST-512).

    The variable wraps at its width; ``bias`` is the least 64-bit number where it is unsigned, so
    that signed comparisons order unsigned values.
    """

    def __init__(
        self,
        address: Whole,
        kind: int,
        start: Whole,
        end: Whole,
        step: Whole,
        body: Step,
        source: int,
        cost: int,
    ) -> None:
        super().__init__(source, cost)
        self.address = address
        self.kind = kind
        self.start = start
        self.end = end
        self.step = step
        self.body = body
        self.bias = -(1 << 63) if kind == kinds.U64 else 0

    def run(self, context: PlcContext) -> int:
        at = leaves.target_of(self.address, context)
        value = leaves.value_of(self.start, context)
        limit = leaves.value_of(self.end, context) ^ self.bias
        step = leaves.value_of(self.step, context)
        if step == 0:
            context.fail(kinds.STEP, 0, 0)
        if context.fault:
            return context.stop_at(self.source)
        words.store(context.memory, at, self.kind, value)
        value = words.wrap(value, self.kind)
        while True:
            context.steps += self.cost
            if context.steps > context.max_steps:
                return context.over_budget(self.source)
            value ^= self.bias
            if value > limit if step > 0 else value < limit:
                return kinds.GOES_ON
            end = self.body.run(context)
            if end and end != kinds.CONTINUES:
                return kinds.GOES_ON if end == kinds.EXITS else end
            value = words.add(words.load(context.memory, at, self.kind), step)
            words.store(context.memory, at, self.kind, value)
            value = words.wrap(value, self.kind)


class While(Sourced):
    """``WHILE``."""

    def __init__(self, condition: Whole, body: Step, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.condition = condition
        self.body = body

    def run(self, context: PlcContext) -> int:
        while True:
            context.steps += self.cost
            if context.steps > context.max_steps:
                return context.over_budget(self.source)
            truth = leaves.value_of(self.condition, context)
            if context.fault:
                return context.stop_at(self.source)
            if truth == 0:
                return kinds.GOES_ON
            end = self.body.run(context)
            if end and end != kinds.CONTINUES:
                return kinds.GOES_ON if end == kinds.EXITS else end


class Repeat(Sourced):
    """``REPEAT … UNTIL``."""

    def __init__(self, condition: Whole, body: Step, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.condition = condition
        self.body = body

    def run(self, context: PlcContext) -> int:
        while True:
            context.steps += self.cost
            if context.steps > context.max_steps:
                return context.over_budget(self.source)
            end = self.body.run(context)
            if end and end != kinds.CONTINUES:
                return kinds.GOES_ON if end == kinds.EXITS else end
            truth = leaves.value_of(self.condition, context)
            if context.fault:
                return context.stop_at(self.source)
            if truth:
                return kinds.GOES_ON

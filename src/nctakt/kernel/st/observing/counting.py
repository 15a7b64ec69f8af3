# SPDX-License-Identifier: MIT
"""How often conditions were true and false, and bodies ran; counted only on request.

The nodes wrap those of conditions and bodies; they cost no elementary instructions, so that
a run that counts does the same as one that does not.
"""

from __future__ import annotations

from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.steps import Step
from nctakt.kernel.st.wholes import Whole


class CountedTruth(Whole):
    """A condition: counts ``number`` when it is true, the next number when it is false."""

    def __init__(self, operand: Whole, number: int) -> None:
        check_range(number, 0, kinds.MAX_COUNTS - 2, "number")
        self.operand = operand
        self.number = number

    def value(self, context: PlcContext) -> int:
        value = self.operand.value(context)
        if context.fault == 0:
            context.count(self.number if value else self.number + 1)
        return value


class SeenWhole(Whole):
    """A side of a comparison that is counted: its value is noted."""

    def __init__(self, operand: Whole, is_left: bool, is_unsigned: bool) -> None:
        self.operand = operand
        self.is_left = is_left
        self.is_unsigned = is_unsigned

    def value(self, context: PlcContext) -> int:
        value = self.operand.value(context)
        seen = value + 0.0
        if self.is_unsigned and value < 0:
            seen = words.real_of_unsigned(value)
        if self.is_left:
            context.seen_left = seen
        else:
            context.seen_right = seen
        return value


class SeenReal(Real):
    """A side of a comparison of real numbers that is counted: its value is noted."""

    def __init__(self, operand: Real, is_left: bool) -> None:
        self.operand = operand
        self.is_left = is_left

    def number(self, context: PlcContext) -> float:
        seen = self.operand.number(context)
        if self.is_left:
            context.seen_left = seen
        else:
            context.seen_right = seen
        return seen


class ComparedTruth(CountedTruth):
    """A comparison whose sides are noted, and how near it came to the result it never had."""

    def value(self, context: PlcContext) -> int:
        value = self.operand.value(context)
        if context.fault == 0:
            context.count(self.number if value else self.number + 1)
            context.approach(self.number, value)
        return value


class SeenSelector(Whole):
    """The selector of ``CASE``: how near it came to the labels of bodies that never ran.

    ``labels``: lowest and highest label of a range and the number of its body, one after another.
    """

    def __init__(
        self, operand: Whole, is_unsigned: bool, labels: list[tuple[float, float, int]]
    ) -> None:
        self.operand = operand
        self.is_unsigned = is_unsigned
        self.count = len(labels)
        self.lowest = doubles(self.count + 1)
        self.highest = doubles(self.count + 1)
        self.numbers = integers(self.count + 1)
        for index, (lowest, highest, number) in enumerate(labels):
            check_range(number, 0, kinds.MAX_COUNTS - 1, "number")
            self.lowest[index] = lowest
            self.highest[index] = highest
            self.numbers[index] = number

    def value(self, context: PlcContext) -> int:
        value = self.operand.value(context)
        if context.fault:
            return value
        seen = value + 0.0
        if self.is_unsigned and value < 0:
            seen = words.real_of_unsigned(value)
        for i in range(self.count):
            if self.numbers[i] >= context.count_end or context.counts[self.numbers[i]]:
                continue
            if seen < self.lowest[i]:
                context.note_near(self.numbers[i], seen, self.lowest[i])
            elif seen > self.highest[i]:
                context.note_near(self.numbers[i], seen, self.highest[i])
        return value


class CountedStep(Step):
    """A body: counts ``number`` each time when it begins."""

    def __init__(self, body: Step, number: int) -> None:
        check_range(number, 0, kinds.MAX_COUNTS - 1, "number")
        self.body = body
        self.number = number

    def run(self, context: PlcContext) -> int:
        context.count(self.number)
        return self.body.run(context)

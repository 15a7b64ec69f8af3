# SPDX-License-Identifier: MIT
"""Texts of PLC code: compared, assigned, put together in their places (ST-310, ST-711).

A text is an address and the number of bytes that its variable holds at most; it ends before the
first zero byte. A function puts its result into the caller's frame, at most ``kinds.MAX_TEXT``
bytes.
"""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, wholes, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.steps import Sourced
from nctakt.kernel.st.wholes import Whole


class StringPart:
    """A text: where it begins, and how many bytes it has at most."""

    def __init__(self, address: Whole, capacity: int) -> None:
        check_range(capacity, 0, kinds.MAX_MEMORY, "capacity")
        self.address = address
        self.capacity = capacity

    def begin(self, context: PlcContext) -> int:
        """Return where the text begins."""
        return context.checked(self.address.value(context), self.capacity)

    def length(self, context: PlcContext, begin: int) -> int:
        """Return the number of bytes of the text, which begins there."""
        return words.length(context.memory, begin, self.capacity)


class AssignString(Sourced):
    """An assignment: what is longer than the target is cut off (ST-310)."""

    def __init__(
        self, address: Whole, capacity: int, text: StringPart, source: int, cost: int
    ) -> None:
        check_range(capacity, 0, kinds.MAX_MEMORY, "capacity")
        super().__init__(source, cost)
        self.address = address
        self.capacity = capacity
        self.text = text

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        to = context.checked_target(self.address.value(context), self.capacity + 1)
        begin = self.text.begin(context)
        if context.fault:
            return context.stop_at(self.source)
        count = min(self.text.length(context, begin), self.capacity)
        context.steps += count >> 3
        words.copy(context.memory, to, begin, count)
        words.fill(context.memory, to + count, 1, 0)
        return kinds.GOES_ON


class CompareStrings(Whole):
    """A relation of two texts, byte by byte."""

    def __init__(self, left: StringPart, right: StringPart, relation: int) -> None:
        self.left = left
        self.right = right
        self.relation = relation

    def value(self, context: PlcContext) -> int:
        left = self.left.begin(context)
        right = self.right.begin(context)
        if context.fault:
            return 0
        left_count = self.left.length(context, left)
        right_count = self.right.length(context, right)
        order = words.compare(context.memory, left, right, min(left_count, right_count))
        if order == 0:
            order = left_count - right_count
        return wholes.holds(self.relation, order, 0)


class LengthOfString(Whole):
    """``LEN``."""

    def __init__(self, text: StringPart) -> None:
        self.text = text

    def value(self, context: PlcContext) -> int:
        begin = self.text.begin(context)
        return 0 if context.fault else self.text.length(context, begin)


class FindString(Whole):
    """``FIND``: the first address of the second text in the first one, from 1; 0: none."""

    def __init__(self, text: StringPart, searched: StringPart) -> None:
        self.text = text
        self.searched = searched

    def value(self, context: PlcContext) -> int:
        begin = self.text.begin(context)
        searched = self.searched.begin(context)
        if context.fault:
            return 0
        count = self.searched.length(context, searched)
        last = self.text.length(context, begin) - count
        if count == 0:
            return 0
        for i in range(last + 1):
            if words.compare(context.memory, begin + i, searched, count) == 0:
                return i + 1
        return 0


def join(
    context: PlcContext, to: int, first: int, first_count: int, second: int, second_count: int
) -> int:
    """Put two runs of bytes one after the other, cut at the longest text; return their count."""
    count = min(first_count, kinds.MAX_TEXT)
    words.copy(context.memory, to, first, count)
    added = min(second_count, kinds.MAX_TEXT - count)
    words.copy(context.memory, to + count, second, added)
    return count + added


class ChangeString(Whole):
    """``CONCAT``, ``INSERT``, ``DELETE`` and ``REPLACE``: a text with a part of it replaced.

    ``kept`` is where the frame keeps the result. Positions count from 1; what lies outside of the
    text takes nothing away (ST-711).
    """

    def __init__(
        self,
        text: StringPart,
        inserted: StringPart,
        length: Whole,
        position: Whole,
        function: int,
        kept: int,
    ) -> None:
        check_range(function, kinds.CONCAT, kinds.REPLACE, "function")
        self.text = text
        self.inserted = inserted
        self.length = length
        self.position = position
        self.function = function
        self.kept = kept

    def value(self, context: PlcContext) -> int:
        kept = context.checked_target(context.frame + self.kept, kinds.TEXT_BYTES)
        begin = self.text.begin(context)
        inserted = self.inserted.begin(context)
        removed = self.length.value(context)
        position = self.position.value(context)
        if context.fault:
            return kept
        context.steps += 16
        count = min(self.text.length(context, begin), kinds.MAX_TEXT)
        added = self.inserted.length(context, inserted)
        if self.function == kinds.CONCAT:
            head = count
        elif self.function == kinds.INSERT:
            head = min(max(position, 0), count)
        else:
            head = min(max(position, 1) - 1, count)
        removed = min(max(removed, 0), count - head)
        total = join(context, kept, begin, head, inserted, added)
        rest = min(count - head - removed, kinds.MAX_TEXT - total)
        words.copy(context.memory, kept + total, begin + head + removed, rest)
        words.fill(context.memory, kept + total + rest, 1, 0)
        return kept


class PartOfString(Whole):
    """``LEFT``, ``RIGHT`` and ``MID``: a part of a text."""

    def __init__(
        self, text: StringPart, length: Whole, position: Whole, function: int, kept: int
    ) -> None:
        check_range(function, kinds.LEFT, kinds.MID, "function")
        self.text = text
        self.length = length
        self.position = position
        self.function = function
        self.kept = kept

    def value(self, context: PlcContext) -> int:
        kept = context.checked_target(context.frame + self.kept, kinds.TEXT_BYTES)
        begin = self.text.begin(context)
        taken = max(self.length.value(context), 0)
        position = self.position.value(context)
        if context.fault:
            return kept
        context.steps += 16
        count = min(self.text.length(context, begin), kinds.MAX_TEXT)
        head = 0
        if self.function == kinds.RIGHT:
            head = max(count - taken, 0)
        elif self.function == kinds.MID:
            head = min(max(position, 1) - 1, count)
        taken = min(taken, count - head)
        words.copy(context.memory, kept, begin + head, taken)
        words.fill(context.memory, kept + taken, 1, 0)
        return kept

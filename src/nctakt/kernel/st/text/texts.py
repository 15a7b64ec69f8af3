# SPDX-License-Identifier: MIT
"""Texts of PLC code: compared, assigned, put together in their places (ST-310, ST-711).

A text is an address and the number of characters that its variable holds at most; a character is
one byte, of a WSTRING two; the text ends before the first zero character. A function puts its
result into the caller's frame, at most ``kinds.MAX_TEXT`` characters.
"""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, wholes, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.steps import Sourced
from nctakt.kernel.st.text import characters
from nctakt.kernel.st.wholes import Whole


class StringPart:
    """A text: where it begins, how many characters it has at most, and the bytes of one."""

    def __init__(self, address: Whole, capacity: int, unit: int = 1) -> None:
        check_range(capacity, 0, kinds.MAX_MEMORY >> 1, "capacity")
        check_range(unit, 1, 2, "unit")
        self.address = address
        self.capacity = capacity
        self.unit = unit

    def begin(self, context: PlcContext) -> int:
        """Return where the text begins."""
        return context.checked(self.address.value(context), self.capacity * self.unit)

    def length(self, context: PlcContext, begin: int) -> int:
        """Return the number of characters of the text, which begins there."""
        if self.unit > 1:
            return words.length_wide(context.memory, begin, self.capacity)
        return words.length(context.memory, begin, self.capacity)


class ChosenText(StringPart):
    """A text of which only the address says which variable it is: it ends with its zero."""

    def begin(self, context: PlcContext) -> int:
        return context.checked(self.address.value(context), self.unit)

    def length(self, context: PlcContext, begin: int) -> int:
        count = min(self.capacity, words.divide(context.end - begin, self.unit))
        if self.unit > 1:
            return words.length_wide(context.memory, begin, count)
        return words.length(context.memory, begin, count)


class AssignString(Sourced):
    """An assignment: a text longer than the target is cut off (ST-310)."""

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
        unit = self.text.unit
        to = context.checked_target(self.address.value(context), (self.capacity + 1) * unit)
        begin = self.text.begin(context)
        if context.fault:
            return context.stop_at(self.source)
        count = unit * min(self.text.length(context, begin), self.capacity)
        context.steps += count >> 3
        words.copy(context.memory, to, begin, count)
        words.fill(context.memory, to + count, unit, 0)
        if context.is_noting:
            context.wrote_bytes(to, count + unit, self.source)
        return kinds.GOES_ON


def order_of(
    context: PlcContext, left: StringPart, first: int, right: StringPart, second: int
) -> int:
    """Return whether a text comes before, with or after another: negative, 0, positive."""
    left_count = left.length(context, first)
    right_count = right.length(context, second)
    count = min(left_count, right_count)
    if left.unit > 1:
        order = words.compare_wide(context.memory, first, second, count)
    else:
        order = words.compare(context.memory, first, second, count)
    return order if order else left_count - right_count


class CompareStrings(Whole):
    """A relation of two texts, character by character."""

    def __init__(self, left: StringPart, right: StringPart, relation: int) -> None:
        self.left = left
        self.right = right
        self.relation = relation

    def value(self, context: PlcContext) -> int:
        left = self.left.begin(context)
        right = self.right.begin(context)
        if context.fault:
            return 0
        order = order_of(context, self.left, left, self.right, right)
        return wholes.holds(self.relation, order, 0)


class ExtremeText(Whole):
    """``MIN`` or ``MAX`` of two texts: the address of the one."""

    def __init__(self, left: StringPart, right: StringPart, is_maximum: bool) -> None:
        self.left = left
        self.right = right
        self.is_maximum = is_maximum

    def value(self, context: PlcContext) -> int:
        left = self.left.begin(context)
        right = self.right.begin(context)
        if context.fault:
            return left
        order = order_of(context, self.left, left, self.right, right)
        if self.is_maximum:
            return right if order < 0 else left
        return left if order < 0 else right


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
        unit = self.text.unit
        count = self.searched.length(context, searched)
        last = self.text.length(context, begin) - count
        if count == 0:
            return 0
        for i in range(last + 1):
            if words.compare(context.memory, begin + i * unit, searched, count * unit) == 0:
                return i + 1
        return 0


def join(
    context: PlcContext,
    to: int,
    first: int,
    first_count: int,
    second: int,
    second_count: int,
    unit: int,
) -> int:
    """Put two runs of characters in order, cut at the longest text; return their count."""
    count = min(first_count, kinds.MAX_TEXT)
    words.copy(context.memory, to, first, count * unit)
    added = min(second_count, kinds.MAX_TEXT - count)
    words.copy(context.memory, to + count * unit, second, added * unit)
    return count + added


class ChangeString(Whole):
    """``CONCAT``, ``INSERT``, ``DELETE`` and ``REPLACE``: a text with a part of it replaced.

    ``kept`` is where the frame keeps the result. Positions count from 1; positions outside the text
    delete nothing (ST-711).
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
        unit = self.text.unit
        kept = context.checked_target(context.frame + self.kept, kinds.TEXT_BYTES * unit)
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
        total = join(context, kept, begin, head, inserted, added, unit)
        rest = min(count - head - removed, kinds.MAX_TEXT - total)
        origin = begin + (head + removed) * unit
        words.copy(context.memory, kept + total * unit, origin, rest * unit)
        words.fill(context.memory, kept + (total + rest) * unit, unit, 0)
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
        unit = self.text.unit
        kept = context.checked_target(context.frame + self.kept, kinds.TEXT_BYTES * unit)
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
        words.copy(context.memory, kept, begin + head * unit, taken * unit)
        words.fill(context.memory, kept + taken * unit, unit, 0)
        return kept


class ResizedText(Whole):
    """A text with characters of the other size; anything outside Latin-1 becomes ``?`` (ST-307)."""

    def __init__(self, text: StringPart, kept: int) -> None:
        self.text = text
        self.kept = kept

    def value(self, context: PlcContext) -> int:
        unit = self.text.unit
        resized = 3 - unit
        kept = context.checked_target(context.frame + self.kept, kinds.TEXT_BYTES * resized)
        begin = self.text.begin(context)
        if context.fault:
            return kept
        context.steps += 16
        count = min(self.text.length(context, begin), kinds.MAX_TEXT)
        for i in range(count):
            if unit > 1:
                character = words.load(context.memory, begin + 2 * i, kinds.U16)
                if character > characters.LATIN_LAST:
                    character = characters.QUESTION
                words.store(context.memory, kept + i, kinds.U8, character)
            else:
                character = words.load(context.memory, begin + i, kinds.U8)
                words.store(context.memory, kept + 2 * i, kinds.U16, character)
        words.fill(context.memory, kept + count * resized, resized, 0)
        return kept

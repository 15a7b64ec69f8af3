# SPDX-License-Identifier: MIT
"""``MEMCPY``, ``MEMMOVE``, ``MEMSET`` and ``MEMCMP`` on checked places (ST-721)."""

from __future__ import annotations

from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.wholes import Whole


class MoveBytes(Whole):
    """``MEMCPY`` and ``MEMMOVE``: the number of bytes; 0 for a null address or no byte."""

    def __init__(self, to: Whole, origin: Whole, count: Whole) -> None:
        self.to = to
        self.origin = origin
        self.count = count

    def value(self, context: PlcContext) -> int:
        to = self.to.value(context)
        origin = self.origin.value(context)
        count = self.count.value(context)
        if to == 0 or origin == 0 or count == 0:
            return 0
        to = context.checked_target(to, count)
        origin = context.checked(origin, count)
        if context.fault:
            return 0
        context.steps += count >> 3
        words.copy(context.memory, to, origin, count)
        if context.is_noting:
            context.wrote_bytes(to, count, kinds.NOT_A_STATEMENT)
        return count


class FillBytes(Whole):
    """``MEMSET``: the number of bytes; 0 for a null address or no byte."""

    def __init__(self, to: Whole, filling: Whole, count: Whole) -> None:
        self.to = to
        self.filling = filling
        self.count = count

    def value(self, context: PlcContext) -> int:
        to = self.to.value(context)
        filling = self.filling.value(context)
        count = self.count.value(context)
        if to == 0 or count == 0:
            return 0
        to = context.checked_target(to, count)
        if context.fault:
            return 0
        context.steps += count >> 3
        words.fill(context.memory, to, count, filling & 255)
        if context.is_noting:
            context.wrote_bytes(to, count, kinds.NOT_A_STATEMENT)
        return count


class CompareBytes(Whole):
    """``MEMCMP``: -1, 0 or 1 by the first byte that differs."""

    def __init__(self, one: Whole, other: Whole, count: Whole) -> None:
        self.one = one
        self.other = other
        self.count = count

    def value(self, context: PlcContext) -> int:
        one = self.one.value(context)
        other = self.other.value(context)
        count = self.count.value(context)
        if one == 0 or other == 0 or count == 0:
            return 0
        one = context.checked(one, count)
        other = context.checked(other, count)
        if context.fault:
            return 0
        context.steps += count >> 3
        return words.compare(context.memory, one, other, count)

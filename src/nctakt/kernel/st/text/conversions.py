# SPDX-License-Identifier: MIT
"""Conversions between numbers and texts (ST-307, ST-308)."""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.text import characters, dates, digits
from nctakt.kernel.st.text.texts import StringPart
from nctakt.kernel.st.wholes import Whole


class StringOfWhole(Whole):
    """A whole number, a truth, a length of time or a date as a text."""

    def __init__(self, operand: Whole, form: int, width: int, kept: int) -> None:
        check_range(form, kinds.SIGNED, kinds.MOMENT, "form")
        check_range(width, 1, 64, "width")
        self.operand = operand
        self.form = form
        self.width = width
        self.kept = kept

    def value(self, context: PlcContext) -> int:
        kept = context.checked_target(context.frame + self.kept, kinds.TEXT_BYTES)
        value = self.operand.value(context)
        if context.fault:
            return kept
        context.steps += 16
        words.fill(context.memory, self.write(context, kept, value), 1, 0)
        return kept

    def write(self, context: PlcContext, at: int, value: int) -> int:
        """Write the value; return the address after it."""
        if self.form == kinds.SIGNED:
            return digits.put_signed(context, at, value)
        if self.form == kinds.UNSIGNED:
            return digits.put_unsigned(context, at, value, 10, 1)
        if self.form == kinds.HEXADECIMAL:
            return digits.put_unsigned(context, at, value, 16, self.width)
        if self.form == kinds.TRUTH:
            return put_truth(context, at, value)
        if self.form == kinds.LENGTH:
            return dates.put_length(context, at, value, False)
        if self.form == kinds.FINE_LENGTH:
            return dates.put_length(context, at, value, True)
        if self.form == kinds.CLOCK:
            return dates.put_moment(context, at, value, kinds.TIME_OF_DAY)
        if self.form == kinds.DAY:
            return dates.put_moment(context, at, value, kinds.DATE)
        return dates.put_moment(context, at, value, kinds.DATE_AND_TIME)


def put_truth(context: PlcContext, at: int, value: int) -> int:
    """Write ``TRUE`` or ``FALSE``."""
    if value:
        at = digits.put(context, digits.put(context, at, characters.LARGE_T), characters.LARGE_R)
        return digits.put(context, digits.put(context, at, characters.LARGE_U), characters.LARGE_E)
    at = digits.put(context, digits.put(context, at, characters.LARGE_F), characters.LARGE_A)
    at = digits.put(context, digits.put(context, at, characters.LARGE_L), characters.LARGE_S)
    return digits.put(context, at, characters.LARGE_E)


class StringOfReal(Whole):
    """A real number as a text."""

    def __init__(self, operand: Real, is_single: bool, kept: int) -> None:
        self.operand = operand
        self.is_single = is_single
        self.kept = kept

    def value(self, context: PlcContext) -> int:
        kept = context.checked_target(context.frame + self.kept, kinds.TEXT_BYTES)
        number = self.operand.number(context)
        if context.fault:
            return kept
        context.steps += 16
        end = digits.put_real(context, kept, number, self.is_single)
        words.fill(context.memory, end, 1, 0)
        return kept


class WholeOfString(Whole):
    """The whole number that a text spells, cut to its kind; ms of a length of time."""

    def __init__(self, text: StringPart, kind: int, is_length: bool, scale: int) -> None:
        check_range(scale, 1, 1000000, "scale")
        self.text = text
        self.kind = kind
        self.is_length = is_length
        self.scale = scale

    def value(self, context: PlcContext) -> int:
        begin = self.text.begin(context)
        if context.fault:
            return 0
        context.steps += 16
        end = begin + self.text.length(context, begin)
        if self.kind == kinds.BOOL:
            first = digits.skip_blanks(context, begin, end)
            return truth_at(context, first, end)
        if self.is_length:
            return whole_length(dates.read_length(context, begin, end), self.scale)
        return words.wrap(digits.read_whole(context, begin, end), self.kind)


def whole_length(length: float, scale: int) -> int:
    """Return a length of ms in ms or ns, cut down; 0 if it is too long."""
    scaled = length * scale + 0.0000001
    return int(scaled) if scaled < 9.0e18 else 0


def truth_at(context: PlcContext, at: int, end: int) -> int:
    """Return whether ``TRUE`` or a number that is not zero is there."""
    if end - at < 4:
        return 1 if digits.read_whole(context, at, end) else 0
    spelled = words.load(context.memory, at, kinds.U32) | characters.SMALL_LETTERS
    return 1 if spelled == characters.TRUE or digits.read_whole(context, at, end) else 0


class RealOfString(Real):
    """The real number that a text spells."""

    def __init__(self, text: StringPart) -> None:
        self.text = text

    def number(self, context: PlcContext) -> float:
        begin = self.text.begin(context)
        if context.fault:
            return 0.0
        context.steps += 16
        return digits.read_real(context, begin, begin + self.text.length(context, begin))


class MomentOfString(Whole):
    """The date, the time of day or both that a text spells."""

    def __init__(self, text: StringPart, shown: int) -> None:
        check_range(shown, kinds.TIME_OF_DAY, kinds.DATE_AND_TIME, "shown")
        self.text = text
        self.shown = shown

    def value(self, context: PlcContext) -> int:
        begin = self.text.begin(context)
        if context.fault:
            return 0
        context.steps += 16
        end = begin + self.text.length(context, begin)
        return dates.read_moment(context, begin, end, self.shown)

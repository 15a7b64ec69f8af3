# SPDX-License-Identifier: MIT
"""Lengths of time and dates written into texts (ST-307)."""

from __future__ import annotations

from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.text import characters, digits


def put_length(context: PlcContext, at: int, value: int, is_fine: bool) -> int:
    """Write a length of time of ms, or of ns: its units from the first that is not zero on."""
    if is_fine:
        at = digits.put(context, at, characters.LARGE_L)
    at = digits.put(context, at, characters.LARGE_T)
    if is_fine:
        at = digits.put(context, digits.put(context, at, characters.LARGE_I), characters.LARGE_M)
        at = digits.put(context, at, characters.LARGE_E)
    at = digits.put(context, at, characters.HASH)
    begin = at
    scale = 1000000 if is_fine else 1
    at = put_unit(context, at, value, 86400000 * scale, 0, characters.SMALL_D, 0)
    at = put_unit(context, at, value, 3600000 * scale, 24, characters.SMALL_H, 0)
    at = put_unit(context, at, value, 60000 * scale, 60, characters.SMALL_M, 0)
    at = put_unit(context, at, value, 1000 * scale, 60, characters.SMALL_S, 0)
    at = put_unit(context, at, value, scale, 1000, characters.SMALL_M, characters.SMALL_S)
    if is_fine:
        at = put_unit(context, at, value, 1000, 1000, characters.SMALL_U, characters.SMALL_S)
        at = put_unit(context, at, value, 1, 1000, characters.SMALL_N, characters.SMALL_S)
    if at == begin:
        at = digits.put(context, at, characters.ZERO)
        at = digits.put(context, digits.put(context, at, characters.SMALL_M), characters.SMALL_S)
    return at


def put_unit(
    context: PlcContext, at: int, value: int, unit: int, ring: int, first: int, second: int
) -> int:
    """Write the number of a unit, unless it is zero."""
    count = words.divide_unsigned(value, unit)
    if ring:
        count = words.modulo_unsigned(count, ring)
    if count == 0:
        return at
    at = digits.put(context, digits.put_unsigned(context, at, count, 10, 1), first)
    return digits.put(context, at, second) if second else at


def put_clock(context: PlcContext, at: int, seconds: int) -> int:
    """Write hours, minutes and seconds."""
    at = digits.put_unsigned(context, at, words.divide(seconds, 3600), 10, 2)
    at = digits.put(context, at, characters.COLON)
    at = digits.put_unsigned(context, at, words.modulo(words.divide(seconds, 60), 60), 10, 2)
    at = digits.put(context, at, characters.COLON)
    return digits.put_unsigned(context, at, words.modulo(seconds, 60), 10, 2)


def put_day(context: PlcContext, at: int, day: int) -> int:
    """Write a date by its days since 1970-01-01, in the Gregorian calendar."""
    # Years of a cycle of 400 begin in March, so that the leap day is the last one.
    shifted = day + 719468
    cycle = words.divide(shifted, 146097)
    inside = shifted - cycle * 146097
    leaps = words.divide(inside, 1460) + words.divide(inside, 146096)
    year = words.divide(inside - leaps + words.divide(inside, 36524), 365)
    rest = inside - (365 * year + words.divide(year, 4) - words.divide(year, 100))
    month = words.divide(5 * rest + 2, 153)
    number = rest - words.divide(153 * month + 2, 5) + 1
    month = month + 3 if month < 10 else month - 9
    year = year + cycle * 400 + (1 if month <= 2 else 0)
    at = digits.put(context, digits.put_unsigned(context, at, year, 10, 4), characters.MINUS)
    at = digits.put(context, digits.put_unsigned(context, at, month, 10, 2), characters.MINUS)
    return digits.put_unsigned(context, at, number, 10, 2)


def put_moment(context: PlcContext, at: int, value: int, shown: int) -> int:
    """Write ``TOD#``, ``D#`` or ``DT#``: ms of a day, or seconds since 1970-01-01."""
    at = digits.put(
        context, at, characters.LARGE_T if shown == kinds.TIME_OF_DAY else characters.LARGE_D
    )
    if shown == kinds.TIME_OF_DAY:
        at = digits.put(context, digits.put(context, at, characters.LARGE_O), characters.LARGE_D)
    elif shown == kinds.DATE_AND_TIME:
        at = digits.put(context, at, characters.LARGE_T)
    at = digits.put(context, at, characters.HASH)
    if shown == kinds.TIME_OF_DAY:
        at = put_clock(context, at, words.divide(value, 1000))
        rest = words.modulo(value, 1000)
        if rest == 0:
            return at
        return digits.put_unsigned(context, digits.put(context, at, characters.POINT), rest, 10, 3)
    at = put_day(context, at, words.divide(value, 86400))
    if shown == kinds.DATE:
        return at
    at = digits.put(context, at, characters.MINUS)
    return put_clock(context, at, words.modulo(value, 86400))


def read_length(context: PlcContext, at: int, end: int) -> float:
    """Return the ms of ``T#1h2m3.5s``; 0 of anything else."""
    at = digits.skip_prefix(context, digits.skip_blanks(context, at, end), end)
    total = 0.0
    while at < end and digits.digit_of(context, at, 10) >= 0:
        number = digits.read_real(context, at, end)
        at = digits.skip_digits(context, at, end)
        if at < end and words.load(context.memory, at, kinds.U8) == characters.POINT:
            at = digits.skip_digits(context, at + 1, end)
        unit = unit_at(context, at, end)
        total += number * unit
        at += 2 if unit < 2.0 else 1
    return total


def unit_at(context: PlcContext, at: int, end: int) -> float:
    """Return the ms of the unit that is there: d, h, m, s, ms, us, ns."""
    first = words.load(context.memory, at, kinds.U8) | characters.SMALL if at < end else 0
    second = words.load(context.memory, at + 1, kinds.U8) | characters.SMALL if at + 1 < end else 0
    if first == characters.SMALL_M and second == characters.SMALL_S:
        return 1.0
    if first == characters.SMALL_U and second == characters.SMALL_S:
        return 0.001
    if first == characters.SMALL_N and second == characters.SMALL_S:
        return 0.000001
    if first == characters.SMALL_D:
        return 86400000.0
    if first == characters.SMALL_H:
        return 3600000.0
    if first == characters.SMALL_M:
        return 60000.0
    return 1000.0 if first == characters.SMALL_S else 0.0


def number_at(context: PlcContext, at: int, end: int) -> int:
    """Return the decimal number that begins there, -1 without a digit."""
    if at >= end or digits.digit_of(context, at, 10) < 0:
        return -1
    return min(digits.read_digits(context, at, min(end, at + 9), 10), 999999)


def day_of(year: int, month: int, day: int) -> int:
    """Return the days from 1970-01-01 to a date of the Gregorian calendar."""
    # Years begin in March, so that the leap day is the last one.
    if month <= 2:
        year -= 1
    shifted = month - 3 if month > 2 else month + 9
    rest = words.divide(153 * shifted + 2, 5) + day - 1
    leaps = words.divide(year, 4) - words.divide(year, 100) + words.divide(year, 400)
    return 365 * year + leaps + rest - 719468


def read_moment(context: PlcContext, at: int, end: int, shown: int) -> int:
    """Return the value of a ``D#``, ``DT#`` or ``TOD#`` literal, with or without prefix; else 0."""
    at = digits.skip_prefix(context, digits.skip_blanks(context, at, end), end)
    seconds = 0
    if shown != kinds.TIME_OF_DAY:
        year = number_at(context, at, end)
        at = digits.skip_digits(context, at, end) + 1
        month = number_at(context, at, end)
        at = digits.skip_digits(context, at, end) + 1
        day = number_at(context, at, end)
        at = digits.skip_digits(context, at, end) + 1
        if year < 1970 or year > 2106 or month < 1 or month > 12 or day < 1 or day > 31:
            return 0
        seconds = 86400 * day_of(year, month, day)
        if shown == kinds.DATE:
            return seconds
    hour = number_at(context, at, end)
    at = digits.skip_digits(context, at, end) + 1
    minute = number_at(context, at, end)
    at = digits.skip_digits(context, at, end) + 1
    if hour < 0 or hour > 23 or minute < 0 or minute > 59:
        return 0
    seconds += 3600 * hour + 60 * minute
    whole = max(number_at(context, at, end), 0)
    if whole > 59:
        return 0
    if shown == kinds.DATE_AND_TIME:
        return seconds + whole
    part = digits.read_real(context, at, end) if at < end else 0.0
    if part >= 60.0:
        return 0
    return 1000 * seconds + words.unsigned_of_real(part * 1000.0 + 0.5)

# SPDX-License-Identifier: MIT
"""Numbers written into texts, and read from them (ST-307, ST-308).

A writer puts bytes into the memory and returns the address after them; the caller provides room for
``kinds.TEXT_BYTES``.
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.text import characters


def put(context: PlcContext, at: int, character: int) -> int:
    """Write a character."""
    words.store(context.memory, at, kinds.U8, character)
    return at + 1


def put_unsigned(context: PlcContext, at: int, value: int, base: int, width: int) -> int:
    """Write an unsigned number with at least ``width`` digits."""
    count = 1
    rest = words.divide_unsigned(value, base)
    while rest != 0 or count < width:
        rest = words.divide_unsigned(rest, base)
        count += 1
    for i in range(count):
        digit = words.modulo_unsigned(value, base)
        value = words.divide_unsigned(value, base)
        put(
            context,
            at + count - 1 - i,
            digit + (characters.ZERO if digit < 10 else characters.LARGE_A - 10),
        )
    return at + count


def put_signed(context: PlcContext, at: int, value: int) -> int:
    """Write a signed number."""
    if value < 0:
        at = put(context, at, characters.MINUS)
        value = words.subtract(0, value)
    return put_unsigned(context, at, value, 10, 1)


def put_special(context: PlcContext, at: int, value: float) -> int:
    """Write an infinite value or NaN: ``#INF``, ``-#INF``, ``#NAN``."""
    if value < 0.0:
        at = put(context, at, characters.MINUS)
    at = put(context, at, characters.HASH)
    if value != value:
        at = put(context, put(context, at, characters.LARGE_N), characters.LARGE_A)
        return put(context, at, characters.LARGE_N)
    at = put(context, put(context, at, characters.LARGE_I), characters.LARGE_N)
    return put(context, at, characters.LARGE_F)


def put_real(context: PlcContext, at: int, value: float, is_single: bool) -> int:
    """Write a real number as short as it reads back, with at least one decimal (ST-308)."""
    if not arithmetic.is_finite(value):
        return put_special(context, at, value)
    if value < 0.0:
        at = put(context, at, characters.MINUS)
        value = -value
    # d.ddde+xx is written farther on, and taken apart there.
    spelled = at + 64
    count = words.decimal(context.memory, spelled, value, is_single)
    mark = 0
    while words.load(context.memory, spelled + mark, kinds.U8) != characters.SMALL_E:
        mark += 1
    exponent = 0
    for i in range(mark + 2, count):
        exponent = (
            10 * exponent + words.load(context.memory, spelled + i, kinds.U8) - characters.ZERO
        )
    if words.load(context.memory, spelled + mark + 1, kinds.U8) == characters.MINUS:
        exponent = -exponent
    digits = max(mark - 1, 1)
    if mark > 1:
        words.copy(context.memory, spelled + 1, spelled + 2, digits - 1)
    if exponent < characters.MIN_EXPONENT or exponent >= characters.FIRST_EXPONENT:
        return put_scientific(context, at, spelled, digits, exponent)
    return put_plain(context, at, spelled, digits, exponent)


def put_scientific(context: PlcContext, at: int, spelled: int, digits: int, exponent: int) -> int:
    """Write digits with an exponent: ``1E+20``, ``1.5E-07``."""
    words.copy(context.memory, at, spelled, 1)
    at += 1
    if digits > 1:
        at = put(context, at, characters.POINT)
        words.copy(context.memory, at, spelled + 1, digits - 1)
        at += digits - 1
    at = put(context, at, characters.LARGE_E)
    at = put(context, at, characters.MINUS if exponent < 0 else characters.PLUS)
    return put_unsigned(context, at, -exponent if exponent < 0 else exponent, 10, 2)


def put_plain(context: PlcContext, at: int, spelled: int, digits: int, exponent: int) -> int:
    """Write digits without an exponent: ``12.5``, ``100.0``, ``0.001``."""
    taken = 0
    if exponent < 0:
        at = put(context, at, characters.ZERO)
    for _ in range(exponent + 1):
        at = put(
            context,
            at,
            words.load(context.memory, spelled + taken, kinds.U8)
            if taken < digits
            else characters.ZERO,
        )
        taken += 1
    at = put(context, at, characters.POINT)
    for _ in range(-1 - exponent):
        at = put(context, at, characters.ZERO)
    if taken >= digits:
        return put(context, at, characters.ZERO)
    words.copy(context.memory, at, spelled + taken, digits - taken)
    return at + digits - taken


def digit_of(context: PlcContext, at: int, base: int) -> int:
    """Return the value of a digit, -1 if it is not one."""
    character = words.load(context.memory, at, kinds.U8)
    if character > 96:
        character -= 32
    digit = (
        character - characters.ZERO
        if character <= characters.NINE
        else character - characters.LARGE_A + 10
    )
    if character > characters.NINE and character < characters.LARGE_A:
        return -1
    return digit if 0 <= digit < base else -1


def skip_blanks(context: PlcContext, at: int, end: int) -> int:
    """Return the address of the first character that is not a blank."""
    while at < end and words.load(context.memory, at, kinds.U8) == characters.BLANK:
        at += 1
    return at


def skip_prefix(context: PlcContext, at: int, end: int) -> int:
    """Return the address after ``INT#`` and the like."""
    i = at
    while i < end and words.load(context.memory, i, kinds.U8) > characters.NINE:
        i += 1
    return i + 1 if i < end and words.load(context.memory, i, kinds.U8) == characters.HASH else at


def read_digits(context: PlcContext, at: int, end: int, base: int) -> int:
    """Return the whole number that begins there; digits may have ``_`` between them."""
    value = 0
    while at < end:
        digit = digit_of(context, at, base)
        if digit >= 0:
            value = words.add(words.multiply(value, base), digit)
        elif words.load(context.memory, at, kinds.U8) != characters.UNDERSCORE:
            break
        at += 1
    return value


def skip_digits(context: PlcContext, at: int, end: int) -> int:
    """Return the address after the decimal digits that begin there."""
    while at < end:
        if digit_of(context, at, 10) < 0:
            if words.load(context.memory, at, kinds.U8) != characters.UNDERSCORE:
                break
        at += 1
    return at


def read_whole(context: PlcContext, at: int, end: int) -> int:
    """Return the number of a literal: blanks, prefix, sign, base; 0 of anything else (ST-307)."""
    at = skip_prefix(context, skip_blanks(context, at, end), end)
    is_negative = at < end and words.load(context.memory, at, kinds.U8) == characters.MINUS
    if is_negative or (at < end and words.load(context.memory, at, kinds.U8) == characters.PLUS):
        at += 1
    after = skip_digits(context, at, end)
    value = read_digits(context, at, after, 10)
    if after < end and words.load(context.memory, after, kinds.U8) == characters.HASH:
        if value in (characters.BINARY, characters.OCTAL, characters.HEXADECIMAL):
            value = read_digits(context, after + 1, end, value)
    return words.subtract(0, value) if is_negative else value


def read_real(context: PlcContext, at: int, end: int) -> float:
    """Return the real number of a literal; 0 of anything else."""
    at = skip_prefix(context, skip_blanks(context, at, end), end)
    i = at
    if i < end and words.load(context.memory, i, kinds.U8) == characters.MINUS:
        i += 1
    elif i < end and words.load(context.memory, i, kinds.U8) == characters.PLUS:
        i += 1
    first = i
    while i < end and digit_of(context, i, 10) >= 0:
        i += 1
    if i == first:
        return 0.0
    if i < end and words.load(context.memory, i, kinds.U8) == characters.POINT:
        i += 1
        while i < end and digit_of(context, i, 10) >= 0:
            i += 1
    if i < end and digit_of(context, i, characters.DIGIT_E + 1) == characters.DIGIT_E:
        exponent = i + 1
        if exponent < end and words.load(context.memory, exponent, kinds.U8) == characters.MINUS:
            exponent += 1
        elif exponent < end and words.load(context.memory, exponent, kinds.U8) == characters.PLUS:
            exponent += 1
        if exponent < end and digit_of(context, exponent, 10) >= 0:
            i = exponent
            while i < end and digit_of(context, i, 10) >= 0:
                i += 1
    return words.parse(context.memory, at, i - at)

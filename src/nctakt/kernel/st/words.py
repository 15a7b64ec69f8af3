# SPDX-License-Identifier: MIT
"""Words of the PLC's memory and the arithmetic of whole numbers (ST-001, ST-301, ST-302).

A whole number has 64 bits, as a signed number; an unsigned one is kept with the same bits. Overflow
wraps around. Compiled modules have C functions of the same names (``words.pxd``). Every address is
checked by the caller; so are divisors and the range of conversions to whole numbers.
"""

import struct

from nctakt.kernel.st import kinds

_FORMATS = {
    kinds.BOOL: "?",
    kinds.I8: "b",
    kinds.I16: "<h",
    kinds.I32: "<i",
    kinds.I64: "<q",
    kinds.U8: "B",
    kinds.U16: "<H",
    kinds.U32: "<I",
    kinds.U64: "<q",
    kinds.F32: "<f",
    kinds.F64: "<d",
}
_WORDS = {kind: struct.Struct(text) for kind, text in _FORMATS.items()}
_MASK = (1 << 64) - 1
_TOP = 1 << 63
_UNSIGNED = {kinds.U8: 0xFF, kinds.U16: 0xFFFF, kinds.U32: 0xFFFFFFFF}
_SIGNED = {kinds.I8: 1 << 7, kinds.I16: 1 << 15, kinds.I32: 1 << 31, kinds.I64: _TOP}


def load(memory: memoryview, at: int, kind: int) -> int:
    """Return a whole number or a truth."""
    return int(_WORDS[kind].unpack_from(memory, at)[0])


def store(memory: memoryview, at: int, kind: int, value: int) -> None:
    """Store a whole number, cut to its width, or a truth."""
    _WORDS[kind].pack_into(memory, at, wrap(value, kind))


def load_real(memory: memoryview, at: int, kind: int) -> float:
    """Return a real number."""
    return float(_WORDS[kind].unpack_from(memory, at)[0])


def store_real(memory: memoryview, at: int, kind: int, value: float) -> None:
    """Store a real number, rounded to its width."""
    _WORDS[kind].pack_into(memory, at, single(value) if kind == kinds.F32 else value)


def copy(memory: memoryview, to: int, source: int, count: int) -> None:
    """Copy bytes; the two ranges may overlap."""
    memory[to : to + count] = bytes(memory[source : source + count])


def fill(memory: memoryview, at: int, count: int, value: int) -> None:
    """Set bytes to the low byte of a value."""
    memory[at : at + count] = bytes([value & 0xFF]) * count


def compare(memory: memoryview, one: int, other: int, count: int) -> int:
    """Return -1, 0 or 1: the order of bytes."""
    left, right = bytes(memory[one : one + count]), bytes(memory[other : other + count])
    return (left > right) - (left < right)


def length(memory: memoryview, at: int, count: int) -> int:
    """Return the number of bytes before the first zero, ``count`` at most."""
    found = bytes(memory[at : at + count]).find(0)
    return count if found < 0 else found


def length_wide(memory: memoryview, at: int, count: int) -> int:
    """Return the number of pairs of bytes before the first that is zero, ``count`` at most."""
    return next((i for i in range(count) if not any(memory[at + 2 * i : at + 2 * i + 2])), count)


def compare_wide(memory: memoryview, one: int, other: int, count: int) -> int:
    """Return -1, 0 or 1: the order of pairs of bytes as numbers."""
    left, right = (struct.unpack_from(f"<{count}H", memory, at) for at in (one, other))
    return (left > right) - (left < right)


def add(left: int, right: int) -> int:
    """``left + right``."""
    return wrap(left + right, kinds.I64)


def subtract(left: int, right: int) -> int:
    """``left - right``."""
    return wrap(left - right, kinds.I64)


def multiply(left: int, right: int) -> int:
    """``left * right``."""
    return wrap(left * right, kinds.I64)


def divide(left: int, right: int) -> int:
    """``left / right``, cut towards zero; the divisor is not 0 (ST-503)."""
    size = abs(left) // abs(right)
    return wrap(size if (left < 0) == (right < 0) else -size, kinds.I64)


def modulo(left: int, right: int) -> int:
    """Remainder with the sign of ``left``; the divisor is not 0 (ST-503)."""
    size = abs(left) % abs(right)
    return -size if left < 0 else size


def divide_unsigned(left: int, right: int) -> int:
    """``left / right`` of unsigned numbers; the divisor is not 0."""
    return wrap((left & _MASK) // (right & _MASK), kinds.I64)


def modulo_unsigned(left: int, right: int) -> int:
    """Remainder of unsigned numbers; the divisor is not 0."""
    return wrap((left & _MASK) % (right & _MASK), kinds.I64)


def wrap(value: int, kind: int) -> int:
    """Cut a number to the width of its kind; a truth is 0 or 1 (ST-302)."""
    if kind == kinds.BOOL:
        return int(value != 0)
    if kind in _UNSIGNED:
        return value & _UNSIGNED[kind]
    top = _SIGNED.get(kind, _TOP)
    return ((value + top) & (2 * top - 1)) - top


def shift_left(value: int, count: int) -> int:
    """Move bits up by 0 … 63."""
    return wrap(value << count, kinds.I64)


def shift_right(value: int, count: int) -> int:
    """Move bits down by 0 … 63; zeros follow."""
    return wrap((value & _MASK) >> count, kinds.I64)


def real_of_unsigned(value: int) -> float:
    """Return an unsigned number as a real one."""
    return float(value & _MASK)


def unsigned_of_real(value: float) -> int:
    """Return a real number of 0 … 2**64, cut towards zero, as an unsigned one."""
    return wrap(int(value), kinds.I64)


def single(value: float) -> float:
    """Round to the nearest REAL; an overflow is infinite (ST-304)."""
    if value - value != 0.0:
        return value
    try:
        return float(struct.unpack("<f", struct.pack("<f", value))[0])
    except OverflowError:
        return float("inf") if value > 0.0 else float("-inf")


def decimal(memory: memoryview, at: int, value: float, is_single: bool) -> int:
    """Write the shortest ``d.de+d`` that reads back as a finite number; return its length.

    Up to 32 bytes are written (ST-308).
    """
    text = ""
    for digits in range(17):
        text = f"{value:.{digits}e}"
        again = float(text)
        if (single(again) if is_single else again) == value:
            break
    memory[at : at + len(text) + 1] = text.encode("ascii") + b"\0"
    return len(text)


def parse(memory: memoryview, at: int, count: int) -> float:
    """Return the decimal number that up to 63 bytes spell."""
    return float(bytes(memory[at : at + min(count, 63)]))

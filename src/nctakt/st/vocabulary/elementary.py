# SPDX-License-Identifier: MIT
"""The elementary types with size and range (ST-301), and combinations of two (ST-302 … 304)."""

from __future__ import annotations

from nctakt.base.misspelling import nearest
from nctakt.st.types import Elementary, Family, PointerType, StringType, Type


def _whole(name: str, size: int, family: Family) -> Elementary:
    bits = 8 * size
    low = -(1 << bits - 1) if family is Family.SIGNED else 0
    high = (1 << bits - 1) - 1 if family is Family.SIGNED else (1 << bits) - 1
    return Elementary(name, size, size, family, low, high)


_SIZES = (1, 2, 4, 8)
_BIT_STRINGS = [
    _whole(name, size, Family.BITS)
    for name, size in zip(("BYTE", "WORD", "DWORD", "LWORD"), _SIZES, strict=True)
]
_UNSIGNED = [
    _whole(name, size, Family.UNSIGNED)
    for name, size in zip(("USINT", "UINT", "UDINT", "ULINT"), _SIZES, strict=True)
]
_SIGNED = [
    _whole(name, size, Family.SIGNED)
    for name, size in zip(("SINT", "INT", "DINT", "LINT"), _SIZES, strict=True)
]
_OF_FAMILY = {
    family: {one.size: one for one in group}
    for family, group in (
        (Family.BITS, _BIT_STRINGS),
        (Family.UNSIGNED, _UNSIGNED),
        (Family.SIGNED, _SIGNED),
    )
}

BOOL = Elementary("BOOL", 1, 1, Family.BOOL, 0, 1)
BIT = Elementary("BIT", 0, 1, Family.BOOL, 0, 1, is_bit=True)
REAL = Elementary("REAL", 4, 4, Family.REAL)
LREAL = Elementary("LREAL", 8, 8, Family.REAL)
BYTE, WORD = _BIT_STRINGS[:2]
UDINT, ULINT = _UNSIGNED[2:]
INT, DINT, LINT = _SIGNED[1:]
TIME = Elementary("TIME", 4, 4, Family.DURATION, 0, (1 << 32) - 1)
LTIME = Elementary("LTIME", 8, 8, Family.DURATION, 0, (1 << 64) - 1)
DATE = Elementary("DATE", 4, 4, Family.DATE, 0, (1 << 32) - 1)
DATE_AND_TIME = Elementary("DATE_AND_TIME", 4, 4, Family.DATE, 0, (1 << 32) - 1)
TIME_OF_DAY = Elementary("TIME_OF_DAY", 4, 4, Family.DATE, 0, 86_399_999)
PVOID = PointerType("PVOID", 8, 8, None)
#: A literal before its context says which type it has: they never stay in a checked tree.
UNTYPED = Elementary("integer", 8, 8, Family.SIGNED, -(1 << 63), (1 << 64) - 1)
UNTYPED_REAL = Elementary("real", 8, 8, Family.REAL)

#: All elementary types by their names in upper case.
ELEMENTARY: dict[str, Type] = {
    one.name: one
    for one in (
        *_BIT_STRINGS,
        *_UNSIGNED,
        *_SIGNED,
        *(BOOL, REAL, LREAL, TIME, LTIME, DATE, DATE_AND_TIME, TIME_OF_DAY, PVOID),
    )
} | {
    "BIT": BIT,
    "DT": DATE_AND_TIME,
    "TOD": TIME_OF_DAY,
    "__XINT": LINT,
    "__UXINT": ULINT,
    "__XWORD": _BIT_STRINGS[3],
}

#: Types that come before ``#`` of a literal under another name.
LITERAL_PREFIXES: dict[str, Elementary] = {
    "T": TIME,
    "LT": LTIME,
    "D": DATE,
    **{name: one for name, one in ELEMENTARY.items() if isinstance(one, Elementary)},
}

INTEGERS = frozenset((Family.BITS, Family.UNSIGNED, Family.SIGNED))
NUMBERS = INTEGERS | {Family.REAL}


def nearest_type(name: str) -> str:
    """Return the elementary type that a name is a misspelling of; empty if none is clearly meant.

    A letter that is missing is more likely than a wrong one: ``UDNT`` is UDINT, not UINT.
    """
    known = [*(one for one in ELEMENTARY if not one.startswith("_")), "STRING", "WSTRING"]
    found = nearest(name, known)
    if found:
        return found
    written = name.upper()
    longer = [
        one
        for one in known
        if any(written == one[:index] + one[index + 1 :] for index in range(len(one)))
    ]
    return longer[0] if len(longer) == 1 else ""


def string(length: int, *, is_wide: bool = False) -> StringType:
    """Return STRING(length) or WSTRING(length)."""
    unit = 2 if is_wide else 1
    name = f"{'W' if is_wide else ''}STRING({length})"
    return StringType(name, (length + 1) * unit, unit, length, is_wide)


def wider(first: Elementary, second: Elementary) -> Elementary:
    """Return the type of an operation with two whole numbers (ST-302, ST-303)."""
    size = max(first.size, second.size)
    families = {first.family, second.family}
    if Family.SIGNED in families:
        return _OF_FAMILY[Family.SIGNED][size]
    family = Family.BITS if families == {Family.BITS} else Family.UNSIGNED
    return _OF_FAMILY[family][size]


def signed(kind: Elementary) -> Elementary:
    """Return the signed type of a size: that of a minus before an unsigned operand."""
    return _OF_FAMILY[Family.SIGNED][kind.size]


def smallest_bits(value: int) -> Elementary:
    """Return the smallest bit string that holds a literal: the operand of NOT."""
    return next((one for one in _BIT_STRINGS if value <= one.high), _BIT_STRINGS[-1])


def smallest(value: int) -> Elementary:
    """Return the smallest of INT, DINT, LINT and ULINT that holds a literal."""
    return next((one for one in (INT, DINT, LINT) if one.low <= value <= one.high), ULINT)

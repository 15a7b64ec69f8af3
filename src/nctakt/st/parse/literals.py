# SPDX-License-Identifier: MIT
"""Texts of literals -> values (ST-206 … 208).

In: the text of a literal without its prefix. Out: its value, ``None`` if it is not a literal.
"""

from __future__ import annotations

import re
from itertools import pairwise

from nctakt.base.diagnostics import Text

#: Nanoseconds of the units of TIME and LTIME, in the order in which they are written.
_UNITS = {
    "d": 86_400_000_000_000,
    "h": 3_600_000_000_000,
    "m": 60_000_000_000,
    "s": 1_000_000_000,
    "ms": 1_000_000,
    "us": 1_000,
    "ns": 1,
}
_UNIT_ORDER = list(_UNITS)
_PART = re.compile(r"(\d[\d_]*)(?:\.(\d+))?(d|h|ms|us|ns|m|s)_?", re.IGNORECASE)
_DATE = re.compile(r"(\d+)-(\d+)-(\d+)(?:-(\d+):(\d+)(?::(\d+)(?:\.\d+)?)?)?")
_TIME_OF_DAY = re.compile(r"(\d+):(\d+)(?::(\d+)(?:\.(\d+))?)?")
_DAYS = (31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)
_BASED = re.compile(r"(-?)(\d[\d_]*)#(\w+)")
_ESCAPE = re.compile(r"\$(?:([0-9A-Fa-f]{4})|([0-9A-Fa-f]{2})|(.)|$)", re.DOTALL)
_ESCAPED = {
    "$": "$",
    "'": "'",
    '"': '"',
    "l": "\n",
    "n": "\n",
    "p": "\f",
    "r": "\r",
    "t": "\t",
}
#: More digits than any 64-bit number has.
_MAX_DIGITS = 80


def integer(text: str) -> int | None:
    """Return the value of ``12``, ``1_000``, ``16#FF``, with a sign if there is one."""
    based = _BASED.fullmatch(text)
    try:
        if based is not None:
            base = int(based[2].replace("_", "")[:4])
            if base not in (2, 8, 10, 16):
                return None
            number = int(based[3].replace("_", ""), base)
            return -number if based[1] else number
        digits = text.replace("_", "")
        return int(digits) if len(digits) <= _MAX_DIGITS else None
    except ValueError:
        return None


def real(text: str) -> float | None:
    """Return the value of ``1.5``, ``1E-3``; ``None`` beyond the range, too."""
    try:
        value = float(text.replace("_", ""))
    except ValueError:
        return None
    return value if abs(value) != float("inf") else None


def duration_ns(text: str) -> int | None:
    """Return the value of ``1d2h3m4s5ms6us7ns``: units from large to small, each once."""
    parts = list(_PART.finditer(text))
    if not parts or "".join(part[0] for part in parts) != text:
        return None
    order = [_UNIT_ORDER.index(part[3].lower()) for part in parts]
    if any(first >= second for first, second in pairwise(order)):
        return None
    total = 0
    for part in parts:
        unit = _UNITS[part[3].lower()]
        if len(part[1]) > _MAX_DIGITS:
            return None
        total += int(part[1].replace("_", "")) * unit
        if part[2]:
            if part is not parts[-1]:
                return None
            digits = part[2][:18]
            total += int(digits) * unit // 10 ** len(digits)
    return total


def date_s(text: str, *, with_time: bool) -> int | None:
    """Return the seconds since 1970-01-01 of ``2024-02-29`` or ``2024-02-29-12:34:56``."""
    match = _DATE.fullmatch(text)
    if match is None or (match[4] is not None) != with_time:
        return None
    year, month, day = (int(match[index][:6]) for index in (1, 2, 3))
    if not (1970 <= year <= 2106 and 1 <= month <= 12 and 1 <= day <= _DAYS[month - 1]):
        return None
    is_leap = year % 4 == 0 and (year % 100 != 0 or year % 400 == 0)
    if month == 2 and day == 29 and not is_leap:
        return None
    days = _days_before(year, month) + day - 1
    hour, minute, second = (int((match[index] or "0")[:4]) for index in (4, 5, 6))
    if hour > 23 or minute > 59 or second > 59:
        return None
    return days * 86_400 + hour * 3600 + minute * 60 + second


def _days_before(year: int, month: int) -> int:
    """Return the days from 1970-01-01 to the first of a month."""
    before = year - 1
    days = 365 * (year - 1970) + before // 4 - before // 100 + before // 400 - 477
    for number in range(1, month):
        days += _DAYS[number - 1]
        if number == 2 and (year % 4 or (year % 100 == 0 and year % 400)):
            days -= 1
    return days


def time_of_day_ms(text: str) -> int | None:
    """Return the milliseconds since midnight of ``12:34:56.789``."""
    match = _TIME_OF_DAY.fullmatch(text)
    if match is None:
        return None
    hour, minute, second = (int((match[index] or "0")[:4]) for index in (1, 2, 3))
    if hour > 23 or minute > 59 or second > 59:
        return None
    milliseconds = int((match[4] or "0").ljust(3, "0")[:3])
    return ((hour * 60 + minute) * 60 + second) * 1000 + milliseconds


def string(text: str) -> str | None:
    """Return the characters of a literal between its quotes; ``None`` for a wrong ``$``."""
    is_wide = text[:1] == '"'
    faults = []

    def escaped(match: re.Match[str]) -> str:
        four, two, character = match.groups()
        if four is not None:
            if is_wide:
                return chr(int(four, 16))
            return chr(int(four[:2], 16)) + four[2:]
        if two is not None and not is_wide:
            return chr(int(two, 16))
        known = _ESCAPED.get((character or "").lower())
        if known is None:
            faults.append(match[0])
            return ""
        return known

    found = _ESCAPE.sub(escaped, text[1:-1])
    return None if faults else found


#: Names of wrong literals in messages, by their intended kind.
LITERAL_KINDS = {
    "time": Text("duration", "Zeitdauer"),
    "date": Text("date", "Datum"),
    "string": Text("string", "Zeichenkette"),
    "number": Text("number", "Zahl"),
}

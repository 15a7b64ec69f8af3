# SPDX-License-Identifier: MIT
"""Lengths of time as users write them: ``"1.5 s"``, ``"300 ticks"``, ``0.2``, a ``timedelta``.

In: a text with a unit, a number of seconds or a ``datetime.timedelta``. Out: ``Time``, in whole
microseconds or whole ticks. A time is reached at the start of the first tick that begins at or
after it (RC-001), so a part of a microsecond is rounded up: no tick begins within it. The command
line, the Python interface, PLCs, tests and load files all read their times here.
"""

from __future__ import annotations

import functools
import math
import numbers
import re
from datetime import timedelta

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.base.plain_values import plain_number
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import INVALID_TIME, WRONG_TIME_TYPE

#: Microseconds in each unit; a text without a unit is a number of seconds.
_UNITS = {
    "us": 1,
    "µs": 1,
    "μs": 1,
    "ms": 1_000,
    "s": 1_000_000,
    "": 1_000_000,
    "min": 60_000_000,
    "h": 3_600_000_000,
}

#: At most 12 digits on either side: some 30 000 years, and finer than a microsecond.
_TEXT = re.compile(
    r"(?=[\d.])(?P<whole>\d{0,12})(?:(?P<point>\.)(?P<part>\d{0,12}))? ?(?P<unit>[a-zµμ]*)",
    re.ASCII,
)
_LONGEST_S = 10**12

#: A time within a longer text, as a regular expression without groups.
PATTERN = r"(?:\d+\.?\d*|\.\d+)(?: ?(?:us|µs|μs|ms|s|min|h|ticks?)\b)?"


@dataclass(frozen=True, slots=True)
class Time:
    """A length of time: ``count`` microseconds, or ticks of the controller."""

    count: int
    is_in_ticks: bool = False

    def us(self, cycle_time_us: int) -> int:
        """Return the time in microseconds, where a tick lasts ``cycle_time_us``."""
        return self.count * cycle_time_us if self.is_in_ticks else self.count

    def ticks(self, cycle_time_us: int) -> int:
        """Return the number of the first tick that begins at or after this time."""
        return self.count if self.is_in_ticks else -(-self.count // cycle_time_us)

    def __str__(self) -> str:
        if self.is_in_ticks:
            return "1 tick" if self.count == 1 else f"{self.count} ticks"
        seconds = f"{self.count // 1_000_000}.{self.count % 1_000_000:06}".rstrip("0")
        return f"{seconds.rstrip('.')} s"


def time_stamp(time_us: int) -> str:
    """Return a time with all its microseconds, in columns of equal width: ``0.463000 s``."""
    return f"{time_us // 1_000_000}.{time_us % 1_000_000:06d} s"


#: A time in the Python interface; a number means seconds.
TimeLike = Time | str | float | timedelta


def read_time(value: TimeLike) -> Time:
    """Return the time of ``value``; ``"0.2"`` and ``0.2`` are seconds.

    Raises ``Failure`` for an invalid text or number (900510) and for another type (900513).
    """
    value = plain_number(value)
    if isinstance(value, Time):
        return value
    if isinstance(value, str):
        return _from_text(value)
    if isinstance(value, timedelta):
        time_us = value // timedelta(microseconds=1)
    elif isinstance(value, numbers.Real) and not isinstance(value, bool):
        time_us = _from_seconds(float(value))
    else:
        raise Failure(diagnostic(WRONG_TIME_TYPE, value=repr(value), type=type(value).__name__))
    if time_us < 0:
        raise Failure(diagnostic(INVALID_TIME, text=value))
    return Time(time_us)


def nanoseconds(text: str) -> int | None:
    """Return a text with a unit in nanoseconds, rounded up; ``None`` if it is not such a text.

    A number of ticks has no fixed length, and neither has a number without a unit here.
    """
    match = _match(text)
    if match is None or not match["unit"] or match["unit"] not in _UNITS:
        return None
    return _rounded_up(match, 1_000 * _UNITS[match["unit"]])


@functools.lru_cache(maxsize=1024)
def _from_text(text: str) -> Time:
    match = _match(text)
    unit = "?" if match is None else match["unit"]
    if match is not None and unit in ("tick", "ticks") and not match["point"]:
        return Time(int(match["whole"]), is_in_ticks=True)
    if match is None or unit not in _UNITS:
        raise Failure(diagnostic(INVALID_TIME, text=text))
    return Time(_rounded_up(match, _UNITS[unit]))


def _match(text: str) -> re.Match[str] | None:
    """Return the parts of a text that begins with a number, at least one digit of it."""
    match = _TEXT.fullmatch(text.strip())
    return match if match is not None and (match["whole"] or match["part"]) else None


def _rounded_up(match: re.Match[str], factor: int) -> int:
    """Return the number times a factor, exactly, then rounded up."""
    part = match["part"] or ""
    divisor: int = 10 ** len(part)
    return -(-int(match["whole"] + part) * factor // divisor)


def _from_seconds(seconds: float) -> int:
    """Return the microseconds of a number of seconds, rounded up; -1 if it is not a time.

    A binary fraction is taken to the nanosecond first: 0.1 + 0.2 means 300 ms.
    """
    if not math.isfinite(seconds) or not 0.0 <= seconds < _LONGEST_S:
        return -1
    return -(-round(seconds * 1e9) // 1_000)

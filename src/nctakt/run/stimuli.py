# SPDX-License-Identifier: MIT
"""Values of variables at times, from the words of a command line.

In: ``1.5ms``, ``V.E.VALUE=5``. Out: times in whole microseconds, ``Stimulus`` objects. A stimulus
is latched at the start of the first tick that begins at or after its time (RC-001, RC-002), so a
part of a microsecond is rounded up: no tick begins within it. Whether the variable exists, and
what it can hold, the controller says.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from decimal import ROUND_CEILING, Decimal

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.inputs import INVALID_TIME, NOT_AN_ASSIGNMENT, UNREADABLE_VALUE

#: Microseconds in a unit of time; a number without a unit means seconds.
_UNITS = {"us": 1, "µs": 1, "μs": 1, "ms": 1_000, "s": 1_000_000, "": 1_000_000, "min": 60_000_000}

#: At most 12 digits on either side: some 30 000 years, and finer than a microsecond.
_TIME = re.compile(r"(?P<number>\d{1,12}(?:\.\d{0,12})?|\.\d{1,12}) ?(?P<unit>[a-zµμ]*)", re.ASCII)
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_TRUTH = {"TRUE": 1.0, "FALSE": 0.0}

#: No variable of 64 bits holds more.
_LARGEST = 1.7976931348623157e308


@dataclass(frozen=True, slots=True)
class Stimulus:
    """``name`` gets ``value`` at ``time_us`` of the run, counted from its first tick."""

    time_us: int
    name: str
    value: float | str


def parse_time(text: str) -> int:
    """A time in microseconds: ``1500us``, ``1.5ms``, ``0.2s``, ``2min``; ``0.2`` is in seconds.

    Raises ``Failure`` (900510) for anything else.
    """
    match = _TIME.fullmatch(text.strip())
    if match is None or match["unit"] not in _UNITS:
        raise Failure(diagnostic(INVALID_TIME, text=text))
    time_us = Decimal(match["number"]) * _UNITS[match["unit"]]
    return int(time_us.to_integral_value(ROUND_CEILING))


def parse_assignment(text: str) -> tuple[str, float | str]:
    """Name and value of ``V.E.VALUE=5`` or ``V.E.TEXT="part"``; TRUE is 1 and FALSE is 0.

    Raises ``Failure``: no assignment (900511), no value (900512).
    """
    name, equals, value = text.partition("=")
    name = name.strip()
    if not equals or not name:
        raise Failure(diagnostic(NOT_AN_ASSIGNMENT, text=text))
    return name, _parse_value(name, value.strip())


def parse_stimulus(time: str, assignment: str) -> Stimulus:
    """The stimulus of ``--at TIME NAME=VALUE``; raises ``Failure`` as its two parts do."""
    time_us = parse_time(time)
    return Stimulus(time_us, *parse_assignment(assignment))


def _parse_value(name: str, text: str) -> float | str:
    if len(text) > 1 and text[0] == text[-1] == '"':
        return text[1:-1]
    truth = _TRUTH.get(text.upper())
    if truth is not None:
        return truth
    if _NUMBER.fullmatch(text) is None or abs(float(text)) > _LARGEST:
        raise Failure(diagnostic(UNREADABLE_VALUE, name=name, value=text))
    return float(text)

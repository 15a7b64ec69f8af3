# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""A ``Segment`` of an ordinary block, filled slot by slot.

The constructor of a frozen dataclass takes as long as finding out all that it is given.
"""

from __future__ import annotations

from nctakt.decoder.commands import Command, Pace, Segment
from nctakt.nc import slots

_SOURCE = Command.__dict__["source"]
_NUMBER = Command.__dict__["number"]
_START = Segment.__dict__["start"]
_TARGET = Segment.__dict__["target"]
_FEED = Segment.__dict__["feed"]
_EXACT_STOP = Segment.__dict__["exact_stop"]
_DEVIATION = Segment.__dict__["deviation"]
_LIMITS_JERK = Segment.__dict__["limits_jerk"]
_ARC = Segment.__dict__["arc"]
_PACE = Segment.__dict__["pace"]
_GOES_ON = Segment.__dict__["goes_on"]


def segment(
    source: int,
    number: int,
    start: list[float],
    target: list[float],
    feed: float,
    exact_stop: bool,
    deviation: float,
    limits_jerk: bool,
    arc: tuple[float, ...] | None,
    pace: Pace | None,
) -> Segment:
    """The segment of a whole block."""
    made: Segment = slots.fresh(Segment, 0)
    slots.put(_SOURCE, made, source)
    slots.put(_NUMBER, made, number)
    slots.put(_START, made, tuple(start))
    slots.put(_TARGET, made, tuple(target))
    slots.put(_FEED, made, feed)
    slots.put(_EXACT_STOP, made, exact_stop)
    slots.put(_DEVIATION, made, deviation)
    slots.put(_LIMITS_JERK, made, limits_jerk)
    slots.put(_ARC, made, arc)
    slots.put(_PACE, made, pace)
    slots.put(_GOES_ON, made, False)
    return made

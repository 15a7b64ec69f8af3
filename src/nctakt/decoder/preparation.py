# SPDX-License-Identifier: MIT
"""Contour preparation: start, target and limits of the axes -> a segment of the path (MO-1, MO-4).

The length of a segment is that of its way in the linear axes, or in the rotary ones where no linear
axis moves; the feed goes along it. Speed and acceleration on it are the highest that keep every
axis within its own. Every block ends with an exact stop.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from nctakt.decoder.commands import Segment
from nctakt.lists.axis_configuration import AxisConfiguration


@dataclass(frozen=True, slots=True)
class AxisLimits:
    """What contour preparation needs of an axis, in mm or degrees."""

    is_linear: bool
    rapid_speed: float
    max_speed: float
    rapid_acceleration: float
    feed_acceleration: float


def axis_limits(axis: AxisConfiguration) -> AxisLimits:
    """The limits of an axis list."""
    return AxisLimits(
        axis.is_linear,
        axis.rapid_speed,
        axis.max_speed,
        axis.dynamics.rapid_acceleration,
        axis.dynamics.feed_acceleration,
    )


def prepare(
    source: int,
    number: int,
    start: Sequence[float],
    target: Sequence[float],
    limits: Sequence[AxisLimits],
    feed_mm_s: float | None,
) -> Segment | None:
    """The segment from ``start`` to ``target``; ``None`` when nothing moves.

    ``feed_mm_s`` is ``None`` for a rapid motion.
    """
    ways = [end - begin for begin, end in zip(start, target, strict=True)]
    moving = [(way, axis) for way, axis in zip(ways, limits, strict=True) if way != 0.0]
    if not moving:
        return None
    linear = [way for way, axis in moving if axis.is_linear]
    length = _norm(linear or [way for way, _ in moving])
    parts = [(abs(way) / length, axis) for way, axis in moving]
    if feed_mm_s is None:
        speed = min(axis.rapid_speed / part for part, axis in parts)
        acceleration = min(axis.rapid_acceleration / part for part, axis in parts)
    else:
        speed = feed_mm_s
        acceleration = min(axis.feed_acceleration / part for part, axis in parts)
    highest = min(axis.max_speed / part for part, axis in parts)
    return Segment(
        source, number, tuple(start), tuple(target), length, speed, highest, acceleration
    )


def _norm(ways: Sequence[float]) -> float:
    if len(ways) == 1:
        return abs(ways[0])
    return math.sqrt(sum(way * way for way in ways))

# SPDX-License-Identifier: MIT
"""Contour preparation in the queue: limits, speeds at corners, look-ahead (MO-1, MO-3).

Runs when a segment is put into the queue, before the tick that takes it; compiled like the tick,
because a program may have very many short blocks. A segment is a row
(``rows.py``).

* ``measure`` (``segment_limits.py``): the length of a segment, and the highest speed and
acceleration
  on it that keep every axis within its own limits.
* ``join``: how the path passes from one segment to the next. An axis whose speed changes in a step
  has at most a share of what its acceleration changes in a tick, and the path keeps that share in
  reserve near the corner; a corner that would nearly stop it is a stop. With a deviation a parabola
  rounds the corner between two lines.
* ``spread``: the speeds at the ends of the segments before, from the last one backwards, so that
  each next one can still be kept and the last one stops.

This is for the trapezoid; with a limit of the jerk ``jerk_lookahead.py`` does both, and
``corner_rounding.py`` rounds corners.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.path import geometry
from nctakt.kernel.path.corner import Corner
from nctakt.kernel.path.corner_rounding import CornerRounding
from nctakt.kernel.path.jerk_lookahead import JerkLookAhead
from nctakt.kernel.path.segment_limits import SegmentLimits


class LookAhead:
    """The preparation of one channel: how its segments are joined.

    Its parts: the ``limits`` of a segment, the ``corner`` before the newest one, and for a
    limited jerk the ``rounding`` of corners and the look-ahead ``jerk``. ``blocks``: how many
    blocks are looked ahead; ``capacity``: rows of the queue.
    """

    def __init__(
        self, count: int, cycle_time_us: int, blocks: int, max_factor: float, room: int = 0
    ) -> None:
        self.limits = SegmentLimits(count, cycle_time_us, max_factor, room)
        self.corner = Corner(self.limits)
        self.rounding = CornerRounding(self.limits, self.corner)
        self.jerk = JerkLookAhead(self.limits, self.corner, blocks)
        self.blocks = blocks
        self.width = rows.segment_width(self.limits.room)
        self.capacity = 0
        self.spare = doubles(2 * self.width)

    def resize(self, capacity: int) -> None:
        """Work on a queue of ``capacity`` rows from now on."""
        self.capacity = capacity
        self.jerk.capacity = capacity

    def measure(self, segments: memoryview[float], row: int) -> None:
        """Prepare the newest segment alone: its limits, and its direction at its start."""
        self.corner.enter(segments, row, self.limits.measure(segments, row))

    # --- joining segments -----------------------------------------------------------------------

    def join(self, segments: memoryview[float], before: int, row: int) -> None:
        """Settle how the path passes from the segment at ``before`` to that at ``row``."""
        segments[before + rows.NEXT_SPEED] = segments[row + rows.SPEED]
        segments[before + rows.NEXT_IGNORES_OVERRIDE] = segments[row + rows.IGNORES_OVERRIDE]
        self.corner.set_steps()
        if segments[row + rows.JERK] > 0.0:
            self.jerk.join(segments, before, row)
            return
        if segments[before + rows.SHAPE] == rows.LINE and segments[row + rows.SHAPE] == rows.LINE:
            if self.corner.last_deviation != 0.0 and self.round_corner(segments, before, row):
                return
        self.pass_corner(segments, before, row)
        speed = min(segments[before + rows.CORNER_SPEED], self.arc_speed(segments, before, 1))
        segments[before + rows.CORNER_SPEED] = min(speed, self.arc_speed(segments, row, 0))

    def arc_speed(self, segments: memoryview[float], row: int, at_end: int) -> float:
        """Highest speed at start or end of an arc whose limits go by its angle."""
        if geometry.pieces(segments, row) == 0:
            return 1e300
        self.limits.arcs.open(segments, row)
        return self.limits.arcs.end_cap(at_end)

    def pass_corner(self, segments: memoryview[float], before: int, row: int) -> None:
        """Compute the speed at a corner, and the zones next to it with reserves."""
        share = max(self.corner.centripetal_share, self.corner.last_centripetal_share)
        reserve = min(0.7, 1.0 - arithmetic.square_root(share * share + 0.0025))
        shortest = min(segments[before + rows.LENGTH], segments[row + rows.LENGTH])
        limit_v = 1e300
        min_a = 1e300
        for i in range(self.limits.count):
            if self.corner.steps[i] > 0.0:
                step_a = self.limits.axis_acceleration(i) * reserve / self.corner.steps[i]
                limit_v = min(limit_v, step_a * self.limits.tick_t)
                limit_v = min(limit_v, arithmetic.square_root(step_a * shortest))
                min_a = min(min_a, self.limits.axis_acceleration(i))
        if limit_v < 2.5 * min_a * self.limits.tick_t and limit_v < 1e299:
            segments[before + rows.CORNER_SPEED] = 0.0
            return
        segments[before + rows.CORNER_SPEED] = limit_v
        speed = min(
            limit_v,
            self.limits.speed_of(segments[before + rows.SPEED], segments[before + rows.MAX_SPEED]),
            self.limits.speed_of(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED]),
        )
        density = max(1.0, speed * self.limits.tick_t / shortest)
        max_share = 0.0
        for i in range(self.limits.count):
            used = (
                self.corner.steps[i]
                * speed
                * density
                / (self.limits.axis_acceleration(i) * self.limits.tick_t)
            )
            self.corner.shares[i] = used
            max_share = max(max_share, used)
        if max_share > 1e-6:
            self.reserve_zone(segments, before, 1, speed, max_share)
            self.reserve_zone(segments, row, 0, speed, max_share)

    def reserve_zone(
        self, segments: memoryview[float], row: int, at_end: int, speed: float, max_share: float
    ) -> None:
        """Lower the acceleration within a tick of a corner, or on all of a short segment."""
        length = (
            speed * self.limits.tick_t
            + segments[row + rows.ACCELERATION] * self.limits.tick_t * self.limits.tick_t
        )
        if geometry.pieces(segments, row) > 0:
            first_a = self.limits.listed_a[int(segments[row + rows.ARC_FIRST_AXIS])]
            second_a = self.limits.listed_a[int(segments[row + rows.ARC_SECOND_AXIS])]
            length += (first_a + second_a) * self.limits.tick_t * self.limits.tick_t
            column = row + (rows.ARC_EXIT_SHARE if at_end else rows.ARC_ENTRY_SHARE)
            if 3.0 * length > segments[row + rows.LENGTH]:
                column = row + rows.ARC_SHARE
            segments[column] = max(segments[column], max_share)
        limit_a = segments[row + rows.ACCELERATION]
        share = self.corner.last_centripetal_share if at_end else self.corner.centripetal_share
        if segments[row + rows.SHAPE] == rows.ARC and segments[row + rows.TRANSFORMATION] == 0.0:
            left2 = (1.0 - max_share) * (1.0 - max_share) - share * share
            limit_a *= arithmetic.square_root(left2 / (1.0 - share * share))
        else:
            for i in range(self.limits.count):
                part = self.corner.leaving[i] if at_end else self.corner.entering[i]
                part = part if part >= 0.0 else 0.0 - part
                if part > 0.0:
                    free = 1.0 - self.corner.shares[i] - share
                    limit_a = min(limit_a, self.limits.axis_acceleration(i) * free / part)
        if 3.0 * length > segments[row + rows.LENGTH]:
            segments[row + rows.ACCELERATION] = min(segments[row + rows.ACCELERATION], limit_a)
            entry_a = segments[row + rows.ENTRY_ACCELERATION]
            segments[row + rows.ENTRY_ACCELERATION] = min(entry_a, limit_a)
            exit_a = segments[row + rows.EXIT_ACCELERATION]
            segments[row + rows.EXIT_ACCELERATION] = min(exit_a, limit_a)
        elif at_end:
            segments[row + rows.EXIT_LENGTH] = length
            segments[row + rows.EXIT_ACCELERATION] = limit_a
        else:
            segments[row + rows.ENTRY_LENGTH] = length
            segments[row + rows.ENTRY_ACCELERATION] = limit_a

    def round_corner(self, segments: memoryview[float], before: int, row: int) -> int:
        """Round the corner by a parabola within the deviation; return 0 if none fits.

        Its begin and end are equally far from the corner, on each segment at most half its length.
        """
        size2 = 0.0
        for i in range(self.limits.count):
            if self.limits.linear[i]:
                size2 += self.corner.steps[i] * self.corner.steps[i]
        size = arithmetic.square_root(size2)
        shorter = min(self.corner.last_length, segments[row + rows.LENGTH])
        half = self.corner.half_length(size, shorter, 4.0)
        if half <= 0.0:
            return 0
        curve_v2 = 1e300
        for i in range(self.limits.count):
            if self.corner.steps[i] > 0.0:
                step_a = 0.9 * self.limits.axis_acceleration(i) / self.corner.steps[i]
                curve_v2 = min(curve_v2, 2.0 * half * step_a)
        if self.limits.is_reduced:
            radial_a = self.limits.vector_limit(segments, row, rows.RADIAL_ACCELERATION)
            curve_v2 = min(curve_v2, 2.0 * half * radial_a / size)
        speed = min(
            self.limits.speed_of(segments[before + rows.SPEED], segments[before + rows.MAX_SPEED]),
            self.limits.speed_of(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED]),
        )
        share = 0.9 * min(1.0, speed * speed / curve_v2)
        curve_a = 1e300
        if self.limits.is_reduced:
            curve_a = min(segments[before + rows.ACCELERATION], segments[row + rows.ACCELERATION])
        for i in range(self.limits.count):
            part = max(self.corner.leaving[i], 0.0 - self.corner.leaving[i])
            part = max(part, self.corner.entering[i], 0.0 - self.corner.entering[i])
            if part > 0.0:
                curve_a = min(curve_a, self.limits.axis_acceleration(i) * (1.0 - share) / part)
        segments[before + rows.CURVE_HALF] = half
        segments[before + rows.CURVE_SPEED] = min(arithmetic.square_root(curve_v2), speed)
        segments[before + rows.CURVE_ACCELERATION] = curve_a
        start = row + rows.START
        corner = before + rows.START + self.limits.count
        curve_end = corner + self.limits.count
        for i in range(self.limits.count):
            position = segments[corner + i] + half * self.corner.entering[i]
            segments[curve_end + i] = position
            segments[start + i] = position
        segments[row + rows.LENGTH] -= half
        segments[before + rows.CORNER_SPEED] = 1e300
        return 1

    # --- the speeds at the ends -----------------------------------------------------------------

    def spread(
        self,
        segments: memoryview[float],
        number: int,
        oldest: int,
        promised_v: float,
        promised_max_v: float,
    ) -> int:
        """Raise the end speeds of the segments before ``number`` as far as they may.

        ``oldest`` is the first command of the queue that is not current. The current segment has
        been promised the speed at its end: 0 where that cannot be kept.
        """
        row = number % self.capacity * self.width
        entry_v = self.feed_entry_speed(segments, row, 0.0)
        max_entry_v = self.max_entry_speed(segments, row, entry_v, 0.0, 0.0)
        passed = 0
        while segments[row + rows.PREDECESSOR] > 0.0:
            back = int(segments[row + rows.PREDECESSOR])
            number = number - back
            if number < oldest:
                return 1 if entry_v >= promised_v and max_entry_v >= promised_max_v else 0
            row = number % self.capacity * self.width
            entry_v = min(entry_v, segments[row + rows.CORNER_SPEED])
            max_entry_v = min(max_entry_v, segments[row + rows.CORNER_SPEED])
            end_v = segments[row + rows.END_SPEED]
            max_end_v = segments[row + rows.MAX_END_SPEED]
            if passed > 0 and entry_v == end_v and max_entry_v == max_end_v:
                return 1
            if passed >= self.blocks and entry_v >= end_v and max_entry_v >= max_end_v:
                return 1
            segments[row + rows.END_SPEED] = entry_v
            segments[row + rows.MAX_END_SPEED] = max_entry_v
            end_v = entry_v
            max_end_v = max_entry_v
            entry_v = self.feed_entry_speed(segments, row, end_v)
            max_entry_v = self.max_entry_speed(segments, row, entry_v, end_v, max_end_v)
            passed += 1
        return 1

    def feed_entry_speed(self, segments: memoryview[float], row: int, end_v: float) -> float:
        """Return the highest speed at a segment's start under its feed, from that at its end."""
        speed = min(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED])
        return self.entry_speed(segments, row, end_v, speed)

    def max_entry_speed(
        self, segments: memoryview[float], row: int, entry_v: float, end_v: float, max_end_v: float
    ) -> float:
        """``feed_entry_speed`` without the feed; ``entry_v``: with it, from ``end_v``."""
        speed = min(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED])
        if max_end_v != end_v or entry_v == speed:
            return self.entry_speed(segments, row, max_end_v, segments[row + rows.MAX_SPEED])
        return entry_v

    def entry_speed(
        self, segments: memoryview[float], row: int, end_v: float, limit_v: float
    ) -> float:
        """Highest speed at a segment's start that keeps the one at its end."""
        if geometry.pieces(segments, row) > 0:
            self.limits.arcs.open(segments, row)
            return self.limits.arcs.entry_speed(end_v, limit_v)
        return geometry.entry_speed(segments, row, codes.ENTRY_ZONE, end_v, limit_v)

    def connect(
        self,
        segments: memoryview[float],
        number: int,
        back: int,
        oldest: int,
        promised_v: float,
        promised_max_v: float,
    ) -> None:
        """Let the path continue into segment ``number`` from the one ``back`` rows before.

        A continuation that would break the promise to the current segment is undone: the path stops
        there.
        """
        row = number % self.capacity * self.width
        before = (number - back) % self.capacity * self.width
        segments[row + rows.PREDECESSOR] = back
        if promised_v >= 0.0:
            for i in range(self.width):
                self.spare[i] = segments[row + i]
                self.spare[self.width + i] = segments[before + i]
        end_v = segments[before + rows.NEXT_SPEED]
        self.join(segments, before, row)
        if end_v > 0.0:
            segments[before + rows.NEXT_SPEED] = min(end_v, segments[row + rows.SPEED])
            segments[before + rows.CORNER_SPEED] = min(end_v, segments[before + rows.CORNER_SPEED])
        if self.spread_any(segments, number, oldest, promised_v, promised_max_v):
            return
        for i in range(self.width):
            segments[row + i] = self.spare[i]
            segments[before + i] = self.spare[self.width + i]
        self.spread_any(segments, number, oldest, -1.0, -1.0)

    def spread_any(
        self,
        segments: memoryview[float],
        number: int,
        oldest: int,
        promised_v: float,
        promised_max_v: float,
    ) -> int:
        """Spread for either slope; a ``promised_v`` below 0 is no promise."""
        if segments[number % self.capacity * self.width + rows.JERK] > 0.0:
            return self.jerk.spread(segments, number, oldest, promised_v >= 0.0)
        return self.spread(segments, number, oldest, promised_v, promised_max_v)

# SPDX-License-Identifier: MIT
"""Contour preparation in the queue: limits, speeds at corners, look-ahead (MO-1, MO-3).

Runs when a segment is put into the queue, before the tick that takes it; compiled like the tick,
because a program may have very many short blocks. A segment is a row
(``rows.py``).

* ``measure`` (``segment_limits.py``): the way of a segment, and the highest speed and acceleration
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
from nctakt.kernel.path import geometry
from nctakt.kernel.path.corner_rounding import Bends


class LookAhead(Bends):
    """The preparation of one channel: how its segments go on into each other."""

    # --- from one segment to the next -----------------------------------------------------------

    def leave(self, row: memoryview[float], base: int, length: float) -> None:
        """Keep what the next segment needs to know of this one, ``length`` as programmed."""
        geometry.direct(row, base, self.count, 1, self.leaving)
        if row[base + rows.JERK] > 0.0:
            self.leave_smoothly(row, base)
        self.last_bend = self.bend
        self.last_length = length
        self.last_deviation = row[base + rows.DEVIATION]

    def join(self, row: memoryview[float], before: int, base: int) -> None:
        """Settle how the path passes from the segment at ``before`` to that at ``base``."""
        row[before + rows.NEXT_SPEED] = row[base + rows.SPEED]
        row[before + rows.NEXT_IGNORES_OVERRIDE] = row[base + rows.IGNORES_OVERRIDE]
        for i in range(self.count):
            self.steps[i] = self.entering[i] - self.leaving[i]
            if self.steps[i] < 0.0:
                self.steps[i] = 0.0 - self.steps[i]
        if row[base + rows.JERK] > 0.0:
            self.join_smoothly(row, before, base)
            return
        if row[before + rows.SHAPE] == rows.LINE and row[base + rows.SHAPE] == rows.LINE:
            if self.last_deviation > 0.0 and self.round_corner(row, before, base):
                return
        self.pass_corner(row, before, base)
        speed = min(row[before + rows.CORNER_SPEED], self.arc_speed(row, before, 1))
        row[before + rows.CORNER_SPEED] = min(speed, self.arc_speed(row, base, 0))

    def arc_speed(self, row: memoryview[float], base: int, at_end: int) -> float:
        """The highest speed at the begin or end of an arc whose limits go by its angle."""
        if geometry.pieces(row, base) == 0:
            return 1e300
        self.arcs.open(row, base)
        return self.arcs.end_cap(at_end)

    def axis_acceleration(self, index: int) -> float:
        """What an axis can do in both segments of a corner."""
        return min(self.rapid_a[index], self.feed_a[index])

    def pass_corner(self, row: memoryview[float], before: int, base: int) -> None:
        """The highest speed at a corner, and the zones around it with acceleration in reserve."""
        bend = max(self.bend, self.last_bend)
        reserve = min(0.7, 1.0 - arithmetic.square_root(bend * bend + 0.0025))
        shortest = min(row[before + rows.LENGTH], row[base + rows.LENGTH])
        limit_v = 1e300
        least_a = 1e300
        for i in range(self.count):
            if self.steps[i] > 0.0:
                step_a = self.axis_acceleration(i) * reserve / self.steps[i]
                limit_v = min(limit_v, step_a * self.tick_t)
                limit_v = min(limit_v, arithmetic.square_root(step_a * shortest))
                least_a = min(least_a, self.axis_acceleration(i))
        if limit_v < 2.5 * least_a * self.tick_t and limit_v < 1e299:
            row[before + rows.CORNER_SPEED] = 0.0
            return
        row[before + rows.CORNER_SPEED] = limit_v
        speed = min(limit_v, self.speed_of(row, before), self.speed_of(row, base))
        density = max(1.0, speed * self.tick_t / shortest)
        most = 0.0
        for i in range(self.count):
            used = self.steps[i] * speed * density / (self.axis_acceleration(i) * self.tick_t)
            self.shares[i] = used
            most = max(most, used)
        if most > 1e-6:
            self.reserve_zone(row, before, 1, speed, most)
            self.reserve_zone(row, base, 0, speed, most)

    def reserve_zone(
        self, row: memoryview[float], base: int, at_end: int, speed: float, most: float
    ) -> None:
        """Less acceleration within a tick of a corner; on a short segment, on all of it."""
        way = speed * self.tick_t + row[base + rows.ACCELERATION] * self.tick_t * self.tick_t
        if geometry.pieces(row, base) > 0:
            first_a = self.feed_a[int(row[base + rows.ARC_FIRST_AXIS])]
            second_a = self.feed_a[int(row[base + rows.ARC_SECOND_AXIS])]
            way += (first_a + second_a) * self.tick_t * self.tick_t
            column = base + (rows.ARC_EXIT_SHARE if at_end else rows.ARC_ENTRY_SHARE)
            if 3.0 * way > row[base + rows.LENGTH]:
                column = base + rows.ARC_SHARE
            row[column] = max(row[column], most)
        limit_a = row[base + rows.ACCELERATION]
        if row[base + rows.SHAPE] == rows.ARC:
            bend = self.last_bend if at_end else self.bend
            left2 = (1.0 - most) * (1.0 - most) - bend * bend
            limit_a *= arithmetic.square_root(left2 / (1.0 - bend * bend))
        else:
            for i in range(self.count):
                part = self.leaving[i] if at_end else self.entering[i]
                part = part if part >= 0.0 else 0.0 - part
                if part > 0.0:
                    left_a = self.axis_acceleration(i) * (1.0 - self.shares[i])
                    limit_a = min(limit_a, left_a / part)
        if 3.0 * way > row[base + rows.LENGTH]:
            row[base + rows.ACCELERATION] = min(row[base + rows.ACCELERATION], limit_a)
            entry_a = row[base + rows.ENTRY_ACCELERATION]
            row[base + rows.ENTRY_ACCELERATION] = min(entry_a, limit_a)
            exit_a = row[base + rows.EXIT_ACCELERATION]
            row[base + rows.EXIT_ACCELERATION] = min(exit_a, limit_a)
        elif at_end:
            row[base + rows.EXIT_LENGTH] = way
            row[base + rows.EXIT_ACCELERATION] = limit_a
        else:
            row[base + rows.ENTRY_LENGTH] = way
            row[base + rows.ENTRY_ACCELERATION] = limit_a

    def round_corner(self, row: memoryview[float], before: int, base: int) -> int:
        """A parabola over the corner, not farther from it than the deviation: 0 if none fits.

        Its begin and end are equally far from the corner, on each segment at most half its way.
        """
        size2 = 0.0
        for i in range(self.count):
            if self.linear[i]:
                size2 += self.steps[i] * self.steps[i]
        size = arithmetic.square_root(size2)
        if size < 1e-6 or size > 1.99:
            return 0
        shorter = min(self.last_length, row[base + rows.LENGTH])
        half = min(4.0 * self.last_deviation / size, 0.5 * shorter)
        curve_v2 = 1e300
        for i in range(self.count):
            if self.steps[i] > 0.0:
                step_a = 0.9 * self.axis_acceleration(i) / self.steps[i]
                curve_v2 = min(curve_v2, 2.0 * half * step_a)
        speed = min(self.speed_of(row, before), self.speed_of(row, base))
        share = 0.9 * min(1.0, speed * speed / curve_v2)
        curve_a = 1e300
        for i in range(self.count):
            part = max(self.leaving[i], 0.0 - self.leaving[i])
            part = max(part, self.entering[i], 0.0 - self.entering[i])
            if part > 0.0:
                curve_a = min(curve_a, self.axis_acceleration(i) * (1.0 - share) / part)
        row[before + rows.CURVE_HALF] = half
        row[before + rows.CURVE_SPEED] = min(arithmetic.square_root(curve_v2), speed)
        row[before + rows.CURVE_ACCELERATION] = curve_a
        start = base + rows.START
        corner = before + rows.START + self.count
        curve_end = corner + self.count
        for i in range(self.count):
            position = row[corner + i] + half * self.entering[i]
            row[curve_end + i] = position
            row[start + i] = position
        row[base + rows.LENGTH] -= half
        row[before + rows.CORNER_SPEED] = 1e300
        return 1

    # --- the speeds at the ends -----------------------------------------------------------------

    def spread(
        self,
        row: memoryview[float],
        number: int,
        oldest: int,
        promised_v: float,
        promised_free_v: float,
    ) -> int:
        """Let the end speeds of the segments before ``number`` rise as far as they may.

        ``oldest`` is the first command of the queue that is not current. The current segment has
        been promised the speed at its end: 0 where that cannot be kept.
        """
        base = number % self.capacity * self.width
        self.enter(row, base, 0.0, 0.0)
        passed = 0
        while row[base + rows.PREDECESSOR] > 0.0:
            back = int(row[base + rows.PREDECESSOR])
            number = number - back
            if number < oldest:
                return 1 if self.entry_v >= promised_v and self.free_v >= promised_free_v else 0
            base = number % self.capacity * self.width
            self.entry_v = min(self.entry_v, row[base + rows.CORNER_SPEED])
            self.free_v = min(self.free_v, row[base + rows.CORNER_SPEED])
            end_v = row[base + rows.END_SPEED]
            free_end_v = row[base + rows.FREE_END_SPEED]
            if passed > 0 and self.entry_v == end_v and self.free_v == free_end_v:
                return 1
            if passed >= self.blocks and self.entry_v >= end_v and self.free_v >= free_end_v:
                return 1
            row[base + rows.END_SPEED] = self.entry_v
            row[base + rows.FREE_END_SPEED] = self.free_v
            self.enter(row, base, self.entry_v, self.free_v)
            passed += 1
        return 1

    def enter(self, row: memoryview[float], base: int, end_v: float, free_end_v: float) -> None:
        """The speeds at the begin of a segment from those at its end: with its feed, without."""
        speed = min(row[base + rows.SPEED], row[base + rows.MAX_SPEED])
        self.entry_v = self.entry_speed(row, base, end_v, speed)
        self.free_v = self.entry_v
        if free_end_v != end_v or self.entry_v == speed:
            self.free_v = self.entry_speed(row, base, free_end_v, row[base + rows.MAX_SPEED])

    def entry_speed(self, row: memoryview[float], base: int, end_v: float, limit_v: float) -> float:
        """The highest speed at the begin of a segment from which that at its end is kept."""
        if geometry.pieces(row, base) > 0:
            self.arcs.open(row, base)
            return self.arcs.entry_speed(end_v, limit_v)
        return geometry.entry_speed(row, base, codes.ENTRY_ZONE, end_v, limit_v)

    def connect(
        self,
        row: memoryview[float],
        number: int,
        back: int,
        oldest: int,
        promised_v: float,
        promised_free_v: float,
    ) -> None:
        """Let the path go on into segment ``number`` from the one ``back`` commands before it.

        What would break the promise to the current segment is taken back: the path stops there.
        """
        base = number % self.capacity * self.width
        before = (number - back) % self.capacity * self.width
        row[base + rows.PREDECESSOR] = back
        for i in range(self.width):
            self.spare[i] = row[base + i]
            self.spare[self.width + i] = row[before + i]
        self.join(row, before, base)
        if self.spread_any(row, number, oldest, promised_v, promised_free_v):
            return
        for i in range(self.width):
            row[base + i] = self.spare[i]
            row[before + i] = self.spare[self.width + i]
        self.spread_any(row, number, oldest, -1.0, -1.0)

    def spread_any(
        self,
        row: memoryview[float],
        number: int,
        oldest: int,
        promised_v: float,
        promised_free_v: float,
    ) -> int:
        """``spread``, or ``spread_smoothly``: a speed below 0 is none that is promised."""
        if row[number % self.capacity * self.width + rows.JERK] > 0.0:
            return self.spread_smoothly(row, number, oldest, promised_v >= 0.0)
        return self.spread(row, number, oldest, promised_v, promised_free_v)

# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""Contour preparation in the queue: limits, speeds at corners, look-ahead (MO-1, MO-3).

Runs when a segment is put into the queue, before the tick that takes it; compiled like the tick,
because a program may have very many short blocks. ``shape.py`` says what is in a segment's row.

* ``measure``: the way of a segment, and the highest speed and acceleration on it that keep every
  axis within its own limits; on an arc the centripetal acceleration counts.
* ``join``: how the path passes from one segment to the next. An axis whose speed changes in a step
  has at most a share of what its acceleration changes in a tick, and the path keeps that share in
  reserve near the corner; a corner that would nearly stop it is a stop. With a deviation a parabola
  rounds the corner between two lines.
* ``spread``: the speeds at the ends of the segments before, from the last one backwards, so that
  each next one can still be kept and the last one stops.
"""

from __future__ import annotations

from nctakt.kernel import arithmetic, shape


class LookAhead:
    """The preparation of one channel over ``count`` axes, ``blocks`` segments ahead.

    ``most_factor``: the highest override as a factor (P-CHAN-00056). ``capacity``: that of the
    channel's queue, which keeps it current.
    """

    def __init__(self, count: int, cycle_time_us: int, blocks: int, most_factor: float) -> None:
        self.count = count
        self.blocks = blocks
        self.most_factor = max(1.0, most_factor)
        self.tick_t = cycle_time_us / 1e6
        self.width = shape.width(count)
        self.capacity = 0
        room = max(1, count)
        self.linear = memoryview(bytearray(8 * room)).cast("q")
        self.rapid_v = memoryview(bytearray(8 * room)).cast("d")
        self.most_v = memoryview(bytearray(8 * room)).cast("d")
        self.rapid_a = memoryview(bytearray(8 * room)).cast("d")
        self.feed_a = memoryview(bytearray(8 * room)).cast("d")
        self.rapid_slope_a = memoryview(bytearray(8 * room)).cast("d")
        self.feed_slope_a = memoryview(bytearray(8 * room)).cast("d")
        self.rapid_j = memoryview(bytearray(8 * room)).cast("d")
        self.feed_j = memoryview(bytearray(8 * room)).cast("d")
        self.entering = memoryview(bytearray(8 * room)).cast("d")
        self.leaving = memoryview(bytearray(8 * room)).cast("d")
        self.steps = memoryview(bytearray(8 * room)).cast("d")
        self.shares = memoryview(bytearray(8 * room)).cast("d")
        self.spare = memoryview(bytearray(16 * self.width)).cast("d")
        self.bend = 0.0
        self.last_bend = 0.0
        self.last_length = 0.0
        self.last_deviation = 0.0

    def limit(
        self,
        index: int,
        is_linear: bool,
        speeds: tuple[float, float],
        accelerations: tuple[float, float],
    ) -> None:
        """The limits of one axis: rapid and highest speed, acceleration of rapid and feed."""
        self.linear[index] = is_linear
        self.rapid_v[index], self.most_v[index] = speeds
        self.rapid_a[index], self.feed_a[index] = accelerations

    def limit_slope(
        self, index: int, accelerations: tuple[float, float], jerks: tuple[float, float]
    ) -> None:
        """The limits of one axis with the jerk-limited slope: of rapid and feed."""
        self.rapid_slope_a[index], self.feed_slope_a[index] = accelerations
        self.rapid_j[index], self.feed_j[index] = jerks

    # --- the limits of a segment ----------------------------------------------------------------

    def measure(self, row: memoryview[float], base: int, feed_v: float) -> None:
        """Way, speeds and acceleration of the segment in ``row``; ``feed_v`` below 0: rapid."""
        self.bend = 0.0
        row[base + 3] = self.straight_way(row, base)
        if row[base + 9] == 1.0:
            self.measure_arc(row, base, feed_v)
        else:
            self.bound(row, base, feed_v)
        if row[base + 10] > 0.0:
            self.smooth(row, base, feed_v)
        row[base + 11] = 0.0
        shape.direct(row, base, self.count, 0, self.entering)

    def smooth(self, row: memoryview[float], base: int, feed_v: float) -> None:
        """Acceleration and jerk of the jerk-limited slope.

        On an arc the jerk of an axis has three parts: 0.4 of its limit are for the path's own, 0.3
        for the turning of the path's acceleration, 0.3 for that of the centripetal one.
        """
        limit_a = 1e300
        limit_j = 1e300
        for i in range(self.count):
            way = row[base + 12 + self.count + i] - row[base + 12 + i]
            if way == 0.0 or self.in_plane(row, base, i):
                continue
            part = (way if way > 0.0 else 0.0 - way) / row[base + 3]
            slope_a = self.rapid_slope_a[i] if feed_v < 0.0 else self.feed_slope_a[i]
            slope_j = self.rapid_j[i] if feed_v < 0.0 else self.feed_j[i]
            limit_a = min(limit_a, slope_a / part)
            limit_j = min(limit_j, slope_j / part)
        if row[base + 9] == 1.0:
            tail = base + 12 + 2 * self.count
            first = int(row[tail + 7])
            second = int(row[tail + 8])
            x = row[base + 12 + first] - row[tail + 9]
            y = row[base + 12 + second] - row[tail + 10]
            radius = arithmetic.square_root(x * x + y * y)
            plane_j = min(self.feed_j[first], self.feed_j[second])
            plane_a = min(self.feed_slope_a[first], self.feed_slope_a[second])
            plane_a = min(plane_a, row[base + 6])
            speed = arithmetic.power(0.3 * plane_j * radius * radius, 1.0 / 3.0)
            speed = min(speed, arithmetic.square_root(0.5 * plane_a * radius))
            row[base + 5] = min(row[base + 5], speed)
            fastest = min(row[base + 5], row[base + 4] * self.most_factor)
            limit_a = min(limit_a, 0.8 * plane_a, 0.1 * plane_j * radius / fastest)
            limit_j = min(limit_j, 0.4 * plane_j)
        row[base + 6] = min(row[base + 6], limit_a)
        row[base + 10] = limit_j

    def straight_way(self, row: memoryview[float], base: int) -> float:
        """The way in the linear axes, or in the rotary ones where no linear axis moves."""
        linear2 = 0.0
        rotary2 = 0.0
        for i in range(self.count):
            way = row[base + 12 + self.count + i] - row[base + 12 + i]
            if self.linear[i]:
                linear2 += way * way
            else:
                rotary2 += way * way
        return arithmetic.square_root(linear2 if linear2 > 0.0 else rotary2)

    def bound(self, row: memoryview[float], base: int, feed_v: float) -> None:
        """Speeds and acceleration on a line, or of the axes outside of an arc's plane."""
        highest = 1e300
        limit_a = 1e300
        rapid = 1e300
        for i in range(self.count):
            way = row[base + 12 + self.count + i] - row[base + 12 + i]
            if way == 0.0 or self.in_plane(row, base, i):
                continue
            part = (way if way > 0.0 else 0.0 - way) / row[base + 3]
            rapid = min(rapid, self.rapid_v[i] / part)
            highest = min(highest, self.most_v[i] / part)
            limit_a = min(limit_a, self.acceleration(i, feed_v) / part)
        row[base + 4] = rapid if feed_v < 0.0 else feed_v
        row[base + 5] = highest
        row[base + 6] = limit_a

    def acceleration(self, index: int, feed_v: float) -> float:
        """The acceleration of an axis at rapid or feed."""
        return self.rapid_a[index] if feed_v < 0.0 else self.feed_a[index]

    def in_plane(self, row: memoryview[float], base: int, index: int) -> int:
        """Whether an axis is one of the two of the arc."""
        if row[base + 9] != 1.0:
            return 0
        tail = base + 12 + 2 * self.count
        return 1 if row[tail + 7] == index or row[tail + 8] == index else 0

    def measure_arc(self, row: memoryview[float], base: int, feed_v: float) -> None:
        """``measure`` for an arc, a helix where further axes move.

        Of the acceleration ``a`` that both axes of the plane have, the centripetal part takes a
        share ``s``, so that along the path ``a * sqrt(1 - s²)`` is left. The speed is the one that
        is fastest over the arc from rest to rest, not above what is programmed.
        """
        tail = base + 12 + 2 * self.count
        first = int(row[tail + 7])
        second = int(row[tail + 8])
        x = row[base + 12 + first] - row[tail + 9]
        y = row[base + 12 + second] - row[tail + 10]
        radius = arithmetic.square_root(x * x + y * y)
        angle = row[tail + 11] * 0.017453292519943295
        way = radius * (angle if angle > 0.0 else 0.0 - angle)
        length2 = way * way
        for i in range(self.count):
            if self.linear[i] and not self.in_plane(row, base, i):
                rise = row[base + 12 + self.count + i] - row[base + 12 + i]
                length2 += rise * rise
        length = arithmetic.square_root(length2)
        row[base + 3] = length
        self.bound(row, base, feed_v)
        part = way / length
        plane_a = min(self.feed_a[first], self.feed_a[second])
        highest = min(row[base + 5], min(self.most_v[first], self.most_v[second]) / part)
        wanted = min(feed_v * self.most_factor, highest)
        self.bend = min(wanted * part * wanted * part / (radius * plane_a), 0.95)
        best_t = 1e300
        best_v = 0.0
        best_a = 0.0
        share = self.bend
        for _ in range(6):
            speed = min(arithmetic.square_root(share * radius * plane_a) / part, wanted)
            limit_a = plane_a * arithmetic.square_root(1.0 - share * share) / part
            limit_a = min(limit_a, row[base + 6])
            time = length / speed + speed / limit_a
            if speed * speed > limit_a * length:
                time = 2.0 * arithmetic.square_root(length / limit_a)
            if time < best_t:
                best_t = time
                best_v = speed
                best_a = limit_a
                self.bend = share
            share *= 0.85
        row[base + 5] = min(highest, best_v)
        row[base + 6] = best_a

    # --- from one segment to the next -----------------------------------------------------------

    def leave(self, row: memoryview[float], base: int, length: float, deviation: float) -> None:
        """Keep what the next segment needs to know of this one, ``length`` as programmed."""
        shape.direct(row, base, self.count, 1, self.leaving)
        self.last_bend = self.bend
        self.last_length = length
        self.last_deviation = deviation

    def join(self, row: memoryview[float], before: int, base: int) -> None:
        """Settle how the path passes from the segment at ``before`` to that at ``base``."""
        tail = before + 12 + 2 * self.count
        row[tail + 12] = row[base + 4]
        for i in range(self.count):
            self.steps[i] = self.entering[i] - self.leaving[i]
            if self.steps[i] < 0.0:
                self.steps[i] = 0.0 - self.steps[i]
        if self.last_deviation > 0.0 and row[before + 9] == 0.0 and row[base + 9] == 0.0:
            if self.round_corner(row, before, base):
                return
        self.pass_corner(row, before, base)

    def axis_acceleration(self, index: int) -> float:
        """What an axis can do in both segments of a corner."""
        return min(self.rapid_a[index], self.feed_a[index])

    def speed_of(self, row: memoryview[float], base: int) -> float:
        """The highest speed that a segment is ever driven with."""
        return min(row[base + 4] * self.most_factor, row[base + 5])

    def pass_corner(self, row: memoryview[float], before: int, base: int) -> None:
        """The highest speed at a corner, and the zones around it with acceleration in reserve."""
        bend = max(self.bend, self.last_bend)
        reserve = min(0.7, 1.0 - arithmetic.square_root(bend * bend + 0.0025))
        shortest = min(row[before + 3], row[base + 3])
        limit_v = 1e300
        least_a = 1e300
        for i in range(self.count):
            if self.steps[i] > 0.0:
                step_a = self.axis_acceleration(i) * reserve / self.steps[i]
                limit_v = min(limit_v, step_a * self.tick_t)
                limit_v = min(limit_v, arithmetic.square_root(step_a * shortest))
                least_a = min(least_a, self.axis_acceleration(i))
        if limit_v < 2.5 * least_a * self.tick_t and limit_v < 1e299:
            row[before + 11] = 0.0
            return
        row[before + 11] = limit_v
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
        tail = base + 12 + 2 * self.count
        way = speed * self.tick_t + row[base + 6] * self.tick_t * self.tick_t
        if row[base + 9] == 1.0:
            bend = self.last_bend if at_end else self.bend
            left2 = (1.0 - most) * (1.0 - most) - bend * bend
            limit_a = row[base + 6] * arithmetic.square_root(left2 / (1.0 - bend * bend))
        else:
            limit_a = row[base + 6]
            for i in range(self.count):
                part = self.leaving[i] if at_end else self.entering[i]
                part = part if part >= 0.0 else 0.0 - part
                if part > 0.0:
                    left_a = self.axis_acceleration(i) * (1.0 - self.shares[i])
                    limit_a = min(limit_a, left_a / part)
        if 3.0 * way > row[base + 3]:
            row[base + 6] = min(row[base + 6], limit_a)
            row[tail + 2] = min(row[tail + 2], limit_a)
            row[tail + 3] = min(row[tail + 3], limit_a)
        else:
            place = tail + 1 if at_end else tail
            row[place] = way
            row[place + 2] = limit_a

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
        half = min(4.0 * self.last_deviation / size, 0.5 * min(self.last_length, row[base + 3]))
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
        tail = before + 12 + 2 * self.count
        row[tail + 4] = half
        row[tail + 5] = min(arithmetic.square_root(curve_v2), speed)
        row[tail + 6] = curve_a
        for i in range(self.count):
            place = row[before + 12 + self.count + i] + half * self.entering[i]
            row[tail + 19 + i] = place
            row[base + 12 + i] = place
        row[base + 3] -= half
        row[before + 11] = 1e300
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
        tail = 12 + 2 * self.count
        speed = min(row[base + 4], row[base + 5])
        entry_v = shape.entry_speed(row, base, self.count, 0, 0.0, speed)
        free_v = shape.entry_speed(row, base, self.count, 0, 0.0, row[base + 5])
        passed = 0
        while row[base + tail + 14] > 0.0:
            back = int(row[base + tail + 14])
            number = number - back
            if number < oldest:
                return 1 if entry_v >= promised_v and free_v >= promised_free_v else 0
            base = number % self.capacity * self.width
            entry_v = min(entry_v, row[base + 11])
            free_v = min(free_v, row[base + 11])
            if passed > 0 and entry_v == row[base + 7] and free_v == row[base + tail + 13]:
                return 1
            if passed >= self.blocks and entry_v >= row[base + 7]:
                if free_v >= row[base + tail + 13]:
                    return 1
            row[base + 7] = entry_v
            row[base + tail + 13] = free_v
            speed = min(row[base + 4], row[base + 5])
            entry_v = shape.entry_speed(row, base, self.count, 0, entry_v, speed)
            free_v = shape.entry_speed(row, base, self.count, 0, free_v, row[base + 5])
            passed += 1
        return 1

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
        row[base + 12 + 2 * self.count + 14] = back
        for i in range(self.width):
            self.spare[i] = row[base + i]
            self.spare[self.width + i] = row[before + i]
        self.join(row, before, base)
        if self.spread(row, number, oldest, promised_v, promised_free_v):
            return
        for i in range(self.width):
            row[base + i] = self.spare[i]
            row[before + i] = self.spare[self.width + i]
        self.spread(row, number, oldest, 0.0, 0.0)

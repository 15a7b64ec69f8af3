# SPDX-License-Identifier: MIT
"""Look-ahead with a limit of the jerk: speeds at corners, what the path brakes for (MO-1, MO-3).

A corner where an axis changes its speed in a step, or its acceleration because the curvature
changes, is passed so slowly that the axis keeps its jerk in each tick; what the corner uses is
missing on the two segments.

The path brakes for *goals*: corners, lesser feeds and the stand at the end, each with its speed and
no acceleration. A place where the path that brakes for a goal behind it is slow enough anyway is
none. Each segment keeps the nearest goal at or behind its end: the way to it, its speed, and
acceleration and jerk on this way. So ramps go over any number of segments.

What holds at each place: the speed that would be left once the acceleration has faded is not above
that of the goal at this place, or the goal ahead can still be reached. A goal's speed is therefore
one from which the next goal can be reached even where the path comes with all its acceleration
(``slowing_way``). Acceleration and jerk of a segment are at most those of the next one, and of
those behind it where that is short, since the acceleration may not have faded before. Both ends of
a bend (``corner_rounding.py``) are goals; the line in front of it keeps what it has, since it ends
with no acceleration, whatever is commanded.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.path import geometry
from nctakt.kernel.path.segment_limits import SegmentLimits


class JerkAhead(SegmentLimits):
    """How the segments of one channel go on into each other with a limit of the jerk."""

    # --- corners --------------------------------------------------------------------------------

    def leave_smoothly(self, row: memoryview[float], base: int) -> None:
        """Keep the curvature at the end of a segment, and how the path has come into it."""
        geometry.curve(row, base, self.count, 1, self.leaving_curve)
        self.last_corner_v = self.corner_v
        self.last_is_bent = self.is_bent

    def join_smoothly(self, row: memoryview[float], before: int, base: int) -> None:
        """The highest speed at the corner between two segments; what it uses is theirs no more.

        ``steps`` has the step of each axis' part of the way. In a tick³ a step of the speed counts
        at most once, one of the acceleration 3/4; several corners in a tick add up.
        """
        geometry.curve(row, base, self.count, 0, self.entering_curve)
        shortest = min(row[before + rows.LENGTH], row[base + rows.LENGTH])
        speed = 1e300
        for i in range(self.count):
            turn = self.entering_curve[i] - self.leaving_curve[i]
            turn = turn if turn >= 0.0 else 0.0 - turn
            self.turns[i] = turn
            speed = min(speed, self.corner_speed(i, shortest, turn))
        if self.last_is_bent:
            speed = min(speed, row[before + rows.LENGTH] / (3.0 * self.tick_t))
        if speed < 4.0 * self.least_jerk(row, before, base) * self.tick_t * self.tick_t:
            row[before + rows.CORNER_SPEED] = 0.0
            return
        row[before + rows.CORNER_SPEED] = speed
        speed = min(speed, self.speed_of(row, before), self.speed_of(row, base))
        self.corner_v = speed
        passed = speed * self.tick_t / shortest
        most_j = 0.0
        for i in range(self.count):
            step = self.steps[i] * speed * (1.0 + 1.5 * passed) / self.tick_t
            turn = self.turns[i] * speed * speed * (0.75 + passed)
            self.shares[i] = step
            self.turns[i] = (step / self.tick_t) + turn / self.tick_t
            most_j = max(most_j, self.turns[i])
        if most_j > 0.0:
            self.use(row, before, self.leaving)
            self.use(row, base, self.entering)

    def corner_speed(self, i: int, shortest: float, turn: float) -> float:
        """The highest speed at a corner for one axis: at most 0.7 of its jerk is used."""
        step = self.steps[i]
        if step <= 1e-12:
            step = 0.0
        if turn <= 1e-12:
            turn = 0.0
        most_a = self.axis_jerk(i) * self.tick_t * (0.35 if step > 0.0 and turn > 0.0 else 0.7)
        speed = 1e300
        if step > 0.0:
            more = 6.0 * step * self.tick_t * most_a * self.tick_t / shortest
            root = arithmetic.square_root(step * step + more)
            speed = 2.0 * most_a * self.tick_t / (step + root)
        if turn > 0.0:
            slower = arithmetic.square_root(most_a / (0.75 * turn))
            density = 0.75 + min(slower, speed) * self.tick_t / shortest
            speed = min(speed, arithmetic.square_root(most_a / (density * turn)))
        return speed

    def axis_jerk(self, index: int) -> float:
        """The jerk that an axis can do in both segments of a corner."""
        return min(self.rapid_j[index], self.feed_j[index])

    def least_jerk(self, row: memoryview[float], before: int, base: int) -> float:
        """The lesser jerk along the path."""
        return min(row[before + rows.JERK], row[base + rows.JERK])

    def use(self, row: memoryview[float], base: int, parts: memoryview[float]) -> None:
        """A corner uses acceleration and jerk of the axes: less is left along a segment."""
        if row[base + rows.SHAPE] == rows.ARC:
            self.smooth_arc(row, base, 1)
        for i in range(self.count):
            part = parts[i] if parts[i] >= 0.0 else 0.0 - parts[i]
            if part > 0.0 and not self.in_plane(row, base, i):
                least_a = min(self.rapid_slope_a[i], self.feed_slope_a[i])
                left_a = (least_a - self.shares[i]) / part
                left_j = (self.axis_jerk(i) - self.turns[i]) / part
                row[base + rows.ACCELERATION] = min(row[base + rows.ACCELERATION], left_a)
                row[base + rows.JERK] = min(row[base + rows.JERK], left_j)

    def speed_of(self, row: memoryview[float], base: int) -> float:
        """The highest speed that a segment is ever driven with."""
        return min(row[base + rows.SPEED] * self.most_factor, row[base + rows.MAX_SPEED])

    # --- goals ----------------------------------------------------------------------------------

    def spread_smoothly(
        self, row: memoryview[float], number: int, oldest: int, is_promised: int
    ) -> int:
        """The goals of the segments before ``number``, which ends with a stand.

        ``oldest`` is the first command of the queue that is not current. 0 where the current
        segment has been promised (``is_promised``) more than can be kept: some segment behind it
        has less acceleration or jerk by now.
        """
        base = number % self.capacity * self.width
        self.stand_at_end(row, base)
        is_less = 0
        passed = 0
        while row[base + rows.PREDECESSOR] > 0.0:
            self.way = row[base + rows.LENGTH] + row[base + rows.GOAL_LENGTH]
            self.goal_v = row[base + rows.GOAL_SPEED]
            goal_a = row[base + rows.GOAL_ACCELERATION]
            self.goal_a = min(goal_a, row[base + rows.CARRIED_ACCELERATION])
            self.goal_j = min(row[base + rows.GOAL_JERK], row[base + rows.CARRIED_JERK])
            self.goal_kind = int(row[base + rows.GOAL_KIND])
            back = int(row[base + rows.PREDECESSOR])
            number = number - back
            if number < oldest:
                return 0 if is_less and is_promised else 1
            before = number % self.capacity * self.width
            self.lend(row, before, base)
            lent = self.borrow(row, before)
            self.stop_before(row, before, base)
            is_less = 1 if lent < 0 else is_less
            if is_less == 0 and passed & codes.FAR_CHECK == codes.FAR_CHECK:
                if passed >= self.blocks or self.is_far(row, before, self.speed_of(row, before)):
                    return 1
            if self.keep(row, before) == 0 and lent == 0 and passed > 0:
                return 1
            base = before
            passed += 0 if row[base + rows.SHAPE] == rows.ROUNDING else 1
        return 1

    def is_far(self, row: memoryview[float], base: int, speed: float) -> int:
        """Whether the goal of a segment is so far away that the speed on it depends on no goal."""
        goal_a = row[base + rows.GOAL_ACCELERATION]
        goal_j = row[base + rows.GOAL_JERK]
        way = self.slowing_way(speed, row[base + rows.GOAL_SPEED], goal_a, goal_j)
        return 1 if way <= row[base + rows.GOAL_LENGTH] else 0

    def keep(self, row: memoryview[float], base: int) -> int:
        """Keep the goal at the end of a segment: whether it is another one."""
        is_new = 0
        if row[base + rows.GOAL_LENGTH] != self.way or row[base + rows.GOAL_SPEED] != self.goal_v:
            is_new = 1
        elif row[base + rows.GOAL_ACCELERATION] != self.goal_a:
            is_new = 1
        elif row[base + rows.GOAL_JERK] != self.goal_j:
            is_new = 1
        row[base + rows.GOAL_LENGTH] = self.way
        row[base + rows.GOAL_SPEED] = self.goal_v
        row[base + rows.GOAL_ACCELERATION] = self.goal_a
        row[base + rows.GOAL_JERK] = self.goal_j
        row[base + rows.GOAL_KIND] = self.goal_kind
        return is_new

    def stop_before(self, row: memoryview[float], before: int, base: int) -> None:
        """Make the place between two segments the goal where the one ahead does not suffice."""
        self.stop_at(row, before, base, row[before + rows.CORNER_SPEED])

    def stop_at(self, row: memoryview[float], before: int, base: int, top_v: float) -> None:
        """``stop_before``; ``top_v``: the highest speed from the one segment into the other."""
        goal_kind = rows.LIMIT_GOAL
        is_exempt = row[base + rows.IGNORES_OVERRIDE] > 0.0
        is_other = is_exempt != (row[before + rows.IGNORES_OVERRIDE] > 0.0)
        feed_v = row[base + rows.SPEED]
        if row[base + rows.MAX_SPEED] < self.speed_of(row, before):
            top_v = min(top_v, row[base + rows.MAX_SPEED])
        if (feed_v < row[before + rows.SPEED] or is_other) and feed_v < top_v:
            top_v = feed_v
            goal_kind = rows.EXEMPT_FEED_GOAL if is_exempt else rows.FEED_GOAL
        is_rounding = row[before + rows.SHAPE] == rows.ROUNDING
        if is_rounding or row[base + rows.SHAPE] == rows.ROUNDING:
            top_v = min(top_v, self.speed_of(row, before), self.speed_of(row, base))
        elif top_v > 1e299 or self.way <= self.reach(top_v):
            return
        self.goal_v = self.safe_speed(top_v)
        self.way = 0.0
        self.goal_a = 1e300
        self.goal_j = 1e300
        self.goal_kind = goal_kind

    def reach(self, speed: float) -> float:
        """From how far before the goal on the path that brakes for it is not faster than this."""
        change = speed - self.goal_v
        if change < 0.0:
            return -1.0
        ramp_t = self.goal_a / self.goal_j
        ramp_v = 0.5 * self.goal_a * ramp_t
        if change <= ramp_v:
            time = arithmetic.square_root(2.0 * change / self.goal_j)
            return time * (self.goal_v + self.goal_j * time * time / 6.0)
        way = ramp_t * (self.goal_v + self.goal_a * ramp_t / 6.0)
        from_v = self.goal_v + ramp_v
        return way + 0.5 * (speed * speed - from_v * from_v) / self.goal_a

    def slowing_way(self, speed: float, goal_v: float, limit_a: float, limit_j: float) -> float:
        """The way to a lesser speed, from one that is reached once acceleration has faded.

        It fades from ``lent_a`` with ``lent_j``.
        """
        if speed <= goal_v:
            return 0.0
        time = arithmetic.square_root(2.0 * speed / self.lent_j)
        time = min(self.lent_a / self.lent_j, time)
        way = time * (speed - self.lent_j * time * time / 6.0)
        ramp_t = limit_a / limit_j
        change = speed - goal_v
        if change >= limit_a * ramp_t:
            time = change / limit_a + ramp_t
        else:
            time = 2.0 * arithmetic.square_root(change / limit_j)
        return way + 0.5 * (speed + goal_v) * time

    def safe_speed(self, top_v: float) -> float:
        """The highest speed up to ``top_v`` from which the goal ahead can be reached."""
        if self.slowing_way(top_v, self.goal_v, self.goal_a, self.goal_j) <= self.way:
            return top_v
        low = min(self.goal_v, top_v)
        high = top_v
        for _ in range(40):
            middle = 0.5 * (low + high)
            if self.slowing_way(middle, self.goal_v, self.goal_a, self.goal_j) <= self.way:
                low = middle
            else:
                high = middle
        return low

    def lend(self, row: memoryview[float], before: int, base: int) -> None:
        """The acceleration with which the path may come from ``before``; the jerk to take it back.

        It has faded at the end of ``base``, unless that is short.
        """
        self.lent_a = row[base + rows.ACCELERATION]
        self.lent_j = row[base + rows.JERK]
        if row[base + rows.LENGTH] * self.lent_j < self.speed_of(row, base) * self.lent_a:
            self.lent_a = min(self.lent_a, row[base + rows.CARRIED_ACCELERATION])
            self.lent_j = min(self.lent_j, row[base + rows.CARRIED_JERK])
            if row[base + rows.ROUNDING_LENGTH] > 0.0:
                self.lent_a = min(self.lent_a, row[base + rows.ROUNDING_ACCELERATION])
                self.lent_j = min(self.lent_j, row[base + rows.ROUNDING_JERK])
        if row[before + rows.CORNER_SPEED] == 0.0:
            self.lent_a = 1e300
            self.lent_j = 1e300

    def borrow(self, row: memoryview[float], before: int) -> int:
        """Acceleration and jerk of the segment before: -1 they become less, 1 more, 0 they stay."""
        self.lent_a = min(self.lent_a, row[before + rows.ACCELERATION])
        self.lent_j = min(self.lent_j, row[before + rows.JERK])
        if row[before + rows.ROUNDING_LENGTH] > 0.0:
            return 0
        old_a = row[before + rows.CARRIED_ACCELERATION]
        old_j = row[before + rows.CARRIED_JERK]
        row[before + rows.CARRIED_ACCELERATION] = self.lent_a
        row[before + rows.CARRIED_JERK] = self.lent_j
        if self.lent_a < old_a or self.lent_j < old_j:
            return -1
        return 0 if self.lent_a == old_a and self.lent_j == old_j else 1

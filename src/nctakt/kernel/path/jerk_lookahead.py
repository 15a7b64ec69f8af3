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
(``slowing_distance``). Acceleration and jerk of a segment are at most those of the next one, and of
those behind it where that is short, since the acceleration may not have faded before. Both ends of
a bend (``corner_rounding.py``) are goals; the line in front of it keeps what it has, since it ends
with no acceleration, whatever is commanded.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.path import geometry
from nctakt.kernel.path.segment_limits import SegmentLimits


class JerkLookAhead(SegmentLimits):
    """How the segments of one channel go on into each other with a limit of the jerk."""

    # --- corners --------------------------------------------------------------------------------

    def leave_with_jerk(self, segments: memoryview[float], row: int) -> None:
        """Keep the curvature at the end of a segment, and how the path has come into it."""
        geometry.curvature(segments, row, self.count, 1, self.leaving_curve)
        self.last_corner_v = self.corner_v
        self.last_is_rounded = self.is_rounded

    def join_with_jerk(self, segments: memoryview[float], before: int, row: int) -> None:
        """The highest speed at the corner between two segments; what it uses is theirs no more.

        ``steps`` has the step of each axis' part of the way. In a tick³ a step of the speed counts
        at most once, one of the acceleration 3/4; several corners in a tick add up.
        """
        geometry.curvature(segments, row, self.count, 0, self.entering_curve)
        shortest = min(segments[before + rows.LENGTH], segments[row + rows.LENGTH])
        speed = 1e300
        for i in range(self.count):
            turn = self.entering_curve[i] - self.leaving_curve[i]
            turn = turn if turn >= 0.0 else 0.0 - turn
            self.turns[i] = turn
            speed = min(speed, self.corner_speed(i, shortest, turn))
        if self.last_is_rounded:
            speed = min(speed, segments[before + rows.LENGTH] / (3.0 * self.tick_t))
        if speed < 4.0 * self.min_jerk(segments, before, row) * self.tick_t * self.tick_t:
            segments[before + rows.CORNER_SPEED] = 0.0
            return
        segments[before + rows.CORNER_SPEED] = speed
        speed = min(speed, self.speed_of(segments, before), self.speed_of(segments, row))
        self.corner_v = speed
        passed = speed * self.tick_t / shortest
        max_j = 0.0
        for i in range(self.count):
            step = self.steps[i] * speed * (1.0 + 1.5 * passed) / self.tick_t
            turn = self.turns[i] * speed * speed * (0.75 + passed)
            self.shares[i] = step
            self.turns[i] = (step / self.tick_t) + turn / self.tick_t
            max_j = max(max_j, self.turns[i])
        if max_j > 0.0:
            self.use_up(segments, before, self.leaving)
            self.use_up(segments, row, self.entering)

    def corner_speed(self, i: int, shortest: float, turn: float) -> float:
        """The highest speed at a corner for one axis: at most 0.7 of its jerk is used."""
        step = self.steps[i]
        if step <= 1e-12:
            step = 0.0
        if turn <= 1e-12:
            turn = 0.0
        max_a = self.axis_jerk(i) * self.tick_t * (0.35 if step > 0.0 and turn > 0.0 else 0.7)
        speed = 1e300
        if step > 0.0:
            more = 6.0 * step * self.tick_t * max_a * self.tick_t / shortest
            root = arithmetic.square_root(step * step + more)
            speed = 2.0 * max_a * self.tick_t / (step + root)
        if turn > 0.0:
            slower = arithmetic.square_root(max_a / (0.75 * turn))
            density = 0.75 + min(slower, speed) * self.tick_t / shortest
            speed = min(speed, arithmetic.square_root(max_a / (density * turn)))
        return speed

    def axis_jerk(self, index: int) -> float:
        """The jerk that an axis can do in both segments of a corner."""
        return min(self.rapid_j[index], self.feed_j[index])

    def min_jerk(self, segments: memoryview[float], before: int, row: int) -> float:
        """The lesser jerk along the path."""
        return min(segments[before + rows.JERK], segments[row + rows.JERK])

    def use_up(self, segments: memoryview[float], row: int, parts: memoryview[float]) -> None:
        """A corner uses acceleration and jerk of the axes: less is left along a segment."""
        if segments[row + rows.SHAPE] == rows.ARC:
            self.limit_jerk_on_arc(segments, row, 1)
        for i in range(self.count):
            part = parts[i] if parts[i] >= 0.0 else 0.0 - parts[i]
            if part > 0.0 and not self.in_plane(segments, row, i):
                min_a = min(self.rapid_slope_a[i], self.feed_slope_a[i])
                left_a = (min_a - self.shares[i]) / part
                left_j = (self.axis_jerk(i) - self.turns[i]) / part
                segments[row + rows.ACCELERATION] = min(segments[row + rows.ACCELERATION], left_a)
                segments[row + rows.JERK] = min(segments[row + rows.JERK], left_j)

    def speed_of(self, segments: memoryview[float], row: int) -> float:
        """The highest speed that a segment is ever driven with."""
        return min(segments[row + rows.SPEED] * self.max_factor, segments[row + rows.MAX_SPEED])

    # --- goals ----------------------------------------------------------------------------------

    def spread_with_jerk(
        self, segments: memoryview[float], number: int, oldest: int, is_promised: int
    ) -> int:
        """The goals of the segments before ``number``, which ends with a stand.

        ``oldest`` is the first command of the queue that is not current. 0 where the current
        segment has been promised (``is_promised``) more than can be kept: some segment behind it
        has less acceleration or jerk by now.
        """
        row = number % self.capacity * self.width
        self.stand_at_end(segments, row)
        is_less = 0
        passed = 0
        while segments[row + rows.PREDECESSOR] > 0.0:
            self.goal_d = segments[row + rows.LENGTH] + segments[row + rows.GOAL_LENGTH]
            self.goal_v = segments[row + rows.GOAL_SPEED]
            goal_a = segments[row + rows.GOAL_ACCELERATION]
            self.goal_a = min(goal_a, segments[row + rows.CARRIED_ACCELERATION])
            self.goal_j = min(segments[row + rows.GOAL_JERK], segments[row + rows.CARRIED_JERK])
            self.goal_kind = int(segments[row + rows.GOAL_KIND])
            back = int(segments[row + rows.PREDECESSOR])
            number = number - back
            if number < oldest:
                return 0 if is_less and is_promised else 1
            before = number % self.capacity * self.width
            self.carry_back(segments, before, row)
            change = self.take_over(segments, before)
            self.slow_before(segments, before, row)
            is_less = 1 if change < 0 else is_less
            if is_less == 0 and passed & codes.FAR_CHECK == codes.FAR_CHECK:
                if passed >= self.blocks or self.is_far(
                    segments, before, self.speed_of(segments, before)
                ):
                    return 1
            if self.store_goal(segments, before) == 0 and change == 0 and passed > 0:
                return 1
            row = before
            passed += 0 if segments[row + rows.SHAPE] == rows.ROUNDING else 1
        return 1

    def is_far(self, segments: memoryview[float], row: int, speed: float) -> int:
        """Whether the goal of a segment is so far away that the speed on it depends on no goal."""
        goal_a = segments[row + rows.GOAL_ACCELERATION]
        goal_j = segments[row + rows.GOAL_JERK]
        distance = self.slowing_distance(speed, segments[row + rows.GOAL_SPEED], goal_a, goal_j)
        return 1 if distance <= segments[row + rows.GOAL_LENGTH] else 0

    def store_goal(self, segments: memoryview[float], row: int) -> int:
        """Keep the goal at the end of a segment: whether it is another one."""
        is_new = 0
        if (
            segments[row + rows.GOAL_LENGTH] != self.goal_d
            or segments[row + rows.GOAL_SPEED] != self.goal_v
        ):
            is_new = 1
        elif segments[row + rows.GOAL_ACCELERATION] != self.goal_a:
            is_new = 1
        elif segments[row + rows.GOAL_JERK] != self.goal_j:
            is_new = 1
        segments[row + rows.GOAL_LENGTH] = self.goal_d
        segments[row + rows.GOAL_SPEED] = self.goal_v
        segments[row + rows.GOAL_ACCELERATION] = self.goal_a
        segments[row + rows.GOAL_JERK] = self.goal_j
        segments[row + rows.GOAL_KIND] = self.goal_kind
        return is_new

    def slow_before(self, segments: memoryview[float], before: int, row: int) -> None:
        """Make the place between two segments the goal where the one ahead does not suffice."""
        self.stop_at(segments, before, row, segments[before + rows.CORNER_SPEED])

    def stop_at(self, segments: memoryview[float], before: int, row: int, top_v: float) -> None:
        """``slow_before``; ``top_v``: the highest speed from the one segment into the other."""
        goal_kind = rows.LIMIT_GOAL
        is_exempt = segments[row + rows.IGNORES_OVERRIDE] > 0.0
        is_other = is_exempt != (segments[before + rows.IGNORES_OVERRIDE] > 0.0)
        feed_v = segments[row + rows.SPEED]
        if segments[row + rows.MAX_SPEED] < self.speed_of(segments, before):
            top_v = min(top_v, segments[row + rows.MAX_SPEED])
        if (feed_v < segments[before + rows.SPEED] or is_other) and feed_v < top_v:
            top_v = feed_v
            goal_kind = rows.EXEMPT_FEED_GOAL if is_exempt else rows.FEED_GOAL
        is_rounding = segments[before + rows.SHAPE] == rows.ROUNDING
        if is_rounding or segments[row + rows.SHAPE] == rows.ROUNDING:
            top_v = min(top_v, self.speed_of(segments, before), self.speed_of(segments, row))
        elif top_v > 1e299 or self.goal_d <= self.braking_distance(top_v):
            return
        self.goal_v = self.safe_speed(top_v)
        self.goal_d = 0.0
        self.goal_a = 1e300
        self.goal_j = 1e300
        self.goal_kind = goal_kind

    def braking_distance(self, speed: float) -> float:
        """From how far before the goal on the path that brakes for it is not faster than this."""
        change = speed - self.goal_v
        if change < 0.0:
            return -1.0
        ramp_t = self.goal_a / self.goal_j
        ramp_v = 0.5 * self.goal_a * ramp_t
        if change <= ramp_v:
            time = arithmetic.square_root(2.0 * change / self.goal_j)
            return time * (self.goal_v + self.goal_j * time * time / 6.0)
        distance = ramp_t * (self.goal_v + self.goal_a * ramp_t / 6.0)
        from_v = self.goal_v + ramp_v
        return distance + 0.5 * (speed * speed - from_v * from_v) / self.goal_a

    def slowing_distance(
        self, speed: float, goal_v: float, limit_a: float, limit_j: float
    ) -> float:
        """The way to a lesser speed, from one that is reached once acceleration has faded.

        It fades from ``carried_a`` with ``carried_j``.
        """
        if speed <= goal_v:
            return 0.0
        time = arithmetic.square_root(2.0 * speed / self.carried_j)
        time = min(self.carried_a / self.carried_j, time)
        distance = time * (speed - self.carried_j * time * time / 6.0)
        ramp_t = limit_a / limit_j
        change = speed - goal_v
        if change >= limit_a * ramp_t:
            time = change / limit_a + ramp_t
        else:
            time = 2.0 * arithmetic.square_root(change / limit_j)
        return distance + 0.5 * (speed + goal_v) * time

    def safe_speed(self, top_v: float) -> float:
        """The highest speed up to ``top_v`` from which the goal ahead can be reached."""
        if self.slowing_distance(top_v, self.goal_v, self.goal_a, self.goal_j) <= self.goal_d:
            return top_v
        low = min(self.goal_v, top_v)
        high = top_v
        for _ in range(40):
            middle = 0.5 * (low + high)
            if self.slowing_distance(middle, self.goal_v, self.goal_a, self.goal_j) <= self.goal_d:
                low = middle
            else:
                high = middle
        return low

    def carry_back(self, segments: memoryview[float], before: int, row: int) -> None:
        """The acceleration with which the path may come from ``before``; the jerk to take it back.

        It has faded at the end of ``row``, unless that is short.
        """
        self.carried_a = segments[row + rows.ACCELERATION]
        self.carried_j = segments[row + rows.JERK]
        if (
            segments[row + rows.LENGTH] * self.carried_j
            < self.speed_of(segments, row) * self.carried_a
        ):
            self.carried_a = min(self.carried_a, segments[row + rows.CARRIED_ACCELERATION])
            self.carried_j = min(self.carried_j, segments[row + rows.CARRIED_JERK])
            if segments[row + rows.ROUNDING_LENGTH] > 0.0:
                self.carried_a = min(self.carried_a, segments[row + rows.ROUNDING_ACCELERATION])
                self.carried_j = min(self.carried_j, segments[row + rows.ROUNDING_JERK])
        if segments[before + rows.CORNER_SPEED] == 0.0:
            self.carried_a = 1e300
            self.carried_j = 1e300

    def take_over(self, segments: memoryview[float], before: int) -> int:
        """Acceleration and jerk of the segment before: -1 they become less, 1 more, 0 they stay."""
        self.carried_a = min(self.carried_a, segments[before + rows.ACCELERATION])
        self.carried_j = min(self.carried_j, segments[before + rows.JERK])
        if segments[before + rows.ROUNDING_LENGTH] > 0.0:
            return 0
        old_a = segments[before + rows.CARRIED_ACCELERATION]
        old_j = segments[before + rows.CARRIED_JERK]
        segments[before + rows.CARRIED_ACCELERATION] = self.carried_a
        segments[before + rows.CARRIED_JERK] = self.carried_j
        if self.carried_a < old_a or self.carried_j < old_j:
            return -1
        return 0 if self.carried_a == old_a and self.carried_j == old_j else 1

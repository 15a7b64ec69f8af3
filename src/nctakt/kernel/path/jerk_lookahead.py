# SPDX-License-Identifier: MIT
"""Look-ahead with a jerk limit: speeds at corners, goals that the path brakes for (MO-1, MO-3).

A corner where an axis changes its speed in a step, or its acceleration because the curvature
changes, is passed so slowly that the axis keeps its jerk limit in each tick; the share that the
corner uses is missing on the two segments.

The path brakes for *goals*: corners, lesser feeds and the stop at the end, each with its speed and
no acceleration. A point where the path that brakes for a later goal is slow enough anyway is
none. Each segment keeps the nearest goal at or after its end: the distance to it, its speed, and
acceleration and jerk on this distance. So ramps go over any number of segments.

At each point the following holds: the speed that would be left once the acceleration has faded is
not above that of the goal at this point, or the goal ahead can still be reached. A goal's speed is
therefore one from which the next goal can be reached even where the path comes with all its
acceleration (``Goal.slowing_distance``). Acceleration and jerk of a segment are at most those of
the next one, and of those after it where that is short, since the acceleration may not have faded
before. Both ends of a rounding (``corner_rounding.py``) are goals; the line before it keeps
what it has, since it ends with no acceleration, whatever is commanded.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.path.corner import Corner
from nctakt.kernel.path.goal import Goal
from nctakt.kernel.path.segment_limits import SegmentLimits


class JerkLookAhead:
    """How the segments of one channel are joined with a jerk limit.

    ``capacity``: rows of the queue; ``blocks``: how many of them are looked ahead (P-CHAN-00653).
    """

    def __init__(self, limits: SegmentLimits, corner: Corner, blocks: int) -> None:
        self.limits = limits
        self.corner = corner
        self.goal = Goal()
        self.stored = Goal()
        self.width = rows.segment_width(limits.room)
        self.capacity = 0
        self.blocks = blocks

    # --- corners --------------------------------------------------------------------------------

    def join(self, segments: memoryview[float], before: int, row: int) -> None:
        """Compute the speed at the corner between two segments, and the limits left to both.

        ``steps`` has the step of each axis' part of the length. In a tick³ a step of the speed
        counts at most once, one of the acceleration 3/4; several corners in a tick add up.
        """
        self.corner.enter_curve(segments, row)
        shortest = min(segments[before + rows.LENGTH], segments[row + rows.LENGTH])
        speed = 1e300
        for i in range(self.limits.count):
            turn = self.corner.entering_curve[i] - self.corner.leaving_curve[i]
            turn = turn if turn >= 0.0 else 0.0 - turn
            self.corner.turns[i] = turn
            speed = min(speed, self.corner.corner_speed(i, shortest, turn))
        if self.corner.last_is_rounded:
            speed = min(speed, segments[before + rows.LENGTH] / (3.0 * self.limits.tick_t))
        if (
            speed
            < 4.0 * self.min_jerk(segments, before, row) * self.limits.tick_t * self.limits.tick_t
        ):
            segments[before + rows.CORNER_SPEED] = 0.0
            return
        segments[before + rows.CORNER_SPEED] = speed
        speed = min(
            speed,
            self.limits.speed_of(segments[before + rows.SPEED], segments[before + rows.MAX_SPEED]),
            self.limits.speed_of(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED]),
        )
        self.corner.corner_v = speed
        passed = speed * self.limits.tick_t / shortest
        max_j = 0.0
        for i in range(self.limits.count):
            step = self.corner.steps[i] * speed * (1.0 + 1.5 * passed) / self.limits.tick_t
            turn = self.corner.turns[i] * speed * speed * (0.75 + passed)
            self.corner.shares[i] = step
            self.corner.turns[i] = (step / self.limits.tick_t) + turn / self.limits.tick_t
            max_j = max(max_j, self.corner.turns[i])
        if max_j > 0.0:
            self.use_up(segments, before, self.corner.leaving, self.corner.last_is_bent)
            self.use_up(segments, row, self.corner.entering, self.corner.is_bent)

    def min_jerk(self, segments: memoryview[float], before: int, row: int) -> float:
        """Lower of both jerks along the path, per s³."""
        return min(segments[before + rows.JERK], segments[row + rows.JERK])

    def use_up(
        self, segments: memoryview[float], row: int, parts: memoryview[float], is_bent: int
    ) -> None:
        """Subtract the acceleration and jerk of the axes that a corner uses on a segment.

        ``is_bent``: a transformation bends the axes' motion, which takes a share of both.
        """
        free_a = self.limits.transformed.free_a if is_bent else 1.0
        free_j = self.limits.transformed.free_j if is_bent else 1.0
        if segments[row + rows.SHAPE] == rows.ARC and segments[row + rows.TRANSFORMATION] == 0.0:
            self.limits.limit_jerk_on_arc(segments, row, self.corner.shares, self.corner.turns)
        for i in range(self.limits.count):
            part = parts[i] if parts[i] >= 0.0 else 0.0 - parts[i]
            if part > 0.0 and not self.limits.in_plane(segments, row, i):
                left_a = (self.limits.slope_acceleration(i) * free_a - self.corner.shares[i]) / part
                left_j = (self.limits.axis_jerk(i) * free_j - self.corner.turns[i]) / part
                segments[row + rows.ACCELERATION] = min(segments[row + rows.ACCELERATION], left_a)
                segments[row + rows.JERK] = min(segments[row + rows.JERK], left_j)

    # --- goals ----------------------------------------------------------------------------------

    def spread(
        self, segments: memoryview[float], number: int, oldest: int, is_promised: int
    ) -> int:
        """Settle the goals of the segments before ``number``, which ends at a standstill.

        ``oldest`` is the first command of the queue that is not current. 0 where the current
        segment has been promised (``is_promised``) more than can be kept: some segment after it
        has less acceleration or jerk by now.
        """
        row = number % self.capacity * self.width
        self.limits.stop_at_end(segments, row)
        is_less = 0
        passed = 0
        while segments[row + rows.PREDECESSOR] > 0.0:
            self.goal.load(segments, row)
            back = int(segments[row + rows.PREDECESSOR])
            number = number - back
            if number < oldest:
                return 0 if is_less and is_promised else 1
            before = number % self.capacity * self.width
            self.carry_back(segments, before, row)
            change = self.take_over(segments, before)
            corner_v = segments[before + rows.CORNER_SPEED]
            self.slow_before(self.goal, segments, before, row, corner_v)
            is_less = 1 if change < 0 else is_less
            if is_less == 0 and passed & codes.FAR_CHECK == codes.FAR_CHECK:
                if passed >= self.blocks or self.is_far(
                    segments,
                    before,
                    self.limits.speed_of(
                        segments[before + rows.SPEED], segments[before + rows.MAX_SPEED]
                    ),
                ):
                    return 1
            if self.goal.store(segments, before) == 0 and change == 0 and passed > 0:
                return 1
            row = before
            passed += 0 if segments[row + rows.SHAPE] == rows.ROUNDING else 1
        return 1

    def is_far(self, segments: memoryview[float], row: int, speed: float) -> int:
        """Return whether a segment's goal is so far ahead that the speed on it depends on none.

        ``speed``: the highest one on the segment.
        """
        self.stored.load_end(segments, row, self.goal.carried_a, self.goal.carried_j)
        return 1 if self.stored.slowing_distance(speed) <= self.stored.distance_d else 0

    def slow_before(
        self, goal: Goal, segments: memoryview[float], before: int, row: int, top_v: float
    ) -> None:
        """Move the goal between two segments if the one ahead does not suffice.

        ``top_v``: the highest speed from the segment at ``before`` into the one at ``row``.
        """
        goal_kind = rows.LIMIT_GOAL
        is_exempt = segments[row + rows.IGNORES_OVERRIDE] > 0.0
        is_other = is_exempt != (segments[before + rows.IGNORES_OVERRIDE] > 0.0)
        feed_v = segments[row + rows.SPEED]
        if segments[row + rows.MAX_SPEED] < self.limits.speed_of(
            segments[before + rows.SPEED], segments[before + rows.MAX_SPEED]
        ):
            top_v = min(top_v, segments[row + rows.MAX_SPEED])
        if (feed_v < segments[before + rows.SPEED] or is_other) and feed_v < top_v:
            top_v = feed_v
            goal_kind = rows.EXEMPT_FEED_GOAL if is_exempt else rows.FEED_GOAL
        is_rounding = segments[before + rows.SHAPE] == rows.ROUNDING
        if is_rounding or segments[row + rows.SHAPE] == rows.ROUNDING:
            top_v = min(
                top_v,
                self.limits.speed_of(
                    segments[before + rows.SPEED], segments[before + rows.MAX_SPEED]
                ),
                self.limits.speed_of(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED]),
            )
        elif top_v > 1e299 or goal.distance_d <= goal.braking_distance(top_v):
            return
        goal.move(goal.safe_speed(top_v), goal_kind)

    def carry_back(self, segments: memoryview[float], before: int, row: int) -> None:
        """Settle the acceleration and jerk that the path may carry over from ``before``.

        It has faded at the end of ``row``, unless that is short.
        """
        self.goal.carried_a = segments[row + rows.ACCELERATION]
        self.goal.carried_j = segments[row + rows.JERK]
        if (
            segments[row + rows.LENGTH] * self.goal.carried_j
            < self.limits.speed_of(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED])
            * self.goal.carried_a
        ):
            self.goal.carried_a = min(
                self.goal.carried_a, segments[row + rows.CARRIED_ACCELERATION]
            )
            self.goal.carried_j = min(self.goal.carried_j, segments[row + rows.CARRIED_JERK])
            if segments[row + rows.ROUNDING_LENGTH] > 0.0:
                self.goal.carried_a = min(
                    self.goal.carried_a, segments[row + rows.ROUNDING_ACCELERATION]
                )
                self.goal.carried_j = min(self.goal.carried_j, segments[row + rows.ROUNDING_JERK])
        if segments[before + rows.CORNER_SPEED] == 0.0:
            self.goal.carried_a = 1e300
            self.goal.carried_j = 1e300

    def take_over(self, segments: memoryview[float], before: int) -> int:
        """Carry the limits into the segment before: -1 less, 0 the same, 1 more than yet."""
        self.goal.carried_a = min(self.goal.carried_a, segments[before + rows.ACCELERATION])
        self.goal.carried_j = min(self.goal.carried_j, segments[before + rows.JERK])
        if segments[before + rows.ROUNDING_LENGTH] > 0.0:
            return 0
        old_a = segments[before + rows.CARRIED_ACCELERATION]
        old_j = segments[before + rows.CARRIED_JERK]
        segments[before + rows.CARRIED_ACCELERATION] = self.goal.carried_a
        segments[before + rows.CARRIED_JERK] = self.goal.carried_j
        if self.goal.carried_a < old_a or self.goal.carried_j < old_j:
            return -1
        return 0 if self.goal.carried_a == old_a and self.goal.carried_j == old_j else 1

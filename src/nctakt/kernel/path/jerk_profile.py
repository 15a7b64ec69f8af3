# SPDX-License-Identifier: MIT
"""The speed along the path with a jerk limit: state, limits, goal ahead -> a plan (MO-1).

The plan leads from the present speed and acceleration to the goal of the segment
(``jerk_lookahead.py``), which may be several segments ahead; it is followed up to the segment's end
and recomputed there from the speed and acceleration reached, or where the speed limit changes.
"""

from __future__ import annotations

import math

from nctakt.kernel import rows
from nctakt.kernel.axes.trajectory import Trajectories


class JerkProfile:
    """Plan of one path with limited jerk, and the acceleration that it has reached.

    ``distance_d``, ``speed_v``: results of ``advance``; ``left_t``: time left after the end of the
    segment.
    """

    def __init__(self, cycle_time_t: float) -> None:
        self.course = Trajectories(1)
        self.tick_t = cycle_time_t
        self.acceleration_a = 0.0
        self.distance_d = 0.0
        self.speed_v = 0.0
        self.left_t = 0.0
        self.rest_d = 0.0
        self.ends_in_time = False
        self.stops_at_end = False
        self.own_j = 0.0

    def begin(self) -> None:
        """Begin another segment."""
        self.stops_at_end = False

    def plan(
        self,
        segments: memoryview[float],
        row: int,
        rest_d: float,
        speed_v: float,
        limit_v: float,
        factor: float,
        is_single: int,
    ) -> None:
        """Plan the rest of a segment up to its goal; to a standstill where ``limit_v`` is 0.

        ``row``: where the segment's row begins. In single block the segment's end is the goal if
        the path can still stop there; it brakes with the limits of the segment, and so may be too
        fast for the goal ahead, which requires less, when single block is switched off: then it
        stops at the end anyway. It no longer does once the goal is within reach, since it then
        leaves the distance on which it could stop there.
        """
        limit_a = segments[row + rows.CARRIED_ACCELERATION]
        limit_j = segments[row + rows.CARRIED_JERK]
        self.own_j = segments[row + rows.JERK]
        self.rest_d = rest_d
        self.ends_in_time = False
        settles = segments[row + rows.ROUNDING_LENGTH] > 0.0
        if limit_v <= 0.0:
            if settles and not self.can_stop(speed_v, limit_a, limit_j):
                self.fade_by_end(0.0, speed_v, limit_a, limit_j)
            else:
                self.head_for(0.0, 0.0, speed_v, 0.0, limit_a, limit_j)
            return
        if is_single:
            self.stops_at_end = self.can_stop(speed_v, limit_a, limit_j) > 0
            if self.stops_at_end:
                self.stop_at_end(speed_v, limit_v, limit_a, limit_j)
                return
        goal_d = segments[row + rows.GOAL_LENGTH]
        goal_v = segments[row + rows.GOAL_SPEED]
        if segments[row + rows.GOAL_KIND] != rows.LIMIT_GOAL and factor < 1.0:
            goal_v *= factor
        goal_v = min(goal_v, limit_v)
        goal_a = min(limit_a, segments[row + rows.GOAL_ACCELERATION])
        goal_j = min(limit_j, segments[row + rows.GOAL_JERK])
        is_met = self.head_for(rest_d + goal_d, goal_v, speed_v, limit_v, goal_a, goal_j)
        self.ends_in_time = is_met > 0 and goal_d == 0.0
        self.stops_at_end = self.stops_at_end and not is_met
        if self.stops_at_end:
            self.stop_at_end(speed_v, limit_v, limit_a, limit_j)
        elif settles and not is_met:
            self.fade_by_end(goal_v, speed_v, limit_a, limit_j)

    def can_stop(self, speed_v: float, limit_a: float, limit_j: float) -> int:
        """Return whether the path can still stop at the segment's end, up to rounding.

        A path that brakes for that stop must not miss it if it is also held: a lower speed can mean
        a longer distance, so the only speed found up to the end might be far too high.
        """
        stop_d = self.course.stopping_d(speed_v, self.acceleration_a, limit_a, limit_j)
        return 1 if stop_d <= self.rest_d + 1e-10 else 0

    def stop_at_end(self, speed_v: float, limit_v: float, limit_a: float, limit_j: float) -> None:
        """Plan to stop at the segment's end."""
        is_met = self.head_for(self.rest_d, 0.0, speed_v, limit_v, limit_a, limit_j)
        self.ends_in_time = is_met > 0

    def fade_by_end(self, goal_v: float, speed_v: float, limit_a: float, limit_j: float) -> None:
        """Plan to reach the segment's end without acceleration, since a rounding follows.

        The distance is too short to change the speed to ``goal_v``: it changes as far as possible.
        """
        self.course.begin(0, 0.0, limit_a, limit_j)
        self.course.side = 1.0
        self.course.from_v = speed_v
        self.course.from_a = self.acceleration_a
        low_v = max(self.course.settled(), 0.0)
        sign = 1.0 if low_v < goal_v else -1.0
        self.course.goal_v = low_v
        if self.course.brake(speed_v, self.acceleration_a, sign) < self.rest_d:
            self.ends_in_time = True
            high_v = goal_v
            for _attempt in range(60):
                self.course.goal_v = 0.5 * (low_v + high_v)
                if self.course.brake(speed_v, self.acceleration_a, sign) <= self.rest_d:
                    low_v = self.course.goal_v
                else:
                    high_v = self.course.goal_v
            self.course.goal_v = low_v
            self.course.brake(speed_v, self.acceleration_a, sign)
        self.course.append_change(self.course.goal_v)
        self.course.finish()

    def head_for(
        self,
        distance_d: float,
        goal_v: float,
        speed_v: float,
        limit_v: float,
        limit_a: float,
        limit_j: float,
    ) -> int:
        """Plan for ``goal_v`` after a distance (0: soon); return 1 if it can be reached.

        The jerk up to the goal may be less than that of the segment. Where the path would stop
        before a braking has faded, it fades so that it just has then; where the path would get
        faster than it may, or to the goal too fast, the acceleration first fades with the jerk of
        the segment.
        """
        start_a = self.acceleration_a
        change_v = 0.5 * start_a * start_a
        fading_j = 0.0
        if start_a < 0.0 and speed_v * limit_j < change_v:
            fading_j = change_v / speed_v if speed_v > 0.0 else self.own_j
        if start_a > 0.0 and (limit_v - speed_v) * limit_j < change_v:
            fading_j = self.own_j
        is_met = self.course.plan_passing(
            0, distance_d, speed_v, start_a, limit_v, goal_v, limit_a, limit_j, fading_j
        )
        if is_met or start_a <= 0.0 or fading_j > 0.0 or self.course.settled() <= goal_v:
            return is_met
        return self.course.plan_passing(
            0, distance_d, speed_v, start_a, limit_v, goal_v, limit_a, limit_j, self.own_j
        )

    def advance(self, now_t: float) -> int:
        """Evaluate the plan at ``now_t``; return 1 if the segment has ended by then."""
        end_t = self.course.duration_t(0)
        if self.ends_in_time:
            if now_t - end_t >= -1e-6 * self.tick_t:
                self.course.evaluate(0, end_t)
                self.speed_v = self.course.speed_v
                self.acceleration_a = 0.0
                self.left_t = max(now_t - end_t, 0.0)
                return 1
            self.course.evaluate(0, now_t)
        else:
            self.course.evaluate(0, now_t)
            if self.course.distance_d >= self.rest_d:
                begin_t = max(now_t - self.tick_t, 0.0)
                end_t = self.time_at_end(begin_t, now_t)
                self.left_t = now_t - end_t
                self.settle()
                return 1
        self.distance_d = min(self.course.distance_d, self.rest_d)
        self.settle()
        return 0

    def time_at_end(self, low_t: float, high_t: float) -> float:
        """Time in s at which the segment has ended, between two times."""
        time_t = high_t
        for _attempt in range(60):
            self.course.rewind(0)
            self.course.evaluate(0, time_t)
            off_d = self.course.distance_d - self.rest_d
            if off_d > 0.0:
                high_t = time_t
            else:
                low_t = time_t
            if math.fabs(off_d) <= 1e-13 or high_t - low_t <= 1e-15:
                break
            speed_v = self.course.speed_v
            if speed_v > 0.0:
                time_t -= off_d / speed_v
            if speed_v <= 0.0 or time_t <= low_t or time_t >= high_t:
                time_t = 0.5 * (low_t + high_t)
        return time_t

    def settle(self) -> None:
        """Take over speed and acceleration of the evaluated point."""
        self.speed_v = max(self.course.speed_v, 0.0)
        self.acceleration_a = self.course.acceleration_a

# SPDX-License-Identifier: MIT
"""The goal that a path with limited jerk brakes for: where, how fast, with what limits (MO-1)."""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic


class Goal:
    """The nearest goal ahead of a point of the path.

    It is ``distance_d`` mm ahead and may be passed with ``speed_v`` and no acceleration; up to it
    the path has ``acceleration_a`` and ``jerk_j``. ``kind`` says how the override changes the
    speed (``rows.LIMIT_GOAL`` …). ``carried_a``, ``carried_j``: the acceleration that the path may
    bring into the segment at that point, and the jerk with which it takes it back.
    """

    def __init__(self) -> None:
        self.distance_d = 0.0
        self.speed_v = 0.0
        self.acceleration_a = 0.0
        self.jerk_j = 0.0
        self.kind = rows.LIMIT_GOAL
        self.carried_a = 0.0
        self.carried_j = 0.0

    def load(self, segments: memoryview[float], row: int) -> None:
        """Take the goal of a segment, seen from the segment's start."""
        self.distance_d = segments[row + rows.LENGTH] + segments[row + rows.GOAL_LENGTH]
        self.speed_v = segments[row + rows.GOAL_SPEED]
        goal_a = segments[row + rows.GOAL_ACCELERATION]
        self.acceleration_a = min(goal_a, segments[row + rows.CARRIED_ACCELERATION])
        self.jerk_j = min(segments[row + rows.GOAL_JERK], segments[row + rows.CARRIED_JERK])
        self.kind = int(segments[row + rows.GOAL_KIND])

    def load_end(
        self, segments: memoryview[float], row: int, carried_a: float, carried_j: float
    ) -> None:
        """Take the goal of a segment, seen from the segment's end."""
        self.distance_d = segments[row + rows.GOAL_LENGTH]
        self.speed_v = segments[row + rows.GOAL_SPEED]
        self.acceleration_a = segments[row + rows.GOAL_ACCELERATION]
        self.jerk_j = segments[row + rows.GOAL_JERK]
        self.carried_a = carried_a
        self.carried_j = carried_j

    def move(self, speed_v: float, kind: int) -> None:
        """Move the goal to this very point, with its own speed."""
        self.speed_v = speed_v
        self.distance_d = 0.0
        self.acceleration_a = 1e300
        self.jerk_j = 1e300
        self.kind = kind

    def store(self, segments: memoryview[float], row: int) -> int:
        """Store the goal in the segment at ``row``; return 1 if it changed."""
        is_new = 0
        if (
            segments[row + rows.GOAL_LENGTH] != self.distance_d
            or segments[row + rows.GOAL_SPEED] != self.speed_v
        ):
            is_new = 1
        elif segments[row + rows.GOAL_ACCELERATION] != self.acceleration_a:
            is_new = 1
        elif segments[row + rows.GOAL_JERK] != self.jerk_j:
            is_new = 1
        segments[row + rows.GOAL_LENGTH] = self.distance_d
        segments[row + rows.GOAL_SPEED] = self.speed_v
        segments[row + rows.GOAL_ACCELERATION] = self.acceleration_a
        segments[row + rows.GOAL_JERK] = self.jerk_j
        segments[row + rows.GOAL_KIND] = self.kind
        return is_new

    def braking_distance(self, speed: float) -> float:
        """Distance before the goal from which braking keeps the speed below ``speed``."""
        change = speed - self.speed_v
        if change < 0.0:
            return -1.0
        ramp_t = self.acceleration_a / self.jerk_j
        ramp_v = 0.5 * self.acceleration_a * ramp_t
        if change <= ramp_v:
            time = arithmetic.square_root(2.0 * change / self.jerk_j)
            return time * (self.speed_v + self.jerk_j * time * time / 6.0)
        distance = ramp_t * (self.speed_v + self.acceleration_a * ramp_t / 6.0)
        from_v = self.speed_v + ramp_v
        return distance + 0.5 * (speed * speed - from_v * from_v) / self.acceleration_a

    def slowing_distance(self, speed: float) -> float:
        """Distance to the goal's speed, from one reached once the acceleration has faded.

        It fades from ``carried_a`` with ``carried_j``.
        """
        if speed <= self.speed_v:
            return 0.0
        time = arithmetic.square_root(2.0 * speed / self.carried_j)
        time = min(self.carried_a / self.carried_j, time)
        distance = time * (speed - self.carried_j * time * time / 6.0)
        ramp_t = self.acceleration_a / self.jerk_j
        change = speed - self.speed_v
        if change >= self.acceleration_a * ramp_t:
            time = change / self.acceleration_a + ramp_t
        else:
            time = 2.0 * arithmetic.square_root(change / self.jerk_j)
        return distance + 0.5 * (speed + self.speed_v) * time

    def safe_speed(self, top_v: float) -> float:
        """Highest speed up to ``top_v`` from which the goal ahead can be reached."""
        if self.slowing_distance(top_v) <= self.distance_d:
            return top_v
        low = min(self.speed_v, top_v)
        high = top_v
        for _ in range(40):
            middle = 0.5 * (low + high)
            if self.slowing_distance(middle) <= self.distance_d:
                low = middle
            else:
                high = middle
        return low

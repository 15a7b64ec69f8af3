# SPDX-License-Identifier: MIT
"""How far each axis is in its own motion: its limits, its plan, and the state it has reached.

``AxisMotions`` decides what an axis does; here it is planned from the present state
(``trajectory.py``), and evaluated tick by tick.
"""

from __future__ import annotations

from nctakt.kernel.axes.trajectory import Trajectories
from nctakt.kernel.base.arrays import doubles, integers


class MotionLimits:
    """The limits of each axis in its own motions; jerk 0: trapezoid.

    ``low``, ``high``: the software limits in force, ``listed_…``: those of the axis list.
    ``is_enabled``: cycles and the PLC may move the axis (P-AXIS-00457).
    """

    def __init__(self, count: int) -> None:
        self.is_enabled = integers(count)
        self.low = doubles(count)
        self.high = doubles(count)
        self.listed_low = doubles(count)
        self.listed_high = doubles(count)
        self.max_v = doubles(count)
        self.max_a = doubles(count)
        self.max_j = doubles(count)

    def put_back(self, axis: int) -> None:
        """Put the software limits of the axis list in force again."""
        self.low[axis] = self.listed_low[axis]
        self.high[axis] = self.listed_high[axis]


class AxisPlans:
    """The plan of each axis, and the speed and acceleration that it has reached.

    ``start_d``: where the plan begins, ``ticks``: since then, ``planned_v``: its highest speed,
    -1 if the axis has to be replanned. ``last_direction``: 1 or -1, kept at rest.
    """

    def __init__(self, limits: MotionLimits, count: int, cycle_time_us: int) -> None:
        self.limits = limits
        self.cycle_time_us = cycle_time_us
        self.forgiven_t = -1e-12 * cycle_time_us
        self.trajectories = Trajectories(count)
        self.speed = doubles(count)
        self.acceleration = doubles(count)
        self.last_direction = doubles(count)
        self.planned_v = doubles(count)
        self.start_d = doubles(count)
        self.ticks = integers(count)
        for axis in range(count):
            self.last_direction[axis] = 1.0

    def come_to_rest(self, axis: int) -> None:
        """Note that an axis is at rest."""
        self.speed[axis] = 0.0
        self.acceleration[axis] = 0.0

    def brake_d(self, axis: int) -> float:
        """Return how far an axis goes if it brakes now, with its sign."""
        return self.trajectories.stopping_d(
            self.speed[axis],
            self.acceleration[axis],
            self.limits.max_a[axis],
            self.limits.max_j[axis],
        )

    def begin(self, axis: int, position: float, top_v: float) -> None:
        """Note that a plan with at most ``top_v`` begins here and now."""
        self.planned_v[axis] = top_v
        self.ticks[axis] = 0
        self.start_d[axis] = position

    def plan_speed(self, axis: int, end_v: float) -> None:
        """Plan to reach a speed from the present state, and to keep it."""
        self.trajectories.plan_speed(
            axis,
            end_v,
            self.speed[axis],
            self.acceleration[axis],
            self.limits.max_a[axis],
            self.limits.max_j[axis],
        )

    def plan_distance(self, axis: int, goal: float) -> None:
        """Plan to stop at ``goal`` from the present state."""
        self.trajectories.plan_distance(
            axis,
            goal - self.start_d[axis],
            self.speed[axis],
            self.acceleration[axis],
            self.planned_v[axis],
            self.limits.max_a[axis],
            self.limits.max_j[axis],
        )

    def count_tick(self, axis: int) -> int:
        """Count a tick of the plan; return whether the plan is over with it."""
        self.ticks[axis] += 1
        over_t = self.time_t(axis) - self.trajectories.duration_t(axis)
        return 1 if over_t >= self.forgiven_t else 0

    def time_t(self, axis: int) -> float:
        """Return the time since the plan began, in s."""
        return self.ticks[axis] * self.cycle_time_us / 1e6

    def advance(self, axis: int) -> float:
        """Take over the state of this tick from the plan; return the position."""
        self.trajectories.evaluate(axis, self.time_t(axis))
        self.speed[axis] = self.trajectories.speed_v
        self.acceleration[axis] = self.trajectories.acceleration_a
        if self.speed[axis] != 0.0:
            self.last_direction[axis] = 1.0 if self.speed[axis] > 0.0 else -1.0
        return self.start_d[axis] + self.trajectories.distance_d

    def end_position(self, axis: int) -> float:
        """Return the position at the end of the plan."""
        self.trajectories.evaluate(axis, self.trajectories.duration_t(axis))
        return self.start_d[axis] + self.trajectories.distance_d

# SPDX-License-Identifier: MIT
"""The limits of the spindles of one channel: of their axis lists, of their tools, of a thread.

The limits of a tool count from the next start from standstill on, and stay until another tool
brings new ones (public manuals, "tool-related dynamic limiting"). A spindle that follows a thread
is limited to what the path axis can do. Degrees and seconds.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base.arrays import doubles


class SpindleLimits:
    """``speed_v``, ``acceleration_a`` and ``jerk_j`` are in force, ``low_v`` for endless jobs.

    ``step``: the number of the gear step that is engaged, 0 for a spindle without.
    """

    def __init__(self, count: int) -> None:
        size = max(1, count)
        self.count = count
        self.speed_v = doubles(size)
        self.acceleration_a = doubles(size)
        self.jerk_j = doubles(size)
        self.low_v = doubles(size)
        self.step = doubles(size)
        self.own_v = doubles(size)
        self.own_a = doubles(size)
        self.tool_low_v = doubles(size)
        self.tool_v = doubles(size)
        self.tool_a = doubles(size)
        self.bound_v = doubles(size)
        self.bound_a = doubles(size)
        self.bound_j = doubles(size)

    def configure(
        self, spindle: int, speed_v: float, acceleration_a: float, jerk_j: float, step: int
    ) -> None:
        """Set limits and gear step of an axis list; the caller has checked the index."""
        self.step[spindle] = step
        self.own_v[spindle] = speed_v
        self.own_a[spindle] = acceleration_a
        self.jerk_j[spindle] = jerk_j
        self.take_over(spindle)

    def execute(self, queue: memoryview[float], row: int) -> None:
        """Keep the limits of a tool for the next start (P-TOOL-00013 … 00015), 0: none; or take
        those of another gear step, while the spindle is at rest.
        """
        spindle = int(queue[row + rows.LIMITED_SPINDLE])
        if queue[row + rows.LIMITED_BY_GEAR] != 0.0:
            self.step[spindle] = queue[row + rows.LIMITED_BY_GEAR]
            self.own_v[spindle] = queue[row + rows.LIMITED_HIGH]
            self.own_a[spindle] = queue[row + rows.LIMITED_ACCELERATION]
            self.jerk_j[spindle] = queue[row + rows.LIMITED_JERK]
            self.take_over(spindle)
            return
        self.tool_low_v[spindle] = queue[row + rows.LIMITED_LOW]
        self.tool_v[spindle] = queue[row + rows.LIMITED_HIGH]
        self.tool_a[spindle] = queue[row + rows.LIMITED_ACCELERATION]

    def gear_step(self, spindle: int) -> int:
        """Return the number of the gear step that is engaged."""
        return int(self.step[spindle])

    def tool_range(self, spindle: int) -> tuple[float, float]:
        """Return the least and the highest speed of the tool, degrees/s; 0: none."""
        return self.tool_low_v[spindle], self.tool_v[spindle]

    def take_over(self, spindle: int) -> None:
        """Limit a spindle at rest as its axis list and its tool say."""
        self.speed_v[spindle] = lower(self.own_v[spindle], self.tool_v[spindle])
        self.acceleration_a[spindle] = lower(self.own_a[spindle], self.tool_a[spindle])
        self.low_v[spindle] = min(self.tool_low_v[spindle], self.speed_v[spindle])

    def bind(self, spindle: int, speed_v: float, acceleration_a: float, jerk_j: float) -> None:
        """Limit changes of speed to what an axis can follow; 0: no limit."""
        self.bound_v[spindle] = speed_v
        self.bound_a[spindle] = acceleration_a
        self.bound_j[spindle] = jerk_j

    def endless_v(self, spindle: int, speed_v: float) -> float:
        """Return the speed of an endless job, at least that of the tool; 0 stays 0."""
        return max(speed_v, self.low_v[spindle]) if speed_v > 0.0 else speed_v

    def bounded_v(self, spindle: int, speed_v: float) -> float:
        """Return a speed that the spindle can have."""
        return lower(min(speed_v, self.speed_v[spindle]), self.bound_v[spindle])

    def bounded_a(self, spindle: int) -> float:
        """Return the acceleration that a new plan has."""
        return lower(self.acceleration_a[spindle], self.bound_a[spindle])

    def bounded_j(self, spindle: int) -> float:
        """Return the jerk that a new plan has; 0: unlimited."""
        limit_j = self.jerk_j[spindle]
        is_bound = self.bound_a[spindle] > 0.0 and self.bound_j[spindle] > 0.0
        return min(limit_j, self.bound_j[spindle]) if is_bound and limit_j > 0.0 else limit_j


def lower(limit: float, other: float) -> float:
    """Return the lower of two limits; a second of 0 is no limit."""
    return min(limit, other) if other > 0.0 else limit

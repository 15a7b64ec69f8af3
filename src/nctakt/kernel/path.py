# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""The path: a ring of prepared segments -> command positions, one increment a tick (MO-1 … MO-6).

A segment is a row of the command queue (``channel.py``): straight, with its length, programmed
speed, what the axes allow on it, and its end points. The path decides what only the tick knows:
override, hold and stop. Every change of the speed limit plans the rest of the segment anew from the
present speed; position and speed come from the plan in closed form. Segments that were used stay in
the ring until they are overwritten. Time left over in a tick when a segment ends without a stop is
carried into the next one.
"""

from __future__ import annotations

from nctakt.kernel import arithmetic
from nctakt.kernel.axis import Axes
from nctakt.kernel.motion import Profile

#: Segments that the ring holds, with the current one.
RING_SIZE = 256


class Path:
    """The path of one channel over the machine's axes that belong to it."""

    def __init__(self, axes: Axes, members: list[int], cycle_time_us: int) -> None:
        self.axes = axes
        self.count = len(members)
        self.members = memoryview(bytearray(8 * max(1, len(members)))).cast("q")
        for i, axis in enumerate(members):
            self.members[i] = axis
        self.cycle_time_t = cycle_time_us / 1e6
        self.cycle_time_us = cycle_time_us
        self.width = 12 + 2 * len(members)
        self.ring_size = RING_SIZE
        self.ring = memoryview(bytearray(8 * RING_SIZE * self.width)).cast("d")
        self.used = 0
        self.base = 0
        self.serial = 0
        self.is_active = False
        self.is_dwell = False
        self.dwell_ticks = 0
        self.profile = Profile()
        self.covered_d = 0.0
        self.plan_d = 0.0
        self.speed_v = 0.0
        self.limit_v = -1.0
        self.offset_t = 0.0
        self.ticks = 0
        self.left_t = 0.0
        self.is_single = False

    def begin(self, queue_base: int, queue: memoryview[float], offset_t: float) -> None:
        """Take the segment in ``queue`` at ``queue_base`` as current, ``offset_t`` of it past."""
        self.base = (self.used % self.ring_size) * self.width
        for i in range(self.width):
            self.ring[self.base + i] = queue[queue_base + i]
        self.used += 1
        self.serial += 1
        self.is_active = True
        self.is_dwell = self.ring[self.base] == 2.0
        self.dwell_ticks = int(self.ring[self.base + 3]) if self.is_dwell else 0
        self.covered_d = 0.0
        self.plan_d = 0.0
        self.limit_v = -1.0
        self.offset_t = offset_t
        self.ticks = 0
        if not self.is_dwell:
            for i in range(self.count):
                self.axes.target[self.members[i]] = self.ring[self.base + 12 + self.count + i]
            self.axes.has_moved = True

    def starts_where_axes_stand(self, queue_base: int, queue: memoryview[float]) -> int:
        """Whether a segment starts where the axes stand: the path never jumps (RC-409)."""
        for i in range(self.count):
            if queue[queue_base + 12 + i] != self.axes.command[self.members[i]]:
                return 0
        return 1

    def step(self, factor: float, is_stopping: int) -> int:
        """One tick with the override as a factor: 1 when the segment has ended with time left.

        ``is_stopping`` brakes on the path to a stand, at the path's acceleration (MO-6).
        """
        if not self.is_active:
            self.speed_v = 0.0
            return 0
        if self.is_dwell:
            self.limit_v = 0.0 if is_stopping else -1.0
            self.dwell_ticks -= 0 if is_stopping else 1
            if self.dwell_ticks <= 0:
                self.is_active = False
            return 0
        limit_v = self.highest_speed(factor, is_stopping)
        if limit_v != self.limit_v:
            self.offset_t = 0.0
            self.replan(limit_v)
        self.ticks += 1
        return self.advance()

    def set_single(self, is_single: bool) -> None:
        """Single block on or off: the current segment is planned anew where it matters (MO-6)."""
        self.is_single = is_single
        if self.is_active and not self.is_dwell and self.ring[self.base + 7] > 0.0:
            self.limit_v = -1.0

    def end_speed(self, rest_d: float) -> float:
        """The speed at the segment's end: a stand in single block, if it can still be had."""
        brake_d = self.speed_v * self.speed_v / (2.0 * self.ring[self.base + 6])
        if self.is_single and brake_d <= rest_d * 1.000001:
            return 0.0
        return self.ring[self.base + 7]

    def publish_overrides(self, operator_pct: float) -> None:
        """TOTAL of the members' independent motions: operator's and CYCLE part (RC-305)."""
        for i in range(self.count):
            base = self.axes.first_cell + self.members[i] * 20
            pct = operator_pct * self.axes.cells[base + 15] / 100.0
            if pct != self.axes.cells[base + 16]:
                self.axes.cells[base + 16] = arithmetic.round_half_even(pct)

    def step_carried(self, factor: float, is_stopping: int) -> int:
        """The rest of a tick in the segment that has just begun: 1 when that has ended, too."""
        self.replan(self.highest_speed(factor, is_stopping))
        return self.advance()

    def highest_speed(self, factor: float, is_stopping: int) -> float:
        """The speed limit on the current segment in this tick."""
        if is_stopping:
            return 0.0
        return min(self.ring[self.base + 4] * factor, self.ring[self.base + 5])

    def replan(self, limit_v: float) -> None:
        """Plan what is left of the segment from the present speed."""
        self.limit_v = limit_v
        self.plan_d = self.covered_d
        self.ticks = 0
        rest_d = self.ring[self.base + 3] - self.covered_d
        self.profile.plan(
            rest_d, self.speed_v, self.end_speed(rest_d), limit_v, self.ring[self.base + 6]
        )

    def advance(self) -> int:
        """Go to where the plan is at the end of this tick; 1 when the segment ended before."""
        now_t = self.offset_t + self.ticks * self.cycle_time_us / 1e6
        over_t = now_t - self.profile.duration_t
        if self.profile.is_endless or over_t < -1e-6 * self.cycle_time_t:
            self.covered_d = self.plan_d + self.profile.position(now_t)
            self.speed_v = self.profile.speed(now_t)
            self.move_axes(self.covered_d / self.ring[self.base + 3])
            return 0
        self.speed_v = self.profile.end_v
        self.is_active = False
        self.left_t = max(over_t, 0.0)
        for i in range(self.count):
            self.axes.command[self.members[i]] = self.ring[self.base + 12 + self.count + i]
        self.axes.has_moved = True
        return 1 if self.ring[self.base + 8] == 0.0 and self.left_t > 0.0 else 0

    def move_axes(self, part: float) -> None:
        """Put the axes on the segment, ``part`` of its way."""
        self.axes.has_moved = True
        for i in range(self.count):
            start = self.ring[self.base + 12 + i]
            end = self.ring[self.base + 12 + self.count + i]
            self.axes.command[self.members[i]] = start + (end - start) * part

    def abandon(self) -> None:
        """Reset: the rest of the segment is dropped where the axes stand, to be read at once."""
        self.is_active = False
        self.speed_v = 0.0
        for i in range(self.count):
            axis = self.members[i]
            self.axes.target[axis] = self.axes.command[axis]
        self.axes.has_moved = True
        self.axes.publish()

    def stands(self) -> int:
        """Whether nothing moves on the path."""
        return 1 if self.speed_v == 0.0 and (not self.is_active or self.limit_v == 0.0) else 0

    def has_stopped(self) -> bool:
        """``stands`` for Python's side."""
        return bool(self.stands())

    def rest_d(self) -> float:
        """What is left of the current segment."""
        if not self.is_active or self.is_dwell:
            return 0.0
        return self.ring[self.base + 3] - self.covered_d

    def block_number(self) -> float:
        """The N number of the current block."""
        return self.ring[self.base + 2]

    def segment_row(self, back: int) -> list[float]:
        """A segment of the ring, ``back`` segments before the latest one: for Python's side."""
        assert 0 <= back < min(self.used, self.ring_size)
        base = (self.used - 1 - back) % self.ring_size * self.width
        return [self.ring[base + i] for i in range(self.width)]

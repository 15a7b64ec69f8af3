# SPDX-License-Identifier: MIT
"""Rounded corners with limited jerk: a rounding between two lines, within the deviation (MO-3).

An arc or a parabola has a curvature from its first point on, which would be a step in acceleration.
The direction of a rounding changes by 2·u² up to its middle and in the mirror image of this after
it, u being the covered part of its length: its curvature rises and falls evenly. On a rounding that
begins and ends ``h`` before and after the corner, with the step ``s`` of the axis' part of
the length, the speed v, the acceleration a and the jerk j along it, an axis with the part ``p`` of
the length has at most

    acceleration  p·a + v²·s/h,        jerk  p·j + 3·v·a·s/h + v³·s/h²,

and the corner is h·(size of the step)/6 away from it.

Most of the axes' limits is for the speed. Little is left for the acceleration along the rounding,
which override and hold need: the path reaches either end with none, if it can
(``jerk_lookahead.py``, ``jerk_profile.py``). A rounding is a separate segment, part of the block
whose end it rounds.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.path.corner import Corner
from nctakt.kernel.path.segment_limits import SegmentLimits


class CornerRounding:
    """Roundings of one channel's corners, made one at a time in ``row``.

    ``spare``: both segments as they were before, the newer one first.
    """

    def __init__(self, limits: SegmentLimits, corner: Corner) -> None:
        self.limits = limits
        self.corner = corner
        self.width = rows.segment_width(limits.room)
        self.row = doubles(self.width)
        self.spare = doubles(2 * self.width)

    def round(self, segments: memoryview[float], before: int, row: int, back: int) -> int:
        """Make a rounding over the corner between two segments; return 0 if none fits.

        None is made either if the path is as fast without it. ``spare`` keeps both segments as they
        were; ``back``: how many commands lie between them.
        """
        if segments[before + rows.NEXT_SPEED] > 0.0:
            return 0
        if segments[row + rows.JERK] == 0.0 or self.corner.last_deviation == 0.0:
            return 0
        if segments[before + rows.SHAPE] != rows.LINE or segments[row + rows.SHAPE] != rows.LINE:
            return 0
        half = self.rounding_half(segments, before, row)
        if half <= 1e-6:
            return 0
        speed = self.rounding_speed(segments, before, row, half)
        if speed <= 0.0 or not self.saves_time(segments, before, row, half, speed):
            return 0
        segments[row + rows.PREDECESSOR] = back
        for i in range(self.width):
            self.spare[i] = segments[row + i]
            self.spare[self.width + i] = segments[before + i]
            self.row[i] = 0.0
        self.limit_rounding(segments, before, row, half, speed)
        self.put_rounding(segments, before, row, half)
        return 1

    def restore(self, segments: memoryview[float], before: int, row: int) -> None:
        """Restore both segments as they were before ``round``."""
        for i in range(self.width):
            segments[row + i] = self.spare[i]
            segments[before + i] = self.spare[self.width + i]

    def rounding_half(self, segments: memoryview[float], before: int, row: int) -> float:
        """Length of a rounding on either line, in mm: less than half of the line.

        Before it three ticks are left where the line begins with a corner that uses the jerk.
        """
        size2 = 0.0
        for i in range(self.limits.count):
            step = self.corner.entering[i] - self.corner.leaving[i]
            self.corner.steps[i] = step if step >= 0.0 else 0.0 - step
            if self.limits.linear[i]:
                size2 += step * step
        size = arithmetic.square_root(size2)
        shorter = min(self.corner.last_length, segments[row + rows.LENGTH])
        half = min(self.corner.half_length(size, shorter, 6.0), 0.49 * shorter)
        return min(
            half,
            segments[before + rows.LENGTH] - 3.0 * self.limits.tick_t * self.corner.last_corner_v,
        )

    def rounding_speed(
        self, segments: memoryview[float], before: int, row: int, half: float
    ) -> float:
        """Highest speed on the rounding; 0 if the corner lets the path pass as fast."""
        shortest = min(segments[before + rows.LENGTH], segments[row + rows.LENGTH])
        speed = min(
            self.limits.speed_of(segments[before + rows.SPEED], segments[before + rows.MAX_SPEED]),
            self.limits.speed_of(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED]),
        )
        corner_v = 1e300
        for i in range(self.limits.count):
            corner_v = min(corner_v, self.corner.corner_speed(i, shortest, 0.0))
            step = self.corner.steps[i]
            if step > 0.0:
                max_v2 = 0.8 * self.limits.slope_acceleration(i) * half / step
                max_v3 = 0.75 * self.limits.axis_jerk(i) * half * half / step
                speed = min(speed, arithmetic.square_root(max_v2))
                speed = min(speed, arithmetic.power(max_v3, 1.0 / 3.0))
        return speed if speed > corner_v else 0.0

    def saves_time(
        self, segments: memoryview[float], before: int, row: int, half: float, speed: float
    ) -> int:
        """Return whether rounding and ramps take less time than a standstill at the corner.

        Compares how much longer a ramp takes than the same distance at its higher speed. From that
        speed the path can stop on half of each line.
        """
        limit_a = min(segments[before + rows.ACCELERATION], segments[row + rows.ACCELERATION])
        limit_j = min(segments[before + rows.JERK], segments[row + rows.JERK])
        top_v = min(
            self.limits.speed_of(segments[before + rows.SPEED], segments[before + rows.MAX_SPEED]),
            self.limits.speed_of(segments[row + rows.SPEED], segments[row + rows.MAX_SPEED]),
        )
        room = min(segments[before + rows.LENGTH], segments[row + rows.LENGTH])
        time = self.ramp_time(top_v, limit_a, limit_j)
        while top_v > speed and top_v * time > room:
            top_v *= 0.9
            time = self.ramp_time(top_v, limit_a, limit_j)
        if top_v <= speed:
            return 1
        stop_t = 0.5 * time
        time = self.ramp_time(top_v - speed, limit_a, limit_j)
        rounding_t = 0.5 * time * (top_v - speed) / top_v + half / speed - half / top_v
        return 1 if rounding_t < stop_t else 0

    def ramp_time(self, change: float, limit_a: float, limit_j: float) -> float:
        """Time in s of a change of speed, from no acceleration to none."""
        if change >= limit_a * limit_a / limit_j:
            return change / limit_a + limit_a / limit_j
        return 2.0 * arithmetic.square_root(change / limit_j)

    def limit_rounding(
        self, segments: memoryview[float], before: int, row: int, half: float, speed: float
    ) -> None:
        """Settle speed, acceleration and jerk of the rounding."""
        limit_a = min(segments[before + rows.ACCELERATION], segments[row + rows.ACCELERATION])
        limit_j = min(segments[before + rows.JERK], segments[row + rows.JERK])
        for i in range(self.limits.count):
            step = self.corner.steps[i]
            part = max(self.corner.leaving[i], 0.0 - self.corner.leaving[i])
            part = max(part, self.corner.entering[i], 0.0 - self.corner.entering[i])
            left_a = 0.98 * (self.limits.slope_acceleration(i) - speed * speed * step / half)
            left_j = 0.98 * (
                self.limits.axis_jerk(i) - speed * speed * speed * step / (half * half)
            )
            if step > 0.0:
                left_j *= 0.5
                limit_a = min(limit_a, left_j * half / (3.0 * speed * step))
            if part > 0.0:
                limit_a = min(limit_a, left_a / part)
                limit_j = min(limit_j, left_j / part)
        self.row[rows.MAX_SPEED] = speed
        self.row[rows.ACCELERATION] = limit_a
        self.row[rows.JERK] = limit_j

    def put_rounding(self, segments: memoryview[float], before: int, row: int, half: float) -> None:
        """Shorten both lines by the rounding, and put it between them."""
        rounding = self.row
        rounding[rows.KIND] = rows.SEGMENT
        rounding[rows.SOURCE] = segments[before + rows.SOURCE]
        rounding[rows.BLOCK_NUMBER] = segments[before + rows.BLOCK_NUMBER]
        rounding[rows.LENGTH] = 2.0 * half
        rounding[rows.SHAPE] = rows.ROUNDING
        rounding[rows.EXACT_STOP] = segments[before + rows.EXACT_STOP]
        rounding[rows.CONTINUES] = segments[before + rows.CONTINUES]
        rounding[rows.HAS_JERK_LIMIT] = 1.0
        rounding[rows.SPEED] = segments[before + rows.SPEED]
        for i in range(rows.FEED_MODIFIER_WIDTH):
            rounding[rows.SPEED_OVERRIDE + i] = segments[before + rows.SPEED_OVERRIDE + i]
        rounding[rows.PREDECESSOR] = 1.0
        rounding[rows.CORNER_SPEED] = 1e300
        start = rows.START
        target = start + self.limits.count
        corners = target + self.limits.count + self.limits.count
        for i in range(self.limits.count):
            corner = segments[row + start + i]
            rounding[start + i] = corner - half * self.corner.leaving[i]
            rounding[target + i] = corner + half * self.corner.entering[i]
            rounding[corners + i] = corner
            segments[before + target + i] = rounding[start + i]
            segments[row + start + i] = rounding[target + i]
        segments[before + rows.LENGTH] -= half
        segments[row + rows.LENGTH] -= half
        segments[before + rows.CONTINUES] = 1.0
        segments[before + rows.CORNER_SPEED] = 1e300
        segments[before + rows.ROUNDING_LENGTH] = rounding[rows.LENGTH]
        segments[before + rows.ROUNDING_ACCELERATION] = rounding[rows.ACCELERATION]
        segments[before + rows.ROUNDING_JERK] = rounding[rows.JERK]
        self.limits.stop_at_end(segments, before)
        self.limits.stop_at_end(rounding, 0)
        self.corner.is_rounded = True

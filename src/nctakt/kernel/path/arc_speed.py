# SPDX-License-Identifier: MIT
"""The speed along an arc whose limits turn with its angle: one plan for each piece (MO-1, MO-5).

``survey`` finds how fast the path may be at each border of the pieces, from the arc's end
backwards: ``highs`` the limit, ``lows`` the target, because the next block has a lower feed.
``plan`` then leads from the present speed to the next border as fast as possible: speed up or slow
down to the speed limit or to the highest speed that fits, keep it, brake. All accelerations are
allowed by ``arc_limits.py`` at each speed that occurs.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.path.arc_limits import ArcLimits
from nctakt.kernel.path.trapezoid_profile import TrapezoidProfile


class ArcSpeed(ArcLimits):
    """The plan of one path on its current arc, which it puts into ``profile``."""

    def __init__(self, count: int, profile: TrapezoidProfile, room: int = 0) -> None:
        super().__init__(count, room)
        self.profile = profile
        self.highs = doubles(rows.MAX_PIECES + 1)
        self.lows = doubles(rows.MAX_PIECES + 1)
        self.prepared_v = 0.0
        self.next_feed_v = 0.0
        self.max_end_v = 0.0
        self.surveyed_v = -1.0
        self.surveyed_target_v = -1.0

    def begin(self, segments: memoryview[float], row: int) -> None:
        """Make the arc of the segment at ``row`` the current one."""
        self.open(segments, row)
        self.prepared_v = segments[row + rows.END_SPEED]
        self.next_feed_v = segments[row + rows.NEXT_SPEED]
        self.max_end_v = max(segments[row + rows.MAX_END_SPEED], segments[row + rows.END_SPEED])
        self.surveyed_v = -1.0
        self.surveyed_target_v = -1.0

    def look_ahead(
        self,
        stage: int,
        rest_d: float,
        start_v: float,
        factor: float,
        factor_ahead: float,
        remaining_v: float,
    ) -> None:
        """``survey`` for an override as a factor; in single block with ``remaining_v`` at the end.

        ``factor_ahead``: the override of the next segment.

        That is left out (``remaining_v`` below 0), also if it is no longer possible. If the
        override has just changed, the arc may end faster than its target.
        """
        end_v = self.prepared_v
        if factor > 1.0:
            end_v = max(end_v, min(end_v * factor, self.max_end_v))
        feed_v = self.next_feed_v * factor_ahead
        if 0.0 < feed_v < end_v:
            end_v = feed_v
        if remaining_v >= 0.0:
            self.survey(min(remaining_v, self.max_end_v), end_v)
            if self.is_met(stage, rest_d, start_v):
                return
        self.survey(self.max_end_v, end_v)

    def survey(self, max_v: float, target_v: float) -> None:
        """Settle the speeds at the borders, from the highest and the target one at the end."""
        if max_v == self.surveyed_v and target_v == self.surveyed_target_v:
            return
        self.surveyed_v = max_v
        self.surveyed_target_v = target_v
        self.fill(self.highs, max_v)
        self.fill(self.lows, min(target_v, max_v))

    def fill(self, borders: memoryview[float], end_v: float) -> None:
        """Fill the squares of the highest speeds at all borders that keep the one at the end."""
        k = self.pieces - 1
        speed2 = min(end_v * end_v, self.caps[k])
        borders[self.pieces] = speed2
        while k >= 0:
            speed2 = self.before(k, speed2)
            before = k - 1
            if before >= 0:
                speed2 = min(speed2, self.caps[before])
            borders[k] = speed2
            k = before

    def is_met(self, stage: int, rest_d: float, start_v: float) -> int:
        """Return whether the survey can still be kept ``rest_d`` mm before a piece's end."""
        width = 2.0 * rest_d
        border = stage + 1
        speed2 = self.highs[border]
        speed2 += width * self.rate(stage, speed2, width, -1.0)
        return 1 if start_v * start_v <= 1.000001 * speed2 else 0

    def plan(self, stage: int, rest_d: float, start_v: float, limit_v: float) -> None:
        """Plan the rest of a piece, at most with ``limit_v``; 0: brake to a standstill."""
        start2 = start_v * start_v
        limit2 = min(limit_v * limit_v, self.caps[stage])
        if rest_d <= 0.0:
            border = stage + 1
            end2 = min(start2, self.highs[border])
            self.profile.plan(0.0, start_v, arithmetic.square_root(end2), limit_v, 1.0)
        elif start2 > limit2 * 1.000000000001:
            self.slow_down(stage, rest_d, start_v, limit2)
        else:
            self.speed_up(stage, rest_d, start_v, max(limit2, start2))

    def change(self, stage: int, from2: float, to2: float, width: float, direction: float) -> float:
        """Acceleration from one speed to a higher one, on half of ``width`` at most.

        A tiny acceleration counts as none, since its length would be mere rounding.
        """
        max_a = self.rate(stage, from2, 0.0, direction)
        max_a = min(max_a, self.rate(stage, to2, 0.0, direction))
        if from2 + width * max_a < to2:
            longer = self.rate(stage, from2, width, direction)
            max_a = max(max_a, min(longer, (to2 - from2) / width))
        return max_a if max_a > 1e-6 else 0.0

    def slow_down(self, stage: int, rest_d: float, start_v: float, limit2: float) -> None:
        """Brake to the limit that the path is above, then for the border."""
        start2 = start_v * start_v
        rate = self.rate(stage, start2, 0.0, -1.0)
        rate = min(rate, self.rate(stage, limit2, 0.0, -1.0))
        if start2 - 2.0 * rest_d * rate > limit2:
            self.brake(stage, rest_d, start_v, limit2)
            return
        first_d = 0.5 * (start2 - limit2) / rate
        border = stage + 1
        end2 = min(limit2, self.lows[border])
        last_d = 0.0
        if end2 < limit2:
            last = self.rate(stage, limit2, 0.0, -1.0)
            last = min(last, self.rate(stage, end2, 0.0, -1.0))
            if 2.0 * last * (rest_d - first_d) < limit2 - end2:
                self.brake(stage, rest_d, start_v, end2)
                return
            last_d = 0.5 * (limit2 - end2) / last
        self.follow(rest_d, start_v, first_d, limit2, last_d, end2)

    def brake(self, stage: int, rest_d: float, start_v: float, target2: float) -> None:
        """Brake evenly up to the border, to the target speed if that can be reached."""
        start2 = start_v * start_v
        width = 2.0 * rest_d
        rate = self.rate(stage, start2, 0.0 - width, -1.0)
        end2 = max(target2, start2 - width * rate)
        border = stage + 1
        end2 = min(end2, self.highs[border], start2)
        self.follow(rest_d, start_v, 0.0, start2, rest_d, end2)

    def speed_up(self, stage: int, rest_d: float, start_v: float, limit2: float) -> None:
        """Speed up to the limit, or as far as the path can still brake."""
        start2 = start_v * start_v
        width = 2.0 * rest_d
        border = stage + 1
        end2 = min(self.lows[border], limit2)
        last = 0.0
        if end2 < limit2:
            last = self.change(stage, end2, limit2, width, -1.0)
        if start2 > end2 + width * last:
            self.brake(stage, rest_d, start_v, end2)
            return
        first = 0.0
        if start2 < limit2:
            first = self.change(stage, start2, limit2, width, 1.0)
        top2 = min(start2 + width * first, limit2)
        if top2 <= end2 or first + last <= 0.0:
            first_d = min(0.5 * (top2 - start2) / first, rest_d) if first > 0.0 else 0.0
            self.follow(rest_d, start_v, first_d, top2, 0.0, top2)
            return
        # Without one of the two ramps the highest speed is that of its border, bit for bit.
        top2 = start2 if first <= 0.0 else end2
        if first > 0.0 and last > 0.0:
            top2 = (last * start2 + first * end2 + width * first * last) / (first + last)
        top2 = max(min(top2, limit2), start2, end2)
        first_d = min(0.5 * (top2 - start2) / first, rest_d) if top2 > start2 else 0.0
        last_d = min(0.5 * (top2 - end2) / last, rest_d - first_d) if top2 > end2 else 0.0
        self.follow(rest_d, start_v, first_d, top2, last_d, end2)

    def follow(
        self,
        rest_d: float,
        start_v: float,
        first_d: float,
        top2: float,
        last_d: float,
        end2: float,
    ) -> None:
        """Put the ramps into the profile."""
        top_v = arithmetic.square_root(top2)
        end_v = arithmetic.square_root(end2)
        self.profile.plan_ramps(rest_d, start_v, first_d, top_v, last_d, end_v)

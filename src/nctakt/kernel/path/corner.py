# SPDX-License-Identifier: MIT
"""The corner between the newest segment and the one before it (MO-1, MO-3).

How the axes' parts of the path's length change there: in a step if the direction changes, and their
derivatives along the path if the curvature changes.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.path import cubic, geometry
from nctakt.kernel.path.segment_limits import SegmentLimits


class Corner:
    """The directions at one corner, and values of the segment before it.

    ``entering`` and ``leaving``: each axis' part of the length after the corner and before it;
    ``entering_curve`` and ``leaving_curve``: the change of these per mm. ``steps``, ``shares`` and
    ``turns``: the corner's demand on each axis, as it is passed. ``centripetal_share``: of an arc's
    acceleration; ``corner_v``: with which the newest segment is entered, 0 without a limit of the
    jerk; ``is_rounded``: a rounding leads into it; ``is_bent``: a transformation or a spline bends
    the motion of the axes on it. ``last_…``: the same of the segment before; ``last_length`` is its
    programmed length in mm, ``last_deviation`` the distance in mm at which the path may pass its
    end, negative: at which it leaves the line before it. ``last_part`` and ``last_bend``: which
    part of a line a rounding may take, and up to which change of direction there is one.
    """

    def __init__(self, limits: SegmentLimits) -> None:
        self.limits = limits
        room = limits.room
        self.entering = doubles(room)
        self.leaving = doubles(room)
        self.entering_curve = doubles(room)
        self.leaving_curve = doubles(room)
        self.steps = doubles(room)
        self.shares = doubles(room)
        self.turns = doubles(room)
        self.unused = doubles(room)
        self.centripetal_share = 0.0
        self.last_centripetal_share = 0.0
        self.last_length = 0.0
        self.last_deviation = 0.0
        self.last_part = 0.5
        self.last_bend = 1.99
        self.corner_v = 0.0
        self.last_corner_v = 0.0
        self.is_rounded = False
        self.last_is_rounded = False
        self.is_bent = False
        self.last_is_bent = False

    def enter(self, segments: memoryview[float], row: int, centripetal_share: float) -> None:
        """Take the direction at the start of the newest segment as the one after the corner."""
        self.centripetal_share = centripetal_share
        self.corner_v = 0.0
        self.is_rounded = False
        self.is_bent = False
        if segments[row + rows.TRANSFORMATION] > 0.0:
            self.is_bent = self.limits.transformed.turn > 0.0
            for i in range(self.limits.count):
                self.entering[i] = self.limits.transformed.entering[i]
            return
        if cubic.is_cubic(segments, row):
            self.is_bent = True
            cubic.differentiate(
                segments,
                row,
                self.limits.count,
                0.0,
                self.entering,
                self.entering_curve,
                self.unused,
            )
            return
        geometry.tangent(segments, row, self.limits.count, 0, self.entering)

    def enter_curve(self, segments: memoryview[float], row: int) -> None:
        """Take the curvature at the start of the newest segment as the one after the corner."""
        if segments[row + rows.TRANSFORMATION] > 0.0:
            for i in range(self.limits.count):
                self.entering_curve[i] = self.limits.transformed.entering_curve[i]
            return
        if cubic.is_cubic(segments, row):
            return
        geometry.curvature(segments, row, self.limits.count, 0, self.entering_curve)

    def leave(self, segments: memoryview[float], row: int, length: float) -> None:
        """Keep the end of the newest segment, ``length`` mm as programmed, for the next corner."""
        self.last_is_bent = self.is_bent
        if segments[row + rows.TRANSFORMATION] > 0.0:
            for i in range(self.limits.count):
                self.leaving[i] = self.limits.transformed.leaving[i]
                self.leaving_curve[i] = self.limits.transformed.leaving_curve[i]
        elif cubic.is_cubic(segments, row):
            cubic.differentiate(
                segments, row, self.limits.count, 1.0, self.leaving, self.leaving_curve, self.unused
            )
        else:
            geometry.tangent(segments, row, self.limits.count, 1, self.leaving)
            if segments[row + rows.JERK] > 0.0:
                geometry.curvature(segments, row, self.limits.count, 1, self.leaving_curve)
        if segments[row + rows.JERK] > 0.0:
            self.last_corner_v = self.corner_v
            self.last_is_rounded = self.is_rounded
        self.last_centripetal_share = self.centripetal_share
        self.last_length = length
        self.last_deviation = segments[row + rows.DEVIATION]
        self.last_part = self.limits.rounded_part
        self.last_bend = self.limits.max_bend

    def set_steps(self) -> None:
        """Settle the step of each axis' part of the length at the corner."""
        for i in range(self.limits.count):
            self.steps[i] = self.entering[i] - self.leaving[i]
            if self.steps[i] < 0.0:
                self.steps[i] = 0.0 - self.steps[i]

    def half_length(self, size: float, shorter: float, spread: float) -> float:
        """Return the length of a rounding on either line, at most the permitted part of it.

        ``size``: of the step of the direction; ``spread``: how many times the deviation it is at
        the size 1. 0 where the corner is not rounded.
        """
        if size < 1e-6 or size > self.last_bend:
            return 0.0
        if self.last_deviation < 0.0:
            return min(0.0 - self.last_deviation, self.last_part * shorter)
        return min(spread * self.last_deviation / size, self.last_part * shorter)

    def corner_speed(self, i: int, shortest: float, turn: float) -> float:
        """Highest speed at a corner for one axis.

        It uses at most 0.7 of its jerk, 0.5 next to a motion that a transformation bends.
        """
        step = self.steps[i]
        if step <= 1e-12:
            step = 0.0
        if turn <= 1e-12:
            turn = 0.0
        max_a = (
            self.limits.axis_jerk(i)
            * self.limits.tick_t
            * (0.5 if self.is_bent or self.last_is_bent else 0.7)
            * (0.5 if step > 0.0 and turn > 0.0 else 1.0)
        )
        speed = 1e300
        if step > 0.0:
            more = 6.0 * step * self.limits.tick_t * max_a * self.limits.tick_t / shortest
            root = arithmetic.square_root(step * step + more)
            speed = 2.0 * max_a * self.limits.tick_t / (step + root)
        if turn > 0.0:
            slower = arithmetic.square_root(max_a / (0.75 * turn))
            density = 0.75 + min(slower, speed) * self.limits.tick_t / shortest
            speed = min(speed, arithmetic.square_root(max_a / (density * turn)))
        return speed

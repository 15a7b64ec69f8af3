# SPDX-License-Identifier: MIT
"""Constant cutting speeds of the spindles of one channel (G96): the speed follows a face axis."""

from __future__ import annotations

import math

from nctakt.kernel import rows
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.base.arrays import doubles, integers

DEGREES_PER_RADIAN = 57.29577951308232


class CuttingSpeeds:
    """``active_count``: spindles that follow an axis; ``rapid_cell``: not 0 while at rapid."""

    def __init__(self, count: int) -> None:
        size = max(1, count)
        self.surface_v = doubles(size)
        self.face_axis = integers(size)
        self.centre_d = doubles(size)
        self.limit_v = doubles(size)
        self.active_count = 0
        self.axes: Axes | None = None
        self.rapid_cell = 0

    def execute(self, queue: memoryview[float], row: int) -> None:
        """Begin, change or end the constant cutting speed of a spindle."""
        spindle = int(queue[row + rows.CUTTING_SPINDLE])
        was_on = self.surface_v[spindle] > 0.0
        self.surface_v[spindle] = queue[row + rows.CUTTING_SURFACE]
        is_on = self.surface_v[spindle] > 0.0
        self.active_count += is_on - was_on
        self.face_axis[spindle] = int(queue[row + rows.CUTTING_AXIS])
        self.centre_d[spindle] = queue[row + rows.CUTTING_CENTRE]
        self.limit_v[spindle] = queue[row + rows.CUTTING_LIMIT]

    def speed(self, spindle: int, highest_v: float, factor: float) -> float:
        """Return the speed that the face axis asks for, scaled, in degrees/s; -1 without one."""
        if self.axes is None or self.surface_v[spindle] <= 0.0:
            return -1.0
        radius = math.fabs(self.axes.command[self.face_axis[spindle]] - self.centre_d[spindle])
        if self.limit_v[spindle] > 0.0:
            highest_v = min(highest_v, self.limit_v[spindle])
        asked_v = self.surface_v[spindle] * DEGREES_PER_RADIAN * factor
        return asked_v / radius if radius * highest_v > asked_v else highest_v

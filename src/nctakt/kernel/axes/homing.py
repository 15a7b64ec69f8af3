# SPDX-License-Identifier: MIT
"""Reference positions of the axes: how each axis is homed, and whether it has been.

A program homes axes by G74 and computes the positions itself; a PLC leaves that to the tick
(MC_Home): at the end of the motion the axis has the position of its list, or the one requested.
Homing outlives programs and resets.
"""

from __future__ import annotations

from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index


class Homing:
    """``distance``: signed, to where the axis comes to rest, ``overrun`` beyond the zero pulse.

    ``position``: of the list, at the zero pulse; ``ordered``: of the homing that runs, which
    ``running`` (``codes.HOMED_BY_PROGRAM`` …, 0: none) has ordered.
    """

    def __init__(self, axes: Axes) -> None:
        count = axes.count
        self.axes = axes
        self.running = integers(count)
        self.is_allowed = integers(count)
        self.distance = doubles(count)
        self.speed = doubles(count)
        self.overrun = doubles(count)
        self.position = doubles(count)
        self.ordered = doubles(count)
        self.is_homed = integers(count)
        self.reference = doubles(count)

    def configure(
        self, axis: int, *, distance: float, speed: float, overrun: float, position: float
    ) -> None:
        """Set how an axis is homed, in mm or degrees, and the same per s."""
        check_index(axis, self.axes.count, "axis")
        self.is_allowed[axis] = 1
        self.distance[axis] = distance
        self.speed[axis] = speed
        self.overrun[axis] = overrun
        self.position[axis] = position

    def keep(self, axis: int, reference: float) -> None:
        """Note that an axis is homed, with this position at its reference point."""
        self.is_homed[axis] = 1
        self.reference[axis] = reference

    def finish(self, axis: int) -> None:
        """Give a homed axis, at rest beyond its zero pulse, its position."""
        self.axes.refer(axis, self.ordered[axis] + self.overrun[axis])
        self.keep(axis, self.ordered[axis])

    def reference_of(self, axis: int) -> float | None:
        """Return the position of an axis at its reference point, ``None`` if it is not homed."""
        check_index(axis, self.axes.count, "axis")
        return self.reference[axis] if self.is_homed[axis] else None

# SPDX-License-Identifier: MIT
"""Whether a curve over a corner is faster than the corner, where a transformation bends the paths.

Where the direction of an axis changes by d, its path on a curve that begins h before the corner
bends by d/h per mm. So the curve takes about twice the root of d·h/a, or the cube root of d·h/j;
from a standstill at the corner the axis needs twice that of 2·p·h/a, or 6·p·h/j, if p is its part
of the length. The look-ahead leaves the bend 0.4 of the acceleration a or 0.1 of the jerk j, and
with limited jerk the lines next to a curve have its lower acceleration, which costs as much.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.decoder.shapes.splines import slope_of
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.queued.commands import Segment
from nctakt.kernel.kinematics import map_rows

#: Up to which d/p the curve is faster; both are those of the axes that take longest.
FASTER = 2.0 * 0.4
FASTER_WITH_JERK = 0.5 * 6.0 * 0.1

#: How far from the corner the directions of the axes are taken, mm.
NEAR_MM = 0.01


def is_faster(
    environment: DecoderEnvironment,
    before: Segment,
    after: Segment,
    linear: Sequence[int],
    axes_at_end: Sequence[float],
) -> bool:
    """Return whether a curve between two motions is faster than the corner.

    ``linear``: the axes that are programmed in mm; ``axes_at_end``: positions of the axes at the
    corner.
    """
    transformation = environment.offsets.transformation

    def axes_at(slope: Sequence[float], distance: float) -> list[float] | None:
        point = [begin + distance * part for begin, part in zip(after.start, slope, strict=True)]
        axes, answer = transformation.mapped(
            transformation.number, point, axes_at_end, to_axes=True
        )
        return axes if answer == map_rows.REACHED else None

    leaving = slope_of(before, linear, at_end=True)
    near = axes_at(leaving, -NEAR_MM)
    corner = axes_at(leaving, 0.0)
    beyond = axes_at(slope_of(after, linear, at_end=False), NEAR_MM)
    if near is None or corner is None or beyond is None:
        return False
    change = part = 0.0
    for axis, *places in zip(environment.axes, near, corner, beyond, strict=True):
        limit = axis.dynamics.feed_acceleration
        if before.limits_jerk:
            limit = axis.dynamics.jerk_slope.jerk or axis.dynamics.smooth_accelerations[1]
        out, on = places[1] - places[0], places[2] - places[1]
        change = max(change, abs(on - out) / limit)
        part = max(part, abs(out) / limit, abs(on) / limit)
    return change <= (FASTER_WITH_JERK if before.limits_jerk else FASTER) * part

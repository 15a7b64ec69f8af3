# SPDX-License-Identifier: MIT
"""The limits of the machine's axes -> contour preparation (MO-1, MO-4).

The preparation itself runs compiled, in the queue (``kernel/lookahead.py``).
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.kernel.lookahead import LookAhead
from nctakt.lists.axis_configuration import AxisConfiguration


def look_ahead(
    axes: Sequence[AxisConfiguration], cycle_time_us: int, blocks: int, max_override_pct: float
) -> LookAhead:
    """Contour preparation for a channel with these axes."""
    ahead = LookAhead(len(axes), cycle_time_us, blocks, max_override_pct / 100.0)
    for index, axis in enumerate(axes):
        ahead.limit(
            index,
            axis.is_linear,
            (axis.rapid_speed, axis.max_speed),
            (axis.dynamics.rapid_acceleration, axis.dynamics.feed_acceleration),
        )
        slope = axis.dynamics.jerk_slope
        most = axis.dynamics.max_acceleration
        feed = min(slope.acceleration, slope.deceleration, most)
        rapid = min(slope.rapid_acceleration, most)
        shortest_us = axis.dynamics.shortest_ramp_time_us
        slowest_us = max(*slope.ramp_times_us, shortest_us, 1)
        rapid_us = max(slope.rapid_ramp_time_us, shortest_us, 1)
        jerks = (rapid * 1e6 / rapid_us, feed * 1e6 / slowest_us)
        ahead.limit_slope(index, (rapid, feed), jerks)
    return ahead

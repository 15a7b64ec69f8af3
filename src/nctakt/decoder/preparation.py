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
    return ahead

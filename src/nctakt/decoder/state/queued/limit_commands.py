# SPDX-License-Identifier: MIT
"""The command that changes the limits of axes and path; it has no row in the queue."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.queued.commands import Command


@dataclass(frozen=True, slots=True)
class AxisLimits:
    """The limits of one axis, of rapid motions first: speeds (rapid, highest), accelerations,
    those of the jerk-limited slope and its jerks.
    """

    speeds: tuple[float, float]
    accelerations: tuple[float, float]
    slope_accelerations: tuple[float, float]
    jerks: tuple[float, float]

    def lower_with(self, slave: AxisLimits, share: float) -> AxisLimits:
        """Return these limits of a master such that a slave keeps its own.

        ``share``: the ratio of the slave's distance to the master's.
        """
        return AxisLimits(
            _lower(self.speeds, slave.speeds, share),
            _lower(self.accelerations, slave.accelerations, share),
            _lower(self.slope_accelerations, slave.slope_accelerations, share),
            _lower(self.jerks, slave.jerks, share),
        )


def _lower(
    own: tuple[float, float], slave: tuple[float, float], share: float
) -> tuple[float, float]:
    return min(own[0], slave[0] / share), min(own[1], slave[1] / share)


@dataclass(frozen=True, slots=True)
class SetLimits(Command):
    """The limits of all axes and of the path for the segments after it; no row of the queue.

    ``feed`` and ``rapid``: the limits of the path from ``rows.VECTOR_SPEED`` on, 0 none.
    ``is_reduced``: they are not those of the lists. ``rounded_part`` and ``max_bend``: how corners
    are rounded.
    """

    axes: tuple[AxisLimits, ...]
    feed: tuple[float, ...]
    rapid: tuple[float, ...]
    is_reduced: bool
    rounded_part: float
    max_bend: float

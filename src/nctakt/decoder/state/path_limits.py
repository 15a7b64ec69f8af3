# SPDX-License-Identifier: MIT
"""The weights of the axes' limits, and the limits of the path, that a program sets.

In: G127 … G134, G230 … G233, ``#VECTOR LIMIT``. They are modal to the end of the program; weights
always relate to the values of the lists.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from types import MappingProxyType

from nctakt.base.dataclass import dataclass, field
from nctakt.kernel import rows
from nctakt.nc.vocabulary.functions import (
    FEED_ACCELERATION_WEIGHT,
    FEED_ACCELERATION_WEIGHTS,
    FEED_RAMP_WEIGHT,
    FEED_RAMP_WEIGHTS,
    RAPID_ACCELERATION_WEIGHT,
    RAPID_ACCELERATION_WEIGHTS,
    RAPID_RAMP_WEIGHT,
    RAPID_RAMP_WEIGHTS,
    RAPID_SPEED_WEIGHT,
    SPEED_WEIGHT,
    SPEED_WEIGHTS,
)
from nctakt.nc.vocabulary.path_keywords import VECTOR_BLOCKS

#: The change of direction from which on no corner is rounded: nearly a reversal.
MAX_BEND = 1.99


@dataclass(frozen=True, slots=True)
class AxisWeights:
    """The weights of one axis as factors; 1 leaves the value of its list."""

    speed: float = 1.0
    rapid_speed: float = 1.0
    feed_acceleration: float = 1.0
    rapid_acceleration: float = 1.0
    feed_ramp: float = 1.0
    rapid_ramp: float = 1.0


#: What each function weights; the others are accepted without effect.
_WEIGHTED = MappingProxyType(
    {
        SPEED_WEIGHTS: "speed",
        SPEED_WEIGHT: "speed",
        RAPID_SPEED_WEIGHT: "rapid_speed",
        FEED_ACCELERATION_WEIGHTS: "feed_acceleration",
        FEED_ACCELERATION_WEIGHT: "feed_acceleration",
        RAPID_ACCELERATION_WEIGHTS: "rapid_acceleration",
        RAPID_ACCELERATION_WEIGHT: "rapid_acceleration",
        FEED_RAMP_WEIGHTS: "feed_ramp",
        FEED_RAMP_WEIGHT: "feed_ramp",
        RAPID_RAMP_WEIGHTS: "rapid_ramp",
        RAPID_RAMP_WEIGHT: "rapid_ramp",
    }
)
#: The functions that weight speeds, where 0 is allowed.
_SPEEDS = (SPEED_WEIGHTS, SPEED_WEIGHT, RAPID_SPEED_WEIGHT)


def is_weight(function: int, value: float) -> bool:
    """Return whether a function allows this weight in per cent."""
    return value >= 0.0 if function in _SPEEDS else value > 0.0


@dataclass(slots=True)
class LimitState:
    """Weights by axis index, and the limits of the path: columns from ``rows.VECTOR_SPEED`` on.

    ``feed`` limits feed blocks, ``rapid`` rapid ones; 0: no limit. ``vector``: the same by the
    keywords of ``#VECTOR LIMIT``, for FEED and for RAPID. ``rounded_part`` of a line and changes of
    direction up to ``max_bend`` (``kernel/path/segment_limits.py``) are for rounded corners.
    """

    weights: dict[int, AxisWeights] = field(default_factory=dict)
    feed: list[float] = field(default_factory=lambda: [0.0] * rows.VECTOR_WIDTH)
    rapid: list[float] = field(default_factory=lambda: [0.0] * rows.VECTOR_WIDTH)

    vector: dict[str, dict[str, float]] = field(
        default_factory=lambda: {name: {} for name in VECTOR_BLOCKS}
    )
    rounded_part: float = 0.5
    max_bend: float = MAX_BEND

    def weigh(self, function: int, axes: Iterable[int], pct: dict[int, float]) -> bool:
        """Process a weight of ``axes`` in per cent; those without one are at 100 %.

        Return whether anything is weighted differently from before.
        """
        name = _WEIGHTED.get(function)
        if name is None:
            return False
        before = dict(self.weights)
        for axis in axes:
            weights = self.weights.get(axis, AxisWeights())
            self.weights[axis] = replace(weights, **{name: pct.get(axis, 100.0) / 100.0})
        return before != self.weights

    @property
    def is_reduced(self) -> bool:
        """Whether the limits are not those of the lists."""
        if any(self.feed) or any(self.rapid):
            return True
        return any(weights != AxisWeights() for weights in self.weights.values())

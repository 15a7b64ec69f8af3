# SPDX-License-Identifier: MIT
"""The weights of the axes' limits, and the limits of the path, that a program sets.

In: G127 … G134, G230 … G233, ``#VECTOR LIMIT``. They are modal to the end of the program; weights
always relate to the values of the lists.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from types import MappingProxyType

from nctakt.base.dataclass import dataclass, field
from nctakt.kernel import rows
from nctakt.lists.machine.dynamic_weights import WeightRow
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


def bend_of(angle_deg: float) -> float:
    """Return a change of direction as the length of two unit vectors' difference."""
    half = math.radians(min(max(angle_deg, 0.0), 180.0)) / 2.0
    return min(2.0 * math.sin(half), MAX_BEND)


@dataclass(frozen=True, slots=True)
class AxisWeights:
    """The weights of one axis as factors; 1 leaves the value of its list."""

    speed: float = 1.0
    rapid_speed: float = 1.0
    feed_acceleration: float = 1.0
    rapid_acceleration: float = 1.0
    feed_ramp: float = 1.0
    rapid_ramp: float = 1.0


@dataclass(frozen=True, slots=True)
class BlockWeights:
    """The weights of one block by its length or radius, as factors of all axes' limits."""

    rapid: tuple[float, float, float] = (1.0, 1.0, 1.0)
    feed: tuple[float, float, float] = (1.0, 1.0, 1.0)

    def with_row(self, row: WeightRow | None, *, is_rapid: bool, is_capped: bool) -> BlockWeights:
        """Return these weights times those of a row; ``is_capped``: at most 1 but the ramps."""
        if row is None:
            return self
        top = 1.0 if is_capped else 1e9
        before = self.rapid if is_rapid else self.feed
        factors = (
            before[0] * min(row.speed, top),
            before[1] * min(row.acceleration, top),
            before[2] * row.ramp,
        )
        return replace(self, rapid=factors) if is_rapid else replace(self, feed=factors)

    def of(self, weights: AxisWeights) -> AxisWeights:
        """Return the weights of an axis times these."""
        return AxisWeights(
            weights.speed * self.feed[0],
            weights.rapid_speed * self.rapid[0],
            weights.feed_acceleration * self.feed[1],
            weights.rapid_acceleration * self.rapid[1],
            weights.feed_ramp * self.feed[2],
            weights.rapid_ramp * self.rapid[2],
        )


#: The weights of a block without any.
BLOCK_UNWEIGHTED = BlockWeights()

#: The limits that each function weights; the others are accepted without effect.
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
    ``weights_motions`` (bits of P-CHAN-00190) and ``weights_arcs``: blocks have weights by their
    length or radius; ``block``: those of the last one. ``followed``: masters and their slaves by
    index, with the ratio of the slave's distance to the master's, which keeps the limits of both.
    """

    weights: dict[int, AxisWeights] = field(default_factory=dict)
    feed: list[float] = field(default_factory=lambda: [0.0] * rows.VECTOR_WIDTH)
    rapid: list[float] = field(default_factory=lambda: [0.0] * rows.VECTOR_WIDTH)

    vector: dict[str, dict[str, float]] = field(
        default_factory=lambda: {name: {} for name in VECTOR_BLOCKS}
    )
    rounded_part: float = 0.5
    max_bend: float = MAX_BEND
    weights_motions: int = 0
    weights_arcs: bool = False
    block: BlockWeights = BLOCK_UNWEIGHTED
    followed: tuple[tuple[int, int, float], ...] = ()

    @property
    def weights_blocks(self) -> bool:
        """Whether blocks may have weights by their length or radius."""
        return self.weights_motions != 0 or self.weights_arcs

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
        if self.followed or any((*self.feed, *self.rapid)) or self.block != BLOCK_UNWEIGHTED:
            return True
        return any(weights != AxisWeights() for weights in self.weights.values())

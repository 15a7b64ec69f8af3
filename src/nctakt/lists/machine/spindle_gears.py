# SPDX-License-Identifier: MIT
"""The gear steps of spindles in the values of channel lists."""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.values import Values


@dataclass(frozen=True, slots=True)
class GearRanges:
    """The ranges of speeds in 1/min by gear step from 1 on, in the order of their search.

    ``is_automatic``: the speed chooses the step (P-CHAN-00004).
    """

    is_automatic: bool
    ranges: Mapping[int, tuple[float, float]]


@dataclass(frozen=True, slots=True)
class ListedGears:
    """``is_enabled``: P-CHAN-00052. ``ranges`` by the logical number of a spindle."""

    is_enabled: bool
    ranges: Mapping[int, GearRanges]


def listed_gears(values: Values) -> ListedGears:
    """Return what a channel list says about the gear steps of its spindles."""
    return ListedGears(
        values.flag("main_spindle_gear_change"),
        {
            values.integer("spindel[].log_achs_nr", index): _ranges(values, index)
            for index in values.indices("spindel[]")
        },
    )


def _ranges(values: Values, index: int) -> GearRanges:
    table = "spindel[].range_table[]"
    stages = list(values.indices(table, index))
    if values.integer("spindel[].range_way", index) == 1:
        stages.reverse()
    ranges = {
        stage + 1: (
            float(values.integer(f"{table}.min_speed", index, stage)),
            float(values.integer(f"{table}.max_speed", index, stage)),
        )
        for stage in stages
    }
    used = {stage: limits for stage, limits in ranges.items() if limits[1] > 0.0}
    return GearRanges(values.flag("spindel[].autom_range", index), used)

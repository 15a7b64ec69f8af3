# SPDX-License-Identifier: MIT
"""Lists of zero offsets (P-ZERO) and clamp offsets (P-CLMP): declarations, values -> offsets.

In: checked values. Out: ``ZeroOffsets`` and ``ClampOffsets``: groups of one offset per axis of the
channel, in mm, for rotary axes in degrees. G53 … G59 are the groups 0 … 6, G159 = n is group n.
"""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass, field
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.machines.folders import (
    DEFAULT_GROUP_EMPTY,
    GROUP_ZERO_OFFSETS_IGNORED,
    UNKNOWN_AXIS_INDEX,
)

MAX_GROUPS = 97
MAX_AXES = 32
_POSITION_UNITS = 10_000


@dataclass(frozen=True, slots=True)
class ZeroOffsets:
    """The zero offsets of a channel; ``groups``: group -> index of an axis -> offset.

    An offset that is not listed, or inactive in its axis (P-ZERO-00004), is 0. ``default_group``:
    active after start-up and reset. Group 0 has no offsets unless P-ZERO-00001 says so.
    """

    groups: Mapping[int, Mapping[int, float]] = field(default_factory=dict)
    default_group: int = 0

    def offset(self, group: int, axis: int) -> float:
        """Return the offset of a group in an axis of the channel, mm or degrees."""
        return self.groups.get(group, {}).get(axis, 0.0)


@dataclass(frozen=True, slots=True)
class ClampOffsets:
    """The clamp offsets of a channel; ``groups``: group -> index of an axis -> offset."""

    groups: Mapping[int, Mapping[int, float]] = field(default_factory=dict)

    def offset(self, group: int, axis: int) -> float:
        """Return the offset of a group in an axis of the channel, mm or degrees."""
        return self.groups.get(group, {}).get(axis, 0.0)


def zero_offsets_configuration(
    values: Values, axis_count: int, collector: Collector
) -> ZeroOffsets:
    """Return the zero offsets of a channel with this number of axes.

    Reported: an unknown axis (900741), offsets of G53 without effect (900742), a default group
    without offsets (20585).
    """
    g53_available = values.flag("g53_verfuegbar")
    groups: dict[int, dict[int, float]] = {}
    for group in values.indices("np_grp[]"):
        inactive = "np_grp[].achse[].inaktiv"
        offsets = {
            axis: offset
            for axis, offset in _offsets(
                values, "np_grp[].achse[]", "versch", group, axis_count, collector
            )
            if not values.flag(inactive, group, axis)
        }
        if group == 0 and not g53_available:
            wrong = next((axis for axis, offset in offsets.items() if offset), None)
            if wrong is not None:
                values.report(
                    collector, GROUP_ZERO_OFFSETS_IGNORED, ("np_grp[].achse[].versch", 0, wrong)
                )
            continue
        groups[group] = offsets
    default_group = values.integer("default_index")
    if default_group and default_group not in groups:
        values.report(collector, DEFAULT_GROUP_EMPTY, ("default_index",), group=default_group)
    return ZeroOffsets(groups, default_group)


def clamp_offsets_configuration(
    values: Values, axis_count: int, collector: Collector
) -> ClampOffsets:
    """Return the clamp offsets of a channel; an axis beyond ``axes`` is reported (900741)."""
    return ClampOffsets(
        {
            group: dict(
                _offsets(values, "pzv_grp[].achse[]", "versatz", group, axis_count, collector)
            )
            for group in values.indices("pzv_grp[]")
        }
    )


def _offsets(
    values: Values, prefix: str, name: str, group: int, axis_count: int, collector: Collector
) -> list[tuple[int, float]]:
    """Return the offsets of a group as (index of the axis, mm or degrees)."""
    pattern = f"{prefix}.{name}"
    offsets: list[tuple[int, float]] = []
    for axis in values.indices(prefix, group):
        if axis >= axis_count:
            if values.is_set(pattern, group, axis):
                key = (pattern, group, axis)
                values.report(collector, UNKNOWN_AXIS_INDEX, key, index=axis, count=axis_count)
            continue
        offsets.append((axis, values.integer(pattern, group, axis) / _POSITION_UNITS))
    return offsets

# SPDX-License-Identifier: MIT
"""Weights of the dynamics by length or radius in the values of channel lists."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.controller_numbers import bound_number
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.machines.lists import PARAMETER_OUT_OF_RANGE

#: Bits of P-CHAN-00190.
OF_RAPID, OF_FEED = 1, 2
_LENGTH_UNITS = 10_000
#: The least weight, ‰.
_LOWEST = 10


@dataclass(frozen=True, slots=True)
class WeightRow:
    """Factors of speed, acceleration and ramp times below a length or radius, mm or degrees."""

    below: float
    speed: float
    acceleration: float
    ramp: float


@dataclass(frozen=True, slots=True)
class DynamicWeights:
    """``motions``: P-CHAN-00190, ``on_arcs``: P-CHAN-00230; the rows by ascending limits."""

    motions: int
    on_arcs: bool
    by_length: tuple[WeightRow, ...]
    by_radius: tuple[WeightRow, ...]


def dynamic_weights(values: Values, collector: Collector) -> DynamicWeights:
    """Return the settings of a channel list for weights of the dynamics."""
    return DynamicWeights(
        values.integer("dynamic_weighting_active"),
        values.flag("curve_dynamic_weighting_active"),
        _rows(values, "dynamic_weighting[]", "path_limit", "P-CHAN-00191", collector),
        _rows(values, "curve_dynamic_weighting[]", "radius_limit", "P-CHAN-00231", collector),
    )


def _rows(
    values: Values, table: str, limit: str, first: str, collector: Collector
) -> tuple[WeightRow, ...]:
    """Return the rows of a table; those that are not valid are reported and left out."""
    rows: list[WeightRow] = []
    names = (limit, "velocity_fact", "acceleration_fact", "ramp_time_fact")
    before = 0
    for index in values.indices(table):
        row = [values.integer(f"{table}.{name}", index) for name in names]
        lowest = (before + 1, _LOWEST, _LOWEST, _LOWEST)
        # A factor of 0 is that of a row without it: 1000.
        row[1:] = [factor or 1000 for factor in row[1:]]
        wrong = [column for column in range(len(row)) if row[column] < lowest[column]]
        for column in wrong[:1]:
            key = (f"{table}.{names[column]}", index)
            identity = f"P-CHAN-00{int(first[-3:]) + column}"
            values.report(
                collector,
                PARAMETER_OUT_OF_RANGE,
                key,
                bound_number(identity, row[column], is_above=False),
                key=with_indices(key[0], (index,)),
                value=row[column],
                range=f">= {lowest[column]}",
                default=0,
            )
        if not wrong:
            before = row[0]
            speed, acceleration, ramp = (factor / 1000 for factor in row[1:])
            rows.append(WeightRow(row[0] / _LENGTH_UNITS, speed, acceleration, ramp))
    return tuple(rows)

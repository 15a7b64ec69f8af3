# SPDX-License-Identifier: MIT
"""Axes that follow another permanently: their lists, checked against the others."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.couplings import AxisGantry
from nctakt.messages import Collector
from nctakt.messages.machines.coupling_lists import (
    GANTRY_ACCELERATION_DIFFERS,
    GANTRY_MASTER_MISSING,
    GANTRY_MODULO_DIFFERS,
    GANTRY_SLAVE_HAS_NARROWER_LIMIT,
    GANTRY_SLAVE_IN_CHANNEL,
)


def with_gantries(
    axes: Sequence[AxisConfiguration],
    values: Sequence[Values],
    owned: Collection[int],
    collector: Collector,
) -> tuple[AxisConfiguration, ...]:
    """Return the axes; a wrong master (P-AXIS-00070) is reported and left out.

    ``values``: their lists. ``owned``: the indices of those that channels have.
    """
    checked = []
    for index, axis in enumerate(axes):
        number, master = axis.logical_number, axis.gantry.master
        leader = next((other for other in axes if other.logical_number == master), None)
        message = None
        if master and (leader is None or leader is axis or leader.gantry.master):
            message = GANTRY_MASTER_MISSING
        elif master and index in owned:
            message = GANTRY_SLAVE_IN_CHANNEL
        if message is not None:
            key = ("kenngr.gantry_ax_nr",)
            values[index].report(collector, message, key, slave=number, master=master)
            checked.append(replace(axis, gantry=AxisGantry()))
        elif leader is not None and master:
            _compare(axis, leader, values[index], collector)
            checked.append(_like(axis, leader))
        else:
            checked.append(axis)
    return tuple(checked)


def _compare(
    axis: AxisConfiguration, leader: AxisConfiguration, values: Values, collector: Collector
) -> None:
    """Report values that differ between both lists (285690635), and limits that do not count."""
    numbers = {"slave": axis.logical_number, "master": leader.logical_number}
    if _modulo_range(axis) != _modulo_range(leader):
        values.report(collector, GANTRY_MODULO_DIFFERS, ("kenngr.achs_mode",), **numbers)
    steps = sorted({0, *values.indices("getriebe[]")})
    number = steps[axis.gears.index(axis.dynamics)]
    own, other = axis.dynamics.max_acceleration, leader.dynamics.max_acceleration
    if own != other:
        values.report(
            collector,
            GANTRY_ACCELERATION_DIFFERS,
            ("getriebe[].dynamik.a_max", number),
            **numbers,
            value=own,
            other=other,
        )
    narrower: dict[tuple[str, *tuple[int, ...]], bool] = {
        ("getriebe[].dynamik.vb_max", number): axis.max_speed < leader.max_speed,
        ("kenngr.swe_neg",): axis.software_limit_low > leader.software_limit_low,
        ("kenngr.swe_pos",): axis.software_limit_high < leader.software_limit_high,
    }
    for key, is_narrower in narrower.items():
        if is_narrower and values.is_set(*key):
            name = with_indices(key[0], tuple(key[1:]))
            values.report(collector, GANTRY_SLAVE_HAS_NARROWER_LIMIT, key, key=name, **numbers)


def _modulo_range(axis: AxisConfiguration) -> tuple[float, float] | None:
    dynamics = axis.dynamics
    return (dynamics.modulo_low, dynamics.modulo_high) if axis.is_modulo else None


def _like(axis: AxisConfiguration, leader: AxisConfiguration) -> AxisConfiguration:
    """Return a slave with the values taken over from its master."""
    dynamics = replace(
        axis.dynamics,
        max_acceleration=leader.dynamics.max_acceleration,
        modulo_low=leader.dynamics.modulo_low,
        modulo_high=leader.dynamics.modulo_high,
    )
    return replace(axis, is_modulo=leader.is_modulo, dynamics=dynamics)


def gantries(axes: Sequence[AxisConfiguration]) -> Iterator[tuple[int, int, AxisGantry]]:
    """Yield slave and master of each gantry by their indices, and the slave's settings."""
    for index, axis in enumerate(axes):
        for other, leader in enumerate(axes):
            if axis.gantry.master and leader.logical_number == axis.gantry.master:
                yield index, other, axis.gantry

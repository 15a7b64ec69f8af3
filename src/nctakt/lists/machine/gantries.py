# SPDX-License-Identifier: MIT
"""Axes that follow another one for ever: their lists, checked against those of the others."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from nctakt.lists.format.values import Values
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.couplings import AxisGantry
from nctakt.messages import Collector
from nctakt.messages.coupling_lists import GANTRY_MASTER_MISSING, GANTRY_SLAVE_IN_CHANNEL


def with_gantries(
    axes: Sequence[AxisConfiguration],
    values: Sequence[Values],
    owned: Collection[int],
    collector: Collector,
) -> tuple[AxisConfiguration, ...]:
    """Return the axes; a wrong master (P-AXIS-00070) is reported, and none then.

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
        checked.append(axis if message is None else replace(axis, gantry=AxisGantry()))
    return tuple(checked)


def gantries(axes: Sequence[AxisConfiguration]) -> Iterator[tuple[int, int, AxisGantry]]:
    """Yield slave and master of each gantry by their indices, and what the slave's list says."""
    for index, axis in enumerate(axes):
        for other, leader in enumerate(axes):
            if axis.gantry.master and leader.logical_number == axis.gantry.master:
                yield index, other, axis.gantry

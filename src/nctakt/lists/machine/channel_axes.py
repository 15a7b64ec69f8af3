# SPDX-License-Identifier: MIT
"""The axes and spindles of a channel -> their axis lists in the machine.

In: the values of the channel list, all axes of the machine. Out: ``ChannelAxis``,
``ChannelSpindle``. An axis without an axis list, or of another channel, is reported and left out.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.values import Values
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters, Spindle
from nctakt.messages import Collector
from nctakt.messages.machines.folders import AXIS_IN_TWO_CHANNELS, CHANNEL_WITHOUT_AXES
from nctakt.messages.machines.machine import AXIS_LIST_MISSING

_AXIS_NUMBERS = ("gruppe[].achse[].log_achs_nr",)
_SPINDLE_NUMBERS = ("spindel[].log_achs_nr", "main_spindle_ax_nr")


@dataclass(frozen=True, slots=True)
class ChannelAxis:
    """An axis of a channel; ``index`` into the machine's ``axes``."""

    name: str
    logical_number: int
    index: int


@dataclass(frozen=True, slots=True)
class ChannelSpindle:
    """A spindle of a channel; ``index`` into the machine's ``axes``, ``None`` for the PLC's."""

    spindle: Spindle
    index: int | None

    @property
    def name(self) -> str:
        """The name in programs."""
        return self.spindle.name


def c_axis_index(main: ChannelSpindle | None, axes: Sequence[AxisConfiguration]) -> int:
    """Return the index of the main spindle that can be an axis of the path; -1: it cannot.

    The CNC must turn it, and its list have the mode of a C axis (P-AXIS-00015).
    """
    if main is None or main.index is None or not axes[main.index].is_c_axis:
        return -1
    return main.index


def channel_axes(
    parameters: ChannelParameters,
    values: Values,
    axes: Sequence[AxisConfiguration],
    channel: int,
    owners: dict[int, int],
    collector: Collector,
) -> tuple[ChannelAxis, ...]:
    """Return the axes of a channel, without those of an earlier channel.

    ``values``: those of its list. ``owners``: index of an axis -> the channel that it belongs to.
    """
    members: list[ChannelAxis] = []
    for axis in parameters.axes:
        number = axis.logical_number
        position = values.where(_AXIS_NUMBERS, number)
        index = _index(number, axes)
        if index is None:
            collector.report(AXIS_LIST_MISSING, *position, logical=number, name=axis.name)
            continue
        owner = owners.setdefault(index, channel)
        if owner != channel:
            collector.report(
                AXIS_IN_TWO_CHANNELS, *position, axis=number, first=owner, second=channel
            )
        else:
            members.append(ChannelAxis(axis.name, number, index))
    if not parameters.axes:
        values.report(collector, CHANNEL_WITHOUT_AXES, ("gruppe[].achs_anzahl", 0), channel=channel)
    return tuple(members)


def channel_spindles(
    parameters: ChannelParameters,
    values: Values,
    axes: Sequence[AxisConfiguration],
    collector: Collector,
) -> tuple[ChannelSpindle, ...]:
    """Return the spindles of a channel; ``values``: those of its list."""
    members: list[ChannelSpindle] = []
    for spindle in parameters.spindles:
        index = None if spindle.plc_controlled else _index(spindle.logical_number, axes)
        if index is None and not spindle.plc_controlled:
            number = spindle.logical_number
            position = values.where(_SPINDLE_NUMBERS, number)
            collector.report(AXIS_LIST_MISSING, *position, logical=number, name=spindle.name)
        else:
            members.append(ChannelSpindle(spindle, index))
    return tuple(members)


def _index(number: int, axes: Sequence[AxisConfiguration]) -> int | None:
    return next((i for i, axis in enumerate(axes) if axis.logical_number == number), None)

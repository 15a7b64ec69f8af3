# SPDX-License-Identifier: MIT
"""The spindles of a machine's channels: their axis lists, their realtime part, their names."""

from __future__ import annotations

from nctakt.decoder.blocks.spindles import names_of
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.record import Record
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import Spindle
from nctakt.lists.machine.machine import Machine
from nctakt.nc.vocabulary.variable_table import Layout


def channel_spindles(
    configuration: Machine,
    index: int,
    layout: Layout,
    memory: bytearray,
    record: Record,
) -> Spindles:
    """The spindles of a channel with the limits of their axis lists.

    Where the channel's slope is jerk-limited the ramp times of the list count, as for axes.
    """
    is_smooth = configuration.channels[index].parameters.program_start.slope_profile != 0
    spindles = configuration.channels[index].parameters.spindles
    first, cycle_time_us = layout.spindle_cell(index), configuration.cycle_time_us
    made = Spindles(memory, first, len(spindles), record, cycle_time_us)
    before = configuration.channels[:index]
    made.first_number = sum(len(channel.parameters.spindles) for channel in before)
    for place, spindle in enumerate(spindles):
        axis = _axis_of(configuration, spindle)
        if axis is None:
            made.configure(place, plc=spindle.plc_controlled, speed=0.0, acceleration=0.0)
            continue
        slope = axis.dynamics.jerk_slope
        jerk = slope.jerk if is_smooth else 0.0
        acceleration = axis.max_acceleration
        if jerk > 0.0:
            acceleration = min(slope.least_acceleration, axis.dynamics.max_acceleration)
        made.configure(place, plc=False, speed=axis.max_speed, acceleration=acceleration, jerk=jerk)
    return made


def turning(configuration: Machine, index: int) -> dict[int, float]:
    """The places of a channel's spindles that the CNC turns, with the speed of their axis lists.

    In degrees per second; only those that have an axis list.
    """
    spindles = configuration.channels[index].parameters.spindles
    axes = {place: _axis_of(configuration, spindle) for place, spindle in enumerate(spindles)}
    return {place: axis.max_speed for place, axis in axes.items() if axis is not None}


def all_names(configuration: Machine) -> list[str]:
    """The names of all spindles of the machine, channel by channel."""
    return [
        name for channel in configuration.channels for name in names_of(channel.parameters.spindles)
    ]


def _axis_of(configuration: Machine, spindle: Spindle) -> AxisConfiguration | None:
    """The axis list of a spindle; none for one that the PLC turns."""
    for axis in configuration.axes:
        if axis.logical_number == spindle.logical_number and not spindle.plc_controlled:
            return axis
    return None

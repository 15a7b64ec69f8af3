# SPDX-License-Identifier: MIT
"""The spindles of a machine's channels: axis lists, realtime part, names."""

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
    """Return the spindles of a channel with the limits of their axis lists.

    With a jerk-limited slope in the channel list the ramp times limit their jerk, as for axes.
    """
    is_jerk_limited = configuration.channels[index].parameters.program_start.slope_profile != 0
    spindles = configuration.channels[index].parameters.spindles
    first, cycle_time_us = layout.spindle_cell(index), configuration.cycle_time_us
    realtime = Spindles(memory, first, len(spindles), record, cycle_time_us)
    before = configuration.channels[:index]
    realtime.first_number = sum(len(channel.parameters.spindles) for channel in before)
    for column, spindle in enumerate(spindles):
        axis = _axis_of(configuration, spindle)
        if axis is None:
            realtime.configure(column, plc=spindle.plc_controlled, speed=0.0, acceleration=0.0)
            continue
        slope = axis.dynamics.jerk_slope
        jerk = slope.jerk if is_jerk_limited else 0.0
        acceleration = axis.max_acceleration
        if jerk > 0.0:
            acceleration = min(slope.min_acceleration, axis.dynamics.max_acceleration)
        speed = axis.max_speed
        realtime.configure(column, plc=False, speed=speed, acceleration=acceleration, jerk=jerk)
    return realtime


def max_speeds(configuration: Machine, index: int) -> dict[int, float]:
    """Return the maximum speeds, in °/s, of a channel's spindles that the CNC turns.

    The keys are their indices in the channel list; spindles without an axis list are missing.
    """
    spindles = configuration.channels[index].parameters.spindles
    axes = {i: _axis_of(configuration, spindle) for i, spindle in enumerate(spindles)}
    return {i: axis.max_speed for i, axis in axes.items() if axis is not None}


def all_names(configuration: Machine) -> list[str]:
    """Return the names of all spindles of the machine, channel by channel."""
    return [
        name for channel in configuration.channels for name in names_of(channel.parameters.spindles)
    ]


def _axis_of(configuration: Machine, spindle: Spindle) -> AxisConfiguration | None:
    """Return the axis list of a spindle; ``None`` for one that the PLC turns."""
    for axis in configuration.axes:
        if axis.logical_number == spindle.logical_number and not spindle.plc_controlled:
            return axis
    return None

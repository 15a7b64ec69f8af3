# SPDX-License-Identifier: MIT
"""The spindles of a machine's channels: axis lists, realtime part, names."""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.decoder.blocks.axes.spindles import names_of
from nctakt.decoder.state.spindle_gears import SpindleGear, SpindleGears
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.record import Record
from nctakt.lists.machine.axis_configuration import AxisDynamics
from nctakt.lists.machine.channel_configuration import Spindle
from nctakt.lists.machine.machine import Machine
from nctakt.nc.vocabulary.variables.variable_table import Layout


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
        number = _axis_of(configuration, spindle)
        if number < 0:
            realtime.configure(column, plc=spindle.plc_controlled, speed=0.0, acceleration=0.0)
            continue
        axis = configuration.axes[number]
        gear = _gear(axis.dynamics, is_jerk_limited)
        realtime.configure(
            column,
            plc=False,
            speed=gear.speed_v,
            acceleration=gear.acceleration,
            jerk=gear.jerk,
            step=axis.dynamics.gear_number,
            override_pct=axis.max_override_pct,
            axis=number,
        )
    return realtime


def gear_steps(configuration: Machine, index: int) -> dict[int, SpindleGears]:
    """Return the gear steps of a channel's spindles that the CNC turns.

    The keys are their indices in the channel list; spindles without an axis list are missing.
    """
    parameters = configuration.channels[index].parameters
    is_jerk_limited = parameters.program_start.slope_profile != 0
    gears = {}
    for column, spindle in enumerate(parameters.spindles):
        number = _axis_of(configuration, spindle)
        if number >= 0:
            axis = configuration.axes[number]
            steps = {step.gear_number: _gear(step, is_jerk_limited) for step in axis.gears}
            active = axis.dynamics.gear_number
            gears[column] = SpindleGears(steps, active, axis.checks_tool_speed)
    return gears


def follow_executed(gears: Mapping[int, SpindleGears], spindles: Spindles) -> None:
    """Let the decoder begin a program with the gear steps and tools that the spindles have.

    A reset drops what an earlier program has not reached.
    """
    for column, one in gears.items():
        one.active = spindles.limits.gear_step(column)
        one.tool_range = spindles.limits.tool_range(column)


def at_start_up(gears: Mapping[int, SpindleGears]) -> dict[int, SpindleGears]:
    """Return gear steps in their start-up state, for another run."""
    return {
        column: SpindleGears(one.steps, one.active, one.checks_tool)
        for column, one in gears.items()
    }


def _gear(dynamics: AxisDynamics, is_jerk_limited: bool) -> SpindleGear:
    """Return the limits of a spindle in a gear step."""
    slope = dynamics.jerk_slope
    jerk = slope.jerk if is_jerk_limited else 0.0
    acceleration = min(dynamics.feed_acceleration, dynamics.rapid_acceleration)
    if jerk > 0.0:
        acceleration = min(slope.min_acceleration, dynamics.max_acceleration)
    position = dynamics.change_position
    return SpindleGear(dynamics.max_speed, dynamics.rapid_speed, acceleration, jerk, position)


def all_names(configuration: Machine) -> list[str]:
    """Return the names of all spindles of the machine, channel by channel."""
    return [
        name for channel in configuration.channels for name in names_of(channel.parameters.spindles)
    ]


def _axis_of(configuration: Machine, spindle: Spindle) -> int:
    """Return the number in the machine of a spindle's axis; -1 if the PLC turns it."""
    for number, axis in enumerate(configuration.axes):
        if axis.logical_number == spindle.logical_number and not spindle.plc_controlled:
            return number
    return -1

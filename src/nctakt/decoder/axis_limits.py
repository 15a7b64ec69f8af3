# SPDX-License-Identifier: MIT
"""The limits of the machine's axes -> look-ahead and independent motion (MO-1, MO-4, MO-11).

The look-ahead itself runs compiled, in the queue (``kernel/path/lookahead.py``).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.path_limits import AxisWeights, LimitState
from nctakt.decoder.state.queued.limit_commands import AxisLimits, SetLimits
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.record import Record
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.segment_limits import SegmentLimits
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.machine import Machine

#: Speed of an axis with the weight 0: 1 µm/s or 0.001 degrees/s.
MIN_SPEED = 0.001


def look_ahead(
    axes: Sequence[AxisConfiguration],
    cycle_time_us: int,
    blocks: int,
    max_override_pct: float,
    room: int = 0,
) -> LookAhead:
    """Return the look-ahead of a channel with these axes, and room for this many."""
    ahead = LookAhead(len(axes), cycle_time_us, blocks, max_override_pct / 100.0, room)
    apply_axis_limits(ahead.limits, axes)
    return ahead


def apply_axis_limits(limits: SegmentLimits, axes: Sequence[AxisConfiguration]) -> None:
    """Let the limits of the lists apply to the places of a channel with these axes."""
    for index, axis in enumerate(axes):
        limits.limit(
            index,
            axis.is_linear,
            (axis.rapid_speed, axis.max_speed),
            (axis.dynamics.rapid_acceleration, axis.dynamics.feed_acceleration),
        )
        limits.limit_slope(index, axis.dynamics.smooth_accelerations, axis.dynamics.smooth_jerks)


def weighted_limits(axis: AxisConfiguration, weights: AxisWeights) -> AxisLimits:
    """Return the limits of an axis with its weights.

    Speeds are at most P-AXIS-00212, accelerations P-AXIS-00008, ramps take P-AXIS-00201 or longer.
    """
    dynamics = axis.dynamics
    max_speed = max(axis.max_speed * min(weights.speed, 1.0), MIN_SPEED)
    rapid_speed = max(axis.rapid_speed * weights.rapid_speed, MIN_SPEED)
    factors = (weights.rapid_acceleration, weights.feed_acceleration)
    smooth = dynamics.smooth_accelerations
    trapezoid = (dynamics.rapid_acceleration, dynamics.feed_acceleration)
    accelerations = _scaled(trapezoid, factors, dynamics.max_acceleration)
    slope_accelerations = _scaled(smooth, factors, dynamics.max_acceleration)
    shortest_us = max(dynamics.shortest_ramp_time_us, 1)
    slope = dynamics.jerk_slope
    ramps_us = (
        max(slope.rapid_ramp_time_us * weights.rapid_ramp, shortest_us),
        max(max(slope.ramp_times_us) * weights.feed_ramp, shortest_us),
    )
    return AxisLimits(
        (min(rapid_speed, max_speed), max_speed),
        accelerations,
        slope_accelerations,
        (
            slope_accelerations[0] * 1e6 / ramps_us[0],
            slope_accelerations[1] * 1e6 / ramps_us[1],
        ),
    )


def _scaled(
    values: tuple[float, float], factors: tuple[float, float], maximum: float
) -> tuple[float, float]:
    return (min(values[0] * factors[0], maximum), min(values[1] * factors[1], maximum))


def set_limits(
    axes: Sequence[AxisConfiguration], state: LimitState, source: int, number: int
) -> SetLimits:
    """Return the command with the limits that a program has set."""
    none = AxisWeights()
    limits = [
        weighted_limits(axis, state.block.of(state.weights.get(index, none)))
        for index, axis in enumerate(axes)
    ]
    for master, slave, share in state.followed:
        limits[master] = limits[master].lower_with(limits[slave], share)
    return SetLimits(
        source,
        number,
        tuple(limits),
        tuple(state.feed),
        tuple(state.rapid),
        state.is_reduced,
        state.rounded_part,
        state.max_bend,
    )


def listed_limits(axes: Sequence[AxisConfiguration]) -> SetLimits:
    """Return the limits at program start: those of the lists."""
    return set_limits(axes, LimitState(), 0, 0)


def apply_limits(limits: SegmentLimits, command: SetLimits) -> None:
    """Let the limits of a command apply to the segments that come.

    A program that begins without all axes of its list gets theirs with the axes.
    """
    for index, axis in enumerate(command.axes[: limits.count]):
        limits.change(index, axis.speeds, axis.accelerations, axis.slope_accelerations, axis.jerks)
    limits.limit_path(False, command.feed)
    limits.limit_path(True, command.rapid)
    limits.is_reduced = command.is_reduced
    limits.rounded_part = command.rounded_part
    limits.max_bend = command.max_bend


#: Bytes of a block in the memory of backward motion, and of each axis of the channel in it (MO-7).
BLOCK_BYTES = 304
AXIS_BYTES = 24


def history_blocks(memory_bytes: int, axis_count: int) -> int:
    """Return how many blocks before the current one fit into the memory of backward motion
    (MO-7).
    """
    return memory_bytes // (BLOCK_BYTES + AXIS_BYTES * axis_count)


def homing_overrun(axis: AxisConfiguration) -> float:
    """Return the signed distance that an axis needs to stop after its zero pulse."""
    homing = axis.homing
    acceleration = axis.max_acceleration
    speed = min(homing.speed, arithmetic.square_root(2.0 * acceleration * abs(homing.distance)))
    distance = 0.5 * speed * speed / acceleration
    return distance if homing.distance > 0.0 else -distance


def single_axes(configuration: Machine, axes: Axes, record: Record) -> SingleAxes:
    """Return the independent motions of the axes, with the limits of their lists."""
    motions = SingleAxes(axes, record, configuration.cycle_time_us)
    jerky = {
        axis.index
        for channel in configuration.channels
        if channel.parameters.program_start.slope_profile != 0
        for axis in channel.axes
    }
    for index, axis in enumerate(configuration.axes):
        axes.set_override(
            index,
            axis.override_mode,
            axis.max_override_pct,
            ignores_hold=axis.ignores_channel_hold,
        )
        if axis.is_modulo:
            axes.set_modulo(index, axis.dynamics.modulo_low, axis.modulo_range)
        if axis.obstacle != 0.0:
            axes.set_stop(index, axis.obstacle)
        if not axis.follows_exactly:
            _let_lag(axes, index, axis, configuration.cycle_time_us)
        slope = axis.dynamics.jerk_slope
        has_jerk = index in jerky and slope.jerk > 0.0
        motions.configure(
            index,
            low=axis.software_limit_low,
            high=axis.software_limit_high,
            speed=axis.max_speed,
            acceleration=acceleration_alone(axis, index in jerky),
            jerk=slope.jerk if has_jerk else 0.0,
            is_enabled=axis.enable_single_axis,
        )
        if axis.homing.is_allowed:
            overrun = homing_overrun(axis)
            motions.configure_homing(
                index,
                distance=axis.homing.distance + overrun,
                speed=axis.homing.speed,
                overrun=overrun,
                position=axis.homing.position,
            )
    return motions


def acceleration_alone(axis: AxisConfiguration, is_jerk_limited: bool) -> float:
    """Return the acceleration of independent motions of an axis, per s²."""
    slope = axis.dynamics.jerk_slope
    if is_jerk_limited and slope.jerk > 0.0:
        return min(slope.min_acceleration, axis.dynamics.max_acceleration)
    return axis.max_acceleration


def feed_unit(axis: AxisConfiguration, state: ModalState, listed_mm_min: float) -> float:
    """Return FEED=1 of an axis alone in mm/s or degrees/s.

    ``listed_mm_min``: the unit of the lists (P-CHAN-00108).
    """
    if not axis.is_linear:
        return 1.0 / 60.0
    return (state.length_unit_mm if state.inch else listed_mm_min) / 60.0


def _let_lag(axes: Axes, index: int, axis: AxisConfiguration, cycle_time_us: int) -> None:
    """Set the following error of an axis per tick (MO-10); with a feed-forward share of 1 there is
    none.
    """
    reach = axis.kv * cycle_time_us / 1e6
    kept = math.exp(-reach)
    axes.set_lag(index, kept, (1.0 - kept) / reach)
    axes.feed_forward(index, axis.feed_forward.permanent_share)

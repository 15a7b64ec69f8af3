# SPDX-License-Identifier: MIT
"""The state of axes and spindles: from one object to another of its class, and its arrays.

A copy has all that changes after an object has been built; what is in its arrays is not in it.
``tests/kernel/test_state.py`` holds the functions to the fields that the classes assign.
"""

from __future__ import annotations

from collections.abc import Callable
from types import MappingProxyType
from typing import Any

from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.axis_motions import AxisMotions
from nctakt.kernel.axes.c_axis import CAxis
from nctakt.kernel.axes.coordinates import Offsets, Turns
from nctakt.kernel.axes.couplings import Couplings
from nctakt.kernel.axes.cutting_speeds import CuttingSpeeds
from nctakt.kernel.axes.spindle_limits import SpindleLimits
from nctakt.kernel.axes.spindle_overrides import SpindleOverrides
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.axes.trajectory import Trajectories
from nctakt.kernel.axes.transformations import Transformations
from nctakt.kernel.kinematics.maps import KinematicMaps
from nctakt.kernel.kinematics.orientation import Orientation

Arrays = tuple[Any, ...]


def copy_axes(source: Axes, target: Axes) -> None:
    target.count = source.count
    target.has_lag = source.has_lag
    target.is_late = source.is_late
    target.has_stops = source.has_stops
    target.has_moved = source.has_moved
    target.is_shifted = source.is_shifted


def arrays_of_axes(part: Axes) -> Arrays:
    return (
        part.cells,
        part.command,
        part.lag_d,
        part.lag_kept,
        part.lag_alone,
        part.lag_gained,
        part.followed,
        part.drive_d,
        part.unsent,
        part.target,
        part.modulo_low,
        part.modulo_range,
        part.on_path,
        part.independent,
        part.override_mode,
        part.override_pct,
        part.max_override_pct,
        part.independent_pct,
        part.stop_low,
        part.stop_high,
        part.shown_command,
        part.shown_actual,
        part.shown_target,
        part.actual,
    )


def copy_axis_motions(source: AxisMotions, target: AxisMotions) -> None:
    target.count = source.count
    target.active_count = source.active_count
    target.fault_count = source.fault_count
    target.reported_count = source.reported_count
    target.requested_axis = source.requested_axis
    target.has_exchanged = source.has_exchanged
    target.source = source.source
    target.serial = source.serial
    target.failed_count = source.failed_count


def arrays_of_axis_motions(part: AxisMotions) -> Arrays:
    return (
        part.enabled,
        part.low,
        part.high,
        part.listed_low,
        part.listed_high,
        part.is_homing,
        part.limit_v,
        part.limit_a,
        part.limit_j,
        part.kind,
        part.held,
        part.owner,
        part.serials,
        part.sources,
        part.goal,
        part.end,
        part.commanded_v,
        part.direction,
        part.next_kind,
        part.next_owner,
        part.next_serial,
        part.next_source,
        part.next_value,
        part.next_v,
        part.next_direction,
        part.next_held,
        part.speed,
        part.acceleration,
        part.last_direction,
        part.planned_v,
        part.start_d,
        part.ticks,
        part.fault,
        part.failed,
        part.arrived,
        part.in_channel,
        part.closed,
    )


def copy_offsets(source: Offsets, target: Offsets) -> None:
    target.count = source.count


def arrays_of_offsets(part: Offsets) -> Arrays:
    return (
        part.values,
        part.program,
        part.origin,
    )


def copy_turns(source: Turns, target: Turns) -> None:
    target.active = source.active


def arrays_of_turns(part: Turns) -> Arrays:
    return (
        part.second,
        part.third,
        part.matrix,
    )


def copy_couplings(source: Couplings, target: Couplings) -> None:
    target.axis_count = source.axis_count
    target.count = source.count
    target.fixed_count = source.fixed_count
    target.watched_count = source.watched_count


def arrays_of_couplings(part: Couplings) -> Arrays:
    return (
        part.slave,
        part.master,
        part.factor,
        part.slave_begin,
        part.master_begin,
        part.allowed_d,
        part.closed,
    )


def copy_c_axis(source: CAxis, target: CAxis) -> None:
    target.axis = source.axis
    target.spindle = source.spindle
    target.last = source.last
    target.is_active = source.is_active


def copy_spindles(source: Spindles, target: Spindles) -> None:
    target.count = source.count
    target.first_number = source.first_number
    target.issued = source.issued
    target.version = source.version
    target.active_count = source.active_count


def arrays_of_spindles(part: Spindles) -> Arrays:
    return (
        part.cells,
        part.is_plc,
        part.position,
        part.speed_v,
        part.acceleration,
        part.mode,
        part.begin_position,
        part.begin_tick,
        part.commanded_v,
        part.commanded_position,
        part.direction,
        part.function,
        part.is_open,
        part.is_held,
        part.owner,
        part.source,
        part.serial,
        part.taken_tick,
        part.plc_state,
        part.done_tick,
        part.job,
        part.reached_v,
        part.laps,
    )


def copy_cutting_speeds(source: CuttingSpeeds, target: CuttingSpeeds) -> None:
    target.active_count = source.active_count
    target.rapid_cell = source.rapid_cell


def arrays_of_cutting_speeds(part: CuttingSpeeds) -> Arrays:
    return (
        part.surface_v,
        part.face_axis,
        part.centre_d,
        part.limit_v,
    )


def arrays_of_spindle_overrides(part: SpindleOverrides) -> Arrays:
    return (
        part.cells,
        part.programmed_v,
        part.acted_pct,
        part.highest_pct,
        part.is_ignored,
    )


def copy_spindle_limits(source: SpindleLimits, target: SpindleLimits) -> None:
    target.count = source.count


def arrays_of_spindle_limits(part: SpindleLimits) -> Arrays:
    return (
        part.speed_v,
        part.acceleration_a,
        part.jerk_j,
        part.low_v,
        part.step,
        part.own_v,
        part.own_a,
        part.tool_low_v,
        part.tool_v,
        part.tool_a,
        part.bound_v,
        part.bound_a,
        part.bound_j,
    )


def copy_trajectories(source: Trajectories, target: Trajectories) -> None:
    target.distance_d = source.distance_d
    target.speed_v = source.speed_v
    target.acceleration_a = source.acceleration_a
    target.top_v = source.top_v
    target.limit_a = source.limit_a
    target.limit_j = source.limit_j
    target.from_v = source.from_v
    target.from_a = source.from_a
    target.middle_v = source.middle_v
    target.middle_a = source.middle_a
    target.slowest_v = source.slowest_v
    target.slowest_peak2 = source.slowest_peak2
    target.first_peak2 = source.first_peak2
    target.sign = source.sign
    target.cruise_t = source.cruise_t
    target.first_t = source.first_t
    target.hold_t = source.hold_t
    target.last_t = source.last_t
    target.peak_a = source.peak_a
    target.first_j = source.first_j
    target.row = source.row
    target.count = source.count
    target.end_t = source.end_t
    target.end_d = source.end_d
    target.end_v = source.end_v
    target.goal_v = source.goal_v
    target.side = source.side


def arrays_of_trajectories(part: Trajectories) -> Arrays:
    return (part.rows,)


def copy_transformations(source: Transformations, target: Transformations) -> None:
    target.active_count = source.active_count
    target.named = source.named
    target.joint_count = source.joint_count
    target.target_number = source.target_number


def arrays_of_transformations(part: Transformations) -> Arrays:
    return (
        part.active,
        part.gathered,
        part.mapped,
        part.near,
        part.tips,
        part.joint_axes,
        part.joint_members,
        part.joint_mapped,
        part.mapped_targets,
    )


def copy_kinematic_maps(source: KinematicMaps, target: KinematicMaps) -> None:
    target.capacity = source.capacity
    target.used = source.used
    target.values = source.values
    target.x = source.x
    target.y = source.y
    target.z = source.z


def arrays_of_kinematic_maps(part: KinematicMaps) -> Arrays:
    return (
        part.values,
        part.columns,
        part.linear,
        part.between,
        part.near_between,
    )


def copy_orientation(source: Orientation, target: Orientation) -> None:
    target.first = source.first
    target.second = source.second
    target.other_first = source.other_first
    target.other_second = source.other_second
    target.x = source.x
    target.y = source.y
    target.z = source.z


#: Class -> what copies its state.
COPIERS: MappingProxyType[type, Callable[..., None]] = MappingProxyType(
    {
        KinematicMaps: copy_kinematic_maps,
        Orientation: copy_orientation,
        Transformations: copy_transformations,
        Axes: copy_axes,
        AxisMotions: copy_axis_motions,
        CAxis: copy_c_axis,
        Couplings: copy_couplings,
        CuttingSpeeds: copy_cutting_speeds,
        Offsets: copy_offsets,
        Turns: copy_turns,
        Spindles: copy_spindles,
        SpindleLimits: copy_spindle_limits,
        Trajectories: copy_trajectories,
    }
)

#: Class -> what returns its arrays.
ARRAYS: MappingProxyType[type, Callable[..., Arrays]] = MappingProxyType(
    {
        KinematicMaps: arrays_of_kinematic_maps,
        Transformations: arrays_of_transformations,
        Axes: arrays_of_axes,
        AxisMotions: arrays_of_axis_motions,
        Couplings: arrays_of_couplings,
        CuttingSpeeds: arrays_of_cutting_speeds,
        Offsets: arrays_of_offsets,
        Turns: arrays_of_turns,
        Spindles: arrays_of_spindles,
        SpindleLimits: arrays_of_spindle_limits,
        SpindleOverrides: arrays_of_spindle_overrides,
        Trajectories: arrays_of_trajectories,
    }
)

# SPDX-License-Identifier: MIT
"""The state of the path: as ``axes.py``.

Of the history only the rows of segments that have begun count, and the first one, which is read
before there is any.
"""

from __future__ import annotations

from collections.abc import Callable
from types import MappingProxyType
from typing import Any

from nctakt.kernel.path.arc_limits import ArcLimits
from nctakt.kernel.path.arc_speed import ArcSpeed
from nctakt.kernel.path.backward import BackwardMotion
from nctakt.kernel.path.corner import Corner
from nctakt.kernel.path.corner_rounding import CornerRounding
from nctakt.kernel.path.edge_probe import EdgeProbe
from nctakt.kernel.path.fixed_stops import FixedStops
from nctakt.kernel.path.goal import Goal
from nctakt.kernel.path.history import History
from nctakt.kernel.path.jerk_lookahead import JerkLookAhead
from nctakt.kernel.path.jerk_profile import JerkProfile
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.override import Overrides
from nctakt.kernel.path.path import Path
from nctakt.kernel.path.path_axes import PathAxes
from nctakt.kernel.path.segment_limits import SegmentLimits
from nctakt.kernel.path.threads import Threads
from nctakt.kernel.path.tool_life import ToolLife
from nctakt.kernel.path.touch_probe import TouchProbe
from nctakt.kernel.path.transformed_limits import TransformedLimits
from nctakt.kernel.path.trapezoid_profile import TrapezoidProfile

Arrays = tuple[Any, ...]


def copy_arc_limits(source: ArcLimits, target: ArcLimits) -> None:
    target.count = source.count
    target.max_v = source.max_v
    target.max_a = source.max_a
    target.pieces = source.pieces
    target.first_a = source.first_a
    target.second_a = source.second_a
    target.outer_a = source.outer_a
    target.outer_v = source.outer_v


def arrays_of_arc_limits(part: ArcLimits) -> Arrays:
    return (
        part.max_v,
        part.max_a,
        part.first_parts,
        part.second_parts,
        part.first_curvatures,
        part.second_curvatures,
        part.caps,
        part.keeps,
        part.ends,
    )


def copy_arc_speed(source: ArcSpeed, target: ArcSpeed) -> None:
    target.prepared_v = source.prepared_v
    target.next_feed_v = source.next_feed_v
    target.max_end_v = source.max_end_v
    target.surveyed_v = source.surveyed_v
    target.surveyed_target_v = source.surveyed_target_v


def arrays_of_arc_speed(part: ArcSpeed) -> Arrays:
    return (
        part.highs,
        part.lows,
    )


def copy_backward_motion(source: BackwardMotion, target: BackwardMotion) -> None:
    target.stage = source.stage
    target.stage_d = source.stage_d
    target.plan_d = source.plan_d
    target.offset_t = source.offset_t
    target.ticks = source.ticks
    target.factor = source.factor
    target.is_single = source.is_single
    target.is_blocked = source.is_blocked
    target.was_paused = source.was_paused
    target.was_released = source.was_released
    target.fault = source.fault
    target.has_failed = source.has_failed
    target.fault_source = source.fault_source
    target.entered = source.entered


def copy_corner(source: Corner, target: Corner) -> None:
    target.centripetal_share = source.centripetal_share
    target.last_centripetal_share = source.last_centripetal_share
    target.last_length = source.last_length
    target.last_deviation = source.last_deviation
    target.last_part = source.last_part
    target.last_bend = source.last_bend
    target.corner_v = source.corner_v
    target.last_corner_v = source.last_corner_v
    target.is_rounded = source.is_rounded
    target.last_is_rounded = source.last_is_rounded
    target.is_bent = source.is_bent
    target.last_is_bent = source.last_is_bent


def arrays_of_corner(part: Corner) -> Arrays:
    return (
        part.entering,
        part.leaving,
        part.entering_curve,
        part.leaving_curve,
        part.steps,
        part.shares,
        part.turns,
        part.unused,
    )


def arrays_of_corner_rounding(part: CornerRounding) -> Arrays:
    return (
        part.row,
        part.spare,
    )


def copy_edge_probe(source: EdgeProbe, target: EdgeProbe) -> None:
    target.phase = source.phase
    target.source = source.source
    target.function = source.function
    target.ticks = source.ticks
    target.has_value = source.has_value
    target.value = source.value
    target.residual_d = source.residual_d
    target.joint_d = source.joint_d


def arrays_of_edge_probe(part: EdgeProbe) -> Arrays:
    return (part.cells,)


def copy_fixed_stops(source: FixedStops, target: FixedStops) -> None:
    target.count = source.count
    target.detected_count = source.detected_count


def arrays_of_fixed_stops(part: FixedStops) -> Arrays:
    return (
        part.active,
        part.detected,
        part.needed,
        part.ticks,
        part.sources,
        part.limit_d,
        part.min_ticks,
        part.from_part,
        part.to_part,
    )


def copy_goal(source: Goal, target: Goal) -> None:
    target.distance_d = source.distance_d
    target.speed_v = source.speed_v
    target.acceleration_a = source.acceleration_a
    target.jerk_j = source.jerk_j
    target.kind = source.kind
    target.carried_a = source.carried_a
    target.carried_j = source.carried_j


def copy_history(source: History, target: History) -> None:
    target.number = source.number
    target.front_number = source.front_number
    target.front_map = source.front_map
    target.stretch_end = source.stretch_end
    target.limit_a = source.limit_a
    target.limit_j = source.limit_j
    target.rounding_a = source.rounding_a
    target.rounding_j = source.rounding_j


def arrays_of_history(part: History) -> Arrays:
    return (
        part.foreign,
        part.stretch,
        part.goal_row,
    )


def copy_jerk_look_ahead(source: JerkLookAhead, target: JerkLookAhead) -> None:
    target.capacity = source.capacity


def copy_jerk_profile(source: JerkProfile, target: JerkProfile) -> None:
    target.acceleration_a = source.acceleration_a
    target.distance_d = source.distance_d
    target.speed_v = source.speed_v
    target.left_t = source.left_t
    target.rest_d = source.rest_d
    target.ends_in_time = source.ends_in_time
    target.stands_at_end = source.stands_at_end
    target.own_j = source.own_j


def copy_look_ahead(source: LookAhead, target: LookAhead) -> None:
    target.capacity = source.capacity


def arrays_of_look_ahead(part: LookAhead) -> Arrays:
    return (part.spare,)


def copy_overrides(source: Overrides, target: Overrides) -> None:
    target.max_pct = source.max_pct
    target.operator_pct = source.operator_pct
    target.cycle_pct = source.cycle_pct
    target.total_pct = source.total_pct


def copy_tool_life(source: ToolLife, target: ToolLife) -> None:
    target.is_counted = source.is_counted
    target.has_moved = source.has_moved
    target.counted_d = source.counted_d
    target.time_t = source.time_t
    target.distance_d = source.distance_d
    target.time_factor = source.time_factor
    target.distance_factor = source.distance_factor
    target.begin_t = source.begin_t
    target.ticks = source.ticks
    target.begin_d = source.begin_d
    target.from_d = source.from_d
    target.tool = source.tool
    target.basic = source.basic


def copy_path(source: Path, target: Path) -> None:
    target.used = source.used
    target.oldest = source.oldest
    target.front = source.front
    target.is_retracing = source.is_retracing
    target.is_front_over = source.is_front_over
    target.serial = source.serial
    target.is_active = source.is_active
    target.is_dwell = source.is_dwell
    target.dwell_ticks = source.dwell_ticks
    target.pieces = source.pieces
    target.stage = source.stage
    target.stage_end_d = source.stage_end_d
    target.factor = source.factor
    target.common_factor = source.common_factor
    target.unoverridden_factor = source.unoverridden_factor
    target.planned_factor = source.planned_factor
    target.covered_d = source.covered_d
    target.plan_d = source.plan_d
    target.speed_v = source.speed_v
    target.limit_v = source.limit_v
    target.offset_t = source.offset_t
    target.ticks = source.ticks
    target.left_t = source.left_t
    target.is_single = source.is_single


def arrays_of_path(part: Path) -> Arrays:
    return (
        part.ends,
        part.positions,
    )


def copy_path_axes(source: PathAxes, target: PathAxes) -> None:
    target.count = source.count
    target.moved_count = source.moved_count
    target.refused_axis = source.refused_axis
    target.slot = source.slot
    target.row = source.row
    target.direction = source.direction


def arrays_of_path_axes(part: PathAxes) -> Arrays:
    return (
        part.members,
        part.moved,
        part.unmapped,
        part.near,
        part.standing,
    )


def copy_segment_limits(source: SegmentLimits, target: SegmentLimits) -> None:
    target.count = source.count
    target.has_jerk_limit = source.has_jerk_limit
    target.is_reduced = source.is_reduced
    target.has_changed = source.has_changed
    target.rounded_part = source.rounded_part
    target.max_bend = source.max_bend


def arrays_of_segment_limits(part: SegmentLimits) -> Arrays:
    return (
        part.linear,
        part.rapid_v,
        part.max_v,
        part.rapid_a,
        part.feed_a,
        part.rapid_slope_a,
        part.feed_slope_a,
        part.rapid_j,
        part.feed_j,
        part.listed_v,
        part.listed_a,
        part.kept_rapid_a,
        part.kept_feed_a,
        part.kept_rapid_slope_a,
        part.kept_feed_slope_a,
        part.kept_rapid_j,
        part.kept_feed_j,
        part.vector,
        part.direction,
        part.unused,
    )


def copy_transformed_limits(source: TransformedLimits, target: TransformedLimits) -> None:
    target.count = source.count
    target.turn = source.turn
    target.steps = source.steps
    target.is_even = source.is_even
    target.plane_axis = source.plane_axis
    target.rapid_v = source.rapid_v
    target.max_v = source.max_v
    target.rapid_a = source.rapid_a
    target.feed_a = source.feed_a
    target.rapid_slope_a = source.rapid_slope_a
    target.feed_slope_a = source.feed_slope_a
    target.rapid_j = source.rapid_j
    target.feed_j = source.feed_j
    target.transformations = source.transformations


def arrays_of_transformed_limits(part: TransformedLimits) -> Arrays:
    return (
        part.linear,
        part.rapid_v,
        part.max_v,
        part.rapid_a,
        part.feed_a,
        part.rapid_slope_a,
        part.feed_slope_a,
        part.rapid_j,
        part.feed_j,
        part.near,
        part.point,
        part.start,
        part.target,
        part.samples,
        part.result,
        part.first,
        part.second,
        part.third,
        part.entering,
        part.leaving,
        part.entering_curve,
        part.leaving_curve,
    )


def copy_trapezoid_profile(source: TrapezoidProfile, target: TrapezoidProfile) -> None:
    target.first_t = source.first_t
    target.first_a = source.first_a
    target.first_d = source.first_d
    target.start_v = source.start_v
    target.cruise_t = source.cruise_t
    target.cruise_v = source.cruise_v
    target.cruise_d = source.cruise_d
    target.last_a = source.last_a
    target.duration_t = source.duration_t
    target.length_d = source.length_d
    target.end_v = source.end_v
    target.is_endless = source.is_endless


def history_of_path(path: Path) -> tuple[Any, int]:
    """Return the rows of the history, and how many of their cells count."""
    count = min(max(path.used, 1), path.ring_size)
    return path.history_rows, count * path.width


def copy_threads(source: Threads, target: Threads) -> None:
    target.state = source.state
    target.is_cutting = source.is_cutting
    target.was_cut = source.was_cut
    target.spindle = source.spindle
    target.angle = source.angle
    target.turn = source.turn
    target.length_d = source.length_d
    target.delay_t = source.delay_t
    target.source = source.source
    target.fault = source.fault


def copy_touch_probe(source: TouchProbe, target: TouchProbe) -> None:
    target.is_seeking = source.is_seeking
    target.is_braking = source.is_braking
    target.has_touched = source.has_touched
    target.source = source.source
    target.touch_part = source.touch_part
    target.ticks = source.ticks
    target.touch_level = source.touch_level
    target.continues = source.continues
    target.is_needed = source.is_needed


def arrays_of_touch_probe(part: TouchProbe) -> Arrays:
    return (part.values,)


#: Class -> what copies its state.
COPIERS: MappingProxyType[type, Callable[..., None]] = MappingProxyType(
    {
        ArcLimits: copy_arc_limits,
        ArcSpeed: copy_arc_speed,
        BackwardMotion: copy_backward_motion,
        Corner: copy_corner,
        ToolLife: copy_tool_life,
        EdgeProbe: copy_edge_probe,
        FixedStops: copy_fixed_stops,
        Goal: copy_goal,
        History: copy_history,
        JerkLookAhead: copy_jerk_look_ahead,
        JerkProfile: copy_jerk_profile,
        LookAhead: copy_look_ahead,
        Overrides: copy_overrides,
        Path: copy_path,
        PathAxes: copy_path_axes,
        SegmentLimits: copy_segment_limits,
        Threads: copy_threads,
        TouchProbe: copy_touch_probe,
        TransformedLimits: copy_transformed_limits,
        TrapezoidProfile: copy_trapezoid_profile,
    }
)

#: Class -> what returns its arrays.
ARRAYS: MappingProxyType[type, Callable[..., Arrays]] = MappingProxyType(
    {
        ArcLimits: arrays_of_arc_limits,
        ArcSpeed: arrays_of_arc_speed,
        Corner: arrays_of_corner,
        CornerRounding: arrays_of_corner_rounding,
        EdgeProbe: arrays_of_edge_probe,
        FixedStops: arrays_of_fixed_stops,
        History: arrays_of_history,
        LookAhead: arrays_of_look_ahead,
        Path: arrays_of_path,
        PathAxes: arrays_of_path_axes,
        SegmentLimits: arrays_of_segment_limits,
        TouchProbe: arrays_of_touch_probe,
        TransformedLimits: arrays_of_transformed_limits,
    }
)

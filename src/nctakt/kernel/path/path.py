# SPDX-License-Identifier: MIT
"""The path: prepared segments -> command positions, one increment a tick (MO-1 … MO-6).

A segment is a row of the command queue (``rows.py``); ``geometry.py`` computes where the axes are
on it. The path handles what only the tick knows: override, hold and stop. Every change of the speed
limit replans the rest of the present stage of the segment from the present speed; position and
speed come from the plan in closed form. Time left over in a tick when a segment ends without a stop
is carried into the next one. Segments that were used stay in the history until they are
overwritten: ``backward.py`` walks back over them (MO-7).
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.base.bounds import check_index, check_size
from nctakt.kernel.path import geometry
from nctakt.kernel.path.arc_speed import ArcSpeed
from nctakt.kernel.path.jerk_profile import JerkProfile
from nctakt.kernel.path.path_axes import PathAxes
from nctakt.kernel.path.tool_life import ToolLifeCounter
from nctakt.kernel.path.trapezoid_profile import TrapezoidProfile


class Path(PathAxes):
    """Path of one channel over those of the machine's axes that belong to it.

    ``history_size`` blocks before the current one are kept, from the running number ``oldest`` on.
    ``front`` is the row of the newest segment. While the path ``is_retracing`` from it the current
    row is another one, walked over in ``direction`` (1 forward, -1 backward), and
    ``is_front_over``: the newest segment had already reached its end.
    """

    def __init__(
        self,
        axes: Axes,
        members: list[int],
        cycle_time_us: int,
        history_size: int = 0,
        room: int = 0,
    ) -> None:
        check_size(history_size, "size of the history")
        super().__init__(axes, members, room)
        self.cycle_time_t = cycle_time_us / 1e6
        self.cycle_time_us = cycle_time_us
        self.width = rows.segment_width(self.room)
        self.history_size = history_size
        self.ring_size = history_size + 1
        self.history_rows = doubles(self.ring_size * self.width)
        self.ends = doubles(self.room)
        self.used = 0
        self.oldest = 0
        self.front = 0
        self.is_retracing = False
        self.is_front_over = False
        self.serial = 0
        self.is_active = False
        self.is_dwell = False
        self.dwell_ticks = 0
        self.profile = TrapezoidProfile()
        self.arc = ArcSpeed(len(members), self.profile, self.room)
        self.pieces = 0
        self.jerk_profile = JerkProfile(self.cycle_time_t)
        self.life = ToolLifeCounter(cycle_time_us)
        self.positions = doubles(self.room)
        self.stage = 0
        self.stage_end_d = 0.0
        self.factor = 1.0
        self.common_factor = 1.0
        self.unoverridden_factor = 1.0
        self.planned_factor = 1.0
        self.covered_d = 0.0
        self.plan_d = 0.0
        self.speed_v = 0.0
        self.limit_v = -1.0
        self.offset_t = 0.0
        self.ticks = 0
        self.left_t = 0.0
        self.is_single = False

    def begin(self, queue_row: int, queue: memoryview[float], offset_t: float) -> None:
        """Begin the segment of ``queue`` at ``queue_row``, ``offset_t`` s into it."""
        if not self.continues_block():
            self.serial += 1
        self.row = (self.used % self.ring_size) * self.width
        for i in range(self.width):
            self.history_rows[self.row + i] = queue[queue_row + i]
        self.history_rows[self.row + rows.SHOWN_TRANSFORMATION] = self.shown_map()
        self.front = self.row
        if self.history_size > 0:
            self.remember()
        self.used += 1
        self.is_active = True
        self.is_dwell = self.history_rows[self.row + rows.KIND] == rows.DWELL
        dwell_ticks = int(self.history_rows[self.row + rows.DWELL_TICKS])
        self.dwell_ticks = dwell_ticks if self.is_dwell else 0
        self.covered_d = 0.0
        self.plan_d = 0.0
        self.limit_v = -1.0
        self.offset_t = offset_t
        self.ticks = 0
        if not self.is_dwell:
            self.life.begin(1 - self.is_rapid())
            self.enter_stages()
            self.next_stage()
            self.claim()

    def enter_stages(self) -> None:
        """Reset to before the first stage."""
        self.jerk_profile.begin()
        self.stage = codes.BEFORE_STAGES
        self.stage_end_d = 0.0
        self.pieces = geometry.pieces(self.history_rows, self.row)
        if self.pieces > 0:
            self.arc.begin(self.history_rows, self.row)

    def remember(self) -> None:
        """Keep the segment in the history; begin a new one if an axis was moved by other means."""
        if self.used - self.oldest > self.history_size:
            self.oldest += 1
        if self.history_rows[self.row + rows.KIND] == rows.DWELL:
            return
        end = geometry.end_column(self.history_rows, self.row, self.count)
        if self.history_rows[self.row + rows.TRANSFORMATION] > 0.0:
            if not self.continues_from(self.ends):
                self.oldest = self.used
            return
        for i in range(self.count):
            if self.history_rows[self.row + rows.START + i] != self.ends[i]:
                self.oldest = self.used
            self.ends[i] = self.history_rows[end + i]

    def history(self) -> tuple[memoryview[float], int]:
        """Return the rows of the history, and how many of their cells count.

        The first row always counts: it is read before there is any segment.
        """
        count = min(max(self.used, 1), self.ring_size)
        return self.history_rows, count * self.width

    def programmed_speed(self) -> float:
        """Return the programmed speed of the current segment in mm/s, 0 without one."""
        if not self.is_active or self.is_dwell:
            return 0.0
        return self.history_rows[self.row + rows.SPEED]

    def row_of(self, number: int) -> int:
        """Row of the segment with this running number."""
        return number % self.ring_size * self.width

    def return_to_newest(self, covered_d: float) -> None:
        """Return to the newest segment at ``covered_d`` mm and continue forward."""
        self.is_retracing = False
        self.direction = 1
        self.row = self.front
        self.limit_v = -1.0
        self.offset_t = 0.0
        self.ticks = 0
        self.is_dwell = self.history_rows[self.row + rows.KIND] == rows.DWELL
        if self.is_dwell:
            return
        self.covered_d = covered_d
        self.enter_stages()
        while self.next_stage() and self.stage_end_d <= covered_d:
            pass
        self.claim_again()

    def forget(self) -> None:
        """End the history: the walk back stops here."""
        self.oldest = self.used

    def continues_block(self) -> bool:
        """Return whether the block of the newest segment continues with the next one."""
        return self.history_rows[self.front + rows.CONTINUES] > 0.0

    def set_remaining(self, remaining: float) -> None:
        """Set the rest of the block after the newest segment.

        With a limit of the jerk its length, else the highest speed that reaches 0 at its end.
        """
        if self.history_rows[self.front + rows.JERK] > 0.0:
            self.history_rows[self.front + rows.REMAINING_LENGTH] = remaining
        else:
            self.history_rows[self.front + rows.REMAINING_SPEED] = remaining

    def remaining_speed(self) -> float:
        """Highest speed at the segment's end from which its block can end at a standstill."""
        return self.history_rows[self.row + rows.REMAINING_SPEED]

    def block_serial(self) -> int:
        """Running number of the current block, 0 between two blocks."""
        return self.serial if self.is_active or self.continues_block() else 0

    def next_stage(self) -> int:
        """Continue with the segment's next stage with a length; return 0 if none is left.

        The pieces of an arc whose limits go by its angle are its stages.
        """
        if self.pieces > 0:
            if self.stage + 1 == self.pieces:
                return 0
            self.stage += 1
            border = self.stage + 1
            self.stage_end_d = self.arc.ends[border]
            return 1
        while self.stage < codes.CURVE:
            self.stage += 1
            length = geometry.stage_length(self.history_rows, self.row, self.stage)
            if length > 0.0:
                self.stage_end_d += length
                return 1
        return 0

    def step(self, factor: float, is_stopping: int) -> int:
        """Advance a tick at an override factor; return 1 if the segment ended with time left.

        ``is_stopping`` brakes on the path to a standstill, at the path's acceleration (MO-6).
        """
        if not self.is_active:
            self.speed_v = 0.0
            if self.moved_count > 0:
                self.show_standstill()
            return 0
        if self.is_dwell:
            self.limit_v = 0.0 if is_stopping else -1.0
            self.dwell_ticks -= 0 if is_stopping else 1
            if self.dwell_ticks <= 0:
                self.is_active = False
            return 0
        limit_v = self.highest_speed(factor, is_stopping)
        if limit_v != self.limit_v or self.common_factor != self.planned_factor:
            self.offset_t = 0.0
            self.replan(limit_v)
        self.ticks += 1
        has_time_left = self.advance()
        if self.speed_v == 0.0 and self.is_active and self.is_at_end():
            self.left_t = 0.0
            return self.finish()
        return has_time_left

    def is_at_end(self) -> int:
        """Return whether nothing is left of the segment but a rounding error, in mm.

        A stop whose braking distance is that to the end has ended the segment (RC-105, MO-6).
        """
        rest_d = geometry.total_length(self.history_rows, self.row) - self.covered_d
        return 1 if rest_d <= 1e-9 and rest_d < self.covered_d else 0

    def set_single(self, is_single: bool) -> None:
        """Switch single block; replan the current segment where it matters (MO-6)."""
        self.is_single = is_single
        if self.is_active and not self.is_dwell and self.ends_moving():
            self.limit_v = -1.0

    def ends_moving(self) -> int:
        """Return whether the current segment does not end at a standstill."""
        goal = self.history_rows[self.row + rows.GOAL_LENGTH]
        goal += self.history_rows[self.row + rows.GOAL_SPEED]
        return 1 if self.history_rows[self.row + rows.END_SPEED] + goal > 0.0 else 0

    def step_carried(self, factor: float, is_stopping: int) -> int:
        """Spend the rest of a tick in the segment just begun; return 1 if that ended, too."""
        self.replan(self.highest_speed(factor, is_stopping))
        return self.advance()

    def highest_speed(self, factor: float, is_stopping: int) -> float:
        """Speed limit on the current segment in this tick."""
        self.factor = factor
        if is_stopping:
            return 0.0
        return min(
            self.history_rows[self.row + rows.SPEED] * factor,
            self.history_rows[self.row + rows.MAX_SPEED],
        )

    def replan(self, limit_v: float) -> None:
        """Plan the rest of the stage from the present speed."""
        self.limit_v = limit_v
        self.planned_factor = self.common_factor
        self.plan_d = self.covered_d
        self.ticks = 0
        if self.history_rows[self.row + rows.JERK] > 0.0:
            self.jerk_profile.plan(
                self.history_rows,
                self.row,
                self.stage_end_d - self.covered_d,
                self.speed_v,
                limit_v,
                self.factor_ahead(
                    self.history_rows[self.row + rows.GOAL_KIND] == rows.EXEMPT_FEED_GOAL
                ),
                self.is_single and self.stops_in_single_block(limit_v),
            )
            return
        rest_d = self.stage_end_d - self.covered_d
        if self.pieces > 0:
            remaining_v = self.remaining_speed() if self.is_single else -1.0
            ahead = self.factor_ahead(
                self.history_rows[self.row + rows.NEXT_IGNORES_OVERRIDE] > 0.0
            )
            self.arc.look_ahead(self.stage, rest_d, self.speed_v, self.factor, ahead, remaining_v)
            self.arc.plan(self.stage, rest_d, self.speed_v, limit_v)
            return
        limit_a = geometry.stage_acceleration(self.history_rows, self.row, self.stage)
        end_v = self.end_speed(rest_d, limit_a)
        if self.stage == codes.CURVE:
            limit_v = min(limit_v, self.history_rows[self.row + rows.CURVE_SPEED])
        self.profile.plan(rest_d, self.speed_v, end_v, limit_v, limit_a)

    def advance_with_jerk(self) -> int:
        """Advance to the end of this tick with limited jerk, as ``advance``."""
        now_t = self.offset_t + self.ticks * self.cycle_time_us / 1e6
        is_over = self.jerk_profile.advance(now_t)
        self.speed_v = self.jerk_profile.speed_v
        if is_over == 0:
            self.covered_d = self.plan_d + self.jerk_profile.distance_d
            self.move_axes()
            return 0
        self.left_t = self.jerk_profile.left_t
        self.covered_d = self.stage_end_d
        return self.finish()

    def end_speed(self, rest_d: float, limit_a: float) -> float:
        """Highest speed at the end of the stage, ``rest_d`` mm ahead."""
        end_v = self.block_end_speed(rest_d, limit_a)
        if geometry.total_length(self.history_rows, self.row) > self.stage_end_d:
            limit_v = self.history_rows[self.row + rows.MAX_SPEED]
            return geometry.entry_speed(self.history_rows, self.row, self.stage + 1, end_v, limit_v)
        feed_v = self.history_rows[self.row + rows.NEXT_SPEED]
        feed_v *= self.factor_ahead(self.history_rows[self.row + rows.NEXT_IGNORES_OVERRIDE] > 0.0)
        if 0.0 < feed_v < end_v:
            min_v2 = self.speed_v * self.speed_v - 2.0 * limit_a * rest_d
            end_v = min(end_v, max(feed_v, arithmetic.square_root(max(min_v2, 0.0))))
        return end_v

    def factor_ahead(self, ignores_override: int) -> float:
        """Override factor of a segment ahead, which may ignore the operator's part (G166).

        The effect of a spindle on its feed is taken from the current segment.
        """
        if ignores_override == (self.history_rows[self.row + rows.IGNORES_OVERRIDE] > 0.0):
            return self.factor
        return self.unoverridden_factor if ignores_override else self.common_factor

    def block_end_speed(self, rest_d: float, limit_a: float) -> float:
        """Highest speed at the segment's end; in single block a standstill, if it is possible.

        Where the next segment continues the block it is a speed that reaches 0 at the block's end.
        The prepared speed is for an override of 100 %. With less, the next segment begins at its
        own lower speed, as far as braking at the limit allows; with more, the prepared speed grows
        as far as the axes allow.
        """
        end_v = self.history_rows[self.row + rows.END_SPEED]
        if self.factor > 1.0:
            max_end_v = self.history_rows[self.row + rows.MAX_END_SPEED]
            end_v = max(end_v, min(end_v * self.factor, max_end_v))
        if self.is_single:
            remaining_v = self.remaining_speed()
            stop_v = geometry.entry_speed(
                self.history_rows, self.row, self.stage + 1, remaining_v, 1e300
            )
            brake2 = self.speed_v * self.speed_v - stop_v * stop_v
            if brake2 <= 2.0 * limit_a * rest_d * 1.000001:
                end_v = min(end_v, remaining_v)
        return end_v

    def stops_in_single_block(self, limit_v: float) -> int:
        """Return whether single block stops at the segment's end with limited jerk.

        If the block continues, it does so only if it could not stop at the block's end.
        """
        if self.history_rows[self.row + rows.CONTINUES] == 0.0:
            return 1
        rest_d = self.history_rows[self.row + rows.REMAINING_LENGTH]
        speed_v = max(limit_v, self.speed_v)
        limit_a = self.history_rows[self.row + rows.CARRIED_ACCELERATION]
        limit_j = self.history_rows[self.row + rows.CARRIED_JERK]
        if self.history_rows[self.row + rows.ROUNDING_LENGTH] > 0.0:
            speed_v = min(speed_v, self.history_rows[self.row + rows.GOAL_SPEED])
            limit_a = self.history_rows[self.row + rows.ROUNDING_ACCELERATION]
            limit_j = self.history_rows[self.row + rows.ROUNDING_JERK]
        need_d = self.jerk_profile.course.stopping_d(speed_v, 0.0, limit_a, limit_j)
        return 1 if rest_d < need_d else 0

    def advance(self) -> int:
        """Advance to the end of this tick; return 1 if the segment ended before."""
        if self.history_rows[self.row + rows.JERK] > 0.0:
            return self.advance_with_jerk()
        while True:
            now_t = self.offset_t + self.ticks * self.cycle_time_us / 1e6
            over_t = now_t - self.profile.duration_t
            if self.profile.is_endless or over_t < -1e-6 * self.cycle_time_t:
                self.covered_d = self.plan_d + self.profile.position(now_t)
                self.speed_v = self.profile.speed(now_t)
                self.move_axes()
                return 0
            self.speed_v = self.profile.end_v
            self.covered_d = self.stage_end_d
            self.left_t = max(over_t, 0.0)
            if not self.next_stage():
                break
            self.offset_t = self.left_t
            self.replan(self.limit_v)
        return self.finish()

    def finish(self) -> int:
        """Put the axes exactly to the segment's end; return 1 if the path moves on.

        A path that still moves continues even if no time is left: commands between the blocks may
        have to wait, and must not stop the path in a step (MO-1).
        """
        self.is_active = False
        if not self.is_retracing:
            self.life.count(self.covered_d)
        self.put_axes(geometry.end_column(self.history_rows, self.row, self.count))
        self.release()
        if self.history_rows[self.row + rows.EXACT_STOP] > 0.0:
            return 0
        return 1 if self.left_t > 0.0 or self.speed_v > 0.0 else 0

    def move_axes(self) -> None:
        """Put the axes to their positions after ``covered_d`` mm."""
        self.axes.has_moved = True
        if not self.is_retracing:
            self.life.count(self.covered_d)
        geometry.locate(self.history_rows, self.row, self.count, self.covered_d, self.positions)
        if self.history_rows[self.row + rows.TRANSFORMATION] > 0.0:
            self.put_transformed(self.positions)
            return
        for k in range(self.moved_count):
            i = self.moved[k]
            self.axes.command[self.members[i]] = self.positions[i]

    def abandon(self) -> None:
        """Drop the rest of the segment where the axes are, to be read at once (reset)."""
        self.is_active = False
        self.is_retracing = False
        self.direction = 1
        self.history_rows[self.front + rows.CONTINUES] = 0.0  # the block is over with all pieces
        self.forget()
        self.speed_v = 0.0
        self.jerk_profile.acceleration_a = 0.0
        self.release()
        self.show_standstill()
        for i in range(self.count):
            axis = self.members[i]
            self.axes.target[axis] = self.axes.command[axis]
        self.axes.has_moved = True
        self.axes.publish()

    def is_at_rest(self) -> int:
        """Return whether nothing moves on the path."""
        return 1 if self.speed_v == 0.0 and (not self.is_active or self.limit_v == 0.0) else 0

    def has_stopped(self) -> bool:
        """Return whether nothing moves on the path."""
        return bool(self.is_at_rest())

    def distance_to_go(self) -> float:
        """Remaining length of the current segment and its rounding, in mm."""
        if not self.is_active or self.is_dwell:
            return 0.0
        if self.direction < 0:
            return self.covered_d
        return geometry.length_with_rounding(self.history_rows, self.row) - self.covered_d

    def promised_speed(self, column: int) -> float:
        """End speed in ``column`` of the newest segment; 0 for a dwell, or if it is over."""
        if self.history_rows[self.front + rows.KIND] == rows.DWELL or (
            self.is_retracing and self.is_front_over
        ):
            return 0.0
        return self.history_rows[self.front + column]

    def block_number(self) -> float:
        """N number of the current block."""
        return self.history_rows[self.row + rows.BLOCK_NUMBER]

    def is_rapid(self) -> int:
        """Return whether the current block is a rapid motion."""
        motion = self.history_rows[self.row + rows.MOTION]
        return 1 if not self.is_dwell and motion == rows.RAPID_MOTION else 0

    def segment_row(self, back: int) -> list[float]:
        """Row ``back`` segments before the newest; raise ``ValueError`` where none is kept."""
        check_index(back, min(self.used, self.ring_size), "segment")
        row = (self.used - 1 - back) % self.ring_size * self.width
        return [self.history_rows[row + i] for i in range(self.width)]

    def current_segment(self) -> list[float]:
        """Return the row of the current segment, or of the latest one between two segments."""
        return [self.history_rows[self.row + i] for i in range(self.width)]

    def planned(self) -> tuple[float, float, int]:
        """Return the speed limit of this tick, the override factor in it, and the stage."""
        return (self.limit_v, self.factor, self.stage)

    def covered_length(self) -> float:
        """Length covered of the current segment, in mm."""
        return self.covered_d

    def braking_distance(self) -> float:
        """Distance in mm that braking from now on takes on the current segment."""
        acceleration = self.history_rows[self.row + rows.ACCELERATION]
        length = 0.5 * self.speed_v * self.speed_v / acceleration
        if self.history_rows[self.row + rows.JERK] > 0.0:
            length += self.speed_v * acceleration / self.history_rows[self.row + rows.JERK]
        return length

    def covered_part(self) -> float:
        """Covered share of the current segment's length, from 0 to 1."""
        if not self.is_active or self.is_dwell:
            return 1.0
        return self.covered_d / geometry.total_length(self.history_rows, self.row)

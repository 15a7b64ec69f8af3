# SPDX-License-Identifier: MIT
"""Backward motion on the path: over the segments that the path has kept, and forward again (MO-7).

Backward is commanded: the path brakes to a standstill, then walks back on the same curve, with the
feeds and limits of the blocks, until backward is taken away or the history ends. Forward it walks
over the same segments to its *front*, where it turned, and continues. Nothing but motion happens
meanwhile: no command is taken, dwells are passed over.

Stages (``geometry.py``) and corners are passed with the speeds of forward motion; where the path
had stopped it stops again. Under a jerk limit it walks stretches (``history.py``), stop to stop.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.record import Record
from nctakt.kernel.path import geometry
from nctakt.kernel.path.history import History
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.override import Overrides
from nctakt.kernel.path.path import Path
from nctakt.kernel.path.trapezoid_profile import TrapezoidProfile
from nctakt.kernel.plc.panel import Panel


class BackwardMotion(History):
    """Backward motion of one channel's path over its history.

    ``fault`` is the number of the message that stops the channel, because something else has moved
    an axis while the path was away (MO-13); ``Path.refused_axis`` is the axis, ``fault_source`` the
    block. ``is_blocked``: the walk has come to the start of the history, or to such a block.
    ``entered``: the N number of the block that the walk has come to within this tick, else -1.
    """

    def __init__(
        self, path: Path, panel: Panel, record: Record, ahead: LookAhead, overrides: Overrides
    ) -> None:
        super().__init__(path, ahead)
        self.overrides = overrides
        self.panel = panel
        self.record = record
        self.profile = TrapezoidProfile()
        self.stage = 0
        self.stage_d = 0.0
        self.plan_d = 0.0
        self.offset_t = 0.0
        self.ticks = 0
        self.factor = 1.0
        self.is_single = False
        self.is_blocked = False
        self.was_paused = False
        self.was_released = False
        self.fault = 0
        self.fault_source = 0
        self.has_failed = False
        self.entered = -1.0

    def can_take_over(self) -> int:
        """Return whether the path, stopped by backward motion, is at rest and can go back."""
        return 1 if self.path.speed_v == 0.0 and self.can_go_back() else 0

    def can_go_back(self) -> int:
        """Return whether there is a path before the present position."""
        number = self.path.used
        if self.path.is_active:
            if not self.path.is_dwell and self.path.covered_d > 0.0:
                return 1
            number -= 1
        return 1 if self.neighbour(number, -1) >= self.path.oldest else 0

    def state(self) -> int:
        """State of the walk over the history: ``codes.AT_FRONT`` …"""
        if not self.path.is_retracing:
            return codes.AT_FRONT
        return codes.WALKS_BACKWARD if self.path.direction < 0 else codes.WALKS_FORWARD

    def step(self, factor: float, is_stopping: int) -> int:
        """Advance a tick; return 1 if the path is at its front again with time left.

        As ``Path.step``; the path is away.
        """
        self.entered = -1.0
        direction = -1 if self.panel.backward_motion else 1
        if self.path.direction != direction and self.path.speed_v == 0.0:
            self.turn(direction)
            if self.path.is_active:
                self.entered = self.path.block_number()
            if not self.path.is_retracing:
                return self.path.step(factor, is_stopping)
        if self.is_blocked:
            self.path.limit_v = 0.0
            return 0
        halts = is_stopping or self.path.direction != direction or self.panel.is_paused
        limit_v = 0.0 if halts else self.feed_speed(self.path.row, 0)
        is_changed = factor != self.factor or self.path.is_single != self.is_single
        if self.note_foreign():
            is_changed = True
            if self.path.history_rows[self.path.row + rows.JERK] > 0.0:
                self.survey(0)
        if limit_v != self.path.limit_v or is_changed:
            self.factor = factor
            self.is_single = self.path.is_single
            self.offset_t = 0.0
            self.replan(limit_v)
        self.ticks += 1
        return self.advance(is_stopping)

    # --- begin, turn, end -----------------------------------------------------------------------

    def leave(self) -> None:
        """Leave the front and go back from here; the path is at rest."""
        self.path.is_retracing = True
        self.path.is_front_over = not self.path.is_active
        self.has_failed = False
        self.was_paused = self.panel.is_paused
        self.was_released = self.panel.is_released
        self.panel.is_paused = False
        self.front_number = self.path.used if self.path.is_front_over else self.path.used - 1
        self.number, self.front_map = self.front_number, self.path.shown_map()
        for i in range(self.path.count):
            axis = self.path.members[i]
            self.foreign[i] = (
                not self.path.axes.on_path[axis]
                and self.path.axes.command[axis] != self.path.ends[i]
            )
        if self.path.is_front_over or self.path.is_dwell:
            self.path.show_standstill()
            self.path.covered_d = 0.0
        self.path.is_active = True
        self.path.is_dwell = False
        self.go(-1)

    def turn(self, direction: int) -> None:
        """Continue in ``direction``; the path is at rest."""
        if direction > 0 and self.number == self.front_number:
            self.return_to_front(self.path.covered_d)
        else:
            self.go(direction)

    def go(self, direction: int) -> None:
        """Begin to walk in ``direction``, from rest."""
        self.path.direction = direction
        self.path.speed_v = 0.0
        self.path.jerk_profile.acceleration_a = 0.0
        self.path.limit_v = -1.0
        self.is_blocked = False
        source = int(self.path.history_rows[self.path.row + rows.SOURCE])
        phase = rows.RETRACE_BACKWARD if direction < 0 else rows.RETRACE_FORWARD
        self.record.event(rows.EVENT_RETRACED, source, phase)
        if self.path.covered_d > 0.0 or direction > 0:
            self.path.claim_again()
            if self.enter_stage():
                return
        self.cross()

    def return_to_front(self, covered_d: float) -> None:
        """Return to forward motion where the path has turned."""
        self.panel.is_paused = self.was_paused
        self.panel.is_released = self.was_released
        source = int(self.path.history_rows[self.path.front + rows.SOURCE])
        self.record.event(rows.EVENT_RETRACED, source, rows.RETRACE_FRONT)
        self.path.release()
        self.path.show_map(self.front_map)
        self.path.show_standstill()
        self.path.is_active = not self.path.is_front_over
        if self.path.is_active:
            self.path.return_to_newest(covered_d)
        else:
            self.path.is_retracing = False
            self.path.direction = 1

    # --- the speeds -----------------------------------------------------------------------------

    def feed_speed(self, row: int, ignores_feed: int) -> float:
        """Speed limit of a segment under override; with ``ignores_feed`` that of the axes alone."""
        speed = self.path.history_rows[row + rows.MAX_SPEED]
        if geometry.pieces(self.path.history_rows, row) > 0:
            speed = self.path.history_rows[row + rows.BACKWARD_SPEED]
        if ignores_feed:
            return speed
        factor = self.overrides.factor(self.path.history_rows, row)
        return min(self.path.history_rows[row + rows.SPEED] * factor, speed)

    def stage_speed(self, row: int, stage: int, ignores_feed: int) -> float:
        """Speed limit of a stage: its segment's, on a curve the curve's as well."""
        speed = self.feed_speed(row, ignores_feed)
        if stage == codes.CURVE:
            speed = min(speed, self.path.history_rows[row + rows.CURVE_SPEED])
        return speed

    def corner_speed(self, number: int, other: int, ignores_feed: int) -> float:
        """Highest speed from segment ``number`` into its neighbour or into the front, per s."""
        if other < self.path.oldest or (self.path.is_single and not ignores_feed):
            return 0.0
        first = self.path.row_of(number if self.path.direction > 0 else other)
        if self.path.history_rows[first + rows.JERK] > 0.0:
            return 0.0
        if other == self.front_number:
            return min(
                self.front_speed(ignores_feed), self.path.history_rows[first + rows.CORNER_SPEED]
            )
        second = self.path.row_of(other if self.path.direction > 0 else number)
        if self.path.history_rows[second + rows.JERK] > 0.0 or self.is_shut(
            self.path.row_of(other)
        ):
            return 0.0
        return self.path.history_rows[first + rows.CORNER_SPEED]

    def front_speed(self, ignores_feed: int) -> float:
        """Highest speed into the segment at the front; 0 if it is over or a dwell."""
        row = self.path.front
        if (
            self.path.is_front_over
            or self.path.history_rows[row + rows.KIND] == rows.DWELL
            or self.path.history_rows[row + rows.JERK] > 0.0
        ):
            return 0.0
        end_v = self.path.history_rows[row + rows.END_SPEED]
        limit_v = self.feed_speed(row, ignores_feed)
        return geometry.entry_speed(self.path.history_rows, row, codes.ENTRY_ZONE, end_v, limit_v)

    def border_speed(self, ignores_feed: int) -> float:
        """Highest speed at the end of the stage that keeps all that follows.

        Each border ahead may be passed at its own highest speed, plus what can be braked before it.
        The search ends where no border can require less.
        """
        number = self.number
        stage = self.stage
        row = self.path.row
        max_v2 = 1e300
        gained2 = 0.0
        while True:
            speed = self.stage_speed(row, stage, ignores_feed)
            stage = self.next_stage(row, stage)
            if stage < 0:
                other = self.neighbour(number, self.path.direction)
                speed = min(speed, self.corner_speed(number, other, ignores_feed))
                if speed == 0.0 or other == self.front_number:
                    return arithmetic.square_root(min(max_v2, speed * speed + gained2))
                number = other
                row = self.path.row_of(number)
                stage = self.first_stage(row)
            speed = min(speed, self.stage_speed(row, stage, ignores_feed))
            max_v2 = min(max_v2, speed * speed + gained2)
            if gained2 >= max_v2:
                return arithmetic.square_root(max_v2)
            limit_a = geometry.stage_acceleration(self.path.history_rows, row, stage)
            d = geometry.stage_length(self.path.history_rows, row, stage)
            gained2 += 2.0 * limit_a * d

    def end_speed(self, rest_d: float, limit_a: float) -> float:
        """Speed at the end of the stage: the override's, as far as braking reaches it."""
        end_v = self.border_speed(1)
        feed_v = self.border_speed(0)
        speed2 = self.path.speed_v * self.path.speed_v
        min_v2 = speed2 - 2.0 * limit_a * rest_d
        if min_v2 > end_v * end_v + 1e-6 * speed2 + 1e-4:  # a block that was shut too late
            return arithmetic.square_root(min_v2)
        if feed_v < end_v:
            end_v = min(end_v, max(feed_v, arithmetic.square_root(max(min_v2, 0.0))))
        return end_v

    def replan(self, limit_v: float) -> None:
        """Plan the rest of the stage from the present speed."""
        self.path.limit_v = limit_v
        self.plan_d = self.path.covered_d
        self.ticks = 0
        rest_d = (self.stage_d - self.path.covered_d) * self.path.direction
        if self.path.history_rows[self.path.row + rows.JERK] > 0.0:
            speed_v, is_single = self.path.speed_v, self.path.is_single
            self.path.jerk_profile.plan(
                self.goal_row, 0, rest_d, speed_v, limit_v, self.factor, is_single
            )
            return
        limit_a = geometry.stage_acceleration(self.path.history_rows, self.path.row, self.stage)
        limit_v = min(limit_v, self.stage_speed(self.path.row, self.stage, 0))
        end_v = self.end_speed(rest_d, limit_a)
        self.profile.plan(rest_d, self.path.speed_v, end_v, limit_v, limit_a)

    # --- stages and segments
    # --------------------------------------------------------------------------------

    def first_stage(self, row: int) -> int:
        """First stage of a segment in the direction of the walk."""
        is_backward = self.path.direction < 0
        return self.next_stage(row, codes.AFTER_STAGES if is_backward else codes.BEFORE_STAGES)

    def next_stage(self, row: int, stage: int) -> int:
        """Next stage with a length in the walk's direction; ``BEFORE_STAGES`` without one.

        With a limit of the jerk a segment has one stage.
        """
        is_inside = codes.ENTRY_ZONE <= stage <= codes.CURVE
        if self.path.history_rows[row + rows.JERK] > 0.0:
            return codes.BEFORE_STAGES if is_inside else codes.MIDDLE
        stage += self.path.direction
        while codes.ENTRY_ZONE <= stage <= codes.CURVE:
            if geometry.stage_length(self.path.history_rows, row, stage) > 0.0:
                return stage
            stage += self.path.direction
        return codes.BEFORE_STAGES

    def enter_stage(self) -> int:
        """Settle the stage at the path's position; return 0 if none is left ahead."""
        if self.path.history_rows[self.path.row + rows.JERK] > 0.0:
            self.path.jerk_profile.begin()
            self.survey(1 if self.path.speed_v == 0.0 else 0)
        self.stage = self.first_stage(self.path.row)
        while self.stage >= 0:
            self.stage_d = self.border(self.stage)
            if (self.stage_d - self.path.covered_d) * self.path.direction > 0.0:
                return 1
            self.stage = self.next_stage(self.path.row, self.stage)
        return 0

    def border(self, stage: int) -> float:
        """Length from the segment's start to the end of a stage in the walk's direction."""
        if self.path.history_rows[self.path.row + rows.JERK] > 0.0:
            if self.path.direction < 0:
                return 0.0
            return geometry.total_length(self.path.history_rows, self.path.row)
        length = 0.0
        for i in range(stage):
            length += geometry.stage_length(self.path.history_rows, self.path.row, i)
        if self.path.direction > 0:
            length += geometry.stage_length(self.path.history_rows, self.path.row, stage)
        return length

    def length(self) -> float:
        """Length of all stages of the current segment, added up one by one."""
        if self.path.history_rows[self.path.row + rows.JERK] > 0.0:
            return geometry.total_length(self.path.history_rows, self.path.row)
        length = 0.0
        for i in range(codes.AFTER_STAGES):
            length += geometry.stage_length(self.path.history_rows, self.path.row, i)
        return length

    def cross(self) -> int:
        """Cross into the next segment; return 1 if the path continues without a stop.

        The position of the border is reached exactly to the bit, whatever the speed.
        """
        other = self.neighbour(self.number, self.path.direction)
        end = geometry.end_column(self.path.history_rows, self.path.row, self.path.count)
        self.path.put_axes(end if self.path.direction > 0 else self.path.row + rows.START)
        refusal = self.refusal_into(other)
        if refusal and (self.path.speed_v == 0.0 or other < self.path.oldest):
            self.stay(refusal)
            return 0
        if refusal:
            self.fail(refusal, other)
        self.number = other
        if other == self.front_number:
            self.return_to_front(0.0)
            if refusal:
                self.path.release()
                self.path.claim()
            return self.keeps_moving()
        self.path.release()
        self.path.show_standstill()
        self.path.row = self.path.row_of(other)
        end = geometry.end_column(self.path.history_rows, self.path.row, self.path.count)
        self.path.claim_free(self.path.row + rows.START if self.path.direction > 0 else end)
        self.path.covered_d = 0.0 if self.path.direction > 0 else self.length()
        self.enter_stage()
        return self.keeps_moving()

    def keeps_moving(self) -> int:
        """Return whether the path moves past a border in this tick or the next."""
        if not self.path.is_active or self.path.speed_v == 0.0:
            return 0
        if self.path.left_t > 0.0:
            self.entered = self.path.block_number()
        return 1

    def refusal_into(self, number: int) -> int:
        """Return why the walk must not enter a segment: 0 it may, -1 the history starts.

        Else the number of the message about ``refused_axis``, which something else has moved.
        """
        if number < self.path.oldest:
            return -1
        if number == self.front_number and (
            self.path.is_front_over
            or self.path.history_rows[self.path.front + rows.KIND] == rows.DWELL
        ):
            return 0
        row = self.path.row_of(number)
        if self.path.direction > 0:
            return self.path.refusal(row, self.path.history_rows)
        end = geometry.end_column(self.path.history_rows, row, self.path.count)
        self.path.map_to_axes(row, self.path.history_rows, end)
        for i in range(self.path.count):
            if self.path.moves_axis(self.path.history_rows, row, i):
                axis = self.path.members[i]
                self.path.refused_axis = axis
                if self.foreign[i] or self.path.axes.independent[axis]:
                    return 50766
                if not self.path.is_there(self.path.history_rows, row, end, i):
                    return 900420
        return 0

    def stay(self, refusal: int) -> None:
        """Stop where the walk cannot continue: backward at the start of the history."""
        self.is_blocked = True
        self.path.speed_v = 0.0
        source = int(self.path.history_rows[self.path.row + rows.SOURCE])
        if self.path.direction < 0:
            self.record.event(rows.EVENT_RETRACED, source, rows.RETRACE_START)
        else:
            other = self.neighbour(self.number, 1)
            self.fault = refusal
            self.fault_source = int(self.path.history_rows[self.path.row_of(other) + rows.SOURCE])

    def fail(self, refusal: int, number: int) -> None:
        """Brake on a segment that the walk must not enter (MO-1, MO-13).

        With the axes that are free, as the path does forward; the channel is in error state.
        """
        if not self.has_failed:
            self.has_failed = True
            self.fault = refusal
            self.fault_source = int(self.path.history_rows[self.path.row_of(number) + rows.SOURCE])

    def advance(self, is_stopping: int) -> int:
        """Advance to the end of this tick, as ``Path.advance``."""
        while True:
            now_t = self.offset_t + self.ticks * self.path.cycle_time_us / 1e6
            if not self.has_ended(now_t):
                return 0
            self.path.covered_d = self.stage_d
            self.offset_t = self.path.left_t
            self.stage = self.next_stage(self.path.row, self.stage)
            if self.stage >= 0:
                self.stage_d = self.border(self.stage)
            elif not self.cross():
                self.stop_between()
                return 0
            elif not self.path.is_retracing:
                self.path.offset_t = self.path.left_t
                self.factor = self.overrides.factor(self.path.history_rows, self.path.row)
                return self.path.step_carried(self.factor, is_stopping or self.fault != 0)
            elif self.fault != 0:
                self.path.limit_v = 0.0
            elif self.path.limit_v > 0.0:
                self.factor = self.overrides.factor(self.path.history_rows, self.path.row)
                self.path.limit_v = self.feed_speed(self.path.row, 0)
            self.replan(self.path.limit_v)

    def stop_between(self) -> None:
        """Stop between two segments: single block pauses there."""
        if self.path.is_retracing and not self.is_blocked:
            self.path.limit_v = -1.0
            if self.path.is_single and not self.is_inside():
                self.panel.is_paused = True
                source = int(self.path.history_rows[self.path.row + rows.SOURCE])
                self.record.event(rows.EVENT_PAUSED, source)

    def is_inside(self) -> int:
        """Return whether the segment just entered is inside of a block for the walk."""
        first = self.number - 1 if self.path.direction > 0 else self.number
        return 1 if self.path.history_rows[self.path.row_of(first) + rows.CONTINUES] > 0.0 else 0

    def has_ended(self, now_t: float) -> int:
        """Return whether the stage has ended by then; else follow the plan."""
        if self.path.history_rows[self.path.row + rows.JERK] > 0.0:
            return self.has_ended_with_jerk(now_t)
        over_t = now_t - self.profile.duration_t
        if self.profile.is_endless or over_t < -1e-6 * self.path.cycle_time_t:
            self.path.speed_v = self.profile.speed(now_t)
            self.follow(self.profile.position(now_t))
            return 0
        self.path.left_t = max(over_t, 0.0)
        self.path.speed_v = self.profile.end_v
        self.path.jerk_profile.acceleration_a = 0.0
        return 1

    def has_ended_with_jerk(self, now_t: float) -> int:
        """``has_ended`` with limited jerk: the walk has stopped at its stretch's end."""
        is_over = self.path.jerk_profile.advance(now_t)
        self.path.speed_v = self.path.jerk_profile.speed_v
        if is_over == 0:
            self.follow(self.path.jerk_profile.distance_d)
            return 0
        self.path.left_t = self.path.jerk_profile.left_t
        if self.number == self.stretch_end:
            self.path.speed_v = 0.0
        if self.path.speed_v == 0.0:
            self.path.jerk_profile.acceleration_a = 0.0
        return 1

    def follow(self, distance: float) -> None:
        """Put the axes to the plan's position, ``distance`` from the plan's start."""
        covered_d = self.plan_d + distance * self.path.direction
        rest_d = (self.stage_d - covered_d) * self.path.direction
        self.path.covered_d = covered_d if rest_d > 0.0 else self.stage_d
        self.path.move_axes()

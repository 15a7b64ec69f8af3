# SPDX-License-Identifier: MIT
"""Threads: the path follows the angle of a spindle, or a spindle the path (G33, G63, G331, G332).

Cutting: where the path has its speed, its length is (angle - start angle) / degrees for each mm, to
the last bits, whatever the spindle does; so passes repeat at any speed. The path begins earlier by
the time that its acceleration loses, within a tick, and so is on that line from then on. A block
that continues into the next thread keeps the angle. The override, feed hold, single block and
backward motion wait for the end of the threads; while they last the spindle changes its speed only
as the axes can follow it. Tapping: the spindle has the angle that belongs to the length, in each
tick, so override, hold and backward motion act on both.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.axes import spindles
from nctakt.kernel.base import arithmetic
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.path import geometry
from nctakt.kernel.path.path import Path


class Threads:
    """The threads of one channel's path; ``state``: ``codes.WITHOUT_THREAD`` ….

    ``is_cutting``: the path follows a spindle. ``angle``: of the spindle, with all its revolutions,
    at the start of the block; ``turn``: degrees for each mm, negative backward. ``fault``: number
    of the message for the fault that broke the thread at ``source``, 0 for none.
    """

    def __init__(self, path: Path, context: Context) -> None:
        self.path = path
        self.context = context
        self.spindles = context.spindles
        self.state = codes.WITHOUT_THREAD
        self.is_cutting = False
        self.was_cut = False
        self.spindle = 0
        self.angle = 0.0
        self.turn = 0.0
        self.length_d = 0.0
        self.delay_t = -1.0
        self.source = 0
        self.fault = 0

    # --- the begin ------------------------------------------------------------------------------

    def may_begin(self, segments: memoryview[float], row: int) -> int:
        """Return whether the thread at ``row`` may begin in this tick, or has to wait."""
        self.fault = 0
        self.source = int(segments[row + rows.SOURCE])
        spindle = int(segments[row + rows.FEED_SPINDLE])
        spindle -= 1
        self.spindle = spindle
        if segments[row + rows.THREAD] == rows.CUTTING:
            return self.is_due(segments, row, spindle)
        if self.spindles.is_resting(spindle):
            return 1
        if self.spindles.is_endless(spindle):
            self.fault = 901508
        return 0

    def is_due(self, segments: memoryview[float], row: int, spindle: int) -> int:
        """Return whether the spindle comes to the angle in this tick at which the path starts."""
        if self.spindles.is_resting(spindle):
            self.fault = 50499
        if not self.spindles.is_at_speed(spindle):
            return 0
        spindle_v = self.spindles.speed_v[spindle]
        sign = 1.0 if spindle_v > 0.0 else -1.0
        path_v = sign * spindle_v / segments[row + rows.THREAD_TURN]
        if path_v > segments[row + rows.MAX_SPEED] * 1.000000001:
            self.fault = 901509
        elif path_v * self.path.cycle_time_t < 1e-7:
            self.fault = 50206
        lead = spindle_v * self.lead_t(segments, row, path_v)
        begin = segments[row + rows.THREAD_ANGLE] - lead
        missing = spindles.wrapped(sign * (begin - self.spindles.position[spindle]))
        self.delay_t = missing / (sign * spindle_v)
        if self.fault or self.delay_t >= self.path.cycle_time_t:
            return 0
        angle = self.spindles.turned_by(spindle, self.context.tick - 1) + sign * missing + lead
        offset = segments[row + rows.THREAD_ANGLE]
        self.angle = offset + 360.0 * arithmetic.round_half_even((angle - offset) / 360.0)
        self.turn = sign * segments[row + rows.THREAD_TURN]
        return 1

    def lead_t(self, segments: memoryview[float], row: int, path_v: float) -> float:
        """Time that the acceleration to ``path_v`` loses, in s: half of what it lasts."""
        limit_a = segments[row + rows.ACCELERATION]
        limit_j = segments[row + rows.JERK]
        if limit_j == 0.0:
            return 0.5 * path_v / limit_a
        if path_v * limit_j < limit_a * limit_a:
            return arithmetic.square_root(path_v / limit_j)
        return 0.5 * (path_v / limit_a + limit_a / limit_j)

    def begin(self) -> None:
        """Begin the thread that the path has just taken."""
        row = self.path.row
        self.spindle = int(self.path.history_rows[row + rows.FEED_SPINDLE])
        self.spindle -= 1
        if self.path.history_rows[row + rows.THREAD] == rows.TAPPING:
            self.state = codes.WITH_TAP
            angle = self.spindles.position[self.spindle]
            self.path.history_rows[row + rows.THREAD_ANGLE] = angle
            return
        self.state = codes.THREAD_ENTRY
        self.is_cutting = True
        self.was_cut = False
        self.measure()
        self.path.forget()

    def measure(self) -> None:
        """Note the current block's demand on the spindle."""
        row = self.path.row
        turn = self.path.history_rows[row + rows.THREAD_TURN]
        self.turn = turn if self.turn > 0.0 else 0.0 - turn
        self.length_d = geometry.total_length(self.path.history_rows, row)
        self.spindles.limits.bind(
            self.spindle,
            self.path.history_rows[row + rows.MAX_SPEED] * turn,
            self.path.history_rows[row + rows.ACCELERATION] * turn,
            self.path.history_rows[row + rows.JERK] * turn,
        )

    def chain(self) -> None:
        """Continue into the thread that the path has just entered, at the angle there."""
        row = self.path.row
        self.source = int(self.path.history_rows[row + rows.SOURCE])
        if self.state == codes.WITH_TAP:
            self.path.history_rows[row + rows.THREAD_ANGLE] = self.angle
            return
        self.angle += self.turn * self.length_d
        before_v = self.spindles.speed_v[self.spindle] / self.turn
        self.measure()
        self.path.forget()
        after_v = self.spindles.speed_v[self.spindle] / self.turn
        step_v = after_v - before_v if after_v > before_v else before_v - after_v
        if (
            step_v > self.path.history_rows[row + rows.ACCELERATION] * self.path.cycle_time_t
            or self.path.speed_v < before_v * 0.999999999
        ):
            self.fault = 51103
        self.state = codes.THREAD_ENTRY

    # --- the tick -------------------------------------------------------------------------------

    def step(self, factor: float, is_stopping: int) -> int:
        """Advance a path that cuts a thread by a tick, as ``Path.step``."""
        if self.delay_t >= 0.0:
            self.path.offset_t = 0.0 - self.delay_t
            self.path.replan(self.path.highest_speed(factor, is_stopping))
            self.delay_t = -1.0
        if is_stopping:
            self.state = codes.THREAD_EXIT
            return self.path.step(factor, is_stopping)
        if self.state == codes.THREAD_ENTRY and self.has_speed():
            self.lock()
        if self.state == codes.THREAD_CUT and self.follow_spindle():
            return 0
        return self.path.step(factor, is_stopping)

    def has_speed(self) -> int:
        """Return whether the acceleration is over."""
        if self.path.speed_v < self.path.limit_v or self.path.speed_v == 0.0:
            return 0
        if self.path.history_rows[self.path.row + rows.JERK] == 0.0:
            return 1
        return 1 if self.path.jerk_profile.acceleration_a == 0.0 else 0

    def lock(self) -> None:
        """Follow the angle from now on, where the path is on its line: to 1e-6 of the pitch."""
        tick = self.context.tick
        angle = self.spindles.turned_by(self.spindle, tick - 1)
        off_d = self.path.covered_d - (angle - self.angle) / self.turn
        size = self.turn if self.turn > 0.0 else 0.0 - self.turn
        allowed_d = 1e-6 * 360.0 / size
        if self.was_cut:
            limit_a = self.path.history_rows[self.path.row + rows.ACCELERATION]
            allowed_d += limit_a * self.path.cycle_time_t * self.path.cycle_time_t
        if off_d > allowed_d or off_d < 0.0 - allowed_d:
            self.fault = 51103 if self.was_cut else 901510
            self.state = codes.THREAD_EXIT
            return
        self.state = codes.THREAD_CUT
        self.was_cut = True

    def follow_spindle(self) -> int:
        """Put the path where the angle at the end of the tick says; return 0 to brake instead."""
        if self.spindles.mode[self.spindle] == codes.SPINDLE_STOPPED:
            angle = 360.0 * self.spindles.laps[self.spindle] + self.spindles.position[self.spindle]
            self.angle = angle - self.turn * self.path.covered_d
            self.path.speed_v = 0.0
            return 1
        angle = self.spindles.turned_by(self.spindle, self.context.tick)
        covered_d = (angle - self.angle) / self.turn
        path_v = self.spindles.plans.speed_v / self.turn
        if path_v < 0.0:
            self.fault = 901511
        need_d = self.braking_d(path_v) + path_v * self.path.cycle_time_t
        if self.fault or covered_d + need_d >= self.length_d:
            self.state = codes.THREAD_EXIT
            self.path.limit_v = -1.0
            return 0
        while self.path.stage_end_d <= covered_d and self.path.next_stage():
            pass
        self.path.covered_d = max(covered_d, self.path.covered_d)
        self.path.speed_v = path_v
        self.path.limit_v = -1.0
        self.path.move_axes()
        return 1

    def braking_d(self, path_v: float) -> float:
        """Distance in mm that braking from a speed takes."""
        row = self.path.row
        limit_a = self.path.history_rows[row + rows.ACCELERATION]
        limit_j = self.path.history_rows[row + rows.JERK]
        if limit_j == 0.0:
            return 0.5 * path_v * path_v / limit_a
        return path_v * self.lead_t(self.path.history_rows, row, path_v)

    # --- after the path's step ------------------------------------------------------------------

    def settle(self) -> None:
        """Turn a spindle that taps, or end the threads; warn of a thread that had no speed."""
        if not self.is_cutting:
            self.turn_spindle()
            return
        if self.path.is_active:
            return
        self.clear()
        if not self.was_cut:
            self.context.record.event(rows.EVENT_ERROR, self.source, 0, 901512)

    def turn_spindle(self) -> None:
        """Turn the spindle to the angle that belongs to the path's length."""
        row = self.path.row
        is_tap = (
            not self.path.is_dwell and self.path.history_rows[row + rows.THREAD] == rows.TAPPING
        )
        spindle = int(self.path.history_rows[row + rows.FEED_SPINDLE]) if is_tap else 0
        spindle -= 1
        if self.state == codes.WITH_TAP and spindle != self.spindle:
            self.leave_tap()
        if is_tap:
            self.spindle = spindle
            turn = self.path.history_rows[row + rows.THREAD_TURN]
            angle = self.path.history_rows[row + rows.THREAD_ANGLE] + turn * self.path.covered_d
            if self.spindles.mode[self.spindle] != codes.COUPLED and self.path.is_active:
                self.couple(self.path.history_rows[row + rows.THREAD_ANGLE], turn)
            if self.spindles.mode[self.spindle] == codes.COUPLED:
                spindle_v = turn * self.path.speed_v * self.path.direction
                self.spindles.follow(self.spindle, angle, spindle_v)
                self.turn = turn
                self.length_d = geometry.total_length(self.path.history_rows, row)
                self.angle = self.path.history_rows[row + rows.THREAD_ANGLE]
                self.angle += turn * self.length_d
        if not is_tap or not self.path.is_active:
            self.uncouple()

    def leave_tap(self) -> None:
        """Leave the spindle at the end of the tap where the path has left it within the tick."""
        if self.spindles.mode[self.spindle] == codes.COUPLED:
            angle = self.angle
            if self.path.direction < 0:
                angle -= self.turn * self.length_d
            self.spindles.follow(self.spindle, angle, 0.0)
        self.uncouple()

    def couple(self, angle: float, turn: float) -> None:
        """Couple a resting spindle, whose angle has to be that at an end of the block."""
        self.source = int(self.path.history_rows[self.path.row + rows.SOURCE])
        if not self.spindles.is_resting(self.spindle):
            self.fault = 901508
            return
        self.state = codes.WITH_TAP
        if self.path.direction < 0:
            angle += turn * geometry.total_length(self.path.history_rows, self.path.row)
        off = spindles.wrapped(angle - self.spindles.position[self.spindle] + 180.0) - 180.0
        if off > 1e-6 or off < -1e-6:
            self.fault = 901510
            return
        self.spindles.mode[self.spindle] = codes.COUPLED

    def uncouple(self) -> None:
        """Leave the spindle that tapped where it is."""
        if self.state == codes.WITH_TAP:
            if self.spindles.mode[self.spindle] == codes.COUPLED:
                self.spindles.uncouple(self.spindle)
            self.state = codes.WITHOUT_THREAD

    def is_at_rest_before(self, thread: float) -> int:
        """Return whether the path is at rest between a thread and the segment that follows.

        The next tick decides when it continues; ``thread``: that of the segment.
        """
        if self.path.speed_v > 0.0:
            return 0
        return 1 if thread != rows.NO_THREAD or self.state != codes.WITHOUT_THREAD else 0

    def take_fault(self) -> int:
        """Return the message number of the fault that broke the thread, once."""
        fault = self.fault
        self.fault = 0
        return fault

    def spindle_number(self) -> int:
        """Number of the spindle in the machine."""
        return self.spindles.first_number + self.spindle

    def clear(self) -> None:
        """End all threads: the spindle is independent again."""
        self.uncouple()
        if self.is_cutting:
            self.spindles.limits.bind(self.spindle, 0.0, 0.0, 0.0)
        self.is_cutting = False
        self.state = codes.WITHOUT_THREAD
        self.delay_t = -1.0

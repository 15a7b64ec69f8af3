# SPDX-License-Identifier: MIT
"""The spindles of one channel: endless, to a position, to a standstill; those that the PLC turns.

A job is taken in the command or cycle phase and acts in the same tick: the speed changes from its
present value, within acceleration and jerk of the axis list, and never jumps. A job is open until
its speed or position is reached; the next job takes its place. A spindle under the PLC
(P-CHAN-00069) is different: its job is handed over and open until the PLC has acknowledged it. A
spindle takes one job in a tick, and none while the PLC still has one (RC-404).

Units: degrees and seconds; ``_v`` degrees per second. Signals are revolutions per minute and
degrees from 0 to 360.
"""

from __future__ import annotations

import math

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.axes.cutting_speeds import CuttingSpeeds
from nctakt.kernel.axes.spindle_limits import SpindleLimits
from nctakt.kernel.axes.spindle_overrides import SpindleOverrides
from nctakt.kernel.axes.trajectory import Trajectories
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_cells, check_index, check_size
from nctakt.kernel.base.record import Record


class Spindles:
    """``count`` spindles, whose signals begin at ``first_cell``.

    ``first_number`` counts those of the channels before: events have the machine's numbers.
    """

    def __init__(
        self, memory: bytearray, first_cell: int, count: int, record: Record, cycle_time_us: int
    ) -> None:
        check_size(count, "number of spindles")
        check_cells(first_cell, cells.SPINDLE_CELLS * count, memory)
        size = max(1, count)
        self.cells = memoryview(memory).cast("d")
        self.first_cell = first_cell
        self.count = count
        self.first_number = 0
        self.record = record
        self.cycle_t = cycle_time_us * 1e-6
        self.plans = Trajectories(count)
        self.is_plc = integers(size)
        self.limits = SpindleLimits(count)
        self.overrides = SpindleOverrides(memory, first_cell, count)
        self.cutting = CuttingSpeeds(count)
        self.position = doubles(size)
        self.speed_v = doubles(size)
        self.acceleration = doubles(size)
        self.mode = integers(size)
        self.begin_position = doubles(size)
        self.begin_tick = integers(size)
        self.commanded_v = doubles(size)
        self.commanded_position = doubles(size)
        self.direction = integers(size)
        self.function = integers(size)
        self.is_open = integers(size)
        self.is_held = integers(size)
        self.owner = integers(size)
        self.source = integers(size)
        self.serial = integers(size)
        self.taken_tick = integers(size)
        self.has_no_axis = integers(size)
        self.axis = integers(size)
        self.plc_state = integers(size)
        self.done_tick = integers(size)
        self.job = integers(size)
        self.reached_v = doubles(size)
        self.laps = doubles(size)
        self.issued = 0
        self.version = 0
        self.active_count = 0
        for spindle in range(count):
            self.taken_tick[spindle] = -1
            self.axis[spindle] = -1

    def configure(
        self,
        spindle: int,
        *,
        plc: bool,
        speed: float,
        acceleration: float,
        jerk: float = 0.0,
        step: int = 0,
        override_pct: float = 100.0,
        axis: int = -1,
    ) -> None:
        """Set limits and gear step of a spindle, degrees and seconds; a PLC spindle has none.

        ``axis``: number in the machine of the axis that it turns.
        """
        check_index(spindle, self.count, "spindle")
        self.axis[spindle] = axis
        self.is_plc[spindle] = plc
        self.limits.configure(spindle, speed, acceleration, jerk, step)
        self.overrides.limit(spindle, override_pct)

    # --- jobs -----------------------------------------------------------------------------------

    def is_ready(self, spindle: int, tick: int) -> int:
        """Return whether the spindle takes a job in this tick (else 60331)."""
        if self.mode[spindle] == codes.COUPLED or self.taken_tick[spindle] == tick:
            return 0
        return 1 if self.plc_state[spindle] == codes.FREE else 0

    def command(
        self,
        spindle: int,
        function: int,
        speed_v: float,
        position: float,
        direction: int,
        owner: int,
        tick: int,
        ignores_override: int = 0,
    ) -> None:
        """Take a job: M ``function`` 3, 4, 5 or 19; ``direction`` 0 of 19: the shortest way."""
        self.taken_tick[spindle] = tick
        self.function[spindle] = function
        self.commanded_position[spindle] = position
        self.direction[spindle] = direction
        self.owner[spindle] = owner
        self.is_held[spindle] = 0
        self.is_open[spindle] = 1
        if self.is_plc[spindle]:
            self.commanded_v[spindle] = speed_v
            return
        if self.mode[spindle] == codes.SPINDLE_STOPPED:
            self.limits.take_over(spindle)
        self.overrides.begin(spindle, speed_v, ignores_override)
        self.commanded_v[spindle] = self.goal_v(spindle)
        self.plan(spindle, tick)

    def goal_v(self, spindle: int) -> float:
        """Return the speed of the present job with its override and within its limits."""
        speed_v = self.overrides.programmed_v[spindle]
        if not self.rests(spindle):
            speed_v *= self.overrides.factor(spindle)
        if self.function[spindle] != codes.SPINDLE_POSITION:
            speed_v = self.limits.endless_v(spindle, speed_v)
        speed_v = self.limits.bounded_v(spindle, speed_v)
        return 0.0 - speed_v if self.function[spindle] == codes.SPINDLE_BACKWARD else speed_v

    def rests(self, spindle: int) -> int:
        """Return whether an override of 0 % lets the present job wait, which stays open."""
        is_stop = self.function[spindle] == codes.SPINDLE_STOP
        return 1 if self.overrides.factor(spindle) == 0.0 and not is_stop else 0

    def follow_override(self, spindle: int, tick: int) -> None:
        """Continue the present job with another override."""
        goes_on = self.mode[spindle] != codes.SPINDLE_STOPPED
        goes_on = goes_on or self.is_open[spindle] != 0 or self.is_endless(spindle) != 0
        self.commanded_v[spindle] = self.goal_v(spindle)
        if self.function[spindle] != codes.SPINDLE_STOP and goes_on:
            self.plan(spindle, tick)

    def record_job(self, spindle: int, source: int, serial: int) -> None:
        """Record the job just taken; its end gets the same source."""
        self.source[spindle] = source
        self.serial[spindle] = serial
        number = self.first_number + spindle
        function = self.function[spindle]
        speed = math.fabs(self.commanded_v[spindle]) / 6.0
        self.record.event(rows.EVENT_SPINDLE, source, serial, number, function, speed)
        if self.function[spindle] == codes.SPINDLE_POSITION:
            position = self.commanded_position[spindle]
            self.record.event(rows.EVENT_SPINDLE_POSITION, source, serial, number, position)

    def hand_over(self, spindle: int, done_tick: int) -> None:
        """Hand the job just taken to the PLC; the default PLC is done in ``done_tick``."""
        if self.is_plc[spindle]:
            self.active_count += 1
            self.plc_state[spindle] = codes.WAITING
            self.issued = self.issued + 1 if self.issued < 2147483647 else 1
            self.job[spindle] = self.issued
            self.version += 1
            self.done_tick[spindle] = done_tick

    def plan(self, spindle: int, tick: int) -> None:
        """Plan from the present state of a spindle to the goal of its job."""
        if self.mode[spindle] == codes.SPINDLE_STOPPED:
            self.active_count += 1
        else:
            self.count_laps(spindle, tick)
        limit_a, limit_j = self.limits.bounded_a(spindle), self.limits.bounded_j(spindle)
        self.begin_position[spindle] = self.position[spindle]
        self.begin_tick[spindle] = tick
        waits = self.is_held[spindle] or self.rests(spindle)
        if self.function[spindle] == codes.SPINDLE_POSITION and not waits:
            self.mode[spindle] = codes.POSITIONING
            self.plans.plan_distance(
                spindle,
                self.remaining_angle(spindle),
                self.speed_v[spindle],
                self.acceleration[spindle],
                math.fabs(self.commanded_v[spindle]),
                limit_a,
                limit_j,
            )
            return
        self.mode[spindle] = codes.TURNING
        end_v = self.commanded_v[spindle]
        if self.function[spindle] == codes.SPINDLE_STOP or waits:
            end_v = 0.0
        self.plans.plan_speed(
            spindle, end_v, self.speed_v[spindle], self.acceleration[spindle], limit_a, limit_j
        )

    def remaining_angle(self, spindle: int) -> float:
        """Degrees to the position of a job: where braking ends, then on in the direction.

        Without a direction a spindle that turns keeps turning, one at rest takes the shorter
        way, forward where both are equal.
        """
        direction = self.direction[spindle]
        braking = self.plans.stopping_d(
            self.speed_v[spindle],
            self.acceleration[spindle],
            self.limits.acceleration_a[spindle],
            self.limits.jerk_j[spindle],
        )
        remaining = wrapped(self.commanded_position[spindle] - self.position[spindle] - braking)
        if direction == 0 and self.speed_v[spindle] != 0.0:
            direction = 1 if self.speed_v[spindle] > 0.0 else -1
        if direction < 0 and remaining > 0.0:
            remaining -= 360.0
        elif direction == 0 and remaining > 180.0:
            remaining -= 360.0
        return braking + remaining

    # --- threads --------------------------------------------------------------------------------

    def count_laps(self, spindle: int, tick: int) -> None:
        """Count the whole revolutions of the plan that ends with the tick before this one."""
        self.plans.evaluate(spindle, (tick - self.begin_tick[spindle]) * self.cycle_t)
        turned = self.begin_position[spindle] + self.plans.distance_d - self.position[spindle]
        self.laps[spindle] += arithmetic.round_half_even(turned / 360.0)

    def turned_by(self, spindle: int, tick: int) -> float:
        """Angle at the end of a tick with all revolutions, in degrees.

        ``plans.speed_v`` is the speed then.
        """
        self.plans.evaluate(spindle, (tick - self.begin_tick[spindle] + 1) * self.cycle_t)
        begin = 360.0 * self.laps[spindle] + self.begin_position[spindle]
        return begin + self.plans.distance_d

    def is_at_speed(self, spindle: int) -> int:
        """Return whether the spindle turns endlessly and has reached its commanded speed."""
        if self.mode[spindle] != codes.TURNING or self.is_open[spindle]:
            return 0
        return 1 if self.speed_v[spindle] == self.commanded_v[spindle] else 0

    def follow(self, spindle: int, angle: float, speed_v: float) -> None:
        """Couple a spindle with the path, and turn it to an angle, at a speed."""
        self.mode[spindle] = codes.COUPLED
        self.position[spindle] = wrapped(angle)
        self.speed_v[spindle] = speed_v
        self.publish(spindle)

    def uncouple(self, spindle: int) -> None:
        """Leave a coupled spindle to itself, where it is."""
        self.mode[spindle] = codes.SPINDLE_STOPPED
        self.speed_v[spindle] = 0.0
        self.acceleration[spindle] = 0.0
        self.publish(spindle)

    # --- its axis -------------------------------------------------------------------------------

    def give_axis(self, spindle: int) -> int:
        """Give the axis of a spindle away, which takes no job then; 0 if the spindle turns."""
        if not self.has_no_axis[spindle]:
            if not self.is_resting(spindle):
                return 0
            self.has_no_axis[spindle] = 1
            self.follow(spindle, self.position[spindle], 0.0)
        return 1

    def take_axis(self, spindle: int) -> None:
        """Let a spindle have its axis again."""
        if self.has_no_axis[spindle]:
            self.has_no_axis[spindle] = 0
            self.uncouple(spindle)

    def turn_to(self, spindle: int, angle: float) -> None:
        """Set the angle of a spindle at rest whose axis another spindle has turned."""
        if self.has_no_axis[spindle] or self.is_resting(spindle):
            self.position[spindle] = wrapped(angle)
            self.publish(spindle)

    def without_axis(self) -> list[int]:
        """Return the spindles that have given their axes away."""
        return [spindle for spindle in range(self.count) if self.has_no_axis[spindle]]

    # --- settings of the program ----------------------------------------------------------------

    def execute(self, queue: memoryview[float], row: int, kind: int) -> None:
        """Take the limits of a tool, or a constant cutting speed."""
        if kind == rows.SPINDLE_LIMITS:
            self.limits.execute(queue, row)
        else:
            self.cutting.execute(queue, row)

    def follow_axes(self, tick: int) -> None:
        """Give the spindles the speeds that their face axes ask for, except while at rapid."""
        if self.cells[self.cutting.rapid_cell] > 0.0:
            return
        for spindle in range(self.count):
            if self.turns_freely(spindle):
                limit_v, factor = self.limits.speed_v[spindle], self.overrides.factor(spindle)
                speed_v = self.cutting.speed(spindle, limit_v, factor)
                if speed_v < 0.0:
                    continue
                speed_v = min(self.limits.endless_v(spindle, speed_v), limit_v)
                if self.function[spindle] == codes.SPINDLE_BACKWARD:
                    speed_v = 0.0 - speed_v
                if speed_v != self.commanded_v[spindle]:
                    self.commanded_v[spindle] = speed_v
                    self.plan(spindle, tick)

    def turns_freely(self, spindle: int) -> int:
        """Return whether an endless job turns the spindle, and no thread is cut with it."""
        is_bound = self.is_held[spindle] or self.limits.bound_a[spindle] > 0.0
        if is_bound or self.rests(spindle) or self.mode[spindle] != codes.TURNING:
            return 0
        return 1 if self.function[spindle] != codes.SPINDLE_STOP else 0

    # --- the actions of realtime cycles ----------------------------------------------------------

    def open_count(self, owner: int) -> int:
        """Number of open jobs of a realtime cycle (P-CHAN-00480)."""
        count = 0
        for spindle in range(self.count):
            count += self.has_job(spindle, owner)
        return count

    def is_busy(self, spindle: int) -> int:
        """Return whether a job is open or waits for the PLC's acknowledgement."""
        return 1 if self.is_open[spindle] or self.plc_state[spindle] else 0

    def is_resting(self, spindle: int) -> int:
        """Return whether the spindle is at rest and no job on its way turns it."""
        if self.speed_v[spindle] != 0.0 or self.plc_state[spindle]:
            return 0
        return 1 if self.mode[spindle] == codes.SPINDLE_STOPPED else 0

    def has_plc(self, spindle: int) -> bool:
        """Return whether the PLC turns the spindle."""
        check_index(spindle, self.count, "spindle")
        return bool(self.is_plc[spindle])

    def has_job(self, spindle: int, owner: int) -> int:
        """Return whether the spindle has an open job of this cycle: the next one replaces it."""
        if self.owner[spindle] != owner:
            return 0
        return 1 if self.is_open[spindle] or self.is_endless(spindle) else 0

    def is_endless(self, spindle: int) -> int:
        """Return whether the latest job turns the spindle endlessly: it stays open (RC-408)."""
        if self.is_plc[spindle] or self.commanded_v[spindle] == 0.0:
            return 0
        return 1 if self.function[spindle] in (codes.SPINDLE_FORWARD, codes.SPINDLE_BACKWARD) else 0

    def hold(self, owner: int, tick: int) -> None:
        """Brake the spindles with open jobs of the cycle to a standstill; keep the jobs (HOLD)."""
        for spindle in range(self.count):
            if self.has_job(spindle, owner) and not self.is_plc[spindle]:
                self.is_held[spindle] = 1
                self.plan(spindle, tick)

    def resume(self, owner: int, tick: int) -> None:
        """Continue held jobs from the present speed (CONTINUE)."""
        for spindle in range(self.count):
            if self.is_held[spindle] and self.owner[spindle] == owner:
                self.is_held[spindle] = 0
                self.is_open[spindle] = 1
                self.plan(spindle, tick)

    def abort(self, owner: int, tick: int) -> None:
        """Brake the spindles of the cycle to a standstill and drop their jobs (ABORT ACTION)."""
        for spindle in range(self.count):
            if self.has_job(spindle, owner) and not self.is_plc[spindle]:
                self.is_held[spindle] = 0
                self.is_open[spindle] = 1
                self.function[spindle] = codes.SPINDLE_STOP
                self.plan(spindle, tick)

    def leave(self, owner: int) -> None:
        """Let the spindles of an ended cycle keep turning; held spindles stay at rest."""
        for spindle in range(self.count):
            if self.owner[spindle] == owner:
                self.owner[spindle] = 0
                if self.is_held[spindle]:
                    self.is_held[spindle] = 0
                    self.function[spindle] = codes.SPINDLE_STOP
                    if self.mode[spindle] == codes.SPINDLE_STOPPED:
                        self.is_open[spindle] = 0

    # --- the tick -------------------------------------------------------------------------------

    def latch(self) -> None:
        """Free the jobs that the PLC has acknowledged, at the start of a tick."""
        if self.active_count == 0:
            return
        for spindle in range(self.count):
            if self.plc_state[spindle] == codes.ACKNOWLEDGED:
                self.plc_state[spindle] = codes.FREE
                self.active_count -= 1
                self.version += 1
                self.reached_v[spindle] = self.plc_speed(spindle)
                self.finish(spindle)

    def plc_speed(self, spindle: int) -> float:
        """Speed of a PLC spindle after its job in degrees/s; negative under M4."""
        if self.function[spindle] == codes.SPINDLE_FORWARD:
            return self.commanded_v[spindle]
        if self.function[spindle] == codes.SPINDLE_BACKWARD:
            return 0.0 - self.commanded_v[spindle]
        return 0.0

    def step(self, tick: int, acknowledges_itself: int) -> None:
        """Advance all turning spindles by a tick; run the default PLC if there is no other."""
        spindle = self.overrides.next_changed(0)
        while spindle >= 0:
            is_free = self.mode[spindle] != codes.COUPLED and self.limits.bound_a[spindle] == 0.0
            if is_free and self.overrides.apply(spindle):
                self.follow_override(spindle, tick)
            spindle = self.overrides.next_changed(spindle + 1)
        if self.cutting.active_count > 0:
            self.follow_axes(tick)
        if self.active_count == 0:
            return
        for spindle in range(self.count):
            if self.mode[spindle] == codes.TURNING or self.mode[spindle] == codes.POSITIONING:
                self.advance(spindle, tick)
            if self.plc_state[spindle] == codes.WAITING and self.done_tick[spindle] <= tick:
                if acknowledges_itself:
                    self.plc_state[spindle] = codes.ACKNOWLEDGED

    def advance(self, spindle: int, tick: int) -> None:
        """Advance a spindle that has a plan by a tick, and publish its state."""
        time_t = (tick - self.begin_tick[spindle] + 1) * self.cycle_t
        self.plans.evaluate(spindle, time_t)
        self.position[spindle] = wrapped(self.begin_position[spindle] + self.plans.distance_d)
        self.speed_v[spindle] = self.plans.speed_v
        self.acceleration[spindle] = self.plans.acceleration_a
        if time_t >= self.plans.duration_t(spindle) - 1e-12:
            self.arrive(spindle)
        self.publish(spindle)

    def publish(self, spindle: int) -> None:
        """Write speed and position where cycles, traces and the PLC read them."""
        cell = self.first_cell + cells.SPINDLE_CELLS * spindle
        self.cells[cell + cells.SPINDLE_SPEED] = self.speed_v[spindle] / 6.0
        self.cells[cell + cells.SPINDLE_POSITION] = self.position[spindle]

    def arrive(self, spindle: int) -> None:
        """Settle a reached speed or position, bit by bit the commanded one."""
        self.acceleration[spindle] = 0.0
        is_there = self.mode[spindle] == codes.POSITIONING
        is_at_rest = is_there or self.function[spindle] == codes.SPINDLE_STOP
        if is_there:
            self.position[spindle] = wrapped(self.commanded_position[spindle])
        waits = self.is_held[spindle] or self.rests(spindle)
        if is_at_rest or waits or self.commanded_v[spindle] == 0.0:
            self.speed_v[spindle] = 0.0
            self.mode[spindle] = codes.SPINDLE_STOPPED
            self.active_count -= 1
        else:
            self.speed_v[spindle] = self.commanded_v[spindle]
        if not waits:
            self.finish(spindle)

    def finish(self, spindle: int) -> None:
        """End the open job and record it."""
        if self.is_open[spindle]:
            self.is_open[spindle] = 0
            number = self.first_number + spindle
            source, serial = self.source[spindle], self.serial[spindle]
            self.record.event(rows.EVENT_SPINDLE_REACHED, source, serial, number)

    # --- Python's side --------------------------------------------------------------------------

    def jobs(self) -> list[tuple[int, int, float, float, int, int, float, int]]:
        """Jobs that wait for the PLC: spindle, M, °/s, °, direction, tick, °/s before, serial."""
        return [
            (
                spindle,
                self.function[spindle],
                self.commanded_v[spindle],
                self.commanded_position[spindle],
                self.direction[spindle],
                self.taken_tick[spindle],
                self.reached_v[spindle],
                self.job[spindle],
            )
            for spindle in range(self.count)
            if self.plc_state[spindle] == codes.WAITING
        ]

    def has_jobs(self) -> bool:
        """Return whether a job waits for the PLC."""
        for spindle in range(self.count):
            if self.plc_state[spindle] == codes.WAITING:
                return True
        return False

    def latest_job(self, spindle: int) -> tuple[int, float, bool]:
        """Return the M function of the latest job, 0 before the first, °/s, and if it is open."""
        check_index(spindle, self.count, "spindle")
        return self.function[spindle], self.commanded_v[spindle], self.is_open[spindle] != 0

    def acknowledge(self, spindle: int, serial: int) -> bool:
        """Acknowledge the job of this serial; return whether it waits."""
        check_index(spindle, self.count, "spindle")
        if self.plc_state[spindle] == codes.FREE or self.job[spindle] != serial:
            return False
        self.plc_state[spindle] = codes.ACKNOWLEDGED
        return True

    def ending_count(self) -> int:
        """Number of spindles on their way to a standstill."""
        return sum(
            1
            for spindle in range(self.count)
            if self.mode[spindle] == codes.POSITIONING
            or (
                self.mode[spindle] not in (codes.SPINDLE_STOPPED, codes.COUPLED)
                and (self.function[spindle] == codes.SPINDLE_STOP or self.is_held[spindle])
            )
        )


def wrapped(degrees: float) -> float:
    """Position within a revolution: from 0 up to, but not including, 360 degrees."""
    turned = degrees - 360.0 * arithmetic.floor(degrees / 360.0)
    return 0.0 if turned >= 360.0 else turned

# SPDX-License-Identifier: MIT
"""Independent motion of each axis, tick by tick (MO-11): the motions of ``single_axes.py``.

Each axis has at most one present motion and one waiting motion. ``begin`` only stores the command;
``step``, once a tick after the cycles and the paths, plans from the present state
(``axis_plans.py``) wherever the motion or its speed limit has changed, and puts the axes where the
plan has them. So a new target, an override, a hold and its end carry speed and acceleration on
without a step.

Targets are in axis coordinates (ACS), mm or degrees. Positions of modulo axes run on while they
move, and are put back into the range when they are at rest.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.axis_plans import AxisPlans, MotionLimits
from nctakt.kernel.axes.homing import Homing
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index
from nctakt.kernel.base.record import Record


class WaitingMotions:
    """The motion of each axis that begins after its present one; kind ``codes.IDLE``: none."""

    def __init__(self, count: int) -> None:
        self.kind = integers(count)
        self.owner = integers(count)
        self.serial = integers(count)
        self.source = integers(count)
        self.value = doubles(count)
        self.speed_v = doubles(count)
        self.direction = integers(count)
        self.held = integers(count)
        self.swings = integers(count)


class Oscillations:
    """What oscillating axes have besides their present motion.

    ``left``: how often an axis will still reach its second position, -1 without an end, 0 if it
    does not oscillate. ``stage``: ``codes.APPROACH`` …. ``pausing``: ticks that it waits before it
    continues.
    """

    def __init__(self, count: int) -> None:
        self.left = integers(count)
        self.stage = integers(count)
        self.pausing = integers(count)
        self.first_pause = integers(count)
        self.second_pause = integers(count)
        self.first_d = doubles(count)
        self.second_d = doubles(count)
        self.stroke_d = doubles(count)

    def end(self, axis: int) -> None:
        """End the oscillation of an axis, if it has one."""
        self.left[axis] = 0
        self.pausing[axis] = 0


class AxisFaults:
    """The errors that axes are in.

    ``message``: of an axis, with a minus once its channel has reported it, 0 without an error.
    ``open_count``: errors that are still to be reported; ``failed``: the axes of the last errors.
    """

    def __init__(self, count: int) -> None:
        self.open_count = 0
        self.reported_count = 0
        self.failed_count = 0
        self.ring_size = count
        self.message = integers(count)
        self.failed = integers(count)

    def enter(self, axis: int, message: int, channel: int) -> None:
        """Let an axis be in an error, which ``channel`` has to report; 0: none."""
        self.message[axis] = message if channel else 0 - message
        if channel:
            self.open_count += 1

    def note(self, axis: int) -> None:
        """Note that an axis has failed in its motion."""
        self.failed[self.failed_count % self.ring_size] = axis
        self.failed_count += 1

    def take(self, axis: int) -> int:
        """Take the error of an axis that its channel has not reported yet; 0 without one."""
        if self.message[axis] > 0:
            self.open_count -= 1
            message = self.message[axis]
            self.message[axis] = 0 - message
            return message
        return 0


class AxisMotions:
    """The present and the waiting motion of each axis of the machine."""

    def __init__(self, axes: Axes, record: Record, cycle_time_us: int) -> None:
        count = axes.count
        self.axes = axes
        self.record = record
        self.limits = MotionLimits(count)
        self.plans = AxisPlans(self.limits, count, cycle_time_us)
        self.homing = Homing(axes)
        self.waiting = WaitingMotions(count)
        self.oscillations = Oscillations(count)
        self.faults = AxisFaults(count)
        self.active_count = 0
        # The present motions.
        self.kind = integers(count)
        self.held = integers(count)
        self.owner = integers(count)
        self.serials = integers(count)
        self.sources = integers(count)
        self.goal = doubles(count)
        self.end = doubles(count)
        self.commanded_v = doubles(count)
        self.direction = doubles(count)
        self.arrived = integers(count)
        # Which channel has the axis, from 1.
        self.in_channel = integers(count)
        for axis in range(count):
            self.axes.show_state(axis, codes.STANDSTILL)

    def configure(
        self,
        axis: int,
        *,
        low: float,
        high: float,
        speed: float,
        acceleration: float,
        jerk: float,
        is_enabled: bool = True,
    ) -> None:
        """Let an axis move on its own within these limits; jerk 0: trapezoid.

        ``is_enabled``: cycles and the PLC may move it (P-AXIS-00457).
        """
        check_index(axis, self.axes.count, "axis")
        self.limits.is_enabled[axis] = is_enabled
        self.limits.listed_low[axis] = low
        self.limits.listed_high[axis] = high
        self.limits.put_back(axis)
        self.limits.max_v[axis] = speed
        self.limits.max_a[axis] = acceleration
        self.limits.max_j[axis] = jerk

    def is_beyond(self, axis: int, target: float) -> int:
        """Return 60158 for a target above the software limits, 60159 for one below them, else 0."""
        if self.homing.running[axis]:
            return 0
        if (
            self.axes.modulo_range[axis] > 0.0
            or self.limits.low[axis] <= target <= self.limits.high[axis]
        ):
            return 0
        return 60159 if target < self.limits.low[axis] else 60158

    def is_shift_beyond(self, axis: int, shift: float) -> int:
        """Return as ``is_beyond`` of the place of an axis and its targets, shifted; else 0."""
        message = self.is_beyond(axis, self.axes.command[axis] + shift)
        if message == 0 and self.kind[axis] == codes.TO_POSITION:
            message = self.is_beyond(axis, self.goal[axis] + shift)
            if message == 0 and self.oscillations.left[axis]:
                message = self.is_beyond(axis, self.oscillations.first_d[axis] + shift)
            if message == 0 and self.oscillations.left[axis]:
                message = self.is_beyond(axis, self.oscillations.second_d[axis] + shift)
        return message

    def move_origin(self, axis: int, shift: float) -> None:
        """Assign another position to the place of an axis; its motion covers the same distance."""
        if self.kind[axis] == codes.IDLE:
            self.axes.refer(axis, self.in_range(axis, self.axes.command[axis] + shift))
            return
        self.axes.refer(axis, self.axes.command[axis] + shift)
        self.plans.start_d[axis] += shift
        self.oscillations.first_d[axis] += shift
        self.oscillations.second_d[axis] += shift
        if self.kind[axis] == codes.ENDLESS:
            self.plans.planned_v[axis] = -1.0  # the limit is at another distance now
        else:
            self.goal[axis] += shift
            self.end[axis] = self.in_range(axis, self.end[axis] + shift)
            self.axes.target[axis] = self.goal[axis]

    def is_at_speed(self, axis: int) -> int:
        """Return whether an endless motion has reached its speed."""
        if self.kind[axis] != codes.ENDLESS or self.plans.planned_v[axis] <= 0.0:
            return 0
        return (
            1 if self.plans.speed[axis] == self.direction[axis] * self.plans.planned_v[axis] else 0
        )

    def event(self, kind: int, axis: int, value: float) -> None:
        """Record the outcome of the present motion."""
        self.record.event(kind, self.sources[axis], self.serials[axis], axis, value)

    # --- beginnings and ends --------------------------------------------------------------------

    def begin(self, axis: int) -> None:
        """Make the waiting motion the present one; it is planned in the next step."""
        kind = self.waiting.kind[axis]
        position = self.axes.command[axis]
        self.waiting.kind[axis] = codes.IDLE
        self.direction[axis] = self.waiting.direction[axis]
        if self.waiting.direction[axis] == codes.PRESENT:
            self.direction[axis] = self.plans.last_direction[axis]
        self.oscillations.left[axis] = self.waiting.swings[axis] if kind == codes.OSCILLATION else 0
        self.oscillations.pausing[axis] = 0
        if kind == codes.ENDLESS:
            self.goal[axis] = (
                self.limits.high[axis] if self.direction[axis] > 0.0 else self.limits.low[axis]
            )
            self.end[axis] = self.goal[axis]
        elif kind == codes.BY_DISTANCE:
            self.goal[axis] = position + self.waiting.value[axis]
            self.end[axis] = self.in_range(axis, self.goal[axis])
            kind = codes.TO_POSITION
        else:
            self.end[axis] = self.in_range(axis, self.waiting.value[axis])
            self.goal[axis] = self.waiting.value[axis]
            if self.axes.modulo_range[axis] > 0.0:
                self.goal[axis] = position + self.turn(axis, self.end[axis] - position)
            kind = codes.TO_POSITION
        if self.kind[axis] == codes.IDLE:
            self.active_count += 1
            self.axes.independent[axis] = 1
        self.kind[axis] = kind
        self.held[axis] = self.waiting.held[axis]
        self.owner[axis] = self.waiting.owner[axis]
        self.serials[axis] = self.waiting.serial[axis]
        self.sources[axis] = self.waiting.source[axis]
        self.commanded_v[axis] = self.waiting.speed_v[axis]
        self.plans.planned_v[axis] = -1.0
        self.axes.target[axis] = self.goal[axis] if kind == codes.TO_POSITION else position
        self.axes.has_moved = True
        self.axes.show_state(
            axis, codes.CONTINUOUS_MOTION if kind == codes.ENDLESS else codes.DISCRETE_MOTION
        )
        self.record_begin(axis)
        if kind == codes.TO_POSITION and self.is_beyond(axis, self.goal[axis]):
            self.fail(axis, 1702 if self.goal[axis] > self.limits.high[axis] else 1703)
        elif self.held[axis]:
            self.axes.show_state(axis, codes.STANDSTILL)
            self.event(rows.EVENT_AXIS_CHANGED, axis, rows.MOTION_HELD)

    def record_begin(self, axis: int) -> None:
        """Record that the present motion begins."""
        source, serial = self.sources[axis], self.serials[axis]
        if self.kind[axis] == codes.ENDLESS:
            self.event(rows.EVENT_AXIS_ENDLESS, axis, self.direction[axis])
        elif self.oscillations.left[axis]:
            first_d, second_d = self.oscillations.first_d[axis], self.oscillations.second_d[axis]
            kind = rows.EVENT_AXIS_OSCILLATES
            self.record.event(kind, source, serial, axis, first_d, second_d)
        else:
            self.event(rows.EVENT_AXIS_BEGUN, axis, self.end[axis])

    def turn(self, axis: int, distance_d: float) -> float:
        """Return how far a modulo axis goes to a target ``distance_d`` away in its direction.

        In a given direction the axis never comes back: its braking distance is already used up.
        """
        full_d = self.axes.modulo_range[axis]
        if self.waiting.direction[axis] == codes.SHORTEST:
            return distance_d - full_d * arithmetic.ceiling(distance_d / full_d - 0.5)
        turns = (distance_d - self.plans.brake_d(axis)) / full_d
        if self.direction[axis] > 0.0:
            return distance_d - full_d * arithmetic.floor(turns)
        return distance_d - full_d * arithmetic.ceiling(turns)

    def in_range(self, axis: int, position: float) -> float:
        """Position of a modulo axis within its range; that of any other axis unchanged."""
        full_d = self.axes.modulo_range[axis]
        if full_d <= 0.0:
            return position
        return arithmetic.within(position, self.axes.modulo_low[axis], full_d)

    def drop(self, axis: int) -> None:
        """Give up the waiting and the present motion, and record both."""
        self.homing.running[axis] = 0
        if self.waiting.kind[axis]:
            self.drop_next(axis, rows.NOT_WITH_CYCLE)
        if codes.IDLE < self.kind[axis] < codes.BRAKING:
            self.drop_present(axis, rows.NOT_WITH_CYCLE)

    def drop_next(self, axis: int, why: int) -> None:
        """Give up the waiting motion."""
        source, serial = self.waiting.source[axis], self.waiting.serial[axis]
        self.record.event(rows.EVENT_AXIS_ENDED, source, serial, axis, rows.MOTION_ABORTED, why)
        self.waiting.kind[axis] = codes.IDLE

    def drop_present(self, axis: int, why: int) -> None:
        """Record that the present motion is dropped; its owner may command another."""
        source, serial = self.sources[axis], self.serials[axis]
        self.record.event(rows.EVENT_AXIS_ENDED, source, serial, axis, rows.MOTION_ABORTED, why)
        self.owner[axis] = 0

    def give_up(self, axis: int) -> None:
        """Brake to a standstill and give up all motions of an axis."""
        self.drop(axis)
        if codes.IDLE < self.kind[axis] < codes.BRAKING:
            self.brake(axis)

    def brake(self, axis: int) -> None:
        """Brake to a standstill; the motion itself has been given up."""
        self.kind[axis] = codes.BRAKING
        self.held[axis] = 0
        self.oscillations.end(axis)
        self.axes.show_state(axis, codes.STOPPING)

    def come_to_standstill(self, axis: int) -> None:
        """End the motion of an axis, or begin the waiting one."""
        self.kind[axis] = codes.IDLE
        self.axes.independent[axis] = 0
        self.held[axis] = 0
        self.oscillations.end(axis)
        self.homing.running[axis] = 0
        self.owner[axis] = 0
        self.active_count -= 1
        self.plans.come_to_rest(axis)
        self.axes.target[axis] = self.axes.command[axis]
        self.axes.has_moved = True
        if self.waiting.kind[axis]:
            self.begin(axis)
        else:
            self.axes.show_state(
                axis, codes.ERROR_STOP if self.faults.message[axis] else codes.STANDSTILL
            )

    def fail(self, axis: int, message: int) -> None:
        """End the motion with the error ``message``, and drop the one that waits."""
        self.record.event(rows.EVENT_ERROR, self.sources[axis], self.serials[axis], message, axis)
        if self.waiting.kind[axis]:
            self.drop_next(axis, rows.NOT_WITH_CYCLE)
        self.event(rows.EVENT_AXIS_ENDED, axis, rows.MOTION_FAILED)
        self.brake(axis)
        self.faults.enter(axis, message, self.in_channel[axis])
        self.faults.note(axis)

    # --- the tick -------------------------------------------------------------------------------

    def step(self) -> None:
        """Advance all axes in independent motion by a tick."""
        if self.active_count == 0:
            return
        for axis in range(self.axes.count):
            if self.kind[axis]:
                self.step_axis(axis)

    def follow_masters(self) -> None:
        """Let slaves follow their masters, before the drives (``couplings.py``)."""
        if self.axes.couplings.count > 0:
            self.axes.follow_masters()

    def watch_slaves(self) -> None:
        """Stop with an error where the drives of a gantry are too far apart."""
        if self.axes.couplings.watched_count == 0:
            return
        for k in range(self.axes.couplings.count):
            axis = self.axes.couplings.master[k]
            if self.faults.message[axis] == 0 and self.axes.is_askew(k):
                self.stop_askew(axis)

    def stop_askew(self, axis: int) -> None:
        """Stop a master whose slave is too far away."""
        if self.kind[axis]:
            self.fail(axis, 901879)
            return
        self.record.event(rows.EVENT_ERROR, 0, 0, 901879, axis)
        self.faults.enter(axis, 901879, self.in_channel[axis])

    def step_axis(self, axis: int) -> None:
        """Advance one axis by a tick; replan where its limit has changed."""
        if self.oscillations.pausing[axis] > 0:
            self.oscillations.pausing[axis] -= 1
            return
        top_v = 0.0
        if self.kind[axis] != codes.BRAKING and not self.held[axis]:
            top_v = self.commanded_v[axis] * self.axes.independent_pct[axis] / 100.0
            top_v *= self.axes.plc_factor[axis]
            top_v = min(top_v, self.limits.max_v[axis])
        if top_v != self.plans.planned_v[axis]:
            self.plan(axis, top_v)
        self.axes.has_moved = True
        if self.plans.count_tick(axis) and self.arrive(axis, top_v):
            return
        self.axes.command[axis] = self.plans.advance(axis)
        if self.kind[axis] == codes.ENDLESS:
            self.axes.target[axis] = self.axes.command[axis]
            if self.waiting.kind[axis] and not self.waiting.held[axis] and self.is_at_speed(axis):
                self.event(rows.EVENT_AXIS_ENDED, axis, rows.MOTION_DONE)
                self.begin(axis)

    def plan(self, axis: int, top_v: float) -> None:
        """Plan the rest of the motion from the present state, at most with ``top_v``."""
        self.plans.begin(axis, self.axes.command[axis], top_v)
        if top_v == 0.0 or (
            self.kind[axis] == codes.ENDLESS and not arithmetic.is_finite(self.goal[axis])
        ):
            self.plans.plan_speed(axis, top_v * self.direction[axis])
        else:
            self.plans.plan_distance(axis, self.goal[axis])

    def arrive(self, axis: int, top_v: float) -> int:
        """Finish a plan that is over; return 1 if the motion has ended with it."""
        if self.kind[axis] == codes.BRAKING:
            position = self.plans.end_position(axis)
            self.axes.command[axis] = self.in_range(axis, position)
            self.record.event(
                rows.EVENT_AXIS_CHANGED,
                self.sources[axis],
                self.serials[axis],
                axis,
                rows.MOTION_STOPPED,
                self.goal[axis] - position,
            )
            self.come_to_standstill(axis)
            return 1
        if top_v == 0.0 or (
            self.kind[axis] == codes.ENDLESS and not arithmetic.is_finite(self.goal[axis])
        ):
            if self.held[axis]:
                self.axes.show_state(axis, codes.STANDSTILL)
            return 0
        self.axes.command[axis] = self.end[axis]
        if self.kind[axis] == codes.ENDLESS:
            self.fail(axis, 1702 if self.direction[axis] > 0.0 else 1703)
        elif self.oscillations.left[axis] and self.turn_round(axis):
            return 1
        else:
            self.event(rows.EVENT_AXIS_ENDED, axis, rows.MOTION_DONE)
            self.arrived[axis] = self.owner[axis]
            if self.homing.running[axis] == codes.HOMED_BY_PLC:
                self.homing.finish(axis)
        self.come_to_standstill(axis)
        return 1

    def turn_round(self, axis: int) -> int:
        """Send an oscillating axis to its other position; return 0 after its last swing.

        Another motion that waits ends the oscillation here.
        """
        if self.oscillations.stage[axis] == codes.FORTH:
            if self.waiting.kind[axis] and not self.waiting.held[axis]:
                return 0
            if self.oscillations.left[axis] > 0:
                self.oscillations.left[axis] -= 1
            if self.oscillations.left[axis] == 0:
                return 0
            self.goal[axis] = self.axes.command[axis] - self.oscillations.stroke_d[axis]
            self.end[axis] = self.oscillations.first_d[axis]
            self.oscillations.pausing[axis] = self.oscillations.second_pause[axis]
            self.oscillations.stage[axis] = codes.BACK
        else:
            self.goal[axis] = self.axes.command[axis] + self.oscillations.stroke_d[axis]
            self.end[axis] = self.oscillations.second_d[axis]
            self.oscillations.pausing[axis] = self.oscillations.first_pause[axis]
            self.oscillations.stage[axis] = codes.FORTH
        self.plans.come_to_rest(axis)
        self.plans.planned_v[axis] = -1.0
        self.axes.target[axis] = self.goal[axis]
        return 1

    def finish_swing(self, axis: int) -> None:
        """Let an oscillating axis stop when it comes to its second position, or there at once."""
        if self.oscillations.left[axis] == 0:
            return
        is_there = (
            self.axes.command[axis] == self.oscillations.second_d[axis]
            and self.plans.speed[axis] == 0.0
        )
        if is_there and self.oscillations.stage[axis] == codes.BACK:
            self.event(rows.EVENT_AXIS_ENDED, axis, rows.MOTION_DONE)
            self.arrived[axis] = self.owner[axis]
            self.come_to_standstill(axis)
        else:
            self.oscillations.left[axis] = 1

    # --- Python's side --------------------------------------------------------------------------

    def configure_homing(
        self, axis: int, *, distance: float, speed: float, overrun: float, position: float
    ) -> None:
        """Let an axis be homed in this manner (``Homing.configure``)."""
        self.homing.configure(
            axis, distance=distance, speed=speed, overrun=overrun, position=position
        )

    def keep_reference(self, axis: int, position: float) -> None:
        """Note that a program homes an axis, with this position at its reference point."""
        check_index(axis, self.axes.count, "axis")
        self.homing.keep(axis, position)

    def reference_of(self, axis: int) -> float | None:
        """Return the reference position of an axis, ``None`` if it is not homed."""
        return self.homing.reference_of(axis)

    def limits_of(self, axis: int) -> tuple[float, float]:
        """Return the software limits of an axis in force, in mm or degrees."""
        return (self.limits.low[axis], self.limits.high[axis])

    def next_failed(self) -> int:
        """Axis of the next error event that was not asked for yet."""
        faults = self.faults
        faults.reported_count += 1
        return faults.failed[(faults.reported_count - 1) % faults.ring_size]

# SPDX-License-Identifier: MIT
"""One axis on its own: state, target and limits -> a time-optimal motion in closed form (MO-11).

A plan begins in any state (distance 0, a speed, an acceleration) and ends at rest after a distance,
or with a speed, or passes the end of a distance with a speed. It is a row of phases of constant
jerk; ``evaluate`` gives distance, speed and acceleration at any time by the polynomial of the
phase. With the jerk 0 the acceleration may step: a trapezoid of at most three phases. Else there
are at most seven: two changes of speed, each with three phases (the acceleration builds up, is
kept, fades), and a constant speed between them; one more where the present acceleration fades
first.

Finding the changes of speed: see where the axis would stop if it braked at once. If the target lies
beyond, it must continue in that direction, else come back; mirrored where necessary, one number
remains to be found: the highest speed, or, where the axis is braking already (or is too fast) and
only has to brake less, the acceleration between two brakings. The distance covered grows with that
number, so it is found in a bracket; only sums, products, quotients and square roots are used, so
that all machines find the same bits.

Units: ``_d`` mm or degrees, ``_v`` per second, ``_a`` per second squared, ``_j`` per second cubed,
``_t`` seconds.
"""

from __future__ import annotations

import math

from nctakt.kernel import codes
from nctakt.kernel.axes import plan_rows
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.base.bounds import check_size


class Trajectories:
    """The plans of ``count`` axes, a row each (``plan_rows.py``).

    The last phase of a plan keeps the speed reached.
    """

    def __init__(self, count: int) -> None:
        check_size(count, "number of axes")
        self.rows = doubles(plan_rows.PLAN_WIDTH * max(1, count))
        self.distance_d = 0.0
        self.speed_v = 0.0
        self.acceleration_a = 0.0
        self.top_v = 0.0
        self.limit_a = 0.0
        self.limit_j = 0.0
        self.from_v = 0.0
        self.from_a = 0.0
        self.middle_v = 0.0
        self.middle_a = 0.0
        self.slowest_v = 0.0
        self.slowest_peak2 = 0.0
        self.first_peak2 = 0.0
        self.sign = 1.0
        self.cruise_t = 0.0
        self.first_t = 0.0
        self.hold_t = 0.0
        self.last_t = 0.0
        self.peak_a = 0.0
        self.first_j = 0.0
        self.row = 0
        self.count = 0
        self.end_t = 0.0
        self.end_d = 0.0
        self.end_v = 0.0
        self.goal_v = 0.0
        self.side = 1.0

    # --- planning -------------------------------------------------------------------------------

    def plan_distance(
        self,
        axis: int,
        distance_d: float,
        start_v: float,
        start_a: float,
        top_v: float,
        limit_a: float,
        limit_j: float,
    ) -> None:
        """Plan to stop after ``distance_d``, at most with ``top_v`` (> 0) but at the start."""
        self.begin(axis, top_v, limit_a, limit_j)
        beyond_d = distance_d - self.stopping_d(start_v, start_a, limit_a, limit_j)
        self.side = 1.0 if beyond_d >= 0.0 else -1.0
        self.from_v = self.side * start_v
        self.from_a = self.side * start_a
        if limit_j == 0.0:
            self.trapezoid(self.side * distance_d)
        elif beyond_d * self.side <= 1e-10:
            self.direct(self.from_v, self.from_a)
            self.append_change(0.0)
        else:
            self.solve(self.side * distance_d)
            self.append_both()
        self.finish()

    def plan_passing(
        self,
        axis: int,
        distance_d: float,
        start_v: float,
        start_a: float,
        top_v: float,
        goal_v: float,
        limit_a: float,
        limit_j: float,
        fading_j: float,
    ) -> int:
        """Plan to pass a point ahead with ``goal_v`` (at most ``top_v``), no acceleration.

        Return 0 if the distance is too short: then the speed changes to ``goal_v`` at once, and has
        not reached it when the point is passed. Only with a jerk limit; if ``fading_j`` is not 0,
        the initial acceleration first fades with that jerk.
        """
        self.begin(axis, top_v, limit_a, limit_j)
        self.side = 1.0
        self.goal_v = goal_v
        self.from_v = start_v
        self.from_a = start_a
        if fading_j > 0.0:
            distance_d -= self.fade(fading_j)
        direct_d = self.direct(self.from_v, self.from_a)
        if direct_d >= distance_d - 1e-10:
            self.append_change(goal_v)
        else:
            self.solve(distance_d)
            self.append_both()
        self.finish()
        return 1 if direct_d <= distance_d + 1e-10 else 0

    def plan_speed(
        self,
        axis: int,
        end_v: float,
        start_v: float,
        start_a: float,
        limit_a: float,
        limit_j: float,
    ) -> None:
        """Plan to reach the speed ``end_v`` as fast as possible, and to keep it."""
        self.begin(axis, 0.0, limit_a, limit_j)
        self.side = 1.0
        self.from_v = start_v
        self.from_a = start_a
        if limit_j == 0.0:
            rise = limit_a if end_v > start_v else 0.0 - limit_a
            self.end_v = start_v
            self.append((end_v - start_v) / rise, rise, 0.0)
            self.end_v = end_v
        else:
            self.goal_v = end_v
            self.direct(start_v, start_a)
            self.append_change(end_v)
        self.finish()

    def evaluate(self, axis: int, time_t: float) -> None:
        """Evaluate distance, speed and acceleration at ``time_t`` since the plan's start.

        The times of one plan have to rise from call to call.
        """
        row = axis * plan_rows.PLAN_WIDTH
        phase = int(self.rows[row + plan_rows.PLAN_PHASE])
        last = int(self.rows[row + plan_rows.PLAN_LAST])
        begin = row + plan_rows.PLAN_PHASES + plan_rows.PHASE_WIDTH * phase
        next_begin = begin + plan_rows.PHASE_WIDTH
        while phase < last and time_t >= self.rows[next_begin + plan_rows.PHASE_TIME]:
            phase += 1
            begin = next_begin
            next_begin += plan_rows.PHASE_WIDTH
        self.rows[row + plan_rows.PLAN_PHASE] = phase
        since = time_t - self.rows[begin + plan_rows.PHASE_TIME]
        speed_v = self.rows[begin + plan_rows.PHASE_SPEED]
        rise_a = self.rows[begin + plan_rows.PHASE_ACCELERATION]
        jerk = self.rows[begin + plan_rows.PHASE_JERK]
        half = 0.5 * since
        self.distance_d = self.rows[begin + plan_rows.PHASE_DISTANCE] + since * (
            speed_v + half * (rise_a + since * jerk / 3.0)
        )
        self.speed_v = speed_v + since * (rise_a + half * jerk)
        self.acceleration_a = rise_a + since * jerk

    def rewind(self, axis: int) -> None:
        """Allow ``evaluate`` for an earlier time again."""
        self.rows[axis * plan_rows.PLAN_WIDTH + plan_rows.PLAN_PHASE] = 0.0

    def duration_t(self, axis: int) -> float:
        """Time until the target, or the speed, is reached, in s."""
        return self.rows[axis * plan_rows.PLAN_WIDTH + plan_rows.PLAN_DURATION]

    def stopping_d(self, start_v: float, start_a: float, limit_a: float, limit_j: float) -> float:
        """Distance that braking at once takes, in mm or degrees."""
        self.goal_v = 0.0
        self.limit_a = limit_a
        self.limit_j = limit_j
        if limit_j == 0.0:
            return 0.5 * start_v * math.fabs(start_v) / limit_a
        return self.direct(start_v, start_a)

    # --- the trapezoid --------------------------------------------------------------------------

    def trapezoid(self, distance_d: float) -> None:
        """Append a trapezoid: change to the highest usable speed, keep it, brake."""
        rise = self.limit_a
        highest_v = self.top_v
        if self.from_v > self.top_v:
            rise = 0.0 - self.limit_a
        else:
            peak2 = self.limit_a * distance_d + 0.5 * self.from_v * self.from_v
            highest_v = min(highest_v, math.sqrt(max(peak2, 0.0)))
        first_t = max((highest_v - self.from_v) / rise, 0.0)
        rest_d = distance_d - 0.5 * (self.from_v + highest_v) * first_t
        rest_d -= 0.5 * highest_v * highest_v / self.limit_a
        self.end_v = self.side * self.from_v
        self.append(first_t, self.side * rise, 0.0)
        self.end_v = self.side * highest_v
        if highest_v > 0.0:
            self.append(max(rest_d, 0.0) / highest_v, 0.0, 0.0)
            self.append(highest_v / self.limit_a, 0.0 - self.side * self.limit_a, 0.0)
        self.end_v = 0.0

    # --- the S-curve ----------------------------------------------------------------------------

    def settled(self) -> float:
        """Speed that is left once the acceleration of the start has faded."""
        return self.from_v + 0.5 * self.from_a * math.fabs(self.from_a) / self.limit_j

    def peak2(
        self, start_v: float, start_a: float, end_v: float, end_a: float, sign: float
    ) -> float:
        """Square of the acceleration's peak in a change of speed without limits."""
        return 0.5 * (start_a * start_a + end_a * end_a) + sign * self.limit_j * (end_v - start_v)

    def change(
        self,
        start_v: float,
        start_a: float,
        end_v: float,
        end_a: float,
        sign: float,
        peak2: float,
    ) -> float:
        """Change speed and acceleration with the acceleration's peak in ``sign``.

        Return the length; its three times, peak and first jerk are kept for ``append_change``.
        """
        peak_a = math.sqrt(max(peak2, 0.0))
        self.hold_t = 0.0
        is_held = peak_a > self.limit_a
        if is_held:
            peak_a = self.limit_a
        peak_a = peak_a * sign
        self.first_j = sign * self.limit_j
        if sign * (peak_a - start_a) < 0.0:
            self.first_j = 0.0 - self.first_j
        self.first_t = (peak_a - start_a) / self.first_j
        self.last_t = max(sign * (peak_a - end_a) / self.limit_j, 0.0)
        if is_held:
            ramps_v = 0.5 * (start_a + peak_a) * self.first_t + 0.5 * (peak_a + end_a) * self.last_t
            self.hold_t = max((end_v - start_v - ramps_v) / peak_a, 0.0)
        self.peak_a = peak_a
        time = self.first_t
        distance_d = time * (start_v + 0.5 * time * (start_a + time * self.first_j / 3.0))
        speed_v = start_v + 0.5 * (start_a + peak_a) * time
        time = self.hold_t
        distance_d += time * (speed_v + 0.5 * time * peak_a)
        speed_v += peak_a * time
        time = self.last_t
        return distance_d + time * (
            speed_v + 0.5 * time * (peak_a - sign * time * self.limit_j / 3.0)
        )

    def brake(self, start_v: float, start_a: float, sign: float) -> float:
        """Change to the speed at the goal (``change``); return the distance."""
        peak2 = self.peak2(start_v, start_a, self.goal_v, 0.0, sign)
        return self.change(start_v, start_a, self.goal_v, 0.0, sign, peak2)

    def direct(self, start_v: float, start_a: float) -> float:
        """Brake with the sign of the speed that is missing; return the distance.

        If no speed is missing, the peak is the present acceleration. Rounding differences below
        1e-12 of the speeds do not count: with the other sign its root would be a second peak, and
        the distance too long for a point that is just reached.
        """
        missing_v = self.goal_v - start_v - 0.5 * start_a * math.fabs(start_a) / self.limit_j
        size_v = math.fabs(start_v) + self.limit_a * self.limit_a / self.limit_j
        sign = 1.0 if missing_v > 0.0 else -1.0
        if start_a != 0.0 and math.fabs(missing_v) <= 1e-12 * (size_v + math.fabs(self.goal_v)):
            sign = 1.0 if start_a > 0.0 else -1.0
        return self.brake(start_v, start_a, sign)

    def solve(self, distance_d: float) -> None:
        """Find speed and acceleration between the two changes of speed for a distance."""
        self.cruise_t = 0.0
        settled_v = self.settled()
        self.slowest_v = max(settled_v, self.goal_v)
        rising_a = max(self.from_a, 0.0)
        self.slowest_peak2 = rising_a * rising_a + self.limit_j * (self.slowest_v - settled_v)
        self.sign = -1.0 if settled_v > self.top_v else 1.0
        self.middle_v = self.top_v
        self.middle_a = 0.0
        self.first_peak2 = self.peak2(self.from_v, self.from_a, self.top_v, 0.0, self.sign)
        longest_d = self.distance()
        if distance_d >= longest_d:
            self.cruise_t = (distance_d - longest_d) / self.top_v
        elif self.sign > 0.0 and self.guess(distance_d, longest_d):
            return
        elif settled_v > self.top_v:
            self.search(codes.CROSSING, 0.0 - self.crossing(), 0.0, distance_d)
        elif distance_d >= self.measure(codes.HIGHEST_SPEED, 0.0):
            above = math.sqrt(self.top_v - self.slowest_v)
            self.search(codes.HIGHEST_SPEED, 0.0, above, distance_d)
        else:
            self.sign = -1.0
            self.search(codes.MIN_BRAKING, self.from_a, 0.0, distance_d)

    def guess(self, distance_d: float, longest_d: float) -> int:
        """Find the highest speed where both changes keep the limit for a while: 1 if found.

        Then the length is v²/a + v·a/j + c, and a quadratic equation; c follows from the length to
        ``top_v``.
        """
        ramp_v = self.limit_a * self.limit_a / self.limit_j
        min_v = self.from_v + ramp_v - 0.5 * self.from_a * self.from_a / self.limit_j
        min_v = max(min_v, ramp_v + self.goal_v)
        if self.top_v < min_v:
            return 0
        left_d = longest_d - self.top_v * (self.top_v + ramp_v) / self.limit_a
        middle2 = 0.25 * ramp_v * ramp_v + self.limit_a * (distance_d - left_d)
        highest_v = math.sqrt(max(middle2, 0.0)) - 0.5 * ramp_v
        if highest_v < min_v:
            return 0
        self.middle_v = highest_v
        self.first_peak2 = self.peak2(self.from_v, self.from_a, highest_v, 0.0, 1.0)
        return 1

    def crossing(self) -> float:
        """Deceleration with which an axis that brakes at once passes ``top_v``."""
        rising = self.from_a * self.from_a + 2.0 * self.limit_j * (self.from_v - self.top_v)
        peak2 = 0.5 * self.from_a * self.from_a + self.limit_j * (self.from_v - self.goal_v)
        falling = 2.0 * self.limit_j * (self.top_v - self.goal_v)
        return min(self.limit_a, math.sqrt(max(min(rising, peak2, falling), 0.0)))

    def measure(self, unknown: int, value: float) -> float:
        """Length of the plan for a value of the unknown (``codes.HIGHEST_SPEED`` …)."""
        if unknown == codes.HIGHEST_SPEED:
            self.middle_v = self.slowest_v + value * value
            self.first_peak2 = self.slowest_peak2 + self.limit_j * value * value
            return self.distance()
        self.middle_a = value
        self.middle_v = self.top_v
        if unknown == codes.MIN_BRAKING:
            turned = value * value - self.from_a * self.from_a
            self.middle_v = self.from_v + 0.5 * turned / self.limit_j
        self.first_peak2 = self.peak2(self.from_v, self.from_a, self.middle_v, value, -1.0)
        return self.distance()

    def distance(self) -> float:
        """Length of both changes of speed, in mm or degrees."""
        distance_d = self.change(
            self.from_v, self.from_a, self.middle_v, self.middle_a, self.sign, self.first_peak2
        )
        return distance_d + self.brake(self.middle_v, self.middle_a, -1.0)

    def search(self, unknown: int, low: float, high: float, distance_d: float) -> None:
        """Find the value between two for which the length is ``distance_d``.

        Inverse quadratic interpolation through the last three values where it can be trusted, else
        bisection (Chandrupatla 1997).
        """
        other, before, value = low, low, high
        other_d = self.measure(unknown, low) - distance_d
        before_d = other_d
        value_d = self.measure(unknown, high) - distance_d
        allowed_d = 1e-12 + 1e-15 * math.fabs(distance_d)
        allowed = 1e-15 * (math.fabs(low) + math.fabs(high))
        if math.fabs(value_d) <= allowed_d:
            return
        part = 0.5
        for _attempt in range(100):
            estimate = value + part * (other - value)
            estimate_d = self.measure(unknown, estimate) - distance_d
            if math.fabs(estimate_d) <= allowed_d or math.fabs(other - value) <= allowed:
                return
            if (estimate_d > 0.0) == (value_d > 0.0):
                before, before_d = value, value_d
            else:
                before, before_d = other, other_d
                other, other_d = value, value_d
            value, value_d = estimate, estimate_d
            part = 0.5
            if before_d == other_d:
                continue
            ratio = (value - other) / (before - other)
            ratio_d = (value_d - other_d) / (before_d - other_d)
            if ratio_d * ratio_d < ratio and (1.0 - ratio_d) * (1.0 - ratio_d) < 1.0 - ratio:
                part = value_d / (other_d - value_d) * before_d / (other_d - before_d)
                part += (
                    (before - value)
                    / (other - value)
                    * value_d
                    / (before_d - value_d)
                    * other_d
                    / (before_d - other_d)
                )

    # --- the row of phases ----------------------------------------------------------------------

    def begin(self, axis: int, top_v: float, limit_a: float, limit_j: float) -> None:
        """Begin an empty plan of an axis."""
        self.row = axis * plan_rows.PLAN_WIDTH
        self.rows[self.row + plan_rows.PLAN_PHASE] = 0.0
        self.count = 0
        self.end_t = 0.0
        self.end_d = 0.0
        self.end_v = 0.0
        self.top_v = top_v
        self.limit_a = limit_a
        self.limit_j = limit_j

    def append(self, time_t: float, start_a: float, jerk_j: float) -> None:
        """Append a phase, unless it takes no time."""
        if time_t <= 0.0:
            return
        self.put_phase(start_a, jerk_j)
        self.count += 1
        self.end_t += time_t
        self.end_d += time_t * (self.end_v + 0.5 * time_t * (start_a + time_t * jerk_j / 3.0))
        self.end_v += time_t * (start_a + 0.5 * time_t * jerk_j)

    def put_phase(self, start_a: float, jerk_j: float) -> None:
        """Write the phase that begins at the plan's present end."""
        begin = self.row + plan_rows.PLAN_PHASES + plan_rows.PHASE_WIDTH * self.count
        self.rows[begin + plan_rows.PHASE_TIME] = self.end_t
        self.rows[begin + plan_rows.PHASE_DISTANCE] = self.end_d
        self.rows[begin + plan_rows.PHASE_SPEED] = self.end_v
        self.rows[begin + plan_rows.PHASE_ACCELERATION] = start_a
        self.rows[begin + plan_rows.PHASE_JERK] = jerk_j

    def fade(self, fading_j: float) -> float:
        """Append the fading of the start's acceleration; return the plan's length so far."""
        self.end_v = self.from_v
        jerk = 0.0 - fading_j if self.from_a > 0.0 else fading_j
        self.append(math.fabs(self.from_a) / fading_j, self.from_a, jerk)
        self.from_v = max(self.end_v, 0.0)
        self.from_a = 0.0
        return self.end_d

    def append_both(self) -> None:
        """Append both changes found by ``solve``, and the constant speed between them."""
        self.change(
            self.from_v, self.from_a, self.middle_v, self.middle_a, self.sign, self.first_peak2
        )
        self.append_change(self.middle_v)
        self.append(self.cruise_t, 0.0, 0.0)
        self.from_v = self.middle_v
        self.from_a = self.middle_a
        self.brake(self.from_v, self.from_a, -1.0)
        self.append_change(self.goal_v)

    def append_change(self, end_v: float) -> None:
        """Append the three phases of a change that ends with exactly ``end_v``."""
        if self.count == 0:
            self.end_v = self.side * self.from_v
        self.append(self.first_t, self.side * self.from_a, self.side * self.first_j)
        self.append(self.hold_t, self.side * self.peak_a, 0.0)
        fading_j = self.limit_j if self.peak_a < 0.0 else 0.0 - self.limit_j
        self.append(self.last_t, self.side * self.peak_a, self.side * fading_j)
        self.end_v = self.side * end_v

    def finish(self) -> None:
        """Append the last phase: the speed that was reached is kept."""
        self.rows[self.row + plan_rows.PLAN_LAST] = self.count
        self.rows[self.row + plan_rows.PLAN_DURATION] = self.end_t
        self.put_phase(0.0, 0.0)

    # --- Python's side --------------------------------------------------------------------------

    def prepare_distance(
        self, distance: float, v: float, a: float, top_v: float, limit_a: float, limit_j: float
    ) -> float:
        """Plan a distance of axis 0; return its duration in s."""
        self.plan_distance(0, distance, v, a, top_v, limit_a, limit_j)
        return self.duration_t(0)

    def prepare_speed(
        self, speed: float, v: float, a: float, limit_a: float, limit_j: float
    ) -> float:
        """Plan a speed of axis 0; return its duration in s."""
        self.plan_speed(0, speed, v, a, limit_a, limit_j)
        return self.duration_t(0)

    def at(self, time_t: float) -> tuple[float, float, float]:
        """Distance, speed and acceleration of axis 0 at a time in s."""
        self.evaluate(0, time_t)
        return self.distance_d, self.speed_v, self.acceleration_a

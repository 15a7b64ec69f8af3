# SPDX-License-Identifier: MIT
"""One coordinate's motion: state, target, limits -> a profile in closed form (MO-2, MO-5, MO-14).

A ``TrapezoidProfile`` is planned from a distance, a start and an end speed, a speed limit and one
acceleration, time-optimal: change to the highest speed that can be used, keep it, brake to the end
speed. Position and speed at any time are closed forms, so each tick can be computed by hand. Units:
``_d`` mm or degrees, ``_v`` per second, ``_a`` per second squared, ``_t`` seconds.
"""

from __future__ import annotations

import math


class TrapezoidProfile:
    """Three phases: constant acceleration, constant speed, constant deceleration.

    ``is_endless``: the end is never reached, because the speed limit is zero: the motion is stopped
    until it is replanned.
    """

    def __init__(self) -> None:
        self.first_t = 0.0
        self.first_a = 0.0
        self.first_d = 0.0
        self.start_v = 0.0
        self.cruise_t = 0.0
        self.cruise_v = 0.0
        self.cruise_d = 0.0
        self.last_a = 0.0
        self.duration_t = 0.0
        self.length_d = 0.0
        self.end_v = 0.0
        self.is_endless = False

    def plan(
        self, length_d: float, start_v: float, end_v: float, limit_v: float, limit_a: float
    ) -> None:
        """Plan ``length_d`` from speed ``start_v`` to ``end_v``, nowhere above ``limit_v``.

        A start speed above the limit is first brought down to it. The end speed is lower where the
        limit is, or where ``length_d`` is too short to gain it, and higher than the limit where
        ``length_d`` is too short to brake. Only if not even ``end_v`` can be reached (due to
        rounding by the caller) is the braking as hard as it takes.
        """
        self.length_d = length_d
        self.start_v = start_v
        self.is_endless = False
        start2 = start_v * start_v
        if length_d <= 0.0:
            self.end_v = min(end_v, start_v)
            self.pass_at_once()
            return
        highest_v = math.sqrt(start2 + 2.0 * limit_a * length_d)
        self.end_v = min(end_v, limit_v, highest_v)
        brake_d = (start2 - self.end_v * self.end_v) / (2.0 * limit_a)
        if brake_d >= length_d:
            end_v2 = max(start2 - 2.0 * limit_a * length_d, 0.0)
            self.end_v = min(end_v, math.sqrt(end_v2))
            self.brake_only()
            return
        if start_v > limit_v:
            self.first_a = 0.0 - limit_a
            self.cruise_v = limit_v
        else:
            peak2 = limit_a * length_d + 0.5 * (start_v * start_v + self.end_v * self.end_v)
            self.first_a = limit_a
            self.cruise_v = min(limit_v, math.sqrt(peak2))
            self.end_v = min(self.end_v, self.cruise_v)
        self.last_a = limit_a
        self.first_t = (self.cruise_v - start_v) / self.first_a
        self.first_d = 0.5 * (start_v + self.cruise_v) * self.first_t
        last_t = (self.cruise_v - self.end_v) / limit_a
        self.cruise_d = length_d - self.first_d - 0.5 * (self.cruise_v + self.end_v) * last_t
        self.cruise_d = max(self.cruise_d, 0.0)
        if self.cruise_v > 0.0:
            self.cruise_t = self.cruise_d / self.cruise_v
            self.duration_t = self.first_t + self.cruise_t + last_t
        else:
            self.cruise_t = 0.0
            self.duration_t = self.first_t
            self.is_endless = True

    def plan_ramps(
        self,
        length_d: float,
        start_v: float,
        first_d: float,
        cruise_v: float,
        last_d: float,
        end_v: float,
    ) -> None:
        """Plan ``length_d`` by the lengths of its ramps to ``cruise_v`` and to ``end_v``.

        With a ``cruise_v`` of 0 the motion is stopped after the first ramp.
        """
        self.length_d = length_d
        self.start_v = start_v
        self.end_v = end_v
        self.cruise_v = cruise_v
        self.first_d = first_d
        self.first_t = 2.0 * first_d / (start_v + cruise_v) if first_d > 0.0 else 0.0
        self.first_a = (cruise_v - start_v) / self.first_t if self.first_t > 0.0 else 0.0
        last_t = 2.0 * last_d / (cruise_v + end_v) if last_d > 0.0 else 0.0
        self.last_a = (cruise_v - end_v) / last_t if last_t > 0.0 else 0.0
        self.cruise_d = max(length_d - first_d - last_d, 0.0)
        self.is_endless = cruise_v <= 0.0
        self.cruise_t = 0.0 if self.is_endless else self.cruise_d / cruise_v
        self.duration_t = self.first_t + self.cruise_t + last_t

    def pass_at_once(self) -> None:
        """Plan an end that is reached in no time: no length is left."""
        self.first_t = 0.0
        self.first_a = 0.0
        self.first_d = 0.0
        self.cruise_t = 0.0
        self.cruise_d = 0.0
        self.cruise_v = self.end_v
        self.last_a = 0.0
        self.duration_t = 0.0

    def brake_only(self) -> None:
        """Brake from the first moment so that the end speed is reached at the end."""
        middle_v = 0.5 * (self.start_v + self.end_v)
        self.first_t = 0.0
        self.first_a = 0.0
        self.first_d = 0.0
        self.cruise_t = 0.0
        self.cruise_d = 0.0
        self.cruise_v = self.start_v
        self.duration_t = self.length_d / middle_v
        self.last_a = 0.0
        if self.duration_t > 0.0:
            self.last_a = (self.start_v - self.end_v) / self.duration_t

    def position(self, time_t: float) -> float:
        """Distance covered at ``time_t`` s since the plan's start."""
        if time_t < self.first_t:
            return time_t * (self.start_v + 0.5 * self.first_a * time_t)
        if self.is_endless:
            return self.first_d
        since = time_t - self.first_t
        if since < self.cruise_t:
            return self.first_d + self.cruise_v * since
        since = since - self.cruise_t
        return self.first_d + self.cruise_d + since * (self.cruise_v - 0.5 * self.last_a * since)

    def speed(self, time_t: float) -> float:
        """Speed per s at ``time_t`` s since the plan's start."""
        if time_t < self.first_t:
            return self.start_v + self.first_a * time_t
        since = time_t - self.first_t
        if self.is_endless or since < self.cruise_t:
            return self.cruise_v
        return self.cruise_v - self.last_a * (since - self.cruise_t)

    def at(self, time_t: float) -> tuple[float, float]:
        """Distance and speed at a time in s."""
        return (self.position(time_t), self.speed(time_t))

    def prepare(
        self, length_d: float, start_v: float, end_v: float, limit_v: float, limit_a: float
    ) -> None:
        """Plan as ``plan``, for Python's side."""
        self.plan(length_d, start_v, end_v, limit_v, limit_a)

# SPDX-License-Identifier: MIT
"""The shortest motion of an axis of the demo machine (MO-11), found slowly, by bisection."""

from __future__ import annotations

import math
from dataclasses import dataclass

TICK, ACCELERATION, FASTEST = 0.001, 4000.0, 500.0


@dataclass
class Plan:
    """From ``place`` with ``speed`` to ``target``, begun in tick ``first``."""

    first: int
    place: float
    speed: float
    target: float
    top: float

    def __post_init__(self) -> None:
        way = self.target - self.place
        low, high = -self.top, self.top
        if way >= self.braked(high):
            self.cruise, self.rest = high, (way - self.braked(high)) / high
        elif way <= self.braked(low):
            self.cruise, self.rest = low, (way - self.braked(low)) / low
        else:
            for _ in range(200):
                middle = (low + high) / 2
                low, high = (middle, high) if self.braked(middle) < way else (low, middle)
            self.cruise, self.rest = (low + high) / 2, 0.0
        self.ramp = abs(self.cruise - self.speed) / ACCELERATION
        self.duration = self.ramp + self.rest + abs(self.cruise) / ACCELERATION

    def braked(self, cruise: float) -> float:
        """The way to a speed and from there to rest."""
        ramp = abs(cruise - self.speed) / ACCELERATION
        return (self.speed + cruise) / 2 * ramp + cruise * abs(cruise) / (2 * ACCELERATION)

    def ticks(self) -> int:
        """How many ticks it takes, at least one."""
        return max(1, math.ceil(self.duration / TICK - 1e-6))

    def after(self, tick: int) -> tuple[float, float]:
        """Place and speed at the end of a tick."""
        time = (tick - self.first + 1) * TICK
        if tick - self.first + 1 >= self.ticks():
            return self.target, 0.0
        if time < self.ramp:
            change = math.copysign(ACCELERATION, self.cruise - self.speed) * time
            return self.place + (self.speed + change / 2) * time, self.speed + change
        place = self.place + (self.speed + self.cruise) / 2 * self.ramp
        time -= self.ramp
        if time < self.rest:
            return place + self.cruise * time, self.cruise
        place += self.cruise * self.rest
        time -= self.rest
        speed = self.cruise - math.copysign(ACCELERATION, self.cruise) * time
        return place + (self.cruise + speed) / 2 * time, speed

# SPDX-License-Identifier: MIT
"""The clocks of a session: when the next slice is due, and up to which tick it runs.

In: a speed, the time of a monotonic clock. Out: deadlines and ticks. Deadlines are absolute, so a
late slice does not move those after it: a session never drifts.
"""

from __future__ import annotations

#: The length of a slice on the wall clock, in seconds.
SLICE_S = 0.010

#: How long a slice takes that runs as fast as possible, in seconds: from, to.
FAST_SLICE_S = (0.012, 0.040)

#: Speeds on the wall clock, as factors.
MIN_SPEED, MAX_SPEED = 0.01, 1000.0

#: Ticks of a slice at most.
MAX_SLICE_TICKS = 1_000_000


class WallClock:
    """Machine time that follows the wall clock, times ``speed``, from ``first_tick`` on.

    Slices last ``slice_s`` seconds. ``late_count``: slices that began later than a slice's length
    after their time; ``worst_s``: the largest lateness in seconds.
    """

    def __init__(
        self, speed: float, first_tick: int, cycle_time_us: int, now_s: float, slice_s: float
    ) -> None:
        if not MIN_SPEED <= speed <= MAX_SPEED:
            raise ValueError(speed)
        self.speed = speed
        self._first_tick = first_tick
        self._cycle_time_us = cycle_time_us
        self._begin_s = now_s
        self._slice_s = slice_s
        self._slices = 0
        self.late_count = 0
        self.worst_s = 0.0

    def wait_s(self, now_s: float) -> float:
        """Return how long it is to the next slice, in seconds; 0 if it is due."""
        return max(0.0, self._begin_s + (self._slices + 1) * self._slice_s - now_s)

    def next_tick(self, now_s: float) -> int:
        """Return the tick up to which the slice that is due runs; note how late it is."""
        self._slices += 1
        lateness = now_s - (self._begin_s + self._slices * self._slice_s)
        self.worst_s = max(self.worst_s, lateness)
        if lateness > self._slice_s:
            self.late_count += 1
        passed_us = self._slices * self._slice_s * 1e6 * self.speed
        return self._first_tick + int(passed_us / self._cycle_time_us + 1e-6)

    def note(self, ticks: int, took_s: float) -> None:
        """Receive the cost of the slice: it has no consequence."""


class ScheduleClock:
    """The NC interrupts of a real schedule pace the session: each slice takes as long as it lasts.

    ``cycle_time_us``: the length of a tick.
    """

    speed: float | None = 1.0

    def __init__(self, first_tick: int, cycle_time_us: int) -> None:
        self._tick = first_tick
        self._ticks = max(1, int(SLICE_S * 1e6) // cycle_time_us)

    def wait_s(self, now_s: float) -> float:
        """Return 0: the schedule waits."""
        return 0.0

    def next_tick(self, now_s: float) -> int:
        """Return the tick up to which the next slice runs."""
        return self._tick + self._ticks

    def note(self, ticks: int, took_s: float) -> None:
        """Take how far the slice has come."""
        self._tick += ticks


class FastClock:
    """As fast as possible, in slices short enough for those who watch.

    ``rests``: the session stops where nothing can happen any more by itself.
    """

    speed: float | None = None

    def __init__(self, first_tick: int) -> None:
        self.rests = False
        self._tick = first_tick
        self._ticks = 10_000

    def wait_s(self, now_s: float) -> float:
        """Return 0: a slice is always due."""
        return 0.0

    def next_tick(self, now_s: float) -> int:
        """Return the tick up to which the next slice runs."""
        return self._tick + self._ticks

    def note(self, ticks: int, took_s: float) -> None:
        """Make the next slice longer or shorter, depending on the cost of this one."""
        self._tick += ticks
        shortest, longest = FAST_SLICE_S
        if took_s < shortest:
            self._ticks = min(2 * self._ticks, MAX_SLICE_TICKS)
        elif took_s > longest:
            self._ticks = max(self._ticks // 2, 1)


#: The clock that paces a session.
AnyClock = WallClock | ScheduleClock | FastClock


class Pacing:
    """How a session paces itself; ``pace``: by ``slice`` or by ``tick``, else ``ValueError``.

    ``has_schedule``: a real schedule gives the ticks their time.
    """

    def __init__(self, pace: str, cycle_time_us: int, *, has_schedule: bool) -> None:
        if pace not in ("slice", "tick"):
            raise ValueError(pace)
        self._cycle_time_us = cycle_time_us
        self._slice_s = SLICE_S if pace == "slice" else cycle_time_us / 1e6
        self._has_schedule = has_schedule

    def clock(self, speed: float | None, first_tick: int, now_s: float) -> AnyClock:
        """Return the clock of a speed; ``None``: as fast as possible."""
        if self._has_schedule:
            return ScheduleClock(first_tick, self._cycle_time_us)
        if speed is None:
            return FastClock(first_tick)
        return WallClock(speed, first_tick, self._cycle_time_us, now_s, self._slice_s)

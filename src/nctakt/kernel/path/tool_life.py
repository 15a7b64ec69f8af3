# SPDX-License-Identifier: MIT
"""How long and how far the tool has worked on the path of one channel (V.TLM).

Public manuals: "Weighting factors for tool life and tool life distance". Rapid motions do not
count, unless the list says so (P-CHAN-00255), nor does motion backward and forward again over the
same path.
"""

from __future__ import annotations


class ToolLifeCounter:
    """``time_t``: weighed seconds, to the tick; ``distance_d``: weighed mm along the path.

    ``tool``: number of the text of the tool's ID (``run/realtime/event_registry.py``), -1: none
    yet, ``basic``: its first part. Degrees count as mm where only rotary axes move.
    """

    def __init__(self, cycle_time_us: int) -> None:
        self.cycle_time_us = cycle_time_us
        self.counts_rapid = False
        self.is_counted = False
        self.has_moved = False
        self.time_t = 0.0
        self.distance_d = 0.0
        self.time_factor = 1.0
        self.distance_factor = 1.0
        self.begin_t = 0.0
        self.ticks = 0
        self.begin_d = 0.0
        self.from_d = 0.0
        self.counted_d = 0.0
        self.tool = -1
        self.basic = 0

    def count_rapid(self, counts_rapid: bool) -> None:
        """Let rapid motions count, or not (P-CHAN-00255)."""
        self.counts_rapid = counts_rapid

    def factors(self) -> tuple[float, float]:
        """Return the factors of time and distance."""
        return self.time_factor, self.distance_factor

    def begin(self, is_feed: int) -> None:
        """Begin a segment."""
        self.is_counted = is_feed != 0 or self.counts_rapid
        self.counted_d = 0.0
        self.begin_d = self.distance_d
        self.from_d = 0.0

    def count(self, covered_d: float) -> None:
        """Count the distance up to here, in mm from the start of the segment."""
        if self.is_counted and covered_d > self.counted_d:
            self.counted_d = covered_d
            self.distance_d = self.begin_d + (covered_d - self.from_d) * self.distance_factor
            self.has_moved = True

    def end_tick(self) -> None:
        """Count a tick in which the tool has worked."""
        self.has_moved = False
        self.ticks += 1
        self.time_t = self.begin_t + self.ticks * self.cycle_time_us / 1e6 * self.time_factor

    def before(self, is_ahead: int) -> float:
        """Return the distance up to a command; ``is_ahead``: the present segment comes after it."""
        return self.begin_d if is_ahead else self.distance_d

    def go_on(self, time_t: float, distance_d: float, is_ahead: int) -> None:
        """Continue from these values at a command."""
        self.time_t, self.begin_t, self.ticks = time_t, time_t, 0
        self.begin_d = distance_d
        self.from_d = 0.0 if is_ahead else self.counted_d
        self.distance_d = distance_d + (self.counted_d - self.from_d) * self.distance_factor

    def weigh(self, time_factor: float, distance_factor: float, is_ahead: int) -> None:
        """Let other factors count from a command on."""
        distance_d = self.before(is_ahead)
        self.time_factor = time_factor
        self.distance_factor = distance_factor
        self.go_on(self.time_t, distance_d, is_ahead)

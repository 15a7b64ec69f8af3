# SPDX-License-Identifier: MIT
"""The timers of realtime cycles: a bank apart from the decoder's (RC-401).

The time is the tick's. Timers survive program end and reset. The value latched by READ is in the
channel's cells of V.RTG.TIMER.
"""

from __future__ import annotations

from nctakt.kernel import cells, codes
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_cells


class Timers:
    """``first_cell`` is that of V.RTG.TIMER[0]."""

    def __init__(self, memory: bytearray, first_cell: int, cycle_time_us: int) -> None:
        check_cells(first_cell, cells.TIMERS, memory)
        self.cells = memoryview(memory).cast("d")
        self.first_cell = first_cell
        self.cycle_time_us = cycle_time_us
        self.is_running = integers(cells.TIMERS)
        self.started_tick = integers(cells.TIMERS)
        self.elapsed_ticks = integers(cells.TIMERS)

    def command(self, action: int, timer: int, tick: int) -> None:
        """Carry out an action: ``codes.TIMER_START`` …

        START of a running timer has no effect, a stopped one resumes counting; CLEAR zeroes and
        stops, the latched value stays.
        """
        if action == codes.TIMER_START:
            if not self.is_running[timer]:
                self.is_running[timer] = 1
                self.started_tick[timer] = tick
        elif action == codes.TIMER_STOP:
            self.elapsed_ticks[timer] = self.elapsed(timer, tick)
            self.is_running[timer] = 0
        elif action == codes.TIMER_READ:
            self.latch(timer, tick)
        else:
            self.is_running[timer] = 0
            self.elapsed_ticks[timer] = 0

    def elapsed(self, timer: int, tick: int) -> int:
        """Number of ticks that a timer has counted."""
        running = tick - self.started_tick[timer] if self.is_running[timer] else 0
        return self.elapsed_ticks[timer] + running

    def latched(self, timer: int) -> float:
        """The milliseconds that the last READ has latched."""
        return self.cells[self.first_cell + timer]

    def latch(self, timer: int, tick: int) -> None:
        """Latch whole milliseconds, at most the largest number of UNS32 (READ)."""
        time_us = self.elapsed(timer, tick) * self.cycle_time_us
        milliseconds = arithmetic.floor(time_us / 1000.0)
        self.cells[self.first_cell + timer] = min(milliseconds, 4294967295.0)

# SPDX-License-Identifier: MIT
"""The operator's override of the spindles of one channel (public manuals: "Spindle override").

It scales the speed of endless jobs and of positioning; G167 leaves it out for a job. While a
thread is cut a spindle keeps the override that it has.
"""

from __future__ import annotations

from nctakt.kernel import cells
from nctakt.kernel.base.arrays import doubles, integers


class SpindleOverrides:
    """``programmed_v``: speeds of the jobs, degrees/s; ``acted_pct``: the override that acts.

    ``highest_pct``: P-AXIS-00109 of each spindle.
    """

    def __init__(self, memory: bytearray, first_cell: int, count: int) -> None:
        size = max(1, count)
        self.cells = memoryview(memory).cast("d")
        self.first_cell = first_cell
        self.count = count
        self.programmed_v = doubles(size)
        self.acted_pct = doubles(size)
        self.highest_pct = doubles(size)
        self.is_ignored = integers(size)
        for spindle in range(count):
            self.acted_pct[spindle] = 100.0
            self.highest_pct[spindle] = 100.0
            self.cells[self.cell(spindle)] = 100.0

    def cell(self, spindle: int) -> int:
        """Return the cell of a spindle's override."""
        return self.first_cell + cells.SPINDLE_CELLS * spindle + cells.SPINDLE_OVERRIDE

    def begin(self, spindle: int, speed_v: float, is_ignored: int) -> None:
        """Begin a job with this speed; ``is_ignored``: without the override (G167)."""
        self.programmed_v[spindle] = speed_v
        self.is_ignored[spindle] = is_ignored

    def limit(self, spindle: int, highest_pct: float) -> None:
        """Set the highest override; the caller has checked the index."""
        self.highest_pct[spindle] = highest_pct

    def commanded(self, spindle: int) -> float:
        """Return the override that the operator commands, within its bounds, in percent."""
        return min(max(self.cells[self.cell(spindle)], 0.0), self.highest_pct[spindle])

    def next_changed(self, spindle: int) -> int:
        """Return the first spindle, from this one on, whose override has changed; -1: none."""
        for other in range(spindle, self.count):
            if self.commanded(other) != self.acted_pct[other]:
                return other
        return -1

    def apply(self, spindle: int) -> int:
        """Let the commanded override act; return whether it changes the speed."""
        self.acted_pct[spindle] = self.commanded(spindle)
        return 0 if self.is_ignored[spindle] else 1

    def factor(self, spindle: int) -> float:
        """Return the factor of the speed of the present job."""
        return 1.0 if self.is_ignored[spindle] else self.acted_pct[spindle] / 100.0

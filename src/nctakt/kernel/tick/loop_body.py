# SPDX-License-Identifier: MIT
"""The body of a realtime loop: the rows of the queue between its two ends, to be put in again.

Rows are kept as they were before their preparation: so each pass is prepared like the first, and
the path continues from one pass into the next.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base.arrays import doubles


class LoopBody:
    """Rows of ``width`` numbers; ``is_open`` while they come, ``is_complete`` from the end on.

    ``ends_at_standstill``: the last block ends at a standstill and needs no look-ahead.
    """

    def __init__(self, width: int) -> None:
        self.width = width
        self.rows = doubles(self.width)
        self.count = 0
        self.is_open = False
        self.is_complete = False
        self.ends_at_standstill = False

    def begin(self) -> None:
        """Begin a loop: the rows that follow are its body."""
        self.count = 0
        self.is_open = True
        self.is_complete = False

    def end(self, axis_count: int, ends_at_standstill: bool) -> None:
        """Complete the body; a pass begins exactly where the one before has ended."""
        self.is_open = False
        self.is_complete = True
        self.ends_at_standstill = ends_at_standstill
        begins = [self.width * k for k in range(self.count)]
        segments = [begin for begin in begins if self.rows[begin + rows.KIND] == rows.SEGMENT]
        first = segments[0] + rows.START
        last = segments[len(segments) - 1] + rows.START
        for i in range(axis_count):
            self.rows[first + i] = self.rows[last + axis_count + i]

    def give_up(self) -> None:
        """Forget the loop."""
        self.is_open = False
        self.is_complete = False

    def append(self, queue: memoryview[float], row: int) -> None:
        """Append the queue's row at ``row`` to the body."""
        if (self.count + 1) * self.width > len(self.rows):
            larger = doubles(2 * len(self.rows))
            for i in range(self.count * self.width):
                larger[i] = self.rows[i]
            self.rows = larger
        begin = self.count * self.width
        for i in range(self.width):
            self.rows[begin + i] = queue[row + i]
        self.count += 1

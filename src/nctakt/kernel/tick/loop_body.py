# SPDX-License-Identifier: MIT
"""The body of a realtime loop: the rows of the queue between its two ends, to be put in again.

Rows are kept as they were before their preparation, with what that needs: so each pass is prepared
like the first one, and the path goes on from one pass into the next.
"""

from __future__ import annotations

from collections.abc import Sequence

#: Columns behind a row: programmed speed, deviation.
EXTRA_COLUMNS = 2


class LoopBody:
    """Rows of ``width`` numbers; ``is_open`` while they come, ``is_complete`` from the end on.

    ``stops``: the last block ends with a stand, so that nothing is to be looked ahead for.
    """

    def __init__(self, width: int) -> None:
        self.width = width
        self.stride = width + EXTRA_COLUMNS
        self.rows = memoryview(bytearray(8 * self.stride)).cast("d")
        self.count = 0
        self.is_open = False
        self.is_complete = False
        self.stops = False

    def begin(self) -> None:
        """A loop begins: what comes is its body."""
        self.count = 0
        self.is_open = True
        self.is_complete = False

    def end(self, axis_count: int, stops: bool) -> None:
        """All of the body has come; a pass begins bit by bit where the one before has ended."""
        self.is_open = False
        self.is_complete = True
        self.stops = stops
        places = [self.stride * k for k in range(self.count)]
        segments = [place for place in places if self.rows[place] == 1.0]
        first, last = segments[0], segments[len(segments) - 1]
        for i in range(axis_count):
            self.rows[first + 12 + i] = self.rows[last + 12 + axis_count + i]

    def give_up(self) -> None:
        """There is no loop any more."""
        self.is_open = False
        self.is_complete = False

    def keep(self, row: Sequence[float], feed_v: float, deviation: float) -> None:
        """Keep a row of the queue."""
        if (self.count + 1) * self.stride > len(self.rows):
            larger = memoryview(bytearray(16 * len(self.rows))).cast("d")
            for i in range(self.count * self.stride):
                larger[i] = self.rows[i]
            self.rows = larger
        place = self.count * self.stride
        for i in range(self.width):
            self.rows[place + i] = row[i]
        self.rows[place + self.width] = feed_v
        self.rows[place + self.width + 1] = deviation
        self.count += 1

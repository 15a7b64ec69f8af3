# SPDX-License-Identifier: MIT
"""Plain blocks beside which the tool goes -> its ways in the channel's queue, without objects.

In: the lines of plain blocks while a contour is compensated, one motion behind (``tool_path.py``).
Out: rows of the queue, equal to the bit to those of the tree's way (``compensation.py``), which
hands its contour over and takes it back. A line with which there is something to tell is not taken.
"""

from __future__ import annotations

from nctakt.decoder.contour import rows as contour_rows
from nctakt.decoder.contour.tool_path import ToolPath
from nctakt.kernel import rows
from nctakt.kernel.tick.command_queue import CommandRing


class CompensatedLines:
    """The contour of one channel with so many axes.

    ``is_on``: plain blocks are compensated. ``first``, ``second``: the axes of the plane, at the
    ``distance`` to the left of whose lines the tool goes. What is held: the motion that is known
    but for its end, ``source`` … ``stops``, from ``start`` to ``target``; ``has_first_piece``: its
    first piece is in the queue. ``deviation``, ``limits_jerk``: as of all lines. ``has_next``: a
    line has come behind it, the next one, and it is not yet in the queue as a whole.
    """

    def __init__(self, tool: ToolPath, count: int) -> None:
        self.tool = tool
        self.count = count
        self.is_on = False
        self.first = 0
        self.second = 1
        self.distance = 0.0
        size = 8 * max(1, count)
        self.start = memoryview(bytearray(size)).cast("d")
        self.target = memoryview(bytearray(size)).cast("d")
        self.begin = memoryview(bytearray(size)).cast("d")
        self.end = memoryview(bytearray(size)).cast("d")
        self.arc = memoryview(bytearray(8 * rows.ARC_WIDTH)).cast("d")
        #: The places of the latest motions, by the last digits of their numbers.
        self.sources = memoryview(bytearray(8 * 64)).cast("d")
        self.source = 0
        self.number = 0
        self.motion = rows.FEED_MOTION
        self.feed_v = 0.0
        self.stops = False
        self.deviation = 0.0
        self.limits_jerk = False
        self.has_first_piece = False
        self.has_next = False
        self.next_target = memoryview(bytearray(size)).cast("d")
        self.next_source = 0
        self.next_number = 0
        self.next_motion = rows.FEED_MOTION
        self.next_feed_v = 0.0
        self.next_stops = False

    def set_motion(self, axis: int, start: float, target: float) -> None:
        """The way of an axis in the motion that is held."""
        self.start[axis] = start
        self.target[axis] = target

    def motion_of(self, axis: int) -> tuple[float, float]:
        """As ``set_motion``."""
        return (self.start[axis], self.target[axis])

    def source_of(self, number: int) -> int:
        """The place of one of the latest motions."""
        return int(self.sources[number & 63])

    def try_join(
        self,
        start: memoryview[float],
        target: memoryview[float],
        lows: memoryview[float],
        highs: memoryview[float],
        is_contour: bool,
    ) -> int:
        """Join a line with the motion that is held; 0: that is not for here."""
        x = start[self.first]
        y = start[self.second]
        x_2 = target[self.first]
        y_2 = target[self.second]
        if -1e-9 <= x_2 - x <= 1e-9 and -1e-9 <= y_2 - y <= 1e-9:
            return 0
        self.tool.line(x, y, x_2, y_2, self.distance, self.distance, is_contour)
        return (
            1
            if self.tool.try_add(
                lows[self.first], highs[self.first], lows[self.second], highs[self.second]
            )
            else 0
        )

    def emit(self, ring: CommandRing, timed: int) -> int:
        """The pieces of the motion that is held into the queue, up to so many commands in it.

        0: not all of them fit. Behind the last one the line that came then is held.
        """
        before = self.tool.number - 1
        while ring.timed_count < timed:
            shape = self.tool.take(before)
            if shape != contour_rows.NOTHING:
                self.emit_piece(ring, shape, before)
            if not self.tool.goes_on(before):
                self.advance(before)
                return 1
        return 0

    def advance(self, before: int) -> None:
        """The line that came is held; the one that was is over."""
        self.sources[before & 63] = self.source
        self.has_next = False
        self.has_first_piece = False
        self.source = self.next_source
        self.number = self.next_number
        self.motion = self.next_motion
        self.feed_v = self.next_feed_v
        self.stops = self.next_stops
        for i in range(self.count):
            self.start[i] = self.target[i]
            self.target[i] = self.next_target[i]

    def emit_piece(self, ring: CommandRing, shape: int, before: int) -> None:
        """One piece; other axes move on the first one, and only the last one stops exactly."""
        base = self.tool.taken_place()
        for i in range(self.count):
            self.begin[i] = self.target[i] if self.has_first_piece else self.start[i]
            self.end[i] = self.target[i]
        self.has_first_piece = True
        self.begin[self.first] = self.tool.rows[base + contour_rows.START_X]
        self.begin[self.second] = self.tool.rows[base + contour_rows.START_Y]
        self.end[self.first] = self.tool.rows[base + contour_rows.END_X]
        self.end[self.second] = self.tool.rows[base + contour_rows.END_Y]
        goes_on = self.tool.goes_on(before)
        stops = self.stops and not goes_on
        deviation = 0.0 if self.stops else self.deviation
        if shape == contour_rows.LINE:
            ring.put_line(
                self.source,
                self.number,
                self.begin,
                self.end,
                self.motion,
                self.feed_v,
                stops,
                deviation,
                self.limits_jerk,
            )
        else:
            self.arc[rows.PLANE_FIRST] = self.first
            self.arc[rows.PLANE_SECOND] = self.second
            self.arc[rows.CENTRE_FIRST] = self.tool.rows[base + contour_rows.CENTRE_X]
            self.arc[rows.CENTRE_SECOND] = self.tool.rows[base + contour_rows.CENTRE_Y]
            self.arc[rows.ANGLE] = self.tool.rows[base + contour_rows.ANGLE]
            ring.put_arc(
                self.source,
                self.number,
                self.begin,
                self.end,
                self.arc,
                self.motion,
                self.feed_v,
                stops,
                deviation,
                self.limits_jerk,
            )
        if goes_on:
            ring.block_goes_on()

    def set_next(
        self,
        source: int,
        number: int,
        target: memoryview[float],
        motion: int,
        feed_v: float,
        stops: int,
    ) -> None:
        """A line has come, to be held when the one before it is in the queue."""
        self.has_next = True
        self.next_source = source
        self.next_number = number
        self.next_motion = motion
        self.next_feed_v = feed_v
        self.next_stops = stops != 0
        for i in range(self.count):
            self.next_target[i] = target[i]

# SPDX-License-Identifier: MIT
"""Plain blocks along a compensated contour -> rows of the queue, without objects.

In: the lines of plain blocks during compensation, one motion late (``tool_path.py``). Out: rows
equal to the bit to those of ``compensation.py``, which exports its contour and imports it again. A
line that needs a message is left to the tree.
"""

from __future__ import annotations

from nctakt.decoder.contour import rows as contour_rows
from nctakt.decoder.contour.tool_path import ToolPath
from nctakt.kernel import rows
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.tick.command_queue import CommandQueue


class CompensatedLines:
    """The contour of one channel with ``count`` axes.

    ``is_on``: plain blocks are compensated. ``first``, ``second``: the axes of the plane;
    ``distance``: of the tool to the left of the lines, mm. The pending motion, known except for its
    end: ``source`` … ``stops``, from ``start`` to ``target``; ``has_first_piece``: its first piece
    is in the queue. ``deviation``, ``limits_jerk``: of all lines. ``has_next``: the next line has
    arrived, and the pending motion is not yet completely in the queue.
    """

    def __init__(self, tool: ToolPath, count: int) -> None:
        self.tool = tool
        self.count = count
        self.is_on = False
        self.first = 0
        self.second = 1
        self.distance = 0.0
        size = max(1, count)
        self.start = doubles(size)
        self.target = doubles(size)
        self.begin = doubles(size)
        self.end = doubles(size)
        self.arc = doubles(rows.ARC_WIDTH)
        #: Source numbers of the last motions, by their number modulo 64.
        self.sources = doubles(64)
        self.source = 0
        self.number = 0
        self.motion = rows.FEED_MOTION
        self.feed_v = 0.0
        self.stops = False
        self.deviation = 0.0
        self.limits_jerk = False
        self.has_first_piece = False
        self.has_next = False
        self.next_target = doubles(size)
        self.next_source = 0
        self.next_number = 0
        self.next_motion = rows.FEED_MOTION
        self.next_feed_v = 0.0
        self.next_stops = False

    def set_motion(self, axis: int, start: float, target: float) -> None:
        """Set start and target of an axis in the pending motion."""
        self.start[axis] = start
        self.target[axis] = target

    def motion_of(self, axis: int) -> tuple[float, float]:
        """Return start and target of an axis in the pending motion."""
        return (self.start[axis], self.target[axis])

    def source_of(self, number: int) -> int:
        """Return the source number of one of the last motions."""
        return int(self.sources[number & 63])

    def try_join(
        self,
        start: memoryview[float],
        target: memoryview[float],
        lows: memoryview[float],
        highs: memoryview[float],
        is_contour: bool,
    ) -> int:
        """Join a line to the pending motion; return 0 if the tree must do it."""
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

    def emit(self, queue: CommandQueue, timed: int) -> int:
        """Put the pieces of the pending motion into the queue, up to ``timed`` commands in it.

        Return 0 if not all of them fit. After the last one the next line becomes the pending
        motion.
        """
        before = self.tool.number - 1
        while queue.timed_count < timed:
            shape = self.tool.take(before)
            if shape != contour_rows.NOTHING:
                self.emit_piece(queue, shape, before)
            if not self.tool.has_next(before):
                self.advance(before)
                return 1
        return 0

    def advance(self, before: int) -> None:
        """Make the next line the pending motion."""
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

    def emit_piece(self, queue: CommandQueue, shape: int, before: int) -> None:
        """Put one piece into the queue; other axes move on the first one, the last one may stop
        exactly.
        """
        row = self.tool.taken_row()
        for i in range(self.count):
            self.begin[i] = self.target[i] if self.has_first_piece else self.start[i]
            self.end[i] = self.target[i]
        self.has_first_piece = True
        self.begin[self.first] = self.tool.rows[row + contour_rows.START_X]
        self.begin[self.second] = self.tool.rows[row + contour_rows.START_Y]
        self.end[self.first] = self.tool.rows[row + contour_rows.END_X]
        self.end[self.second] = self.tool.rows[row + contour_rows.END_Y]
        is_continued = self.tool.has_next(before)
        stops = self.stops and not is_continued
        deviation = 0.0 if self.stops else self.deviation
        if shape == contour_rows.LINE:
            queue.put_line(
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
            self.arc[rows.CENTRE_FIRST] = self.tool.rows[row + contour_rows.CENTRE_X]
            self.arc[rows.CENTRE_SECOND] = self.tool.rows[row + contour_rows.CENTRE_Y]
            self.arc[rows.ANGLE] = self.tool.rows[row + contour_rows.ANGLE]
            queue.put_arc(
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
        if is_continued:
            queue.continue_block()

    def set_next(
        self,
        source: int,
        number: int,
        target: memoryview[float],
        motion: int,
        feed_v: float,
        stops: int,
    ) -> None:
        """Set the line that follows the pending motion."""
        self.has_next = True
        self.next_source = source
        self.next_number = number
        self.next_motion = motion
        self.next_feed_v = feed_v
        self.next_stops = stops != 0
        for i in range(self.count):
            self.next_target[i] = target[i]

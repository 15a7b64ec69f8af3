# SPDX-License-Identifier: MIT
"""The commands that wait for a channel: a ring of rows of float64.

A command (``decoder/state/packing.py`` packs it) is a row (``rows.py``). A segment is prepared as
it comes, so that those before it may go faster. Commands that take time are counted
(``timed_count``); a rounding, which belongs to the segment in front of it, is not.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.kernel import rows
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.path import Path
from nctakt.kernel.tick.loop_body import LoopBody


class CommandRing:
    """Commands from ``head`` to ``tail``, running numbers; the path has begun up to ``begun``.

    ``latest``: the segment that the next one may go on from, -1 where the path stops first.
    """

    def __init__(self, path: Path, ahead: LookAhead) -> None:
        self.path = path
        self.ahead = ahead
        self.width = path.width
        self.capacity = 256
        ahead.capacity = self.capacity
        self.path.arc.share(self.ahead.most_v, self.ahead.feed_a)
        self.queue = memoryview(bytearray(8 * self.width * self.capacity)).cast("d")
        self.head = 0
        self.tail = 0
        self.timed_count = 0
        self.begun = -1
        self.latest = -1
        self.body = LoopBody(self.width)
        self.end_row = memoryview(bytearray(8 * self.width)).cast("d")

    def put(self, row: list[float]) -> None:
        """Append a command; the row may be shorter than the ring's width."""
        check_range(len(row), 1, self.width, "length of a command")
        base = self.next_row()
        for i, number in enumerate(row):
            self.queue[base + i] = number
        for i in range(len(row), self.width):
            self.queue[base + i] = 0.0
        self.tail += 1
        kind = int(row[rows.KIND])
        if kind in rows.TIMED_KINDS:
            self.timed_count += 1
        if not self.passes(kind):
            self.latest = -1
        if self.body.is_open:
            self.body.keep(self.queue, base)

    def begin_loop(self, row: list[float]) -> None:
        """Append the begin of a realtime loop; what comes up to its end is its body."""
        self.put(row)
        self.body.begin()

    def end_loop(self, row: list[float]) -> None:
        """Append the end of a realtime loop, where the path goes on into another pass."""
        latest = self.latest
        self.body.end(self.path.count, latest < 0)
        self.put(row)
        self.latest = latest
        while self.capacity < 8 * (self.body.count + 2) + self.ahead.blocks:
            self.grow()

    def put_segment(
        self,
        source: int,
        number: int,
        start: Sequence[float],
        target: Sequence[float],
        motion: int,
        feed_v: float,
        exact_stop: bool,
        deviation: float,
        limits_jerk: bool,
        arc: Sequence[float] | None,
        pace: Sequence[float] | None = None,
    ) -> None:
        """Append a segment, and let the path go on into it from the one before.

        ``motion``: ``rows.FEED_MOTION`` with ``feed_v``, mm/s, or ``rows.RAPID_MOTION``.
        ``deviation``: how far the path may pass its target, 0 not at all. ``limits_jerk``: the
        slope is an S-curve; the path stops where the slope changes. ``arc``: first and second axis
        of the plane, centre, angle in degrees. ``pace``: the columns of a segment from
        ``rows.SPEED_OVERRIDE`` on; the override in it counts in its speed from here on.
        """
        base = self.next_row()
        self.begin_segment(base, source, number, motion, exact_stop, limits_jerk)
        self.queue[base + rows.SPEED] = feed_v
        self.queue[base + rows.DEVIATION] = deviation
        first = base + rows.START
        for i in range(self.path.count):
            self.queue[first + i] = start[i]
            self.queue[first + self.path.count + i] = target[i]
        if arc is not None:
            self.queue[base + rows.SHAPE] = rows.ARC
            for i in range(rows.ARC_WIDTH):
                self.queue[base + rows.ARC_FIRST_AXIS + i] = arc[i]
        if pace is not None:
            for i in range(rows.PACE_WIDTH):
                self.queue[base + rows.SPEED_OVERRIDE + i] = pace[i]
            self.queue[base + rows.SPEED] *= self.queue[base + rows.SPEED_OVERRIDE]
        if self.body.is_open:
            self.body.keep(self.queue, base)
        self.end_segment(base)

    def put_line(
        self,
        source: int,
        number: int,
        start: memoryview[float],
        target: memoryview[float],
        motion: int,
        feed_v: float,
        exact_stop: int,
        deviation: float,
        limits_jerk: int,
    ) -> None:
        """``put_segment`` of a line, without objects; there is room for it (``reserve``)."""
        base = self.tail % self.capacity * self.width
        self.begin_segment(base, source, number, motion, exact_stop, limits_jerk)
        self.queue[base + rows.SPEED] = feed_v
        self.queue[base + rows.DEVIATION] = deviation
        self.put_ends(base, start, target)
        self.end_segment(base)

    def put_arc(
        self,
        source: int,
        number: int,
        start: memoryview[float],
        target: memoryview[float],
        arc: memoryview[float],
        motion: int,
        feed_v: float,
        exact_stop: int,
        deviation: float,
        limits_jerk: int,
    ) -> None:
        """``put_segment`` of an arc, without objects; there is room for it (``reserve``)."""
        base = self.tail % self.capacity * self.width
        self.begin_segment(base, source, number, motion, exact_stop, limits_jerk)
        self.queue[base + rows.SPEED] = feed_v
        self.queue[base + rows.DEVIATION] = deviation
        self.put_ends(base, start, target)
        self.queue[base + rows.SHAPE] = rows.ARC
        for i in range(rows.ARC_WIDTH):
            self.queue[base + rows.ARC_FIRST_AXIS + i] = arc[i]
        self.end_segment(base)

    def begin_segment(
        self, base: int, source: int, number: int, motion: int, exact_stop: int, limits_jerk: int
    ) -> None:
        """The head of a segment, in a row that is otherwise empty."""
        for i in range(self.width):
            self.queue[base + i] = 0.0
        self.queue[base + rows.KIND] = rows.SEGMENT
        self.queue[base + rows.SOURCE] = source
        self.queue[base + rows.BLOCK_NUMBER] = number
        self.queue[base + rows.MOTION] = motion
        self.queue[base + rows.EXACT_STOP] = exact_stop
        self.queue[base + rows.HAS_JERK_LIMIT] = limits_jerk

    def put_ends(self, base: int, start: memoryview[float], target: memoryview[float]) -> None:
        """Where a segment begins and ends."""
        first = base + rows.START
        for i in range(self.path.count):
            self.queue[first + i] = start[i]
            self.queue[first + self.path.count + i] = target[i]

    def end_segment(self, base: int) -> None:
        """The segment stands in its row: it counts, and is prepared."""
        self.tail += 1
        self.timed_count += 1
        exact_stop = self.queue[base + rows.EXACT_STOP] > 0.0
        self.prepare(base)
        self.latest = -1 if exact_stop else self.tail - 1

    def block_goes_on(self) -> None:
        """The latest segment, without exact stop, and the one behind it are one block."""
        base = (self.tail - 1) % self.capacity * self.width
        self.queue[base + rows.CONTINUES] = 1.0

    def prepare(self, base: int) -> None:
        """Limits of the latest segment and the speeds of those before it."""
        self.ahead.measure(self.queue, base)
        if self.queue[base + rows.MOTION] == rows.RAPID_MOTION:
            if self.queue[base + rows.SPEED_OVERRIDE] > 0.0:
                self.queue[base + rows.SPEED] *= self.queue[base + rows.SPEED_OVERRIDE]
        length = self.queue[base + rows.LENGTH]
        oldest = max(self.head, self.begun + 1)
        if self.latest >= oldest and self.is_like(self.latest, base):
            before = self.latest % self.capacity * self.width
            back = self.tail - 1 - self.latest
            if self.ahead.round_smoothly(self.queue, before, base, back):
                base = self.insert_bend(oldest)
            else:
                self.connect(back, oldest)
        self.ahead.leave(self.queue, base, length)

    def connect(self, back: int, oldest: int) -> None:
        """Let the path go on into the latest segment from the one ``back`` commands before it."""
        promised_v = -1.0
        promised_free_v = -1.0
        if self.path.is_active:
            promised_v = self.path.promised_speed(rows.END_SPEED)
            promised_free_v = self.path.promised_speed(rows.FREE_END_SPEED)
        self.ahead.connect(self.queue, self.tail - 1, back, oldest, promised_v, promised_free_v)

    def insert_bend(self, oldest: int) -> int:
        """Put the bend that was made behind ``latest``: where the latest segment begins then.

        If it would break the promise to the current segment, the path stops at the corner.
        """
        for number in range(self.tail - 1, self.latest, -1):
            self.copy_row(number, number + 1)
        self.tail += 1
        bend = (self.latest + 1) % self.capacity * self.width
        base = (self.tail - 1) % self.capacity * self.width
        for i in range(self.width):
            self.queue[bend + i] = self.ahead.bend_row[i]
        if self.ahead.spread_smoothly(self.queue, self.tail - 1, oldest, self.path.is_active):
            return base
        for number in range(self.latest + 1, self.tail - 1):
            self.copy_row(number + 1, number)
        self.tail -= 1
        before = self.latest % self.capacity * self.width
        base = (self.tail - 1) % self.capacity * self.width
        for i in range(self.width):
            self.queue[base + i] = self.ahead.spare[i]
            self.queue[before + i] = self.ahead.spare[self.width + i]
        self.ahead.spread_smoothly(self.queue, self.tail - 1, oldest, 0)
        return base

    def copy_row(self, number: int, to: int) -> None:
        """Copy a command to another place of the queue."""
        base = number % self.capacity * self.width
        target = to % self.capacity * self.width
        for i in range(self.width):
            self.queue[target + i] = self.queue[base + i]

    def is_like(self, number: int, base: int) -> int:
        """Whether two segments have one kind of slope: the path stops between different ones."""
        before = number % self.capacity * self.width
        limits_jerk = self.queue[base + rows.JERK] > 0.0
        return 1 if limits_jerk == (self.queue[before + rows.JERK] > 0.0) else 0

    def next_row(self) -> int:
        """Where the next command of the queue begins; there is room for a bend in front of it."""
        if self.tail - self.head + 1 >= self.capacity:
            self.grow()
        return self.tail % self.capacity * self.width

    def reserve(self, count: int) -> None:
        """Room for so many commands that take time in all, each with a bend, and one more."""
        while self.capacity <= 2 * count + self.tail - self.head - self.timed_count:
            self.grow()

    def grow(self) -> None:
        """Double the queue: many commands without motion stand in a row."""
        rows = [self.row(n) for n in range(self.head, self.tail)]
        self.capacity *= 2
        self.ahead.capacity = self.capacity
        self.queue = memoryview(bytearray(8 * self.width * self.capacity)).cast("d")
        self.begun = max(self.begun - self.head, -1)
        self.latest = max(self.latest - self.head, -1)
        self.head = 0
        self.tail = len(rows)
        for n, row in enumerate(rows):
            for i, number in enumerate(row):
                self.queue[n * self.width + i] = number

    def row(self, number: int) -> list[float]:
        """The command with this running number."""
        check_range(number, self.head, self.tail - 1, "command")
        base = number % self.capacity * self.width
        return [self.queue[base + i] for i in range(self.width)]

    def queued(self) -> int:
        """How many commands wait."""
        return self.tail - self.head

    def passes(self, kind: int) -> int:
        """Whether the path passes a command of this kind between two blocks without a stop."""
        if kind in (
            rows.SEGMENT,
            rows.DEFINE_CYCLE,
            rows.CONTROL_CYCLE,
            rows.TECHNOLOGY,
            rows.WRITE_VARIABLE,
            rows.WRITE_TEXT,
            rows.MESSAGE,
            rows.USER_ERROR,
            rows.USER_VALUE,
            rows.USER_TEXT,
            rows.SPINDLE,
            rows.BLOCK_MARK,
            rows.WAIT_MARK,
            rows.TIMER,
            rows.SET_OFFSET,
            rows.SET_ORIGIN,
            rows.SET_TURN,
            rows.FREEZE,
            rows.LOOP_PASS,
            rows.CLEAR_HISTORY,
        ):
            return 1
        return 0

    def needs_pass(self) -> int:
        """Whether a path that does not slow down for the loop's end needs another pass by now.

        At least one segment behind the next one has to be there, and the way to brake on.
        """
        if not self.body.is_complete or self.body.stops:
            return 0
        count = 0
        way = 0.0
        need = 0.0
        position = max(self.head, self.begun + 1)
        while position < self.tail:
            base = position % self.capacity * self.width
            if self.queue[base + rows.KIND] == rows.SEGMENT:
                count += 1
                way += self.queue[base + rows.LENGTH]
                need = max(need, self.brake_way_in(base))
                if count > 1 and way >= need:
                    return 0
            position += 1
        return 1 if self.tail - self.head + 2 * self.body.count < self.capacity else 0

    def brake_way_in(self, base: int) -> float:
        """How far the path brakes from a segment's highest speed, with three ticks more."""
        fastest_v = self.queue[base + rows.SPEED] * self.ahead.most_factor
        speed = min(fastest_v, self.queue[base + rows.MAX_SPEED])
        acceleration = self.queue[base + rows.ACCELERATION]
        way = speed * (0.5 * speed / acceleration + 3.0 * self.path.cycle_time_t)
        if self.queue[base + rows.JERK] > 0.0:
            way += speed * acceleration / self.queue[base + rows.JERK]
        return way

    def repeat_body(self) -> None:
        """Put the body in again, in front of the loop's end, which is the last command."""
        end = (self.tail - 1) % self.capacity * self.width
        for i in range(self.width):
            self.end_row[i] = self.queue[end + i]
        self.tail -= 1
        for k in range(self.body.count):
            base = self.tail % self.capacity * self.width
            kept = k * self.width
            for i in range(self.width):
                self.queue[base + i] = self.body.rows[kept + i]
            if self.queue[base + rows.KIND] == rows.SEGMENT:
                self.end_segment(base)
            else:
                self.tail += 1
        base = self.tail % self.capacity * self.width
        for i in range(self.width):
            self.queue[base + i] = self.end_row[i]
        self.tail += 1

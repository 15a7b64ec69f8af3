# SPDX-License-Identifier: MIT
"""The commands that wait for a channel: a ring buffer of rows of float64.

A command (``decoder/state/queued/packing.py`` packs it) is a row (``rows.py``). A segment is
prepared as it comes, so that those before it may go faster. Commands that take time are counted
(``timed_count``); a rounding, which belongs to the segment before it, is not.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.kernel import codes, rows
from nctakt.kernel.base import bounds
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.path import geometry
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.path import Path
from nctakt.kernel.tick.loop_body import LoopBody


class CommandQueue:
    """Commands from ``head`` to ``tail``, running numbers; ``started``: the newest begun.

    ``last_segment``: the segment that the next one may continue, -1 if the path stops first;
    ``has_early``: functions may be queued that go out before the path comes to them;
    ``transformation``: the map of the segments to come, 0 for none.
    """

    def __init__(self, path: Path, look_ahead: LookAhead) -> None:
        self.path = path
        self.look_ahead = look_ahead
        self.width = path.width
        self.capacity = 256
        look_ahead.resize(self.capacity)
        self.path.arc.share(self.look_ahead.limits.listed_v, self.look_ahead.limits.listed_a)
        self.look_ahead.limits.transformed.share(self.path.axes.transformations)
        self.rows = doubles(self.width * self.capacity)
        self.head = 0
        self.tail = 0
        self.timed_count = 0
        self.started = -1
        self.last_segment = -1
        self.transformation = 0
        self.loop_body = LoopBody(self.width)
        self.has_early = False
        self.end_row = doubles(self.width)

    def used_rows(self) -> tuple[memoryview[float], int]:
        """Return the rows, and how many of their cells count: those that were ever written.

        The first row after them counts, too: it may be read while the queue is empty.
        """
        count = self.tail + 1 if self.tail < self.capacity else self.capacity
        return self.rows, count * self.width

    def put(self, command: list[float]) -> None:
        """Append a command; the row may be shorter than the queue's width."""
        bounds.check_range(len(command), 1, self.width, "length of a command")
        row = self.next_row()
        for i, number in enumerate(command):
            self.rows[row + i] = number
        for i in range(len(command), self.width):
            self.rows[row + i] = 0.0
        self.tail += 1
        kind = int(command[rows.KIND])
        if kind == rows.SET_TRANSFORMATION:
            if self.transformation == 0:
                axes = self.path.axes.command
                self.look_ahead.limits.transformed.start_at(axes, self.path.members)
            self.transformation = int(command[rows.TRANSFORMATION_OF_SEGMENTS])
            self.look_ahead.limits.transformed.transform(self.transformation)
        if rows.is_timed(kind):
            self.timed_count += 1
        if not rows.is_transparent(kind):
            self.last_segment = -1
        self.note_early(row)
        if self.loop_body.is_open:
            self.loop_body.append(self.rows, row)

    def note_early(self, row: int) -> None:
        """Note whether a command is a function that goes out before the path comes to it."""
        if self.rows[row + rows.KIND] == rows.TECHNOLOGY:
            self.has_early = self.has_early or self.rows[row + rows.TECHNOLOGY_LEAD] > 0.0

    def last_source(self) -> int:
        """Return where in the program's text the newest command with a place comes from, else 0."""
        for number in range(self.tail - 1, max(-1, self.tail - 1 - self.capacity), -1):
            source = int(self.rows[number % self.capacity * self.width + rows.SOURCE])
            if source:
                return source
        return 0

    def begin_loop(self, command: list[float]) -> None:
        """Append the start of a realtime loop; everything up to its end is its body."""
        self.put(command)
        self.loop_body.begin()

    def end_loop(self, command: list[float]) -> None:
        """Append the end of a realtime loop, where the path continues into another pass."""
        last_segment = self.last_segment
        self.loop_body.end(self.path.count, last_segment < 0)
        self.put(command)
        self.last_segment = last_segment
        while self.capacity < 8 * (self.loop_body.count + 2) + self.look_ahead.blocks:
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
        feed_modifiers: Sequence[float] | None = None,
        curve: Sequence[float] | None = None,
    ) -> None:
        """Append a segment, and let the path continue into it from the one before.

        ``motion``: ``rows.FEED_MOTION`` with ``feed_v``, mm/s, or ``rows.RAPID_MOTION``.
        ``deviation``: how far the path may pass its target, 0 not at all. ``limits_jerk``: the
        slope is an S-curve; the path stops where the slope changes. ``arc``: first and second axis
        of the plane, centre, angle in degrees. ``feed_modifiers``: the columns of a segment from
        ``rows.SPEED_OVERRIDE`` on, whose override counts in its speed from here on; then, if given,
        the speed at its end, 0: as the next segment. ``curve``: the inner control points of a
        cubic, all first ones, then all second ones.
        """
        row = self.next_row()
        self.begin_segment(row, source, number, motion, exact_stop, limits_jerk)
        self.rows[row + rows.SPEED] = feed_v
        self.rows[row + rows.DEVIATION] = deviation
        first = row + rows.START
        for i in range(self.path.count):
            self.rows[first + i] = start[i]
            self.rows[first + self.path.count + i] = target[i]
        if arc is not None:
            self.rows[row + rows.SHAPE] = rows.ARC
            for i in range(rows.ARC_WIDTH):
                self.rows[row + rows.ARC_FIRST_AXIS + i] = arc[i]
        if curve is not None:
            self.rows[row + rows.SHAPE] = rows.CUBIC
            first += 2 * self.path.count
            for i in range(2 * self.path.count):
                self.rows[first + i] = curve[i]
        if feed_modifiers is not None:
            for i in range(rows.FEED_MODIFIER_WIDTH):
                self.rows[row + rows.SPEED_OVERRIDE + i] = feed_modifiers[i]
            self.rows[row + rows.SPEED] *= self.rows[row + rows.SPEED_OVERRIDE]
            if len(feed_modifiers) > rows.FEED_MODIFIER_WIDTH:
                self.rows[row + rows.NEXT_SPEED] = feed_modifiers[rows.FEED_MODIFIER_WIDTH]
        if self.loop_body.is_open:
            self.loop_body.append(self.rows, row)
        self.end_segment(row)

    def put_mark(self, source: int, number: int, decoded_tick: int, calls: int, depth: int) -> None:
        """``put`` of a mark where a block begins, without objects."""
        row = self.next_row()
        for i in range(self.width):
            self.rows[row + i] = 0.0
        self.rows[row + rows.KIND] = rows.BLOCK_MARK
        self.rows[row + rows.SOURCE] = source
        self.rows[row + rows.BLOCK_NUMBER] = number
        self.rows[row + rows.MARK_TICK] = decoded_tick
        self.rows[row + rows.MARK_CALLS] = calls
        self.rows[row + rows.MARK_DEPTH] = depth
        self.tail += 1

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
        row = self.tail % self.capacity * self.width
        self.begin_segment(row, source, number, motion, exact_stop, limits_jerk)
        self.rows[row + rows.SPEED] = feed_v
        self.rows[row + rows.DEVIATION] = deviation
        self.put_ends(row, start, target)
        self.end_segment(row)

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
        row = self.tail % self.capacity * self.width
        self.begin_segment(row, source, number, motion, exact_stop, limits_jerk)
        self.rows[row + rows.SPEED] = feed_v
        self.rows[row + rows.DEVIATION] = deviation
        self.put_ends(row, start, target)
        self.rows[row + rows.SHAPE] = rows.ARC
        for i in range(rows.ARC_WIDTH):
            self.rows[row + rows.ARC_FIRST_AXIS + i] = arc[i]
        self.end_segment(row)

    def begin_segment(
        self, row: int, source: int, number: int, motion: int, exact_stop: int, limits_jerk: int
    ) -> None:
        """Write the head of a segment into its row, which is otherwise 0."""
        for i in range(self.width):
            self.rows[row + i] = 0.0
        self.rows[row + rows.KIND] = rows.SEGMENT
        self.rows[row + rows.SOURCE] = source
        self.rows[row + rows.BLOCK_NUMBER] = number
        self.rows[row + rows.MOTION] = motion
        self.rows[row + rows.EXACT_STOP] = exact_stop
        self.rows[row + rows.HAS_JERK_LIMIT] = limits_jerk
        self.rows[row + rows.TRANSFORMATION] = self.transformation

    def put_ends(self, row: int, start: memoryview[float], target: memoryview[float]) -> None:
        """Write the positions at start and end of a segment."""
        first = row + rows.START
        for i in range(self.path.count):
            self.rows[first + i] = start[i]
            self.rows[first + self.path.count + i] = target[i]

    def end_segment(self, row: int) -> None:
        """Count and prepare the segment that is in its row."""
        self.tail += 1
        self.timed_count += 1
        exact_stop = self.rows[row + rows.EXACT_STOP] > 0.0
        self.prepare(row)
        self.last_segment = -1 if exact_stop else self.tail - 1

    def continue_block(self) -> None:
        """Make the newest segment, without exact stop, and the next one one block."""
        row = (self.tail - 1) % self.capacity * self.width
        self.rows[row + rows.CONTINUES] = 1.0

    def prepare(self, row: int) -> None:
        """Prepare the newest segment: its limits, and the speeds of those before it."""
        self.look_ahead.measure(self.rows, row)
        if self.rows[row + rows.MOTION] == rows.RAPID_MOTION:
            if self.rows[row + rows.SPEED_OVERRIDE] > 0.0:
                self.rows[row + rows.SPEED] *= self.rows[row + rows.SPEED_OVERRIDE]
        length = self.rows[row + rows.LENGTH]
        oldest = max(self.head, self.started + 1)
        if self.last_segment >= oldest and self.has_same_slope(self.last_segment, row):
            if self.look_ahead.limits.has_changed:
                self.look_ahead.limits.use_stricter_limits()
                row = self.pass_into(row, oldest)
                self.look_ahead.limits.end_corner()
            else:
                row = self.pass_into(row, oldest)
        self.look_ahead.limits.has_changed = False
        self.look_ahead.corner.leave(self.rows, row, length)

    def pass_into(self, row: int, oldest: int) -> int:
        """Let the path pass the corner to the newest segment; return its row."""
        before = self.last_segment % self.capacity * self.width
        back = self.tail - 1 - self.last_segment
        if self.look_ahead.rounding.round(self.rows, before, row, back):
            return self.insert_rounding(oldest)
        self.connect(back, oldest)
        return row

    def connect(self, back: int, oldest: int) -> None:
        """Let the path continue into the newest segment from the one ``back`` rows before."""
        promised_v = -1.0
        promised_max_v = -1.0
        if self.path.is_active:
            promised_v = self.path.promised_speed(rows.END_SPEED)
            promised_max_v = self.path.promised_speed(rows.MAX_END_SPEED)
        self.look_ahead.connect(self.rows, self.tail - 1, back, oldest, promised_v, promised_max_v)

    def insert_rounding(self, oldest: int) -> int:
        """Insert the rounding after ``last_segment``; return the newest segment's row.

        If it would break the promise to the current segment, the path stops at the corner.
        """
        for number in range(self.tail - 1, self.last_segment, -1):
            self.copy_row(number, number + 1)
        self.tail += 1
        rounding = (self.last_segment + 1) % self.capacity * self.width
        row = (self.tail - 1) % self.capacity * self.width
        for i in range(self.width):
            self.rows[rounding + i] = self.look_ahead.rounding.row[i]
        if self.look_ahead.jerk.spread(self.rows, self.tail - 1, oldest, self.path.is_active):
            return row
        for number in range(self.last_segment + 1, self.tail - 1):
            self.copy_row(number + 1, number)
        self.tail -= 1
        before = self.last_segment % self.capacity * self.width
        row = (self.tail - 1) % self.capacity * self.width
        self.look_ahead.rounding.restore(self.rows, before, row)
        self.look_ahead.jerk.spread(self.rows, self.tail - 1, oldest, 0)
        return row

    def copy_row(self, number: int, to: int) -> None:
        """Copy a command to another row of the queue."""
        row = number % self.capacity * self.width
        target = to % self.capacity * self.width
        for i in range(self.width):
            self.rows[target + i] = self.rows[row + i]

    def has_same_slope(self, number: int, row: int) -> int:
        """Return whether two segments have one slope; else the path stops between them.

        It does so, too, where a thread begins or ends, and where a tap turns round.
        """
        before = number % self.capacity * self.width
        thread = self.rows[row + rows.THREAD]
        if thread != self.rows[before + rows.THREAD]:
            return 0
        if thread == rows.TAPPING:
            if self.rows[row + rows.THREAD_TURN] != self.rows[before + rows.THREAD_TURN]:
                return 0
        limits_jerk = self.rows[row + rows.JERK] > 0.0
        return 1 if limits_jerk == (self.rows[before + rows.JERK] > 0.0) else 0

    def has_thread(self, row: int) -> int:
        """Return whether the command at ``row`` is a segment coupled with a spindle."""
        if self.rows[row + rows.KIND] != rows.SEGMENT:
            return 0
        return 1 if self.rows[row + rows.THREAD] != rows.NO_THREAD else 0

    def next_row(self) -> int:
        """Row of the next command; there is room for a rounding before it."""
        if self.tail - self.head + 1 >= self.capacity:
            self.grow()
        return self.tail % self.capacity * self.width

    def reserve(self, count: int) -> None:
        """Make room for ``count`` commands that take time, each with a rounding, and one."""
        while self.capacity <= 2 * count + self.tail - self.head - self.timed_count:
            self.grow()

    def grow(self) -> None:
        """Double the queue, where many commands without motion come in a row."""
        commands = [self.command(n) for n in range(self.head, self.tail)]
        self.capacity *= 2
        self.look_ahead.resize(self.capacity)
        self.rows = doubles(self.width * self.capacity)
        self.started = max(self.started - self.head, -1)
        self.last_segment = max(self.last_segment - self.head, -1)
        self.head = 0
        self.tail = len(commands)
        for n, command in enumerate(commands):
            for i, number in enumerate(command):
                self.rows[n * self.width + i] = number

    def command(self, number: int) -> list[float]:
        """Command with this running number; raise ``ValueError`` if it is not queued."""
        bounds.check_range(number, self.head, self.tail - 1, "command")
        row = number % self.capacity * self.width
        return [self.rows[row + i] for i in range(self.width)]

    def queued(self) -> int:
        """Number of commands that wait."""
        return self.tail - self.head

    def segment_after(self, number: int) -> int:
        """Return the number of the segment into which the path continues after command ``number``.

        Below 0 it is the current one. ``codes.END_OF_QUEUE`` if the queue ends before,
        ``codes.STOPS_BETWEEN`` if something comes first that the path stops for.
        """
        position = number + 1
        if number < 0:
            position = max(self.head, self.started + 1)
        while position < self.tail:
            row = position % self.capacity * self.width
            kind = int(self.rows[row + rows.KIND])
            if kind == rows.SEGMENT:
                is_joined = self.rows[row + rows.PREDECESSOR] > 0.0
                return position if is_joined else codes.STOPS_BETWEEN
            if not rows.is_transparent(kind):
                return codes.STOPS_BETWEEN
            position += 1
        return codes.END_OF_QUEUE

    def entry_speed_of(self, number: int) -> float:
        """Return the highest speed at the start of a queued segment, from that at its end.

        Raises ``ValueError`` if it is not queued.
        """
        bounds.check_range(number, self.head, self.tail - 1, "segment")
        row = number % self.capacity * self.width
        return self.look_ahead.feed_entry_speed(self.rows, row, self.rows[row + rows.END_SPEED])

    def needs_pass(self) -> int:
        """Return whether a path that passes the loop's end needs another pass by now.

        At least one segment after the next one must be there, and enough distance to brake on.
        """
        if not self.loop_body.is_complete or self.loop_body.ends_at_standstill:
            return 0
        count = 0
        length = 0.0
        needed = 0.0
        position = max(self.head, self.started + 1)
        while position < self.tail:
            row = position % self.capacity * self.width
            if self.rows[row + rows.KIND] == rows.SEGMENT:
                count += 1
                length += self.rows[row + rows.LENGTH]
                needed = max(needed, self.braking_distance_in(row))
                if count > 1 and length >= needed:
                    return 0
            position += 1
        return 1 if self.tail - self.head + 2 * self.loop_body.count < self.capacity else 0

    def braking_distance_in(self, row: int) -> float:
        """Braking distance in mm from a segment's highest speed, three ticks included."""
        fastest_v = self.rows[row + rows.SPEED] * self.look_ahead.limits.max_factor
        speed = min(fastest_v, self.rows[row + rows.MAX_SPEED])
        acceleration = self.rows[row + rows.ACCELERATION]
        length = speed * (0.5 * speed / acceleration + 3.0 * self.path.cycle_time_t)
        if self.rows[row + rows.JERK] > 0.0:
            length += speed * acceleration / self.rows[row + rows.JERK]
        return length

    def repeat_body(self) -> None:
        """Insert the body again before the loop's end, which is the last command."""
        end = (self.tail - 1) % self.capacity * self.width
        for i in range(self.width):
            self.end_row[i] = self.rows[end + i]
        self.tail -= 1
        for k in range(self.loop_body.count):
            row = self.tail % self.capacity * self.width
            kept = k * self.width
            for i in range(self.width):
                self.rows[row + i] = self.loop_body.rows[kept + i]
            if self.rows[row + rows.KIND] == rows.SEGMENT:
                self.end_segment(row)
            else:
                self.tail += 1
                self.timed_count += self.time_units(row)
                self.note_early(row)
        row = self.tail % self.capacity * self.width
        for i in range(self.width):
            self.rows[row + i] = self.end_row[i]
        self.tail += 1

    def head_row(self) -> int:
        """Return the row of the command at the head of the queue."""
        return self.head % self.capacity * self.width

    def time_units(self, row: int) -> int:
        """Number of commands that take time: 1 of a segment, dwell or ``#WAIT SYN``, else 0."""
        if self.rows[row + rows.KIND] == rows.SEGMENT:
            return 0 if self.rows[row + rows.SHAPE] == rows.ROUNDING else 1
        kind = int(self.rows[row + rows.KIND])
        return 1 if kind in (rows.DWELL, rows.AWAIT_SIGNAL) else 0

    def remaining_of_block(self, position: int) -> float:
        """Remaining length or end speed of a block for ``Path.set_remaining``; 0 if unknown."""
        last = position
        while self.block_continues(last):
            last += 1
            if last >= self.tail:
                return 0.0
        remaining = 0.0
        while last > position:
            row = last % self.capacity * self.width
            if self.rows[row + rows.JERK] > 0.0:
                remaining += geometry.total_length(self.rows, row)
            else:
                limit_v = self.rows[row + rows.MAX_SPEED]
                remaining = self.look_ahead.entry_speed(self.rows, row, remaining, limit_v)
            last -= 1
        return remaining

    def block_continues(self, position: int) -> int:
        """Return whether a command is a segment whose block continues with the next one."""
        row = position % self.capacity * self.width
        if self.rows[row + rows.KIND] != rows.SEGMENT:
            return 0
        return 1 if self.rows[row + rows.CONTINUES] > 0.0 else 0

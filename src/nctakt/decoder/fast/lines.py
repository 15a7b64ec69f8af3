# SPDX-License-Identifier: MIT
"""Plain blocks -> lines in the channel's queue, without objects in between.

In: lines, and the modal state as numbers (``handover.py`` exports and imports it). Out: rows of the
queue, equal to the bit to those of the tree (``block_decoder.py``, ``path_motion.py``). Lines with
mistakes or other effects are left to the tree.
"""

from __future__ import annotations

from nctakt.decoder.fast.compensated_lines import CompensatedLines
from nctakt.decoder.kinematics.transformed_travel import TransformedTravel
from nctakt.kernel import rows
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.nc.fast.plain_lines import PlainScanner
from nctakt.nc.vocabulary.functions import RAPID


class PlainLines:
    """Decodes plain blocks of one channel.

    Modal state: ``motion`` 0 … 3, ``feed_v`` mm/s, 0 before the first F, ``is_absolute``;
    ``feed_factor``: F -> mm per minute; the ends of blocks. ``source_base``: the source number of
    line 0, column 0, -1 for a text without source numbers. ``blocks``: the number of blocks since
    the last one that takes time, ``max_blocks``: its maximum. ``block_number``: the last N.
    ``is_transformed``: the positions are transformed; ``axis_check`` checks the limits of the axes
    then. ``leaves_last``: a motion that no plain one follows at once is left to the tree;
    ``leaves_functions``: one that M or H functions or an arc may follow. ``marks``: each block is
    marked in the queue, with ``tick``, ``calls`` and ``depth``, unless it changes the functions in
    force; ``source``: where the latest block begins.
    """

    def __init__(
        self,
        scanner: PlainScanner,
        count: int,
        compensated: CompensatedLines,
        axis_check: TransformedTravel,
    ) -> None:
        self.scanner = scanner
        self.compensated = compensated
        self.axis_check = axis_check
        self.is_transformed = False
        self.leaves_last = False
        self.leaves_functions = False
        self.marks = False
        self.tick = 0
        self.calls = 0
        self.depth = 0
        self.count = count
        size = max(1, count)
        #: Where the axes are; where the latest block begins and ends: mm or degrees.
        self.positions = doubles(size)
        self.start = doubles(size)
        self.target = doubles(size)
        #: Of each axis: zero of absolute positions, mm or degrees per unit, software limits.
        self.offsets = doubles(size)
        self.factors = doubles(size)
        self.lows = doubles(size)
        self.highs = doubles(size)
        self.motion = RAPID
        self.rapid = RAPID
        self.feed_v = 0.0
        self.feed_factor = 1.0
        self.is_absolute = True
        self.stops_exactly = False
        self.rapid_stops_exactly = False
        self.deviation = 0.0
        self.limits_jerk = False
        self.source_base = 0
        self.blocks = 0
        self.max_blocks = 0
        self.source = 0
        self.is_block = False
        self.block_number = 0

    def set_axis(
        self, axis: int, position: float, offset: float, factor: float, low: float, high: float
    ) -> None:
        """Set position, zero of absolute positions, unit and software limits of an axis."""
        self.positions[axis] = position
        self.offsets[axis] = offset
        self.factors[axis] = factor
        self.lows[axis] = low
        self.highs[axis] = high

    def axis_positions(self) -> list[float]:
        """Return the positions of the axes in mm or degrees."""
        return [self.positions[i] for i in range(self.count)]

    def fill(
        self, queue: CommandQueue, timed: int, lines: list[str], index: int, number: int
    ) -> int:
        """Fill the queue with up to ``timed`` commands that take time, from ``lines[index]`` on.

        ``number``: the line number of ``lines[index]``. Return the index of the first line not
        decoded. The queue must have room.
        """
        end = len(lines)
        while index < end and queue.timed_count < timed:
            if self.is_left(lines, index):
                return index
            what = self.decode(lines[index], number)
            if what == 0:
                return index
            index += 1
            number += 1
            if self.marks and self.is_block:
                queue.put_mark(self.source, self.scanner.number, self.tick, self.calls, self.depth)
            if what == 2:
                is_rapid = self.motion == self.rapid
                motion = rows.RAPID_MOTION if is_rapid else rows.FEED_MOTION
                feed_v = 0.0 if is_rapid else self.feed_v
                stops = self.stops_exactly or (is_rapid and self.rapid_stops_exactly)
                if self.compensated.is_on:
                    self.compensated.set_next(
                        self.source, self.scanner.number, self.target, motion, feed_v, stops
                    )
                    if not self.compensated.emit(queue, timed):
                        return index
                else:
                    queue.put_line(
                        self.source,
                        self.scanner.number,
                        self.start,
                        self.target,
                        motion,
                        feed_v,
                        stops,
                        0.0 if stops else self.deviation,
                        self.limits_jerk,
                    )
        return index

    def is_left(self, lines: list[str], index: int) -> bool:
        """Return whether ``lines[index]`` is left to the tree because of its successor."""
        if self.leaves_last:
            return self.is_followed(lines, index) == 0
        if self.leaves_functions and (
            index + 1 == len(lines) or self.may_output(lines[index + 1]) != 0
        ):
            return self.is_followed(lines, index) == 0
        return False

    def may_output(self, line: str) -> int:
        """Return whether a line may output functions, or be an arc that a curve joins."""
        begins = 0
        is_function = 0
        for character in line:
            if character in "MHSmhs":
                return 1
            if character == "G":
                is_function = 1
            elif is_function == 1 and character != "0":
                if character in "23" and not self.limits_jerk:
                    return 1
                is_function = 0
            if begins == 0 and character != " ":
                if character not in "NGXYZ":
                    return 1
                begins = 1
        return 1 - begins

    def is_followed(self, lines: list[str], index: int) -> int:
        """Return whether ``lines[index]`` moves, and the next line that is not empty moves on.

        An empty line counts as well.
        """
        scanner = self.scanner
        end = len(lines)
        what = scanner.read(lines[index])
        if what != 2:
            return what
        if scanner.axes == 0 or self.set_target() != 1:
            return 0
        index += 1
        what = 1
        while index < end and what == 1:
            what = scanner.read(lines[index])
            index += 1
        if what != 2:
            return 0
        for i in range(self.count):
            if scanner.axes >> i & 1:
                position = self.target[i]
                begin = self.offsets[i] if self.is_absolute else position
                if begin + scanner.values[i] * self.factors[i] != position:
                    return 1
        return 0

    def resume(self, queue: CommandQueue, timed: int) -> bool:
        """Continue with the pieces of a line that did not fit; return whether all fit now."""
        return not self.compensated.has_next or self.compensated.emit(queue, timed) != 0

    def decode(self, line: str, number: int) -> int:
        """Decode a line: return 0 if not accepted, 1 if nothing moves, 2 if a line is due."""
        scanner = self.scanner
        what = scanner.read(line)
        self.is_block = what == 2
        if what != 2:
            return what
        if self.blocks >= self.max_blocks:
            return 0
        motion = self.motion if scanner.motion < 0 else scanner.motion
        if self.marks and motion != self.motion:
            return 0
        feed_v = self.feed_v
        if scanner.has_feed:
            feed_v = scanner.feed * self.feed_factor / 60.0
        moves = 0
        if scanner.axes != 0:
            moves = self.set_target()
            if moves < 0 or scanner.motions[motion] == 0:
                return 0
            if moves == 1 and motion != self.rapid and feed_v <= 0.0:
                return 0
            if self.is_transformed and moves == 1:
                if self.axis_check.first_outside_of_line(self.positions, self.target) >= 0:
                    return 0
            if self.compensated.is_on and moves == 1 and not self.try_join(motion):
                return 0
            for i in range(self.count):
                self.start[i] = self.positions[i]
                self.positions[i] = self.target[i]
        self.motion = motion
        self.feed_v = feed_v
        if scanner.number > 0:
            self.block_number = scanner.number
        self.blocks += 1
        self.source = 0
        if self.source_base >= 0:
            self.source = self.source_base + min(number, 16777215) * 1048576 + scanner.column
        if moves == 0:
            return 1
        self.blocks = 0
        return 2

    def try_join(self, motion: int) -> int:
        """Return whether the tool can follow the scanned block without a message."""
        return self.compensated.try_join(
            self.positions, self.target, self.lows, self.highs, motion != self.rapid
        )

    def set_target(self) -> int:
        """Set the target of the scanned block: return 1 if it moves, 0 if not, -1 outside
        limits.
        """
        scanner = self.scanner
        moves = 0
        for i in range(self.count):
            position = self.positions[i]
            if scanner.axes >> i & 1:
                begin = self.offsets[i] if self.is_absolute else position
                target = begin + scanner.values[i] * self.factors[i]
                if not self.lows[i] <= target <= self.highs[i]:
                    return -1
                if target != position:
                    moves = 1
                position = target
            self.target[i] = position
        return moves

# SPDX-License-Identifier: MIT
"""The pieces of the tool's way one behind the other, and where it crosses itself (MO-9).

Each new piece is compared with those of the last motions, and a crossing is told; or (``masks``)
the loop that it closes is left out, with the motions in it. A loop that is left out is kept as long
as the way may lead back behind it.
"""

from __future__ import annotations

from nctakt.decoder.contour import pieces
from nctakt.decoder.contour.pieces import Crossing

#: So many motions before a new one its way is compared with; of so many (``masks``) the way waits.
REACH = 50

#: Pieces that there is room for: of two reaches, with all that can join two motions, and as many
#: of loops that were left out, each one with a row behind it (of kind 3).
_ROOM = 1024

#: What ``take`` gives: 0 nothing more of the motion, a line, an arc, the motion does not fit.
NOTHING, LINE, ARC, GAP = range(4)


class Chain:
    """The pieces of one way.

    ``side``: where the tool is, 1 left, -1 right of the contour. ``number``: of the latest motion,
    counted from 1. ``crossed``: the motion whose way that of ``crossing`` crosses, 0 none.
    """

    def __init__(self) -> None:
        self.crossings = Crossing()
        self.rows = memoryview(bytearray(8 * 2 * _ROOM * pieces.WIDTH)).cast("d")
        self.hidden = memoryview(bytearray(8 * 64 * 4)).cast("d")
        self.hidden_count = 0
        self.left = 0
        self.count = 0
        self.out = 0
        self.barrier = 0
        self.number = 0
        self.side = 1.0
        self.masks = False
        self.crossed = 0
        self.crossing = 0

    def count_motion(self) -> None:
        """There is one more motion."""
        self.number += 1

    def separate(self) -> None:
        """Compare nothing that comes with what was."""
        self.barrier = self.count
        self.left = 0
        self.hidden_count = 0

    def import_from(self, count: int, barrier: int) -> None:
        """Let all be as it was with so many pieces, where nothing was crossed."""
        self.count = count
        self.barrier = barrier
        self.crossed = 0

    # --- pieces ----------------------------------------------------------------------------------

    def put_line(
        self, kind: int, x: float, y: float, x_2: float, y_2: float, is_contour: int
    ) -> None:
        """One more line of the latest motion."""
        self.make_room()
        pieces.put_line(self.rows, self.count * 16, kind, x, y, x_2, y_2)
        self.put(is_contour)

    def put(self, is_contour: int) -> None:
        """The row behind the pieces is one more piece of the latest motion."""
        base = self.count * 16
        self.rows[base + 9] = self.number
        is_gap = self.rows[base + 4] == 2.0
        self.rows[base + 10] = 1.0 if is_contour and not is_gap else 0.0
        self.rows[base + 15] = 0.0
        pieces.bound(self.rows, base)
        self.count += 1
        if is_contour and not is_gap:
            self.compare()

    def make_room(self) -> None:
        """Forget the pieces that are neither compared nor waited for, if there are many."""
        if self.count < 500:
            return
        first = self.oldest(self.out)
        for i in range((self.count - first) * 16):
            self.rows[i] = self.rows[first * 16 + i]
        self.count -= first
        self.out -= first
        self.barrier = max(self.barrier - first, 0)

    def oldest(self, last: int) -> int:
        """The first piece up to ``last`` that is within reach of the latest motion."""
        first = last
        while first > self.barrier and self.rows[first * 16 - 7] >= self.number - 50:
            first -= 1
        return first

    # --- crossings -------------------------------------------------------------------------------

    def compare(self) -> None:
        """Find where the latest piece crosses earlier ones, and leave out the loops."""
        if self.masks:
            self.mask()
            return
        last = self.count - 1
        found = self.search(last, 0.0)
        if found >= 0:
            self.crossed = int(self.rows[found * 16 + 9])
            self.crossing = self.number
            self.barrier = last

    def mask(self) -> None:
        """Leave out the loops that the latest piece closes.

        It may lead back behind what was left out, so that a part of that is way after all.
        """
        room = 8
        while True:
            last = self.count - 1
            found = self.search(last, self.side)
            if found >= self.out and found >= 0:
                self.leave_out(found, last)
                continue
            found = self.search_loops(last)
            if found < 0 or room == 0 or not self.take_in(found, last):
                break
            room -= 1
        if found >= 0:
            self.rows[last * 16 + 15] = self.rows[found * 16 + 9]
        self.note(last)

    def note(self, last: int) -> None:
        """Note a crossing that closes no loop; one behind it may still leave out both."""
        found = self.search(last, 0.0)
        if found >= 0:
            self.rows[last * 16 + 15] = self.rows[found * 16 + 9]

    def search(self, last: int, wanted: float) -> int:
        """The newest piece that the latest one crosses in this sense; -1: none.

        So the smallest loop is found first.
        """
        rows = self.rows
        self.crossings.wanted = wanted
        base = last * 16
        one = last - 1
        if one >= 0 and rows[one * 16 + 4] != 2.0:
            one -= 1  # the way goes on from this one
        while one >= self.barrier and rows[one * 16 + 9] >= self.number - 50:
            if rows[one * 16 + 10] != 0.0 and not pieces.are_apart(rows, one * 16, base):
                if self.crossings.find(rows, one * 16, base):
                    return one
            one -= 1
        return -1

    def search_loops(self, last: int) -> int:
        """The piece of a loop behind which the latest piece leads; -1: none."""
        rows = self.rows
        self.crossings.wanted = -self.side
        base = last * 16
        one = 1024 + self.left - 1
        while one >= 1024:
            if rows[one * 16 + 10] != 0.0 and rows[one * 16 + 9] >= self.number - 50:
                if not pieces.are_apart(rows, one * 16, base):
                    if self.crossings.find(rows, one * 16, base):
                        return one
            one -= 1
        return -1

    def leave_out(self, first: int, last: int) -> None:
        """Leave out the loop between two pieces that cross, and the first one if nothing is left.

        The piece behind the loop keeps its end, so that it stays even where it has no length.
        """
        rows = self.rows
        x = self.crossings.x
        y = self.crossings.y
        self.keep_loop(first, last)
        pieces.cut_end(rows, first * 16, x, y)
        pieces.cut_start(rows, last * 16, x, y)
        if pieces.length(rows, first * 16) > 1e-9:
            first += 1
        self.copy(last, first)
        self.count = first + 1

    def keep_loop(self, first: int, last: int) -> None:
        """Keep the loop that is left out, and forget the oldest ones if there is no room."""
        while self.left + last - first + 2 > 1024:
            self.forget_loop(1024)
        at = 1024 + self.left
        for one in range(first, last + 1):
            self.copy(one, at)
            if one == first:
                pieces.cut_start(self.rows, at * 16, self.crossings.x, self.crossings.y)
            elif one == last:
                pieces.cut_end(self.rows, at * 16, self.crossings.x, self.crossings.y)
            at += 1
        self.rows[at * 16 + 4] = 3.0
        self.rows[at * 16 + 10] = 0.0
        self.left = at - 1023

    def forget_loop(self, first: int) -> None:
        """The loop that begins with this row is left out for good."""
        behind = self.end_of_loop(first) + 1
        for one in range(behind, 1024 + self.left):
            self.copy(one, first + one - behind)
        self.left -= behind - first

    def end_of_loop(self, one: int) -> int:
        """The row behind the last piece of a loop."""
        while self.rows[one * 16 + 4] != 3.0:
            one += 1
        return one

    def take_in(self, found: int, last: int) -> int:
        """Lead the way around a loop again from where the latest piece crosses it: 1 done.

        What of it is not way after all the rest of the latest piece will leave out.
        """
        rows = self.rows
        end = self.end_of_loop(found)
        first = found
        while first > 1024 and rows[first * 16 - 12] != 3.0:
            first -= 1
        rest = last + end - first + 2
        if rest > 1000:
            return 0
        x = self.crossings.x
        y = self.crossings.y
        self.copy(last, rest)
        pieces.cut_end(rows, last * 16, x, y)
        pieces.cut_start(rows, rest * 16, x, y)
        begin = last + 1 if pieces.length(rows, last * 16) > 1e-9 else last
        one = found
        for at in range(begin, begin + end - first + 1):
            self.copy(one, at)
            rows[at * 16 + 9] = self.number
            one = first if one == end - 1 else one + 1
        at = begin + end - first + 1
        pieces.cut_start(rows, begin * 16, x, y)
        pieces.cut_end(rows, (at - 1) * 16, x, y)
        self.copy(rest, at)
        self.count = at + 1
        self.forget_loop(first)
        return 1

    def copy(self, one: int, other: int) -> None:
        """Copy a row."""
        for i in range(16):
            self.rows[other * 16 + i] = self.rows[one * 16 + i]

    # --- what is taken ---------------------------------------------------------------------------

    def take(self, number: int) -> int:
        """Take the next piece of this motion, which is then told: ``NOTHING`` … ``GAP``."""
        if self.out >= self.count or self.rows[self.out * 16 + 9] != number:
            return 0
        kind = int(self.rows[self.out * 16 + 4])
        noted = self.rows[self.out * 16 + 15]
        if noted > 0.0:
            self.crossed = int(noted)
            self.crossing = number
            for one in range(self.out, self.count):
                self.rows[one * 16 + 15] = 0.0
        elif self.hidden_count > 0 and self.rows[self.out * 16 + 10] != 0.0:
            self.find_hidden()
        self.out += 1
        return kind + 1

    def hide(self, x: float, y: float, radius: float) -> None:
        """The latest motion, an arc that the tool does not fit into, begins or ends here.

        No way leads beside it, so that what is taken is compared with its ends; 64 are known.
        """
        at = self.hidden_count % 64 * 4
        self.hidden[at] = x
        self.hidden[at + 1] = y
        self.hidden[at + 2] = radius
        self.hidden[at + 3] = self.number
        self.hidden_count += 1

    def find_hidden(self) -> None:
        """Tell where the next piece comes too near to an end that no way leads beside.

        A thousandth of the radius is left to rounding: ends of arcs, and corners that are none.
        """
        base = self.out * 16
        number = self.rows[base + 9]
        for one in range(min(self.hidden_count, 64)):
            at = one * 4
            if number - 50 <= self.hidden[at + 3] <= number + 50:
                off = pieces.distance(self.rows, base, self.hidden[at], self.hidden[at + 1])
                if off < 0.999 * self.hidden[at + 2]:
                    self.crossed = int(self.hidden[at + 3])
                    self.crossing = int(number)
                    self.hidden[at + 2] = 0.0

    def goes_on(self, number: int) -> bool:
        """Whether there is one more piece of this motion."""
        return self.out < self.count and self.rows[self.out * 16 + 9] == number

    def taken(self) -> tuple[float, ...]:
        """Start, end, kind, centre and angle of the piece that was taken last."""
        base = (self.out - 1) * 16
        return tuple([self.rows[base + i] for i in range(8)])

    def taken_place(self) -> int:
        """Where the row of the piece begins that was taken last."""
        return (self.out - 1) * 16

    def taken_way(self) -> float:
        """Its length."""
        return pieces.length(self.rows, (self.out - 1) * 16)

# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""The way of the tool's centre beside a contour, motion by motion (MO-9).

In: motions of a plane in their order, each with the distance of the tool. Out: the pieces of each
motion: the way beside it and, around an outer corner, what joins it with the next one. So a motion
is known up to its end when the next one is there.

Where the way crosses itself the tool cuts what it has made or will make. Each new piece is compared
with those of the last motions, and a crossing is told; or (``masks``) the loop that it closes is
left out, with the motions in it. There, a motion that does not fit leaves a gap, which such a loop
takes away, or which is found when its motion is taken.
"""

from __future__ import annotations

from nctakt.decoder import pieces
from nctakt.decoder.corners import Corners
from nctakt.decoder.pieces import Crossing

#: So many motions before a new one its way is compared with; of so many (``masks``) the way waits.
REACH = 50

#: Pieces that there is room for: of two reaches, with all that can join two motions, and as many
#: of loops that were left out, each one with a row behind it (of kind 3).
_ROOM = 1024

#: What ``take`` gives: 0 nothing more of the motion, a line, an arc, the motion does not fit.
NOTHING, LINE, ARC, GAP = range(4)


class ToolPath:
    """The way of one contour.

    ``side``: where the tool is, 1 left, -1 right of the contour. ``number``: of the latest motion,
    counted from 1. ``is_open``: that one is not known up to its end. ``at_x``, ``at_y``: where the
    tool is behind the pieces so far. ``parts``: what comes behind the latest motion is not compared
    with what was. ``crossed``: the motion whose way that of ``crossing`` crosses,
    0 none.
    """

    def __init__(self) -> None:
        self.corners = Corners()
        self.crossings = Crossing()
        self.rows = memoryview(bytearray(8 * 2 * _ROOM * pieces.WIDTH)).cast("d")
        self.rest = memoryview(bytearray(8 * pieces.WIDTH)).cast("d")
        self.rest_number = 0
        self.left = 0
        self.count = 0
        self.out = 0
        self.barrier = 0
        self.number = 0
        self.is_open = False
        self.latest = 0
        self.side = 1.0
        self.masks = False
        self.parts = False
        self.at_x = 0.0
        self.at_y = 0.0
        self.crossed = 0
        self.crossing = 0

    def set_corners(self, by_arc: bool, is_direct: bool) -> None:
        """How the next corner is passed (``Corners``)."""
        self.corners.by_arc = by_arc
        self.corners.is_direct = is_direct

    # --- motions ---------------------------------------------------------------------------------

    def line(
        self,
        x: float,
        y: float,
        x_2: float,
        y_2: float,
        begin_d: float,
        end_d: float,
        is_contour: bool,
    ) -> None:
        """The next motion is a line; ``is_contour``: its way is compared with others."""
        at = 20 - self.latest
        self.corners.enter(at, x, y, x_2, y_2, begin_d, end_d)
        self.corners.motions[at + 18] = is_contour

    def arc(
        self,
        x: float,
        y: float,
        x_2: float,
        y_2: float,
        distance: float,
        centre_x: float,
        centre_y: float,
        angle: float,
    ) -> bool:
        """The next motion is an arc: false where its radius is not greater than the tool's."""
        at = 20 - self.latest
        motions = self.corners.motions
        motions[at] = x
        motions[at + 1] = y
        motions[at + 2] = x_2
        motions[at + 3] = y_2
        motions[at + 9] = distance
        motions[at + 10] = distance
        motions[at + 18] = 1.0
        self.corners.bend(at, centre_x, centre_y, angle)
        return motions[at + 17] == 0.0

    def begin(self, x: float, y: float, is_perpendicular: bool) -> None:
        """The motion is the first one: the tool is here; it may first go beside its start."""
        at = 20 - self.latest
        self.open(at)
        if is_perpendicular:
            self.corners.place_start(at)
            self.put_line(0, x, y, self.corners.next_x, self.corners.next_y, 0)
            x = self.corners.next_x
            y = self.corners.next_y
        self.corners.motions[at + 15] = x
        self.corners.motions[at + 16] = y
        self.at_x = x
        self.at_y = y

    def add(self) -> bool:
        """Join the motion with the one before it: false where that one does not fit."""
        at = 20 - self.latest
        meets = self.corners.join(self.latest, at)
        if not self.put_motion(meets, at):
            return False
        self.corners.motions[at + 15] = self.at_x
        self.corners.motions[at + 16] = self.at_y
        self.open(at)
        return True

    def try_add(self, low_x: float, high_x: float, low_y: float, high_y: float) -> bool:
        """Join the motion with the one before it if there is nothing to tell of that.

        False, and all is as it was: that one does not fit, or its way crosses another one, or it
        may come near to these bounds.
        """
        at = 20 - self.latest
        if not self.corners.join(self.latest, at):
            return False
        if not self.corners.is_within(self.latest, low_x, high_x, low_y, high_y):
            return False
        self.make_room()
        count = self.count
        barrier = self.barrier
        x = self.at_x
        y = self.at_y
        if self.put_motion(1, at) and self.crossed == 0:
            self.corners.motions[at + 15] = self.at_x
            self.corners.motions[at + 16] = self.at_y
            self.open(at)
            return True
        self.count = count
        self.barrier = barrier
        self.at_x = x
        self.at_y = y
        self.crossed = 0
        self.is_open = True
        return False

    def close(self, is_perpendicular: bool) -> bool:
        """The latest motion ends beside its end, or goes back from there to the contour."""
        self.corners.place_end(self.latest)
        if not self.put_motion(1, -1):
            return False
        if is_perpendicular:
            end_x = self.corners.motions[self.latest + 2]
            end_y = self.corners.motions[self.latest + 3]
            self.put_line(0, self.at_x, self.at_y, end_x, end_y, 0)
            self.at_x = end_x
            self.at_y = end_y
        return True

    def beside_end(self) -> tuple[float, float]:
        """Where the latest motion ends if nothing joins it."""
        self.corners.place_end(self.latest)
        return (self.corners.end_x, self.corners.end_y)

    def latest_fits(self) -> bool:
        """Whether the latest motion is no arc that is too small for the tool."""
        return self.corners.motions[self.latest + 17] == 0.0

    def give_up(self) -> None:
        """The latest motion is none."""
        self.is_open = False

    def open(self, at: int) -> None:
        """The motion in this row is the latest one."""
        self.latest = at
        self.number += 1
        self.is_open = True

    # --- pieces ----------------------------------------------------------------------------------

    def put_motion(self, meets: int, other: int) -> int:
        """The pieces of the latest motion up to its end: 0 it does not fit.

        ``other``: the motion that it has been joined with, -1 none.
        """
        corners = self.corners
        self.make_room()
        self.is_open = False
        at = self.latest
        is_contour = 1 if corners.motions[at + 18] != 0.0 else 0
        base = self.count * 16
        fits = corners.put_own(at, self.rows, base)
        if not self.masks and not (fits and meets):
            return 0
        if not fits:
            self.part(at, other, is_contour)
            base = self.count * 16
        if self.masks:
            self.keep_rest(at, other)
        if pieces.length(self.rows, base) > 0.0:
            self.put(is_contour)
        for k in range(corners.way_count):
            base = self.count * 16
            for i in range(9):
                self.rows[base + i] = corners.way[k * 16 + i]
            self.put(is_contour)
        self.at_x = corners.next_x
        self.at_y = corners.next_y
        if self.parts or not is_contour:
            self.barrier = self.count
            self.left = 0
            self.parts = False
        return 1

    def part(self, at: int, other: int, is_contour: int) -> None:
        """The latest motion does not fit between its neighbours: all three are passed whole.

        So the way of one neighbour crosses that of another one where they really meet. The way
        beside the latest motion is the row behind the pieces then, or a gap.
        """
        corners = self.corners
        if self.rest_number == self.number:
            base = self.count * 16
            for i in range(9):
                self.rows[base + i] = self.rest[i]
            x = self.rest[2]
            y = self.rest[3]
            self.put(is_contour)
            next_x = corners.next_x
            next_y = corners.next_y
            corners.place_start(at)
            corners.motions[at + 15] = corners.next_x
            corners.motions[at + 16] = corners.next_y
            self.put_line(2, x, y, corners.next_x, corners.next_y, is_contour)
            corners.next_x = next_x
            corners.next_y = next_y
        if other >= 0 and corners.meets_inside(at, other):
            corners.part(at, other)
        base = self.count * 16
        if not corners.put_own(at, self.rows, base):
            self.rows[base + 4] = 2.0

    def keep_rest(self, at: int, other: int) -> None:
        """Keep what the meeting with the next motion cuts off; that one may not fit."""
        if other >= 0 and self.corners.meets_inside(at, other):
            self.corners.put_rest(at, self.rest, 0)
            self.rest_number = self.number + 1

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
        self.out += 1
        return kind + 1

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

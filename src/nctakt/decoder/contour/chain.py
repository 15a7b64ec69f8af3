# SPDX-License-Identifier: MIT
"""The pieces of the tool's path one after the other, and where it crosses itself (MO-9).

Each new piece is compared with those of the last motions, and a crossing is reported; or
(``masks``) the loop that it closes is left out, with the motions in it. A loop that is left out is
kept as long as the path may lead back past it.
"""

from __future__ import annotations

from nctakt.decoder.contour import pieces, rows
from nctakt.decoder.contour.pieces import Crossing
from nctakt.kernel.base.arrays import doubles


class Chain:
    """Pieces of one tool path.

    ``side``: where the tool is, 1 left, -1 right of the contour. ``number``: of the newest motion,
    counted from 1. ``crossed``: the motion whose path that of ``crossing`` crosses, 0 none.
    ``crosses_lead``: one of both leads to the contour, or from it.
    ``leading``: the motion to the contour, whose pieces come after those of loops, 0 none.
    ``radius``: of the tool, mm.
    """

    def __init__(self) -> None:
        self.crossings = Crossing()
        count = 2 * rows.ROOM + rows.MAX_LEADING
        self.rows = doubles(count * rows.PIECE_WIDTH)
        self.hidden = doubles(rows.MAX_HIDDEN * rows.HIDDEN_WIDTH)
        self.hidden_count = 0
        self.left_out_count = 0
        self.count = 0
        self.taken_count = 0
        self.barrier = 0
        self.number = 0
        self.side = 1.0
        self.masks = False
        self.crossed = 0
        self.crossing = 0
        self.crosses_lead = False
        self.leading = 0
        self.leading_count = 0
        self.radius = 0.0

    def count_motion(self) -> None:
        """Count one more motion."""
        self.number += 1

    def separate(self) -> None:
        """Compare later pieces with nothing that was before."""
        self.barrier = self.count
        self.left_out_count = 0
        self.hidden_count = 0
        self.leading = 0

    def import_from(self, count: int, barrier: int) -> None:
        """Restore ``count`` pieces and their ``barrier``; none of them was crossed."""
        self.count = count
        self.barrier = barrier
        self.crossed = 0

    # --- pieces ----------------------------------------------------------------------------------

    def put_line(
        self, shape: int, x: float, y: float, x_2: float, y_2: float, is_contour: int
    ) -> None:
        """Append a line of the newest motion."""
        self.make_room()
        pieces.put_line(self.rows, self.count * rows.PIECE_WIDTH, shape, x, y, x_2, y_2)
        self.put(is_contour)

    def put(self, is_contour: int) -> None:
        """Append the row after the pieces as a piece of the newest motion."""
        row = self.count * rows.PIECE_WIDTH
        self.rows[row + rows.MOTION] = self.number
        is_gap = self.rows[row + rows.SHAPE] == rows.GAP
        self.rows[row + rows.IS_CONTOUR] = 1.0 if is_contour and not is_gap else 0.0
        self.rows[row + rows.CROSSED] = 0.0
        pieces.bound(self.rows, row)
        self.count += 1
        if is_contour and not is_gap:
            self.compare()

    def make_room(self) -> None:
        """Forget the pieces that are neither compared nor waited for, if there are many."""
        if self.count < rows.MANY:
            return
        first = self.oldest(self.taken_count)
        for i in range((self.count - first) * rows.PIECE_WIDTH):
            self.rows[i] = self.rows[first * rows.PIECE_WIDTH + i]
        self.count -= first
        self.taken_count -= first
        self.barrier = max(self.barrier - first, 0)

    def oldest(self, last: int) -> int:
        """Index of the first piece up to ``last`` that is near to the newest motion."""
        first = last
        before = last - 1
        while before >= self.barrier and self.is_near(before):
            first = before
            before -= 1
        return first

    def is_near(self, piece: int) -> int:
        """Return whether the newest motion may cross this piece."""
        motion = self.rows[piece * rows.PIECE_WIDTH + rows.MOTION]
        return 1 if motion >= self.number - rows.REACH else 0

    # --- crossings -------------------------------------------------------------------------------

    def compare(self) -> None:
        """Find where the newest piece crosses earlier ones, and leave out the loops."""
        if self.masks:
            self.mask()
            return
        last = self.count - 1
        crossed_piece = self.search(last, 0.0)
        if crossed_piece >= 0:
            self.crossed = int(self.rows[crossed_piece * rows.PIECE_WIDTH + rows.MOTION])
            self.crossing = self.number
            self.crosses_lead = False
            self.barrier = last
        elif self.leading > 0:
            self.compare_with_leading(last)

    # --- to the contour and from it --------------------------------------------------------------

    def lead(self) -> None:
        """Keep the pieces of the newest motion, which leads to the contour."""
        self.leading_count = 0
        piece = self.count - 1
        while piece >= 0 and self.rows[piece * rows.PIECE_WIDTH + rows.MOTION] == self.number:
            if self.leading_count < rows.MAX_LEADING:
                self.copy(piece, 2 * rows.ROOM + self.leading_count)
                self.leading_count += 1
            piece -= 1
        self.leading = self.number

    def compare_with_leading(self, last: int) -> None:
        """Find where the newest piece of the contour crosses the approach to the contour."""
        if self.number > self.leading + rows.REACH:
            self.leading = 0
            return
        if self.number == self.leading + 1:
            return  # next to which it ends
        row = last * rows.PIECE_WIDTH
        for k in range(self.leading_count):
            at = (2 * rows.ROOM + k) * rows.PIECE_WIDTH
            if self.enters(at, row, row):
                self.crossed = self.leading
                self.crossing = self.number
                self.crosses_lead = True
                self.leading = 0
                return

    def compare_leaving(self, last: int) -> None:
        """Find where the newest piece, which leads from the contour, crosses that."""
        row = last * rows.PIECE_WIDTH
        oldest = self.number - rows.REACH
        piece = pieces.overlapping(self.rows, last - 1, self.barrier, oldest, row)
        while piece >= 0:
            at = piece * rows.PIECE_WIDTH
            is_neighbour = self.rows[at + rows.MOTION] >= self.number - 1
            if not is_neighbour and self.enters(at, row, at):
                self.crossed = int(self.rows[at + rows.MOTION])
                self.crossing = self.number
                self.crosses_lead = True
                return
            piece = pieces.overlapping(self.rows, piece - 1, self.barrier, oldest, row)

    def enters(self, first: int, second: int, contour: int) -> int:
        """Return whether two pieces cross where one leads alongside the contour.

        Around corners, up to a radius from the ends, the path may be farther from it than that.
        """
        self.crossings.required_sense = 0.0
        if not self.crossings.find(self.rows, first, second):
            return 0
        if -1e-3 < self.crossings.sense < 1e-3:
            return 0
        x = self.crossings.x
        y = self.crossings.y
        along = self.crossings.distance_along(self.rows, contour, x, y)
        rest = pieces.length(self.rows, contour) - along
        return 1 if along > self.radius and rest > self.radius else 0

    # --- loops -----------------------------------------------------------------------------------

    def mask(self) -> None:
        """Leave out the loops that the newest piece closes.

        It may lead back past a part that was left out, so that some of that is path after all.
        """
        room = 8
        while True:
            last = self.count - 1
            crossed_piece = self.search(last, self.side)
            if crossed_piece >= self.taken_count and crossed_piece >= 0:
                self.leave_out(crossed_piece, last)
                continue
            crossed_piece = self.search_loops(last)
            if crossed_piece < 0 or room == 0 or not self.restore_loop(crossed_piece, last):
                break
            room -= 1
        if crossed_piece >= 0:
            self.cross(last, crossed_piece)
        self.note(last)

    def note(self, last: int) -> None:
        """Note a crossing that closes no loop; one after it may still leave out both."""
        crossed_piece = self.search(last, 0.0)
        if crossed_piece >= 0:
            self.cross(last, crossed_piece)

    def cross(self, last: int, crossed_piece: int) -> None:
        """Note that the newest piece crosses the motion of another one."""
        motion = self.rows[crossed_piece * rows.PIECE_WIDTH + rows.MOTION]
        self.rows[last * rows.PIECE_WIDTH + rows.CROSSED] = motion

    def search(self, last: int, required_sense: float) -> int:
        """Newest piece that the newest one crosses in this sense; -1 without one.

        So the smallest loop is found first.
        """
        self.crossings.required_sense = required_sense
        row = last * rows.PIECE_WIDTH
        oldest = self.number - rows.REACH
        piece = last - 1
        if piece >= 0 and self.rows[piece * rows.PIECE_WIDTH + rows.SHAPE] != rows.GAP:
            piece -= 1  # the path continues from this one
        piece = pieces.overlapping(self.rows, piece, self.barrier, oldest, row)
        while piece >= 0 and not self.crossings.find(self.rows, piece * rows.PIECE_WIDTH, row):
            piece = pieces.overlapping(self.rows, piece - 1, self.barrier, oldest, row)
        return piece

    def search_loops(self, last: int) -> int:
        """Piece of a loop past which the newest piece leads; -1 without one."""
        self.crossings.required_sense = -self.side
        row = last * rows.PIECE_WIDTH
        oldest = self.number - rows.REACH
        piece = rows.ROOM + self.left_out_count - 1
        while piece >= rows.ROOM:
            if pieces.overlapping(self.rows, piece, piece, oldest, row) == piece:
                if self.crossings.find(self.rows, piece * rows.PIECE_WIDTH, row):
                    return piece
            piece -= 1
        return -1

    def leave_out(self, first: int, last: int) -> None:
        """Leave out the loop between two pieces that cross, and the first one if nothing is left.

        The piece after the loop keeps its end, so that it stays even where it has no length.
        """
        table = self.rows
        x = self.crossings.x
        y = self.crossings.y
        self.keep_loop(first, last)
        pieces.cut_end(table, first * rows.PIECE_WIDTH, x, y)
        pieces.cut_start(table, last * rows.PIECE_WIDTH, x, y)
        if pieces.length(table, first * rows.PIECE_WIDTH) > 1e-9:
            first += 1
        self.copy(last, first)
        self.count = first + 1

    def keep_loop(self, first: int, last: int) -> None:
        """Keep the loop that is left out, and forget the oldest ones if there is no room."""
        while self.left_out_count + last - first + 2 > rows.ROOM:
            self.forget_loop(rows.ROOM)
        at = rows.ROOM + self.left_out_count
        for piece in range(first, last + 1):
            self.copy(piece, at)
            if piece == first:
                pieces.cut_start(
                    self.rows, at * rows.PIECE_WIDTH, self.crossings.x, self.crossings.y
                )
            elif piece == last:
                pieces.cut_end(self.rows, at * rows.PIECE_WIDTH, self.crossings.x, self.crossings.y)
            at += 1
        self.rows[at * rows.PIECE_WIDTH + rows.SHAPE] = rows.LOOP_END
        self.rows[at * rows.PIECE_WIDTH + rows.IS_CONTOUR] = 0.0
        self.left_out_count = at + 1 - rows.ROOM

    def forget_loop(self, first: int) -> None:
        """Leave out the loop at this row for good."""
        after = self.end_of_loop(first) + 1
        for piece in range(after, rows.ROOM + self.left_out_count):
            self.copy(piece, first + piece - after)
        self.left_out_count -= after - first

    def end_of_loop(self, piece: int) -> int:
        """Row after the last piece of a loop."""
        while self.rows[piece * rows.PIECE_WIDTH + rows.SHAPE] != rows.LOOP_END:
            piece += 1
        return piece

    def restore_loop(self, crossed_piece: int, last: int) -> int:
        """Lead the path around a loop again from its crossing; return 1 if done.

        The rest of the newest piece will leave out the part of it that is not path after all.
        """
        table = self.rows
        end = self.end_of_loop(crossed_piece)
        first = crossed_piece
        before = crossed_piece - 1
        while (
            before >= rows.ROOM and table[before * rows.PIECE_WIDTH + rows.SHAPE] != rows.LOOP_END
        ):
            first = before
            before -= 1
        after = last + end - first + 2
        if after > rows.FULL:
            return 0
        x = self.crossings.x
        y = self.crossings.y
        self.copy(last, after)
        pieces.cut_end(table, last * rows.PIECE_WIDTH, x, y)
        pieces.cut_start(table, after * rows.PIECE_WIDTH, x, y)
        begin = last + 1 if pieces.length(table, last * rows.PIECE_WIDTH) > 1e-9 else last
        piece = crossed_piece
        for at in range(begin, begin + end - first + 1):
            self.copy(piece, at)
            table[at * rows.PIECE_WIDTH + rows.MOTION] = self.number
            piece = first if piece == end - 1 else piece + 1
        at = begin + end - first + 1
        pieces.cut_start(table, begin * rows.PIECE_WIDTH, x, y)
        pieces.cut_end(table, (at - 1) * rows.PIECE_WIDTH, x, y)
        self.copy(after, at)
        self.count = at + 1
        self.forget_loop(first)
        return 1

    def copy(self, source: int, target: int) -> None:
        """Copy a row."""
        for i in range(rows.PIECE_WIDTH):
            self.rows[target * rows.PIECE_WIDTH + i] = self.rows[source * rows.PIECE_WIDTH + i]

    # --- taking pieces ---------------------------------------------------------------------------

    def take(self, number: int) -> int:
        """Take the next piece of this motion; return its shape, ``rows.NOTHING`` without one."""
        if not self.has_next(number):
            return rows.NOTHING
        row = self.taken_count * rows.PIECE_WIDTH
        noted = self.rows[row + rows.CROSSED]
        if noted > 0.0:
            self.crossed = int(noted)
            self.crossing = number
            self.crosses_lead = False
            for piece in range(self.taken_count, self.count):
                self.rows[piece * rows.PIECE_WIDTH + rows.CROSSED] = 0.0
        elif self.hidden_count > 0 and self.rows[row + rows.IS_CONTOUR] != 0.0:
            self.find_hidden()
        self.taken_count += 1
        return int(self.rows[row + rows.SHAPE])

    def hide(self, x: float, y: float, radius: float) -> None:
        """Note an end of the newest motion, an arc that the tool does not fit into.

        No path leads alongside it, so the pieces taken are compared with its ends.
        """
        at = self.hidden_count % rows.MAX_HIDDEN * rows.HIDDEN_WIDTH
        self.hidden[at + rows.HIDDEN_X] = x
        self.hidden[at + rows.HIDDEN_Y] = y
        self.hidden[at + rows.HIDDEN_RADIUS] = radius
        self.hidden[at + rows.HIDDEN_MOTION] = self.number
        self.hidden_count += 1

    def find_hidden(self) -> None:
        """Find where the next piece comes too near to a hidden end of an arc.

        A thousandth of the radius is left to rounding: ends of arcs, and corners that are not
        really corners.
        """
        row = self.taken_count * rows.PIECE_WIDTH
        number = self.rows[row + rows.MOTION]
        for piece in range(min(self.hidden_count, rows.MAX_HIDDEN)):
            at = piece * rows.HIDDEN_WIDTH
            motion = self.hidden[at + rows.HIDDEN_MOTION]
            if number - rows.REACH <= motion <= number + rows.REACH:
                x = self.hidden[at + rows.HIDDEN_X]
                y = self.hidden[at + rows.HIDDEN_Y]
                off = pieces.distance(self.rows, row, x, y)
                if off < 0.999 * self.hidden[at + rows.HIDDEN_RADIUS]:
                    self.crossed = int(motion)
                    self.crossing = int(number)
                    self.crosses_lead = False
                    self.hidden[at + rows.HIDDEN_RADIUS] = 0.0

    def has_next(self, number: int) -> bool:
        """Return whether there is one more piece of this motion."""
        if self.taken_count >= self.count:
            return False
        return self.rows[self.taken_count * rows.PIECE_WIDTH + rows.MOTION] == number

    def taken(self) -> tuple[float, ...]:
        """First columns of the piece taken last, up to its angle."""
        row = (self.taken_count - 1) * rows.PIECE_WIDTH
        return tuple([self.rows[row + i] for i in range(rows.RADIUS)])

    def taken_row(self) -> int:
        """Offset of the row of the piece taken last."""
        return (self.taken_count - 1) * rows.PIECE_WIDTH

    def taken_length(self) -> float:
        """Length of the piece taken last, in mm."""
        return pieces.length(self.rows, (self.taken_count - 1) * rows.PIECE_WIDTH)

# SPDX-License-Identifier: MIT
"""The offset path of the tool's centre along a contour, motion by motion (MO-9).

In: motions of a plane in their order, each with the distance of the tool. Out: the pieces of each
motion: the offset path and, around an outer corner, the pieces that join it with the next one. So a
motion is known up to its end once the next one is there.

Where the path crosses itself the tool damages the contour (``chain.py``). Where such loops are left
out (``masks``), a motion that does not fit leaves a gap, which such a loop removes, or which is
found when its motion is taken.
"""

from __future__ import annotations

from nctakt.decoder.contour import pieces, rows
from nctakt.decoder.contour.chain import Chain
from nctakt.decoder.contour.corners import Corners
from nctakt.kernel.base.arrays import doubles

#: A piece up to this length is a rounding error, mm.
NOTHING_MM = 1e-9


class ToolPath(Chain):
    """Path of the tool's centre along one contour.

    ``is_open``: the newest motion is not known up to its end. ``at_x``, ``at_y``: where the tool is
    after the pieces so far. ``parts``: motions after the newest one are not compared with earlier
    ones. ``first``: the motion that the tool has begun with; ``contour_start``: the first one of
    the contour, 0 none; ``closed``: the one that has ended where that begins. ``is_begun``: the
    next piece begins at ``begin_x``, ``begin_y``, where one has been left out.
    """

    def __init__(self) -> None:
        super().__init__()
        self.corners = Corners()
        self.cut_off = doubles(rows.PIECE_WIDTH)
        self.cut_off_number = 0
        self.is_open = False
        self.last_motion = 0
        self.parts = False
        self.at_x = 0.0
        self.at_y = 0.0
        self.first = 0
        self.contour_start = 0
        self.contour_start_x = 0.0
        self.contour_start_y = 0.0
        self.closed = 0
        self.is_begun = False
        self.begin_x = 0.0
        self.begin_y = 0.0

    def set_corners(self, by_arc: bool, is_direct: bool) -> None:
        """Set how the next corner is passed (``Corners``)."""
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
        compared: int,
    ) -> None:
        """Let the next motion be a line; ``compared``: with which others, ``rows.LEADS`` …"""
        at = rows.SECOND_MOTION - self.last_motion
        self.corners.enter(at, x, y, x_2, y_2, begin_d, end_d)
        self.corners.motions[at + rows.IS_OF_CONTOUR] = compared

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
        """Let the next motion be an arc; return false if the tool does not fit into it."""
        at = rows.SECOND_MOTION - self.last_motion
        motions = self.corners.motions
        motions[at + rows.START_X] = x
        motions[at + rows.START_Y] = y
        motions[at + rows.END_X] = x_2
        motions[at + rows.END_Y] = y_2
        motions[at + rows.START_DISTANCE] = distance
        motions[at + rows.END_DISTANCE] = distance
        motions[at + rows.IS_OF_CONTOUR] = rows.OF_CONTOUR
        self.corners.bend(at, centre_x, centre_y, angle)
        return motions[at + rows.IS_TOO_SMALL] == 0.0

    def begin(self, x: float, y: float, is_perpendicular: bool) -> None:
        """Begin with the motion at the tool's position; it may first go to its offset start."""
        at = rows.SECOND_MOTION - self.last_motion
        self.open(at)
        self.contour_start = 0
        self.first = self.number
        if is_perpendicular:
            self.corners.place_start(at)
            self.put_line(rows.LINE, x, y, self.corners.next_x, self.corners.next_y, 0)
            x = self.corners.next_x
            y = self.corners.next_y
        self.corners.motions[at + rows.TOOL_X] = x
        self.corners.motions[at + rows.TOOL_Y] = y
        self.at_x = x
        self.at_y = y

    def add(self) -> bool:
        """Join the motion with the one before it; return false if that one does not fit."""
        at = rows.SECOND_MOTION - self.last_motion
        meets = self.corners.join(self.last_motion, at)
        if not self.put_motion(meets, at):
            return False
        self.corners.motions[at + rows.TOOL_X] = self.at_x
        self.corners.motions[at + rows.TOOL_Y] = self.at_y
        self.open(at)
        if self.number == self.first + 1:
            for i in range(rows.MOTION_WIDTH):
                self.corners.motions[rows.FIRST_OF_CONTOUR + i] = self.corners.motions[at + i]
        return True

    def try_add(self, low_x: float, high_x: float, low_y: float, high_y: float) -> bool:
        """Join the motion with the one before it if there is nothing to report of that.

        Return false, with nothing changed, if that motion does not fit, if its path crosses
        another, or if it may come near these bounds.
        """
        at = rows.SECOND_MOTION - self.last_motion
        if not self.corners.join(self.last_motion, at):
            return False
        if not self.corners.is_within(self.last_motion, low_x, high_x, low_y, high_y):
            return False
        self.make_room()
        count = self.count
        barrier = self.barrier
        leading = self.leading
        x = self.at_x
        y = self.at_y
        if self.put_motion(1, at) and self.crossed == 0:
            self.corners.motions[at + rows.TOOL_X] = self.at_x
            self.corners.motions[at + rows.TOOL_Y] = self.at_y
            self.open(at)
            return True
        self.import_from(count, barrier)
        self.leading = leading
        self.at_x = x
        self.at_y = y
        self.is_open = True
        return False

    def close(self, is_perpendicular: bool) -> bool:
        """End the newest motion at its offset end, or go back from there to the contour."""
        self.corners.place_end(self.last_motion)
        if not self.put_motion(1, -1):
            return False
        if is_perpendicular:
            end_x = self.corners.motions[self.last_motion + rows.END_X]
            end_y = self.corners.motions[self.last_motion + rows.END_Y]
            self.put_end(end_x, end_y)
            self.at_x = end_x
            self.at_y = end_y
        return True

    def put_end(self, end_x: float, end_y: float) -> None:
        """Continue to a point; if the distance is zero, the last piece ends there."""
        self.make_room()
        row = self.count * rows.PIECE_WIDTH
        pieces.put_line(self.rows, row, rows.LINE, self.at_x, self.at_y, end_x, end_y)
        if pieces.length(self.rows, row) > NOTHING_MM:
            self.put_line(rows.LINE, self.at_x, self.at_y, end_x, end_y, 0)
            return
        row -= rows.PIECE_WIDTH
        if row >= 0 and self.rows[row + rows.MOTION] == self.number:
            self.rows[row + rows.END_X] = end_x
            self.rows[row + rows.END_Y] = end_y

    def enclose(self) -> int:
        """End the newest motion at the contour's start; return the motion that does not fit.

        In an inner corner the tool begins and ends the contour where both offset paths meet. The
        first motion has led there, and nothing is taken yet.
        """
        number = self.number
        first = rows.FIRST_OF_CONTOUR
        distance = self.corners.motions[self.last_motion + rows.END_DISTANCE]
        meets = self.corners.join(self.last_motion, first)
        if self.corners.is_outer(self.last_motion, first, distance):
            self.corners.place_end(self.last_motion)
        x = self.corners.end_x
        y = self.corners.end_y
        self.corners.joint_count = 0
        self.corners.meet(x, y)
        if not meets or not self.put_motion(1, -1):
            return number
        if self.corners.is_outer(self.last_motion, first, distance):
            return 0
        piece = 0
        while (
            piece < self.count and self.rows[piece * rows.PIECE_WIDTH + rows.MOTION] <= self.first
        ):
            piece += 1
        row = piece * rows.PIECE_WIDTH
        if piece < 1 or piece >= self.count or self.rows[row + rows.MOTION] != self.first + 1:
            return self.first + 1
        if self.crossings.distance_along(self.rows, row, x, y) < -1.0:
            return self.first + 1
        pieces.cut_end(self.rows, row - rows.PIECE_WIDTH, x, y)
        pieces.cut_start(self.rows, row, x, y)
        return 0

    def beside_end(self) -> tuple[float, float]:
        """Offset point at the end of the newest motion."""
        self.corners.place_end(self.last_motion)
        return (self.corners.end_x, self.corners.end_y)

    def last_motion_fits(self) -> bool:
        """Return whether the newest motion is no arc that is too small for the tool."""
        return self.corners.motions[self.last_motion + rows.IS_TOO_SMALL] == 0.0

    def give_up(self) -> None:
        """Drop the newest motion."""
        self.is_open = False

    def open(self, at: int) -> None:
        """Make the motion in this row the newest one."""
        self.last_motion = at
        self.count_motion()
        self.is_open = True

    # --- pieces ----------------------------------------------------------------------------------

    def put_motion(self, meets: int, other: int) -> int:
        """Append the pieces of the newest motion up to its end; return 0 if it does not fit.

        ``other``: the motion that it has been joined with, -1 none.
        """
        corners = self.corners
        self.make_room()
        self.is_open = False
        at = self.last_motion
        compared = corners.motions[at + rows.IS_OF_CONTOUR]
        is_contour = 1 if compared == rows.OF_CONTOUR else 0
        if is_contour:
            self.radius = abs(corners.motions[at + rows.END_DISTANCE])
        self.note_ends(at, is_contour)
        row = self.count * rows.PIECE_WIDTH
        fits = corners.put_own(at, self.rows, row)
        if not self.masks and not (fits and meets):
            return 0
        if not fits:
            self.part(at, other, is_contour)
            row = self.count * rows.PIECE_WIDTH
        if self.masks:
            self.keep_cut_off(at, other)
        self.is_begun = False
        self.put_if_long(row, is_contour)
        for k in range(corners.joint_count):
            row = self.count * rows.PIECE_WIDTH
            for i in range(rows.FURTHER):
                self.rows[row + i] = corners.joint[k * rows.PIECE_WIDTH + i]
            self.put_if_long(row, is_contour)
        self.at_x = self.begin_x if self.is_begun else corners.next_x
        self.at_y = self.begin_y if self.is_begun else corners.next_y
        self.compare_lead(compared == rows.LEADS)
        if self.parts or not is_contour:
            is_lead = compared == rows.LEADS and self.number == self.first and not self.parts
            self.separate()
            self.parts = False
            if is_lead and not self.masks:
                self.lead()
        return 1

    def compare_lead(self, leads: int) -> None:
        """Compare the newest motion with the contour if it leads away from that."""
        if leads and self.number > self.first and not self.masks and self.count > 0:
            self.compare_leaving(self.count - 1)

    def put_if_long(self, row: int, is_contour: int) -> None:
        """Append the piece in a row if it is more than rounding leaves.

        A piece that is not appended has no direction: the next piece begins where it does.
        """
        if self.is_begun:
            self.rows[row + rows.START_X] = self.begin_x
            self.rows[row + rows.START_Y] = self.begin_y
        self.is_begun = pieces.length(self.rows, row) <= NOTHING_MM
        if self.is_begun:
            self.begin_x = self.rows[row + rows.START_X]
            self.begin_y = self.rows[row + rows.START_Y]
        else:
            self.put(is_contour)

    def part(self, at: int, other: int, is_contour: int) -> None:
        """Pass a motion that does not fit and both its neighbours whole.

        So the path of one neighbour crosses that of another one where they really meet. The offset
        path of the newest motion is then the row after the pieces, or a gap.
        """
        corners = self.corners
        if self.cut_off_number == self.number:
            row = self.count * rows.PIECE_WIDTH
            for i in range(rows.FURTHER):
                self.rows[row + i] = self.cut_off[i]
            x = self.cut_off[rows.END_X]
            y = self.cut_off[rows.END_Y]
            self.put(is_contour)
            next_x = corners.next_x
            next_y = corners.next_y
            corners.place_start(at)
            corners.motions[at + rows.TOOL_X] = corners.next_x
            corners.motions[at + rows.TOOL_Y] = corners.next_y
            self.put_line(rows.GAP, x, y, corners.next_x, corners.next_y, is_contour)
            corners.next_x = next_x
            corners.next_y = next_y
        if other >= 0 and corners.meets_inside(at, other):
            corners.part(at, other)
        row = self.count * rows.PIECE_WIDTH
        if not corners.put_own(at, self.rows, row):
            self.rows[row + rows.SHAPE] = rows.GAP
            motions = corners.motions
            radius = motions[at + rows.START_DISTANCE]
            if radius < 0.0:
                radius = -radius
            self.hide(motions[at + rows.START_X], motions[at + rows.START_Y], radius)
            self.hide(motions[at + rows.END_X], motions[at + rows.END_Y], radius)

    def note_ends(self, at: int, is_contour: int) -> None:
        """Note where the contour begins, and which motion ends there."""
        motions = self.corners.motions
        if not is_contour:
            self.contour_start = 0
        elif self.contour_start == 0:
            self.contour_start = self.number
            self.contour_start_x = motions[at + rows.START_X]
            self.contour_start_y = motions[at + rows.START_Y]
        else:
            off = abs(motions[at + rows.END_X] - self.contour_start_x)
            off += abs(motions[at + rows.END_Y] - self.contour_start_y)
            if off <= 1e-6:
                self.closed = self.number

    def closes_contour(self) -> bool:
        """Return whether start and end of a closed contour cross."""
        return self.crossed == self.contour_start and self.crossing == self.closed

    def keep_cut_off(self, at: int, other: int) -> None:
        """Keep the part cut off at the junction with the next motion, which may not fit."""
        if other >= 0 and self.corners.meets_inside(at, other):
            self.corners.put_cut_off(at, self.cut_off, 0)
            self.cut_off_number = self.number + 1

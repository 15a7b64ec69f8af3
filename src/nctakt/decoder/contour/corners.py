# SPDX-License-Identifier: MIT
"""Two motions of a contour, and how their offset paths are joined at the corner (MO-9).

The tool's centre goes at a signed distance to the left of a motion, which is a row (``rows.py``).
At an inner corner the offset paths of both motions intersect, at an outer one further pieces join
them.

A change of direction below 0.01° does not count: ends and centres of arcs are rounded.
"""

from __future__ import annotations

from nctakt.decoder.contour import pieces, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles


class Corners:
    """Motions at a corner: the one before it, the one after it, and the contour's first.

    ``by_arc``: around outer corners in an arc. ``is_direct``: to a contour and from it without a
    path around a corner. Found by ``join``: the tool passes the first motion up to ``end_x``,
    ``end_y``, then ``joint_count`` pieces in ``joint``, then the second one from ``next_x``,
    ``next_y`` on.
    """

    def __init__(self) -> None:
        self.motions = doubles(rows.MOTIONS * rows.MOTION_WIDTH)
        self.joint = doubles(3 * rows.PIECE_WIDTH)
        self.joint_count = 0
        self.by_arc = False
        self.is_direct = False
        self.end_x = 0.0
        self.end_y = 0.0
        self.next_x = 0.0
        self.next_y = 0.0

    def enter(
        self,
        at: int,
        x: float,
        y: float,
        x_2: float,
        y_2: float,
        begin_d: float,
        end_d: float,
    ) -> None:
        """A line of non-zero length and its offsets."""
        motions = self.motions
        motions[at + rows.START_X] = x
        motions[at + rows.START_Y] = y
        motions[at + rows.END_X] = x_2
        motions[at + rows.END_Y] = y_2
        motions[at + rows.SHAPE] = rows.LINE
        motions[at + rows.START_DISTANCE] = begin_d
        motions[at + rows.END_DISTANCE] = end_d
        x = x_2 - x
        y = y_2 - y
        size = arithmetic.square_root(x * x + y * y)
        motions[at + rows.START_COSINE] = x / size
        motions[at + rows.START_SINE] = y / size
        motions[at + rows.END_COSINE] = motions[at + rows.START_COSINE]
        motions[at + rows.END_SINE] = motions[at + rows.START_SINE]
        motions[at + rows.IS_TOO_SMALL] = 0.0

    def bend(self, at: int, centre_x: float, centre_y: float, angle: float) -> None:
        """Turn the line in row ``at`` into an arc with this centre (mm) and angle (°)."""
        motions = self.motions
        motions[at + rows.SHAPE] = rows.ARC
        motions[at + rows.CENTRE_X] = centre_x
        motions[at + rows.CENTRE_Y] = centre_y
        motions[at + rows.ANGLE] = angle
        sense = 1.0 if angle > 0.0 else -1.0
        x = motions[at + rows.END_X] - centre_x
        y = motions[at + rows.END_Y] - centre_y
        radius = arithmetic.square_root(x * x + y * y)
        motions[at + rows.END_COSINE] = -y / radius * sense
        motions[at + rows.END_SINE] = x / radius * sense
        x = motions[at + rows.START_X] - centre_x
        y = motions[at + rows.START_Y] - centre_y
        radius = arithmetic.square_root(x * x + y * y)
        motions[at + rows.START_COSINE] = -y / radius * sense
        motions[at + rows.START_SINE] = x / radius * sense
        motions[at + rows.RADIUS] = radius
        is_too_small = radius - sense * motions[at + rows.START_DISTANCE] <= 1e-7
        motions[at + rows.IS_TOO_SMALL] = 1.0 if is_too_small else 0.0

    def place_end(self, at: int) -> None:
        """Let the tool pass the motion up to its offset end, with nothing joined to it."""
        motions = self.motions
        self.joint_count = 0
        distance = motions[at + rows.END_DISTANCE]
        self.end_x = motions[at + rows.END_X] - motions[at + rows.END_SINE] * distance
        self.end_y = motions[at + rows.END_Y] + motions[at + rows.END_COSINE] * distance
        self.next_x = self.end_x
        self.next_y = self.end_y

    def place_start(self, at: int) -> None:
        """Let the tool begin the motion at its offset start."""
        motions = self.motions
        distance = motions[at + rows.START_DISTANCE]
        self.next_x = motions[at + rows.START_X] - motions[at + rows.START_SINE] * distance
        self.next_y = motions[at + rows.START_Y] + motions[at + rows.START_COSINE] * distance

    def add_line(self, shape: int, x: float, y: float, x_2: float, y_2: float) -> None:
        """Append a line to the pieces between both motions."""
        pieces.put_line(self.joint, self.joint_count * rows.PIECE_WIDTH, shape, x, y, x_2, y_2)
        self.joint_count += 1

    def join(self, first: int, second: int) -> int:
        """Join two motions; return 0 if their offset paths leave a gap."""
        motions = self.motions
        distance = motions[first + rows.END_DISTANCE]
        self.joint_count = 0
        if distance != 0.0 and motions[second + rows.START_DISTANCE] != 0.0:
            return self.join_contour(first, second, distance)
        if distance == 0.0:
            distance = motions[second + rows.START_DISTANCE]
        if distance == 0.0:
            self.place_end(first)
        elif self.is_outer(first, second, distance) and not self.is_direct:
            self.go_around(first, second, distance)
        elif motions[first + rows.END_DISTANCE] != 0.0:
            self.place_end(first)
        else:
            self.place_start(second)
            self.end_x = self.next_x
            self.end_y = self.next_y
        return 1

    def join_contour(self, first: int, second: int, distance: float) -> int:
        """Join two motions of a contour; return as ``join``."""
        motions = self.motions
        if self.is_outer(first, second, distance):
            self.go_around(first, second, distance)
            return 1
        if motions[first + rows.IS_TOO_SMALL] == 0.0 and motions[second + rows.IS_TOO_SMALL] == 0.0:
            if self.is_straight(first, second):
                self.place_start(second)
                x = self.next_x
                y = self.next_y
                self.place_end(first)
                self.meet((self.end_x + x) / 2.0, (self.end_y + y) / 2.0)
                return 1
            if (
                motions[first + rows.SHAPE] == rows.LINE
                and motions[second + rows.SHAPE] == rows.LINE
            ):
                self.meet_between(first, second, distance)
                return 1
            if self.meet_nearest(first, second, distance):
                return 1
        self.part(first, second)
        return 0

    def part(self, first: int, second: int) -> None:
        """Let the tool pass both motions whole, with a gap between them."""
        self.place_start(second)
        x = self.next_x
        y = self.next_y
        self.place_end(first)
        self.add_line(rows.GAP, self.end_x, self.end_y, x, y)
        self.next_x = x
        self.next_y = y

    def meets_inside(self, first: int, second: int) -> int:
        """Return whether ``join`` let both motions meet at an inner corner."""
        distance = self.motions[first + rows.END_DISTANCE]
        if distance == 0.0 or self.motions[second + rows.START_DISTANCE] == 0.0:
            return 0
        if self.joint_count > 0:
            return 0
        if self.is_straight(first, second) or self.is_outer(first, second, distance):
            return 0
        return 1

    def put_cut_off(self, first: int, table: memoryview[float], row: int) -> None:
        """Put the part of a motion's tool path that ``join`` has cut off into a row."""
        motions = self.motions
        x = self.end_x
        y = self.end_y
        distance = motions[first + rows.END_DISTANCE]
        end_x = motions[first + rows.END_X] - motions[first + rows.END_SINE] * distance
        end_y = motions[first + rows.END_Y] + motions[first + rows.END_COSINE] * distance
        pieces.put_line(table, row, rows.LINE, x, y, end_x, end_y)
        if motions[first + rows.SHAPE] == rows.LINE:
            return
        centre_x = motions[first + rows.CENTRE_X]
        centre_y = motions[first + rows.CENTRE_Y]
        angle = pieces.turn(x - centre_x, y - centre_y, end_x - centre_x, end_y - centre_y)
        pieces.put_arc(table, row, centre_x, centre_y, angle)

    def meet(self, x: float, y: float) -> None:
        """Let the tool change from one motion to the other at a point."""
        self.end_x = x
        self.end_y = y
        self.next_x = x
        self.next_y = y

    def meet_between(self, first: int, second: int, distance: float) -> None:
        """Meet where the offset lines of the directions at a corner intersect."""
        motions = self.motions
        share = distance / (1.0 + self.cosine(first, second))
        off_x = (motions[first + rows.END_SINE] + motions[second + rows.START_SINE]) * share
        off_y = (motions[first + rows.END_COSINE] + motions[second + rows.START_COSINE]) * share
        self.meet(motions[first + rows.END_X] - off_x, motions[first + rows.END_Y] + off_y)

    def cosine(self, first: int, second: int) -> float:
        """Cosine of the change of direction at the corner."""
        motions = self.motions
        along = motions[first + rows.END_COSINE] * motions[second + rows.START_COSINE]
        return along + motions[first + rows.END_SINE] * motions[second + rows.START_SINE]

    def sine(self, first: int, second: int) -> float:
        """Sine of the change of direction at the corner, above 0 to the left."""
        motions = self.motions
        across = motions[first + rows.END_COSINE] * motions[second + rows.START_SINE]
        return across - motions[first + rows.END_SINE] * motions[second + rows.START_COSINE]

    def is_straight(self, first: int, second: int) -> int:
        """Return whether two motions join tangentially, within 0.01 degrees."""
        return (
            1
            if self.cosine(first, second) > 0.0
            and -0.00017453292431333680 < self.sine(first, second) < 0.00017453292431333680
            else 0
        )

    def is_outer(self, first: int, second: int, distance: float) -> int:
        """Return whether the tool has to go around this corner; a reversal counts as one."""
        sine = self.sine(first, second)
        if -0.00017453292431333680 < sine < 0.00017453292431333680:
            return 1 if self.cosine(first, second) < 0.0 else 0
        return 1 if sine * distance < 0.0 else 0

    def is_within(
        self, first: int, low_x: float, high_x: float, low_y: float, high_y: float
    ) -> int:
        """Return whether the path that ``join`` has found surely keeps these bounds."""
        x = self.end_x
        y = self.end_y
        extent = 0.0
        if self.joint_count > 0:
            x = self.motions[first + rows.END_X]
            y = self.motions[first + rows.END_Y]
            extent = 1.5 * self.motions[first + rows.END_DISTANCE]
            if extent < 0.0:
                extent = -extent
        if not low_x <= x - extent or not x + extent <= high_x:
            return 0
        return 1 if low_y <= y - extent and y + extent <= high_y else 0

    # --- outer corners ---------------------------------------------------------------------------

    def go_around(self, first: int, second: int, distance: float) -> None:
        """Lead the tool around an outer corner, from the offset of one direction to the other.

        In lines it goes straight on to where both offset lines intersect, at sharp corners no
        farther than the offset, and then across; a straight continuation is part of the line that
        it continues.
        """
        motions = self.motions
        corner_x = motions[first + rows.END_X]
        corner_y = motions[first + rows.END_Y]
        self.end_x = corner_x - motions[first + rows.END_SINE] * distance
        self.end_y = corner_y + motions[first + rows.END_COSINE] * distance
        self.next_x = corner_x - motions[second + rows.START_SINE] * distance
        self.next_y = corner_y + motions[second + rows.START_COSINE] * distance
        if self.by_arc:
            self.add_arc(first, second, distance)
            return
        x = self.end_x
        y = self.end_y
        x_2 = self.next_x
        y_2 = self.next_y
        cosine = self.cosine(first, second)
        if cosine >= 0.0:
            share = distance / (1.0 + cosine)
            x = (
                corner_x
                - (motions[first + rows.END_SINE] + motions[second + rows.START_SINE]) * share
            )
            y = (
                corner_y
                + (motions[first + rows.END_COSINE] + motions[second + rows.START_COSINE]) * share
            )
            x_2 = x
            y_2 = y
        else:
            extent = distance if distance > 0.0 else -distance
            x += motions[first + rows.END_COSINE] * extent
            y += motions[first + rows.END_SINE] * extent
            x_2 -= motions[second + rows.START_COSINE] * extent
            y_2 -= motions[second + rows.START_SINE] * extent
        if motions[first + rows.SHAPE] == rows.LINE and motions[first + rows.END_DISTANCE] != 0.0:
            self.end_x = x
            self.end_y = y
        else:
            self.add_line(rows.LINE, self.end_x, self.end_y, x, y)
        if cosine < 0.0:
            self.add_line(rows.LINE, x, y, x_2, y_2)
        if (
            motions[second + rows.SHAPE] == rows.LINE
            and motions[second + rows.START_DISTANCE] != 0.0
        ):
            self.next_x = x_2
            self.next_y = y_2
        else:
            self.add_line(rows.LINE, x_2, y_2, self.next_x, self.next_y)

    def add_arc(self, first: int, second: int, distance: float) -> None:
        """Lead the tool around the corner by an arc; half a turn where the contour reverses."""
        motions = self.motions
        angle = pieces.turn(
            motions[first + rows.END_COSINE],
            motions[first + rows.END_SINE],
            motions[second + rows.START_COSINE],
            motions[second + rows.START_SINE],
        )
        if (angle > 179.99 and distance > 0.0) or (angle < -179.99 and distance < 0.0):
            angle = -angle
        pieces.put_line(self.joint, 0, rows.LINE, self.end_x, self.end_y, self.next_x, self.next_y)
        pieces.put_arc(
            self.joint, 0, motions[first + rows.END_X], motions[first + rows.END_Y], angle
        )
        self.joint_count = 1

    # --- inner corners with arcs -----------------------------------------------------------------

    def meet_nearest(self, first: int, second: int, distance: float) -> int:
        """Meet where the offset lines or circles of two motions intersect next to the corner."""
        if (
            self.motions[first + rows.SHAPE] == rows.ARC
            and self.motions[second + rows.SHAPE] == rows.ARC
        ):
            return self.meet_of_arcs(first, second, distance)
        motions = self.motions
        arc = first if motions[first + rows.SHAPE] == rows.ARC else second
        x = (
            motions[second + rows.START_COSINE]
            if arc == first
            else motions[first + rows.END_COSINE]
        )
        y = motions[second + rows.START_SINE] if arc == first else motions[first + rows.END_SINE]
        # a point on the offset line of the other motion, from the centre
        off_x = motions[first + rows.END_X] - y * distance - motions[arc + rows.CENTRE_X]
        off_y = motions[first + rows.END_Y] + x * distance - motions[arc + rows.CENTRE_Y]
        across = x * off_y - y * off_x
        middle = -(x * off_x + y * off_y)
        radius = self.shifted_radius(arc, distance)
        half2 = (radius - across) * (radius + across)
        if half2 < 0.0:
            return 0
        half = arithmetic.square_root(half2)
        # the foot of the line is on the corner's perpendicular: the nearer point gives the shorter
        # path
        along = middle + half if middle < 0.0 else middle - half
        at_x = motions[arc + rows.CENTRE_X] + off_x + x * along
        self.meet(at_x, motions[arc + rows.CENTRE_Y] + off_y + y * along)
        return 1

    def meet_of_arcs(self, first: int, second: int, distance: float) -> int:
        """Meet where the offset circles of two arcs intersect next to the corner."""
        motions = self.motions
        x = motions[second + rows.CENTRE_X] - motions[first + rows.CENTRE_X]
        y = motions[second + rows.CENTRE_Y] - motions[first + rows.CENTRE_Y]
        apart = arithmetic.square_root(x * x + y * y)
        if apart <= 1e-7:
            return 0
        radius = self.shifted_radius(first, distance)
        radius_2 = self.shifted_radius(second, distance)
        along = (apart + (radius - radius_2) * (radius + radius_2) / apart) / 2.0
        half2 = (radius - along) * (radius + along)
        if half2 < 0.0:
            return 0
        half = arithmetic.square_root(half2)
        x /= apart
        y /= apart
        # the corner lies on one side of the line through both centres, and so does the nearer place
        off_x = motions[first + rows.END_X] - motions[first + rows.CENTRE_X]
        off_y = motions[first + rows.END_Y] - motions[first + rows.CENTRE_Y]
        if x * off_y - y * off_x < 0.0:
            half = -half
        self.meet(
            motions[first + rows.CENTRE_X] + x * along - y * half,
            motions[first + rows.CENTRE_Y] + y * along + x * half,
        )
        return 1

    def shifted_radius(self, at: int, distance: float) -> float:
        """Radius of the offset circle of an arc, in mm."""
        sense = 1.0 if self.motions[at + rows.ANGLE] > 0.0 else -1.0
        return self.motions[at + rows.RADIUS] - sense * distance

    # --- a motion itself -------------------------------------------------------------------------

    def put_own(self, at: int, table: memoryview[float], row: int) -> int:
        """Put the offset path of a motion into a row; return 0 if it runs backwards."""
        motions = self.motions
        x = motions[at + rows.TOOL_X]
        y = motions[at + rows.TOOL_Y]
        pieces.put_line(table, row, rows.LINE, x, y, self.end_x, self.end_y)
        if motions[at + rows.START_DISTANCE] == 0.0 and motions[at + rows.END_DISTANCE] == 0.0:
            return 1
        if motions[at + rows.IS_TOO_SMALL] != 0.0:
            return 0
        if motions[at + rows.SHAPE] == rows.LINE:
            length = (self.end_x - x) * motions[at + rows.START_COSINE]
            length += (self.end_y - y) * motions[at + rows.START_SINE]
            return 1 if length >= -1e-7 else 0
        return self.put_own_arc(at, table, row)

    def put_own_arc(self, at: int, table: memoryview[float], row: int) -> int:
        """``put_own`` of an arc: the angle is the motion's, corrected at both ends."""
        motions = self.motions
        centre_x = motions[at + rows.CENTRE_X]
        centre_y = motions[at + rows.CENTRE_Y]
        sense = 1.0 if motions[at + rows.ANGLE] > 0.0 else -1.0
        whole = sense * motions[at + rows.ANGLE]
        distance = motions[at + rows.START_DISTANCE]
        angle = whole - sense * pieces.turn(
            motions[at + rows.START_X] - motions[at + rows.START_SINE] * distance - centre_x,
            motions[at + rows.START_Y] + motions[at + rows.START_COSINE] * distance - centre_y,
            table[row + rows.START_X] - centre_x,
            table[row + rows.START_Y] - centre_y,
        )
        angle -= sense * pieces.turn(
            self.end_x - centre_x,
            self.end_y - centre_y,
            motions[at + rows.END_X] - motions[at + rows.END_SINE] * distance - centre_x,
            motions[at + rows.END_Y] + motions[at + rows.END_COSINE] * distance - centre_y,
        )
        length = angle * self.shifted_radius(at, distance) * 0.017453292519943295
        if length < -1e-7 or angle > whole + 0.01:
            return 0
        if length >= 1e-7:
            pieces.put_arc(table, row, centre_x, centre_y, sense * angle)
        return 1

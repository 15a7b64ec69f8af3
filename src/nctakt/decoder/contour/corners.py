# SPDX-License-Identifier: MIT
"""Two motions of a contour, and how the ways beside them are joined at their corner (MO-9).

The tool's centre goes at a signed distance to the left of a motion. At an inner corner the ways
beside both motions cut each other, at an outer one further pieces join them. A motion is a row of
float64, lengths in mm, angles in degrees:

====== =============================================================================
0 … 3  start, end
4 … 8  whether it is an arc, its centre, angle (negative clockwise), radius
9, 10  the distance at its start and at its end; both 0: it leads to a contour or from it
11 …   its direction at the start and at the end
15, 16 where the tool begins it
17     whether it is an arc that is too small for the tool
18     whether it is part of a contour
====== =============================================================================

A change of direction below 0.01° is none: ends and centres of arcs are rounded.
"""

from __future__ import annotations

from nctakt.decoder.contour import pieces
from nctakt.kernel.base import arithmetic

#: Numbers of a row.
WIDTH = 20


class Corners:
    """The motion that is known up to its end, the one behind it, and the first of the contour.

    ``by_arc``: around outer corners in an arc. ``is_direct``: to a contour and from it without a
    way around a corner. Found by ``join``: the tool passes the first motion up to ``end_x``,
    ``end_y``, then ``way_count`` pieces in ``way``, then the second one from ``next_x``, ``next_y``
    on.
    """

    def __init__(self) -> None:
        self.motions = memoryview(bytearray(8 * 3 * WIDTH)).cast("d")
        self.way = memoryview(bytearray(8 * 3 * pieces.WIDTH)).cast("d")
        self.way_count = 0
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
        """A line with its distances, which is not nothing."""
        rows = self.motions
        rows[at] = x
        rows[at + 1] = y
        rows[at + 2] = x_2
        rows[at + 3] = y_2
        rows[at + 4] = 0.0
        rows[at + 9] = begin_d
        rows[at + 10] = end_d
        x = x_2 - x
        y = y_2 - y
        size = arithmetic.square_root(x * x + y * y)
        rows[at + 11] = x / size
        rows[at + 12] = y / size
        rows[at + 13] = rows[at + 11]
        rows[at + 14] = rows[at + 12]
        rows[at + 17] = 0.0

    def bend(self, at: int, centre_x: float, centre_y: float, angle: float) -> None:
        """Make the motion an arc; its start and end stand in it, and one distance."""
        rows = self.motions
        rows[at + 4] = 1.0
        rows[at + 5] = centre_x
        rows[at + 6] = centre_y
        rows[at + 7] = angle
        sense = 1.0 if angle > 0.0 else -1.0
        for end in range(2):
            x = rows[at + 2 * end] - centre_x
            y = rows[at + 2 * end + 1] - centre_y
            radius = arithmetic.square_root(x * x + y * y)
            if end == 0:
                rows[at + 8] = radius
            rows[at + 11 + 2 * end] = -y / radius * sense
            rows[at + 12 + 2 * end] = x / radius * sense
        rows[at + 17] = 1.0 if rows[at + 8] - sense * rows[at + 9] <= 1e-7 else 0.0

    def place_end(self, at: int) -> None:
        """Let the tool pass the motion up to beside its end: nothing joins it."""
        rows = self.motions
        self.way_count = 0
        self.end_x = rows[at + 2] - rows[at + 14] * rows[at + 10]
        self.end_y = rows[at + 3] + rows[at + 13] * rows[at + 10]
        self.next_x = self.end_x
        self.next_y = self.end_y

    def place_start(self, at: int) -> None:
        """Let the tool begin the motion beside its start."""
        rows = self.motions
        self.next_x = rows[at] - rows[at + 12] * rows[at + 9]
        self.next_y = rows[at + 1] + rows[at + 11] * rows[at + 9]

    def add_line(self, kind: int, x: float, y: float, x_2: float, y_2: float) -> None:
        """One more piece of the way between both."""
        pieces.put_line(self.way, self.way_count * 16, kind, x, y, x_2, y_2)
        self.way_count += 1

    def join(self, one: int, other: int) -> int:
        """Join two motions; 0: the ways beside them do not meet, there is a gap between them."""
        rows = self.motions
        distance = rows[one + 10]
        self.way_count = 0
        if distance != 0.0 and rows[other + 9] != 0.0:
            return self.join_contour(one, other, distance)
        if distance == 0.0:
            distance = rows[other + 9]
        if distance == 0.0:
            self.place_end(one)
        elif self.is_outer(one, other, distance) and not self.is_direct:
            self.go_around(one, other, distance)
        elif rows[one + 10] != 0.0:
            self.place_end(one)
        else:
            self.place_start(other)
            self.end_x = self.next_x
            self.end_y = self.next_y
        return 1

    def join_contour(self, one: int, other: int, distance: float) -> int:
        """Both motions have the same distance at their corner."""
        rows = self.motions
        if self.is_outer(one, other, distance):
            self.go_around(one, other, distance)
            return 1
        if rows[one + 17] == 0.0 and rows[other + 17] == 0.0:
            if self.is_straight(one, other):
                self.place_start(other)
                x = self.next_x
                y = self.next_y
                self.place_end(one)
                self.meet((self.end_x + x) / 2.0, (self.end_y + y) / 2.0)
                return 1
            if rows[one + 4] == 0.0 and rows[other + 4] == 0.0:
                self.meet_between(one, other, distance)
                return 1
            if self.meet_nearest(one, other, distance):
                return 1
        self.part(one, other)
        return 0

    def part(self, one: int, other: int) -> None:
        """The tool passes both motions whole; between the ways beside them there is a gap."""
        self.place_start(other)
        x = self.next_x
        y = self.next_y
        self.place_end(one)
        self.add_line(2, self.end_x, self.end_y, x, y)
        self.next_x = x
        self.next_y = y

    def meets_inside(self, one: int, other: int) -> int:
        """Whether ``join`` let both motions meet at an inner corner."""
        distance = self.motions[one + 10]
        if distance == 0.0 or self.motions[other + 9] == 0.0 or self.way_count > 0:
            return 0
        if self.is_straight(one, other) or self.is_outer(one, other, distance):
            return 0
        return 1

    def put_rest(self, one: int, rows: memoryview[float], base: int) -> None:
        """Put the way beside a motion from where ``join`` ends it to beside its end into a row."""
        motions = self.motions
        x = self.end_x
        y = self.end_y
        end_x = motions[one + 2] - motions[one + 14] * motions[one + 10]
        end_y = motions[one + 3] + motions[one + 13] * motions[one + 10]
        pieces.put_line(rows, base, 0, x, y, end_x, end_y)
        if motions[one + 4] == 0.0:
            return
        centre_x = motions[one + 5]
        centre_y = motions[one + 6]
        angle = pieces.turn(x - centre_x, y - centre_y, end_x - centre_x, end_y - centre_y)
        pieces.put_arc(rows, base, centre_x, centre_y, angle)

    def meet(self, x: float, y: float) -> None:
        """The tool goes from one motion on to the other at this place."""
        self.end_x = x
        self.end_y = y
        self.next_x = x
        self.next_y = y

    def meet_between(self, one: int, other: int, distance: float) -> None:
        """Where the lines beside the directions at a corner cut each other."""
        rows = self.motions
        share = distance / (1.0 + self.cosine(one, other))
        self.meet(
            rows[one + 2] - (rows[one + 14] + rows[other + 12]) * share,
            rows[one + 3] + (rows[one + 13] + rows[other + 11]) * share,
        )

    def cosine(self, one: int, other: int) -> float:
        """Of the change of direction at the corner."""
        rows = self.motions
        return rows[one + 13] * rows[other + 11] + rows[one + 14] * rows[other + 12]

    def sine(self, one: int, other: int) -> float:
        """Of the change of direction at the corner, above 0 to the left."""
        rows = self.motions
        return rows[one + 13] * rows[other + 12] - rows[one + 14] * rows[other + 11]

    def is_straight(self, one: int, other: int) -> int:
        """Whether there is no corner."""
        return (
            1
            if self.cosine(one, other) > 0.0
            and -0.00017453292431333680 < self.sine(one, other) < 0.00017453292431333680
            else 0
        )

    def is_outer(self, one: int, other: int, distance: float) -> int:
        """Whether the tool has to go around this corner; it has where the contour goes back."""
        sine = self.sine(one, other)
        if -0.00017453292431333680 < sine < 0.00017453292431333680:
            return 1 if self.cosine(one, other) < 0.0 else 0
        return 1 if sine * distance < 0.0 else 0

    def is_within(self, one: int, low_x: float, high_x: float, low_y: float, high_y: float) -> int:
        """Whether the way that ``join`` has found surely keeps these bounds."""
        x = self.end_x
        y = self.end_y
        reach = 0.0
        if self.way_count > 0:
            x = self.motions[one + 2]
            y = self.motions[one + 3]
            reach = 1.5 * self.motions[one + 10]
            if reach < 0.0:
                reach = -reach
        if not low_x <= x - reach or not x + reach <= high_x:
            return 0
        return 1 if low_y <= y - reach and y + reach <= high_y else 0

    # --- outer corners ---------------------------------------------------------------------------

    def go_around(self, one: int, other: int, distance: float) -> None:
        """The way around an outer corner, from beside one direction to beside the other.

        In lines it goes straight on to where the lines beside both directions cut each other, at
        sharp corners no farther than the distance, and then across; what goes on straight is part
        of the line that it continues.
        """
        rows = self.motions
        corner_x = rows[one + 2]
        corner_y = rows[one + 3]
        self.end_x = corner_x - rows[one + 14] * distance
        self.end_y = corner_y + rows[one + 13] * distance
        self.next_x = corner_x - rows[other + 12] * distance
        self.next_y = corner_y + rows[other + 11] * distance
        if self.by_arc:
            self.add_arc(one, other, distance)
            return
        x = self.end_x
        y = self.end_y
        x_2 = self.next_x
        y_2 = self.next_y
        cosine = self.cosine(one, other)
        if cosine >= 0.0:
            share = distance / (1.0 + cosine)
            x = corner_x - (rows[one + 14] + rows[other + 12]) * share
            y = corner_y + (rows[one + 13] + rows[other + 11]) * share
            x_2 = x
            y_2 = y
        else:
            reach = distance if distance > 0.0 else -distance
            x += rows[one + 13] * reach
            y += rows[one + 14] * reach
            x_2 -= rows[other + 11] * reach
            y_2 -= rows[other + 12] * reach
        if rows[one + 4] == 0.0 and rows[one + 10] != 0.0:
            self.end_x = x
            self.end_y = y
        else:
            self.add_line(0, self.end_x, self.end_y, x, y)
        if cosine < 0.0:
            self.add_line(0, x, y, x_2, y_2)
        if rows[other + 4] == 0.0 and rows[other + 9] != 0.0:
            self.next_x = x_2
            self.next_y = y_2
        else:
            self.add_line(0, x_2, y_2, self.next_x, self.next_y)

    def add_arc(self, one: int, other: int, distance: float) -> None:
        """About the corner; where the contour goes back by half a turn around its end."""
        rows = self.motions
        angle = pieces.turn(rows[one + 13], rows[one + 14], rows[other + 11], rows[other + 12])
        if (angle > 179.99 and distance > 0.0) or (angle < -179.99 and distance < 0.0):
            angle = -angle
        pieces.put_line(self.way, 0, 0, self.end_x, self.end_y, self.next_x, self.next_y)
        pieces.put_arc(self.way, 0, rows[one + 2], rows[one + 3], angle)
        self.way_count = 1

    # --- inner corners with arcs -----------------------------------------------------------------

    def meet_nearest(self, one: int, other: int, distance: float) -> int:
        """Where the whole lines or circles beside two motions cut each other next to the corner."""
        if self.motions[one + 4] == 1.0 and self.motions[other + 4] == 1.0:
            return self.meet_of_arcs(one, other, distance)
        rows = self.motions
        arc = one if rows[one + 4] == 1.0 else other
        x = rows[other + 11] if arc == one else rows[one + 13]
        y = rows[other + 12] if arc == one else rows[one + 14]
        # a place on the line beside the other motion, from the centre
        off_x = rows[one + 2] - y * distance - rows[arc + 5]
        off_y = rows[one + 3] + x * distance - rows[arc + 6]
        across = x * off_y - y * off_x
        middle = -(x * off_x + y * off_y)
        radius = self.shifted_radius(arc, distance)
        half2 = (radius - across) * (radius + across)
        if half2 < 0.0:
            return 0
        half = arithmetic.square_root(half2)
        # the foot of the line is on the corner's perpendicular: the nearer one is the shorter way
        way = middle + half if middle < 0.0 else middle - half
        self.meet(rows[arc + 5] + off_x + x * way, rows[arc + 6] + off_y + y * way)
        return 1

    def meet_of_arcs(self, one: int, other: int, distance: float) -> int:
        """Two arcs."""
        rows = self.motions
        x = rows[other + 5] - rows[one + 5]
        y = rows[other + 6] - rows[one + 6]
        apart = arithmetic.square_root(x * x + y * y)
        if apart <= 1e-7:
            return 0
        radius = self.shifted_radius(one, distance)
        radius_2 = self.shifted_radius(other, distance)
        along = (apart + (radius - radius_2) * (radius + radius_2) / apart) / 2.0
        half2 = (radius - along) * (radius + along)
        if half2 < 0.0:
            return 0
        half = arithmetic.square_root(half2)
        x /= apart
        y /= apart
        # the corner lies on one side of the line through both centres, and so does the nearer place
        off_x = rows[one + 2] - rows[one + 5]
        off_y = rows[one + 3] - rows[one + 6]
        if x * off_y - y * off_x < 0.0:
            half = -half
        self.meet(
            rows[one + 5] + x * along - y * half,
            rows[one + 6] + y * along + x * half,
        )
        return 1

    def shifted_radius(self, at: int, distance: float) -> float:
        """The radius of the circle beside an arc."""
        sense = 1.0 if self.motions[at + 7] > 0.0 else -1.0
        return self.motions[at + 8] - sense * distance

    # --- a motion itself -------------------------------------------------------------------------

    def put_own(self, at: int, rows: memoryview[float], base: int) -> int:
        """Put the tool's way beside the motion into a row, up to its end: 0 it goes backwards."""
        motions = self.motions
        x = motions[at + 15]
        y = motions[at + 16]
        pieces.put_line(rows, base, 0, x, y, self.end_x, self.end_y)
        if motions[at + 9] == 0.0 and motions[at + 10] == 0.0:
            return 1
        if motions[at + 17] != 0.0:
            return 0
        if motions[at + 4] == 0.0:
            way = (self.end_x - x) * motions[at + 11] + (self.end_y - y) * motions[at + 12]
            return 1 if way >= -1e-7 else 0
        return self.put_own_arc(at, rows, base)

    def put_own_arc(self, at: int, rows: memoryview[float], base: int) -> int:
        """As ``put_own``: the angle is the motion's less what is cut off, or more, at both ends."""
        motions = self.motions
        centre_x = motions[at + 5]
        centre_y = motions[at + 6]
        sense = 1.0 if motions[at + 7] > 0.0 else -1.0
        whole = sense * motions[at + 7]
        distance = motions[at + 9]
        angle = whole - sense * pieces.turn(
            motions[at] - motions[at + 12] * distance - centre_x,
            motions[at + 1] + motions[at + 11] * distance - centre_y,
            rows[base] - centre_x,
            rows[base + 1] - centre_y,
        )
        angle -= sense * pieces.turn(
            self.end_x - centre_x,
            self.end_y - centre_y,
            motions[at + 2] - motions[at + 14] * distance - centre_x,
            motions[at + 3] + motions[at + 13] * distance - centre_y,
        )
        way = angle * self.shifted_radius(at, distance) * 0.017453292519943295
        if way < -1e-7 or angle > whole + 0.01:
            return 0
        if way >= 1e-7:
            pieces.put_arc(rows, base, centre_x, centre_y, sense * angle)
        return 1

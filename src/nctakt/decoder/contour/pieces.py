# SPDX-License-Identifier: MIT
"""Lines and arcs in a plane as rows of float64, and where two of them cross (MO-9).

Lengths in mm, angles in degrees. A row:

====== =============================================================================
0 … 3  start, end
4      0 line, 1 arc, 2 a gap: the way between two pieces that do not meet
5 … 8  of an arc: centre, angle (negative clockwise), radius
9      the running number of the motion that it belongs to
10     whether it is part of a contour: what leads to it and from it is not
11 …   least and greatest place in both axes
15     the motion whose way this piece crosses, 0 none
====== =============================================================================

A piece has its start, and not its end, so that a corner of a way is on one piece of it.
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic

#: Numbers of a row.
WIDTH = 16


def put_line(
    rows: memoryview[float], base: int, kind: int, x: float, y: float, x_2: float, y_2: float
) -> None:
    """Make the row a line, or with the kind 2 a gap."""
    rows[base] = x
    rows[base + 1] = y
    rows[base + 2] = x_2
    rows[base + 3] = y_2
    rows[base + 4] = kind
    rows[base + 7] = 0.0


def put_arc(
    rows: memoryview[float], base: int, centre_x: float, centre_y: float, angle: float
) -> None:
    """Make the row, whose start and end stand in it, an arc."""
    rows[base + 4] = 1.0
    rows[base + 5] = centre_x
    rows[base + 6] = centre_y
    rows[base + 7] = angle
    x = rows[base] - centre_x
    y = rows[base + 1] - centre_y
    rows[base + 8] = arithmetic.square_root(x * x + y * y)


def turn(x: float, y: float, x_2: float, y_2: float) -> float:
    """How far it is from one direction to another, to the left; above -180, up to 180."""
    return arithmetic.arc_tangent_2(x * y_2 - y * x_2, x * x_2 + y * y_2)


def length(rows: memoryview[float], base: int) -> float:
    """The way from its start to its end."""
    if rows[base + 4] == 1.0:
        angle = rows[base + 7]
        return rows[base + 8] * (angle if angle > 0.0 else -angle) * 0.017453292519943295
    x = rows[base + 2] - rows[base]
    y = rows[base + 3] - rows[base + 1]
    return arithmetic.square_root(x * x + y * y)


def bound(rows: memoryview[float], base: int) -> None:
    """Put the least and the greatest places of a piece into its row."""
    more = 0.0
    if rows[base + 4] == 1.0:
        angle = rows[base + 7]
        if -180.0 <= angle <= 180.0:
            more = rows[base + 8] * (1.0 - arithmetic.cosine(angle / 2.0))
        else:
            more = 2.0 * rows[base + 8]
    for i in range(2):
        rows[base + 11 + 2 * i] = min(rows[base + i], rows[base + 2 + i]) - more
        rows[base + 12 + 2 * i] = max(rows[base + i], rows[base + 2 + i]) + more


def are_apart(rows: memoryview[float], one: int, other: int) -> int:
    """Whether the bounds of two pieces have nothing in common."""
    if rows[one + 12] < rows[other + 11] or rows[other + 12] < rows[one + 11]:
        return 1
    return 1 if rows[one + 14] < rows[other + 13] or rows[other + 14] < rows[one + 13] else 0


def cut_end(rows: memoryview[float], base: int, x: float, y: float) -> None:
    """Let a piece end at this place on it."""
    if rows[base + 4] == 1.0:
        rows[base + 7] = angle_to(rows, base, x, y)
    rows[base + 2] = x
    rows[base + 3] = y
    bound(rows, base)


def cut_start(rows: memoryview[float], base: int, x: float, y: float) -> None:
    """Let a piece begin at this place on it."""
    if rows[base + 4] == 1.0:
        rows[base + 7] -= angle_to(rows, base, x, y)
    rows[base] = x
    rows[base + 1] = y
    bound(rows, base)


def swept(x: float, y: float, x_2: float, y_2: float, sense: float) -> float:
    """From one direction to another in this sense of rotation, with its sign, up to a turn."""
    angle = turn(x, y, x_2, y_2)
    if sense > 0.0 and angle < 0.0:
        angle += 360.0
    elif sense < 0.0 and angle > 0.0:
        angle -= 360.0
    return angle


def angle_to(rows: memoryview[float], base: int, x: float, y: float) -> float:
    """From the start of an arc to a place on it, in its sense.

    A place up to 1e-6 mm before the start is there, and not a turn away.
    """
    centre_x = rows[base + 5]
    centre_y = rows[base + 6]
    angle = swept(
        rows[base] - centre_x, rows[base + 1] - centre_y, x - centre_x, y - centre_y, rows[base + 7]
    )
    turn_ = 360.0 if angle > 0.0 else -360.0
    before = (turn_ - angle) * rows[base + 8] * 0.017453292519943295
    return angle - turn_ if -1e-6 <= before <= 1e-6 else angle


def distance(rows: memoryview[float], base: int, x: float, y: float) -> float:
    """How far a place is from a line or an arc."""
    if rows[base + 4] == 1.0:
        angle = angle_to(rows, base, x, y)
        whole = rows[base + 7]
        if (0.0 <= angle <= whole) or (whole <= angle <= 0.0):
            off_x = x - rows[base + 5]
            off_y = y - rows[base + 6]
            off = arithmetic.square_root(off_x * off_x + off_y * off_y) - rows[base + 8]
            return off if off > 0.0 else -off
    else:
        way_x = rows[base + 2] - rows[base]
        way_y = rows[base + 3] - rows[base + 1]
        along = (x - rows[base]) * way_x + (y - rows[base + 1]) * way_y
        size2 = way_x * way_x + way_y * way_y
        if 0.0 < along < size2:
            off_x = x - rows[base] - way_x * along / size2
            off_y = y - rows[base + 1] - way_y * along / size2
            return arithmetic.square_root(off_x * off_x + off_y * off_y)
    least2 = 0.0
    for end in range(2):
        off_x = x - rows[base + 2 * end]
        off_y = y - rows[base + 2 * end + 1]
        off2 = off_x * off_x + off_y * off_y
        if end == 0 or off2 < least2:
            least2 = off2
    return arithmetic.square_root(least2)


def direction_x(rows: memoryview[float], base: int, y: float) -> float:
    """The way's direction at a place, its part along the first axis."""
    if rows[base + 4] != 1.0:
        return (rows[base + 2] - rows[base]) / length(rows, base)
    sense = 1.0 if rows[base + 7] > 0.0 else -1.0
    return sense * (rows[base + 6] - y) / rows[base + 8]


def direction_y(rows: memoryview[float], base: int, x: float) -> float:
    """The way's direction at a place, its part along the second axis."""
    if rows[base + 4] != 1.0:
        return (rows[base + 3] - rows[base + 1]) / length(rows, base)
    sense = 1.0 if rows[base + 7] > 0.0 else -1.0
    return sense * (x - rows[base + 5]) / rows[base + 8]


class Crossing:
    """Where two pieces cross.

    ``x``, ``y``: the place. ``along``: how far it is along the second one, mm. ``sense``: the sine
    from the first one's direction to the second one's, above 0 where that crosses to the left.
    ``wanted``: only crossings whose sense has this sign, 0: any.
    """

    def __init__(self) -> None:
        self.wanted = 0.0
        self.x = 0.0
        self.y = 0.0
        self.along = 0.0
        self.sense = 0.0

    def find(self, rows: memoryview[float], one: int, other: int) -> int:
        """The first crossing along the second piece: 1 found."""
        if rows[one + 4] == 0.0 and rows[other + 4] == 0.0:
            return self.of_lines(rows, one, other)
        if rows[one + 4] == 1.0 and rows[other + 4] == 1.0:
            return self.of_arcs(rows, one, other)
        if rows[one + 4] == 1.0:
            return self.of_both(rows, other, one, one, other)
        return self.of_both(rows, one, other, one, other)

    def of_lines(self, rows: memoryview[float], one: int, other: int) -> int:
        """Two lines; parallel ones do not cross."""
        x = rows[one + 2] - rows[one]
        y = rows[one + 3] - rows[one + 1]
        x_2 = rows[other + 2] - rows[other]
        y_2 = rows[other + 3] - rows[other + 1]
        size = arithmetic.square_root(x * x + y * y)
        size_2 = arithmetic.square_root(x_2 * x_2 + y_2 * y_2)
        if size <= 1e-9 or size_2 <= 1e-9:
            return 0
        sine = (x * y_2 - y * x_2) / (size * size_2)
        if -1e-6 < sine < 1e-6:
            return 0
        off_x = rows[other] - rows[one]
        off_y = rows[other + 1] - rows[one + 1]
        way = (off_x * y_2 - off_y * x_2) / (size_2 * sine)
        way_2 = (off_x * y - off_y * x) / (size * sine)
        if not -1e-6 <= way < size - 1e-6 or not -1e-6 <= way_2 < size_2 - 1e-6:
            return 0
        self.x = rows[one] + x / size * way
        self.y = rows[one + 1] + y / size * way
        self.along = way_2
        self.sense = sine
        return 1 if sine * self.wanted >= 0.0 else 0

    def of_both(self, rows: memoryview[float], line: int, arc: int, one: int, other: int) -> int:
        """A line and an arc; one that only touches does not cross."""
        x = rows[line + 2] - rows[line]
        y = rows[line + 3] - rows[line + 1]
        size = arithmetic.square_root(x * x + y * y)
        if size <= 1e-9:
            return 0
        x /= size
        y /= size
        off_x = rows[line] - rows[arc + 5]
        off_y = rows[line + 1] - rows[arc + 6]
        across = x * off_y - y * off_x
        middle = -(x * off_x + y * off_y)
        radius = rows[arc + 8]
        if not -radius + 1e-6 < across < radius - 1e-6:
            return 0
        half = arithmetic.square_root((radius - across) * (radius + across))
        found = 0
        for side in range(2):
            way = middle - half if side == 0 else middle + half
            found += self.consider(
                rows, one, other, rows[line] + x * way, rows[line + 1] + y * way, found
            )
        return 1 if found > 0 else 0

    def of_arcs(self, rows: memoryview[float], one: int, other: int) -> int:
        """Two arcs; those that only touch do not cross."""
        x = rows[other + 5] - rows[one + 5]
        y = rows[other + 6] - rows[one + 6]
        apart = arithmetic.square_root(x * x + y * y)
        radius = rows[one + 8]
        radius_2 = rows[other + 8]
        less = radius - radius_2 if radius > radius_2 else radius_2 - radius
        if not less + 1e-6 < apart < radius + radius_2 - 1e-6:
            return 0
        x /= apart
        y /= apart
        along = (apart + (radius - radius_2) * (radius + radius_2) / apart) / 2.0
        half = arithmetic.square_root((radius - along) * (radius + along))
        found = 0
        for side in range(2):
            off = half if side == 0 else -half
            found += self.consider(
                rows,
                one,
                other,
                rows[one + 5] + x * along - y * off,
                rows[one + 6] + y * along + x * off,
                found,
            )
        return 1 if found > 0 else 0

    def consider(
        self, rows: memoryview[float], one: int, other: int, x: float, y: float, found: int
    ) -> int:
        """A place where the whole lines or circles cross: 1 where it is on both, and the first."""
        if self.way_to(rows, one, x, y) < -1.0:
            return 0
        along = self.way_to(rows, other, x, y)
        if along < -1.0 or (found > 0 and along >= self.along):
            return 0
        sense = self.sine(rows, one, other, x, y)
        if sense * self.wanted < 0.0:
            return 0
        self.x = x
        self.y = y
        self.along = along
        self.sense = sense
        return 1

    def way_to(self, rows: memoryview[float], base: int, x: float, y: float) -> float:
        """How far it is along the piece to a place; -2: it is not on it."""
        if rows[base + 4] == 0.0:
            x_2 = rows[base + 2] - rows[base]
            y_2 = rows[base + 3] - rows[base + 1]
            size = arithmetic.square_root(x_2 * x_2 + y_2 * y_2)
            way = ((x - rows[base]) * x_2 + (y - rows[base + 1]) * y_2) / size
        else:
            size = length(rows, base)
            way = angle_to(rows, base, x, y) * rows[base + 8] * 0.017453292519943295
            if rows[base + 7] < 0.0:
                way = -way
        return way if -1e-6 <= way < size - 1e-6 else -2.0

    def sine(self, rows: memoryview[float], one: int, other: int, x: float, y: float) -> float:
        """The sine from the direction of the first piece at a place to that of the second one."""
        x_1 = direction_x(rows, one, y)
        y_1 = direction_y(rows, one, x)
        return x_1 * direction_y(rows, other, x) - y_1 * direction_x(rows, other, y)

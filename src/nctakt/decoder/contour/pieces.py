# SPDX-License-Identifier: MIT
"""Lines and arcs in a plane as rows (``rows.py``), and where two of them cross (MO-9).

A piece has its start, and not its end, so that a corner of a way is on one piece of it.
"""

from __future__ import annotations

from nctakt.decoder.contour import rows
from nctakt.kernel.base import arithmetic


def put_line(
    row: memoryview[float], base: int, shape: int, x: float, y: float, x_2: float, y_2: float
) -> None:
    """Make the row a line or a gap."""
    row[base + rows.START_X] = x
    row[base + rows.START_Y] = y
    row[base + rows.END_X] = x_2
    row[base + rows.END_Y] = y_2
    row[base + rows.SHAPE] = shape
    row[base + rows.ANGLE] = 0.0


def put_arc(
    row: memoryview[float], base: int, centre_x: float, centre_y: float, angle: float
) -> None:
    """Make the row, whose start and end stand in it, an arc."""
    row[base + rows.SHAPE] = rows.ARC
    row[base + rows.CENTRE_X] = centre_x
    row[base + rows.CENTRE_Y] = centre_y
    row[base + rows.ANGLE] = angle
    x = row[base + rows.START_X] - centre_x
    y = row[base + rows.START_Y] - centre_y
    row[base + rows.RADIUS] = arithmetic.square_root(x * x + y * y)


def turn(x: float, y: float, x_2: float, y_2: float) -> float:
    """How far it is from one direction to another, to the left; above -180, up to 180."""
    return arithmetic.arc_tangent_2(x * y_2 - y * x_2, x * x_2 + y * y_2)


def length(row: memoryview[float], base: int) -> float:
    """The way from its start to its end."""
    if row[base + rows.SHAPE] == rows.ARC:
        angle = row[base + rows.ANGLE]
        return row[base + rows.RADIUS] * (angle if angle > 0.0 else -angle) * 0.017453292519943295
    x = row[base + rows.END_X] - row[base + rows.START_X]
    y = row[base + rows.END_Y] - row[base + rows.START_Y]
    return arithmetic.square_root(x * x + y * y)


def bound(row: memoryview[float], base: int) -> None:
    """Put the least and the greatest places of a piece into its row."""
    more = 0.0
    if row[base + rows.SHAPE] == rows.ARC:
        angle = row[base + rows.ANGLE]
        if -180.0 <= angle <= 180.0:
            more = row[base + rows.RADIUS] * (1.0 - arithmetic.cosine(angle / 2.0))
        else:
            more = 2.0 * row[base + rows.RADIUS]
    row[base + rows.MIN_X] = min(row[base + rows.START_X], row[base + rows.END_X]) - more
    row[base + rows.MAX_X] = max(row[base + rows.START_X], row[base + rows.END_X]) + more
    row[base + rows.MIN_Y] = min(row[base + rows.START_Y], row[base + rows.END_Y]) - more
    row[base + rows.MAX_Y] = max(row[base + rows.START_Y], row[base + rows.END_Y]) + more


def are_apart(row: memoryview[float], one: int, other: int) -> int:
    """Whether the bounds of two pieces have nothing in common."""
    if row[one + rows.MAX_X] < row[other + rows.MIN_X]:
        return 1
    if row[other + rows.MAX_X] < row[one + rows.MIN_X]:
        return 1
    if row[one + rows.MAX_Y] < row[other + rows.MIN_Y]:
        return 1
    return 1 if row[other + rows.MAX_Y] < row[one + rows.MIN_Y] else 0


def cut_end(row: memoryview[float], base: int, x: float, y: float) -> None:
    """Let a piece end at this place on it."""
    if row[base + rows.SHAPE] == rows.ARC:
        row[base + rows.ANGLE] = angle_to(row, base, x, y)
    row[base + rows.END_X] = x
    row[base + rows.END_Y] = y
    bound(row, base)


def cut_start(row: memoryview[float], base: int, x: float, y: float) -> None:
    """Let a piece begin at this place on it."""
    if row[base + rows.SHAPE] == rows.ARC:
        row[base + rows.ANGLE] -= angle_to(row, base, x, y)
    row[base + rows.START_X] = x
    row[base + rows.START_Y] = y
    bound(row, base)


def swept(x: float, y: float, x_2: float, y_2: float, sense: float) -> float:
    """From one direction to another in this sense of rotation, with its sign, up to a turn."""
    angle = turn(x, y, x_2, y_2)
    if sense > 0.0 and angle < 0.0:
        angle += 360.0
    elif sense < 0.0 and angle > 0.0:
        angle -= 360.0
    return angle


def angle_to(row: memoryview[float], base: int, x: float, y: float) -> float:
    """From the start of an arc to a place on it, in its sense.

    A place up to 1e-6 mm before the start is there, and not a turn away.
    """
    centre_x = row[base + rows.CENTRE_X]
    centre_y = row[base + rows.CENTRE_Y]
    start_x = row[base + rows.START_X] - centre_x
    start_y = row[base + rows.START_Y] - centre_y
    angle = swept(start_x, start_y, x - centre_x, y - centre_y, row[base + rows.ANGLE])
    turn_ = 360.0 if angle > 0.0 else -360.0
    before = (turn_ - angle) * row[base + rows.RADIUS] * 0.017453292519943295
    return angle - turn_ if -1e-6 <= before <= 1e-6 else angle


def distance(row: memoryview[float], base: int, x: float, y: float) -> float:
    """How far a place is from a line or an arc."""
    if row[base + rows.SHAPE] == rows.ARC:
        angle = angle_to(row, base, x, y)
        whole = row[base + rows.ANGLE]
        if (0.0 <= angle <= whole) or (whole <= angle <= 0.0):
            off_x = x - row[base + rows.CENTRE_X]
            off_y = y - row[base + rows.CENTRE_Y]
            off = arithmetic.square_root(off_x * off_x + off_y * off_y) - row[base + rows.RADIUS]
            return off if off > 0.0 else -off
    else:
        way_x = row[base + rows.END_X] - row[base + rows.START_X]
        way_y = row[base + rows.END_Y] - row[base + rows.START_Y]
        off_x = x - row[base + rows.START_X]
        off_y = y - row[base + rows.START_Y]
        along = off_x * way_x + off_y * way_y
        size2 = way_x * way_x + way_y * way_y
        if 0.0 < along < size2:
            off_x -= way_x * along / size2
            off_y -= way_y * along / size2
            return arithmetic.square_root(off_x * off_x + off_y * off_y)
    off_x = x - row[base + rows.START_X]
    off_y = y - row[base + rows.START_Y]
    start2 = off_x * off_x + off_y * off_y
    off_x = x - row[base + rows.END_X]
    off_y = y - row[base + rows.END_Y]
    return arithmetic.square_root(min(start2, off_x * off_x + off_y * off_y))


def direction_x(row: memoryview[float], base: int, y: float) -> float:
    """The way's direction at a place, its part along the first axis."""
    if row[base + rows.SHAPE] != rows.ARC:
        return (row[base + rows.END_X] - row[base + rows.START_X]) / length(row, base)
    sense = 1.0 if row[base + rows.ANGLE] > 0.0 else -1.0
    return sense * (row[base + rows.CENTRE_Y] - y) / row[base + rows.RADIUS]


def direction_y(row: memoryview[float], base: int, x: float) -> float:
    """The way's direction at a place, its part along the second axis."""
    if row[base + rows.SHAPE] != rows.ARC:
        return (row[base + rows.END_Y] - row[base + rows.START_Y]) / length(row, base)
    sense = 1.0 if row[base + rows.ANGLE] > 0.0 else -1.0
    return sense * (x - row[base + rows.CENTRE_X]) / row[base + rows.RADIUS]


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

    def find(self, row: memoryview[float], one: int, other: int) -> int:
        """The first crossing along the second piece: 1 found."""
        if row[one + rows.SHAPE] == rows.LINE and row[other + rows.SHAPE] == rows.LINE:
            return self.of_lines(row, one, other)
        if row[one + rows.SHAPE] == rows.ARC and row[other + rows.SHAPE] == rows.ARC:
            return self.of_arcs(row, one, other)
        if row[one + rows.SHAPE] == rows.ARC:
            return self.of_both(row, other, one, one, other)
        return self.of_both(row, one, other, one, other)

    def of_lines(self, row: memoryview[float], one: int, other: int) -> int:
        """Two lines; parallel ones do not cross."""
        x = row[one + rows.END_X] - row[one + rows.START_X]
        y = row[one + rows.END_Y] - row[one + rows.START_Y]
        x_2 = row[other + rows.END_X] - row[other + rows.START_X]
        y_2 = row[other + rows.END_Y] - row[other + rows.START_Y]
        size = arithmetic.square_root(x * x + y * y)
        size_2 = arithmetic.square_root(x_2 * x_2 + y_2 * y_2)
        if size <= 1e-9 or size_2 <= 1e-9:
            return 0
        sine = (x * y_2 - y * x_2) / (size * size_2)
        if -1e-6 < sine < 1e-6:
            return 0
        off_x = row[other + rows.START_X] - row[one + rows.START_X]
        off_y = row[other + rows.START_Y] - row[one + rows.START_Y]
        way = (off_x * y_2 - off_y * x_2) / (size_2 * sine)
        way_2 = (off_x * y - off_y * x) / (size * sine)
        if not -1e-6 <= way < size - 1e-6 or not -1e-6 <= way_2 < size_2 - 1e-6:
            return 0
        self.x = row[one + rows.START_X] + x / size * way
        self.y = row[one + rows.START_Y] + y / size * way
        self.along = way_2
        self.sense = sine
        return 1 if sine * self.wanted >= 0.0 else 0

    def of_both(self, row: memoryview[float], line: int, arc: int, one: int, other: int) -> int:
        """A line and an arc; one that only touches does not cross."""
        x = row[line + rows.END_X] - row[line + rows.START_X]
        y = row[line + rows.END_Y] - row[line + rows.START_Y]
        size = arithmetic.square_root(x * x + y * y)
        if size <= 1e-9:
            return 0
        x /= size
        y /= size
        off_x = row[line + rows.START_X] - row[arc + rows.CENTRE_X]
        off_y = row[line + rows.START_Y] - row[arc + rows.CENTRE_Y]
        across = x * off_y - y * off_x
        middle = -(x * off_x + y * off_y)
        radius = row[arc + rows.RADIUS]
        if not -radius + 1e-6 < across < radius - 1e-6:
            return 0
        half = arithmetic.square_root((radius - across) * (radius + across))
        found = 0
        for side in range(2):
            way = middle - half if side == 0 else middle + half
            at_x = row[line + rows.START_X] + x * way
            at_y = row[line + rows.START_Y] + y * way
            found += self.consider(row, one, other, at_x, at_y, found)
        return 1 if found > 0 else 0

    def of_arcs(self, row: memoryview[float], one: int, other: int) -> int:
        """Two arcs; those that only touch do not cross."""
        x = row[other + rows.CENTRE_X] - row[one + rows.CENTRE_X]
        y = row[other + rows.CENTRE_Y] - row[one + rows.CENTRE_Y]
        apart = arithmetic.square_root(x * x + y * y)
        radius = row[one + rows.RADIUS]
        radius_2 = row[other + rows.RADIUS]
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
            at_x = row[one + rows.CENTRE_X] + x * along - y * off
            at_y = row[one + rows.CENTRE_Y] + y * along + x * off
            found += self.consider(row, one, other, at_x, at_y, found)
        return 1 if found > 0 else 0

    def consider(
        self, row: memoryview[float], one: int, other: int, x: float, y: float, found: int
    ) -> int:
        """A place where the whole lines or circles cross: 1 where it is on both, and the first."""
        if self.way_to(row, one, x, y) < -1.0:
            return 0
        along = self.way_to(row, other, x, y)
        if along < -1.0 or (found > 0 and along >= self.along):
            return 0
        sense = self.sine(row, one, other, x, y)
        if sense * self.wanted < 0.0:
            return 0
        self.x = x
        self.y = y
        self.along = along
        self.sense = sense
        return 1

    def way_to(self, row: memoryview[float], base: int, x: float, y: float) -> float:
        """How far it is along the piece to a place; -2: it is not on it."""
        if row[base + rows.SHAPE] == rows.LINE:
            x_2 = row[base + rows.END_X] - row[base + rows.START_X]
            y_2 = row[base + rows.END_Y] - row[base + rows.START_Y]
            size = arithmetic.square_root(x_2 * x_2 + y_2 * y_2)
            off_x = x - row[base + rows.START_X]
            off_y = y - row[base + rows.START_Y]
            way = (off_x * x_2 + off_y * y_2) / size
        else:
            size = length(row, base)
            way = angle_to(row, base, x, y) * row[base + rows.RADIUS] * 0.017453292519943295
            if row[base + rows.ANGLE] < 0.0:
                way = -way
        return way if -1e-6 <= way < size - 1e-6 else -2.0

    def sine(self, row: memoryview[float], one: int, other: int, x: float, y: float) -> float:
        """The sine from the direction of the first piece at a place to that of the second one."""
        x_1 = direction_x(row, one, y)
        y_1 = direction_y(row, one, x)
        return x_1 * direction_y(row, other, x) - y_1 * direction_x(row, other, y)

# SPDX-License-Identifier: MIT
"""Lines and arcs in a plane as rows (``rows.py``), and where two of them cross (MO-9).

A piece has its start, and not its end, so that a corner of a path is on one piece of it.
"""

from __future__ import annotations

from nctakt.decoder.contour import rows
from nctakt.kernel.base import arithmetic


def put_line(
    table: memoryview[float], row: int, shape: int, x: float, y: float, x_2: float, y_2: float
) -> None:
    """Make the row a line or a gap."""
    table[row + rows.START_X] = x
    table[row + rows.START_Y] = y
    table[row + rows.END_X] = x_2
    table[row + rows.END_Y] = y_2
    table[row + rows.SHAPE] = shape
    table[row + rows.ANGLE] = 0.0


def put_arc(
    table: memoryview[float], row: int, centre_x: float, centre_y: float, angle: float
) -> None:
    """Make the row, whose start and end are in it, an arc."""
    table[row + rows.SHAPE] = rows.ARC
    table[row + rows.CENTRE_X] = centre_x
    table[row + rows.CENTRE_Y] = centre_y
    table[row + rows.ANGLE] = angle
    x = table[row + rows.START_X] - centre_x
    y = table[row + rows.START_Y] - centre_y
    table[row + rows.RADIUS] = arithmetic.square_root(x * x + y * y)


def turn(x: float, y: float, x_2: float, y_2: float) -> float:
    """Angle from one direction to another in degrees, to the left; above -180, up to 180."""
    return arithmetic.arc_tangent_2(x * y_2 - y * x_2, x * x_2 + y * y_2)


def length(table: memoryview[float], row: int) -> float:
    """Length of a piece in mm."""
    if table[row + rows.SHAPE] == rows.ARC:
        angle = table[row + rows.ANGLE]
        return table[row + rows.RADIUS] * (angle if angle > 0.0 else -angle) * 0.017453292519943295
    x = table[row + rows.END_X] - table[row + rows.START_X]
    y = table[row + rows.END_Y] - table[row + rows.START_Y]
    return arithmetic.square_root(x * x + y * y)


def bound(table: memoryview[float], row: int) -> None:
    """Put the lowest and the highest coordinates of a piece into its row."""
    more = 0.0
    if table[row + rows.SHAPE] == rows.ARC:
        angle = table[row + rows.ANGLE]
        if -180.0 <= angle <= 180.0:
            more = table[row + rows.RADIUS] * (1.0 - arithmetic.cosine(angle / 2.0))
        else:
            more = 2.0 * table[row + rows.RADIUS]
    table[row + rows.MIN_X] = min(table[row + rows.START_X], table[row + rows.END_X]) - more
    table[row + rows.MAX_X] = max(table[row + rows.START_X], table[row + rows.END_X]) + more
    table[row + rows.MIN_Y] = min(table[row + rows.START_Y], table[row + rows.END_Y]) - more
    table[row + rows.MAX_Y] = max(table[row + rows.START_Y], table[row + rows.END_Y]) + more


def overlapping(table: memoryview[float], piece: int, first: int, oldest: float, row: int) -> int:
    """Return the newest piece of the contour whose bounds have something in common with a row's.

    It is one from ``piece`` down to ``first``, of a motion from ``oldest`` on; -1 without one.
    """
    min_x = table[row + rows.MIN_X]
    max_x = table[row + rows.MAX_X]
    min_y = table[row + rows.MIN_Y]
    max_y = table[row + rows.MAX_Y]
    while piece >= first:
        begin = piece * rows.PIECE_WIDTH
        if table[begin + rows.MOTION] < oldest:
            return -1
        if table[begin + rows.MIN_X] <= max_x and min_x <= table[begin + rows.MAX_X]:
            if table[begin + rows.MIN_Y] <= max_y and min_y <= table[begin + rows.MAX_Y]:
                if table[begin + rows.IS_CONTOUR] != 0.0:
                    return piece
        piece -= 1
    return -1


def cut_end(table: memoryview[float], row: int, x: float, y: float) -> None:
    """Let a piece end at a point on it."""
    if table[row + rows.SHAPE] == rows.ARC:
        table[row + rows.ANGLE] = angle_to(table, row, x, y)
    table[row + rows.END_X] = x
    table[row + rows.END_Y] = y
    bound(table, row)


def cut_start(table: memoryview[float], row: int, x: float, y: float) -> None:
    """Let a piece begin at a point on it."""
    if table[row + rows.SHAPE] == rows.ARC:
        table[row + rows.ANGLE] -= angle_to(table, row, x, y)
    table[row + rows.START_X] = x
    table[row + rows.START_Y] = y
    bound(table, row)


def swept(x: float, y: float, x_2: float, y_2: float, sense: float) -> float:
    """Angle from one direction to another in this sense of rotation, up to a full turn."""
    angle = turn(x, y, x_2, y_2)
    if sense > 0.0 and angle < 0.0:
        angle += 360.0
    elif sense < 0.0 and angle > 0.0:
        angle -= 360.0
    return angle


def angle_to(table: memoryview[float], row: int, x: float, y: float) -> float:
    """Angle in degrees from the start of an arc to a point on it, in its sense.

    A point up to 1e-6 mm before the start counts as the start, and not as a turn away.
    """
    centre_x = table[row + rows.CENTRE_X]
    centre_y = table[row + rows.CENTRE_Y]
    start_x = table[row + rows.START_X] - centre_x
    start_y = table[row + rows.START_Y] - centre_y
    angle = swept(start_x, start_y, x - centre_x, y - centre_y, table[row + rows.ANGLE])
    turn_ = 360.0 if angle > 0.0 else -360.0
    before = (turn_ - angle) * table[row + rows.RADIUS] * 0.017453292519943295
    return angle - turn_ if -1e-6 <= before <= 1e-6 else angle


def distance(table: memoryview[float], row: int, x: float, y: float) -> float:
    """Distance in mm of a point from a line or an arc."""
    if table[row + rows.SHAPE] == rows.ARC:
        angle = angle_to(table, row, x, y)
        whole = table[row + rows.ANGLE]
        if (0.0 <= angle <= whole) or (whole <= angle <= 0.0):
            off_x = x - table[row + rows.CENTRE_X]
            off_y = y - table[row + rows.CENTRE_Y]
            off = arithmetic.square_root(off_x * off_x + off_y * off_y) - table[row + rows.RADIUS]
            return off if off > 0.0 else -off
    else:
        chord_x = table[row + rows.END_X] - table[row + rows.START_X]
        chord_y = table[row + rows.END_Y] - table[row + rows.START_Y]
        off_x = x - table[row + rows.START_X]
        off_y = y - table[row + rows.START_Y]
        along = off_x * chord_x + off_y * chord_y
        size2 = chord_x * chord_x + chord_y * chord_y
        if 0.0 < along < size2:
            off_x -= chord_x * along / size2
            off_y -= chord_y * along / size2
            return arithmetic.square_root(off_x * off_x + off_y * off_y)
    off_x = x - table[row + rows.START_X]
    off_y = y - table[row + rows.START_Y]
    start2 = off_x * off_x + off_y * off_y
    off_x = x - table[row + rows.END_X]
    off_y = y - table[row + rows.END_Y]
    return arithmetic.square_root(min(start2, off_x * off_x + off_y * off_y))


def direction_x(table: memoryview[float], row: int, y: float) -> float:
    """Direction of a piece at a point, its part along the first axis."""
    if table[row + rows.SHAPE] != rows.ARC:
        return (table[row + rows.END_X] - table[row + rows.START_X]) / length(table, row)
    sense = 1.0 if table[row + rows.ANGLE] > 0.0 else -1.0
    return sense * (table[row + rows.CENTRE_Y] - y) / table[row + rows.RADIUS]


def direction_y(table: memoryview[float], row: int, x: float) -> float:
    """Direction of a piece at a point, its part along the second axis."""
    if table[row + rows.SHAPE] != rows.ARC:
        return (table[row + rows.END_Y] - table[row + rows.START_Y]) / length(table, row)
    sense = 1.0 if table[row + rows.ANGLE] > 0.0 else -1.0
    return sense * (x - table[row + rows.CENTRE_X]) / table[row + rows.RADIUS]


class Crossing:
    """Crossing of two pieces.

    ``x``, ``y``: the point. ``along``: how far it is along the second one, mm. ``sense``: the sine
    from the first one's direction to the second one's, above 0 where that crosses to the left.
    ``required_sense``: only crossings whose sense has this sign, 0: any.
    """

    def __init__(self) -> None:
        self.required_sense = 0.0
        self.x = 0.0
        self.y = 0.0
        self.along = 0.0
        self.sense = 0.0

    def find(self, table: memoryview[float], first: int, second: int) -> int:
        """Find the first crossing along the second piece; return 1 if there is one."""
        if table[first + rows.SHAPE] == rows.LINE and table[second + rows.SHAPE] == rows.LINE:
            return self.of_lines(table, first, second)
        if table[first + rows.SHAPE] == rows.ARC and table[second + rows.SHAPE] == rows.ARC:
            return self.of_arcs(table, first, second)
        if table[first + rows.SHAPE] == rows.ARC:
            return self.of_both(table, second, first, first, second)
        return self.of_both(table, first, second, first, second)

    def of_lines(self, table: memoryview[float], first: int, second: int) -> int:
        """Find the crossing of two lines; parallel ones do not cross."""
        x = table[first + rows.END_X] - table[first + rows.START_X]
        y = table[first + rows.END_Y] - table[first + rows.START_Y]
        x_2 = table[second + rows.END_X] - table[second + rows.START_X]
        y_2 = table[second + rows.END_Y] - table[second + rows.START_Y]
        size = arithmetic.square_root(x * x + y * y)
        size_2 = arithmetic.square_root(x_2 * x_2 + y_2 * y_2)
        if size <= 1e-9 or size_2 <= 1e-9:
            return 0
        sine = (x * y_2 - y * x_2) / (size * size_2)
        if -1e-6 < sine < 1e-6:
            return 0
        off_x = table[second + rows.START_X] - table[first + rows.START_X]
        off_y = table[second + rows.START_Y] - table[first + rows.START_Y]
        along = (off_x * y_2 - off_y * x_2) / (size_2 * sine)
        along_2 = (off_x * y - off_y * x) / (size * sine)
        if not -1e-6 <= along < size - 1e-6 or not -1e-6 <= along_2 < size_2 - 1e-6:
            return 0
        self.x = table[first + rows.START_X] + x / size * along
        self.y = table[first + rows.START_Y] + y / size * along
        self.along = along_2
        self.sense = sine
        return 1 if sine * self.required_sense >= 0.0 else 0

    def of_both(
        self, table: memoryview[float], line: int, arc: int, first: int, second: int
    ) -> int:
        """Find the crossing of a line and an arc; touching does not count."""
        x = table[line + rows.END_X] - table[line + rows.START_X]
        y = table[line + rows.END_Y] - table[line + rows.START_Y]
        size = arithmetic.square_root(x * x + y * y)
        if size <= 1e-9:
            return 0
        x /= size
        y /= size
        off_x = table[line + rows.START_X] - table[arc + rows.CENTRE_X]
        off_y = table[line + rows.START_Y] - table[arc + rows.CENTRE_Y]
        across = x * off_y - y * off_x
        middle = -(x * off_x + y * off_y)
        radius = table[arc + rows.RADIUS]
        if not -radius + 1e-6 < across < radius - 1e-6:
            return 0
        half = arithmetic.square_root((radius - across) * (radius + across))
        count = 0
        for side in range(2):
            along = middle - half if side == 0 else middle + half
            at_x = table[line + rows.START_X] + x * along
            at_y = table[line + rows.START_Y] + y * along
            count += self.consider(table, first, second, at_x, at_y, count)
        return 1 if count > 0 else 0

    def of_arcs(self, table: memoryview[float], first: int, second: int) -> int:
        """Find the crossing of two arcs; those that only touch do not cross."""
        x = table[second + rows.CENTRE_X] - table[first + rows.CENTRE_X]
        y = table[second + rows.CENTRE_Y] - table[first + rows.CENTRE_Y]
        apart = arithmetic.square_root(x * x + y * y)
        radius = table[first + rows.RADIUS]
        radius_2 = table[second + rows.RADIUS]
        less = radius - radius_2 if radius > radius_2 else radius_2 - radius
        if not less + 1e-6 < apart < radius + radius_2 - 1e-6:
            return 0
        x /= apart
        y /= apart
        along = (apart + (radius - radius_2) * (radius + radius_2) / apart) / 2.0
        half = arithmetic.square_root((radius - along) * (radius + along))
        count = 0
        for side in range(2):
            off = half if side == 0 else -half
            at_x = table[first + rows.CENTRE_X] + x * along - y * off
            at_y = table[first + rows.CENTRE_Y] + y * along + x * off
            count += self.consider(table, first, second, at_x, at_y, count)
        return 1 if count > 0 else 0

    def consider(
        self, table: memoryview[float], first: int, second: int, x: float, y: float, count: int
    ) -> int:
        """Keep a crossing if it is on both pieces and the first; return 1 if kept."""
        if self.distance_along(table, first, x, y) < -1.0:
            return 0
        along = self.distance_along(table, second, x, y)
        if along < -1.0 or (count > 0 and along >= self.along):
            return 0
        sense = self.sine(table, first, second, x, y)
        if sense * self.required_sense < 0.0:
            return 0
        self.x = x
        self.y = y
        self.along = along
        self.sense = sense
        return 1

    def distance_along(self, table: memoryview[float], row: int, x: float, y: float) -> float:
        """Distance along the piece to a point in mm; -2 if it is not on the piece."""
        if table[row + rows.SHAPE] == rows.LINE:
            x_2 = table[row + rows.END_X] - table[row + rows.START_X]
            y_2 = table[row + rows.END_Y] - table[row + rows.START_Y]
            size = arithmetic.square_root(x_2 * x_2 + y_2 * y_2)
            off_x = x - table[row + rows.START_X]
            off_y = y - table[row + rows.START_Y]
            length_to = (off_x * x_2 + off_y * y_2) / size
        else:
            size = length(table, row)
            length_to = angle_to(table, row, x, y) * table[row + rows.RADIUS] * 0.017453292519943295
            if table[row + rows.ANGLE] < 0.0:
                length_to = -length_to
        return length_to if -1e-6 <= length_to < size - 1e-6 else -2.0

    def sine(self, table: memoryview[float], first: int, second: int, x: float, y: float) -> float:
        """Sine from the direction of the first piece at a point to the second one's."""
        x_1 = direction_x(table, first, y)
        y_1 = direction_y(table, first, x)
        return x_1 * direction_y(table, second, x) - y_1 * direction_x(table, second, y)

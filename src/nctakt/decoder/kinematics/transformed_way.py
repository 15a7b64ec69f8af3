# SPDX-License-Identifier: MIT
"""The way of the machine's axes on a transformed block, against their software limits.

In: a line or an arc of programmed positions, the limits of the axes. Out: the first axis that
leaves its limits, and how far it would go. The way is sampled at least every one and a half degrees
of what turns on it; between three samples the vertex of the parabola through them counts.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.axes.transformations import Transformations
from nctakt.kernel.base import arithmetic

#: Degrees between two samples.
STEP = 1.5


class TransformedWay:
    """The limits of one channel's axes; ``number``: the map; ``position``: what was found last."""

    def __init__(self, count: int, transformations: Transformations) -> None:
        room = 8 * max(1, count)
        self.count = count
        self.transformations = transformations
        self.number = 0
        self.position = 0.0
        self.lows = memoryview(bytearray(room)).cast("d")
        self.highs = memoryview(bytearray(room)).cast("d")
        self.start = memoryview(bytearray(room)).cast("d")
        self.target = memoryview(bytearray(room)).cast("d")
        self.arc = memoryview(bytearray(8 * rows.ARC_WIDTH)).cast("d")
        self.point = memoryview(bytearray(room)).cast("d")
        self.near = memoryview(bytearray(room)).cast("d")
        self.newest = memoryview(bytearray(room)).cast("d")
        self.middle = memoryview(bytearray(room)).cast("d")
        self.before = memoryview(bytearray(room)).cast("d")

    def limit(self, axis: int, low: float, high: float) -> None:
        """Set the software limits of an axis."""
        self.lows[axis] = low
        self.highs[axis] = high

    def first_outside(self, start: list[float], target: list[float], arc: list[float]) -> int:
        """Return the first axis outside its limits on a block, -1 for none; no ``arc``: a line."""
        for i in range(self.count):
            self.start[i] = start[i]
            self.target[i] = target[i]
        for i in range(rows.ARC_WIDTH):
            self.arc[i] = arc[i] if arc else 0.0
        return self.check(1 if arc else 0)

    def first_outside_of_line(self, start: memoryview[float], target: memoryview[float]) -> int:
        """``first_outside`` of a line, without objects."""
        for i in range(self.count):
            self.start[i] = start[i]
            self.target[i] = target[i]
        return self.check(0)

    def check(self, is_arc: int) -> int:
        """Return the first axis outside its limits between ``start`` and ``target``, else -1."""
        turn = self.transformations.rotation(self.number, self.start, self.target)
        if is_arc:
            angle = self.arc[rows.ANGLE]
            turn += angle if angle >= 0.0 else 0.0 - angle
        steps = 1
        if turn > 1e-9:
            steps = int(turn / STEP)
            steps += 2
        for sample in range(1 if steps == 1 else 0, steps + 1):
            for i in range(self.count):
                self.before[i] = self.middle[i]
                self.middle[i] = self.newest[i]
            self.sample(sample / steps, is_arc)
            for i in range(self.count):
                if not self.is_inside(i, self.newest[i]):
                    return i
                if sample >= 2 and not self.is_inside(i, self.vertex(i)):
                    return i
        return -1

    def is_inside(self, i: int, position: float) -> int:
        """Return whether a position of an axis is within its limits; keep it."""
        self.position = position
        return 1 if self.lows[i] <= position <= self.highs[i] else 0

    def vertex(self, i: int) -> float:
        """Return the extreme of the parabola through three samples, if it lies between them."""
        rise = 0.5 * (self.newest[i] - self.before[i])
        bend = self.newest[i] - 2.0 * self.middle[i] + self.before[i]
        if (rise < bend and 0.0 - rise < bend) or (rise > bend and 0.0 - rise > bend):
            return self.middle[i] - 0.5 * rise * rise / bend
        return self.middle[i]

    def sample(self, part: float, is_arc: int) -> None:
        """Put the positions of the axes after ``part`` of the block into ``newest``."""
        for i in range(self.count):
            self.point[i] = self.start[i] + (self.target[i] - self.start[i]) * part
        if part == 1.0:
            for i in range(self.count):
                self.point[i] = self.target[i]
        elif is_arc:
            first = int(self.arc[rows.PLANE_FIRST])
            second = int(self.arc[rows.PLANE_SECOND])
            cosine = arithmetic.cosine(self.arc[rows.ANGLE] * part)
            sine = arithmetic.sine(self.arc[rows.ANGLE] * part)
            x = self.start[first] - self.arc[rows.CENTRE_FIRST]
            y = self.start[second] - self.arc[rows.CENTRE_SECOND]
            self.point[first] = self.arc[rows.CENTRE_FIRST] + x * cosine - y * sine
            self.point[second] = self.arc[rows.CENTRE_SECOND] + x * sine + y * cosine
        for i in range(self.count):
            self.near[i] = self.middle[i]
        self.transformations.maps.inverse(self.number, self.point, self.near, self.newest)

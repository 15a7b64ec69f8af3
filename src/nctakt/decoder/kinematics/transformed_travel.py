# SPDX-License-Identifier: MIT
"""The paths of the machine's axes on a transformed block, against their software limits.

In: a line or an arc of programmed positions, the limits of the axes. Out: the first axis that
leaves its limits, and how far it would go; or why the axes cannot follow. The path is sampled at
least every one and a half degrees of rotation; between three samples the vertex of the parabola
through them counts. Where rotary axes turn differently from what is programmed, there are enough
samples to keep their steps as small: near a pole, where an axis turns far within a short distance.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.axes.transformations import Transformations
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.kinematics import map_rows

#: Degrees between two samples.
STEP = 1.5
#: Degrees between the finest samples above which an axis would have to jump, and how many they are.
JUMP = 3.0
MAX_SAMPLES = 2048
#: A block that begins in a pole turns at once into its direction: by how many degrees an axis may
#: have turned after this share of a block.
BEGIN_JUMP = 0.001
BEGIN = 1e-9


class TransformedTravel:
    """The limits of one channel's axes; ``number``: the map; ``position``: the last result.

    ``obstacle``: ``map_rows.AXIS_OUTSIDE`` …, the last result.
    """

    def __init__(self, count: int, transformations: Transformations) -> None:
        room = max(1, count)
        self.count = count
        self.transformations = transformations
        self.number = 0
        self.position = 0.0
        self.obstacle = map_rows.AXIS_OUTSIDE
        self.lows = doubles(room)
        self.highs = doubles(room)
        self.start = doubles(room)
        self.target = doubles(room)
        self.arc = doubles(rows.ARC_WIDTH)
        self.point = doubles(room)
        self.near = doubles(room)
        self.newest = doubles(room)
        self.middle = doubles(room)
        self.before = doubles(room)
        self.begin = doubles(room)

    def limit(self, axis: int, low: float, high: float) -> None:
        """Set the software limits of an axis."""
        self.lows[axis] = low
        self.highs[axis] = high

    def start_at(self, axes: list[float]) -> None:
        """Set positions of the axes: of two solutions the next block starts at the nearer one."""
        for i in range(self.count):
            self.newest[i] = axes[i]

    def axes_at_end(self) -> list[float]:
        """Return where the axes are after the last block."""
        return list(self.newest)

    def first_outside(self, start: list[float], target: list[float], arc: list[float]) -> int:
        """Return the first axis outside its limits on a block, -1 for none; no ``arc``: a line."""
        for i in range(self.count):
            self.start[i] = start[i]
            self.target[i] = target[i]
        for i in range(rows.ARC_WIDTH):
            self.arc[i] = arc[i] if arc else 0.0
        return self.find(1 if arc else 0)

    def first_outside_of_line(self, start: memoryview[float], target: memoryview[float]) -> int:
        """``first_outside`` of a line, without objects."""
        for i in range(self.count):
            self.start[i] = start[i]
            self.target[i] = target[i]
        return self.find(0)

    def find(self, is_arc: int) -> int:
        """Return the first axis that cannot follow between ``start`` and ``target``, else -1."""
        if not self.transformations.turns_otherwise(self.number):
            return self.check(is_arc, self.steps_of_turn(is_arc))
        steps = max(2, self.steps_of_turn(is_arc))
        for i in range(self.count):
            self.begin[i] = self.newest[i]
        axis = self.jump_at_begin(is_arc)
        for i in range(self.count):
            self.newest[i] = self.begin[i]
        if axis >= 0:
            return axis
        while True:
            steps *= 2
            axis = self.widest_turn(is_arc, steps)
            for i in range(self.count):
                self.newest[i] = self.begin[i]
            if axis < 0:
                return self.check(is_arc, steps)
            if steps >= MAX_SAMPLES or self.obstacle == map_rows.WAY_OUT_OF_REACH:
                return axis

    def jump_at_begin(self, is_arc: int) -> int:
        """Return the axis that would have to jump where the block begins, -1 for none."""
        if self.sample(0.0, is_arc) != map_rows.REACHED:
            return -1
        for i in range(self.count):
            self.middle[i] = self.newest[i]
        if self.sample(BEGIN, is_arc) != map_rows.REACHED:
            return -1
        for i in range(self.count):
            turn = self.newest[i] - self.middle[i]
            turn = turn if turn >= 0.0 else 0.0 - turn
            if turn > BEGIN_JUMP and self.transformations.is_rotary(self.number, i):
                self.obstacle = map_rows.AXIS_JUMPS
                self.position = turn
                return i
        return -1

    def widest_turn(self, is_arc: int, steps: int) -> int:
        """Return the axis that turns farthest between two samples, above ``JUMP``; else -1."""
        widest = JUMP
        found = -1
        if self.sample(0.0, is_arc) != map_rows.REACHED:
            self.obstacle = map_rows.WAY_OUT_OF_REACH
            return 0
        for sample in range(1, steps + 1):
            for i in range(self.count):
                self.middle[i] = self.newest[i]
            if self.sample(1.0 * sample / steps, is_arc) != map_rows.REACHED:
                self.obstacle = map_rows.WAY_OUT_OF_REACH
                return 0
            for i in range(self.count):
                turn = self.newest[i] - self.middle[i]
                turn = turn if turn >= 0.0 else 0.0 - turn
                if turn > widest and self.transformations.is_rotary(self.number, i):
                    widest = turn
                    found = i
        self.obstacle = map_rows.AXIS_JUMPS
        self.position = widest
        return found

    def steps_of_turn(self, is_arc: int) -> int:
        """Return how many samples a block needs on which rotary axes turn as programmed."""
        turn = self.transformations.rotation(self.number, self.start, self.target)
        if is_arc:
            angle = self.arc[rows.ANGLE]
            turn += angle if angle >= 0.0 else 0.0 - angle
        steps = 1
        if turn > 1e-9:
            steps = int(turn / STEP)
            steps += 2
        return steps

    def check(self, is_arc: int, steps: int) -> int:
        """Return the first axis outside its limits between ``start`` and ``target``, else -1."""
        self.obstacle = map_rows.AXIS_OUTSIDE
        for sample in range(1 if steps == 1 else 0, steps + 1):
            for i in range(self.count):
                self.before[i] = self.middle[i]
                self.middle[i] = self.newest[i]
            self.sample(1.0 * sample / steps, is_arc)
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

    def sample(self, part: float, is_arc: int) -> int:
        """Put the positions of the axes after ``part`` of the block into ``newest``.

        Return as ``KinematicMaps.inverse``.
        """
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
            self.near[i] = self.newest[i]
        return self.transformations.maps.inverse(self.number, self.point, self.near, self.newest)

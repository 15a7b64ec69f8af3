# SPDX-License-Identifier: MIT
"""Limits of the axes on a transformed segment or cubic, from positions over its length (MO-1).

The map bends the motion of the axes where rotary axes turn. A segment is sampled at least every
three degrees of rotation; differences of the samples give the change of each axis with the length
s, once, twice and thrice. With the speed v, the acceleration a and the jerk j along the segment an
axis q has the speed q'·v, the acceleration q'·a + q''·v² and the jerk q'·j + 3·q''·v·a + q'''·v³;
in the last two, the bend terms may each take a share, and the rest is left for the first term.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.axes.transformations import Transformations
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.path import cubic

#: Degrees between two samples: at most, and on shorter turns at least.
MAX_STEP = 3.0
#: Degrees that a piece of a spline counts as.
CUBIC_TURN = 48.0
MIN_STEP = 1.5
#: Degrees between the samples for the direction at an end.
END_STEP = 0.1
#: Maximum number of samples of a segment on which the axes turn differently from what is
#: programmed.
MAX_SAMPLES = 4096
#: Relative error allowed for differences of samples.
MARGIN = 1.01
#: Shares of acceleration and jerk that the bend takes at most, of the jerk with its two terms.
BEND_A = 0.4
BEND_J = 0.1
BEND_RAMP_J = 0.15


class TransformedLimits:
    """The samples of one channel's newest transformed segment.

    ``first``, ``second``, ``third``: the largest changes of each axis with the length; ``entering``
    … ``leaving_curve``: first and second change at its start and its end. ``turn``: the degrees by
    which anything turns on it, 0: the axes move straight; ``is_even``: evenly all along.
    ``free_a``, ``free_j``: the shares of acceleration and jerk that a bend leaves at least.
    """

    def __init__(self, count: int, linear: memoryview[int], places: int) -> None:
        self.count = count
        self.linear = linear
        self.room = places
        room = places
        self.rapid_v = doubles(room)
        self.max_v = doubles(room)
        self.axis_a = doubles(room)
        self.axis_j = doubles(room)
        self.transformations = Transformations(1)
        self.free_a = 1.0 - BEND_A
        self.free_j = 1.0 - BEND_J - BEND_RAMP_J
        self.turn = 0.0
        self.steps = 1
        self.is_even = True
        self.plane_axis = -1
        self.near = doubles(room)
        self.point = doubles(room)
        self.start = doubles(room)
        self.target = doubles(room)
        self.samples = doubles(4 * room)
        self.result = doubles(room)
        self.first = doubles(room)
        self.second = doubles(room)
        self.third = doubles(room)
        self.entering = doubles(room)
        self.leaving = doubles(room)
        self.entering_curve = doubles(room)
        self.leaving_curve = doubles(room)

    def start_at(self, axes: memoryview[float], members: memoryview[int]) -> None:
        """Take where the axes are: of two solutions the next segment starts at the nearer one."""
        for i in range(self.count):
            self.near[i] = axes[members[i]]

    def set_count(self, count: int) -> None:
        """Let there be ``count`` axes; raise ``ValueError`` if there is no room for them."""
        check_range(count, 0, self.room, "number of axes")
        self.count = count

    def transform(self, number: int) -> None:
        """Count a rotary axis as a linear one from the next segment on where a map has it in mm."""
        if self.plane_axis >= 0:
            self.linear[self.plane_axis] = 0
        self.plane_axis = self.transformations.plane_axis(number)
        if self.plane_axis >= 0:
            self.linear[self.plane_axis] = 1

    def share(self, transformations: Transformations) -> None:
        """Use the maps of the machine."""
        self.transformations = transformations

    def limit(
        self,
        rapid_v: memoryview[float],
        max_v: memoryview[float],
        axis_a: memoryview[float],
        axis_j: memoryview[float],
    ) -> None:
        """Share the axes' speeds, and their accelerations and jerks on the newest segment."""
        self.rapid_v = rapid_v
        self.max_v = max_v
        self.axis_a = axis_a
        self.axis_j = axis_j

    def locate(self, segments: memoryview[float], row: int, part: float, sample: int) -> None:
        """Put the axes after ``part`` of a segment into a sample; beyond the ends it continues."""
        start = row + rows.START
        target = start + self.count
        for i in range(self.count):
            begin = segments[start + i]
            self.point[i] = begin + (segments[target + i] - begin) * part
        if segments[row + rows.SHAPE] == rows.ARC:
            first = int(segments[row + rows.ARC_FIRST_AXIS])
            second = int(segments[row + rows.ARC_SECOND_AXIS])
            angle = segments[row + rows.ARC_ANGLE] * part
            cosine = arithmetic.cosine(angle)
            sine = arithmetic.sine(angle)
            x = segments[start + first] - segments[row + rows.ARC_FIRST_CENTRE]
            y = segments[start + second] - segments[row + rows.ARC_SECOND_CENTRE]
            self.point[first] = segments[row + rows.ARC_FIRST_CENTRE] + x * cosine - y * sine
            self.point[second] = segments[row + rows.ARC_SECOND_CENTRE] + x * sine + y * cosine
        if cubic.is_cubic(segments, row):
            cubic.locate(segments, row, self.count, part, self.point)
        number = int(segments[row + rows.TRANSFORMATION])
        self.transformations.maps.inverse(number, self.point, self.near, self.result)
        for i in range(self.count):
            self.near[i] = self.result[i]
            self.samples[self.count * sample + i] = self.result[i]

    def measure_turn(self, segments: memoryview[float], row: int) -> None:
        """Settle by how many degrees anything turns on a segment."""
        start = row + rows.START
        for i in range(self.count):
            self.start[i] = segments[start + i]
            self.target[i] = segments[start + self.count + i]
        number = int(segments[row + rows.TRANSFORMATION])
        arc = 0.0
        if segments[row + rows.SHAPE] == rows.ARC:
            angle = segments[row + rows.ARC_ANGLE]
            arc = angle if angle >= 0.0 else 0.0 - angle
        if cubic.is_cubic(segments, row):
            arc = CUBIC_TURN
        self.is_even = not self.transformations.turns_otherwise(number)
        if not self.is_even:
            self.count_samples(segments, row, number, arc)
            return
        self.turn = arc + self.transformations.rotation(number, self.start, self.target)
        self.steps = int(self.turn / MAX_STEP)
        self.steps += 1

    def count_samples(self, segments: memoryview[float], row: int, number: int, arc: float) -> None:
        """Compute the turn, and how many samples keep the turn between two of them small.

        Near a pole an axis turns far within a short distance. ``arc``: the angle of an arc in
        degrees.
        """
        for i in range(self.count):
            self.first[i] = self.near[i]
        self.steps = 2
        while True:
            self.steps *= 2
            self.turn = arc
            widest = 0.0
            for i in range(self.count):
                self.near[i] = self.first[i]
            self.locate(segments, row, 0.0, 0)
            for k in range(1, self.steps + 1):
                for i in range(self.count):
                    self.start[i] = self.near[i]
                self.locate(segments, row, 1.0 * k / self.steps, 0)
                angle = self.transformations.rotation(number, self.start, self.near)
                self.turn += angle
                widest = max(widest, angle + arc / self.steps)
            if widest <= MAX_STEP or self.steps >= MAX_SAMPLES:
                return

    def survey(self, segments: memoryview[float], row: int) -> None:
        """Sample a segment whose length is known."""
        self.measure_turn(segments, row)
        length = segments[row + rows.LENGTH]
        for i in range(self.count):
            self.second[i] = 0.0
            self.third[i] = 0.0
            self.entering_curve[i] = 0.0
            self.leaving_curve[i] = 0.0
        if self.turn < 1e-9:
            self.turn = 0.0
            self.locate(segments, row, 0.0, 0)
            self.locate(segments, row, 1.0, 1)
            for i in range(self.count):
                slope = (self.samples[self.count + i] - self.samples[i]) / length
                self.entering[i] = slope
                self.leaving[i] = slope
                self.first[i] = slope if slope >= 0.0 else 0.0 - slope
            return
        for i in range(self.count):
            self.first[i] = 0.0
        self.sample_bend(segments, row)
        self.sample_end(segments, row, 0.0, self.entering)
        self.sample_end(segments, row, 1.0, self.leaving)

    def survey_cubic(self, segments: memoryview[float], row: int) -> None:
        """Survey a piece of a spline whose positions are those of the axes."""
        for i in range(self.count):
            self.first[i] = 0.0
            self.second[i] = 0.0
            self.third[i] = 0.0
        steps = int(CUBIC_TURN / MAX_STEP)
        for number in range(steps + 1):
            part = number * MAX_STEP / CUBIC_TURN
            cubic.differentiate(segments, row, self.count, part, self.point, self.near, self.result)
            for i in range(self.count):
                self.first[i] = max(self.first[i], self.point[i], 0.0 - self.point[i])
                self.second[i] = max(self.second[i], self.near[i], 0.0 - self.near[i])
                self.third[i] = max(self.third[i], self.result[i], 0.0 - self.result[i])

    def curvature(self) -> float:
        """Return a bound of the curvature of the surveyed segment, per mm."""
        curvature2 = 0.0
        for i in range(self.count):
            if self.linear[i]:
                curvature2 += self.second[i] * self.second[i]
        return arithmetic.square_root(curvature2)

    def sample_bend(self, segments: memoryview[float], row: int) -> None:
        """Sample a segment on which something turns, one step beyond either end."""
        steps = self.steps
        part = 1.0 / steps
        if self.is_even or self.turn < MIN_STEP:
            part = max(part, MIN_STEP / self.turn)
            if not self.is_even:
                part = min(part, 1.0)
        step_d = part * segments[row + rows.LENGTH]
        for number in range(-1, steps + 2):
            for i in range(3 * self.count):
                self.samples[i] = self.samples[self.count + i]
            self.locate(segments, row, number * part, 3)
            if number >= 1:
                self.take_differences(step_d, number - 1 == 0, number - 1 == steps, number >= 2)

    def take_differences(self, step_d: float, is_start: int, is_end: int, has_third: int) -> None:
        """Take the differences about the last sample but one of the four, ``step_d`` apart."""
        last = self.count + self.count
        for i in range(self.count):
            newest = self.samples[last + self.count + i]
            middle = self.samples[last + i]
            before = self.samples[self.count + i]
            slope = 0.5 * (newest - before) / step_d
            curve = (newest - 2.0 * middle + before) / (step_d * step_d)
            if is_start:
                self.entering_curve[i] = curve
            if is_end:
                self.leaving_curve[i] = curve
            self.first[i] = max(self.first[i], slope, 0.0 - slope)
            self.second[i] = max(self.second[i], curve, 0.0 - curve)
            if has_third:
                bend = newest - 3.0 * middle + 3.0 * before - self.samples[i]
                bend /= step_d * step_d * step_d
                self.third[i] = max(self.third[i], bend, 0.0 - bend)

    def sample_end(
        self, segments: memoryview[float], row: int, part: float, slopes: memoryview[float]
    ) -> None:
        """Compute the direction of the axes' motion at an end."""
        step = END_STEP / self.turn
        if not self.is_even:
            step = min(0.1, step, END_STEP / self.steps)
        self.locate(segments, row, part - step, 0)
        self.locate(segments, row, part + step, 1)
        step_d = 2.0 * step * segments[row + rows.LENGTH]
        for i in range(self.count):
            slope = (self.samples[self.count + i] - self.samples[i]) / step_d
            slopes[i] = slope
            self.first[i] = max(self.first[i], slope, 0.0 - slope)

    # --- limits ---------------------------------------------------------------------------------

    def highest_speed(self, limits: memoryview[float]) -> float:
        """Highest speed along the segment that keeps the axes' speeds within ``limits``."""
        speed = 1e300
        for i in range(self.count):
            if self.first[i] > 0.0:
                speed = min(speed, limits[i] / (MARGIN * self.first[i]))
        return speed

    def bent_speed(self, limits: memoryview[float]) -> float:
        """Highest speed at which the bend takes its share of the accelerations ``limits``."""
        speed2 = 1e300
        for i in range(self.count):
            if self.second[i] > 0.0:
                speed2 = min(speed2, BEND_A * limits[i] / (MARGIN * self.second[i]))
        return arithmetic.square_root(speed2)

    def bend_share(self, limits: memoryview[float], speed: float) -> float:
        """Largest share of the accelerations ``limits`` that the bend takes at a speed."""
        share = 0.0
        for i in range(self.count):
            share = max(share, MARGIN * self.second[i] * speed * speed / limits[i])
        return share

    def acceleration(self, limits: memoryview[float], speed: float) -> float:
        """Acceleration along the segment that the bend leaves at a speed."""
        limit_a = 1e300
        for i in range(self.count):
            if self.first[i] > 0.0:
                left_a = limits[i] - MARGIN * self.second[i] * speed * speed
                limit_a = min(limit_a, left_a / (MARGIN * self.first[i]))
        return limit_a

    def bent_jerk_speed(self, limits: memoryview[float]) -> float:
        """Highest speed at which the bend takes its share of the jerks ``limits``."""
        speed = 1e300
        for i in range(self.count):
            if self.third[i] > 0.0:
                speed3 = BEND_J * limits[i] / (MARGIN * self.third[i])
                speed = min(speed, arithmetic.power(speed3, 1.0 / 3.0))
        return speed

    def bent_acceleration(self, limits: memoryview[float], speed: float) -> float:
        """Highest acceleration along the segment that takes its share of the jerks ``limits``."""
        limit_a = 1e300
        for i in range(self.count):
            if self.second[i] > 0.0:
                jerk = MARGIN * 3.0 * self.second[i] * speed
                limit_a = min(limit_a, BEND_RAMP_J * limits[i] / jerk)
        return limit_a

    def jerk(self, limits: memoryview[float], speed: float, ramp_a: float) -> float:
        """Jerk along the segment that the bend leaves at a speed and an acceleration."""
        limit_j = 1e300
        for i in range(self.count):
            if self.first[i] > 0.0:
                bend = 3.0 * self.second[i] * ramp_a + self.third[i] * speed * speed
                left_j = limits[i] - MARGIN * bend * speed
                limit_j = min(limit_j, left_j / (MARGIN * self.first[i]))
        return limit_j

    # --- a segment -----------------------------------------------------------------------------

    def measure(self, segments: memoryview[float], row: int, max_factor: float) -> float:
        """Prepare length, speeds and acceleration of a transformed segment, or of a cubic.

        Return the share of the accelerations that the bend of the axes' motion takes. The corner at
        its end is not rounded.
        """
        segments[row + rows.DEVIATION] = 0.0
        if segments[row + rows.SHAPE] == rows.ARC:
            segments[row + rows.LENGTH] = self.arc_length(segments, row)
        if cubic.is_cubic(segments, row):
            cubic.measure(segments, row, self.count, self.linear)
        if segments[row + rows.TRANSFORMATION] > 0.0:
            self.survey(segments, row)
        else:
            self.survey_cubic(segments, row)
        if segments[row + rows.MOTION] == rows.RAPID_MOTION:
            segments[row + rows.SPEED] = self.highest_speed(self.rapid_v)
        speed = min(
            segments[row + rows.SPEED] * max_factor,
            self.highest_speed(self.max_v),
            self.bent_speed(self.axis_a),
        )
        if segments[row + rows.HAS_JERK_LIMIT] > 0.0:
            speed = min(speed, self.bent_jerk_speed(self.axis_j))
        segments[row + rows.MAX_SPEED] = speed
        segments[row + rows.ACCELERATION] = self.acceleration(self.axis_a, speed)
        segments[row + rows.CORNER_SPEED] = 0.0
        if segments[row + rows.HAS_JERK_LIMIT] > 0.0:
            self.limit_jerk(segments, row)
        return self.bend_share(self.axis_a, speed)

    def limit_jerk(self, segments: memoryview[float], row: int) -> None:
        """Limit acceleration and jerk for the jerk-limited slope."""
        speed = segments[row + rows.MAX_SPEED]
        limit_a = self.bent_acceleration(self.axis_j, speed)
        limit_a = min(segments[row + rows.ACCELERATION], limit_a)
        segments[row + rows.ACCELERATION] = limit_a
        segments[row + rows.JERK] = self.jerk(self.axis_j, speed, limit_a)

    def arc_length(self, segments: memoryview[float], row: int) -> float:
        """Length of an arc, of a helix where further linear axes move."""
        first = int(segments[row + rows.ARC_FIRST_AXIS])
        second = int(segments[row + rows.ARC_SECOND_AXIS])
        x = segments[row + rows.START + first] - segments[row + rows.ARC_FIRST_CENTRE]
        y = segments[row + rows.START + second] - segments[row + rows.ARC_SECOND_CENTRE]
        distance = segments[row + rows.ARC_ANGLE] * 0.017453292519943295
        length2 = (x * x + y * y) * distance * distance
        start = row + rows.START
        for i in range(self.count):
            if self.linear[i] and i not in (first, second):
                rise = segments[start + self.count + i] - segments[start + i]
                length2 += rise * rise
        return arithmetic.square_root(length2)

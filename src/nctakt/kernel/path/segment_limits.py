# SPDX-License-Identifier: MIT
"""The limits of one segment: its length, and the limits that its axes set (MO-1, MO-4).

A segment is a row (``rows.py``). Lines: of each axis its part of the length.
Arcs: of the acceleration that both axes of the plane have, the centripetal part takes a share.

With a limit of the jerk an arc of radius r with the speed v, the acceleration a and the jerk j
along it gives its axes, in the direction that is worst, the acceleration √(a² + (v²/r)²) and the
jerk √((j + v³/r²)² + (3·v·a/r)²); of the speeds and accelerations that leave room for a jerk those
are taken that are fastest over the arc from rest to rest.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index
from nctakt.kernel.path import arc_limits, geometry
from nctakt.kernel.path.arc_limits import ArcLimits
from nctakt.kernel.path.transformed_limits import TransformedLimits


class SegmentLimits:
    """The limits of one channel's axes, and the limits that follow for a segment.

    An axis is ``linear`` or not; ``rapid_…`` limits hold for rapid motions, ``feed_…`` for the
    others, ``…_slope_a`` with limited jerk: each slope has separate accelerations. ``axis_a`` and
    ``axis_j``: those of the newest segment. A speed is at most ``max_factor`` times the programmed
    one (P-CHAN-00056). ``has_jerk_limit``: a segment had a limit of the jerk.

    Programs change the limits between two segments. ``is_reduced``: they are not those of the
    lists (``listed_v``, ``listed_a``); an arc then has one acceleration. ``kept_…``: the limits of
    the segment before, while ``has_changed``. ``vector``: limits along the path, of feed blocks and
    of rapid ones, 0 none. ``rounded_part``: of a line that a rounded corner may take; ``max_bend``:
    the largest change of direction that is rounded, as a length of two unit vectors' difference.
    """

    def __init__(self, count: int, cycle_time_us: int, max_factor: float, places: int = 0) -> None:
        self.count = count
        self.room = max(1, count, places)
        self.max_factor = max(1.0, max_factor)
        self.tick_t = cycle_time_us / 1e6
        room = self.room
        self.linear = integers(room)
        self.rapid_v = doubles(room)
        self.max_v = doubles(room)
        self.rapid_a = doubles(room)
        self.feed_a = doubles(room)
        self.rapid_slope_a = doubles(room)
        self.feed_slope_a = doubles(room)
        self.rapid_j = doubles(room)
        self.feed_j = doubles(room)
        self.axis_a = doubles(room)
        self.axis_j = doubles(room)
        self.listed_v = doubles(room)
        self.listed_a = doubles(room)
        self.kept_rapid_a = doubles(room)
        self.kept_feed_a = doubles(room)
        self.kept_rapid_slope_a = doubles(room)
        self.kept_feed_slope_a = doubles(room)
        self.kept_rapid_j = doubles(room)
        self.kept_feed_j = doubles(room)
        self.vector = doubles(2 * rows.VECTOR_WIDTH)
        self.is_reduced = False
        self.has_changed = False
        self.rounded_part = 0.5
        self.max_bend = 1.99
        self.arcs = ArcLimits(count, self.room)
        self.arcs.share(self.listed_v, self.listed_a)
        self.transformed = TransformedLimits(count, self.linear, self.room)
        self.transformed.limit(self.rapid_v, self.max_v, self.axis_a, self.axis_j)
        self.direction = doubles(room)
        self.unused = doubles(room)
        self.has_jerk_limit = False
        self.spindles: Spindles | None = None

    def limit(
        self,
        index: int,
        is_linear: bool,
        speeds: tuple[float, float],
        accelerations: tuple[float, float],
    ) -> None:
        """Set the limits of one axis: rapid and highest speed, rapid and feed acceleration."""
        check_index(index, self.count, "axis")
        self.linear[index] = is_linear
        self.rapid_v[index], self.max_v[index] = speeds
        self.rapid_a[index], self.feed_a[index] = accelerations
        self.listed_v[index] = self.max_v[index]
        self.listed_a[index] = self.feed_a[index]

    def limit_slope(
        self, index: int, accelerations: tuple[float, float], jerks: tuple[float, float]
    ) -> None:
        """Set the limits of one axis with limited jerk: of rapid and feed."""
        check_index(index, self.count, "axis")
        self.rapid_slope_a[index], self.feed_slope_a[index] = accelerations
        self.rapid_j[index], self.feed_j[index] = jerks

    def set_count(self, count: int) -> None:
        """Let the path have ``count`` places; raise ``ValueError`` if there is no room for them."""
        self.arcs.set_count(count)
        self.transformed.set_count(count)
        self.count = count

    # --- limits that programs change ------------------------------------------------------------

    def change(
        self,
        index: int,
        speeds: tuple[float, float],
        accelerations: tuple[float, float],
        slope_accelerations: tuple[float, float],
        jerks: tuple[float, float],
    ) -> None:
        """Change the limits of one axis from the next segment on; arguments as in ``limit``."""
        check_index(index, self.count, "axis")
        self.keep()
        self.rapid_v[index], self.max_v[index] = speeds
        self.rapid_a[index], self.feed_a[index] = accelerations
        self.rapid_slope_a[index], self.feed_slope_a[index] = slope_accelerations
        self.rapid_j[index], self.feed_j[index] = jerks

    def limit_path(self, is_rapid: bool, limits: tuple[float, ...]) -> None:
        """Limit the path from the next segment on; ``limits`` from ``rows.VECTOR_SPEED`` on."""
        first = rows.VECTOR_WIDTH if is_rapid else 0
        for i in range(rows.VECTOR_WIDTH):
            self.vector[first + i] = limits[i]

    def keep(self) -> None:
        """Keep the limits of the segment before until the corner after it is settled."""
        if not self.has_changed:
            for i in range(self.count):
                self.kept_rapid_a[i] = self.rapid_a[i]
                self.kept_feed_a[i] = self.feed_a[i]
                self.kept_rapid_slope_a[i] = self.rapid_slope_a[i]
                self.kept_feed_slope_a[i] = self.feed_slope_a[i]
                self.kept_rapid_j[i] = self.rapid_j[i]
                self.kept_feed_j[i] = self.feed_j[i]
        self.has_changed = True

    def use_stricter_limits(self) -> None:
        """Use the stricter limits of both segments of a corner until ``end_corner``."""
        for i in range(self.count):
            limit = self.rapid_a[i]
            self.rapid_a[i] = min(limit, self.kept_rapid_a[i])
            self.kept_rapid_a[i] = limit
            limit = self.feed_a[i]
            self.feed_a[i] = min(limit, self.kept_feed_a[i])
            self.kept_feed_a[i] = limit
            limit = self.rapid_slope_a[i]
            self.rapid_slope_a[i] = min(limit, self.kept_rapid_slope_a[i])
            self.kept_rapid_slope_a[i] = limit
            limit = self.feed_slope_a[i]
            self.feed_slope_a[i] = min(limit, self.kept_feed_slope_a[i])
            self.kept_feed_slope_a[i] = limit
            limit = self.rapid_j[i]
            self.rapid_j[i] = min(limit, self.kept_rapid_j[i])
            self.kept_rapid_j[i] = limit
            limit = self.feed_j[i]
            self.feed_j[i] = min(limit, self.kept_feed_j[i])
            self.kept_feed_j[i] = limit

    def end_corner(self) -> None:
        """Let the changed limits apply alone."""
        for i in range(self.count):
            self.rapid_a[i] = self.kept_rapid_a[i]
            self.feed_a[i] = self.kept_feed_a[i]
            self.rapid_slope_a[i] = self.kept_rapid_slope_a[i]
            self.feed_slope_a[i] = self.kept_feed_slope_a[i]
            self.rapid_j[i] = self.kept_rapid_j[i]
            self.feed_j[i] = self.kept_feed_j[i]
        self.has_changed = False

    # --- the limits of a segment ----------------------------------------------------------------

    def measure(self, segments: memoryview[float], row: int) -> float:
        """Prepare length, speeds and acceleration of the segment at ``row``.

        Return the share of the acceleration of an arc's plane that the centripetal part takes.
        """
        share = 0.0
        self.choose(segments, row)
        segments[row + rows.LENGTH] = self.straight_length(segments, row)
        if segments[row + rows.TRANSFORMATION] > 0.0:
            return self.measure_bent(segments, row)
        if segments[row + rows.SHAPE] == rows.LINE:
            self.bound(segments, row)
        elif segments[row + rows.SHAPE] == rows.ARC:
            share = self.measure_arc(segments, row)
        else:
            return self.measure_bent(segments, row)
        if segments[row + rows.HAS_JERK_LIMIT] > 0.0:
            self.limit_jerk(segments, row)
        if segments[row + rows.THREAD] == rows.TAPPING:
            self.limit_tap(segments, row)
        segments[row + rows.CORNER_SPEED] = 0.0
        return share

    def choose(self, segments: memoryview[float], row: int) -> None:
        """Take the accelerations and jerks of the axes by motion and slope of a segment."""
        is_rapid = segments[row + rows.MOTION] == rows.RAPID_MOTION
        is_smooth = segments[row + rows.HAS_JERK_LIMIT] > 0.0
        for i in range(self.count):
            if is_rapid:
                self.axis_a[i] = self.rapid_slope_a[i] if is_smooth else self.rapid_a[i]
                self.axis_j[i] = self.rapid_j[i]
            else:
                self.axis_a[i] = self.feed_slope_a[i] if is_smooth else self.feed_a[i]
                self.axis_j[i] = self.feed_j[i]

    def measure_bent(self, segments: memoryview[float], row: int) -> float:
        """Prepare a segment on which the motion of the axes is bent; return as ``measure``."""
        share = self.transformed.measure(segments, row, self.max_factor)
        if self.is_reduced:
            limit_v = self.vector_limit(segments, row, rows.VECTOR_SPEED)
            limit_a = self.vector_limit(segments, row, rows.RADIAL_ACCELERATION)
            curvature = max(self.transformed.curvature(), 1e-9)
            limit_v = min(limit_v, arithmetic.square_root(limit_a / curvature))
            segments[row + rows.MAX_SPEED] = min(segments[row + rows.MAX_SPEED], limit_v)
            limit_a = self.vector_limit(segments, row, rows.VECTOR_ACCELERATION)
            segments[row + rows.ACCELERATION] = min(segments[row + rows.ACCELERATION], limit_a)
        if segments[row + rows.HAS_JERK_LIMIT] > 0.0:
            self.has_jerk_limit = True
            self.stop_at_end(segments, row)
        return share

    def limit_tap(self, segments: memoryview[float], row: int) -> None:
        """Limit a line so that the spindle which turns with it keeps its own limits."""
        if self.spindles is None:
            return
        spindle = int(segments[row + rows.FEED_SPINDLE])
        spindle -= 1
        turn = segments[row + rows.THREAD_TURN]
        turn = turn if turn > 0.0 else 0.0 - turn
        limit_v = self.spindles.limits.speed_v[spindle] / turn
        limit_a = self.spindles.limits.acceleration_a[spindle] / turn
        limit_j = self.spindles.limits.jerk_j[spindle] / turn
        segments[row + rows.MAX_SPEED] = min(segments[row + rows.MAX_SPEED], limit_v)
        segments[row + rows.ACCELERATION] = min(segments[row + rows.ACCELERATION], limit_a)
        if segments[row + rows.JERK] > 0.0:
            if limit_j > 0.0:
                segments[row + rows.JERK] = min(segments[row + rows.JERK], limit_j)
            self.stop_at_end(segments, row)

    def limit_jerk(self, segments: memoryview[float], row: int) -> None:
        """Limit the jerk of a line, or of all that an arc takes."""
        self.has_jerk_limit = True
        start = row + rows.START
        target = start + self.count
        limit_j = 1e300
        for i in range(self.count):
            distance = segments[target + i] - segments[start + i]
            if distance == 0.0 or self.in_plane(segments, row, i):
                continue
            part = (distance if distance > 0.0 else 0.0 - distance) / segments[row + rows.LENGTH]
            limit_j = min(limit_j, self.axis_j[i] / part)
        if self.is_reduced:
            limit_j = min(limit_j, self.vector_limit(segments, row, rows.VECTOR_JERK))
        segments[row + rows.JERK] = limit_j
        if segments[row + rows.SHAPE] == rows.ARC:
            self.limit_jerk_on_arc(segments, row, self.unused, self.unused)
        self.stop_at_end(segments, row)

    def limit_jerk_on_arc(
        self,
        segments: memoryview[float],
        row: int,
        shares: memoryview[float],
        turns: memoryview[float],
    ) -> None:
        """Limit speed, acceleration and jerk on an arc.

        A corner uses ``shares`` of the axes' accelerations and ``turns`` of their jerks.
        """
        first = int(segments[row + rows.ARC_FIRST_AXIS])
        second = int(segments[row + rows.ARC_SECOND_AXIS])
        x = segments[row + rows.START + first] - segments[row + rows.ARC_FIRST_CENTRE]
        y = segments[row + rows.START + second] - segments[row + rows.ARC_SECOND_CENTRE]
        radius = arithmetic.square_root(x * x + y * y)
        turn = segments[row + rows.ARC_ANGLE] * 0.017453292519943295
        distance = radius * (turn if turn > 0.0 else 0.0 - turn)
        part = distance / segments[row + rows.LENGTH]
        first_a = self.feed_slope_a[first] - shares[first]
        plane_a = min(first_a, self.feed_slope_a[second] - shares[second])
        plane_j = min(self.feed_j[first] - turns[first], self.feed_j[second] - turns[second])
        max_v = (
            min(segments[row + rows.SPEED] * self.max_factor, segments[row + rows.MAX_SPEED]) * part
        )
        max_v = min(max_v, arithmetic.square_root(0.97 * plane_a * radius))
        max_v = min(max_v, arithmetic.power(0.97 * plane_j * radius * radius, 1.0 / 3.0))
        outer_a = segments[row + rows.ACCELERATION] * part
        outer_j = segments[row + rows.JERK] * part
        best_t = 1e300
        speed = max_v
        for _ in range(8):
            centre_a = speed * speed / radius
            turned_j = centre_a * speed / radius
            free_a = arithmetic.square_root(plane_a * plane_a - centre_a * centre_a)
            ramp_a = min(free_a, outer_a, arithmetic.square_root(speed * plane_j))
            for _ in range(4):
                crossing_j = 3.0 * speed * ramp_a / radius
                if crossing_j < plane_j:
                    jerk = plane_j * plane_j - crossing_j * crossing_j
                    jerk = min(arithmetic.square_root(jerk) - turned_j, outer_j)
                    if jerk > 0.01 * plane_j:
                        time = arc_limits.rest_to_rest_time(distance, speed, ramp_a, jerk)
                        if time < best_t:
                            best_t = time
                            segments[row + rows.MAX_SPEED] = speed / part
                            segments[row + rows.ACCELERATION] = ramp_a / part
                            segments[row + rows.JERK] = jerk / part
                ramp_a *= 0.7
            speed *= 0.88

    def stop_at_end(self, segments: memoryview[float], row: int) -> None:
        """Let a segment end at a standstill."""
        segments[row + rows.GOAL_LENGTH] = 0.0
        segments[row + rows.GOAL_SPEED] = 0.0
        segments[row + rows.GOAL_ACCELERATION] = 1e300
        segments[row + rows.GOAL_JERK] = 1e300
        segments[row + rows.GOAL_KIND] = rows.LIMIT_GOAL
        segments[row + rows.CARRIED_ACCELERATION] = segments[row + rows.ACCELERATION]
        segments[row + rows.CARRIED_JERK] = segments[row + rows.JERK]

    def straight_length(self, segments: memoryview[float], row: int) -> float:
        """Length in the linear axes, or in the rotary ones where no linear axis moves.

        A linear length below a nanometre, a rounding error, counts as none.
        """
        start = row + rows.START
        target = start + self.count
        linear2 = 0.0
        rotary2 = 0.0
        for i in range(self.count):
            distance = segments[target + i] - segments[start + i]
            if self.linear[i]:
                linear2 += distance * distance
            else:
                rotary2 += distance * distance
        if linear2 < 1e-12 and rotary2 > 0.0:
            return arithmetic.square_root(rotary2)
        return arithmetic.square_root(linear2)

    def of_axis(self, index: int) -> tuple[float, ...]:
        """Return the limits of one axis: speeds, accelerations, those of slopes, jerks.

        In each pair that of rapid motions comes first. Raises ``ValueError`` for no such axis.
        """
        check_index(index, self.count, "axis")
        return (
            self.rapid_v[index],
            self.max_v[index],
            self.rapid_a[index],
            self.feed_a[index],
            self.rapid_slope_a[index],
            self.feed_slope_a[index],
            self.rapid_j[index],
            self.feed_j[index],
        )

    def bound(self, segments: memoryview[float], row: int) -> None:
        """Settle speeds and acceleration of a line, or of axes outside of an arc's plane."""
        is_rapid = segments[row + rows.MOTION] == rows.RAPID_MOTION
        start = row + rows.START
        target = start + self.count
        highest = 1e300
        limit_a = 1e300
        rapid = 1e300
        for i in range(self.count):
            distance = segments[target + i] - segments[start + i]
            if distance == 0.0 or self.in_plane(segments, row, i):
                continue
            part = (distance if distance > 0.0 else 0.0 - distance) / segments[row + rows.LENGTH]
            rapid = min(rapid, self.rapid_v[i] / part)
            highest = min(highest, self.max_v[i] / part)
            limit_a = min(limit_a, self.axis_a[i] / part)
        if is_rapid:
            segments[row + rows.SPEED] = rapid
        segments[row + rows.MAX_SPEED] = highest
        segments[row + rows.ACCELERATION] = limit_a
        if self.is_reduced:
            limit_v = self.vector_limit(segments, row, rows.VECTOR_SPEED)
            segments[row + rows.MAX_SPEED] = min(highest, limit_v)
            limit_a = min(limit_a, self.vector_limit(segments, row, rows.VECTOR_ACCELERATION))
            segments[row + rows.ACCELERATION] = limit_a

    def vector_limit(self, segments: memoryview[float], row: int, column: int) -> float:
        """Return a limit of ``#VECTOR LIMIT`` for a segment; 1e300 without one."""
        is_rapid = segments[row + rows.MOTION] == rows.RAPID_MOTION
        limit = self.vector[rows.VECTOR_WIDTH + column if is_rapid else column]
        return limit if limit > 0.0 else 1e300

    def limit_radially(
        self, segments: memoryview[float], row: int, radius: float, part: float
    ) -> None:
        """Limit the speed on an arc by the radial acceleration and jerk of ``#VECTOR LIMIT``."""
        limit_a = self.vector_limit(segments, row, rows.RADIAL_ACCELERATION)
        limit_j = self.vector_limit(segments, row, rows.RADIAL_JERK)
        speed = segments[row + rows.MAX_SPEED] * part
        if limit_a < 1e299:
            speed = min(speed, arithmetic.square_root(limit_a * radius))
        if limit_j < 1e299:
            speed = min(speed, arithmetic.power(limit_j * radius * radius, 1.0 / 3.0))
        segments[row + rows.MAX_SPEED] = speed / part

    def in_plane(self, segments: memoryview[float], row: int, index: int) -> int:
        """Return whether an axis is one of the two of the arc."""
        if segments[row + rows.SHAPE] != rows.ARC or segments[row + rows.TRANSFORMATION] > 0.0:
            return 0
        if segments[row + rows.ARC_FIRST_AXIS] == index:
            return 1
        return 1 if segments[row + rows.ARC_SECOND_AXIS] == index else 0

    def measure_arc(self, segments: memoryview[float], row: int) -> float:
        """Prepare an arc, a helix where further axes move; return as ``measure``.

        Of the acceleration ``a`` that both axes of the plane have, the centripetal part takes a
        share ``s``, so that along the path ``a * sqrt(1 - s²)`` is left all along. Where that would
        limit the speed or lose time, the limits go by the angle (``arc_limits.py``).
        """
        start = row + rows.START
        target = start + self.count
        first = int(segments[row + rows.ARC_FIRST_AXIS])
        second = int(segments[row + rows.ARC_SECOND_AXIS])
        x = segments[start + first] - segments[row + rows.ARC_FIRST_CENTRE]
        y = segments[start + second] - segments[row + rows.ARC_SECOND_CENTRE]
        radius = arithmetic.square_root(x * x + y * y)
        angle = segments[row + rows.ARC_ANGLE] * 0.017453292519943295
        distance = radius * (angle if angle > 0.0 else 0.0 - angle)
        length2 = distance * distance
        for i in range(self.count):
            if self.linear[i] and not self.in_plane(segments, row, i):
                rise = segments[target + i] - segments[start + i]
                length2 += rise * rise
        length = arithmetic.square_root(length2)
        segments[row + rows.LENGTH] = length
        self.bound(segments, row)
        part = distance / length
        if self.is_reduced:
            self.limit_radially(segments, row, radius, part)
        highest = min(
            segments[row + rows.MAX_SPEED], min(self.max_v[first], self.max_v[second]) / part
        )
        if segments[row + rows.HAS_JERK_LIMIT] > 0.0:
            segments[row + rows.MAX_SPEED] = highest
            return 0.0
        plane_a = min(self.feed_a[first], self.feed_a[second])
        commanded_v = segments[row + rows.SPEED] * self.max_factor
        if self.is_reduced:
            commanded_v = min(commanded_v, highest)
        share = commanded_v * part * commanded_v * part / (radius * plane_a)
        centripetal = min(share, 0.5)
        speed = min(arithmetic.square_root(centripetal * radius * plane_a) / part, commanded_v)
        limit_a = plane_a * arithmetic.square_root(1.0 - centripetal * centripetal) / part
        segments[row + rows.ACCELERATION] = min(limit_a, segments[row + rows.ACCELERATION])
        segments[row + rows.MAX_SPEED] = min(highest, speed)
        if self.is_reduced:
            return centripetal
        if share > 0.5 or commanded_v > highest or not self.is_even(segments, row, commanded_v):
            by_speed = commanded_v > highest and highest * highest < radius * plane_a
            self.divide_arc(segments, row, 3.0 if by_speed else 6.0)
        return centripetal

    def is_even(self, segments: memoryview[float], row: int, commanded_v: float) -> int:
        """Return whether one acceleration all along an arc costs next to no time (1 %).

        Compares the time that ramps at both ends lose against the acceleration of the axes there
        with the time for the whole length at the commanded speed.
        """
        slower = 1.0 / segments[row + rows.ACCELERATION]
        geometry.tangent(segments, row, self.count, 0, self.direction)
        slower -= 0.5 / self.straight_acceleration(self.direction)
        geometry.tangent(segments, row, self.count, 1, self.direction)
        slower -= 0.5 / self.straight_acceleration(self.direction)
        return 1 if commanded_v * commanded_v * slower <= 0.01 * segments[row + rows.LENGTH] else 0

    def straight_acceleration(self, parts: memoryview[float]) -> float:
        """Acceleration per s² that the axes allow together in a direction."""
        limit_a = 1e300
        for i in range(self.count):
            part = parts[i] if parts[i] >= 0.0 else 0.0 - parts[i]
            if part > 1e-9:
                limit_a = min(limit_a, self.feed_a[i] / part)
        return limit_a

    def divide_arc(self, segments: memoryview[float], row: int, piece: float) -> None:
        """Divide an arc whose limits go by its angle into pieces of ``piece`` degrees.

        Backward it is walked with one speed and acceleration for all of it.
        """
        angle = segments[row + rows.ARC_ANGLE]
        pieces = int((angle if angle > 0.0 else 0.0 - angle) / piece - 1e-9)
        segments[row + rows.ARC_PIECES] = max(pieces + 1, 2) + rows.MORE_PIECES
        segments[row + rows.BACKWARD_SPEED] = segments[row + rows.MAX_SPEED]
        segments[row + rows.ACCELERATION] *= 0.99
        self.arcs.open(segments, row)
        segments[row + rows.MAX_SPEED] = self.arcs.highest_speed()

    # --- abilities of the axes ------------------------------------------------------------------

    def speed_of(self, speed: float, max_speed: float) -> float:
        """Highest speed that a segment is ever driven with, per s, from its two columns."""
        return min(speed * self.max_factor, max_speed)

    def axis_jerk(self, index: int) -> float:
        """Jerk of an axis that both segments of a corner allow."""
        return min(self.rapid_j[index], self.feed_j[index])

    def axis_acceleration(self, index: int) -> float:
        """Acceleration of an axis that both segments of a corner allow."""
        return min(self.rapid_a[index], self.feed_a[index])

    def slope_acceleration(self, index: int) -> float:
        """``axis_acceleration`` with limited jerk."""
        return min(self.rapid_slope_a[index], self.feed_slope_a[index])

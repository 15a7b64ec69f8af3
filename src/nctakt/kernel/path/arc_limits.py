# SPDX-License-Identifier: MIT
"""The limits of the axes on an arc, by its angle: speeds, speeding up, braking (MO-1, MO-2).

On an arc the direction q' of the path and its curvature q'' turn with the angle, so the same speed
v and acceleration a put different demands on each axis at each place: ``|q'·a + q''·v²| <= A``. The
arc is divided into *pieces* of equal angle, 6° at most (3° where the speed of an axis is the
limit), the first and the last one divided further, because the path may start or stop there. No
component of a rotating vector exceeds, between the two ends of a piece, its value at an end by more
than 1 / cos(half the piece's angle): keeping to that share of the limits at both ends keeps them on
the whole piece. Speeds are kept as squares, since the conditions are linear in them.

Within a piece the path may always keep its speed: ``caps`` is the highest for which that holds.
From any speed not above the line between those of the piece's two borders, the path can continue to
the border ahead and always brake there (``entry_v2``).
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.base.bounds import check_index, check_range


def rest_to_rest_time(distance: float, speed: float, limit_a: float, limit_j: float) -> float:
    """Time in s of a distance from rest to rest with limited jerk."""
    ramp = limit_a / limit_j
    if speed < limit_a * ramp:
        ramp = 2.0 * arithmetic.square_root(speed / limit_j)
    else:
        ramp += speed / limit_a
    if speed * ramp <= distance:
        return distance / speed + ramp
    ramp = limit_a / limit_j
    if distance < 2.0 * limit_a * ramp * ramp:
        return 4.0 * arithmetic.power(0.5 * distance / limit_j, 1.0 / 3.0)
    half = 0.5 * limit_a * ramp
    peak = arithmetic.square_root(half * half + limit_a * distance) - half
    return distance / peak + peak / limit_a + ramp


class ArcLimits:
    """The limits on one arc at a time, over ``count`` axes with their limits of speed and feed.

    At each border of the pieces, for both axes of the plane: ``first_parts``, ``second_parts``
    their part of the length, ``first_curvatures``, ``second_curvatures`` the change of these per
    mm. ``keeps``: the share of the axes' acceleration that may be used on each piece. ``ends``: the
    length up to each border.
    """

    def __init__(self, count: int, room: int = 0) -> None:
        self.count = count
        self.room = max(1, count, room)
        self.max_v = doubles(self.room)
        self.max_a = doubles(self.room)
        borders = rows.MAX_PIECES + 1
        self.first_parts = doubles(borders)
        self.second_parts = doubles(borders)
        self.first_curvatures = doubles(borders)
        self.second_curvatures = doubles(borders)
        self.caps = doubles(rows.MAX_PIECES)
        self.keeps = doubles(rows.MAX_PIECES)
        self.ends = doubles(borders)
        self.pieces = 0
        self.first_a = 0.0
        self.second_a = 0.0
        self.outer_a = 0.0
        self.outer_v = 0.0

    def share(self, max_v: memoryview[float], max_a: memoryview[float]) -> None:
        """Take over the limits of the axes: of speed, and of acceleration with a feed."""
        check_index(self.count, min(len(max_v), len(max_a)) + 1, "number of axes")
        self.max_v = max_v
        self.max_a = max_a

    def set_count(self, count: int) -> None:
        """Set the number of axes; raise ``ValueError`` if there is no room for them."""
        check_range(count, 0, self.room, "number of axes")
        self.count = count

    def open(self, segments: memoryview[float], row: int) -> None:
        """Take the arc of the segment at ``row``."""
        first = int(segments[row + rows.ARC_FIRST_AXIS])
        second = int(segments[row + rows.ARC_SECOND_AXIS])
        x = segments[row + rows.START + first] - segments[row + rows.ARC_FIRST_CENTRE]
        y = segments[row + rows.START + second] - segments[row + rows.ARC_SECOND_CENTRE]
        angle = segments[row + rows.ARC_ANGLE]
        radius = arithmetic.square_root(x * x + y * y)
        x /= radius
        y /= radius
        turn = angle * 0.017453292519943295
        part = radius * turn / segments[row + rows.LENGTH]
        curvature = part * part / radius
        self.pieces = int(segments[row + rows.ARC_PIECES])
        for j in range(self.pieces + 1):
            share = self.border(j)
            cosine = arithmetic.cosine(angle * share)
            sine = arithmetic.sine(angle * share)
            self.ends[j] = segments[row + rows.LENGTH] * share
            self.first_parts[j] = 0.0 - (x * sine + y * cosine) * part
            self.second_parts[j] = (x * cosine - y * sine) * part
            self.first_curvatures[j] = 0.0 - (x * cosine - y * sine) * curvature
            self.second_curvatures[j] = 0.0 - (x * sine + y * cosine) * curvature
        self.first_a = self.max_a[first]
        self.second_a = self.max_a[second]
        self.open_outer(segments, row, first, second)
        even = self.pieces - rows.MORE_PIECES
        keep = arithmetic.cosine(0.5 * angle / even)
        for k in range(self.pieces):
            self.keeps[k] = keep * (1.0 - self.used_share(segments, row, k))
            cap = min(self.cap_at(k, first, second, keep), self.cap_at(k + 1, first, second, keep))
            outer_v = self.outer_v * keep
            cap = min(cap, outer_v * outer_v)
            cap = min(cap, self.centre_cap(k, k), self.centre_cap(k, k + 1))
            self.caps[k] = cap

    def border(self, j: int) -> float:
        """Share of the arc before a border; the pieces at both ends grow evenly."""
        rest = self.pieces - j
        even = self.pieces - rows.MORE_PIECES
        if j < 4:
            return j * j / (16.0 * even)
        if rest < 4:
            return 1.0 - rest * rest / (16.0 * even)
        return (j - 3) / even

    def open_outer(self, segments: memoryview[float], row: int, first: int, second: int) -> None:
        """Settle the limits of the axes that a helix moves outside of its plane."""
        self.outer_a = 1e300
        self.outer_v = 1e150
        start = row + rows.START
        target = start + self.count
        for i in range(self.count):
            distance = segments[target + i] - segments[start + i]
            if distance != 0.0 and i not in (first, second):
                part = (distance if distance > 0.0 else 0.0 - distance) / segments[
                    row + rows.LENGTH
                ]
                self.outer_a = min(self.outer_a, self.max_a[i] / part)
                self.outer_v = min(self.outer_v, self.max_v[i] / part)

    def used_share(self, segments: memoryview[float], row: int, k: int) -> float:
        """Share of the acceleration that corners at the arc's ends use on a piece."""
        end = k + 1
        used = segments[row + rows.ARC_SHARE]
        if self.ends[k] < segments[row + rows.ENTRY_LENGTH]:
            used = max(used, segments[row + rows.ARC_ENTRY_SHARE])
        if self.ends[end] > segments[row + rows.LENGTH] - segments[row + rows.EXIT_LENGTH]:
            used = max(used, segments[row + rows.ARC_EXIT_SHARE])
        return used

    def cap_at(self, j: int, first: int, second: int, keep: float) -> float:
        """Square of the speed that the axes' limits of speed allow at a border."""
        cap = 1e300
        part = self.first_parts[j]
        if part * part > 1e-18:
            speed = self.max_v[first] * keep / part
            cap = speed * speed
        part = self.second_parts[j]
        if part * part > 1e-18:
            speed = self.max_v[second] * keep / part
            cap = min(cap, speed * speed)
        return cap

    def centre_cap(self, k: int, j: int) -> float:
        """Square of the speed that piece ``k`` allows all along, from one of its borders."""
        first = self.first_curvatures[j]
        second = self.second_curvatures[j]
        first = first if first > 0.0 else 0.0 - first
        second = second if second > 0.0 else 0.0 - second
        cap = 1e300
        if first > 1e-30:
            cap = self.first_a * self.keeps[k] / first
        if second > 1e-30:
            cap = min(cap, self.second_a * self.keeps[k] / second)
        return cap

    def rate(self, k: int, speed2: float, growth: float, direction: float) -> float:
        """Highest acceleration on piece ``k`` at the square of the speed ``speed2``.

        ``direction``: 1 speeding up, -1 braking. The acceleration is kept until the square of the
        speed has grown by ``growth`` (below 0: fallen) times the acceleration.
        """
        max_a = self.outer_a * self.keeps[k]
        max_a = min(max_a, self.border_rate(k, self.keeps[k], speed2, growth, direction))
        return min(max_a, self.border_rate(k + 1, self.keeps[k], speed2, growth, direction))

    def border_rate(
        self, j: int, keep: float, speed2: float, growth: float, direction: float
    ) -> float:
        """``rate`` at one border, with the share ``keep`` of the axes' acceleration."""
        part = direction * self.first_parts[j]
        curvature = self.first_curvatures[j]
        max_a = self.axis_rate(part, curvature, self.first_a * keep, speed2, growth)
        part = direction * self.second_parts[j]
        curvature = self.second_curvatures[j]
        return min(max_a, self.axis_rate(part, curvature, self.second_a * keep, speed2, growth))

    def axis_rate(
        self, part: float, curvature: float, limit_a: float, speed2: float, growth: float
    ) -> float:
        """``rate`` of one axis at one border, from its part of the length and its curvature."""
        if part < 0.0:
            part = 0.0 - part
            curvature = 0.0 - curvature
        left_a = max(limit_a - curvature * speed2, 0.0)
        later = part + growth * curvature
        part = max(part, later)
        return left_a / part if part > 1e-9 else 1e300

    def entry_v2(self, speed2: float) -> float:
        """Square of the highest speed at the arc's start that keeps the one at its end."""
        k = self.pieces
        while k > 0:
            k -= 1
            speed2 = self.before(k, speed2)
        return speed2

    def before(self, k: int, speed2: float) -> float:
        """Square of the highest speed at a piece's start, from that at its end."""
        end = k + 1
        width = 2.0 * (self.ends[end] - self.ends[k])
        speed2 = min(speed2, self.caps[k])
        speed2 += width * self.rate(k, speed2, width, -1.0)
        return min(speed2, self.caps[k])

    def entry_speed(self, end_v: float, limit_v: float) -> float:
        """The highest speed at the arc's begin from which the end's is kept, as in
        ``geometry.py``."""
        return min(arithmetic.square_root(self.entry_v2(end_v * end_v)), limit_v)

    def highest_speed(self) -> float:
        """Highest speed on any piece."""
        cap = 0.0
        for k in range(self.pieces):
            cap = max(cap, self.caps[k])
        return arithmetic.square_root(cap)

    def end_cap(self, at_end: int) -> float:
        """Highest speed on the first or the last piece."""
        last = self.pieces - 1
        return arithmetic.square_root(self.caps[last if at_end else 0])

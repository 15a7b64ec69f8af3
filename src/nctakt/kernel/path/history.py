# SPDX-License-Identifier: MIT
"""The segments that the path has kept, as the walk over them sees them (MO-7).

A segment is known by its running number, its *place*. With a limit of the jerk the walk goes over
*stretches*: segments between which the path had passed without a stop. On each
segment the walk has the least acceleration and jerk of it and those behind it, up to a bend; with
these it brakes for goals as the path does (``jerk_lookahead.py``), and stands at the stretch's end.
A bend is driven with its own ones, and is a goal at either end, which the walk comes to without
acceleration.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.path import geometry
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.path import Path

#: The most segments of a stretch.
MAX_STRETCH = 32


class History:
    """The history of one channel's path, and where the walk is in it.

    ``goal_row``: the goal ahead as in a segment's row, for ``jerk_profile.py``. ``foreign``: which
    axes something else has moved since the path has left its front.
    """

    def __init__(self, path: Path, ahead: LookAhead) -> None:
        self.path = path
        self.ahead = ahead
        self.foreign = memoryview(bytearray(8 * max(1, path.count))).cast("q")
        self.place = 0
        self.front_place = 0
        self.stretch = memoryview(bytearray(8 * MAX_STRETCH)).cast("q")
        self.max_stretch = MAX_STRETCH
        self.stretch_end = 0
        self.goal_row = memoryview(bytearray(8 * path.width)).cast("d")
        self.limit_a = 0.0
        self.limit_j = 0.0
        self.bend_a = 1e300
        self.bend_j = 1e300

    def neighbour(self, place: int, direction: int) -> int:
        """The next segment in ``direction``; dwells are passed over, but for one at the front."""
        place += direction
        while place >= self.path.oldest and (direction < 0 or place < self.front_place):
            if self.path.ring[self.path.row_of(place) + rows.KIND] != rows.DWELL:
                return place
            place += direction
        return place

    def is_shut(self, base: int) -> int:
        """Whether something else has moved an axis of a segment since the path has left it."""
        for i in range(self.path.count):
            if geometry.moves(self.path.ring, base, self.path.count, i):
                if self.foreign[i] or self.path.axes.independent[self.path.members[i]]:
                    return 1
        return 0

    def note_foreign(self) -> int:
        """Whether another axis has got a motion of its own in this tick: its blocks are shut."""
        found = 0
        for i in range(self.path.count):
            if self.path.axes.independent[self.path.members[i]] and not self.foreign[i]:
                self.foreign[i] = 1
                found = 1
        return found

    # --- stretches with a limit of the jerk -----------------------------------------------------

    def passing_speed(self, place: int, other: int) -> float:
        """The highest speed from a segment into its neighbour; 0: the walk stands between them."""
        if other < self.path.oldest or other == self.front_place:
            return 0.0
        first = self.path.row_of(place if self.path.direction > 0 else other)
        second = self.path.row_of(other if self.path.direction > 0 else place)
        if self.path.ring[first + rows.JERK] == 0.0 or self.path.ring[second + rows.JERK] == 0.0:
            return 0.0
        if self.is_shut(self.path.row_of(other)):
            return 0.0
        return self.path.ring[first + rows.CORNER_SPEED]

    def survey(self, is_new: int) -> None:
        """Find the goal at or behind the end of the present segment; ``is_new``: a new stretch."""
        count = 0
        place = self.place
        while True:
            self.stretch[count] = place
            count += 1
            if count >= self.max_stretch or (not is_new and place == self.stretch_end):
                break
            other = self.neighbour(place, self.path.direction)
            if self.passing_speed(place, other) <= 0.0:
                break
            place = other
        if is_new:
            self.stretch_end = place
        self.find_goal(count)
        self.goal_row[rows.JERK] = self.limit_j
        self.goal_row[rows.ROUNDING_LENGTH] = 1.0 if self.bend_a < 1e299 else 0.0
        self.goal_row[rows.GOAL_LENGTH] = self.ahead.way
        self.goal_row[rows.GOAL_SPEED] = self.ahead.goal_v
        self.goal_row[rows.GOAL_ACCELERATION] = 1e300
        self.goal_row[rows.GOAL_JERK] = 1e300
        self.goal_row[rows.GOAL_KIND] = self.ahead.goal_kind
        self.goal_row[rows.CARRIED_ACCELERATION] = self.limit_a
        self.goal_row[rows.CARRIED_JERK] = self.limit_j

    def find_goal(self, count: int) -> None:
        """The nearest goal of the stretch's first ``count`` segments, the last of which is one.

        ``limit_a``, ``limit_j``: acceleration and jerk on the first of them; ``bend_a``,
        ``bend_j``: those of the bend that follows it, 1e300 where none does.
        """
        last = count - 1
        base = self.path.row_of(self.stretch[last])
        self.limit_a = self.path.ring[base + rows.ACCELERATION]
        self.limit_j = self.path.ring[base + rows.JERK]
        self.bend_a = 1e300
        self.bend_j = 1e300
        self.ahead.way = 0.0
        self.ahead.goal_v = 0.0
        self.ahead.goal_kind = rows.LIMIT_GOAL
        while last > 0:
            base = self.path.row_of(self.stretch[last])
            last -= 1
            before = self.path.row_of(self.stretch[last])
            first = before if self.path.direction > 0 else base
            self.ahead.goal_a = self.limit_a
            self.ahead.goal_j = self.limit_j
            self.ahead.way += self.path.ring[base + rows.LENGTH]
            self.borrow(before, base)
            corner_v = self.path.ring[first + rows.CORNER_SPEED]
            self.ahead.stop_at(self.path.ring, before, base, corner_v)

    def borrow(self, before: int, base: int) -> None:
        """Go on from ``base`` to the segment before it, and to what the walk may do on that.

        Acceleration that it brings into a segment in front of a bend has to fade on it. A bend it
        comes to without any; if it cannot, the bend's limits count (``ahead.lent_a``).
        """
        own_a = self.path.ring[before + rows.ACCELERATION]
        own_j = self.path.ring[before + rows.JERK]
        fades_d = self.ahead.speed_of(self.path.ring, base) * self.limit_a / self.limit_j
        if self.path.ring[base + rows.LENGTH] < fades_d:
            self.limit_a = min(self.limit_a, self.bend_a)
            self.limit_j = min(self.limit_j, self.bend_j)
        self.ahead.lent_a = min(self.limit_a, own_a)
        self.ahead.lent_j = min(self.limit_j, own_j)
        self.bend_a = 1e300
        self.bend_j = 1e300
        if self.path.ring[base + rows.SHAPE] == rows.ROUNDING:
            self.bend_a = self.limit_a
            self.bend_j = self.limit_j
            self.limit_a = own_a
            self.limit_j = own_j
        else:
            self.limit_a = self.ahead.lent_a
            self.limit_j = self.ahead.lent_j

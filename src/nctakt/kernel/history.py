# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""The segments that the path has kept, as the walk over them sees them (MO-7).

A segment is known by its running number, its *place*. With a limit of the jerk the walk goes over
*stretches*: segments between which the path had passed without a stop, up to 32 of them. On all of
a stretch the walk has the least acceleration and jerk of its segments; with these it brakes for
goals as the path does (``jerk_ahead.py``), and stands at the stretch's end.
"""

from __future__ import annotations

from nctakt.kernel import shape
from nctakt.kernel.lookahead import LookAhead
from nctakt.kernel.path import Path


class History:
    """The history of one channel's path, and where the walk is in it.

    ``goal_row``: the goal ahead as in a segment's row (``shape.py``), for ``smooth_speed.py``.
    ``foreign``: which axes something else has moved since the path has left its front.
    """

    def __init__(self, path: Path, ahead: LookAhead) -> None:
        self.path = path
        self.ahead = ahead
        self.foreign = memoryview(bytearray(8 * max(1, path.count))).cast("q")
        self.place = 0
        self.front_place = 0
        self.stretch = memoryview(bytearray(8 * 32)).cast("q")
        self.stretch_end = 0
        self.goal_row = memoryview(bytearray(8 * path.width)).cast("d")

    def neighbour(self, place: int, direction: int) -> int:
        """The next segment in ``direction``; dwells are passed over, but for one at the front."""
        place += direction
        while place >= self.path.oldest and (direction < 0 or place < self.front_place):
            if self.path.ring[self.path.row_of(place)] != 2.0:
                return place
            place += direction
        return place

    def is_shut(self, base: int) -> int:
        """Whether something else has moved an axis of a segment since the path has left it."""
        for i in range(self.path.count):
            if shape.moves(self.path.ring, base, self.path.count, i):
                if self.foreign[i] or self.path.axes.independent[self.path.members[i]]:
                    return 1
        return 0

    # --- stretches with a limit of the jerk -----------------------------------------------------

    def passing_speed(self, place: int, other: int) -> float:
        """The highest speed from a segment into its neighbour; 0: the walk stands between them."""
        if other < self.path.oldest or other == self.front_place:
            return 0.0
        first = self.path.row_of(place if self.path.direction > 0 else other)
        second = self.path.row_of(other if self.path.direction > 0 else place)
        if self.path.ring[first + 10] == 0.0 or self.path.ring[second + 10] == 0.0:
            return 0.0
        if self.path.ring[first + 9] == 2.0 or self.path.ring[second + 9] == 2.0:
            return 0.0
        return 0.0 if self.is_shut(self.path.row_of(other)) else self.path.ring[first + 11]

    def survey(self, is_new: int) -> None:
        """Find the goal at or behind the end of the present segment; ``is_new``: a new stretch."""
        tail = 12 + 2 * self.path.count
        count = 0
        place = self.place
        limit_a = 1e300
        limit_j = 1e300
        while True:
            self.stretch[count] = place
            limit_a = min(limit_a, self.path.ring[self.path.row_of(place) + 6])
            limit_j = min(limit_j, self.path.ring[self.path.row_of(place) + 10])
            count += 1
            if count >= 32 or (not is_new and place == self.stretch_end):
                break
            other = self.neighbour(place, self.path.direction)
            if self.passing_speed(place, other) <= 0.0:
                break
            place = other
        if is_new:
            self.stretch_end = place
            self.goal_row[10] = limit_j
            self.goal_row[tail + 17] = 1e300
            self.goal_row[tail + 18] = 1e300
            self.goal_row[tail + 19] = limit_a
            self.goal_row[tail + 20] = limit_j
        self.find_goal(count)
        self.goal_row[tail + 15] = self.ahead.way
        self.goal_row[tail + 16] = self.ahead.goal_v
        self.goal_row[tail + 21] = self.ahead.is_feed

    def find_goal(self, count: int) -> None:
        """The nearest goal of the stretch's first ``count`` segments, the last of which is one."""
        tail = 12 + 2 * self.path.count
        self.ahead.way = 0.0
        self.ahead.goal_v = 0.0
        self.ahead.is_feed = 0.0
        self.ahead.lent_a = self.goal_row[tail + 19]
        self.ahead.lent_j = self.goal_row[tail + 20]
        for i in range(count - 1, 0, -1):
            base = self.path.row_of(self.stretch[i])
            before = self.path.row_of(self.stretch[i - 1])
            first = before if self.path.direction > 0 else base
            self.ahead.goal_a = self.goal_row[tail + 19]
            self.ahead.goal_j = self.goal_row[tail + 20]
            self.ahead.way += self.path.ring[base + 3]
            self.ahead.stop_at(self.path.ring, before, base, self.path.ring[first + 11])

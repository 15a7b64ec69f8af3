# SPDX-License-Identifier: MIT
"""The segments that the path has kept, as the walk over them sees them (MO-7).

A segment is known by its running number, its *number*. With a limit of the jerk the walk goes over
*stretches*: segments between which the path had passed without a stop. On each segment the walk has
the least acceleration and jerk of it and those after it, up to a rounding; with these it brakes
for goals as the path does (``jerk_lookahead.py``), and stops at the stretch's end. A rounding has
its own values, and is a goal at either end, which the walk reaches without acceleration.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.path.goal import Goal
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.path import Path

#: The most segments of a stretch.
MAX_STRETCH = 32


class History:
    """History of one channel's path, and the walk's segment in it.

    ``goal_row``: the goal ahead as in a segment's row, for ``jerk_profile.py``. ``foreign``: which
    axes something else has moved since the path has left its front.
    """

    def __init__(self, path: Path, ahead: LookAhead) -> None:
        self.path = path
        self.look_ahead = ahead
        self.goal = Goal()
        self.foreign = integers(path.room)
        self.number = 0
        self.front_number = 0
        self.front_map = 0
        self.stretch = integers(MAX_STRETCH)
        self.max_stretch = MAX_STRETCH
        self.stretch_end = 0
        self.goal_row = doubles(path.width)
        self.limit_a = 0.0
        self.limit_j = 0.0
        self.rounding_a = 1e300
        self.rounding_j = 1e300

    def neighbour(self, number: int, direction: int) -> int:
        """Number of the next segment in ``direction``; dwells before the front are skipped."""
        number += direction
        while number >= self.path.oldest and (direction < 0 or number < self.front_number):
            if self.path.history_rows[self.path.row_of(number) + rows.KIND] != rows.DWELL:
                return number
            number += direction
        return number

    def is_shut(self, row: int) -> int:
        """Return whether an axis of a segment was moved otherwise since the path left it."""
        for i in range(self.path.count):
            if self.path.moves_axis(self.path.history_rows, row, i):
                if self.foreign[i] or self.path.axes.independent[self.path.members[i]]:
                    return 1
        return 0

    def note_foreign(self) -> int:
        """Return whether another axis has started an independent motion in this tick."""
        has_changed = 0
        for i in range(self.path.count):
            if self.path.axes.independent[self.path.members[i]] and not self.foreign[i]:
                self.foreign[i] = 1
                has_changed = 1
        return has_changed

    # --- stretches with a limit of the jerk -----------------------------------------------------

    def passing_speed(self, number: int, other: int) -> float:
        """Highest speed from a segment into its neighbour; 0: a standstill between them."""
        if other < self.path.oldest or other == self.front_number:
            return 0.0
        first = self.path.row_of(number if self.path.direction > 0 else other)
        second = self.path.row_of(other if self.path.direction > 0 else number)
        if (
            self.path.history_rows[first + rows.JERK] == 0.0
            or self.path.history_rows[second + rows.JERK] == 0.0
        ):
            return 0.0
        if self.is_shut(self.path.row_of(other)):
            return 0.0
        return self.path.history_rows[first + rows.CORNER_SPEED]

    def survey(self, is_new: int) -> None:
        """Find the goal ahead of the present segment's end; ``is_new``: of a new stretch."""
        count = 0
        number = self.number
        while True:
            self.stretch[count] = number
            count += 1
            if count >= self.max_stretch or (not is_new and number == self.stretch_end):
                break
            other = self.neighbour(number, self.path.direction)
            if self.passing_speed(number, other) <= 0.0:
                break
            number = other
        if is_new:
            self.stretch_end = number
        self.find_goal(count)
        self.goal_row[rows.JERK] = self.limit_j
        self.goal_row[rows.ROUNDING_LENGTH] = 1.0 if self.rounding_a < 1e299 else 0.0
        self.goal_row[rows.GOAL_LENGTH] = self.goal.distance_d
        self.goal_row[rows.GOAL_SPEED] = self.goal.speed_v
        self.goal_row[rows.GOAL_ACCELERATION] = 1e300
        self.goal_row[rows.GOAL_JERK] = 1e300
        self.goal_row[rows.GOAL_KIND] = self.goal.kind
        self.goal_row[rows.CARRIED_ACCELERATION] = self.limit_a
        self.goal_row[rows.CARRIED_JERK] = self.limit_j

    def find_goal(self, count: int) -> None:
        """Find the nearest goal of the stretch's first ``count`` segments.

        ``limit_a``, ``limit_j``: acceleration and jerk on the first of them; ``rounding_a``,
        ``rounding_j``: those of the rounding that follows it, 1e300 where none does.
        """
        last = count - 1
        row = self.path.row_of(self.stretch[last])
        self.limit_a = self.path.history_rows[row + rows.ACCELERATION]
        self.limit_j = self.path.history_rows[row + rows.JERK]
        self.rounding_a = 1e300
        self.rounding_j = 1e300
        self.goal.distance_d = 0.0
        self.goal.speed_v = 0.0
        self.goal.kind = rows.LIMIT_GOAL
        while last > 0:
            row = self.path.row_of(self.stretch[last])
            last -= 1
            before = self.path.row_of(self.stretch[last])
            first = before if self.path.direction > 0 else row
            self.goal.acceleration_a = self.limit_a
            self.goal.jerk_j = self.limit_j
            self.goal.distance_d += self.path.history_rows[row + rows.LENGTH]
            self.take_over(before, row)
            corner_v = self.path.history_rows[first + rows.CORNER_SPEED]
            self.look_ahead.jerk.slow_before(
                self.goal, self.path.history_rows, before, row, corner_v
            )

    def take_over(self, before: int, row: int) -> None:
        """Take the limits of the segment before ``row`` into account.

        Acceleration that it brings into a segment before a rounding has to fade on it. A
        rounding it comes to without any; if it cannot, the rounding's limits count
        (``Goal.carried_a``).
        """
        own_a = self.path.history_rows[before + rows.ACCELERATION]
        own_j = self.path.history_rows[before + rows.JERK]
        speed = self.path.history_rows[row + rows.SPEED]
        max_speed = self.path.history_rows[row + rows.MAX_SPEED]
        fades_d = self.look_ahead.limits.speed_of(speed, max_speed) * self.limit_a / self.limit_j
        if self.path.history_rows[row + rows.LENGTH] < fades_d:
            self.limit_a = min(self.limit_a, self.rounding_a)
            self.limit_j = min(self.limit_j, self.rounding_j)
        self.goal.carried_a = min(self.limit_a, own_a)
        self.goal.carried_j = min(self.limit_j, own_j)
        self.rounding_a = 1e300
        self.rounding_j = 1e300
        if self.path.history_rows[row + rows.SHAPE] == rows.ROUNDING:
            self.rounding_a = self.limit_a
            self.rounding_j = self.limit_j
            self.limit_a = own_a
            self.limit_j = own_j
        else:
            self.limit_a = self.goal.carried_a
            self.limit_j = self.goal.carried_j

# SPDX-License-Identifier: MIT
"""Goals that the path slows down for: the nearest place ahead whose speed decides the present one.

In: the current segment and the commands after it in the queue. Out: a ``Limit``. The look-ahead
settles speeds from the last segment backwards (MO-3); so the one that decides is the first whose
end speed is its own limit and not left over by a later one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import isclose

from nctakt.base.diagnostics import Text
from nctakt.kernel import codes, rows
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.timing.entries import Cause, Limit

#: Relative deviation up to which two speeds or lengths are the same.
SAME = 1e-9
#: The same of a goal with a limit of the jerk, whose speed is found by iteration.
_SAME_GOAL = 1e-6

_Row = Sequence[float]


class Goals:
    """The goals of one channel; ``line_of`` names the line of a source number."""

    def __init__(self, queue: CommandQueue, line_of: Callable[[int], Text]) -> None:
        self._queue = queue
        self._line_of = line_of

    def find(self, row: _Row, factor: float) -> Limit:
        """Return the goal for which the segment ``row``, the current one, slows down."""
        if row[rows.JERK] > 0.0:
            return self._smooth_goal(row)
        if 0.0 < row[rows.NEXT_SPEED] * factor < row[rows.END_SPEED] * (1.0 - SAME):
            number = self._queue.segment_after(-1)
            if number >= 0:
                return self._into(self._queue.command(number), "next feed")
            return Limit("next feed")
        if factor > 1.0:
            return Limit("unknown")
        number = -1
        while True:
            found = self._end_of(row, number)
            if found is not None:
                return found
            number = self._queue.segment_after(number)
            row = self._queue.command(number)

    def _end_of(self, row: _Row, number: int) -> Limit | None:
        """Return the limit of the speed at a segment's end; ``None`` if it lies further ahead."""
        following = self._queue.segment_after(number)
        if following < 0:
            return self._standstill(row, following)
        after = self._queue.command(following)
        end_v, corner_v = row[rows.END_SPEED], row[rows.CORNER_SPEED]
        if row[rows.EXACT_STOP] > 0.0:
            return Limit("exact stop", self._line_of(int(row[rows.SOURCE])))
        if corner_v == 0.0 or (end_v > 0.0 and isclose(end_v, corner_v, rel_tol=SAME)):
            return self._into(after, "corner")
        entry_v = self._queue.entry_speed_of(following)
        if end_v < min(entry_v, corner_v) * (1.0 - SAME):
            return Limit("horizon")  # the speed was computed before the next segments were known
        if not isclose(end_v, entry_v, rel_tol=SAME):
            return Limit("unknown")
        if isclose(end_v, min(after[rows.SPEED], after[rows.MAX_SPEED]), rel_tol=SAME):
            return self._into(after, _slower(after))
        return None

    def _standstill(self, row: _Row, following: int) -> Limit:
        """Return why the path is at rest at the end of a segment that no other one continues."""
        if row[rows.EXACT_STOP] > 0.0:
            return Limit("exact stop", self._line_of(int(row[rows.SOURCE])))
        is_full = self._queue.timed_count >= self._queue.look_ahead.blocks
        if following == codes.END_OF_QUEUE and is_full:
            return Limit("horizon")
        return Limit("standstill", self._line_of(int(row[rows.SOURCE])))

    def _smooth_goal(self, row: _Row) -> Limit:
        """Return the goal of a segment with a limit of the jerk: a place ahead and its speed."""
        goal_d, ahead_d, number = row[rows.GOAL_LENGTH], 0.0, -1
        is_feed, goal_v = row[rows.GOAL_KIND] != rows.LIMIT_GOAL, row[rows.GOAL_SPEED]
        while not isclose(ahead_d, goal_d, rel_tol=_SAME_GOAL, abs_tol=_SAME_GOAL):
            number = self._queue.segment_after(number)
            if number < 0 or ahead_d > goal_d:
                return Limit("unknown")
            row = self._queue.command(number)
            ahead_d += row[rows.LENGTH]
        following = self._queue.segment_after(number)
        if following < 0:
            return Limit("unknown") if is_feed or goal_v > 0.0 else self._standstill(row, following)
        after = self._queue.command(following)
        if is_feed:
            return self._into(after, "next feed")
        if row[rows.EXACT_STOP] > 0.0:
            return Limit("exact stop", self._line_of(int(row[rows.SOURCE])))
        if isclose(goal_v, row[rows.CORNER_SPEED], rel_tol=_SAME_GOAL):
            return self._into(after, "corner")
        if isclose(goal_v, after[rows.MAX_SPEED], rel_tol=_SAME_GOAL):
            return self._into(after, "next limit")
        return Limit("horizon" if goal_v == 0.0 else "unknown")

    def _into(self, after: _Row, cause: Cause) -> Limit:
        return Limit(cause, self._line_of(int(after[rows.SOURCE])))


def _slower(row: _Row) -> Cause:
    """Return why a segment is slower than the one before: its feed or a limit of its axes."""
    is_feed = row[rows.MOTION] == rows.FEED_MOTION and row[rows.SPEED] <= row[rows.MAX_SPEED]
    return "next feed" if is_feed else "next limit"

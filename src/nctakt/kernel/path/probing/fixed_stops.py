# SPDX-License-Identifier: MIT
"""Moving to a fixed stop: axes of the path that run into an obstacle and notice it (MO-12).

An axis is monitored from the command that says so (``take``) to ``disarm``. It is at its stop when
its command is farther from its actual position than its limit for a given number of ticks, within a
part of the block's length. Each axis shows it in its cells FIXED_STOP.ACTIVE, DETECTED and ACS.POS
(``axes.py``).
"""

from __future__ import annotations

from nctakt.kernel import cells, rows
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.record import Record
from nctakt.kernel.path.path import Path


class FixedStops:
    """Monitored axes of one channel's path, by their indices in it.

    ``count``: how many are monitored; ``detected_count``: how many of these have found their stop.
    """

    def __init__(self, path: Path, record: Record) -> None:
        self.path = path
        self.record = record
        room = path.room
        self.active = integers(room)
        self.detected = integers(room)
        self.needed = integers(room)
        self.ticks = integers(room)
        self.sources = integers(room)
        self.limit_d = doubles(room)
        self.min_ticks = integers(room)
        self.from_part = doubles(room)
        self.to_part = doubles(room)
        self.count = 0
        self.detected_count = 0

    def execute(self, queue: memoryview[float], row: int) -> None:
        """Monitor the axis of the command at ``row`` from now on, or no longer."""
        i = int(queue[row + rows.FIXED_STOP_AXIS])
        self.disarm(i)
        if queue[row + rows.FIXED_STOP_IS_ON] == 0.0:
            return
        self.count += 1
        self.active[i] = 1
        self.sources[i] = int(queue[row + rows.SOURCE])
        self.limit_d[i] = queue[row + rows.FIXED_STOP_LIMIT]
        self.min_ticks[i] = int(queue[row + rows.FIXED_STOP_TICKS])
        self.from_part[i] = queue[row + rows.FIXED_STOP_FROM]
        self.to_part[i] = queue[row + rows.FIXED_STOP_TO]
        self.needed[i] = int(queue[row + rows.FIXED_STOP_IS_NEEDED])
        self.show(i, 0.0)

    def disarm(self, i: int) -> None:
        """Stop monitoring an axis, and forget its stop."""
        if self.active[i]:
            self.count -= 1
            self.detected_count -= self.detected[i]
        self.active[i] = 0
        self.detected[i] = 0
        self.ticks[i] = 0
        self.show(i, 0.0)

    def clear(self) -> None:
        """Stop monitoring: the program is over or given up."""
        for i in range(self.path.count if self.count > 0 else 0):
            self.disarm(i)

    def show(self, i: int, position: float) -> None:
        """Publish the cells of an axis."""
        cell = self.path.axes.cell_of(self.path.members[i])
        self.path.axes.cells[cell + cells.AXIS_FIXED_STOP_ACTIVE] = self.active[i]
        self.path.axes.cells[cell + cells.AXIS_FIXED_STOP_DETECTED] = self.detected[i]
        self.path.axes.cells[cell + cells.AXIS_FIXED_STOP_ACS_POS] = position

    def watch(self) -> int:
        """Watch a tick; return 1 if the last monitored axis has found its stop in it."""
        before = self.detected_count
        part = self.path.covered_part()
        for i in range(self.path.count):
            if self.active[i] and not self.detected[i]:
                self.watch_axis(i, part)
        return 1 if self.detected_count > before and self.detected_count == self.count else 0

    def watch_axis(self, i: int, part: float) -> None:
        """Watch an axis that has not found its stop for a tick."""
        axis = self.path.members[i]
        actual = self.path.axes.actual_position(axis)
        lag_d = self.path.axes.command[axis] - actual
        is_off = lag_d > self.limit_d[i] or lag_d < 0.0 - self.limit_d[i]
        if not is_off or part < self.from_part[i] or part > self.to_part[i]:
            self.ticks[i] = 0
            return
        self.ticks[i] += 1
        if self.ticks[i] >= self.min_ticks[i]:
            self.detected[i] = 1
            self.detected_count += 1
            self.show(i, actual)
            self.record.event(rows.EVENT_FIXED_STOP, self.sources[i], 0, axis, actual)

    def missing(self) -> int:
        """Index of the first axis that needs its stop and has not found it; -1 without one."""
        for i in range(self.path.count):
            if self.active[i] and self.needed[i] and not self.detected[i]:
                return i
        return -1

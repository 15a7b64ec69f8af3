# SPDX-License-Identifier: MIT
"""Measuring with a touch probe within a block (G100): where the axes were at its signal.

The block is armed while the path is at rest. The signal is HLI.PROBE at its level, a fixed stop of
an axis, or that of a simulated probe: at a share of the block's length, or after a number of ticks.
It latches the positions of the axes; the path brakes and drops the rest of the block, or continues
to its end.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.base.record import Record
from nctakt.kernel.path import geometry
from nctakt.kernel.path.path import Path
from nctakt.kernel.path.probing.fixed_stops import FixedStops
from nctakt.kernel.plc.panel import Panel


class TouchProbe:
    """The touch probe of one channel.

    ``touch_part``: share of the block's length at which the simulated probe touches, below 0:
    nowhere; ``ticks``: how many ticks it still waits, below 0: it does not. ``values``: positions
    of the axes at the signal, in mm or degrees, as the block's segment has them.
    """

    def __init__(self, path: Path, panel: Panel, record: Record, fixed_stops: FixedStops) -> None:
        self.path = path
        self.panel = panel
        self.fixed_stops = fixed_stops
        self.record = record
        self.values = doubles(path.room)
        self.is_seeking = False
        self.is_braking = False
        self.has_touched = False
        self.source = 0
        self.touch_part = -1.0
        self.ticks = -1
        self.touch_level = 1
        self.continues = False
        self.is_needed = False

    def arm(self, source: int, queue: memoryview[float], row: int) -> int:
        """Measure in the next block; return 0, or the message for a probe that is pressed."""
        self.source = source
        self.touch_part = queue[row + rows.TOUCH_PART]
        self.ticks = int(queue[row + rows.TOUCH_TICKS])
        self.touch_level = int(queue[row + rows.TOUCH_LEVEL])
        self.continues = queue[row + rows.TOUCH_CONTINUES] != 0.0
        self.is_needed = queue[row + rows.TOUCH_IS_NEEDED] != 0.0
        self.has_touched = False
        self.is_braking = False
        self.is_seeking = True
        if not self.is_pressed():
            return 0
        if queue[row + rows.TOUCH_MAY_BE_PRESSED] == 0.0:
            self.is_seeking = False
            return 50052
        self.latch_actual(0.0)
        return 0

    def clear(self) -> None:
        """Stop measuring."""
        self.is_seeking = False
        self.is_braking = False

    def is_pressed(self) -> int:
        """Return whether HLI.PROBE is at the level of the signal, or an axis at a fixed stop."""
        if self.touch_level == codes.FIXED_STOP_SIGNAL:
            return 1 if self.fixed_stops.detected_count > 0 else 0
        return 1 if (1 if self.panel.probe else 0) == self.touch_level else 0

    def watch(self) -> int:
        """Watch a tick before the path's increment; return 1 if the path has to brake."""
        if self.is_seeking:
            self.seek()
        if self.is_braking and self.path.speed_v == 0.0:
            self.is_braking = False
            self.path.abandon()
        return 1 if self.is_braking else 0

    def seek(self) -> None:
        """Look for the signal."""
        if self.is_pressed():
            self.latch_actual(self.path.covered_length())
        elif self.touch_part >= 0.0 and self.path.covered_part() >= self.touch_part:
            self.latch_simulated()
        elif self.ticks >= 0:
            self.ticks -= 1
            if self.ticks < 0:
                self.latch_actual(self.path.covered_length())

    def latch_actual(self, covered_d: float) -> None:
        """Latch the actual positions at the start of this tick."""
        for i in range(self.path.count):
            self.values[i] = self.path.axes.actual_position(self.path.members[i])
        self.touch(covered_d)

    def latch_simulated(self) -> None:
        """Latch the positions where the simulated probe touches."""
        length_d = self.path.history_rows[self.path.row + rows.LENGTH]
        covered_d = length_d * self.touch_part
        geometry.locate(
            self.path.history_rows, self.path.row, self.path.count, covered_d, self.values
        )
        self.path.to_axes(self.values)
        self.touch(covered_d)

    def touch(self, covered_d: float) -> None:
        """Note the signal, ``covered_d`` mm after the start of the block."""
        self.is_seeking = False
        self.has_touched = True
        self.is_braking = not self.continues
        self.record.event(rows.EVENT_TOUCHED, self.source, 0, covered_d)

    def finish(self) -> int:
        """Finish the block; return 0, or the message for a signal that did not come."""
        if self.is_seeking and self.is_pressed():
            self.latch_actual(self.path.covered_length())
        elif self.is_seeking and self.touch_part >= 0.0:
            self.latch_simulated()
        self.clear()
        return 901700 if self.is_needed and not self.has_touched else 0

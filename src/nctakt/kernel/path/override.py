# SPDX-License-Identifier: MIT
"""The override of the path: the factor for the prepared speed of a segment (RC-305).

The programmed part is in the prepared speed already; P-CHAN-00056 bounds the others, as contour
preparation counts with it. G166 leaves out operator's and programmed part; under G95 the speed
follows the spindle's. While a thread is cut (G33) no part of it acts.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.cycles.context import Context


class Overrides:
    """The override of one channel with the operator's and the CYCLE part of this tick, in percent.

    ``total_pct``: all parts together, of the segment that was asked for last. ``is_settled``: the
    parts are those of a tick.
    """

    def __init__(self, context: Context) -> None:
        self.context = context
        self.max_pct = 100.0
        self.operator_pct = 100.0
        self.cycle_pct = 100.0
        self.is_settled = False
        self.total_pct = 100.0

    def have_changed(self, operator_pct: float, cycle_pct: float) -> int:
        """Take the parts of this tick; return whether they are not those of the tick before."""
        if self.is_settled and operator_pct == self.operator_pct and cycle_pct == self.cycle_pct:
            return 0
        self.operator_pct = operator_pct
        self.cycle_pct = cycle_pct
        self.is_settled = True
        return 1

    def parts(self, ignores_override: int) -> float:
        """The parts of this tick together, in percent, with or without the operator's (G166)."""
        operator = 100.0 if ignores_override else self.operator_pct
        return min(operator * self.cycle_pct / 100.0, self.max_pct)

    def none(self) -> float:
        """Factor where no segment is current."""
        self.total_pct = self.parts(0)
        return self.total_pct / 100.0

    def factor(self, segments: memoryview[float], row: int) -> float:
        """Factor of a segment, and its override in percent in ``total_pct``."""
        pct = self.parts(segments[row + rows.IGNORES_OVERRIDE] != 0.0)
        if segments[row + rows.THREAD] == rows.CUTTING:
            pct = 100.0
        self.total_pct = pct
        if segments[row + rows.SPEED_OVERRIDE] == 0.0:
            return pct / 100.0
        self.total_pct = pct * segments[row + rows.SPEED_OVERRIDE]
        spindle = int(segments[row + rows.FEED_SPINDLE])
        if spindle > 0 and segments[row + rows.THREAD] != rows.TAPPING:
            speed_v = self.context.spindles.speed_v[spindle - 1]
            pct *= (speed_v if speed_v > 0.0 else 0.0 - speed_v) / segments[
                row + rows.FEED_SPINDLE_SPEED
            ]
            pct = min(pct, max(100.0, self.max_pct))
        return pct / 100.0

# SPDX-License-Identifier: MIT
"""Limits of the path in a tick: a feed, an override, an axis, a curve, a goal ahead.

In: the speeds before and after the tick, and the current segment with its limits. Out: how the
speed changes, and a ``Limit``. A limit is named only if its own value is that of the segment;
otherwise the cause is ``unknown``, or has no axis.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import hypot, isclose, radians

from nctakt.base.diagnostics import Text
from nctakt.kernel import codes, rows
from nctakt.kernel.tick.channel import Channel
from nctakt.run.causes.wait_reasons import cycle_that_writes
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.timing.entries import NOTHING, Limit, Phase
from nctakt.timing.goals import SAME, Goals

#: Columns of ``SegmentLimits.of_axis``, of rapid motions and of the others.
_RAPID_SPEED, _HIGHEST_SPEED = 0, 1
_ACCELERATIONS, _SLOPES, _JERKS = (2, 3), (4, 5), (6, 7)

_CYCLE_OVERRIDE = "V.RTG.OVERRIDE.VEL.CYCLE"

_Row = Sequence[float]


class PathLimits:
    """The limits of one channel's path; ``index`` counts from 0."""

    def __init__(
        self, machine: AssembledMachine, index: int, line_of: Callable[[int], Text]
    ) -> None:
        self._machine = machine
        self._index = index
        self._channel: Channel = machine.channels[index]
        self._goals = Goals(self._channel.queue, line_of)
        self._tick_t = machine.configuration.cycle_time_us / 1e6

    def of_tick(self, row: _Row, before_v: float, after_v: float) -> tuple[Phase, Limit]:
        """Return how the speed has changed on the segment ``row``, and its limit."""
        limit_v, factor, stage = self._channel.path.planned()
        is_over = not self._channel.path.is_active
        phase = _phase(before_v, after_v)
        if row[rows.THREAD] != rows.NO_THREAD:
            return phase, Limit("spindle")
        if before_v == 0.0 == after_v:
            return phase, Limit("tick" if is_over else "unknown")
        if phase == "accelerating":
            return phase, self._acceleration(row, after_v - before_v, stage)
        if phase == "braking" and before_v > limit_v * (1.0 + SAME) and not is_over:
            if limit_v == 0.0:
                return phase, Limit("hold" if self._channel.panel.feed_hold else "stop")
            return phase, self._speed(row, factor)
        if phase == "constant" and isclose(after_v, limit_v, rel_tol=SAME):
            return phase, self._speed(row, factor)
        if phase == "constant" and _is_on_curve(row, stage, after_v):
            return phase, Limit("rounding")
        if row[rows.ARC_PIECES] > 0.0:
            return phase, Limit("unknown")
        if is_over and after_v == 0.0 and row[rows.EXACT_STOP] == 0.0:
            return phase, Limit("standstill")
        return phase, self._goals.find(row, factor)

    # --- speeds -----------------------------------------------------------------------------------

    def _speed(self, row: _Row, factor: float) -> Limit:
        """Return the limit of a speed that is neither reached nor left."""
        is_rapid = row[rows.MOTION] == rows.RAPID_MOTION
        if row[rows.SPEED] * factor <= row[rows.MAX_SPEED]:
            override = self._override(row, factor)
            if override is not None:
                return override
            if is_rapid:
                return Limit("speed", self._axis(row, row[rows.SPEED], _RAPID_SPEED))
            return Limit("feed")
        axis = self._axis(row, row[rows.MAX_SPEED], _HIGHEST_SPEED)
        if axis == NOTHING and row[rows.SHAPE] != rows.LINE:
            return Limit("curvature")
        return Limit("speed" if axis != NOTHING else "unknown", axis)

    def _override(self, row: _Row, factor: float) -> Limit | None:
        """Return the override that lowers a speed; ``None`` if none does."""
        ignores_operator = row[rows.IGNORES_OVERRIDE] > 0.0
        operator_pct = 100.0 if ignores_operator else self._channel.panel.override_pct
        cycle_pct = float(self._machine.read(f"{self._prefix}{_CYCLE_OVERRIDE}"))
        common = operator_pct * cycle_pct / 1e4
        if row[rows.FEED_SPINDLE] > 0.0 and factor < common * (1.0 - SAME):
            return Limit("spindle")
        if operator_pct < 100.0 and cycle_pct < 100.0:
            return Limit("override both", self._writer())
        if operator_pct < 100.0:
            return Limit("override operator", _percent(operator_pct))
        if cycle_pct < 100.0:
            return Limit("override cycle", self._writer())
        if 0.0 < row[rows.SPEED_OVERRIDE] < 1.0:
            return Limit("override program", _percent(100.0 * row[rows.SPEED_OVERRIDE]))
        return None

    @property
    def _prefix(self) -> str:
        several = self._machine.number_in_names(self._index)
        return self._machine.assembled[self._index].prefix if several else ""

    def _writer(self) -> Text:
        """Return which realtime cycle has set the CYCLE override; empty if that is not known."""
        found = cycle_that_writes(self._machine, self._index, _CYCLE_OVERRIDE)
        if found is None:
            return NOTHING
        cycle, line = found
        return Text(f"cycle {cycle}, line {line}", f"Zyklus {cycle}, Zeile {line}")

    # --- accelerations ----------------------------------------------------------------------------

    def _acceleration(self, row: _Row, gained_v: float, stage: int) -> Limit:
        """Return the limit of an acceleration: that of an axis, or its jerk."""
        is_rapid = row[rows.MOTION] == rows.RAPID_MOTION
        column = 0 if is_rapid else 1
        if row[rows.JERK] > 0.0:
            if gained_v / self._tick_t < row[rows.ACCELERATION] * (1.0 - SAME):
                return Limit("jerk", self._axis(row, row[rows.JERK], _JERKS[column]))
            return Limit("acceleration", self._axis(row, row[rows.ACCELERATION], _SLOPES[column]))
        if stage in (codes.ENTRY_ZONE, codes.EXIT_ZONE, codes.CURVE):
            return Limit("acceleration")
        return Limit(
            "acceleration", self._axis(row, row[rows.ACCELERATION], _ACCELERATIONS[column])
        )

    def _axis(self, row: _Row, limit: float, column: int) -> Text:
        """Return the axis whose limit is that of the path on a line or arc; else empty."""
        if row[rows.TRANSFORMATION] > 0.0 or row[rows.SHAPE] not in (rows.LINE, rows.ARC):
            return NOTHING
        limits = self._channel.queue.look_ahead.limits
        parts = self._parts(row, limits.count)
        allowed = [limits.of_axis(i)[column] / part if part else 1e300 for i, part in parts]
        if not isclose(min(allowed), limit, rel_tol=SAME):
            return NOTHING
        members = self._machine.members_of(self._index)
        names = [
            self._machine.registry.axis(members[i])
            for i, one in enumerate(allowed)
            if isclose(one, limit, rel_tol=SAME)
        ]
        text = ", ".join(names)
        return Text(text, text)

    @staticmethod
    def _parts(row: _Row, count: int) -> list[tuple[int, float]]:
        """Return the share of the length of the path that each axis moves at most."""
        start, target = rows.START, rows.START + count
        length = row[rows.LENGTH]
        parts = [abs(row[target + i] - row[start + i]) / length for i in range(count)]
        if row[rows.SHAPE] == rows.ARC:
            first, second = int(row[rows.ARC_FIRST_AXIS]), int(row[rows.ARC_SECOND_AXIS])
            radius = hypot(
                row[start + first] - row[rows.ARC_FIRST_CENTRE],
                row[start + second] - row[rows.ARC_SECOND_CENTRE],
            )
            parts[first] = parts[second] = radius * radians(abs(row[rows.ARC_ANGLE])) / length
        return list(enumerate(parts))


def _phase(before_v: float, after_v: float) -> Phase:
    if isclose(before_v, after_v, rel_tol=SAME):
        return "constant"
    return "accelerating" if after_v > before_v else "braking"


def _is_on_curve(row: _Row, stage: int, speed_v: float) -> bool:
    """Return whether a speed is that of a rounded corner."""
    if row[rows.SHAPE] == rows.ROUNDING:
        return isclose(speed_v, row[rows.MAX_SPEED], rel_tol=SAME)
    return stage == codes.CURVE and isclose(speed_v, row[rows.CURVE_SPEED], rel_tol=SAME)


def _percent(value: float) -> Text:
    return Text(f"{value:g} %", f"{value:g} %")

# SPDX-License-Identifier: MIT
"""A recorded run -> curves: the positions of axes, their derivatives and limits.

In: a trace with the ``signals``, the machine's lists. Out: curves, arrays over time. A row of tick
n holds the values at its end, (n + 1) · T. Speed, acceleration and jerk are differences of the
recorded positions, each in the middle of its interval: the picture shows the motion of the axes,
not the plan.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.results.trace.recorded import Trace

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Values = NDArray[numpy.float64]

SPEED, ACCELERATION, JERK = 1, 2, 3

PATH_SPEED, DISTANCE_TO_GO = "PATH.SPEED", "PATH.DIST_TO_GO"
OVERRIDE, RAPID = "OVERRIDE.VEL.TOTAL", "PATH.RAPID"


@dataclass(frozen=True, slots=True)
class Curve:
    """Values at times; both have the same length."""

    time_s: Values
    values: Values

    @property
    def is_constant(self) -> bool:
        """Whether it has one value only."""
        return not len(self.values) or bool(numpy.ptp(self.values) == 0.0)


@dataclass(frozen=True, slots=True)
class AxisMotion:
    """The motion of one axis in mm or degrees and seconds.

    ``position`` is continuous, also for a modulo axis. ``derivatives``: speed, acceleration and
    jerk. ``limits``: of these three, 0 for none. ``tip``: the tool's position along the axis, which
    under a transformation differs from the axis position.
    """

    name: str
    unit: str
    position: Curve
    derivatives: tuple[Curve, Curve, Curve]
    limits: tuple[float, float, float]
    tip: Curve

    @property
    def moves(self) -> bool:
        """Whether its position changes."""
        return not self.position.is_constant


def position_signal(axis: str) -> str:
    """Return the signal with the position of an axis."""
    return f"{axis}.ACS.ACT_POS"


def tip_signal(axis: str) -> str:
    """Return the signal with the place of the tool along an axis."""
    return f"{axis}.MCS.ACT_POS"


def signals(axes: Sequence[str], *, has_transformations: bool = False) -> tuple[str, ...]:
    """Return the signals that a picture of these axes needs."""
    positions = [position_signal(axis) for axis in axes]
    if has_transformations:
        positions += [tip_signal(axis) for axis in axes]
    return (*positions, PATH_SPEED, DISTANCE_TO_GO, OVERRIDE, RAPID)


def times_of(trace: Trace) -> Values:
    """Return the ends of the recorded ticks in s."""
    return ((trace.tick + 1) * trace.cycle_time_us / 1e6).astype(numpy.float64)


def curve_of(trace: Trace, signal: str) -> Curve:
    """Return a recorded signal; an empty curve if it was not recorded."""
    if signal not in trace:
        return Curve(numpy.empty(0), numpy.empty(0))
    return Curve(times_of(trace), trace[signal])


def axis_motion(trace: Trace, axis: AxisConfiguration, *, limits_jerk: bool = False) -> AxisMotion:
    """Return the motion of an axis whose position was recorded.

    ``limits_jerk``: the path has the jerk-limited slope; otherwise the jerk has no limit.
    """
    cycle_time_s = trace.cycle_time_us / 1e6
    time_s = times_of(trace)
    position = trace[position_signal(axis.name)]
    if axis.is_modulo and len(position):
        position = numpy.unwrap(position, period=axis.modulo_range)
    dynamics = axis.dynamics
    highest = max(dynamics.feed_acceleration, dynamics.rapid_acceleration)
    jerk = 0.0
    if limits_jerk:
        highest = max(highest, *dynamics.smooth_accelerations)
        jerk = max(dynamics.smooth_jerks)
    speed, acceleration, third = (
        derivative(position, time_s, cycle_time_s, order) for order in (1, 2, 3)
    )
    return AxisMotion(
        axis.name,
        "mm" if axis.is_linear else "°",
        Curve(time_s, position),
        (speed, acceleration, third),
        (axis.max_speed, highest, jerk),
        Curve(time_s, trace[tip_signal(axis.name)] if tip_signal(axis.name) in trace else position),
    )


def derivative(position: Values, time_s: Values, cycle_time_s: float, order: int) -> Curve:
    """Return the mean derivative of this order over ``order`` ticks each."""
    values = numpy.diff(position, order) / cycle_time_s**order
    return Curve(time_s[order:] - order * cycle_time_s / 2.0, values)


def thinned(curve: Curve, max_points: int) -> Curve:
    """Return the curve with at most ``max_points`` points: minimum and maximum of each piece."""
    count = len(curve.values)
    pieces = max_points // 2
    if count <= max_points:
        return curve
    edges = numpy.linspace(0, count, pieces + 1).astype(int)
    kept: list[int] = []
    for begin, end in itertools.pairwise(edges.tolist()):
        piece = curve.values[begin:end]
        kept.extend(sorted({begin + int(piece.argmin()), begin + int(piece.argmax())}))
    return Curve(curve.time_s[kept], curve.values[kept])

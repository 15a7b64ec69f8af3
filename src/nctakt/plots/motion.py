# SPDX-License-Identifier: MIT
"""A recorded run -> the curves of a picture: positions, their derivatives, limits, lanes.

In: a trace with the ``signals``, the machine's lists. Out: ``Motion``, arrays over time. A row of
tick n holds the values at its end, (n + 1) · T. Speed, acceleration and jerk are differences of the
recorded positions, each in the middle of its interval: the picture shows the motion of the axes,
not the plan.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.trace.events import Event
from nctakt.trace.recorded import Trace

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Values = NDArray[numpy.float64]

SPEED, ACCELERATION, JERK = 1, 2, 3

_PATH_SIGNALS = ("PATH.SPEED", "PATH.DIST_TO_GO", "OVERRIDE.VEL.TOTAL")
#: Kinds of events in the picture.
_MARKS = ("fired", "M", "H", "output", "error", "starved", "overflow", "end")


@dataclass(frozen=True, slots=True)
class Curve:
    """Values at times; both have the same length."""

    time_s: Values
    values: Values


@dataclass(frozen=True, slots=True)
class AxisMotion:
    """The motion of one axis in mm or degrees and seconds.

    ``position`` is continuous, also for a modulo axis. ``derivatives``: speed, acceleration and
    jerk. ``limits``: of these three, 0 for none.
    """

    name: str
    unit: str
    position: Curve
    derivatives: tuple[Curve, Curve, Curve]
    limits: tuple[float, float, float]
    moves: bool


@dataclass(frozen=True, slots=True)
class Lane:
    """Events of one kind and label.

    ``spans``: begins and ends in s, in order; events in consecutive ticks are one span, a single
    event has a span without length.
    """

    kind: str
    label: str
    spans: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class Motion:
    """A run as curves; ``override`` in percent, ``distance_to_go`` on the path in mm."""

    axes: tuple[AxisMotion, ...]
    path_speed: Curve
    override: Curve
    distance_to_go: Curve
    lanes: tuple[Lane, ...]


def position_signal(axis: str) -> str:
    """Return the signal with the position of an axis."""
    return f"{axis}.ACS.ACT_POS"


def signals(axes: Sequence[str]) -> tuple[str, ...]:
    """Return the signals that a picture of these axes needs."""
    return (*(position_signal(axis) for axis in axes), *_PATH_SIGNALS)


def motion_of(
    trace: Trace, axes: Sequence[AxisConfiguration], *, limits_jerk: bool = False
) -> Motion:
    """Return the curves of a run that recorded ``signals``.

    ``limits_jerk``: the path has the jerk-limited slope; otherwise the jerk has no limit.
    """
    cycle_time_s = trace.cycle_time_us / 1e6
    time_s = ((trace.tick + 1) * trace.cycle_time_us / 1e6).astype(numpy.float64)
    return Motion(
        tuple(_axis(trace, axis, time_s, cycle_time_s, limits_jerk) for axis in axes),
        Curve(time_s, trace["PATH.SPEED"]),
        Curve(time_s, trace["OVERRIDE.VEL.TOTAL"]),
        Curve(time_s, trace["PATH.DIST_TO_GO"]),
        _lanes(trace.events, trace.cycle_time_us),
    )


def _axis(
    trace: Trace,
    axis: AxisConfiguration,
    time_s: Values,
    cycle_time_s: float,
    limits_jerk: bool,
) -> AxisMotion:
    position = trace[position_signal(axis.name)]
    if axis.is_modulo and len(position):
        position = numpy.unwrap(position, period=axis.modulo_range)
    dynamics = axis.dynamics
    trapezoid = (dynamics.feed_acceleration, dynamics.rapid_acceleration)
    jerk = max(dynamics.smooth_jerks) if limits_jerk else 0.0
    limits = (axis.max_speed, max(trapezoid), jerk)
    speed, acceleration, third = (
        derivative(position, time_s, cycle_time_s, order) for order in (1, 2, 3)
    )
    return AxisMotion(
        axis.name,
        "mm" if axis.is_linear else "°",
        Curve(time_s, position),
        (speed, acceleration, third),
        limits,
        bool(len(position)) and bool(numpy.ptp(position) > 0.0),
    )


def derivative(position: Values, time_s: Values, cycle_time_s: float, order: int) -> Curve:
    """Return the mean derivative of this order over ``order`` ticks each."""
    values = numpy.diff(position, order) / cycle_time_s**order
    return Curve(time_s[order:] - order * cycle_time_s / 2.0, values)


def _lanes(events: Iterable[Event], cycle_time_us: int) -> tuple[Lane, ...]:
    """Return a lane for each reaction, function, error and end, by the time of its first event."""
    spans: dict[tuple[str, str], list[tuple[int, int]]] = {}
    for event in events:
        if event.kind not in _MARKS:
            continue
        own = spans.setdefault((event.kind, _label(event)), [])
        goes_on = event.kind == "starved" and event.text != "begun"
        if own and (goes_on or event.time_us - own[-1][1] <= cycle_time_us):
            own[-1] = (own[-1][0], event.time_us)
        else:
            own.append((event.time_us, event.time_us))
    return tuple(
        Lane(kind, label, tuple((begin / 1e6, end / 1e6) for begin, end in own))
        for (kind, label), own in spans.items()
    )


def _label(event: Event) -> str:
    words = event.text.split()
    if event.kind == "fired":
        return f"{words[0]}: {words[-1]}"
    if event.kind in ("M", "H"):
        return f"{event.kind}{words[0]}"
    if event.kind == "output":
        return f"{words[0]}{words[1]}"
    if event.kind == "starved":
        return f"{event.prefix}starved"
    if event.kind == "overflow":
        return f"overflow {event.text}"
    return words[0] if event.kind == "error" else event.kind


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

# SPDX-License-Identifier: MIT
"""The time of a run if one limit were doubled: the same programs on changed machines.

In: a machine, and a function that runs the programs on a machine. Out: a ``Variant`` for each
limit. Nothing is estimated: each is a separate run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.lists.machine.axis_configuration import AxisConfiguration, AxisDynamics, TrapezoidSlope
from nctakt.lists.machine.machine import Machine
from nctakt.results.run import Run, RunState
from nctakt.run.access.machine_names import prefix_of

_FEEDS = Text("all F (override 200 %)", "alle F (Override 200 %)")
_SPEED = Text("speed of {axis}", "Geschwindigkeit von {axis}")
_ACCELERATION = Text("acceleration of {axis}", "Beschleunigung von {axis}")
_JERK = Text("jerk of {axis}", "Ruck von {axis}")
_LOOK_AHEAD = Text("blocks of the look-ahead", "Sätze der Vorausschau")


@dataclass(frozen=True, slots=True)
class Variant:
    """A run with one limit doubled; ``saved_us``: how much shorter it is, below 0 if longer.

    ``changes_nothing``: it takes the same time and ends in the same state.
    """

    name: Text
    state: RunState
    time_us: int
    saved_us: int
    changes_nothing: bool


def what_if(
    run: Run,
    machine: Machine,
    rerun: Callable[[Machine, Mapping[str, float]], Run],
    *,
    has_override: bool,
) -> list[Variant]:
    """Return the time of ``run`` with each limit doubled.

    ``rerun`` runs its programs again on a machine with values of variables. ``has_override``:
    somebody sets the operator's override in the run, so that all F cannot be doubled by it.
    """
    found = []
    variants: list[tuple[Text, Machine, dict[str, float]]] = [
        (name, changed, {}) for name, changed in _changed(machine)
    ]
    if not has_override:
        variants.insert(0, _with_feeds(machine))
    for name, changed, values in variants:
        again = rerun(changed, values)
        saved_us = run.virtual_time_us - again.virtual_time_us
        is_same = saved_us == 0 and again.state == run.state
        found.append(Variant(name, again.state, again.virtual_time_us, saved_us, is_same))
        if again.state == "interrupted":
            break
    return found


def _changed(machine: Machine) -> Iterator[tuple[Text, Machine]]:
    """Yield the machines with one limit doubled."""
    moved = dict.fromkeys(axis.index for channel in machine.channels for axis in channel.axes)
    for index in moved:
        axis = machine.axes[index]
        for text, change in ((_SPEED, _faster), (_ACCELERATION, _stronger), (_JERK, _jerkier)):
            name = Text(text.en.format(axis=axis.name), text.de.format(axis=axis.name))
            yield name, _with_axis(machine, index, _with_dynamics(axis, change))
    channels = tuple(
        replace(
            one,
            startup=replace(one.startup, look_ahead_blocks=2 * one.startup.look_ahead_blocks),
        )
        for one in machine.channels
    )
    yield _LOOK_AHEAD, replace(machine, channels=channels)


def _with_feeds(machine: Machine) -> tuple[Text, Machine, dict[str, float]]:
    """Return the machine on which the operator's override doubles all F (P-CHAN-00056)."""
    channels = []
    values = {}
    for index, channel in enumerate(machine.channels):
        maximum = max(channel.parameters.max_override_pct, 200.0)
        parameters = replace(channel.parameters, max_override_pct=maximum)
        channels.append(replace(channel, parameters=parameters))
        prefix = prefix_of(index) if len(machine.channels) > 1 else ""
        values[f"{prefix}HLI.OVERRIDE"] = 200.0
    return _FEEDS, replace(machine, channels=tuple(channels)), values


def _with_axis(machine: Machine, index: int, axis: AxisConfiguration) -> Machine:
    axes: Sequence[AxisConfiguration] = machine.axes
    return replace(machine, axes=(*axes[:index], axis, *axes[index + 1 :]))


def _with_dynamics(
    axis: AxisConfiguration, change: Callable[[AxisDynamics], AxisDynamics]
) -> AxisConfiguration:
    gears = tuple(change(one) for one in axis.gears)
    return replace(axis, dynamics=change(axis.dynamics), gears=gears)


def _faster(dynamics: AxisDynamics) -> AxisDynamics:
    """Double both speeds; the changeover speed of the acceleration stays in proportion."""
    return replace(
        dynamics,
        max_speed=2.0 * dynamics.max_speed,
        rapid_speed=2.0 * dynamics.rapid_speed,
        feed_slope=_with_doubled_changeover(dynamics.feed_slope),
        rapid_slope=_with_doubled_changeover(dynamics.rapid_slope),
    )


def _with_doubled_changeover(slope: TrapezoidSlope) -> TrapezoidSlope:
    return replace(slope, changeover_speed=2.0 * slope.changeover_speed)


def _stronger(dynamics: AxisDynamics) -> AxisDynamics:
    """Double all accelerations, and the ramps so that the jerk stays."""
    slope = dynamics.jerk_slope
    up, down, brake, release = (2 * one for one in slope.ramp_times_us)
    return replace(
        dynamics,
        max_acceleration=2.0 * dynamics.max_acceleration,
        feed_slope=_steeper(dynamics.feed_slope),
        rapid_slope=_steeper(dynamics.rapid_slope),
        jerk_slope=replace(
            slope,
            acceleration=2.0 * slope.acceleration,
            deceleration=2.0 * slope.deceleration,
            rapid_acceleration=2.0 * slope.rapid_acceleration,
            ramp_times_us=(up, down, brake, release),
            rapid_ramp_time_us=2 * slope.rapid_ramp_time_us,
        ),
        shortest_ramp_time_us=2 * dynamics.shortest_ramp_time_us,
    )


def _steeper(slope: TrapezoidSlope) -> TrapezoidSlope:
    return replace(slope, low=2.0 * slope.low, high=2.0 * slope.high)


def _jerkier(dynamics: AxisDynamics) -> AxisDynamics:
    """Halve all ramps, to whole microseconds."""
    slope = dynamics.jerk_slope
    up, down, brake, release = (max(1, one // 2) for one in slope.ramp_times_us)
    return replace(
        dynamics,
        jerk_slope=replace(
            slope,
            ramp_times_us=(up, down, brake, release),
            rapid_ramp_time_us=max(1, slope.rapid_ramp_time_us // 2),
        ),
        shortest_ramp_time_us=max(1, dynamics.shortest_ramp_time_us // 2),
    )

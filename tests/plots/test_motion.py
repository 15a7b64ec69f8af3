# SPDX-License-Identifier: MIT
"""The curves of a picture are what the axes did."""

from __future__ import annotations

from pathlib import Path

import numpy
import pytest

from nctakt import machines
from nctakt.lists.machine.machine import load_machine
from nctakt.plots.motion import (
    ACCELERATION,
    JERK,
    SPEED,
    AxisMotion,
    Curve,
    axis_motion,
    signals,
    thinned,
)
from nctakt.run.controller import Controller, NcText

pytestmark = pytest.mark.slow


def motions(text: str) -> list[AxisMotion]:
    """The motion of each axis of a program on the demo machine."""
    controller = Controller()
    axes = controller.channel_axes
    run = controller.run(NcText("part.nc", text), signals=signals([axis.name for axis in axes]))
    assert run.trace is not None
    limits_jerk = controller.has_limited_jerk
    return [axis_motion(run.trace, axis, limits_jerk=limits_jerk) for axis in axes]


def test_the_jerk_has_a_limit_where_the_slope_gives_it_one() -> None:
    """MO-2: 4000 mm/s² in 50 ms; the axis keeps to it, and a trapezoid draws no line."""
    axis = motions("#SLOPE [TYPE=TRAPEZ]\nG00 X20\nM30\n")[0]
    assert axis.limits == (500.0, 4000.0, 80_000.0)
    assert abs(axis.derivatives[JERK - 1].values).max() == pytest.approx(80_000.0)
    assert motions("G00 X20\nM30\n")[0].limits == (500.0, 4000.0, 0.0)


def test_speed_acceleration_and_jerk_are_those_of_the_positions() -> None:
    """G00 X20: 4000 mm/s² up and down, 0.1414 s; each difference is in its middle."""
    axis = motions("G00 X20\nM30\n")[0]
    assert (axis.name, axis.unit, axis.moves) == ("X", "mm", True)
    assert axis.position.time_s[0] == pytest.approx(0.001)
    speed, acceleration, jerk = axis.derivatives
    assert len(speed.values) == len(axis.position.values) - 1
    # From 1 ms to 2 ms the axis goes from 0.002 mm to 0.008 mm.
    assert speed.time_s[0] == pytest.approx(0.0015)
    assert speed.values[0] == pytest.approx(6.0)
    assert acceleration.time_s[0] == pytest.approx(0.002)
    assert acceleration.values[:60] == pytest.approx(4000.0)
    assert abs(jerk.values[:60]).max() < 1.0
    assert axis.limits[SPEED - 1] == 500.0
    assert axis.limits[ACCELERATION - 1] == 4000.0
    assert len(axis.derivatives) == JERK


def test_a_modulo_axis_runs_on() -> None:
    """No jump where the position that is shown restarts."""
    axis = motions("G00 A700\nM30\n")[3]
    assert axis.unit == "°"
    assert axis.position.values[-1] - axis.position.values[0] == pytest.approx(700.0, abs=0.1)
    assert abs(axis.derivatives[0].values).max() <= 360.1


def test_many_points_are_thinned_to_the_lowest_and_highest_of_each_piece() -> None:
    """A peak of one tick stays in the picture."""
    values = numpy.zeros(100_000)
    values[54_321] = 1.0
    few = thinned(Curve(numpy.arange(100_000.0), values), 1000)
    assert len(few.values) <= 1000
    assert few.values.max() == 1.0
    assert few.time_s[few.values.argmax()] == 54_321.0


def test_the_path_under_a_transformation_is_that_of_the_tip() -> None:
    """The tip stays at its place while the head turns about it: only the axes move."""
    controller = Controller(load_machine(Path(machines.__path__[0]) / "demo5"))
    names = signals([axis.name for axis in controller.channel_axes], has_transformations=True)
    text = "N1 G00 X10 Y20 Z30\nN2 #TRAFO ON\nN3 G01 A40 C30 F5000\nM30"
    trace = controller.run(NcText("part.nc", text), signals=[*names, "BLOCK"]).trace
    assert trace is not None
    inside = trace["BLOCK"] == 3
    for axis in controller.channel_axes[:3]:
        motion = axis_motion(trace, axis)
        assert numpy.ptp(motion.position.values[inside][:-1]) > 1.0 or axis.name == "X"
        assert numpy.ptp(motion.tip.values[inside][:-1]) < 1e-9

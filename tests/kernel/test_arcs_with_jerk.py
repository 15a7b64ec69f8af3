# SPDX-License-Identifier: MIT
"""Arcs with the jerk-limited slope: entered, passed and left within each axis' limits (MO-1)."""

from __future__ import annotations

import math

import pytest
from support.kernel_rig import DEMO
from support.random_paths import violations

from nctakt.run.controller import Controller, NcText

SIGNALS = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "Z.ACS.ACT_POS"]
MAX_JERK_MM = 8e-5


def assert_within_limits(program: str) -> None:
    """Speed, acceleration and jerk of X, Y and Z in each tick."""
    text = NcText("p.nc", f"#SLOPE [TYPE=TRAPEZ]\n{program}\nM30")
    run = Controller(DEMO).run(text, signals=SIGNALS)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    for name, signal in zip("XYZ", SIGNALS, strict=True):
        assert violations(run.trace[signal], name, MAX_JERK_MM) == []


@pytest.mark.parametrize("feed", [10, 60, 200, 450])
@pytest.mark.parametrize("radius", [0.05, 0.5, 5.0, 50.0, 400.0])
def test_an_arc_between_tangential_lines_keeps_the_jerk(radius: float, feed: float) -> None:
    """A line of 80 mm, a quarter, a line: the centripetal acceleration comes and goes in a step."""
    assert_within_limits(f"G91 G01 X80 F{feed * 60}\nG03 X{radius} Y{radius} I0 J{radius}\nG01 Y80")


@pytest.mark.parametrize("heading", [0.0, 0.4, math.pi / 4, 1.2])
@pytest.mark.parametrize("radius", [0.5, 5.0, 50.0])
def test_arcs_that_bend_the_other_way_keep_the_jerk(radius: float, heading: float) -> None:
    """Two thirds of a circle to the left, as much to the right: twice the step of acceleration."""
    lines = [f"G91 G01 X{80 * math.cos(heading):.9f} Y{80 * math.sin(heading):.9f} F18000"]
    for sign in (1, -1):
        x, y = -math.sin(heading) * radius * sign, math.cos(heading) * radius * sign
        heading += sign * 4.0
        ends = (x + sign * math.sin(heading) * radius, y - sign * math.cos(heading) * radius)
        lines.append(f"G0{3 if sign > 0 else 2} X{ends[0]:.9f} Y{ends[1]:.9f} I{x:.9f} J{y:.9f}")
    assert_within_limits("\n".join(lines))


@pytest.mark.parametrize("rise", [0.1, 5.0, 200.0])
def test_a_helix_keeps_the_jerk(rise: float) -> None:
    """Three turns of a helix after a line, flat and steep."""
    turns = "\n".join(f"G03 I0 J10 Z{rise}" for _ in range(3))
    assert_within_limits(f"G91 G01 X40 F18000\n{turns}\nG01 X40")

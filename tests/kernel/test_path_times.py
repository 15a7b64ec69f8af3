# SPDX-License-Identifier: MIT
"""How long paths take, beside the best that the same limits allow (MO-2, MO-3)."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from support.kernel_rig import ACCELERATION, DEMO, RAPID

from nctakt.run.controller import Controller, NcText

JERK = ACCELERATION / 0.05


def seconds(program: str) -> float:
    """The time that a program takes up to its end."""
    run = Controller(DEMO).run(NcText("p.nc", program + "\nM30"), signals=["X.ACS.ACT_POS"])
    assert run.state == "ended", run.diagnostics
    return (run.ticks - 1) / 1000


def best_time(points: list[tuple[float, float]], feed: float) -> float:
    """The time of ``toppra`` along a smooth line, with the axes' limits and the feed."""
    toppra: Any = pytest.importorskip("toppra", reason="the oracle for curves is not installed")
    toppra.setup_logging("ERROR")
    corners = np.asarray(points)
    way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(corners, axis=0), axis=1))])
    path = toppra.SplineInterpolator(way, np.column_stack([corners, way]))
    speeds = np.array([[-RAPID, RAPID]] * 2 + [[-feed, feed]])
    accelerations = np.array([[-ACCELERATION, ACCELERATION]] * 2 + [[-1e6, 1e6]])
    limits = [
        toppra.constraint.JointVelocityConstraint(speeds),
        toppra.constraint.JointAccelerationConstraint(accelerations),
    ]
    grid = np.linspace(0, way[-1], 500)
    solver = toppra.algorithm.TOPPRA(limits, path, gridpoints=grid, solver_wrapper="seidel")
    return float(solver.compute_trajectory(0, 0).duration)


def trapezoid(length: float, speed: float, acceleration: float = ACCELERATION) -> float:
    """The shortest time of a straight way from rest to rest."""
    peak = min(speed, math.sqrt(acceleration * length))
    return length / peak + peak / acceleration


def s_curve(length: float, speed: float) -> float:
    """The same with a limit of the jerk: the highest speed that fits, by bisection."""

    def way(top: float) -> float:
        if top >= ACCELERATION**2 / JERK:
            return top * (top / ACCELERATION + ACCELERATION / JERK)
        return 2 * top * math.sqrt(top / JERK)

    low, high = 0.0, speed
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if way(middle) <= length else (low, middle)
    return (length + way(low)) / low


@pytest.mark.nightly
@pytest.mark.parametrize(("radius", "feed"), [(5, 50), (5, 100), (20, 200), (100, 200), (100, 450)])
def test_circles_take_hardly_longer_than_the_optimum(radius: float, feed: float) -> None:
    """Within 3 %, where the feed and not the acceleration sets the speed."""
    angles = np.linspace(0, 2 * math.pi, 721)
    points = [(radius * (math.cos(a) - 1), radius * math.sin(a)) for a in angles]
    found = seconds(f"G03 I-{radius} F{feed * 60}")
    assert found <= 1.03 * best_time(points, feed) + 0.001


def test_a_spiral_takes_hardly_longer_than_the_optimum() -> None:
    """Half circles whose radius grows by 1 mm each, at 60 mm/s: within 3 %."""
    place, points, program = 0.0, [(0.0, 0.0)], "F3600\n"
    for i in range(12):
        radius, sign = 4.0 + i, 1 if i % 2 == 0 else -1
        centre = place + sign * radius
        for angle in np.linspace(0, math.pi, 120)[1:]:
            points.append(
                (centre - sign * radius * math.cos(angle), -sign * radius * math.sin(angle))
            )
        place = centre + sign * radius
        program += f"G03 X{place} Y0 I{sign * radius}\n"
    found = seconds(program.rstrip("\n"))
    assert found <= 1.03 * best_time(points, 60.0) + 0.001


def test_straight_sequences_take_hardly_longer_than_the_optimum() -> None:
    """Right angles stop the path: the sum of the single optima; one tick in all for rounding."""
    lengths = [3.0, 0.4, 25.0, 7.5, 0.05, 60.0, 12.0]
    for feed in (10.0, 120.0, 400.0):
        program = f"G91 G01 F{feed * 60}\n" + "\n".join(
            f"{'XY'[i % 2]}{length}" for i, length in enumerate(lengths)
        )
        best = sum(trapezoid(length, feed) for length in lengths)
        assert best - 0.001 <= seconds(program) <= 1.03 * best + 0.001


def test_short_blocks_in_one_line_lose_nothing() -> None:
    """MO-3: 200 blocks of unequal length in one line are as fast as one block."""
    ends = np.cumsum([0.05 + 0.37 * (i % 7) for i in range(200)])
    program = "G01 F24000\n" + "\n".join(f"X{end:.2f} Y{end:.2f}" for end in ends)
    length = math.hypot(ends[-1], ends[-1])
    best = trapezoid(length, 400.0, ACCELERATION * math.sqrt(2))
    assert seconds(program) <= best * 1.001 + 0.001


def test_look_ahead_is_bounded_by_its_blocks() -> None:
    """120 blocks of 0.01 mm: the path is never faster than it can brake within them."""
    ends = [0.01 * (i + 1) for i in range(2000)]
    program = "G01 F24000\n" + "\n".join(f"X{end:.2f}" for end in ends)
    run = Controller(DEMO).run(NcText("p.nc", program + "\nM30"), signals=["PATH.SPEED"])
    assert run.trace is not None
    maximum = math.sqrt(2 * ACCELERATION * 0.01 * 190)
    assert math.sqrt(2 * ACCELERATION * 0.01 * 110) < max(run.trace["PATH.SPEED"]) <= maximum


def test_short_blocks_lose_nothing_with_a_limit_of_the_jerk() -> None:
    """MO-3: 200 blocks of 0.1 mm and more in one line are as fast as one block, within a tick."""
    ends = np.cumsum([0.1 + 0.37 * (i % 7) for i in range(200)])
    for feed in (40.0, 200.0, 400.0):
        program = f"#SLOPE [TYPE=TRAPEZ]\nG01 F{feed * 60}\n" + "\n".join(
            f"X{end:.2f}" for end in ends
        )
        assert seconds(program) <= s_curve(ends[-1], feed) + 0.001


def test_a_feed_changes_within_the_jerk_in_the_best_time() -> None:
    """MO-3: 60 mm at 100 mm/s, 30 mm at 20 mm/s: the first ends with the second's feed.

    By hand: up to 100 and down to 20 mm/s with peaks √(80000 · Δv), then down from 20 to a
    standstill.
    """

    def ramp(change: float) -> float:
        return change / ACCELERATION + 0.05 if change >= 200 else 2 * math.sqrt(change / JERK)

    up, down, stop = ramp(100), ramp(80), ramp(20)
    best = up + (60 - 50 * up - 60 * down) / 100 + down + (30 - 10 * stop) / 20 + stop
    found = seconds("#SLOPE [TYPE=TRAPEZ]\nG01 X60 F6000\nX90 F1200")
    assert best - 0.001 <= found <= best + 0.002


@pytest.mark.parametrize("length", [0.01, 0.3, 5.0, 20.0, 70.0, 400.0])
@pytest.mark.parametrize("feed", [20.0, 150.0, 450.0])
def test_jerk_limited_blocks_take_the_optimum(length: float, feed: float) -> None:
    """MO-2: from rest to rest, rounded up to whole ticks."""
    found = seconds(f"#SLOPE [TYPE=TRAPEZ]\nG01 X{length} F{feed * 60}")
    assert found == pytest.approx(math.ceil(1000 * s_curve(length, feed) - 1e-6) / 1000, abs=1e-9)


def test_the_jerk_limited_slope_follows_its_polynomials() -> None:
    """MO-14: 10 mm at 20 mm/s: √(20 / 80000) = 15.8 ms up and down each, jerk 80000 mm/s³."""
    program = "#SLOPE [TYPE=TRAPEZ]\nG01 X10 F1200\nM30"
    run = Controller(DEMO).run(NcText("p.nc", program), signals=["X.ACS.ACT_POS"])
    assert run.trace is not None
    for tick, found in enumerate(run.trace["X.ACS.ACT_POS"][:15].tolist()):
        assert found == pytest.approx(JERK * ((tick + 1) / 1000) ** 3 / 6, abs=1e-12)
    places = [0.0, *run.trace["X.ACS.ACT_POS"].tolist()]
    assert max(after - before for before, after in pairwise(places)) == pytest.approx(0.02)
    assert places[-1] == 10.0

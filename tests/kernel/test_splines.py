# SPDX-License-Identifier: MIT
"""Splines on the path: on their curve, with their feed, within the limits of the axes (MO-18)."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from scipy.interpolate import Akima1DInterpolator, BSpline
from support.kernel_rig import DEMO
from support.random_operator import Operator
from support.random_paths import AXES, violations
from support.random_seeds import seeds_in_parts
from support.spline_programs import splined

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

SIGNALS = [f"{name}.ACS.ACT_POS" for name in AXES]
JERK_LIMITED = "#SLOPE [TYPE=TRAPEZ]"
MAX_JERK_MM = 8e-5

VERTICES = [(0.0, 0.0), (20.0, 10.0), (35.0, -5.0), (60.0, 0.0), (70.0, 25.0), (50.0, 40.0)]


class Retracer:
    """Goes back and forward, with other overrides in between."""

    def cycle(self, hli: PlcView) -> None:
        part = hli.tick // 300
        hli.backward_motion = part < 12 and part % 3 == 2
        hli.override_pct = 40.0 if part % 4 == 1 else 100.0


def run_of(text: str, plc: object | None = None) -> Run:
    """The run of a program."""
    return Controller(DEMO).run(
        NcText("p.nc", text), signals=[*SIGNALS, "BLOCK"], ticks=400_000, plc=plc
    )


def places(run: Run) -> np.ndarray:
    """The positions of X and Y in the blocks N2."""
    assert run.errors == ()
    assert run.trace is not None
    found = np.array([run.trace[name] for name in SIGNALS[:2]]).T
    return found[np.asarray(run.trace["BLOCK"]) == 2]


def blocks(vertices: list[tuple[float, float]]) -> str:
    """Motions to the vertices."""
    return "\n".join(f"N2 X{x} Y{y}" for x, y in vertices)


def distances(found: np.ndarray, curve: np.ndarray) -> float:
    """The largest distance of positions from a curve of many points, as a polygon."""
    worst = 0.0
    for place in found[:: max(1, len(found) // 300)]:
        nearest = int(np.argmin(((curve - place) ** 2).sum(axis=1)))
        worst_here = math.inf
        for begin in (max(nearest - 1, 0), min(nearest, len(curve) - 2)):
            way = curve[begin + 1] - curve[begin]
            part = float(np.clip((place - curve[begin]) @ way / (way @ way), 0.0, 1.0))
            worst_here = min(worst_here, float(np.linalg.norm(curve[begin] + part * way - place)))
        worst = max(worst, worst_here)
    return worst


def akima(vertices: list[tuple[float, float]]) -> np.ndarray:
    """Points of Akima's curve over the length of the chords, by scipy."""
    chords = [math.dist(*pair) for pair in itertools.pairwise(vertices)]
    at = np.concatenate(([0.0], np.cumsum(chords)))
    return Akima1DInterpolator(at, np.array(vertices))(np.linspace(0.0, at[-1], 60_001))


def bspline(points: list[tuple[float, float]]) -> np.ndarray:
    """Points of the cubic B-spline with uniform knots, by scipy."""
    spans = len(points) - 3
    knots = [0, 0, 0, *range(spans + 1), spans, spans, spans]
    return BSpline(knots, np.array(points), 3)(np.linspace(0.0, spans, 60_001))


@pytest.mark.nightly
@pytest.mark.parametrize("slope", ["#SLOPE [TYPE=STEP]", JERK_LIMITED])
@pytest.mark.parametrize("kind", ["AKIMA", "BSPLINE"])
def test_the_path_is_on_the_curve(kind: str, slope: str) -> None:
    """Pages 207198603, 207263627: through the vertices, or from the first to the last point."""
    text = f"{slope}\n#SPLINE TYPE {kind}\nG01 F6000\nG151\n{blocks(VERTICES[1:])}\nG150\nM30"
    found = places(run_of(text))
    curve = akima(VERTICES) if kind == "AKIMA" else bspline(VERTICES)
    assert distances(found, curve) < 1e-6
    assert found[-1] == pytest.approx(VERTICES[-1])


def test_the_feed_is_that_of_the_path() -> None:
    """F is the speed along the curve, within a part of 10^-4 (MO-18)."""
    text = f"G01 F3000\nG151\n{blocks(VERTICES[1:])}\nG150\nM30"
    found = places(run_of(text))
    speeds = np.linalg.norm(np.diff(found, axis=0), axis=1) / 0.001
    assert np.abs(speeds[30:-30] / 50.0 - 1.0).max() < 2e-4


def test_g93_is_the_time_of_a_block() -> None:
    """The curve of each block takes its time."""
    text = f"G93 F2 G01\nG151\n{blocks(VERTICES[1:])}\nG150\nM30"
    assert len(places(run_of(text))) == pytest.approx(10_000, abs=50)


def test_tangential_ends_fit_lines_and_arcs() -> None:
    """Page 207222923: the path does not slow down where it enters and leaves the curve."""
    text = (
        "G01 F3000 X20\n#AKIMA TRANS [START=TANGENTIAL END=TANGENTIAL]\nG151\n"
        "N2 X40 Y10\nN2 X60\nN2 X80 Y0\nG150\nG02 X90 Y-10 I0 J-10\nM30"
    )
    run = run_of(text)
    assert run.trace is not None
    found = np.array([run.trace[name] for name in SIGNALS[:2]]).T
    speeds = np.linalg.norm(np.diff(found, axis=0), axis=1) / 0.001
    assert speeds[30:-30].min() > 49.9


def test_an_akima_spline_pauses_at_arcs() -> None:
    """hsc/15427927179: the curve fits the arc at both ends, the arc is one."""
    text = (
        "#AKIMA TRANS [START=TANGENTIAL]\nG01 F3000 X10\nG151\nX30 Y10\nX50 Y0\n"
        "N2 G03 X70 Y20 I0 J20\nG01 X60 Y40\nX30 Y60\nX10 Y50\nG150\nM30"
    )
    run = run_of(text)
    found = places(run)
    assert np.abs(np.hypot(found[:, 0] - 50.0, found[:, 1] - 20.0) - 20.0).max() < 1e-9
    assert run.trace is not None
    every = np.array([run.trace[name] for name in SIGNALS[:2]]).T
    assert np.linalg.norm(np.diff(every, axis=0), axis=1)[30:-30].min() > 0.0499


def test_a_given_start() -> None:
    """Page 1255466635: the curve begins with the slope 1, and by #SPLINE in the block, too."""
    head = "G01 X20 Y0 F1000\n#AKIMA TRANS[START=USER END=AUTO]\n# AKIMA STARTVECTOR X1 Y1 Z0\n"
    rest = "X60\nY0\nX80\nY10\n"
    one = run_of(f"{head}G151\nN2 G01 X40 Y20\n{rest}G150\nX70\nM30")
    other = run_of(f"{head}N2 #SPLINE ON X40 Y20\n{rest}#SPLINE OFF X70\nM30")
    found = places(one)
    assert (places(other) == found).all()
    way = found[40] - found[20]
    assert way[1] / way[0] == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize("slope", ["", JERK_LIMITED])
@pytest.mark.parametrize("orders", ["", "single override hold"])
@seeds_in_parts(4, 2, 2)
def test_the_axes_keep_their_limits(seeds: range, orders: str, slope: str) -> None:
    """Speed, acceleration and jerk of each axis, whatever the operator does (MO-1)."""
    for seed in seeds:
        run = run_of(splined(seed, slope), Operator(seed, orders) if orders else None)
        assert run.state == "ended", (seed, run.diagnostics)
        assert run.trace is not None
        for name, signal in zip(AXES, SIGNALS, strict=True):
            jerk = MAX_JERK_MM if slope else 0.0
            assert violations(run.trace[signal], name, jerk) == [], seed


@pytest.mark.parametrize("slope", ["", JERK_LIMITED])
def test_the_way_back_is_the_same_curve(slope: str) -> None:
    """MO-7: backward and forward, with the same end."""
    text = f"{slope}\nG01 F3000\nG151\n{blocks(VERTICES[1:])}\nG150\nM30"
    found = places(run_of(text, Retracer()))
    assert distances(found, akima(VERTICES)) < 1e-6
    assert (found[-1] == places(run_of(text))[-1]).all()


def test_a_realtime_loop_repeats_a_spline() -> None:
    """Page 791740171: #SPLINE ON and OFF may be in a loop."""
    body = "#SPLINE ON X10\nX20 Y10\nX10 Y20\nX0 Y10\nX0 Y0\n#SPLINE OFF\n"
    cycle = (
        "V.RTG.LOOP.ENABLED = TRUE\n#RT CYCLE [ID=1]\n$IF V.RTG.LOOP.COUNT >= 2\n"
        "V.RTG.LOOP.ENABLED = FALSE\n$ENDIF\n#RT CYCLE END\n"
    )
    run = run_of(f"{cycle}G01 F6000\n#RT WHILE\n{body}#RT ENDWHILE\nX30\nM30")
    assert run.errors == ()
    assert run.trace is not None
    x = np.asarray(run.trace[SIGNALS[0]])
    peaks = np.flatnonzero((x[1:-1] > 19.99) & (x[1:-1] >= x[:-2]) & (x[1:-1] > x[2:]))
    assert len(peaks) == 3

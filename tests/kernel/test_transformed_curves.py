# SPDX-License-Identifier: MIT
"""Curves over corners under a transformation (MO-3): within the deviation, limits and time.

``docs/conformance/transformations.md`` says where a corner gets a curve.
``NCTAKT_SEEDS=1000`` makes as many programs.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from support.five_axis_limits import broken_limits, positions, run_of
from support.five_axis_programs import NAMES, FiveAxisProgram, five_axis_program, tips
from support.random_seeds import seeds_in_parts

from nctakt.results.run import Run

#: How much longer a program with curves may take: at the limit of what gets a curve they cost some.
SLOWER = 1.5


def contoured(program: FiveAxisProgram, mode: str) -> FiveAxisProgram:
    """The program with a contour mode."""
    return replace(program, text=f"#CONTOUR MODE [{mode}]\nG261\n{program.text}")


def off_the_polygon(program: FiveAxisProgram, places: np.ndarray, run: Run) -> np.ndarray:
    """How far the tip is from the nearest line in each tick after the first block."""
    assert run.trace is not None
    ticks = np.asarray(run.trace["BLOCK"]).astype(int) > min(program.ways)
    at = tips(places[ticks], program.kinematic)
    off = np.full(len(at), np.inf)
    for start, end in program.ways.values():
        way = (end - start)[:3]
        length2 = way @ way
        part = np.clip((at - start[:3]) @ way / length2, 0.0, 1.0) if length2 else 0.0
        nearest = start[:3] + np.multiply.outer(part, way)
        off = np.minimum(off, np.linalg.norm(at - nearest, axis=1))
    return off


def polygon(corners: int, slope: str, *, is_turning: bool = False) -> FiveAxisProgram:
    """A regular polygon about the zero with a radius of 30 mm, and the tool at 20°."""
    angles = [2 * math.pi * number / corners for number in range(corners + 1)]
    turn = 360.0 if is_turning else 0.0
    points = [
        np.array([30 * math.cos(one), 30 * math.sin(one), 0.0, turn * one / 2 / math.pi, 20.0])
        for one in angles
    ]
    points = [np.round(point, 4) for point in points]
    lines = [f"#SLOPE [TYPE={slope}]", "#TRAFO [1]", "F6000 G01"]
    for number, point in enumerate(points, 9):
        words = " ".join(f"{name}{value:.4f}" for name, value in zip(NAMES, point, strict=True))
        lines.append(f"N{number} {words}")
    ways = {n: (a, b) for n, (a, b) in enumerate(pairwise(points), 10)}
    return FiveAxisProgram("\n".join([*lines, "M30", ""]), 1, ways, slope == "TRAPEZ")


@pytest.mark.nightly
@seeds_in_parts(compiled=20, plain=0, part=10)
def test_curves_keep_deviation_limits_and_time(seeds: range) -> None:
    """Of random programs with lines and turns of all sizes."""
    for seed in seeds:
        program = five_axis_program(seed)
        exact = run_of(program)
        run = run_of(contoured(program, "DEV PATH_DEV=0.3"))
        assert not run.errors, (seed, [str(one) for one in run.errors])
        places = positions(run)
        found = broken_limits(places, program.has_jerk_limit)
        off = off_the_polygon(program, places, run).max()
        assert (found, off <= 0.3 + 1e-6) == ([], True), (seed, found, off)
        assert run.ticks <= SLOWER * exact.ticks, (seed, run.ticks, exact.ticks)
        target = list(program.ways.values())[-1][1]
        assert tips(places[-1:], program.kinematic)[0] == pytest.approx(target[:3], abs=1e-6)


@pytest.mark.parametrize("slope", ["STEP", "TRAPEZ"])
def test_the_curve_is_as_far_from_the_corner_as_it_may(slope: str) -> None:
    """Its interim point is PATH_DEV away; with DIST_SOFT a sixth of PATH_DIST times the turn."""
    program = polygon(30, slope)
    turn = 2 * math.sin(math.pi / 30)
    for mode, expected in (
        ("DEV PATH_DEV=0.05", 0.05),
        ("DIST_SOFT PATH_DIST=2", 2 * turn / 6),
        ("DEV PATH_DEV=1", 0.499 * 60 * math.sin(math.pi / 30) * turn / 6),
    ):
        run = run_of(contoured(program, mode))
        assert run.errors == ()
        places = positions(run)
        assert broken_limits(places, program.has_jerk_limit) == []
        off = off_the_polygon(program, places, run)
        assert off.max() == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize(("slope", "corners"), [("STEP", 5), ("TRAPEZ", 12)])
def test_sharp_corners_are_passed_exactly(slope: str, corners: int) -> None:
    """A curve of 1 mm is slower there than a standstill; a mode with its own shape has it."""
    program = polygon(corners, slope)
    exact = run_of(program)
    run = run_of(contoured(program, "DEV PATH_DEV=1"))
    assert (run.errors, run.ticks) == ((), exact.ticks)
    assert off_the_polygon(program, positions(run), run).max() < 1e-6
    run = run_of(contoured(program, "DIST PRE_DIST=1 POST_DIST=2"))
    assert off_the_polygon(program, positions(run), run).max() > 0.05


def test_small_turns_are_faster() -> None:
    """The polygon of an arc, with the tool turning along: no standstill between its lines."""
    for slope in ("STEP", "TRAPEZ"):
        program = polygon(90, slope, is_turning=True)
        exact, run = run_of(program), run_of(contoured(program, "DEV PATH_DEV=0.05"))
        assert run.errors == ()
        assert broken_limits(positions(run), program.has_jerk_limit) == []
        assert run.ticks < 0.8 * exact.ticks

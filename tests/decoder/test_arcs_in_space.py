# SPDX-License-Identifier: MIT
"""Arcs in space by three points (G303); public manuals: page 206116363, ID 22081."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from support.decided import numbers, perform
from support.random_seeds import seeds_in_parts

from nctakt.results.run import Run

SIGNALS = [*(f"{axis}.ACS.ACT_POS" for axis in "XYZ"), "BLOCK"]


def run_of(*lines: str) -> Run:
    """A run of these lines."""
    return perform("\n".join([*lines, "M30"]), signals=SIGNALS)


def axes(run: Run, block: int | None = None) -> np.ndarray:
    """X, Y, Z after each tick, or after those of a block."""
    assert run.trace is not None
    found = np.array([run.trace[name] for name in SIGNALS[:3]]).T
    return found if block is None else found[np.asarray(run.trace["BLOCK"]) == block]


def circle(*points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The centre of the circle through three points, from the planes between them."""
    one, two, three = points
    normal = np.cross(two - one, three - one)
    left = np.array([two - one, three - one, normal])
    right = [0.5 * (two @ two - one @ one), 0.5 * (three @ three - one @ one), normal @ one]
    return np.linalg.solve(left, right), normal / np.linalg.norm(normal)


def check(way: np.ndarray, points: list[np.ndarray], tolerance: float = 1.1e-6) -> None:
    """The way is on the circle, goes by the interim point and in its direction."""
    centre, normal = circle(*points)
    radius = np.linalg.norm(points[0] - centre)
    assert np.abs(np.linalg.norm(way - centre, axis=1) - radius).max() < tolerance
    assert np.abs((way - centre) @ normal).max() < tolerance
    steps = np.linalg.norm(np.diff(way, axis=0), axis=1).max()
    assert np.linalg.norm(way - points[1], axis=1).min() <= steps
    ahead = np.cross(way[:-1] - centre, way[1:] - centre) @ normal
    assert ahead[np.abs(ahead) > 1e-9].min() > 0.0


def test_the_example_of_the_public_manual() -> None:
    """From (0, 0, 30) by way of (30, 75, 15) to (60, 0, 0)."""
    run = run_of("G17 G90 G01 F2000 X0 Y0 Z0", "G01 X0 Y0 Z30", "N30 G303 I30 J75 K15 X60 Y0 Z0")
    assert numbers(run) == []
    points = [np.array(one, float) for one in ((0, 0, 30), (30, 75, 15), (60, 0, 0))]
    check(axes(run, 30)[:-1], points)
    assert axes(run)[-1] == pytest.approx([60.0, 0.0, 0.0], abs=1e-12)


@seeds_in_parts(compiled=40, plain=2, part=20)
def test_any_three_points(seeds: range) -> None:
    """In systems, mirrored, scaled, in inches, absolute and relative: the points are those of
    straight lines to them."""
    for seed in seeds:
        dice = random.Random(f"arc in space {seed}")
        size = dice.choice((0.5, 20.0))
        points = [np.round([dice.gauss(0.0, size) for _ in range(3)], 4) for _ in range(3)]
        head = [f"#SLOPE [TYPE={dice.choice(('STEP', 'TRAPEZ'))}]"]
        if dice.random() < 0.5:
            values = [round(dice.uniform(-90.0, 90.0), 3) for _ in range(6)]
            head.append(f"#CS ON {values}")
        if dice.random() < 0.3:
            head.append("G54")
        if dice.random() < 0.3:
            head.append(
                dice.choice(("G21", "G22", "G68 R30", "#SCALE ON X2 Y2 Z2", "#SCALE ON Y3"))
            )
        if dice.random() < 0.2:
            head.append("G70")
        words = [
            " ".join(f"{name}{value:.4f}" for name, value in zip("XYZ", point, strict=True))
            for point in points
        ]
        lines = run_of(
            *head, "G360", f"N10 G01 {words[0]} F5000", f"N20 {words[1]}", f"N30 {words[2]}"
        )
        assert lines.errors == (), (seed, [str(one) for one in lines.errors])
        ends = [axes(lines, block)[-1] for block in (10, 20)] + [axes(lines)[-1]]
        start = f"N10 G360 G01 {words[0]} F5000"
        if dice.random() < 0.5:
            interim, target = words[1], words[2]
        else:
            start += "\nG91"
            interim, target = (
                " ".join(f"{n}{v:.4f}" for n, v in zip("XYZ", one - points[0], strict=True))
                for one in points[1:]
            )
        for name, other in zip("XYZ", "IJK", strict=True):
            interim = interim.replace(name, other)
        run = run_of(*head, start, f"N30 G303 {interim} {target}")
        assert run.errors == (), (seed, [str(one) for one in run.errors])
        assert axes(run)[-1] == pytest.approx(ends[2], abs=1e-9), seed
        way = axes(run, 30)[:-1]
        exact = [axes(run, 10)[-1], ends[1], ends[2]]
        if math.dist(exact[0], ends[0]) < 1e-9:
            centre, _ = circle(*exact)
            check(way, exact, 1.2e-6 + 1e-9 * float(np.linalg.norm(exact[0] - centre)))


def test_it_is_modal() -> None:
    """The next block is an arc as well; a coordinate that is not named stays."""
    run = run_of("G01 X0 Y0 F6000", "N10 G303 I10 J10 X20 Y0", "N20 I30 J-10 X40 Y0", "G01 X50")
    assert numbers(run) == []
    check(
        axes(run, 20)[1:-1],
        [np.array(one, float) for one in ((20, 0, 0), (30, -10, 0), (40, 0, 0))],
    )


def test_a_cycle_and_other_axes_move_along() -> None:
    """Another axis goes evenly with the angle."""
    run = perform(
        "G01 X0 Y0 A0 F6000\nN10 G303 I10 J10 X20 Y0 A90\nM30", signals=[*SIGNALS, "A.ACS.ACT_POS"]
    )
    assert numbers(run) == []
    assert run.trace is not None
    ticks = np.flatnonzero(np.asarray(run.trace["BLOCK"]) == 10)[1:-1]
    way = axes(run)[ticks] - (10.0, 0.0, 0.0)
    angle = np.degrees(np.pi - np.arctan2(way[:, 1], way[:, 0]))
    assert np.asarray(run.trace["A.ACS.ACT_POS"])[ticks] == pytest.approx(angle / 2.0, abs=1e-5)


@pytest.mark.parametrize(
    ("lines", "number"),
    [
        ("G303 X20 I10 F100", 901892),  # on a line
        ("G303 X20 I20 F100", 901892),  # the interim point is the target
        ("G303 X20 F100", 901892),  # no interim point
        ("G303 I10 J10 F100", 901892),  # a full circle
        ("D1 G41 G01 X10 F100\nX20\nG303 I30 J10 X40", 22081),
        ("G303 I30000 J30000 X20 F100", 120003),
        ("G100 G303 X10 F100", 900210),
    ],
)
def test_mistakes(lines: str, number: int) -> None:
    """Each with its own diagnostic."""
    found = numbers(perform(f"G01 X0 Y0 F1000\n{lines}\nM30"))
    assert found[:1] == [number]

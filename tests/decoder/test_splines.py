# SPDX-License-Identifier: MIT
"""Splines of programs: their curves against scipy, and their mistakes (MO-18)."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import Akima1DInterpolator, BSpline

from nctakt.decoder.shapes.splines import AkimaCurve, BsplineCurve
from nctakt.decoder.state.geometry import cubics
from nctakt.run.controller import Controller, NcText

NUMBER = st.floats(-500, 500)
POINTS = st.lists(st.tuples(NUMBER, NUMBER, NUMBER), min_size=4, max_size=9).filter(
    lambda points: all(math.dist(a, b) > 0.1 for a, b in pairwise(points))
)
PARTS = (0.0, 0.2, 0.5, 0.9, 1.0)


@given(POINTS)
def test_akima_is_that_of_scipy(points: list[tuple[float, ...]]) -> None:
    """Each axis over the length of the chords."""
    curve = AkimaCurve(points[0])
    at = [0.0]
    for before, point in pairwise(points):
        curve.add(point, math.dist(before, point))
        at.append(at[-1] + math.dist(before, point))
    reference = Akima1DInterpolator(at, np.array(points))
    for number, (begin, end) in enumerate(pairwise(at)):
        piece = curve.piece(number)
        for part in PARTS:
            want = reference(begin + (end - begin) * part)
            assert cubics.point(piece, part) == pytest.approx(want, abs=1e-6)


@given(POINTS)
def test_bsplines_are_those_of_scipy(points: list[tuple[float, ...]]) -> None:
    """Cubic, uniform knots, from the first to the last point; blocks between Greville's means."""
    curve = BsplineCurve(points[0])
    for point in points[1:]:
        curve.add(point)
    spans = len(points) - 3
    knots = [0, 0, 0, *range(spans + 1), spans, spans, spans]
    reference = BSpline(knots, np.array(points), 3)
    means = [sum(knots[n + 1 : n + 4]) / 3 for n in range(len(points))]
    for number, (begin, end) in enumerate(pairwise(means)):
        piece = curve.piece(number)
        for part in PARTS:
            want = reference(begin + (end - begin) * part)
            assert cubics.point(piece, part) == pytest.approx(want, abs=1e-9)


@pytest.mark.nightly
@given(POINTS)
def test_pieces_lie_on_the_cubic_that_they_divide(points: list[tuple[float, ...]]) -> None:
    """They follow each other, and their lengths add up."""
    cubic = (points[0], points[1], points[2], points[3])
    parts = list(cubics.divided(cubic, (0, 1, 2)))
    assert parts[0][0] == cubic[0]
    assert parts[-1][3] == cubic[3]
    assert all(before[3] == behind[0] for before, behind in pairwise(parts))
    lengths = sum(cubics.length_of(part, (0, 1, 2)) for part in parts)
    dense = np.array([cubics.point(cubic, number / 4000) for number in range(4001)])
    assert lengths == pytest.approx(np.linalg.norm(np.diff(dense, axis=0), axis=1).sum(), rel=1e-5)
    for axis in range(3):
        low, high = cubics.extremes(cubic, axis)
        assert low == pytest.approx(dense[:, axis].min(), abs=1e-2)
        assert high == pytest.approx(dense[:, axis].max(), abs=1e-2)


MOTIONS = "X10 Y5\nX20\nX30 Y9\nX40\n"


@pytest.mark.parametrize(
    ("text", "number"),
    [
        (f"#AKIMA TRANS [START=TANGENTIAL]\nG151\n{MOTIONS}G150\n", 120112),
        (f"X1\n#SPLINE TYPE AKIMA\n#AKIMA TRANS [START=TANGENTIAL]\nG151\n{MOTIONS}", 120112),
        (f"#AKIMA TRANS [END=TANGENTIAL]\nG151\n{MOTIONS}G150\nM30\n", 901620),
        ("G151\nX10\nG150\n", 901621),
        ("#SPLINE TYPE BSPLINE\nG151\nX10\nY10\nG150\n", 901621),
        (f"G151\n{MOTIONS}Z10\nG150\nX50\n", None),
        (f"G151\n{MOTIONS}A10\nX60\nG150\n", 120180),
        (f"#SPLINE TYPE BSPLINE\nG151\n{MOTIONS}G02 X60 R20\nG150\n", 120254),
        (f"G261\nG151\n{MOTIONS}G150\n", 120255),
        (f"G151\nG261\n{MOTIONS}G150\n", 120255),
        (f"#SET ASPLINE MODE [4, 1]\nG151\n{MOTIONS}G150\n", 120097),
        (f"P1=0\n#SET ASPLINE MODE [1, P1]\nG151\n{MOTIONS}G150\n", 120097),
        ("#AKIMA ENDVECTOR X1 Y1\n", 120100),
        ("#AKIMA STARTVECTOR X0 Y0 Z0\n", 120100),
        ("P1=0\n#AKIMA STARTVECTOR X=P1 Y=P1 Z=P1\n", 120100),
        (f"G41 D1 X5\nG151\n{MOTIONS}G150\n", 901622),
        (f"G151\n{MOTIONS}G41 D1 X50\nG150\n", 901622),
        (f"G151\n{MOTIONS}#FLUSH WAIT\nX60\nG150\n", 20651),
        (f"G151\n{MOTIONS}G301 I1\nX60\nG150\n", 901624),
        ("G151\nX9000 Y-1000\nX9999 Y0\nX9998 Y4000\nX3000\nG150\n", 901623),
        (f"G151\n{MOTIONS}#RT WHILE\nX5\nX40\n#RT ENDWHILE\n", 22128),
        (f"#RT WHILE\n#SPLINE ON\n{MOTIONS}X0 Y0\n#RT ENDWHILE\n", 22129),
        ("#AKIMA TRANS [START=AUT]\n", 900233),
        ("#SPLINE TYPE CUBIC\n", 900233),
    ],
)
def test_mistakes(text: str, number: int | None) -> None:
    """Each mistake has the controller's number, if it has one."""
    done = Controller().run(NcText("p.nc", "G01 F6000\n" + text), ticks=40_000)
    assert [found.id for found in done.errors][:1] == ([] if number is None else [number])


def test_the_form_of_the_curve_is_reported_once() -> None:
    """Notes 901551: no source settles the curves."""
    text = f"G01 F6000\nG151\n{MOTIONS}G150\n#SPLINE TYPE BSPLINE\n#SPLINE ON\n{MOTIONS}G150\nM30"
    done = Controller().run(NcText("p.nc", text))
    assert [found.id for found in done.diagnostics if found.id == 901551] == [901551, 901551]

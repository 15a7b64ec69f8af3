# SPDX-License-Identifier: MIT
"""Curves of ``#CONTOUR MODE`` with two halves: POS, unequal distances, actions (language 2.1)."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from support.kernel_rig import DEMO
from support.random_operator import Operator
from support.random_paths import AXES, violations
from support.random_seeds import each_seed

from nctakt.decoder.shapes import contour_curve
from nctakt.decoder.shapes.contour_curve import End
from nctakt.decoder.state.geometry import cubics
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

SIGNALS = [f"{name}.ACS.ACT_POS" for name in AXES]
MAX_JERK_MM = 8e-5
LINES = "G01 X50 F6000\nY50\nM30"


def run_of(text: str, plc: object | None = None) -> Run:
    """The run of a program."""
    return Controller(DEMO).run(NcText("p.nc", text), signals=SIGNALS, ticks=200_000, plc=plc)


def performed(text: str, plc: object | None = None) -> tuple[Run, np.ndarray]:
    """A run within the limits of the axes, and where they were."""
    run = run_of(text, plc)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    jerk = MAX_JERK_MM if "TRAPEZ" in text else 0.0
    for name, signal in zip(AXES, SIGNALS, strict=True):
        assert violations(run.trace[signal], name, jerk) == [], text
    return run, np.array([np.asarray(run.trace[signal]) for signal in SIGNALS]).T


def curve_of(begin: End, end: End, middle: tuple[float, ...]) -> np.ndarray:
    """Points of a curve in the plane with halves of 4 and 7 mm."""
    pieces = [
        piece
        for half in contour_curve.curve(begin, end, (4.0, 7.0), middle, [0, 1])
        for piece in half
    ]
    return np.array([[cubics.point(piece, k / 400) for k in range(401)] for piece in pieces])


def test_a_curve_has_direction_and_curvature_of_both_motions() -> None:
    """475073291: continuous in both at its ends and at the interim point, which it goes through."""
    begin = End((0.0, 0.0), (1.0, 0.0), (0.0, 0.05))
    end = End((9.0, 5.0), (0.0, 1.0), (-0.1, 0.0))
    middle = (6.0, 1.0)
    pieces = curve_of(begin, end, middle)
    assert pieces[0, 0].tolist() == [0.0, 0.0]
    assert pieces[1, -1] == pytest.approx(middle)
    assert pieces[-1, -1].tolist() == [9.0, 5.0]
    steps = np.repeat([2.0 / 400, 0.5 * max(7.0, math.dist(middle, end.position)) / 400], 2)
    steps[:2] = 0.5 * max(4.0, math.dist(middle, begin.position)) / 400
    first = np.gradient(pieces, axis=1, edge_order=2) / steps[:, None, None]
    second = np.gradient(first, axis=1, edge_order=2) / steps[:, None, None]
    for derivative, at_begin, at_end in ((first, begin[1], end[1]), (second, begin[2], end[2])):
        assert derivative[0, 0] == pytest.approx(at_begin, abs=2e-3)
        assert derivative[-1, -1] == pytest.approx(at_end, abs=2e-3)
        for before, behind in ((0, 1), (1, 2), (2, 3)):
            assert derivative[before, -1] == pytest.approx(derivative[behind, 0], abs=2e-3)


@pytest.mark.parametrize("slope", ["STEP", "TRAPEZ"])
@pytest.mark.parametrize(
    ("mode", "begin", "end", "through"),
    [
        ("DIST PRE_DIST=10 POST_DIST=4", 10.0, 4.0, (50 - 40 / 42, 40 / 42)),
        ("DIST, PRE_DIST 4, POST_DIST 10", 4.0, 10.0, (50 - 40 / 42, 40 / 42)),
        ("DIST PRE_DIST=90 POST_DIST=4", 24.95, 4.0, None),
        ("DIST PRE_DIST=90 POST_DIST=4 REMAIN_PART=20", 20.0, 4.0, None),
        ("POS PRE_DIST=10 POST_DIST=4 X47 Y2", 10.0, 4.0, (47.0, 2.0)),
        ("POS PRE_DIST=6 POST_DIST=6 X48.5 Y1.5 Z0", 6.0, 6.0, (48.5, 1.5)),
    ],
)
def test_halves_begin_and_end_at_their_distances(
    mode: str, begin: float, end: float, through: tuple[float, float] | None, slope: str
) -> None:
    """475180811, 475227019: unequal distances are limited singly; the point is met."""
    found = performed(f"#SLOPE [TYPE={slope}]\n#CONTOUR MODE [{mode}]\nG261\n{LINES}")[1][:, :2]
    is_between = (np.abs(found[:, 1]) > 1e-9) & (np.abs(found[:, 0] - 50.0) > 1e-9)
    assert 50.0 - found[is_between, 0].min() == pytest.approx(begin, abs=0.15)
    assert found[is_between, 1].max() == pytest.approx(end, abs=0.15)
    if through is not None:
        assert np.linalg.norm(found - through, axis=1).min() < 0.06


def test_a_distance_of_0_goes_to_the_corner() -> None:
    """475227019: the programmed contour is kept, and the curve lies beyond it."""
    mode = "#CONTOUR MODE [POS PRE_DIST=0 POST_DIST=0 X55 Y-5]"
    found = performed(f"{mode}\nG261\n{LINES}")[1][:, :2]
    assert np.linalg.norm(found - (55.0, -5.0), axis=1).min() < 0.06
    assert np.linalg.norm(found - (50.0, 0.0), axis=1).min() < 0.06
    assert found[:, 0].max() > 55.0


@pytest.mark.parametrize("slope", ["STEP", "TRAPEZ"])
def test_lines_and_arcs_are_joined_at_distances(slope: str) -> None:
    """475073291: between lines and arcs; on an arc the distance is that along it, up to 90°."""
    arcs = "G01 X30 F3000\nG03 X50 Y20 I20 J0\nG02 X70 Y40 I20\nG01 X90\nM30"
    mode = "#CONTOUR MODE [DIST PRE_DIST=3 POST_DIST=5]"
    found = performed(f"#SLOPE [TYPE={slope}]\n{mode}\nG261\n{arcs}")[1]
    assert np.linalg.norm(found[:, :2] - (30.0, 0.0), axis=1).min() > 0.3
    assert found[-1, :2].tolist() == [90.0, 40.0]


@pytest.mark.parametrize(
    "lines", ["X20\nG03 X40 Y0 R25\nG01 Y40", "G03 X20 Y10 R40\nG02 X50 Y0 R30"]
)
def test_corners_with_arcs_are_rounded_within_the_deviation(lines: str) -> None:
    """475073291: lines and arcs; with a limit of the jerk such corners are kept."""
    begin = "G01 F3000 Y-20\n"
    sharp = performed(f"{begin}{lines}\nG01 X0\nM30")[1][:, :2]
    found = performed(f"#CONTOUR MODE [DEV PATH_DEV=0.5]\nG261\n{begin}{lines}\nG01 X0\nM30")[1][
        :, :2
    ]
    assert len(found) < len(sharp)
    off = [np.linalg.norm(sharp - position, axis=1).min() for position in found[::5]]
    assert 0.3 < max(off) < 0.52
    jerk = "#SLOPE [TYPE=TRAPEZ]\n"
    kept = performed(f"{jerk}{begin}G03 X20 Y10 R40\nG02 X50 Y0 R30\nM30")[1]
    assert np.array_equal(
        performed(f"{jerk}G261\n{begin}G03 X20 Y10 R40\nG02 X50 Y0 R30\nM30")[1], kept
    )


def test_arcs_after_plain_lines_have_the_same_curves() -> None:
    """The fast way of plain lines leaves the line before an arc to the tree."""
    lines = "G01 F6000 X10\nX20 Y5\nX30\nG2 X40 Y-10 R10\nG01 X50\nX60\nG03 X60 Y30 R20\nM30"
    slow = lines.replace("\nX", " ; P1\nX=").replace(" ; P1\nX=20", "\nX=20")
    fast = performed(f"#CONTOUR MODE [DEV PATH_DEV=1]\nG261\n{lines}")[1]
    assert np.array_equal(fast, performed(f"#CONTOUR MODE [DEV PATH_DEV=1]\nG261\n{slow}")[1])


@pytest.mark.parametrize(
    ("before", "point"),
    [
        ("", "X48 Y2"),
        ("G92 X-100 Y20", "X148 Y-18"),
        ("G70", f"X{48 / 25.4:.6f} Y{2 / 25.4:.6f}"),
        ("#ROTATION ON [ANGLE=90]", "X2 Y-48"),
        ("P1 = 2", "X=50-P1 Y=P1"),
    ],
)
def test_the_interim_point_is_one_of_the_program(before: str, point: str) -> None:
    """It has the offsets, unit and rotation that hold at the command."""
    text = f"{before}\n#CONTOUR MODE [POS PRE_DIST=1 POST_DIST=2 {point}]"
    text += "\nG71 G261\nG91 G01 " + ("Y-50" if "ROT" in before else "X50")
    text += " F3000\n" + ("X50" if "ROT" in before else "Y50") + "\nM30"
    found = performed(text)[1][:, :2]
    assert np.linalg.norm(found - (48.0, 2.0), axis=1).min() < 0.03


def test_a_curve_stays_within_the_limits() -> None:
    """901873: the interim point may lie where an axis must not go."""
    run = run_of(f"#CONTOUR MODE [POS PRE_DIST=1 POST_DIST=2 X50 Y-9999]\nG261\n{LINES}")
    assert [error.id for error in run.errors] == [901873]


@pytest.mark.parametrize("slope", ["STEP", "TRAPEZ"])
@pytest.mark.parametrize(
    ("action", "at"),
    [("PRE_ACTION", (45.757, 0.0)), ("", (49.293, 0.707)), ("POST_ACTION", (50.0, 4.243))],
)
@pytest.mark.parametrize("lines", ["X50\nM100\n", "X50\nM100 G61\n", "X50\n\nN5 M100 (x)\n"])
def test_functions_act_where_the_action_says(
    action: str, at: tuple[float, float], slope: str, lines: str
) -> None:
    """475113099: before the curve, between its halves (default), after it.

    What comes after it leaves the corner to the realtime part, whose parabola is shorter.
    """
    if (action, slope) == ("POST_ACTION", "STEP"):
        at = (50.0, 4.0 / math.sqrt(2.0))
    mode = f"#SLOPE [TYPE={slope}]\n#CONTOUR MODE [DEV PATH_DEV=1 {action}]\nG261\nG01 F6000\n"
    run, found = performed(f"{mode}{lines}Y50\nM30")
    (tick,) = [event.tick for event in run.events if event.kind == "output"]
    off = np.linalg.norm(found[tick - 2 : tick + 1, :2] - at, axis=1)
    assert off.min() < 0.12
    assert np.linalg.norm(found[:, :2] - (50.0, 0.0), axis=1).min() == pytest.approx(1.0, abs=1e-3)


def test_plain_blocks_and_others_have_the_same_curves() -> None:
    """The fast way of plain lines leaves the motion before a function to the tree."""
    lines = "G01 F6000 X10\nX20 Y5\nX30\nM100\nY50\nX10\nH100\nX0 Y0\nM30"
    slow = lines.replace("\n", " ; P1\n").replace("X10 ", "X=10 ").replace("Y50", "Y=50")
    fast = performed(f"#CONTOUR MODE [DEV PATH_DEV=1]\nG261\n{lines}")[1]
    assert np.array_equal(fast, performed(f"#CONTOUR MODE [DEV PATH_DEV=1]\nG261\n{slow}")[1])


@pytest.mark.parametrize(
    ("action", "at"),
    [("PRE_ACTION", (45.757, 0.0)), ("", (49.293, 0.707)), ("POST_ACTION", (50.0, 4.243))],
)
def test_a_function_that_waits_stops_the_path_on_the_curve(
    action: str, at: tuple[float, float]
) -> None:
    """475259787: without an acknowledgement the path is at the place of the action."""

    class Late:
        def cycle(self, hli: PlcView) -> None:
            if hli.tick > 2000:
                hli.acknowledge_all()

    text = f"#CONTOUR MODE [DEV PATH_DEV=1 {action}]\nG261\nG01 X50 F6000\nM6\nY50\nM30"
    run, found = performed(text, Late())
    assert run.ticks > 2000
    assert found[1900, :2] == pytest.approx(at, abs=1e-3)


def test_functions_under_compensation_act_on_the_curve_of_the_tool() -> None:
    """The curve comes after the compensation of the radius: the corner is that of the tool."""
    tool = "V.G.WZ_AKT.R = 5\n#CONTOUR MODE [DEV PATH_DEV=1]\nG261\nG41 G01 X50 Y50 F6000\n"
    run, found = performed(f"{tool}X150\nM100\nY150\nX100\nG40 X0 Y0\nM30")
    (tick,) = [event.tick for event in run.events if event.kind == "output"]
    corner = np.array([145.0, 55.0])
    off = np.linalg.norm(found[:, :2] - corner, axis=1)
    assert off.min() == pytest.approx(1.0, abs=0.01)
    assert abs(int(off.argmin()) - tick) <= 2


def contoured(seed: int) -> str:
    """A random program of lines and arcs with curves over its corners."""
    chance = random.Random(seed)
    lines = [f"#SLOPE [TYPE={chance.choice(('STEP', 'TRAPEZ'))}]", "G91 G261 G01 F6000"]
    size = chance.choice((0.3, 3.0, 20.0))
    heading = 0.0
    for _ in range(chance.randint(8, 16)):
        if chance.random() < 0.4:
            mode = chance.choice(("DIST", "POS", "DEV", "DIST"))
            words = [f"{name}={size * chance.uniform(0.05, 1):.4f}" for name in ("PRE_DIST",)]
            if mode != "DEV":
                words.append(f"POST_DIST={size * chance.uniform(0.05, 1):.4f}")
            else:
                words = [f"PATH_DEV={size * chance.uniform(0.01, 0.3):.4f}"]
            action = chance.choice(("PRE_ACTION", "INTER_ACTION", "POST_ACTION"))
            lines.append(f"#CONTOUR MODE [{mode} {' '.join(words)} {action}]")
        heading += chance.gauss(0.0, 1.0)
        length = size * chance.uniform(0.4, 2.0)
        x, y = length * math.cos(heading), length * math.sin(heading)
        if chance.random() < 0.3:
            lines.append(f"G0{chance.choice('23')} X{x:.4f} Y{y:.4f} R{length * 0.8:.4f}")
        else:
            rest = f" Z{chance.uniform(-1, 1) * size:.4f}" if chance.random() < 0.2 else ""
            rest += f" A{chance.uniform(-9, 9):.4f}" if chance.random() < 0.2 else ""
            lines.append(f"G0{chance.choice('1110')} X{x:.4f} Y{y:.4f}{rest}")
        if chance.random() < 0.4:
            lines.append(chance.choice(("M100", "H100", "M6", "M100\nM6", "G04 0.01")))
    return "\n".join([*lines, "M30"])


@each_seed(6, 1)
def test_random_curves_keep_the_limits(seed: int) -> None:
    """MO-1: in each tick, with an operator who turns the override, holds and goes back."""
    operator = Operator(seed, ("", "override hold", "back", "single")[seed % 4])
    performed(contoured(seed), operator)

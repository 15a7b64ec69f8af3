# SPDX-License-Identifier: MIT
"""Decisions on mirroring, rotation and scaling of the programmed contour (MO-8).

Sources: the programming manual's pages on G20 … G23, G351, ``#ROTATION``, G68 and ``#SCALE``.
Places are worked out by hand, and against products of matrices.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.decided import left, numbers, perform

from nctakt.decoder.state.geometry.contour_frame import ContourFrame
from nctakt.results.run import Run
from nctakt.run.controller import Controller

POSITIONS = [f"{axis}.ACS.ACT_POS" for axis in "XYZ"]
HEAD = "G90 G17 F6000\n"


def done(program: str) -> Run:
    """A program's run without errors."""
    run = perform(f"{HEAD}{program}\nM30", signals=POSITIONS)
    assert run.state == "ended", run.diagnostics
    return run


def way(run: Run) -> np.ndarray:
    """The axes' positions at each tick."""
    assert run.trace is not None
    ticks = range(run.first_tick, run.first_tick + run.ticks)
    return np.array([[run.trace.at(tick, name) for name in POSITIONS] for tick in ticks])


def ends_at(program: str) -> list[float]:
    """The positions of X, Y, Z after a program."""
    return list(way(done(program))[-1])


def at(*place: float) -> object:
    """What equals a place but for rounding."""
    return pytest.approx(place, abs=1e-9)


@pytest.mark.parametrize(
    ("program", "place"),
    [
        ("G21\nG01 X10 Y5", (-10, 5, 0)),
        ("G22\nG01 X10 Y5", (10, -5, 0)),
        ("G23 X10 Y5", (-10, -5, 0)),
        ("G21\nG22\nG01 X10 Y5", (10, -5, 0)),
        ("G23\nG20\nG01 X10 Y5", (10, 5, 0)),
        ("G21\nG01 X10\nG91 X10", (-20, 0, 0)),
        ("G01 X10\nG21\nG01 Y5", (10, 5, 0)),
        ("G21\nG92 X1\nG01 X10", (-9, 0, 0)),
        ("G18\nG21\nG01 Z10 X5", (5, 0, -10)),
        ("G351 X-1 Z-1\nG01 X10 Y5 Z3", (-10, 5, -3)),
        ("G351 X-1 Z-1\nG351 X1\nG01 X10 Y5 Z3", (10, 5, -3)),
        ("P1 = -1\nG351 X=P1\nG20\nG01 X10", (10, 0, 0)),
        ("G70\nG21\nG01 X1 F100", (-25.4, 0, 0)),
        ("#CS ON [1, 0, 0, 0, 0, 90]\nG21\nG01 X10 Y5", (-4, -10, 0)),
        ("G21\nG01 X10\n#MCS ON\nG01 X7 Y1", (7, 1, 0)),
        ("G21\n#MCS ON\nG01 X7\n#MCS OFF\nG01 X9", (-9, 0, 0)),
    ],
)
def test_mirroring(program: str, place: tuple[float, ...]) -> None:
    """Signs change before offsets are added; one of G20 … G23 replaces the other ones."""
    assert ends_at(program) == at(*place)


@pytest.mark.parametrize(
    ("program", "place"),
    [
        ("#ROTATION ON [ANGLE=90]\nG01 X10", (0, 10, 0)),
        ("#ROTATION ON [ANGLE=90 CENTER1=10]\nG01 X20", (0, 10, 0)),
        ("#ROTATION ON [ANGLE=90 CENTER1=10 CENTER2=5]\nG01 X20 Y5", (10, 15, 0)),
        ("#ROTATION ON [ANGLE=90]\nG01 X10\nG91 X5 Z2", (0, 15, 2)),
        ("#ROTATION ON [ANGLE=30]\n#ROTATION OFF\nG01 X10", (10, 0, 0)),
        ("#ROTATION ON [ANGLE=90]\n#ROTATION OFF\n#ROTATION ON\nG01 X10", (0, 10, 0)),
        ("G92 X1\n#ROTATION ON [ANGLE=90]\nG01 X10 Y0", (1, 10, 0)),
        ("#ROTATION ON [ANGLE=90]\nG92 X1\nG01 X10 Y0", (1, 10, 0)),
        ("G22\n#ROTATION ON [ANGLE=90]\nG01 X10 Y0", (0, -10, 0)),
        ("G19\n#ROTATION ON [ANGLE=90]\nG01 Y10", (0, 0, 10)),
        ("G01 X10 Y10\nG68 R90\nG01 X20 Y10", (10, 20, 0)),
        ("G01 X10 Y10\nG68 R90 X0 Y0\nG01 X20 Y10", (-10, 20, 0)),
        ("G68 R90\nG69\nG01 X20", (20, 0, 0)),
        ("G68\nG01 X20", (20, 0, 0)),
        ("#CS ON [0, 0, 0, 0, 0, 90]\n#ROTATION ON [ANGLE=90]\nG01 X10 Y0", (-10, 0, 0)),
        ("#ROTATION ON [ANGLE=90]\n#MCS ON\nG01 X7\n#MCS OFF\nG01 X9 Y0", (0, 9, 0)),
    ],
)
def test_rotation(program: str, place: tuple[float, ...]) -> None:
    """Before mirroring and offsets; what ``#ROTATION ON`` does not name stays as it was."""
    assert ends_at(program) == at(*place)


@pytest.mark.parametrize(
    ("program", "place"),
    [
        ("#SCALE ON X2 Y0.5\nG01 X10 Y10 Z10", (20, 5, 10)),
        ("#SCALE X2\nG01 X10", (10, 0, 0)),
        ("#SCALE X2\n#SCALE ON Y3\nG01 X10 Y10", (20, 30, 0)),
        ("#SCALE ON X2\n#SCALE OFF\nG01 X10", (10, 0, 0)),
        ("#SCALE ON X2\n#SCALE OFF\n#SCALE ON\nG91 G01 X10", (20, 0, 0)),
        ("G92 X1\n#SCALE ON X2\nG01 X10", (21, 0, 0)),
        ("#SCALE ON X2\n#ROTATION ON [ANGLE=90 CENTER1=10]\nG01 X10 Y0", (10, 10, 0)),
        ("#SCALE ON X2\nG21\nG01 X10", (-20, 0, 0)),
    ],
)
def test_scaling(program: str, place: tuple[float, ...]) -> None:
    """About the program's zero, before rotation, whose centre it leaves where it is."""
    assert ends_at(program) == at(*place)


@pytest.mark.parametrize(
    "arc",
    ["G03 X20 Y10 I10 J0", "G03 X20 Y10 R10", "G161\nG03 X20 Y10 I10 J10", "G163=10\nG03 X20 Y10"],
)
@pytest.mark.parametrize(
    ("frame", "centre", "radius", "end"),
    [
        ("G21", (-10, 10), 10, (-20, 10)),
        ("G23", (-10, -10), 10, (-20, -10)),
        ("#ROTATION ON [ANGLE=90]", (-10, 10), 10, (-10, 20)),
        ("#SCALE ON X2 Y2", (20, 20), 20, (40, 20)),
    ],
)
def test_arcs(
    arc: str, frame: str, centre: tuple[float, float], radius: float, end: tuple[float, float]
) -> None:
    """From the bottom of a circle a quarter to its right end; mirrored in one axis it runs back."""
    if "I10 J0" in arc:
        arc = "G03 X20 Y10 I0 J10"
    ticks = way(done(f"{frame}\nG01 X10 Y0\nG04 X0.01\n{arc}"))
    assert list(ticks[-1][:2]) == at(*end)
    places = np.hypot(*(ticks[:, :2] - centre).T)
    last = ticks[np.abs(places - radius) < 1e-6]
    turned = np.unwrap(np.arctan2(*(last[:, :2] - centre).T[::-1]))
    assert abs(turned[-1] - turned[0]) == pytest.approx(math.pi / 2, abs=1e-3)


def test_a_mirrored_contour_is_compensated_on_the_other_side() -> None:
    """G41 stays left of the contour as it is programmed."""
    text = "T1\nD1\n{}G41\nG01 X10 Y10\nX60\nY40\nX10\nG40 X0 Y0"
    programmed, mirrored = (way(done(text.format(word))) for word in ("", "G21\n"))
    assert programmed[:, 0].max() < 60
    assert np.abs(mirrored - programmed * [-1, 1, 1]).max() < 1e-9


SPLINE = """{}
#AKIMA TRANS [START=USER]
#AKIMA STARTVECTOR X1 Y2 Z0
#SPLINE ON
G01 X10 Y0
X20 Y5
X30 Y0
#SPLINE OFF"""


@pytest.mark.parametrize(
    ("frame", "matrix"),
    [
        ("G21", [[-1, 0], [0, 1]]),
        ("#ROTATION ON [ANGLE=90]", [[0, -1], [1, 0]]),
        ("G22\n#ROTATION ON [ANGLE=90]", [[0, -1], [-1, 0]]),
    ],
)
def test_the_direction_of_a_spline_is_mapped(frame: str, matrix: list[list[float]]) -> None:
    """A mapped spline is the programmed one, turned or seen in a mirror, tick by tick."""
    programmed, mapped = (way(done(SPLINE.format(word)))[:, :2] for word in ("", frame))
    assert np.abs(mapped - programmed @ np.array(matrix).T).max() < 1e-9


def test_what_programs_can_read() -> None:
    """V.A.MENT is the place before mirroring, V.A.PROG after it; V.G.ROT_… the rotation."""
    text = f"{HEAD}#ROTATION ON [ANGLE=90 CENTER1=1 CENTER2=2]\nG21\nG01 X11 Y2\n"
    values = {
        "V.A.MENT.X": 1.0,
        "V.A.PROG.X": -1.0,
        "V.A.PROG.Y": 12.0,
        "V.G.ROT_ACTIVE": 1.0,
        "V.G.ROT_ANGLE": 90.0,
        "V.G.ROT_CENTER1": 1.0,
        "V.G.ROT_CENTER2": 2.0,
    }
    for name, value in values.items():
        assert left(f"{text}V.E.VALUE = {name}\nM30", "V.E.VALUE") == pytest.approx(value)


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("G351 X0", 20860),
        ("P1 = 2\nG351 X=P1", 20860),
        ("G351", 20052),
        ("G21 G22", 20112),
        ("G351 X-1 G01", 900210),
        ("G68 R30 Z5", 22156),
        ("G68 R30 G01 X5", 900210),
        ("G68 R30 I5", 900210),
        ("G351 X-1\nG351 X-2", 20860),
        ("P1 = -2\n#SCALE ON X=P1", 901726),
        ("#ROTATION ON [ANGLE=3 ANGLE=4]", 22155),
        ("#ROTATION ON [ANGLE=30]\n#MCS ON\nG18\n#MCS OFF\nG01 X10", 901729),
        ("G193 G293 G01 X5", 900210),
        ("G09 G193 G01 X5", 900210),
        ("G293 G08 G01 X5", 900210),
        ("#SCALE ON X0", 901726),
        ("#SCALE ON X2\n#SCALE Y2", 901725),
        ("#SCALE", 20052),
        ("#SCALE ON X2\nG02 X10 Y0 R5", 901727),
        ("#ROTATION", 0),
        ("#ROTATION ON [ANGEL=30]", 0),
        ("T1\nD1\nG41 X10\nG21", 901728),
        ("T1\nD1\nG41 X10\n#ROTATION ON [ANGLE=3]", 901728),
        ("#ROTATION ON [ANGLE=30]\nG18\nG01 X10", 901729),
    ],
)
def test_mistakes(program: str, expected: int) -> None:
    """Each has its number; none moves an axis accidentally."""
    run = perform(f"{HEAD}{program}\nM30", signals=POSITIONS)
    assert run.diagnostics
    assert expected in (*numbers(run), 0), run.diagnostics


angles = st.floats(-720, 720)
places = st.lists(st.floats(-1000, 1000), min_size=3, max_size=3)
factors = st.dictionaries(st.integers(0, 2), st.floats(0.1, 10))


@given(
    angles, places, places, factors, st.frozensets(st.integers(0, 2)), st.sampled_from((0, 1, 2))
)
def test_frames_against_matrices(
    angle: float,
    centre: list[float],
    place: list[float],
    factor: dict[int, float],
    mirrored: frozenset[int],
    normal: int,
) -> None:
    """Scaling, rotation about the centre, mirroring as 4 × 4 matrices; and back."""
    first, second = ((1, 2), (2, 0), (0, 1))[normal]
    frame = ContourFrame(
        mirrored, factor, True, True, angle, (centre[first], centre[second]), (first, second)
    )
    scale = np.diag([factor.get(axis, 1.0) for axis in range(3)] + [1.0])
    turn, shift = np.eye(4), np.eye(4)
    sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    turn[first, first] = turn[second, second] = cosine
    turn[first, second], turn[second, first] = -sine, sine
    shift[first, 3], shift[second, 3] = centre[first], centre[second]
    mirror = np.diag([-1.0 if axis in mirrored else 1.0 for axis in range(3)] + [1.0])
    expected = mirror @ shift @ turn @ np.linalg.inv(shift) @ scale @ [*place, 1.0]
    found = frame.outside(place)
    assert found == pytest.approx(list(expected[:3]), abs=1e-8)
    assert frame.inside(found) == pytest.approx(place, abs=1e-8)


def test_the_example_cuts_its_pocket_in_four_places() -> None:
    """As drawn it fills x 10 … 40, y 5 … 20: mirrored, turned by 180°, halved and mirrored down."""
    controller = Controller()
    program = Path(__file__).parents[2] / "examples" / "frames.nc"
    run = controller.run(program, signals=POSITIONS)
    assert run.state == "ended", run.diagnostics
    cuts = np.array([place[:2] for place in way(run) if place[2] == -2.0])
    jumps = np.abs(np.diff(cuts, axis=0)).max(axis=1) > 1.0
    pockets = np.split(cuts, np.flatnonzero(jumps) + 1)
    boxes = [(*pocket.min(axis=0), *pocket.max(axis=0)) for pocket in pockets]
    assert boxes == [
        at(10, 5, 40, 20),
        at(-40, 5, -10, 20),
        at(-40, -20, -10, -5),
        at(5, -10, 20, -2.5),
    ]
    assert controller.read("V.E.COUNT") == 4

# SPDX-License-Identifier: MIT
"""``#FACE`` and ``#CYL`` on demo5: planes that turn with the axis C (language: 1.6; MO-1, MO-8)."""

from __future__ import annotations

import functools
import random
import shutil
from pathlib import Path

import numpy as np
import pytest
from support.random_seeds import seeds_in_parts

from nctakt import machines
from nctakt.decoder.kinematics.rotating_planes import RotatingPlane, map_values
from nctakt.kernel.kinematics import map_rows
from nctakt.kernel.kinematics.maps import KinematicMaps
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

NAMES = ("X", "Y", "Z", "C", "A")
SIGNALS = [*(f"{name}.ACS.ACT_POS" for name in NAMES), "BLOCK", "X.PCS.ACT_POS", "C.PCS.ACT_POS"]
#: What the lists of demo5 allow the axes X, Z and C, per s and s².
SPEED, ACCELERATION = np.array([500.0, 500.0, 360.0]), np.array([4000.0, 4000.0, 4000.0])
PLANE_NOTE = 901816


@functools.cache
def machine() -> Machine:
    return load_machine(Path(machines.__path__[0]) / "demo5")


def run_of(text: str, own: Machine | None = None) -> Run:
    """The run of a program on demo5, with the trace of ``SIGNALS``."""
    return Controller(own or machine()).run(NcText("t.nc", text), ticks=200_000, signals=SIGNALS)


def column(run: Run, name: str) -> np.ndarray:
    assert run.trace is not None
    return np.asarray(run.trace[name])


def axes(run: Run) -> np.ndarray:
    """X, Z and C after each tick; C as it runs on."""
    c = np.unwrap(np.concatenate([[0.0], column(run, "C.ACS.ACT_POS")]), period=360.0)[1:]
    return np.column_stack([column(run, "X.ACS.ACT_POS"), column(run, "Z.ACS.ACT_POS"), c])


def face(run: Run) -> np.ndarray:
    """Where the tool is on the turning face, from X and C alone."""
    places = axes(run)
    angle = np.radians(places[:, 2])
    return np.column_stack([places[:, 0] * np.cos(angle), places[:, 0] * np.sin(angle)])


def beside_line(points: np.ndarray, start: tuple[float, ...], end: tuple[float, ...]) -> float:
    """How far the points are from a line, at most."""
    way = np.subtract(end, start)
    across = np.array([-way[1], way[0]]) / np.hypot(*way)
    return float(np.abs((points - np.array(start)) @ across).max())


def errors(run: Run) -> list[int]:
    return [one.id for one in run.diagnostics if one.id != PLANE_NOTE]


def assert_within_limits(run: Run) -> None:
    path = np.concatenate([np.zeros((2, 3)), axes(run), *([axes(run)[-1:]] * 2)])
    for order, limits in ((1, SPEED), (2, ACCELERATION)):
        worst = np.abs(np.diff(path, order, axis=0)).max(axis=0) / 0.001**order / limits
        assert (worst < 1 + 1e-6).all(), (order, worst)


SQUARE = """N10 G00 X60 Z0 C0
N20 #FACE [X, C]
N30 G01 X40 C-30 F3000
N40 X-40
N50 C30
N60 G02 X40 I40 J0
N70 #FACE OFF
N80 G00 X100 C0
M30"""


def test_a_square_on_the_face_is_straight() -> None:
    run = run_of(SQUARE)
    assert errors(run) == []
    points, blocks = face(run), column(run, "BLOCK")
    assert beside_line(points[blocks == 40][:-1], (40, -30), (-40, -30)) < 1e-9
    assert beside_line(points[blocks == 50][:-1], (-40, -30), (-40, 30)) < 1e-9
    around = points[blocks == 60][:-1] - [0, 30]
    assert np.abs(np.hypot(*around.T) - 40).max() < 1e-9
    assert list(axes(run)[-1][:2]) == [100.0, 0.0]
    assert column(run, "C.ACS.ACT_POS")[-1] == 0.0
    assert_within_limits(run)


def test_positions_in_the_plane_are_shown_in_mm() -> None:
    run = run_of(SQUARE)
    inside = np.flatnonzero((column(run, "BLOCK") >= 40) & (column(run, "BLOCK") < 70))[:-1]
    shown = np.column_stack([column(run, "X.PCS.ACT_POS"), column(run, "C.PCS.ACT_POS")])
    assert np.abs(shown[inside] - face(run)[inside]).max() < 1e-9


def test_the_feed_is_that_of_the_tool_on_the_part() -> None:
    """A line of 80 mm at 3000 mm/min takes 1.6 s and the two ramps."""
    blocks = column(run_of(SQUARE), "BLOCK")
    assert 1600 <= (blocks == 40).sum() < 1640


def test_a_groove_on_the_cylinder() -> None:
    text = """N10 G00 X60 Z20
N20 #CYL [Z, C, X60]
N30 G01 Z0 C0 F3000
N40 X58
N50 Z-30 C20
N60 G02 Z-30 C60 I0 J20
N70 #CYL OFF
M30"""
    run = run_of(text)
    assert errors(run) == []
    places, blocks = axes(run), column(run, "BLOCK")
    groove = np.column_stack([places[:, 1], np.radians(places[:, 2]) * 60.0])
    assert beside_line(groove[blocks == 50][:-1], (0, 0), (-30, 20)) < 1e-9
    around = groove[blocks == 60][:-1] - [-30, 40]
    assert np.abs(np.hypot(*around.T) - 20).max() < 1e-9
    assert np.abs(places[blocks == 60][:, 0] - 58).max() < 1e-9
    assert_within_limits(run)


def test_radius_compensation_lies_in_the_plane() -> None:
    """G41 with the radius 5 of tool 1 around a square of 40 mm, outside."""
    text = """N5 D1
N10 G00 X60 C0
N20 #FACE [X, C]
N30 G42 G01 X20 C-20 F3000
N40 C20
N50 X-20
N60 C-20
N70 X20
N80 G40 X60
M30"""
    run = run_of(text)
    assert errors(run) == []
    points, blocks = face(run), column(run, "BLOCK")
    assert beside_line(points[blocks == 60][5:-1], (-25, 20), (-25, -20)) < 1e-9


def test_the_tool_beside_the_spindle_counts_along_the_radius() -> None:
    """Tool 3 is 1 mm beside the middle in X; the contour on the part is the programmed one."""
    run = run_of("N5 D3\n" + SQUARE)
    places = axes(run)
    places[:, 0] -= 1.0
    angle = np.radians(places[:, 2])
    points = np.column_stack([places[:, 0] * np.cos(angle), places[:, 0] * np.sin(angle)])
    blocks = column(run, "BLOCK")
    assert beside_line(points[blocks == 40][:-1], (40, -30), (-40, -30)) < 1e-9
    assert places[-1][0] == 100.0


def test_both_planes_follow_each_other_without_off() -> None:
    text = "N10 G00 X50 C90\nN20 #FACE [X, C]\nN30 #CYL [Z, C, X50]\nN40 G01 C0 Z5 F3000\nM30"
    run = run_of(text)
    assert errors(run) == []
    assert axes(run)[-1] == pytest.approx([50.0, 5.0, 0.0], abs=1e-9)


def test_lengths_in_inch() -> None:
    run = run_of("N10 G00 X50\nN20 #FACE [X, C]\nN30 G70 G01 X1 C1 F100\nM30")
    assert face(run)[-1] == pytest.approx([25.4, 25.4], abs=1e-9)


def test_a_line_through_the_centre_is_refused_and_one_into_it_is_not() -> None:
    begin = "N10 G00 X20\nN20 #FACE [X, C]\nN30 G01 X0 C0 F1000\n"
    assert errors(run_of(begin + "M30")) == []
    assert errors(run_of(begin + "N40 X20 C20\nM30")) == [901619]
    assert errors(run_of("N10 G00 X20\nN20 #FACE [X, C]\nN30 G01 X-20 F1000\nM30")) == [901619]
    # Out of the centre C would turn at once by the angle of the line, however small it is.
    assert errors(run_of("N20 #FACE [X, C]\nN30 G01 X100 C1 F1000\nM30")) == [901619]
    assert errors(run_of("N20 #FACE [X, C]\nN30 G01 X100 C0 F1000\nM30")) == []


@pytest.mark.parametrize(
    ("line", "number"),
    [
        ("#FACE [X, Z]", 20886),
        ("#FACE [X, A]", 20886),
        ("#FACE [X, Q]", 901812),
        ("#FACE [X]", 900233),
        ("#CYL [Z, C]", 900233),
        ("#CYL [Z, C, X0]", 901813),
        ("#FACE [X, C]\nG18", 20944),
        ("#FACE [X, C]\nG33 Z5 K1", 20944),
        ("#FACE [X, C]\n#TRAFO ON", 901814),
        ("#FACE [X, C]\n#MCS ON", 901814),
        ("#TRAFO ON\n#FACE [X, C]", 901814),
        ("#CS ON [1,2,3,0,0,0]\n#FACE [X, C]", 901814),
        ("#CYL ORI LATERAL", 900200),
        ("#CYL ORI PROFILE", 900200),
        ("#CYL 2ROT [AX1=X AX2=C AX3=A]", 900200),
        ("#FACE 2ROT [AXNR1=1 AXNR2=4]", 900200),
        ("#CYL 2ROT OFF", 900200),
    ],
)
def test_what_is_refused(line: str, number: int) -> None:
    assert errors(run_of(f"N1 G00 X50\n{line}\nM30")) == [number]


@pytest.mark.parametrize(
    ("lines", "place"),
    [
        ("G21", (-40.0, 10.0)),
        ("G22", (40.0, -10.0)),
        ("G351 C-1", (40.0, -10.0)),
        ("#SCALE ON X2 C3", (80.0, 30.0)),
        ("#ROTATION ON [ANGLE=90]", (-10.0, 40.0)),
        ("G68 X50 C0 R90", (40.0, -10.0)),
        ("G68 X50 C0 R90\nG01 X50 C10 F999\nG69", (40.0, 10.0)),
    ],
)
@pytest.mark.parametrize("plane", ["#FACE [X, C]", "#CYL [Z, C, X50]"])
def test_contours_are_mirrored_rotated_and_scaled_in_the_plane(
    plane: str, lines: str, place: tuple[float, float]
) -> None:
    """The first axis of the plane is its X, the rotary one its Y; 1 mm around is 1 mm."""
    first = plane[plane.index("[") + 1]
    lines = lines.replace("X", first)
    run = run_of(f"N1 G00 X50 Z50\nN2 {plane}\n{lines}\nG01 {first}40 C10 F5000\nM30")
    assert errors(run) == []
    if first == "X":
        assert face(run)[-1] == pytest.approx(place, abs=1e-9)
    else:
        end = (axes(run)[-1][1], np.radians(axes(run)[-1][2]) * 50.0)
        assert end == pytest.approx(place, abs=1e-9)


def test_a_rotation_belongs_to_its_plane() -> None:
    inside = "N1 G00 X50\n#FACE [X, C]\n#ROTATION ON [ANGLE=90]\n#FACE OFF\nG00 X60 C0\nM30"
    run = run_of(inside)
    assert errors(run) == [901729]
    assert list(axes(run)[-1]) == [60.0, 0.0, 0.0]
    assert errors(run_of("#ROTATION ON [ANGLE=90]\n#CYL [Z, C, X50]\nM30")) == [901814]


#: Where the tool of a milling machine stays in Y, and what #FACE needs there.
ACROSS = 20.0


@functools.cache
def milling_machine(folder: Path) -> Machine:
    target = folder / "machine"
    shutil.copytree(Path(machines.__path__[0]) / "demo5", target)
    channel = target / "sda_mds1.lis"
    listed = channel.read_text("utf-8").replace(
        "cax_face_id                             1", "cax_face_id 2"
    )
    channel.write_text(listed.replace("13       ( face", "14"), "utf-8")
    return load_machine(target)


def test_the_face_on_a_milling_machine(tmp_path: Path) -> None:
    """Kinematic 14: Y stays at 20; the part turned back by C has the tool on the line."""
    text = SQUARE.replace("X60 Z0 C0", "X60 Y20 Z0 C0").replace(
        "N70 #FACE OFF", "N65 G01 X30 C5\nN70 #FACE OFF"
    )
    run = Controller(milling_machine(tmp_path)).run(
        NcText("t.nc", text), ticks=200_000, signals=SIGNALS
    )
    assert errors(run) == []
    assert set(column(run, "Y.ACS.ACT_POS")[column(run, "BLOCK") >= 20]) == {ACROSS}
    places, blocks = axes(run), column(run, "BLOCK")
    points = np.array([tuple(turned(c) @ (x, ACROSS)) for x, _, c in places])
    assert beside_line(points[blocks == 40][:-1], (40, -30), (-40, -30)) < 1e-9
    assert beside_line(points[blocks == 50][:-1], (-40, -30), (-40, 30)) < 1e-9
    around = points[blocks == 60][:-1] - [0, 30]
    assert np.abs(np.hypot(*around.T) - 40).max() < 1e-9
    assert points[blocks == 65][-1] == pytest.approx((30.0, 5.0), abs=0.1)
    assert_within_limits(run)


def test_the_face_on_a_milling_machine_has_a_hole_in_the_middle(tmp_path: Path) -> None:
    text = "N10 G00 X60 Y20\nN20 #FACE [X, C]\nN30 G01 X10 C10 F3000\nM30"
    run = Controller(milling_machine(tmp_path)).run(NcText("t.nc", text), ticks=200_000)
    assert errors(run) == [901618]


def turned(degrees: float) -> np.ndarray:
    """The rotation of a plane by an angle."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, -s], [s, c]])


@seeds_in_parts(compiled=300, plain=30, part=100)
def test_maps_against_products_of_matrices(seeds: range) -> None:
    """Kinematics 13, 14 and 15, there and back, with the tool beside the line of X."""
    for seed in seeds:
        dice = random.Random(f"planes {seed}")
        positions = [dice.uniform(-200, 200) for _ in range(5)]
        near = list(positions)
        near[3] += dice.uniform(-100, 100)
        radial, tool = dice.choice((0, 1)), dice.uniform(-5, 5)
        across = dice.choice((0.0, dice.uniform(-50, 50)))
        positions[radial] = tool + dice.uniform(0.1, 200)
        plane = RotatingPlane("#FACE", (radial, 3), 3, radial, beside=across)
        maps = KinematicMaps(5)
        number = maps.add(map_values(plane, range(5), {radial: tool}))
        shown = list(positions)
        shown[radial], shown[3] = turned(positions[3]) @ (positions[radial] - tool, across)
        assert mapped(maps, number, positions, None) == pytest.approx(shown, abs=1e-9)
        back = mapped(maps, number, shown, near)
        assert back == pytest.approx(positions, abs=1e-9), seed
        radius, zero = dice.uniform(1, 300), dice.uniform(-180, 180)
        plane = RotatingPlane("#CYL", (2, 3), 3, radius=radius, zero_angle=zero)
        number = maps.add(map_values(plane, range(5), {}))
        shown = list(positions)
        shown[3] = np.radians(positions[3] - zero) * radius
        assert mapped(maps, number, positions, None) == pytest.approx(shown, abs=1e-9)
        assert mapped(maps, number, shown, near) == pytest.approx(positions, abs=1e-9)


def mapped(
    maps: KinematicMaps, number: int, positions: list[float], near: list[float] | None
) -> list[float]:
    """What a map makes of positions: of the axes, or with ``near`` of the plane."""
    given, beside, results = (memoryview(bytearray(40)).cast("d") for _ in range(3))
    for i in range(5):
        given[i] = positions[i]
        beside[i] = (near or positions)[i]
    if near is None:
        maps.forward(number, given, beside, results)
    else:
        assert maps.inverse(number, given, beside, results) == map_rows.REACHED
    return list(results)


@seeds_in_parts(compiled=12, plain=1, part=6)
def test_random_contours_stay_on_their_lines_and_within_the_limits(seeds: range) -> None:
    for seed in seeds:
        dice = random.Random(f"face {seed}")
        place = (dice.uniform(5.0, 60.0), 0.0)
        lines = [f"N1 G00 X{place[0]:.4f}", "N2 #FACE [X, C]"]
        ways = {}
        place = (round(place[0], 4), 0.0)
        for number in range(10, 18):
            end = (round(dice.gauss(0, 30), 4), round(dice.gauss(0, 30), 4))
            feed = dice.choice((500, 3000, 20000))
            lines.append(f"N{number} G01 X{end[0]} C{end[1]} F{feed}")
            ways[number] = (place, end)
            place = end
        run = run_of("\n".join([*lines, "M30"]))
        if errors(run) == [901619]:
            continue
        assert errors(run) == [], seed
        points, blocks = face(run), column(run, "BLOCK")
        for number, (start, end) in ways.items():
            assert beside_line(points[blocks == number][:-1], start, end) < 1e-6, (seed, number)
        assert_within_limits(run)

# SPDX-License-Identifier: MIT
"""Decisions on arcs, on the ends of blocks, and on rounded corners (MO-1, MO-3, MO-4)."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from support.decided import left, numbers, perform
from support.kernel_rig import controller_with

from nctakt.results.run import Run

AXES = ("X.ACS.ACT_POS", "Y.ACS.ACT_POS", "Z.ACS.ACT_POS")


def moved(program: str) -> Run:
    """A run with the positions of X, Y and Z."""
    run = perform(program + "\nM30", signals=[*AXES, "PATH.SPEED", "X.PCS.DIST_TO_GO", "BLOCK"])
    assert run.state == "ended", run.diagnostics
    return run


def place(run: Run, tick: int) -> tuple[float, ...]:
    """Where X, Y and Z are after a tick."""
    assert run.trace is not None
    return tuple(run.trace.at(tick, name) for name in AXES)


def test_the_feed_goes_along_the_arc() -> None:
    """MO-4: a quarter of a circle of 10 mm at 100 mm/s.

    A quarter of the acceleration is centripetal, 100² / 10; along the path are left
    4000·√(1 − 1/16) = 3873 mm/s². 15.708 mm take 157.08 + 25.82 = 182.9 ms: 183 ticks. After 91 ms
    9.1 − 1.291 = 7.809 mm are covered, 0.7809 of the circle's radius.
    """
    run = moved("G03 X-10 Y10 I-10 J0 F6000")
    assert run.ticks == 184
    angle = (100 * 0.091 - 100**2 / (2 * 4000 * math.sqrt(1 - 1 / 16))) / 10
    expected = (-10 + 10 * math.cos(angle), 10 * math.sin(angle), 0.0)
    assert place(run, 90) == pytest.approx(expected, abs=1e-9)
    assert place(run, 182) == (-10.0, 10.0, 0.0)


@pytest.mark.parametrize(
    ("words", "middle"),
    [
        ("G17 G03 I10", (10, -10, 0)),
        ("G17 G02 I10", (10, 10, 0)),
        ("G18 G03 K10", (-10, 0, 10)),
        ("G18 G02 K10", (10, 0, 10)),
        ("G19 G03 J10", (0, 10, -10)),
        ("G19 G02 J10", (0, 10, 10)),
        ("G17 G161 G03 I10 J0", (10, -10, 0)),
        ("G17 G03 X0 Y0 I10", (10, -10, 0)),
        ("G70 G17 G03 I[10/25.4]", (10, -10, 0)),
    ],
)
def test_full_circles_in_the_three_planes(words: str, middle: tuple[float, ...]) -> None:
    """MO-4: a target that is the start, or none, is a full circle; it passes ``middle``."""
    run = moved(f"{words} F3000")
    away = min(math.dist(place(run, tick), middle) for tick in range(run.ticks))
    assert away < 0.15
    assert place(run, run.ticks - 2) == (0.0, 0.0, 0.0)


def test_a_target_that_rounding_moves_off_the_start_is_a_full_circle() -> None:
    """MO-4, MO-14: 5.6e-17 mm beside the start; it ends there, bit for bit."""
    run = moved("G17 G03 X[0.1+0.2-0.3] Y0 I10 F3000")
    away = min(math.dist(place(run, tick), (10, -10, 0)) for tick in range(run.ticks))
    assert away < 0.15
    assert place(run, run.ticks - 2) == (0.1 + 0.2 - 0.3, 0.0, 0.0)


def test_a_radius_has_a_shorter_and_a_longer_arc() -> None:
    """R stays; a negative one is the longer arc; alone in a block it moves nothing."""
    run = moved("G02 R10\nX10 Y10 F3000\nG90 G01 X0 Y0\nG02 X10 Y10 R-10")
    near = [
        math.dist(place(run, tick), (10 - 10 * 0.5**0.5, 10 * 0.5**0.5, 0)) for tick in range(900)
    ]
    assert min(near) < 0.03
    assert max(place(run, tick)[1] for tick in range(run.ticks)) == pytest.approx(20.0, abs=0.01)
    assert place(run, run.ticks - 2) == (10.0, 10.0, 0.0)


def test_a_helix_rises_with_its_angle() -> None:
    """The third axis moves along evenly; the feed is that of the whole way."""
    run = moved("G03 X0 Y0 Z5 I10 F3000")
    length = math.hypot(20 * math.pi, 5)
    assert run.ticks - 1 == pytest.approx(1000 * (length / 50 + 50 / 4000), abs=1.5)
    for tick in range(0, run.ticks, 97):
        x, y, z = place(run, tick)
        angle = math.atan2(-y, 10 - x) % (2 * math.pi)
        assert z == pytest.approx(5 * angle / (2 * math.pi), abs=1e-9)


@pytest.mark.parametrize(
    ("block", "number"),
    [
        ("G02 X10", 20036),
        ("G02 X10 I0 J0", 20036),
        ("G02 X10 R4.9", 20033),
        ("G02 X0 R5", 20036 + 1),
        ("G02 X10 I4.74", 20035),
        ("G02 X0.005 I5", 20035),
        ("G02 X10 K5", 900704),
        ("G00 X9999 Y0\nG03 Y5 J2.5", 120002),
    ],
)
def test_arcs_that_are_none_have_a_diagnostic(block: str, number: int) -> None:
    """No centre, radius too small, target off the circle, wrong centre word, beyond the limits."""
    run = perform(f"F3000\n{block}\nM30")
    if block == "G02 X0 R5":
        assert run.state == "ended"  # nothing moves
        return
    assert (run.state, numbers(run)) == ("error", [number])


@pytest.mark.parametrize("centre", ["5.004", "4.77"])
def test_a_centre_nearly_right_is_moved(centre: str) -> None:
    """P-CHAN-00060: up to 50 per mille of the radius, to where it is equally far from both ends."""
    run = moved(f"G02 X10 Y0 I{centre} F3000")
    radii = [math.dist(place(run, tick), (5.0, 0.0, 0.0)) for tick in range(run.ticks - 1)]
    assert max(radii) - min(radii) < 1e-9


@pytest.mark.parametrize(
    ("entries", "centre", "state"),
    [
        ("", "48", "ended"),
        ("", "47.9", "error"),  # 2.1 mm, though 50 per mille of 50 mm are 2.5 mm
        ("mittelpkt_diff 25000", "47.6", "ended"),
        ("mittelpkt_diff 25000", "47.4", "error"),
        ("mittelpkt_diff 100\nmittelpkt_faktor 1000", "49.99", "ended"),
        ("mittelpkt_diff 100\nmittelpkt_faktor 1000", "49.98", "error"),
        ("mittelpkt_diff 0", "50", "ended"),
        ("mittelpkt_diff 0", "49.999", "error"),
    ],
)
def test_how_far_a_centre_may_be_off(tmp_path: Path, entries: str, centre: str, state: str) -> None:
    """P-CHAN-00059 and P-CHAN-00060: both hold; 2 mm and 50 per mille by default."""
    controller = controller_with(tmp_path, entries)
    run = perform(f"G00 X0 Y0\nG02 X100 Y0 I{centre} F60000\nM30", controller)
    assert run.state == state, run.diagnostics


def test_a_management_command_between_blocks_does_not_stop_the_path() -> None:
    """MO-1, RC-004: 11.25 mm at 100 mm/s end with tick 124 exactly, with no time left over.

    HOLD waits there for a tick, since the cycle has just been started: the path continues.
    """
    run = moved(
        "G01 X11.25 F6000\n#RT CYCLE [ID=1]\nVs.E.COUNT += 1\n#RT CYCLE END\n"
        "#RT CYCLE HOLD [ID=1]\nG01 X20"
    )
    assert run.trace is not None
    assert [run.trace.at(tick, "PATH.SPEED") for tick in range(120, 130)] == [100.0] * 10
    assert place(run, 124)[0] == pytest.approx(11.25)
    assert place(run, 125)[0] == pytest.approx(11.35)
    assert run.trace.at(124, "BLOCK") == run.trace.at(123, "BLOCK")


def test_a_tight_arc_is_driven_slowly() -> None:
    """MO-1, MO-2: the axes keep their limit at each angle, whatever the feed.

    Where an axis turns round, it has 4000 mm/s² for v² / 1 mm: 63.2 mm/s. Between, at the angle w
    from there, x's limit 4000 = a·sin w + v²·cos w lets v² grow to 8000 / (1 + cos w) up to 45°:
    68.5 mm/s; after it y's has v² fall again."""
    run = moved("G02 I1 F30000")
    assert run.trace is not None
    speed = run.trace["PATH.SPEED"]
    assert 67.0 < max(speed) <= math.sqrt(8000 / (1 + math.sqrt(0.5)))
    assert min(speed[25:85]) <= math.sqrt(4000)


def test_blocks_in_one_line_are_passed_without_a_stop() -> None:
    """MO-3: two G01 of 1 mm in one line take as long as one of 2 mm."""
    assert moved("G01 X1 F60000\nX2").ticks == moved("G01 X2 F60000").ticks
    assert moved("G01 X1 F60000\nM100\nX2").ticks == moved("G01 X2 F60000").ticks


@pytest.mark.parametrize(
    "program",
    [
        "G60 G01 X1 F60000\nX2",
        "G360 G01 X1 F60000\nX2\nG359",
        "G01 X1 F60000\n#FLUSH\nX2",
        "G01 X1 F60000\n#TIME 0.001\nX2",
    ],
)
def test_exact_stops_end_in_their_tick(program: str) -> None:
    """G60 for its block, G360 until G359, and what needs the path to stop: 32 ticks each."""
    extra = {"#FLUSH": 1, "#TIME": 1}.get(program.split("\n")[1].split(" ", maxsplit=1)[0], 0)
    run = moved(program)
    assert place(run, 31) == (1.0, 0.0, 0.0)
    assert run.ticks - 1 == 64 + extra


def test_a_sharp_corner_is_a_stop() -> None:
    """A right angle without contouring: the axes are on the corner, within the tick."""
    run = moved("G01 X10 F6000\nY10")
    for tick in range(run.ticks):
        x, y, _ = place(run, tick)
        assert x == 10.0 or y == 0.0


def test_contouring_rounds_a_corner_by_its_deviation() -> None:
    """G261: the curve passes a right angle in a distance of 1 mm, or of what is set."""
    for setting, deviation in (("", 1.0), ("#CONTOUR MODE [DEV PATH_DEV=0.2]\n", 0.2)):
        run = moved(f"{setting}G261 G01 X40 F6000\nY40\nG260")
        nearest = min(math.dist(place(run, tick), (40, 0, 0)) for tick in range(run.ticks))
        assert nearest == pytest.approx(deviation, abs=0.01)
        assert place(run, run.ticks - 2) == (40.0, 40.0, 0.0)
        assert run.ticks < moved("G01 X40 F6000\nY40").ticks


def test_g61_rounds_the_end_of_its_block_only() -> None:
    """The corner after the block with G61 is rounded, the next one is not."""
    run = moved("G61 G01 X20 F6000\nY20\nX0")
    places = [place(run, tick) for tick in range(run.ticks)]
    assert min(math.dist(one, (20, 0, 0)) for one in places) > 0.9
    assert min(math.dist(one, (20, 20, 0)) for one in places) < 0.1


def test_distance_to_go_ends_with_the_block() -> None:
    """The target of an arc is its end; the distance to go of an axis is that to its target."""
    assert left("G03 X-10 Y10 I-10 F6000\nM30", "V.RTA.PCS.DIST_TO_GO.X") == 0.0
    run = moved("G03 X-10 Y10 I-10 F6000")
    assert run.trace is not None
    for tick in (0, 50, 150):
        found = run.trace.at(tick, "X.PCS.DIST_TO_GO")
        assert found == pytest.approx(-10 - place(run, tick)[0], abs=1e-12)


def test_the_slope_is_that_of_the_channel_until_the_program_chooses(tmp_path: Path) -> None:
    """P-CHAN-00071: 1 is the jerk-limited slope; #SLOPE DEFAULT goes back to it.

    10 mm at 20 mm/s: 500 + 5 ms with the trapezoid; with the S-curve of 15.81 ms up, 15.81 ms on
    and as much down 500 + 31.62 ms.
    """
    smooth = controller_with(tmp_path, "prog_start.slope.profile 1")
    ticks = [
        perform(f"{slope}G01 X10 F1200\nM30", controller_).ticks - 1
        for controller_, slope in (
            (None, ""),
            (smooth, ""),
            (None, "#SLOPE [TYPE=TRAPEZ]\n"),
            (None, "#SLOPE [TYPE=TRAPEZ]\n#SLOPE DEFAULT\n"),
        )
    ]
    assert ticks == [505, 532, 532, 505]


def test_with_a_limit_of_the_jerk_the_path_passes_block_ends() -> None:
    """MO-3: a line in pieces takes as long as in one piece; a right angle is a stop."""
    slope = "#SLOPE [TYPE=TRAPEZ]\nG01 F1200 "
    assert moved(slope + "X10\nX10.1\nX20").ticks == moved(slope + "X20").ticks
    run = moved(slope + "X10\nY10")
    assert place(run, run.ticks - 2) == (10.0, 10.0, 0.0)
    assert all(x == 10.0 or y == 0.0 for x, y, _ in (place(run, t) for t in range(run.ticks)))


def test_with_a_limit_of_the_jerk_an_arc_is_entered_slowly() -> None:
    """The centripetal acceleration comes in a step, at most 0.7 of what the jerk does in a tick.

    A step counts 3/4 in a tick: v² / 50 <= 0.7 * 80 / 0.75, 61.1 mm/s; the feed would be 100.
    """
    program = "#SLOPE [TYPE=TRAPEZ]\nG01 X50 F6000\nG03 X100 Y50 J50\nG01 Y90"
    run = moved(program)
    assert run.trace is not None
    speeds = run.trace["PATH.SPEED"].tolist()
    ticks = range(1, run.ticks - 1)
    entries = [t for t in ticks if place(run, t - 1)[1] == 0.0 < place(run, t)[1]]
    assert 60.0 < speeds[entries[0]] <= 61.2
    assert max(speeds) == pytest.approx(100.0)


def test_other_slopes_and_modes_are_refused_by_name() -> None:
    """900706: what is not simulated would change positions or times; 21401: no deviation."""
    assert numbers(perform("#SLOPE [TYPE=SLOW]\nM30")) == [900706]
    assert numbers(perform("#CONTOUR MODE [DEV PATH_DEV=1 X5]\nM30")) == [900706]
    assert numbers(perform("#CONTOUR MODE [DEV PATH_DEV=0]\nM30")) == [21401]


@pytest.mark.parametrize("word", ["R6", "G163=6"])
def test_an_arc_has_a_centre_or_a_radius(word: str) -> None:
    """21024: both in one block are refused before the first tick."""
    run = perform(f"G01 X1 F5000\nG02 X11 I5 {word}\nM30")
    assert (run.state, numbers(run)) == ("error", [21024])
    assert run.ticks == 0

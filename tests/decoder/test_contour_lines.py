# SPDX-License-Identifier: MIT
"""``#ANG``: lines by their angle (page 206123787, messages 21892, 21895, 21904, 21910, 21932).

Ends are worked out by hand: tan 60° = √3; two lines meet where both equations hold.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.decided import numbers, perform

from nctakt.results.run import Run

POSITIONS = [f"{axis}.ACS.ACT_POS" for axis in "XYZ"]
SPEED = "PATH.SPEED"
ROOT = math.sqrt(3.0)


def way(program: str) -> np.ndarray:
    """The axes' positions at each tick of a program without errors."""
    run = perform(f"G90 G17 G01 F6000\n{program}\nM30", signals=POSITIONS)
    assert run.state == "ended", run.diagnostics
    return positions(run)


def positions(run: Run) -> np.ndarray:
    """The axes' positions at each tick."""
    assert run.trace is not None
    return np.array([run.trace[name] for name in POSITIONS]).T


def passes(places: np.ndarray, x: float, y: float) -> float:
    """How near the way comes to a place in X, Y, in mm."""
    return float(np.hypot(places[:, 0] - x, places[:, 1] - y).min())


@pytest.mark.parametrize(
    ("program", "end"),
    [
        ("X10 Y10\n#ANG=60 X20", (20, 10 + 10 * ROOT, 0)),
        ("X10 Y10\n#ANG=60 Y20", (10 + 10 / ROOT, 20, 0)),
        ("X10 Y10\n#ANG 60 X20", (20, 10 + 10 * ROOT, 0)),
        ("P1 = 30\nX10 Y10\n#ANG=P1+30 X20", (20, 10 + 10 * ROOT, 0)),
        ("X10 Y10\nG91 #ANG=60 X10", (20, 10 + 10 * ROOT, 0)),
        ("X10 Y10\n#ANG=240 X0", (0, 10 - 10 * ROOT, 0)),
        ("X10 Y10\n#ANG=0 X20 Z5", (20, 10, 5)),
        ("X10 Y10\n#ANG=90 Y20", (10, 20, 0)),
        ("G18\nX10 Z10\n#ANG=60 Z20", (10 + 10 * ROOT, 0, 20)),
        ("G19\nY10 Z10\n#ANG=60 Y20", (0, 20, 10 + 10 * ROOT)),
        ("G92 X5\nX10 Y10\n#ANG=60 X20", (25, 10 + 10 * ROOT, 0)),
        ("G70\nX1 Y1\n#ANG=60 X2\nG71", (50.8, 25.4 + 25.4 * ROOT, 0)),
        ("X10 Y10\nG21\n#ANG=120 X-20", (20, 10 + 10 * ROOT, 0)),
        ("#ROTATION ON [ANGLE=90]\nX10 Y10\n#ANG=60 X20\n#ROTATION OFF", (-10 - 10 * ROOT, 20, 0)),
    ],
)
def test_a_line_has_its_angle_and_one_axis(program: str, end: tuple[float, ...]) -> None:
    """It ends where it has the place that is given."""
    assert list(way(program)[-1]) == pytest.approx(end, abs=1e-9)


def test_two_lines_meet_in_a_point() -> None:
    """y = x and y = 10 - (x - 20) / 2, the direction of (2, -1), meet at (40/3, 40/3)."""
    angle = math.degrees(math.atan2(-1.0, 2.0))
    places = way(f"#ANG=45\n#ANG={angle!r} X20 Y10")
    assert list(places[-1]) == pytest.approx((20, 10, 0), abs=1e-9)
    assert passes(places, 40 / 3, 40 / 3) < 2e-3


def test_between_two_lines_a_corner_is_rounded() -> None:
    """Up and to the right with 2 mm: the way stays 2·(√2 - 1) off the corner (0, 10)."""
    places = way("#ANG=90 #RND=2\n#ANG=0 X30 Y10")
    assert list(places[-1]) == pytest.approx((30, 10, 0), abs=1e-9)
    assert passes(places, 0.0, 10.0) == pytest.approx(2 * (math.sqrt(2) - 1), abs=1e-3)


def test_each_line_has_the_feed_of_its_block() -> None:
    """F6000 up to the point where they meet, then F3000."""
    run = perform(
        "G90 G17 G01 F6000\n#ANG=0\n#ANG=90 X50 Y50 F3000\nM30", signals=[*POSITIONS, SPEED]
    )
    assert run.errors == ()
    assert run.trace is not None
    places, speeds = positions(run), np.array(run.trace[SPEED])
    assert speeds[places[:, 1] == 0.0].max() == pytest.approx(100.0)
    assert speeds[places[:, 1] > 0.0].max() == pytest.approx(50.0)


def test_commands_between_two_lines_are_executed() -> None:
    """Assignments and comments."""
    places = way("#ANG=45\n; here they meet\nP1 = 20\n#ANG=0 XP1 Y5")
    assert passes(places, 5, 5) < 2e-3
    assert list(places[-1]) == pytest.approx((20, 5, 0), abs=1e-9)


@pytest.mark.parametrize(
    ("program", "number"),
    [
        ("#ANG=60\n#ANG=60 X40 Y30", 21892),
        ("#ANG=60\n#ANG=240 X-40 Y-30", 21892),
        ("#ANG=45 X20 Y25", 21895),
        ("#ANG=30 #RND=3\nG01 X40 Y30", 21904),
        ("#ANG=30", 21904),
        ("#ANG=30\n#ANG=80 X30", 21904),
        ("#ANG=30\nM100", 21904),
        ("#ANG=30\nG91 #ANG=80 X30 Y10", 21910),
        ("G02\n#ANG=30 X5", 901833),
        ("G02 #ANG=30 X5", 901833),
        ("X1\n#ANG=90 X5", 901834),
        ("X1\n#ANG=180 Y5", 901834),
        ("#ANG", 900208),
    ],
)
def test_mistakes(program: str, number: int) -> None:
    run = perform(f"G90 G17 G01 F6000\n{program}\nM30", signals=POSITIONS)
    assert numbers(run) == [number]


def test_a_program_that_ends_with_half_a_line_is_reported() -> None:
    """Without M30, too: no line is lost without a word."""
    assert numbers(perform("G01 F6000\n#ANG=30\n", signals=POSITIONS)) == [21904]


def test_plain_lines_do_not_pass_over_an_open_line() -> None:
    """Long programs are decoded line by line; the line after #ANG still has to end it."""
    lines = [f"X{i % 5} Y{i % 7}" for i in range(3000)]
    program = "\n".join(["G01 F6000", *lines, "#ANG=30", *lines, "M30"])
    assert numbers(perform(program, signals=POSITIONS)) == [21904]

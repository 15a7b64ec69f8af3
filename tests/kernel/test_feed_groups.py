# SPDX-License-Identifier: MIT
"""``#FGROUP``: the axes whose path F applies to (207471243, P-CHAN-00011, P-CHAN-00096)."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from support.kernel_rig import DEMO, controller_with

from nctakt.run.controller import Controller, NcText


def speed(text: str, axis: str = "X", controller: Controller | None = None) -> float:
    """The speed of an axis in mm/s in the middle of the program's last motion."""
    signal = f"{axis}.ACS.ACT_POS"
    controller = controller or Controller(DEMO)
    run = controller.run(NcText("p.nc", text), signals=[signal], ticks=100_000)
    assert run.trace is not None
    assert run.errors == ()
    x = np.asarray(run.trace[signal])
    middle = len(x) // 2
    return abs(float(x[middle] - x[middle - 1])) * 1000


#: The way of 20 degrees at a radius of 60 mm.
TURN = math.radians(20.0) * 60.0


@pytest.mark.parametrize(
    ("group", "expected"),
    [
        # F6000 is 100 mm/s: of the path of X and Y, 3 by 4, of which X has 60.
        ("", 60.0),
        ("#FGROUP [X, Y, Z]", 60.0),
        ("#FGROUP [X, Y]", 60.0),
        ("#FGROUP [X]", 100.0),
        ("#FGROUP [Y]", 75.0),
        # A turns 20 degrees while X moves 30 mm.
        ("#FGROUP [A]", 150.0),
        # No axis of the group moves: F applies as without it.
        ("#FGROUP [Z]", 60.0),
        ("#FGROUP [X]\n#FGROUP", 60.0),
        # Ways count with their factors: 60 mm of X and 40 mm of Y.
        ("#FGROUP [X=2, Y]", 30 / math.hypot(60.0, 40.0) * 100.0),
        ("#FGROUP [X=P1, Y=P1]", 120.0),
        # A of demo has 360 °/s, X and Y 500 mm/s: Y takes the longest.
        ("#FGROUP WAXIS", 75.0),
        ("#FGROUP WAXIS\n#FGROUP [X]", 100.0),
        # A counts at its radius, beside the linear axes or alone.
        ("#FGROUP ROT [AX=A REF=60]", 30 / math.hypot(50.0, TURN) * 100.0),
        ("#FGROUP [A]\n#FGROUP ROT [AX=A REF=60]", 30 / TURN * 100.0),
        ("#FGROUP ROT [AX=A REF=60]\n#FGROUP ROT", 60.0),
    ],
)
def test_the_feed_is_that_of_the_group(group: str, expected: float) -> None:
    """The other axes arrive with those of the group."""
    text = f"P1 = 0.5\n{group}\nG01 X30 Y40 A20 F6000\nM30"
    assert speed(text) == pytest.approx(expected, rel=1e-6)


def test_a_radius_in_inch_and_a_rotary_axis_alone() -> None:
    """F is the speed on the cylinder: 10 mm/s at a radius of one inch."""
    text = "G70\n#FGROUP ROT [AX=A REF=1]\nG71 G01 A90 F600\nM30"
    expected = 10.0 / math.radians(1.0) / 25.4
    assert speed(text, axis="A") == pytest.approx(expected, rel=1e-6)


def test_axes_outside_the_group_keep_their_limits() -> None:
    """F for X alone would be 1000 mm/s of Y, which has 500 at most."""
    assert speed("#FGROUP [X]\nG01 X30 Y300 F6000\nM30") == pytest.approx(50.0, rel=1e-6)


def test_an_arc_counts_as_a_whole() -> None:
    """A half circle with 40 mm of Z: 100 mm/s of the way of X and Y are more of Z."""
    turn = 10.0 * math.pi
    helix = "G01 F6000\nG02 X20 I10 Z40\nM30"
    for group in ("#FGROUP [X, Y]", "#FGROUP [X]"):
        expected = 100.0 * 40.0 / turn
        assert speed(f"{group}\n{helix}", "Z") == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(
    ("entries", "group", "expected"),
    [
        (("gruppe[0].achse[0].default_feed_axis 1",), "", 100.0),
        (("gruppe[0].achse[0].default_feed_axis 1",), "#FGROUP [Y]\n#FGROUP", 100.0),
        (("feed_to_weakest_axis 1",), "", 75.0),
        (("feed_to_weakest_axis 1", "gruppe[0].achse[0].default_feed_axis 1"), "", 75.0),
        (("feed_to_weakest_axis 1",), "#FGROUP [X]", 100.0),
        (("feed_to_weakest_axis 1",), "#FGROUP [X]\n#FGROUP", 75.0),
    ],
)
def test_the_channel_list_names_the_group(
    entries: tuple[str, ...], group: str, expected: float, tmp_path: Path
) -> None:
    """P-CHAN-00011 and P-CHAN-00096 count until a program chooses, and for #FGROUP alone."""
    controller = controller_with(tmp_path, *entries)
    text = f"{group}\nG01 X30 Y40 A20 F6000\nM30"
    assert speed(text, controller=controller) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(
    ("command", "number"),
    [
        ("#FGROUP [B]", 21220),
        ("#FGROUP ROT [A]", 900233),
        ("#FGROUP ROT [AX=A]", 900233),
        ("#FGROUP ROT [AX=A REF=0]", 901831),
        ("#FGROUP ROT [AX=X REF=5]", 901830),
        ("#FGROUP ROT [AX=Q REF=5]", 21220),
        ("#FGROUP [X=0]", 901831),
        ("#FGROUP []", 900233),
        ("#FGROUP WAXIS [X]", 900233),
        ("#FGROUP [X, X]", 21887),
    ],
)
def test_mistakes(command: str, number: int) -> None:
    """Unknown axes, forms without their words, values that are not above 0."""
    run = Controller(DEMO).run(NcText("p.nc", f"{command}\nM30"), signals=["BLOCK"], ticks=10)
    assert [error.id for error in run.errors] == [number]


def test_what_is_decided_is_reported_once() -> None:
    """Notes: the meaning of WAXIS and factors, the default, splines that F ignores groups for."""
    text = (
        "#FGROUP WAXIS\n#FGROUP WAXIS\n#FGROUP [X=2]\n#FGROUP\n#FGROUP\n#FGROUP [X]\n"
        "G01 F1000 X1\nG151 X2\nX3 Y1\nX4\nG150\nM30"
    )
    run = Controller(DEMO).run(NcText("p.nc", text), signals=["BLOCK"], ticks=10_000)
    assert run.errors == ()
    numbers = sorted(finding.id for finding in run.diagnostics)
    assert numbers == [21209, 120462, 901551, 901551, 901551]


def test_a_group_follows_the_axes_through_an_exchange() -> None:
    """Y is given away: X and A stay in the group, whatever their new places."""
    text = "#FGROUP [X=2, Y]\n#FGROUP ROT [AX=A REF=60]\n#PUT AX [Y]\nG01 X30 A20 F6000\nM30"
    assert speed(text) == pytest.approx(30 / math.hypot(60.0, TURN) * 100.0, rel=1e-6)

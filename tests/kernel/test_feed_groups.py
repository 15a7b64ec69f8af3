# SPDX-License-Identifier: MIT
"""``#FGROUP``: the axes whose path F applies to (207471243)."""

from __future__ import annotations

import numpy as np
import pytest
from kernel_rig import DEMO

from nctakt.run.controller import Controller, NcText


def speed(text: str) -> float:
    """The speed of the path in mm/s in the middle of the program's last motion."""
    run = Controller(DEMO).run(NcText("p.nc", text), signals=["X.ACS.ACT_POS"], ticks=100_000)
    assert run.trace is not None
    assert run.errors == ()
    x = np.asarray(run.trace["X.ACS.ACT_POS"])
    middle = len(x) // 2
    return abs(float(x[middle] - x[middle - 1])) * 1000


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
    ],
)
def test_the_feed_is_that_of_the_group(group: str, expected: float) -> None:
    """The other axes arrive with those of the group."""
    assert speed(f"{group}\nG01 X30 Y40 A20 F6000\nM30") == pytest.approx(expected, rel=1e-6)


def test_axes_outside_the_group_keep_their_limits() -> None:
    """F for X alone would be 1000 mm/s of Y, which has 500 at most."""
    assert speed("#FGROUP [X]\nG01 X30 Y300 F6000\nM30") == pytest.approx(50.0, rel=1e-6)


@pytest.mark.parametrize(
    ("command", "number"), [("#FGROUP [B]", 21220), ("#FGROUP ROT [A]", 900200)]
)
def test_other_forms_are_mistakes(command: str, number: int) -> None:
    """Unknown axes; ROT and WAXIS, of which no source settles the formula, are refused."""
    run = Controller(DEMO).run(NcText("p.nc", f"{command}\nM30"), signals=["BLOCK"], ticks=10)
    assert [error.id for error in run.errors] == [number]

# SPDX-License-Identifier: MIT
"""Backward over ``#TRAFO``: MCS is that of the transformation in force there (MO-7, MO-8)."""

from __future__ import annotations

from pathlib import Path

import pytest

import nctakt
from nctakt.run.controller import Controller, NcText

DEMO5 = Path(nctakt.__file__).parent / "machines" / "demo5"
PROGRAM = """N10 G01 X10 Z300 A30 F20000
N20 X20
N25 #TRAFO ON
N30 X30
N35 #PTP ON
N40 X40
N45 #TRAFO OFF
N50 X50
N60 X60
N70 #TIME 9
M30
"""


def positions(controller: Controller) -> tuple[float, float]:
    """X, and how far MCS is from ACS in Y: 75 mm for the head with A at 30°."""
    x, mcs, acs = (
        float(controller.read(f"V.RTA.{name}"))
        for name in ("ACS.ACT_POS.X", "MCS.ACT_POS.Y", "ACS.ACT_POS.Y")
    )
    return x, mcs - acs


def shifts(controller: Controller, ticks: int) -> list[tuple[float, float]]:
    """The positions in the ticks to come."""
    found = []
    for _ in range(ticks):
        controller.step(1)
        found.append(positions(controller))
    return found


def test_mcs_is_that_of_the_block_backward_and_forward_again() -> None:
    """Also under #PTP, whose motions are those of the axes, and at the front again."""
    controller = Controller(DEMO5)
    controller.start(NcText("p.nc", PROGRAM))
    shifts(controller, 2000)
    assert positions(controller) == pytest.approx((60.0, 0.0))
    controller.backward()
    walked = shifts(controller, 2000)
    assert walked[-1] == pytest.approx((0.0, 0.0), abs=1e-9)
    controller.forward()
    again = shifts(controller, 2000)
    assert again[-1] == pytest.approx((60.0, 0.0))
    for x, shift in (*walked, *again):
        if min(abs(x - border) for border in (20.0, 40.0)) > 1e-6:
            assert shift == pytest.approx(75.0 if 20.0 < x < 40.0 else 0.0, abs=1e-9), x


def test_front_inside_a_transformation_is_shown_as_before() -> None:
    """Back over #TRAFO ON and forward to the middle of a block; a reset leaves nothing behind."""
    controller = Controller(DEMO5)
    controller.start(NcText("p.nc", PROGRAM.replace("N30 X30", "N30 X30 F60")))
    while positions(controller)[0] < 25.0:
        controller.step(10)
    controller.backward()
    while positions(controller)[0] > 12.0:
        controller.step(10)
    assert positions(controller)[1] == 0.0
    controller.forward()
    while positions(controller)[0] < 26.0:
        controller.step(10)
    assert positions(controller)[1] == pytest.approx(75.0)

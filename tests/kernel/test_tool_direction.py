# SPDX-License-Identifier: MIT
"""TOOL.DIRECTION: where the tool points in each tick, from its tip to its clamp (MO-8)."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from support.stepped_machine import DEMO5, machine_with_steps

from nctakt.run.controller import Controller, NcText

NAMES = ["TOOL.DIRECTION.X", "TOOL.DIRECTION.Y", "TOOL.DIRECTION.Z"]


def test_direction_is_that_of_the_rotary_axes_in_each_tick() -> None:
    """The head of demo5 turns A about X, then C about Z: (sin c sin a, −cos c sin a, cos a)."""
    text = "D1\n#TRAFO ON\nG00 X10 Y10 Z20\nG01 X60 A30 C90 F4000\nM30\n"
    signals = [*NAMES, "C.ACS.ACT_POS", "A.ACS.ACT_POS"]
    trace = Controller(DEMO5).run(NcText("p.nc", text), signals=signals).trace
    moved = 0
    for row in range(3, len(trace.tick)):
        c, a = (math.radians(trace[f"{axis}.ACS.ACT_POS"][row]) for axis in "CA")
        expected = [math.sin(c) * math.sin(a), -math.cos(c) * math.sin(a), math.cos(a)]
        assert [trace[name][row] for name in NAMES] == pytest.approx(expected, abs=1e-12)
        moved += 0 < a < math.radians(30)
    assert moved > 100


def test_without_a_transformation_no_direction_is_given() -> None:
    """Before #TRAFO ON, and from #TRAFO OFF on, all three are 0."""
    text = "D1\nA20\n#TRAFO ON\nG04 X5\n#TRAFO OFF\nG04 X5\nM30\n"
    trace = Controller(DEMO5).run(NcText("p.nc", text), signals=NAMES).trace
    sizes = [round(math.hypot(*(trace[name][row] for name in NAMES)), 12) for row in
             range(len(trace.tick))]  # fmt: skip
    assert sizes[0] == sizes[-1] == 0.0
    assert set(sizes) == {0.0, 1.0}
    assert sizes.count(1.0) > 3


def test_two_steps_give_no_direction(tmp_path: Path) -> None:
    """What a second step makes of the direction is not said, so none is given."""
    machine = machine_with_steps(tmp_path / "machine")
    text = "D1\n#KIN ID [91, 340]\n#TRAFO ON\nG01 A20 F1000\nM30\n"
    trace = Controller(machine).run(NcText("p.nc", text), signals=[*NAMES, "Z.MCS.ACT_POS"]).trace
    assert trace["Z.MCS.ACT_POS"].max() != trace["Z.MCS.ACT_POS"].min()
    assert not any(trace[name].any() for name in NAMES)

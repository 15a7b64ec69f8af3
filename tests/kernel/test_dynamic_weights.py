# SPDX-License-Identifier: MIT
"""``#DYNAMIC WEIGHT``, P-CHAN-00190 … 194, P-CHAN-00230 … 234: weights by length and radius.

The demo machine (MO-15): 500 mm/s, 4000 mm/s², tick 1 ms.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from support.kernel_rig import controller_with

from nctakt.lists.machine.machine import Machine
from nctakt.run.controller import Controller, NcText

ROWS = (
    "dynamic_weighting[0].path_limit 500000",
    "dynamic_weighting[0].velocity_fact 200",
    "dynamic_weighting[0].acceleration_fact 250",
    "dynamic_weighting[1].path_limit 2000000",
    "dynamic_weighting[1].velocity_fact 400",
    "curve_dynamic_weighting[0].radius_limit 200000",
    "curve_dynamic_weighting[0].velocity_fact 100",
    "curve_dynamic_weighting[0].acceleration_fact 2000",
)
#: Up to this speed 49 mm suffice for 4000 mm/s².
FREE = math.sqrt(49.0 * 4000.0)


@pytest.fixture(scope="module", name="machines")
def fixture_machines(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Machine]:
    """Machines by P-CHAN-00190; with curves on from 1 on."""
    return {
        motions: controller_with(
            tmp_path_factory.mktemp(f"m{motions}"),
            *ROWS,
            f"dynamic_weighting_active {motions}",
            f"curve_dynamic_weighting_active {int(motions > 0)}",
        ).machine
        for motions in range(4)
    }


def fastest(machine: Machine, text: str) -> tuple[float, float]:
    """The greatest speed in mm/s and acceleration in mm/s² of the block N9."""
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "BLOCK"]
    program = NcText("p.nc", f"{text}\nM30")
    run = Controller(machine).run(program, signals=signals, ticks=100_000)
    assert run.errors == ()
    assert run.trace is not None
    speed = np.hypot(*(np.diff(np.asarray(run.trace[name])) for name in signals[:2])) * 1000
    speed = speed[np.asarray(run.trace["BLOCK"])[1:] == 9]
    return float(speed.max()), float(np.abs(np.diff(speed)).max() * 1000)


@pytest.mark.parametrize(
    ("motions", "before", "motion", "speed", "acceleration"),
    [
        # Rows below 50 mm and below 200 mm; a length at a limit takes the next row.
        (1, "", "G00 X49", 100.0, 1000.0),
        (1, "", "G00 X50", 200.0, 4000.0),
        (1, "", "G00 X250", 500.0, 4000.0),
        (1, "", "G01 X49 F30000", FREE, 4000.0),
        (2, "", "G01 X49 F30000", 100.0, 1000.0),
        (2, "", "G00 X49", FREE, 4000.0),
        (3, "", "G00 X30 Y20", 100.0 * math.hypot(30, 20) / 30, 1000.0 * math.hypot(30, 20) / 30),
        (3, "", "G01 X30 F30000", 100.0, 1000.0),
        (3, "#DYNAMIC WEIGHT OFF [PATH]", "G00 X49", FREE, 4000.0),
        (0, "", "G00 X49", FREE, 4000.0),
        (0, "#DYNAMIC WEIGHT ON [PATH]", "G01 X49 F30000", 100.0, 1000.0),
        (0, "#DYNAMIC WEIGHT ON [CURVE]", "G01 X49 F30000", FREE, 4000.0),
        # Other weights multiply: 50 % of 1000 mm/s².
        (2, "G131=50", "G01 X49 F30000", 100.0, 500.0),
    ],
)
def test_short_motions_have_weights(
    machines: dict[int, Machine],
    motions: int,
    before: str,
    motion: str,
    speed: float,
    acceleration: float,
) -> None:
    """Speed and acceleration of a motion by its length (149436171, 207692555)."""
    found = fastest(machines[motions], f"{before}\nN9 {motion} G60")
    assert found[0] == pytest.approx(speed, rel=0.06)
    assert found[0] <= speed * (1 + 1e-6) or speed == FREE
    assert found[1] <= acceleration * 1.01
    assert found[1] >= acceleration * 0.9


@pytest.mark.parametrize(
    ("motions", "before", "radius", "speed"),
    [
        (1, "", 19, 50.0),
        (1, "", 20, 301.0),
        (1, "#DYNAMIC WEIGHT OFF [CURVE PATH]", 19, 293.0),
        (0, "#DYNAMIC WEIGHT ON [CURVE]", 19, 50.0),
    ],
)
def test_small_arcs_have_weights(
    machines: dict[int, Machine], motions: int, before: str, radius: int, speed: float
) -> None:
    """The speed on an arc by its radius, never above that of the lists (149448459)."""
    found = fastest(machines[motions], f"{before}\nN9 G03 X0 Y0 I{radius} F30000")
    assert found[0] == pytest.approx(speed, rel=0.15)
    if speed == 50.0:
        assert found[0] <= 50.0 * (1 + 1e-6)


def test_a_block_without_a_row_is_not_weighted(machines: dict[int, Machine]) -> None:
    """After a short block the limits of the lists are back, and a program starts with them."""
    text = "G01 X30 F30000\nN9 G01 G60 X300 F30000"
    assert fastest(machines[2], text)[0] == pytest.approx(500.0)
    assert fastest(machines[2], "G00 X49\nN9 G00 X300")[0] == pytest.approx(500.0)


@pytest.mark.parametrize(
    ("command", "number"),
    [
        ("#DYNAMIC WEIGHT ON", 900233),
        ("#DYNAMIC WEIGHT ON [LENGTH]", 900706),
        ("#DYNAMIC WEIGHT", 900233),
        ("#DYNAMIC WEIGHT OFF [PATH=1]", 900706),
    ],
)
def test_mistakes(machines: dict[int, Machine], command: str, number: int) -> None:
    """One of PATH and CURVE is needed."""
    program = NcText("p.nc", f"{command}\nM30")
    run = Controller(machines[0]).run(program, signals=["BLOCK"], ticks=10)
    assert [error.id for error in run.errors] == [number]


@pytest.mark.parametrize(
    "entries",
    [
        ("dynamic_weighting[0].path_limit 0", "dynamic_weighting[0].velocity_fact 500"),
        ("dynamic_weighting[0].path_limit 9", "dynamic_weighting[0].velocity_fact 9"),
        ("dynamic_weighting[0].path_limit 9", "dynamic_weighting[1].path_limit 9"),
    ],
)
def test_rows_that_are_not_valid(entries: tuple[str, ...], tmp_path: Path) -> None:
    """Limits ascend, weights are 1 % at least: 21538."""
    machine = controller_with(tmp_path, *entries).machine
    assert 21538 in {found.id for found in machine.diagnostics}

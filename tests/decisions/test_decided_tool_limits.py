# SPDX-License-Identifier: MIT
"""Decisions on the limits that tools bring for their spindle (P-TOOL-00012 … 00015).

Public manuals, "tool-related dynamic limiting for spindles": they act from the next start of the
spindle on, the least speed only on endless rotation, and stay until another tool has others.
Demo machine: S (5) has 4000 degrees/s² and up to 8000 1/min, S2 (6) likewise.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.decided import numbers, perform
from support.run_folders import changed_machine

from nctakt.results.run import Run
from nctakt.run.controller import Controller

TOOLS = """\
wz[6].gueltig 1
wz[6].log_ax_nr_spdl 5
wz[6].vb_min 600000
wz[6].vb_max 3000000
wz[6].a_max 2000
wz[7].gueltig 1
wz[7].log_ax_nr_spdl 5
wz[7].vb_max 1200000
wz[8].gueltig 1
wz[8].log_ax_nr_spdl 0
wz[8].vb_max 6000
""".splitlines()


@pytest.fixture(scope="module", name="controller")
def fixture_controller(tmp_path_factory: pytest.TempPathFactory) -> Controller:
    """The demo machine with tools: 6 turns S with 100 … 500 1/min, 7 with up to 200, 8 nothing."""
    folder = tmp_path_factory.mktemp("tools") / "machine"
    return Controller(changed_machine({"werkz_d1.lis": TOOLS}, folder))


def turned(controller: Controller, program: str) -> tuple[Run, list[float]]:
    """A run, and the speed of S in each tick in 1/min."""
    run = perform(f"{program}\nM30", controller, signals=["S.SPEED"])
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    return run, run.trace["S.SPEED"].tolist()


@pytest.mark.parametrize(
    ("program", "speed"),
    [
        ("D6\nM3 S1000", 500.0),
        ("D6\nM4 S1000", -500.0),
        ("D6\nM3 S300", 300.0),
        ("D6\nM3 S20", 100.0),
        ("D6\nM3 S0", 0.0),
        ("D8\nM3 S1000", 1000.0),
        ("D6\nD0\nM3 S1000", 500.0),
        ("D6\nD8\nM3 S1000", 500.0),
        ("D7\nM3 S20", 20.0),
        ("M3 S1000\nG04 2\nD7\nS900", 900.0),
        ("M3 S1000\nG04 2\nM5\nG04 2\nD7\nM3 S900", 200.0),
    ],
)
def test_speeds(program: str, speed: float, tmp_path: Path) -> None:
    """In 1/min, some seconds later."""
    machine = changed_machine({"werkz_d1.lis": TOOLS}, tmp_path / "machine")
    _, speeds = turned(Controller(machine), f"{program}\nG04 2")
    assert speeds[-2] == pytest.approx(speed)


def test_the_acceleration_of_the_tool(tmp_path: Path) -> None:
    """2000 degrees/s²: 333.3 1/min more in each second; M19 turns slower than the least speed."""
    machine = changed_machine({"werkz_d1.lis": TOOLS}, tmp_path / "machine")
    _, speeds = turned(Controller(machine), "D6\nM3 S400\nG04 2\nM5\nG04 2\nM19 S50 S.POS90\nG04 2")
    assert np.abs(np.diff(speeds)).max() == pytest.approx(2000 / 6 / 1000)
    assert 0.0 < np.abs(speeds[4100:]).max() <= 50.0


def test_the_limits_outlive_the_program(tmp_path: Path) -> None:
    """Choice: they are modal in the spindle until another tool."""
    machine = changed_machine({"werkz_d1.lis": TOOLS}, tmp_path / "machine")
    controller = Controller(machine)
    turned(controller, "D6")
    _, speeds = turned(controller, "M3 S1000\nG04 2\nM5\nG04 2")
    assert max(speeds) == pytest.approx(500.0)


def test_a_speed_beyond_them_is_an_error_by_the_list(tmp_path: Path) -> None:
    """P-AXIS-00474: 60312 for endless jobs beyond 100 … 500 1/min, with the override."""
    changes = {
        "werkz_d1.lis": TOOLS,
        "achs_mds5.lis": ["kenngr.check_spindle_speed_in_tool_range 1"],
    }
    machine = changed_machine(changes, tmp_path / "machine")
    for program, expected in (
        ("M3 S1000", []),
        ("D6\nM3 S1000", [60312]),
        ("D6\nM4 S99", [60312]),
        ("D6\nM3 S100\nS500\nM5\nM19 S50 S.POS10", []),
        ("D6\nM3 S400\nS[OVERRIDE SPEED_FACT=150]", [60312]),
        ("D7\nM3 S20", []),
        ("D7\nM3 S201", [60312]),
    ):
        assert numbers(perform(f"{program}\nM30", Controller(machine))) == expected, program


def test_programs_read_them(controller: Controller) -> None:
    """V.G.WZ: in the units of the list."""
    values = "V.G.WZ[6].S_MIN_SPEED, V.G.WZ[6].S_MAX_SPEED, V.G.WZ_AKT.S_MAX_ACC"
    run, _ = turned(controller, f'D6\n#MSG ["%d %d %d", {values}]')
    assert [event.text for event in run.messages] == ["600000 3000000 2000"]
    assert numbers(perform("V.G.WZ[6].S_MAX_ACC = 1\nM30", controller)) != []

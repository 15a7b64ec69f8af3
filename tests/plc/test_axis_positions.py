# SPDX-License-Identifier: MIT
"""MC_Home, MC_SetPosition, MC_SetOverride, MC_ReadParameter of a PLC in Structured Text (ST-744).

T = 1 ms; the axis A has 4000°/s². After k increments of the acceleration it has moved by 0.002 · k²
degrees, after 25 of them by 1.25, at 100°/s; then by 0.1 in each.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from support.plc_rig import loaded, values_in_main

from nctakt.lists.machine.axis_configuration import AxisHoming
from nctakt.lists.machine.machine import load_machine
from nctakt.plc.structured_text import StructuredPlc
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

CNC = """PROGRAM MAIN
VAR
    A : AXIS_REF;
    fbPower : MC_Power;
    fbMove : MC_MoveAbsolute;
    fbHalt : MC_Halt;
    fbHome : MC_Home;
    fbInfo : MC_ReadAxisInfo;
    fbStatus : MC_ReadStatus;
    fbPosition : MC_SetPosition;
    fbOverride : MC_SetOverride;
    fbRead : MC_ReadParameter;
    n, nDone, nHoming, nMoved : UDINT;
END_VAR
fbPower(Axis := A, Enable := TRUE, Enable_Positive := TRUE, Enable_Negative := TRUE);
fbStatus(Axis := A, Enable := TRUE);
IF fbStatus.Homing THEN nHoming := nHoming + 1; END_IF
{body}
n := n + 1;
END_PROGRAM
"""
#: 3° to the zero pulse at 100°/s; the axis needs 1.25° more to stop, and has 250° at the pulse.
HOMING = AxisHoming(distance=-3.0, speed=100.0, position=250.0)


def run_with(
    folder: Path, body: str, ticks: int, program: str = "G04 1\nM30", homing: AxisHoming = HOMING
) -> tuple[list[float], StructuredPlc, Run]:
    """The positions of A after each tick, the PLC afterwards, the run."""
    plc = loaded(folder, CNC.format(body=body))
    demo = load_machine(None)
    axes = [replace(one, homing=homing) if one.name == "A" else one for one in demo.axes]
    machine = Controller(replace(demo, axes=tuple(axes)))
    run = machine.run(NcText("part.nc", program), plc=plc, ticks=ticks, signals=["A.ACS.ACT_POS"])
    return [round(float(one), 6) for one in run.trace["A.ACS.ACT_POS"]], plc, run


HOME = """fbHome(Axis := A, Execute := n >= 5);
IF fbHome.Done AND nDone = 0 THEN nDone := n; END_IF
fbInfo(Axis := A, Enable := TRUE);"""


def test_a_plc_homes_an_axis(tmp_path: Path) -> None:
    """4.25° / (100°/s) + 100 / 4000 s = 67.5 ms: 68 increments from tick 6 on, Done in cycle 73.

    The axis is 1.25° beyond the zero pulse, towards the negative side: 250 - 1.25. Its positions
    are shown from 0 to 360°.
    """
    reads = '#MSG ["%d %f", V.A.RERF.A, V.A.REF.A]\n'
    a, plc, run = run_with(tmp_path, HOME, 1100, f"{reads}G04 1\n#FLUSH WAIT\n{reads}M30")
    assert [a[tick] for tick in (5, 6, 30, 72, 73, 1000)] == [
        0.0, 359.998, 358.75, 355.7505, 248.75, 248.75,
    ]  # fmt: skip
    assert [one.text for one in run.messages] == ["0 0.000000", "1 250.000000"]
    assert values_in_main(plc, "nDone", "nHoming", "fbInfo.IsHomed", "fbStatus.Standstill") == [
        73, 67, True, True,
    ]  # fmt: skip


def test_a_halted_homing_leaves_the_axis_where_it_is(tmp_path: Path) -> None:
    """Stopped in cycle 40: 1.25 + 10 · 0.1 = 2.25 back from 0, and 1.25 to brake."""
    body = f"{HOME} fbHalt(Axis := A, Execute := n >= 40);"
    a, plc, _ = run_with(tmp_path, body, 100)
    assert [a[tick] for tick in (40, 65, 99)] == [357.75, 356.5, 356.5]
    names = ("fbHome.Done", "fbHome.CommandAborted", "fbHalt.Done", "fbInfo.IsHomed")
    assert values_in_main(plc, *names) == [False, True, True, False]


@pytest.mark.parametrize("is_allowed", [True, False])
def test_an_axis_that_moves_or_must_not_be_homed_is_refused(
    tmp_path: Path, *, is_allowed: bool
) -> None:
    """902860 while it moves, and 50686 by P-AXIS-00299; the motion goes on."""
    body = f"fbMove(Axis := A, Execute := n >= 2, Position := 200_000, Velocity := 100_000); {HOME}"
    if not is_allowed:
        body = HOME
    homing = replace(HOMING, is_allowed=is_allowed)
    a, plc, _ = run_with(tmp_path, body, 300, homing=homing)
    assert a[299] == (20.0 if is_allowed else 0.0)
    assert values_in_main(plc, "fbHome.Error", "fbHome.ErrorID", "fbInfo.IsHomed") == [
        True, 65535 if is_allowed else 50686, False,
    ]  # fmt: skip
    assert plc.read("MAIN.fbHome.fbMotion.ErrorID") == (902860 if is_allowed else 50686)


def test_a_position_is_set_without_motion(tmp_path: Path) -> None:
    """Execute rises in cycle 5: tick 6 has the position, Done after it; the path leaves it."""
    body = "fbPosition(Axis := A, Execute := n >= 5, Position := 123_0000); "
    body += "IF fbPosition.Done AND nDone = 0 THEN nDone := n; END_IF"
    a, plc, run = run_with(tmp_path, body, 200, "G01 X2 F6000\nG04 1\nM30")
    assert [a[tick] for tick in (5, 6, 199)] == [0.0, 123.0, 123.0]
    assert values_in_main(plc, "nDone", "fbPosition.Error") == [6, False]
    assert run.diagnostics == ()


def test_a_block_never_jumps_to_a_position_that_the_plc_has_set(tmp_path: Path) -> None:
    """MO-13: a block that moves the axis begins elsewhere: 900420, and nothing moves."""
    body = "fbPosition(Axis := A, Execute := n >= 5, Position := 123_0000);"
    a, _, run = run_with(tmp_path, body, 400, "G01 X2 F6000\nG04 0.1\nG01 A10 F6000\nM30")
    assert 900420 in [one.message.id for one in run.diagnostics]
    assert set(a[6:]) == {123.0}


def test_a_position_set_in_motion_takes_the_target_along(tmp_path: Path) -> None:
    """20° from tick 6 on; in cycle 105 at 8.75 the place becomes 100: 11.25° are left."""
    body = """fbMove(Axis := A, Execute := n >= 5, Position := 20_0000, Velocity := 100_000);
fbPosition(Axis := A, Execute := n >= 105, Position := 100_0000);
IF fbMove.Done AND nMoved = 0 THEN nMoved := n; END_IF"""
    a, plc, _ = run_with(tmp_path, body, 300)
    assert [a[tick] for tick in (105, 106, 230, 299)] == [8.75, 100.1, 111.25, 111.25]
    assert values_in_main(plc, "nMoved", "fbPosition.Done") == [230, True]


def test_an_override_of_the_plc_slows_down_and_stops(tmp_path: Path) -> None:
    """100°/s times 0.5 are 50: 0.05° in each tick; by 0 the axis waits, and then goes on."""
    body = """fbMove(Axis := A, Execute := n >= 5, Position := 20_0000, Velocity := 100_000);
fbOverride(Axis := A, Enable := n < 400, VelFactor := SEL(n >= 100 AND n < 300, 0.5, 0.0));
IF fbMove.Done AND nMoved = 0 THEN nMoved := n; END_IF"""
    a, plc, _ = run_with(tmp_path, body, 900)
    assert a[105] - a[104] < 0.05
    assert round(a[60] - a[59], 6) == 0.05
    assert a[150] == a[299]
    assert a[320] > a[299]
    assert a[899] == 20.0
    assert values_in_main(plc, "fbMove.Done", "fbOverride.Enabled") == [True, False]


@pytest.mark.parametrize(("pins", "number"), [
    ("VelFactor := 1.5", 900657),
    ("VelFactor := -0.1", 900657),
    ("VelFactor := 1, AccFactor := 0.5", 902861),
])  # fmt: skip
def test_a_factor_that_is_not_there_is_an_error(tmp_path: Path, pins: str, number: int) -> None:
    """ST-744: its number is beyond 16 bits in the CNC's library."""
    _, plc, _ = run_with(tmp_path, f"fbOverride(Axis := A, Enable := TRUE, {pins});", 10)
    names = ("fbOverride.Enabled", "fbOverride.ErrorID", "fbOverride.fbFactor.ErrorID")
    assert values_in_main(plc, *names) == [False, 65535, number]


def test_parameters_have_plcopens_numbers(tmp_path: Path) -> None:
    """Acceleration 4000°/s² (12); 5 is not there."""
    body = "fbRead(Axis := A, Enable := TRUE, ParameterNumber := SEL(n < 5, 5, 12));"
    _, plc, _ = run_with(tmp_path, body, 4)
    assert values_in_main(plc, "fbRead.Valid", "fbRead.Value") == [True, 4000.0]
    _, plc, _ = run_with(tmp_path, body, 9)
    assert plc.read("MAIN.fbRead.fbParameter.ErrorID") == 902862

# SPDX-License-Identifier: MIT
"""What the NC writes into an AXIS_REF of Tc2_MC2, and what reads it (ST-742, ST-744).

T = 1 ms; the axis A has 4000°/s². From rest it moves by 0.002 · (2k - 1) degrees in its k-th
increment: on average at 4k - 2 °/s, up to 100°/s.
"""

from __future__ import annotations

from pathlib import Path

from support.plc_rig import nc_axis, run, values_in_main

from nctakt.plc.structured_text import StructuredPlc, load_structured
from nctakt.run.controller import Controller, NcText

AXIS = """PROGRAM MAIN
VAR
    A, C : AXIS_REF;
    fbPower : MC_Power;
    fbMove : MC_MoveRelative;
    fbEndless : MC_MoveVelocity;
    fbStop : MC_Stop;
    fbSet : MC_SetPosition;
    fbSpeed : MC_ReadActualVelocity;
    fbStatus : MC_ReadStatus;
    n : UDINT;
END_VAR"""
MOVES = """fbPower(Axis := A, Enable := TRUE);
fbMove(Axis := A, Execute := n >= 5, Distance := 10.0, Velocity := 100.0);
fbSpeed(Axis := A, Enable := TRUE);
fbStatus(Axis := A, Enable := TRUE);
n := n + 1;"""


def traced(
    folder: Path, body: str, ticks: int, *names: str
) -> tuple[list[list[float]], StructuredPlc]:
    """Values of variables of MAIN after each tick, and the PLC afterwards."""
    plc = load_structured(nc_axis(folder, AXIS, body), {"MAIN.C": "X"})
    trace = run(plc, ticks, [f"MAIN.{name}" for name in names]).trace
    return [[round(float(one), 6) for one in trace[f"MAIN.{name}"]] for name in names], plc


def test_positions_speeds_and_accelerations_of_a_motion(tmp_path: Path) -> None:
    """ST-742: 25 increments faster, 75 at 100°/s, 25 slower; before the cycle of each tick."""
    names = ("ActPos", "SetPos", "TargetPos", "PosDiff", "ActVelo", "SetVelo", "SetAcc", "ActAcc")
    found, _ = traced(tmp_path, MOVES, 140, *(f"A.NcToPlc.{name}" for name in names))
    actual, command, target, lag, actual_v, command_v, command_a, actual_a = found
    assert actual == command
    assert (actual_v, actual_a) == (command_v, command_a)
    assert set(lag) == {0.0}
    assert [command[5], command[6], command[7], command[30]] == [0.0, 0.002, 0.008, 1.25]
    assert [target[4], target[6], target[139]] == [0.0, 10.0, 10.0]
    assert command_v[5:9] == [0.0, 2.0, 6.0, 10.0]
    assert [command_v[30], command_v[31], command_v[80]] == [98.0, 100.0, 100.0]
    assert command_a[6:9] == [2000.0, 4000.0, 4000.0]
    assert [command_a[80], command_a[110], command_a[139]] == [0.0, -4000.0, 0.0]
    assert command_v[139] == 0.0


def test_bits_of_an_axis_and_their_names(tmp_path: Path) -> None:
    """ST-742: the published bits of StateDWord; MC_ReadStatus fills Status with their names."""
    names = ["A.NcToPlc.StateDWord", "fbStatus.Accelerating", "fbStatus.ConstantVelocity"]
    names += ["fbStatus.Decelerating", "fbSpeed.ActualVelocity", "A.Status.CycleCounter"]
    found, plc = traced(tmp_path, MOVES, 140, *names)
    bits = [{bit for bit in range(32) if int(word) >> bit & 1} for word in found[0]]
    on, job, up, even = {0, 20}, 8, 9, 12
    assert bits[3] == on | {2}
    assert bits[15] == on | {job, up}
    assert bits[80] == on | {job, up, even}
    assert bits[139] == on | {2}
    assert [[one[tick] for one in found[1:4]] for tick in (3, 15, 80, 110, 139)] == [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
        [0, 0, 0],
    ]
    assert found[4][80] == 100.0
    assert found[5][-1] == 140
    states = ("MotionState", "NotMoving", "Moving", "HasJob", "StandStill", "Operational")
    assert values_in_main(plc, *(f"A.Status.{name}" for name in states)) == [
        "MC_AxisStates.MC_AXISSTATE_STANDSTILL",
        True,
        False,
        False,
        True,
        True,
    ]


def test_phases_of_a_motion_and_modes_of_an_axis(tmp_path: Path) -> None:
    """ST-742: AxisState as published: inactive, constant speed, faster, slower; modes by lists.

    A is a modulo axis without software limits, X has both of them.
    """
    names = ["A.NcToPlc.AxisState", "A.NcToPlc.ModuloActPos", "A.NcToPlc.ActPos"]
    found, plc = traced(tmp_path, f"{MOVES}\nA.ReadStatus(); C.ReadStatus();", 140, *names)
    assert [found[0][tick] for tick in (3, 15, 80, 110, 139)] == [0, 4, 3, 5, 0]
    assert found[1] == found[2]
    modes = values_in_main(plc, "A.NcToPlc.OpModeDWord", "C.NcToPlc.OpModeDWord")
    assert modes == [1 << 7, 1 << 18 | 1 << 19]
    names = ["Modulo", "SoftLimitMinMonitoring", "SoftLimitMaxMonitoring"]
    of_a, of_c = (
        values_in_main(plc, *(f"{one}.Status.OpMode.{name}" for name in names)) for one in "AC"
    )
    assert (of_a, of_c) == ([True, False, False], [False, True, True])


def test_a_motion_downwards_has_the_same_phases(tmp_path: Path) -> None:
    """ST-742: faster and slower mean the speed, not its sign; positions stay in the range."""
    body = MOVES.replace("Distance := 10.0", "Distance := -10.0")
    found, _ = traced(tmp_path, body, 140, "A.NcToPlc.AxisState", "A.NcToPlc.ModuloSetPos")
    assert [found[0][tick] for tick in (3, 15, 80, 110, 139)] == [0, 4, 3, 5, 0]
    assert found[1][139] == 350.0


def test_states_of_endless_motion_stop_and_an_axis_without_power(tmp_path: Path) -> None:
    """ST-744: by ReadStatus() or a call of the reference; MC_Stop keeps an axis that is at rest."""
    body = """fbPower(Axis := A, Enable := TRUE);
fbEndless(Axis := A, Execute := n >= 5, Velocity := 100.0, Direction := MC_Negative_Direction);
fbStop(Axis := A, Execute := n >= 60);
A.ReadStatus();
C();
n := n + 1;"""
    names = ("A.Status.MotionState", "A.NcToPlc.StateDWord", "A.NcToPlc.SetVelo", "fbStop.Done")
    found, plc = traced(tmp_path, body, 130, *names)
    assert [found[0][tick] for tick in (3, 40, 70, 129)] == [2, 7, 4, 4]
    assert found[3][129]
    word = int(found[1][40])
    assert [word >> bit & 1 for bit in (8, 9, 10, 12, 19)] == [1, 0, 1, 1, 1]
    assert [found[2][40], found[2][129]] == [-100.0, 0.0]
    assert plc.read("MAIN.C.Status.MotionState") == "MC_AxisStates.MC_AXISSTATE_DISABLED"
    assert plc.read("MAIN.C.NcToPlc.StateDWord") == 4


def test_a_given_position_is_no_motion(tmp_path: Path) -> None:
    """ST-744: MC_SetPosition moves the numbers and not the axis."""
    body = """fbPower(Axis := A, Enable := TRUE);
fbSet(Axis := A, Execute := n >= 5, Position := 30.0);
n := n + 1;"""
    found, _ = traced(tmp_path, body, 20, "A.NcToPlc.ActPos", "A.NcToPlc.ActVelo")
    assert [found[0][0], found[0][-1]] == [0.0, 30.0]
    assert set(found[1]) == {0.0}


def test_a_position_given_in_motion_keeps_the_speed(tmp_path: Path) -> None:
    """ST-744: at 100°/s the number of the position changes at once, which is no speed."""
    body = """fbPower(Axis := A, Enable := TRUE);
fbEndless(Axis := A, Execute := n >= 5, Velocity := 100.0, Direction := MC_Positive_Direction);
fbSet(Axis := A, Execute := n >= 60, Position := 200.0);
n := n + 1;"""
    found, _ = traced(tmp_path, body, 80, "A.NcToPlc.ActPos", "A.NcToPlc.ActVelo")
    assert found[0][70] > 200.0
    assert max(found[1]) == 100.0
    assert set(found[1][40:]) == {100.0}


def test_an_axis_that_the_cnc_moves_has_its_speed_there_too(tmp_path: Path) -> None:
    """ST-742: X moves by a program at 6000 mm/min; the PLC only looks."""
    plc = load_structured(nc_axis(tmp_path, AXIS, "C.ReadStatus();\nn := n + 1;"), {"MAIN.C": "X"})
    names = ["MAIN.C.NcToPlc.SetVelo", "MAIN.C.Status.MotionState"]
    program = NcText("part.nc", "N10 G01 X50 F6000\nM30\n")
    trace = Controller().run(program, plc=plc, ticks=250, signals=names).trace
    assert round(float(trace[names[0]][150]), 6) == 100.0
    assert int(trace[names[1]][150]) == 8


def test_what_the_nc_writes_costs_the_plc_no_time(tmp_path: Path) -> None:
    """ST-830: of 1 µs each, elementary instructions are those of the PLC's own code, here six."""
    (tmp_path / "nctakt.toml").write_text("[plc]\ninstruction_time = 1000\n", "utf-8")
    body = "n := TwinCAT_SystemInfoVarList._TaskInfo[1].LastExecTime;"
    found, _ = traced(tmp_path, body, 5, "n")
    assert found[0][-1] == 60.0

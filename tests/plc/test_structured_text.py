# SPDX-License-Identifier: MIT
"""A PLC in Structured Text beside the CNC: interface, functions, axes, V.E, several PLCs.

The values are worked out by hand from the rules: T = 1 ms; cycle n is that after tick n (ST-801),
and what it writes counts from tick n + 1 on (RC-002).
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from support.changed_lists import machine_with
from support.plc_rig import EACH_TICK, loaded, nc_axis, values_in_main

from nctakt.base.failure import Failure
from nctakt.hli.variables_memory import describe
from nctakt.lists.machine.machine import load_machine
from nctakt.plc import Plc, on
from nctakt.plc.error import PlcError
from nctakt.plc.structured_text import StructuredPlc, load_structured
from nctakt.results.run import Run
from nctakt.run.access.inputs import unpack
from nctakt.run.access.stimuli import Stimulus, StimulusLike, parse_stimulus
from nctakt.run.access.tape import Tape
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import AnyPlc, PlcView
from nctakt.run.plcs.realtime_plc import PlcGroup
from nctakt.testing.expectations import read_expectation
from nctakt.testing.queries import NcRun
from nctakt.testing.verdict import differences

OPEN = "IF NOT fbHli.Initialized THEN fbHli(); RETURN; END_IF\n"


def program(variables: str, body: str) -> str:
    """A program that opens the interface in its first two cycles."""
    return (
        f"PROGRAM MAIN VAR fbHli : MCV_HliInterface; {variables} END_VAR {OPEN}{body} END_PROGRAM"
    )


def run_nc(
    plc: AnyPlc, text: str, ticks: int, signals: Sequence[str], at: Sequence[StimulusLike] = ()
) -> Run:
    """The run of an NC program with a PLC."""
    nc = NcText("part.nc", text)
    return Controller().run(nc, plc=plc, ticks=ticks, signals=list(signals), at=at, blocks=True)


GATE = program(
    """
    bDoor AT %I* : BOOL; nUnit : INT := -1; nSeen : UDINT; nKind : UINT; i : INT;
    nTicksOfOne : UDINT; pData : POINTER TO HLI_M_H_PROZESS;
    """,
    """
gpCh[0]^.head.plc_present_w := TRUE;
IF nUnit < 0 THEN
    FOR i := 0 TO UINT_TO_INT(gpCh[0]^.used_units_std_sync_r) - 1 DO
        IF gpCh[0]^.techno_unit_std_sync[i].please_rw THEN
            gpCh[0]^.techno_unit_std_sync[i].please_rw := FALSE;
            pData := ADR(gpCh[0]^.techno_unit_std_sync[i].attribut_r.data);
            nSeen := pData^.nr;
            nKind := gpCh[0]^.techno_unit_std_sync[i].fkt_ctrl_r;
            nUnit := i;
            EXIT;
        END_IF
    END_FOR
END_IF
IF nUnit >= 0 AND bDoor THEN
    gpCh[0]^.techno_unit_std_sync[nUnit].done_w := TRUE;
    nUnit := -1;
END_IF
""",
)


def test_a_function_waits_for_the_door(tmp_path: Path) -> None:
    """ST-763: M7 (MVS_SVS) of tick 10 is done in cycle 30, and X begins in tick 31.

    Its first increment at 4000 mm/s² is 4000 · 0.001² / 2 = 0.002 mm.
    """
    plc = loaded(tmp_path, GATE)
    signals = ["MAIN.nUnit", "X.ACS.ACT_POS"]
    text = "N10 G04 0.01\nN20 M7\nN30 G00 X10\nM30"
    done = run_nc(plc, text, 40, signals, [("30 ms", "MAIN.bDoor", 1)])
    assert values_in_main(plc, "nSeen", "nKind") == [7, 1]
    unit, x = (list(done.trace[name]) for name in signals)
    assert [int(unit[tick]) for tick in (9, 10, 29, 30)] == [-1, 0, 0, -1]
    assert [x[30], round(x[31], 9)] == [0.0, 0.002]
    (answer,) = [one for one in done.trace.events if one.kind == "acknowledged"]
    assert answer.span is not None
    assert answer.span.file.endswith("cell.st")
    line = (tmp_path / "cell.st").read_text("utf-8").splitlines()[answer.span.line - 1]
    assert "done_w := TRUE" in line


def test_without_a_present_plc_functions_acknowledge_themselves(tmp_path: Path) -> None:
    """ST-763: a PLC that is not announced gets no function; M7 does not hold X up."""
    plc = loaded(tmp_path, GATE.replace("plc_present_w := TRUE", "plc_present_w := FALSE"))
    done = run_nc(plc, "N20 M7\nN30 G00 X10\nM30", 20, ["MAIN.nUnit", "X.ACS.ACT_POS"])
    assert set(done.trace["MAIN.nUnit"]) == {-1}
    assert done.trace["X.ACS.ACT_POS"][5] > 0


def test_a_stopped_plc_is_no_longer_present(tmp_path: Path) -> None:
    """ST-560: after a fault the CNC goes on as without a PLC."""
    stops = "nTicksOfOne := nTicksOfOne + 1; nSeen := 1 / (20 - nTicksOfOne);"
    plc = loaded(tmp_path, GATE.replace("END_PROGRAM", f"{stops} END_PROGRAM"))
    done = run_nc(plc, "N5 G04 0.01\nN20 M7\nN30 G00 X10\nM30", 40, ["X.ACS.ACT_POS"])
    assert [one.message.id for one in done.errors] == [902265]
    # cycle 21 is the twentieth after the opening of the interface; M7 goes on in tick 23
    x = done.trace["X.ACS.ACT_POS"]
    assert x[21] == 0.0
    assert x[39] > 0.0


OVERRIDE = program(
    "nWish, nShown : UINT; bDecides AT %I* : BOOL;",
    """
gpCh[0]^.head.plc_present_w := TRUE;
gpCh[0]^.bahn_mc_control.override.enable_w := bDecides;
gpCh[0]^.bahn_mc_control.override.command_w := 500;
nWish := gpCh[0]^.bahn_mc_control.override.request_r;
nShown := gpCh[0]^.bahn_mc_control.override.state_r;
""",
)


def test_a_fault_says_where_it_was_called_from(tmp_path: Path) -> None:
    """ST-560: the innermost call first; nothing of values where none are known."""
    code = (
        "FUNCTION Tenth : INT VAR_INPUT n : INT; END_VAR\nTenth := 10 / n;\nEND_FUNCTION\n"
        "FUNCTION Share : INT VAR_INPUT n : INT; END_VAR\nShare := Tenth(n);\nEND_FUNCTION\n"
        "PROGRAM MAIN VAR n : INT; END_VAR\nn := Share(0);\nEND_PROGRAM\n"
    )
    (error,) = run_nc(loaded(tmp_path, code), "M30", 40, []).errors
    file = tmp_path / "cell.st"
    calls = f"{file}:5, {file}:8"
    assert error.text("en").endswith(f"division by zero; called from {calls}")
    assert error.text("de").endswith(f"Division durch null; aufgerufen aus {calls}")


def test_a_control_unit_decides_while_it_is_enabled(tmp_path: Path) -> None:
    """ST-762: enabled in cycle 10, 50 % acts from tick 11 on; the HMI's 80 % is a wish until 30."""
    plc = loaded(tmp_path, OVERRIDE)
    signals = ["HLI.OVERRIDE", "MAIN.nWish", "MAIN.nShown"]
    at = [
        ("10 ms", "MAIN.bDecides", 1.0),
        ("20 ms", "HLI.OVERRIDE", 80.0),
        ("30 ms", "MAIN.bDecides", 0.0),
    ]
    trace = run_nc(plc, "N10 G04 1\nM30", 40, signals, at).trace
    shown = {
        tick: tuple(int(trace[name][tick]) for name in signals) for tick in (10, 11, 20, 30, 31)
    }
    assert shown == {
        10: (100, 1000, 1000),
        11: (50, 1000, 500),
        20: (50, 800, 500),
        30: (50, 800, 500),
        31: (80, 800, 800),
    }


KEYS = program(
    "n : UINT; nState : UDINT;",
    """
n := n + 1;
gpCh[0]^.head.plc_present_w := TRUE;
gpCh[0]^.bahn_mc_control.feedhold.enable_w := TRUE;
gpCh[0]^.bahn_mc_control.feedhold.command_w := n >= 10 AND n < 20;
nState := gpCh[0]^.channel_mc_control.mode_and_state.state_r.state;
""",
)


def test_the_mode_is_shown_and_feed_hold_commands(tmp_path: Path) -> None:
    """ST-762: n = 10 in cycle 11; held from tick 12 on, seen in cycle 12; 22 goes on: 4, 5, 4."""
    plc = loaded(tmp_path, KEYS)
    trace = run_nc(plc, "N10 G01 X10 F6000\nM30", 30, ["MAIN.nState", "HLI.FEED_HOLD"]).trace
    assert [int(trace["MAIN.nState"][tick]) for tick in (5, 11, 12, 21, 22)] == [4, 4, 5, 5, 4]
    assert [int(trace["HLI.FEED_HOLD"][tick]) for tick in (11, 12, 21, 22)] == [0, 1, 1, 0]


def test_v_e_is_shared_by_structure(tmp_path: Path) -> None:
    """ST-764: NC's value is read in the cycle of its tick; the PLC's counts a tick later."""
    machine = load_machine(None)
    places = {one.path: (channel, one) for channel in (0, 1) for one in describe(machine, channel)}
    channel, count = places["COUNT"]
    assert count.type == "UNS32"
    base = "gpVECh[0]" if channel else "gpVEGlob"
    body = f"p := {base}; p := p + {count.offset}; nRead := p^; p^ := p^ + 5;"
    plc = loaded(tmp_path, program("p : POINTER TO UDINT; nRead : UDINT;", body))
    signals = ["MAIN.nRead", "V.E.COUNT"]
    trace = run_nc(plc, "N10 V.E.COUNT = 100\nN20 G04 1\nM30", 8, signals).trace
    assert [int(trace["MAIN.nRead"][tick]) for tick in (2, 3, 4)] == [100, 105, 110]
    assert [int(trace["V.E.COUNT"][tick]) for tick in (2, 3, 4)] == [100, 105, 110]


AXIS = """PROGRAM MAIN
VAR
    A : AXIS_REF;
    fbPower : MC_Power;
    fbOut, fbBack : MC_MoveAbsolute;
    nCycle, nOut, nBack : UDINT;
    bBusy, bActive : BOOL;
END_VAR
fbPower(Axis := A, Enable := {on}, Enable_Positive := TRUE, Enable_Negative := TRUE);
fbOut(Axis := A, Execute := nCycle >= 5, Position := {unit} * 20, Velocity := {speed} * 100);
IF fbOut.Done AND nOut = 0 THEN nOut := nCycle; END_IF
fbBack(Axis := A, Execute := nOut > 0, Position := 0, Velocity := {speed} * 100);
IF fbBack.Done AND nBack = 0 THEN nBack := nCycle; END_IF
nCycle := nCycle + 1;
END_PROGRAM
"""


def test_an_axis_goes_out_and_back(tmp_path: Path) -> None:
    """ST-743: 20° at 4000°/s² and 100°/s are 225 increments: 5 + 225 = 230, back 230 + 225 = 455.

    After k increments of the acceleration 0.002 · k²; after 25 of them 1.25, then 0.1 each.
    """
    plc = loaded(tmp_path, AXIS.format(on="TRUE", unit=10_000, speed=1000))
    a = list(run_nc(plc, "N10 G04 1\nM30", 460, ["A.ACS.ACT_POS"]).trace["A.ACS.ACT_POS"])
    assert [round(a[tick], 6) for tick in (5, 6, 105, 230, 231, 455)] == [
        0.0, 0.002, 8.75, 20.0, 19.998, 0.0,
    ]  # fmt: skip
    assert values_in_main(plc, "nOut", "nBack", "fbOut.CommandAborted") == [230, 455, False]


def test_an_axis_without_power_takes_no_command(tmp_path: Path) -> None:
    """ST-744: a motion without MC_Power is an error; its number is beyond 16 bits here."""
    plc = loaded(tmp_path, AXIS.format(on="FALSE", unit=10_000, speed=1000))
    run_nc(plc, "N10 G04 1\nM30", 10, [])
    assert values_in_main(plc, "fbOut.Error", "fbOut.ErrorID", "fbPower.Status") == [
        True, 65535, False,
    ]  # fmt: skip


RISING = """PROGRAM MAIN
VAR
    A : AXIS_REF;
    fbPower : MC_Power;
    fbMove : ARRAY[1..2] OF MC_MoveAbsolute;
    n : UDINT;
END_VAR
fbPower(Axis := A, Enable := TRUE, Enable_Positive := TRUE, Enable_Negative := TRUE);
fbMove[1](Axis := A, Execute := n MOD 4 < 2, Position := 100_000, Velocity := 1000);
n := n + 1;
END_PROGRAM
"""


def test_a_rising_execute_of_a_busy_block_is_reported(tmp_path: Path) -> None:
    """ST-743: Execute rises in the cycles 0, 4 and 8; the first command is Busy at the others."""
    plc = loaded(tmp_path, RISING)
    found = run_nc(plc, "N10 G04 1\nM30", 10, []).diagnostics
    (warning,) = [one.render("en") for one in found if one.message.id == 902710]
    assert "MAIN.fbMove[1]: " in warning
    assert "(2 ×)" in warning
    assert values_in_main(plc, "fbMove[1].fbMotion.nIgnored", "fbMove[2].fbMotion.nIgnored") == [
        2, 0,
    ]  # fmt: skip


COUNTER = "PROGRAM {name} VAR n, nIndex : DINT; nCount : UDINT; bFirst : BOOL; END_VAR n := n + 1; "
INFO = (
    "nIndex := GETCURTASKINDEXEX(); "
    "nCount := TwinCAT_SystemInfoVarList._TaskInfo[nIndex].CycleCount; "
    "bFirst := TwinCAT_SystemInfoVarList._TaskInfo[nIndex].FirstCycle; END_PROGRAM "
)
TASKS = """
CONFIGURATION Cell
RESOURCE Controller ON PLC
TASK Slow(INTERVAL := T#10MS, PRIORITY := 20);
TASK Fast(INTERVAL := T#3MS, PRIORITY := 1);
PROGRAM P1 WITH Slow : MAIN;
PROGRAM P2 WITH Fast : QUICK;
END_RESOURCE
END_CONFIGURATION
"""


def test_tasks_run_by_cycle_and_priority(tmp_path: Path) -> None:
    """ST-802 … 804: each 10 and each 3 ticks, the first ones after tick 0; counts begin with 1."""
    text = COUNTER.format(name="MAIN") + INFO + COUNTER.format(name="QUICK") + INFO
    plc = loaded(tmp_path, text, TASKS)
    signals = ["MAIN.n", "QUICK.n", "MAIN.bFirst", "QUICK.nCount"]
    trace = run_nc(plc, "N10 G04 1\nM30", 21, signals).trace
    shown = {tick: tuple(int(trace[name][tick]) for name in signals) for tick in (0, 3, 9, 10, 20)}
    assert shown == {
        0: (1, 1, 1, 1), 3: (1, 2, 1, 2), 9: (1, 4, 1, 4), 10: (2, 4, 0, 4), 20: (3, 7, 0, 7),
    }  # fmt: skip
    assert plc.read("MAIN.nIndex") == 1
    assert plc.read("QUICK.nIndex") == 2


class _Acknowledges(Plc):
    """A PLC in Python beside the one in the tick."""

    seen = 0

    @on("M7")
    def cool(self, hli: PlcView, function: object) -> None:
        self.seen += 1
        hli.acknowledge(function)  # type: ignore[arg-type]


def test_several_plcs_run_in_one_tick(tmp_path: Path) -> None:
    """ST-803: two projects, and a PLC in Python that acknowledges what neither of them takes."""
    folders = (tmp_path / "one", tmp_path / "two")
    for folder in folders:
        folder.mkdir()
    first = loaded(folders[0], COUNTER.format(name="MAIN") + "END_PROGRAM")
    other = EACH_TICK.replace("MAIN", "OTHER").replace("1MS", "2MS")
    second = loaded(folders[1], COUNTER.format(name="OTHER") + "END_PROGRAM", other)
    python = _Acknowledges()
    plc = PlcGroup([first, python, second])
    trace = run_nc(plc, "N10 M7\nN20 G04 1\nM30", 10, ["MAIN.n", "OTHER.n"]).trace
    assert [int(trace["MAIN.n"][9]), int(trace["OTHER.n"][9])] == [10, 5]
    assert python.seen == 1


#: A block whose interface is here, and which a PLC in Python carries out.
STUB = """
FUNCTION_BLOCK FB_Sdo
VAR_INPUT bExecute : BOOL; nIndex : UINT; END_VAR
VAR_OUTPUT bDone : BOOL; nData : UDINT; sText : STRING(9); END_VAR
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR fbSdo : FB_Sdo; nGot : UDINT; n : INT; END_VAR
n := n + 1;
fbSdo(bExecute := n >= 3, nIndex := 16#1018);
IF fbSdo.bDone THEN nGot := fbSdo.nData; END_IF
END_PROGRAM
"""


class _Sdo(Plc):
    """Answers the block in the tick in which it is asked."""

    def cycle(self, hli: PlcView) -> None:
        if hli.read("MAIN.fbSdo.bExecute") and not hli.read("MAIN.fbSdo.bDone"):
            assert hli.read("MAIN.fbSdo.nIndex") == 0x1018
            hli.write("MAIN.fbSdo.nData", 42)
            hli.write("MAIN.fbSdo.sText", "ok")
            hli.write("MAIN.fbSdo.bDone", True)


def test_a_plc_in_python_carries_out_a_block(tmp_path: Path) -> None:
    """ST-803: it reads after cycle 2 that the block is asked; cycle 3 has what it has written.

    The tape has what it wrote, and gives the same run without it.
    """
    plc, noted = loaded(tmp_path, STUB), list[object]()
    nc, signals = NcText("part.nc", "N10 G04 1\nM30"), ["MAIN.nGot", "MAIN.fbSdo.bDone"]
    run = Controller().run(
        nc, plc=PlcGroup([plc, _Sdo()]), ticks=6, signals=signals, record=noted.extend
    )
    assert [int(value) for value in run.trace["MAIN.fbSdo.bDone"]] == [0, 0, 0, 1, 1, 1]
    assert [int(value) for value in run.trace["MAIN.nGot"]] == [0, 0, 0, 42, 42, 42]
    assert plc.read("MAIN.fbSdo.sText") == "ok"
    inputs = tuple(unpack(noted))
    assert [(one.tick, one.values[0]) for one in inputs] == [
        (3, f"MAIN.fbSdo.{name}") for name in ("nData", "sText", "bDone")
    ]
    tape = Tape({}, {}, False, inputs, {}, 6, "", {})
    again = Controller().run(nc, plc=loaded(tmp_path, STUB), ticks=6, signals=signals, replay=tape)
    assert all((again.trace[name] == run.trace[name]).all() for name in signals)


@pytest.mark.parametrize(
    ("name", "value", "number"),
    [
        ("MAIN.fbSdo.nData", -1, "902262"),
        ("MAIN.fbSdo.nData", "ok", "902262"),
        ("MAIN.fbSdo.nDat", 1, "900541"),
        ("MAIN.fbSdo", 1, "902262"),
    ],
)
def test_a_plc_in_python_writes_what_a_variable_can_hold(
    name: str, value: float | str, number: str, tmp_path: Path
) -> None:
    """A wrong name or value is an error of the PLC, with its number."""

    class Wrong(Plc):
        def cycle(self, hli: PlcView) -> None:
            hli.write(name, value)

    with pytest.raises(Failure, match=number):
        run_nc(PlcGroup([loaded(tmp_path, STUB), Wrong()]), "N10 G04 1\nM30", 3, [])


ADDRESSES = """
TYPE E_Gate : (Closed, Opening, Open := 10); END_TYPE
PROGRAM MAIN
VAR bDoor AT %IX0.3 : BOOL; eWish AT %IB4 : E_Gate; eState : E_Gate; END_VAR
eState := eWish;
IF bDoor THEN eState := E_Gate.Opening; END_IF
END_PROGRAM
"""


def test_inputs_by_address_and_items_of_enumerations(tmp_path: Path) -> None:
    """ST-402, ST-313: a fixed address names its variable; an item is as good as its number."""
    at = [
        parse_stimulus("2 ms", "%ix0.3=TRUE"),
        parse_stimulus("4 ms", "%IX0.3=0"),
        parse_stimulus("4 ms", "MAIN.eWish=E_Gate.Open"),
        Stimulus("6 ms", "%IB4", "closed"),
    ]
    plc = loaded(tmp_path, ADDRESSES)
    trace = run_nc(plc, "N10 G04 1\nM30", 8, ["MAIN.eState"], at).trace
    assert [int(value) for value in trace["MAIN.eState"]] == [0, 0, 1, 1, 10, 10, 0, 0]
    assert plc.read("%IX0.3") is False
    assert plc.read("MAIN.eState") == "E_Gate.Closed"
    for name, value in (("%IB4", "E_Gate.Opn"), ("%IB4", "E_Door.Open"), ("%IX0.3", "Open")):
        with pytest.raises(Failure, match="902262"):
            plc.check(name, value)
    with pytest.raises(Failure, match=r"Did you mean E_Gate\.Open\?"):
        plc.check("%IB4", "E_Gate.Opn")
    assert not plc.knows("%IX0.4")


def test_a_tape_gives_the_inputs_of_the_plc_again(tmp_path: Path) -> None:
    """ST-820: the same inputs at the same ticks, and the PLC itself, make the same run."""
    plc = loaded(tmp_path, GATE)
    noted: list[object] = []
    text = "N10 G04 0.01\nN20 M7\nN30 G00 X10\nM30"
    signals = ["MAIN.nUnit", "X.ACS.ACT_POS"]
    first = Controller().run(
        NcText("part.nc", text), plc=plc, ticks=40, signals=signals, record=noted.extend,
        at=[("30 ms", "MAIN.bDoor", True)],
    )  # fmt: skip
    inputs = tuple(unpack(noted))
    assert [(one.tick, one.values) for one in inputs] == [(30, ("MAIN.bDoor", 1))]
    assert type(inputs[0].values[1]) is int  # a tape knows no truth values
    tape = Tape({}, {}, False, inputs, {}, 40, "", {})
    again = Controller().run(
        NcText("part.nc", text), plc=loaded(tmp_path, GATE), ticks=40, signals=signals, replay=tape
    )
    for name in signals:
        assert list(first.trace[name]) == list(again.trace[name])


NC_AXIS = """PROGRAM MAIN
VAR
    axLoader : AXIS_REF;
    fbPower : MC_Power;
    fbMove : MC_MoveRelative;
    fbPosition : MC_ReadActualPosition;
    fbStop : MC_Stop;
    n, nDone : UDINT;
END_VAR"""
NC_BODY = """fbPower(Axis := axLoader, Enable := TRUE);
fbMove(Axis := axLoader, Execute := n >= 5, Distance := 20.0, Velocity := 100.0);
fbStop(Axis := axLoader, Execute := n >= 105);
fbPosition(Axis := axLoader, Enable := TRUE);
IF fbStop.Done AND nDone = 0 THEN nDone := n; END_IF
n := n + 1;"""
BUFFERED_AXIS = """PROGRAM MAIN
VAR
    axLoader : AXIS_REF;
    fbPower : MC_Power;
    fbOut, fbBack, fbMore : MC_MoveAbsolute;
    n, nOut, nBack : UDINT;
END_VAR"""
BUFFERED_BODY = """fbPower(Axis := axLoader, Enable := TRUE);
fbOut(Axis := axLoader, Execute := n >= 5, Position := 20.0, Velocity := 100.0);
fbBack(Axis := axLoader, Execute := n >= {second}, Position := 0.0, Velocity := 100.0,
    BufferMode := MC_BufferMode.{mode});
fbMore(Axis := axLoader, Execute := n >= 12, Position := 5.0, Velocity := 100.0,
    BufferMode := MC_BufferMode.MC_Buffered);
IF fbOut.Done AND nOut = 0 THEN nOut := n; END_IF
IF fbBack.Done AND nBack = 0 THEN nBack := n; END_IF
n := n + 1;"""


def test_a_stop_aborts_a_motion_of_the_other_library(tmp_path: Path) -> None:
    """ST-741 … 744: braking from 100 mm/s at 4000 mm/s² takes 25 increments after cycle 105.

    The motion is at 8.75 in cycle 105; braking adds 100² / (2 · 4000) = 1.25: 10 in cycle 130.
    """
    plc = load_structured(nc_axis(tmp_path, NC_AXIS, NC_BODY), {"MAIN.axLoader": "A"})
    a = list(run_nc(plc, "N10 G04 1\nM30", 140, ["A.ACS.ACT_POS"]).trace["A.ACS.ACT_POS"])
    assert [round(a[tick], 6) for tick in (105, 130, 139)] == [8.75, 10.0, 10.0]
    names = ("nDone", "fbMove.CommandAborted", "fbStop.Busy", "fbPosition.Position")
    found = values_in_main(plc, *names)
    assert found[1:3] == [True, True]
    assert found[3] == 10.0
    assert found[0] in (130, 131)


def test_a_buffered_command_waits_for_the_first_one(tmp_path: Path) -> None:
    """ST-745: 225 increments out, then 225 back: 5 + 225 = 230, 455; a third one has no place."""
    body = BUFFERED_BODY.format(second=10, mode="MC_Buffered")
    plc = load_structured(nc_axis(tmp_path, BUFFERED_AXIS, body), {"MAIN.axLoader": "A"})
    run_nc(plc, "N10 G04 1\nM30", 460, [])
    assert values_in_main(plc, "nOut", "nBack") == [230, 455]
    assert values_in_main(plc, "fbMore.Error", "fbMore.ErrorID") == [True, 1704]


def test_an_aborting_command_takes_the_place_of_the_first_one(tmp_path: Path) -> None:
    """ST-745: the first command is aborted, the axis goes back to where the second one leads."""
    body = BUFFERED_BODY.format(second=10, mode="MC_Aborting").replace("n >= 12", "FALSE")
    plc = load_structured(nc_axis(tmp_path, BUFFERED_AXIS, body), {"MAIN.axLoader": "A"})
    a = run_nc(plc, "N10 G04 1\nM30", 200, ["A.ACS.ACT_POS"]).trace["A.ACS.ACT_POS"]
    assert values_in_main(plc, "fbOut.CommandAborted", "fbOut.Done") == [True, False]
    assert values_in_main(plc, "fbBack.Done") == [True]
    assert round(float(a[199]), 6) == 0.0


SLOW_CYCLE = """PROGRAM MAIN
VAR n, i, k : DINT; nLength : UDINT; bExceeded : BOOL; END_VAR
n := n + 1;
nLength := TwinCAT_SystemInfoVarList._TaskInfo[1].LastExecTime;
bExceeded := TwinCAT_SystemInfoVarList._TaskInfo[1].CycleTimeExceeded;
IF n = 3 THEN FOR i := 1 TO 1500 DO k := k + 1; END_FOR END_IF
END_PROGRAM
"""


def test_a_cycle_that_takes_too_long_loses_the_next_ones(tmp_path: Path) -> None:
    """ST-830: with 1 µs an instruction, cycle 3 begins at 2 ms; the next one after it has ended."""
    (tmp_path / "nctakt.toml").write_text("[plc]\ninstruction_time = 1000\n", "utf-8")
    plc = loaded(tmp_path, SLOW_CYCLE)
    signals = ["MAIN.n", "MAIN.nLength", "MAIN.bExceeded"]
    run = run_nc(plc, "N10 G04 1\nM30", 30, signals)
    count, length = list(run.trace["MAIN.n"]), run.trace["MAIN.nLength"]
    again = count.index(4)
    length_us = int(length[again]) // 10
    assert length_us > 1500
    assert again == 2 + -(-length_us // 1000)
    assert count[: again + 2] == [1, 2, *[3] * (again - 2), 4, 5]
    assert list(run.trace["MAIN.bExceeded"][again - 1 : again + 2]) == [0, 1, 0]
    [warning] = [one for one in run.diagnostics if one.id == 902632]
    assert f"took {length_us / 1000:g} ms of 1 ms" in warning.text("en")


@pytest.mark.parametrize("name", ["gone.st", "gone.plcproj"])
def test_a_missing_file_is_named_as_such(tmp_path: Path, name: str) -> None:
    """It was said that it could not be written, with a remedy for that."""
    with pytest.raises(PlcError, match="900500"):
        load_structured(tmp_path / name)


def test_a_reset_does_not_touch_the_plc(tmp_path: Path) -> None:
    """ST-810: its cycles and values go on, one in each tick."""
    plc = loaded(tmp_path, "PROGRAM MAIN VAR n : UDINT; END_VAR n := n + 1; END_PROGRAM")
    controller = Controller()
    controller.start(NcText("part.nc", "G04 10\nM30"), plc=plc)
    controller.step(20)
    controller.reset()
    assert plc.read("MAIN.n") == controller.tick
    controller.step(5)
    assert plc.read("MAIN.n") == controller.tick


STATES = """TYPE E_Gate : (Closed, Opening := 5, Open); END_TYPE
PROGRAM MAIN VAR n : INT := 7; eGate : E_Gate; bOpen : BOOL; END_VAR
n := n + 1; IF n = 10 THEN eGate := E_Gate.Open; END_IF bOpen := eGate = E_Gate.Open; END_PROGRAM
"""


def test_expectations_name_items_of_enumerations(tmp_path: Path) -> None:
    """RC-002: n is 7 before the first cycle and 10 after the third; what holds then counts."""
    plc = loaded(tmp_path, STATES)
    names = ["MAIN.n", "MAIN.eGate", "MAIN.bOpen"]
    nc = NcText("part.nc", "G04 0.01\nM30")
    run = NcRun(
        Controller().run(nc, plc=plc, ticks=8, signals=names, set={"MAIN.eGate": "Opening"})
    )
    texts = (
        "MAIN.n = 7 at 0ms", "MAIN.eGate = E_Gate.Opening at 0ms", "MAIN.eGate = opening at 2ms",
        "MAIN.eGate = E_Gate.Open at 3ms", "MAIN.eGate = 6 at end", "MAIN.bOpen = TRUE at 3ms",
        "MAIN.bOpen = FALSE at 2ms",
    )  # fmt: skip
    assert list(differences(run, [read_expectation(text) for text in texts], "part.nc")) == []
    wrong = [read_expectation("MAIN.eGate = Closed"), read_expectation("MAIN.eGate = Ajar")]
    first, second = differences(run, wrong, "part.nc")
    assert "+ MAIN.eGate = E_Gate.Open" in first
    assert "902631" in second
    assert "E_Gate.Closed, E_Gate.Opening, E_Gate.Open" in second
    for item in ("E_Gate.Opning", "Opning"):
        (third,) = differences(run, [read_expectation(f"MAIN.eGate = {item}")], "part.nc")
        assert "Did you mean E_Gate.Opening?" in third


def test_the_project_file_names_axes(tmp_path: Path) -> None:
    """ST-742: the table [plc] axes says which axis a variable means."""
    file = nc_axis(tmp_path, NC_AXIS, NC_BODY)
    table = '[plc]\nfile = "Cell.plcproj"\naxes = {"MAIN.axLoader" = "A"}\n'
    (tmp_path / "nctakt.toml").write_text(table, "utf-8")
    done = run_nc(load_structured(file), "N10 G04 1\nM30", 20, ["A.ACS.ACT_POS"])
    assert done.trace["A.ACS.ACT_POS"][19] > 0.0


def test_an_axis_of_no_name_is_refused(tmp_path: Path) -> None:
    """ST-742: neither the variable nor the table names an axis of the machine."""
    plc = load_structured(nc_axis(tmp_path, NC_AXIS, NC_BODY))
    with pytest.raises(PlcError, match="axLoader"):
        run_nc(plc, "M30", 1, [])


SPINDLE = program(
    "nRev : DINT; n : UDINT; pS : POINTER TO HLI_S_PROZESS;",
    """
gpAx[4]^.head.plc_present_w := TRUE;
IF gpAx[4]^.techno_unit_std_sync[0].please_rw THEN
    gpAx[4]^.techno_unit_std_sync[0].please_rw := FALSE;
    pS := ADR(gpAx[4]^.techno_unit_std_sync[0].attribut_r.data);
    nRev := pS^.rev;
    n := n + 1;
    gpAx[4]^.techno_unit_std_sync[0].done_w := TRUE;
END_IF
""",
)


def test_a_spindle_that_the_plc_turns_asks_at_its_axis(tmp_path: Path) -> None:
    """ST-763: 1000 rev/min are 6,000,000 · 0.001°/s, negative for M4; M5 is 0."""
    folder = machine_with(tmp_path / "machine")
    lists = folder / "sda_mds1.lis"
    text = lists.read_text("utf-8")
    line = "spindel[0].plc_control                  "
    lists.write_text(text.replace(f"{line}0", f"{line}1"), "utf-8")
    plc = loaded(tmp_path, SPINDLE)
    nc = NcText("p.nc", "N5 G04 0.01\nN10 M4 S1000\nN20 G04 0.01\nN30 M5\nN40 G04 0.01\nM30")
    done = Controller(folder).run(nc, plc=plc, ticks=40, signals=["MAIN.nRev", "MAIN.n"])
    assert done.errors == ()
    rev = list(dict.fromkeys(int(one) for one in done.trace["MAIN.nRev"]))
    assert rev == [0, -6_000_000]
    assert plc.read("MAIN.nRev") == 0
    assert plc.read("MAIN.n") == 2


JOG_AXIS = """PROGRAM MAIN
VAR
    axLoader : AXIS_REF;
    fbPower : MC_Power;
    fbJog : MC_Jog;
    n, nDone, nErrors : UDINT;
END_VAR"""
JOG_BODY = """fbPower(Axis := axLoader, Enable := TRUE);
fbJog(Axis := axLoader, JogForward := {forward}, JogBackwards := {backwards},
    Mode := E_JogMode.MC_JOGMODE_{mode}, Position := 20.0, Velocity := 100.0);
IF fbJog.Done THEN nDone := nDone + 1; END_IF
IF fbJog.Error THEN nErrors := nErrors + 1; END_IF
n := n + 1;"""


def jogged(
    folder: Path, mode: str, forward: str, backwards: str = "FALSE"
) -> tuple[list[float], StructuredPlc]:
    """The positions of an axis that a block jogs, and the PLC after it."""
    body = JOG_BODY.format(mode=mode, forward=forward, backwards=backwards)
    plc = load_structured(nc_axis(folder, JOG_AXIS, body), {"MAIN.axLoader": "A"})
    run = run_nc(plc, "N10 G04 1\nM30", 480, ["A.ACS.ACT_POS"])
    assert [one for one in run.diagnostics if one.message.id == 902710] == []
    return [round(float(value), 6) for value in run.trace["A.ACS.ACT_POS"]], plc


def test_a_button_jogs_while_it_is_pressed(tmp_path: Path) -> None:
    """ST-744: 100 mm/s after 25 increments of 4000 mm/s², then 0.1 mm in each; braking 1.25 mm.

    Pressed from cycle 5 to 104: 100 increments are 1.25 + 75 · 0.1 = 8.75, the stop is at 10. The
    other button, pressed meanwhile, counts after the stop.
    """
    a, plc = jogged(tmp_path, "CONTINOUS", "n >= 5 AND n < 105", "n >= 90 AND n < 300")
    assert [a[tick] for tick in (5, 105, 130)] == [0.0, 8.75, 10.0]
    assert a[140] < 10.0
    assert a[325] == a[479]
    assert values_in_main(plc, "nDone", "fbJog.Busy", "nErrors") == [2, False, 0]


def test_a_button_inches_by_a_distance(tmp_path: Path) -> None:
    """ST-744: 20 mm in 225 increments at each press, however long it lasts."""
    a, plc = jogged(tmp_path, "INCHING", "n >= 5 AND n < 10 OR n >= 15 AND n < 20")
    assert [a[tick] for tick in (5, 230, 479)] == [0.0, 20.0, 20.0]
    assert values_in_main(plc, "fbJog.Busy", "nErrors", "nDone") == [False, 0, 1]


def test_a_jog_without_a_speed_of_its_own_is_an_error(tmp_path: Path) -> None:
    """ST-744: the standard modes take speeds that no list here has."""
    a, plc = jogged(tmp_path, "STANDARD_SLOW", "n >= 5")
    assert a[479] == 0.0
    assert values_in_main(plc, "fbJog.Error", "fbJog.ErrorID") == [True, 900657]


HOME_AXIS = """PROGRAM MAIN
VAR
    axLoader : AXIS_REF;
    fbPower : MC_Power;
    fbHome : MC_Home;
    fbSet : MC_SetPosition;
    fbRead : MC_ReadParameter;
    n : UDINT;
END_VAR"""
HOME_BODY = """fbPower(Axis := axLoader, Enable := TRUE);
fbHome(Axis := axLoader, Execute := n >= 5, {pins});
fbSet(Axis := axLoader, Execute := n >= 50, Position := 7.5, Mode := TRUE);
fbRead(Axis := axLoader, Enable := TRUE, ParameterNumber := MC_AxisParameter.{parameter},
    ReadMode := E_ReadMode.READMODE_ONCE);
n := n + 1;"""


@pytest.mark.parametrize(
    ("pins", "homed", "number"),
    [
        ("HomingMode := MC_HomingMode.MC_Direct, Position := 30.0", 30.0, 0),
        ("HomingMode := MC_HomingMode.MC_ForceCalibration, Position := 30.0", 0.0, 0),
        ("HomingMode := MC_HomingMode.MC_Direct", 0.0, 902863),
        ("HomingMode := MC_HomingMode.MC_AbsSwitch", 0.0, 902863),
        ("Position := 20.0", 20.001, 0),
        ("bCalibrationCam := TRUE", 0.001, 0),
    ],
)
def test_the_other_library_homes_in_three_ways(
    tmp_path: Path, pins: str, homed: float, number: int
) -> None:
    """ST-744: the simulated axis is 0.001 mm beyond its zero pulse, as that is 0.001 off.

    Then its position becomes greater by 7.5, and the parameter was read once.
    """
    body = HOME_BODY.format(pins=pins, parameter="CommandedPosition")
    plc = load_structured(nc_axis(tmp_path, HOME_AXIS, body), {"MAIN.axLoader": "A"})
    a = run_nc(plc, "N10 G04 1\nM30", 60, ["A.ACS.ACT_POS"]).trace["A.ACS.ACT_POS"]
    assert [round(float(a[tick]), 6) for tick in (49, 59)] == [homed, round(homed + 7.5, 6)]
    assert values_in_main(plc, "fbHome.Done", "fbHome.Error", "fbHome.ErrorID") == [
        number == 0, number != 0, number,
    ]  # fmt: skip
    assert values_in_main(plc, "fbSet.Done", "fbRead.Valid", "fbRead.Value") == [True, True, 0.0]

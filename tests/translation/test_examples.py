# SPDX-License-Identifier: MIT
"""Programs with timers, states, inheritance, texts and faults, tick by tick.

The values are worked out by hand from the rules: T = 1 ms; cycle n is that after tick n (ST-801).
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.plc_rig import loaded, run, values_in_main

from nctakt.base.failure import Failure
from nctakt.plc.error import PlcError

STATES = """
{attribute 'qualified_only'}
{attribute 'strict'}
TYPE E_Clamp : (Open, Closing, Closed, Opening, Fault := 99) USINT; END_TYPE
PROGRAM MAIN
VAR
    bStart AT %I* : BOOL;
    bIsClosed AT %I* : BOOL;
    bIsOpen AT %I* : BOOL := TRUE;
    bValve AT %Q* : BOOL;
    eState, eLast : E_Clamp;
    tonStep : TON;
    nChanges : UINT;
END_VAR
tonStep(IN := eState = E_Clamp.Closing OR eState = E_Clamp.Opening, PT := T#50MS);
CASE eState OF
    E_Clamp.Open: IF bStart THEN eState := E_Clamp.Closing; END_IF
    E_Clamp.Closing:
        IF bIsClosed THEN eState := E_Clamp.Closed;
        ELSIF tonStep.Q THEN eState := E_Clamp.Fault;
        END_IF
    E_Clamp.Closed: IF NOT bStart THEN eState := E_Clamp.Opening; END_IF
    E_Clamp.Opening:
        IF bIsOpen THEN eState := E_Clamp.Open;
        ELSIF tonStep.Q THEN eState := E_Clamp.Fault;
        END_IF
ELSE
    bValve := FALSE;
END_CASE
IF eState <> eLast THEN nChanges := nChanges + 1; tonStep(IN := FALSE); END_IF
eLast := eState;
bValve := eState = E_Clamp.Closing OR eState = E_Clamp.Closed;
END_PROGRAM
"""


def test_a_clamp_as_a_state_machine_with_a_timeout(tmp_path: Path) -> None:
    """ST-511, ST-701, ST-313: inputs count in the cycle of their tick; ET from the second call."""
    plc = loaded(tmp_path, STATES)
    signals = ["MAIN.eState", "MAIN.bValve", "MAIN.nChanges"]
    at = [
        ("5 ms", "MAIN.bStart", 1),
        ("40 ms", "MAIN.bStart", 0),
        ("10 ms", "MAIN.bIsOpen", 0),
        ("25 ms", "MAIN.bIsClosed", 1),
        ("45 ms", "MAIN.bIsClosed", 0),
    ]
    trace = run(plc, 100, signals, at).trace
    expected = {
        4: (0, 0, 0), 5: (1, 1, 1), 6: (1, 1, 1), 24: (1, 1, 1), 25: (2, 1, 2), 40: (3, 0, 3),
        90: (3, 0, 3), 91: (99, 0, 4),
    }  # fmt: skip
    assert {tick: tuple(trace[name][tick] for name in signals) for tick in expected} == expected
    assert plc.read("MAIN.eState") == "E_Clamp.Fault"


TIMERS = """
PROGRAM MAIN
VAR
    bIn AT %I* : BOOL;
    tonIn : TON := (PT := T#30MS);
    tofIn : TOF := (PT := T#25MS);
    tpIn : TP := (PT := T#20MS);
    rtIn : R_TRIG;
    ctuIn : CTU := (PV := 2);
END_VAR
tonIn(IN := bIn); tofIn(IN := bIn); tpIn(IN := bIn); rtIn(CLK := bIn);
ctuIn(CU := bIn, RESET := FALSE);
END_PROGRAM
"""


def test_timers_in_a_task_of_ten_ticks(tmp_path: Path) -> None:
    """ST-701 … ST-706, ST-802: TON, TOF, TP as Q and ET in ms, R_TRIG, CTU as CV and Q."""
    plc = loaded(tmp_path, TIMERS, "")
    names = "tonIn.Q tonIn.ET tofIn.Q tofIn.ET tpIn.Q tpIn.ET rtIn.Q ctuIn.CV ctuIn.Q"
    signals = [f"MAIN.{name}" for name in names.split()]
    at = [(f"{ms} ms", "MAIN.bIn", value) for ms, value in ((20, 1), (95, 0), (120, 1), (130, 0))]
    trace = run(plc, 170, signals, at).trace
    expected = {
        10: (0, 0, 0, 0, 0, 0, 0, 0, 0),
        20: (0, 0, 1, 0, 1, 0, 1, 1, 0),
        29: (0, 0, 1, 0, 1, 0, 1, 1, 0),
        30: (0, 10, 1, 0, 1, 10, 0, 1, 0),
        40: (0, 20, 1, 0, 0, 20, 0, 1, 0),
        50: (1, 30, 1, 0, 0, 20, 0, 1, 0),
        90: (1, 30, 1, 0, 0, 20, 0, 1, 0),
        100: (0, 0, 1, 0, 0, 0, 0, 1, 0),
        110: (0, 0, 1, 10, 0, 0, 0, 1, 0),
        120: (0, 0, 1, 0, 1, 0, 1, 2, 1),
        130: (0, 0, 1, 0, 1, 10, 0, 2, 1),
        140: (0, 0, 1, 10, 0, 0, 0, 2, 1),
        160: (0, 0, 0, 25, 0, 0, 0, 2, 1),
    }
    assert {tick: tuple(trace[name][tick] for name in signals) for tick in expected} == expected


INHERITANCE = """
INTERFACE I_Device
METHOD Cycle : BOOL
END_METHOD
PROPERTY Name : STRING(20)
GET
END_GET
END_PROPERTY
END_INTERFACE
FUNCTION_BLOCK ABSTRACT FB_Device IMPLEMENTS I_Device
VAR
    sName : STRING(20);
    nCalls : UDINT;
END_VAR
METHOD FB_init : BOOL
VAR_INPUT
    bInitRetains : BOOL;
    bInCopyCode : BOOL;
    sDevice : STRING(20);
END_VAR
sName := sDevice;
END_METHOD
METHOD Cycle : BOOL
nCalls := nCalls + 1;
Cycle := Work();
END_METHOD
METHOD PROTECTED ABSTRACT Work : BOOL
END_METHOD
PROPERTY Name : STRING(20)
GET
Name := sName;
END_GET
END_PROPERTY
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB_Pump EXTENDS FB_Device
VAR
    nLitres : UDINT;
END_VAR
METHOD PROTECTED Work : BOOL
nLitres := nLitres + 5;
Work := nLitres >= 20;
END_METHOD
END_FUNCTION_BLOCK
FUNCTION_BLOCK FINAL FB_SlowPump EXTENDS FB_Pump
METHOD Cycle : BOOL
VAR_INST
    bTurn : BOOL;
END_VAR
bTurn := NOT bTurn;
IF bTurn THEN Cycle := SUPER^.Cycle(); ELSE Cycle := FALSE; END_IF
END_METHOD
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR
    fbPump : FB_Pump(sDevice := 'pump');
    fbSlow : FB_SlowPump(sDevice := 'slow');
    aDevices : ARRAY[1..2] OF I_Device := [fbPump, fbSlow];
    aReady : ARRAY[1..2] OF BOOL;
    sFirst : STRING;
    i : INT;
END_VAR
FOR i := 1 TO 2 DO
    aReady[i] := aDevices[i].Cycle();
    IF aReady[i] AND sFirst = '' THEN sFirst := aDevices[i].Name; END_IF
END_FOR
END_PROGRAM
"""


def test_devices_behind_an_interface(tmp_path: Path) -> None:
    """ST-601 … ST-605: interface, abstract base, SUPER^, VAR_INST, property, FB_init."""
    plc = loaded(tmp_path, INHERITANCE)
    names = "aReady[1] aReady[2] fbPump.nLitres fbSlow.nLitres".split()
    signals = [f"MAIN.{name}" for name in names]
    trace = run(plc, 9, signals).trace
    expected = {
        0: (0, 0, 5, 5), 1: (0, 0, 10, 5), 2: (0, 0, 15, 10), 3: (1, 0, 20, 10),
        6: (1, 1, 35, 20), 7: (1, 0, 40, 20), 8: (1, 1, 45, 25),
    }  # fmt: skip
    assert {tick: tuple(trace[name][tick] for name in signals) for tick in expected} == expected
    assert values_in_main(plc, "sFirst", "fbPump.nCalls", "fbSlow.nCalls") == ["pump", 9, 5]


TEXTS = """
FUNCTION F_Line : STRING
VAR_INPUT
    nNumber : INT;
    fValue : LREAL;
END_VAR
F_Line := CONCAT(CONCAT('N', INT_TO_STRING(nNumber)), CONCAT(' X', LREAL_TO_STRING(fValue)));
END_FUNCTION
FUNCTION F_Largest : DINT
VAR_IN_OUT
    aValues : ARRAY[*] OF INT;
END_VAR
VAR_OUTPUT
    nIndex : DINT;
END_VAR
VAR
    i : DINT;
END_VAR
nIndex := LOWER_BOUND(aValues, 1);
FOR i := LOWER_BOUND(aValues, 1) + 1 TO UPPER_BOUND(aValues, 1) DO
    IF aValues[i] > aValues[nIndex] THEN nIndex := i; END_IF
END_FOR
F_Largest := aValues[nIndex];
END_FUNCTION
TYPE ST_Tool : STRUCT nNumber : UINT; fRadius : REAL; bWorn : BOOL; END_STRUCT END_TYPE
PROGRAM MAIN
VAR
    sLine : STRING := F_Line(10, 12.5);
    sShort : STRING(4);
    nFound, nBack : INT;
    sPart, sOther : STRING;
    sQuote : STRING := 'it$'s $41$$';
    nFirst : BYTE;
    aTools : ARRAY[1..4] OF ST_Tool := [(nNumber := 7, fRadius := 5.0), (nNumber := 3),
        (nNumber := 9, bWorn := TRUE), (nNumber := 3, fRadius := 2.5)];
    aCurve : ARRAY[-2..2] OF INT := [4, -7, 12, 2(12)];
    nMax, nMaxAt : DINT;
    nMod : INT := -7 MOD 3;
    nBits : WORD;
    nSmall : USINT := 255;
    nSize : UDINT := SIZEOF(ST_Tool);
    i : INT;
    pTool : POINTER TO ST_Tool;
    rTool : REFERENCE TO ST_Tool;
    bBound : BOOL;
END_VAR
sShort := sLine;
nFound := FIND(sLine, 'X');
sPart := MID(STR := sLine, LEN := 4, POS := nFound + 1);
sOther := REPLACE(STR1 := sLine, STR2 := 'Y', L := 1, P := nFound);
sOther := INSERT(sOther, '-', nFound);
nFirst := sQuote[0];
nBack := STRING_TO_INT(LEFT(RIGHT(sLine, 4), 2));
FOR i := 1 TO 4 DO
    IF aTools[i].bWorn THEN CONTINUE; END_IF
    nBits.3 := TRUE;
END_FOR
nMax := F_Largest(aValues := aCurve, nIndex => nMaxAt);
nSmall := nSmall + 1;
pTool := ADR(aTools[1]);
pTool := pTool + SIZEOF(ST_Tool);
pTool^.fRadius := 1.25;
bBound := __ISVALIDREF(rTool);
rTool REF= aTools[4];
rTool.nNumber := 44;
END_PROGRAM
"""


def test_texts_arrays_and_pointers(tmp_path: Path) -> None:
    """ST-310 … ST-317, ST-330, ST-503, ST-711: 2 + 2 gap + 4 + 1 + 3 gap bytes; 255 + 1 wraps."""
    plc = loaded(tmp_path, TEXTS)
    run(plc, 1)
    assert values_in_main(plc, "sLine", "sShort", "nFound", "sPart") == [
        "N10 X12.5",
        "N10 ",
        5,
        "12.5",
    ]
    assert values_in_main(plc, "sOther", "sQuote") == ["N10 Y-12.5", "it's A$"]
    assert values_in_main(plc, "nFirst", "nBack", "i", "nBits") == [105, 12, 5, 8]
    assert values_in_main(plc, "nMax", "nMaxAt", "nMod", "nSmall", "nSize") == [12, 0, -1, 0, 12]
    assert values_in_main(plc, "aTools[2].fRadius", "aTools[4].nNumber", "bBound") == [
        1.25, 44, False,
    ]  # fmt: skip


FAULT = """
PROGRAM MAIN
VAR
    nCycle, nBefore, nQuot, nAfter : INT;
    bLamp AT %Q* : BOOL;
END_VAR
nBefore := nBefore + 1;
bLamp := nCycle < 7;
nQuot := 100 / (7 - nCycle);
nAfter := nAfter + 1;
nCycle := nCycle + 1;
END_PROGRAM
"""


def test_a_division_by_zero_stops_the_plc(tmp_path: Path) -> None:
    """ST-560: cycle 7 ends there with 902265; what was done before it stays; no further cycle."""
    plc = loaded(tmp_path, FAULT)
    done = run(plc, 20, ["MAIN.nQuot"])
    assert list(done.trace["MAIN.nQuot"][:7]) == [14, 16, 20, 25, 33, 50, 100]
    names = ("nBefore", "nAfter", "nCycle", "nQuot", "bLamp")
    assert values_in_main(plc, *names) == [8, 7, 7, 100, False]
    (fault,) = [one for one in done.diagnostics if one.message.id == 902265]
    assert fault.span is not None
    assert fault.span.line == 9
    assert "nCycle = 7" in fault.text("en")


CALLED = """
FUNCTION F_At : INT
VAR_INPUT
    n : INT;
END_VAR
VAR
    a : ARRAY[1..3] OF INT;
    p : POINTER TO INT;
    x : REAL;
END_VAR
{body}
END_FUNCTION
PROGRAM MAIN
VAR
    r : INT;
END_VAR
r := F_At(7);
END_PROGRAM
"""


@pytest.mark.parametrize(
    ("body", "number"),
    [
        ("F_At := a[n];", 902266),
        ("F_At := p^;", 902267),
        ("p := ADR(a) + 100000000; p^ := 1;", 902267),
        ("WHILE TRUE DO n := n + 1; END_WHILE", 902269),
        ("x := 40000.0; F_At := REAL_TO_INT(x);", 902270),
        ("x := -1.0; x := SQRT(x);", 902260),
        ("FOR n := 1 TO 3 BY a[1] DO ; END_FOR", 902271),
        ("F_RaiseException(7);", 902360),
    ],
)
def test_each_fault_has_its_number_and_its_calls(tmp_path: Path, body: str, number: int) -> None:
    """ST-560, ST-512, ST-830: index, pointer, budget, conversion, invalid operation, step 0."""
    done = run(loaded(tmp_path, CALLED.format(body=body)), 3)
    (fault,) = [one for one in done.diagnostics if one.message.id == number]
    assert fault.span is not None
    assert fault.span.line == 11
    assert "cell.st:17" in fault.text("en")


def test_each_run_begins_with_the_initial_values(tmp_path: Path) -> None:
    """ST-805, ST-820: a second run of the same PLC gives the same."""
    plc = loaded(tmp_path, FAULT)
    first, second = (list(run(plc, 6, ["MAIN.nQuot"]).trace["MAIN.nQuot"]) for _ in range(2))
    assert first == second


def test_an_input_counts_and_the_last_variable_is_a_signal(tmp_path: Path) -> None:
    """ST-801, 802: the cycle after an input reads it, here that of each tenth tick."""
    text = "PROGRAM MAIN VAR bDoor AT %I* : BOOL; n : INT; END_VAR IF bDoor THEN n := n + 1; END_IF"
    plc = loaded(tmp_path, f"{text} END_PROGRAM", "")
    at = [("20 ms", "MAIN.bDoor", 1)]
    counts = run(plc, 51, ["MAIN.n"], at).trace["MAIN.n"]
    assert [int(counts[tick]) for tick in (19, 20, 29, 30, 50)] == [0, 1, 1, 2, 4]


def test_values_beside_a_fault_are_those_of_its_own_program(tmp_path: Path) -> None:
    """A block's variable is not shown with the value that the program's of that name has."""
    text = """FUNCTION_BLOCK FB_Ratio
VAR n : INT; r : INT; END_VAR
r := 5 / n;
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR fb : FB_Ratio; n : INT := 7; END_VAR
fb();
END_PROGRAM
"""
    (fault,) = run(loaded(tmp_path, text), 5).errors
    assert "n = 7" not in fault.text("en")


@pytest.mark.parametrize(
    ("name", "value"),
    [("r", 1e300), ("n", float("nan")), ("n", float("inf")), ("s", "four"), ("s", "€"), ("n", 1.5)],
)
def test_a_value_that_a_variable_cannot_hold_is_refused(
    tmp_path: Path, name: str, value: float | str
) -> None:
    """Nothing is cut, replaced or rounded in silence."""
    text = "PROGRAM MAIN VAR n : INT; r : REAL; s : STRING(3); END_VAR n := n; END_PROGRAM"
    with pytest.raises(Failure, match="MAIN"):
        loaded(tmp_path, text).check(f"MAIN.{name}", value)


@pytest.mark.parametrize(
    "text",
    [
        "PROGRAM MAIN VAR a : AXIS_REF; h : MC_CamOut; END_VAR h(Slave := a); END_PROGRAM",
        "PROGRAM MAIN VAR a : INT; e : E_TcMemoryArea; END_VAR"
        " e := F_CheckMemoryArea(ADR(a), 2); END_PROGRAM",
    ],
)
def test_what_does_not_run_is_refused_by_name(tmp_path: Path, text: str) -> None:
    """What is not connected or has no body here is refused before the first tick, at its place."""
    with pytest.raises(PlcError) as caught:
        loaded(tmp_path, text)
    assert [one.message.id for one in caught.value.diagnostics] == [902261]

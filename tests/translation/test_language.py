# SPDX-License-Identifier: MIT
"""What code computes, rule by rule: the values of variables after the first cycle."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.plc_rig import loaded, run

from nctakt.base.failure import Failure

ANY_SIZE = """FUNCTION F_Sum : DINT
VAR_INPUT x : ANY; y : ANY_NUM; END_VAR
VAR p : POINTER TO INT; END_VAR
p := x.pValue;
F_Sum := x.diSize * 100 + p^;
IF y.TypeClass = __SYSTEM.TYPE_CLASS.TYPE_LREAL THEN F_Sum := F_Sum + 10000; END_IF
END_FUNCTION
"""
PUMPS = """INTERFACE I_Run
METHOD Go : BOOL
END_METHOD
END_INTERFACE
INTERFACE I_Stop EXTENDS __SYSTEM.IQueryInterface
METHOD Halt : BOOL
END_METHOD
END_INTERFACE
FUNCTION_BLOCK FB_Both IMPLEMENTS I_Run, I_Stop
METHOD Go : BOOL
END_METHOD
METHOD Halt : BOOL
END_METHOD
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB_One IMPLEMENTS I_Run
METHOD Go : BOOL
END_METHOD
END_FUNCTION_BLOCK
"""
NAMED = """{attribute 'reflection'}
FUNCTION_BLOCK FB_Named
VAR
    {attribute 'instance-path'}
    {attribute 'noinit'}
    sPath : STRING(40);
END_VAR
VAR_OUTPUT nLate : INT := 3; END_VAR
METHOD FB_init : BOOL
VAR_INPUT bInitRetains : BOOL; bInCopyCode : BOOL; END_VAR
nLate := 4;
END_METHOD
{attribute 'call_after_init'}
METHOD Late
nLate := nLate * 10;
END_METHOD
METHOD Name : STRING
Name := __POUNAME();
END_METHOD
END_FUNCTION_BLOCK
"""
CHECKS = """FUNCTION CheckBounds : DINT
VAR_INPUT index, lower, upper : DINT; END_VAR
CheckBounds := LIMIT(lower, index, upper);
END_FUNCTION
FUNCTION CheckDivDInt : DINT
VAR_INPUT divisor : DINT; END_VAR
CheckDivDInt := SEL(divisor = 0, divisor, 1);
END_FUNCTION
FUNCTION CheckDivLReal : LREAL
VAR_INPUT divisor : LREAL; END_VAR
CheckDivLReal := SEL(divisor = 0, divisor, 1);
END_FUNCTION
FUNCTION CheckRangeSigned : DINT
VAR_INPUT value, lower, upper : DINT; END_VAR
CheckRangeSigned := LIMIT(lower, value, upper);
END_FUNCTION
{attribute 'no_check'}
FUNCTION F_Raw : INT
VAR a : ARRAY[1..3] OF INT; i : INT := 3; END_VAR
F_Raw := a[i] + 2;
END_FUNCTION
FUNCTION CheckPointer : POINTER TO BYTE
VAR_INPUT ptToTest : POINTER TO BYTE; iSize, iGran : DINT; bWrite : BOOL; END_VAR
VAR_STAT bSpare : ARRAY[0..7] OF BYTE; END_VAR
IF ptToTest = 0 THEN CheckPointer := ADR(bSpare); ELSE CheckPointer := ptToTest; END_IF
END_FUNCTION
"""
COUNTED = """FUNCTION F_Next : INT
VAR_STAT n : INT; END_VAR
n := n + 1;
F_Next := n - 1;
END_FUNCTION
"""

NUMBERED = """FUNCTION_BLOCK FB_Numbered
VAR nKept : INT; END_VAR
METHOD FB_init : BOOL
VAR_INPUT bInitRetains, bInCopyCode : BOOL; n : INT; END_VAR
nKept := n;
END_METHOD
END_FUNCTION_BLOCK
"""
DERIVED = """FUNCTION_BLOCK FB_Base
VAR_INPUT n : INT; END_VAR
METHOD Times : INT
VAR_INPUT k : INT; END_VAR
Times := k;
END_METHOD
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB_Derived EXTENDS FB_Base
METHOD Times : INT
VAR_INPUT k : INT; END_VAR
Times := 10 * n + k;
END_METHOD
END_FUNCTION_BLOCK
FUNCTION F_ByReference : INT VAR_INPUT r : REFERENCE TO FB_Base; END_VAR
F_ByReference := r.Times(1);
END_FUNCTION
FUNCTION F_ByPointer : INT VAR_INPUT p : POINTER TO FB_Base; END_VAR
F_ByPointer := p^.Times(2);
END_FUNCTION
FUNCTION F_InPlace : INT VAR_IN_OUT b : FB_Base; END_VAR
F_InPlace := b.Times(3);
END_FUNCTION
"""

CASES = {
    "ST-208, 301: WSTRING": (
        "",
        'w, x, y : WSTRING(4) := "abc"; n : INT; b : BOOL; c : WORD; s : STRING; z : WSTRING;',
        'x := WCONCAT(w, "déf"); n := WLEN(x); c := x[3]; b := "b" > "a€" AND x <> w;'
        ' w[0] := 16#20AC; s := WSTRING_TO_STRING(w); z := STRING_TO_WSTRING(\'é\');'
        ' y := WREPLACE(y, "€", 1, 2);',
        {"x": "abcd", "n": 4, "c": 100, "b": True, "s": "?bc", "z": "é", "y": "a€c"},
    ),
    "ST-713: the chosen text is whole": (
        "",
        "s, t, u, v : STRING; k : INT := 1;",
        "s := SEL(TRUE, 'no', 'longer'); t := MUX(k, 'a', 'bcd', 'e'); u := MAX('ab', 'b', 'a');"
        " v := MIN('ab', 'aa');",
        {"s": "longer", "t": "bcd", "u": "b", "v": "aa"},
    ),
    "ST-713: a selector is evaluated once": (
        COUNTED,
        "a, b : INT;",
        "a := MUX(F_Next(), 10, 20, 30); b := MUX(F_Next(), 10, 20, 30);",
        {"a": 10, "b": 20},
    ),
    "ST-307: dates of texts": (
        "",
        "d : DATE; t : DT; c : TOD; e : DT;",
        "d := STRING_TO_DATE('D#2024-02-29'); t := STRING_TO_DT('DT#1970-01-02-01:00');"
        " c := STRING_TO_TOD('TOD#01:00:00.5'); e := STRING_TO_DT('next week');",
        {"d": 1709164800, "t": 90000, "c": 3600500, "e": 0},
    ),
    "ST-510: an assignment within an expression": (
        "",
        "a, b : INT; r : LREAL; s : STRING;",
        "IF (a := 3) = 3 THEN b := 2 * (a := a + 1); END_IF r := 1.0 + (r := 1.5);",
        {"a": 4, "b": 8, "r": 2.5},
    ),
    "ST-620: ANY has address, size and class": (
        ANY_SIZE,
        "n : INT := 7; d, e : DINT;",
        "d := F_Sum(n, 1.5); e := F_Sum(n + 1, n);",
        {"d": 10207, "e": 208},
    ),
    "ST-620: __VARINFO": (
        "",
        "nSpeed : INT; s : STRING; n : UDINT;",
        "s := __VARINFO(nSpeed).Symbol; n := __VARINFO(nSpeed).BitSize;",
        {"s": "nSpeed", "n": 16},
    ),
    "ST-604: __QUERYINTERFACE": (
        PUMPS,
        "both : FB_Both; one : FB_One; r : I_Run; h : I_Stop; a, b, c, d : BOOL; p : PVOID;",
        "r := both; a := __QUERYINTERFACE(r, h) AND h <> 0; d := __QUERYPOINTER(r, p) AND"
        " p = ADR(both); r := one; b := __QUERYINTERFACE(r, h) OR h <> 0; r := 0;"
        " c := __QUERYINTERFACE(r, h);",
        {"a": True, "b": False, "c": False, "d": True},
    ),
    "ST-403: arguments of FB_init for each element of an array": (
        NUMBERED,
        "a : ARRAY[1..2] OF FB_Numbered[(n := 4), (5)]; b : ARRAY[1..2] OF FB_Numbered(n := 6);"
        " c : ARRAY[1..2] OF ARRAY[0..1] OF FB_Numbered[(1), (2), (3), (4)]; d, e, f : INT;",
        "d := 10 * a[1].nKept + a[2].nKept; e := 10 * b[1].nKept + b[2].nKept;"
        " f := 1000 * c[1][0].nKept + 100 * c[1][1].nKept + 10 * c[2][0].nKept + c[2][1].nKept;",
        {"d": 45, "e": 66, "f": 1234},
    ),
    "ST-404, 621: paths of instances, methods after the initial values": (
        NAMED,
        "a : ARRAY[1..2] OF FB_Named; s, t, u : STRING; n, m : INT;"
        " late : FB_Named := (nLate := 7);",
        "s := a[2].sPath; t := a[1].Name(); u := __POSITION(); n := a[1].nLate; m := late.nLate;",
        {"s": "cell.MAIN.a[2]", "t": "FB_Named.Name", "n": 40, "m": 70},
    ),
    "ST-560: the project's check functions": (
        CHECKS,
        "a : ARRAY[0..3] OF INT; i : INT := 9; n, m : DINT; r, z : LREAL; k : INT(0..5);"
        " p : POINTER TO INT; raw : INT;",
        "a[i] := 5; n := a[3]; m := 7 / (i - 9); r := 3.0 / z; k := i; p^ := 4; raw := F_Raw();",
        {"n": 5, "m": 7, "r": 3.0, "k": 5, "raw": 2},
    ),
    "ST-311: bounds of a computed dimension": (
        "FUNCTION F_Size : DINT VAR_IN_OUT a : ARRAY[*, *] OF INT; END_VAR VAR i : INT; END_VAR FOR"
        " i := 1 TO 2 DO F_Size := F_Size * 100 + UPPER_BOUND(a, i) - LOWER_BOUND(a, i); END_FOR"
        " END_FUNCTION",
        "a : ARRAY[1..3, -1..4] OF INT; n : DINT;",
        "n := F_Size(a);",
        {"n": 205},
    ),
    "ST-401: VAR_IN_OUT CONSTANT takes values": (
        "FUNCTION F_Len : INT VAR_IN_OUT CONSTANT s : STRING; n : INT; END_VAR"
        " F_Len := LEN(s) + n; END_FUNCTION",
        "k : INT; short : STRING(2) := 'xy';",
        "k := F_Len('abc', 4) * 100 + F_Len(short, k + 1);",
        {"k": 703},
    ),
    "ST-606: derived instances where their base is asked for": (
        DERIVED,
        "d : FB_Derived := (n := 5); a, b, c : INT;",
        "a := F_ByReference(d); b := F_ByPointer(ADR(d)); c := F_InPlace(d);",
        {"a": 51, "b": 52, "c": 53},
    ),
    "ST-707: which of both counts": (
        "",
        "sets : SR; resets : RS; a, b, c, d, e : BOOL;",
        "sets(SET1 := TRUE, RESET := TRUE); a := sets.Q1; resets(SET := TRUE, RESET1 := TRUE);"
        " b := resets.Q1; resets(SET := TRUE, RESET1 := FALSE);"
        " sets(SET1 := FALSE, RESET := FALSE); resets(SET := FALSE);"
        " c := sets.Q1; d := resets.Q1; sets(RESET := TRUE); e := sets.Q1;",
        {"a": True, "b": False, "c": True, "d": True, "e": False},
    ),
    "ST-715: sizes in bytes, and the time since the start": (
        "",
        "s : STRING(10); w : WSTRING(10); f : ARRAY[1..3] OF INT; p : POINTER TO BYTE;"
        " a, b, c, d : UDINT; t : TIME; l : LTIME;",
        "a := SIZEOF(s); b := SIZEOF(w); c := SIZEOF(f); d := SIZEOF(p); t := TIME();"
        " l := LTIME();",
        {"a": 11, "b": 22, "c": 6, "d": 8, "t": 0, "l": 0},
    ),
    "ST-721: blocks of memory": (
        "",
        "a, b : ARRAY[0..3] OF BYTE := [1, 2, 3, 4]; none : POINTER TO BYTE;"
        " n, m, z, less, same : DINT; last, copied : BYTE;",
        "m := MEMMOVE(ADR(a[1]), ADR(a[0]), 3); last := a[3]; n := MEMSET(ADR(b), 7, 2);"
        " copied := b[1]; same := MEMCMP(ADR(a[1]), ADR(a[0]), 1); z := MEMCPY(none, ADR(a), 2);"
        " less := MEMCMP(ADR(a), ADR(b), 4);",
        {"m": 3, "last": 3, "n": 2, "copied": 7, "same": 0, "z": 0, "less": -1},
    ),
    "ST-722, 723: times, hexadecimal digits, cases, blanks": (
        "",
        "t : TIMESTRUCT; d : DT; s, h, c, b, f : STRING;",
        "t := DT_TO_SYSTEMTIME(DT#2024-02-29-12:34:56); d := SYSTEMTIME_TO_DT(t);"
        " s := SYSTEMTIME_TO_STRING(FILETIME_TO_SYSTEMTIME(SYSTEMTIME_TO_FILETIME(t)));"
        " h := DWORD_TO_HEXSTR(16#ABC, 4, TRUE); c := F_ToUCase('aÄz');"
        " b := CONCAT(F_LTrim(F_RTrim('  x ')), '|'); f := LREAL_TO_FMTSTR(-12.3456, 3, TRUE);",
        {
            "d": 1709210096, "s": "2024-02-29-12:34:56.000", "h": "0abc", "c": "AÄZ", "b": "x|",
            "f": "-12.346",
        },
    ),
    # 30 bytes of memory hold two records of 8 bytes and their lengths, 4 bytes each.
    "ST-723: records in memory, the oldest one first": (
        "",
        "fb : FB_MemRingBuffer; mem : ARRAY[1..30] OF BYTE; v, w, x : LINT; n, need : UDINT;"
        " full, small, empty : BOOL;",
        "fb.pBuffer := ADR(mem); fb.cbBuffer := SIZEOF(mem); fb.cbWrite := 8; fb.cbRead := 8;"
        " FOR v := 1 TO 3 DO fb.A_AddTail(pWrite := ADR(v)); END_FOR full := NOT fb.bOk;"
        " fb.A_GetHead(pRead := ADR(w), cbRead := 7); small := NOT fb.bOk; need := fb.cbReturn;"
        " fb.A_RemoveHead(pRead := ADR(w), cbRead := 8); v := 16#0102030405060708;"
        " fb.A_AddTail(pWrite := ADR(v)); fb.A_RemoveHead(pRead := ADR(w));"
        " fb.A_RemoveHead(pRead := ADR(x)); n := fb.nCount; fb.A_GetHead(); empty := NOT fb.bOk;",
        {
            "full": True, "small": True, "need": 8, "w": 2, "x": 0x0102030405060708, "n": 0,
            "empty": True,
        },
    ),
    "ST-307: lengths of time in ns, moments with their seconds": (
        "",
        "a, b, c : STRING;",
        "a := LTIME_TO_STRING(LTIME#1H2US); b := DT_TO_STRING(DT#1998-02-13-14:20:00);"
        " c := LWORD_TO_HEXSTR(16#123456789ABCDEF0, 18, FALSE);",
        {"a": "LTIME#1h2us", "b": "DT#1998-02-13-14:20:00", "c": "00123456789ABCDEF0"},
    ),
    "ST-722: lengths and copies of texts by address; what has no room is cut off": (
        "",
        "a : STRING(9) := 'abcdef'; b, c : STRING(5); t : STRING(9);"
        " w : WSTRING(9) := \"a\u20acb\"; v : WSTRING(3); n, m, src, dst : UDINT;"
        " whole, cut, narrow, wide, none : BOOL;",
        "n := LEN2(ADR(a)); m := WLEN2(ADR(w));"
        " whole := STRNCPY(ADR(t), ADR(a), SIZEOF(t));"
        " cut := STRNCPY(ADR(b), ADR(a), 4, nSrcLen => src, nDstLen => dst);"
        " narrow := WSTRING_TO_STRING2(ADR(c), ADR(w), SIZEOF(c));"
        " wide := STRING_TO_WSTRING2(ADR(v), ADR(a), SIZEOF(v));"
        " none := WSTRNCPY(ADR(w), ADR(v), 0);",
        {
            "n": 6, "m": 3, "whole": True, "t": "abcdef", "cut": False, "b": "abc", "src": 6,
            "dst": 3, "narrow": True, "c": "ab", "wide": False, "v": "abc", "none": False,
            "w": "a\u20acb",
        },
    ),
    "ST-722: an address of six numbers as a text": (
        "",
        "ids : T_AmsNetIdArr := [127, 16, 17, 3, 1, 1]; s : T_AmsNetId;",
        "s := F_CreateAmsNetId(ids);",
        {"s": "127.16.17.3.1.1"},
    ),
    "ST-314: a subrange begins with its lowest value": (
        "FUNCTION F : INT VAR n : INT(4..9); END_VAR F := n; END_FUNCTION\n"
        "TYPE T_Low : UINT(2..7); END_TYPE\n",
        "a : T_Low; b : ARRAY[0..1] OF INT(-3..3); c : INT(5..6) := 6; d : INT;",
        "d := F();",
        {"a": 2, "b[1]": -3, "c": 6, "d": 4},
    ),
    "ST-520: an action writes its arguments to the instance": (
        "FUNCTION_BLOCK FB VAR_INPUT n : INT; END_VAR VAR_OUTPUT m : INT; END_VAR\n"
        "ACTION Twice: m := 2 * n; END_ACTION END_FUNCTION_BLOCK\n",
        "fb : FB; a, b : INT;",
        "fb.Twice(n := 4, m => a); fb.Twice(); b := fb.m + fb.n;",
        {"a": 8, "b": 12},
    ),
    "ST-316: what is bound to an unbound reference or a null pointer is unbound": (
        "FUNCTION F : REFERENCE TO INT VAR_INPUT b : BOOL; END_VAR VAR_IN_OUT n : INT; END_VAR\n"
        "IF b THEN F REF= n; END_IF END_FUNCTION\n",
        "r, s, t : REFERENCE TO INT; p : POINTER TO INT; n : INT := 3; a, b, c, d : BOOL; m : INT;",
        "r REF= F(FALSE, n); a := __ISVALIDREF(r); r REF= F(TRUE, n); b := __ISVALIDREF(r);"
        " m := r; s REF= p^; c := __ISVALIDREF(s); t REF= s; d := __ISVALIDREF(t);",
        {"a": False, "b": True, "m": 3, "c": False, "d": False},
    ),
    # After the 8 bytes of its type a block has eight bits in a byte, then n at 10.
    "ST-312, 330: bits of a block lie eight in a byte, those of a union in its first one": (
        "FUNCTION_BLOCK FB VAR a, b, c, d, e, f, g, h, i : BIT; n : INT := -1; END_VAR\n"
        "VAR_OUTPUT at : UDINT; bits : WORD; END_VAR VAR p : POINTER TO WORD; END_VAR\n"
        "b := TRUE; i := n < 0; p := ADR(a); bits := p^;"
        " at := TO_UDINT(ADR(n) - ADR(a)); END_FUNCTION_BLOCK\n"
        "TYPE S : STRUCT a, b, c : BIT; END_STRUCT END_TYPE\n"
        "TYPE U : UNION one : BIT; whole : BYTE; END_UNION END_TYPE\n",
        "fb : FB; u : U; at, bits, size : UDINT; one, two : BOOL; s : S;",
        "s.b := TRUE; s.c := s.a; two := s.b AND NOT s.a AND NOT s.c; fb();"
        " at := fb.at; bits := fb.bits; u.whole := 3; one := u.one;"
        " size := 10 * SIZEOF(U) + SIZEOF(u.one);",
        {"at": 2, "bits": 0x102, "one": True, "two": True, "size": 11},
    ),
    "ST-721: what the system says of the project": (
        "",
        "name : STRING; n : UDINT;",
        "name := _AppInfo.ProjectName; n := _AppInfo.TaskCnt;",
        {"name": "cell", "n": 1},
    ),
    "ST-313: values of an enumeration of a global variable are global names": (
        "VAR_GLOBAL eStep : (Idle, Busy := 5) := Busy; END_VAR\n",
        "n : INT; is : BOOL;",
        "is := eStep = Busy; eStep := Idle; n := Busy + eStep;",
        {"is": True, "n": 5},
    ),
}  # fmt: skip


@pytest.mark.parametrize("rule", CASES)
def test_values_are_those_of_the_rules(tmp_path: Path, rule: str) -> None:
    """Worked out by hand from the rule that is named."""
    before, variables, body, expected = CASES[rule]
    main = f"PROGRAM MAIN\nVAR {variables} END_VAR\n{body}\nEND_PROGRAM\n"
    plc = loaded(tmp_path, f"{before}\n{main}")
    assert not run(plc, 1).errors
    assert {name: plc.read(f"MAIN.{name}") for name in expected} == expected


def test_the_counter_of_the_processor_is_the_time_of_the_cycle(tmp_path: Path) -> None:
    """ST-804: the third cycle of 1 ms runs at 2 ms, which are 20,000 times 100 ns."""
    declared = "VAR fb : GETCPUCOUNTER; lo, hi : UDINT; END_VAR"
    body = "fb(cpuCntLoDW => lo, cpuCntHiDW => hi);"
    plc = loaded(tmp_path, f"PROGRAM MAIN {declared} {body} END_PROGRAM\n")
    assert not run(plc, 3).errors
    assert (plc.read("MAIN.lo"), plc.read("MAIN.hi")) == (20_000, 0)


def test_any_takes_only_its_kinds(tmp_path: Path) -> None:
    """ST-620: a text is no ANY_NUM."""
    text = f"{ANY_SIZE}PROGRAM MAIN VAR n : INT; END_VAR F_Sum(n, 'a'); END_PROGRAM"
    with pytest.raises(Exception, match="C0032"):
        loaded(tmp_path, text)


ENDING = """VAR_GLOBAL nTrail, nSlot : DINT; END_VAR
FUNCTION_BLOCK FB_Valve
VAR nDigit : DINT; END_VAR
METHOD FB_init : BOOL
VAR_INPUT bInitRetains, bInCopyCode : BOOL; nNumber : DINT; END_VAR
nDigit := nNumber;
END_METHOD
METHOD FB_exit : BOOL
VAR_INPUT bInCopyCode : BOOL; END_VAR
nTrail := nTrail * 10 + nDigit;
END_METHOD
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB_Station EXTENDS FB_Valve
VAR inner : FB_Valve(nNumber := 7); END_VAR
METHOD FB_init : BOOL
VAR_INPUT bInitRetains, bInCopyCode : BOOL; nNumber : DINT; END_VAR
END_METHOD
METHOD FB_exit : BOOL
VAR_INPUT bInCopyCode : BOOL; END_VAR
nTrail := nTrail * 10 + 9;
END_METHOD
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR first : FB_Valve(nNumber := 1); both : ARRAY[1..2] OF FB_Valve(nNumber := 3);
station : FB_Station(nNumber := 4); nAtEnd : DINT; END_VAR
nAtEnd := nTrail;
END_PROGRAM
"""


def test_fb_exit_runs_after_the_last_cycle(tmp_path: Path) -> None:
    """ST-405: the last instance first; the derived block (9), its base (4), then its member (7)."""
    plc = loaded(tmp_path, ENDING)
    for _ in range(2):  # each run ends by itself
        assert not run(plc, 3).errors
        assert plc.read("nTrail") == 947331
        assert plc.read("MAIN.nAtEnd") == 0


def test_each_element_has_its_arguments(tmp_path: Path) -> None:
    """ST-403: three groups for two elements are one too many; empty brackets lack n."""
    text = f"{NUMBERED}PROGRAM MAIN VAR a : ARRAY[1..2] OF FB_Numbered[(1), (2), (3)]; END_VAR\n"
    with pytest.raises(Failure, match="902630"):
        loaded(tmp_path, f"{text}END_PROGRAM")


def test_a_fault_in_fb_exit_is_reported(tmp_path: Path) -> None:
    """ST-405, ST-560: number and line; before it 9, 3 / (4 − 3) and 3 / (7 − 3) of the station."""
    text = ENDING.replace("nTrail * 10 + nDigit", "nTrail * 10 + 3 / (nDigit - 3)")
    plc = loaded(tmp_path, text)
    [error] = run(plc, 3).errors
    assert error.span is not None
    assert (error.id, error.span.line) == (902265, 10)
    assert plc.read("nTrail") == 930


UPDATED = """FUNCTION F_Next : DINT
VAR_IN_OUT nCalls : DINT; END_VAR
nCalls := nCalls + 1;
F_Next := nCalls;
END_FUNCTION
FUNCTION_BLOCK FB_Sums
VAR a : ARRAY[1..3] OF INT := [32767, 0, 5]; b : ARRAY[0..1] OF BOOL; END_VAR
VAR i, j : INT := 1; n : DINT; END_VAR
a[i] := a[i] + 1;
a[3] := a[3] - a[i + 2];
b[i] := b[i] OR a[1] < 0;
b[0] := b[i] AND b[0];
a[F_Next(n)] := a[F_Next(n)] + 7;
END_FUNCTION_BLOCK
PROGRAM MAIN VAR fb : FB_Sums; END_VAR fb(); END_PROGRAM
"""


def test_an_element_is_changed_in_its_place(tmp_path: Path) -> None:
    """ST-302, ST-502: a stored sum wraps at its width; an index that calls is evaluated twice."""
    plc = loaded(tmp_path, UPDATED)
    run(plc, 1)
    # The last statement writes a[1] and reads a[2], which is 0.
    assert [plc.read(f"MAIN.fb.a[{i}]") for i in (1, 2, 3)] == [7, 0, 0]
    assert [plc.read(f"MAIN.fb.{name}") for name in ("b[0]", "b[1]", "n")] == [False, True, 2]


def test_a_variable_is_changed_in_its_place(tmp_path: Path) -> None:
    """ST-302, ST-502: the old value counts before an operand that changes it; sums wrap."""
    functions = (
        "FUNCTION F_Set : DINT\nVAR_IN_OUT n : DINT; END_VAR\nn := 100; F_Set := 1;\n"
        "END_FUNCTION\n"
        "FUNCTION F_Local : INT\nVAR k : INT := 32767; END_VAR\nk := k + 2; F_Local := k;\n"
        "END_FUNCTION\n"
    )
    declared = "n : DINT := 5; k : INT; u : USINT := 1; b : BOOL := TRUE; a : ARRAY[0..1] OF DINT;"
    body = "n := n + F_Set(n); k := F_Local(); u := u - 2; b := b AND n = 7; a[1] := a[1] + n;"
    plc = loaded(tmp_path, f"{functions}PROGRAM MAIN VAR {declared} END_VAR {body} END_PROGRAM")
    run(plc, 1)
    names = ("n", "k", "u", "b", "a[1]")
    # 5 + 1; 32767 + 2 - 65536; 1 - 2 + 256
    assert [plc.read(f"MAIN.{name}") for name in names] == [6, -32767, 255, False, 6]


def test_a_changed_element_outside_of_its_array_stops_the_plc(tmp_path: Path) -> None:
    """ST-311, ST-560: the index is reported, nothing is written."""
    body = "i := 4; a[i] := a[i] + 1;"
    declared = "a : ARRAY[0..3] OF DINT; i : DINT;"
    plc = loaded(tmp_path, f"PROGRAM MAIN VAR {declared} END_VAR {body} END_PROGRAM")
    run(plc, 1)
    assert plc.context.fault == 902266
    assert [plc.read(f"MAIN.a[{i}]") for i in range(4)] == [0, 0, 0, 0]

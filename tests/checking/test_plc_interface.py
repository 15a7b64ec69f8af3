# SPDX-License-Identifier: MIT
"""PLC code that does not fit the lists of its machine, and code that cannot be judged."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.changed_lists import machine_with

from nctakt.cli.check import command

NUMBERS = (*range(902361, 902370), 902981)
HEAD = "PROGRAM MAIN\nVAR i : INT; pM : POINTER TO HLI_M_H_PROZESS; b : BOOL; END_VAR\n"
PRESENT = "gpCh[0]^.head.plc_present_w := TRUE;\n"
UNIT = "gpCh[0]^.techno_unit_std_sync[i]"
TAKE = f"pM := ADR({UNIT}.attribut_r.data);\n"
DONE = f"{UNIT}.done_w := TRUE;"


def found_in(folder: Path, body: str) -> list[tuple[int, int]]:
    """Numbers and lines of what is reported beyond the code itself."""
    machine_with(folder / "lists")
    (folder / "nctakt.toml").write_text('machine = "lists"\n', "utf-8")
    (folder / "cell.st").write_text(f"{HEAD}{body}\nEND_PROGRAM\n", "utf-8")
    return reported(folder / "cell.st")


def reported(path: Path) -> list[tuple[int, int]]:
    """Numbers and lines of what is reported beyond the code itself, which has no errors."""
    done = CliRunner().invoke(command, [str(path), "--format", "json"])
    found = json.loads(done.stdout)["diagnostics"]
    assert not [one for one in found if one["severity"] == "error"]
    return [(one["id"], one["line"]) for one in found if one["id"] in NUMBERS]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("b := gpCh[7]^.bahn_state.program_end_r;", [(902361, 3)]),
        ("b := gpCh[0]^.bahn_state.program_end_r;", []),
        (f"gpAx[9]^.head.plc_present_w := TRUE;\n{PRESENT}{DONE}", [(902361, 3)]),
        (PRESENT, [(902362, 3)]),
        (f"{PRESENT}{DONE}", []),
        (f"{PRESENT}{TAKE}CASE pM^.nr OF\n100: {DONE}\nEND_CASE", [(902363, 6)]),
        (
            f"{PRESENT}{TAKE}CASE UDINT_TO_INT(TO_UDINT(pM^.nr)) OF\n100: {DONE}\nEND_CASE",
            [(902363, 6)],
        ),
        (
            f"{PRESENT}{TAKE}IF UDINT_TO_DINT(pM^.nr) = 7777 THEN {DONE} END_IF",
            [(902364, 5), (902363, 5)],
        ),
        (f"{PRESENT}{TAKE}CASE pM^.nr OF\n0..9999: {DONE}\nEND_CASE", []),
        (f"{PRESENT}{TAKE}CASE pM^.nr OF\n100: b := TRUE;\nELSE\n{DONE}\nEND_CASE", []),
        (f"{PRESENT}{TAKE}IF pM^.nr = 7777 THEN b := TRUE; END_IF\n{DONE}", [(902364, 5)]),
        ("gpCh[0]^.bahn_mc_control.insert_cmd.command_w.axis_nr := 1;", [(902365, 3)]),
        (
            "gpCh[0]^.bahn_mc_control.insert_cmd.command_w.axis_nr := 1;\n"
            "gpCh[0]^.bahn_mc_control.insert_cmd.command_semaphor_rw := TRUE;",
            [],
        ),
    ],
)
def test_code_is_compared_with_the_lists(
    tmp_path: Path, body: str, expected: list[tuple[int, int]]
) -> None:
    """ST-762, ST-763: what no code answers, what never comes, what is never taken."""
    assert found_in(tmp_path, body) == expected


@pytest.mark.parametrize(
    ("cycle", "expected"), [("T#1MS", []), ("T#10MS", [(902981, 3)]), ("", [(902981, 3)])]
)
def test_functions_of_realtime_cycles_need_a_fast_task(
    tmp_path: Path, cycle: str, expected: list[tuple[int, int]]
) -> None:
    """ST-802: a task of 10 ms, which is that without any, sees them up to nine ticks later."""
    body = "b := gpCh[0]^.techno_unit_late_sync[0].please_rw;\nEND_PROGRAM\n"
    task = f"TASK T(INTERVAL := {cycle}, PRIORITY := 1); PROGRAM P WITH T : MAIN;"
    whole = f"CONFIGURATION C RESOURCE R ON PLC {task} END_RESOURCE END_CONFIGURATION"
    machine_with(tmp_path / "lists")
    (tmp_path / "nctakt.toml").write_text('machine = "lists"\n', "utf-8")
    (tmp_path / "cell.st").write_text(f"{HEAD}{body}{whole if cycle else ''}", "utf-8")
    assert reported(tmp_path / "cell.st") == expected


def test_code_with_addresses_of_units_is_not_judged(tmp_path: Path) -> None:
    """Other code may answer by the address of the unit."""
    body = f"{PRESENT}i := SEL(ADR({UNIT}) = 0, 1, 2);"
    assert found_in(tmp_path, body) == []


def test_without_a_named_machine_nothing_is_compared(tmp_path: Path) -> None:
    """The demo machine is not the user's."""
    (tmp_path / "cell.st").write_text(f"{HEAD}{PRESENT}END_PROGRAM\n", "utf-8")
    assert reported(tmp_path / "cell.st") == []


STRUCTURE = """TYPE ST_Channel : STRUCT
    fValue2 : LREAL;
    nPos : DINT;
    aGap : ARRAY[1..28] OF BYTE;
    {members}
END_STRUCT
END_TYPE
PROGRAM MAIN
VAR p, q : POINTER TO ST_Channel; END_VAR
p := gpVECh[0];
q := {other};
END_PROGRAM
"""


@pytest.mark.parametrize(
    ("members", "other", "expected"),
    [
        ("nCount : UDINT;", "p", []),
        ("nCount : UDINT;", "gpVECh[0]", []),
        ("nCount : UDINT; fill : UDINT; aList : ARRAY[0..9] OF LREAL; bFlag : BOOL;", "p", []),
        ("nCount : REAL;", "p", [(902366, 5)]),
        ("nCount : REAL;", "GPVECH[0]", [(902366, 5)]),
        ("nCount : UDINT; aList : ARRAY[0..9] OF REAL;", "p", [(902366, 5)]),
        ("nCount : DINT;", "p", [(902366, 5)]),
        ("nCount : UDINT; nHigh : INT; aList : ARRAY[0..9] OF LREAL;", "p", []),
        ("nLow : INT; nHigh : INT;", "p", [(902366, 5), (902366, 5)]),
        ("fCount : LREAL; sText : STRING(700); nFar : DINT;", "p", [(902366, 5)] * 3),
        ("nCount : UDINT;", "gpVEGlob", [(902366, 3), (902366, 5)]),
    ],
)
def test_structures_are_compared_with_the_variables(
    tmp_path: Path, members: str, other: str, expected: list[tuple[int, int]]
) -> None:
    """ST-764: COUNT (UNS32) is at byte 40, LIST at 48; the global SGN32 at 16 lies under a gap."""
    machine_with(tmp_path / "lists")
    (tmp_path / "nctakt.toml").write_text('machine = "lists"\n', "utf-8")
    text = STRUCTURE.format(members=members, other=other)
    (tmp_path / "cell.st").write_text(text, "utf-8")
    assert reported(tmp_path / "cell.st") == expected


def test_a_pointer_that_moves_is_not_judged(tmp_path: Path) -> None:
    """What it points to later may fit."""
    machine_with(tmp_path / "lists")
    (tmp_path / "nctakt.toml").write_text('machine = "lists"\n', "utf-8")
    text = STRUCTURE.format(members="nCount : REAL;", other="p; p := p + 8")
    (tmp_path / "cell.st").write_text(text, "utf-8")
    assert reported(tmp_path / "cell.st") == []

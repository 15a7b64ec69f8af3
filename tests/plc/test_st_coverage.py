# SPDX-License-Identifier: MIT
"""Branch coverage of Structured Text, in one report with realtime cycles."""

from __future__ import annotations

from pathlib import Path

from nctakt import Controller, NcText
from nctakt.plc.structured_text import load_structured
from nctakt.results.coverage import BranchCounts, Coverage, NearestMiss
from nctakt.results.coverage_files import as_json, as_lcov, from_json
from nctakt.results.coverage_text import CoverageText

CELL = """\
PROGRAM MAIN
VAR n, i, sum : INT; fb : FB_Two; END_VAR
n := n + 1;
IF n = 3 OR n > 100 THEN
    sum := 0;
ELSIF n = 4 THEN
    sum := 1;
ELSE
    FOR i := 1 TO 2 DO
        sum := sum + 1;
    END_FOR
END_IF
CASE n OF
    1, 2: fb.Act();
    7: sum := 7;
END_CASE
WHILE sum > 3 DO
    sum := sum - 1;
END_WHILE
END_PROGRAM
FUNCTION_BLOCK FB_Two
VAR b : BOOL; END_VAR
METHOD Act
IF b THEN b := FALSE; END_IF
b := TRUE;
END_METHOD
METHOD Never
b := FALSE;
END_METHOD
END_FUNCTION_BLOCK
"""
CYCLE = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
$IF ONCE V.E.COUNT > 0
V.E.COUNT = 0
$ENDIF
#RT CYCLE END
G04 0.045
M30
"""


def covered(folder: Path) -> Coverage:
    """The coverage of five cycles of the PLC, at 0, 10, … 40 ms, beside a program."""
    path = folder / "cell.st"
    path.write_text(CELL, "utf-8")
    run = Controller().run(NcText("part.nc", CYCLE), plc=load_structured(path), ticks=45, why=True)
    return run.coverage


def row(branch: BranchCounts) -> tuple[int, str, int, int, int]:
    """Line, word, true, false, runs of the body."""
    condition = branch.condition
    return branch.line, branch.word, condition.true, condition.false, branch.bodies


def nearest_of(branch: BranchCounts) -> list[NearestMiss | None]:
    """How near a condition and its operands came to being true, and to being false."""
    conditions = (branch.condition, *branch.parts)
    return [miss for one in conditions for miss in (one.nearest, one.nearest_to_false)]


def nearest_in(folder: Path, condition: str, *statements: str) -> NearestMiss | None:
    """How near a condition came to being true in cycles with n from 1 to 5."""
    path = folder / "near.st"
    path.write_text(
        "TYPE E_Gate : (Shut, Open := 5); END_TYPE\n"
        "FUNCTION F_Next : INT VAR_INPUT n : INT; END_VAR F_Next := n + 1; END_FUNCTION\n"
        "PROGRAM MAIN VAR n : INT; r : REAL; u : ULINT; t : TIME; e : E_Gate; b : BOOL; END_VAR\n"
        f"n := n + 1; {' '.join(statements)}\nIF {condition} THEN n := n; END_IF\nEND_PROGRAM\n",
        "utf-8",
    )
    plc = load_structured(path)
    coverage = Controller().run(NcText("part.nc", CYCLE), plc=plc, ticks=45, why=True).coverage
    (unit,) = [one for one in coverage.cycles if one.name == "MAIN"]
    (branch,) = unit.branches
    if branch.condition.nearest is not None:
        assert "nearest" in CoverageText(coverage, "en").table()
    return branch.condition.nearest


def test_how_near_comparisons_came(tmp_path: Path) -> None:
    """The sides of the evaluation that was nearest, the first one of several; its distance."""
    assert nearest_in(tmp_path, "n > 7") == NearestMiss(5, 7, 2)
    assert nearest_in(tmp_path, "10 - n = 2") == NearestMiss(5, 2, 3)
    assert nearest_in(tmp_path, "ABS(n - 3) < 0") == NearestMiss(0, 0, 0)
    assert nearest_in(tmp_path, "r > 10.5", "r := n * 2;") == NearestMiss(10, 10.5, 0.5)
    huge = 18_446_744_073_709_551_615.0
    assert nearest_in(tmp_path, "u < 5", "u := 16#FFFFFFFFFFFFFFFF;") == NearestMiss(
        huge, 5, huge - 5
    )
    assert nearest_in(tmp_path, "t >= T#1S", "t := T#900MS;") == NearestMiss(900, 1000, 100)
    assert nearest_in(tmp_path, "e = E_Gate.Open") == NearestMiss(0, 5, 5)


def test_nothing_is_near_without_numbers(tmp_path: Path) -> None:
    """A truth, and a comparison that calls code, which might come to the same comparison."""
    assert nearest_in(tmp_path, "b") is None
    assert nearest_in(tmp_path, "b = TRUE") is None
    assert nearest_in(tmp_path, "F_Next(n) > 100") is None


def labels_in(folder: Path, case: str) -> tuple[Coverage, dict[str, NearestMiss | None]]:
    """How near a selector came to labels in cycles with n from 1 to 5."""
    path = folder / "labels.st"
    path.write_text(
        "TYPE E_Gate : (Shut, Open := 5, Gone := 6); END_TYPE\n"
        "PROGRAM MAIN VAR n, k : INT; s : USINT; u : ULINT; e : E_Gate; END_VAR\nn := n + 1;\n"
        f"{case}\nEND_CASE\nEND_PROGRAM\n",
        "utf-8",
    )
    plc = load_structured(path)
    coverage = Controller().run(NcText("part.nc", CYCLE), plc=plc, ticks=45, why=True).coverage
    (unit,) = [one for one in coverage.cycles if one.name == "MAIN"]
    return Coverage((unit,), 1), {one.text: one.condition.nearest for one in unit.branches}


def test_how_near_selectors_came_to_labels(tmp_path: Path) -> None:
    """ST-511: the next value of a label that never fitted, of ELSE the next without a label."""
    case = "CASE n OF\n3: k := 1;\n8, 20..30: k := 2;\n-7..-4: k := 3;"
    coverage, nearest = labels_in(tmp_path, case)
    assert nearest == {
        "3: k := 1;": None,
        "8, 20..30: k := 2;": NearestMiss(5, 8, 3),
        "-7..-4: k := 3;": NearestMiss(1, -4, 5),
    }
    assert "never reached, nearest 5 = 8, 3 away" in CoverageText(coverage, "en").table()
    assert from_json("x", as_json(coverage)) == coverage
    twice = coverage.plus(coverage).cycles[0].branches[1]
    assert (twice.bodies, twice.condition.nearest) == (0, NearestMiss(5, 8, 3))


def test_how_near_selectors_came_to_else(tmp_path: Path) -> None:
    """Values without a label lie between those with one, and within the type."""
    _, nearest = labels_in(tmp_path, "CASE n OF\n0..7, 9..30000: k := 1;\nELSE\nk := 2;")
    assert nearest["ELSE"] == NearestMiss(1, -1, 2)
    _, nearest = labels_in(tmp_path, "CASE s OF\n0..200, 202..255: k := 1;\nELSE\nk := 2;")
    assert nearest["ELSE"] == NearestMiss(0, 201, 201)
    _, nearest = labels_in(tmp_path, "CASE s OF\n0..255: k := 1;\nELSE\nk := 2;")
    assert nearest["ELSE"] is None
    _, nearest = labels_in(tmp_path, "e := 5; CASE e OF\nE_Gate.Gone: k := 1;")
    assert nearest["E_Gate.Gone: k := 1;"] == NearestMiss(5, 6, 1)


def test_labels_beyond_signed_numbers(tmp_path: Path) -> None:
    """ST-303, ST-511: labels of ULINT from 2⁶³ on, and a range across it."""
    case = (
        "u := ULINT#16#8000000000000000 + INT_TO_ULINT(n);\nCASE u OF\n"
        "16#FFFFFFFFFFFFFFFF: k := 1;\n10..16#8000000000000002: k := 2;\n"
        "16#8000000000000003: k := 3;\nELSE\nk := 4;"
    )
    coverage, nearest = labels_in(tmp_path, case)
    assert [one.bodies for one in coverage.cycles[0].branches] == [0, 2, 1, 2]
    miss = nearest["16#FFFFFFFFFFFFFFFF: k := 1;"]
    assert miss is not None and miss.right == float((1 << 64) - 1)


def test_branches_of_the_plc_are_counted(tmp_path: Path) -> None:
    """n is 1 … 5: 3 takes the IF, 4 the ELSIF, the others ELSE, whose FOR passes twice each."""
    units = {cycle.name: cycle for cycle in covered(tmp_path).cycles}
    main = units["MAIN"]
    assert (main.scope, main.runs) == ("PROGRAM", 5)
    assert [row(branch) for branch in main.branches] == [
        (4, "IF", 1, 4, 1),
        (6, "ELSIF", 1, 3, 1),
        (9, "ELSE", 3, 0, 3),
        (9, "FOR", 6, 0, 6),
        (14, "CASE", 2, 0, 2),
        (15, "CASE", 0, 0, 0),
        # sum is 2, 4, 0, 1, 3 before the loop.
        (17, "WHILE", 1, 5, 1),
    ]
    assert [(part.text, part.true, part.false) for part in main.branches[0].parts] == [
        ("n = 3", 1, 4),
        ("n > 100", 0, 5),
    ]
    nearest = [one and (one.left, one.right, one.distance) for one in nearest_of(main.branches[0])]
    assert nearest == [None, None, None, None, (5, 100, 95), None]
    assert nearest_of(main.branches[6]) == [None, None]
    assert [main.branches[index].outer for index in (2, 3, 4)] == [None, 2, None]
    act, never = units["FB_Two.Act"], units["FB_Two.Never"]
    assert (act.scope, act.runs, row(act.branches[0])) == ("METHOD", 2, (24, "IF", 1, 1, 1))
    assert never.runs == 0


def test_one_report_with_realtime_cycles(tmp_path: Path) -> None:
    """As a table, as JSON and back, as LCOV: labels of CASE are branches, conditions are two."""
    coverage = covered(tmp_path)
    assert {cycle.scope for cycle in coverage.cycles} == {"PROGRAM", "METHOD", "PROG"}
    assert from_json("x", as_json(coverage)) == coverage
    assert coverage.plus(coverage).cycles[0].runs == 2 * coverage.cycles[0].runs
    table = CoverageText(coverage, "en").table()
    assert f"{tmp_path}/cell.st:1  PROGRAM MAIN, run 5 times, 6 of 7 branches ran" in table
    assert "METHOD FB_Two.Never, never called" in table
    (record,) = [one for one in as_lcov(coverage).split("end_of_record") if "cell.st" in one]
    assert "BRDA:4,0,0,1\nBRDA:4,0,1,4\nBRDA:6,0,0,1\nBRDA:6,0,1,3\nBRDA:14,0,0,2\n" in record
    assert "DA:10,6\n" in record
    assert "DA:28,0\n" in record


def test_counting_changes_nothing(tmp_path: Path) -> None:
    """A run whose branches are counted has the same values and the same instructions."""
    path = tmp_path / "cell.st"
    path.write_text(CELL, "utf-8")
    states = []
    for why in (False, True):
        plc = load_structured(path)
        Controller().run(NcText("part.nc", CYCLE), plc=plc, ticks=45, why=why)
        states.append((bytes(plc.data()), plc.context.steps))
    assert states[0] == states[1]

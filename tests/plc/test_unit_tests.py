# SPDX-License-Identifier: MIT
"""Suites of unit tests in Structured Text under the names of TcUnit (ST-901 … ST-903)."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.lists.machine.machine import load_machine
from nctakt.plc.structured_text import load_structured
from nctakt.plc.unit_tests import Outcome, SuiteResults, load_suites, run_suites, suites_of

#: Further assertions, with what a failure shows, if it is one.
FURTHER = [
    ("AssertTrue(FALSE, '');", "TRUE", "FALSE"),
    ("AssertFalse(TRUE, '');", "FALSE", "TRUE"),
    ("AssertEquals_LREAL(1.0, 1.5, 0.25, '');", "1.0", "1.5"),
    ("AssertEquals_REAL(1.0, 1.25, 0.25, '');", "", ""),
    ("AssertEquals(n, r, '');", "INT#7", "REAL#1.5"),
    ("AssertEquals('a', 'ab', '');", "STRING#a", "STRING#ab"),
    ("AssertEquals(short, long, '');", "", ""),
    ("AssertArrayEquals_INT(a, b, '');", "[1] = 2", "[2] = 4"),
    ("AssertArrayEquals_INT(a, c, '');", "bounds 0..2", "bounds 0..1"),
    ("AssertArrayEquals_INT(a, d, '');", "", ""),
    ("AssertArray2dEquals_REAL(p, q, 0.5, '');", "[0,1] = 2.0", "[0,1] = 3.0"),
    ("AssertArray3dEquals_LREAL(x, y, 0.5, '');", "[0,0,0] = 1.0", "[1,0,0] = 4.0"),
]

PROGRAM = "PROGRAM MAIN VAR fbSuite : FB_Suite; END_VAR TcUnit.RUN(); END_PROGRAM\n"

#: An expression of each type, another value of it, and both as a failure shows them.
VALUES = [
    ("BOOL", "TRUE", "FALSE", "TRUE", "FALSE"),
    ("BYTE", "16#10", "17", "16", "17"),
    ("SINT", "-1", "1", "-1", "1"),
    ("UINT", "65535", "0", "65535", "0"),
    ("LINT", "-5000000000", "5000000000", "-5000000000", "5000000000"),
    ("ULINT", "18446744073709551615", "1", "18446744073709551615", "1"),
    ("TIME", "T#1s", "T#1500ms", "T#1s", "T#1s500ms"),
    ("LTIME", "LTIME#5NS", "LTIME#1US", "LTIME#5ns", "LTIME#1us"),
    ("DATE", "D#2024-02-29", "D#2024-03-01", "D#2024-02-29", "D#2024-03-01"),
    ("STRING", "'one'", "'two'", "one", "two"),
    ("WSTRING", '"one"', '"two"', "one", "two"),
]  # fmt: skip


def results(folder: Path, suite: str, program: str = PROGRAM, until: float = 1.0) -> SuiteResults:
    """What a run of a text with suites finds."""
    path = folder / "suites.st"
    path.write_text(suite + program, "utf-8")
    return run_suites(load_suites(path), load_machine(None), until)


def outcomes(folder: Path, body: str, members: str = "", until: float = 1.0) -> dict[str, Outcome]:
    """What has become of the tests of ``MAIN.fbSuite`` with a body."""
    text = f"FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite\n{members}\n{body}\nEND_FUNCTION_BLOCK\n"
    return results(folder, text, until=until).outcomes["MAIN.fbSuite"]


def test_values_are_compared_and_shown(tmp_path: Path) -> None:
    """ST-903: equal ones pass; of others expected and actual value, line and tick are shown.

    Reals are equal within Delta, texts of other lengths and arrays with other bounds may be.
    """
    cases = [(f"AssertEquals_{name}({one}, {one}, '');", "", "") for name, one, *_ in VALUES]
    cases += [
        (f"AssertEquals_{name}({one}, {other}, '');", expected, actual)
        for name, one, other, expected, actual in VALUES
    ]
    cases += FURTHER
    members = """VAR n : INT := 7; r : REAL := 1.5; short : STRING(5) := 'a'; long : STRING := 'a';
        a : ARRAY[0..2] OF INT := [1, 2, 3]; b : ARRAY[1..3] OF INT := [1, 4, 3];
        c : ARRAY[0..1] OF INT; d : ARRAY[-1..1] OF INT := [1, 2, 3];
        p : ARRAY[0..0, 0..1] OF REAL := [1.0, 2.0]; q : ARRAY[0..0, 0..1] OF REAL := [1.5, 3.0];
        x : ARRAY[0..0, 0..0, 0..0] OF LREAL := [1.0];
        y : ARRAY[1..1, 0..0, 0..0] OF LREAL := [4.0]; END_VAR"""
    body = [f"TEST('{i}'); {case[0]} TEST_FINISHED();" for i, case in enumerate(cases)]
    found = outcomes(tmp_path, "\n".join(body), members)
    first = members.count("\n") + 3
    for number, (statement, expected, actual) in enumerate(cases):
        problems = found[str(number)].problems
        assert found[str(number)].asserts == 1
        if not expected:
            assert problems == [], statement
            continue
        where = f"{tmp_path}/suites.st:{first + number}: {body[number]}"
        assert problems == [f"{where}\n    EXP: {expected}\n    ACT: {actual}\n    at 0 s, tick 0"]


def test_tests_of_several_cycles(tmp_path: Path) -> None:
    """ST-902: the first failure is the result; nothing counts after the end; turns are taken.

    The next ordered test's turn begins in the cycle in which the finished one is called again.
    ST-903: WRITE_PROTECTED sets what a program may only read.
    """
    body = """n := n + 1;
        TEST(' t '); AssertEquals_INT(n, 2, 'second'); AssertTrue(FALSE, 'later');
        IF n = 3 THEN TEST_FINISHED(); END_IF
        TEST('ends'); TEST_FINISHED(); AssertTrue(FALSE, 'after the end');
        IF TEST_ORDERED('a') THEN IF n = 2 THEN TEST_FINISHED(); END_IF END_IF
        IF TEST_ORDERED('disabled_b') THEN AssertTrue(FALSE, 'disabled'); END_IF
        IF TEST_ORDERED('c') THEN AssertEquals_INT(3, n, 'turn'); TEST_FINISHED(); END_IF
        TEST('w'); WRITE_PROTECTED_INT(ADR(nIn), 5); AssertEquals_INT(5, nIn, '');
        TEST_FINISHED();"""
    found = outcomes(tmp_path, body, "VAR n : INT; nIn AT %I* : INT; END_VAR")
    (problem,) = found.pop("t").problems
    assert problem.split(": ")[1].splitlines()[0] == "second"
    assert {name: one.problems for name, one in found.items()} == {
        "ends": [], "a": [], "b": [], "c": [], "w": [],
    }  # fmt: skip
    assert found["b"].is_disabled
    assert found["a"].duration_us == 10_000


def test_suites_run_in_sequence(tmp_path: Path) -> None:
    """ST-901: by RUN_IN_SEQUENCE the second suite begins after the first one has ended."""
    text = """VAR_GLOBAL nEnded : INT; END_VAR
        FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite
        VAR n : INT; END_VAR
        VAR_INPUT nFirst : INT; END_VAR
        TEST('t'); AssertEquals_INT(nFirst, nEnded, 'ended before'); n := n + 1;
        IF n = 5 THEN nEnded := nEnded + 1; TEST_FINISHED(); END_IF
        END_FUNCTION_BLOCK
        """
    program = """PROGRAM MAIN
        VAR aSuites : ARRAY[1..2] OF FB_Suite := [(nFirst := 0), (nFirst := 1)]; END_VAR
        TcUnit.RUN_IN_SEQUENCE(); END_PROGRAM"""
    found = results(tmp_path, text, program)
    assert list(found.outcomes) == ["MAIN.aSuites[1]", "MAIN.aSuites[2]"]
    assert [one["t"].problems for one in found.outcomes.values()] == [[], []]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (
            "TEST('t'); AssertTrue(TRUE, '');\nTEST('u'); TEST_FINISHED();\nTEST('u');",
            {"t": (902540, 3), "u": (902543, 5)},
        ),
        ("TEST('t');\nTEST_FINISHED_NAMED('u');", {"t": (902544, 4)}),
        ("TEST('t');\nn := n / n;", {"t": (902265, 4)}),
    ],
    ids=["never ends, equal names", "unknown name", "fault"],
)
def test_mistakes_have_their_place(
    tmp_path: Path, body: str, expected: dict[str, tuple[int, int]]
) -> None:
    """Tests that never end, equal names, unknown names, faults fail with number, file, line."""
    found = outcomes(tmp_path, body, "VAR n : INT; END_VAR", until=0.05)
    for name, (number, line) in expected.items():
        (problem,) = found[name].problems
        assert f"suites.st:{line}:" in problem
        assert str(number) in problem


def test_what_belongs_to_no_test_fails_all_of_its_suite(tmp_path: Path) -> None:
    """An assertion before the first TEST, in the first cycle."""
    text = """FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite
        AssertTrue(FALSE, '');
        TEST('t'); TEST_FINISHED();
        END_FUNCTION_BLOCK
        """
    (problem,) = results(tmp_path, text).problems["MAIN.fbSuite"]
    assert "suites.st:2:9: error 902542" in problem


@pytest.mark.parametrize(
    ("before", "number"),
    [("n := n / n;", 902265), ("IF n = 0 THEN RETURN; END_IF TEST('first');", 902540)],
    ids=["fault", "never opened"],
)
def test_no_test_passes_that_had_no_turn(tmp_path: Path, before: str, number: int) -> None:
    """ST-904: what a suite had not opened when its run ended has failed, with the reason."""
    body = f"{before} TEST('later'); TEST_FINISHED(); TEST(CONCAT('a', 'b')); TEST_FINISHED();"
    members = "VAR n : INT; END_VAR TEST('begins');" if number == 902540 else "VAR n : INT; END_VAR"
    found = outcomes(tmp_path, body, members, until=0.05)
    assert {"later", "tests with computed names"} <= set(found)
    for one in found.values():
        (problem,) = one.problems
        assert f"error {number}: " in problem


def test_a_fault_before_the_first_call_is_no_missing_call(tmp_path: Path) -> None:
    """902546 is for suites that no task calls, not for those that a fault kept from their turn."""
    text = """FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite
        TEST('t'); TEST_FINISHED();
        END_FUNCTION_BLOCK
        PROGRAM MAIN VAR fbSuite : FB_Suite; n : INT; END_VAR n := n / n; TcUnit.RUN(); END_PROGRAM
        """
    found = results(tmp_path, text, "", until=0.05)
    assert found.problems["MAIN.fbSuite"] == []
    (problem,) = found.outcomes["MAIN.fbSuite"]["t"].problems
    assert "suites.st:4:63: error 902265" in problem


def test_many_tests_of_one_suite(tmp_path: Path) -> None:
    """Finding a test by its name takes no longer the more there are, also out of their order."""
    names = [f"test {number:04}" for number in range(1000)]
    first = [f"TEST('{name}'); TEST_FINISHED();" for name in names]
    again = [f"TEST('{name}'); IF n = 0 THEN TEST_FINISHED(); END_IF" for name in names[::-1]]
    body = "n := n + 1;\nIF n = 1 THEN TEST('last');\n{}\nELSE {}\nTEST('last'); TEST_FINISHED();"
    text = body.format("\n".join(first), "\n".join(again)) + " END_IF"
    found = outcomes(tmp_path, text, "VAR n : INT; END_VAR")
    assert len(found) == 1001
    assert [name for name, one in found.items() if one.problems] == []


def test_a_suite_that_nothing_calls(tmp_path: Path) -> None:
    """902546: without TcUnit.RUN no test of it begins."""
    text = """FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite
        TEST('t'); TEST_FINISHED();
        END_FUNCTION_BLOCK
        PROGRAM MAIN VAR fbSuite : FB_Suite; END_VAR END_PROGRAM"""
    (problem,) = results(tmp_path, text, "", until=0.05).problems["MAIN.fbSuite"]
    assert "error 902546: no task calls MAIN.fbSuite" in problem


def test_tests_are_found_without_a_run(tmp_path: Path) -> None:
    """By the text of a suite and its bases; computed names are known in a run only."""
    text = """FUNCTION_BLOCK FB_Base EXTENDS FB_TestSuite
        METHOD InBase TEST('in base'); TEST_FINISHED(); END_METHOD
        END_FUNCTION_BLOCK
        FUNCTION_BLOCK FB_Suite EXTENDS FB_Base
        VAR n : INT; END_VAR
        InBase(); TEST('disabled_own'); TEST_FINISHED();
        TEST(CONCAT('number ', INT_TO_STRING(n))); TEST_FINISHED();
        END_FUNCTION_BLOCK
        """
    path = tmp_path / "suites.st"
    path.write_text(text + PROGRAM, "utf-8")
    (suite,) = suites_of(load_structured(path).program)
    assert [(one.name, one.span.line) for one in suite.tests.values()] == [
        ("in base", 2),
        ("own", 6),
    ]
    assert suite.has_others
    found = results(tmp_path, text).outcomes["MAIN.fbSuite"]
    assert list(found) == ["in base", "own", "number 0"]


def test_the_projects_own_text_is_beside_a_file_with_suites(tmp_path: Path) -> None:
    """Its blocks are known; its programs do not run."""
    (tmp_path / "cell.st").write_text(
        """VAR_GLOBAL bHasRun : BOOL; END_VAR
        FUNCTION F_Two : INT F_Two := 2; END_FUNCTION
        PROGRAM MAIN bHasRun := TRUE; END_PROGRAM""",
        "utf-8",
    )
    path = tmp_path / "suites.st"
    path.write_text(
        """FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite
        VAR n : INT; END_VAR
        TEST('t'); AssertEquals_INT(2, F_Two(), ''); AssertFalse(bHasRun, ''); n := n + 1;
        IF n > 2 THEN TEST_FINISHED(); END_IF
        END_FUNCTION_BLOCK
        PROGRAM PRG_TEST VAR fbSuite : FB_Suite; END_VAR TcUnit.RUN(); END_PROGRAM""",
        "utf-8",
    )
    plc = load_suites(path, tmp_path / "cell.st")
    found = run_suites(plc, load_machine(None)).outcomes["PRG_TEST.fbSuite"]
    assert found["t"].problems == []
    assert found["t"].duration_us == 20_000

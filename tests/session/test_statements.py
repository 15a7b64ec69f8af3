# SPDX-License-Identifier: MIT
"""A session within a cycle of its PLC: statements in the order of the tick, forward and back.

The task runs each 2 ms, so in ticks 0, 2, 4 … of the demo machine, whose tick is 1 ms. A cycle
passes these lines: 20, 21, in Tick 9, 10, 11, then 22, in the body of the gate 13 (and 14 from the
third cycle on), in the loop 24 twice after 23.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from nctakt import NcText
from nctakt.base.failure import Failure
from nctakt.plc.stepping.beside import Line
from nctakt.session.session import Session
from nctakt.session.statements import PlcPlace
from nctakt.session.stops import StopAt

TASK = """\
CONFIGURATION Cell
RESOURCE Controller ON PLC
TASK Fast(INTERVAL := T#2MS, PRIORITY := 1);
PROGRAM Main1 WITH Fast : MAIN;
END_RESOURCE
END_CONFIGURATION
"""
CELL = """\
TYPE E_Gate : (Closed, Open := 5); END_TYPE
TYPE ST_Tool : STRUCT nLife : INT; pNext : POINTER TO ST_Tool; END_STRUCT END_TYPE
FUNCTION_BLOCK FB_Gate
VAR_INPUT bGo : BOOL; END_VAR
VAR nCount : INT; eGate : E_Gate; aTools : ARRAY[1..3] OF ST_Tool; END_VAR
METHOD Tick : INT
VAR_INPUT nBy : INT; END_VAR
VAR nLocal : INT; END_VAR
nLocal := nBy * 2;
nCount := nCount + nLocal;
Tick := nCount;
END_METHOD
IF bGo THEN
    eGate := E_Gate.Open;
END_IF
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR n, m, i : INT; fbGate : FB_Gate; pTool : POINTER TO ST_Tool; END_VAR

n := n + 1;
m := fbGate.Tick(n);
fbGate(bGo := n > 2);
FOR i := 1 TO 2 DO
    m := m + i;
END_FOR
END_PROGRAM
"""
NC = "G01 X20 F1000\nM30"
FIRST = [20, 21, 9, 10, 11, 22, 13, 23, 24, 24]


@pytest.fixture(scope="module")
def cell(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("cell") / "cell.st"
    path.write_text(CELL + TASK, "utf-8")
    return path


@pytest.fixture
def session(cell: Path) -> Iterator[Session]:
    with Session(NcText("p.nc", NC), plc=cell) as own:
        yield own


def line(found: PlcPlace | None) -> tuple[int, int, int]:
    """Tick, number and line of a place."""
    assert found is not None
    span = found.frames[0].span
    assert span is not None
    return found.tick, found.number, span.line


def test_steps_go_through_a_cycle_in_the_order_of_the_tick(session: Session) -> None:
    """ST-801, ST-520: into calls; then the next cycle, in tick 2; the same way back."""
    there = [line(session.step_statement()) for _ in range(12)]
    first = [(0, number, own) for number, own in enumerate(FIRST, 1)]
    assert there == [*first, (2, 1, 20), (2, 2, 21)]
    back = [line(session.step_statement_back()) for _ in range(11)]
    assert back == there[-2::-1]
    assert session.step_statement_back() is None
    assert line(session.statement) == (0, 1, 20)


def test_steps_over_and_out_pass_calls(session: Session) -> None:
    session.step_statement()
    session.step_statement()
    assert line(session.step_statement("over")) == (0, 6, 22)
    assert line(session.step_statement_back("over")) == (0, 2, 21)
    assert line(session.step_statement("into")) == (0, 3, 9)
    assert line(session.step_statement("over")) == (0, 4, 10)
    assert line(session.step_statement_back("out")) == (0, 2, 21)
    session.step_statement("into")
    assert line(session.step_statement("out")) == (0, 6, 22)


def test_a_stop_at_a_line_has_a_condition_in_its_own_language(session: Session) -> None:
    """nBy is n of the caller: 3 in the third cycle, which is in tick 4; nothing is called by it."""
    done = session.run(until="statement cell.st:9 if nBy = 3 AND nCount > 0")
    assert (done.hits, done.tick) == ((0,), 5)
    assert line(session.statement) == (4, 3, 9)
    assert session.value("nBy").text == "3"
    assert session.value("nCount").text == "6"  # 2 · (1 + 2)
    assert session.back_to(StopAt("statement", file="cell.st", line=24)) is not None
    assert line(session.statement)[::2] == (2, 24)
    assert session.value("i").text == "2"  # the last pass of the loop


def played(session: Session) -> PlcPlace | None:
    """Let a session go on by itself until it stops; return where it is then."""
    session.play()
    while session.is_playing:
        time.sleep(0.005)
    return session.statement


def test_what_goes_on_by_itself_stops_before_statements_too(session: Session) -> None:
    session.set_stops("statement cell.st:24")
    seen = [line(played(session)) for _ in range(3)]
    assert seen == [(0, 9, 24), (0, 10, 24), (2, 9, 24)]
    assert session.value("i").text == "1"
    session.set_stops()
    assert played(session) is None and session.is_over


def test_the_body_after_a_method_is_not_the_method(session: Session) -> None:
    """ST-520: in plain text, the body of a block comes after its methods."""
    session.run(until="statement cell.st:13 if bGo")
    place = session.statement
    assert place is not None
    assert [(one.name, one.instance) for one in place.frames] == [
        ("FB_Gate", "MAIN.fbGate"), ("MAIN", "MAIN"),
    ]  # fmt: skip
    assert session.scopes()[:2] == ["VAR_INPUT", "VAR"]
    assert session.value("nCount").text == "12"  # 2 · (1 + 2 + 3)


def test_hits_within_a_tick_come_one_after_the_other(session: Session) -> None:
    stop = StopAt("statement", file="cell.st", line=24)
    seen = []
    for _ in range(4):
        session.run(until=stop)
        seen.append((line(session.statement), session.value("i").text))
    assert seen == [
        ((0, 9, 24), "1"), ((0, 10, 24), "2"), ((2, 9, 24), "1"), ((2, 10, 24), "2"),
    ]  # fmt: skip


def test_calls_scopes_and_trees_are_those_before_the_statement(session: Session) -> None:
    """ST-330, ST-520: nLocal is 4 after line 9 of the second cycle, nCount is still 2."""
    session.run(until=StopAt("statement", file="cell.st", line=10, only_if="nBy = 2"))
    found = session.statement
    assert found is not None
    assert [(one.name, one.instance) for one in found.frames] == [
        ("FB_Gate.Tick", "MAIN.fbGate"), ("MAIN", "MAIN"),
    ]  # fmt: skip
    assert session.scopes() == ["result", "VAR_INPUT", "VAR", "THIS^", "VAR_GLOBAL", "PROGRAM"]
    assert [(one.name, one.text) for one in session.of_scope("VAR")] == [("nLocal", "4")]
    this = {one.name: one for one in session.of_scope("THIS^")}
    assert this["nCount"].text == "2"
    assert this["eGate"].text == "E_Gate.Closed"
    assert (this["aTools"].count, this["aTools"].indexed) == (3, True)
    assert this["nCount"].settable == "MAIN.fbGate.nCount"
    tools = session.below("aTools", first=1, count=1)
    assert [(one.name, one.count) for one in tools] == [("[2]", 2)]
    assert [one.text for one in session.below("aTools[2]")] == ["0", "null"]
    assert session.value("n", level=1).text == "2"
    assert session.value("MAIN.m").text == "5"  # 2 + 1 + 2 in the first cycle
    assert session.value("nLocal * 2 > nCount").text == "TRUE"


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("nMissing", 902812),
        ("pTool^.nLife", 902813),  # ST-315: it is null
        ("fbGate.Tick(1)", 902814),  # a call might never end, or change what is looked at
        ("n := 3", 902180),
    ],
)
def test_a_question_that_changes_or_reads_nothing_is_refused(
    session: Session, text: str, number: int
) -> None:
    session.step_statement()
    with pytest.raises(Failure) as refused:
        session.value(text)
    assert refused.value.diagnostics[0].id == number
    assert session.value("n").text == "0"


@pytest.mark.parametrize(
    ("stop", "number"),
    [
        (StopAt("statement", file="cell.st", line=19), 902811),
        (StopAt("statement", file="cell.st", line=20, only_if="n"), 902817),
        (StopAt("statement", file="cell.st", line=20, only_if="fbGate.Tick(1) > 0"), 902814),
    ],
)
def test_a_stop_that_cannot_hold_is_refused(session: Session, stop: StopAt, number: int) -> None:
    with pytest.raises(Failure) as refused:
        session.set_stops(stop)
    assert refused.value.diagnostics[0].id == number


def test_without_structured_text_there_are_no_statements() -> None:
    with Session(NcText("p.nc", NC)) as session:
        with pytest.raises(Failure) as refused:
            session.step_statement()
        assert refused.value.diagnostics[0].id == 902810


def test_what_is_written_counts_from_the_next_tick_on(session: Session) -> None:
    """RC-002, ST-402: it is an input on the tape; pointers only become null (ST-315)."""
    session.run(until=StopAt("statement", file="cell.st", line=21))
    session.write({"MAIN.fbGate.nCount": 100}, "debugger")
    session.step_statement("over")
    assert session.value("m").text == "2"
    session.run(until=StopAt("statement", file="cell.st", line=22))
    assert session.value("m").text == "104"  # 100 + 2 · 2
    assert [one.values for one in session.tape()] == [("MAIN.fbGate.nCount", 100)]
    with pytest.raises(Failure) as refused:
        session.write({"MAIN.pTool": 5000})
    assert refused.value.diagnostics[0].id == 902815
    session.write({"MAIN.pTool": 0})


def test_a_fault_shows_its_calls_and_their_variables(tmp_path: Path) -> None:
    """ST-560: the index 4 of 1 … 3 in the fourth cycle, in tick 6; both calls are open."""
    text = """\
FUNCTION F_Pick : INT
VAR_INPUT nAt : INT; END_VAR
VAR aList : ARRAY[1..3] OF INT; END_VAR
F_Pick := aList[nAt];
END_FUNCTION
PROGRAM MAIN
VAR n, m : INT; END_VAR
n := n + 1;
m := F_Pick(n);
END_PROGRAM
"""
    path = tmp_path / "cell.st"
    path.write_text(text + TASK, "utf-8")
    with Session(NcText("p.nc", NC), plc=path) as session:
        done = session.run(until="fault")
        found = session.statement
        assert (done.tick, found is not None) == (7, True)
        assert found is not None and found.fault is not None and found.fault.id == 902266
        assert [(one.name, one.span and one.span.line) for one in found.frames] == [
            ("F_Pick", 4), ("MAIN", 9),
        ]  # fmt: skip
        assert session.value("nAt").text == "4"
        assert session.value("n", level=1).text == "4"
        with pytest.raises(Failure) as refused:
            session.step_statement()
        assert refused.value.diagnostics[0].id == 902818
        assert line(session.step_statement_back()) == (6, 3, 4)


def test_debugging_changes_no_result(cell: Path) -> None:
    """The PLC's data and the signals after 40 ticks: stepped through, and not."""
    names = ("MAIN.n", "MAIN.m", "MAIN.fbGate.nCount", "X.ACS.ACT_POS")
    with Session(NcText("p.nc", NC), plc=cell) as plain:
        plain.step(40)
        expected = plain.read(*names)
    with Session(NcText("p.nc", NC), plc=cell) as watched:
        watched.set_stops(StopAt("statement"))
        for _ in range(15):
            watched.step_statement()
        watched.step_statement_back("over")
        watched.set_stops()
        watched.run("40 ms")
        assert watched.read(*names) == expected


def test_values_beside_lines_are_those_of_their_unit(session: Session, cell: Path) -> None:
    """After tick 0 (n = 1, nCount = 2): a local variable lives only while its method is open."""
    file = cell.as_posix()
    assert session.plc_instances(file) == ["MAIN.fbGate"]
    session.step()
    wanted = [
        (20, ["n"]),
        (9, ["nLocal", "nBy"]),
        (10, ["nCount"]),
        (14, ["eGate"]),
        (24, ["fbGate"]),
    ]
    gate = "MAIN.fbGate"
    assert session.texts_beside(file, wanted, 0, gate) == [
        ["1"],
        ["", ""],
        ["2"],
        ["E_Gate.Closed"],
        [""],
    ]
    assert session.texts_beside(file, wanted[2:3]) == [[""]]
    assert session.texts_beside(file, wanted[2:3], 0, "MAIN") == [[""]]
    session.back()
    session.run(until="statement cell.st:10")
    assert session.texts_beside(file, wanted[:3]) == [["1"], ["2", "1"], ["0"]]
    assert session.texts_beside(file, [(10, ["nCount"])], 1) == [[""]]


def test_what_a_line_names_unfolds_as_a_tree(session: Session, cell: Path) -> None:
    """What is opened, with paths as the line has them; nothing where the name has no value."""

    def tree(line: Line, *opened: str, instance: str = "") -> list[tuple[int, str, str, str]]:
        found = session.tree_beside(file, line, opened, None, instance)
        return [(depth, one.name, one.path, one.text) for depth, one in found]

    file = cell.as_posix()
    session.step()
    of_gate = session.below("MAIN.fbGate", None)
    unfolded = tree((24, ["fbGate", "unknown", "n"]), "fbGate", "n", "other")
    assert [row[:3] for row in unfolded] == [
        (0, "fbGate", "fbGate"),
        *((1, one.name, f"fbGate.{one.name}") for one in of_gate),
        (0, "n", "n"),
    ]
    assert [text for _, _, _, text in unfolded[1:-1]] == [one.text for one in of_gate]
    assert len(tree((24, ["fbGate"]))) == 1
    assert tree((10, ["nCount"])) == []
    assert tree((10, ["nCount"]), instance="MAIN.fbGate") == [(0, "nCount", "nCount", "2")]

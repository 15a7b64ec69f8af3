# SPDX-License-Identifier: MIT
"""The debugger within a PLC in Structured Text, beside the NC program.

The task runs each 2 ms, in ticks 0, 2, 4 …; a cycle passes lines 14, 15, in Tick 8 and 9, then 16
in the loop 17 twice.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support.debug_client import DebugClient, Refused

pytestmark = pytest.mark.slow

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
FUNCTION_BLOCK FB_Gate
VAR_INPUT bGo : BOOL; END_VAR
VAR nCount : INT; eGate : E_Gate; aList : ARRAY[1..3] OF INT; END_VAR
METHOD Tick : INT
VAR_INPUT nBy : INT; END_VAR
VAR nLocal : INT; END_VAR
nLocal := nBy * 2;
nCount := nCount + nLocal;
END_METHOD PROPERTY nTwice : INT GET nTwice := 2 * nCount; END_GET END_PROPERTY
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR n, i : INT; fbGate : FB_Gate; pN : POINTER TO INT; END_VAR
n := n + 1;
fbGate.Tick(n);
FOR i := 1 TO 2 DO
    fbGate.aList[i] := fbGate.aList[i] + n;
END_FOR
END_PROGRAM
"""
PLC = 1000


@pytest.fixture
def cell(tmp_path: Path) -> Path:
    path = tmp_path / "cell.st"
    path.write_text(CELL + TASK, "utf-8")
    return path


@pytest.fixture
def client(tmp_path: Path, cell: Path) -> Iterator[DebugClient]:
    """A client before the first tick."""
    part = tmp_path / "part.nc"
    part.write_text("G01 X20 F1000\nM30\n", "utf-8")
    with DebugClient() as own:
        own.begin(str(part), plc=str(cell), stopOnEntry=True)
        own.ask("configurationDone")
        own.stopped()
        yield own


def set_lines(client: DebugClient, path: Path, *breakpoints: dict[str, Any]) -> list[Any]:
    """Set the breakpoints of a file; return them as the debugger shows them."""
    own = {"source": {"path": str(path)}, "breakpoints": list(breakpoints)}
    return list(client.ask("setBreakpoints", **own)["breakpoints"])


def value(client: DebugClient, frames: list[Any], text: str, level: int = 0) -> str:
    """The value of an expression in a frame, as a watch shows it."""
    return str(client.ask("evaluate", expression=text, frameId=frames[level]["id"])["result"])


def test_breakpoints_are_at_lines_with_statements(client: DebugClient, cell: Path) -> None:
    """ST-510: line 12 holds none, 14 is the next one; conditions are Structured Text (902817)."""
    shown = set_lines(
        client,
        cell,
        {"line": 12},
        {"line": 8, "condition": "nBy = 3"},
        {"line": 9, "condition": "n"},
    )
    assert [(one["line"], one["verified"]) for one in shown] == [(14, True), (8, True), (9, False)]
    set_lines(client, cell, {"line": 8, "condition": "nBy = 3"})
    stop = client.go()
    assert (stop["reason"], stop["threadId"], stop["line"]) == ("breakpoint", PLC, 8)
    assert [one["name"] for one in stop["frames"]] == ["FB_Gate.Tick (MAIN.fbGate)", "MAIN"]
    assert [one["line"] for one in stop["frames"]] == [8, 15]
    assert value(client, stop["frames"], "nBy") == "3"
    assert value(client, stop["frames"], "n", 1) == "3"
    assert value(client, stop["frames"], "nCount > 5 AND nBy = 3") == "TRUE"


def test_hit_conditions_count_each_pass(client: DebugClient, cell: Path) -> None:
    """The third pass of the loop is the first one of the second cycle; so it is backward."""
    set_lines(client, cell, {"line": 17, "hitCondition": "== 3"})
    stop = client.go()
    assert (value(client, stop["frames"], "n"), value(client, stop["frames"], "i")) == ("2", "1")
    set_lines(client, cell, {"line": 17})
    back = client.go("reverseContinue", threadId=PLC)
    assert (value(client, back["frames"], "n"), value(client, back["frames"], "i")) == ("1", "2")


def test_steps_go_into_over_and_out_and_back(client: DebugClient, cell: Path) -> None:
    set_lines(client, cell, {"line": 15})
    assert client.go()["line"] == 15
    set_lines(client, cell)
    lines = [
        client.go(command, threadId=PLC)["line"]
        for command in ("next", "stepBack", "stepIn", "next", "stepOut", "next")
    ]
    assert lines == [16, 15, 8, 9, 16, 17]
    back = client.go("stepBack", threadId=PLC, granularity="instruction")
    assert back["line"] == 16


def test_scopes_are_trees_and_set_values_count_from_the_next_tick(
    client: DebugClient, cell: Path
) -> None:
    """RC-002: nCount becomes 100, so 100 + 2 · 2 after line 9 of the second cycle."""
    set_lines(client, cell, {"line": 9})
    frames = client.go()["frames"]
    assert [one["name"] for one in client.ask("scopes", frameId=frames[0]["id"])["scopes"]] == [
        "result", "VAR_INPUT", "VAR", "THIS^", "VAR_GLOBAL", "PROGRAM",
    ]  # fmt: skip
    assert client.scope("VAR", frames[0]["id"])["nLocal"]["value"] == "2"
    this = client.scope("THIS^", frames[0]["id"])
    assert this["eGate"]["value"] == "E_Gate.Closed"
    elements = client.unfolded(this["aList"]["variablesReference"])
    assert [one["value"] for one in elements.values()] == ["0", "0", "0"]
    scopes = client.ask("scopes", frameId=frames[0]["id"])["scopes"]
    references = {one["name"]: one["variablesReference"] for one in scopes}
    for name, text in (("nCount", "100"), ("eGate", "Open")):
        client.ask("setVariable", variablesReference=references["THIS^"], name=name, value=text)
    assert client.scope("THIS^", frames[0]["id"])["nCount"]["value"] == "0 → 100"
    with pytest.raises(Refused) as refused:
        client.ask("setVariable", variablesReference=references["VAR"], name="nLocal", value="1")
    assert refused.value.error["id"] == 902816
    frames = client.go()["frames"]
    assert value(client, frames, "nCount") == "100"
    assert value(client, frames, "eGate") == "E_Gate.Open"
    assert client.ask("evaluate", expression="MAIN.fbGate.nCount", context="watch")["result"]
    client.ask("setExpression", expression="nCount", value="7", frameId=frames[0]["id"])
    frames = client.go()["frames"]
    assert value(client, frames, "nCount") == "7"


def test_what_is_set_is_checked(client: DebugClient, cell: Path) -> None:
    """ST-206, ST-311, ST-315: literals, pointers, and the reason where nothing can be set."""
    set_lines(client, cell, {"line": 14})
    frame = client.go()["frames"][0]["id"]

    def set_to(name: str, text: str) -> str:
        try:
            answer = client.ask("setExpression", expression=name, value=text, frameId=frame)
        except Refused as refused:
            return str(refused)
        return str(answer["value"])

    assert (set_to("n", "16#10"), set_to("pN", "null")) == ("16#10", "null")
    assert set_to("pN", "4096").endswith("from outside it can only be set to 0")
    assert set_to("fbGate", "0") == "fbGate cannot be set: it has parts, which can"
    assert set_to("n.3", "TRUE") == "n.3 cannot be set: it is a single bit"
    assert set_to("n + 1", "3") == "n + 1 cannot be set: it is computed"
    assert set_to("fbGate.aList[4]", "1").startswith("there is no fbGate.aList[4]: fbGate.aList is")
    assert set_to("V.E.VALUE", "3") == "3"
    assert client.ask("evaluate", expression="X.ACS.ACT_POS", frameId=frame)["result"] == "0.002"
    with pytest.raises(Refused, match=r"12 / i has no value here: division by zero"):
        client.ask("evaluate", expression="12 / i", frameId=frame)
    with pytest.raises(Refused, match="a call of the property nTwice"):
        client.ask("evaluate", expression="fbGate.nTwice", frameId=frame)


@pytest.mark.parametrize("text", ["fbGate.Tick(1)", "nCount := 3", "nMissing"])
def test_what_a_watch_cannot_show_is_refused(client: DebugClient, cell: Path, text: str) -> None:
    set_lines(client, cell, {"line": 14})
    frames = client.go()["frames"]
    with pytest.raises(Refused):
        value(client, frames, text)


def test_a_fault_is_an_exception_with_its_calls(tmp_path: Path) -> None:
    """ST-560: the divisor is 0 in the third cycle, in tick 4."""
    cell = tmp_path / "cell.st"
    cell.write_text(
        "FUNCTION F_Part : INT\nVAR_INPUT nOf : INT; END_VAR\nF_Part := 12 / nOf;\nEND_FUNCTION\n"
        "PROGRAM MAIN\nVAR n, m : INT; END_VAR\nn := n + 1;\nm := F_Part(3 - n);\nEND_PROGRAM\n"
        + TASK,
        "utf-8",
    )
    part = tmp_path / "part.nc"
    part.write_text("G01 X20 F1000\nM30\n", "utf-8")
    with DebugClient() as own:
        abilities = own.begin(str(part), plc=str(cell))
        filters = [one["filter"] for one in abilities["exceptionBreakpointFilters"]]
        assert {"plc_pointer", "plc_index", "plc_division", "plc_conversion"} <= {*filters}
        own.ask("setExceptionBreakpoints", filters=["plc_division"])
        own.ask("configurationDone")
        stop = own.stopped()
        assert (stop["reason"], stop["threadId"], stop["line"]) == ("exception", PLC, 3)
        assert [one["name"] for one in stop["frames"]] == ["F_Part", "MAIN"]
        assert value(own, stop["frames"], "nOf") == "0"
        assert value(own, stop["frames"], "n", 1) == "3"
        assert own.ask("exceptionInfo", threadId=PLC)["exceptionId"] == "902265"
        back = [own.go("stepBack", threadId=PLC) for _ in range(2)]
        assert [(one["reason"], one["line"]) for one in back] == [("step", 3), ("step", 8)]
        assert own.go("next", threadId=PLC)["reason"] == "exception"
        assert own.go()["reason"] == "end"
        again = own.go("reverseContinue")
        assert (again["reason"], again["line"]) == ("exception", 3)


def test_a_file_that_changes_in_the_run_is_reported_with_its_place(
    client: DebugClient, cell: Path, tmp_path: Path
) -> None:
    """902969: once for each change, at a stop and where breakpoints are set; not for a touch."""
    set_lines(client, cell, {"line": 14})
    assert client.go()["line"] == 14
    cell.write_text(cell.read_text("utf-8").replace("n := n + 1;", "// new\nn := n + 2;"), "utf-8")
    set_lines(client, cell, {"line": 15})
    reported = client.event("output", lambda one: "902969" in one["output"])
    assert (reported["line"], reported["source"]["name"], reported["category"]) == (
        14,
        "cell.st",
        "console",
    )
    part = tmp_path / "part.nc"
    part.write_text(part.read_text("utf-8"), "utf-8")
    assert client.go()["line"] == 15
    part.write_text("G01 X20 F1000\n", "utf-8")
    client.ask("continue", threadId=1)
    assert client.event("output", lambda one: "902969" in one["output"])["line"] == 2
    if hasattr(os, "mkfifo"):  # nobody waits for what may never come
        cell.unlink()
        os.mkfifo(cell)
        set_lines(client, cell, {"line": 14})

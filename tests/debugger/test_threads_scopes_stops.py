# SPDX-License-Identifier: MIT
"""Threads, scopes, stops at H functions and data, errors by class with cause and remedy."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from support.debug_client import DebugClient

pytestmark = pytest.mark.slow

PROGRAM = """\
%L SUB
  #VAR
    V.L.OWN = 3
  #ENDVAR
  G01 X20 F60000
  M17
%MAIN
#VAR
  V.S.KEPT = 4
#ENDVAR
P1 = 0
#RT CYCLE [ID=3 SCOPE=PROG]
  V.E.CONDITION = 1
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
V.E.VALUE = 5
LL SUB
G01 X30 H7
G04 X0.1
G01 X=1/P1
M30
"""
DIVISION = 1 + PROGRAM.splitlines().index("G01 X=1/P1")


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("words") / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    return str(path)


@pytest.fixture(scope="module")
def shared(program: str) -> Iterator[DebugClient]:
    with DebugClient() as client:
        client.begin(program, stopOnEntry=True)
        client.ask("configurationDone")
        client.stopped()
        yield client
        client.ask("disconnect")


@pytest.fixture
def client(shared: DebugClient, program: str) -> DebugClient:
    """A client whose session is at its start, without breakpoints."""
    for kind in ("Function", "Data", ""):
        shared.ask(f"set{kind}Breakpoints", source={"path": program}, breakpoints=[])
    shared.ask("setExceptionBreakpoints", filters=[])
    shared.console("tick 0")
    shared.ask("threads")  # what has been reported before this answer is old
    shared.events.clear()
    return shared


def test_channels_and_cycles_are_threads(client: DebugClient, program: str) -> None:
    """A cycle is one as long as it lives; its values are those of each tick."""
    client.ask("setBreakpoints", source={"path": program}, breakpoints=[{"line": 5}])
    assert client.go()["line"] == 5
    names = {one["name"]: one["id"] for one in client.ask("threads")["threads"]}
    assert list(names) == ["channel 1", "realtime cycle 3 (PROG, running)"]
    cycle = names["realtime cycle 3 (PROG, running)"]
    frames = client.ask("stackTrace", threadId=cycle)["stackFrames"]
    assert frames[0]["name"] == "realtime cycle 3"
    assert client.go("next", threadId=cycle)["threadId"] == cycle


def test_each_kind_of_variable_has_a_scope(client: DebugClient, program: str) -> None:
    """Those of the decoder are distinguished, and are there in its frame, too."""
    client.ask("setBreakpoints", source={"path": program}, breakpoints=[{"line": 5}])
    frames = client.go()["frames"]
    scopes = client.ask("scopes", frameId=frames[0]["id"])["scopes"]
    assert [one["name"] for one in scopes] == [
        *("Axes", "Path and channel", "V.E", "V.CH", "V.RTA", "V.RTG", "HLI"),
        *("Realtime cycles", "Waits for the PLC"),
        *("V.P [decoder]", "V.L [decoder]", "V.S [decoder]"),
    ]
    assert client.scope("V.S [decoder]")["V.S.KEPT"]["value"] == "4"
    assert "TIMER" in client.scope("V.RTG")
    assert "ACS" in client.scope("V.RTA")
    assert client.console("V.E.CONDITION", "hover") == "1"


def test_an_h_function_stops(client: DebugClient) -> None:
    client.ask("setFunctionBreakpoints", breakpoints=[{"name": "H7"}])
    stop = client.go()
    assert (stop["reason"], stop["text"].partition(",")[0]) == ("function breakpoint", "H7")


@pytest.mark.parametrize(
    ("name", "mode", "reason"),
    [
        ("V.E.VALUE", "changes", "data breakpoint"),
        ("V.E.VALUE", "written", "end"),
        ("V.E.COUNT", "changes", "data breakpoint"),
        ("V.E.COUNT", "written", "data breakpoint"),
    ],
)
def test_data_stop_where_they_change_or_a_cycle_writes_them(
    client: DebugClient, name: str, mode: str, reason: str
) -> None:
    """``V.E.VALUE`` is written by the program alone, ``V.E.COUNT`` by the cycle."""
    found = client.ask("dataBreakpointInfo", name=name, mode=mode)
    client.ask("setDataBreakpoints", breakpoints=[{"dataId": found["dataId"]}])
    stop = client.go()
    assert stop["reason"] == reason
    assert client.console(name) == ("5" if name == "V.E.VALUE" else "1")


def test_an_error_of_a_class_stops_with_effect_and_remedy(client: DebugClient) -> None:
    """The filter of another class lets it pass; 20396 is of class 2."""
    client.ask("setExceptionBreakpoints", filters=["class3"])
    assert client.go()["reason"] == "end"
    client.console("tick 0")
    client.event("stopped")
    client.ask("setExceptionBreakpoints", filters=["class2"])
    stop = client.go()
    assert (stop["reason"], stop["text"]) == ("exception", "error 20396")
    reported = client.ask("exceptionInfo", threadId=1)
    assert reported["details"]["typeName"] == "Class 2"
    assert f"part.nc:{DIVISION}:8: error 20396" in reported["description"]
    assert "  remedy: Check the operands first" in reported["description"]
    assert "  effect: the program is aborted" in reported["description"]


def test_an_error_tells_its_cause(client: DebugClient, tmp_path: Path) -> None:
    """Where the catalogue knows one."""
    path = tmp_path / "index.nc"
    path.write_text("P1 = 99\nG01 X1 F6000\nV.E.LIST[P1] = 1\nM30\n", "utf-8")
    with DebugClient() as own:
        own.begin(str(path))
        own.ask("configurationDone")
        assert own.stopped()["reason"] == "exception"
        reported = own.ask("exceptionInfo", threadId=1)["description"]
        assert "  cause: Indices count from 0" in reported
        own.ask("disconnect")

# SPDX-License-Identifier: MIT
"""Frames that begin again, other blocks to go on from, cycles as instructions."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support.debug_client import DebugClient, Refused

pytestmark = pytest.mark.slow

PROGRAM = """\
%L SUB
  G01 X10 F6000
  G01 X20
  M17
%MAIN
P1 = 4
#VAR
V.P.POS.X = 1
V.P.POS.END.Y = 2
V.P.LIST[2] = [3, 4]
#ENDVAR
#RT CYCLE [ID=3 SCOPE=PROG]
  V.E.VALUE = V.E.COUNT + P1
  $IF EDGE V.RTA.ACS.ACT_POS.X > 15
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 Y5 F6000
LL SUB
G01 Y10
#BLOCKSEARCH LOCKED
G01 Y20
#BLOCKSEARCH RELEASED
G01 Y30
#MSG ["there"]
G01 Y31
M30
"""
X20, Y5, Y20 = 3, 18, 22
BRANCH = 14


@pytest.fixture
def client(tmp_path: Path) -> Iterator[DebugClient]:
    file = tmp_path / "p.nc"
    file.write_text(PROGRAM, "utf-8")
    with DebugClient() as client:
        client.begin(str(file), stopOnEntry=True)
        client.ask("setBreakpoints", source={"path": str(file)}, breakpoints=[{"line": X20}])
        client.ask("configurationDone")
        assert client.stopped()["reason"] == "entry"
        yield client


def source(tmp_path: Path) -> dict[str, Any]:
    return {"path": str(tmp_path / "p.nc")}


def tick(client: DebugClient) -> str:
    return client.console("tick")


def test_a_frame_begins_its_block_again(client: DebugClient) -> None:
    """From the middle of a block to its begin, there and back; a caller to its own last block."""
    begun = client.go()
    assert begun["line"] == X20
    position = tick(client)
    for _ in range(3):
        client.go("next", granularity="instruction")
    top = client.ask("stackTrace", threadId=1)["stackFrames"][0]
    client.ask("restartFrame", frameId=top["id"])
    again = client.stopped()
    assert (again["reason"], again["line"]) == ("restart", X20)
    assert tick(client) == position
    client.ask("restartFrame", frameId=again["frames"][0]["id"])
    assert (client.stopped()["line"], tick(client)) == (X20, position)
    below = client.ask("stackTrace", threadId=1)["stackFrames"][1]
    client.ask("restartFrame", frameId=below["id"])
    assert client.stopped()["line"] == Y5
    client.ask("threads")
    cycle = client.ask("stackTrace", threadId=1001)["stackFrames"][0]
    assert cycle["canRestart"] is False
    with pytest.raises(Refused) as refused:
        client.ask("restartFrame", frameId=cycle["id"])
    assert refused.value.error["id"] == 902570


@pytest.mark.nightly
def test_goto_begins_at_a_block_by_block_search(client: DebugClient, tmp_path: Path) -> None:
    """Backward; where the search is locked, and in a cycle, nothing changes."""
    client.go()
    (target,) = client.ask("gotoTargets", source=source(tmp_path), line=Y5)["targets"]
    client.ask("goto", threadId=1, targetId=target["id"])
    stop = client.stopped()
    assert (stop["reason"], stop["line"]) == ("goto", Y5)
    position = tick(client)
    (locked,) = client.ask("gotoTargets", source=source(tmp_path), line=Y20)["targets"]
    with pytest.raises(Refused) as refused:
        client.ask("goto", threadId=1, targetId=locked["id"])
    assert refused.value.error["id"] == 21399
    assert tick(client) == position
    assert client.ask("gotoTargets", source=source(tmp_path), line=BRANCH)["targets"] == []
    assert client.go()["line"] == X20


@pytest.mark.nightly
def test_a_cycle_is_shown_as_its_instructions(client: DebugClient) -> None:
    """Statements with their counts (RC-501), frozen values (RC-302), as many rows as asked for."""
    client.go()
    client.ask("threads")
    frame = client.ask("stackTrace", threadId=1001)["stackFrames"][0]
    reference = frame["instructionPointerReference"]
    rows = client.ask(
        "disassemble", memoryReference=reference, instructionOffset=-6, instructionCount=20
    )["instructions"]
    assert len(rows) == 20
    assert len({row["address"] for row in rows}) == 20
    texts = [row["instruction"] for row in rows]
    lines = [row["line"] for row in rows if "line" in row]
    assert lines == [12, 13, BRANCH, 15]
    assert any("V.E.VALUE = V.E.COUNT + P1 (4)" in text for text in texts), texts
    assert any("P1" in text and "4" in text for text in texts[2:])
    at = next(row for row in rows if row["address"] == reference)
    assert at["line"] == frame["line"]
    with pytest.raises(Refused) as refused:
        client.ask("disassemble", memoryReference="0x1", instructionCount=3)
    assert refused.value.error["id"] == 902571


@pytest.mark.nightly
def test_structures_of_a_program_unfold(client: DebugClient) -> None:
    """V.P.POS.X below V.P.POS, by name in the console too."""
    client.go()
    found = client.ask("evaluate", expression="V.P", context="repl")

    def children(variable: dict[str, Any]) -> dict[str, dict[str, Any]]:
        reference = variable["variablesReference"]
        below = client.ask("variables", variablesReference=reference)["variables"]
        return {one["name"]: one for one in below}

    top = children(found)
    assert set(top) == {"V.P.POS", "V.P.LIST"}
    assert top["V.P.POS"]["value"] == "X 1, END.Y 2"
    inside = children(top["V.P.POS"])
    assert inside["V.P.POS.X"]["value"] == "1"
    assert children(inside["V.P.POS.END"])["V.P.POS.END.Y"]["value"] == "2"
    named = client.ask("evaluate", expression="V.P.POS", context="repl")
    assert set(children(named)) == {"V.P.POS.X", "V.P.POS.END"}


@pytest.mark.nightly
def test_the_way_back_stops_at_exceptions_too(client: DebugClient) -> None:
    """A message that stops a run stops it on the way back, at the same tick, with its thread."""
    client.ask("setExceptionBreakpoints", filters=["message"])
    assert client.go()["line"] == X20
    forward = client.go()
    position = tick(client)
    assert forward["reason"] == "exception"
    assert client.go()["reason"] == "end"
    back = client.go("reverseContinue")
    keys = ("reason", "threadId", "text")
    assert [back[key] for key in keys] == [forward[key] for key in keys]
    assert tick(client) == position
    assert client.go("reverseContinue")["line"] == X20

# SPDX-License-Identifier: MIT
"""What the debugger says of breakpoints and values is so: before a statement, anew, backward."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support.debug_client import DebugClient, Refused

pytestmark = pytest.mark.slow

PROGRAM = """\
#VAR
V.P.LIST[4] = [1, 2, 3, 4]
V.P.A = 5
#ENDVAR
#RT CYCLE [ID=1 SCOPE=PROG]
  V.E.COUNT = V.E.COUNT + 1
  $IF V.RTA.ACS.ACT_POS.X > 5 && V.E.VALUE < 3
    V.E.VALUE = V.E.VALUE + 1
    V.E.TRIGGER = V.E.VALUE
  $ENDIF
#RT CYCLE END
G01 X10 F6000
G01 X20
M30
"""


@pytest.fixture
def part(tmp_path: Path) -> Path:
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    return path


@pytest.fixture
def client(part: Path) -> Iterator[DebugClient]:
    """A client before the first tick of the program."""
    with DebugClient() as own:
        own.begin(str(part), stopOnEntry=True)
        own.ask("configurationDone")
        own.stopped()
        yield own


@pytest.fixture(scope="module")
def standing(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DebugClient]:
    """A client after the first block of the program has become current."""
    path = tmp_path_factory.mktemp("standing") / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with DebugClient() as own:
        own.begin(str(path), stopOnEntry=True)
        own.ask("configurationDone")
        own.stopped()
        own.go("next")
        yield own


def set_lines(client: DebugClient, part: Path, *breakpoints: dict[str, Any]) -> list[Any]:
    """Set the breakpoints of the program; return them as the debugger shows them."""
    own = {"source": {"path": str(part)}, "breakpoints": list(breakpoints)}
    return list(client.ask("setBreakpoints", **own)["breakpoints"])


@pytest.mark.parametrize(
    ("line", "condition", "values"),
    [
        (8, "V.E.VALUE == 0", (1, 1)),  # the first run: it is 0 before, 1 after the tick
        (9, "V.E.VALUE == 2", (2, 2)),  # line 8 has run in this tick, and counts
        (7, "V.E.VALUE == 1", (2, 2)),  # the $IF: before the first statement of its body
        (6, "V.E.COUNT == 3", (0, 0)),  # outside of any branch
    ],
)
def test_a_condition_is_judged_before_the_statement(
    client: DebugClient, part: Path, line: int, condition: str, values: tuple[int, int]
) -> None:
    """With what the statements before it in the same tick have written, and forward and back."""
    set_lines(client, part, {"line": line, "condition": condition})
    stop = client.go()
    assert (stop["reason"], stop["hitBreakpointIds"]) == ("breakpoint", [1])
    assert int(client.console("V.E.VALUE")) == values[0]
    if line == 6:
        assert client.console("V.E.COUNT") == "4"
    tick = client.console("tick")
    assert client.go()["reason"] == "end"
    back = client.go("reverseContinue")
    assert (back["reason"], client.console("tick")) == ("breakpoint", tick)


def test_backward_a_breakpoint_is_reported_as_forward(client: DebugClient, part: Path) -> None:
    """Its number, and the thread of the realtime cycle in which it has held."""
    set_lines(client, part, {"line": 8}, {"line": 13})
    keys = ("reason", "threadId", "line", "hitBreakpointIds", "text")
    forward = [client.go() for _ in range(4)]
    assert [stop["threadId"] > 1000 for stop in forward] == [True, True, True, False]
    for expected in forward[2::-1]:
        found = client.go("reverseContinue")
        assert [found[key] for key in keys] == [expected[key] for key in keys]
    assert client.go("reverseContinue")["reason"] == "entry"


def test_a_restart_finds_the_breakpoints_again(client: DebugClient, part: Path) -> None:
    """Those that cannot be watched stay unverified and keep nobody from going on.

    A branch that has moved in the text is watched where it is now.
    """
    set_lines(client, part, {"line": 8}, {"line": 12, "condition": "V.E.NOTHING > 1"})
    other = {"source": {"path": str(part.parent / "other.nc")}, "breakpoints": [{"line": 1}]}
    assert not client.ask("setBreakpoints", **other)["breakpoints"][0]["verified"]
    part.write_text(PROGRAM.replace("  V.E.COUNT", "; moved\n; down\n  V.E.COUNT"), "utf-8")
    client.events.clear()
    client.ask("restart")
    shown = [client.event("breakpoint")["breakpoint"] for _ in range(3)]
    assert [(one["id"], one["verified"]) for one in shown] == [(1, True), (2, False), (3, False)]
    assert "20196" in shown[1]["message"]
    assert client.stopped()["reason"] == "entry"
    stop = client.go()  # line 8 is the statement outside of the branch now
    assert (stop["reason"], client.console("V.E.COUNT")) == ("breakpoint", "1")


@pytest.mark.parametrize(
    ("text", "shown", "children"),
    [
        ("V.E", "VALUE 0, VALUE1 0, VALUE2 0, …", "VALUE"),
        ("Y", "ACS.ACT_POS 0, ACS.CUR_POS 0, ACS.CMD_POS 0, …", "ACS"),
        ("V.RTG.TIMER", "[128] 0, 0, 0, …", "[0]"),
        ("V.CH.Table", "[5] 0, 0, 0, …", "[0]"),
        ("V.P.LIST", "[4] 1, 2, 3, …", "V.P.LIST[0]"),
        ("v.p.list", "[4] 1, 2, 3, …", "V.P.LIST[0]"),
        ("V.P", "V.P.LIST [4] 1, 2, 3, …, V.P.A 5", "V.P.LIST"),
    ],
)
def test_names_of_several_values_unfold(
    standing: DebugClient, text: str, shown: str, children: str
) -> None:
    """In a watch, beside the mouse and in the console."""
    for context in ("watch", "hover", "repl"):
        found = standing.ask("evaluate", expression=text, context=context)
        assert found["result"] == shown
        assert next(iter(standing.unfolded(found["variablesReference"]))) == children


def test_no_value_of_a_scope_is_blank(standing: DebugClient) -> None:
    """Axes show their positions, arrays their first elements."""
    for name in ("Axes", "Path and channel", "V.E", "V.CH", "V.RTA", "V.RTG", "HLI"):
        assert [one for one in standing.scope(name).values() if not one["value"]] == []


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("1/0", "'/' has no valid result"),
        ("LN[V.E.VALUE]", "'LN' has no valid result"),
        ("V.P.NOTHING", "does not know this name"),
        ("V.P.LIST[4]", "does not know this name"),
        ("P77", "does not know this name"),
    ],
)
def test_what_has_no_value_says_why(standing: DebugClient, text: str, reason: str) -> None:
    """901926, not a dash."""
    with pytest.raises(Refused, match="has no value here") as refused:
        standing.console(text, "watch")
    assert reason in refused.value.error["format"]


@pytest.mark.nightly
def test_a_run_that_waits_for_the_operator_stops(client: DebugClient) -> None:
    """901925, instead of running to the limit in single block."""
    client.console("set HLI.SINGLE_BLOCK = 1")
    stop = client.go()
    assert stop["reason"] == "pause"
    assert "START in single block mode" in stop["text"]
    client.console("set HLI.START = 1")
    assert "START in single block mode" in client.go()["text"]

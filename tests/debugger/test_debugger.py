# SPDX-License-Identifier: MIT
"""The debugger over its protocol: breakpoints, steps, time travel, values, the console."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support.debug_client import DebugClient, Refused

from nctakt.debugger import report
from nctakt.debugger.debuggee import Debuggee
from nctakt.session.engine import Found
from nctakt.session.history import timeline
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.session import Session

pytestmark = pytest.mark.slow

PROGRAM = """\
%L DEEP
  #VAR
    V.L.OWN = 3
    V.L.LIST[3] = [4, 5, 6]
  #ENDVAR
  G01 X20 F60000
  M17
%L SUB
  V.P.A = V.P.A + 1
  G01 X10 F60000
  LL DEEP
  G01 Y=10*V.P.A
  M17
%MAIN
P5 = 7
V.P.A = 0
#RT CYCLE [ID=3 SCOPE=PROG]
  V.E.VALUE = V.E.COUNT + 1
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT += 1
  $ENDIF
  $IF V.E.COUNT > 5
    V.E.TRIGGER = 1
  $ELSE
    V.E.CONDITION = 1
  $ENDIF
#RT CYCLE END
; a remark
LL SUB
M100
#MSG ["there %d", V.P.A]
G01 X0
LL SUB
G01 X30 H7
M30
"""

#: Lines of the program by what is there.
LINES = {text.strip(): number for number, text in enumerate(PROGRAM.splitlines(), start=1)}
EDGE = LINES["$IF EDGE V.RTA.ACS.ACT_POS.X > 5"]
COUNT = LINES["V.E.COUNT += 1"]
X10, X20, Y10 = LINES["G01 X10 F60000"], LINES["G01 X20 F60000"], LINES["G01 Y=10*V.P.A"]
X0, X30 = LINES["G01 X0"], LINES["G01 X30 H7"]
FIRST_CALL = LINES["; a remark"] + 1


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("debugged") / "p.nc"
    path.write_text(PROGRAM, "utf-8")
    return str(path)


@pytest.fixture(scope="module")
def shared(file: str) -> Iterator[DebugClient]:
    with DebugClient() as client:
        client.begin(file, stopOnEntry=True, client={"supportsInvalidatedEvent": True})
        client.ask("configurationDone")
        assert client.stopped()["reason"] == "entry"
        yield client
        client.ask("disconnect")


@pytest.fixture
def client(shared: DebugClient, file: str) -> DebugClient:
    """A client whose session is at its start, without breakpoints."""
    shared.ask("setBreakpoints", source={"path": file}, breakpoints=[])
    shared.ask("setFunctionBreakpoints", breakpoints=[])
    shared.ask("setDataBreakpoints", breakpoints=[])
    shared.ask("setExceptionBreakpoints", filters=[])
    shared.console("branch 1")
    shared.console("tick 0")
    shared.ask("threads")  # what has been reported before this answer is old
    shared.events.clear()
    return shared


def set_at(client: DebugClient, file: str, *wanted: int | dict[str, Any]) -> list[dict[str, Any]]:
    """Set breakpoints at lines; the answer."""
    own = [{"line": one} if isinstance(one, int) else one for one in wanted]
    answer = client.ask("setBreakpoints", source={"path": file}, breakpoints=own)
    return list(answer["breakpoints"])


# --- breakpoints ----------------------------------------------------------------------------------


def test_a_breakpoint_stops_where_its_block_becomes_current(client: DebugClient, file: str) -> None:
    """The stack has the programs that are open there, and apart those of the decoder."""
    (made,) = set_at(client, file, X20)
    assert made["verified"]
    stop = client.go()
    assert (stop["reason"], stop["line"], stop["hitBreakpointIds"]) == (
        "breakpoint",
        X20,
        [made["id"]],
    )
    shown = [(one["name"], one["line"], one["presentationHint"]) for one in stop["frames"]]
    assert shown[:3] == [
        ("DEEP", X20, "normal"),
        ("SUB", LINES["LL DEEP"], "normal"),
        ("MAIN", FIRST_CALL, "normal"),
    ]
    assert shown[3][0] == "decoder, ahead of the path"
    assert shown[4][2] == "subtle"


def test_a_breakpoint_moves_to_the_next_line_where_the_run_can_stop(
    client: DebugClient, file: str
) -> None:
    """A comment, the inside of #VAR, the end of a cycle; after the last block there is none."""
    lines = [LINES["; a remark"], 3, LINES["#RT CYCLE END"], LINES["$ENDIF"], 99]
    made = set_at(client, file, *lines)
    assert [one["line"] for one in made] == [FIRST_CALL, X20, FIRST_CALL, FIRST_CALL, 99]
    assert [one["verified"] for one in made] == [True, True, True, True, False]
    assert "901230" in made[-1]["message"]
    (other,) = client.ask(
        "setBreakpoints", source={"path": "/else/where.nc"}, breakpoints=[{"line": 1}]
    )["breakpoints"]
    assert not other["verified"]
    assert "901229" in other["message"]


def test_branches_stop_when_their_body_runs_and_when_their_truth_changes(
    client: DebugClient, file: str
) -> None:
    """A statement in the body represents its branch; the mode can be written as a condition."""
    set_at(client, file, COUNT)
    first = client.go()
    assert first["frames"][0]["name"] == "realtime cycle 3"
    assert client.console("V.E.COUNT") == "1"
    set_at(client, file, {"line": EDGE, "mode": "changes"})
    assert client.go()["reason"] == "breakpoint"
    assert client.console("V.RTA.ACS.ACT_POS.X > 5", "watch") == "0"
    set_at(client, file, {"line": LINES["V.E.CONDITION = 1"], "condition": "fires"})
    client.go()
    assert client.console("V.E.CONDITION") == "1"


def test_a_statement_outside_of_branches_stops_in_each_tick_of_its_cycle(
    client: DebugClient, file: str
) -> None:
    line = LINES["V.E.VALUE = V.E.COUNT + 1"]
    set_at(client, file, line)
    assert [client.go()["text"].split()[-1] for _ in range(3)] == ["0", "1", "2"]
    set_at(client, file, {"line": line, "condition": "changes V.E.COUNT > 0"})
    client.go()
    assert client.console("V.E.VALUE") == "2"
    (wrong,) = set_at(client, file, {"line": X10, "condition": "changes"})
    assert "901232" in wrong["message"]


def test_conditions_hit_counts_and_log_points(client: DebugClient, file: str) -> None:
    set_at(client, file, {"line": X10, "condition": "V.E.COUNT > 0"})
    assert client.go()["line"] == X10
    assert client.console("V.P.A") == "2"
    client.console("tick 0")
    client.event("stopped")
    set_at(client, file, {"line": X10, "hitCondition": "== 2"})
    assert client.go()["line"] == X10
    assert client.console("V.P.A") == "2"
    client.console("tick 0")
    client.event("stopped")
    set_at(client, file, {"line": Y10, "logMessage": "count {V.E.COUNT}, {V.E.NOTHING}"}, X30)
    client.ask("continue", threadId=1)
    for count in (1, 2):
        reported = client.event("output", lambda body: "count " in body["output"])
        assert f"  count {count}, <" in reported["output"]
        assert reported["line"] == Y10
    assert client.stopped()["line"] == X30
    (wrong,) = set_at(client, file, {"line": X10, "hitCondition": "often"})
    assert "901231" in wrong["message"]
    (wrong,) = set_at(client, file, {"line": X10, "condition": "V.E.NOTHING > 1"})
    assert not wrong["verified"]
    assert "V.E.NOTHING" in wrong["message"]


def test_functions_data_and_exceptions_stop(client: DebugClient, file: str) -> None:
    made = client.ask(
        "setFunctionBreakpoints", breakpoints=[{"name": "M100"}, {"name": "H7"}, {"name": "G01"}]
    )["breakpoints"]
    assert [one["verified"] for one in made] == [True, True, False]
    stop = client.go()
    assert (stop["reason"], stop["text"].partition(",")[0]) == ("function breakpoint", "M100")
    client.console("back 1")
    client.event("stopped")
    client.ask("setExceptionBreakpoints", filters=["message"])
    client.ask("continue", threadId=1)
    assert client.event("output")["output"].endswith("  there 1\n")
    stop = client.stopped()  # in the same tick
    assert (stop["reason"], stop["text"]) == ("exception", "message there 1")
    assert client.ask("exceptionInfo", threadId=1)["description"] == "message there 1"
    reference = client.ask("scopes", frameId=stop["frames"][0]["id"])["scopes"]
    own = next(one for one in reference if one["name"] == "V.E")["variablesReference"]
    found = client.ask("dataBreakpointInfo", variablesReference=own, name="COUNT")
    assert found["dataId"] == "changes 1 V.E.COUNT"
    assert client.ask("dataBreakpointInfo", name="V.P.A")["dataId"] is None
    written = client.ask("dataBreakpointInfo", name="V.E.COUNT", mode="written")["dataId"]
    client.ask("setFunctionBreakpoints", breakpoints=[])
    client.ask("setDataBreakpoints", breakpoints=[{"dataId": written}])
    stop = client.go()
    assert (stop["reason"], stop["text"].partition(",")[0]) == ("data breakpoint", "V.E.COUNT")
    assert client.console("V.E.COUNT") == "2"


def test_locations_and_sources(client: DebugClient, file: str) -> None:
    found = client.ask("breakpointLocations", source={"path": file}, line=EDGE, endLine=FIRST_CALL)
    lines = [one["line"] for one in found["breakpoints"]]
    assert lines == [EDGE, COUNT, *range(COUNT + 2, COUNT + 6), FIRST_CALL]
    (source,) = client.ask("loadedSources")["sources"]
    assert source["path"] == str(Path(file).resolve())
    assert client.ask("source", source={"path": file}, sourceReference=0)["content"] in PROGRAM


# --- steps ----------------------------------------------------------------------------------------


def test_steps_go_over_into_and_out_of_programs(client: DebugClient, file: str) -> None:
    set_at(client, file, X10)
    client.go()
    set_at(client, file)
    assert client.go("next")["line"] == Y10
    assert client.go("next")["line"] in (FIRST_CALL + 1, X0)
    set_at(client, file, X20)
    client.go()
    set_at(client, file)
    assert client.go("stepOut")["line"] == Y10
    assert client.go("stepBack")["line"] == X10
    assert client.go("stepIn")["line"] == X20


def test_a_tick_is_the_smallest_step(client: DebugClient) -> None:
    tick = int(client.console("tick").split()[2])
    client.go("next", granularity="instruction")
    client.go("stepIn", granularity="instruction")
    assert int(client.console("tick").split()[2]) == tick + 2
    client.go("stepBack", granularity="instruction")
    assert int(client.console("tick").split()[2]) == tick + 1


def test_back_to_the_breakpoint_before(client: DebugClient, file: str) -> None:
    set_at(client, file, X10, X30)
    assert [client.go()["line"] for _ in range(3)] == [X10, X10, X30]
    assert [client.go("reverseContinue")["line"] for _ in range(2)] == [X10, X10]
    assert client.go("reverseContinue")["reason"] == "entry"
    assert client.event("invalidated") == {"areas": ["all"]}


@pytest.mark.parametrize("counted", [X10, EDGE])
def test_reverse_passes_a_breakpoint_whose_hit_condition_is_false(
    client: DebugClient, file: str, counted: int
) -> None:
    """Others, which hold elsewhere, neither stop there nor count."""
    own = {"line": counted, "hitCondition": "== 1"}
    set_at(client, file, own, {"line": X0, "hitCondition": "== 1"}, X30)
    places = []
    for _ in range(3):
        client.go()
        places.append(client.console("tick"))
    for place in places[1::-1]:
        client.go("reverseContinue")
        assert client.console("tick") == place
    assert client.go("reverseContinue")["reason"] == "entry"


def test_the_end_is_a_place_to_go_back_from(client: DebugClient, file: str) -> None:
    stop = client.go()
    assert stop["reason"] == "end"
    assert "ran to its end" in stop["text"] or stop["text"]
    assert client.go("stepBack")["line"] >= X30


# --- values ---------------------------------------------------------------------------------------


def test_scopes_show_axes_variables_cycles_and_what_waits(client: DebugClient, file: str) -> None:
    set_at(client, file, X20)
    frames = client.go()["frames"]
    axes = client.scope("Axes")
    assert list(axes) == ["X", "Y", "Z", "A"]
    x = client.unfolded(axes["X"]["variablesReference"])
    assert "ACT_POS" in client.unfolded(x["ACS"]["variablesReference"])
    values = client.scope("V.E")
    assert values["VALUE"]["evaluateName"] == "V.E.VALUE"
    assert values["LIST"]["indexedVariables"] == 10
    assert client.unfolded(values["LIST"]["variablesReference"])["[3]"]["value"] == "0"
    assert values["LIST"]["value"] == "[10] 0, 0, 0, …"
    assert values["LEVEL_1_A"]["value"].startswith("[3] [0].BOOLEAN 0, [0].SGN08 0, ")
    assert values["TEXT"]["type"] == "STRING"
    assert client.scope("HLI")["OVERRIDE"]["value"] == "100"
    cycles = client.scope("Realtime cycles")
    branches = client.unfolded(cycles["3"]["variablesReference"])
    edge = branches[f"{EDGE}: $IF EDGE V.RTA.ACS.ACT_POS.X > 5"]
    assert edge["value"].startswith("true")
    assert "V.RTA.ACS.ACT_POS.X" in client.unfolded(edge["variablesReference"])
    assert client.scope("V.P [decoder]")["V.P.A"]["value"] == "2"
    decoding = next(one for one in frames if one["presentationHint"] == "subtle")
    assert client.scope("P parameters", decoding["id"])["P5"]["value"] == "7"


def test_what_the_decoder_knows_is_read_only(client: DebugClient, file: str) -> None:
    set_at(client, file, X10)
    client.go()
    assert [client.console(name) for name in ("V.P.A", "P5")] == ["2", "7"]
    with pytest.raises(Refused, match=r"V\.P\.NONE has no value here"):
        client.console("V.P.NONE")
    with pytest.raises(Refused, match="decoder"):
        client.ask("setExpression", expression="V.P.A", value="3")


def test_a_value_that_is_set_holds_from_the_next_tick_on(client: DebugClient, file: str) -> None:
    """In the past another branch of the tape begins there."""
    set_at(client, file, X30)
    client.go()
    set_at(client, file, Y10)
    client.go("reverseContinue")
    client.go("reverseContinue")
    frame = client.ask("stackTrace", threadId=1)["stackFrames"][0]["id"]
    scopes = {one["name"]: one for one in client.ask("scopes", frameId=frame)["scopes"]}
    own = scopes["V.E"]["variablesReference"]
    assert client.ask("setVariable", variablesReference=own, name="COUNT", value="40") == {
        "value": "40"
    }
    assert "branch 2" in client.event("output")["output"]
    assert client.console("V.E.COUNT").endswith("→ 40")
    client.go("next", granularity="instruction")
    assert client.console("V.E.COUNT") == "40"
    with pytest.raises(Refused, match="value"):
        client.ask("setExpression", expression="V.E.COUNT", value="many")


@pytest.mark.parametrize(
    ("name", "value", "stored"),
    [("V.E.COUNT", "3.5", "4"), ("V.E.FLAG", "7", "1"), ("V.E.VALUE1", "3.5", "3.5")],
)
def test_the_value_that_its_type_makes_is_answered(
    client: DebugClient, file: str, name: str, value: str, stored: str
) -> None:
    """A whole number is rounded, a truth value is 0 or 1 (RC-307): the answer says it at once."""
    set_at(client, file, X30)
    client.go()
    answer = client.ask("setExpression", expression=name, value=value)
    assert answer["value"] == stored
    assert client.console(name).endswith(f"→ {stored}")
    client.go("next", granularity="instruction")
    assert client.console(name) == stored


# --- the console ----------------------------------------------------------------------------------


def test_the_console_travels_and_explains(client: DebugClient) -> None:
    client.console("tick 100")
    assert client.event("stopped")["reason"] == "goto"
    assert client.console("tick").startswith("before tick 100 = 0.100000 s")
    client.console("back 10 ms")
    assert client.console("tick").startswith("before tick 90")
    client.console("last V.E.COUNT")
    assert client.console("V.E.COUNT") == "1"
    assert "evaluated in ticks" in client.console(f"why 3:{EDGE}")
    client.console("reaction")
    assert client.console("tick").startswith("before tick 1 ")
    assert "back 10 ms" in client.console("help")
    client.events.clear()
    client.console("until M100")
    assert client.event("stopped")["reason"] == "goto"
    for wrong in ("back tomorrow", "why me", "V.E.NOTHING", "until", "branch 77", ""):
        with pytest.raises(Refused):
            client.console(wrong)


def test_the_console_completes(client: DebugClient) -> None:
    found = client.ask("completions", text="V.E.COU", column=8)["targets"]
    assert "V.E.COUNT" in [one["label"] for one in found]
    assert {(one["start"], one["length"]) for one in found} == {(1, 7)}
    assert "back" in [
        one["label"] for one in client.ask("completions", text="", column=1)["targets"]
    ]


def test_a_pause_ends_what_goes_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A search backward stops where it began; the console says that it was interrupted."""
    part = tmp_path / "long.nc"
    part.write_text("G04 X10\nG04 X10\nM30\n", "utf-8")
    with DebugClient() as client:
        client.ask("initialize")
        client.ask("launch", program=str(part), stopOnEntry=True, until="8 s")
        point = {"line": 1, "condition": "V.E.COUNT > 5"}
        client.ask("setBreakpoints", source={"path": str(part)}, breakpoints=[point])
        client.ask("configurationDone")
        client.stopped()
        client.go()
        begun, goes_on = threading.Event(), threading.Event()
        interrupt = Session.interrupt

        def noted(session: Session) -> None:
            interrupt(session)
            goes_on.set()

        monkeypatch.setattr(Session, "interrupt", noted)
        search = RemoteEngine.last_hit

        def held(engine: RemoteEngine, *words: Any) -> Found:
            begun.set()
            assert goes_on.wait(60)
            return search(engine, *words)

        monkeypatch.setattr(timeline, "PART_TICKS", 100)
        for command, arguments in (
            ("reverseContinue", {"threadId": 1}),
            ("evaluate", {"expression": "last V.E.COUNT + V.E.VALUE", "context": "repl"}),
        ):
            begun.clear()
            goes_on.clear()
            with monkeypatch.context() as patch:
                patch.setattr(RemoteEngine, "last_hit", held)
                number = client.send(command, **arguments)
                assert begun.wait(60)
                paused = client.send("pause", threadId=1)
                answer = client.answer(number)
                client.answer(paused)
            if command == "evaluate":
                assert not answer["success"]
                assert "interrupted" in answer["message"]
            else:
                assert client.stopped()["reason"] == "pause"
        assert client.ask("evaluate", expression="tick", context="repl")["result"].startswith(
            "before tick 8000 "
        )


def test_a_long_way_back_shows_its_progress(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where everything is run again, it shows how many of how many ticks have been."""
    part = tmp_path / "long.nc"
    part.write_text("G04 X10\nM30\n", "utf-8")
    monkeypatch.setattr(report, "PROGRESS_S", 0.0)
    monkeypatch.setattr(timeline, "PART_TICKS", 1000)
    with DebugClient() as client:
        client.ask("initialize", supportsProgressReporting=True)
        client.ask("launch", program=str(part), stopOnEntry=True, until="8 s")
        point = {"line": 1, "condition": "V.E.COUNT > 5"}
        client.ask("setBreakpoints", source={"path": str(part)}, breakpoints=[point])
        client.ask("configurationDone")
        client.stopped()
        client.go()
        client.send("reverseContinue", threadId=1)
        begun = client.event("progressStart", lambda body: "/" in body["message"])
        assert begun["message"] == "0 / 7,999 ticks"
        assert client.event("progressEnd")


def test_a_pause_between_two_searches_ends_what_goes_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is not lost where a breakpoint has been found that is not due."""
    part = tmp_path / "short.nc"
    part.write_text("G04 X1\nG04 X1\nM30\n", "utf-8")
    with DebugClient() as client:
        client.ask("initialize")
        client.ask("launch", program=str(part), stopOnEntry=True, until="1.5 s")
        lines = {"source": {"path": str(part)}, "breakpoints": [{"line": 2, "hitCondition": "9"}]}
        client.ask("setBreakpoints", **lines)
        client.ask("configurationDone")
        client.stopped()
        client.go()
        found, goes_on = threading.Event(), threading.Event()
        interrupt = Session.interrupt

        def noted(session: Session) -> None:
            interrupt(session)
            goes_on.set()

        def not_due(*_words: Any) -> tuple[None, list[Any]]:
            found.set()
            assert goes_on.wait(60)
            return None, []

        monkeypatch.setattr(Session, "interrupt", noted)
        monkeypatch.setattr(Debuggee, "_due_here", not_due)
        client.send("reverseContinue", threadId=1)
        assert found.wait(60)
        client.send("pause", threadId=1)
        assert client.stopped()["reason"] == "pause"
        where = client.ask("evaluate", expression="tick", context="repl")["result"]
        assert not where.startswith("before tick 0 ")

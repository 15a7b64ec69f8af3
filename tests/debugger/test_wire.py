# SPDX-License-Identifier: MIT
"""The debugger's protocol at its edges: garbage, bounds, wrong orders, ports, the ends of a run."""

from __future__ import annotations

import io
import json
import random
import socket
import struct
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support.debug_client import DebugClient, Refused
from support.random_seeds import all_seeds

from nctakt import Failure
from nctakt.debugger.adapter import MAX_REQUESTS
from nctakt.debugger.server import PortServer
from nctakt.ports.framing import MAX_MESSAGE, MessageReader, MessageWriter

pytestmark = pytest.mark.slow

ENDLESS = """\
$WHILE 1
  G01 X100 F6000
  G01 X0
$ENDWHILE
M30
"""

SHORT = 'G01 X1 F6000\n#MSG ["over"]\nM30\n'


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("programs")
    (path / "endless.nc").write_text(ENDLESS, "utf-8")
    (path / "short.nc").write_text(SHORT, "utf-8")
    (path / "wrong.nc").write_text("G01 Q1\nM30\n", "utf-8")
    return path


@pytest.fixture
def client() -> Iterator[DebugClient]:
    with DebugClient() as own:
        yield own


def framed(body: bytes) -> bytes:
    return b"Content-Length: %d\r\n\r\n%b" % (len(body), body)


# --- the transport --------------------------------------------------------------------------------


def test_what_is_written_is_read() -> None:
    stream = io.BytesIO()
    writer = MessageWriter(stream)
    writer.write({"type": "event", "event": "ä"})
    writer.write({"type": "event", "event": "second"})
    stream.seek(0)
    reader = MessageReader(stream, is_strict=True)
    assert [(reader.read() or {})["seq"] for _ in range(2)] == [1, 2]
    assert reader.read() is None


@pytest.mark.parametrize(
    ("bytes_", "number"),
    [
        (b"GET / HTTP/1.1\r\n\r\n", "901220"),
        (b"Content-Length: many\r\n\r\n", "901220"),
        (b"Content-Type: x\r\n" * 9, "901220"),
        (framed(b"[1, 2]"), "901222"),
        (framed(b"{"), "901222"),
        (framed(b'{"a": NaN}'), "901222"),
        (framed(b'{"a": 1e999}'), "901222"),
        (framed(b"\xff\xfe"), "901222"),
        (framed(b"[" * 100_000), "901222"),
        (framed(b" " * (MAX_MESSAGE + 1)), "901221"),
    ],
)
def test_what_is_no_message_is_reported_and_passed_over(bytes_: bytes, number: str) -> None:
    """On a pipe the next message is found again."""
    reader = MessageReader(io.BytesIO(bytes_ + framed(b'{"seq": 1}')), is_strict=False)
    with pytest.raises(Failure, match=number):
        reader.read()
    found: dict[str, Any] | None = {}
    while found is not None and "seq" not in found:
        try:
            found = reader.read()
        except Failure:
            continue
    assert found == {"seq": 1}


def test_the_longest_message_is_read() -> None:
    body = json.dumps({"text": ""}).encode()
    body = json.dumps({"text": " " * (MAX_MESSAGE - len(body))}).encode()
    assert len(body) == MAX_MESSAGE
    assert MessageReader(io.BytesIO(framed(body)), is_strict=True).read() is not None


def test_a_page_in_a_browser_is_not_understood() -> None:
    """Its request begins with no header of ours: what its body says is not read."""
    body = framed(b'{"seq": 1, "type": "request", "command": "launch"}')
    reader = MessageReader(io.BytesIO(b"POST / HTTP/1.1\r\nHost: x\r\n\r\n" + body), is_strict=True)
    with pytest.raises(Failure, match="901220"):
        reader.read()
    assert reader.read() is None


# --- whatever a client sends ----------------------------------------------------------------------


@pytest.mark.nightly
def test_a_request_at_a_wrong_time_or_with_wrong_arguments_is_refused(
    client: DebugClient, folder: Path
) -> None:
    for command in ("next", "setBreakpoints", "configurationDone", "restart", "attach", "nothing"):
        with pytest.raises(Refused):
            client.ask(command)
    with pytest.raises(Refused, match=r"missing\.nc") as refused:
        client.ask("launch", program=str(folder / "missing.nc"))
    assert refused.value.error["showUser"]
    for wrong in (
        {"program": 1},
        {"program": []},
        {"channels": {"x": "a"}},
        {"at": [1]},
        {"skip": [11]},
        {"until": "soon"},
        {"language": "fr"},
        {"machine": "nowhere"},
        {"set": {"V.E.COUNT": []}},
        {"set": {"V.E.NOTHING": 1}},
        {"plc": "none.py"},
    ):
        with pytest.raises(Refused):
            client.ask("launch", **{"program": str(folder / "short.nc"), **wrong})
    with pytest.raises(Refused, match=r"wrong\.nc has errors"):
        client.ask("launch", program=str(folder / "wrong.nc"))
    assert "20797" in client.event("output", lambda body: "Q1" in body["output"])["output"]
    client.begin(str(folder / "short.nc"))
    for command, arguments in (
        ("next", {"threadId": 9}),
        ("stackTrace", {"threadId": 1001}),
        ("scopes", {"frameId": 99}),
        ("variables", {"variablesReference": -1}),
        ("setBreakpoints", {"breakpoints": 1}),
        ("setBreakpoints", {"source": {"path": 1}, "breakpoints": [{"line": "x"}]}),
        ("evaluate", {}),
        ("source", {"sourceReference": 7}),
        ("exceptionInfo", {"threadId": 1}),
    ):
        with pytest.raises(Refused):
            client.ask(command, **arguments)
    client.ask("disconnect")


def test_random_messages_neither_end_nor_hold_the_debugger(
    client: DebugClient, folder: Path
) -> None:
    """Each request gets its answer, and none of them is an error of nctakt's own."""
    abilities = client.begin(str(folder / "short.nc"), stopOnEntry=True)
    client.ask("configurationDone")
    client.stopped()
    assert abilities["supportsStepBack"]
    commands = (
        "setBreakpoints", "setDataBreakpoints", "setFunctionBreakpoints", "evaluate", "variables",
        "setExceptionBreakpoints", "dataBreakpointInfo", "stackTrace", "scopes", "completions",
        "setVariable", "setExpression", "source", "breakpointLocations", "next", "stepBack",
        "exceptionInfo", "cancel", "initialize", "threads", "loadedSources", "pause", "x",
    )  # fmt: skip
    names = (
        "line", "source", "path", "breakpoints", "expression", "context", "frameId", "threadId",
        "variablesReference", "name", "value", "text", "column", "dataId", "filters", "start",
        "condition", "hitCondition", "granularity", "requestId", "logMessage", "mode",
    )  # fmt: skip
    for seed in all_seeds(3, 2):
        chance = random.Random(seed)

        def anything(depth: int = 0, chance: random.Random = chance) -> Any:
            kind = chance.randrange(9 if depth < 3 else 6)
            if kind > 7:
                return {chance.choice(names): anything(depth + 1) for _ in range(3)}
            if kind > 5:
                return [anything(depth + 1) for _ in range(chance.randrange(3))]
            texts = ("V.E.COUNT", "repl", "tick 3", "M30", "% 0", "back", "\0{}", "instruction")
            return (None, True, chance.choice((-1, 0, 1, 2, 1 << 60)), 1.5, "", *texts)[
                chance.randrange(13)
            ]

        for _ in range(60):
            arguments = {chance.choice(names): anything() for _ in range(chance.randrange(5))}
            command = chance.choice(commands)
            answer = client.answer(client.send(command, **arguments))
            assert "internal error of nctakt" not in answer.get("message", ""), (
                seed,
                command,
                arguments,
            )
    client.ask("initialize")
    assert client.ask("threads")["threads"]


def test_bytes_that_are_no_messages_are_reported(client: DebugClient) -> None:
    client.writing.write(b"hello\r\n\r\n")
    assert "901220" in client.event("output")["output"]
    client.send_bytes(b"null")
    assert "901222" in client.event("output", lambda body: "901222" in body["output"])["output"]
    client.send_bytes(b'{"type": "response"}')
    assert client.ask("initialize")["supportsStepBack"]


def test_too_many_requests_are_refused(client: DebugClient, folder: Path) -> None:
    """While one of them works, at most ``MAX_REQUESTS`` others wait."""
    client.begin(str(folder / "short.nc"), stopOnEntry=True)
    body = json.dumps({"seq": 1000, "type": "request", "command": "threads"}).encode()
    slow = json.dumps(
        {"seq": 999, "type": "request", "command": "launch",
         "arguments": {"program": str(folder / "short.nc")}}
    ).encode()  # fmt: skip
    client.writing.write(framed(slow) + framed(body) * (MAX_REQUESTS + 50))
    answers = [client.answer(1000) for _ in range(MAX_REQUESTS + 50)]
    refused = [one for one in answers if not one["success"]]
    assert 0 < len(refused) <= 51
    assert "already waiting" in refused[0]["message"]


def test_breakpoints_beyond_the_bound_are_not_verified(client: DebugClient, folder: Path) -> None:
    """The others are watched; 8 stops are left for exceptions and steps."""
    program = str(folder / "short.nc")
    client.begin(program)
    own = {"source": {"path": program}, "breakpoints": [{"line": 1}] * 994}
    made = client.ask("setBreakpoints", **own)["breakpoints"]
    assert [one["verified"] for one in made] == [True] * 992 + [False] * 2
    assert "901152" in made[-1]["message"]
    client.ask("configurationDone")
    assert client.stopped()["line"] == 1


# --- a run on its way -----------------------------------------------------------------------------


def test_a_run_can_be_paused_and_shows_its_progress(client: DebugClient, folder: Path) -> None:
    """Requests are answered meanwhile; what needs a run that is is refused."""
    program = str(folder / "endless.nc")
    able = {"supportsProgressReporting": True}
    client.begin(program, until="24 h", client=able)
    client.ask("configurationDone")
    assert client.event("progressStart")["cancellable"]
    with pytest.raises(Refused, match="only possible while the run is stopped"):
        client.ask("next", threadId=1)
    with pytest.raises(Refused, match="only possible while the run is stopped"):
        client.console("back 1 ms")
    tick = int(client.console("tick").split()[2])
    assert int(client.console("tick").split()[2]) >= tick
    line = client.ask("setBreakpoints", source={"path": program}, breakpoints=[{"line": 3}])
    assert line["breakpoints"][0]["verified"]
    assert client.stopped()["line"] == 3
    client.ask("setBreakpoints", source={"path": program}, breakpoints=[])
    client.ask("continue", threadId=1)
    client.ask("pause", threadId=1)
    assert client.stopped()["reason"] == "pause"
    client.ask("terminate")
    assert client.event("exited") == {"exitCode": 0}
    client.event("terminated")


def test_requests_that_wait_can_be_cancelled(client: DebugClient, folder: Path) -> None:
    client.begin(str(folder / "short.nc"), stopOnEntry=True)
    slow = client.send("evaluate", expression="why", context="repl")
    waiting = client.send("threads")
    client.send("cancel", requestId=waiting)
    assert client.answer(slow)["request_seq"] == slow
    answer = client.answer(waiting)
    assert (answer["success"], answer["message"]) == (False, "cancelled")


def test_a_cancellation_that_comes_too_late_is_forgotten(client: DebugClient, folder: Path) -> None:
    """Else those that were too late would fill the bound for those that are not."""
    client.begin(str(folder / "short.nc"), stopOnEntry=True)
    for _ in range(MAX_REQUESTS + 1):
        number = client.send("threads")
        client.answer(number)
        client.answer(client.send("cancel", requestId=number))
    slow = client.send("evaluate", expression="why", context="repl")
    waiting = client.send("threads")
    client.send("cancel", requestId=waiting)
    assert client.answer(slow)["success"]
    assert client.answer(waiting)["message"] == "cancelled"


def test_a_request_whose_number_is_none_is_answered(client: DebugClient) -> None:
    client.send_bytes(b'{"seq": [1], "type": "request", "command": "threads"}')
    assert client.ask("initialize")["supportsStepBack"]


@pytest.mark.nightly
def test_a_restart_reads_the_program_again(client: DebugClient, tmp_path: Path) -> None:
    """Breakpoints stay; those whose line is gone are reported."""
    program = tmp_path / "part.nc"
    program.write_text(SHORT, "utf-8")
    client.begin(str(program), stopOnEntry=True)
    client.ask("setBreakpoints", source={"path": str(program)}, breakpoints=[{"line": 3}])
    client.ask("configurationDone")
    assert client.stopped()["reason"] == "entry"
    program.write_text(SHORT.replace("X1", "X2"), "utf-8")
    client.ask("restart")
    assert client.event("breakpoint")["breakpoint"]["verified"]
    assert client.stopped()["reason"] == "entry"
    assert client.go()["line"] == 3
    assert client.console("V.RTA.ACS.ACT_POS.X") == "2"
    assert client.go()["reason"] == "end"
    client.ask("continue", threadId=1)
    client.event("terminated")
    program.write_text("G01 Q1\nM30\n", "utf-8")
    with pytest.raises(Refused, match="has errors"):
        client.ask("restart")
    client.event("terminated")


def test_without_breakpoints_the_run_goes_to_its_end(client: DebugClient, folder: Path) -> None:
    client.begin(str(folder / "short.nc"), noDebug=True, language="de")
    program = str(folder / "short.nc")
    client.ask("setBreakpoints", source={"path": program}, breakpoints=[{"line": 2}])
    client.ask("configurationDone")
    assert "over" in client.event("output", lambda body: body["category"] == "stdout")["output"]
    assert "Takte" in client.event("output", lambda body: "Takt" in body["output"])["output"]
    client.event("terminated")


def test_an_error_stops_and_explains_itself(client: DebugClient, tmp_path: Path) -> None:
    """With lines from zero on, as some clients count them."""
    program = tmp_path / "fails.nc"
    program.write_text("G01 X1 F6000\n#ERROR [ID=77 RC=2]\nM30\n", "utf-8")
    zero = {"linesStartAt1": False, "columnsStartAt1": False}
    abilities = client.begin(str(program), client=zero)
    assert "class2" in [one["filter"] for one in abilities["exceptionBreakpointFilters"]]
    made = client.ask("setBreakpoints", source={"path": str(program)}, breakpoints=[{"line": 0}])
    assert made["breakpoints"][0]["line"] == 0
    client.ask("setExceptionBreakpoints", filters=["user_error"])
    client.ask("configurationDone")
    assert client.stopped()["line"] == 0
    stop = client.go()
    assert (stop["reason"], stop["text"]) == ("exception", "user_error 77 2")
    reported = client.ask("exceptionInfo", threadId=1)
    assert "77" in reported["description"]
    assert reported["breakMode"] == "always"


# --- outside of this process ----------------------------------------------------------------------


def test_only_the_allowed_folders_are_run(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "own.nc").write_text(SHORT, "utf-8")
    with DebugClient(folders=[str(tmp_path)]) as client:
        with pytest.raises(Refused, match="outside"):
            client.ask("launch", program=str(folder / "short.nc"))
        client.begin(str(tmp_path / "own.nc"))


def test_a_plc_of_the_project_lies_in_the_allowed_folders(folder: Path, tmp_path: Path) -> None:
    """900917."""
    own = tmp_path / "own"
    own.mkdir()
    (tmp_path / "cell.py").write_text("raise SystemExit\n", "utf-8")
    (own / "nctakt.toml").write_text('plc = "../cell.py"\n', "utf-8")
    (own / "own.nc").write_text(SHORT, "utf-8")
    with DebugClient(folders=[str(own)]) as client:
        with pytest.raises(Refused, match="outside"):
            client.ask("launch", program=str(own / "own.nc"))


def test_a_client_that_breaks_off_leaves_no_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    broken: list[object] = []
    monkeypatch.setattr(threading, "excepthook", lambda hook: broken.append(hook.exc_value))
    server = PortServer(0)
    threading.Thread(target=server.serve, daemon=True).start()
    before = set(threading.enumerate())
    client = socket.create_connection(("127.0.0.1", server.endpoint.port), timeout=60)
    client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    client.sendall(framed(b'{"seq": 1, "type": "request", "command": "initialize"}') * 200)
    client.recv(1)
    client.close()
    for thread in set(threading.enumerate()) - before:
        thread.join(timeout=60)
    server.close()
    assert broken == []


def test_a_port_serves_several_clients_and_refuses_others(folder: Path) -> None:
    server = PortServer(0)
    threading.Thread(target=server.serve, daemon=True).start()
    with pytest.raises(Failure, match="901920"):
        PortServer(server.endpoint.port)
    with socket.create_connection(("127.0.0.1", server.endpoint.port), timeout=60) as browser:
        browser.sendall(b"GET / HTTP/1.1\r\n\r\n")
        assert b"901220" in browser.makefile("rb").read()
    for _ in range(2):
        with socket.create_connection(("127.0.0.1", server.endpoint.port), timeout=60) as client:
            client.sendall(framed(b'{"seq": 1, "type": "request", "command": "initialize"}'))
            answer = MessageReader(client.makefile("rb"), is_strict=True).read()
            assert answer is not None
            assert answer["success"]
    server.close()


def test_a_port_runs_programs_for_who_has_the_token(folder: Path, tmp_path: Path) -> None:
    """Without it only what ``--confine`` allows; the file of the token is of this user alone."""
    program = str(folder / "short.nc")
    for folders, arguments, refusal in (
        ((), {}, "901921"),
        ((), {"token": "none"}, "901922"),
        ((str(tmp_path),), {}, "outside"),
        ((str(folder),), {"token": "none"}, "901922"),
    ):
        server = PortServer(0, folders=folders)
        threading.Thread(target=server.serve, daemon=True).start()
        with DebugClient(port=server.endpoint.port) as client:
            client.ask("initialize")
            with pytest.raises(Refused) as refused:
                client.ask("launch", program=program, **arguments)
            assert refusal in refused.value.error["format"]
        server.close()
    for folders, has_token in (((), True), ((str(folder),), False)):
        server = PortServer(0, folders=folders)
        threading.Thread(target=server.serve, daemon=True).start()
        token = server.endpoint.token
        with DebugClient(port=server.endpoint.port) as client:
            client.begin(program, **({"token": token} if has_token else {}))
            client.ask("configurationDone")
            assert client.stopped()["reason"] == "end"
        server.close()


def test_the_command_speaks_over_standard_input_and_output(folder: Path) -> None:
    """What a PLC prints does not get into the protocol."""
    plc = folder / "loud.py"
    plc.write_text(
        "from nctakt import Plc\nclass Loud(Plc):\n    def cycle(self, hli):\n        print('x')\n",
        "utf-8",
    )
    requests = [
        ("initialize", {}),
        ("launch", {"program": str(folder / "short.nc"), "plc": str(plc), "stopAtEnd": False}),
        ("configurationDone", {}),
    ]
    body = b"".join(
        framed(json.dumps({"seq": n, "type": "request", "command": c, "arguments": a}).encode())
        for n, (c, a) in enumerate(requests, start=1)
    )
    words = [sys.executable, "-m", "nctakt", "dap"]
    with subprocess.Popen(
        words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(body)
        process.stdin.flush()
        reader = MessageReader(process.stdout, is_strict=True)
        events = []
        while "terminated" not in events:
            message = reader.read()
            assert message is not None
            events.append(message.get("event"))
        process.stdin.close()
        assert process.wait(timeout=60) == 0


def test_the_command_ends_when_it_is_left_while_its_input_is_open() -> None:
    requests = [
        b'{"seq": 1, "type": "request", "command": "%b"}' % name
        for name in (b"initialize", b"disconnect")
    ]
    words = [sys.executable, "-m", "nctakt", "dap"]
    with subprocess.Popen(
        words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdin is not None
        assert process.stderr is not None
        process.stdin.write(b"".join(map(framed, requests)))
        process.stdin.flush()
        assert process.wait(timeout=60) == 0
        assert process.stderr.read() == b""

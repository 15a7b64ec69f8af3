# SPDX-License-Identifier: MIT
"""One project, one result: every way to run a program takes the same settings of its project.

The project names machine, PLC, values and limit. What each way must give is the run whose words
name the four themselves.
"""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.launch import read_configuration
from nctakt.session.session import Session
from nctakt.studies.study import Study

#: A program for demo5, where C is an axis: its cycle fires later with half the speed, and stores
#: what was set before the first tick. It does not end within the limit.
PROGRAM = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
$IF ONCE V.RTA.ACS.ACT_POS.C >= 1
V.E.COUNT = V.E.VALUE
$ENDIF
#RT CYCLE END
G01 C300 F600
M30
"""
PLC = "class Cell:\n    def cycle(self, hli):\n        hli.override_pct = 50\n"
PROJECT = """\
machine = "demo5"
plc = "cell.py"
until = "0.4 s"
signals = ["V.E.COUNT"]

[set]
V.E.VALUE = 5
"""
NAMED = ("--machine", "demo5", "--plc", "cell.py", "--set", "V.E.VALUE=5", "--until", "400ms")

Captured = pytest.CaptureFixture[str]


@pytest.fixture
def program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """The program in the folder of its project, which is the working directory."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("NCTAKT_MACHINE", raising=False)
    Path("a.nc").write_text(PROGRAM, "utf-8")
    Path("cell.py").write_text(PLC, "utf-8")
    return "a.nc"


def document(captured: Captured, *words: str) -> dict:
    """What a command shows as JSON."""
    assert main([*words, "--format", "json"]) == 0
    return json.loads(captured.readouterr().out)


def end_of(found: dict) -> tuple[str, int, int]:
    """State and length of a run, and the tick in which its cycle fired."""
    branch = found["cycles"][0]["reactions"][0]
    return found["state"], found["ticks"], branch["first_tick"]


def expected(captured: Captured, program: str) -> tuple[str, int, int]:
    """The run whose words name all four, and whose fired cycle has seen the value."""
    found = end_of(document(captured, "run", program, *NAMED, "--trace", "named.csv",
                            "--signals", "V.E.COUNT"))  # fmt: skip
    assert found[:2] == ("limit", 400)
    assert Path("named.csv").read_text().splitlines()[-1].endswith(",5,")
    Path("nctakt.toml").write_text(PROJECT, "utf-8")
    return found


def test_the_commands_that_run(program: str, capsys: Captured) -> None:
    """run, why, coverage; a recorded run and its replay; list runs nobody's PLC unless named."""
    named = expected(capsys, program)
    for command in ("run", "why"):
        assert end_of(document(capsys, command, program)) == named, command
    without_plc = end_of(document(capsys, "run", program, "--plc", "default"))
    assert end_of(document(capsys, "disassemble", program)) == without_plc != named
    assert end_of(document(capsys, "disassemble", program, "--plc", "cell.py")) == named
    run = document(capsys, "run", program, "--record", "a.tape", "--trace", "a.csv")
    assert end_of(run) == named
    assert Path("a.csv").read_bytes() == Path("named.csv").read_bytes()
    Path("nctakt.toml").write_text('signals = ["V.E.COUNT"]\n', "utf-8")
    assert end_of(document(capsys, "replay", "a.tape", "--trace", "b.csv")) == named
    assert Path("b.csv").read_bytes() == Path("named.csv").read_bytes()
    Path("nctakt.toml").write_text(PROJECT, "utf-8")
    assert main(["coverage", program, "--format", "json"]) == 0
    counted = json.loads(capsys.readouterr().out)
    Path("nctakt.toml").unlink()
    assert main(["coverage", program, *NAMED, "--format", "json"]) == 0
    assert counted == json.loads(capsys.readouterr().out)


def test_words_come_before_the_project(program: str, capsys: Captured) -> None:
    """Each of the four can be named; a limit in ticks replaces that of the project."""
    expected(capsys, program)
    run = document(capsys, "run", program, "--plc", "default", "--ticks", "500",
                   "--set", "V.E.VALUE=7", "--trace", "c.csv")  # fmt: skip
    assert (run["state"], run["ticks"]) == ("limit", 500)
    assert Path("c.csv").read_text().splitlines()[-1].endswith(",7,")
    fast = end_of(document(capsys, "run", program, "--plc", "default"))
    assert fast[2] < end_of(document(capsys, "run", program))[2]


def test_a_study(program: str, capsys: Captured) -> None:
    """Its rows; the command that it shows for a run makes the same one."""
    named = expected(capsys, program)
    words = {"time": "time of fired 1", "count": "V.E.COUNT at end"}
    study = Study(program=program, measure=words, vary=[{"variable": "V.E.WORD", "values": [0]}])
    row = study.run().rows[0]
    assert (row["state"], row["ticks"], row["time"]) == ("limit", 400, named[2] / 1000)
    assert row["count"] == 5
    command = study.command(0)
    assert command is not None
    assert end_of(document(capsys, *command.split()[1:])) == named
    study.record(0, "study.tape")
    Path("nctakt.toml").unlink()
    assert end_of(document(capsys, "replay", "study.tape")) == named


def session_end(session: Session, named: tuple[str, int, int]) -> None:
    """The run of a session is the expected one."""
    session.run()
    assert (session.description.cycle_time_us * session.tick, session.read("V.E.COUNT")[0]) == (
        400_000,
        5.0,
    )
    session.go_to(named[2] - 1)
    assert session.read("V.E.COUNT")[0] == 0.0
    session.go_to(named[2] + 1)
    assert session.read("V.E.COUNT")[0] == 5.0


def test_the_debugger(program: str, capsys: Captured) -> None:
    """A launch that names the program alone."""
    named = expected(capsys, program)
    with contextlib.closing(read_configuration(Arguments({"program": program}), ()).open()) as one:
        session_end(one, named)


def test_the_page(program: str, capsys: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    """``live`` opens the session that its page shows."""
    named = expected(capsys, program)
    monkeypatch.setattr(
        "nctakt.live.server.serve", lambda shared, *_, **__: session_end(shared.session, named)
    )
    assert main(["live", program, "--port", "0"]) == 0


def test_the_server(program: str, capsys: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    """``serve`` goes on beyond the limit: what it serves has no end."""
    named = expected(capsys, program)
    served = []

    async def serve(session: Session, *_: object, **__: object) -> None:
        session.run("0.4 s")
        served.append((session.tick, session.read("V.E.COUNT")[0], session.is_over))
        session.run("0.5 s")
        served.append(session.tick)
        session.go_to(named[2])
        served.append(session.read("V.E.COUNT")[0])

    monkeypatch.setattr("nctakt.servers.serving.serve", serve)
    assert main(["serve", program, "--ads=127.0.0.1:0"]) == 0
    assert served == [(400, 5.0, False), 500, 0.0]


TESTS = """\
def test_settings(run_nc):
    run = run_nc("a.nc", signals=["V.E.COUNT"], limit_fails=False)
    assert (run.run.state, run.run.ticks) == ("limit", 400)
    assert run.fired(cycle=1).times == [{time}]
    assert run.value_at("V.E.COUNT", 0.4) == 5
    assert run_nc("a.nc", plc="default", limit_fails=False).fired().at < {time}
    assert run_nc("a.nc", until="0.5 s").duration == 0.5

def test_limit(run_nc):
    run_nc("a.nc")
"""


@pytest.fixture
def here() -> Iterator[list[str]]:
    """Words of pytest in this process."""
    yield ["-p", "no:cacheprovider", "-p", "no:faulthandler", "-q", "--import-mode=importlib"]


def test_tests(program: str, capsys: Captured, here: list[str]) -> None:
    """``run_nc``, expectations in comments; the project's limit fails a test, its own does not."""
    named = expected(capsys, program)
    time = named[2] / 1000
    Path("test_ways.py").write_text(TESTS.format(time=time), "utf-8")
    comment = f"; expect: fired once at {time}s; V.E.COUNT = 5 at end\n"
    Path("limit.nc").write_text(comment + PROGRAM, "utf-8")
    Path("own.nc").write_text("; given: until 0.5s\n" + comment + PROGRAM, "utf-8")
    Path("pytest.ini").write_text("[pytest]\n", "utf-8")
    assert pytest.main(here) == 1
    shown = capsys.readouterr().out
    assert "2 failed, 2 passed" in shown
    assert "limit.nc: error 901016" in shown
    assert "Failure: error 901016" in shown

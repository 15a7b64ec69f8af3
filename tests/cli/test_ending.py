# SPDX-License-Identifier: MIT
"""SIGTERM ends each long command as Ctrl-C does, also where SIGINT is ignored (``nohup … &``)."""

from __future__ import annotations

import contextlib
import json
import os
import random
import shutil
import signal
import socket
import subprocess
import sys
import time
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, NoReturn

import pytest
from support.command_table import commands

import nctakt
from nctakt.base import interrupts
from nctakt.cli import group, main
from nctakt.lists.machine.machine import load_machine
from nctakt.results.trace.reading import read_trace

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(os.name != "posix", reason="signals are sent in another way there"),
]

#: Without what NiceGUI takes for its own tests.
ENVIRONMENT = {name: value for name, value in os.environ.items() if "PYTEST" not in name}

SOURCES = Path(nctakt.__file__).parent.parent

ENDLESS = '#MSG ["begun"]\n$WHILE 1\nG01 X10 F6000\nG01 X0\n$ENDWHILE\nM30\n'

STUDY = """\
program = "part.nc"
until = "0.05 s"
plc = "slow.py"
vary = [{ variable = "V.E.VALUE", from = 1, to = 20000, step = 1 }]
measure.end = "X at end"
"""

CAPABILITIES: dict[str, object] = {"capabilities": {}}

SLOW = "import time\nclass P:\n  def cycle(self, hli):\n    time.sleep(0.0001)\n"


class Started:
    """A command in its own group; ``ignores``: SIGINT is ignored, as in the background."""

    def __init__(self, folder: Path, *words: str, ignores: bool) -> None:
        before = signal.signal(signal.SIGINT, signal.SIG_IGN if ignores else signal.SIG_DFL)
        try:
            self.process = subprocess.Popen(
                [sys.executable, "-P", "-m", "nctakt", *words],
                cwd=folder,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env={**ENVIRONMENT, "PYTHONPATH": str(SOURCES), "PYTHONUNBUFFERED": "1"},
                start_new_session=True,
            )
        finally:
            signal.signal(signal.SIGINT, before)
        self.said = ""

    def until(self, text: str) -> None:
        """Wait until it has said a text."""
        while text not in self.said:
            line = (self.output.readline()).decode()
            assert line, self.said
            self.said += line

    @property
    def output(self) -> IO[bytes]:
        assert self.process.stdout is not None
        return self.process.stdout

    def end(self, number: signal.Signals, *, in_group: bool = False) -> int:
        """Send a signal; the exit code. No process of the group is left then."""
        if in_group:
            os.killpg(self.process.pid, number)
        else:
            self.process.send_signal(number)
        self.said += self.output.read().decode()  # to the end of all that hold it open
        code = self.process.wait(60)
        for _ in range(200):
            try:
                os.killpg(self.process.pid, 0)
            except ProcessLookupError:
                return code
            time.sleep(0.05)
        pytest.fail("processes are left")

    def close(self) -> None:
        """End all of it for sure."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.communicate()


Start = Callable[..., Started]

_LOAD = ("rtconf.lis", "--load", "load.toml")
_LONG = ("endless.nc", "--until", "9999min")

#: What keeps each command busy; those that end at once are interrupted while they begin.
BUSY: dict[str, tuple[str, ...]] = {
    "demo": ("--port", "0"),
    "init": (".",),
    "new": ("machine",),
    "check": ("long.nc",),
    "run": (*_LONG, "--trace", "out.csv", "--record", "out.tape"),
    "live": ("part.nc", "--port", "0", "--record", "out.tape"),
    "why": _LONG,
    "time": _LONG,
    "compare": ("log.csv", *_LONG),
    "coverage": _LONG,
    "disassemble": _LONG,
    "explain": ("V.E.WORD",),
    "test": ("endless.nc", "long.nc"),
    "study": ("plan.toml", "--out", "rows.csv", "--yes"),
    "replay": ("long.tape",),
    "schedule": (),
    "schedule analyse": _LOAD,
    "schedule compare": ("rtconf.lis", *_LOAD),
    "schedule learn": ("rtconf.lis", "load.toml", "--output", "learnt.toml"),
    "schedule run": (*_LOAD, "--duration", "60s"),
    "schedule show": ("rtconf.lis",),
    "schedule simulate": (*_LOAD, "--duration", "1h", "--plot", "out.svg"),
    "schedule suggest": (*_LOAD, "--slack", "20"),
    "serve": ("part.nc", "--ads=127.0.0.1:0", "--record", "out.tape"),
    "fmu": ("long.nc", "--output", "out.fmu"),
    "dap": (),
    "lsp": (),
}

#: Files under a whole name -> what raises an exception unless they are whole.
WHOLE: dict[str, Callable[[Path], object]] = {
    "out.csv": read_trace,
    "out.fmu": lambda path: zipfile.ZipFile(path).testzip(),
    "rows.csv": lambda path: pytest.fail("20,000 runs cannot have ended"),
    "machine": load_machine,
}


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Start]:
    """Starts commands in a folder with programs."""
    (tmp_path / "part.nc").write_text("G01 X[V.E.VALUE] F600\nG04 1\nM30\n", "utf-8")
    (tmp_path / "endless.nc").write_text(ENDLESS, "utf-8")
    (tmp_path / "plan.toml").write_text(STUDY, "utf-8")
    (tmp_path / "slow.py").write_text(SLOW, "utf-8")
    started: list[Started] = []

    def begin(*words: str, ignores: bool = True) -> Started:
        started.append(Started(tmp_path, *words, ignores=ignores))
        return started[-1]

    yield begin
    for one in started:
        one.close()


@pytest.mark.nightly
def test_a_run_ends_between_two_ticks_with_its_records(start: Start, tmp_path: Path) -> None:
    """Exit code 1; trace and tape are whole.

    SIGINT that the shell lets be ignored stays so: Ctrl-C is for what is in front.
    """
    words = ("endless.nc", "--until", "9999min", "--trace", "out.csv", "--record", "run.tape")
    run = start("run", *words)
    run.until("begun")
    run.process.send_signal(signal.SIGINT)
    with pytest.raises(subprocess.TimeoutExpired):
        run.process.wait(0.5)
    assert run.end(signal.SIGTERM) == 1
    assert "endless.nc: interrupted, " in run.said
    ticks = int(run.said.split("interrupted, ")[1].split()[0])
    assert read_trace(tmp_path / "out.csv").ticks == ticks
    assert (tmp_path / "run.tape").exists()


@pytest.mark.nightly
@pytest.mark.parametrize("in_group", [False, True], ids=["alone", "with its workers"])
def test_a_study_keeps_its_rows(start: Start, tmp_path: Path, in_group: bool) -> None:
    """A note says how many; no run counts as crashed, and all workers have ended."""
    study = start("study", "plan.toml", "--out", "rows.csv", "--processes", "2", "--yes")
    rows = tmp_path / "rows.csv.rows"
    for _ in range(600):
        if rows.exists() and rows.stat().st_size > 5_000:
            break
        time.sleep(0.05)
    assert study.end(signal.SIGTERM, in_group=in_group) == 1, study.said
    assert "rows.csv.rows" in study.said
    assert "Traceback" not in study.said
    assert b"crashed" not in rows.read_bytes()


@pytest.mark.parametrize("program", ["part.nc", "endless.nc"], ids=["waiting", "in a run"])
def test_watching_ends(start: Start, program: str) -> None:
    """With the exit code of the last time; a run that continues is interrupted."""
    pytest.importorskip("watchfiles")
    watched = start("run", program, "--until", "9999min", "--watch")
    watched.until("901069" if program == "part.nc" else "begun")
    assert watched.end(signal.SIGTERM) == (0 if program == "part.nc" else 1)


def framed(request: dict[str, object]) -> bytes:
    body = json.dumps(request).encode()
    return b"Content-Length: %d\r\n\r\n%b" % (len(body), body)


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("words", "number"),
    [(("dap",), signal.SIGTERM), (("dap", "--port", "0"), signal.SIGINT)],
    ids=["at a pipe", "at a port"],
)
def test_a_debugger_leaves_no_controller(
    start: Start, words: tuple[str, ...], number: signal.Signals
) -> None:
    """While a program runs: exit code 0, as where the client has gone."""
    debugger = start(*words, ignores=False)
    arguments: dict[str, object] = {"program": "endless.nc", "until": "24 h"}
    with contextlib.ExitStack() as files:
        if len(words) > 1:
            debugger.until("token")
            address, token, *_ = debugger.said.split("\n")
            arguments["token"] = token.split()[1]
            port = int(address.rpartition(":")[2])
            client = files.enter_context(socket.create_connection(("127.0.0.1", port)))
            to, said = client.makefile("wb"), client.makefile("rb")
        else:
            assert debugger.process.stdin is not None
            to, said = debugger.process.stdin, debugger.output
        for seq, command in enumerate(("initialize", "launch", "configurationDone"), 1):
            given = arguments if command == "launch" else {}
            request = {"seq": seq, "type": "request", "command": command, "arguments": given}
            to.write(framed(request))
            to.flush()
        while b"begun" not in said.read1(65536):
            pass
        assert debugger.end(number) == 0


@pytest.mark.parametrize(
    ("words", "number"),
    [(("lsp",), signal.SIGINT), (("lsp", "--tcp", "0"), signal.SIGTERM)],
    ids=["at a pipe", "at a port"],
)
def test_a_language_server_ends_though_its_editor_waits(
    start: Start, words: tuple[str, ...], number: signal.Signals
) -> None:
    """Exit code 0."""
    pytest.importorskip("pygls")
    server = start(*words, ignores=False)
    if len(words) > 1:
        server.until("token")
    else:
        assert server.process.stdin is not None
        server.process.stdin.write(
            framed({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": CAPABILITIES})
        )
        server.process.stdin.flush()
        server.until("Content-Length")
    assert server.end(number) == 0


def test_a_language_server_ends_as_its_editor_says(start: Start) -> None:
    """Exit code 0 and nothing more is said, though standard output is closed then."""
    pytest.importorskip("pygls")
    server = start("lsp", ignores=False)
    to = server.process.stdin
    assert to is not None
    to.write(framed({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": CAPABILITIES}))
    to.write(framed({"jsonrpc": "2.0", "id": 2, "method": "shutdown"}))
    to.write(framed({"jsonrpc": "2.0", "method": "exit"}))
    to.flush()
    said = server.output.read().decode()
    assert server.process.wait(60) == 0
    assert "Traceback" not in said


@pytest.mark.nightly
def test_the_page_keeps_its_tape(start: Start, tmp_path: Path) -> None:
    """What was lived through is written, as after Ctrl-C."""
    pytest.importorskip("nicegui")
    page = start("live", "part.nc", "--port", "0", "--dap", "0", "--record", "run.tape")
    page.until("http://")
    assert "dap token " in page.said
    assert page.end(signal.SIGTERM) == 0, page.said
    assert (tmp_path / "run.tape").stat().st_size > 0


def test_coverage_says_that_its_run_was_interrupted(start: Start, tmp_path: Path) -> None:
    """Its table counts only the ticks until then (902984); exit code 1."""
    own = "import os, signal\nclass P:\n  def cycle(self, hli):\n    if hli.tick == 10:\n"
    own += "      os.kill(os.getpid(), signal.SIGINT)\n"
    (tmp_path / "own.py").write_text(own, "utf-8")
    counting = start("coverage", *_LONG, "--plc", "own.py", ignores=False)
    said = counting.process.communicate(timeout=60)[0].decode()
    assert counting.process.returncode == 1, said
    assert "warning 902984: the run was interrupted after " in said


def test_a_page_that_does_not_exist_yet_ends_as_one_that_does(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Ctrl-C is the way to end it: exit code 0 while it still reads its inputs, too."""
    pytest.importorskip("nicegui")

    def interrupted(*_: object) -> NoReturn:
        raise KeyboardInterrupt

    monkeypatch.setattr("nctakt.cli.live.read_request", interrupted)
    (tmp_path / "part.nc").write_text("M30\n", "utf-8")
    assert main(["live", str(tmp_path / "part.nc"), "--port", "0"]) == 0
    assert capsys.readouterr().out == ""


@pytest.mark.nightly
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["Ctrl-C", "SIGTERM"])
@pytest.mark.parametrize("words", list(commands(group)), ids=" ".join)
def test_each_command_can_be_interrupted(
    start: Start, tmp_path: Path, words: list[str], number: signal.Signals
) -> None:
    """At any time: no traceback, no process left, no half file under a whole name."""
    for name in ("rtconf.lis", "load.toml"):
        shutil.copy(SOURCES.parent / "examples" / "schedule" / name, tmp_path)
    (tmp_path / "long.nc").write_text("G01 X1 F600\nX0\n" * 50_000 + "M30\n", "utf-8")
    (tmp_path / "log.csv").write_text("t,X\n" + "0.001,0\n" * 50_000, "utf-8")
    chance = random.Random(f"{words} {number}")
    started = start(*words, *BUSY[" ".join(words)], ignores=False)
    with contextlib.suppress(subprocess.TimeoutExpired):
        started.process.wait(chance.uniform(0.3, 4.0))
    code = started.end(number)
    # Python itself ends by SIGINT if the signal comes while it runs a text that it translates
    assert code in (0, 1, 2, -number, -signal.SIGINT), started.said
    assert not any(text in started.said for text in ("Traceback", "internal error"))
    for name, check in WHOLE.items():
        if (tmp_path / name).exists():
            check(tmp_path / name)


def test_outside_of_commands_signals_are_as_they_were() -> None:
    """And in another thread nothing is changed."""
    before = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
    count = interrupts.terminations()
    seen: list[int] = []
    with interrupts.handling(lambda number, _: seen.append(number)):
        signal.raise_signal(signal.SIGTERM)
        signal.raise_signal(signal.SIGINT)
    assert seen == [signal.SIGTERM, signal.SIGINT]
    assert interrupts.terminations() == count + 1
    assert [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)] == before


def test_ctrl_c_before_the_command_has_begun(tmp_path: Path) -> None:
    """It ends the process without a traceback: the shell shows 130."""
    (tmp_path / "click.py").write_text("import time\nprint('begun', flush=True)\ntime.sleep(60)\n")
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        process = subprocess.Popen(
            [sys.executable, "-P", "-m", "nctakt", "--version"],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env={**ENVIRONMENT, "PYTHONPATH": f"{tmp_path}{os.pathsep}{SOURCES}"},
        )
    finally:
        signal.signal(signal.SIGINT, before)
    assert process.stdout is not None
    assert process.stdout.readline() == b"begun\n"
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=60)[0] == b""
    assert process.returncode == -signal.SIGINT


def test_a_controller_whose_session_has_ended_says_nothing(tmp_path: Path) -> None:
    """The command was interrupted while its controller started: there is nothing to connect to."""
    done = subprocess.run(
        [sys.executable, "-P", "-m", "nctakt.session.process.worker", str(tmp_path / "gone"), "1"],
        input=bytes(32),
        capture_output=True,
        env={**ENVIRONMENT, "PYTHONPATH": str(SOURCES)},
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")

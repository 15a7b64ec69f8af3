# SPDX-License-Identifier: MIT
"""The process of which those of sessions are copies: what a copy has is as if it had just begun."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from support.insides import process_of

from nctakt import NcText, Session
from nctakt.base.python_process import python_environment
from nctakt.session.process.worker import can_fork

pytestmark = pytest.mark.skipif(not can_fork(), reason="processes cannot be copied here")

PROGRAM = NcText("part.nc", "G01 X10 F1000\nM30\n")

TELLING = """import os

from nctakt.plc import Plc, on


class Cell(Plc):
    @on("M10")
    def tell(self, hli, function):
        print(os.getcwd(), os.environ["CELL"], flush=True)
"""


def prototype_of(session: Session) -> int:
    """The process that a session's own is a copy of: its parent."""
    text = Path(f"/proc/{process_of(session)}/stat").read_text("utf-8")
    return int(text.rpartition(")")[2].split()[1])


def test_sessions_are_copies_of_one_process() -> None:
    """Each runs by itself, and that process is none of them."""
    with Session(PROGRAM) as one, Session(PROGRAM) as other:
        assert prototype_of(one) == prototype_of(other) != os.getpid()
        assert process_of(one) != process_of(other)
        one.step(5)
        assert (one.tick, other.tick) == (5, 0)


def test_a_copy_has_what_a_new_process_would_have(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """Working directory, environment and where it prints are those at the beginning of each."""
    plc = tmp_path / "cell.py"
    plc.write_text(TELLING, "utf-8")
    for name in ("first", "second"):
        folder = tmp_path / name
        folder.mkdir()
        monkeypatch.chdir(folder)
        monkeypatch.setenv("CELL", name)
        with Session(NcText("part.nc", "M10\nM30\n"), plc=str(plc)) as session:
            session.run()
        assert f"{folder} {name}\n" in capfd.readouterr().out


def test_what_python_reads_at_its_start_needs_another_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """PYTHONPATH: modules are found in the folders of now."""
    with Session(PROGRAM) as session:
        before = prototype_of(session)
    (tmp_path / "cell_tools.py").write_text("WIDTH = 3\n", "utf-8")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    plc = tmp_path / "cell.py"
    plc.write_text(f"import cell_tools\n{TELLING}", "utf-8")
    with Session(PROGRAM, plc=str(plc)) as session:
        assert prototype_of(session) != before


def test_one_that_was_killed_is_replaced() -> None:
    """A session that is open goes on, the next one begins."""
    with Session(PROGRAM) as one:
        before = prototype_of(one)
        os.kill(before, signal.SIGKILL)
        with Session(PROGRAM) as other:
            assert prototype_of(other) != before
            other.step(3)
        one.step(3)
        assert one.tick == 3


FORKING = """import os
from nctakt import NcText, Session

program = NcText("part.nc", "G01 X10 F1000\\nM30\\n")
with Session(program) as session:
    session.step(2)
child = os.fork()
with Session(program) as session:
    session.step(4)
    print(session.tick, flush=True)
if child:
    assert os.waitpid(child, 0)[1] == 0
"""


def test_a_copy_of_this_process_has_its_own(tmp_path: Path) -> None:
    """Neither takes the other's answers, and nothing stays."""
    script = tmp_path / "forking.py"
    script.write_text(FORKING, "utf-8")
    done = subprocess.run(
        [sys.executable, str(script)],
        env=python_environment(),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert (done.returncode, done.stdout.split()) == (0, ["4", "4"]), done.stderr

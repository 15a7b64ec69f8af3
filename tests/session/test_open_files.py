# SPDX-License-Identifier: MIT
"""What a PLC holds open: read files keep a place for each copy, others are refused by name."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from nctakt import NcText
from nctakt.base.failure import Failure
from nctakt.session.core import SessionCore
from nctakt.session.process.worker import can_fork, check_open_files, open_again
from nctakt.session.setup import Setup

pytestmark = pytest.mark.skipif(not can_fork(), reason="a controller cannot be copied here")

READING = """\
from pathlib import Path
from nctakt import Plc

class Cell(Plc):
    def __init__(self):
        self.file = Path(__file__).with_name("rates.txt").open(buffering=1)
        self.calls = 0

    def cycle(self, hli):
        self.calls += 1
        if self.calls % 20 == 0:
            hli.override_pct = int(self.file.read(3))
"""

WRITING = """\
from pathlib import Path
from nctakt import Plc

class Cell(Plc):
    def __init__(self):
        self.calls = 0

    def cycle(self, hli):
        self.calls += 1
        if self.calls == 30:
            self.file = Path(__file__).with_name("log.txt").open("w")
"""

REGISTERED = """\
import atexit, os
from pathlib import Path
from nctakt import Plc

MARK = Path(__file__).with_name("ends")

def end():
    MARK.mkdir(exist_ok=True)
    (MARK / str(os.getpid())).touch()

class Cell(Plc):
    def __init__(self):
        atexit.register(end)

    def cycle(self, hli):
        if hli.override_pct == 100:
            hli.override_pct = 90
"""


def opened(folder: Path, text: str) -> SessionCore:
    """A session with a PLC."""
    plc = folder / "cell.py"
    plc.write_text(text, "utf-8")
    return SessionCore(Setup({1: [NcText("p.nc", "G01 X100 F6000\nM30")]}, plc=plc))


def test_a_copy_goes_on_at_its_own_place_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "rates.txt").write_text("".join(f"{20 + 3 * k:3}" for k in range(60)), "utf-8")
    own = opened(tmp_path, READING)
    try:
        seen = []
        for _ in range(12):
            own.step(20)
            seen.append(own.read(["V.RTA.ACS.ACT_POS.X"]))
        for number in (2, 9, 5, 11):
            done = own.go_to(20 * (number + 1))
            assert own.read(["V.RTA.ACS.ACT_POS.X"]) == seen[number]
            assert done.differs is None
    finally:
        own.close()


def test_what_a_plc_writes_is_refused_by_name(tmp_path: Path) -> None:
    """Forward the session goes on; before anything went wrong it says why it cannot go back."""
    own = opened(tmp_path, WRITING)
    try:
        own.step(100)
        with pytest.raises(Failure) as failed:
            own.go_to(50)
        assert failed.value.diagnostics[0].id == 902060
        assert str(tmp_path / "log.txt") in str(failed.value)
        own.step(10)
        assert own.tick == 110
    finally:
        own.close()


def test_files_are_opened_again_where_they_were(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"0123456789")
    own = {int(path.name) for path in Path("/proc/self/fd").iterdir()}
    with (tmp_path / "a").open("rb", buffering=0) as file:
        file.read(4)
        (shared,) = check_open_files(own - {file.fileno()})
        before = os.dup(shared)
        open_again([shared])
        os.lseek(before, 0, os.SEEK_SET)
        assert file.read(2) == b"45"
        os.close(before)
    reader, writer = os.pipe()
    with pytest.raises(Failure, match="pipe"):
        check_open_files(own - {reader, writer})
    os.close(reader)
    os.close(writer)


def test_what_a_plc_has_registered_for_its_end_runs_once(tmp_path: Path) -> None:
    """It belongs to the PLC, not to each copy of its controller that a session has given up."""
    own = opened(tmp_path, REGISTERED)
    first = own.timeline.live.process
    try:
        own.step(60)
        for tick in (40, 20, 50, 10):
            own.go_to(tick)
        assert own.timeline.live.process != first
    finally:
        own.close()
    assert [one.name for one in (tmp_path / "ends").iterdir()] == [str(first)]

# SPDX-License-Identifier: MIT
"""Standard output and standard error that take nothing: never an error of nctakt's own."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

PART = '#MSG ["hello"]\n#RT CYCLE\nV.E.VALUE = 1\n#RT CYCLE END\nG00 X1\nM30\n'
WRONG = "QQQ\nM30\n"
FULL = Path("/dev/full")

COMMANDS = (
    "--version",
    "--help",
    "run --help",
    "run part.nc",
    "run part.nc --quiet",
    "check part.nc",
    "check part.nc --format json",
    "list part.nc",
    "why part.nc",
    "coverage part.nc",
    "explain G01",
    "new folder",
    "schedule show rtconf.lis",
    "schedule simulate rtconf.lis --load load.toml --cycles 2",
    "schedule analyse rtconf.lis --load load.toml --cycles 2",
)
STARVED = Path(__file__).parent.parent / "runs" / "rtconf_starved_decoder"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a program, a wrong one, a list and a load."""
    (tmp_path / "part.nc").write_text(PART, "utf-8")
    (tmp_path / "wrong.nc").write_text(WRONG, "utf-8")
    for name in ("rtconf.lis", "load.toml"):
        (tmp_path / name).write_bytes((STARVED / name).read_bytes())
    return tmp_path


def shell(folder: Path, command: str) -> subprocess.CompletedProcess[bytes]:
    """Run a command line of nctakt, followed by redirections of the shell."""
    line = f"{sys.executable} -m nctakt {command}"
    return subprocess.run(["sh", "-c", line], cwd=folder, capture_output=True, check=False)


@pytest.mark.nightly
@pytest.mark.skipif(not FULL.exists(), reason="a device of Linux")
@pytest.mark.parametrize("command", COMMANDS)
def test_a_full_standard_output_is_reported(folder: Path, command: str) -> None:
    """900507 and exit code 2 where there was something to show; no traceback."""
    done = shell(folder, f"{command} > /dev/full")
    assert b"Traceback" not in done.stderr
    assert b"internal error" not in done.stderr
    shows_nothing = command == "run part.nc --quiet" and done.returncode == 0
    assert shows_nothing or (b"900507" in done.stderr and done.returncode == 2)


@pytest.mark.nightly
@pytest.mark.parametrize("command", ["--version", "run part.nc", "check part.nc", COMMANDS[-2]])
@pytest.mark.parametrize("streams", [">&-", "2>&-", "<&- >&- 2>&-"])
def test_closed_streams_change_nothing_else(folder: Path, command: str, streams: str) -> None:
    """Nobody listens, and the exit code is what it is."""
    done = shell(folder, f"{command} {streams}")
    assert b"Traceback" not in done.stderr
    assert done.returncode == 0


@pytest.mark.nightly
@pytest.mark.parametrize("streams", ["2>&-", "2>/dev/full", ">/dev/full 2>/dev/full"])
def test_errors_that_nobody_can_be_reported_keep_their_exit_code(
    folder: Path, streams: str
) -> None:
    """1 for a program with mistakes, 2 for words that cannot be used, or a full output."""
    if "full" in streams and not FULL.exists():
        pytest.skip("a device of Linux")
    code = 2 if streams.startswith(">") else 1
    assert shell(folder, f"run wrong.nc {streams}").returncode == code
    assert shell(folder, f"run missing.nc {streams}").returncode == 2
    assert shell(folder, f"run --nonsense {streams}").returncode == 2


def test_a_file_does_not_get_the_number_of_a_closed_stream(folder: Path) -> None:
    """What goes to standard output is in no file of results."""
    done = shell(folder, "run part.nc --trace out.csv --messages out.txt <&- >&-")
    assert done.returncode == 0
    assert (folder / "out.csv").read_text("utf-8").startswith("tick,")
    assert (folder / "out.txt").read_text("utf-8").count("\n") == 1


def test_a_trace_is_kept_when_standard_output_fails(folder: Path) -> None:
    """The run ends at the message that cannot be shown."""
    if not FULL.exists():
        pytest.skip("a device of Linux")
    assert shell(folder, "run part.nc --trace out.csv > /dev/full").returncode == 2
    assert (folder / "out.csv").exists()

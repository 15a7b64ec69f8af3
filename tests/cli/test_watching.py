# SPDX-License-Identifier: MIT
"""``--watch``: again at each change of a file that the command reads."""

from __future__ import annotations

import builtins
import os
import re
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest

import nctakt
from nctakt.cli import main
from nctakt.files.access import FileAccess

pytestmark = pytest.mark.slow

SOURCES = Path(nctakt.__file__).parent.parent


class Watched:
    """A command in its own process; what it says is read line by line."""

    def __init__(self, folder: Path, *words: str) -> None:
        kept = {name: value for name, value in os.environ.items() if name != "NCTAKT_MACHINE"}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "nctakt", *words, "--watch"],
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            env={**kept, "PYTHONPATH": str(SOURCES), "PYTHONUNBUFFERED": "1"},
        )

    def until_it_waits(self) -> str:
        """What it says up to the line that it waits (901069)."""
        assert self.process.stdout is not None
        said = ""
        timer = threading.Timer(60, self.process.kill)
        timer.start()
        for line in self.process.stdout:
            said += line
            if "901069" in line:
                timer.cancel()
                return said
        raise AssertionError(said)

    def close(self) -> None:
        """End it for sure."""
        self.process.kill()
        self.process.communicate()

    def end(self) -> int:
        """Ctrl-C; the exit code."""
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(60)


@pytest.mark.skipif(os.name != "posix", reason="Ctrl-C is sent as a signal")
def test_a_check_is_repeated_at_each_change(tmp_path: Path) -> None:
    """A mistake comes and goes; the exit code is that of the last time."""
    pytest.importorskip("watchfiles")
    program = tmp_path / "a.nc"
    program.write_text("G01 X10 F1000\nM30\n", "utf-8")
    watched = Watched(tmp_path, "check", ".")
    try:
        assert "1 file: 0 errors" in watched.until_it_waits()
        program.write_text("G01 Q10 F1000\nM30\n", "utf-8")
        assert "a.nc:1:5: error 20797" in watched.until_it_waits()
        (tmp_path / "b.nc").write_text("G01 X10 F1000\nM30\n", "utf-8")
        assert "2 files: 1 error" in watched.until_it_waits()
        assert watched.end() == 1
    finally:
        watched.close()


@pytest.mark.skipif(os.name != "posix", reason="Ctrl-C is sent as a signal")
def test_a_run_is_repeated_with_a_new_plc(tmp_path: Path) -> None:
    """Also when only a module changes that the PLC imports; the trace it writes is no change."""
    pytest.importorskip("watchfiles")
    (tmp_path / "a.nc").write_text(
        '#MSG ["%d", V.E.VALUE]\nG04 0.01\n#MSG ["%d", V.E.VALUE]\nM30\n'
    )
    (tmp_path / "step.py").write_text("VALUE = 5\n", "utf-8")
    (tmp_path / "plc.py").write_text(
        "from step import VALUE\nclass P:\n  def cycle(self, hli):\n"
        "    hli.write('V.E.VALUE', VALUE)\n",
        "utf-8",
    )
    watched = Watched(tmp_path, "run", "a.nc", "--plc", "plc.py", "--trace", "out.csv")
    try:
        assert "  5\n" in watched.until_it_waits()
        (tmp_path / "step.py").write_text("VALUE = 57  # longer\n", "utf-8")
        assert "  57\n" in watched.until_it_waits()
        assert watched.end() == 0
    finally:
        watched.close()


@pytest.mark.skipif(os.name != "posix", reason="Ctrl-C is sent as a signal")
def test_a_run_begins_anew_with_a_saved_text_and_what_was_retained(tmp_path: Path) -> None:
    """ST-406: the next run goes on from the retained number, and writing it is no change.

    A run of 0.1 s has 11 cycles of 10 ms, at 0 … 0.1 s; then each counts by ten.
    """
    pytest.importorskip("watchfiles")
    (tmp_path / "a.nc").write_text("G04 0.1\nM30\n", "utf-8")
    text = (
        "PROGRAM MAIN\nVAR RETAIN\n    nCount : DINT;\nEND_VAR\n"
        "nCount := nCount + 1;\nEND_PROGRAM\n"
    )
    plc, kept = tmp_path / "cell.st", tmp_path / "kept.json"
    plc.write_text(text, "utf-8")
    words = ("run", "a.nc", "--plc", "cell.st", "--retain", "kept.json", "--until", "0.1s")
    watched = Watched(tmp_path, *words)

    def count() -> int:
        return int(re.findall(r"nCount\D+(\d+)", kept.read_text("utf-8"))[0])

    try:
        watched.until_it_waits()
        first = count()
        plc.write_text(text.replace("+ 1", "+ 10"), "utf-8")
        watched.until_it_waits()
        assert count() == first + 10 * first
        plc.write_text(text.replace("nCount + 1", "nCuont + 1"), "utf-8")
        assert "nCuont is not declared" in watched.until_it_waits()
        assert count() == 11 * first
        assert watched.end() == 2
    finally:
        watched.close()


def test_without_the_library(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """901067 with the command that installs it."""
    monkeypatch.chdir(tmp_path)
    real = builtins.__import__

    def refuse(name: str, *rest: object, **named: object) -> object:
        if name == "watchfiles":
            raise ImportError(name)
        return real(name, *rest, **named)  # type: ignore[arg-type]

    monkeypatch.setattr(builtins, "__import__", refuse)
    assert main(["check", ".", "--watch"]) == 2
    reported = capsys.readouterr().err
    assert "error 901067: " in reported
    assert 'pip install "watchfiles>=0.21"' in reported


def test_standard_input_cannot_be_watched(capsys: pytest.CaptureFixture[str]) -> None:
    """901068."""
    pytest.importorskip("watchfiles")
    assert main(["run", "-", "--watch"]) == 2
    assert "error 901068: " in capsys.readouterr().err


def test_files_know_whether_they_have_changed(tmp_path: Path) -> None:
    """By time, size and inode; one that is gone has changed."""
    file = tmp_path / "a.nc"
    file.write_text("M30\n", "utf-8")
    access = FileAccess()
    access.read_bytes(file)
    assert access.read_files == [file]
    assert not access.has_changed()
    file.write_text("G00 X1\nM30\n", "utf-8")
    assert access.has_changed()
    file.unlink()
    assert access.has_changed()

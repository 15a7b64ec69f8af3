# SPDX-License-Identifier: MIT
"""``nctakt time`` as a user meets it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from nctakt.cli import main


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The command runs in its own folder, where part.nc is."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "part.nc").write_text("G01 X100 F6000\nM30\n", encoding="utf-8")
    return tmp_path


def test_tables_and_files(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """100 mm at 100 mm/s and 4000 mm/s²: 975 ticks at F, 25 up, 25 down, one for M30."""
    assert main(["time", "part.nc", "--csv", "a.csv", "--flame", "a.json"]) == 0
    text = capsys.readouterr().out
    assert "part.nc: ended, 1026 ticks = 1.026000 s" in text
    assert "acceleration of axis X 0.025 s 2.4 %" in " ".join(text.split())
    assert "1: G01 X100 F6000  1.025 s  99.9 %   F" in text
    assert (folder / "a.csv").read_text("utf-8").count("\n") == 5
    assert json.loads((folder / "a.json").read_text("utf-8"))["profiles"][0]["endValue"] == 1026000


@pytest.mark.slow
def test_picture(folder: Path) -> None:
    """The same run gives the same bytes."""
    assert main(["time", "part.nc", "--plot", "a.svg"]) == 0
    assert main(["time", "part.nc", "--plot", "b.svg"]) == 0
    assert (folder / "a.svg").read_bytes() == (folder / "b.svg").read_bytes()
    assert "<svg" in (folder / "a.svg").read_text("utf-8")


def test_doubled_limits(capsys: pytest.CaptureFixture[str]) -> None:
    """With 8000 mm/s² it takes 1.0125 s, with 200 mm/s 0.55 s; then a tick for M30."""
    assert main(["time", "part.nc", "--what-if", "--lang", "de"]) == 0
    text = capsys.readouterr().out
    assert "Beschleunigung von X     1.014 s  0.012 s  beendet" in text
    assert "alle F (Override 200 %)  0.551 s  0.475 s  beendet" in text
    names = text.splitlines()[-1].removeprefix("ohne Wirkung: ").split(", ")
    assert "Beschleunigung von Y" in names
    assert "Beschleunigung von X" not in names


def test_document(capsys: pytest.CaptureFixture[str]) -> None:
    """``--format json`` has all purposes with their times."""
    assert main(["time", "part.nc", "--format", "json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert sum(one["time_us"] for one in document["times"]) == document["time_us"] == 1026000


def test_picture_needs_a_known_suffix(capsys: pytest.CaptureFixture[str]) -> None:
    """Another suffix is refused before the run (901090)."""
    assert main(["time", "part.nc", "--plot", "a.html"]) == 2
    assert "error 901090" in capsys.readouterr().err

# SPDX-License-Identifier: MIT
"""An FMU in its own process: the same run, and a crash or a hang ends the run only."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import Any

import pytest
from support.small_fmus import build_library, description, write_fmu

from nctakt.cli import main
from nctakt.fmu import Fmu, FmuError
from nctakt.run.controller import Controller, NcText

PROGRAM = "G01 X20 F6000\nM30\n"
SIGNALS = ["X.ACS.ACT_POS", "V.E.VALUE", "V.E.COUNT", "V.E.FLAG"]
TIES: dict[str, Any] = {
    "inputs": {"u": "X.ACS.ACT_POS"},
    "outputs": {"y": "V.E.VALUE", "n": "V.E.COUNT", "above.ten": "V.E.FLAG"},
}

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the model raises a Unix signal")


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The library for FMI 3.0."""
    return build_library(3, tmp_path_factory.mktemp("library"))


@pytest.fixture
def plant(library: Path, tmp_path: Path) -> Path:
    """The FMU."""
    return write_fmu(tmp_path / "plant.fmu", description(3), library)


def run_with(fmu: Fmu) -> Any:
    return Controller().run(NcText("part.nc", PROGRAM), fmu=fmu, signals=SIGNALS)


def test_a_run_is_the_same(plant: Path) -> None:
    """All values of all ticks, of numbers, whole numbers and truths; each run restarts."""
    isolated = Fmu(plant, isolate=True, start={"gain": 1000.0}, **TIES)
    beside = run_with(Fmu(plant, start={"gain": 1000.0}, **TIES))
    for _ in range(2):
        assert run_with(isolated).trace == beside.trace


@pytest.mark.parametrize(
    ("fault", "text"),
    [
        (1, r"902609.*DoStep failed at 0\.003 s of the run: status 3 \(error\).*spring is broken"),
        (2, r"902610.*at 0\.003 s"),
        (3, r"902731.*ended its process at 0\.003 s of the run, in a step: SIGSEGV"),
        (4, r"902732.*not returned for 2 s at 0\.003 s of the run, in a step"),
    ],
)
def test_its_end_is_reported(plant: Path, fault: int, text: str) -> None:
    """The model's own words, its signal, or how long it has not returned: a third run is whole."""
    before = time.monotonic()
    with pytest.raises(FmuError, match=text):
        run_with(Fmu(plant, isolate=True, limit="2 s", start={"fault": fault}, **TIES))
    assert time.monotonic() - before < 25.0, "the model sleeps for 30 s"
    assert run_with(Fmu(plant, isolate=True, **TIES)).state == "ended"


def test_a_late_step_is_reported_without_a_process(
    plant: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """902733 on the error output, while the model has not returned; the run continues."""
    run = run_with(Fmu(plant, limit="1 s", start={"fault": 5}, **TIES))
    assert run.state == "ended"
    said = capsys.readouterr().err
    assert "warning 902733" in said
    assert "from fmi3DoStep for 1 s, at 0.003 s of the run" in said


def test_the_command_line_and_the_project_isolate(
    plant: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """``--isolate`` and ``[fmu] isolate``, each by itself; without an FMU it is refused."""
    monkeypatch.chdir(plant.parent)
    Path("a.nc").write_text(PROGRAM, "utf-8")
    assert main(["run", "a.nc", "--isolate"]) == 2
    assert "902734" in capsys.readouterr().err
    ties = '[fmu]\nfile = "plant.fmu"\ninputs = {u = "X.ACS.ACT_POS"}\nstart = {fault = 3}\n'
    Path("nctakt.toml").write_text(ties, "utf-8")
    assert main(["run", "a.nc", "--isolate", "--quiet"]) == 1
    assert "902731" in capsys.readouterr().err
    Path("nctakt.toml").write_text(f"{ties}isolate = true\n", "utf-8")
    assert main(["run", "a.nc", "--quiet"]) == 1
    assert "902731" in capsys.readouterr().err
    Path("nctakt.toml").write_text(f"{ties}isolate = 1\nlimit = 0\n", "utf-8")
    assert main(["run", "a.nc", "--quiet"]) == 2
    assert capsys.readouterr().err.count("error 901062") == 2

# SPDX-License-Identifier: MIT
"""Each violation comes with a command that shows it: it is run, and the same value is there."""

from __future__ import annotations

import csv
import re
import shlex
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.session.tapes import read_setup
from nctakt.studies.study import Study

Captured = pytest.CaptureFixture[str]

PROGRAM = "V.P.WAY = 10\nM8\nG01 X[V.P.WAY] F6000\nM30\n"
RTCONF = """\
interrupt_source 2 # timer
cycle_time 1000
time_slice 250
windows_time 0
thread[0].name GEO
thread[0].cycle 1000
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[1].name BACKGROUND
thread[1].cycle 1000
thread[1].priority 105
thread[1].function[0].name task_rnd
End
"""
VARIED: list[dict[str, Any]] = [
    {"variable": "V.E.VALUE", "values": [0, 5]},
    {"variable": "HLI.OVERRIDE", "values": [100], "rest": 50, "over": "20 ms"},
    {"noise": "HLI.OVERRIDE", "values": [7], "rest": 60, "amount": 30, "for": "20 ms"},
    {"acknowledge": "M8", "values": ["35 ms", "never", "twice"]},
    {"plc_dies": "yes", "values": ["0 ms"]},
    {"parameter": "P-AXIS-00008 of X", "values": [900, 1700]},
    {"program_variable": "V.P.WAY", "values": [7]},
    {"load_entry": "controller.block", "values": [20_000]},
    {"parameter": "P-RTCF-00013 of BACKGROUND", "values": [1]},
]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a program and a schedule."""
    (tmp_path / "part.nc").write_text(PROGRAM)
    (tmp_path / "rtconf.lis").write_text(RTCONF)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("vary", VARIED, ids=str)
def test_a_broken_run_is_shown_by_its_command(vary: dict[str, Any], capsys: Captured) -> None:
    """``nctakt run`` or a replay ends where the study has measured it, at the same tick."""
    is_scheduled = "load_entry" in vary or "P-RTCF" in str(vary)
    study = Study(
        program="part.nc",
        until="400 ms",
        vary=[vary],
        measure={"way": "X at end", "ticks_of_run": "ticks"},
        expect=["way < 0"],
        **({"rtconf": "rtconf.lis"} if is_scheduled else {}),
    )
    for row in study.run().rows:
        assert row["verdict"] == "failed"
        number = int(row["run"] or 0)
        commands = {study.command(number), study.record(number, f"tapes/{number}.tape")} - {None}
        for command in commands:
            words = shlex.split(str(command))
            assert words[0] == "nctakt"
            assert main([*words[1:], "--trace", "trace.csv", "--signals", "X.ACS.ACT_POS"]) == 0
            with Path("trace.csv").open() as file:
                rows = [one for one in csv.reader(file) if one and one[0].isdigit()]
            assert float(rows[-1][2]) == pytest.approx(row["way"])
            assert len(rows) == row["ticks_of_run"]
    capsys.readouterr()


def test_tapes_of_broken_runs(folder: Path, capsys: Captured) -> None:
    """``--record`` writes them and names the replays; without it the study's own words do."""
    (folder / "plan.toml").write_text(
        'program = "part.nc"\nuntil = "400 ms"\nexpect = ["X at end > 5"]\n'
        '[[vary]]\nprogram_variable = "V.P.WAY"\nvalues = [2, 8]\n'
    )
    assert main(["study", "plan.toml", "--quiet"]) == 1
    command = capsys.readouterr().out.splitlines()[-1].strip()
    assert command == "nctakt study plan.toml --only 0 --record tapes"
    assert main([*shlex.split(command)[1:], "--quiet"]) == 1
    command = capsys.readouterr().out.splitlines()[-1].strip()
    assert command == f"nctakt replay {Path('tapes/run-0.tape')} --root ."
    assert main(shlex.split(command)[1:]) == 0


def test_list_and_load_of_a_broken_schedule(folder: Path, capsys: Captured) -> None:
    """The simulation of the written list has the same response."""
    (folder / "plan.toml").write_text(
        'rtconf = "rtconf.lis"\nuntil = "20 ms"\nexpect = ["overflows < 1"]\n'
        '[[vary]]\nload_entry = "functions.task_rnd"\nvalues = [710]\n'
        '[[vary]]\nparameter = "P-RTCF-00003"\nvalues = [200]\n'
    )
    assert main(["study", "plan.toml", "--quiet", "--record", "tapes"]) == 1
    command = capsys.readouterr().out.splitlines()[-1].strip()
    assert "tapes" in command
    main(shlex.split(command)[1:])
    shown = capsys.readouterr().out
    assert "time_slice 200" in Path("tapes/run-0.lis").read_text()
    assert re.search(r"BACKGROUND .* 1310 .* 10 ", shown)  # overflows: each second activation


def test_a_session_refuses_a_tape_with_other_parameters(capsys: Captured) -> None:
    """Only a replay has the lists of such a tape."""
    vary = {"parameter": "P-AXIS-00008 of X", "values": [900]}
    study = Study(program="part.nc", until="400 ms", vary=[vary])
    study.record(0, "run.tape")
    with pytest.raises(Failure) as raised:
        read_setup("run.tape", anyway=False)
    assert raised.value.diagnostics[0].id == 901392

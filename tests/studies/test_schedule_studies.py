# SPDX-License-Identifier: MIT
"""Studies of a scheduling list, with answers that are worked out by hand.

GEO takes 400 µs of each cycle of 2000 µs and is the more urgent one, BACKGROUND takes what the load
says. Nothing is guaranteed to Windows, so BACKGROUND ends at 400 µs plus its own time, and its
first overflow comes with 1601 µs: a job that ends with the next interrupt has none.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.studies.study import Study

RTCONF = """\
interrupt_source 2 # timer
cycle_time 2000
time_slice 500
windows_time 0
thread[0].name GEO
thread[0].cycle 2000
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[1].name BACKGROUND
thread[1].cycle 2000
thread[1].priority 105
thread[1].function[0].name task_rnd
End
"""
LOAD = "[functions]\ntask_int = 400\ntask_rnd = 500\n"
TIME: dict[str, Any] = {"load_entry": "functions.task_rnd", "name": "time"}
MICROSECONDS = {"from": 1500, "to": 1700, "step": 1}


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a list and a load."""
    (tmp_path / "rtconf.lis").write_text(RTCONF)
    (tmp_path / "load.toml").write_text(LOAD)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def study(vary: dict[str, Any], **entries: Any) -> Study:
    """A study of the list."""
    given = {
        "rtconf": "rtconf.lis",
        "load": "load.toml",
        "until": "20 ms",
        "measure": {"slack": "slack of BACKGROUND"},
        "expect": ["overflows < 1"],
        **entries,
    }
    return Study(vary=[vary], **given)


def test_a_grid_finds_the_first_overflow() -> None:
    """Each microsecond from 1500 to 1700."""
    done = study(TIME | MICROSECONDS).run()
    assert done.broken[0]["time"] == 1601
    assert [row["slack"] for row in done.rows[:101]] == [
        pytest.approx((100 - i) / 1e6) for i in range(101)
    ]


def test_bisecting_finds_it() -> None:
    """Both neighbours, in a few simulations."""
    (answer,) = study(TIME | MICROSECONDS, find={"boundary": "time"}).find()
    assert [row["time"] for row in answer.rows] == [1600, 1601]
    assert answer.runs <= 11


def test_a_search_finds_the_least_slack() -> None:
    """The longest time that is tried leaves the least."""
    pytest.importorskip("optuna")
    plan = study(TIME | {"from": 0, "to": 1600}, find={"minimize": "slack", "budget": 30})
    (answer,) = plan.find()
    row = answer.rows[0]
    assert float(row["slack"] or 0) == pytest.approx(
        (1600 - float(row["time"] or 0)) / 1e6, abs=1e-9
    )
    assert float(row["time"] or 0) > 1400


def test_processes_make_the_same_rows() -> None:
    """Rows do not depend on who makes them."""
    plan = study(TIME | {"from": 100, "to": 1700, "step": 100})
    assert plan.run().rows == plan.run(processes=2).rows


@pytest.mark.parametrize(
    ("vary", "slack"),
    [
        ({"parameter": "P-RTCF-00010 of BACKGROUND", "values": [105, 116]}, [1100, 1500]),
        ({"parameter": "P-RTCF-00015 of BACKGROUND", "values": [1, 2]}, [1100, 1500]),
        ({"parameter": "P-RTCF-00013 of BACKGROUND", "values": [1, 2]}, [1100, 600]),
        ({"parameter": "P-RTCF-00002", "values": [2000, 3000]}, [1100, 2100]),
        ({"load_entry": "overheads.activation", "values": [0, 10]}, [1100, 1080]),
        ({"load": "file", "values": ["load.toml", "longer.toml"]}, [1100, 1000]),
        ({"rtconf": "file", "values": ["rtconf.lis", "other.lis"]}, [1100, 1500]),
    ],
)
def test_what_can_be_varied(folder: Path, vary: dict[str, Any], slack: list[int]) -> None:
    """Priorities, processors, calls, cycles, costs of scheduling, whole files."""
    (folder / "longer.toml").write_text(LOAD.replace("500", "600"))
    (folder / "other.lis").write_text(RTCONF.replace("priority 105", "priority 116"))
    if "P-RTCF-00002" in vary.values():
        (folder / "rtconf.lis").write_text(RTCONF.replace("cycle 2000", "cycle 3000"))
        slack = [4000 - 900, 3000 - 900]
    found = study(vary).run().column("slack")
    assert found == [pytest.approx(one / 1e6) for one in slack]


def test_each_phase_of_an_interrupt_from_outside(folder: Path) -> None:
    """One simulation for each microsecond between two timer interrupts."""
    text = RTCONF.replace("2 # timer", "1 # 1: hardware").replace("time 0", "time 500")
    (folder / "rtconf.lis").write_text(text)
    plan = study({"load_entry": "interrupt.phase", "each_phase": True, "name": "phase"})
    assert len(plan) == 500
    numbers = [0, 1, 499]
    assert plan.run(numbers=numbers).column("phase") == numbers


@pytest.mark.parametrize(
    ("vary", "entries", "message"),
    [
        ({"load_entry": "functions.task_rdn"}, {}, 900621),
        ({"load_entry": "interrupt.drift"}, {}, 900627),
        ({"load_entry": "interupt.phase"}, {}, 900624),
        ({"parameter": "P-RTCF-00010 of BACKGRUND"}, {}, 901312),
        ({"parameter": "P-RTCF-00099 of GEO"}, {}, 901312),
        ({"variable": "V.E.VALUE"}, {}, 901302),
        (TIME, {"measure": {"a": "slack of BACKGRUND"}}, 901391),
        (TIME, {"measure": {"a": "max X"}}, 901306),
        (TIME, {"expect": ["M100 once"]}, 901307),
        (TIME, {"plc": "load.toml"}, 901302),
    ],
)
def test_unknown_names_are_reported(
    vary: dict[str, Any], entries: dict[str, Any], message: int
) -> None:
    """Before anything is simulated."""
    with pytest.raises(Failure) as raised:
        study(vary | {"values": [1]}, **entries).run()
    assert message in [one.id for one in raised.value.diagnostics]


def test_the_command(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Results and report as of a program; an overflow that is an error breaks a run."""
    (folder / "plan.toml").write_text(
        'rtconf = "rtconf.lis"\nuntil = "20 ms"\n'
        '[[vary]]\nload_entry = "functions.task_int"\nvalues = [400, 2500]\n'
    )
    words = ["study", "plan.toml", "--out", "rows.csv", "--report", "page.html", "--quiet"]
    assert main(words) == 1
    assert "1 passed, 1 failed" in capsys.readouterr().out
    assert "error 900630" in (folder / "rows.csv").read_text()
    assert main(["study", "report", "plan.toml", "rows.csv"]) == 0


def test_a_program_under_a_schedule_that_varies(folder: Path) -> None:
    """The decoder gets less time, so that the program takes longer."""
    (folder / "part.nc").write_text("G01 X1 F6000\nX2\nX3\nX4\nM30\n")
    plan = Study(
        program="part.nc",
        rtconf="rtconf.lis",
        load="load.toml",
        vary=[{"load_entry": "controller.block", "values": [100, 50_000]}],
        measure={"time": "duration"},
    )
    short, long = plan.run().column("time")
    assert long > short + 0.1


def test_the_schedule_of_a_program_is_measured(folder: Path) -> None:
    """Responses and slack as in a simulation of the list, beside the words of programs."""
    (folder / "part.nc").write_text("G01 X1 F6000\nX2\nX3\nX4\nM30\n")
    entries: dict[str, Any] = {
        "rtconf": "rtconf.lis",
        "load": "load.toml",
        "vary": [{"load_entry": "functions.task_rnd", "values": [100, 300]}],
        "measure": {
            "slack": "slack of GEO",
            "longest": "max response of GEO",
            "late": "overflows of GEO",
        },
    }
    measured = Study(
        program="part.nc",
        **{**entries, "measure": {**entries["measure"], "end": "X at end", "time": "duration"}},
        expect=["slack > 0", "ended"],
    ).run()
    simulated = Study(**entries).run()
    assert measured.column("end") == [4.0, 4.0]
    for name in ("slack", "longest", "late"):
        assert measured.column(name) == simulated.column(name)
    with pytest.raises(Failure) as raised:
        Study(program="part.nc", **{**entries, "measure": {"slack": "slack of GEOM"}}).run()
    assert raised.value.diagnostics[0].id == 901391

# SPDX-License-Identifier: MIT
"""``nctakt schedule suggest``: what it finds has the slacks that were asked for."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.schedule_examples import (
    EXAMPLE_1,
    TABLE,
    TIGHT,
    change,
    configure,
    load_text,
    with_line,
)

from nctakt.cli import main
from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES
from nctakt.messages import Collector
from nctakt.schedule.analysis.self_check import contradictions
from nctakt.schedule.analysis.suggest import VARIABLES, Slacks, Suggestions, suggest
from nctakt.schedule.assemble import assemble
from nctakt.schedule.load import read_load
from nctakt.schedule.model import Model
from nctakt.schedule.simulation.simulate import hyperperiod, simulate

Capture = pytest.CaptureFixture[str]
NOMINAL = TIGHT | {"task_int": 300, "task_rnd": 600, "task_mmi_driver": 200, "task_com": 200}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The list of S1 and its load: COM overflows."""
    (tmp_path / "rtconf.lis").write_text(EXAMPLE_1, "utf-8")
    (tmp_path / "load.toml").write_text(load_text(TIGHT), "utf-8")
    return tmp_path


def run(folder: Path, *words: str, name: str = "rtconf.lis") -> int:
    """The exit code of the command."""
    files = [str(folder / name), "--load", str(folder / "load.toml")]
    return main(["schedule", "suggest", *files, "--convention", "table", "--quiet", *words])


def found(folder: Path, capsys: Capture, *words: str) -> list[dict[str, str]]:
    """What each suggestion changes, by parameter."""
    capsys.readouterr()
    run(folder, *words, "--format", "json")
    document = json.loads(capsys.readouterr().out)
    return [
        {one["name"]: one["suggested"] for one in suggestion["changes"]}
        for suggestion in document["suggestions"]
    ]


def test_suggestions_for_s1(folder: Path, capsys: Capture) -> None:
    """Few changes first; what takes Windows its guarantee comes last."""
    assert run(folder) == 0
    out = capsys.readouterr().out
    assert "Suggestion 1" in out
    changes = found(folder, capsys)
    assert changes[-1] == {"windows_time": "0"}
    assert set(changes[0]) == {"time_slice", "windows_time"}
    assert changes[0]["windows_time"] == "400"


@pytest.mark.parametrize(
    ("words", "changed"),
    [
        (["--vary", "windows_time"], {"windows_time"}),
        (["--vary", "cpus", "--cpus", "2"], {"thread[1].cpu"}),
        (["--vary", "priorities", "--slack", "5", "--slack", "DRIVER=0"], set()),
    ],
)
def test_what_may_be_varied(
    folder: Path, capsys: Capture, words: list[str], changed: set[str]
) -> None:
    """Nothing else is changed."""
    if "DRIVER=0" in words:
        words = [*words[:-1], "MMI_DRIVER=0"]
    changes = found(folder, capsys, *words)
    if changed:
        assert set(changes[0]) == changed
    assert all(
        name.endswith("priority") for one in changes for name in one if "priorities" in words
    )


def test_the_list_that_is_written_has_the_slacks(folder: Path, capsys: Capture) -> None:
    """--output: the list with the first suggestion, its comments kept, asks for nothing more."""
    path = folder / "better.lis"
    assert run(folder, "--output", str(path)) == 0
    text = path.read_text("utf-8")
    assert "windows_time 400 # 0 turned off" in text
    assert text.count("\n") == EXAMPLE_1.count("\n")
    capsys.readouterr()
    assert run(folder, name="better.lis") == 0
    assert "The list has the slacks that are asked for." in capsys.readouterr().out


def test_a_list_that_needs_nothing(folder: Path, capsys: Capture) -> None:
    """The larger possible number of calls is reported; with one more, no slack is left."""
    (folder / "load.toml").write_text(load_text(NOMINAL | {"task_rnd": 100}), "utf-8")
    assert run(folder, "--lang", "de", "--format", "json") == 0
    document = json.loads(capsys.readouterr().out)
    assert document["is_met"] and document["suggestions"] == []
    calls = document["max_calls"]["BACKGROUND_"]
    for count, is_met in ((calls, True), (calls + 1, False)):
        line = f"thread[1].function[0].calls_per_cycle {count}"
        (folder / "more.lis").write_text(with_line(EXAMPLE_1, line), "utf-8")
        run(folder, "--format", "json", name="more.lis")
        assert json.loads(capsys.readouterr().out)["is_met"] is is_met


def test_nothing_is_found(folder: Path, capsys: Capture) -> None:
    """900647 and exit code 1; no list is written."""
    (folder / "load.toml").write_text(load_text(TIGHT | {"task_int": 2100}), "utf-8")
    path = folder / "better.lis"
    assert run(folder, "--output", str(path)) == 1
    assert "error 900647" in capsys.readouterr().err
    assert not path.exists()


@pytest.mark.parametrize("slack", ["x", "-1", "100", "NOBODY=5", "GEO=", "=5", "nan"])
def test_slacks_that_are_none(folder: Path, capsys: Capture, slack: str) -> None:
    """900648 names the threads."""
    assert run(folder, "--slack", slack) == 2
    err = capsys.readouterr().err
    assert "error 900648" in err and "MMI_DRIVER" in err


@pytest.mark.parametrize(
    ("slack", "name"), [("", "--slack"), ("MMI_DRIVER=", "--slack MMI_DRIVER")]
)
def test_two_slacks_of_one_thread(folder: Path, capsys: Capture, slack: str, name: str) -> None:
    """902953: none replaces the other."""
    assert run(folder, "--slack", f"{slack}20", "--slack", f"{slack}30") == 2
    assert f"error 902953: {name} is given more than once" in capsys.readouterr().err


def search(configuration: RtconfConfiguration, load: str, slacks: Slacks, cpus: int) -> Suggestions:
    """Suggestions for a configuration with a load."""
    times = read_load("load.toml", load, Collector())

    def model_of(changed: RtconfConfiguration) -> Model:
        return assemble(changed, times, PROFILES["rtx"], Collector())

    return suggest(configuration, model_of, slacks, VARIABLES, range(1, cpus + 1))


@pytest.mark.nightly
@pytest.mark.slow
@given(
    st.integers(100, 900),
    st.integers(100, 900),
    st.integers(50, 900),
    st.integers(50, 900),
    st.integers(0, 40),
    st.integers(1, 2),
    st.sampled_from([0, 500, 1000]),
)
@settings(max_examples=40, deadline=None)
def test_suggestions_hold_in_a_simulation(
    geo: int, rnd: int, mmi: int, com: int, slack: int, cpus: int, windows: int
) -> None:
    """No thread overflows or answers later than asked for, and Windows keeps what it had."""
    times = TIGHT | {"task_int": geo, "task_rnd": rnd, "task_mmi_driver": mmi, "task_com": com}
    configuration = configure(change(EXAMPLE_1, windows_time=windows), TABLE)
    slacks = Slacks(slack, {})
    found = search(configuration, load_text(times), slacks, cpus)
    for suggestion in found.better or ((found.present,) if found.is_met else ()):
        model = suggestion.analysis.model
        run = simulate(model, 4 * hyperperiod(model), record=0)
        assert contradictions(suggestion.analysis, run) == []
        for task, numbers in zip(model.tasks, run.tasks, strict=True):
            period = task.every * model.train.distance
            assert numbers.overflows == 0
            assert (numbers.response_max or 0) <= slacks.limit(task.name, period)

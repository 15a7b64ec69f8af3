# SPDX-License-Identifier: MIT
"""``nctakt schedule compare``: what differs between two lists, and for whom it is better."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.schedule_examples import EXAMPLE_1, EXAMPLE_2, TIGHT, change, load_text, with_line

from nctakt.cli import main

Capture = pytest.CaptureFixture[str]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Two lists with a load."""
    (tmp_path / "a.lis").write_text(EXAMPLE_1, "utf-8")
    (tmp_path / "b.lis").write_text(change(EXAMPLE_1, windows_time=0), "utf-8")
    (tmp_path / "load.toml").write_text(load_text(TIGHT), "utf-8")
    return tmp_path


def run(folder: Path, *words: str, first: str = "a.lis", second: str = "b.lis") -> int:
    """The exit code of the command."""
    files = [str(folder / first), str(folder / second), "--load", str(folder / "load.toml")]
    return main(["schedule", "compare", *files, "--convention", "table", "--quiet", *words])


def test_windows_time_off(folder: Path, capsys: Capture) -> None:
    """Without guaranteed time the suspendable threads answer sooner, and Windows has less."""
    assert run(folder) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["windows_time", "500", "0"] in rows
    assert ["GEO", "400", "400", "0", "400", "400", "0", "0", "same"] in rows
    com = next(row for row in rows if row[:1] == ["COM"])
    assert com[1:4] == ["5450", "1850", "−3600"]
    assert com[-1] == "better"


def test_a_list_with_itself(folder: Path, capsys: Capture) -> None:
    """Nothing differs."""
    assert run(folder, second="a.lis") == 0
    out = capsys.readouterr().out
    assert "Both lists say the same." in out
    assert "better" not in out and "worse" not in out


def test_the_other_way_round(folder: Path, capsys: Capture) -> None:
    """What is better from A to B is worse from B to A."""
    verdicts = []
    for files in (("a.lis", "b.lis"), ("b.lis", "a.lis")):
        run(folder, "--format", "json", first=files[0], second=files[1])
        document = json.loads(capsys.readouterr().out)
        verdicts.append([one["verdict"] for one in document["threads"]])
    swapped = {"better": "worse", "worse": "better", "same": "same"}
    assert verdicts[1] == [swapped[one] for one in verdicts[0]]


def test_threads_of_one_list_only(folder: Path, capsys: Capture) -> None:
    """They are reported as such, and belong together by name, not by place."""
    (folder / "b.lis").write_text(EXAMPLE_2, "utf-8")
    run(folder, "--lang", "de")
    out = capsys.readouterr().out
    com = next(line for line in out.splitlines() if line.startswith("COM"))
    assert com.endswith("nur in A")
    moved = EXAMPLE_1.replace("thread[2]", "thread[5]")
    (folder / "b.lis").write_text(moved, "utf-8")
    run(folder, "--format", "json")
    document = json.loads(capsys.readouterr().out)
    assert {one["verdict"] for one in document["threads"]} == {"same"}


def test_picture_of_both(folder: Path) -> None:
    """Both schedules in one picture, each under its own name."""
    path = folder / "both.svg"
    assert run(folder, "--plot", str(path)) == 0
    text = path.read_text("utf-8")
    assert "a.lis · load.toml" in text and "b.lis · load.toml" in text


def test_two_loads(folder: Path, capsys: Capture) -> None:
    """--load-b: the same list with other times."""
    (folder / "slow.toml").write_text(load_text(TIGHT | {"task_rnd": 800}), "utf-8")
    run(folder, "--load-b", str(folder / "slow.toml"), second="a.lis")
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    background = next(row for row in rows if row[:1] == ["BACKGROUND_"])
    assert (background[1:4], background[-1]) == (["1300", "1400", "+100"], "worse")


def test_several_processors(folder: Path, capsys: Capture) -> None:
    """Windows on a processor that only one list uses."""
    (folder / "b.lis").write_text(with_line(EXAMPLE_1, "thread[1].cpu 2"), "utf-8")
    run(folder, "--format", "json")
    windows = json.loads(capsys.readouterr().out)["windows"]
    assert [(one["cpu"], one["verdict"]) for one in windows][1:] == [(None, "better"), (2, "added")]


@pytest.mark.parametrize(
    ("words", "number"), [(["--plot", "a.pdf"], 900635), (["--plot", "missing/a.svg"], 900507)]
)
def test_bad_pictures(folder: Path, capsys: Capture, words: list[str], number: int) -> None:
    """Reported before anything is simulated; nothing is shown."""
    assert run(folder, *words) == 2
    captured = capsys.readouterr()
    assert f"error {number}" in captured.err and captured.out == ""


def test_a_picture_never_takes_a_list(folder: Path, capsys: Capture) -> None:
    """The second list is an input, too."""
    (folder / "b.svg").write_text(EXAMPLE_1, "utf-8")
    assert run(folder, "--plot", str(folder / "b.svg"), second="b.svg") == 2
    assert "error 900913" in capsys.readouterr().err
    assert (folder / "b.svg").read_text("utf-8") == EXAMPLE_1

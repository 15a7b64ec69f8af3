# SPDX-License-Identifier: MIT
"""``nctakt coverage`` as a user meets it, and its document."""

from __future__ import annotations

import itertools
import json
import re
import shlex
from pathlib import Path

import pytest

from nctakt.cli import main

ROOT = Path(__file__).parent.parent.parent

PART = """\
#RT CYCLE [ID = 17 SCOPE = PROG]
  $IF V.E.TRIGGER == 1
    M100
  $ELSE
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
#TIME 0.01
M30
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The command runs in its own folder, where part.nc is."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "part.nc").write_text(PART, encoding="utf-8")
    return tmp_path


def bodies(path: Path) -> list[int]:
    """How often each branch in a data file ran."""
    (cycle,) = json.loads(path.read_text("utf-8"))["cycles"]
    return [branch["bodies"] for branch in cycle["branches"]]


def test_data_grow_from_run_to_run(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The dwell takes ten ticks: ten times ``$ELSE``, then four times of ten."""
    data = folder / "all.json"
    assert main(["coverage", "part.nc", "--data", "all.json"]) == 0
    assert bodies(data) == [0, 10]
    assert main(["coverage", "part.nc", "--data", "all.json", "--at", "4ms", "V.E.TRIGGER=1"]) == 0
    assert bodies(data) == [6, 14]
    shown = capsys.readouterr().out
    assert "total: 1 of 2 branches ran, 50 %; runs: 1" in shown
    assert "total: 2 of 2 branches ran, 100 %; runs: 2" in shown
    before = data.read_bytes()
    assert main(["coverage", "--data", "all.json"]) == 0
    assert data.read_bytes() == before


def test_a_run_that_ended_at_its_limit_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    """902985: the table has only what ran until then; a run that ended by itself needs no note."""
    assert main(["coverage", "part.nc", "--ticks", "4"]) == 0
    assert "note 902985: the run ended at its limit, after 0.004 s" in capsys.readouterr().err
    assert main(["coverage", "part.nc"]) == 0
    assert "902985" not in capsys.readouterr().err


def test_files_of_several_runs_are_merged(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What two machines have counted, in any order."""
    for name, value in (("a", 0), ("b", 1)):
        words = ["coverage", "part.nc", "--format", "json", "--set", f"V.E.TRIGGER={value}"]
        assert main(words) == 0
        (folder / f"{name}.json").write_text(capsys.readouterr().out, "utf-8")
    sums = []
    for first, second in ("ab", "ba"):
        words = ["--merge", f"{first}.json", "--merge", f"{second}.json", "--format", "json"]
        assert main(["coverage", *words, "--fail-under", "100"]) == 0
        sums.append(capsys.readouterr().out)
    assert sums[0] == sums[1]
    assert [one["bodies"] for one in json.loads(sums[0])["cycles"][0]["branches"]] == [10, 10]


def test_too_little_is_reported_and_ends_with_1(capsys: pytest.CaptureFixture[str]) -> None:
    """For a pipeline that shall stop."""
    assert main(["coverage", "part.nc", "--fail-under", "50"]) == 0
    assert main(["coverage", "part.nc", "--fail-under", "50.5", "--lang", "de"]) == 1
    shown = capsys.readouterr().err
    assert "900803: 50 % der Zweige sind gelaufen; mindestens 50.5 % sind verlangt" in shown


def test_a_changed_program_drops_what_was_known(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A warning says it."""
    assert main(["coverage", "part.nc", "--data", "all.json"]) == 0
    (folder / "part.nc").write_text(PART.replace("== 1", "== 2"), "utf-8")
    assert main(["coverage", "part.nc", "--data", "all.json"]) == 0
    assert "warning 900802: part.nc: its realtime cycles have changed" in capsys.readouterr().err
    assert bodies(folder / "all.json") == [0, 10]


@pytest.mark.parametrize(
    ("words", "number"),
    [
        ([], 900800),
        (["--merge", "none.json"], 900500),
        (["--merge", "."], 900501),
        (["--merge", "part.nc"], 900801),
        (["--data", "part.nc"], 900801),
        (["part.nc", "--data", "nowhere/all.json"], 900507),
        (["none.nc"], 900500),
        (["part.nc", "--set", "V.E.NONE=1"], 900540),
    ],
)
def test_what_cannot_be_used_is_reported(
    words: list[str], number: int, capsys: pytest.CaptureFixture[str]
) -> None:
    """Wrong usage, by number, and nothing on standard output."""
    assert main(["coverage", *words]) == 2
    shown = capsys.readouterr()
    assert f" {number}: " in shown.err
    assert shown.out == ""


def test_a_program_with_mistakes_counts_nothing(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It did not run, so the data of earlier runs stay."""
    assert main(["coverage", "part.nc", "--data", "all.json"]) == 0
    before = (folder / "all.json").read_bytes()
    capsys.readouterr()
    (folder / "bad.nc").write_text("G00 X1 )\nM30\n", "utf-8")
    assert main(["coverage", "bad.nc", "--data", "all.json"]) == 1
    assert capsys.readouterr().out == ""
    assert (folder / "all.json").read_bytes() == before


def test_the_document_shows_what_the_command_prints(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    """``docs/coverage.md``, letter by letter; its data file is one of this test's folder."""
    monkeypatch.chdir(ROOT)
    text = (ROOT / "docs" / "coverage.md").read_text("utf-8")
    blocks = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    checked = 0
    for (kind, commands), (_, shown) in itertools.pairwise(blocks):
        if kind != "sh":
            continue
        for command in commands.strip().splitlines():
            words = [str(folder / w) if w == "all.json" else w for w in shlex.split(command)[1:]]
            capsys.readouterr()
            assert main(words) == 0
        assert capsys.readouterr().out == shown
        checked += 1
    assert checked == 3

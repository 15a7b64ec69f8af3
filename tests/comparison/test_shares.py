# SPDX-License-Identifier: MIT
"""Folders of ``compare --share``: nothing private is in them, and each is a test (fidelity.md)."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from support.changed_lists import machine_with

from nctakt.cli import main
from nctakt.comparison.sharing.neutral_names import NeutralNames

SHARES = Path(__file__).parent / "shares"
PRIVATE = """%MILLER_FLANGE (for Miller)
#VAR
  V.P.MILLERS : REAL64 = 3
#ENDVAR
#COMMENT BEGIN
Miller's order
#COMMENT END
N10 G01X10Y5F6000 ; Miller
V.E.ROH = V.P.MILLERS \\
  + 1
#MSG ["Miller %f", V.E.ROH]
"MILLER" = "G01 X20"
"MILLER"
L "Order Miller.nc"
$GOTO [MILLER_END]
X99
[MILLER_END] X[V.E.ROH]
M30
"""


@pytest.fixture(autouse=True)
def _log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A program with a subprogram, and the log of another one in the same folder."""
    monkeypatch.chdir(tmp_path)
    variables = machine_with(Path("lists")) / "ext_var1.lis"
    text = variables.read_text("utf-8").replace(" VALUE\n", " ROH\n")
    variables.write_text(f"# Miller\n{text}", "utf-8")
    Path("part.nc").write_text(PRIVATE, "utf-8")
    Path("Order Miller.nc").write_text("(Miller)\nG01 Y20\nM17\n", "utf-8")
    rows = "".join(f"{4 * n},{n / 10}\n" for n in range(40))
    Path("miller.csv").write_text(f"time_ms,Axis X ActPos Miller\n{rows}", "utf-8")


def compare(*words: str) -> int:
    """Compare the log with the program."""
    return main(["compare", "miller.csv", "part.nc", "--offset", "0s", *words])


def test_nothing_private_is_in_a_folder(capsys: pytest.CaptureFixture[str]) -> None:
    """Names, comments, texts and files have neutral names; the files run like the program."""
    words = ("--machine", "lists", "--share", "for_nctakt")
    assert compare(*words, "--set", "V.E.ROH=2", "--yes") == 0
    shown = capsys.readouterr()
    assert "these files run like the program" in shown.out
    assert "part2.nc" in shown.out
    files = {
        path.relative_to("for_nctakt").as_posix(): path.read_text("utf-8")
        for path in Path("for_nctakt").rglob("*.*")
    }
    for name, text in files.items():
        for word in ("miller", "order", "ROH\n", "ROH ", str(Path.cwd()), "#COMMENT"):
            assert word.casefold() not in f"{name}\n{text}".casefold(), (name, word)
    facts = json.loads(files["facts.json"])
    assert facts["runs_alike"] is True
    assert facts["words"][0] == "--set"
    assert facts["words"][1].startswith("V.E.NAME")
    assert files["log.csv"].splitlines()[0] == "time_us;X.ACS.ACT_POS [mm]"


def test_nothing_is_written_without_yes(capsys: pytest.CaptureFixture[str]) -> None:
    """What it would hold is shown first (902743); a folder that is in use is refused."""
    assert compare("--machine", "lists", "--share", "for_nctakt") == 0
    shown = capsys.readouterr()
    assert "log.csv" in shown.out
    assert "902743" in shown.err
    assert not Path("for_nctakt").exists()
    before = Path("lists/hochlauf.lis").read_bytes()
    assert compare("--machine", "lists", "--share", "lists", "--yes") == 2
    assert "900746" in capsys.readouterr().err
    assert Path("lists/hochlauf.lis").read_bytes() == before


def test_what_a_plc_did_is_missing_and_reported(capsys: pytest.CaptureFixture[str]) -> None:
    """902740: the PLC's override is not in the files, so X differs from the first motion on."""
    cycle = "class Slow:\n    def cycle(self, hli):\n        hli.override_pct = 50\n"
    Path("plc.py").write_text(cycle, "utf-8")
    assert compare("--machine", "lists", "--plc", "plc.py", "--share", "f", "--yes") == 0
    assert "902740" in capsys.readouterr().err
    assert json.loads(Path("f/facts.json").read_text("utf-8"))["runs_alike"] is False


@pytest.mark.parametrize(
    ("line", "neutral"),
    [
        ("N10 G01X100Y50F6000 ; Miller", "N10 G01X100Y50F6000"),
        ("X[INDP_ASYN G90 POS=10 FEED=500]", "X[INDP_ASYN G90 POS=10 FEED=500]"),
        ("$IF V.RTA.ACS.ACT_POS.X>V.L.A[2].MASS", "$IF V.RTA.ACS.ACT_POS.X>V.L.NAME1[2].NAME2"),
        ("#FILE NAME [MSG=miller.txt]", "#FILE NAME [MSG=NAME1.NAME2]"),
        ("%L MILLER", "%L NAME1"),
        ("L CYCLE [NAME=part.nc @P1=3]", "L CYCLE [NAME=part1.nc @P1=3]"),
        ("LL part", "LL part1.nc"),
    ],
)  # fmt: skip
def test_neutral_blocks(line: str, neutral: str) -> None:
    """The language stays, and the controller's variables; all else gets a name."""
    assert NeutralNames({"a/part.nc": "part1.nc"}, ["X"]).lines([line]) == [neutral]


def figures(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Any:
    """Compare a folder's log with its program; return what was found, and its facts."""
    monkeypatch.chdir(folder)
    facts = json.loads(Path("facts.json").read_text("utf-8"))
    programs = facts["channels"]["1"]
    words = ["--machine", "machine", "--offset", "0s", "--format", "json", *facts["words"]]
    assert main(["compare", "log.csv", *programs, *words]) == 0
    return json.loads(capsys.readouterr().out)["comparison"], facts["comparison"]


@pytest.mark.parametrize("folder", sorted(SHARES.iterdir()), ids=lambda folder: folder.name)
def test_a_shared_folder(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """No signal is farther from the machine's than when the folder was taken in."""
    found, facts = figures(folder, monkeypatch, capsys)
    for now, then in zip(found["signals"], facts["signals"], strict=True):
        assert (now["signal"], now["samples"]) == (then["signal"], then["samples"])
        assert now["rms"] <= then["rms"] * (1.0 + 1e-6) + 1e-9
        assert abs(now["greatest"]) <= abs(then["greatest"]) * (1.0 + 1e-6) + 1e-9


def test_what_is_known_of_the_first_folder(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Our own run in which M10 took 30 ms longer: N20, the block after it, is late by as much.

    X goes 100 mm/s there: 3 mm.
    """
    found, _ = figures(SHARES / "m10_takes_30_ms_longer", monkeypatch, capsys)
    x = found["signals"][0]
    assert x["greatest"] == pytest.approx(3.0, abs=0.01)
    assert found["delays"][0]["block"] == {"file": "part1.nc", "line": 3}
    assert found["delays"][0]["jump_us"] == pytest.approx(30_000, abs=2_000)

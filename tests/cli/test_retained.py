# SPDX-License-Identifier: MIT
"""``nctakt run --retain``: RETAIN and PERSISTENT variables from run to run (ST-406)."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.plc_rig import EACH_TICK

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.cli.common.retaining import RetainedSession
from nctakt.files.access import FileAccess
from nctakt.session.session import Session

CELL = """
TYPE ST_Part : STRUCT nId : UDINT; sName : STRING(10); END_STRUCT END_TYPE
TYPE E_Gate : (Closed, Open := 10); END_TYPE
FUNCTION_BLOCK FB_Counter
VAR RETAIN n : ULINT; END_VAR
VAR nSinceStart : INT; END_VAR
n := n + 1; nSinceStart := nSinceStart + 1;
END_FUNCTION_BLOCK
VAR_GLOBAL PERSISTENT gTotal : LREAL; gParts : ARRAY[1..2] OF ST_Part; gP : PVOID; END_VAR
PROGRAM MAIN
VAR PERSISTENT eGate : E_Gate; END_VAR
VAR aCounters : ARRAY[0..1] OF FB_Counter; nPlain : INT; END_VAR
aCounters[0](); aCounters[1](); aCounters[1](); nPlain := nPlain + 1;
gTotal := gTotal + 0.5; gParts[2].nId := 7; gParts[1].sName := 'a"b'; eGate := E_Gate.Open;
END_PROGRAM
"""


@pytest.fixture(name="cell")
def _cell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("cell.st").write_text(CELL + EACH_TICK, "utf-8")
    Path("part.nc").write_text("G04 0.01\nM30\n", "utf-8")
    return tmp_path


def _run(*words: str) -> int:
    return main(["run", "part.nc", "--plc", "cell.st", "--ticks", "10", "--quiet", *words])


def test_values_go_on_in_the_next_run(cell: Path) -> None:
    """ST-406: ten cycles a run; all but RETAIN and PERSISTENT restarts; a tape has them."""
    assert _run("--retain", "kept.json") == 0
    first = {
        "gTotal": 5.0,
        "gParts[1].nId": 0,
        "gParts[1].sName": 'a"b',
        "gParts[2].nId": 7,
        "gParts[2].sName": "",
        "MAIN.eGate": "E_Gate.Open",
        "MAIN.aCounters[0].n": 10,
        "MAIN.aCounters[1].n": 20,
    }
    assert json.loads(Path("kept.json").read_text("utf-8")) == first
    assert _run("--retain", "kept.json", "--set", "gTotal=1", "--record", "run.tape") == 0
    second = {**first, "gTotal": 6.0, "MAIN.aCounters[0].n": 20, "MAIN.aCounters[1].n": 40}
    assert json.loads(Path("kept.json").read_text("utf-8")) == second
    Path("kept.json").unlink()
    assert main(["replay", "run.tape", "--quiet"]) == 0


def test_whole_numbers_stay_exact(cell: Path) -> None:
    """A ULINT beyond 2^53: 20 more are 2^64, which wraps to 0."""
    Path("kept.json").write_text('{"MAIN.aCounters[1].n": 18446744073709551596}', "utf-8")
    assert _run("--retain", "kept.json", "--record", "run.tape") == 0
    assert json.loads(Path("kept.json").read_text("utf-8"))["MAIN.aCounters[1].n"] == 0
    assert main(["replay", "run.tape", "--quiet"]) == 0


def test_wrong_files(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Unknown names and types are skipped with a warning; another content is an error."""
    kept = Path("kept.json")
    kept.write_text('{"MAIN.nPlain": 1, "MAIN.gone": 2, "MAIN.eGate": "Ajar", "gTotal": 2}')
    assert _run("--retain", "kept.json", "--lang", "de") == 0
    assert capsys.readouterr().err.count("902503") == 3
    assert json.loads(kept.read_text("utf-8"))["gTotal"] == 7.0
    for content in ("[]", '{"gTotal": [1]}', '{"gTotal": NaN}', "{", "[" * 100_000):
        kept.write_text(content, "utf-8")
        assert _run("--retain", "kept.json") == 2
        assert "902502" in capsys.readouterr().err
        assert kept.read_text("utf-8") == content
    assert main(["run", "part.nc", "--retain", "other.json"]) == 2
    assert "902501" in capsys.readouterr().err
    assert not Path("other.json").exists()


def test_sessions_keep_for_the_next_one(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The values are those at the tick where the session is; its files may have changed."""
    kept = Path("kept.json")
    kept.write_text('{"gTotal": 2, "MAIN.gone": 1}', "utf-8")
    retained = RetainedSession("kept.json", ["cell.st"], FileAccess(), "en")
    assert capsys.readouterr().err.count("902503") == 1
    with Session("part.nc", plc="cell.st", set={**retained.values()}) as session:
        retained.follow(session)
        session.step(8)
        session.back(5)
        tick = session.tick
        source = Path("cell.st")
        text = source.read_text("utf-8")
        source.write_text(text.replace("nPlain : INT", "nOther : INT; nPlain : INT"))
        values = retained.values()
        assert session.tick == tick
        assert values == json.loads(kept.read_text("utf-8"))
        assert values["gTotal"] == session.read("gTotal")[0] == 2.0 + 0.5 * tick
    with pytest.raises(Failure, match="902501"):
        RetainedSession("kept.json", [], FileAccess(), "en")
    with pytest.raises(Failure, match="900913"):
        access = FileAccess()
        access.note("kept.json")
        RetainedSession("kept.json", ["cell.st"], access, "en")

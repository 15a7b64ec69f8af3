# SPDX-License-Identifier: MIT
"""``nctakt check``: what the formats for other tools look like, and that they are right."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any

import pytest
from support.sarif_schema import faults

from nctakt.cli import main
from nctakt.messages.programs.checked_cycles import ASYNCHRONOUS_WRITE_IN_CYCLE

PART = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.E.VALUE > 1
    V.RTG.OVERRIDE.VEL.CYCLE = 50
    V.E.ASYNC = 1
  $ENDIF
#RT CYCLE END
M30
"""
CHANNEL = "rt_cycles.max_steps 5\nrt_cycles.max_stepz 5\nEnde\n"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The command runs in its own folder, with a program and a list."""
    monkeypatch.chdir(tmp_path)
    Path("programs, new").mkdir()
    Path("programs, new/part ä.nc").write_text(PART, encoding="utf-8")
    Path("sda_mds1.lis").write_text(CHANNEL, encoding="utf-8")
    return tmp_path


def reported(capsys: pytest.CaptureFixture[str], *words: str, code: int = 1) -> str:
    """The standard output of a check."""
    assert main(["check", *words]) == code
    return capsys.readouterr().out


def sarif(capsys: pytest.CaptureFixture[str], *words: str, code: int = 1) -> dict[str, Any]:
    """The one run of a SARIF log that keeps the schema of the standard."""
    log = json.loads(reported(capsys, *words, "--format", "sarif", code=code))
    assert faults(log) == []
    (run,) = log["runs"]
    assert isinstance(run, dict)
    rules = [rule["id"] for rule in run["tool"]["driver"]["rules"]]
    assert len(rules) == len(dict.fromkeys(rules))
    for result in run["results"]:
        assert rules[result["ruleIndex"]] == result["ruleId"]
    return run


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    """Files with their kinds, findings with rule, place, text and remedy, counts; no remarks."""
    document = json.loads(reported(capsys, ".", "--format", "json"))
    assert document["files"] == [
        {"file": "programs, new/part ä.nc", "kind": "program"},
        {"file": "sda_mds1.lis", "kind": "channel"},
    ]
    assert document["counts"] == {"files": 2, "errors": 1, "warnings": 2, "notes": 1}
    assert [one["id"] for one in document["diagnostics"]] == [900242, 22009, 900583, 900009]
    assert document["diagnostics"][1] == {
        "id": 22009,
        "also": [],
        "rule": "NCTAKT22009",
        "severity": "error",
        "file": "programs, new/part ä.nc",
        "line": 4,
        "column": 5,
        "end_column": 14,
        "text": ASYNCHRONOUS_WRITE_IN_CYCLE.text.en.format(name="V.E.ASYNC"),
        "remedy": ASYNCHRONOUS_WRITE_IN_CYCLE.remedy.en,
        "source_line": "    V.E.ASYNC = 1",
        "channels": [],
    }


def test_github(capsys: pytest.CaptureFixture[str]) -> None:
    """A workflow command for each finding, with what would end it early escaped."""
    lines = reported(capsys, ".", "--format", "github").splitlines()
    assert [line.split(" ")[0] for line in lines] == [
        "::warning",
        "::error",
        "::notice",
        "::warning",
    ]
    place, message = lines[0].removeprefix("::warning ").split("::", 1)
    assert place == ("file=programs%2C new/part ä.nc,line=3,col=5,endColumn=29,title=NCTAKT900242")
    assert "then it is 100 %25 again%0Aremedy: Write it" in message


def test_sarif(capsys: pytest.CaptureFixture[str]) -> None:
    """SARIF 2.1.0: rules with texts, results with rule, level, relative place, fingerprint."""
    run = sarif(capsys, ".")
    rules = run["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == [
        "NCTAKT22009",
        "NCTAKT900009",
        "NCTAKT900242",
        "NCTAKT900583",
    ]
    assert rules[0]["shortDescription"]["text"].startswith("<name> is asynchronous")
    assert [one["location"]["uri"] for one in run["artifacts"]] == [
        "programs%2C%20new/part%20%C3%A4.nc",
        "sda_mds1.lis",
    ]
    result = run["results"][1]
    assert (result["ruleId"], result["ruleIndex"], result["level"]) == ("NCTAKT22009", 0, "error")
    assert result["message"]["text"].startswith("V.E.ASYNC is asynchronous")
    assert result["locations"][0]["physicalLocation"] == {
        "artifactLocation": {
            "uri": "programs%2C%20new/part%20%C3%A4.nc",
            "uriBaseId": "%SRCROOT%",
        },
        "region": {"startLine": 4, "startColumn": 5, "endColumn": 14},
    }


def test_the_schema_finds_what_is_wrong(capsys: pytest.CaptureFixture[str]) -> None:
    """It is really asked: a level that there is not, a property that nobody knows."""
    log = json.loads(reported(capsys, ".", "--format", "sarif"))
    log["runs"][0]["results"][0]["level"] = "fatal"
    log["runs"][0]["surprise"] = 1
    assert sorted(fault.split(":")[0] for fault in faults(log)) == [
        "$.runs[0]",
        "$.runs[0].results[0].level",
    ]


def test_sarif_in_german(capsys: pytest.CaptureFixture[str]) -> None:
    """The language is that of the option, for rules and results."""
    run = sarif(capsys, ".", "--lang", "de")
    assert run["language"] == "de"
    assert run["tool"]["driver"]["rules"][0]["shortDescription"]["text"].startswith(
        "<name> ist asynchron"
    )
    assert "Abhilfe: " in run["results"][1]["message"]["text"]


def test_sarif_of_files_without_a_place(capsys: pytest.CaptureFixture[str]) -> None:
    """What is about a file as a whole is at its first line; outside paths are absolute."""
    outside = Path("part.nc").resolve().parent.parent / "elsewhere.nc"
    run = sarif(capsys, "gone.nc", str(outside), "<new>.nc", code=2)
    places = [result["locations"][0]["physicalLocation"] for result in run["results"]]
    assert [place["artifactLocation"]["uri"] for place in places] == [
        outside.as_uri(),
        "%3Cnew%3E.nc",
        "gone.nc",
    ]
    assert all(place["region"] == {"startLine": 1} for place in places)


@pytest.mark.skipif(sys.platform != "linux", reason="names of files that are no text")
@pytest.mark.parametrize("format", ["text", "json", "github", "sarif"])
def test_names_that_are_no_text(capsys: pytest.CaptureFixture[str], format: str) -> None:
    """A file name of bytes that are no UTF-8 is reported in every format."""
    name = os.fsdecode(b"part\xff.nc")
    Path(name).write_text(PART, encoding="utf-8")
    capsys.readouterr()
    assert main(["check", name, "--format", format, "--output", "out"]) == 1
    shown = Path("out").read_text("utf-8")
    assert ("part%FF.nc" if format == "sarif" else "part\\udcff.nc") in shown


def fingerprints(capsys: pytest.CaptureFixture[str]) -> dict[str, list[str]]:
    """Rule -> fingerprints of its results in their order."""
    found: dict[str, list[str]] = {}
    for result in sarif(capsys, "programs, new")["results"]:
        own = result["partialFingerprints"]["primaryLocationLineHash"]
        found.setdefault(result["ruleId"], []).append(own)
    return found


def test_fingerprints_stay_when_lines_move(capsys: pytest.CaptureFixture[str]) -> None:
    """They depend on rule, path and the line's text, and tell equal lines apart."""
    before = fingerprints(capsys)
    path = Path("programs, new/part ä.nc")
    path.write_text("; a line\n\n" + PART.replace("    V.E.ASYNC", "\tV.E.ASYNC"), "utf-8")
    assert fingerprints(capsys) == before
    path.write_text(PART.replace("    V.E.ASYNC = 1\n", 2 * "    V.E.ASYNC = 1\n"), "utf-8")
    doubled = fingerprints(capsys)
    first, second = doubled["NCTAKT22009"]
    assert [first] == before["NCTAKT22009"]
    assert first.replace(":1", ":2") == second
    path.rename("programs, new/other.nc")
    assert fingerprints(capsys)["NCTAKT22009"][0] != first


def test_an_empty_check_is_valid(capsys: pytest.CaptureFixture[str]) -> None:
    """A check without findings is a log without results, an object without diagnostics."""
    Path("good.nc").write_text("M30\n", encoding="utf-8")
    assert sarif(capsys, "good.nc", code=0)["results"] == []
    assert json.loads(reported(capsys, "good.nc", "--format", "json", code=0))["diagnostics"] == []
    assert reported(capsys, "good.nc", "--format", "github", code=0) == ""

# SPDX-License-Identifier: MIT
"""``nctakt why`` as a user meets it, and its document."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import nctakt
from nctakt.cli import main
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.run.controller import Controller

ROOT = Path(__file__).parent.parent.parent

PART = """\
#RT CYCLE [ID = 17 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF
  $IF EDGE V.E.TRIGGER == 1
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
#MSG ["on the way"]
N20 G00 X300
M30
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The command runs in its own folder, where part.nc is."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "part.nc").write_text(PART, encoding="utf-8")
    return tmp_path


def test_the_report_follows_how_the_run_ended(capsys: pytest.CaptureFixture[str]) -> None:
    """RC worked example: true in tick 463; what the program says is not shown."""
    assert main(["why", "part.nc"]) == 0
    shown = capsys.readouterr().out.splitlines()
    assert shown[0] == "part.nc: ended, 726 ticks = 0.726000 s"
    assert shown[2] == "realtime cycle 17  part.nc:1  PROG"
    assert "    true from tick 463 (0.463 s): 200.25 > 200" in shown
    assert "    never ran: never true, nearest at tick 0 (0 s): 0 == 1, 1 away" in shown
    assert not any("on the way" in line for line in shown)


def test_notes_about_the_lists_are_one(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Who runs a program has not asked for them; check shows them, and JSON has them."""
    shutil.copytree(DEMO_FOLDER, folder / "mine")
    for name in ("achs_mds1.lis", "achs_mds2.lis"):
        axis = folder / "mine" / name
        axis.write_bytes("# für\n".encode("cp1252") + axis.read_bytes())
    for command in ("run", "why"):
        assert main([command, "part.nc", "--machine", "mine"]) == 0
        shown = capsys.readouterr().err
        assert "note 902936: notes about the lists of the machine: 2\n" in shown
        assert "  remedy: nctakt check mine shows them.\n" in shown
        assert "900000" not in shown
    assert main(["check", "mine"]) == 0
    assert capsys.readouterr().out.count("note 900000") == 2
    assert main(["why", "part.nc", "--machine", "mine", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)["diagnostics"]
    assert [one["id"] for one in found].count(900000) == 2


def test_a_value_at_a_time_changes_the_report(capsys: pytest.CaptureFixture[str]) -> None:
    """``--at``, ``--cycle`` and ``--line``: line 6 belongs to the ``$IF`` in line 5."""
    words = ["why", "part.nc", "--cycle", "17", "--line", "6", "--at", "0.1", "V.E.TRIGGER=1"]
    assert main(words) == 0
    shown = capsys.readouterr().out
    assert "became true once, ran once, in tick 100 (0.1 s)" in shown
    assert "ONCE" not in shown


@pytest.mark.parametrize("command", ["run", "why", "time", "coverage"])
def test_inputs_in_comments_are_those_of_tests(
    command: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A run without them says with which options it would be that of the test (902930)."""
    given = "; given: V.E.VALUE = 2; given: V.E.TRIGGER = 1 at 20ms\n"
    (folder / "part.nc").write_text(given + PART, encoding="utf-8")
    assert main([command, "part.nc"]) == 0
    reported = capsys.readouterr().err
    assert "902930: part.nc gives 2 values in comments" in reported
    options = "--set V.E.VALUE=2 --at 0.02s V.E.TRIGGER=1"
    assert options in reported
    assert main([command, "part.nc", *shlex.split(options)]) == 0
    assert "902930" not in capsys.readouterr().err


def test_how_everything_stood_at_a_time(capsys: pytest.CaptureFixture[str]) -> None:
    """``--state``: tick 463 holds 463.9 ms; the run goes no further, whatever ``--ticks`` says."""
    assert main(["why", "part.nc", "--state", "463.9ms", "--ticks", "9999", "--line", "2"]) == 0
    assert capsys.readouterr().out == (
        "tick 463 (0.463 s)\n"
        "\n"
        "realtime cycle 17  part.nc:1  PROG\n"
        "  ran in this tick\n"
        "\n"
        "  line 2  $IF ONCE V.RTA.ACS.ACT_POS.X > 200\n"
        "    evaluated in this tick\n"
        "    true since tick 463 (0.463 s): 200.25 > 200\n"
        "    ran: M100\n"
    )


def test_it_speaks_german(capsys: pytest.CaptureFixture[str]) -> None:
    """``--lang de``."""
    assert main(["why", "part.nc", "--lang", "de"]) == 0
    shown = capsys.readouterr().out
    assert shown.startswith("part.nc: beendet, 726 Takte")
    assert "wahr ab Takt 463 (0.463 s): 200.25 > 200" in shown


def test_several_programs_and_a_limit(capsys: pytest.CaptureFixture[str]) -> None:
    """The second program's definition is not reached before the limit."""
    Path("next.nc").write_text("#RT CYCLE\n#RT CYCLE END\nM30\n", encoding="utf-8")
    assert main(["why", "part.nc", "next.nc", "--until", "0.5"]) == 0
    shown = capsys.readouterr().out
    assert "stopped at the limit" in shown
    assert "realtime cycle  next.nc:1\n  never ran: not defined up to here" in shown


def test_an_error_of_the_program_is_reported_with_the_report(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Exit code 1; the report says what the fault kept from running."""
    text = PART.replace("#RT CYCLE [ID = 17 SCOPE = PROG]", "#RT CYCLE\nV.E.COUNT = 1/V.E.VALUE")
    Path("part.nc").write_text(text, encoding="utf-8")
    assert main(["why", "part.nc"]) == 1
    shown = capsys.readouterr()
    assert "error 50879" in shown.err
    assert "    never ran: an error ended the cycle at tick 0 (0 s): error 50879" in shown.out


def test_a_program_that_cannot_run_has_no_report(capsys: pytest.CaptureFixture[str]) -> None:
    """Exit code 1, the diagnostics of the check, nothing on standard output."""
    Path("part.nc").write_text("#RT CYCLE\nM30\n", encoding="utf-8")
    assert main(["why", "part.nc"]) == 1
    shown = capsys.readouterr()
    assert shown.out == ""
    assert "error 22005" in shown.err


@pytest.mark.parametrize(
    ("words", "number"),
    [
        ("part.nc --cycle 18", 900574),
        ("part.nc --line 11", 900575),
        ("part.nc --state 2", 900576),
        ("part.nc --state soon", 900510),
        ("missing.nc", 900500),
        ("part.nc --at 1 V.E.TRIGER=1", 900541),
        ("part.nc --variable V.E.TRIGER", 900541),
        ("part.nc --variable MAIN.bDoor", 902660),
    ],
)
def test_wrong_words_are_wrong_usage(
    words: str, number: int, capsys: pytest.CaptureFixture[str]
) -> None:
    """Exit code 2 with number and remedy."""
    assert main(["why", *words.split()]) == 2
    shown = capsys.readouterr().err
    assert f"error {number}: " in shown
    assert "remedy: " in shown


def test_a_variable_of_the_machine_that_no_plc_writes(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """902932 says what it is at the end: --at has set it, no statement of a PLC has."""
    words = ["why", "part.nc", "--at", "0.1", "V.E.TRIGGER=5", "--variable", "V.E.TRIGGER"]
    assert main(words) == 2
    shown = capsys.readouterr().err
    assert "has written V.E.TRIGGER in this run; at its end it is 5" in shown
    assert "nctakt run, with --trace FILE --signals V.E.TRIGGER." in shown


def test_a_plc_that_fails_is_reported(capsys: pytest.CaptureFixture[str]) -> None:
    """Exit code 1, as with ``nctakt run``."""
    Path("plc.py").write_text(
        "class P:\n  def cycle(self, hli):\n    getattr(hli, 'no')\n", "utf-8"
    )
    assert main(["why", "part.nc", "--plc", "plc.py"]) == 1
    assert "error 900523" in capsys.readouterr().err


@pytest.mark.nightly
@pytest.mark.slow
def test_both_forms_of_the_realtime_part_give_the_same_report() -> None:
    """Compiled and plain."""
    from nctakt.base.mode import is_compiled  # noqa: PLC0415 - only where it is asked

    if not is_compiled():
        pytest.skip("the realtime part is not compiled here")
    environment = os.environ | {"PYTHONPATH": str(Path(nctakt.__file__).parent.parent)}
    command = [sys.executable, "-m", "nctakt", "why", str(ROOT / "examples" / "reactions.nc")]
    reports = [
        subprocess.run([*command, form], check=True, capture_output=True, env=environment).stdout
        for form in ("--compiled", "--plain")
    ]
    assert reports[0] == reports[1]
    assert len(reports[0].splitlines()) > 30


# --- the document ------------------------------------------------------------------------------


def blocks(page: str = "why.md") -> list[tuple[str, str]]:
    """Language and text of the fenced blocks of docs/why.md, or of the German page."""
    text = (ROOT / "docs" / page).read_text("utf-8")
    return re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def test_the_document_shows_the_example() -> None:
    """The first block is the program."""
    assert blocks()[0] == ("", (ROOT / "examples" / "reactions.nc").read_text("utf-8"))


@pytest.mark.parametrize(("page", "language"), [("why.md", "en"), ("why.de.md", "de")])
def test_the_document_shows_what_the_commands_print(
    page: str, language: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The manual's ONCE, EDGE and nested ALWAYS: each output is that of the command before it."""
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("NCTAKT_LANGUAGE", language)
    found = blocks(page)
    commands = [i for i, (language, _) in enumerate(found) if language == "sh"]
    assert len(commands) == 2
    for i in commands:
        program, *words = found[i][1].split()
        assert program == "nctakt"
        assert main(words) == 0
        assert capsys.readouterr().out == found[i + 1][1]


def test_the_python_of_the_document_runs(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """X > 100 in line 7 is not asked for; the data of each branch are there."""
    monkeypatch.chdir(ROOT)
    (code,) = [text for language, text in blocks() if language == "python"]
    exec(compile(code, "why.md", "exec"), {"Controller": Controller})
    shown = capsys.readouterr().out.splitlines()
    assert shown[5] == "  line 4  $IF ONCE V.RTA.ACS.ACT_POS.X > 200"
    assert shown[-5] == "4 1 None"

# SPDX-License-Identifier: MIT
"""``#ERROR`` around the run: texts of its file, reset and restart, diagnosis data, log."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import nctakt
from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.results.report import DiagnosisReport, DiagnosisSink
from nctakt.run.controller import Controller, NcText

DEMO = Path(nctakt.__file__).parent / "machines" / "demo"

TEXTS = """\
# the texts of this machine
455\tdoor is open

20 tool is worn
no number
1001 beyond the last ID
"""

PROGRAM = '#ERROR [ID=455 RC=0 PV1=5 PV2=4.999 PM1=2 PM2=3]\n#ERROR [ID=20 RC={rc} PV1="T7"]\nM30'


@pytest.fixture
def machine(tmp_path: Path) -> Path:
    """The demo machine with texts of user errors."""
    folder = tmp_path / "machine"
    shutil.copytree(DEMO, folder)
    (folder / "user_errors.txt").write_text(TEXTS, "utf-8")
    startup = folder / "hochlauf.lis"
    entry = "error_text_user_of_id ./user_errors.txt\n"
    startup.write_text(entry + startup.read_text("utf-8"), "utf-8")
    return folder


def program(rc: int = 2) -> NcText:
    """A program that warns, then raises an error with this RC."""
    return NcText("part.nc", PROGRAM.format(rc=rc))


def test_diagnostics_have_the_texts_of_the_file(machine: Path) -> None:
    """P-STUP-00169: the text of the ID, then RC and the values in the order of the program."""
    run = Controller(machine).run(program())
    assert [(one.id, one.text("en")) for one in run.diagnostics][-2:] == [
        (900463, "user warning 455: door is open (RC = 0, PV1 = 5, PV2 = 4.999, PM1 = 2, PM2 = 3)"),
        (900464, "user error 20: tool is worn (RC = 2, PV1 = T7)"),
    ]
    assert run.state == "error"
    assert [(one.identity, one.reaction) for one in run.user_errors] == [(455, 0), (20, 2)]


def test_lines_that_are_no_texts_are_reported(machine: Path) -> None:
    """Each line is a number from 1 to 1000 and a text; others are left out with a warning."""
    controller = Controller(machine)
    assert controller.machine.user_texts == {455: "door is open", 20: "tool is worn"}
    found = [(one.id, one.values["line"]) for one in controller.diagnostics if one.id == 900468]
    assert found == [(900468, 5), (900468, 6)]


def test_a_file_that_is_not_there_is_a_warning(machine: Path) -> None:
    """User errors are reported without texts then."""
    (machine / "user_errors.txt").unlink()
    controller = Controller(machine)
    assert 296010 in [one.id for one in controller.diagnostics]
    run = controller.run(program())
    assert run.errors[-1].text("en") == "user error 20 (RC = 2, PV1 = T7)"


def test_a_reset_clears_an_error_of_the_user() -> None:
    """RC-402: RC from 1 to 6 is an error until the reset; then programs run again."""
    for rc in (1, 2, 6):
        controller = Controller()
        assert controller.run(program(rc)).state == "error"
        assert controller.state == "error"
        controller.reset()
        assert controller.state == "ready"
        assert controller.run(NcText("next.nc", "G00 X1\nM30")).state == "ended"


def test_only_a_restart_clears_a_fatal_error() -> None:
    """RC-402, RC 7: a reset leaves the error; no program can be started."""
    controller = Controller()
    run = controller.run(program(7))
    assert [one.id for one in run.errors] == [900465]
    controller.reset()
    assert controller.state == "error"
    with pytest.raises(Failure) as failure:
        controller.start(NcText("next.nc", "M30"))
    assert [one.id for one in failure.value.diagnostics] == [900466]


def test_errors_of_cycles_are_in_the_diagnosis_data() -> None:
    """RC-601: a warning at level 2, an error at level 1, both with their texts."""
    report = DiagnosisReport()
    text = "#RT CYCLE [ID=4 SCOPE=PROG]\n$IF ONCE TRUE\n#ERROR [ID=1 RC=0]\n#ERROR [ID=2 RC=1]\n"
    text += "$ENDIF\n#RT CYCLE END\nM30"
    run = Controller().run(NcText("part.nc", text), sinks=[DiagnosisSink(report)])
    lines = report.render(2, "en", run.diagnostics).splitlines()[-2:]
    assert lines == [
        "0           WARNING 900463: user warning 1 (RC = 0)",
        "0           ERROR   900464: user error 2 (RC = 1)",
    ]


def test_the_log_has_a_line_for_each(machine: Path, tmp_path: Path) -> None:
    """``nctakt run --error-log``: time, ID with text, values, place."""
    part, log = tmp_path / "part.nc", tmp_path / "errors.log"
    part.write_text(PROGRAM.format(rc=2), "utf-8")
    words = ["run", str(part), "--machine", str(machine), "--error-log", str(log)]
    assert main(words) == 1
    assert log.read_text("utf-8").splitlines() == [
        f"0 455: door is open [RC=0 PV1=5 PV2=4.999 PM1=2 PM2=3] {part}:1:1",
        f"0 20: tool is worn [RC=2 PV1=T7] {part}:2:1",
    ]

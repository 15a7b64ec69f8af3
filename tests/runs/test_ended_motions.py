# SPDX-License-Identifier: MIT
"""Motions that end with their realtime cycle (END_ACTION), and how that is reported (RC-110)."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.results.run import MotionCount, Run, SpindleJobCount
from nctakt.run.controller import Controller, NcText
from nctakt.session import Session

#: Z is sent to 900 mm at 100 mm/s; the program ends after 0.1 s, when it has gone some mm.
PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG{action}]
$IF ONCE 1
{commands}
$ENDIF
#RT CYCLE END
#TIME 0.1
{control}
M30
"""
FAR = "Z[INDP G01 G90 POS=900 FEED=6000]"


def perform(commands: str = FAR, action: str = "", control: str = "") -> Run:
    """Run a cycle that commands this once; ``control`` comes 0.1 s later."""
    text = PROGRAM.format(commands=commands, action=action, control=control)
    return Controller().run(NcText("part.nc", text), signals=["Z.ACS.CUR_POS"])


def reported(run: Run) -> list[str]:
    """The notes, without their numbers."""
    return [one.text() for one in run.diagnostics if one.id == 902001]


def test_a_motion_that_the_programs_end_cuts_off_is_reported() -> None:
    """MOVE_ABORT is the default: the axis brakes, and the note says how far it did not come."""
    run = perform()
    (note,) = run.diagnostics
    assert run.trace is not None
    position = run.trace["Z.ACS.CUR_POS"][-1]
    assert 5.0 < position < 15.0  # about 0.1 s at 100 mm/s
    left = f"{900.0 - position:.4g}"
    assert reported(run) == [
        f"Z stopped {left} mm before its target: realtime cycle 1 ended (MOVE_ABORT)"
    ]
    assert note.span is not None
    assert (note.severity.name, note.span.line, note.remedy()[:25]) == (
        "NOTE",
        3,
        "END_ACTION=MOVE_CONT lets",
    )


@pytest.mark.parametrize(
    ("commands", "action", "control", "expected"),
    [
        (FAR, " END_ACTION=MOVE_ABORT", "", []),  # who writes it knows
        (FAR, " END_ACTION=MOVE_CONT", "", []),
        ("Z[INDP G00 G90 POS=1]", "", "", []),  # long there
        (FAR, "", "#RT CYCLE DELETE [ID=1]", ["was deleted"]),
        (FAR, "", "#RT CYCLE ABORT ACTION [ID=1]\n#TIME 0.1", []),  # somebody has asked for it
        ("Z[INDP G01 FEED=600]", "", "", ["stopped during an endless motion"]),
        (
            f"{FAR}\nZ[INDP BUFFERED G01 G90 POS=10 FEED=60]",
            "",
            "",
            ["Z did not begin its waiting motion", "before its target"],
        ),
        ("A[INDP G01 G90 POS=90 FEED=600]", "", "", ["° before its target"]),
        (f"{FAR}\nV.E.VALUE = 1 / V.E.VALUE", "", "", []),  # the error is reported
    ],
)
def test_what_is_reported_and_what_is_not(
    commands: str, action: str, control: str, expected: list[str]
) -> None:
    """A note for what ends in silence, none where somebody has asked for it or knows already."""
    found = reported(perform(commands, action, control))
    assert len(found) == len(expected)
    assert all(words in text for text, words in zip(found, expected, strict=True))


def test_an_axis_that_is_taken_over_while_it_brakes_is_not_reported() -> None:
    """A GLOBAL cycle sends Z elsewhere in the tick in which the other one is deleted."""
    text = """\
#RT CYCLE [ID=2 SCOPE=GLOBAL END_ACTION=MOVE_CONT]
$IF EDGE V.E.CONDITION == 1
Z[INDP G01 G90 POS=2 FEED=6000]
$ENDIF
#RT CYCLE END
#RT CYCLE [ID=1 SCOPE=PROG]
$IF ONCE 1
Z[INDP G01 G90 POS=900 FEED=6000]
$ENDIF
#RT CYCLE END
#TIME 0.1
#RT CYCLE DELETE [ID=1]
V.E.CONDITION = 1
#TIME 1
#RT CYCLE DELETE [ID=2]
M30
"""
    assert reported(Controller().run(NcText("part.nc", text))) == []


def test_a_place_is_reported_once() -> None:
    """A BLOCK cycle in a loop ends with each block."""
    text = """\
$FOR P1 = 1, 3, 1
#RT CYCLE [SCOPE=BLOCK]
$IF ONCE 1
Z[INDP G01 G90 POS=900 FEED=6000]
$ENDIF
#RT CYCLE END
#TIME 0.05
#TIME 0.2
$ENDFOR
M30
"""
    assert len(reported(Controller().run(NcText("part.nc", text)))) == 1


def test_motions_and_jobs_are_counted() -> None:
    """The summary has lines for them, as for functions; M3 of the program is apart."""
    commands = f"{FAR}\nY[INDP G00 G90 POS=1]\nS2[M3 REV=500]"
    run = perform(commands, control="M3 S100\nM5")
    assert run.motions == (
        MotionCount("Z", is_realtime=True, count=1, done=0, first_tick=0),
        MotionCount("Y", is_realtime=True, count=1, done=1, first_tick=0),
    )
    assert [(one.spindle, one.function, one.is_realtime) for one in run.spindle_jobs] == [
        ("S2", "M3", True),
        ("S", "M3", False),
        ("S", "M5", False),
    ]
    assert run.spindle_jobs[0] == SpindleJobCount("S2", "M3", True, 1, 0)


@pytest.mark.parametrize("command", ["run", "why"])
def test_both_commands_and_the_session_tell_it(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A note is shown where the motion is asked for."""
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM.format(commands=FAR, action="", control=""), "utf-8")
    assert main([command, str(file)]) == 0
    shown = capsys.readouterr()
    assert "part.nc:3:1: note 902001: Z stopped" in shown.err
    if command == "run":
        (line,) = (line for line in shown.out.splitlines() if line.startswith("Z "))
        assert line.split()[:5] == ["Z", "realtime", "cycle", "1", "0"]
    with Session(file) as session:
        assert [one.id for one in session.run().diagnostics] == [902001]

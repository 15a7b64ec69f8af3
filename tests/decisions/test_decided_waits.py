# SPDX-License-Identifier: MIT
"""Decisions on programs that wait: messages to the user, and their times."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from support.decided import numbers, perform, reported

import nctakt
from nctakt.cli import main
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

DEMO = Path(nctakt.__file__).parent / "machines" / "demo"

#: At 1000 revolutions a minute 0.1 mm each: 100 mm/min, X10 takes 6 s. Tick 3000: a cycle's M5.
STOPPED = """\
#RT CYCLE [ID=1 SCOPE=PROG]
$IF EDGE V.E.VALUE == 1
M5
$ENDIF
$IF EDGE V.E.VALUE == 2
M3 S1000
$ENDIF
#RT CYCLE END
M3 S1000
G95 F0.1
N40 G01 X10
M30
"""


def test_a_path_that_waits_for_its_spindle_says_so_and_goes_on() -> None:
    """MO-4, G95: 900819 in the tick in which the path stops, once; it continues with the spindle.

    The spindle brakes from 6000 °/s with 36000 °/s²: M5 in tick 3000 leads to a standstill after
    tick 3166. The path reads it in tick 3167."""
    stimuli = [
        Stimulus("3 s", "V.E.VALUE", 1.0),
        Stimulus("5 s", "V.E.VALUE", 2.0),
    ]
    run = perform(STOPPED, at=stimuli, signals=["PATH.SPEED", "X.ACS.ACT_POS"])
    assert run.state == "ended"
    assert reported(run, "warning") == ["3167 warning 900819"]
    assert run.diagnostics[-1].span is not None
    assert (numbers(run), run.diagnostics[-1].span.line) == ([900819], 11)
    assert run.trace is not None
    assert run.trace["PATH.SPEED"][3166] > 0.0 == run.trace["PATH.SPEED"][3167]
    assert run.trace["X.ACS.ACT_POS"][-1] == 10.0


def test_each_standing_is_reported_once() -> None:
    """The spindle stops, turns and stops again: two warnings; the limit reports what is awaited."""
    stimuli = [Stimulus(time, "V.E.VALUE", value) for time, value in ((1, 1.0), (2, 2.0), (3, 1.0))]
    run = perform(STOPPED, at=stimuli, ticks=5000)
    assert (run.state, numbers(run)) == ("limit", [900819, 900819, 900820])
    assert "spindle S to turn" in run.diagnostics[-1].text("en")
    advice = "Let it turn (M3 or M4 with S), or feed per minute (G94). Another limit"
    assert run.diagnostics[-1].remedy().startswith(advice)


def test_a_spindle_that_begins_to_turn_with_the_block_is_no_standing() -> None:
    """M3 before the block: in its first tick the spindle does not turn yet; no warning."""
    assert numbers(perform("M3 S1000\nG95 F0.1\nG01 X0.1\nM30")) == []


def test_hold_and_override_are_reported_in_their_own_names() -> None:
    """What the operator stops is no waiting for the spindle."""
    held = Stimulus("1 s", "HLI.FEED_HOLD", 1.0)
    stopped = Stimulus("1.5 s", "V.E.VALUE", 1.0)
    run = perform(STOPPED, at=[held, stopped], ticks=3000)
    assert numbers(run) == [900820]
    assert "feed hold" in run.diagnostics[-1].text("en")


@pytest.mark.parametrize(
    ("program", "initial", "line", "words"),
    [
        ("G00 X1\nN20 M00\nG00 X2\nM30", {}, 2, "START after M00 or M01"),
        ("G00 X1\nM01\nM30", {"HLI.OPTIONAL_STOP": 1.0}, 2, "START after M00 or M01"),
        ("G00 X1\nG00 X2\nM30", {"HLI.SINGLE_BLOCK": 1.0}, 2, "START in single block mode"),
        ("M00\nG00 X1\nM30", {"HLI.FEED_HOLD": 1.0}, 1, "START after M00"),
        ("G00 X1\nM30", {"HLI.FEED_HOLD": 1.0}, 1, "the end of the feed hold"),
        ("#TIME 1\nM30", {"HLI.FEED_HOLD": 1.0}, 1, "the end of the feed hold"),
        ("G00 X1\nM30", {"HLI.OVERRIDE": 0.0}, 1, "the operator's override is 0 %"),
        (
            "#RT CYCLE [ID=1]\nV.RTG.OVERRIDE.VEL.CYCLE = 0\n#RT CYCLE END\nG00 X1\nM30",
            {},
            4,
            "a realtime cycle sets V.RTG.OVERRIDE.VEL.CYCLE to 0 %",
        ),
        (
            "#RT CYCLE [ID=1 SCOPE=BLOCK END_ACTION=MOVE_CONT]\n"
            "X[INDP G01 G90 POS=100 FEED=600]\n#RT CYCLE END\n"
            "#TIME 0.002\nG00 X5\nM30",
            {},
            5,
            "axis X, which moves independently",
        ),
    ],
)
def test_at_the_limit_a_run_says_what_it_waits_for(
    program: str, initial: dict[str, float | str], line: int, words: str
) -> None:
    """One note (900820) names the block and what holds it up, whatever it is."""
    run = perform(program, set=initial, ticks=500)
    note = run.diagnostics[-1]
    assert (run.state, note.id) == ("limit", 900820)
    assert words in note.text("en")
    assert note.span is not None
    assert note.span.line == line


def test_functions_wait_for_a_plc_that_never_acknowledges() -> None:
    """A PLC that does nothing: M115 waits for its acknowledgement."""

    class Silent:
        def cycle(self, interface: object) -> None:
            """It never acknowledges."""

    run = perform("M112\nG00 X1\nM30", plc=Silent(), ticks=50)
    assert numbers(run) == [900820]
    assert "the PLC's acknowledgement of M112" in run.diagnostics[-1].text("en")


def test_a_selected_program_waits_for_start() -> None:
    """With ``--wait-for-start`` and nobody who presses it: the note has no block."""
    run = Controller().run(NcText("part.nc", "M30"), wait_for_start=True, ticks=10)
    assert numbers(run) == [900820]
    assert "START of the selected program" in run.diagnostics[-1].text("en")


def test_a_run_that_is_at_work_at_its_limit_says_nothing() -> None:
    """A motion, a dwell: the limit alone has ended it."""
    for program in ("G01 X100 F100\nM30", "#TIME 5\nM30"):
        assert numbers(perform(program, ticks=100)) == []


@pytest.mark.parametrize(
    ("program", "words"),
    [
        ("M3 S5\nG00 X1 M19 S.POS=180\nG00 X2\nM30", "speed or position of spindle S"),
        ("G00 X1\nS3[M3 REV=500]\nG00 X2\nM30", "acknowledgement of the job of spindle S3"),
    ],
)
def test_spindles_are_waited_for(program: str, words: str, tmp_path: Path) -> None:
    """At 5 revolutions a minute half of one takes 6 s; the PLC takes 100 s for its spindle."""
    lines = ["m19_synch MVS_SNS", "m3_synch MVS_SVS", "m3_prozess_zeit 100000000"]
    shutil.copytree(DEMO, tmp_path / "machine")
    file = tmp_path / "machine" / "sda_mds1.lis"
    kept = [
        line
        for line in file.read_text("utf-8").splitlines()
        if not line.startswith(("spindel[0].m19_synch", "spindel[2].m3_"))
    ]
    added = [f"spindel[{0 if 'm19' in line else 2}].{line}" for line in lines]
    file.write_text("\n".join([*added, *kept, ""]), "utf-8")
    run = perform(program, Controller(tmp_path / "machine"), ticks=500)
    assert (run.state, numbers(run)[-1]) == ("limit", 900820)
    assert words in run.diagnostics[-1].text("en")


@pytest.mark.parametrize(
    ("program", "initial", "remedy"),
    [
        ("G00 X1\nM00\nM30", {}, "--at TIME HLI.START=1 continues"),
        (
            "G00 X1\nG00 X2\nM30",
            {"HLI.SINGLE_BLOCK": 1.0},
            "--at TIME HLI.START=1 runs a block, --at TIME HLI.SINGLE_BLOCK=0 and a START all",
        ),
        ("G00 X1\nM30", {"HLI.FEED_HOLD": 1.0}, "--at TIME HLI.FEED_HOLD=0 ends it"),
        ("G00 X1\nM30", {"HLI.OVERRIDE": 0.0}, "--at TIME HLI.OVERRIDE=100 raises it"),
        (
            "M3 S100\nG95 F1\nG01 X1\nM30",
            {"HLI.S.OVERRIDE": 0.0},
            "Its override is 0 %: --at TIME HLI.S.OVERRIDE=100",
        ),
        (
            "G00 X1\n#WAIT FOR V.E.CONDITION == 1\nM30",
            {},
            "Give a variable of the condition another value (--at TIME NAME=VALUE), or let a "
            "realtime cycle or the PLC do so",
        ),
    ],
)
def test_each_reason_has_its_remedy(
    program: str, initial: dict[str, float | str], remedy: str
) -> None:
    """900820 advises what is true for the reason, and that alone."""
    found = perform(program, set=initial, ticks=500).diagnostics[-1]
    assert found.id == 900820
    assert found.remedy() == f"{remedy}. Another limit: --until, --ticks."
    assert found.remedy("de")


#: X is at the first position beyond 50 mm, V.E.CONDITION holds it there.
HELD = """\
#RT CYCLE [ID=7]
$IF V.RTA.ACS.ACT_POS.X > 50 && V.E.CONDITION == 0
{frequency}V.RTG.OVERRIDE.VEL.CYCLE = {first}
{end}$ENDIF
#RT CYCLE END
G01 X100 F6000
M30
"""


def test_the_line_that_holds_the_path_is_named() -> None:
    """RC-305: the last write of the tick counts; the branch around it, and what that reads."""
    text = HELD.format(frequency="V.RTG.OVERRIDE.VEL.CYCLE = 50\n", first=0, end="")
    found = perform(text, ticks=2000).diagnostics[-1]
    assert found.text().endswith(
        "sets V.RTG.OVERRIDE.VEL.CYCLE to 0 % in line 4 of cycle 7, under "
        "$IF V.RTA.ACS.ACT_POS.X > 50 && V.E.CONDITION == 0 in line 2"
    )
    remedy, _ = found.remedy().split(". Another limit")
    held, position, condition = remedy.replace("; now ", ", ", 1).split(", ")
    assert held == "It is held as long as line 2 runs"
    assert position.startswith("V.RTA.ACS.ACT_POS.X = 5")
    assert condition == "V.E.CONDITION = 0; from outside: --at TIME V.E.CONDITION=VALUE"
    freed = perform(text, at=[Stimulus("1.5 s", "V.E.CONDITION", 1.0)], ticks=4000)
    assert (freed.state, numbers(freed)) == ("ended", [])


def test_a_line_of_another_file_is_named_with_its_file(tmp_path: Path) -> None:
    """The path is in part.nc, the cycle is defined in the subprogram hold.nc."""
    cycle, rest = HELD.format(frequency="", first=0, end="").split("G01 X100", 1)
    (tmp_path / "hold.nc").write_text(f"{cycle}M17\n", "utf-8")
    part = tmp_path / "part.nc"
    part.write_text(f"L hold.nc\nG01 X100{rest}", "utf-8")
    found = Controller().run(part, ticks=2000).diagnostics[-1]
    other = (tmp_path / "hold.nc").as_posix()
    assert f"to 0 % in {other}:3 of cycle 7, under $IF V.RTA" in found.text()
    assert f"== 0 in {other}:2" in found.text()
    assert found.remedy().startswith(f"It is held as long as {other}:2 runs; now ")
    assert found.remedy("de").startswith(f"Es wird gehalten, solange {other}:2 läuft; ")


def test_a_latched_branch_is_no_way_out() -> None:
    """RC-203: what ALWAYS has begun goes on, so only the branch around it can end it."""
    inner = {"frequency": "$IF ALWAYS V.E.VALUE == 0\n", "first": 0, "end": "$ENDIF\n"}
    found = perform(HELD.format(**inner), ticks=2000).diagnostics[-1]
    assert "in line 2 and $IF ALWAYS V.E.VALUE == 0 in line 3" in found.text()
    assert found.remedy().startswith("It is held as long as line 2 runs; now ")
    alone = HELD.format(**inner).replace("$IF V.RTA", "$IF ALWAYS V.RTA")
    found = perform(alone, ticks=2000).diagnostics[-1]
    assert found.remedy().startswith(
        "It is held as long as cycle 7 runs: nothing in it ends what line 4 does. "
    )


def test_an_axis_that_a_cycle_holds_is_reported_as_the_path() -> None:
    """V.RTA.OVERRIDE.VEL.CYCLE of an axis that the path waits for (RC-409)."""
    text = """\
#RT CYCLE [ID=1]
$IF ONCE 1
Z[INDP G01 G90 POS=100 FEED=6000]
$ENDIF
$IF V.RTA.ACS.ACT_POS.Z > 5
V.RTA.OVERRIDE.VEL.CYCLE.Z = 0
$ENDIF
#RT CYCLE END
#TIME 0.2
G01 Z20 F600
M30
"""
    found = perform(text, ticks=1000).diagnostics[-1]
    assert "axis Z, stopped by an override of 0 % in line 6 of cycle 1" in found.text()
    assert found.remedy().startswith("It is held as long as line 5 runs; now V.RTA.ACS.ACT_POS.Z")


@pytest.mark.parametrize(
    ("program", "limit", "found", "code"),
    [
        ("G00 X1\nM00\nM30", [], "error 902000", 1),
        ("G00 X1\nM00\nM30", ["--until", "0.5"], "note 900820", 0),
        (HELD.format(frequency="", first=0, end=""), [], "error 902000", 1),
        ("M3 S1 M19 S.POS=180\nM30", [], "", 0),
        ("$WHILE 1\nG01 X1 F600\nX0\n$ENDWHILE\nM30", [], "", 0),
    ],
)
def test_a_program_that_waits_forever_is_an_error(
    program: str,
    limit: list[str],
    found: str,
    code: int,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Where nobody has set a limit, here 2 s instead of 600; what moves has only not ended yet."""
    monkeypatch.setattr("nctakt.run.program_run.DEFAULT_LIMIT_US", 2_000_000)
    file = tmp_path / "part.nc"
    file.write_text(program, "utf-8")
    assert main(["run", str(file), *limit]) == code
    told_there = capsys.readouterr().err
    assert found in told_there
    assert bool(found) == (" waiting for " in told_there)

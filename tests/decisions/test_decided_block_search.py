# SPDX-License-Identifier: MIT
"""Block search: --from-line, --from-block, #BLOCKSEARCH; docs/conformance/backward.md."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.decided import numbers, perform, reported
from support.polylines import Points, apart, way
from support.random_seeds import MANY

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.launch import read_configuration
from nctakt.results.run import Run
from nctakt.run.controller import Controller
from nctakt.run.program_loader import NcText
from nctakt.session.session import Session

PROGRAM = """%MAIN
N10 G00 X10 Y20
N20 M3 S500
N30 V.P.COUNT = 3
N40 G92 X1
N50 G01 X50 F6000
N60 $FOR P1 = 0, 2, 1
N70 G91 Y5
N80 $ENDFOR
N90 #BLOCKSEARCH LOCKED
N100 G90 X55
N110 #BLOCKSEARCH LOCKED
N120 #BLOCKSEARCH RELEASED
N130 X60
N140 #MSG ["%f %f %f", V.A.ABS.X, V.A.ABS.Y, V.P.COUNT]
N150 M30
"""


@pytest.mark.parametrize("how", [{"from_line": 14}, {"from_block": 130}, {}])
def test_the_state_is_that_of_a_whole_run(how: dict[str, int]) -> None:
    """Positions, offsets, variables, spindles; loops are walked through."""
    run = perform(PROGRAM, **how)
    assert [one.text for one in run.messages] == ["61.000000 35.000000 3.000000"]
    assert [text.partition(" ")[2] for text in reported(run, "spindle")] == ["spindle S M3 500"]
    assert numbers(run) == ([901731] if how else [])


def test_the_axes_go_straight_to_the_start_of_the_block() -> None:
    """From 0 to X51 + 4, Y35 at rapid traverse, then with the feed of the program."""
    run = perform(PROGRAM, from_line=14, signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"])
    axes = (run.trace[f"{axis}.ACS.ACT_POS"].tolist() for axis in "XY")
    rows = list(zip(*axes, strict=True))
    approach = [(x, y) for x, y in rows if y < 35.0]
    assert len(approach) > 50
    assert all(x * 35.0 == pytest.approx(y * 56.0, abs=1e-6) for x, y in approach)
    assert rows[-1] == (61.0, 35.0)


def test_functions_messages_and_cycles_before_it() -> None:
    """M and H functions and messages are left out; realtime cycles run, those of a block do not."""
    cycle = "#RT CYCLE [ID={0} SCOPE={1}]\nV.E.COUNT += 1\n#RT CYCLE END\n"
    program = f'M100\n#MSG ["no"]\n{cycle.format(1, "BLOCK")}G04 X1\n#MSG ["yes"]\nM30'
    run = perform(program, from_line=7)
    assert reported(run, "output", "created") == []
    assert [one.text for one in run.messages] == ["yes"]
    program = f"{cycle.format(1, 'PROG')}G04 X1\nG04 X0.01\nM30"
    assert len(reported(perform(program, from_line=5), "created")) == 1


def test_what_it_cannot_pass() -> None:
    """21399 in a locked part, 50717 for G74, 901730 for a block that is not reached."""
    assert numbers(perform(PROGRAM, from_block=100)) == [21399]
    assert numbers(perform("G74 X1\nG01 X1 F100\nM30", from_line=2)) == [50717]
    assert numbers(perform(PROGRAM, from_line=99)) == [901730]
    assert numbers(perform("G01 X1 F100\nM30", from_block=7)) == [901730]


def test_a_subprogram_called_in_a_locked_part_is_locked() -> None:
    """207611019: subprograms included; a second LOCKED changes nothing."""
    text = "%L SUB\nN5 G91 X1 F6000\nM17\n%MAIN\n#BLOCKSEARCH LOCKED\nLL SUB\n"
    text += "#BLOCKSEARCH RELEASED\nLL SUB\nM30\n"
    assert numbers(perform(text, from_line=2)) == [21399]
    assert perform(text).state == "ended"


def test_a_wrong_start_is_reported() -> None:
    """Types, both places at once."""
    with pytest.raises(Failure, match="901732"):
        Controller().run("x.nc", from_line=1, from_block=1)
    with pytest.raises(Failure):
        Controller().run("x.nc", from_line=0)


@pytest.mark.nightly
@pytest.mark.slow
def test_a_session_begins_there_and_goes_back(tmp_path: Path) -> None:
    """The session of a tape, one of its own, and the tape that it saves."""
    first, second = tmp_path / "first.tape", tmp_path / "second.tape"
    with Session(NcText("part.nc", PROGRAM), from_block=130) as session:
        session.run()
        assert [one.text for one in session.result().messages] == ["61.000000 35.000000 3.000000"]
        session.save(first)
        session.go_to(3)
        session.write({"HLI.OVERRIDE": 50.0})
        last = session.run().tick
        session.save(second)
    with Session.of_tape(second) as session:
        assert session.run().tick == last
        assert session.read("V.RTA.ACS.ACT_POS.X", "V.RTA.ACS.ACT_POS.Y") == [61.0, 35.0]
        assert numbers(session.result()) == [901731]
    assert main(["replay", str(first)]) == 0
    with pytest.raises(Failure, match="901732"):
        Session(NcText("part.nc", PROGRAM), from_line=1, from_block=1)


def test_a_debugger_may_begin_there(tmp_path: Path) -> None:
    """The launch configuration has fromLine and fromBlock."""
    (tmp_path / "part.nc").write_text(PROGRAM)
    words = {"program": "part.nc", "cwd": str(tmp_path), "fromBlock": 130}
    configuration = read_configuration(Arguments(words), ())
    options = configuration.options
    assert (options.get("from_line"), options.get("from_block")) == (None, 130)


def test_measuring_before_it_is_an_error() -> None:
    """50718, for G310 as well; a block that is skipped does not measure."""
    for text in ("G100 X10 F600", "#MEAS MODE [5]\nG310 G01 X10 F600 $GOTO[A]"):
        assert numbers(perform(f"{text}\n[A] X1\nX2\nM30", from_line=text.count("\n") + 3)) == [
            50718
        ]
    assert numbers(perform("/G100 X10 F600\nG01 X1 F600\nM30", from_line=2, skip=[1])) == [901731]


def test_compensated_contours_begin_with_the_way_to_the_start() -> None:
    """G41 in force there leads to the contour from where the tool is."""
    text = "V.G.WZ_AKT.R = 5\nG41 G01 X10 Y0 F6000\nX20\nX30\nG40 Y50\nM30"
    run = perform(text, from_line=4, signals=["Y.ACS.ACT_POS"])
    assert run.state == "ended", run.diagnostics
    assert any(abs(y - 5.0) < 1e-9 for y in run.trace["Y.ACS.ACT_POS"].tolist())


_WORDS = st.sampled_from(
    ["X10", "Y-5 Z3", "G91", "G90", "G92 X2", "G54", "G53", "G70", "G71", "D1", "D0", "P1 = P1 + 1",
     "XP1", "G02 X5 Y5 I2 J1 F6000", "G01 F6000", "G00", "G99 X900", "#CS ON [1, 2, 3, 0, 0, 90]",
     "#CS OFF", "G01 Z1 F6000"]
)  # fmt: skip


@settings(max_examples=200 if MANY else 6, deadline=None)
@given(st.lists(_WORDS, min_size=3, max_size=12), st.data())
def test_any_block_ends_the_program_where_it_ends(words: list[str], data: st.DataObject) -> None:
    """A run from any line of a program without branches has the positions of the whole run."""
    text = "\n".join([*words, '#MSG ["%f %f %f %f", V.A.ABS.X, V.A.ABS.Y, V.A.ABS.Z, P1]', "M30"])
    whole = perform(text)
    if whole.state != "ended":
        return
    line = data.draw(st.integers(1, len(words)))
    run = perform(text, from_line=line)
    assert [one.text for one in run.messages] == [one.text for one in whole.messages]


def test_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """--from-line, --from-block, and a tape of it."""
    program, tape = tmp_path / "part.nc", tmp_path / "run.tape"
    program.write_text(PROGRAM)
    arguments = ["run", str(program), "--lang", "de", "--from-line", "14", "--record", str(tape)]
    assert main(arguments) == 0
    shown = capsys.readouterr()
    assert "61.000000 35.000000 3.000000" in shown.out
    assert "das Programm beginnt bei Zeile 14" in shown.err
    assert main(["replay", str(tape)]) == 0
    assert "61.000000 35.000000 3.000000" in capsys.readouterr().out
    assert main(["run", str(program), "--from-line", "1", "--from-block", "10"]) == 2
    assert "901732" in capsys.readouterr().err


COUNTING = """#RT CYCLE{0} [ID=1 SCOPE=BLOCK]
$IF ONCE 1
V.E.COUNT += 1
$ENDIF
#RT CYCLE END
"""


def test_a_defined_block_cycle_can_be_started_after_the_start_block() -> None:
    """Manual 2.3.1: DEF defines it for the whole program, each START arms it for one block."""
    text = (
        COUNTING.format(" DEF")
        + "#RT CYCLE START [ID=1]\nG00 X10\nX20\n#RT CYCLE START [ID=1]\nX30\nM30"
    )
    for line, expected in ((6, 2), (7, 2), (8, 1), (9, 1), (10, 1), (11, 0)):
        controller = Controller()
        run = perform(text, controller, from_line=line)
        assert (run.state, numbers(run)) == ("ended", [901731]), line
        assert controller.read("V.E.COUNT") == expected, line


@pytest.mark.parametrize("line", [2, 7, 8])
def test_a_block_cycle_runs_in_its_block_not_on_the_way_to_it(line: int) -> None:
    """RC-105: only where its block runs: from Y20 on, where the search begins at that block."""
    text = "G00 X10\n" + COUNTING.format("") + "Y20\nY30\nM30"
    text = text.replace("ONCE 1", "ONCE V.RTA.ACS.ACT_POS.X < 10")
    controller = Controller()
    run = perform(text, controller, from_line=line)
    assert controller.read("V.E.COUNT") == 0
    assert len(reported(run, "created")) == (line < 8)
    assert len(reported(run, "ended")) == (line < 8)


def test_a_cycle_held_before_its_block_is_held_in_it() -> None:
    """RC-111: HOLD and CONTINUE before the start block come after the definition."""
    text = COUNTING.format("") + "#RT CYCLE HOLD [ID=1]\n{0}G00 X10\nX20\nM30"
    for control, expected in (("", 0), ("#RT CYCLE CONTINUE [ID=1]\n", 1)):
        controller = Controller()
        program = text.format(control)
        run = perform(
            program, controller, from_line=program[: program.index("G00")].count("\n") + 1
        )
        assert (run.state, controller.read("V.E.COUNT")) == ("ended", expected)


_POINTS = "#SPLINE ON\nG01 X10 Y0 F600\nX20 Y10\nX30 Y0\nX40 Y10\nX50 Y0\n#SPLINE OFF\nX60\nM30"
SHAPED = {
    "akima": _POINTS,
    "bspline": f"#SPLINE TYPE BSPLINE\n{_POINTS}",
    "corners": "G01 X10 F600\nG302 I2\nY10 #CHR=1\nX30\nY20\nM30",
    "contour": "V.G.WZ_AKT.R = 2\nG41 G01 X10 Y0 F600\nX20\nY-10\nX10\nY10\nG40 X0 Y20\nM30",
    "curve": "#CONTOUR MODE [DIST PRE_DIST=2 POST_DIST=1]\nG61 G01 X10 F600\nY10\nX20\nY20\nM30",
    "tilted": "#CS ON [1, 2, 3, 30, 0, 20]\nG01 X10 Y0 F600\nG02 X20 I5\nG01 X30\n#CS OFF\nX0\nM30",
}


@pytest.mark.parametrize("name", SHAPED)
def test_the_way_from_any_block_is_that_of_the_whole_run(name: str) -> None:
    """Splines, chamfers, roundings, compensated and contoured corners (MO-4, MO-9, MO-18)."""
    axes = [f"{axis}.ACS.ACT_POS" for axis in "XYZ"]
    lines = SHAPED[name].count("\n")
    whole = perform(SHAPED[name], signals=axes, blocks=True)
    assert whole.state == "ended", whole.diagnostics
    for line in range(1, lines + 1):
        run = perform(SHAPED[name], signals=axes, blocks=True, from_line=line)
        assert run.state == "ended", (line, run.diagnostics)
        assert apart(_way_from(whole, line, axes), _way_from(run, line, axes)) < 0.02, line


def _way_from(run: Run, line: int, axes: list[str]) -> Points:
    """The way from the tick in which a block begins, and where the axes come from."""
    begin = next(
        one.tick for one in run.events if one.kind == "block" and one.span and one.span.line == line
    )
    return way(run, axes, max(0, begin - 2))


def test_axes_that_a_cycle_has_moved_stay_where_they_are() -> None:
    """RC-409: the program does not know the position of Y until its path moves it again."""
    cycle = "#RT CYCLE [ID=1]\n$IF ONCE 1\nY[INDP G90 G00 POS=50]\n$ENDIF\n#RT CYCLE END\n"
    run = perform(f"{cycle}G00 X10\nG04 X1\nX20\nM30", from_line=8, signals=["Y.ACS.ACT_POS"])
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    assert run.trace["Y.ACS.ACT_POS"][-1] == 50.0


def test_a_start_within_a_realtime_loop_is_refused_by_name() -> None:
    """901960: it is decoded as a whole."""
    text = "#RT WHILE\nG00 X10\nX0\n#RT ENDWHILE\nX5\nM30"
    assert numbers(perform(text, from_line=2)) == [901960]
    assert numbers(perform(text, from_line=5)) == [901731]


def test_a_value_of_now_before_it_is_reported() -> None:
    """901961, once for each place: positions of the axes are not those of the program."""
    text = "G00 X10\n$FOR P2 = 1, 3, 1\nP1 = V.RTA.ACS.ACT_POS.X\n$ENDFOR\nP3 = V.E.COUNT\nX20\nM30"
    assert numbers(perform(text, from_line=6)) == [901961, 901731]
    assert numbers(perform(text, from_line=3)) == [901731]


def test_timers_before_it_run() -> None:
    """RC-401: one that was started before counts from the search on."""
    text = "#TIMER START SYN [ID=1]\nG01 X1 F600\nG04 X0.05\n#TIMER READ SYN [ID=1]\n"
    run = perform(f'{text}#MSG ["%g", V.G.TIMER[1]]\nM30', from_line=3)
    assert run.state == "ended", run.diagnostics
    assert float(run.messages[0].text) >= 50

# SPDX-License-Identifier: MIT
"""``S[PUTAX]``, ``S[CALLAX]``: a spindle gives its axis to the path and takes it again.

Pages 208235275, 15557191819; IDs 60137, 60054.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from nctakt import machines
from nctakt.base.diagnostics import Severity
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

SIGNALS = ["X.ACS.ACT_POS", "S.SPEED", "S.POSITION", "BLOCK"]


@pytest.fixture(scope="module")
def lathe(tmp_path_factory: pytest.TempPathFactory) -> Machine:
    """The demo machine, whose main spindle turns the axis 5 in the mode 0x204."""
    folder = tmp_path_factory.mktemp("lathe") / "machine"
    shutil.copytree(Path(machines.__path__[0]) / "demo", folder)
    spindle = folder / "achs_mds5.lis"
    spindle.write_text(spindle.read_text("utf-8").replace("0x4 ", "0x204 "), "utf-8")
    return load_machine(folder)


def run_of(machine: Machine, *lines: str) -> Run:
    text = "\n".join([*lines, "M30"])
    return Controller(machine).run(NcText("t.nc", text), ticks=60_000, signals=SIGNALS)


def problems(run: Run) -> list[int]:
    return [one.id for one in run.diagnostics if one.severity is not Severity.NOTE]


def column(run: Run, name: str) -> np.ndarray:
    assert run.trace is not None
    return np.asarray(run.trace[name])


def test_the_public_example(lathe: Machine) -> None:
    """The axis turns as a spindle, moves to 40° and -40° as C of the path, and turns again."""
    run = run_of(
        lathe,
        "N10 S[CALLAX]",
        "N20 M03 S600",
        "N30 G04 X2",
        "N40 M05",
        "N50 S[PUTAX]",
        "N60 #CALL AX [C, 5, 4]",
        "N70 G01 F5000 X10 Y20 Z30 C40",
        "N80 X-10 Y-20 Z-30 C-40",
        "N90 #PUT AX [C]",
        "N100 S[CALLAX]",
        "N110 M04 S300",
        "N120 G04 X1",
        "N130 M05",
    )
    assert problems(run) == []
    speed, blocks = column(run, "S.SPEED"), column(run, "BLOCK")
    assert speed[blocks == 30][-1] == 600.0
    assert column(run, "S.POSITION")[blocks == 80][-1] == 320.0
    assert column(run, "X.ACS.ACT_POS")[blocks == 80][-1] == -10.0
    assert speed[blocks == 120][-1] == -300.0


@pytest.mark.parametrize(
    ("line", "number"),
    [
        ("M3 S100\nS[PUTAX]", 60137),
        ("S[PUTAX]\nM3 S100", 902720),
        ("S[PUTAX]\nM5", 902720),
        ("S[PUTAX]\n#CAX [S, C]", 902720),
        ("S2[PUTAX]\nS2[M4 REV300]", 902720),
        ("S[PUTAX]\n#RT CYCLE [ID=1]\nS[M3 REV100]\n#RT CYCLE END", 902720),
        ("S[PUTAX REV400]", 902721),
        ("S[CALLAX M5]", 902721),
        ("S[PUTAX CALLAX]", 902721),
        ("S3[PUTAX]", 902722),
        ("S[PUTAX]\n#CALL AX [C, 5, 4]\nS[CALLAX]", 901818),
        ("#CALL AX [C, 5, 4]", 901807),
        ("#RT CYCLE [ID=1]\nS[PUTAX]\n#RT CYCLE END", 50954),
    ],
)
def test_what_is_refused(lathe: Machine, line: str, number: int) -> None:
    assert problems(run_of(lathe, line)) == [number]


def test_a_cycle_turns_no_spindle_without_axis(lathe: Machine) -> None:
    """60331, for a cycle that was defined before."""
    cycle = "#RT CYCLE [ID=1]\n$IF ONCE V.RTA.ACS.ACT_POS.X > 5\nS[M3 REV100]\n$ENDIF"
    run = run_of(lathe, cycle, "#RT CYCLE END", "S[PUTAX]", "G01 X10 F6000")
    assert problems(run) == [60331]
    assert column(run, "S.SPEED").max() == 0.0


def test_what_changes_nothing(lathe: Machine) -> None:
    """PUTAX twice, CALLAX of a spindle that has its axis, and one that turns."""
    lines = ("S[PUTAX]", "S[PUTAX]", "S[CALLAX]", "S[CALLAX]", "M3 S60", "S[CALLAX]", "G04 X0.5")
    run = run_of(lathe, *lines)
    assert problems(run) == []
    assert column(run, "S.SPEED")[-1] == 60.0


def test_the_next_program_has_the_spindle_again(lathe: Machine) -> None:
    controller = Controller(lathe)
    lines = "S[PUTAX]\n#CALL AX [C, 5, 4]\nG01 C10 F6000\nM30"
    first = controller.run(NcText("a.nc", lines), ticks=2000, signals=SIGNALS)
    assert column(first, "S.POSITION")[-1] == 10.0
    second = controller.run(NcText("b.nc", "M3 S60\nG04 X0.1\nM30"), ticks=2000, signals=SIGNALS)
    assert problems(second) == []
    assert column(second, "S.SPEED")[-1] == 60.0


def test_a_block_search_does_not_exchange_axes(lathe: Machine) -> None:
    """As for ``#CALL AX``."""
    text = NcText("t.nc", "S[PUTAX]\nS[CALLAX]\nG01 X1 F600\nM30")
    assert problems(Controller(lathe).run(text, ticks=2000, from_line=3)) == [901809]

# SPDX-License-Identifier: MIT
"""Mistakes of the path that ``nctakt check`` finds: those of a run, and no others."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from nctakt.base.diagnostics import Severity
from nctakt.checking.check import check_files
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.assembly import AssembledMachine

#: Programs with one mistake each: its line and number, in a check and in a run.
WRONG = {
    "arc off its circle": ("G00 X0 Y0\nG02 X10 I3", 2, 20035),
    "centre is the start": ("G00 X0 Y0\nG02 X10 I0 J0", 2, 20036),
    "radius too small": ("G00 X0 Y0\nG03 X10 R4", 2, 20033),
    "radius too small, G163": ("G00 X0 Y0\nG163=4\nG03 X10", 3, 20033),
    "in inches": ("G70 G00 X0 Y0\nG02 X10 I3", 2, 20035),
    "relative": ("G00 X5 Y5\nG91 G02 X10 I3", 2, 20035),
    "absolute centre": ("G00 X0 Y0\nG161 G02 X10 I3 J0", 2, 20035),
    "another plane": ("G00 X0 Z0\nG18 G02 X10 I3", 2, 20035),
    "modal arc": ("G00 X0 Y0\nG02 X10 I5\nX20 I5\nX30 I1", 4, 20035),
    "many blocks of one shape": (
        "G00 X0 Y0\n" + "G01 X5\n" * 50 + "G01 X20\nG02 X30 I1",
        53,
        20035,
    ),
    "target": ("G00 X20000", 1, 120002),
    "target, negative": ("G01 X-10001 F1000", 1, 120003),
    "target of the same shape as one before": ("G00 X1\nG00 X2\nG00 X20000", 3, 120002),
    "relative target": ("G00 X9999\nG91 X2", 2, 120002),
    "target in inches": ("G70\nG00 X500", 2, 120002),
    "target of a single axis": ("G00 X5\nX[INDP_SYN G90 G00 POS=20000]", 2, 60158),
    "target of a single axis in inches": ("G70\nX[INDP_ASYN G90 G01 FEED=10 POS=500]", 2, 60158),
    "end of an oscillation": ("X[OSC ON 1ST_POS=0 2ND_POS=-20000 FEED=1000]", 1, 60159),
    "arc beyond a limit": ("G00 X9998 Y0\nG02 Y-10 J-5", 2, 120002),
    "in a branch": ("G00 X0 Y0\nP1 = 1\n$IF P1 == 1\nG02 X10 I3\n$ENDIF", 4, 20035),
    "behind branches that agree": (
        "P1 = 1\n$IF P1 == 1\nG00 X0 Y0\n$ELSE\nG00 X0 Y0\n$ENDIF\nG02 X10 I3",
        7,
        20035,
    ),
    "no feed in its mode": ("G00 X0\nG95 G01 X10", 2, 20008),
    "no feed in its mode, an arc": ("F500 G00 X0 Y0\nG194 G03 X10 I5", 2, 20008),
    "no feed in its mode, relative": ("G00 X5\nG91 G01 X0\nG95 X1\nX2", 3, 20008),
    "an axis given away": ("#PUT AX [X, Y]\nG00 Z1\nG00 Y5", 3, 901800),
    "all axes given away": ("#AX RELEASE ALL\nG00 Z1", 2, 901800),
    "a cycle's axis given away": (
        "#PUT AX [X]\n#RT CYCLE DEF [ID=1 SCOPE=PROG]\n$IF ONCE V.E.COUNT > 3\n"
        "X[INDP G90 POS=5]\n$ENDIF\n#RT CYCLE END",
        2,
        901800,
    ),
    "an axis that a cycle commands": (
        "#RT CYCLE [ID=1 SCOPE=PROG]\nX[INDP G90 G01 FEED=5000 POS=1]\n#RT CYCLE END\nG00 Y1\n"
        "G00 X5",
        2,
        50603,
    ),
    "an axis that a cycle of the block commands": (
        "G00 X0\n#RT CYCLE [ID=1 SCOPE=BLOCK]\nX[INDP FEED=5000]\n#RT CYCLE END\nG00 X5",
        3,
        50603,
    ),
    "in a local subprogram": (
        "%L SUB\nG90 G17 G162 G71 G00 X0 Y0\nG02 X10 I3 F9\nM17\n%MAIN\nLL SUB",
        3,
        20035,
    ),
}
CYCLE = "#RT CYCLE [ID=1 SCOPE=PROG]\n"
#: A cycle that commands its axis in each tick.
COMMANDED = "P1 = 1\n#RT CYCLE [ID=1 SCOPE=PROG]\nX[INDP G90 G01 FEED=5000 POS=1]\n#RT CYCLE END\n"
#: Programs that run, or whose mistake only a run can know.
UNKNOWN = (
    "G00 X0 Y0\nG02 X10 I4.9",
    "G02 X10 I3",
    "G00 X0 Y0\nX P1\nG02 X10 I3",
    "G00 X0 Y0\nG54\nG02 X110 Y50 I5",
    "D1\nG00 Z9990",
    "G92 X50\nG00 X10010",
    "#PSET X50\nG00 X10010",
    "G00 A720",
    "G00 X0 Y0\n/G00 X5\nG02 X10 I2.5",
    "G00 X0 Y0\nP1 = 1\n$IF P1 == 2\nG00 X50\n$ENDIF\nG02 X10 I30",
    "G00 X0 Y0\nG04 X0.1\nG02 X10 I5",
    "G91\nG02 X10 I3",
    "%L SUB\nG02 X10 I3\nM17\n%MAIN\nG00 X0 Y0",
    "G95 F1 G00 X0\nM3 S100 G01 X1",
    "G95 G01 X0",
    "G00 X0\n$IF P1 == 1\nG95 F1\n$ELSE\nG95 F2\n$ENDIF\nM3 S100 G01 X1",
    "#PUT AX [X]\n#CALL AX [X, 1, 0]\nG00 X1",
    "#PUT AX [X]\nP1 = V.RTA.ACS.ACT_POS.X",
    f"{COMMANDED}G00 X1",
    f"{COMMANDED}#RT CYCLE DELETE [ID=1]\nG00 X5",
    f"{COMMANDED}#RT CYCLE HOLD [ID=1]\nG00 X5",
    COMMANDED.replace("SCOPE=PROG", "SCOPE=BLOCK") + "G00 Y1\nG00 X5",
    COMMANDED.replace("[ID", "DEF [ID") + "G00 X5",
    COMMANDED.replace("X[", "$IF ONCE 1\nX[").replace("]\n#RT", "]\n$ENDIF\n#RT") + "G00 X5",
    "#RT CYCLE [SCOPE=PROG]\n$IF ONCE V.E.COUNT == 1\nX[INDP G90 POS=5]\n$ENDIF\n#RT CYCLE END\n"
    "G00 X0 Y0\nG02 X10 I3",
)


def errors(program: str, role: str = "") -> list[tuple[int, int]]:
    """Line and number of each error that a check of the program finds."""
    checked = check_files([NcText("p.nc", program)], AssembledMachine(load_machine(None)))
    found = [one.diagnostic for one in checked.findings]
    return [(one.span.line, one.id) for one in found if one.severity is Severity.ERROR and one.span]


@pytest.mark.parametrize("name", WRONG)
def test_what_a_run_would_refuse_is_found(name: str) -> None:
    """With the number and line of the run's error."""
    program, line, number = WRONG[name]
    assert errors(f"{program}\nM30\n") == [(line, number)]
    begin = "" if program.startswith("%") else "F1000\n"
    run = Controller().run(NcText("p.nc", f"{begin}{program}\nM30\n"))
    assert [one.id for one in run.errors] == [number]


@pytest.mark.parametrize("program", UNKNOWN)
def test_nothing_is_said_of_what_is_not_certain(program: str) -> None:
    """Values, offsets, skipped blocks, branches, realtime cycles, callers."""
    assert errors(f"{program}\nM30\n") == []


@pytest.mark.parametrize(
    ("program", "columns"),
    [
        ("M3 S6001", [5]),
        ("M3 S6000", []),
        ("S2[M4 REV=7000]", [11]),
        ("S7000 M5", [2]),
        ("S P1", []),
        ("G04 S7000", []),
        ("G18 G96 S7000 M3", []),
        ("G18 G96 S100\nS7000", []),
        ("G97 S7000", [6]),
        ("G18 G196 S7000", []),
        ("G112 S7000", []),
        ("#MAIN SPINDLE [S2]\nS7000", []),
        ("L CYCLE [NAME=x.nc]\nS7000", []),
        (f"{CYCLE}S7000 M3\n#RT CYCLE END", [2]),
        (f"{CYCLE}$IF V.E.COUNT == 0\n$ELSE\nS2[M4 REV=7000]\n$ENDIF\n#RT CYCLE END", [11]),
        (f"{CYCLE}S2[M3 REV=6000]\nS[M4 REV=V.E.COUNT + 1]\n#RT CYCLE END", []),
        (f"#MAIN SPINDLE [S2]\n{CYCLE}S7000 M3\n#RT CYCLE END", []),
    ],
)
def test_a_speed_beyond_the_spindle_is_a_warning(program: str, columns: list[int]) -> None:
    """P-AXIS-00212 of the demo machine's spindles: 6000 1/min; a run gives the same number."""
    checked = check_files(
        [NcText("p.nc", f"{program}\nM30\n")], AssembledMachine(load_machine(None))
    )
    found = [one.diagnostic for one in checked.findings if one.diagnostic.id == 900905]
    assert [one.span.column for one in found if one.span] == columns
    if columns:
        run = Controller().run(NcText("p.nc", f"{program}\nM30\n"))
        warnings = [one for one in run.diagnostics if one.id == 900905]
        assert [(one.span, one.text()) for one in warnings] == [
            (one.span, one.text()) for one in found
        ]


def test_the_first_block_with_feed_needs_one(tmp_path: Path) -> None:
    """P-CHAN-00099 is 0: the program has to give F before an axis moves with it (MO-17)."""
    shutil.copytree(DEMO_FOLDER, tmp_path / "machine")
    file = tmp_path / "machine" / "sda_mds1.lis"
    lines = file.read_text("utf-8").splitlines()
    kept = [line for line in lines if not line.startswith("prog_start.feedrate ")]
    file.write_text("\n".join(("prog_start.feedrate 0", *kept)), "utf-8")
    machine = load_machine(tmp_path / "machine")
    for program, expected in (
        ("G00 X5\nG01 X5\nX6\nX7", [3]),
        ("G00 X5\nG01 F100 X6", []),
        ("G00 X5\nF P1\nG01 X6", []),
        ("G00 X5\nG01 X5", []),
        ("G01 X6", []),
        ("G00 X5\nG04 1\n$IF P1 > 3\nF100\n$ENDIF\nG01 X6", []),
    ):
        text = NcText("p.nc", f"P1 = 5\n{program}\nM30\n")
        found = [one.diagnostic for one in check_files([text], AssembledMachine(machine)).findings]
        lines = [one.span.line - 1 for one in found if one.id == 20008 and one.span]
        assert lines == expected, program
        run = Controller(machine).run(text)
        assert not lines or [one.id for one in run.errors] == [20008]


def test_a_file_that_ends_as_a_subprogram_may_begin_anyhow() -> None:
    """G91 or another plane may be its caller's."""
    assert errors("G00 X0 Y0\nG02 X10 I3\nM17\n") == []


def test_long_programs_are_not_followed() -> None:
    """Above 5,000 lines only a run reports it; the check stays fast."""
    program = "G00 X0 Y0\n" + "G01 X5 Y1\n" * 5000 + "G00 X20000\nM30\n"
    assert errors(program) == []


def test_a_program_that_ends_as_a_subprogram_is_noted(tmp_path: Path) -> None:
    """M29 and M17 in a file that the user names and nobody calls; in a run an error (20376)."""
    machine = AssembledMachine(load_machine(None))
    main, sub = tmp_path / "main.nc", tmp_path / "sub.nc"
    main.write_text("L sub.nc\nM30\n", "utf-8")
    sub.write_text("G00 X1\nM29\n", "utf-8")

    def notes(*paths: Path) -> list[tuple[str, int]]:
        found = check_files(list(paths), machine).findings
        return [(Path(one.file).name, one.diagnostic.id) for one in found]

    assert notes(sub) == [("sub.nc", 901076)]
    assert notes(main, sub) == []
    assert notes(tmp_path) == []
    assert [one.id for one in Controller().run(sub).errors] == [20376]

# SPDX-License-Identifier: MIT
"""Mistakes of the path that ``nctakt check`` finds: those of a run, and no others."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.diagnostics import Severity
from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import load_machine
from nctakt.run.assembly import AssembledMachine
from nctakt.run.controller import Controller, NcText

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
    "arc beyond a limit": ("G00 X9998 Y0\nG02 Y-10 J-5", 2, 120002),
    "in a branch": ("G00 X0 Y0\nP1 = 1\n$IF P1 == 1\nG02 X10 I3\n$ENDIF", 4, 20035),
    "behind branches that agree": (
        "P1 = 1\n$IF P1 == 1\nG00 X0 Y0\n$ELSE\nG00 X0 Y0\n$ENDIF\nG02 X10 I3",
        7,
        20035,
    ),
    "in a local subprogram": (
        "%L SUB\nG90 G17 G162 G71 G00 X0 Y0\nG02 X10 I3 F9\nM17\n%MAIN\nLL SUB",
        3,
        20035,
    ),
}
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


def test_a_file_that_ends_as_a_subprogram_may_begin_anyhow() -> None:
    """G91 or another plane may be its caller's."""
    assert errors("G00 X0 Y0\nG02 X10 I3\nM17\n") == []


def test_long_programs_are_not_followed() -> None:
    """Above 5,000 lines a run tells; the check stays fast."""
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

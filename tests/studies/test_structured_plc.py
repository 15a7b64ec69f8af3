# SPDX-License-Identifier: MIT
"""Studies with a PLC in Structured Text: its inputs vary, its variables are measured."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt import Study
from nctakt.base.failure import Failure
from nctakt.studies.runs.plan_files import files_of

PLC = """PROGRAM MAIN
VAR bSensor AT %I* : BOOL; tonLate : TON; bLate : BOOL; nCycles : INT; END_VAR
tonLate(IN := NOT bSensor, PT := T#50MS);
bLate := bLate OR tonLate.Q;
nCycles := nCycles + 1;
END_PROGRAM
"""


@pytest.fixture
def cell(tmp_path: Path) -> Path:
    """A program of 101 ticks, and a PLC whose sensor is late after 50 ms."""
    (tmp_path / "part.nc").write_text("G04 0.1\nM30\n", "utf-8")
    (tmp_path / "cell.st").write_text(PLC, "utf-8")
    return tmp_path


def test_inputs_vary_and_variables_are_measured(cell: Path) -> None:
    """MAIN runs each 10 ms: TON sees 50 ms of FALSE in the cycle at 50 ms (ST-701, ST-801)."""
    study = Study(
        program=cell / "part.nc",
        plc=cell / "cell.st",
        until="0.1 s",
        vary=[{"name": "sensor", "time_of": "MAIN.bSensor = 1", "values": ["45 ms", "55 ms"]}],
        measure={"late": "max MAIN.bLate", "cycles": "MAIN.nCycles at end"},
        expect=["MAIN.bLate = 0 at end"],
    )
    rows = list(study.run(processes=1).rows)
    assert [(row["late"], row["verdict"]) for row in rows] == [(0, "passed"), (1, "failed")]
    assert [row["cycles"] for row in rows] == [10, 10]


def test_unknown_variables_and_faults_are_refused(cell: Path) -> None:
    """900545 for a misspelt name; 902670: it dies in Python only."""
    for words, number in (
        ({"expect": ["MAIN.bLame = 0 at end"]}, 900545),
        ({"vary": [{"name": "d", "plc_dies": "yes", "values": ["5 ms"]}]}, 902670),
    ):
        with pytest.raises(Failure) as raised:
            Study(program=cell / "part.nc", plc=cell / "cell.st", **words).run(processes=1)
        assert [found.id for found in raised.value.diagnostics] == [number]


def test_all_files_of_the_plc_go_along(cell: Path) -> None:
    """A machine that makes runs has settings, sources of libraries, stubs and their modules."""
    library = cell / "libraries" / "late.st"
    library.parent.mkdir()
    library.write_text("FUNCTION Late : INT Late := 1; END_FUNCTION\n", "utf-8")
    stub = (
        "import helper\nclass Gate:\n    declaration = ''\n    def cycle(self, block, hli): ...\n"
    )
    settings = '[plc]\nlibraries = ["libraries"]\nstubs = {FB_Gate = "stubs.py:Gate"}\n'
    for name, text in {"stubs.py": stub, "helper.py": "", "nctakt.toml": settings}.items():
        (cell / name).write_text(text, "utf-8")
    changed = PLC.replace("nCycles : INT;", "nCycles : INT; fbGate : FB_Gate;")
    (cell / "cell.st").write_text(changed, "utf-8")
    needed = files_of(Study(program=cell / "part.nc", plc=cell / "cell.st").plan)
    own = {path.name for path in needed.files if path.is_relative_to(cell.resolve())}
    assert own == {"part.nc", "cell.st", "nctakt.toml", "late.st", "stubs.py"}
    assert [path.name for path in needed.modules.files] == ["helper.py"]

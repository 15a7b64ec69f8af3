# SPDX-License-Identifier: MIT
"""Names of a PLC's variables that are misspelt: where they are named, and what is meant."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.plc_rig import loaded

from nctakt.base.failure import Failure
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import AnyPlc

CELL = """
FUNCTION_BLOCK FB_Clamp
VAR bOpen : BOOL; sState : STRING; nHeights : ARRAY [1..3] OF INT; END_VAR
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR bReleased AT %I* : BOOL; clamp : FB_Clamp; END_VAR
clamp();
END_PROGRAM
VAR_GLOBAL nParts : DINT; END_VAR
"""
PROGRAM = NcText("part.nc", "G04 0.01\nM30")


def refused(plc: AnyPlc | None, **words: object) -> tuple[int, str]:
    """Number and remedy of what a run refuses."""
    with pytest.raises(Failure) as raised:
        Controller().run(PROGRAM, plc=plc, **words)  # type: ignore[arg-type]
    found = raised.value.diagnostics[0]
    return found.id, found.remedy()


@pytest.mark.parametrize(
    ("name", "number", "remedy"),
    [
        ("MAIN.bRelease", 900541, "Did you mean MAIN.bReleased?"),
        ("clamp.bOpen", 900541, "Did you mean MAIN.clamp.bOpen?"),
        ("MAIN.clamp.sStat", 900541, "Did you mean MAIN.clamp.sState?"),
        ("V.E.VALEU", 900541, "Did you mean V.E.VALUE?"),
        ("PUMP.xyz", 900540, "The names are in the machine's variables list, those of the PLC in "),
    ],
)
def test_an_input_of_an_unknown_name(tmp_path: Path, name: str, number: int, remedy: str) -> None:
    """--at and set name the variable of the PLC that is meant, or where they are."""
    found = refused(loaded(tmp_path, CELL), at=[("1 ms", name, 0)])
    assert (found[0], found[1][: len(remedy)]) == (number, remedy)
    if number == 900540:
        assert "MAIN" in found[1]
        alone = refused(None, at=[("1 ms", name, 0)])
        assert alone == (900540, "The names are in the machine's variables list.")


@pytest.mark.parametrize(
    ("name", "number", "remedy"),
    [
        ("X.ACT_POS", 900545, "Did you mean X.ACS.ACT_POS?"),
        ("clamp.bOpen", 900545, "Did you mean MAIN.clamp.bOpen?"),
        ("MAIN.sState", 900544, "Signals are X.ACS.ACT_POS and similar, PATH.SPEED, BLOCK, "),
    ],
)
def test_an_unknown_signal(tmp_path: Path, name: str, number: int, remedy: str) -> None:
    """Signals are numbers: a text of the PLC is not suggested."""
    found = refused(loaded(tmp_path, CELL), signals=[name])
    assert (found[0], found[1][: len(remedy)]) == (number, remedy)
    if number == 900544:
        assert ", those of the PLC in " in found[1]

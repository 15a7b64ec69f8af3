# SPDX-License-Identifier: MIT
"""A session with a PLC in Structured Text: its memory goes back and forward with the machine."""

from __future__ import annotations

from pathlib import Path

from support.plc_rig import EACH_TICK

from nctakt import NcText
from nctakt.session.core import SessionCore
from nctakt.session.setup import Setup

CELL = """
PROGRAM MAIN
VAR
    fbHli : MCV_HliInterface;
    bDoor AT %I* : BOOL;
    n, nSeen : UDINT;
END_VAR
n := n + 1;
IF NOT fbHli.Initialized THEN fbHli(); RETURN; END_IF
gpCh[0]^.head.plc_present_w := TRUE;
IF gpCh[0]^.techno_unit_std_sync[0].please_rw AND bDoor THEN
    gpCh[0]^.techno_unit_std_sync[0].please_rw := FALSE;
    gpCh[0]^.techno_unit_std_sync[0].done_w := TRUE;
    nSeen := nSeen + 1;
END_IF
END_PROGRAM
"""


def test_the_plc_goes_back_with_its_machine(tmp_path: Path) -> None:
    """ST-820: at each tick the PLC has what it had there, before and after a step back.

    n counts cycles: k + 1 after tick k. The door opens in tick 40, M7 of tick 10 is done there, and
    X (0.002 mm in its first tick) begins in tick 41.
    """
    cell = tmp_path / "cell.st"
    cell.write_text(CELL + EACH_TICK, "utf-8")
    nc = NcText("p.nc", "N5 G04 0.01\nN10 M7\nN20 G00 X10\nM30")
    core = SessionCore(Setup({1: [nc]}, plc=cell, options={"at": [("40 ms", "MAIN.bDoor", 1)]}))
    names = ["MAIN.n", "MAIN.nSeen", "X.ACS.ACT_POS"]
    try:
        core.step(60)
        there = core.read(names)
        assert there[:2] == [60, 1]
        core.go_to(41)
        assert core.read(names) == [41, 1, 0.0]
        core.go_to(30)
        assert core.read(names) == [30, 0, 0.0]
        core.step(30)
        assert core.read(names) == there
    finally:
        core.close()

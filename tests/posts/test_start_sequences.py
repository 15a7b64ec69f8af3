# SPDX-License-Identifier: MIT
"""Programs as post processors and cells write them: their start sequences, and a short part.

Each is written for this test, after the order of words in public programs: a timber beam centre, a
cell that builds up weld beads, a panel centre with cycles, a printer of wells, a laser; then those
that smooth by #HSC: a router, a nesting machine, a robot with an extruder.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import nctakt
from nctakt.run.controller import Controller

PROGRAMS = Path(__file__).parent / "programs"
DEMO5 = Path(nctakt.__file__).parent / "machines" / "demo5"

#: Program -> positions of X, Y, Z after its end; ``None``: not looked at.
ENDS: dict[str, tuple[float | None, float | None, float | None]] = {
    "beam_centre.nc": (105.0, 20.0, 300.0),
    "cladding.nc": (120.0, 80.0, 60.0),
    "panel_centre.nc": (None, None, 100.0),
    "printer.nc": (-60.82, 50.955, 21.27),
    "laser.nc": (0.0, 0.0, 0.0),
    "router.nc": (None, None, 280.0),
    "nested_panel.nc": (0.0, 0.0, 250.0),
    "robot.nc": (None, None, None),
}


@pytest.mark.parametrize("name", ENDS)
def test_a_program_of_a_post_processor_runs(name: str) -> None:
    """Nothing stops it, and its axes come to where it ends."""
    signals = [f"{axis}.ACS.ACT_POS" for axis in "XYZ"]
    run = Controller(DEMO5).run(PROGRAMS / name, ticks=60_000, signals=signals)
    assert run.errors == ()
    assert run.state == "ended"
    assert run.trace is not None
    for signal, expected in zip(signals, ENDS[name], strict=True):
        if expected is not None:
            assert run.trace[signal][-1] == pytest.approx(expected, abs=1e-9), signal

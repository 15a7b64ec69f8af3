# SPDX-License-Identifier: MIT
"""Random programs keep every axis within its limits in every tick (MO-1).

``NCTAKT_SEEDS=100000`` runs as many programs, else 1000 run compiled and 40 plain.
"""

from __future__ import annotations

import os

import pytest
from kernel_rig import DEMO
from random_paths import AXES, program, violations

from nctakt.controller import Controller, NcText
from nctakt.mode import is_compiled

SEEDS = int(os.environ.get("NCTAKT_SEEDS", "1000" if is_compiled() else "40"))
#: Programs of one test.
CHUNK = 20


@pytest.mark.parametrize("first", range(0, SEEDS, CHUNK))
def test_random_programs_keep_the_limits(first: int) -> None:
    """Speed and acceleration of each axis in each tick, and the program comes to its end."""
    for seed in range(first, min(first + CHUNK, SEEDS)):
        text = program(seed)
        run = Controller(DEMO).run(
            NcText("p.nc", text), signals=[f"{name}.ACS.ACT_POS" for name in AXES], ticks=400_000
        )
        assert run.state == "ended", (seed, run.diagnostics)
        assert run.trace is not None
        for name in AXES:
            assert violations(run.trace[f"{name}.ACS.ACT_POS"], name) == [], seed

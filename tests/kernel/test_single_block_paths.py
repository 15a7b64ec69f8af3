# SPDX-License-Identifier: MIT
"""Single block, switched at any tick, with START, override and hold, keeps the limits (MO-1, MO-6).

``NCTAKT_SEEDS=100000`` runs as many random programs of each kind, else 40 run compiled, 6 plain.
"""

from __future__ import annotations

import os
from collections.abc import Callable

import pytest
from kernel_rig import DEMO
from random_operator import Operator
from random_paths import AXES, flowing, program, violations

from nctakt.base.mode import is_compiled
from nctakt.run.controller import Controller, NcText

MANY = int(os.environ.get("NCTAKT_SEEDS", "") or ("40" if is_compiled() else "6"))
#: Programs of one test.
CHUNK = 20

SIGNALS = [f"{name}.ACS.ACT_POS" for name in AXES]
JERK_LIMITED = "#SLOPE [TYPE=TRAPEZ]"
MOST_JERK_MM = 8e-5


def found(text: str, plc: Operator) -> list[str]:
    """Where a program breaks the limits."""
    run = Controller(DEMO).run(NcText("p.nc", text), signals=SIGNALS, ticks=400_000, plc=plc)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    jerk = MOST_JERK_MM if JERK_LIMITED in text else 0.0
    return [
        violation
        for name, signal in zip(AXES, SIGNALS, strict=True)
        for violation in violations(run.trace[signal], name, jerk)
    ]


@pytest.mark.parametrize("ways", ["single", "single override hold"])
@pytest.mark.parametrize("slope", ["", JERK_LIMITED])
@pytest.mark.parametrize("make", [program, flowing])
@pytest.mark.parametrize("first", range(0, MANY, CHUNK))
def test_single_block_keeps_the_limits(
    first: int, make: Callable[[int, str], str], slope: str, ways: str
) -> None:
    """Speed, acceleration and jerk of each axis in each tick."""
    for seed in range(first, min(first + CHUNK, MANY)):
        assert found(make(seed, slope), Operator(seed, ways)) == [], seed

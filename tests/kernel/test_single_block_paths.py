# SPDX-License-Identifier: MIT
"""Single block at any tick, with START, override and hold, keeps the limits (MO-1, MO-6)."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from support.kernel_rig import DEMO
from support.random_operator import Operator
from support.random_paths import AXES, flowing, program, violations
from support.random_seeds import seeds_in_parts

from nctakt.run.controller import Controller, NcText

SIGNALS = [f"{name}.ACS.ACT_POS" for name in AXES]
JERK_LIMITED = "#SLOPE [TYPE=TRAPEZ]"
MAX_JERK_MM = 8e-5


def found(text: str, plc: Operator) -> list[str]:
    """Where a program breaks the limits."""
    run = Controller(DEMO).run(NcText("p.nc", text), signals=SIGNALS, ticks=400_000, plc=plc)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    jerk = MAX_JERK_MM if JERK_LIMITED in text else 0.0
    return [
        violation
        for name, signal in zip(AXES, SIGNALS, strict=True)
        for violation in violations(run.trace[signal], name, jerk)
    ]


@pytest.mark.parametrize("ways", ["single", "single override hold"])
@pytest.mark.parametrize("slope", ["", JERK_LIMITED])
@pytest.mark.parametrize("make", [program, flowing])
@seeds_in_parts(6, 2, 3)
def test_single_block_keeps_the_limits(
    seeds: range, make: Callable[[int, str], str], slope: str, ways: str
) -> None:
    """Speed, acceleration and jerk of each axis in each tick."""
    for seed in seeds:
        assert found(make(seed, slope), Operator(seed, ways)) == [], seed

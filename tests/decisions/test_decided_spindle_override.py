# SPDX-License-Identifier: MIT
"""Decisions on ``S[OVERRIDE SPEED_FACT=20]`` (public manuals, page 208269707)."""

from __future__ import annotations

import pytest
from support.decided import numbers, perform, reported

SIGNALS = ["S.SPEED", "S2.SPEED", "PATH.SPEED"]


def speeds(program: str, name: str = "S.SPEED") -> list[float]:
    """A signal of the demo machine in each tick."""
    run = perform(f"{program}\nM30", signals=SIGNALS)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    values: list[float] = run.trace[name].tolist()
    return values


def test_the_public_example() -> None:
    """1000 1/min, 200 while the override is 20 %, then 1000 again."""
    found = speeds(
        "S[M3 REV1000]\nG04 3\nS[OVERRIDE SPEED_FACT=20]\nG04 3\n"
        "S[OVERRIDE SPEED_FACT=100]\nG04 3\nM5"
    )
    assert [found[tick] for tick in (2990, 5990, 8990)] == pytest.approx([1000, 200, 1000])


@pytest.mark.parametrize(
    ("program", "speed"),
    [
        ("S[OVERRIDE SPEED_FACT=50]\nM3 S600", 300.0),
        ("M4 S600\nS[OVERRIDE SPEED_FACT=150]", -900.0),
        ("M3 S600\nS[OVERRIDE SPEED_FACT=50]\nS[OVERRIDE SPEED_FACT=50]", 300.0),
        ("M3 S600\nS2[OVERRIDE SPEED_FACT=50]", 600.0),
        ("P1 = 25\nM3 S400\nS[OVERRIDE SPEED_FACT=P1]", 100.0),
        ("M3 S600\nS[OVERRIDE SPEED_FACT=50]\nM5\nM3", 300.0),
    ],
)
def test_it_is_modal_for_its_spindle(program: str, speed: float) -> None:
    """Not cumulative; the other spindle keeps its speed; 1/min some seconds later."""
    assert speeds(f"{program}\nG04 3")[-2] == pytest.approx(speed)


def test_what_follows_the_spindle() -> None:
    """M19 turns as slowly, G95 follows the real speed, G04 S counts real revolutions."""
    found = speeds("S[OVERRIDE SPEED_FACT=50]\nM19 S100 S.POS180\nG04 2")
    assert max(map(abs, found)) == pytest.approx(50.0)
    found = speeds("M3 S600\nS[OVERRIDE SPEED_FACT=50]\nG04 2\nG95 F1\nG01 X10", "PATH.SPEED")
    assert max(found) == pytest.approx(5.0, rel=1e-6)
    run = perform("M3 S600\nS[OVERRIDE SPEED_FACT=50]\nG04 S10\nM30")
    assert run.ticks == pytest.approx(2000, abs=10)


def test_each_program_begins_without_it() -> None:
    """Choice; V.SPDL_PROG has the programmed speed."""
    text = '#MSG ["%d", V.SPDL_PROG.SPEED.S]'
    run = perform(f"M3 S600\nS[OVERRIDE SPEED_FACT=50]\n{text}\nM30")
    assert reported(run, "message")[0].endswith(" 600")


@pytest.mark.parametrize(
    ("program", "number"),
    [
        ("S[OVERRIDE SPEED_FACT=0]", 21419),
        ("S[OVERRIDE SPEED_FACT=201]", 21419),
        ("P1 = 300\nS[OVERRIDE SPEED_FACT=P1]", 21419),
        ("S[OVERRIDE]", 21035),
        ("S[OVERRIDE FEED_FACT=50]", 21035),
        ("S[SPEED_FACT=50 OVERRIDE]", 21035),
        ("#RT CYCLE [ID=1]\nS[OVERRIDE SPEED_FACT=50]\n#RT CYCLE END", 50954),
    ],
)
def test_what_cannot_be(program: str, number: int) -> None:
    """Beyond 0.1 … 200 %, other words."""
    assert number in numbers(perform(f"{program}\nM30"))

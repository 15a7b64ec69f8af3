# SPDX-License-Identifier: MIT
"""E, the feed at a block's end, and G08, G09, G193, G293, G900, G901 (language 4).

The demo machine (MO-15): 4000 mm/s², tick 1 ms.
"""

from __future__ import annotations

import numpy as np
import pytest
from kernel_rig import DEMO

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText


def run(text: str) -> Run:
    """The run of a program."""
    return Controller(DEMO).run(
        NcText("p.nc", text), signals=["X.ACS.ACT_POS", "BLOCK"], ticks=100_000
    )


def speed_at(text: str, place: float) -> float:
    """The speed in mm/s where X passes a place."""
    trace = run(text).trace
    assert trace is not None
    x = np.asarray(trace["X.ACS.ACT_POS"])
    tick = int(np.searchsorted(x, place))
    return float(x[tick] - x[tick - 1]) * 1000


@pytest.mark.parametrize("slope", ["STEP", "TRAPEZ"])
@pytest.mark.parametrize(
    ("word", "expected"), [("", 200.0), ("E1200", 20.0), ("E6000", 100.0), ("E60000", 200.0)]
)
def test_a_block_ends_with_its_end_feed(word: str, expected: float, slope: str) -> None:
    """F12000 is 200 mm/s; E above F counts as F, a missing one as well (206811147)."""
    text = f"#SLOPE [TYPE={slope}]\nG01 X100 F12000 {word}\nX200\nM30"
    assert speed_at(text, 100.0) == pytest.approx(expected, abs=4.5)
    assert speed_at(text, 50.0) == pytest.approx(200.0, abs=0.1)
    assert speed_at(text, 150.0) == pytest.approx(200.0, abs=0.1)


def test_the_end_feed_follows_the_programs_override() -> None:
    """E is a feed: half of it with an override of 50 %."""
    text = "#OVERRIDE [FEED_FACT=50]\nG01 X100 F12000 E6000\nX200\nM30"
    assert speed_at(text, 100.0) == pytest.approx(50.0, abs=4.5)


@pytest.mark.parametrize(
    ("text", "number"),
    [("G93 G01 X1 F1 E10", 901590), ("G01 X1 F100 E0", 20176), ("G01 X1 F100 E-5", 20176)],
)
def test_mistakes_have_their_numbers(text: str, number: int) -> None:
    """E needs G94 and is above 0."""
    assert [error.id for error in run(f"{text}\nM30").errors] == [number]


@pytest.mark.parametrize("word", ["G08", "G09", "G900", "G901", "G193", "G293"])
def test_where_a_feed_changes(word: str) -> None:
    """The path brakes in front of a slower block and speeds up behind a faster one (206238219)."""
    text = f"G01 X100 F12000\n{word} X200 F1200\nX250 F12000\nX300\nM30"
    assert speed_at(text, 100.0) == pytest.approx(20.0, abs=4.5)
    assert speed_at(text, 150.0) == pytest.approx(20.0, abs=0.1)
    notes = [one.id for one in run(text).diagnostics]
    assert notes.count(901551) == (1 if word in ("G901", "G193", "G293") else 0)

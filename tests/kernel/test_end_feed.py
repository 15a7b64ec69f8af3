# SPDX-License-Identifier: MIT
"""E, the feed at a block's end, and G08, G09, G193, G293, G900, G901 (language 4).

The demo machine (MO-15): 4000 mm/s², tick 1 ms.
"""

from __future__ import annotations

import numpy as np
import pytest
from support.kernel_rig import DEMO

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView


def run(text: str) -> Run:
    """The run of a program."""
    return Controller(DEMO).run(
        NcText("p.nc", text), signals=["X.ACS.ACT_POS", "BLOCK"], ticks=100_000
    )


def path_of(text: str) -> np.ndarray:
    """The positions of X and Y after each tick."""
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
    trace = Controller(DEMO).run(NcText("p.nc", text), signals=signals, ticks=100_000).trace
    assert trace is not None
    return np.array([trace[name] for name in signals]).T


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


@pytest.mark.parametrize("word", ["G08", "G09", "G900", "G901"])
def test_where_a_feed_changes(word: str) -> None:
    """The path brakes before a slower block and speeds up after a faster one (206238219)."""
    text = f"G01 X100 F12000\n{word} X200 F1200\nX250 F12000\nX300\nM30"
    assert speed_at(text, 100.0) == pytest.approx(20.0, abs=4.5)
    assert speed_at(text, 150.0) == pytest.approx(20.0, abs=0.1)
    notes = [one.id for one in run(text).diagnostics]
    assert notes.count(901551) == (1 if word == "G901" else 0)


@pytest.mark.parametrize("motion", ["G01 X300 F30000", "G03 X300 Y0 I100 F30000"])
@pytest.mark.parametrize(("word", "middle"), [("G193", 300.0), ("G293", 360.555)])
@pytest.mark.parametrize(("start", "end"), [(100.0, 500.0), (500.0, 100.0)])
def test_a_ramp_changes_the_feed_over_the_block(
    word: str, middle: float, start: float, end: float, motion: str
) -> None:
    """Linear over the way, or over time: in the middle 300 or √((100² + 500²)/2) mm/s."""
    motion = motion.replace("30000", str(end * 60))
    text = f"G01 X100 F{start * 60}\n{word} {motion}\nG01 X500\nM30"
    trace = path_of(text)
    step = np.hypot(np.diff(trace[:, 0]), np.diff(trace[:, 1])) * 1000
    way = np.cumsum(step) / 1000
    whole = 200.0 if "G01" in motion else 100.0 * np.pi
    tick = int(np.searchsorted(way, 100.0 + whole / 2))
    assert step[tick] == pytest.approx(middle, abs=abs(end - start) / 60)
    quarter = int(np.searchsorted(way, 100.0 + whole / 4))
    expected = start + (end - start) / 4
    if word == "G293":
        expected = np.sqrt(start**2 + (end**2 - start**2) / 4)
    assert step[quarter] == pytest.approx(expected, abs=abs(end - start) / 25)


def test_where_there_is_no_ramp() -> None:
    """Without another F, with limited jerk, beside chamfers: the feed is that of the block."""
    same = "G01 X100 F12000\nG193 X200\nX300\nM30"
    assert speed_at(same, 150.0) == pytest.approx(200.0, abs=0.1)
    jerk = "#SLOPE [TYPE=TRAPEZ]\nG01 X100 F12000\nG193 X200 F6000\nX300\nM30"
    assert speed_at(jerk, 150.0) == pytest.approx(100.0, abs=0.1)
    assert speed_at("G193 G01 X100 F6000\nX200\nM30", 20.0) < 50.0  # from the list's F1000
    chamfer = "G01 X100 F12000\nG193 X200 F6000\nG301 I5\nY50\nM30"
    assert speed_at(chamfer, 150.0) == pytest.approx(100.0, abs=0.1)
    notes = [one.id for one in run(jerk).diagnostics]
    assert notes == [901551]


def test_a_ramp_is_one_block() -> None:
    """The number of the block stays, its end is met to the bit, and E counts at its end."""
    trace = run("N1 G01 X100 F12000\nN2 G193 G60 X200 F6000\nN3 X250\nM30").trace
    assert trace is not None
    x = np.asarray(trace["X.ACS.ACT_POS"])
    assert 200.0 in x
    assert set(np.asarray(trace["BLOCK"]).tolist()) <= {0, 1, 2, 3}
    text = "G01 X100 F12000\nG193 X200 F6000 E1200\nX300\nM30"
    assert speed_at(text, 200.0) == pytest.approx(20.0, abs=4.5)


CORNER = "#CORNER PARAM [DIST=20 UNIT=PERCENT FEED=50]\nG13\n"


@pytest.mark.parametrize(
    ("before", "places"),
    [
        # F12000 is 200 mm/s; linear over the last 20 mm to 100 mm/s.
        (CORNER, {70.0: 200.0, 90.0: 150.0, 98.0: 110.0}),
        (CORNER.replace("PERCENT FEED=50", "FWORD FEED=6000"), {70.0: 200.0, 90.0: 150.0}),
        (CORNER.replace("PERCENT FEED=50", "FWORD FEED=99999"), {90.0: 200.0}),
        (CORNER.replace("DIST=20", "DIST=500"), {50.0: 150.0}),
        (CORNER + "G12\n", {90.0: 200.0}),
        ("#SLOPE [TYPE=TRAPEZ]\n" + CORNER, {90.0: 200.0}),
    ],
)
def test_the_feed_falls_before_a_block_end(before: str, places: dict[float, float]) -> None:
    """G13 with #CORNER PARAM (206444555, 206449675); after the end F counts again."""
    text = f"{before}G01 X100 F12000\nX200\nG12 X300\nM30"
    for place, expected in places.items():
        assert speed_at(text, place) == pytest.approx(expected, abs=4.0)
    assert speed_at(text, 250.0) == pytest.approx(200.0, abs=0.1)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("G13", 20795),
        ("G12 G13", 20794),
        ("#CORNER PARAM [DIST=10 FEED=5]", 900233),
        ("#CORNER PARAM [DIST=0 UNIT=PERCENT FEED=50]", 901832),
        ("#CORNER PARAM [DIST=1 UNIT=PERCENT FEED=-1]", 901832),
        ("#CORNER PARAM [DIST=1 UNIT=MM FEED=5]", 900706),
    ],
)
def test_mistakes_of_corner_feeds(text: str, number: int) -> None:
    """G13 needs its parameters, all of them, above 0."""
    assert [error.id for error in run(f"{text}\nG01 X1 F100\nM30").errors] == [number]


def test_corner_feeds_are_reported_once_and_end_with_the_program() -> None:
    """Note 901551; plain lines after G13 slow down as well."""
    text = CORNER + "G01 F12000\n" + "".join(f"X{x}\n" for x in range(100, 500, 100)) + "M30"
    ran = run(text)
    assert [one.id for one in ran.diagnostics] == [901551]
    for end in (100.0, 300.0):
        assert speed_at(text, end - 10.0) == pytest.approx(150.0, abs=4.0)


class Operator:
    """Walks back and forward, holds the feed and turns the override while the program runs."""

    def cycle(self, hli: PlcView) -> None:
        phase = hli.tick // 90 % 10
        plays = hli.tick < 3000
        hli.backward_motion = plays and phase in (3, 7)
        hli.feed_hold = plays and phase == 5
        hli.override_pct = 40.0 if plays and phase > 7 else 100.0


def test_operators_keep_to_the_ramps() -> None:
    """The path and its end stay, whatever the operator does; no tick exceeds 4000 mm/s²."""
    text = CORNER + (
        "G01 X100 F12000\nG193 X200 F6000\nG293 G03 X240 Y40 J40 F18000\nG12 G01 Y100\nM30"
    )
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
    ran = Controller(DEMO).run(NcText("p.nc", text), signals=signals, plc=Operator(), ticks=20_000)
    assert ran.state == "ended"
    assert ran.trace is not None
    x, y = (np.asarray(ran.trace[name]) for name in signals)
    assert (x[-1], y[-1]) == (240.0, 100.0)
    for axis in (x, y):
        assert np.abs(np.diff(axis, 2)).max() <= 4e-3 + 1e-9
    bend = (x > 200.0) & (y < 40.0)
    assert np.hypot(x[bend] - 200.0, y[bend] - 40.0) == pytest.approx(40.0, abs=1e-6)
    assert np.abs(y[x <= 200.0]).max() < 1e-9

# SPDX-License-Identifier: MIT
"""G127 … G133, G230 … G233: weights of speeds, accelerations and ramp times (language 7).

The demo machine (MO-15): 500 mm/s, 4000 mm/s², tick 1 ms. From rest to rest with the speed v and
the acceleration a a way s takes s/v + v/a, or 2·√(s/a) where v is not reached.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.kernel_rig import DEMO

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText


def run(text: str) -> Run:
    """The run of a program, with the position of X and the blocks."""
    done = Controller(DEMO).run(
        NcText("p.nc", text), signals=["X.ACS.ACT_POS", "BLOCK"], ticks=100_000
    )
    assert done.trace is not None
    return done


def ticks(text: str, number: int = 9) -> int:
    """How long the block with this number lasts."""
    trace = run(text).trace
    assert trace is not None
    return int((np.asarray(trace["BLOCK"]) == number).sum())


def time_s(length: float, speed: float = 500.0, acceleration: float = 4000.0) -> float:
    """The time from rest to rest."""
    if length < speed * speed / acceleration:
        return 2.0 * math.sqrt(length / acceleration)
    return length / speed + speed / acceleration


@pytest.mark.parametrize(
    ("weight", "motion", "speed", "acceleration"),
    [
        ("G127 X10", "G01", 50.0, 4000.0),
        ("G128=10", "G01", 50.0, 4000.0),
        ("G128=10", "G00", 50.0, 4000.0),
        ("G129=50", "G00", 250.0, 4000.0),
        ("G129=50", "G01", 500.0, 4000.0),
        ("G130 X50", "G01", 500.0, 2000.0),
        ("G131=25", "G01", 500.0, 1000.0),
        ("G131=25", "G00", 500.0, 4000.0),
        ("G230 X50", "G00", 500.0, 2000.0),
        ("G231=50", "G00", 500.0, 2000.0),
        ("G231=50", "G01", 500.0, 4000.0),
        # Weights relate to the values of the lists: 50 % twice is 50 % (206590731).
        ("G131=50\nG131=50", "G01", 500.0, 2000.0),
        # Axes that are not named are at 100 %.
        ("G130 X50\nG130 Y50", "G01", 500.0, 4000.0),
        ("G131=50\nG130 Y50", "G01", 500.0, 4000.0),
        # The maxima of the axis cap them (P-AXIS-00212, P-AXIS-00008).
        ("G128=200 G129=200", "G00", 500.0, 4000.0),
        ("G131=300", "G01", 500.0, 4000.0),
        # Positions may be in the block of a weight of all axes (206578955).
        ("G01 F60000", "G129=50 G00", 250.0, 4000.0),
    ],
)
def test_weights_limit_the_axes(
    weight: str, motion: str, speed: float, acceleration: float
) -> None:
    """A way of 300 mm from rest to rest takes what the weighted limits give."""
    text = f"F60000\n{weight}\nN9 {motion} G60 X300\nM30"
    assert ticks(text) == math.ceil(time_s(300.0, speed, acceleration) * 1000 - 1e-6)


@pytest.mark.parametrize(
    ("weight", "motion", "factor"),
    [
        ("G132 X400", "G01", 4.0),
        ("G133=400", "G01", 4.0),
        ("G133=400", "G00", 1.0),
        ("G232 X400", "G00", 4.0),
        ("G233=400", "G00", 4.0),
    ],
)
def test_ramp_times_weight_the_jerk(weight: str, motion: str, factor: float) -> None:
    """Jerk = acceleration / ramp time; a ramp t longer than v/a takes 2·√(v/a·t) in all (MO-2)."""
    text = f"#SLOPE [TYPE=TRAPEZ]\nF60000\n{weight}\nN9 {motion} G60 X300\nM30"
    dynamics = DEMO.axes[0].dynamics
    rapid = motion == "G00"
    acceleration = dynamics.smooth_accelerations[0 if rapid else 1]
    ramp_s = acceleration / dynamics.smooth_jerks[0 if rapid else 1] * factor
    build_up = 500.0 / acceleration
    ramp = build_up + ramp_s if ramp_s <= build_up else 2.0 * math.sqrt(build_up * ramp_s)
    expected = 300.0 / 500.0 + ramp
    assert ticks(text) == pytest.approx(expected * 1000, abs=2)


def test_a_program_begins_with_the_values_of_the_lists() -> None:
    """Weights end with the program."""
    controller = Controller(DEMO)
    for text in ("G131=10 G128=10\nG01 X10 F60000\nM30", "N9 G01 G60 X310 F60000\nM30"):
        done = controller.run(NcText("p.nc", text), signals=["BLOCK"], ticks=100_000)
    assert done.trace is not None
    assert (np.asarray(done.trace["BLOCK"]) == 9).sum() == math.ceil(time_s(300.0) * 1000)


def test_a_speed_of_0_per_cent_is_the_lowest_one() -> None:
    """0: 1 µm/s (206573067)."""
    assert ticks("G128=0\nN9 G01 G60 X0.001 F6000\nM30") == pytest.approx(1000, abs=2)


def test_arcs_keep_the_weighted_limits() -> None:
    """No axis exceeds its weighted acceleration and speed on an arc, whatever the feed."""
    trace = run("G130 X50 Y50\nG01 X20 F30000\nG03 X20 Y0 I-20\nG01 X40\nM30").trace
    assert trace is not None
    speed = np.diff(np.asarray(trace["X.ACS.ACT_POS"]), prepend=0.0, append=40.0) * 1000
    assert np.abs(np.diff(speed)).max() <= 2000.0 * 0.001 * (1 + 1e-6)


def test_the_corner_between_two_weights_keeps_both() -> None:
    """A corner that is passed asks no axis for more than either segment allows."""
    text = "G131=25\nG01 X50 F12000\nG131=100\nX100 Y2\nG131=25\nX150 Y0\nM30"
    trace = run(text).trace
    assert trace is not None
    speed = np.diff(np.asarray(trace["X.ACS.ACT_POS"]), prepend=0.0, append=150.0) * 1000
    change = np.abs(np.diff(speed))
    assert change.max() <= 4.0 * (1 + 1e-6)
    assert change[: len(change) // 4].max() <= 1.0 * (1 + 1e-6)


@pytest.mark.parametrize("word", ["G131=0", "G130 X-5", "G133=0", "G128=-1"])
def test_a_weight_has_to_be_positive(word: str) -> None:
    """Messages name the word and its value."""
    done = Controller(DEMO).run(NcText("p.nc", f"{word}\nM30"), signals=["BLOCK"], ticks=1000)
    assert [error.id for error in done.errors] == [901550]

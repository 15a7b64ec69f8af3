# SPDX-License-Identifier: MIT
"""Each slope has its own accelerations: ``lslope_profil`` STEP, ``slope_profil`` TRAPEZ (MO-2).

P-AXIS-00005, 00006, 00011, 00012 are those of the linear slope, P-AXIS-00001, 00002, 00004 those of
the jerk-limited one. From rest to rest with the speed v, the acceleration a and ramps of T each, a
way s takes s/v + v/a, with limited jerk s/v + v/a + T.
"""

from __future__ import annotations

import itertools
import math
import shutil
from pathlib import Path

import numpy as np
import pytest

import nctakt
from nctakt.lists.machine.machine import load_machine
from nctakt.plots.motion import axis_motion
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.timing.account import account_for

SIGNALS = [f"{name}.ACS.ACT_POS" for name in "XYZ"]
STEP, TRAPEZ = "#SLOPE [TYPE=STEP]", "#SLOPE [TYPE=TRAPEZ]"
_LINEAR = ("a_stufe_1", "a_stufe_2", "a_grenz_stufe_1", "a_grenz_stufe_2")
_SMOOTH = ("a_beschl", "a_brems", "a_grenz")


def controller(
    folder: Path, linear: int, smooth: int, base: str = "demo", ramp_us: int = 50_000
) -> Controller:
    """A bundled machine whose axes have these accelerations in mm/s² or °/s²."""
    made = folder / f"{base}_{linear}_{smooth}"
    shutil.copytree(Path(nctakt.__file__).parent / "machines" / base, made)
    values = {f"lslope_profil.{key}": linear for key in _LINEAR}
    values |= {f"slope_profil.{key}": smooth for key in _SMOOTH}
    values["slope_profil.tr_beschl_zu"] = ramp_us
    _change(made / "default_achs.lis", values)
    return Controller(load_machine(made))


def _change(file: Path, values: dict[str, int]) -> None:
    lines = file.read_text("utf-8").splitlines()
    for key, value in values.items():
        (index,) = [i for i, line in enumerate(lines) if f"[0].{key} " in line]
        lines[index] = f"getriebe[0].{key} {value}"
    file.write_text("\n".join(lines) + "\n", "utf-8")


def run_of(made: Controller, text: str) -> Run:
    """The run of a program up to its end."""
    signals = [*SIGNALS, "PATH.SPEED"]
    run = made.run(NcText("p.nc", text), signals=signals, ticks=100_000)
    assert run.state == "ended", run.diagnostics
    return run


def ticks(made: Controller, slope: str, motion: str) -> int:
    """How long a motion takes, without the tick of M30."""
    return run_of(made, f"{slope}\nG91\nN10 {motion}\nM30").ticks - 1


@pytest.mark.parametrize(
    ("linear", "smooth", "step_t", "trapez_t"),
    [
        # 120 mm at 240 mm/s: 500 ms, and 240 ms or 80 ms of ramps; with TRAPEZ 50 ms more.
        (1000, 3000, 740, 630),
        (3000, 1000, 580, 790),
    ],
)
def test_a_line(tmp_path: Path, linear: int, smooth: int, step_t: int, trapez_t: int) -> None:
    made = controller(tmp_path, linear, smooth)
    assert ticks(made, STEP, "G01 X120 F14400") == step_t
    assert ticks(made, TRAPEZ, "G01 X120 F14400") == trapez_t


@pytest.mark.parametrize(
    ("linear", "smooth", "step_t", "trapez_t"),
    [
        # 300 mm at 500 mm/s: 600 ms, and 500 ms or 166 2/3 ms of ramps; with TRAPEZ 50 ms more.
        (1000, 3000, 1100, 817),
        (3000, 1000, 767, 1150),
    ],
)
def test_a_rapid_motion(
    tmp_path: Path, linear: int, smooth: int, step_t: int, trapez_t: int
) -> None:
    made = controller(tmp_path, linear, smooth)
    assert ticks(made, STEP, "G00 X300") == step_t
    assert ticks(made, TRAPEZ, "G00 X300") == trapez_t


def test_weights_are_those_of_the_own_slope(tmp_path: Path) -> None:
    """G131=50 halves 3000 mm/s² with TRAPEZ, 2000 mm/s² with STEP: 160 ms and 240 ms of ramps."""
    made = controller(tmp_path, 2000, 3000)
    assert ticks(made, f"G131=50\n{TRAPEZ}", "G01 X120 F14400") == 500 + 160 + 50
    assert ticks(made, f"G131=50\n{STEP}", "G01 X120 F14400") == 500 + 240


@pytest.mark.parametrize("key", ["a_beschl", "a_brems"])
def test_the_lesser_of_speeding_up_and_braking_counts(tmp_path: Path, key: str) -> None:
    """P-AXIS-00001, 00002: either at 1500 mm/s² gives 160 ms of ramps at 240 mm/s."""
    controller(tmp_path, 1000, 3000)
    folder = tmp_path / "demo_1000_3000"
    _change(folder / "default_achs.lis", {f"slope_profil.{key}": 1500})
    made = Controller(load_machine(folder))
    assert ticks(made, TRAPEZ, "G01 X120 F14400") == 500 + 160 + 50


@pytest.mark.parametrize(
    ("slope", "linear", "smooth", "speed"),
    [
        # TRAPEZ: a bend of 6·d/√2 on either side; 0.8 of the acceleration is for v²/h.
        (TRAPEZ, 1000, 3000, math.sqrt(0.8 * 3000 * 6.0 / math.sqrt(2.0))),
        (TRAPEZ, 3000, 1000, math.sqrt(0.8 * 1000 * 6.0 / math.sqrt(2.0))),
        # STEP: a parabola of 4·d/√2 on either side; 0.9 of it is for v²/(2·h).
        (STEP, 1000, 3000, math.sqrt(0.9 * 1000 * 8.0 / math.sqrt(2.0))),
        (STEP, 3000, 1000, math.sqrt(0.9 * 3000 * 8.0 / math.sqrt(2.0))),
    ],
)
def test_a_rounded_corner(
    tmp_path: Path, slope: str, linear: int, smooth: int, speed: float
) -> None:
    """A right angle with the deviation d = 1 mm; ramps of 5 ms, so that no jerk limits it."""
    made = controller(tmp_path, linear, smooth, ramp_us=5000)
    trace = run_of(made, f"{slope}\nG261 G01 X100 F9000\nY100\nM30").trace
    assert trace is not None
    found = np.asarray(trace["PATH.SPEED"])
    x, y = (np.asarray(trace[signal]) for signal in SIGNALS[:2])
    assert found[(x < 100.0) & (y > 0.0)].min() == pytest.approx(speed, rel=0.01)


def test_the_top_speed_on_an_arc(tmp_path: Path) -> None:
    """v²/r of a radius of 20 mm, where an axis has 1000 mm/s² with STEP, 3000 with TRAPEZ.

    With STEP it is above what an axis has in between, where both axes take a part of it.
    """
    made = controller(tmp_path, 1000, 3000, ramp_us=5000)
    found = {}
    for slope in (STEP, TRAPEZ):
        trace = run_of(made, f"{slope}\nG02 I0 J20 F30000\nM30").trace
        assert trace is not None
        found[slope] = max(trace["PATH.SPEED"]) ** 2 / 20.0
        for signal in SIGNALS[:2]:
            acceleration = np.diff(np.asarray(trace[signal]), 2) * 1e6
            assert np.abs(acceleration).max() <= (1000 if slope == STEP else 3000) + 1e-3
    assert 500.0 < found[STEP] <= 1000.0 * math.sqrt(2.0)
    assert 2000.0 < found[TRAPEZ] <= 3000.0


WAYS = {
    "line": "G01 X50 Y20 Z5 F20000",
    "rapid": "G00 X80 Y30",
    "corner": "G01 X50 F20000\nX90 Y2\nX95 Y40",
    "short": "G91 F20000\n" + "\n".join(f"G01 X0.5 Y{0.03 * (i % 5)}" for i in range(60)),
    "bend": "G261 G01 X50 F20000\nY50\nX0 Y60",
    "arc": "G01 X30 F20000\nG03 X50 Y20 I0 J20\nG02 X70 Y40 I20 J0",
    "helix": "G02 X0 Y0 Z30 I0 J15 F20000",
    "weights": "G131=60\nG231=70\nG01 X50 F20000\nG00 X90\nG131=100\nG03 X110 Y20 J20",
    "vector limits": ("#VECTOR LIMIT ON [VEL=12000 ACC=500]\nG01 X50 Y10 F20000\nG03 X70 Y30 J20"),
    "spline": "#SPLINE ON\nG01 X20 Y10 F20000\nX35 Y-5\nX60 Y0\nX70 Y25\n#SPLINE OFF",
}


@pytest.mark.parametrize(("name", "slope"), list(itertools.product(WAYS, (STEP, TRAPEZ))))
def test_the_other_slope_changes_nothing(tmp_path: Path, name: str, slope: str) -> None:
    """To the bit, each tick is that of the machine whose other slope is as steep."""
    _compare(tmp_path, "demo", f"{slope}\n{WAYS[name]}\nM30", slope)


@pytest.mark.parametrize("slope", [STEP, TRAPEZ])
def test_the_other_slope_changes_nothing_of_five_axes(tmp_path: Path, slope: str) -> None:
    """The axes' way is bent by a transformation."""
    text = f"{slope}\n#TRAFO ON\nG01 X40 Y10 C30 A20 F20000\nX60 Y30 C-20 A5\n#TRAFO OFF\nM30"
    _compare(tmp_path, "demo5", text, slope)


def _compare(folder: Path, base: str, text: str, slope: str) -> None:
    own, other = 900, 400
    mixed = (own, other) if slope == STEP else (other, own)
    even = run_of(controller(folder, own, own, base), text)
    found = run_of(controller(folder, *mixed, base), text)
    assert even.trace is not None
    assert found.trace is not None
    assert found.ticks == even.ticks
    for signal in [*SIGNALS, "PATH.SPEED"]:
        assert list(found.trace[signal]) == list(even.trace[signal])


def test_what_limits_a_motion(tmp_path: Path) -> None:
    """``time`` names the axis: 80 ms at 3000 mm/s² are 30 ms without 50 ms of ramps."""
    made = controller(tmp_path, 1000, 3000)
    account = account_for(made, {1: [NcText("p.nc", f"{TRAPEZ}\nG01 X120 F14400\nM30")]})
    found = [
        (one.purpose.limit.cause, one.purpose.limit.detail.en, one.ticks)
        for one in account.stretches
        if one.purpose.phase == "accelerating"
    ]
    assert found == [("jerk", "X", 50), ("acceleration", "X", 30), ("jerk", "X", 50)]


def test_a_picture_has_the_limit_of_the_steeper_slope(tmp_path: Path) -> None:
    """A program may use both; without limited jerk it is that of the trapezoid."""
    made = controller(tmp_path, 1000, 3000)
    trace = run_of(made, f"{TRAPEZ}\nG01 X120 F14400\nM30").trace
    assert trace is not None
    axis = made.channel_axes[0]
    assert axis_motion(trace, axis, limits_jerk=True).limits[1] == 3000.0
    assert axis_motion(trace, axis).limits[1] == 1000.0

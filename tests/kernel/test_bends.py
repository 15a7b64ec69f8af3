# SPDX-License-Identifier: MIT
"""Corners that are rounded with a limit of the jerk: G61, G261 (MO-1, MO-3)."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from support.insides import machine_of
from support.kernel_rig import DEMO
from support.random_operator import Operator
from support.random_paths import AXES, cornered, farthest, violations
from support.random_seeds import seeds_in_parts

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

SIGNALS = [f"{name}.ACS.ACT_POS" for name in AXES]
SLOPE = "#SLOPE [TYPE=TRAPEZ]"
MAX_JERK_MM = 8e-5


def performed(text: str, plc: Operator | None = None) -> tuple[Run, np.ndarray]:
    """A run within the limits, and where the axes were."""
    run = Controller(DEMO).run(NcText("p.nc", text), signals=SIGNALS, ticks=400_000, plc=plc)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    for name, signal in zip(AXES, SIGNALS, strict=True):
        assert violations(run.trace[signal], name, MAX_JERK_MM) == [], text
    places = np.array([np.asarray(run.trace[signal]) for signal in SIGNALS]).T
    return run, places


@pytest.mark.parametrize("turn", [0.2, 0.8, 1.57])
@pytest.mark.parametrize("deviation", [1.0, 2.0, 4.0])
def test_a_bend_keeps_the_deviation_and_saves_time(deviation: float, turn: float) -> None:
    """Two lines of 60 mm at 200 mm/s: the corner is no farther away than it may, and no stop."""
    end = (60 + 60 * math.cos(turn), 60 * math.sin(turn))
    lines = f"G01 X60 F12000\nX{end[0]:.6f} Y{end[1]:.6f}\nM30"
    contour = f"#CONTOUR MODE [DEV PATH_DEV={deviation}]\nG261"
    run, places = performed(f"{SLOPE}\n{contour}\n{lines}")
    sharp, _ = performed(f"{SLOPE}\n{lines}")
    assert run.ticks < sharp.ticks
    nearest = np.hypot(places[:, 0] - 60, places[:, 1]).min()
    widest = 0.49 * 60 * 2 * math.sin(turn / 2) / 6
    assert min(deviation, widest) - 1e-6 <= nearest <= min(deviation, widest) + 0.02
    corners = np.array([[0, 0, 0, 0], [60, 0, 0, 0], [*end, 0, 0]], dtype=float)
    assert farthest(places[::7], corners) <= deviation + 1e-9
    assert places[-1][:2].tolist() == [round(end[0], 6), round(end[1], 6)]


def test_a_corner_that_is_as_fast_without_a_bend_stays() -> None:
    """0.01 mm away the bend would be passed at 4.8 mm/s: a stop at the corner is faster."""
    lines = "G01 X50 F12000\nY50\nM30"
    run, places = performed(f"{SLOPE}\n#CONTOUR MODE [DEV PATH_DEV=0.01]\nG261\n{lines}")
    assert run.ticks == performed(f"{SLOPE}\n{lines}")[0].ticks
    assert np.hypot(places[:, 0] - 50, places[:, 1]).min() == 0.0


def test_commands_between_the_blocks_come_after_the_bend() -> None:
    """The bend belongs to its first block; a message between the blocks comes after it."""
    lines = 'G01 X50 F12000\n#MSG ["x"]\nY50\nM30'
    run, places = performed(f"{SLOPE}\nG261\n{lines}")
    reported = [event.tick for event in run.events if event.kind == "message"]
    assert len(reported) == 1
    half = 6.0 / math.sqrt(2.0)
    assert places[reported[0] - 2][1] < half <= places[reported[0]][1]
    assert places[reported[0]][1] < half + 0.5


def test_single_block_stops_after_the_bend() -> None:
    """MO-6: where the block ends, and nowhere before."""

    class Pressed:
        def cycle(self, hli: PlcView) -> None:
            hli.single_block = True
            if hli.is_paused:
                stands.append(hli.tick)
                hli.start()

    stands: list[int] = []
    text = NcText("p.nc", f"{SLOPE}\nG261\nG01 X50 F12000\nY50\nX0\nM30")
    run = Controller(DEMO).run(text, signals=SIGNALS[:2], ticks=20_000, plc=Pressed())
    assert run.state == "ended"
    assert run.trace is not None
    half = 6.0 / math.sqrt(2.0)
    x, y = (run.trace[signal] for signal in SIGNALS[:2])
    places = sorted({(round(x[tick], 6), round(y[tick], 6)) for tick in stands if x[tick] > 1})
    assert places == sorted([(50.0, round(half, 6)), (round(50 - half, 6), 50.0)])
    for name, signal in zip(AXES, SIGNALS[:2], strict=False):
        assert violations(run.trace[signal], name, MAX_JERK_MM) == []


@pytest.mark.parametrize("ways", ["override", "override hold", "single", "back", "back override"])
@seeds_in_parts(6, 2, 3)
def test_bends_keep_the_limits_and_the_path(seeds: range, ways: str) -> None:
    """Whatever is commanded: the limits of each tick, the same curve, the same end to the bit."""
    for seed in seeds:
        text = cornered(seed, SLOPE)
        _, plain = performed(text)
        _, found = performed(text, Operator(seed, ways))
        assert found[-1].tolist() == plain[-1].tolist(), seed
        if seed == seeds.start:
            for way in (plain, found):
                way[:, 3] = np.unwrap(way[:, 3], period=360.0)
            assert farthest(found[::97], np.concatenate([np.zeros((1, 4)), plain])) < 0.05


@pytest.mark.parametrize("seed", range(6))
def test_a_reset_in_any_tick_brakes_within_the_limits(seed: int) -> None:
    """RC-007, MO-6: on a bend and before it, too."""
    chance = random.Random(seed)
    controller = Controller(DEMO)
    controller.start(NcText("p.nc", cornered(seed, SLOPE)))
    found: dict[str, list[float]] = {name: [] for name in AXES}
    is_due = chance.randint(1, 800)
    for tick in range(is_due + 400):
        if tick == is_due:
            machine_of(controller).channels[0].request_reset()
        controller.step(1)
        for name in AXES:
            found[name].append(float(controller.read(f"V.RTA.ACS.ACT_POS.{name}")))
    for name in AXES:
        assert violations(found[name], name, MAX_JERK_MM) == []
        assert found[name][-1] == found[name][-2]


def test_a_realtime_loop_rounds_the_corners_of_each_pass() -> None:
    """Forty passes of a square of 20 mm: the path is at the loop's end only, and at its own."""
    text = f"""{SLOPE}
#CONTOUR MODE [DEV PATH_DEV=5]
G261
V.RTG.LOOP.ENABLED = TRUE
#RT CYCLE [ID = 1 SCOPE = PROG]
$IF V.RTG.LOOP.COUNT >= 40
V.RTG.LOOP.ENABLED = FALSE
$ENDIF
#RT CYCLE END
G91 G01 F12000
#RT WHILE
X20
Y20
X-20
Y-20
#RT ENDWHILE
X20
M30"""
    signals = [*SIGNALS, "PATH.SPEED"]
    run = Controller(DEMO).run(NcText("p.nc", text), signals=signals, ticks=100_000)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    for name, signal in zip(AXES, SIGNALS, strict=True):
        assert violations(run.trace[signal], name, MAX_JERK_MM) == []
    speed = np.asarray(run.trace["PATH.SPEED"])
    assert ((speed[1:] == 0.0) & (speed[:-1] > 0.0)).sum() == 2

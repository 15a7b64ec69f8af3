# SPDX-License-Identifier: MIT
"""Backward motion on the path: the same curve, the same limits, the same end (MO-1, MO-7)."""

from __future__ import annotations

import math
import random
from collections.abc import Callable

import numpy as np
import pytest
from support.insides import machine_of
from support.kernel_rig import DEMO
from support.random_paths import AXES, cornered, farthest, program, violations
from support.random_seeds import seeds_in_parts

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

#: The operator lets go after this many ticks.
PLAY_TICKS = 4000

SIGNALS = [*(f"{name}.ACS.ACT_POS" for name in AXES), "HLI.RETRACE"]
JERK_LIMITED = "#SLOPE [TYPE=TRAPEZ]"
MAX_JERK_MM = 8e-5


class Operator:
    """Goes back and forward at random; ``is_wild``: turns the override, holds the feed as well."""

    def __init__(self, seed: int, *, is_wild: bool) -> None:
        self.chance = random.Random(seed)
        self.is_wild = is_wild
        self.next_tick = 1

    def cycle(self, hli: PlcView) -> None:
        if hli.tick < self.next_tick:
            return
        self.next_tick = hli.tick + self.chance.choice((1, 5, 40, 150, 400))
        plays = hli.tick < PLAY_TICKS
        hli.backward_motion = plays and self.chance.random() < 0.5
        if self.is_wild:
            hli.override_pct = self.chance.choice((0.0, 3.0, 50.0, 100.0)) if plays else 100.0
            hli.feed_hold = plays and self.chance.random() < 0.2
        hli.acknowledge_all()


def performed(
    seed: int, slope: str, operator: Operator | None, make: Callable[[int, str], str] = program
) -> Run:
    """The run of a random program."""
    text = NcText("p.nc", make(seed, slope))
    run = Controller(DEMO).run(text, signals=SIGNALS, ticks=400_000, plc=operator)
    assert run.state == "ended", (seed, run.diagnostics)
    return run


def places(run: Run) -> np.ndarray:
    """The positions of all axes, tick by tick; the modulo axis as it runs on."""
    assert run.trace is not None
    columns = [np.asarray(run.trace[name]) for name in SIGNALS[:4]]
    columns[3] = np.unwrap(columns[3], period=360.0)
    return np.stack(columns, axis=1)


@pytest.mark.parametrize("is_wild", [False, True])
@pytest.mark.parametrize(
    ("make", "slope"), [(program, ""), (program, JERK_LIMITED), (cornered, JERK_LIMITED)]
)
@seeds_in_parts(10, 2, 5)
def test_forward_and_backward_come_to_the_same_end(
    seeds: range, make: Callable[[int, str], str], slope: str, is_wild: bool
) -> None:
    """Any commands at any tick: the limits hold, the curve is the same, the end bit-equal."""
    for seed in seeds if make is program else seeds[:4]:
        straight = performed(seed, slope, None, make)
        plain = places(straight)
        run = performed(seed, slope, Operator(seed, is_wild=is_wild), make)
        assert run.trace is not None
        assert straight.trace is not None
        found = places(run)
        for i, name in enumerate(AXES):
            assert run.trace[SIGNALS[i]][-1] == straight.trace[SIGNALS[i]][-1], seed
            jerk = MAX_JERK_MM if slope else 0.0
            assert violations(run.trace[SIGNALS[i]], name, jerk) == [], seed
        walked = found[np.asarray(run.trace["HLI.RETRACE"]) > 0]
        assert farthest(walked[::37], plain) < 0.05, seed


class Returner:
    """Goes back from a tick on, forward again from another one on."""

    def __init__(self, back: int, forward: int) -> None:
        self.back, self.forward = back, forward

    def cycle(self, hli: PlcView) -> None:
        hli.backward_motion = self.back <= hli.tick < self.forward


def test_the_way_back_passes_block_ends_with_a_limit_of_the_jerk() -> None:
    """MO-3, MO-7: a line in pieces, and an arc after it, are walked back without a stop.

    60 mm in 20 blocks at 100 mm/s, the quarter of 50 mm at 61 mm/s (0.7 of the jerk of a tick).
    """
    lines = "\n".join(f"X{3 * (i + 1)}" for i in range(20))
    text = f"{JERK_LIMITED}\nG01 F6000\n{lines}\nG03 X110 Y50 I0 J50\nG01 Y90\nM30"
    run = Controller(DEMO).run(
        NcText("p.nc", text), signals=[*SIGNALS, "PATH.SPEED"], plc=Returner(1800, 5000)
    )
    assert run.trace is not None
    speed = np.asarray(run.trace["PATH.SPEED"])
    back = np.asarray(run.trace["HLI.RETRACE"]) == 1
    stands = np.flatnonzero((speed[1:] == 0.0) & (speed[:-1] > 0.0)) + 1
    assert speed[back].max() == pytest.approx(100.0)
    assert [run.trace.at(int(tick), SIGNALS[0]) for tick in stands if 1900 < tick < 5000] == [0.0]
    for i, name in enumerate(AXES):
        assert violations(run.trace[SIGNALS[i]], name, MAX_JERK_MM) == []


def test_the_way_back_passes_rounded_corners_with_a_limit_of_the_jerk() -> None:
    """MO-3, MO-7: backward and forward the path is only where it turns, and at its two ends.

    1 mm beside the corners the axes keep their jerk at 100 mm/s. The path turns in the last block,
    which is its front, and begins where the bend ends: 6 mm/(2·sin 22.5°) after the corner.
    """
    contour = "#CONTOUR MODE [DEV PATH_DEV=1]\nG261"
    text = NcText("p.nc", f"{JERK_LIMITED}\n{contour}\nG01 X60 F6000\nX100 Y40\nY100\nM30")
    signals = [*SIGNALS, "PATH.SPEED"]
    run = Controller(DEMO).run(text, signals=signals, plc=Returner(1500, 4500))
    straight = Controller(DEMO).run(text, signals=signals)
    assert run.trace is not None
    assert straight.trace is not None
    speed = np.asarray(run.trace["PATH.SPEED"])
    stands = np.flatnonzero((speed[1:] == 0.0) & (speed[:-1] > 0.0)) + 1
    found = places(run)
    half = 6.0 / (2.0 * math.sin(math.pi / 8.0))
    assert found[stands, 0].tolist() == [100.0, 0.0, 100.0, 100.0]
    assert found[stands[1:], 1] == pytest.approx([0.0, 40.0 + half, 100.0])
    at_corner = (found[:, 0] > 55.0) & (found[:, 0] < 95.0)
    assert speed[at_corner].min() == pytest.approx(100.0)
    assert (found[-1] == places(straight)[-1]).all()
    for i, name in enumerate(AXES):
        assert violations(run.trace[SIGNALS[i]], name, MAX_JERK_MM) == []


def test_the_way_back_has_the_override_of_each_block() -> None:
    """MO-5: from a block with G166 at 100 mm/s into one at 20 % of them, fast only up to it."""

    class Slow(Returner):
        def cycle(self, hli: PlcView) -> None:
            super().cycle(hli)
            hli.override_pct = 20.0

    text = "G01 X50 F6000\nG166 X100\nM30"
    signals = [*SIGNALS, "PATH.SPEED"]
    run = Controller(DEMO).run(NcText("p.nc", text), signals=signals, plc=Slow(2950, 6000))
    assert run.trace is not None
    x, speed = np.asarray(run.trace[SIGNALS[0]]), np.asarray(run.trace["PATH.SPEED"])
    back = np.asarray(run.trace["HLI.RETRACE"]) == 1
    assert speed[back].max() == pytest.approx(100.0)
    assert speed[back & (x < 50.0)].max() == pytest.approx(20.0)
    assert violations(x, "X") == []


@pytest.mark.parametrize("way", ["reset", "error"])
@pytest.mark.parametrize("slope", ["", JERK_LIMITED])
@pytest.mark.parametrize("seed", range(6))
def test_a_stop_in_any_tick_of_the_way_back_stays_on_the_path(
    seed: int, slope: str, way: str
) -> None:
    """MO-6: a reset and a fault of a realtime cycle brake within the limits, on the curve."""
    chance = random.Random(seed)
    text = program(seed, slope)
    plain = places(performed(seed, slope, None))
    fault = "#RT CYCLE [ID = 1 SCOPE = PROG]\n$IF V.E.VALUE > 0\nV.E.COUNT = 1 / 0\n$ENDIF\n"
    controller = Controller(DEMO)
    controller.start(NcText("p.nc", f"{fault}#RT CYCLE END\n{text}"))
    found = []

    def go(ticks: int) -> None:
        for _ in range(ticks):
            controller.step(1)
            found.append([float(controller.read(f"V.RTA.ACS.ACT_POS.{name}")) for name in AXES])

    go(chance.randint(1, 800))
    controller.backward()
    go(chance.randint(1, 600))
    if way == "reset":
        machine_of(controller).channels[0].request_reset()
    else:
        controller.write("V.E.VALUE", 1.0)
    go(400)
    walked = np.asarray(found)
    for i, name in enumerate(AXES):
        assert violations(walked[:, i], name, MAX_JERK_MM if slope else 0.0) == []
        assert walked[-1][i] == walked[-2][i]
    walked[:, 3] = np.unwrap(walked[:, 3], period=360.0)
    assert farthest(walked[-1:], np.concatenate([np.zeros((1, 4)), plain])) < 0.05

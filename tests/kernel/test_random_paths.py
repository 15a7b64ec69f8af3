# SPDX-License-Identifier: MIT
"""Random programs keep every axis within its limits in every tick (MO-1, MO-5, MO-6)."""

from __future__ import annotations

import random
from collections.abc import Callable

import numpy as np
import pytest
from support.insides import machine_of
from support.kernel_rig import DEMO
from support.random_paths import AXES, flowing, program, violations
from support.random_seeds import seeds_in_parts

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

SIGNALS = [f"{name}.ACS.ACT_POS" for name in AXES]
JERK_LIMITED = "#SLOPE [TYPE=TRAPEZ]"
#: 4000 mm/s² in 50 ms, per tick³.
MAX_JERK_MM = 8e-5


class Operator:
    """Turns the override and holds the feed at random, for the first three seconds."""

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        self.next_tick = 1

    def cycle(self, hli: PlcView) -> None:
        if hli.tick < self.next_tick:
            return
        self.next_tick = hli.tick + self.chance.choice((1, 5, 40, 150))
        is_over = hli.tick > 3000
        hli.override_pct = 100.0 if is_over else self.chance.choice((0.0, 3.0, 50.0, 80.0, 100.0))
        hli.feed_hold = not is_over and self.chance.random() < 0.2


def performed(
    seed: int,
    slope: str = "",
    plc: Operator | None = None,
    make: Callable[[int, str], str] = program,
) -> Run:
    """The run of a random program, within the limits."""
    text = NcText("p.nc", make(seed, slope))
    run = Controller(DEMO).run(text, signals=SIGNALS, ticks=400_000, plc=plc)
    assert run.state == "ended", (seed, run.diagnostics)
    assert run.trace is not None
    for name, signal in zip(AXES, SIGNALS, strict=True):
        jerk = MAX_JERK_MM if slope else 0.0
        assert violations(run.trace[signal], name, jerk) == [], seed
    return run


@seeds_in_parts(120, 6, 20)
def test_random_programs_keep_the_limits(seeds: range) -> None:
    """Speed and acceleration of each axis in each tick, and the program comes to its end."""
    for seed in seeds:
        performed(seed)


@seeds_in_parts(16, 3, 8)
def test_random_programs_keep_the_limit_of_the_jerk(seeds: range) -> None:
    """MO-2: with the jerk-limited slope the jerk of each axis as well."""
    for seed in seeds:
        performed(seed, JERK_LIMITED)


@pytest.mark.parametrize("is_held", [False, True])
@pytest.mark.parametrize("slope", ["", JERK_LIMITED])
@seeds_in_parts(16, 3, 8)
def test_paths_that_flow_keep_the_limits(seeds: range, slope: str, is_held: bool) -> None:
    """MO-3: tangential transitions, which the path passes; also with override and feed hold."""
    for seed in seeds:
        performed(seed, slope, Operator(seed) if is_held else None, flowing)


@pytest.mark.parametrize("slope", ["", JERK_LIMITED])
@seeds_in_parts(16, 3, 8)
def test_override_and_hold_keep_the_limits_and_the_path(seeds: range, slope: str) -> None:
    """In any tick: the limits hold, and the axes are where they would have been without."""
    for seed in seeds:
        disturbed = performed(seed, slope, Operator(seed))
        assert disturbed.trace is not None
        if seed == seeds.start:
            assert_on_the_path(disturbed, performed(seed, slope))


def assert_on_the_path(disturbed: Run, plain: Run) -> None:
    """Every place of one run is on the line through the places of the other one."""
    assert disturbed.trace is not None
    assert plain.trace is not None
    line = np.array([plain.trace[name] for name in SIGNALS[:3]]).T
    line = np.concatenate([np.zeros((1, 3)), line])
    places = np.array([disturbed.trace[name] for name in SIGNALS[:3]]).T
    for place in places[::37]:
        near = np.abs(line - place).max(axis=1).argsort()[:2].min()
        window = line[max(near - 2, 0) : near + 4]
        begin, way = window[:-1], np.diff(window, axis=0)
        length2 = np.maximum((way * way).sum(axis=1), 1e-300)
        part = np.clip(((place - begin) * way).sum(axis=1) / length2, 0.0, 1.0)
        away = np.linalg.norm(begin + part[:, None] * way - place, axis=1).min()
        assert away < 0.1


@pytest.mark.parametrize("slope", ["", JERK_LIMITED])
@pytest.mark.parametrize("seed", range(8))
def test_a_reset_in_any_tick_brakes_within_the_limits(seed: int, slope: str) -> None:
    """RC-007, MO-6: the path stops at its limits; the axes are on what was programmed."""
    chance = random.Random(seed)
    controller = Controller(DEMO)
    controller.start(NcText("p.nc", program(seed, slope)))
    found: dict[str, list[float]] = {name: [] for name in AXES}
    is_due = chance.randint(1, 1500)
    for tick in range(is_due + 600):
        if tick == is_due:
            machine_of(controller).channels[0].request_reset()
        controller.step(1)
        for name in AXES:
            found[name].append(float(controller.read(f"V.RTA.ACS.ACT_POS.{name}")))
    for name in AXES:
        jerk = MAX_JERK_MM if slope else 0.0
        assert violations(found[name], name, jerk) == []
        assert found[name][-1] == found[name][-2]

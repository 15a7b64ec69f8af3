# SPDX-License-Identifier: MIT
"""Random programs of all that the path can do keep limits, way and ends (MO-1 … MO-7)."""

from __future__ import annotations

import random

import pytest
from support.motion_checks import SIGNALS, violations
from support.motion_machines import machine
from support.motion_programs import MotionProgram, WeightedProgram
from support.random_seeds import seeds_in_parts

from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

#: The operator lets go after this time.
PLAY_US = 3_000_000

#: A slow program is looked at as far as it comes in this many ticks.
MAX_TICKS = 25_000

SLOPES = (("STEP",), ("TRAPEZ",), ("STEP", "TRAPEZ"))
#: What ends a program otherwise: contours that the tool's radius does not fit into.
CONTOUR_ERRORS = {90008, 90017, 90109}


def disturbances(seed: int) -> list[Stimulus]:
    """What the operator does: override through 0 and above 100 %, hold, single block, backward."""
    chance = random.Random(seed)
    kinds = [name for name in ("override", "hold", "single", "backward") if chance.random() < 0.3]
    made: list[Stimulus] = []
    for kind in kinds:
        time_us = 0
        while (time_us := time_us + chance.choice((1, 5, 40, 150, 400)) * 1000) < PLAY_US:
            if kind == "override":
                value = chance.choice((0.0, 3.0, 50.0, 100.0, 120.0))
                made.append(Stimulus(f"{time_us} us", "HLI.OVERRIDE", value))
            elif kind == "hold":
                made.append(
                    Stimulus(f"{time_us} us", "HLI.FEED_HOLD", float(chance.random() < 0.2))
                )
            elif kind == "single":
                made.append(
                    Stimulus(f"{time_us} us", "HLI.SINGLE_BLOCK", float(chance.random() < 0.3))
                )
                made.append(Stimulus(f"{time_us + 30_000} us", "HLI.START", 1.0))
            else:
                made.append(
                    Stimulus(f"{time_us} us", "HLI.BACKWARD_MOTION", float(chance.random() < 0.4))
                )
    ends = (
        ("OVERRIDE", 100.0),
        ("FEED_HOLD", 0.0),
        ("SINGLE_BLOCK", 0.0),
        ("BACKWARD_MOTION", 0.0),
    )
    made += [Stimulus(f"{PLAY_US} us", f"HLI.{name}", value) for name, value in ends]
    for wait_us in (500_000, 2_000_000, 5_000_000, 10_000_000):
        made.append(Stimulus(f"{PLAY_US + wait_us} us", "HLI.START", 1.0))
    return made if kinds else []


def wrong_with(seed: int, kind: type[MotionProgram] = MotionProgram) -> list[str]:
    """What is wrong with the run of a seed's program."""
    program = kind(seed, SLOPES[seed // 4 % 3])
    chosen = machine(seed % 4)
    run = Controller(chosen.configuration).run(
        NcText("p.nc", program.text),
        signals=SIGNALS,
        ticks=MAX_TICKS,
        at=disturbances(seed),
        record_writes=False,
    )
    ids = {error.id for error in run.errors}
    if run.state == "error" and not (program.has_compensation and ids <= CONTOUR_ERRORS):
        return [f"{[error.text for error in run.errors]}"]
    return violations(program, run, chosen)


@pytest.mark.nightly
@seeds_in_parts(200, 8, 20)
def test_programs_of_all_motions_keep_limits_way_and_ends(seeds: range) -> None:
    """MO-1: in each tick, with all that an operator may do in any tick."""
    for seed in seeds:
        assert wrong_with(seed) == [], seed


@seeds_in_parts(50, 4, 8)
def test_programs_with_weights_keep_limits_way_and_ends(seeds: range) -> None:
    """MO-1: also where weights, limits of the path and modes of contouring change."""
    for seed in seeds:
        assert wrong_with(seed, WeightedProgram) == [], seed

# SPDX-License-Identifier: MIT
"""Random programs whose realtime cycles and path move the same axes (RC-409, MO-1, MO-13).

So do commands of programs beside the path (SA-1 … SA-17). Some programs end with an error, which is
a way to end as well; none may make an axis jump. Nor may a PLC that commands the same axes, holds
the feed, changes the override and presses START and RESET.
"""

from __future__ import annotations

import numpy as np
from support.random_seeds import seeds_in_parts
from support.single_axis_programs import Generator, RandomPlc

from nctakt.results.run import Run
from nctakt.run.controller import Controller
from nctakt.run.program_loader import NcText

#: Highest way of an axis in a tick of 1 ms: 500 mm/s, 360 degrees/s.
HIGHEST = {"X": 0.5, "Y": 0.5, "Z": 0.5, "A": 0.36}
#: Highest change of that way from tick to tick: 4000 mm/s² and degrees/s².
HIGHEST_CHANGE = 0.004
TICKS = 20_000

#: What a program may end with: an axis that is not free, a start elsewhere, too many actions, …
EXPECTED_ERRORS = {50858, 50967, 51028, 900420, 50603, 1704, 50766}


def assert_within_limits(run: Run, seed: int) -> None:
    """MO-1: the speed and the acceleration of each axis, tick by tick."""
    assert run.trace is not None
    for axis, maximum in HIGHEST.items():
        steps = np.diff(run.trace[f"{axis}.ACS.ACT_POS"], prepend=0.0)
        if axis == "A":
            steps = (steps + 180.0) % 360.0 - 180.0
        assert np.abs(steps).max(initial=0.0) <= maximum * (1 + 1e-9), (seed, axis)
        changes = np.diff(steps, prepend=0.0)
        assert np.abs(changes).max(initial=0.0) <= HIGHEST_CHANGE * (1 + 1e-6), (seed, axis)


def run_of(seed: int) -> Run:
    """A run of the program of this seed."""
    program = NcText(f"seed{seed}.nc", Generator(seed).program())
    return Controller().run(program, ticks=TICKS)


@seeds_in_parts(50, 4, 25)
def test_no_axis_moves_or_changes_faster_than_it_can(seeds: range) -> None:
    """RC-409, MO-1: no command position ever changes by more than the axis' speed × tick.

    Nor does its change by more than its acceleration allows, whatever ends the program.
    """
    ended = 0
    for seed in seeds:
        run = run_of(seed)
        assert_within_limits(run, seed)
        found = {error.id for error in run.errors}
        assert found <= EXPECTED_ERRORS, seed
        ended += not found
    assert ended > len(seeds) // 4


@seeds_in_parts(20, 4, 10)
def test_nor_does_it_with_a_plc_that_commands_them(seeds: range) -> None:
    """MO-1, MO-13, RC-007: every second run waits for START, so that RESET does not end it."""
    for seed in seeds:
        program = NcText(f"seed{seed}.nc", Generator(seed).program())
        plc = RandomPlc(seed)
        waits = seed % 2 == 0
        run = Controller().run(program, ticks=3000, plc=plc, wait_for_start=waits)
        assert_within_limits(run, seed)
        assert {error.id for error in run.errors} <= EXPECTED_ERRORS | {50900}, seed


@seeds_in_parts(16, 2, 8)
def test_nor_with_commands_of_the_program_beside_the_path(seeds: range) -> None:
    """MO-1, SA-5, SA-16: program, cycles and the PLC command the same axes at once."""
    seen = set()
    for seed in seeds:
        program = NcText(f"seed{seed}.nc", Generator(seed, is_alone=True).program())
        plc = RandomPlc(seed) if seed % 4 else None
        run = Controller().run(program, ticks=3000, plc=plc)
        assert_within_limits(run, seed)
        found = {error.id for error in run.errors}
        assert found <= EXPECTED_ERRORS | {50900, 900810}, (seed, run.errors)
        seen |= {event.text.split()[2] for event in run.events if " oscillating " in event.text}
    assert "oscillating" in seen

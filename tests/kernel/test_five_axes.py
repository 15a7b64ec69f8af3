# SPDX-License-Identifier: MIT
"""Five axes under a transformation: the tip stays on its line, the axes within their limits.

MO-1, MO-8, and the tip within 1e-6 mm of the programmed line. ``NCTAKT_SEEDS=10000`` makes as many
programs.
"""

from __future__ import annotations

import numpy as np
from five_axis_programs import (
    ACCELERATION,
    JERK,
    NAMES,
    SPEED,
    TICK_S,
    FiveAxisProgram,
    five_axis_program,
    machine,
    tips,
)
from random_seeds import seeds_in_parts

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

SIGNALS = [*(f"{name}.ACS.ACT_POS" for name in NAMES), "BLOCK", "X.MCS.ACT_POS"]


def run_of(program: FiveAxisProgram) -> Run:
    """The program's run, with the trace of ``SIGNALS``."""
    return Controller(machine()).run(
        NcText("five.nc", program.text), ticks=400_000, signals=SIGNALS
    )


def positions(run: Run) -> np.ndarray:
    """The axes' positions behind each tick; the modulo axis as it runs on."""
    assert run.trace is not None
    places = np.array([run.trace[name] for name in SIGNALS[:5]]).T
    places[:, 3] = np.unwrap(np.concatenate([[0.0], places[:, 3]]), period=360.0)[1:]
    return places


def broken_limits(places: np.ndarray, has_jerk_limit: bool) -> list[str]:
    """Where an axis moves faster than it may, or changes its speed or acceleration more."""
    path = np.concatenate([np.zeros((3, 5)), places, *([places[-1:]] * 3)])
    found = []
    limits = [("speed", 1, SPEED), ("acceleration", 2, ACCELERATION)]
    if has_jerk_limit:
        limits.append(("jerk", 3, JERK))
    for what, order, maximum in limits:
        sizes = np.abs(np.diff(path, order, axis=0)) / TICK_S**order
        for axis, name in enumerate(NAMES):
            worst = sizes[:, axis].max() / maximum[axis]
            if worst > 1 + 1e-6 + 1e-12 / TICK_S**order / maximum[axis]:
                tick = int(sizes[:, axis].argmax())
                found.append(f"{name}: {what} {worst:.4f} of its limit, tick {tick}")
    return found


def off_the_way(program: FiveAxisProgram, places: np.ndarray, run: Run) -> list[str]:
    """The blocks in which the tip leaves its line, or the rotary axes do not come along."""
    assert run.trace is not None
    numbers = np.asarray(run.trace["BLOCK"]).astype(int)
    found = []
    for number, (start, end) in program.ways.items():
        ticks = np.flatnonzero(numbers == number)[
            :-1
        ]  # a block's last tick may reach into the next
        if not len(ticks) or not (start != end).any():
            continue
        at = np.column_stack([tips(places[ticks], program.kinematic), places[ticks, 3:]])
        way = end - start
        away = at - start
        shape = way / np.linalg.norm(way)
        along = np.clip(away @ shape, 0.0, np.linalg.norm(way))
        off = np.abs(away - along[:, None] * shape).max()
        if off > 1e-6:
            found.append(f"N{number}: {off:.3g} mm off its way")
    return found


@seeds_in_parts(compiled=40, plain=1, part=10)
def test_the_tip_stays_on_its_line_and_the_axes_within_their_limits(seeds: range) -> None:
    for seed in seeds:
        program = five_axis_program(seed)
        run = run_of(program)
        assert not run.diagnostics, (seed, [str(one) for one in run.diagnostics])
        places = positions(run)
        found = broken_limits(places, program.has_jerk_limit)
        found += off_the_way(program, places, run)
        assert not found, (seed, found)

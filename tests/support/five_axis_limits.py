# SPDX-License-Identifier: MIT
"""Runs of five-axis programs against the limits of their axes."""

from __future__ import annotations

import numpy as np

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from support.five_axis_programs import (
    ACCELERATION,
    JERK,
    NAMES,
    SPEED,
    TICK_S,
    FiveAxisProgram,
    machine,
)

SIGNALS = [*(f"{name}.ACS.ACT_POS" for name in NAMES), "BLOCK", "X.MCS.ACT_POS"]


def run_of(program: FiveAxisProgram) -> Run:
    """The program's run, with the trace of ``SIGNALS``."""
    return Controller(machine()).run(
        NcText("five.nc", program.text), ticks=400_000, signals=SIGNALS
    )


def positions(run: Run) -> np.ndarray:
    """The axes' positions after each tick; the modulo axis as it runs on."""
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

# SPDX-License-Identifier: MIT
"""Five axes under a transformation: the tip stays on its line, the axes within their limits.

MO-1, MO-8, and the tip within 1e-6 mm of the programmed line. ``NCTAKT_SEEDS=10000`` makes as many
programs.
"""

from __future__ import annotations

import numpy as np
from support.five_axis_limits import broken_limits, positions, run_of
from support.five_axis_programs import (
    FiveAxisProgram,
    five_axis_program,
    tips,
)
from support.random_seeds import seeds_in_parts

from nctakt.results.run import Run


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

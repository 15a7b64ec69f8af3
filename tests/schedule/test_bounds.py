# SPDX-License-Identifier: MIT
"""The responses of the analysis are never below those of a simulation.

``NCTAKT_SEEDS=1000000`` tries as many random lists, else 10 000, from the seed ``NCTAKT_FIRST`` on.
"""

from __future__ import annotations

import os
from dataclasses import replace

import pytest
from random_models import phases, random_model

from nctakt.schedule.analyse import analyse
from nctakt.schedule.model import Model
from nctakt.schedule.self_check import contradictions
from nctakt.schedule.simulate import hyperperiod, simulate

MANY = int(os.environ.get("NCTAKT_SEEDS", "") or "10000")
FIRST = int(os.environ.get("NCTAKT_FIRST", "") or "0")
#: The seeds are tried in so many tests, for several processes and a shorter list when one fails.
PARTS = 10


def simulated(model: Model) -> int:
    """So many NC cycles show what there is to see."""
    return 2 * hyperperiod(model) + 4


@pytest.mark.parametrize("part", range(PARTS))
def test_no_simulation_exceeds_its_bound(part: int) -> None:
    """Random lists of all kinds: no response, no overflow that the analysis excludes.

    A response that is called exact is the longest one of the simulation.
    """
    exact = 0
    for seed in range(FIRST + part, FIRST + MANY, PARTS):
        model = random_model(seed)
        analysis = analyse(model)
        run = simulate(model, simulated(model), record=0)
        found = contradictions(analysis, run)
        assert found == [], (seed, found)
        for task, numbers in zip(analysis.tasks, run.tasks, strict=True):
            if task.is_exact and numbers.due:
                exact += 1
                assert task.response == numbers.response_max, seed
    assert exact > MANY // PARTS // 5


@pytest.mark.parametrize("part", range(PARTS))
def test_worst_phase_is_a_bound_for_all_phases(part: int) -> None:
    """A load that names no phase: the bound holds for each of them."""
    for seed in range(FIRST + part, FIRST + MANY // 10, PARTS):
        model = random_model(seed)
        unknown = replace(model, train=replace(model.train, is_phase_known=False))
        analysis = analyse(unknown)
        for phase in phases(model):
            shifted = replace(unknown, train=replace(unknown.train, phase=phase))
            run = simulate(shifted, simulated(model), record=0)
            found = contradictions(analysis, run)
            assert found == [], (seed, phase, found)

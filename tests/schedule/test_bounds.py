# SPDX-License-Identifier: MIT
"""The responses of the analysis are never below those of a simulation."""

from __future__ import annotations

from dataclasses import replace

from support.random_models import phases, random_model
from support.random_seeds import seeds_in_parts

from nctakt.schedule.analysis.analyse import analyse
from nctakt.schedule.analysis.self_check import contradictions
from nctakt.schedule.model import Model
from nctakt.schedule.simulation.simulate import hyperperiod, simulate


def simulated(model: Model) -> int:
    """This many NC cycles show what there is to see."""
    return 2 * hyperperiod(model) + 4


@seeds_in_parts(2_500, 300, 500)
def test_no_simulation_exceeds_its_bound(seeds: range) -> None:
    """Random lists of all kinds: no response, no overflow that the analysis excludes.

    A response that is called exact is the longest one of the simulation.
    """
    exact = 0
    for seed in seeds:
        model = random_model(seed)
        analysis = analyse(model)
        run = simulate(model, simulated(model), record=0)
        found = contradictions(analysis, run)
        assert found == [], (seed, found)
        for task, numbers in zip(analysis.tasks, run.tasks, strict=True):
            if task.is_exact and numbers.due:
                exact += 1
                assert task.response == numbers.response_max, seed
    assert exact > len(seeds) // 8


@seeds_in_parts(300, 60, 100)
def test_worst_phase_is_a_bound_for_all_phases(seeds: range) -> None:
    """A load that names no phase: the bound holds for each of them."""
    for seed in seeds:
        model = random_model(seed)
        unknown = replace(model, train=replace(model.train, is_phase_known=False))
        analysis = analyse(unknown)
        for phase in phases(model):
            shifted = replace(unknown, train=replace(unknown.train, phase=phase))
            run = simulate(shifted, simulated(model), record=0)
            found = contradictions(analysis, run)
            assert found == [], (seed, phase, found)

# SPDX-License-Identifier: MIT
"""Further simulations with the worst phases of an NC interrupt of unknown phase.

In: ``Simulation``. Out: one simulation for each phase that the analysis calls the worst for a
thread; none where the phase is known, or makes no difference.
"""

from __future__ import annotations

from dataclasses import replace

from nctakt.schedule.analysis.analyse import analyse
from nctakt.schedule.simulation.results import Simulation
from nctakt.schedule.simulation.simulate import simulate


def simulate_worst_phases(run: Simulation) -> dict[int, Simulation]:
    """Return the simulations of as many cycles, by phase in ns."""
    model = run.model
    if model.train.is_phase_known:
        return {}
    phases = sorted(set(analyse(model).phases.values()))
    return {
        phase: simulate(
            replace(model, train=replace(model.train, phase=phase)), run.cycles, record=0
        )
        for phase in phases
    }

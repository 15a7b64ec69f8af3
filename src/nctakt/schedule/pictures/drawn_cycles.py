# SPDX-License-Identifier: MIT
"""The NC cycles that pictures and traces show by default.

In: ``Model`` and the number of NC cycles. Out: ``Simulation`` with a record of the cycles up to the
end of the first repetition, of one repetition if that is too much, or of those around the first
overflow. An overflow that occurs is always among them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nctakt.schedule.model import Model
from nctakt.schedule.simulation.results import Simulation
from nctakt.schedule.simulation.simulate import hyperperiod, simulate

#: Default maximum number of NC cycles in a picture.
MAX_DRAWN = 60
#: NC cycles before the first overflow, and as many from it on, where the others are too many.
AROUND_OVERFLOW = 8


def simulate_shown(model: Model, cycles: int) -> Simulation:
    """Simulate ``cycles`` NC cycles and record those that a picture shows."""
    run = simulate(model, cycles, record=min(hyperperiod(model), MAX_DRAWN))
    shown = shown_cycles(run)
    return run if shown == range(recorded_cycles(run)) else record_again(run, shown)


def shown_together(runs: Sequence[Simulation]) -> range:
    """Return the NC cycles that a picture of several simulations shows of each.

    Where they differ too much it shows those of the first simulation with an overflow.
    """
    shown = [shown_cycles(run) for run in runs]
    together = range(min(one.start for one in shown), max(one.stop for one in shown))
    if len(together) <= MAX_DRAWN:
        return together
    overflows = (one for run, one in zip(runs, shown, strict=True) if first_overflow(run) in one)
    return next(overflows, shown[0])


def record_again(run: Simulation, shown: range) -> Simulation:
    """Return a simulation with the record of these cycles."""
    last = min(shown.stop, run.cycles)
    again = simulate(run.model, last, record=shown, repeat=False)
    return replace(run, record=again.record)


def recorded_cycles(run: Simulation) -> int:
    """Return how many of the first NC cycles are recorded by default."""
    return min(hyperperiod(run.model), MAX_DRAWN, run.cycles)


def shown_cycles(run: Simulation) -> range:
    """Return the NC cycles that a picture of a simulation shows."""
    shown = range(recorded_cycles(run))
    if run.repeats_from is not None and run.repeats_after is not None:
        first, last = run.repeats_from, run.repeats_from + run.repeats_after
        if last <= MAX_DRAWN:
            shown = range(last)
        elif run.repeats_after <= MAX_DRAWN:
            shown = range(first, last)
    overflow = first_overflow(run)
    if overflow is None or shown.start <= overflow < shown.stop:
        return shown
    return range(max(0, overflow - AROUND_OVERFLOW), overflow + AROUND_OVERFLOW)


def first_overflow(run: Simulation) -> int | None:
    """Return the NC cycle of the first overflow, ``None`` without one."""
    times = [task.first_overflow for task in run.tasks if task.first_overflow is not None]
    if not times:
        return None
    train = run.model.train
    return (min(times) - train.phase + train.distance // 2) // train.distance

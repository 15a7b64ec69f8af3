# SPDX-License-Identifier: MIT
"""Whether an analysis holds for a simulation of the same model.

In: ``Analysis``, ``Simulation``. Out: the contradictions. There should be none: each is a fault of
the analysis or of the simulation.
"""

from __future__ import annotations

from nctakt.schedule.analysis.analyse import Analysis
from nctakt.schedule.simulation.results import Simulation


class AnalysisError(Exception):
    """A bound that a simulation exceeds: a fault of nctakt."""


def contradictions(analysis: Analysis, run: Simulation) -> list[str]:
    """Describe each task that answers later than its bound; times in ns."""
    errors: list[str] = []
    for task, bound, numbers in zip(run.model.tasks, analysis.tasks, run.tasks, strict=True):
        if bound.response is None:
            continue
        longest = numbers.response_max or 0
        if numbers.unfinished_since is not None:
            longest = max(longest, run.end - numbers.unfinished_since)
        if longest > bound.response:
            errors.append(f"{task.name}: response {longest} ns, bound {bound.response} ns")
        if numbers.overflows and not bound.can_overflow:
            errors.append(f"{task.name}: {numbers.overflows} overflows, none by the analysis")
    return errors


def check_bounds(analysis: Analysis, run: Simulation) -> None:
    """Raise ``AnalysisError`` where the simulation exceeds a bound."""
    if errors := contradictions(analysis, run):
        raise AnalysisError(
            "the analysis contradicts the simulation; please report it with rtconf.lis and load: "
            + "; ".join(errors)
        )

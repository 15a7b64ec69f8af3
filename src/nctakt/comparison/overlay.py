# SPDX-License-Identifier: MIT
"""A log as curves that lie over those of a run, with the stretches beyond the tolerances.

In: a comparison that keeps its overlaid samples. Out: for each signal points in ticks of the run.
If a log has more points than a screen, the lowest and the highest of each stretch are kept.
"""

from __future__ import annotations

import numpy
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.comparison.comparison import Comparison
from nctakt.comparison.deviations import Deviation, single_samples
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import LOG_THINNED

#: Points of a curve, and stretches that are marked, at most.
_MAX_POINTS, _MAX_STRETCHES = 4_000, 500


@dataclass(frozen=True, slots=True)
class LoggedCurve:
    """A signal in the log: times in ticks, values in the signal's unit.

    ``is_whole``: it has all samples. ``beyond``: begin and end of stretches, in ticks, in which the
    log is farther from the run than the tolerance.
    """

    signal: str
    ticks: list[float]
    values: list[float]
    is_whole: bool
    beyond: list[tuple[float, float]]


def logged_curves(comparison: Comparison) -> list[LoggedCurve]:
    """Return the log's curves in the order of the comparison."""
    return [_curve(one, comparison.recorded.cycle_time_us) for one in comparison.deviations]


def left_out(comparison: Comparison) -> list[Diagnostic]:
    """Return a note for each signal of which not all samples are kept (902844)."""
    found = []
    for one in comparison.deviations:
        kept = 0 if one.overlaid is None else len(one.overlaid.times)
        if kept < one.samples:
            name = one.pair.signal.name
            found.append(diagnostic(LOG_THINNED, name=name, kept=kept, count=one.samples))
    return found


def _curve(one: Deviation, cycle_time_us: int) -> LoggedCurve:
    both = one.overlaid
    assert both is not None
    ticks = both.times / cycle_time_us
    kept = _kept(both.values)
    beyond: list[tuple[float, float]] = []
    if one.tolerance is not None:
        is_beyond = both.sizes > one.tolerance
        is_beyond &= ~single_samples(is_beyond)
        edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([False], is_beyond, [False]))))
        pairs = zip(edges[::2], edges[1::2] - 1, strict=True)
        beyond = [(float(ticks[first]), float(ticks[last])) for first, last in pairs]
    return LoggedCurve(
        one.pair.signal.name,
        [round(tick, 3) for tick in ticks[kept].tolist()],
        [float(f"{value:.7g}") for value in both.values[kept].tolist()],
        len(kept) == len(ticks),
        beyond[:_MAX_STRETCHES],
    )


def _kept(values: NDArray[numpy.float64]) -> NDArray[numpy.int64]:
    """Return the indices of the points that stay, ascending."""
    if len(values) <= _MAX_POINTS:
        return numpy.arange(len(values))
    parts = numpy.array_split(numpy.arange(len(values)), _MAX_POINTS // 2)
    found = [part[[values[part].argmin(), values[part].argmax()]] for part in parts]
    return numpy.unique(numpy.concatenate(found))

# SPDX-License-Identifier: MIT
"""How far a log and a run are apart, signal by signal (LG-706).

Deviations are log minus run, at the log's own stamps. Values between ticks are linear; those of
whole numbers and truths are the tick's. What lasts a single sample is jitter of the stamps and is
no exceedance.
"""

from __future__ import annotations

import numpy
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.comparison.alignment import Alignment, Curve
from nctakt.comparison.log import Samples
from nctakt.comparison.mapping import Pair


@dataclass(frozen=True, slots=True, eq=False)
class Overlaid:
    """Both sides of a pair at the log's stamps, as times of the run in µs, to be drawn."""

    times: NDArray[numpy.float64]
    values: NDArray[numpy.float64]
    differences: NDArray[numpy.float64]


@dataclass(frozen=True, slots=True)
class Deviation:
    """How far a pair is apart; times are those of the run, in whole µs.

    ``samples``: those that lie within the run. ``first_us``: where it begins to be more than the
    tolerance for two samples or longer, ``None`` for nowhere or without a tolerance; ``beyond``:
    how many samples are; ``overlaid``: what a picture shows, if it is asked for.
    """

    pair: Pair
    samples: int
    greatest: float
    greatest_us: int
    mean: float
    rms: float
    percentile: float
    first_us: int | None
    beyond: int
    tolerance: float | None = None
    overlaid: Overlaid | None = None


def deviation_of(
    pair: Pair,
    samples: Samples,
    curve: Curve,
    alignment: Alignment,
    tolerance: float | None,
    *,
    is_drawn: bool = False,
) -> Deviation | None:
    """Return how far a pair is apart; ``None`` if no sample lies within the run."""
    times = alignment.run_times(samples.times)
    is_inside = (times >= 0.0) & (times <= curve.end_us)
    inside, values = times[is_inside], samples.values[is_inside]
    if not len(inside):
        return None
    if pair.signal.integral:
        ticks = (inside // curve.period_us).astype(numpy.int64)
        difference = values - curve.values[ticks]
        difference = numpy.where(_is_jitter(difference), 0.0, difference)
    else:
        difference = values - curve.at(inside)
    size = numpy.abs(difference)
    at = int(size.argmax())
    first, beyond = None, 0
    if tolerance is not None:
        is_beyond = ~single_samples(size > tolerance) & (size > tolerance)
        beyond = int(is_beyond.sum())
        first = _whole_us(inside[int(is_beyond.argmax())]) if beyond else None
    return Deviation(
        pair,
        len(inside),
        float(difference[at]),
        _whole_us(inside[at]),
        float(difference.mean()),
        float(numpy.sqrt((difference**2).mean())),
        float(numpy.percentile(size, 99.0)),
        first,
        beyond,
        tolerance,
        Overlaid(inside, values, difference) if is_drawn else None,
    )


def single_samples(is_beyond: NDArray[numpy.bool_]) -> NDArray[numpy.bool_]:
    """Return which samples have neighbours that are not beyond."""
    padded = numpy.concatenate(([False], is_beyond, [False]))
    single: NDArray[numpy.bool_] = ~(padded[:-2] | padded[2:])
    return single


def _is_jitter(
    difference: NDArray[numpy.float64],
) -> NDArray[numpy.bool_]:
    """Return which differences last a single sample."""
    differs = difference != 0.0
    found: NDArray[numpy.bool_] = differs & single_samples(differs)
    return found


def _whole_us(time: float) -> int:
    return round(float(time))

# SPDX-License-Identifier: MIT
"""How far a log and a run are apart, signal by signal (LG-706).

Deviations are log minus run, at the log's own stamps. Values between ticks are linear; those of
whole numbers and truths are the tick's. A single sample beyond the tolerance is jitter of the
stamps and not an exceedance. It works stretch by stretch, so that the length does not matter.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.comparison.alignment import Alignment, Curve
from nctakt.comparison.columns import Numbers, range_of, stretches
from nctakt.comparison.delays import BlockDelays
from nctakt.comparison.log import Samples
from nctakt.comparison.mapping import Pair, Tolerance

#: The share of the percentile that is reported.
_SHARE = 0.99
#: Samples that are kept: for a picture, which has fewer pixels; for a page, where one can zoom in;
#: for others, who get all samples. Beyond twice as many every other sample is dropped.
DRAWN, SHOWN, SHARED = 20_000, 200_000, 500_000
#: Times, values of the log, and log minus run.
_Part = tuple[Numbers, Numbers, Numbers]


@dataclass(frozen=True, slots=True, eq=False)
class Overlaid:
    """Both sides of a pair at the log's stamps, as times of the run in µs, to be drawn.

    ``sizes``: the values compared with the tolerance.
    """

    times: Numbers
    values: Numbers
    differences: Numbers
    sizes: Numbers


@dataclass(frozen=True, slots=True)
class Change:
    """A whole number becomes ``value`` on one side, the run's if ``is_run``, and not on the other.

    ``later_us``: how much later the other side has this value next, ``None`` if it never has.
    """

    is_run: bool
    value: float
    later_us: float | None


@dataclass(frozen=True, slots=True)
class Deviation:
    """How far a pair is apart; times are those of the run, in whole µs.

    ``samples``: those that lie within the run. ``first_us``: where it begins to be more than the
    tolerance for two samples or longer, ``None`` for nowhere or without a tolerance; ``beyond``:
    how many samples are. ``tolerance``: in the signal's unit, ``ticks`` earlier or later.
    ``overlaid``: the samples that are kept, if it is asked for. ``change``: of a whole number, at
    ``first_us`` or else where it is farthest.
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
    ticks: int = 0
    overlaid: Overlaid | None = None
    change: Change | None = None


def deviation_of(
    pair: Pair,
    samples: Samples,
    curve: Curve,
    alignment: Alignment,
    tolerance: Tolerance | None,
    *,
    delays: BlockDelays | None = None,
    kept: int = 0,
) -> Deviation | None:
    """Return the deviation of a pair; ``None`` if no sample lies within the run.

    ``delays`` gets its evidence for the time that the log is late; ``kept``: how many samples of
    both sides are kept at least, at most twice as many.
    """
    parts = beside(samples, curve, alignment, delays, is_whole=pair.signal.integral)
    if pair.signal.integral:
        parts = _without_jitter(parts)
    limit = None if tolerance is None else tolerance.amount
    if tolerance is not None and tolerance.is_share:
        limit = tolerance.amount / 100.0 * range_of(curve.values)
    around = 0 if tolerance is None else tolerance.ticks
    sums = DeviationSums(len(samples), limit)
    drawn = _Drawn(kept) if kept else None
    for times, values, differences in parts:
        sizes = numpy.abs(differences)
        if around:
            sizes = numpy.where(sizes > 0.0, curve.outside(times, values, around), 0.0)
        sums.add(times, differences, sizes)
        if drawn is not None:
            drawn.add(times, values, differences, sizes)
    if not sums.samples:
        return None
    sums.finish()
    place_us = sums.greatest_us if sums.first_us is None else sums.first_us
    change = _change(samples, curve, alignment, place_us) if pair.signal.integral else None
    return Deviation(
        pair,
        sums.samples,
        sums.greatest,
        _whole_us(sums.greatest_us),
        sums.mean,
        sums.rms,
        sums.percentile,
        None if sums.first_us is None else _whole_us(sums.first_us),
        sums.beyond,
        limit,
        around,
        None if drawn is None else drawn.overlaid(),
        change,
    )


def _change(samples: Samples, curve: Curve, alignment: Alignment, time_us: float) -> Change | None:
    """Return the change on one side alone at a sample; ``None`` if there is none."""
    before = alignment.between(samples, -numpy.inf, time_us - 0.5)
    after = alignment.between(samples, time_us - 0.5, numpy.inf)
    if not len(before) or not len(after):
        return None
    both = [before.part(len(before) - 1, len(before)), after.part(0, 1)]
    (was_us, was), (now_us, now) = (next(one.stretches()) for one in both)
    times = alignment.run_times(numpy.append(was_us, now_us))
    ours_was, ours = curve.of_ticks(numpy.clip(times, 0.0, curve.end_us))
    if ours == now[0]:
        return None
    if ours != ours_was:
        for stamps, values in after.stretches():
            found = numpy.flatnonzero(values == ours)
            if len(found):
                next_us = float(alignment.run_times(stamps[found[:1]])[0])
                return Change(True, float(ours), next_us - float(times[1]))
        return Change(True, float(ours), None)
    if now[0] == was[0]:
        return None
    first = int(times[1] // curve.period_us)
    for part in stretches(len(curve.values) - first):
        found = numpy.flatnonzero(curve.values[part.start + first : part.stop + first] == now[0])
        if len(found):
            next_us = (first + part.start + int(found[0])) * curve.period_us
            return Change(False, float(now[0]), next_us - float(times[1]))
    return Change(False, float(now[0]), None)


def beside(
    samples: Samples,
    curve: Curve,
    alignment: Alignment,
    delays: BlockDelays | None,
    *,
    is_whole: bool = False,
) -> Iterator[_Part]:
    """Yield times, values, and log minus run, of the samples that lie within the run.

    ``delays`` gets the evidence of a signal that is not ``is_whole`` for the time that it is late.
    """
    span = 0.0 if is_whole or delays is None else range_of(curve.values)
    for stamps, logged in samples.stretches():
        known = alignment.run_times(stamps)
        first = int(numpy.searchsorted(known, 0.0))
        end = int(numpy.searchsorted(known, curve.end_us, side="right"))
        if first == end:
            continue
        times, values = known[first:end], logged[first:end]
        ours = curve.of_ticks(times) if is_whole else curve.at(times)
        differences = values - ours
        if span > 0.0 and delays is not None:
            delays.add(times, differences / span, curve.slope_at(times) / span, ours / span)
        yield times, values, differences
    if delays is not None:
        delays.end_signal()


def _without_jitter(parts: Iterator[_Part]) -> Iterator[_Part]:
    """Yield parts in which no difference lasts a single sample."""
    held: _Part | None = None
    before = False
    for part in parts:
        times, values, differences = part
        if held is not None:
            times = numpy.append(held[0], times)
            values = numpy.append(held[1], values)
            differences = numpy.append(held[2], differences)
        differs = differences != 0.0
        cleaned = numpy.where(_has_neighbour(differs, before)[:-1], differences[:-1], 0.0)
        if len(cleaned):
            yield times[:-1], values[:-1], cleaned
            before = bool(differs[-2])
        held = times[-1:], values[-1:], differences[-1:]
    if held is not None:
        yield (*held[:2], held[2] if before else numpy.zeros(1))


class DeviationSums:
    """Gathers deviations stretch by stretch; ``count``: how many samples there are at most."""

    def __init__(self, count: int, tolerance: float | None) -> None:
        self._tolerance = tolerance
        self.samples = 0
        self.greatest = self.greatest_us = 0.0
        self._sum = self._squares = 0.0
        self._kept = int(count * (1.0 - _SHARE)) + 3
        self._top = numpy.empty(0)
        self._limit = -1.0
        self.first_us: float | None = None
        self.beyond = 0
        self._held = numpy.empty(0), numpy.empty(0, dtype=bool)
        self._before = False

    def add(self, times: Numbers, differences: Numbers, sizes: Numbers) -> None:
        """Add a stretch that is not empty; ``sizes`` count against the tolerance."""
        size = numpy.abs(differences)
        at = int(size.argmax())
        if not self.samples or size[at] > abs(self.greatest):
            self.greatest, self.greatest_us = float(differences[at]), float(times[at])
        self.samples += len(times)
        self._sum += float(differences.sum())
        self._squares += float((differences * differences).sum())  # `@` would start threads
        self._top = numpy.append(self._top, size[size > self._limit])
        if len(self._top) > 2 * self._kept:
            self._top = numpy.partition(self._top, -self._kept)[-self._kept :]
            self._limit = float(self._top[0])
        if self._tolerance is not None:
            self._count(times, sizes > self._tolerance)

    def _count(self, times: Numbers, is_beyond: NDArray[numpy.bool_]) -> None:
        """Count those beyond the tolerance; the last one waits for its neighbour."""
        times, is_beyond = (
            numpy.append(self._held[0], times),
            numpy.append(self._held[1], is_beyond),
        )
        counts = (is_beyond & _has_neighbour(is_beyond, self._before))[:-1]
        self._note(times, counts)
        self._before = bool(is_beyond[-2]) if len(is_beyond) > 1 else self._before
        self._held = times[-1:], is_beyond[-1:]

    def _note(self, times: Numbers, counts: NDArray[numpy.bool_]) -> None:
        if counts.any():
            if self.first_us is None:
                self.first_us = float(times[int(counts.argmax())])
            self.beyond += int(counts.sum())

    def finish(self) -> None:
        """Count the last sample, which has no successor."""
        times, is_beyond = self._held
        self._note(times, is_beyond & self._before)

    @property
    def mean(self) -> float:
        """The mean deviation."""
        return self._sum / self.samples

    @property
    def rms(self) -> float:
        """The root of the mean square."""
        return math.sqrt(self._squares / self.samples)

    @property
    def percentile(self) -> float:
        """The 99 % quantile of the absolute deviations, linear between two samples."""
        rank = _SHARE * (self.samples - 1)
        below = int(rank)
        top = numpy.sort(self._top)
        at = len(top) - (self.samples - below)
        low, high = float(top[at]), float(top[min(at + 1, len(top) - 1)])
        return low + (high - low) * (rank - below)


class _Drawn:
    """Keeps the samples to draw: each one, or at least ``count`` and at most twice as many."""

    def __init__(self, count: int) -> None:
        self._count = count
        self._stride = 1
        self._seen = 0
        self._kept: list[Numbers] = []

    def add(self, *part: Numbers) -> None:
        """Add a stretch."""
        begin = -self._seen % self._stride
        self._seen += len(part[0])
        self._kept.append(numpy.stack([one[begin :: self._stride] for one in part]))
        while sum(one.shape[1] for one in self._kept) > 2 * self._count:
            self._kept = [numpy.concatenate(self._kept, axis=1)[:, ::2]]
            self._stride *= 2

    def overlaid(self) -> Overlaid:
        """Return the kept samples."""
        return Overlaid(*numpy.concatenate(self._kept, axis=1))


def single_samples(is_beyond: NDArray[numpy.bool_]) -> NDArray[numpy.bool_]:
    """Return which samples have neighbours that are not beyond."""
    return ~_has_neighbour(is_beyond, False)


def _has_neighbour(marks: NDArray[numpy.bool_], before: bool) -> NDArray[numpy.bool_]:
    """Return which samples have a marked neighbour; ``before``: whether the one before is."""
    padded = numpy.concatenate(([before], marks, [False]))
    found: NDArray[numpy.bool_] = padded[:-2] | padded[2:]
    return found


def _whole_us(time: float) -> int:
    return round(float(time))

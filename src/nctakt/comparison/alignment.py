# SPDX-License-Identifier: MIT
"""The time of a log on the time of a run: offset and drift (LG-701 … LG-704).

First both are differentiated on a coarse grid and correlated; then the deviation at the log's own
stamps is made small by Huber's least squares over offset, drift, bias and gain. The log is never
resampled for what is reported, and bias and gain are reported, not removed.
"""

from __future__ import annotations

import bisect
from collections.abc import Sequence
from functools import partial

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.comparison.columns import STRETCH, Column, Numbers, range_of
from nctakt.comparison.log import Samples

#: The grid of the correlation, in µs; doubled until log and run have at most this many points.
_GRID_US, _MAX_GRID = 4000.0, 1 << 21
#: A second peak of this share of the first makes the answer ambiguous (LG-704).
_SECOND_PEAK = 0.95
#: Lowest correlation at which the alignment is trusted.
_MIN_QUALITY = 0.5
#: From this correlation on, and up to this distance of the gain from 1, it is sure.
_SURE_QUALITY, _SURE_GAIN = 0.9, 0.05
#: Shortest time from the first to the last motion for which a drift is reported, in µs.
_DRIFT_FROM_US = 60e6
#: Largest number of samples in the fit, and of its rounds.
_MAX_FITTED, _ROUNDS = 200_000, 30
#: A step of the offset below this ends the fit, in µs.
_SETTLED_US = 0.05
#: Smallest number of samples that can be aligned.
_MIN_SAMPLES = 5
#: A drift counts from this many standard errors on.
_SIGNIFICANT = 3.0
#: A gain and a bias count from this on, as shares of 1 and of the curve's span.
_MIN_SCALE = 1e-4
#: Residuals beyond this multiple of their typical size get less weight.
_HUBER = 1.345
#: Ticks that are read at a time; times that span more of them are divided.
_READ = 4 * STRETCH


_TWO = Text("two offsets fit equally well", "zwei Versätze passen gleich gut")


@dataclass(frozen=True, slots=True)
class Curve:
    """A signal of the run: its value at each tick, ``period_us`` apart, the first at 0."""

    period_us: float
    values: Column

    @property
    def end_us(self) -> float:
        """The time of its last value."""
        return self.period_us * (len(self.values) - 1)

    def at(self, times: Numbers) -> Numbers:
        """Return the values at times, linear between ticks; before and after, those at the ends."""
        return self._at(numpy.clip(times / self.period_us, 0.0, len(self.values) - 1))

    def slope_at(self, times: Numbers) -> Numbers:
        """Return the changes per µs over the tick around times."""
        half = self.period_us / 2.0
        return (self.at(times + half) - self.at(times - half)) / self.period_us

    def of_ticks(self, times: Numbers) -> Numbers:
        """Return the values of the ticks in which times lie."""
        return self._at(times // self.period_us)

    def outside(self, times: Numbers, values: Numbers, around: int) -> Numbers:
        """Return how far values are from all that the signal has within ``around`` ticks."""
        first = (times // self.period_us).astype(numpy.int64) - around
        wide, count = 2 * around + 2, len(self.values)  # both ticks beside a time, those around
        low, high = int(first.min()), int(first.max()) + wide
        missing = max(-low, 0), max(high - count, 0)
        part = numpy.pad(self.values[max(low, 0) : min(high, count)], missing, mode="edge")
        windows = numpy.lib.stride_tricks.sliding_window_view(part, wide)
        first -= low
        lowest, highest = windows.min(axis=1).take(first), windows.max(axis=1).take(first)
        away: Numbers = numpy.maximum(numpy.maximum(lowest - values, values - highest), 0.0)
        return away

    def _at(self, ticks: Numbers) -> Numbers:
        if not len(ticks):
            return ticks
        low, high = int(ticks.min()), int(ticks.max()) + 2
        if high - low > _READ and len(ticks) > 1:
            middle = len(ticks) // 2
            return numpy.concatenate((self._at(ticks[:middle]), self._at(ticks[middle:])))
        part = self.values[low:high]
        index = ticks.astype(numpy.int64)
        fraction = ticks - index
        index -= low
        found = part.take(index)
        index += 1
        after = part.take(index, mode="clip")
        after -= found
        after *= fraction
        found += after
        return found


@dataclass(frozen=True, slots=True)
class Alignment:
    """Where the log lies: its stamp t is ``offset_us`` + (1 + ``drift``) · the run's time.

    ``quality``: the correlation, 0 … 1; ``reason``: why there is no offset, ``None`` if there is
    one. ``gain`` and ``bias`` are those of the pair that it was found by.
    """

    offset_us: float
    drift: float = 0.0
    quality: float = 0.0
    gain: float = 1.0
    bias: float = 0.0
    reason: Text | None = None

    @property
    def is_scaled(self) -> bool:
        """Whether the log has a gain or a bias."""
        return abs(self.gain - 1.0) > _MIN_SCALE or self.bias != 0.0

    @property
    def is_uncertain(self) -> bool:
        """Whether the curves differ in more than time, so that their best place may be false."""
        return self.quality < _SURE_QUALITY or abs(self.gain - 1.0) > _SURE_GAIN

    def run_times(self, stamps: Numbers) -> Numbers:
        """Return the run's times of the log's stamps, in µs."""
        times: Numbers = (stamps - self.offset_us) / (1.0 + self.drift)
        return times

    def between(self, samples: Samples, begin_us: float, end_us: float) -> Samples:
        """Return the samples from a time of the run to before another one."""
        run_time = partial(_run_time, samples, self)
        first, last = (
            bisect.bisect_left(range(len(samples)), time_us, key=run_time)
            for time_us in (begin_us, end_us)
        )
        return samples.part(first, last)


def align(pairs: Sequence[tuple[Samples, Curve]]) -> Alignment:
    """Return where a log lies on the time of a run."""
    energies = [_energy(pair) for pair in pairs]
    moving = [pair for pair, energy in zip(pairs, energies, strict=True) if energy > 0.0]
    if not moving:
        return Alignment(0.0, reason=Text("nothing moves in both", "nichts bewegt sich in beiden"))
    offset, quality, second = _coarse(moving)
    if quality < _MIN_QUALITY:
        return Alignment(0.0, quality=quality, reason=_little(quality))
    if second > _SECOND_PEAK:
        return Alignment(0.0, quality=quality, reason=_TWO)
    return _fine(pairs[energies.index(max(energies))], offset, quality)


def aligned_before(
    pairs: Sequence[tuple[Samples, Curve]], alignment: Alignment, time_us: float
) -> Alignment:
    """Return the alignment by what the log has before a time of the run.

    A log that is late from some place on pulls the best offset of all of it to that side.
    """
    early = [(alignment.between(samples, -numpy.inf, time_us), curve) for samples, curve in pairs]
    best = max(early, key=_energy)
    if _energy(best) <= 0.0 or alignment.drift:
        return alignment
    found = _fine(best, alignment.offset_us, alignment.quality, may_drift=False)
    return found if _is_near(best, found) else alignment


def _run_time(samples: Samples, alignment: Alignment, at: int) -> float:
    return float(alignment.run_times(samples.times[at : at + 1])[0])


def _is_near(pair: tuple[Samples, Curve], found: Alignment) -> bool:
    """Return whether a fit has found a place within the run, and no other curve."""
    samples, curve = pair
    times = found.run_times(_fitted(samples)[0])
    inside = times[(times >= 0.0) & (times <= curve.end_us)]
    return len(inside) >= _MIN_SAMPLES and float(numpy.ptp(curve.at(inside))) > 0.0


def _little(quality: float) -> Text:
    return Text(
        f"the best correlation is {quality:.2f}", f"die beste Korrelation ist {quality:.2f}"
    )


def _energy(pair: tuple[Samples, Curve]) -> float:
    """Return how far a pair moves: the less of both sides' ranges."""
    samples, curve = pair
    if min(len(samples), len(curve.values)) < _MIN_SAMPLES:
        return 0.0
    return min(samples.span, range_of(curve.values))


def _coarse(pairs: Sequence[tuple[Samples, Curve]]) -> tuple[float, float, float]:
    """Return offset in µs, correlation, and the second peak's share of the first."""
    first = min(samples.first_us for samples, _ in pairs)
    last = max(samples.last_us for samples, _ in pairs)
    end = max(curve.end_us for _, curve in pairs)
    grid_us = _GRID_US
    while (last - first + end) / grid_us > _MAX_GRID:
        grid_us *= 2.0
    log_grid = numpy.arange(first, last + grid_us, grid_us)
    run_grid = numpy.arange(0.0, end + grid_us, grid_us)
    size = 1 << int(len(log_grid) + len(run_grid)).bit_length()
    spectrum = numpy.zeros(size // 2 + 1, dtype=numpy.complex128)
    weight = 0.0
    for samples, curve in pairs:
        ours = numpy.diff(curve.at(run_grid), prepend=curve.values[:1])
        others = numpy.diff(_at_grid(samples, log_grid), prepend=0.0)
        others[0] = 0.0
        norm = float(numpy.sqrt((ours**2).sum() * (others**2).sum()))
        if norm > 0.0:
            product = numpy.conj(numpy.fft.rfft(ours, size))
            product *= numpy.fft.rfft(others, size)
            product /= norm
            spectrum += product
            weight += 1.0
    total = numpy.fft.irfft(spectrum, size)
    total /= max(weight, 1.0)
    best = int(total.argmax())
    peak = float(total[best])
    width = _width(total, best)
    far = numpy.roll(total, -best)[width + 1 : size - width]
    second = float(far.max()) / peak if peak > 0.0 and len(far) else 0.0
    lag = best if best < size // 2 else best - size
    return first + lag * grid_us, peak, second


def _at_grid(samples: Samples, grid: Numbers) -> Numbers:
    """Return the values of a log at ascending times, linear between its samples."""
    found = numpy.empty(len(grid))
    done = 0
    before = numpy.empty(0), numpy.empty(0)
    for part in samples.stretches():
        times, values = (numpy.append(*one) for one in zip(before, part, strict=True))
        end = int(numpy.searchsorted(grid, times[-1], side="right"))
        found[done:end] = numpy.interp(grid[done:end], times, values)
        found[end:] = values[-1]
        done, before = end, (times[-1:], values[-1:])
    return found


def _width(total: Numbers, best: int) -> int:
    """Return how far the peak reaches: to where it has fallen to a half on both sides, doubled."""
    half = total[best] / 2.0
    rolled = numpy.roll(total, -best)
    right = int((rolled < half).argmax())
    left = int((rolled[::-1] < half).argmax()) + 1
    return 2 * max(left, right, 2)


def _fine(
    pair: tuple[Samples, Curve], coarse_us: float, quality: float, *, may_drift: bool = True
) -> Alignment:
    """Return the alignment near a coarse offset, by one pair."""
    samples, curve = pair
    stamps, values = _fitted(samples)
    may_drift = may_drift and _time_of_motion(stamps, curve, coarse_us) >= _DRIFT_FROM_US
    middle = float(stamps.mean())
    offset, drift, gain, bias = coarse_us, 0.0, 1.0, 0.0
    error = numpy.zeros(4)
    for _ in range(_ROUNDS):
        times = (stamps - offset) / (1.0 + drift)
        is_inside = (times >= 0.0) & (times <= curve.end_us)
        if is_inside.sum() < _MIN_SAMPLES:
            return Alignment(coarse_us, quality=quality)
        inside = times[is_inside]
        ours, slope = curve.at(inside), curve.slope_at(inside)
        columns = [-slope, numpy.ones_like(slope), ours]
        if may_drift:
            columns.append(-slope * (stamps[is_inside] - middle))
        matrix = numpy.stack(columns, axis=1)
        solution, error = _robust(matrix, values[is_inside] - ours)
        step = float(solution[0])
        gain, bias = 1.0 + float(solution[2]), float(solution[1])
        if may_drift:
            step += (offset - middle) * float(solution[3])
            drift += float(solution[3])
        offset += step
        if abs(step) < _SETTLED_US:
            break
    if may_drift and abs(drift) < _SIGNIFICANT * error[3]:
        return _fine(pair, coarse_us, quality, may_drift=False)
    min_bias = max(_SIGNIFICANT * float(error[1]), _MIN_SCALE * float(numpy.ptp(values)))
    return Alignment(offset, drift, quality, gain, bias if abs(bias) > min_bias else 0.0)


def _time_of_motion(stamps: Numbers, curve: Curve, offset_us: float) -> float:
    """Return how long it takes from the first to the last motion of the curve, in µs.

    Where a curve rests, nothing says whether the clocks differ.
    """
    moving = stamps[curve.slope_at(stamps - offset_us) != 0.0]
    return float(moving[-1] - moving[0]) if len(moving) else 0.0


def _fitted(samples: Samples) -> tuple[Numbers, Numbers]:
    """Return times and values of the samples that count in the fit."""
    parts = list(samples.stretches(max(1, len(samples) // _MAX_FITTED)))
    stamps, values = (numpy.concatenate(one) for one in zip(*parts, strict=True))
    return stamps, values


def _robust(matrix: Numbers, residual: Numbers) -> tuple[Numbers, Numbers]:
    """Return the solution of Huber's least squares and its standard errors."""
    weights = numpy.ones(len(residual))
    solution: Numbers = numpy.zeros(matrix.shape[1])
    left: Numbers = residual
    scale = numpy.abs(matrix).max(axis=0)
    scaled = matrix / numpy.where(scale > 0.0, scale, 1.0)
    for _ in range(5):
        root = numpy.sqrt(weights)
        found = numpy.linalg.lstsq(scaled * root[:, None], residual * root, rcond=None)
        solution = numpy.asarray(found[0], dtype=numpy.float64)
        left = residual - scaled @ solution
        size = float(numpy.median(numpy.abs(left))) / 0.6745
        if size <= 0.0:
            break
        weights = numpy.minimum(1.0, _HUBER * size / numpy.maximum(numpy.abs(left), 1e-300))
    spread = float((weights * left**2).sum()) / max(len(residual) - matrix.shape[1], 1)
    normal = numpy.linalg.pinv((scaled * weights[:, None]).T @ scaled)
    errors = numpy.sqrt(numpy.maximum(numpy.diag(normal) * spread, 0.0))
    divisor = numpy.where(scale > 0.0, scale, 1.0)
    return solution / divisor, errors / divisor

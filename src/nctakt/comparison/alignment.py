# SPDX-License-Identifier: MIT
"""The time of a log on the time of a run: offset and drift (LG-701 … LG-704).

First both are differentiated on a coarse grid and correlated; then the deviation at the log's own
stamps is made small by Huber's least squares over offset, drift, bias and gain. The log is never
resampled for reported values, and bias and gain are reported, not removed.

A delay is a step in time, a drift a slope: the log is followed window by window. The part before
its first step gives the start of the run, and the slope between steps the difference of the clocks.
"""

from __future__ import annotations

import bisect
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

import numpy
from numpy.typing import NDArray

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
#: Largest drift of two clocks; more is another speed.
_MAX_DRIFT = 1e-3
#: The windows in which a log is followed: their length in µs, and their largest number.
_WINDOW_US, _MAX_WINDOWS = 2e6, 400
#: How far from its neighbour a window is searched, in µs, and the correlation that it needs.
_REACH_US, _MIN_CORRELATION = 20e6, 0.9
#: A window counts if at most this share of its variance and this error in µs are left, and its
#: gain is as near to 1.
_MAX_LEFT, _MAX_ERROR_US, _MAX_GAIN = 1e-3, 1000.0, 0.1
#: The smallest number of windows between two steps, and of windows that say anything.
_MIN_WINDOWS, _MIN_FOLLOWED = 3, 6
#: The smallest step in µs, in standard errors, and the best accuracy of a window, in µs.
_MIN_STEP_US, _STEP_ERRORS, _EXACT_US = 100.0, 5.0, 1.0
#: A correlation counts as good as the best one from this share of it on.
_ALIKE = 0.98
#: The share of a span that counts as motion, and how far in µs the first motions of log and run may
#: be apart if the log has steps.
_MOTION, _BEGIN_US = 0.01, 1e5
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
        wide, count = 2 * around + 2, len(self.values)  # both ticks next to a time, those around
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
        """Return the samples from a time of the run to before another."""
        run_time = partial(_run_time, samples, self)
        first, last = (
            bisect.bisect_left(range(len(samples)), time_us, key=run_time)
            for time_us in (begin_us, end_us)
        )
        return samples.part(first, last)


def align(pairs: Sequence[tuple[Samples, Curve]], drift: float | None = None) -> Alignment:
    """Return where a log lies on the time of a run; ``drift``: that of the log if it is given."""
    if drift is None:
        return _aligned(pairs, _MAX_DRIFT)
    slowed = [
        (samples, replace(curve, period_us=(1.0 + drift) * curve.period_us))
        for samples, curve in pairs
    ]
    return replace(_aligned(slowed, 0.0), drift=drift)


def placed(
    pairs: Sequence[tuple[Samples, Curve]], stamp_us: float, run_us: float, drift: float | None
) -> Alignment:
    """Return the position of a log whose stamp is given as a time of the run.

    ``drift``: that of the log, ``None`` to find it.
    """
    if drift is None:
        drift = _drift(pairs, stamp_us - run_us)
    return Alignment(stamp_us - (1.0 + drift) * run_us, drift)


def _drift(pairs: Sequence[tuple[Samples, Curve]], offset_us: float) -> float:
    """Return the drift of a log near an offset, by the pair that moves farthest."""
    farthest = max(pairs, key=_energy, default=None)
    if farthest is None or _energy(farthest) <= 0.0:
        return 0.0
    followed = _Followed.along(farthest, offset_us, _MAX_DRIFT)
    return _fine(farthest, followed, 0.0).drift if followed.drift else 0.0


def _aligned(pairs: Sequence[tuple[Samples, Curve]], max_drift: float) -> Alignment:
    """Return where a log lies, with a drift up to a limit."""
    energies = [_energy(pair) for pair in pairs]
    moving = [pair for pair, energy in zip(pairs, energies, strict=True) if energy > 0.0]
    if not moving:
        return Alignment(0.0, reason=Text("nothing moves in both", "nichts bewegt sich in beiden"))
    offset, quality, second = _coarse(moving)
    farthest = pairs[energies.index(max(energies))]
    followed = _Followed.along(farthest, offset, max_drift)
    if followed.steps and _is_first(moving, followed) and _begins_with(farthest, followed):
        return _fine(farthest, followed, followed.quality(farthest))
    if quality < _MIN_QUALITY:
        return Alignment(0.0, quality=quality, reason=_little(quality))
    if second > _SECOND_PEAK:
        return Alignment(0.0, quality=quality, reason=_TWO)
    if followed.steps or not followed.drift:
        followed = _Followed((offset,))
    return _fine(farthest, followed, quality)


def aligned_before(
    pairs: Sequence[tuple[Samples, Curve]], alignment: Alignment, time_us: float
) -> Alignment:
    """Return the alignment by the part of the log before a time of the run.

    A log that is late from some place on pulls the best offset of all of it to that side.
    """
    early = [(alignment.between(samples, -numpy.inf, time_us), curve) for samples, curve in pairs]
    best = max(early, key=_energy)
    if _energy(best) <= 0.0 or alignment.drift:
        return alignment
    found = _fine(best, _Followed((alignment.offset_us,)), alignment.quality)
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


@dataclass(frozen=True, slots=True)
class _Followed:
    """A log followed along the run: between two steps it is late by one time.

    ``offsets``: of each part, in µs; ``ends``: the stamps after the last sample of each; ``begins``
    those of the first; ``drift``: 0 where the clocks do not differ.
    """

    offsets: Sequence[float] = ()
    begins: Sequence[float] = (-numpy.inf,)
    ends: Sequence[float] = (numpy.inf,)
    drift: float = 0.0

    @classmethod
    def along(cls, pair: tuple[Samples, Curve], coarse_us: float, max_drift: float) -> _Followed:
        """Return how a log lies, from where its coarse offset is true on."""
        windows = [one for one in _windows(pair, coarse_us) if one.is_known]
        if len(windows) < _MIN_FOLLOWED:
            return cls()
        shifts = numpy.array([one.offset_us for one in windows])
        middles = numpy.array([(one.begin_us + one.end_us) / 2.0 for one in windows])
        parts, drift, error = _parts(
            middles, shifts, numpy.array([one.error_us for one in windows])
        )
        if not parts:
            return cls()
        drift = drift if _STEP_ERRORS * error < abs(drift) <= max_drift else 0.0
        shifts -= drift * (middles - shifts)
        return cls(
            [float(numpy.median(shifts[one])) for one in parts],
            [windows[one.start].begin_us for one in parts],
            [windows[one.stop - 1].end_us for one in parts],
            drift,
        )

    @property
    def steps(self) -> int:
        """How many steps there are."""
        return max(len(self.offsets) - 1, 0)

    def part_of(self, stamps: Numbers) -> NDArray[numpy.int64]:
        """Return in which part stamps lie, -1 for those around a step."""
        begins = numpy.array([-numpy.inf, *self.begins[1:]])
        ends = numpy.array([*self.ends[:-1], numpy.inf])
        part = numpy.searchsorted(begins, stamps, side="right") - 1
        return numpy.where(stamps < ends[part], part, -1)

    def quality(self, pair: tuple[Samples, Curve]) -> float:
        """Return the correlation of log and run in the first part."""
        samples, curve = pair
        begin = max(self.begins[0], samples.first_us)
        grid: Numbers = numpy.arange(begin, self.ends[0], _GRID_US)
        ours = numpy.diff(curve.at((grid - self.offsets[0]) / (1.0 + self.drift)))
        logged = numpy.diff(_at_grid(samples, grid))
        norm = float(numpy.sqrt((ours**2).sum() * (logged**2).sum()))
        return float((ours * logged).sum()) / norm if norm > 0.0 else 0.0


@dataclass(frozen=True, slots=True)
class _Window:
    """Where the run begins by a window of a log; ``is_known``: whether the run explains it."""

    begin_us: float
    end_us: float
    offset_us: float
    error_us: float = numpy.inf
    is_known: bool = False


def _windows(pair: tuple[Samples, Curve], coarse_us: float) -> list[_Window]:
    """Return the windows in which a log moves, each with an offset near that of its neighbour."""
    samples, curve = pair
    stamps, values = _fitted(samples)
    length_us = max(_WINDOW_US, float(stamps[-1] - stamps[0]) / _MAX_WINDOWS)
    edges = numpy.arange(stamps[0], stamps[-1] + length_us, length_us)
    parts = [
        (stamps[first:last], values[first:last])
        for first, last in pairwise(numpy.searchsorted(stamps, edges))
        if last - first >= 4 * _MIN_SAMPLES and numpy.ptp(values[first:last]) > 0.0
    ]
    found = [_window(part, curve, coarse_us) for part in parts]
    known = next((at for at, one in enumerate(found) if one.is_known), None)
    if known is None:
        return []
    for order in (range(known - 1, -1, -1), range(known + 1, len(parts))):
        last_us = found[known].offset_us
        for at in order:
            found[at] = _window(parts[at], curve, last_us)
            if not found[at].is_known:
                near_us = _nearest(parts[at], curve, last_us)
                found[at] = _window(parts[at], curve, near_us)
            if found[at].is_known:
                last_us = found[at].offset_us
    return found


def _window(part: tuple[Numbers, Numbers], curve: Curve, offset_us: float | None) -> _Window:
    """Return where the run begins by a stretch of a log, near an offset."""
    stamps, values = part
    begin_us, end_us = float(stamps[0]), float(stamps[-1])
    unknown = _Window(begin_us, end_us, 0.0)
    if offset_us is None:
        return unknown
    for _ in range(_ROUNDS):
        times = stamps - offset_us
        is_inside = (times >= 0.0) & (times <= curve.end_us)
        if is_inside.sum() < 4 * _MIN_SAMPLES:
            return unknown
        ours, slope = curve.at(times[is_inside]), curve.slope_at(times[is_inside])
        matrix = numpy.stack([-slope, numpy.ones_like(slope), ours], axis=1)
        residual = values[is_inside] - ours
        solution, errors = _robust(matrix, residual)
        step = float(solution[0])
        if abs(step) > _REACH_US:
            return unknown
        offset_us += step
        if abs(step) < _EXACT_US:
            break
    else:
        return unknown
    left = residual - matrix @ solution
    share = float(left.var()) / max(float(values[is_inside].var()), 1e-300)
    is_known = share < _MAX_LEFT and abs(solution[2]) < _MAX_GAIN and errors[0] < _MAX_ERROR_US
    return _Window(begin_us, end_us, offset_us, float(errors[0]), bool(is_known))


def _nearest(part: tuple[Numbers, Numbers], curve: Curve, offset_us: float) -> float | None:
    """Return the offset nearest to another at which a stretch correlates best."""
    stamps, values = part
    grid = numpy.arange(stamps[0], stamps[-1], _GRID_US)
    logged = numpy.diff(numpy.interp(grid, stamps, values))
    count = len(grid) + round(2.0 * _REACH_US / _GRID_US)
    first_us = float(stamps[0]) - offset_us - _REACH_US
    times: Numbers = numpy.arange(count, dtype=numpy.float64) * _GRID_US + first_us
    ours = numpy.diff(curve.at(times))
    size = 1 << int(len(ours) + len(logged)).bit_length()
    both = numpy.fft.rfft(ours, size) * numpy.conj(numpy.fft.rfft(logged, size))
    lags = len(ours) - len(logged) + 1
    squares = numpy.append(0.0, numpy.cumsum(ours**2))
    energy = squares[len(logged) :] - squares[:lags]
    norm = numpy.sqrt(numpy.maximum(energy, 1e-9 * squares[-1]) * (logged**2).sum())
    product = numpy.fft.irfft(both, size)[:lags]
    found = numpy.divide(product, norm, out=numpy.zeros(lags), where=norm > 0.0)
    if found.max() < _MIN_CORRELATION:
        return None
    good = numpy.flatnonzero(found >= _ALIKE * found.max())
    at = int(good[numpy.abs(good - lags // 2).argmin()])
    while 0 < at < lags - 1 and max(found[at - 1], found[at + 1]) > found[at]:
        at += 1 if found[at + 1] > found[at - 1] else -1
    return float(stamps[0]) - first_us - at * _GRID_US


def _parts(middles: Numbers, shifts: Numbers, errors: Numbers) -> tuple[list[slice], float, float]:
    """Return the windows between steps, the slope within them all, and its standard error."""
    drift = float(numpy.median(numpy.diff(shifts) / numpy.diff(middles)))
    parts: list[slice] = []
    error = numpy.inf
    for _ in range(_ROUNDS):
        flat = shifts - drift * (middles - middles.mean())
        scatter = float(numpy.median(numpy.abs(numpy.diff(flat)))) / 0.6745 / 2.0**0.5
        weights = 1.0 / (errors**2 + scatter**2 + _EXACT_US**2)
        parts = _merged(_divided(flat, weights), flat, weights)
        above = below = 0.0
        for one in parts:
            weight, middle = weights[one], middles[one]
            middle = middle - numpy.average(middle, weights=weight)
            above += float((weight * middle * shifts[one]).sum())
            below += float((weight * middle**2).sum())
        if below <= 0.0:
            return parts, 0.0, numpy.inf
        before, drift, error = drift, above / below, below**-0.5
        if abs(drift - before) < 1e-9:
            break
    return parts, drift, error


def _divided(flat: Numbers, weights: Numbers) -> list[slice]:
    """Return the division into parts of one value each, whose squares of errors are least.

    Each part costs the square of the errors that a step has at least.
    """
    sums, firsts, squares = (
        numpy.append(0.0, numpy.cumsum(one)) for one in (weights, weights * flat, weights * flat**2)
    )
    count = len(flat)
    best = numpy.zeros(count + 1)
    begins = [0] * (count + 1)
    for end in range(1, count + 1):
        total = (firsts[end] - firsts[:end]) ** 2 / (sums[end] - sums[:end])
        cost = best[:end] + squares[end] - squares[:end] - total + _STEP_ERRORS**2
        begins[end] = int(cost.argmin())
        best[end] = cost[begins[end]]
    parts: list[slice] = []
    end = count
    while end:
        parts.insert(0, slice(begins[end], end))
        end = begins[end]
    return parts


def _merged(parts: Sequence[slice], flat: Numbers, weights: Numbers) -> list[slice]:
    """Return the parts that are long enough; those at one height are one, with all between them."""
    found: list[slice] = []
    for one in parts:
        if one.stop - one.start < _MIN_WINDOWS:
            continue
        if found:
            before = found[-1]
            heights = [numpy.average(flat[at], weights=weights[at]) for at in (before, one)]
            if abs(heights[1] - heights[0]) < _MIN_STEP_US:
                found[-1] = slice(before.start, one.stop)
                continue
        found.append(one)
    return found


def _is_first(pairs: Sequence[tuple[Samples, Curve]], followed: _Followed) -> bool:
    """Return whether the first part of a log fits where it has been followed to, and only there."""
    first = Alignment(followed.offsets[0], followed.drift)
    end_us = float(first.run_times(numpy.array(followed.ends[:1]))[0])
    parts = [(first.between(samples, -numpy.inf, end_us), curve) for samples, curve in pairs]
    offset, _, second = _coarse([one for one in parts if _energy(one) > 0.0])
    return second <= _SECOND_PEAK and abs(offset - first.offset_us) < _BEGIN_US


def _begins_with(pair: tuple[Samples, Curve], followed: _Followed) -> bool:
    """Return whether the first motions of log and run are together, or the log begins in motion."""
    samples, curve = pair
    stamps, values = _fitted(samples)
    min_motion = _MOTION * samples.span
    moves = numpy.abs(values - values[0]) > min_motion
    first_us = float(stamps[int(moves.argmax())])
    ours = curve.at((stamps - followed.offsets[0]) / (1.0 + followed.drift))
    begins_us = float(stamps[int((numpy.abs(ours - ours[0]) > min_motion).argmax())])
    return abs(first_us - begins_us) < _BEGIN_US


def _fine(pair: tuple[Samples, Curve], followed: _Followed, quality: float) -> Alignment:
    """Return the alignment near coarse offsets, by one pair; it is that of the first part."""
    samples, curve = pair
    stamps, values = _fitted(samples)
    part = followed.part_of(stamps)
    middle = float(stamps.mean())
    offsets, drift, gain, bias = numpy.array(followed.offsets), followed.drift, 1.0, 0.0
    count, may_drift = len(offsets), drift != 0.0
    error = numpy.zeros(count + 3)
    for _ in range(_ROUNDS):
        times = (stamps - offsets[part]) / (1.0 + drift)
        is_inside = (part >= 0) & (times >= 0.0) & (times <= curve.end_us)
        if is_inside.sum() < _MIN_SAMPLES:
            return Alignment(float(followed.offsets[0]), quality=quality)
        inside = times[is_inside]
        ours, slope = curve.at(inside), curve.slope_at(inside)
        columns = [-slope * (part[is_inside] == one) for one in range(count)]
        columns += [numpy.ones_like(slope), ours]
        if may_drift:
            columns.append(-slope * (stamps[is_inside] - middle))
        matrix = numpy.stack(columns, axis=1)
        solution, error = _robust(matrix, values[is_inside] - ours)
        steps = solution[:count]
        gain, bias = 1.0 + float(solution[count + 1]), float(solution[count])
        if may_drift:
            steps = steps + (offsets - middle) * float(solution[-1])
            drift += float(solution[-1])
        offsets = offsets + steps
        if numpy.abs(steps).max() < _SETTLED_US:
            break
    if may_drift and abs(drift) < _SIGNIFICANT * error[-1]:
        return _fine(pair, replace(followed, drift=0.0), quality)
    min_bias = max(_SIGNIFICANT * float(error[count]), _MIN_SCALE * float(numpy.ptp(values)))
    bias = bias if abs(bias) > min_bias else 0.0
    return Alignment(float(offsets[0]), drift, quality, gain, bias)


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

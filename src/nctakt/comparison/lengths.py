# SPDX-License-Identifier: MIT
"""By how much a log is later from a place on (LG-706): one length, or none that is certain.

At a place the machine waits for the length, then the run continues; a negative length leaves out
the end of the part before. Lengths up to ``REACH_US`` are tried on a grid, with a gain and a bias
of each signal solved for each; the best ones are refined at the log's own stamps. A length is
certain if it fits as well as the part before the place, and no other length does.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.comparison.alignment import Alignment, Curve
from nctakt.comparison.columns import Numbers
from nctakt.comparison.log import Samples

#: The longest delay that is looked for, in µs.
REACH_US = 20e6
#: How long the stretches after a place are that are fitted, in µs.
_STRETCHES = tuple(0.5e6 * 2.0**power for power in range(8))
#: The same after the first motion of the log, and the share of its span that counts as motion.
_BEGINNINGS = tuple(0.125e6 * 2.0 ** (power / 2.0) for power in range(18))
_MOTION = 0.01
#: Misfits that are allowed there, tried in this order, as shares of a signal's span.
_MISFITS = (1e-5, 1e-4, 1e-3, 5e-3)
#: The step of the grid of lengths, in µs, and the largest number of minima that are refined.
_GRID_US, _REFINED = 4000.0, 8
#: A minimum wider than this number of grid steps says nothing about the length.
_WIDEST = 8
#: The largest difference of a gain from 1.
_GAIN = 0.1
#: Misfits below these shares of a signal's span are ignored: on the grid, and at the stamps.
_GRID_FLOOR, _FLOOR = 1e-4, 1e-5
#: A fit may be worse than the one before the place by up to this factor.
_AS_GOOD = 2.0
#: A misfit above this share of a signal's span is no noise.
_MISFIT = 0.01
#: Another length is excluded if its sum of squares is larger by this many squared errors.
_EXCLUDED = 50.0
#: This many standard errors may be at most this long: in µs, or as a share of the length.
_SIGNIFICANT, _EXACT_US, _EXACT = 5.0, 500.0, 0.005
#: After the place, some signal must move by at least this many times the noise.
_CLEAR = 20.0
#: The length of the parts of a stretch that are checked for a separate delay, in µs.
_PART_US = 0.1e6
#: The shortest length, in µs.
MIN_LENGTH_US = 500.0
#: The largest number of rounds of the refinement, and the step in µs that ends it.
_ROUNDS, _SETTLED_US = 12, 0.01
#: The largest number of samples of a signal that are fitted, and the smallest that says enough.
_MAX_FITTED, _MIN_SAMPLES = 10_000, 20

Signals = Sequence[tuple[Samples, Curve]]


@dataclass(frozen=True, slots=True)
class Place:
    """Where a log may become late: at one of ``times_us`` of the run, the likely one first.

    From ``begin_us`` on until then it is not: times are those of ``alignment``.
    """

    times_us: Sequence[float]
    begin_us: float
    alignment: Alignment


@dataclass(frozen=True, slots=True)
class Length:
    """A length from a time of the run on; ``shift_us``: how much later the alignment is there."""

    time_us: float
    length_us: float
    shift_us: float


@dataclass(frozen=True, slots=True, eq=False)
class _Piece:
    """A stretch of a signal: times of the run, values of the log.

    ``span``: that of the log; ``noise``: the size of misfits that do not count.
    """

    times: Numbers
    values: Numbers
    curve: Curve
    span: float
    noise: float = 0.0

    def misfit(self) -> float:
        """Return the size of the residual after gain and bias where the log is not late."""
        if len(self.times) < _MIN_SAMPLES:
            return 0.0
        left, _ = _left(self.curve.at(self.times), self.values)
        return float(numpy.sqrt((left * left).mean()))


def fits(
    signals: Signals,
    alignment: Alignment,
    begin_us: float,
    end_us: float,
    misfit: float = _MISFIT,
) -> bool:
    """Return whether something moves between two times, and the run explains it.

    ``misfit``: the largest one, as a share of a signal's span.
    """
    pieces = _pieces(signals, alignment, begin_us, end_us)
    moves = any(
        len(one.times) >= _MIN_SAMPLES and numpy.ptp(one.curve.at(one.times)) > 0.0
        for one in pieces
    )
    return moves and all(one.misfit() <= misfit * one.span for one in pieces)


def length_at(signals: Signals, late: Place) -> Length | float | None:
    """Return by how much the log is later from a place on.

    If no length is certain, the time of the place, in µs of the run; ``None`` if it is not certain
    either.
    """
    earliest = min(late.times_us)
    begin = max(late.begin_us, earliest - REACH_US)
    noises = [one.misfit() for one in _pieces(signals, late.alignment, begin, earliest)]
    found: Length | None = None
    places: set[float | None] = set()
    for stretch in _STRETCHES:
        end = late.times_us[0] + stretch
        pieces = _pieces(signals, late.alignment, begin, end, noises)
        search = _only([_Search(pieces, time_us, begin, end) for time_us in late.times_us])
        places.add(None if search is None else search.time_us)
        length = None if search is None else search.length()
        if length is None and found is not None:
            break  # something else has happened by then
        found = length or found
    if found is not None:
        return found
    places.discard(None)
    sure = places or {late.times_us[0]}
    return sure.pop() if len(sure) == 1 else None


def _only(searches: Sequence[_Search]) -> _Search | None:
    """Return the search at the place that fits better than all others, ``None`` for none."""
    known = [(one, one.fit) for one in searches if one.fit is not None]
    if not known:
        return None
    best, fit = min(known, key=lambda one: one[1].misfit)
    others = [other for one, other in known if one is not best]
    if any(other.differs_by(fit) < _EXCLUDED for other in others):
        return None
    return best


def beginning(signals: Signals, alignment: Alignment, time_us: float) -> float:
    """Return by how much the run begins later in the log than aligned, 0 if that is not sure.

    ``time_us``: where the first motion of the run begins; until then all axes are at rest.
    """
    begin = time_us - REACH_US
    whole = _pieces(signals, alignment, begin, numpy.inf)
    start = min(map(_first_motion_us, whole))
    rests = [one.values[one.times < start] for one in whole]
    for share in _MISFITS:
        noises = [
            share * one.span + (float(rest.std()) if len(rest) else 0.0)
            for one, rest in zip(whole, rests, strict=True)
        ]
        found = 0.0
        for stretch in _BEGINNINGS:
            pieces = _pieces(signals, alignment, begin, start + stretch, noises)
            length = _Search(pieces, time_us, begin, start + stretch, is_first=True).length()
            if length is None and found:
                break
            found = length.shift_us if length is not None else found
        if found:
            return found
    return 0.0


def _first_motion_us(piece: _Piece) -> float:
    """Return when the log begins to move, infinite if it does not."""
    moved = numpy.abs(piece.values - piece.values[:1]) > _MOTION * piece.span
    return float(piece.times[int(moved.argmax())]) if moved.any() else numpy.inf


def _pieces(
    signals: Signals,
    alignment: Alignment,
    begin_us: float,
    end_us: float,
    noises: Sequence[float] = (),
) -> list[_Piece]:
    """Return the part of the log between two times of the run."""
    found = []
    for number, (samples, curve) in enumerate(signals):
        part = alignment.between(samples, begin_us, end_us)
        stretches = list(part.stretches(max(1, len(part) // _MAX_FITTED)))
        times = numpy.concatenate([numpy.empty(0), *(stamps for stamps, _ in stretches)])
        values = numpy.concatenate([numpy.empty(0), *(logged for _, logged in stretches)])
        noise = noises[number] if noises else 0.0
        found.append(_Piece(alignment.run_times(times), values, curve, samples.span, noise))
    return found


def _left(model: Numbers, values: Numbers) -> tuple[Numbers, float]:
    """Return the residual of values after a bias and a gain near 1 of a model, and the gain."""
    ours, theirs = model - model.mean(), values - values.mean()
    square = float((ours * ours).sum())
    gain = float((ours * theirs).sum()) / square if square > 0.0 else 1.0
    gain = min(max(gain, 1.0 - _GAIN), 1.0 + _GAIN)
    return theirs - gain * ours, gain


@dataclass(frozen=True, slots=True)
class _Fit:
    """The best fit at the stamps: by how much the log is later after the place than aligned.

    ``length_us``: later than before it; ``error_us``: its standard error; ``squares``: of the
    misfits, signal by signal; ``sizes``: the squares of errors; ``misfit``: the sum of the squares,
    each as a share of the noise before the place.
    """

    shift_us: float
    length_us: float
    error_us: float
    squares: Numbers
    sizes: Numbers
    misfit: float

    def differs_by(self, best: _Fit) -> float:
        """Return by how many squares of errors it fits worse than the best one."""
        return float(((self.squares - best.squares) / best.sizes).sum())


class _Search:
    """The search for the length in a stretch of a log; ``is_first``: nothing moves before it."""

    def __init__(
        self,
        pieces: Sequence[_Piece],
        time_us: float,
        begin_us: float,
        end_us: float,
        *,
        is_first: bool = False,
    ) -> None:
        self._pieces = [one for one in pieces if len(one.times) >= _MIN_SAMPLES and one.span > 0.0]
        self.time_us, self._begin_us, self._end_us = time_us, begin_us, end_us
        self._is_first = is_first
        self._is_sure = True
        self._fits = [self._refined(shift) for shift in self._candidates()]
        #: The best fit, ``None`` where there is nothing to fit.
        self.fit = min(self._fits, key=lambda one: one.misfit, default=None)

    def length(self) -> Length | None:
        """Return the only length that fits, ``None`` if there is none or another one."""
        best = self.fit
        if best is None or not self._is_sure or not self._goes_on(best.shift_us):
            return None
        exact = max(_EXACT_US, _EXACT * abs(best.length_us))
        others = [one for one in self._fits if abs(one.shift_us - best.shift_us) > exact]
        worse = min((one.differs_by(best) for one in others), default=_EXCLUDED)
        if worse < _EXCLUDED or _SIGNIFICANT * best.error_us > exact:
            return None
        if not self._is_as_good(best) or self._is_late_elsewhere(best):
            return None
        return Length(self.time_us, best.length_us, best.shift_us)

    def _is_as_good(self, fit: _Fit) -> bool:
        """Return whether the misfits are those before the place, as far as their number allows."""
        for one, square, size in zip(self._pieces, fit.squares, fit.sizes, strict=True):
            mean = square / len(one.times)
            noise = (one.noise + _FLOOR * one.span) ** 2
            count = max(square / size, 1.0)  # of samples that do not repeat each other
            excess = min(_AS_GOOD**2, 1.0 + _SIGNIFICANT * (2.0 / count) ** 0.5)
            if (not self._is_first and mean > noise * excess) or mean > noise * _AS_GOOD**2:
                return False
        return True

    def _goes_on(self, shift_us: float) -> bool:
        """Return whether after the place something moves clearly."""
        change = self.time_us + shift_us
        for one in self._pieces:
            ours = one.curve.at(one.times[one.times >= change] - shift_us)
            if len(ours) and numpy.ptp(ours) > _MISFIT * one.span + _CLEAR * one.noise:
                return True
        return False

    def _is_late_elsewhere(self, fit: _Fit) -> bool:
        """Return whether the residual is late in a part of the stretch: then the fit is false."""
        parts = int((self._end_us - self._begin_us) // _PART_US) + 1
        slopes, both, squares, counts = numpy.zeros((4, parts))
        for one, size in zip(self._pieces, fit.sizes, strict=True):
            left, changes = self._part(one, fit.shift_us, fit.shift_us - fit.length_us)
            slope = changes.sum(axis=0)
            part = ((one.times - self._begin_us) // _PART_US).astype(numpy.int64)
            part = numpy.clip(part, 0, parts - 1)
            slopes += numpy.bincount(part, slope**2, parts) / size
            both += numpy.bincount(part, slope * left, parts) / size
            squares += numpy.bincount(part, left**2, parts) / size
            counts += numpy.bincount(part[slope != 0.0], minlength=parts)
        is_known = (counts >= _MIN_SAMPLES) & (slopes > 0.0)
        late = both[is_known] / slopes[is_known]
        rest = numpy.maximum(squares[is_known] - late**2 * slopes[is_known], 0.0)
        error = numpy.sqrt(rest / counts[is_known] / slopes[is_known])
        return bool((numpy.abs(late) > numpy.maximum(MIN_LENGTH_US, _SIGNIFICANT * error)).any())

    def _candidates(self) -> list[float]:
        """Return the best lengths of a grid, of each that lie together one."""
        before = round((self.time_us - self._begin_us) / _GRID_US)
        count = before + round((self._end_us - self.time_us) / _GRID_US)
        if count <= 0 or not self._pieces:
            return []
        total: Numbers = numpy.zeros(count + 1)
        curvature: Numbers = numpy.zeros(count + 1)
        for piece in self._pieces:
            squares, slopes = self._grid_squares(piece, before, count)
            share = min(1.0, len(piece.times) / count)
            size = (piece.noise**2 + (_GRID_FLOOR * piece.span) ** 2) / share
            total += squares / size
            curvature += slopes / size
        limit = float(total.min()) + float(curvature[int(total.argmin())]) + _EXCLUDED
        near = numpy.flatnonzero(total <= limit)
        groups = numpy.split(near, numpy.flatnonzero(numpy.diff(near) > 2) + 1)
        best = [int(group[total[group].argmin()]) for group in groups]
        self._is_sure = len(groups) <= _REFINED and all(
            0 < at < count and len(group) <= max(_WIDEST, 4.0 * _EXACT * abs(at - before))
            for at, group in zip(best, groups, strict=True)
        )
        best = best if self._is_sure else [int(total.argmin())]
        return [(at - before) * _GRID_US for at in best]

    def _grid_squares(self, piece: _Piece, before: int, count: int) -> tuple[Numbers, Numbers]:
        """Return the squares of misfits with each length, and those that half a step makes."""
        steps = numpy.arange(count + before + 1, dtype=numpy.float64) - before
        times: Numbers = self.time_us + steps * _GRID_US
        logged = numpy.interp(times[: count + 1], piece.times, piece.values)
        logged -= logged.mean()
        ours = piece.curve.at(times)
        ours -= ours[before]  # its position at rest is 0
        after = ours[before:]
        size = 1 << int(len(after) + len(logged)).bit_length()
        spectrum = numpy.conj(numpy.fft.rfft(after, size)) * numpy.fft.rfft(logged, size)
        changes = numpy.arange(count + 1)  # from these points on, the run continues
        early = numpy.minimum(changes, before)
        late = count + 1 - changes
        sums = _sums(ours)[early] + _sums(after)[late]
        squares = _sums(ours**2)[early] + _sums(after**2)[late]
        both = _sums(ours[: count + 1] * logged)[early]
        both += numpy.fft.irfft(spectrum, size)[: count + 1]
        variance = squares - sums**2 / (count + 1)
        gain = numpy.divide(both, variance, out=numpy.ones(count + 1), where=variance > 0.0)
        gain = numpy.clip(gain, 1.0 - _GAIN, 1.0 + _GAIN)
        left = float((logged**2).sum()) - 2.0 * gain * both + gain**2 * variance
        steps = _sums(numpy.diff(after, append=after[-1:]) ** 2)[late] / 4.0
        return numpy.maximum(left, 0.0), steps

    def _refined(self, shift_us: float) -> _Fit:
        """Return the best fit near a length."""
        shift, earlier = shift_us, 0.0
        noises = numpy.array([one.noise**2 + (_FLOOR * one.span) ** 2 for one in self._pieces])
        for _ in range(_ROUNDS):
            parts = [self._part(one, shift, earlier) for one in self._pieces]
            normal, error = _normal(parts, noises)
            step = numpy.linalg.pinv(normal, hermitian=True) @ error
            step = numpy.clip(step, -_GRID_US, _GRID_US)
            shift, earlier = shift + float(step[0]), earlier + float(step[1])
            if numpy.abs(step).max() < _SETTLED_US:
                break
        parts = [self._part(one, shift, earlier) for one in self._pieces]
        squares = numpy.array([float((left * left).sum()) for left, _ in parts])
        counts = numpy.array([len(left) for left, _ in parts])
        floors = numpy.array([(0.1 * _FLOOR * one.span) ** 2 for one in self._pieces])
        sizes = squares / counts * [_repeated(left) for left, _ in parts] + floors
        error_us = self._error(_normal(parts, sizes)[0])
        misfit = float((squares / noises).sum())
        return _Fit(shift, shift - earlier, error_us, squares, sizes, misfit)

    def _error(self, normal: Numbers) -> float:
        """Return the standard error of a length, infinite if nothing says it."""
        if normal[0, 0] <= 0.0 or (normal[1, 1] <= 0.0 and not self._is_first):
            return numpy.inf
        if self._is_first:
            return float(normal[0, 0] ** -0.5)
        inverse = numpy.linalg.pinv(normal, hermitian=True)
        square = inverse[0, 0] + inverse[1, 1] - 2.0 * inverse[0, 1]
        return float(max(square, 0.0) ** 0.5)

    def _part(self, piece: _Piece, shift_us: float, earlier_us: float) -> tuple[Numbers, Numbers]:
        """Return the residual of a piece, and its changes with both times, less gain and bias."""
        change = self.time_us + shift_us
        is_before = piece.times < min(self.time_us, change)
        is_after = piece.times >= change
        times = numpy.where(is_after, piece.times - shift_us, self.time_us)
        times = numpy.where(is_before, piece.times - earlier_us, times)
        model: Numbers = piece.curve.at(times)
        left, gain = _left(model, piece.values)
        slope = -gain * piece.curve.slope_at(times)
        changes = numpy.stack([slope * is_after, slope * is_before])
        if self._is_first:
            changes[1] = 0.0
        ours = model - model.mean()
        square = float((ours * ours).sum())
        changes -= changes.mean(axis=1, keepdims=True)
        if square > 0.0:
            changes -= (changes * ours).sum(axis=1, keepdims=True) / square * ours
        return left, changes


def _normal(
    parts: Sequence[tuple[Numbers, Numbers]], sizes: Sequence[float] | Numbers
) -> tuple[Numbers, Numbers]:
    """Return the normal equations of both times."""
    normal, error = numpy.zeros((2, 2)), numpy.zeros(2)
    for (left, changes), size in zip(parts, sizes, strict=True):
        for one in range(2):
            error[one] += float((changes[one] * left).sum()) / size
            for other in range(2):
                normal[one, other] += float((changes[one] * changes[other]).sum()) / size
    return normal, error


def _repeated(left: Numbers) -> float:
    """Return how many samples count as one, since neighbours have the same misfit."""
    square = float((left * left).sum())
    if square <= 0.0:
        return 1.0
    same = min(max(float((left[1:] * left[:-1]).sum()) / square, 0.0), 0.999)
    return (1.0 + same) / (1.0 - same)


def _sums(values: Numbers) -> Numbers:
    """Return the sums of the first 0, 1 … values."""
    return numpy.append(0.0, numpy.cumsum(values))

# SPDX-License-Identifier: MIT
"""From which block on a log is later than the run (LG-706).

Within a block the deviation of a moving axis is its speed times the time that the log is late, and
a rest. Where that time jumps from one block to the next, something took longer on the machine: a
dwell, a function that waits, a corner. A log with a gain or a bias always deviates from the run:
then the measure is how deviation and speed change together within the block, less the part
explained by position.

Samples within one tick count as one: the run is known once a tick, so that faster sampling does not
make it more certain where the log is late.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.comparison.columns import Numbers
from nctakt.comparison.recorded import StoredEvents
from nctakt.results.trace.events import Event

#: The smallest jump that counts, in µs and in standard errors.
_MIN_JUMP_US, _SIGNIFICANT = 500.0, 5.0
#: Share of the jumps so far that a jump has at least in a log with a gain or a bias: there a delay
#: is known from the ramps of the speed alone, the less exactly the nearer it is to their duration.
_UNSURE_SHARE = 0.5
#: Smallest number of ticks of a block that have samples and in which a signal moves.
_MIN_MOVING = 5
#: Variance below which two delays cannot be distinguished, in µs².
_MIN_VARIANCE = 1.0
#: Variance of a speed, as a share of its square, up to which it is constant.
_CONSTANT = 1e-12
#: Share of the variance of a speed, up to which the position explains it.
_EXPLAINED = 1e-6
#: How many sums each block has.
_SUMS = 4
#: Which rows of slopes (0), differences (1) and values (2) are multiplied.
_PRODUCTS = ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))


@dataclass(frozen=True, slots=True)
class Delay:
    """From ``block`` on, which begins at ``time_us``, the log is later by ``jump_us`` than before.

    A negative jump: it is earlier; ``None``: by how much is not known.
    """

    block: Span | None
    time_us: int
    jump_us: float | None


class BlockDelays:
    """Gathers signal after signal how late a log is in each block of a run.

    ``is_scaled``: the log has a gain or a bias, so that only changes within a block count.
    """

    def __init__(self, blocks: Sequence[Event], cycle_time_us: int, is_scaled: bool) -> None:
        self._blocks = blocks
        self._is_scaled = is_scaled
        ticks = (
            blocks.ticks
            if isinstance(blocks, StoredEvents)
            else numpy.array([event.tick for event in blocks], dtype=numpy.float64)
        )
        self._cycle_time_us = cycle_time_us
        self._begins = ticks * float(cycle_time_us)
        self._sums = numpy.zeros((_SUMS, len(blocks) + 1))
        self._moving = numpy.zeros(len(blocks) + 1)
        self._signal = _SignalSums(len(blocks) + 1, is_scaled)

    def add(self, times: Numbers, differences: Numbers, slopes: Numbers, values: Numbers) -> None:
        """Add a stretch of a signal: times of the run, log minus run, the run's slopes and values.

        All but times are shares of the signal's span; blocks in which nothing moves say nothing.
        """
        first, last = numpy.searchsorted(self._begins, times[[0, -1]], side="right")
        starts = numpy.append(0, numpy.searchsorted(times, self._begins[first:last]))
        sizes = numpy.diff(numpy.append(starts, len(times)))
        has_samples = sizes > 0
        number = first + numpy.flatnonzero(has_samples)
        starts, sizes = starts[has_samples], sizes[has_samples]
        ticks = times // self._cycle_time_us
        self._signal.add(number, starts, sizes, ticks, numpy.stack([slopes, differences, values]))

    def end_signal(self) -> None:
        """End a signal: later additions belong to another."""
        sums = self._signal.without_position()
        self._sums += sums
        self._moving = numpy.maximum(self._moving, sums[2])
        self._signal = _SignalSums(self._sums.shape[1], self._is_scaled)

    def found(self) -> list[Delay]:
        """Return where the log becomes later or earlier, in the order of the blocks."""
        delays: list[Delay] = []
        weights = weighted = 0.0  # of the blocks since the last jump
        late_by = 0.0  # the sum of the jumps
        for number in map(int, numpy.flatnonzero(self._moving >= _MIN_MOVING)):
            late, variance = self._late(number)
            if weights > 0.0:
                jump = late - weighted / weights
                limit = _SIGNIFICANT * (variance + 1.0 / weights) ** 0.5
                unsure = _UNSURE_SHARE * abs(late_by) if self._is_scaled else 0.0
                if abs(jump) > max(_MIN_JUMP_US, limit, unsure):
                    block = self._blocks[number - 1]
                    delays.append(Delay(block.span, block.time_us, jump))
                    weights = weighted = 0.0
                    late_by += jump
            weights += 1.0 / variance
            weighted += late / variance
        return delays

    def _late(self, number: int) -> tuple[float, float]:
        """Return by how many µs the log is late in a block, and the square of its error."""
        slopes, products, count, squares = map(float, self._sums[:, number])
        late = -products / slopes
        rest = max(squares - late**2 * slopes, 0.0)
        return late, rest / (count - 1.0) / slopes + _MIN_VARIANCE


class _SignalSums:
    """Sums of a signal in each block: products of slopes, differences and values, moving ticks.

    With ``is_scaled`` all three count less their mean in the block, for any stretches: the sums of
    two of them add up with the distance of their means.
    """

    def __init__(self, size: int, is_scaled: bool) -> None:
        self._is_scaled = is_scaled
        self._products: Numbers = numpy.zeros((len(_PRODUCTS), size))
        self._sizes, self._moving = numpy.zeros((2, size))
        self._means: Numbers = numpy.zeros((3, size))
        self._tick = -1.0

    def add(
        self,
        number: NDArray[numpy.int64],
        starts: NDArray[numpy.int64],
        sizes: NDArray[numpy.int64],
        ticks: Numbers,
        rows: Numbers,
    ) -> None:
        """Add a stretch; ``starts``: where in it the blocks of a ``number`` begin.

        ``ticks``: of the samples; ``rows``: slopes, differences, values.
        """
        is_new = numpy.diff(ticks, prepend=self._tick) != 0.0
        self._tick = float(ticks[-1])
        counts = (is_new & (rows[0] != 0.0)).astype(float)
        self._moving[number] += numpy.add.reduceat(counts, starts)
        apart: Numbers = numpy.zeros((3, len(number)))
        weight: Numbers = numpy.zeros(len(number))
        if self._is_scaled:
            means = numpy.add.reduceat(rows, starts, axis=1) / sizes
            rows = rows - numpy.repeat(means, sizes, axis=1)
            before = self._sizes[number]
            share = sizes / (before + sizes)
            apart, weight = means - self._means[:, number], before * share
            self._means[:, number] += apart * share
            self._sizes[number] += sizes
        for sums, (one, other) in zip(self._products, _PRODUCTS, strict=True):
            sums[number] += numpy.add.reduceat(rows[one] * rows[other], starts)
            sums[number] += apart[one] * apart[other] * weight

    def without_position(self) -> Numbers:
        """Return slopes², slopes · differences, moving ticks, differences².

        With ``is_scaled`` less the part explained by the values, as with a gain. At a constant
        speed a delay cannot be distinguished from a bias, at a speed explained by the values not
        from a gain.
        """
        slopes, both, differences, of_slopes, of_differences, squares = self._products
        sums = numpy.stack([slopes, both, self._moving, differences])
        if self._is_scaled:
            divisor = numpy.where(squares > 0.0, squares, 1.0)
            sums[0] -= of_slopes**2 / divisor
            sums[1] -= of_slopes * of_differences / divisor
            sums[3] -= of_differences**2 / divisor
            limit = numpy.maximum(
                _CONSTANT * self._sizes * self._means[0] ** 2, _EXPLAINED * slopes
            )
            sums[:3, sums[0] <= limit] = 0.0
        return sums

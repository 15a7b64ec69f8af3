# SPDX-License-Identifier: MIT
"""From which block on a log is later than the run (LG-706).

Within a block the deviation of a moving axis is its speed times the time that the log is late, and
a rest. Where that time jumps from one block to the next, something took longer on the machine: a
dwell, a function that waits, a corner. A log with a gain or a bias is always beside the run: there
counts how deviation and speed change together within the block.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.comparison.columns import Numbers
from nctakt.comparison.recorded import StoredEvents
from nctakt.trace.events import Event

#: The smallest jump that counts, in µs and in standard errors.
_MIN_JUMP_US, _SIGNIFICANT = 500.0, 5.0
#: Smallest number of samples of a block in which a signal moves.
_MIN_MOVING = 5
#: Variance below which two delays cannot be distinguished, in µs².
_MIN_VARIANCE = 1.0
#: Variance of a speed, as a share of its square, up to which it is constant.
_CONSTANT = 1e-12
#: How many sums each block has.
_SUMS = 4


@dataclass(frozen=True, slots=True)
class Delay:
    """From ``block`` on, which begins at ``time_us``, the log is later by ``jump_us`` than before.

    A negative jump: it is earlier.
    """

    block: Span | None
    time_us: int
    jump_us: float


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
        self._begins = ticks * float(cycle_time_us)
        self._sums = numpy.zeros((_SUMS, len(blocks) + 1))
        self._moving = numpy.zeros(len(blocks) + 1)
        self._signal = _SignalSums(len(blocks) + 1, is_scaled)

    def add(self, times: Numbers, differences: Numbers, slopes: Numbers) -> None:
        """Add a stretch of a signal: times of the run, log minus run, and the run's slopes.

        Both are shares of the signal's span; blocks in which nothing moves say nothing.
        """
        first, last = numpy.searchsorted(self._begins, times[[0, -1]], side="right")
        starts = numpy.append(0, numpy.searchsorted(times, self._begins[first:last]))
        sizes = numpy.diff(numpy.append(starts, len(times)))
        has_samples = sizes > 0
        number = first + numpy.flatnonzero(has_samples)
        starts, sizes = starts[has_samples], sizes[has_samples]
        self._signal.add(number, starts, sizes, slopes, differences)

    def end_signal(self) -> None:
        """End a signal: what is added afterwards is another one's."""
        self._sums += self._signal.without_constant_speeds()
        self._moving = numpy.maximum(self._moving, self._signal.moving)
        self._signal = _SignalSums(self._sums.shape[1], self._is_scaled)

    def found(self) -> list[Delay]:
        """Return where the log becomes later or earlier, in the order of the blocks."""
        delays: list[Delay] = []
        weights = weighted = 0.0  # of the blocks since the last jump
        for number in map(int, numpy.flatnonzero(self._moving >= _MIN_MOVING)):
            late, variance = self._late(number)
            if weights > 0.0:
                jump = late - weighted / weights
                limit = _SIGNIFICANT * (variance + 1.0 / weights) ** 0.5
                if abs(jump) > max(_MIN_JUMP_US, limit):
                    block = self._blocks[number - 1]
                    delays.append(Delay(block.span, block.time_us, jump))
                    weights = weighted = 0.0
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
    """Sums of a signal in each block: slopes², slopes · differences, moving samples, differences².

    With ``is_scaled`` slopes and differences count less their mean in the block, whatever the
    stretches are: the sums of two of them add up with the distance of their means.
    """

    def __init__(self, size: int, is_scaled: bool) -> None:
        self._is_scaled = is_scaled
        self._sums: Numbers = numpy.zeros((_SUMS, size))
        self._sizes, self._slopes, self._differences = numpy.zeros((3, size))

    def add(
        self,
        number: NDArray[numpy.int64],
        starts: NDArray[numpy.int64],
        sizes: NDArray[numpy.int64],
        slopes: Numbers,
        differences: Numbers,
    ) -> None:
        """Add a stretch; ``starts``: where in it the blocks of a ``number`` begin."""
        self._sums[2, number] += numpy.add.reduceat((slopes != 0.0).astype(float), starts)
        if self._is_scaled:
            slope, difference = (
                numpy.add.reduceat(one, starts) / sizes for one in (slopes, differences)
            )
            slopes = slopes - numpy.repeat(slope, sizes)
            differences = differences - numpy.repeat(difference, sizes)
            slope -= self._slopes[number]
            difference -= self._differences[number]
            before = self._sizes[number]
            share = sizes / (before + sizes)
            self._slopes[number] += slope * share
            self._differences[number] += difference * share
            self._sizes[number] += sizes
            apart = before * share
            self._sums[0, number] += slope * slope * apart
            self._sums[1, number] += slope * difference * apart
            self._sums[3, number] += difference * difference * apart
        self._sums[0, number] += numpy.add.reduceat(slopes * slopes, starts)
        self._sums[1, number] += numpy.add.reduceat(slopes * differences, starts)
        self._sums[3, number] += numpy.add.reduceat(differences * differences, starts)

    @property
    def moving(self) -> Numbers:
        """How many samples move in each block."""
        counts: Numbers = self._sums[2]
        return counts

    def without_constant_speeds(self) -> Numbers:
        """Return the sums; at constant speed a delay cannot be told from a bias."""
        is_constant = self._sums[0] <= _CONSTANT * self._sizes * self._slopes**2
        self._sums[:3, is_constant] = 0.0
        return self._sums

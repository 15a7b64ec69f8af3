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
from nctakt.comparison.alignment import Alignment, Curve
from nctakt.comparison.log import Samples
from nctakt.trace.events import Event

#: The smallest jump that counts, in µs and in standard errors.
_MIN_JUMP_US, _SIGNIFICANT = 500.0, 5.0
#: Smallest number of samples of a block in which something moves.
_MIN_MOVING = 5
#: Variance below which two delays cannot be distinguished, in µs².
_MIN_VARIANCE = 1.0


@dataclass(frozen=True, slots=True)
class Delay:
    """From ``block`` on, which begins at ``time_us``, the log is later by ``jump_us`` than before.

    A negative jump: it is earlier.
    """

    block: Span | None
    time_us: int
    jump_us: float


class BlockDelays:
    """Gathers signal after signal how late a log is in each block of a run."""

    def __init__(self, blocks: Sequence[Event]) -> None:
        self._blocks = blocks
        self._begins = numpy.array([event.time_us for event in blocks], dtype=numpy.float64)
        size = len(blocks) + 1
        self._slopes, self._products, self._squares, self._counts = numpy.zeros((4, size))

    def add(self, samples: Samples, curve: Curve, alignment: Alignment) -> None:
        """Add a signal; what does not move says nothing."""
        times = alignment.run_times(samples.times)
        is_inside = (times >= 0.0) & (times <= curve.end_us)
        inside = times[is_inside]
        span = float(numpy.ptp(curve.values)) if len(inside) else 0.0
        if span <= 0.0:
            return
        slope = curve.slope_at(inside) / span
        difference = (samples.values[is_inside] - curve.at(inside)) / span
        number = numpy.searchsorted(self._begins, inside, side="right")
        if alignment.is_scaled:
            slope = self._centred(number, slope)
            difference = self._centred(number, difference)
        self._slopes += self._summed(number, slope**2)
        self._products += self._summed(number, slope * difference)
        self._squares += self._summed(number, difference**2)
        self._counts += self._summed(number, (slope != 0.0) * 1.0)

    def _centred(
        self, number: NDArray[numpy.int64], values: NDArray[numpy.float64]
    ) -> NDArray[numpy.float64]:
        """Return values less their mean in the block."""
        counts = numpy.maximum(self._summed(number, numpy.ones_like(values)), 1.0)
        centred: NDArray[numpy.float64] = values - (self._summed(number, values) / counts)[number]
        return centred

    def _summed(
        self, number: NDArray[numpy.int64], values: NDArray[numpy.float64]
    ) -> NDArray[numpy.float64]:
        found = numpy.bincount(number, values, len(self._slopes))
        return numpy.asarray(found, dtype=numpy.float64)

    def found(self) -> list[Delay]:
        """Return where the log becomes later or earlier, in the order of the blocks."""
        delays: list[Delay] = []
        weights = weighted = 0.0  # of the blocks since the last jump
        for number in map(int, numpy.flatnonzero(self._counts >= _MIN_MOVING)):
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
        slopes = float(self._slopes[number])
        late = -float(self._products[number]) / slopes
        rest = max(float(self._squares[number]) - late**2 * slopes, 0.0)
        return late, rest / (float(self._counts[number]) - 1.0) / slopes + _MIN_VARIANCE

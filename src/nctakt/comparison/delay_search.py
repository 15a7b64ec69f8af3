# SPDX-License-Identifier: MIT
"""Where a log is later than the run, and by how much (LG-706), delay by delay.

``BlockDelays`` finds the first block in which the log becomes late, the length by ``length_at``;
with it the alignment moves, so that the next delay is found in the rest. If a length is not
certain, nothing is known about the log after the place either.
"""

from __future__ import annotations

import bisect
from collections import deque
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.comparison.alignment import Alignment, aligned_before
from nctakt.comparison.columns import range_of, stretches
from nctakt.comparison.delays import BlockDelays, Delay
from nctakt.comparison.deviations import beside
from nctakt.comparison.lengths import (
    MIN_LENGTH_US,
    Length,
    Place,
    Signals,
    beginning,
    fits,
    length_at,
)
from nctakt.results.trace.events import Event

#: The largest number of delays; with more, the log probably belongs to another program.
MAX_DELAYS = 10
#: The first stretch of the run in which the next delay is looked for; then four times as long.
_STRETCH_US, _LONGER = 60e6, 4.0
#: The misfit before a place, as a share of a signal's span, with which the place is sure.
_SURE = 1e-3
#: The number of moving blocks that are tried before the late one, and after it.
_BESIDE = 2


@dataclass(frozen=True, slots=True)
class Delays:
    """Delays in the order of their blocks; ``is_cut``: after them the log is late once more."""

    found: Sequence[Delay] = ()
    is_cut: bool = False


class DelaySearch:
    """The search in one log; ``signals``: curves that are no whole numbers."""

    def __init__(self, signals: Signals, blocks: Sequence[Event], cycle_time_us: int) -> None:
        self._signals = [
            (samples, curve)
            for samples, curve in signals
            if samples.span > 0.0 and range_of(curve.values) > 0.0
        ]
        self._blocks = blocks
        self._cycle_time_us = cycle_time_us
        self._end_us = max((curve.end_us for _, curve in self._signals), default=0.0)

    def is_apart(self, alignment: Alignment) -> bool:
        """Return whether the run, with a gain and a bias, does not explain the log."""
        return not fits(self._signals, alignment, 0.0, self._end_us)

    def begun(self, alignment: Alignment) -> Alignment:
        """Return the alignment by the part before the first delay, unchanged if that is uncertain.

        The most of a log may lie after a delay, and the alignment with it.
        """
        first_us = self._first_us(alignment, 0.0)
        if first_us is None:
            return alignment
        if not fits(self._signals, alignment, 0.0, first_us):
            shift_us = beginning(self._signals, alignment, self._first_motion_us())
            alignment = _moved(alignment, shift_us)
            first_us = self._first_us(alignment, 0.0) if shift_us else None
        if first_us is None:
            return alignment
        return aligned_before(self._signals, alignment, first_us)

    def delays(self, alignment: Alignment) -> Delays:
        """Return the delays of a log that lies where its beginning does."""
        found: list[Delay] = []
        begin_us = 0.0
        while (late_us := self._first_us(alignment, begin_us)) is not None:
            if len(found) == MAX_DELAYS or not fits(self._signals, alignment, begin_us, late_us):
                return Delays(found, is_cut=bool(found))
            at = self._number(late_us)
            # The block of a short delay, or the one where the log is early, may be a neighbour.
            earlier = self._moving(range(at - 1, -1, -1), begin_us, _BESIDE + 1)
            later = self._moving(range(at + 1, len(self._blocks)), begin_us, _BESIDE)
            numbers = [at, *earlier[:_BESIDE], *later]
            # at the end of a block's first tick it has moved: it is at rest where the tick begins
            times_us = [float(self._blocks[one].time_us - self._cycle_time_us) for one in numbers]
            length = length_at(self._signals, Place(times_us, begin_us, alignment))
            time_us = length.time_us if isinstance(length, Length) else length
            is_before_all = time_us == min(times_us) and len(earlier) > _BESIDE
            if time_us is None or is_before_all:
                return Delays(found, is_cut=bool(found))
            event = self._blocks[numbers[times_us.index(time_us)]]
            if not isinstance(length, Length):
                if fits(self._signals, alignment, begin_us, float(event.time_us), _SURE):
                    found.append(Delay(event.span, event.time_us, None))
                break
            begin_us = float(event.time_us)
            alignment = _moved(alignment, length.shift_us)
            if abs(length.length_us) >= MIN_LENGTH_US:
                found.append(Delay(event.span, event.time_us, length.length_us))
        return Delays(found)

    def _first_us(self, alignment: Alignment, begin_us: float) -> float | None:
        """Return when the first block begins in which the log is late, after a time."""
        late = self._next(alignment, begin_us)
        end_us = self._end_us if late is None else float(late.time_us)
        late_us = None if late is None else end_us
        if fits(self._signals, alignment, begin_us, end_us):
            return late_us
        blocks = range(self._number(begin_us) + 1, self._number(end_us))
        at = bisect.bisect_left(blocks, True, key=partial(self._is_apart_by, alignment, begin_us))
        return float(self._blocks[blocks[at]].time_us) if at < len(blocks) else late_us

    def _is_apart_by(self, alignment: Alignment, begin_us: float, number: int) -> bool:
        """Return whether the log is apart somewhere until the end of a block."""
        last = number + 1 == len(self._blocks)
        end_us = self._end_us if last else float(self._blocks[number + 1].time_us)
        return not fits(self._signals, alignment, begin_us, end_us)

    def _next(self, alignment: Alignment, begin_us: float) -> Delay | None:
        """Return the next delay after a time, with the length that deviations seem to have."""
        stretch = _STRETCH_US
        while True:
            end_us = min(begin_us + stretch, self._end_us)
            gathered = BlockDelays(self._blocks, self._cycle_time_us, alignment.is_scaled)
            for samples, curve in self._signals:
                part = alignment.between(samples, begin_us, end_us)
                deque(beside(part, curve, alignment, gathered), maxlen=0)
            found = gathered.found()
            if found or end_us >= self._end_us:
                return found[0] if found else None
            stretch *= _LONGER

    def _number(self, time_us: float) -> int:
        """Return the number of the first block that begins at a time or after it."""
        return bisect.bisect_left(self._blocks, time_us, key=lambda one: one.time_us)

    def _moving(self, numbers: range, begin_us: float, count: int) -> list[int]:
        """Return those of some blocks in which something moves, the first ``count`` of them."""
        found: list[int] = []
        for number in numbers:
            if len(found) == count or self._blocks[number].time_us <= begin_us:
                break
            if self._moves(number):
                found.append(number)
        return found

    def _moves(self, number: int) -> bool:
        """Return whether something moves in a block."""
        first = self._blocks[number].tick
        last = number + 1 == len(self._blocks)
        end = first + len(self._signals[0][1].values) if last else self._blocks[number + 1].tick
        return any(numpy.ptp(curve.values[first:end]) > 0.0 for _, curve in self._signals)

    def _first_motion_us(self) -> float:
        """Return when the first of the signals begins to move."""
        first_us = numpy.inf
        for _, curve in self._signals:
            for part in stretches(len(curve.values)):
                moved = curve.values[part] != curve.values[:1]
                if moved.any():
                    first_us = min(first_us, (part.start + int(moved.argmax())) * curve.period_us)
                    break
        return float(first_us)


def _moved(alignment: Alignment, shift_us: float) -> Alignment:
    """Return an alignment in which the log is less late by a time of the run."""
    offset_us = alignment.offset_us + (1.0 + alignment.drift) * shift_us
    return replace(alignment, offset_us=offset_us)

# SPDX-License-Identifier: MIT
"""Which parked controllers a session keeps, so that any past moment is near one of them.

In: where controllers are parked, as the work of running up to there from the start, in
microseconds. Out: which of them to give up, and where to park next. They stand in windows that end
at the present and grow by a factor: their number grows with the logarithm of the session's length,
and a moment that lies twice as far back is at most twice as dear to reach.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass

#: Parked controllers of a session at most; each is a process that shares its memory.
MAX_PARKED = 32

#: Work between two parked controllers while a session goes forward, in microseconds.
SPARSE_US = 500_000.0

#: Work from the nearest parked controller to a moment that somebody has gone back to.
DENSE_US = 2_000.0

#: How much wider each window is than the one behind it.
GROWTH = 2.0

#: The controllers that a window holds.
WINDOW_COUNT = 3


@dataclass(frozen=True, slots=True)
class Cost:
    """The work of running a stretch again, in microseconds: per tick and per block."""

    tick_us: float = 0.15
    block_us: float = 5.0

    def of(self, ticks: int, blocks: int) -> float:
        """Return the work of so many ticks and blocks, in microseconds."""
        return ticks * self.tick_us + blocks * self.block_us


def surplus(parked: Sequence[float], present: float) -> list[int]:
    """Return the indexes to give up, so that each window holds at most ``WINDOW_COUNT``.

    ``parked`` ascends; the first one, the start, is always kept. Of a window that holds too many
    goes, one by one, the controller whose neighbours are nearest to each other.
    """
    kept = list(range(len(parked)))
    given_up: list[int] = []

    def give_up(candidates: list[int]) -> None:
        loss = min(candidates, key=lambda index: _gap_without(parked, kept, index, present))
        kept.remove(loss)
        given_up.append(loss)

    for low, high in _windows(present):
        while True:
            inside = [i for i in kept if i > 0 and low <= present - parked[i] < high]
            if len(inside) <= WINDOW_COUNT:
                break
            give_up(inside)
    while len(kept) > MAX_PARKED:
        give_up(kept[1:])
    return sorted(given_up)


def _windows(present: float) -> Iterator[tuple[float, float]]:
    """Yield the windows as distances back from the present, up to the start."""
    low, high = 0.0, DENSE_US * WINDOW_COUNT
    while low <= present:
        yield low, high
        low, high = high, high * GROWTH + DENSE_US


def _gap_without(parked: Sequence[float], kept: Sequence[int], index: int, present: float) -> float:
    """Return the distance between the neighbours of a controller, by how far back it is."""
    position = kept.index(index)
    before = parked[kept[position - 1]]
    after = parked[kept[position + 1]] if position + 1 < len(kept) else present
    return (after - before) / max(present - before, 1.0)


def approach(start: float, target: float) -> list[float]:
    """Return where to park on the way from ``start`` to ``target``.

    Half of what is left each time, down to ``DENSE_US`` in front of the target, so that going back
    again from there is cheap.
    """
    places = []
    left = target - start
    while left > 2.0 * DENSE_US:
        left /= 2.0
        places.append(target - left)
    return places

# SPDX-License-Identifier: MIT
"""Which parked controllers a session keeps, so that any past moment is near one of them.

In: where controllers are parked, as the work of running up to there from the start, in
microseconds. Out: which of them to give up, and where to park next. They are in windows around
the present that grow by a factor: their number grows with the logarithm of the session's length,
and a moment that lies twice as far back is at most twice as dear to reach.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

#: Parked controllers of a session at most; each is a process that shares its memory.
MAX_PARKED = 48

#: Work between two parked controllers while a session goes forward, in microseconds.
SPARSE_US = 60_000.0

#: Work from the nearest parked controller to a moment that somebody has gone back to.
DENSE_US = 5_000.0

#: How much wider each window is than the one nearer to the present.
GROWTH = 2.0

#: The controllers that a window holds.
WINDOW_COUNT = 2


def surplus(parked: Sequence[float], present: float) -> list[int]:
    """Return the indexes to give up, so that each window holds at most ``WINDOW_COUNT``.

    ``parked`` ascends; the first one, the start, and the last one are always kept. Of a window that
    holds too many goes, one by one, the controller whose neighbours are nearest to each other.
    """
    kept = list(range(len(parked)))
    given_up: list[int] = []

    def give_up(candidates: list[int]) -> None:
        loss = min(candidates, key=lambda index: _gap_without(parked, kept, index, present))
        kept.remove(loss)
        given_up.append(loss)

    between = kept[1:-1]
    for is_ahead in (False, True):
        side = [index for index in between if (parked[index] > present) is is_ahead]
        reach = max((abs(present - parked[index]) for index in side), default=0.0)
        for low, high in _windows(reach):
            inside = [index for index in side if low <= abs(present - parked[index]) < high]
            while len(inside) > WINDOW_COUNT:
                give_up(inside)
                inside.remove(given_up[-1])
    while len(kept) > MAX_PARKED:
        give_up(kept[1:-1])
    return sorted(given_up)


def _windows(reach: float) -> Iterator[tuple[float, float]]:
    """Yield the windows as distances from the present, up to ``reach``."""
    low, high = 0.0, DENSE_US * WINDOW_COUNT
    while low <= reach:
        yield low, high
        low, high = high, high * GROWTH + DENSE_US


def _gap_without(parked: Sequence[float], kept: Sequence[int], index: int, present: float) -> float:
    """Return the distance between the neighbours of a controller, by how far away it is."""
    position = kept.index(index)
    gap = parked[kept[position + 1]] - parked[kept[position - 1]]
    return gap / max(abs(present - parked[index]), DENSE_US)


def approach(start: float, target: float) -> list[float]:
    """Return where to park on the way from ``start`` to ``target``.

    Half of what is left each time, so that going back again from there is cheap; on a short way
    once, since each copy takes its time as well. Nearer than ``DENSE_US`` there is none.
    """
    places = []
    left = target - start
    while left > 4.0 * DENSE_US:
        left /= 2.0 if left > SPARSE_US else 4.0
        places.append(target - left)
    return places


def first_gap(parked: Sequence[float], present: float) -> tuple[int, float] | None:
    """Return after which parked controller another one is missing, and where; ``None``: nowhere.

    ``parked`` ascends, up to ``present``. Of two neighbours the nearer one may be no farther from
    the present than from the other one: then whoever goes back step by step never has far to go.
    """
    nearer = present
    for index in reversed(range(len(parked))):
        gap = nearer - parked[index]
        if gap > 2.0 * max(DENSE_US, present - nearer):
            return index, parked[index] + gap / 2.0
        nearer = parked[index]
    return None

# SPDX-License-Identifier: MIT
"""Which parked controllers a session keeps, so that any past moment is near one of them.

In: where controllers are parked, as the work of running up to there from the start, in
microseconds. Out: which of them to give up, and where to park next. Around the present a gap
between two of them grows with its distance; farther away all gaps are alike.
"""

from __future__ import annotations

from collections.abc import Sequence

#: Parked controllers of a session at most; each is a process that shares its memory.
MAX_PARKED = 32

#: Work between two parked controllers while a session goes forward, in microseconds.
SPARSE_US = 45_000.0

#: Work from the nearest parked controller to a moment that somebody has gone back to.
DENSE_US = 5_000.0

#: Total cost of a copy of a controller: making it, its first ticks, its end.
COPY_US = 6_000.0

#: From this share of the whole work on, gaps are no longer wider where they are farther away.
EVEN_SHARE = 10.0


def surplus(parked: Sequence[float], present: float, capacity: int = MAX_PARKED) -> list[int]:
    """Return the indexes to give up, so that at most ``capacity`` are left.

    ``parked`` ascends; the first one, the start, and the last one are always kept. Controllers are
    removed one by one, always the one that leaves the smallest gap between its neighbours, relative
    to the gap allowed there.
    """
    kept = list(range(len(parked)))
    given_up: list[int] = []
    even_us = (parked[-1] - parked[0]) / EVEN_SHARE if parked else 0.0

    def share(position: int) -> float:
        gap_us = parked[kept[position + 1]] - parked[kept[position - 1]]
        away_us = abs(present - parked[kept[position]])
        return gap_us / max(min(away_us, even_us), DENSE_US)

    while len(kept) > capacity:
        given_up.append(kept.pop(min(range(1, len(kept) - 1), key=share)))
    return sorted(given_up)


def approach(start: float, target: float, nearest: float = 4.0 * DENSE_US) -> list[float]:
    """Return where to park between ``start`` and ``target``.

    At half of the rest each time, so that going back again from there is cheap; only once on a
    short distance, since each copy costs time as well; no more once at most ``nearest`` is left.
    """
    places = []
    left = target - start
    while left > nearest:
        left /= 2.0 if left > SPARSE_US else 4.0
        places.append(target - left)
    return places


def first_gap(parked: Sequence[float], present: float) -> tuple[int, float] | None:
    """Return after which parked controller another is missing, and where; ``None``: nowhere.

    ``parked`` ascends, up to ``present``. The nearer of two neighbours may be no farther from the
    present than from the other: so going back step by step is never far.
    """
    nearer = present
    for index in reversed(range(len(parked))):
        gap = nearer - parked[index]
        if gap > 2.0 * max(DENSE_US, present - nearer):
            return index, parked[index] + gap / 2.0
        nearer = parked[index]
    return None

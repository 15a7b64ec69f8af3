# SPDX-License-Identifier: MIT
"""Which of many rows show where something goes: some at even distances, others where it bends.

In: rows, with a column for each followed value. Out: the indices of the rows kept. Between two of
them the values change in a nearly straight line, at nearly constant speed.
"""

from __future__ import annotations

import heapq
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

#: How far from a straight line a dropped row may be, as a share of the whole range.
TOLERANCE = 1e-5

#: A span between two kept rows: distance of the farthest row (negative), its index, the ends.
_Gap = tuple[float, int, int, int]


def outlined(ticks: NDArray[np.int64], rows: NDArray[np.float64], count: int) -> NDArray[np.int64]:
    """Return the places of ``count`` rows at most, in their order, first and last among them.

    Half of them are at even distances; the others are those that are farthest from where they
    would be in between. ``ticks``: those of the rows.
    """
    if len(rows) <= count or count < 4:
        return _evenly(len(rows), max(1, -(-len(rows) // max(count, 1))))
    found = [0, *_evenly(len(rows), -(-2 * len(rows) // count)).tolist()]
    finite = np.where(np.isfinite(rows), rows, 0.0)
    tolerance = TOLERANCE * float(np.max(np.ptp(finite, axis=0), initial=0.0))
    gaps = [_farthest(ticks, finite, begin, end) for begin, end in pairwise(found)]
    heapq.heapify(gaps)
    while len(found) < count and -gaps[0][0] > tolerance:
        _, farthest, begin, end = heapq.heappop(gaps)
        found.append(farthest)
        heapq.heappush(gaps, _farthest(ticks, finite, begin, farthest))
        heapq.heappush(gaps, _farthest(ticks, finite, farthest, end))
    return np.unique(np.array(found, np.int64))


def _evenly(count: int, every: int) -> NDArray[np.int64]:
    """Return each ``every``-th of some places, and the last one."""
    return np.minimum(np.arange(every - 1, count + every - 1, every, dtype=np.int64), count - 1)


def _farthest(ticks: NDArray[np.int64], rows: NDArray[np.float64], begin: int, end: int) -> _Gap:
    """Return the row between two that is farthest from the line between them."""
    if end - begin < 2:
        return 0.0, begin, begin, end
    first, last = rows[begin], rows[end]
    share = (ticks[begin + 1 : end] - ticks[begin]) / (ticks[end] - ticks[begin])
    away = rows[begin + 1 : end] - first - share[:, np.newaxis] * (last - first)
    squares = np.einsum("ij,ij->i", away, away)
    index = int(squares.argmax())
    return -(float(squares[index]) ** 0.5), begin + 1 + index, begin, end

# SPDX-License-Identifier: MIT
"""Ways of the axes as polylines, and how far one is from another."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nctakt.results.run import Run

Points = NDArray[np.float64]


def way(run: Run, signals: list[str], tick: int = 0) -> Points:
    """Return where the axes have been from a tick on; where they are at rest, once."""
    assert run.trace is not None
    points = np.array([run.trace[signal][tick:] for signal in signals]).T
    moved = np.r_[True, np.any(np.diff(points, axis=0) != 0.0, axis=1)]
    return points[moved]


def apart(one: Points, other: Points) -> float:
    """Return the largest distance of some points of either way from the other, mm."""
    return max(_off(one, other), _off(other, one))


def _off(points: Points, line: Points) -> float:
    line = np.vstack([line, line[-1:]])
    begin, distance = line[:-1], np.diff(line, axis=0)
    squares = np.maximum((distance * distance).sum(1), 1e-30)
    farthest = 0.0
    for point in points[:: max(1, len(points) // 50)]:
        part = np.clip(((point - begin) * distance).sum(1) / squares, 0.0, 1.0)
        nearest = point - begin - distance * part[:, None]
        farthest = max(farthest, float(np.sqrt((nearest * nearest).sum(1).min())))
    return farthest

# SPDX-License-Identifier: MIT
"""Akima splines: a curve through vertices, each piece from its neighbours (MO-18).

H. Akima 1970, axis by axis, over the length of the chords: the slope at a vertex is the mean of the
slopes of the chords next to it, each weighted by the change of slope on the other side; two chords
are extrapolated at either end. A piece is known when two more vertices are there.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.decoder.state.geometry.cubics import Cubic, Point, hermite

#: Changes of slope are the same below this part of the slopes.
SAME_SLOPE = 1e-9


class AkimaCurve:
    """A curve from vertex to vertex; ``chords``: their lengths.

    ``start_slope`` and ``end_slope``: given slopes by axis, ``None`` for an axis without; empty
    where all follow from the vertices.
    """

    #: How many vertices after its end a piece needs to be known.
    AHEAD = 2
    #: How many vertices a curve has at least.
    FEWEST = 3

    def __init__(self, start: Point) -> None:
        self.points = [start]
        self.chords: list[float] = []
        self.start_slope: Sequence[float | None] = ()
        self.end_slope: Sequence[float | None] = ()
        self._slopes: list[Point] = []

    def add(self, point: Point, chord: float) -> None:
        """Append a vertex ``chord`` mm after the last one."""
        before = self.points[-1]
        self.points.append(point)
        self.chords.append(chord)
        self._slopes.append(tuple((b - a) / chord for a, b in zip(before, point, strict=True)))

    @property
    def is_long_enough(self) -> bool:
        """Whether the curve has as many vertices as it needs."""
        given = bool(self.start_slope) and bool(self.end_slope)
        return len(self.points) >= (2 if given else self.FEWEST)

    def piece(self, number: int) -> Cubic:
        """Return the piece after vertex ``number``; missing vertices end the curve."""
        slopes = (self._slope_at(number), self._slope_at(number + 1))
        ends = (self.points[number], self.points[number + 1])
        return hermite(*ends, slopes, self.chords[number])

    def _slope_at(self, number: int) -> Point:
        """Return the slope at a vertex."""
        given: Sequence[float | None] = ()
        if number == 0:
            given = self.start_slope
        elif number == len(self._slopes):
            given = self.end_slope
        return tuple(
            self._akima(number, axis)
            if not given or given[axis] is None
            else float(given[axis] or 0)
            for axis in range(len(self.points[0]))
        )

    def _akima(self, number: int, axis: int) -> float:
        """Return the slope of an axis at a vertex, from four chords."""
        m = [self._chord_slope(index, axis) for index in range(number - 2, number + 2)]
        before, after = abs(m[1] - m[0]), abs(m[3] - m[2])
        if before + after <= SAME_SLOPE * max(map(abs, m)):
            return 0.5 * (m[0] + m[3])
        return (after * m[1] + before * m[2]) / (before + after)

    def _chord_slope(self, index: int, axis: int) -> float:
        """Return the slope of a chord; beyond the ends it is extrapolated."""
        last = len(self._slopes) - 1
        if 0 <= index <= last:
            return self._slopes[index][axis]
        near, inner = (0, 1) if index < 0 else (last, last - 1)
        if last == 0:
            return self._slopes[0][axis]
        beyond = -index if index < 0 else index - last
        edge = self._slopes[near][axis]
        return edge + beyond * (edge - self._slopes[inner][axis])

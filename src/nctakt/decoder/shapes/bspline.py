# SPDX-License-Identifier: MIT
"""B-splines: a cubic curve that control points draw, with uniform knots (MO-18).

The curve begins at the first control point and ends at the last one (its knots are there four
times); in between it passes near them. The block that ends at a control point has the curve up to
the mean of three knots that belongs to the point (Greville). A block is known when four more
control points are there.
"""

from __future__ import annotations

from nctakt.decoder.state.geometry.cubics import Cubic, Point, between

DEGREE = 3


class BsplineCurve:
    """A curve of control points."""

    #: How many control points after its own a block needs to be known.
    AHEAD = 4
    #: How many control points a curve has at least.
    FEWEST = 4

    def __init__(self, start: Point) -> None:
        self.points = [start]

    def add(self, point: Point) -> None:
        """Append a control point."""
        self.points.append(point)

    @property
    def is_long_enough(self) -> bool:
        """Whether the curve has as many control points as it needs."""
        return len(self.points) >= self.FEWEST

    def piece(self, number: int) -> Cubic:
        """Return the curve of the block that leaves control point ``number``."""
        begin, end = self._mean(number), self._mean(number + 1)
        span = min(int(0.5 * (begin + end)), self._spans - 1)
        steps = [(begin, begin, begin), (begin, begin, end), (begin, end, end), (end, end, end)]
        first, second, third, last = (self._blossom(span, step) for step in steps)
        return (first, second, third, last)

    @property
    def _spans(self) -> int:
        return len(self.points) - DEGREE

    def _knot(self, index: int) -> float:
        """Return a knot; the first and the last four are the same."""
        return float(min(max(index - DEGREE, 0), self._spans))

    def _mean(self, number: int) -> float:
        """Return the parameter that belongs to a control point."""
        return (self._knot(number + 1) + self._knot(number + 2) + self._knot(number + 3)) / 3.0

    def _blossom(self, span: int, at: tuple[float, float, float]) -> Point:
        """Return the point of the polar form of a span (de Boor)."""
        points = self.points[span : span + DEGREE + 1]
        for level in range(DEGREE):
            points = [
                between(
                    points[index],
                    points[index + 1],
                    self._part(span, level, index, at[level]),
                )
                for index in range(DEGREE - level)
            ]
        return points[0]

    def _part(self, span: int, level: int, index: int, at: float) -> float:
        low = self._knot(span + level + index + 1)
        high = self._knot(span + index + DEGREE + 1)
        return (at - low) / (high - low)

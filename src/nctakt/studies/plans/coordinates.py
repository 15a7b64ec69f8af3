# SPDX-License-Identifier: MIT
"""The points of a plan as whole numbers, for searches that go from one to its neighbours.

In: a plan. Out: coordinates, one for each dimension, and the values that they stand for. A
dimension without steps has as many coordinates as it has ticks or whole numbers, at most a million.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from nctakt.studies.plans.dimension import Dimension, Value
from nctakt.studies.plans.plan import Plan

Coordinates = tuple[int, ...]

#: The coordinates of a dimension in which any value may be taken.
MAX_COORDINATES = 1 << 20

#: The share of all points between two that are tried one after the other: the golden ratio.
_SPREAD = 0.6180339887498949


class PlanCoordinates:
    """The coordinates of a plan; those of a list of points are their numbers."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._is_list = plan.method == "list"
        self.sizes = (plan.size,) if self._is_list else tuple(map(_size, plan.dimensions))
        self.count = math.prod(self.sizes)

    def point(self, coordinates: Coordinates) -> tuple[Value, ...]:
        """Return the values of the dimensions."""
        if self._is_list:
            return self._plan.point(coordinates[0])
        parts = zip(self._plan.dimensions, coordinates, self.sizes, strict=True)
        return tuple(_value(dimension, number, size) for dimension, number, size in parts)

    def number(self, coordinates: Coordinates) -> int | None:
        """Return the number of the run with these coordinates; ``None`` for points by chance."""
        if self._plan.method not in ("grid", "list"):
            return None
        number = 0
        for coordinate, size in zip(coordinates, self.sizes, strict=True):
            number = number * size + coordinate
        return number

    def of_point(self, point: Sequence[Value]) -> Coordinates | None:
        """Return the coordinates of values that earlier runs had; ``None``: no longer there."""
        if self._is_list:
            points = (self._plan.point(number) for number in range(self._plan.size))
            return next(((i,) for i, one in enumerate(points) if list(one) == list(point)), None)
        found = []
        for dimension, value, size in zip(self._plan.dimensions, point, self.sizes, strict=True):
            number = _number(dimension, value, size)
            if number is None:
                return None
            found.append(number)
        return tuple(found)

    def spread(self) -> Iterator[Coordinates]:
        """Yield the coordinates of all points once, those in a row far from each other."""
        step = max(1, round(self.count * _SPREAD))
        while math.gcd(step, self.count) != 1:
            step += 1
        for index in range(self.count):
            yield self._at(index * step % self.count)

    def _at(self, number: int) -> Coordinates:
        coordinates = []
        for size in reversed(self.sizes):
            number, coordinate = divmod(number, size)
            coordinates.append(coordinate)
        return tuple(reversed(coordinates))


def _size(dimension: Dimension) -> int:
    """Return the number of coordinates of a dimension."""
    if dimension.count:
        return dimension.count
    span = dimension.high - dimension.low
    if dimension.is_time:
        span /= dimension.tick_us
    elif not dimension.is_whole:
        return MAX_COORDINATES
    return max(1, min(int(span) + 1, MAX_COORDINATES))


def _value(dimension: Dimension, number: int, size: int) -> Value:
    if dimension.count:
        return dimension.value(number)
    return dimension.between(number / (size - 1) if size > 1 else 0.0)


def _number(dimension: Dimension, value: Value, size: int) -> int | None:
    """Return the coordinate whose value is nearest; ``None`` for one that is not in the plan."""
    if dimension.values:
        return dimension.values.index(value) if value in dimension.values else None
    if isinstance(value, str) or not dimension.low <= value <= dimension.high:
        return None
    span = dimension.high - dimension.low
    share = (value - dimension.low) / (dimension.step or span or 1.0)
    return min(round(share if dimension.count else share * (size - 1)), size - 1)

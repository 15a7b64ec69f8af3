# SPDX-License-Identifier: MIT
"""The points of a plan as whole numbers, for searches that go from a point to its neighbours.

In: a plan. Out: coordinates, one for each dimension, and the values that they represent. A
dimension without steps has a coordinate for each tick or whole number; if it takes any number, for
its bounds and for at most a million round numbers or all whole numbers between them, since programs
compare with round numbers.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from nctakt.studies.plans.dimension import Dimension, Value
from nctakt.studies.plans.plan import Plan

Coordinates = tuple[int, ...]

#: Number of round numbers of a dimension that takes any value, unless there are more whole ones.
MAX_COORDINATES = 1 << 20

#: The share of all points between two consecutive trials: the golden ratio.
_SPREAD, _SPREAD_OF = 618_033_988_749_895, 10**15


class _RoundNumbers:
    """The bounds of a range, and the multiples of 1, 2 or 5 times a power of ten between them."""

    def __init__(self, low: float, high: float) -> None:
        self._ends = low, high
        exponent = min(math.floor(math.log10((high - low) / MAX_COORDINATES)), -1)
        widths = (Fraction(10) ** exponent * factor for factor in (1, 2, 5))
        fine = (one for one in widths if (high - low) / one < MAX_COORDINATES)
        self._step = next(fine, Fraction(10) ** (exponent + 1))
        self._first = math.floor(Fraction(str(low)) / self._step) + 1
        self._count = math.ceil(Fraction(str(high)) / self._step) - self._first
        self.size = self._count + 2

    def value(self, number: int) -> float:
        """Return a number of the range."""
        if not 0 < number <= self._count:
            return self._ends[number > 0]
        return float((self._first + number - 1) * self._step)

    def number_of(self, value: float) -> int:
        """Return where the nearest number is."""
        number = round(Fraction(str(value)) / self._step) - self._first + 1
        return min(range(number - 1, number + 2), key=lambda one: self._distance(value, one))

    def _distance(self, value: float, number: int) -> float:
        return abs(self.value(number) - value) if 0 <= number < self.size else math.inf


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
        """Return the number of the run with these coordinates; ``None`` for random points."""
        if self._plan.method not in ("grid", "list"):
            return None
        number = 0
        for coordinate, size in zip(coordinates, self.sizes, strict=True):
            number = number * size + coordinate
        return number

    def of_point(self, point: Sequence[Value]) -> Coordinates | None:
        """Return the coordinates of values of earlier runs; ``None`` if they no longer exist."""
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
        step = max(1, self.count * _SPREAD // _SPREAD_OF)
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


_round_numbers = functools.lru_cache(_RoundNumbers)


def _takes_any(dimension: Dimension) -> bool:
    """Return whether a dimension takes any number between its bounds."""
    return not (dimension.count or dimension.is_time or dimension.is_whole)


def _size(dimension: Dimension) -> int:
    """Return the number of coordinates of a dimension."""
    if dimension.count:
        return dimension.count
    span = dimension.high - dimension.low
    if dimension.is_time:
        span /= dimension.tick_us
    elif not dimension.is_whole:
        return _round_numbers(dimension.low, dimension.high).size if span else 1
    return int(span) + 1


def _value(dimension: Dimension, number: int, size: int) -> Value:
    if dimension.count:
        return dimension.value(number)
    if size > 1 and _takes_any(dimension):
        return _round_numbers(dimension.low, dimension.high).value(number)
    return dimension.between(number / (size - 1) if size > 1 else 0.0)


def _number(dimension: Dimension, value: Value, size: int) -> int | None:
    """Return the coordinate whose value is nearest; ``None`` if it is not in the plan."""
    if dimension.values:
        return dimension.values.index(value) if value in dimension.values else None
    if isinstance(value, str) or not dimension.low <= value <= dimension.high:
        return None
    span = dimension.high - dimension.low
    if span and _takes_any(dimension):
        return _round_numbers(dimension.low, dimension.high).number_of(value)
    share = (value - dimension.low) / (dimension.step or span or 1.0)
    return min(round(share if dimension.count else share * (size - 1)), size - 1)

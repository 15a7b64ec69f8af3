# SPDX-License-Identifier: MIT
"""Cubics with four control points: divided until the path can carry them (MO-18).

The realtime part follows a cubic by a polynomial of its length (``kernel/path/cubic.py``). A cubic
is halved until that keeps the feed within ``MAX_RIPPLE``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

Point = tuple[float, ...]
#: Start, two inner control points, target; a number for each axis.
Cubic = tuple[Point, Point, Point, Point]

#: How far the speed on a piece may differ from the feed, as a part of it.
MAX_RIPPLE = 1e-4
#: How often a cubic is halved at most.
MAX_DEPTH = 7
#: A cubic shorter than this is not halved, mm.
SHORTEST_MM = 1e-4

#: Seven points of Gauss and Legendre on [0, 1]: distances from the middle with weights on [-1, 1].
_OFFSETS = (
    (0.2029225756886985, 0.3818300505051189),
    (0.3707655927996972, 0.2797053914892767),
    (0.4745539561713793, 0.1294849661688697),
)
_NODES = (
    (0.5, 0.2089795918367347),
    *((0.5 - offset, 0.5 * weight) for offset, weight in _OFFSETS),
    *((0.5 + offset, 0.5 * weight) for offset, weight in _OFFSETS),
)

_PARTS = tuple(number / 8 for number in range(1, 8))


def straight(start: Point, target: Point) -> Cubic:
    """Return a line as a cubic."""
    return (start, between(start, target, 1.0 / 3.0), between(start, target, 2.0 / 3.0), target)


def between(one: Point, other: Point, part: float) -> Point:
    """Return the point after a share of the line between two points."""
    return tuple(a + (b - a) * part for a, b in zip(one, other, strict=True))


def hermite(start: Point, target: Point, slopes: tuple[Point, Point], length: float) -> Cubic:
    """Return the cubic with these slopes at its ends, over a parameter of this length."""
    third = length / 3.0
    leaving = tuple(a + third * s for a, s in zip(start, slopes[0], strict=True))
    entering = tuple(a - third * s for a, s in zip(target, slopes[1], strict=True))
    return (start, leaving, entering, target)


def halves(cubic: Cubic) -> tuple[Cubic, Cubic]:
    """Return both halves of a cubic (de Casteljau)."""
    a, b, c, d = cubic
    ab, bc, cd = between(a, b, 0.5), between(b, c, 0.5), between(c, d, 0.5)
    abc, bcd = between(ab, bc, 0.5), between(bc, cd, 0.5)
    middle = between(abc, bcd, 0.5)
    return (a, ab, abc, middle), (middle, bcd, cd, d)


def point(cubic: Cubic, t: float) -> Point:
    """Return the point at a value of the cubic's parameter."""
    rest = 1.0 - t
    factors = (rest * rest * rest, 3.0 * rest * rest * t, 3.0 * rest * t * t, t * t * t)
    return tuple(
        sum(factor * value for factor, value in zip(factors, values, strict=True))
        for values in zip(*cubic, strict=True)
    )


def length_of(cubic: Cubic, axes: Sequence[int]) -> float:
    """Return the length of a cubic over these axes."""
    return sum(weight * _rate(cubic, axes, t)[0] for t, weight in _NODES)


def _rate(cubic: Cubic, axes: Sequence[int], t: float) -> tuple[float, float]:
    """Return the change of the length with the parameter, and the change of that."""
    a, b, c, d = cubic
    rate2 = change = 0.0
    for axis in axes:
        linear = 3.0 * (b[axis] - a[axis])
        square = 3.0 * (c[axis] - 2.0 * b[axis] + a[axis])
        cube = d[axis] - a[axis] + 3.0 * (b[axis] - c[axis])
        slope = linear + t * (2.0 * square + 3.0 * cube * t)
        rate2 += slope * slope
        change += slope * (2.0 * square + 6.0 * cube * t)
    rate = math.sqrt(rate2)
    return rate, change / rate if rate > 0.0 else 0.0


def _is_even(cubic: Cubic, axes: Sequence[int], length: float) -> bool:
    """Return whether the realtime part keeps the feed on a cubic of this length."""
    start, start_change = _rate(cubic, axes, 0.0)
    end, end_change = _rate(cubic, axes, 1.0)
    if min(start, end) * 5.0 < length or max(start, end) * 0.2 > length:
        return False
    v0, v1 = length / start, length / end
    a0 = -start_change * v0 * v0 / start
    a1 = -end_change * v1 * v1 / end
    c3 = 10.0 - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1
    c4 = 8.0 * v0 + 7.0 * v1 - 15.0 + 1.5 * a0 - a1
    c5 = 6.0 - 3.0 * (v0 + v1) + 0.5 * (a1 - a0)
    for part in _PARTS:
        t = part * (v0 + part * (0.5 * a0 + part * (c3 + part * (c4 + part * c5))))
        slope = v0 + part * (a0 + part * (3.0 * c3 + part * (4.0 * c4 + part * 5.0 * c5)))
        if abs(_rate(cubic, axes, t)[0] * slope - length) > MAX_RIPPLE * length:
            return False
    return True


def divided(cubic: Cubic, axes: Sequence[int], depth: int = 0) -> Iterator[Cubic]:
    """Yield the pieces of a cubic that the realtime part can carry.

    ``axes``: those that its length counts.
    """
    length = length_of(cubic, axes)
    if depth >= MAX_DEPTH or length < SHORTEST_MM or _is_even(cubic, axes, length):
        yield cubic
        return
    for half in halves(cubic):
        yield from divided(half, axes, depth + 1)


def extremes(cubic: Cubic, axis: int) -> tuple[float, float]:
    """Return the lowest and the highest position of an axis on a cubic."""
    a, b, c, d = (control[axis] for control in cubic)
    ends = (min(a, d), max(a, d))
    if min(b, c) >= ends[0] and max(b, c) <= ends[1]:
        return ends
    square, linear = d - a + 3.0 * (b - c), 2.0 * (c - 2.0 * b + a)
    found = [*ends]
    for t in _roots(square, linear, b - a):
        if 0.0 < t < 1.0:
            found.append(point(((a,), (b,), (c,), (d,)), t)[0])
    return min(found), max(found)


def _roots(square: float, linear: float, constant: float) -> list[float]:
    """Return the real roots of a quadratic."""
    rest = linear * linear - 4.0 * square * constant
    if rest < 0.0:
        return []
    root = -0.5 * (linear + math.copysign(math.sqrt(rest), linear))
    return [above / below for above, below in ((root, square), (constant, root)) if below != 0.0]

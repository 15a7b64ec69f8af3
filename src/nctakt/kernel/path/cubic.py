# SPDX-License-Identifier: MIT
"""A piece of a spline: a cubic with four control points, by its length (MO-18).

Start, target and two inner control points of each axis are in the row of a segment (``rows.py``).
The cubic's parameter is a polynomial of fifth degree over the share of the length, whose value,
slope and curvature fit at both ends: so the speed is that of the path on short pieces, and exact
where two of them meet. Where the cubic nearly stops at an end, the parameter is the part of the
length itself.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic

#: Slopes of the parameter at an end beyond which it is the part of the length.
MIN_SLOPE = 0.2
MAX_SLOPE = 5.0


def is_cubic(segments: memoryview[float], row: int) -> int:
    """Return whether a segment is a piece of a spline."""
    return 1 if segments[row + rows.SHAPE] == rows.CUBIC else 0


def moves_axis(segments: memoryview[float], row: int, count: int, i: int) -> int:
    """Return whether a cubic moves its axis ``i``."""
    first = row + rows.START + i
    begin = segments[first]
    for _ in range(3):
        first += count
        if segments[first] != begin:
            return 1
    return 0


def parameter(segments: memoryview[float], row: int, part: float) -> float:
    """Return the cubic's parameter after a share of its length."""
    value = segments[row + rows.CUBIC_FIFTH] * part + segments[row + rows.CUBIC_FOURTH]
    value = value * part + segments[row + rows.CUBIC_CUBE]
    value = value * part + segments[row + rows.CUBIC_SQUARE]
    return (value * part + segments[row + rows.CUBIC_LINEAR]) * part


def locate(
    segments: memoryview[float], row: int, count: int, part: float, positions: memoryview[float]
) -> None:
    """Put the position of each axis after ``part`` of the length into ``positions``."""
    t = parameter(segments, row, part)
    rest = 1.0 - t
    first = row + rows.START
    for i in range(count):
        column = first + i
        begin = segments[column]
        end = segments[column + count]
        leaving = segments[column + count + count]
        entering = segments[column + count + count + count]
        positions[i] = rest * rest * (rest * begin + 3.0 * t * leaving) + t * t * (
            3.0 * rest * entering + t * end
        )


def differentiate(
    segments: memoryview[float],
    row: int,
    count: int,
    part: float,
    first: memoryview[float],
    second: memoryview[float],
    third: memoryview[float],
) -> None:
    """Put the three derivatives of each axis by the length into the arrays."""
    length = segments[row + rows.LENGTH]
    t = parameter(segments, row, part)
    linear = segments[row + rows.CUBIC_LINEAR]
    square = 2.0 * segments[row + rows.CUBIC_SQUARE]
    cube = 6.0 * segments[row + rows.CUBIC_CUBE]
    fourth = 24.0 * segments[row + rows.CUBIC_FOURTH]
    fifth = 120.0 * segments[row + rows.CUBIC_FIFTH]
    half = 0.5 * part
    slope = linear + part * (square + half * (cube + part / 3.0 * (fourth + part / 4.0 * fifth)))
    curve = square + part * (cube + half * (fourth + part / 3.0 * fifth))
    bend = cube + part * (fourth + half * fifth)
    slope /= length
    curve /= length * length
    bend /= length * length * length
    start = row + rows.START
    for i in range(count):
        column = start + i
        begin = segments[column]
        end = segments[column + count]
        leaving = segments[column + count + count]
        entering = segments[column + count + count + count]
        b1 = 3.0 * (leaving - begin)
        b2 = 3.0 * (entering - 2.0 * leaving + begin)
        b3 = end - begin + 3.0 * (leaving - entering)
        one = b1 + t * (2.0 * b2 + 3.0 * b3 * t)
        two = 2.0 * b2 + 6.0 * b3 * t
        first[i] = one * slope
        second[i] = two * slope * slope + one * curve
        third[i] = 6.0 * b3 * slope * slope * slope + 3.0 * two * slope * curve + one * bend


def rate(
    segments: memoryview[float],
    row: int,
    count: int,
    t: float,
    linear: memoryview[int],
    kind: int,
) -> float:
    """Return the derivative of the length by the cubic's parameter.

    ``kind``: 1 counts the linear axes, 0 the others.
    """
    start = row + rows.START
    rate2 = 0.0
    for i in range(count):
        if (linear[i] > 0) == (kind > 0):
            column = start + i
            begin = segments[column]
            end = segments[column + count]
            leaving = segments[column + count + count]
            entering = segments[column + count + count + count]
            b2 = 3.0 * (entering - 2.0 * leaving + begin)
            b3 = end - begin + 3.0 * (leaving - entering)
            one = 3.0 * (leaving - begin) + t * (2.0 * b2 + 3.0 * b3 * t)
            rate2 += one * one
    return arithmetic.square_root(rate2)


def rates(
    segments: memoryview[float],
    row: int,
    count: int,
    offset: float,
    linear: memoryview[int],
    kind: int,
) -> float:
    """Return the sum of ``rate`` on both sides of the middle."""
    before = rate(segments, row, count, 0.5 - offset, linear, kind)
    return before + rate(segments, row, count, 0.5 + offset, linear, kind)


def measure(segments: memoryview[float], row: int, count: int, linear: memoryview[int]) -> None:
    """Compute the length of a cubic (seven Gauss points), and its parameter over the length."""
    kind = 0
    for i in range(count):
        if linear[i] > 0 and moves_axis(segments, row, count, i):
            kind = 1
    length = 0.4179591836734694 * rate(segments, row, count, 0.5, linear, kind)
    length += 0.3818300505051189 * rates(segments, row, count, 0.2029225756886985, linear, kind)
    length += 0.2797053914892767 * rates(segments, row, count, 0.3707655927996972, linear, kind)
    length += 0.1294849661688697 * rates(segments, row, count, 0.4745539561713793, linear, kind)
    length *= 0.5
    segments[row + rows.LENGTH] = length
    step = 1e-3
    start_rate = rate(segments, row, count, 0.0, linear, kind)
    end_rate = rate(segments, row, count, 1.0, linear, kind)
    shortest = min(start_rate, end_rate)
    longest = max(start_rate, end_rate)
    segments[row + rows.CUBIC_LINEAR] = 1.0
    if shortest * MAX_SLOPE < length or longest * MIN_SLOPE > length:
        return
    start_slope = length / start_rate
    end_slope = length / end_rate
    change = rate(segments, row, count, step, linear, kind)
    change -= rate(segments, row, count, 0.0 - step, linear, kind)
    start_curve = 0.0 - 0.5 * change / step * length * length / start_rate / start_rate / start_rate
    change = rate(segments, row, count, 1.0 + step, linear, kind)
    change -= rate(segments, row, count, 1.0 - step, linear, kind)
    end_curve = 0.0 - 0.5 * change / step * length * length / end_rate / end_rate / end_rate
    slopes = start_slope + end_slope
    segments[row + rows.CUBIC_LINEAR] = start_slope
    segments[row + rows.CUBIC_SQUARE] = 0.5 * start_curve
    segments[row + rows.CUBIC_CUBE] = (
        10.0 - 4.0 * slopes - 2.0 * start_slope - 1.5 * start_curve + 0.5 * end_curve
    )
    segments[row + rows.CUBIC_FOURTH] = (
        7.0 * slopes + start_slope - 15.0 + 1.5 * start_curve - end_curve
    )
    segments[row + rows.CUBIC_FIFTH] = 6.0 - 3.0 * slopes + 0.5 * (end_curve - start_curve)

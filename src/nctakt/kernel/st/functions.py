# SPDX-License-Identifier: MIT
"""Functions of real numbers (ST-307, ST-712); angles in radians.

Outside of its domain a function answers ``NaN``. Compiled and plain call the same library, guarded
where Python would raise.
"""

from __future__ import annotations

import math

from nctakt.kernel.base import arithmetic
from nctakt.kernel.st import kinds


def quotient_by_zero(left: float, right: float) -> float:
    """``left / right`` where ``right`` is 0, as IEEE 754 says."""
    if left == 0.0 or left != left:
        return arithmetic.NAN
    is_positive = (left > 0.0) == (math.copysign(1.0, right) > 0.0)
    return arithmetic.INFINITY if is_positive else -arithmetic.INFINITY


def round_half_away(value: float) -> float:
    """Nearest integral number; halfway cases are rounded away from zero (ST-307)."""
    below = arithmetic.floor(value)
    part = value - below
    is_up = part >= 0.5 if value > 0.0 else part > 0.5
    return below + 1.0 if is_up else below


def low_bits(value: float) -> int:
    """The low 64 bits of an integral number; 0 if it is not finite."""
    if not arithmetic.is_finite(value):
        return 0
    rest = math.fmod(value, 18446744073709551616.0)
    if rest >= 9223372036854775808.0:
        rest -= 18446744073709551616.0
    elif rest < -9223372036854775808.0:
        rest += 18446744073709551616.0
    return int(rest)


def of_angle(function: int, value: float) -> float:
    """Sine, cosine or tangent of an angle in radians."""
    if not arithmetic.is_finite(value):
        return arithmetic.NAN
    if function == kinds.SIN:
        return math.sin(value)
    if function == kinds.COS:
        return math.cos(value)
    return math.tan(value)


def to_angle(function: int, value: float) -> float:
    """Arc sine, arc cosine or arc tangent in radians."""
    if function == kinds.ATAN:
        return math.atan(value)
    if not -1.0 <= value <= 1.0:
        return arithmetic.NAN
    return math.asin(value) if function == kinds.ASIN else math.acos(value)


def of_real(function: int, value: float) -> float:
    """A function of one number."""
    if function == kinds.ABS:
        return math.fabs(value)
    if function == kinds.SQRT:
        return arithmetic.square_root(value)
    if function == kinds.LN:
        return arithmetic.natural_logarithm(value)
    if function == kinds.LOG:
        return arithmetic.decimal_logarithm(value)
    if function == kinds.EXP:
        return arithmetic.exponential(value)
    if function <= kinds.TAN:
        return of_angle(function, value)
    if function <= kinds.ATAN:
        return to_angle(function, value)
    if function == kinds.FLOOR:
        return arithmetic.floor(value)
    if function == kinds.CEIL:
        return arithmetic.ceiling(value)
    if function == kinds.FRAC:
        return arithmetic.fraction(value)
    return arithmetic.truncate(value)


def of_two(function: int, left: float, right: float) -> float:
    """A function of two numbers."""
    if function == kinds.EXPT:
        return arithmetic.power(left, right)
    if function == kinds.ATAN2:
        return math.atan2(left, right)
    rest = arithmetic.modulo(left, right)
    if function == kinds.MODABS and rest < 0.0:
        rest += math.fabs(right)
    return rest

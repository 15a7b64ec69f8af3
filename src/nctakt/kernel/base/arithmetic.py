# SPDX-License-Identifier: MIT
"""Arithmetic of decoder and realtime part: RC-206, RC-207, RC-307; angles in degrees.

The only place for division, remainders, powers, rounding and trigonometry. Compiled and plain
Python differ in these (exceptions, signs, last bits), so each function guards its domain before it
calls anything and returns ``NaN`` where the operation is not defined; an overflow is infinite. Sine
and cosine are implemented here with + - * only, and so have the same bits on every processor.
"""

import math

NAN = float("nan")
INFINITY = float("inf")


def is_finite(value: float) -> bool:
    """Return whether ``value`` is neither infinite nor NaN."""
    return value - value == 0.0


def divide(left: float, right: float) -> float:
    """``left / right``; NaN for a zero divisor."""
    if right == 0.0:
        return NAN
    return left / right


def modulo(left: float, right: float) -> float:
    """Remainder with the sign of ``left``; NaN for a zero divisor."""
    if right == 0.0 or not is_finite(left) or right != right:
        return NAN
    return math.fmod(left, right)


def power(base: float, exponent: float) -> float:
    """``base ** exponent``; NaN for 0 ** -n and a negative base with a fractional exponent."""
    if exponent == 0.0:
        return 1.0
    if base == 0.0:
        return 0.0 if exponent > 0.0 else NAN
    if not is_finite(base) or not is_finite(exponent):
        return NAN
    if base < 0.0 and floor(exponent) != exponent:
        return NAN
    size = exponent * math.log(math.fabs(base))
    if size > 709.7:
        return INFINITY
    if size < -745.0:
        return 0.0
    return math.pow(base, exponent)


def floor(value: float) -> float:
    """Largest integral number that is not above ``value``."""
    if value >= 4503599627370496.0 or value <= -4503599627370496.0 or value != value:
        return value
    whole = int(value)
    below = 1.0 * whole
    return below - 1.0 if below > value else below


def ceiling(value: float) -> float:
    """Smallest integral number that is not below ``value``."""
    return 0.0 - floor(0.0 - value)


def truncate(value: float) -> float:
    """INT: the integral part, towards zero."""
    return floor(value) if value >= 0.0 else ceiling(value)


def fraction(value: float) -> float:
    """FRACT: the part that INT cuts off, with the sign of ``value``."""
    return value - truncate(value)


def round_half_even(value: float) -> float:
    """Nearest integral number; halfway cases go to the even one (RC-307)."""
    below = floor(value)
    fraction = value - below
    if fraction > 0.5:
        return below + 1.0
    if fraction == 0.5 and floor(below * 0.5) * 2.0 != below:
        return below + 1.0
    return below


def within(value: float, low: float, full: float) -> float:
    """Wrap ``value`` into [``low``, ``low + full``); ``full`` > 0."""
    if low <= value < low + full:
        return value
    inside = value - full * floor((value - low) / full)
    return inside if low <= inside < low + full else low


def square_root(value: float) -> float:
    """SQRT; NaN for a negative operand."""
    if value < 0.0 or value != value:
        return NAN
    return math.sqrt(value)


def exponential(value: float) -> float:
    """EXP: e to the power of ``value``."""
    if value > 709.7:
        return INFINITY
    if value != value:
        return NAN
    return math.exp(value)


def decimal_exponential(value: float) -> float:
    """DEXP: 10 to the power of ``value``."""
    return power(10.0, value)


def natural_logarithm(value: float) -> float:
    """LN; NaN unless the operand is positive."""
    if not value > 0.0:
        return NAN
    return math.log(value)


def decimal_logarithm(value: float) -> float:
    """LOG: to the base 10; NaN unless the operand is positive."""
    if not value > 0.0:
        return NAN
    return math.log10(value)


def _small_sine(degrees: float) -> float:
    """Sine for |degrees| <= 45: Taylor's series to the 15th power, error below half a unit."""
    if degrees == 30.0:
        return 0.5
    if degrees == -30.0:
        return -0.5
    x = degrees * 0.017453292519943295
    y = x * x
    s = -1.0 / 1307674368000.0
    s = s * y + 1.0 / 6227020800.0
    s = s * y - 1.0 / 39916800.0
    s = s * y + 1.0 / 362880.0
    s = s * y - 1.0 / 5040.0
    s = s * y + 1.0 / 120.0
    s = s * y - 1.0 / 6.0
    return x + x * y * s


def _small_cosine(degrees: float) -> float:
    """Cosine for |degrees| <= 45: Taylor's series to the 16th power."""
    x = degrees * 0.017453292519943295
    y = x * x
    c = 1.0 / 20922789888000.0
    c = c * y - 1.0 / 87178291200.0
    c = c * y + 1.0 / 479001600.0
    c = c * y - 1.0 / 3628800.0
    c = c * y + 1.0 / 40320.0
    c = c * y - 1.0 / 720.0
    c = c * y + 1.0 / 24.0
    return 1.0 - 0.5 * y + y * y * c


def sine(degrees: float) -> float:
    """SIN of an angle in degrees; exact at the multiples of 30 that have exact values."""
    if not is_finite(degrees):
        return NAN
    angle = math.fabs(degrees)
    if angle >= 360.0:
        angle = math.fmod(angle, 360.0)
    sign = 1.0 if degrees >= 0.0 else -1.0
    if angle <= 45.0:
        return sign * _small_sine(angle)
    if angle < 135.0:
        return sign * _small_cosine(angle - 90.0)
    if angle <= 225.0:
        return sign * _small_sine(180.0 - angle)
    if angle < 315.0:
        return 0.0 - sign * _small_cosine(angle - 270.0)
    return sign * _small_sine(angle - 360.0)


def cosine(degrees: float) -> float:
    """COS of an angle in degrees; exact at the multiples of 30 that have exact values."""
    if not is_finite(degrees):
        return NAN
    angle = math.fabs(degrees)
    if angle >= 360.0:
        angle = math.fmod(angle, 360.0)
    if angle <= 45.0:
        return _small_cosine(angle)
    if angle < 135.0:
        return _small_sine(90.0 - angle)
    if angle <= 225.0:
        return 0.0 - _small_cosine(angle - 180.0)
    if angle < 315.0:
        return _small_sine(angle - 270.0)
    return _small_cosine(angle - 360.0)


def tangent(degrees: float) -> float:
    """Put each axis' part of the length, at start or target, into ``directions``."""
    return divide(sine(degrees), cosine(degrees))


def cotangent(degrees: float) -> float:
    """COT; NaN where the sine is zero."""
    return divide(cosine(degrees), sine(degrees))


def arc_sine(value: float) -> float:
    """ASIN in degrees; NaN outside -1 … 1."""
    if not -1.0 <= value <= 1.0:
        return NAN
    return math.asin(value) / 0.017453292519943295


def arc_cosine(value: float) -> float:
    """ACOS in degrees; NaN outside -1 … 1."""
    if not -1.0 <= value <= 1.0:
        return NAN
    return math.acos(value) / 0.017453292519943295


def arc_tangent(value: float) -> float:
    """ATAN in degrees, -90 … 90."""
    return math.atan(value) / 0.017453292519943295


def arc_tangent_2(ordinate: float, abscissa: float) -> float:
    """ATAN2[y, x] in degrees, -180 … 180; NaN where both are zero."""
    if ordinate == 0.0 and abscissa == 0.0:
        return NAN
    return math.atan2(ordinate, abscissa) / 0.017453292519943295


def arc_cotangent(value: float) -> float:
    """ACOT in degrees, 0 … 180."""
    return 90.0 - math.atan(value) / 0.017453292519943295


def is_bit_pattern(value: float) -> bool:
    """Return whether ``value``, rounded, fits a bit operation: its size is below 2**53."""
    return -9007199254740992.0 < value < 9007199254740992.0


def bit_and(left: float, right: float) -> float:
    """``&`` of the rounded operands; NaN where one is too large."""
    if not (is_bit_pattern(left) and is_bit_pattern(right)):
        return NAN
    a = int(round_half_even(left))
    b = int(round_half_even(right))
    return (a & b) + 0.0


def bit_or(left: float, right: float) -> float:
    """``|`` of the rounded operands; NaN where one is too large."""
    if not (is_bit_pattern(left) and is_bit_pattern(right)):
        return NAN
    a = int(round_half_even(left))
    b = int(round_half_even(right))
    return (a | b) + 0.0


def bit_xor(left: float, right: float) -> float:
    """``^`` of the rounded operands; NaN where one is too large."""
    if not (is_bit_pattern(left) and is_bit_pattern(right)):
        return NAN
    a = int(round_half_even(left))
    b = int(round_half_even(right))
    return (a ^ b) + 0.0


def bit_invert(value: float) -> float:
    """INV: the one's complement of the rounded operand; NaN where it is too large."""
    if not is_bit_pattern(value):
        return NAN
    a = int(round_half_even(value))
    return (-1 - a) + 0.0


def is_true(value: float) -> bool:
    """Return whether a value is true: its magnitude is 0.5 or more (RC-202)."""
    return value >= 0.5 or value <= -0.5

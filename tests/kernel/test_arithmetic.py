# SPDX-License-Identifier: MIT
"""The arithmetic of decoder and realtime part against exact oracles (RC-206, RC-207, RC-307).

Python's whole numbers, fractions and decimals are the oracles: they have no rounding of their own.
"""

from __future__ import annotations

import decimal
import math
from decimal import Decimal
from fractions import Fraction

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from support.random_seeds import examples

from nctakt.kernel.base import arithmetic

often = settings(max_examples=examples(300), deadline=None, derandomize=True, database=None)

anything = st.floats()
finite = st.floats(allow_nan=False, allow_infinity=False)
moderate = st.floats(-1e6, 1e6)
near_halves = st.integers(-(2**53), 2**53).map(lambda n: n / 2)
around = st.one_of(finite, moderate, near_halves)

PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459")


def same(left: float, right: float) -> bool:
    """Equal, where zeros of both signs are one and NaN equals NaN."""
    return left == right or (math.isnan(left) and math.isnan(right))


# --- rounding -----------------------------------------------------------------------------------


@pytest.mark.slow
@often
@given(around)
@example(0.49999999999999994)
@example(-0.49999999999999994)
@example(4503599627370495.5)
@example(-4503599627370495.5)
@example(4503599627370497.0)
def test_rounding_is_to_the_nearest_and_half_to_even(value: float) -> None:
    """ROUND and stores of integers take the nearest whole number, the even one of two (RC-307)."""
    assert arithmetic.round_half_even(value) == float(round(value))


@often
@given(around)
def test_floor_ceil_int_and_fract_are_exact(value: float) -> None:
    """FLOOR, CEIL, INT and FRACT of any number are those of whole number arithmetic."""
    assert arithmetic.floor(value) == float(math.floor(value))
    assert arithmetic.ceiling(value) == float(math.ceil(value))
    assert arithmetic.truncate(value) == float(math.trunc(value))
    assert Fraction(arithmetic.fraction(value)) == Fraction(value) - math.trunc(value)


@pytest.mark.parametrize("value", [math.inf, -math.inf])
def test_rounding_leaves_what_is_not_finite(value: float) -> None:
    """Infinite and undefined values stay what they are; the statement above refuses them."""
    for function in (arithmetic.floor, arithmetic.ceiling, arithmetic.round_half_even):
        assert function(value) == value
        assert math.isnan(function(math.nan))


# --- quotients and powers -----------------------------------------------------------------------


@often
@given(anything, anything)
def test_a_quotient_is_that_of_the_processor(left: float, right: float) -> None:
    """``/`` is rounded once; a divisor of 0 has no result (RC-207)."""
    result = arithmetic.divide(left, right)
    assert math.isnan(result) if right == 0.0 else same(result, left / right)


@often
@given(anything, anything)
def test_a_remainder_has_the_sign_of_the_left(left: float, right: float) -> None:
    """MOD is the exact remainder of the truncated quotient; a divisor of 0 has no result."""
    result = arithmetic.modulo(left, right)
    if math.isnan(left) or math.isnan(right) or math.isinf(left) or right == 0.0:
        assert math.isnan(result)
    else:
        assert result == math.fmod(left, right)


@often
@given(st.integers(-(2**50), 2**50), st.integers(-1000, 1000).filter(bool))
def test_a_remainder_of_whole_numbers_is_exact(left: int, right: int) -> None:
    """-7 MOD 3 is -1: the quotient is cut off towards zero."""
    expected = abs(left) % abs(right) * (1 if left >= 0 else -1)
    assert arithmetic.modulo(float(left), float(right)) == expected


@often
@given(anything, anything)
def test_a_power_is_defined_where_it_has_one_real_value(base: float, exponent: float) -> None:
    """``**``: no 0 to a negative power, no root of a negative base; anything else is libm's."""
    result = arithmetic.power(base, exponent)
    if exponent == 0.0:
        assert result == 1.0
    elif base == 0.0:
        assert result == 0.0 if exponent > 0.0 else math.isnan(result)
    elif not (math.isfinite(base) and math.isfinite(exponent)):
        assert math.isnan(result)
    elif base < 0.0 and exponent != math.floor(exponent):
        assert math.isnan(result)
    else:
        size = exponent * math.log(abs(base))
        if size > 709.8:
            assert result == math.inf
        elif size < -746.0:
            assert result == 0.0
        elif -745.0 <= size <= 709.7:
            assert result == math.pow(base, exponent)


@often
@given(st.integers(-50, 50), st.integers(0, 9))
def test_a_small_power_of_whole_numbers_is_exact(base: int, exponent: int) -> None:
    """[-3] ** 3 is -27, and 0 ** 0 is 1."""
    assert arithmetic.power(float(base), float(exponent)) == base**exponent


# --- functions ----------------------------------------------------------------------------------


@often
@given(finite)
def test_the_square_root_is_correctly_rounded(value: float) -> None:
    """SQRT of a negative value has no result (RC-207)."""
    result = arithmetic.square_root(value)
    assert math.isnan(result) if value < 0.0 else result == math.sqrt(value)


DOMAINS = [
    (arithmetic.divide, (1.0, 0.0)),
    (arithmetic.divide, (0.0, 0.0)),
    (arithmetic.modulo, (1.0, 0.0)),
    (arithmetic.modulo, (math.inf, 1.0)),
    (arithmetic.power, (0.0, -1.0)),
    (arithmetic.power, (-8.0, 1.0 / 3.0)),
    (arithmetic.power, (2.0, math.inf)),
    (arithmetic.square_root, (-1e-300,)),
    (arithmetic.square_root, (math.nan,)),
    (arithmetic.exponential, (math.nan,)),
    (arithmetic.decimal_exponential, (math.nan,)),
    (arithmetic.natural_logarithm, (0.0,)),
    (arithmetic.natural_logarithm, (-1.0,)),
    (arithmetic.natural_logarithm, (math.nan,)),
    (arithmetic.decimal_logarithm, (0.0,)),
    (arithmetic.decimal_logarithm, (-1.0,)),
    (arithmetic.sine, (math.inf,)),
    (arithmetic.cosine, (-math.inf,)),
    (arithmetic.sine, (math.nan,)),
    (arithmetic.tangent, (90.0,)),
    (arithmetic.tangent, (-270.0,)),
    (arithmetic.cotangent, (0.0,)),
    (arithmetic.cotangent, (180.0,)),
    (arithmetic.cotangent, (-720.0,)),
    (arithmetic.arc_sine, (math.nextafter(1.0, 2.0),)),
    (arithmetic.arc_sine, (math.nan,)),
    (arithmetic.arc_cosine, (math.nextafter(-1.0, -2.0),)),
    (arithmetic.arc_cosine, (math.nan,)),
    (arithmetic.arc_tangent_2, (0.0, 0.0)),
    (arithmetic.arc_tangent_2, (0.0, -0.0)),
    (arithmetic.bit_and, (2.0**53, 1.0)),
    (arithmetic.bit_or, (1.0, -(2.0**53))),
    (arithmetic.bit_xor, (math.inf, 1.0)),
    (arithmetic.bit_invert, (math.nan,)),
]


@pytest.mark.parametrize(("function", "operands"), DOMAINS)
def test_outside_its_domain_an_operation_has_no_result(function, operands) -> None:
    """Each operation answers NaN where it is not defined, and never raises (RC-207)."""
    assert math.isnan(function(*operands))


def test_what_overflows_is_infinite() -> None:
    """EXP, DEXP and ``**`` answer infinity where the result has no room; the store refuses it."""
    assert arithmetic.exponential(710.0) == math.inf
    assert arithmetic.exponential(1e308) == math.inf
    assert arithmetic.exponential(-1e308) == 0.0
    assert arithmetic.decimal_exponential(309.0) == math.inf
    assert arithmetic.decimal_exponential(-400.0) == 0.0
    assert arithmetic.power(-10.0, 309.0) == math.inf
    assert arithmetic.is_finite(1.7976931348623157e308)
    assert not arithmetic.is_finite(math.inf)
    assert not arithmetic.is_finite(math.nan)


# --- angles -------------------------------------------------------------------------------------


def exact_sine(degrees: float) -> Decimal:
    """The sine to forty digits: the angle is reduced as a fraction, then Taylor's series."""
    angle = Fraction(degrees) % 360
    sign = 1
    if angle >= 180:
        angle, sign = angle - 180, -1
    if angle > 90:
        angle = 180 - angle
    with decimal.localcontext(prec=50):
        x = Decimal(angle.numerator) / Decimal(angle.denominator) * PI / 180
        term = total = x
        for n in range(1, 30):
            term = -term * x * x / ((2 * n) * (2 * n + 1))
            total += term
        return sign * total


def exact_cosine(degrees: float) -> Decimal:
    """The cosine as the sine of the complement, which a fraction holds exactly."""
    angle = (Fraction(degrees) + 90) % 360
    sign = 1
    if angle >= 180:
        angle, sign = angle - 180, -1
    if angle > 90:
        angle = 180 - angle
    with decimal.localcontext(prec=50):
        x = Decimal(angle.numerator) / Decimal(angle.denominator) * PI / 180
        term = total = x
        for n in range(1, 30):
            term = -term * x * x / ((2 * n) * (2 * n + 1))
            total += term
        return sign * total


@often
@given(st.one_of(st.floats(-720, 720), st.floats(-1e9, 1e9), finite))
def test_sine_and_cosine_are_right_to_the_last_bits(degrees: float) -> None:
    """SIN and COS of any angle in degrees are within 4e-16 of the exact value."""
    assert abs(Decimal(arithmetic.sine(degrees)) - exact_sine(degrees)) < Decimal("4e-16")
    assert abs(Decimal(arithmetic.cosine(degrees)) - exact_cosine(degrees)) < Decimal("4e-16")


@often
@given(st.floats(1e-200, 45.0))
def test_small_angles_keep_their_relative_accuracy(degrees: float) -> None:
    """SIN of a small angle has as many right digits as that of a large one."""
    exact = exact_sine(degrees)
    assert abs(Decimal(arithmetic.sine(degrees)) - exact) < exact * Decimal("5e-16")


@pytest.mark.parametrize("turns", [-3, -1, 0, 1, 1000])
@pytest.mark.parametrize(
    ("degrees", "sine", "cosine"),
    [
        (0.0, 0.0, 1.0),
        (30.0, 0.5, None),
        (60.0, None, 0.5),
        (90.0, 1.0, 0.0),
        (120.0, None, -0.5),
        (150.0, 0.5, None),
        (180.0, 0.0, -1.0),
        (210.0, -0.5, None),
        (240.0, None, -0.5),
        (270.0, -1.0, 0.0),
        (300.0, None, 0.5),
        (330.0, -0.5, None),
    ],
)
def test_round_angles_have_exact_values(
    degrees: float, sine: float | None, cosine: float | None, turns: int
) -> None:
    """SIN[30] is 0.5 and COS[90] is 0, in every turn and direction."""
    angle = degrees + 360.0 * turns
    if sine is not None:
        assert arithmetic.sine(angle) == sine
        assert arithmetic.sine(-angle) == -sine
    if cosine is not None:
        assert arithmetic.cosine(angle) == cosine
        assert arithmetic.cosine(-angle) == cosine


@often
@given(st.floats(-1e6, 1e6))
def test_sine_is_odd_and_cosine_is_even(degrees: float) -> None:
    """The sign of an angle changes the sign of its sine, and nothing else, bit for bit."""
    assert arithmetic.sine(-degrees) == -arithmetic.sine(degrees)
    assert arithmetic.cosine(-degrees) == arithmetic.cosine(degrees)


@often
@given(st.floats(-1.0, 1.0), st.floats(-1e9, 1e9), st.floats(-1e9, 1e9))
def test_angles_of_functions_are_those_of_libm_in_degrees(x: float, y: float, z: float) -> None:
    """ASIN, ACOS, ATAN, ACOT and ATAN2 give degrees in their usual ranges."""
    assert arithmetic.arc_sine(x) == pytest.approx(math.degrees(math.asin(x)), rel=1e-15, abs=0)
    assert arithmetic.arc_cosine(x) == pytest.approx(math.degrees(math.acos(x)), rel=1e-15)
    assert arithmetic.arc_tangent(y) == pytest.approx(math.degrees(math.atan(y)), rel=1e-15)
    assert arithmetic.arc_cotangent(y) == pytest.approx(90.0 - math.degrees(math.atan(y)))
    assert 0.0 <= arithmetic.arc_cotangent(y) <= 180.0
    if y != 0.0 or z != 0.0:
        expected = math.degrees(math.atan2(y, z))
        assert arithmetic.arc_tangent_2(y, z) == pytest.approx(expected, rel=1e-15)


# --- bits and truth -----------------------------------------------------------------------------

patterns = st.one_of(st.integers(-(2**53) + 1, 2**53 - 1).map(float), st.floats(-1e12, 1e12))


@often
@given(patterns, patterns)
def test_bit_operations_are_those_of_whole_numbers(left: float, right: float) -> None:
    """``&``, ``|``, ``^`` and INV work on the rounded operands in two's complement."""
    a, b = round(left), round(right)
    assert arithmetic.bit_and(left, right) == a & b
    assert arithmetic.bit_or(left, right) == a | b
    assert arithmetic.bit_xor(left, right) == a ^ b
    assert arithmetic.bit_invert(left) == ~a


def test_bit_patterns_end_where_numbers_stop_being_exact() -> None:
    """2**53 - 1 is the last bit pattern on either side."""
    last = 2.0**53 - 1.0
    assert arithmetic.bit_and(last, last) == last
    assert arithmetic.bit_and(-last, -1.0) == -last
    assert math.isnan(arithmetic.bit_and(last + 1.0, 1.0))


@often
@given(anything)
@example(0.5)
@example(-0.5)
@example(math.nextafter(0.5, 0.0))
def test_a_value_is_true_from_a_half_on(value: float) -> None:
    """A condition is true when |value| >= 0.5 (RC-202)."""
    assert bool(arithmetic.is_true(value)) is (abs(value) >= 0.5)

# SPDX-License-Identifier: MIT
"""Lengths of time as users give them: texts with units, seconds, ``datetime.timedelta``."""

from datetime import timedelta
from fractions import Fraction

import numpy as np
import pytest

from nctakt.base.failure import Failure
from nctakt.lists.format.times import Time, TimeLike, nanoseconds, read_time


@pytest.mark.parametrize(
    ("text", "time_us"),
    [
        ("0", 0),
        ("1500us", 1500),
        ("1500 us", 1500),
        ("1500µs", 1500),
        ("1500μs", 1500),
        ("1.5ms", 1500),
        ("0.2s", 200_000),
        ("0.2", 200_000),
        (".2", 200_000),
        ("3.", 3_000_000),
        ("2min", 120_000_000),
        ("1 h", 3_600_000_000),
        ("0.0000001", 1),
        ("0.1us", 1),
        ("1.001ms", 1001),
        ("999999999999s", 999_999_999_999_000_000),
        (" 1s ", 1_000_000),
    ],
)
def test_times_are_exact_and_round_up(text: str, time_us: int) -> None:
    """A time is whole microseconds; a part of one is rounded up, as no tick begins within it."""
    assert read_time(text) == Time(time_us)


@pytest.mark.parametrize(
    ("value", "time_us"),
    [
        (1, 1_000_000),
        (1.0, 1_000_000),
        (0.1, 100_000),
        (0.1 + 0.2, 300_000),
        (1e-7, 1),
        (4.35, 4_350_000),
        (np.float64(0.463), 463_000),
        (np.int32(2), 2_000_000),
        (Fraction(1, 4), 250_000),
        (timedelta(milliseconds=20), 20_000),
        (timedelta(days=1), 86_400_000_000),
        (Time(7), 7),
    ],
)
def test_numbers_are_seconds(value: TimeLike, time_us: int) -> None:
    """A binary fraction is taken to the nanosecond, so that 0.1 + 0.2 is 300 ms."""
    assert read_time(value) == Time(time_us)


def test_ticks_get_their_length_from_the_controller() -> None:
    """300 ticks of 500 µs are 150 ms; a time in microseconds is reached in the tick after it."""
    assert read_time("300 ticks") == Time(300, is_in_ticks=True)
    assert read_time("1 tick") == Time(1, is_in_ticks=True)
    assert read_time("300 ticks").us(500) == 150_000
    assert read_time("300 ticks").ticks(500) == 300
    assert read_time("12.5 ms").ticks(1000) == 13
    assert read_time("12.5 ms").us(1000) == 12_500


@pytest.mark.parametrize(
    "value",
    [
        "",
        ".",
        "s",
        "-1s",
        "1 hour",
        "1e3",
        "NaN",
        "1,5ms",
        "1.5.2s",
        "1S",
        "1ms 2us",
        "1" * 13,
        "1_0s",
        "٣s",
        "1.5 ticks",
        "-1 ticks",
        -1,
        -0.001,
        float("nan"),
        float("inf"),
        1e12,
        timedelta(microseconds=-1),
    ],
)
def test_what_is_not_a_time_is_a_diagnostic(value: TimeLike) -> None:
    """900510: other words, signs, exponents and units are refused."""
    with pytest.raises(Failure) as failure:
        read_time(value)
    assert [one.id for one in failure.value.diagnostics] == [900510]


@pytest.mark.parametrize("value", [None, True, b"1s", ["1s"], ("1s",), 1j])
def test_a_wrong_type_is_a_diagnostic(value: object) -> None:
    """900513 names the type and what is taken instead."""
    with pytest.raises(Failure) as failure:
        read_time(value)  # type: ignore[arg-type]
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.id == 900513
    assert f"type {type(value).__name__}" in diagnostic.text()
    assert "datetime.timedelta" in diagnostic.render()


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("20 ms", "0.02 s"),
        ("1 tick", "1 tick"),
        ("300 ticks", "300 ticks"),
        ("2 min", "120 s"),
        ("1 us", "0.000001 s"),
    ],
)
def test_a_time_is_shown_with_its_unit(value: str, text: str) -> None:
    """In seconds, or in ticks."""
    assert str(read_time(value)) == text


def test_texts_of_load_files_are_exact_to_the_nanosecond() -> None:
    """They need their own unit, since a number there means microseconds."""
    assert nanoseconds("1.5 us") == 1500
    assert nanoseconds("0.0001us") == 1
    assert nanoseconds("1 h") == 3_600 * 10**9
    assert [nanoseconds(text) for text in ("5", "5 ticks", "soon", "")] == [None] * 4

# SPDX-License-Identifier: MIT
"""Times and assignments from the command line."""

import pytest

from nctakt.base.failure import Failure
from nctakt.run.stimuli import Stimulus, parse_assignment, parse_stimulus, parse_time


@pytest.mark.parametrize(
    ("text", "time_us"),
    [
        ("0", 0),
        ("1500us", 1500),
        ("1500 us", 1500),
        ("1500µs", 1500),
        ("1.5ms", 1500),
        ("0.2s", 200_000),
        ("0.2", 200_000),
        (".2", 200_000),
        ("3.", 3_000_000),
        ("2min", 120_000_000),
        ("0.0000001", 1),
        ("0.1us", 1),
        ("1.001ms", 1001),
        ("999999999999s", 999_999_999_999_000_000),
        (" 1s ", 1_000_000),
    ],
)
def test_times_are_exact_and_round_up(text: str, time_us: int) -> None:
    """A time is whole microseconds; a part of one is rounded up, as no tick begins within it."""
    assert parse_time(text) == time_us


@pytest.mark.parametrize(
    "text",
    [
        "",
        "s",
        "-1s",
        "1 h",
        "1e3",
        "nan",
        "1,5ms",
        "1.5.2s",
        "1S",
        "1ms 2us",
        "1" * 13,
        "1_0s",
        "٣s",
    ],
)
def test_what_is_no_time_is_a_diagnostic(text: str) -> None:
    """Other words, signs, exponents and units are refused by number."""
    with pytest.raises(Failure) as failure:
        parse_time(text)
    assert [found.id for found in failure.value.diagnostics] == [900510]


@pytest.mark.parametrize(
    ("text", "name", "value"),
    [
        ("V.E.VALUE=5", "V.E.VALUE", 5.0),
        ("V.E.VALUE = -1.5e-3", "V.E.VALUE", -0.0015),
        ("V.E.VALUE=+.5", "V.E.VALUE", 0.5),
        ("V.E.BIT=TRUE", "V.E.BIT", 1.0),
        ("V.E.BIT=false", "V.E.BIT", 0.0),
        ("V.E.A[3].B=7.", "V.E.A[3].B", 7.0),
    ],
)
def test_assignments(text: str, name: str, value: float) -> None:
    """A name, an equals sign, a number or a truth value; blanks around the sign are free."""
    assert parse_assignment(text) == (name, value)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("V.E.VALUE", 900511),
        ("=5", 900511),
        ("", 900511),
        ("V.E.VALUE=", 900512),
        ("V.E.VALUE=five", 900512),
        ("V.E.VALUE==5", 900512),
        ("V.E.VALUE=nan", 900512),
        ("V.E.VALUE=inf", 900512),
        ("V.E.VALUE=1e999", 900512),
        ("V.E.VALUE=1_000", 900512),
        ("V.E.VALUE=0x10", 900512),
    ],
)
def test_what_is_no_assignment_is_a_diagnostic(text: str, number: int) -> None:
    """A missing sign, name or value, and what is no finite number, are told by number."""
    with pytest.raises(Failure) as failure:
        parse_assignment(text)
    assert [found.id for found in failure.value.diagnostics] == [number]


def test_a_stimulus_has_a_time_and_an_assignment() -> None:
    """``--at 1.5ms V.E.VALUE=-1`` sets the variable at 1500 µs."""
    assert parse_stimulus("1.5ms", "V.E.VALUE=-1") == Stimulus(1500, "V.E.VALUE", -1.0)
